// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "cross_link.hpp"

namespace port_skeleton
{

counterpoint::hal::LinkStatus CrossLink::Send(const counterpoint::hal::LinkFrame& /*frame*/) noexcept
{
    return counterpoint::hal::LinkStatus::kNothing;
}

counterpoint::hal::LinkStatus CrossLink::Receive(counterpoint::hal::LinkFrame& /*frame*/) noexcept
{
    return counterpoint::hal::LinkStatus::kNothing;
}

PartState CrossLink::State() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
