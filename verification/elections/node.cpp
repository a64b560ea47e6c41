// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/elections/node.hpp"

#include "canopen/cia301/nmt/slave.hpp"

#include <algorithm>

namespace counterpoint::elections
{
namespace
{

constexpr std::uint8_t kOperational = 5U;

} // namespace

void Node::PowerOn(const Time now)
{
    is_on = true;
    power_on = kNever;
    recovers_at = kNever;
    heartbeat_at = kNever;
    master.emplace(cia302::FlyingMasterParts{setup, plan.times, *plan.options, *this, *this});
    Start(now);
}

void Node::Start(const Time now)
{
    bus->Attach(index, true, now);
    static_cast<void>(master->Start(clock.Stamp(now)));
}

void Node::Cycle(const Time now)
{
    if (!is_on)
    {
        PowerOn(now);
    }
    else if (recovers_at <= now)
    {
        recovers_at = kNever;
        Start(now);
    }
    else
    {
        for (const CanFrame& frame : heard)
        {
            master->OnFrame(frame, clock.Stamp(now));
        }
        heard.clear();
        master->OnCycle(clock.Stamp(now));
        if (master->IsActiveMaster() && (heartbeat_at <= now))
        {
            heartbeat_at = clock.WorldOf(clock.LocalOf(now) + heartbeat);
            static_cast<void>(Send(cia301::ErrorControlFrame(plan.node, kOperational)));
        }
    }
}

Time Node::Next(const Time now, const Time earliest) const
{
    if (!is_on)
    {
        return power_on;
    }
    if (recovers_at != kNever)
    {
        return recovers_at;
    }
    const cia302::FlyingDeadline deadline = master->Next();
    // Modular instants: the difference to now is exact. A step that is due already waits for the next cycle.
    const auto left = static_cast<std::int32_t>(deadline.at.us - clock.Stamp(now).us);
    const Time step =
        deadline.is_set ? clock.TickFrom(std::max(clock.WorldOf(clock.LocalOf(now) + left), earliest)) : kNever;
    const bool beats = was_active && (heartbeat_at != kNever);
    const Time beat = beats ? clock.TickFrom(std::max(heartbeat_at, earliest)) : kNever;
    const Time poll = heard.empty() ? kNever : clock.TickFrom(earliest);
    return std::min({step, beat, poll});
}

bool Node::Send(const CanFrame& frame) noexcept
{
    return (recovers_at == kNever) && bus->Submit(index, frame);
}

void Node::OnFlyingMaster(const cia302::FlyingEvent event, const cia302::MasterClaim& claim, const Instant now) noexcept
{
    static_cast<void>(claim);
    static_cast<void>(now);
    configuration_errors += (event == cia302::FlyingEvent::kConfigurationError) ? 1U : 0U;
}

void Node::OnInitialising(const Instant now) noexcept
{
    if (recovers_at == kNever)
    {
        static_cast<void>(master->Start(now));
    }
}

} // namespace counterpoint::elections
