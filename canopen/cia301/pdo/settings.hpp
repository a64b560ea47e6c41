// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_PDO_SETTINGS_HPP
#define CANOPEN_CIA301_PDO_SETTINGS_HPP

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/dictionary/number_hook.hpp"

#include <cstdint>

// What the communication parameters of a TPDO (1800h..) and of an RPDO (1400h..) have in common, after CiA 301.
namespace counterpoint::cia301
{

constexpr std::uint8_t kCobIdSub = 1U;
constexpr std::uint8_t kTypeSub = 2U;
constexpr std::uint8_t kInhibitSub = 3U;
constexpr std::uint8_t kEventSub = 5U;
constexpr std::uint32_t kLastSynchronous = 240U;     ///< Last of the transmission types that follow SYNC.
constexpr std::uint32_t kFixedCobBits = 0x3FFFFFFFU; ///< Bits of a COB-ID that do not change while the PDO is valid.

/// The values of sub-index 1, 2, 3 and 5.
struct PdoSettings
{
    std::uint32_t cob_id;
    std::uint8_t type;
    std::uint16_t inhibit_100us;
    std::uint16_t event_ms;
};

/// @brief A sub-index that both kinds have, as the bus reads it; 0 is `highest_sub`, another one is unknown. O(1)
[[nodiscard]] ObjectValue FetchShared(const PdoSettings& settings, std::uint8_t sub, std::uint8_t highest_sub) noexcept;
/// @brief Whether a COB-ID is turned off, or has an identifier of 11 bits that may be configured. O(1)
[[nodiscard]] bool IsUsable(std::uint32_t cob_id) noexcept;
/// @brief Whether a PDO that has the COB-ID `own` may get this other one: valid, it keeps its identifier. O(1)
[[nodiscard]] bool IsAdmitted(std::uint32_t own, std::uint32_t cob_id) noexcept;

/// @brief The PDO of this number among `count`, or null. O(count)
template <typename Pdo>
[[nodiscard]] Pdo* FindPdo(Pdo* const pdos, const std::uint16_t count, const std::uint16_t number) noexcept
{
    Pdo* found = nullptr;
    for (std::uint16_t i = 0U; i < count; ++i)
    {
        found = (pdos[i].number == number) ? &pdos[i] : found;
    }
    return found;
}

template <typename Pdo> [[nodiscard]] bool IsValid(const Pdo& pdo) noexcept
{
    return (pdo.settings.cob_id & kCobOff) == 0U;
}

/// @brief Whether a valid PDO, but not the one of this number, has this identifier. O(count)
template <typename Pdo>
[[nodiscard]] bool IsUsed(const Pdo* const pdos, const std::uint16_t count, const std::uint32_t identifier,
                          const std::uint16_t except) noexcept
{
    bool is_used = false;
    for (std::uint16_t i = 0U; i < count; ++i)
    {
        const bool is_same = (pdos[i].settings.cob_id & kCobIdentifier) == identifier;
        is_used = is_used || (is_same && IsValid(pdos[i]) && (pdos[i].number != except));
    }
    return is_used;
}

/// @brief Turns off each valid PDO whose COB-ID the rule does not allow, the last one first: of two with one identifier
/// the first keeps it. `first_index` is the object of PDO 1. O(count * rule)
template <typename Pdo>
void TurnOffShared(Pdo* const pdos, const std::uint16_t count, const std::uint16_t first_index,
                   const WriteRule& rule) noexcept
{
    for (std::uint16_t left = count; left > 0U; --left)
    {
        Pdo& pdo = pdos[left - 1U];
        const ObjectAddress object{static_cast<std::uint16_t>((first_index + pdo.number) - 1U), kCobIdSub};
        pdo.settings.cob_id |= rule.Allows(object, pdo.settings.cob_id) ? 0U : kCobOff;
    }
}

template <typename Pdo> [[nodiscard]] bool IsSynchronous(const Pdo& pdo) noexcept
{
    return pdo.settings.type <= kLastSynchronous;
}

} // namespace counterpoint::cia301

#endif
