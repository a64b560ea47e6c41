// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/managers/manager.hpp"

#include "hal/host/live/bus.hpp"
#include "runtime/network_files/file.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kManagerCycle = kNanosecondsPerMillisecond;
constexpr std::int64_t kMillion = 1000000;
constexpr Nanoseconds kApart = 5; ///< No two managers, and no device, count in step.

std::uint64_t Us(const Nanoseconds time)
{
    return static_cast<std::uint64_t>(time / kNanosecondsPerMicrosecond);
}
} // namespace

SimulatedManager::SimulatedManager(const ManagerSetup& setup, const std::string& profile, const std::size_t place,
                                   host::VirtualBus& bus, Journal& journal)
    : setup_(setup), place_(place), bus_(bus), journal_(journal),
      net_(runtime::ReadNetworkFile(setup.network, setup.node_id, profile)),
      bus_node_(bus.Attach(*this, host::NodeSetup{CanPortId::kFirst, 1U})),
      begin_(setup.at + (static_cast<Nanoseconds>(place) + 1) * kApart)
{
    if (setup.at > 0)
    {
        bus_.Disconnect(bus_node_);
    }
}

void SimulatedManager::Plan(const Action& action)
{
    const auto later = std::upper_bound(actions_.begin(), actions_.end(), action,
                                        [](const Action& left, const Action& right) { return left.at < right.at; });
    actions_.insert(later, action);
}

Nanoseconds SimulatedManager::NextEvent() const noexcept
{
    const Nanoseconds heard = heard_.empty() ? kNever : heard_.front().at;
    const Nanoseconds begin = std::min((station_ == nullptr) ? begin_ : next_cycle_, heard);
    return (next_action_ < actions_.size()) ? std::min(begin, actions_[next_action_].at) : begin;
}

void SimulatedManager::Run(const Nanoseconds now)
{
    if (station_ == nullptr && begin_ <= now)
    {
        Start(now);
    }
    for (; next_action_ < actions_.size() && actions_[next_action_].at <= now; ++next_action_)
    {
        Act(actions_[next_action_], now);
    }
    TakeFrames(now);
    if (now >= next_cycle_)
    {
        next_cycle_ += CycleTime(now);
        station_->OnCycle(ClockUs(now));
    }
}

void SimulatedManager::SwitchOn(const Nanoseconds now)
{
    is_killed_ = false;
    is_off_bus_ = false;
    heard_.clear();
    Start(now);
}

void SimulatedManager::SwitchOff()
{
    if (!HasSupply())
    {
        return;
    }
    is_killed_ = true;
    next_cycle_ = kNever;
    waiting_.clear();
    bus_.AbortAll(bus_node_);
    bus_.Disconnect(bus_node_);
}

/// The time that it is told.
std::uint64_t SimulatedManager::ClockUs(const Nanoseconds now) noexcept
{
    Nanoseconds by = 0;
    if (now >= clock_.since)
    {
        by = clock_.jump + ((now - clock_.since) / kMillion * clock_.rate_ppm) +
             ((now - clock_.since) % kMillion * clock_.rate_ppm / kMillion);
    }
    const std::uint64_t us = Us(now);
    const std::uint64_t told = static_cast<std::uint64_t>((now + by) / kNanosecondsPerMicrosecond);
    fast_by_us_ = told - us;
    return told;
}

Nanoseconds SimulatedManager::CycleTime(const Nanoseconds now) const noexcept
{
    const bool drifts = now >= clock_.since && clock_.rate_ppm > -kMillion;
    return drifts ? kManagerCycle * kMillion / (kMillion + clock_.rate_ppm) : kManagerCycle;
}

void SimulatedManager::Start(const Nanoseconds now)
{
    bus_.Connect(bus_node_);
    next_cycle_ = now + kManagerCycle;
    station_ = std::make_unique<runtime::ManagerStation>(
        net_, [this](const CanFrame& frame) { return Send(frame); },
        [this](const runtime::ManagerEvent& told)
        {
            runtime::ManagerEvent event = told;
            event.at_us -= fast_by_us_; // When it happened, whatever its clock says.
            events_.push_back(event);
            journal_.Note(ManagerEntry{static_cast<Nanoseconds>(event.at_us) * kNanosecondsPerMicrosecond, place_,
                                       event.node, event.kind, event.text, runtime::JsonLine(event)});
        });
    station_->Begin(ClockUs(now));
}

bool SimulatedManager::Send(const CanFrame& frame)
{
    const bool is_taken = !is_off_bus_ && waiting_.size() < host::kLiveQueueFrames;
    if (is_taken)
    {
        waiting_.push_back(frame);
    }
    if (is_taken && waiting_.size() == 1U)
    {
        static_cast<void>(bus_.Submit(bus_node_, frame));
    }
    return is_taken;
}

void SimulatedManager::TakeFrames(const Nanoseconds now)
{
    for (; !heard_.empty() && heard_.front().at <= now; heard_.pop_front())
    {
        const HeardFrame& heard = heard_.front();
        if (!HasSupply() || is_off_bus_)
        {
            continue;
        }
        if (heard.is_own)
        {
            station_->Assembly().OnSent(heard.frame);
        }
        else
        {
            station_->OnFrame(heard.frame, ClockUs(now));
        }
    }
}

void SimulatedManager::OnReceived(const CanFrame& frame, const host::BusTime at)
{
    heard_.push_back({frame, at + ReactionTime(bus_), false});
}

void SimulatedManager::OnConfirmed(const CanFrame& frame, const host::BusTime at)
{
    heard_.push_back({frame, at + ReactionTime(bus_), true});
    if (!waiting_.empty())
    {
        waiting_.pop_front();
    }
    if (!waiting_.empty())
    {
        static_cast<void>(bus_.Submit(bus_node_, waiting_.front()));
    }
}

void SimulatedManager::OnBusOff(const host::BusTime at)
{
    TellController(cia302::ControllerState::kBusOff, "bus_off", at);
}

void SimulatedManager::Act(const Action& action, const Nanoseconds now)
{
    if (!HasSupply())
    {
        return;
    }
    switch (action.kind)
    {
    case ActionKind::kOrder:
    {
        const std::uint64_t us = ClockUs(now);
        const std::string answer = station_->Carry(runtime::ParseManagerOrder(action.order), us);
        station_->Tell("order", "order " + action.order + ": " + answer, {{"order", action.order}, {"answer", answer}},
                       us);
        return;
    }
    case ActionKind::kKillManager:
        SwitchOff();
        return;
    case ActionKind::kBusOff:
        bus_.ForceBusOff(bus_node_);
        return;
    case ActionKind::kNoController:
        bus_.AbortAll(bus_node_);
        bus_.Disconnect(bus_node_);
        TellController(cia302::ControllerState::kAbsent, "down", now);
        return;
    default:
        bus_.Connect(bus_node_);
        bus_.Recover(bus_node_);
        TellController(cia302::ControllerState::kRunning, "active", now);
        return;
    }
}

void SimulatedManager::TellController(const cia302::ControllerState state, const char* const word,
                                      const Nanoseconds now)
{
    is_off_bus_ = state != cia302::ControllerState::kRunning;
    waiting_.clear();
    if (HasSupply())
    {
        const std::uint64_t us = ClockUs(now);
        station_->Tell("bus", std::string("bus ") + word, {{"state", word}}, us);
        station_->Assembly().OnController(state, runtime::InstantAt(us));
    }
}
} // namespace counterpoint::simulator
