// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What passes in a simulated network; network_verdicts.cpp judges it.
#include "simulator/networks/simulation.hpp"

#include "runtime/network_files/file.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint64_t kNsPerUs = 1000U;
constexpr std::uint64_t kManagerCycleNs = 1000000U;
constexpr std::uint64_t kNeverNs = std::numeric_limits<std::uint64_t>::max();

template <typename Item> std::vector<Item> ByTime(std::vector<Item> items)
{
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& left, const Item& right) { return left.at_ns < right.at_ns; });
    return items;
}

host::LiveFrame EmergencyFrame(const NetworkAction& action)
{
    constexpr std::uint32_t kEmergencies = 0x80U;
    host::LiveFrame frame;
    frame.identifier = kEmergencies + action.node;
    frame.length_bytes = host::kClassicalDataBytes;
    frame.data[0] = static_cast<std::uint8_t>(action.code & 0xFFU);
    frame.data[1] = static_cast<std::uint8_t>(action.code >> 8U);
    frame.data[2] = 1U;
    return frame;
}

/// Eight zeros, or what is to be sent.
host::LiveFrame FrameOf(const NetworkAction& action)
{
    host::LiveFrame frame;
    const bool is_babble = action.kind == NetworkActionKind::kBabble;
    frame.identifier = action.identifier;
    frame.length_bytes = is_babble ? host::kClassicalDataBytes : static_cast<std::uint8_t>(action.data.size());
    std::copy(action.data.begin(), action.data.end(), std::begin(frame.data));
    return frame;
}
} // namespace

NetworkSimulation::NetworkSimulation(const NetworkScenario& scenario, TellEvent tell)
    : scenario_(scenario), tell_(std::move(tell)), bus_(scenario.bitrate), setups_(scenario.devices),
      has_come_(scenario.devices.size(), false), actions_(ByTime(scenario.actions)),
      expectations_(ByTime(scenario.expectations))
{
    for (const ScenarioManager& setup : scenario.managers)
    {
        auto manager = std::make_unique<SimulatedManager>();
        manager->setup = setup;
        manager->net = std::make_unique<network::LoadedNetwork>(runtime::ReadNetworkFile(setup.network, setup.node));
        manager->node = manager->net->Setup().own.value;
        for (const auto& other : managers_)
        {
            if (other->node == manager->node)
            {
                throw YamlError(scenario_.file, setup.place,
                                "manager " + std::to_string(manager->node) + " a second time",
                                "each manager with a node-ID of its own");
            }
        }
        managers_.push_back(std::move(manager));
    }
    for (const NetworkExpectation& expectation : expectations_)
    {
        RequireKnown(expectation);
    }
    RequireManagers();
}

std::uint64_t NetworkSimulation::NextNs() const
{
    std::uint64_t next = std::min(bus_.NextNs(), scenario_.duration_ns);
    next = (next_action_ < actions_.size()) ? std::min(next, actions_[next_action_].at_ns) : next;
    next = (next_expectation_ < expectations_.size()) ? std::min(next, expectations_[next_expectation_].at_ns) : next;
    for (const auto& manager : managers_)
    {
        const std::uint64_t at = (manager->port == nullptr && manager->station == nullptr) ? manager->setup.at_ns
                                 : (manager->port != nullptr)                              ? manager->next_cycle_ns
                                                                                           : kNeverNs;
        next = std::min(next, at);
    }
    for (std::size_t place = 0U; place < setups_.size(); ++place)
    {
        next = has_come_[place] ? next : std::min(next, setups_[place].at_ns);
    }
    for (const auto& device : devices_)
    {
        next = std::min(next, device->NextNs());
    }
    for (const Storm& storm : storms_)
    {
        next = std::min(next, storm.next_ns);
    }
    return next;
}

void NetworkSimulation::Run()
{
    std::uint64_t now_ns = 0U;
    Step(now_ns);
    while (now_ns < scenario_.duration_ns)
    {
        now_ns = std::max(NextNs(), now_ns + 1U);
        Step(now_ns);
    }
    verdicts_.reserve(expectations_.size());
    Judge(kNeverNs);
}

void NetworkSimulation::Step(const std::uint64_t now_ns)
{
    bus_.Advance(now_ns);
    TellFrames();
    StartDue(now_ns);
    for (; next_action_ < actions_.size() && actions_[next_action_].at_ns <= now_ns; ++next_action_)
    {
        Act(actions_[next_action_], now_ns);
    }
    RunStorms(now_ns);
    for (const auto& device : devices_)
    {
        if (device->HasFrames() || device->NextNs() <= now_ns)
        {
            device->Run(now_ns);
        }
    }
    for (const auto& manager : managers_)
    {
        if (manager->port != nullptr)
        {
            RunManager(*manager, now_ns);
        }
    }
    Judge(now_ns);
}

void NetworkSimulation::Listen(TellFrame tell)
{
    tell_frame_ = std::move(tell);
    listener_ = std::make_unique<SimulatedPort>(bus_);
}

void NetworkSimulation::TellFrames()
{
    host::LiveFrame frame;
    while (listener_ != nullptr && listener_->Receive(frame))
    {
        tell_frame_(frame);
    }
}

void NetworkSimulation::StartDue(const std::uint64_t now_ns)
{
    for (std::size_t place = 0U; place < setups_.size(); ++place)
    {
        if (!has_come_[place] && setups_[place].at_ns <= now_ns)
        {
            has_come_[place] = true;
            devices_.push_back(std::make_unique<SimulatedDevice>(setups_[place], bus_, now_ns));
        }
    }
    for (const auto& each : managers_)
    {
        SimulatedManager& manager = *each;
        if (manager.station == nullptr && manager.setup.at_ns <= now_ns)
        {
            manager.port = std::make_unique<SimulatedPort>(bus_);
            manager.next_cycle_ns = now_ns + kManagerCycleNs;
            manager.station = std::make_unique<runtime::ManagerStation>(
                *manager.net,
                [&manager](const CanFrame& frame)
                {
                    return manager.port != nullptr && !manager.is_off_bus &&
                           manager.port->Send(host::FromCanFrame(frame)) == host::SendResult::kSent;
                },
                [this, &manager](const runtime::ManagerEvent& event)
                {
                    manager.events.push_back(event);
                    tell_(manager, event);
                });
            manager.station->Begin(now_ns / kNsPerUs);
        }
    }
}

void NetworkSimulation::RunManager(SimulatedManager& manager, const std::uint64_t now_ns)
{
    host::LiveFrame frame;
    while (manager.port->Receive(frame))
    {
        const CanFrame passed = host::ToCanFrame(frame, CanPortId::kFirst);
        if (manager.is_off_bus)
        {
            continue; // It hears nothing either.
        }
        if (frame.own)
        {
            manager.station->Host().OnSent(passed);
        }
        else
        {
            manager.station->OnFrame(passed, now_ns / kNsPerUs);
        }
    }
    if (now_ns >= manager.next_cycle_ns)
    {
        manager.next_cycle_ns += kManagerCycleNs;
        manager.station->OnCycle(now_ns / kNsPerUs);
    }
}

void NetworkSimulation::Act(const NetworkAction& action, const std::uint64_t now_ns)
{
    switch (action.kind)
    {
    case NetworkActionKind::kOrder:
    {
        SimulatedManager& manager = ManagerOf(action.node, {});
        if (manager.port != nullptr)
        {
            const std::string answer =
                manager.station->Carry(runtime::ParseManagerOrder(action.order), now_ns / kNsPerUs);
            manager.station->Tell("order", "order " + action.order + ": " + answer,
                                  {{"order", action.order}, {"answer", answer}}, now_ns / kNsPerUs);
        }
        break;
    }
    case NetworkActionKind::kKillManager:
        ManagerOf(action.node, {}).port.reset();
        break;
    case NetworkActionKind::kBusOff:
    case NetworkActionKind::kNoController:
    case NetworkActionKind::kBusBack:
        ActOnController(action, now_ns);
        break;
    case NetworkActionKind::kEmcyStorm:
    case NetworkActionKind::kBabble:
    case NetworkActionKind::kSend:
        storms_.push_back({action, std::make_unique<SimulatedPort>(bus_), now_ns});
        break;
    case NetworkActionKind::kPull:
    case NetworkActionKind::kInsert:
    case NetworkActionKind::kReset:
    case NetworkActionKind::kReplace:
    case NetworkActionKind::kDuplicate:
    case NetworkActionKind::kStore:
    case NetworkActionKind::kAcknowledge:
    default:
        ActOnDevice(action, now_ns);
        break;
    }
}

void NetworkSimulation::ActOnController(const NetworkAction& action, const std::uint64_t now_ns)
{
    SimulatedManager& manager = ManagerOf(action.node, {});
    cia302::ControllerState state = cia302::ControllerState::kRunning;
    state = (action.kind == NetworkActionKind::kBusOff) ? cia302::ControllerState::kBusOff : state;
    state = (action.kind == NetworkActionKind::kNoController) ? cia302::ControllerState::kAbsent : state;
    manager.is_off_bus = state != cia302::ControllerState::kRunning;
    if (manager.port != nullptr)
    {
        const std::string word = !manager.is_off_bus                           ? "active"
                                 : (state == cia302::ControllerState::kBusOff) ? "bus_off"
                                                                               : "down";
        manager.station->Tell("bus", "bus " + word, {{"state", word}}, now_ns / kNsPerUs);
        manager.station->Host().OnController(state, runtime::InstantAt(now_ns / kNsPerUs));
    }
}

void NetworkSimulation::ActOnDevice(const NetworkAction& action, const std::uint64_t now_ns)
{
    SimulatedDevice* const device = DeviceOf(action.node);
    const bool is_off = action.kind == NetworkActionKind::kPull || action.kind == NetworkActionKind::kReset ||
                        action.kind == NetworkActionKind::kReplace;
    const bool is_on = action.kind == NetworkActionKind::kInsert || action.kind == NetworkActionKind::kReset ||
                       action.kind == NetworkActionKind::kReplace || action.kind == NetworkActionKind::kDuplicate;
    if (device != nullptr && action.kind == NetworkActionKind::kAcknowledge)
    {
        device->Acknowledge(action.srdo, now_ns);
    }
    else if (device != nullptr && action.kind == NetworkActionKind::kStore)
    {
        device->Store(action.object, action.value);
    }
    else if (is_off)
    {
        Pull(action.node);
    }
    for (ScenarioDevice& setup : setups_)
    {
        const bool is_other = action.kind == NetworkActionKind::kReplace && setup.node == action.node;
        setup.serial = is_other ? std::optional(action.serial) : setup.serial;
    }
    if (is_on)
    {
        Insert(action.node, now_ns);
    }
}

void NetworkSimulation::Insert(const std::uint8_t node, const std::uint64_t now_ns)
{
    for (const ScenarioDevice& setup : setups_)
    {
        if (setup.node == node)
        {
            devices_.push_back(std::make_unique<SimulatedDevice>(setup, bus_, now_ns));
            return;
        }
    }
}

void NetworkSimulation::Pull(const std::uint8_t node)
{
    devices_.erase(std::remove_if(devices_.begin(), devices_.end(),
                                  [node](const std::unique_ptr<SimulatedDevice>& device)
                                  { return device->Node() == node; }),
                   devices_.end());
}

void NetworkSimulation::RunStorms(const std::uint64_t now_ns)
{
    for (Storm& storm : storms_)
    {
        if (storm.next_ns <= now_ns)
        {
            const bool is_emergency = storm.action.kind == NetworkActionKind::kEmcyStorm;
            static_cast<void>(storm.port->Send(is_emergency ? EmergencyFrame(storm.action) : FrameOf(storm.action)));
            const std::uint64_t next_ns = now_ns + storm.action.every_ns;
            storm.next_ns = (next_ns > storm.action.until_ns) ? kNeverNs : next_ns;
        }
        host::LiveFrame unread;
        while (storm.port->Receive(unread))
        {
        }
    }
}

SimulatedDevice* NetworkSimulation::DeviceOf(const std::uint8_t node)
{
    SimulatedDevice* found = nullptr;
    for (const auto& device : devices_)
    {
        found = (found == nullptr && device->Node() == node) ? device.get() : found;
    }
    return found;
}

SimulatedManager& NetworkSimulation::ManagerOf(const std::uint8_t node, const Place& place)
{
    for (const auto& manager : managers_)
    {
        if (node == 0U || manager->node == node)
        {
            return *manager;
        }
    }
    throw YamlError(scenario_.file, place, "no manager with node-ID " + std::to_string(node),
                    "one of the scenario's managers");
}
} // namespace counterpoint::simulator
