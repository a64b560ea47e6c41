// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_TIMES_HPP
#define CANOPEN_CIA302_FLYING_MASTER_TIMES_HPP

#include "canopen/cia301/dictionary/number_hook.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

constexpr std::uint16_t kFlyingMasterIndex = 0x1F90U;
constexpr std::uint8_t kLowestPriority = 2U; ///< Level 0 is the highest priority, 1 the medium one.

/// 1F90h, "NMT flying master timing parameters", sub-index 1 to 6. Times in ms. All masters of a network have the same
/// values but for the priority and the detection cycle.
struct FlyingMasterTimes
{
    std::uint16_t timeout;         ///< Sub 1: how long an answer to 073h is waited for.
    std::uint16_t delay;           ///< Sub 2: from the start to 073h.
    std::uint16_t priority;        ///< Sub 3: level, 0 to kLowestPriority.
    std::uint16_t priority_slot;   ///< Sub 4: a level waits so much longer than the one above it.
    std::uint16_t device_slot;     ///< Sub 5: a node-ID waits so much longer than the one below it.
    std::uint16_t detection_cycle; ///< Sub 6: cyclic message of the active master; 0: none.

    /// @brief Priority level: the low byte of `priority`.
    [[nodiscard]] constexpr std::uint8_t Level() const noexcept
    {
        return static_cast<std::uint8_t>(priority);
    }
    /// @brief How long `node` waits between 072h and its 071h. At most 2^28 us if IsUsable. [SRS_FLY_008]
    [[nodiscard]] constexpr std::uint32_t WaitingUs(const NodeId node) const noexcept
    {
        return ((static_cast<std::uint32_t>(priority) * priority_slot) +
                (static_cast<std::uint32_t>(node.value) * device_slot)) *
               1000U;
    }
};

/// @brief Longest time of one negotiation, from the reset to the last slot of the lowest level. At most 2^29 us if
/// IsUsable. [SRS_FLY_010]
[[nodiscard]] constexpr std::uint32_t LongestNegotiationUs(const FlyingMasterTimes& times) noexcept
{
    FlyingMasterTimes last = times;
    last.priority = kLowestPriority;
    return last.WaitingUs(NodeId{kLastNode}) +
           ((static_cast<std::uint32_t>(times.delay) + static_cast<std::uint32_t>(times.timeout)) * 1000U);
}

/// @brief The defaults of the object. `node` is 1 to 127. [SRS_FLY_014]
[[nodiscard]] constexpr FlyingMasterTimes DefaultTimes(const NodeId node) noexcept
{
    return FlyingMasterTimes{100U, 500U, 2U, 1500U, 10U, static_cast<std::uint16_t>(4000U + (10U * node.value))};
}

/// @brief Whether no time slot of a level reaches into the next level: sub-index 4 > 127 x sub-index 5 > 0.
/// [SRS_FLY_002]
[[nodiscard]] constexpr bool HasSeparateSlots(const FlyingMasterTimes& times) noexcept
{
    const std::uint32_t all_devices = static_cast<std::uint32_t>(times.device_slot) * kLastNode;
    return (times.device_slot > 0U) && (times.priority_slot > all_devices);
}

/// @brief Whether a negotiation may begin with these values. [SRS_FLY_002]
[[nodiscard]] constexpr bool IsUsable(const FlyingMasterTimes& times) noexcept
{
    return (times.priority <= kLowestPriority) && HasSeparateSlots(times);
}

/// 1F90h in the object dictionary. A value that is written counts from the next start of a negotiation on, so the owner
/// of the dictionary keeps it over the reset communication that a negotiation brings. [SRS_FLY_014]
class FlyingMasterObject final : public cia301::NumberHook
{
  public:
    /// @brief `times` is kept by reference.
    explicit FlyingMasterObject(FlyingMasterTimes& times) noexcept;

    /// @brief kNone, kSubUnknown, kReadOnly (sub-index 0) or kValueRange.
    [[nodiscard]] cia301::SdoAbort Write(std::uint8_t sub, std::uint32_t value) noexcept;
    /// @brief Sub-index 0 to 6.
    [[nodiscard]] cia301::ObjectValue Read(std::uint8_t sub) const noexcept;

  private:
    [[nodiscard]] cia301::ObjectValue Fetch(const ObjectAddress& address) noexcept override;
    [[nodiscard]] cia301::SdoAbort Store(const ObjectAddress& address, std::uint32_t value) noexcept override;

    FlyingMasterTimes& times_;
};

} // namespace counterpoint::cia302

#endif
