// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "can_ports.hpp"

namespace port_skeleton
{

using counterpoint::hal::Guarantee;

counterpoint::hal::CanGuarantees CanPorts::Guarantees() const noexcept
{
    return counterpoint::hal::CanGuarantees{Guarantee::kAbsent, Guarantee::kAbsent, Guarantee::kAbsent};
}

CanEvent CanPorts::Next() noexcept
{
    return CanEvent{EventKind::kNothing, counterpoint::StampedFrame{}};
}

counterpoint::hal::TransmitStatus CanPorts::DoTransmit(const counterpoint::CanFrame& /*frame*/) noexcept
{
    return counterpoint::hal::TransmitStatus::kRefused;
}

PartState CanPorts::State() const noexcept
{
    return PartState::kMissing;
}

PartState CanPorts::StateOfReception() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
