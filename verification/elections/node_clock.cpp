// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/node_clock.hpp"

namespace counterpoint::elections
{

NodeClock::NodeClock(const MasterPlan& plan, const Time cycle)
    : ppm_(plan.clock_ppm), phase_(plan.phase), cycle_(cycle), begin_(plan.clock_begin)
{
}

Time NodeClock::LocalOf(const Time at) const
{
    return at + ((at * ppm_) / kSecond);
}

Time NodeClock::WorldOf(const Time local) const
{
    Time at = (ppm_ == 0) ? local : ((local * kSecond) / (kSecond + ppm_));
    while (LocalOf(at) < local)
    {
        ++at;
    }
    return at;
}

Instant NodeClock::Stamp(const Time at) const
{
    return Instant{begin_ + static_cast<std::uint32_t>(LocalOf(at))};
}

Time NodeClock::TickFrom(const Time at) const
{
    const Time since = LocalOf(at) - phase_;
    const Time ticks = (since <= 0) ? 0 : ((since + cycle_ - 1) / cycle_);
    const Time tick = WorldOf(phase_ + (ticks * cycle_));
    return (tick < at) ? WorldOf(phase_ + ((ticks + 1) * cycle_)) : tick;
}

} // namespace counterpoint::elections
