// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "watchdog.hpp"

namespace port_skeleton
{

counterpoint::hal::WatchdogQuestion Watchdog::Question() noexcept
{
    return counterpoint::hal::WatchdogQuestion{0U};
}

void Watchdog::Answer(const counterpoint::hal::WatchdogAnswer& /*answer*/) noexcept
{
}

PartState Watchdog::State() const noexcept
{
    return PartState::kMissing;
}

} // namespace port_skeleton
