// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/can_ports.hpp"

namespace counterpoint::hal
{

namespace
{

constexpr std::uint32_t kGreatestStandardIdentifier = 0x7FFU;

[[nodiscard]] bool IsSendable(const CanFrame& frame) noexcept
{
    return (frame.kind == FrameKind::kData) && (frame.identifier <= kGreatestStandardIdentifier) &&
           (frame.length_bytes <= kMaxPayloadBytes);
}

[[nodiscard]] bool IsPort(const CanPortId port) noexcept
{
    return (port == CanPortId::kFirst) || (port == CanPortId::kSecond);
}

} // namespace

TransmitStatus CanPorts::Transmit(const CanFrame& frame) noexcept
{
    const bool sendable = IsSendable(frame);
    const bool port_known = IsPort(frame.port);
    if (sendable && port_known)
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
