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
    constexpr Time kUsPerMs = 1000;
    network = has_manager
                  ? std::make_unique<NetworkSide>(setup, *this, static_cast<std::uint16_t>(heartbeat / kUsPerMs))
                  : nullptr;
    cia302::FlyingMasterListener& listener =
        (network == nullptr) ? static_cast<cia302::FlyingMasterListener&>(*this) : network->Core().Role();
    master.emplace(cia302::FlyingMasterParts{setup, plan.times, *plan.options, *this, listener});
    if (network != nullptr)
    {
        bus->Attach(index, true, now);
        network->Begin(*master, clock.Stamp(now));
    }
    else
    {
        Start(now);
    }
}

void Node::Hear(const CanFrame& frame, const Time now)
{
    if (network != nullptr)
    {
        network->Core().OnFrame(frame, clock.Stamp(now));
    }
    else
    {
        master->OnFrame(frame, clock.Stamp(now));
    }
}

void Node::OnBusOff(const Time now)
{
    to_send.clear();
    if (network != nullptr)
    {
        network->Core().OnBus(false, clock.Stamp(now));
    }
    else
    {
        master->Reset(clock.Stamp(now));
    }
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
        if (network != nullptr)
        {
            bus->Attach(index, true, now);
            network->Core().OnBus(true, clock.Stamp(now));
        }
        else
        {
            Start(now);
        }
    }
    else
    {
        for (const CanFrame& frame : heard)
        {
            Hear(frame, now);
        }
        heard.clear();
        if (network != nullptr)
        {
            network->Core().OnCycle(clock.Stamp(now));
            configuration_errors += network->TakeErrors();
            return;
        }
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
    if (network != nullptr)
    {
        return clock.TickFrom(earliest);
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
    const bool is_on_bus = recovers_at == kNever;
    if (is_on_bus && has_manager)
    {
        to_send.push_back(frame);
        return (to_send.size() > 1U) || bus->Submit(index, frame);
    }
    return is_on_bus && bus->Submit(index, frame);
}

void Node::OnSent()
{
    if (!to_send.empty())
    {
        to_send.pop_front();
    }
    if (!to_send.empty())
    {
        static_cast<void>(bus->Submit(index, to_send.front()));
    }
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
