// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_CAN_PORTS_HPP
#define HAL_API_CAN_PORTS_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::hal
{

/// Whether a port guarantees something.
enum class Guarantee : std::uint8_t
{
    kInvalid = 0U,
    kAbsent = 1U,
    kGiven = 0x5AU,
};

/// What the kernel relies on. A port answers kGiven only for what is so on its hardware. [SRS_HAL_002]
struct CanGuarantees
{
    Guarantee bus_order;     ///< Frames of all controllers reach the kernel in the order of the bus.
    Guarantee stamps;        ///< Both counters are read for each frame in one place.
    Guarantee confirmations; ///< Every transmitted frame comes back with stamps when it was on the bus.
};

/// What became of a frame that was handed over for transmission.
enum class TransmitStatus : std::uint8_t
{
    kInvalid = 0U,
    kAccepted = 0x69U,
    kQueueFull = 1U,
    kBusOff = 2U,
    kRefused = 3U, ///< Not a frame that may be sent, or no such controller.
};

/// All CAN controllers of a device (one or two) behind one face. `Transmit` validates; a port implements DoTransmit and
/// need not look again. Never blocks. Reception is not called from here: the port's owner hands StampedFrames to the
/// kernel.
class CanPorts
{
  public:
    /// @brief Takes a frame for transmission on frame.port. O(1) [SRS_HAL_001]
    [[nodiscard]] TransmitStatus Transmit(const CanFrame& frame) noexcept
    {
        const bool sendable = IsSendable(frame);
        const bool port_known = IsPort(frame.port);
        if (sendable && port_known)
        {
            return DoTransmit(frame);
        }
        return TransmitStatus::kRefused;
    }
    /// @brief What this port guarantees.
    [[nodiscard]] virtual CanGuarantees Guarantees() const noexcept = 0;

    CanPorts(const CanPorts&) = delete;
    CanPorts(CanPorts&&) = delete;
    CanPorts& operator=(const CanPorts&) = delete;
    CanPorts& operator=(CanPorts&&) = delete;

  protected:
    CanPorts() noexcept = default;
    ~CanPorts() noexcept = default;

  private:
    /// A data frame of 11 bits of identifier and at most 8 bytes.
    [[nodiscard]] static bool IsSendable(const CanFrame& frame) noexcept
    {
        return (frame.kind == FrameKind::kData) && (frame.identifier <= kGreatestIdentifier) &&
               (frame.length_bytes <= kMaxPayloadBytes);
    }
    [[nodiscard]] static bool IsPort(const CanPortId port) noexcept
    {
        return (port == CanPortId::kFirst) || (port == CanPortId::kSecond);
    }

    static constexpr std::uint32_t kGreatestIdentifier = 0x7FFU;

    /// @brief Takes a frame that Transmit has validated. Never waits; a frame that was taken is sent at most once.
    [[nodiscard]] virtual TransmitStatus DoTransmit(const CanFrame& frame) noexcept = 0;
};

/// The guarantees by name.
enum class MissingGuarantee : std::uint8_t
{
    kInvalid = 0U,
    kBusOrder = 1U,
    kStamps = 2U,
    kConfirmations = 3U,
    kNone = 0x5AU,
};

/// @brief The first guarantee that is not given; kNone: all are. O(1) [SRS_HAL_002]
[[nodiscard]] MissingGuarantee CheckGuarantees(const CanGuarantees& guarantees) noexcept;

} // namespace counterpoint::hal

#endif
