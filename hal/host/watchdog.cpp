// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/watchdog.hpp"

namespace counterpoint::host
{

namespace
{

[[nodiscard]] Instant InstantOf(const BusTime us)
{
    return Instant{static_cast<std::uint32_t>(us)};
}

} // namespace

HostWatchdog::HostWatchdog(const VirtualBus& bus) : bus_(bus)
{
}

void HostWatchdog::Start(const hal::WatchdogWindow& window)
{
    window_ = window;
    answered_us_ = bus_.Now() / kMicrosecond;
    timer_.Start(window, InstantOf(answered_us_));
    ++starts_;
}

hal::WatchdogQuestion HostWatchdog::Question() noexcept
{
    return timer_.Question();
}

void HostWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    answered_us_ = bus_.Now() / kMicrosecond;
    timer_.Answer(answer, InstantOf(answered_us_));
}

bool HostWatchdog::IsAlive()
{
    timer_.Examine(InstantOf(bus_.Now() / kMicrosecond));
    return timer_.IsAlive();
}

BusTime HostWatchdog::TripsAt()
{
    return IsAlive() ? ((answered_us_ + window_.ends_us + 1) * kMicrosecond) : kNever;
}

} // namespace counterpoint::host
