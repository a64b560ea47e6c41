// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/can_ports.hpp"

namespace counterpoint::hal
{

namespace
{

constexpr std::uint32_t kStandardIdentifierBits = 11U;
// A length above 8 carries into bit 4.
constexpr std::uint32_t kLengthOffset = 7U;
constexpr std::uint32_t kLengthShift = 4U;
constexpr std::uint32_t kPortCount = 2U; // kFirst and kSecond, numbered from 1.

// 0 when the frame may be sent: no bit above those of an 11-bit identifier, at most 8 bytes, a data frame.
[[nodiscard]] std::uint32_t Objections(const CanFrame& frame) noexcept
{
    const std::uint32_t kind = static_cast<std::uint32_t>(frame.kind) ^ static_cast<std::uint32_t>(FrameKind::kData);
    const std::uint32_t length = (static_cast<std::uint32_t>(frame.length_bytes) + kLengthOffset) >> kLengthShift;
    return (frame.identifier >> kStandardIdentifierBits) | kind | length;
}

[[nodiscard]] bool IsPort(const CanPortId port) noexcept
{
    return (static_cast<std::uint32_t>(port) - 1U) < kPortCount;
}

} // namespace

TransmitStatus CanPorts::Transmit(const CanFrame& frame) noexcept
{
    if ((Objections(frame) == 0U) && IsPort(frame.port))
    {
        return DoTransmit(frame);
    }
    return TransmitStatus::kRefused;
}

MissingGuarantee CheckGuarantees(const CanGuarantees& guarantees) noexcept
{
    if (guarantees.bus_order != Guarantee::kGiven)
    {
        return MissingGuarantee::kBusOrder;
    }
    if (guarantees.stamps != Guarantee::kGiven)
    {
        return MissingGuarantee::kStamps;
    }
    if (guarantees.confirmations != Guarantee::kGiven)
    {
        return MissingGuarantee::kConfirmations;
    }
    return MissingGuarantee::kNone;
}

} // namespace counterpoint::hal
