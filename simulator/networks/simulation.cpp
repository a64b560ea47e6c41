// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What passes in a simulated network.
#include "simulator/networks/simulation.hpp"

#include "runtime/network_files/file.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kManagerCycle = kNanosecondsPerMillisecond;

std::uint64_t Ns(const Nanoseconds time)
{
    return static_cast<std::uint64_t>(time);
}

std::uint64_t Us(const Nanoseconds time)
{
    return static_cast<std::uint64_t>(time / kNanosecondsPerMicrosecond);
}

template <typename Item> std::vector<Item> ByTime(std::vector<Item> items)
{
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& left, const Item& right) { return left.at < right.at; });
    return items;
}

host::LiveFrame EmergencyFrame(const Action& action)
{
    constexpr std::uint32_t kEmergencies = 0x80U;
    host::LiveFrame frame;
    frame.identifier = kEmergencies + action.node_id;
    frame.length_bytes = host::kClassicalDataBytes;
    frame.data[0] = static_cast<std::uint8_t>(action.code & 0xFFU);
    frame.data[1] = static_cast<std::uint8_t>(action.code >> 8U);
    frame.data[2] = 1U;
    return frame;
}

/// Eight zeros, or what is to be sent.
host::LiveFrame FrameOf(const Action& action)
{
    host::LiveFrame frame;
    const bool is_babble = action.kind == ActionKind::kBabble;
    frame.identifier = action.identifier;
    frame.length_bytes = is_babble ? host::kClassicalDataBytes : static_cast<std::uint8_t>(action.data.size());
    std::copy(action.data.begin(), action.data.end(), std::begin(frame.data));
    return frame;
}
NmtState StateFrom(const cia301::NodeState state)
{
    switch (state)
    {
    case cia301::NodeState::kInvalid:
        return NmtState::kInvalid;
    case cia301::NodeState::kPreOperational:
        return NmtState::kPreOperational;
    case cia301::NodeState::kOperational:
        return NmtState::kOperational;
    case cia301::NodeState::kStopped:
        return NmtState::kStopped;
    default:
        return NmtState::kInitialising;
    }
}
} // namespace

NetworkSimulation::NetworkSimulation(const Scenario& scenario, Journal& journal)
    : scenario_(scenario), journal_(journal), bus_(scenario.bitrate), setups_(scenario.nodes),
      has_come_(scenario.nodes.size(), false), told_(scenario.nodes.size()), actions_(ByTime(scenario.actions))
{
    LoadManagers();
    RequireOfManagers(scenario_, managers_);
    if (journal_.KeepsAll())
    {
        bus_.Listen([this](const host::LiveFrame& frame, const std::uint64_t begin_ns, const std::size_t owner)
                    { TellFrame(frame, begin_ns, owner); });
    }
}

void NetworkSimulation::LoadManagers()
{
    for (const ManagerSetup& setup : scenario_.managers)
    {
        auto manager = std::make_unique<SimulatedManager>();
        manager->setup = setup;
        manager->place = scenario_.nodes.size() + managers_.size();
        manager->net = std::make_unique<network::LoadedNetwork>(
            runtime::ReadNetworkFile(setup.network, setup.node_id, scenario_.profile));
        manager->node = manager->net->Setup().own.value;
        for (const auto& other : managers_)
        {
            if (other->node == manager->node)
            {
                throw YamlError(setup.source.file, setup.source.place,
                                "manager " + std::to_string(manager->node) + " a second time",
                                "each manager with a node-ID of its own");
            }
        }
        managers_.push_back(std::move(manager));
    }
}

Nanoseconds NetworkSimulation::Next() const
{
    const std::uint64_t of_bus = bus_.NextNs();
    Nanoseconds next = (of_bus > Ns(kNever)) ? kNever : static_cast<Nanoseconds>(of_bus);
    next = (next_action_ < actions_.size()) ? std::min(next, actions_[next_action_].at) : next;
    for (const auto& manager : managers_)
    {
        const Nanoseconds at = (manager->port == nullptr && manager->station == nullptr) ? manager->setup.at
                               : (manager->port != nullptr)                              ? manager->next_cycle
                                                                                         : kNever;
        next = std::min(next, at);
    }
    for (std::size_t place = 0U; place < setups_.size(); ++place)
    {
        next = has_come_[place] ? next : std::min(next, setups_[place].phase);
    }
    for (const auto& device : devices_)
    {
        next = std::min(next, static_cast<Nanoseconds>(device->NextNs()));
    }
    for (const Storm& storm : storms_)
    {
        next = std::min(next, storm.next);
    }
    return next;
}

// Also at `until` itself, where somebody looks: whatever the bus has by then is taken.
void NetworkSimulation::RunUntil(const Nanoseconds until)
{
    while (now_ < until)
    {
        now_ = (now_ < 0) ? 0 : std::min(std::max(Next(), now_ + 1), until);
        Step(now_);
    }
}

void NetworkSimulation::Step(const Nanoseconds now)
{
    bus_.Advance(Ns(now));
    StartDue(now);
    for (; next_action_ < actions_.size() && actions_[next_action_].at <= now; ++next_action_)
    {
        Act(actions_[next_action_], now);
    }
    RunStorms(now);
    for (const auto& device : devices_)
    {
        if (device->HasFrames() || device->NextNs() <= Ns(now))
        {
            device->Run(Ns(now));
        }
    }
    for (const auto& manager : managers_)
    {
        if (manager->port != nullptr)
        {
            RunManager(*manager, now);
        }
    }
    TellDevices(now);
}

void NetworkSimulation::TellFrame(const host::LiveFrame& frame, const std::uint64_t begin_ns, const std::size_t owner)
{
    journal_.Tell(FrameEntry{static_cast<Nanoseconds>(begin_ns), static_cast<Nanoseconds>(frame.time_ns),
                             host::ToCanFrame(frame, CanPortId::kFirst), owner, host::FrameFate::kComplete});
}

void NetworkSimulation::TellOutputs(SimulatedDevice& device, const SrdoMask changed, const Nanoseconds now)
{
    for (const runtime::SrdoModel& srdo : device.Device().Model().Srdos())
    {
        const SlotIndex slot = device.Device().Model().SlotOf(srdo.number).value_or(0U);
        if (((changed >> slot) & 1U) != 0U)
        {
            journal_.Note({now, EventKind::kOutput, device.Node(), srdo.number, (device.Device().Open() >> slot) & 1U});
        }
    }
}

/// States and outputs of the devices that are there, where they changed.
void NetworkSimulation::TellDevices(const Nanoseconds now)
{
    for (NodeIndex node = 0U; node < setups_.size(); ++node)
    {
        SimulatedDevice* const device = DeviceOf(node);
        Told& told = told_[node];
        const Told is{(device == nullptr) ? cia301::NodeState::kInvalid : device->Device().Services().State(),
                      (device == nullptr) ? SrdoMask{0U} : device->Device().Open()};
        if (is.state != told.state)
        {
            const bool is_off = is.state == cia301::NodeState::kInvalid;
            journal_.Note({now, is_off ? EventKind::kPowerOff : EventKind::kNmt, node, 0U,
                           static_cast<std::uint64_t>(StateFrom(is.state))});
        }
        if (device != nullptr && is.open != told.open)
        {
            TellOutputs(*device, is.open ^ told.open, now);
        }
        told = is;
    }
}

void NetworkSimulation::StartDue(const Nanoseconds now)
{
    for (NodeIndex node = 0U; node < setups_.size(); ++node)
    {
        if (!has_come_[node] && setups_[node].phase <= now)
        {
            has_come_[node] = true;
            Insert(node, now);
        }
    }
    for (const auto& manager : managers_)
    {
        if (manager->station == nullptr && manager->setup.at <= now)
        {
            StartManager(*manager, now);
        }
    }
}

void NetworkSimulation::StartManager(SimulatedManager& manager, const Nanoseconds now)
{
    manager.port = std::make_unique<SimulatedPort>(bus_, manager.place);
    manager.next_cycle = now + kManagerCycle;
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
            journal_.Note(ManagerEntry{static_cast<Nanoseconds>(event.at_us) * kNanosecondsPerMicrosecond,
                                       manager.place, event.node, event.kind, event.text, runtime::JsonLine(event)});
        });
    manager.station->Begin(Us(now));
}

void NetworkSimulation::RunManager(SimulatedManager& manager, const Nanoseconds now)
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
            manager.station->OnFrame(passed, Us(now));
        }
    }
    if (now >= manager.next_cycle)
    {
        manager.next_cycle += kManagerCycle;
        manager.station->OnCycle(Us(now));
    }
}

void NetworkSimulation::Act(const Action& action, const Nanoseconds now)
{
    switch (action.kind)
    {
    case ActionKind::kOrder:
    {
        SimulatedManager& manager = ManagerOf(managers_, action.node_id, action.source);
        if (manager.port != nullptr)
        {
            const std::string answer = manager.station->Carry(runtime::ParseManagerOrder(action.order), Us(now));
            manager.station->Tell("order", "order " + action.order + ": " + answer,
                                  {{"order", action.order}, {"answer", answer}}, Us(now));
        }
        break;
    }
    case ActionKind::kKillManager:
        ManagerOf(managers_, action.node_id, action.source).port.reset();
        break;
    case ActionKind::kBusOff:
    case ActionKind::kNoController:
    case ActionKind::kBusBack:
        ActOnController(action, now);
        break;
    case ActionKind::kEmcyStorm:
    case ActionKind::kBabble:
    case ActionKind::kSend:
        storms_.push_back(
            {action, std::make_unique<SimulatedPort>(bus_, scenario_.nodes.size() + managers_.size()), now});
        break;
    case ActionKind::kPull:
    case ActionKind::kInsert:
    case ActionKind::kReset:
    case ActionKind::kReplace:
    case ActionKind::kDuplicate:
    case ActionKind::kStore:
    case ActionKind::kAcknowledge:
    default:
        ActOnDevice(action, now);
        break;
    }
}

void NetworkSimulation::ActOnController(const Action& action, const Nanoseconds now)
{
    SimulatedManager& manager = ManagerOf(managers_, action.node_id, action.source);
    cia302::ControllerState state = cia302::ControllerState::kRunning;
    state = (action.kind == ActionKind::kBusOff) ? cia302::ControllerState::kBusOff : state;
    state = (action.kind == ActionKind::kNoController) ? cia302::ControllerState::kAbsent : state;
    manager.is_off_bus = state != cia302::ControllerState::kRunning;
    if (manager.port != nullptr)
    {
        const std::string word = !manager.is_off_bus                           ? "active"
                                 : (state == cia302::ControllerState::kBusOff) ? "bus_off"
                                                                               : "down";
        manager.station->Tell("bus", "bus " + word, {{"state", word}}, Us(now));
        manager.station->Host().OnController(state, runtime::InstantAt(Us(now)));
    }
}

void NetworkSimulation::ActOnDevice(const Action& action, const Nanoseconds now)
{
    SimulatedDevice* const device = DeviceOf(action.node);
    const bool is_off =
        action.kind == ActionKind::kPull || action.kind == ActionKind::kReset || action.kind == ActionKind::kReplace;
    const bool is_on = action.kind == ActionKind::kInsert || action.kind == ActionKind::kReset ||
                       action.kind == ActionKind::kReplace || action.kind == ActionKind::kDuplicate;
    if (device != nullptr && action.kind == ActionKind::kAcknowledge)
    {
        device->Acknowledge(action.srdo, Ns(now));
    }
    else if (device != nullptr && action.kind == ActionKind::kStore)
    {
        device->Store(action.object, action.value);
    }
    else if (is_off)
    {
        Pull(action.node);
    }
    if (action.kind == ActionKind::kReplace)
    {
        setups_[action.node].serial = action.serial;
    }
    if (is_on)
    {
        Insert(action.node, now);
    }
}

void NetworkSimulation::Insert(const NodeIndex node, const Nanoseconds now)
{
    devices_.push_back(std::make_unique<SimulatedDevice>(node, setups_[node], bus_, Ns(now)));
}

void NetworkSimulation::Pull(const NodeIndex node)
{
    devices_.erase(std::remove_if(devices_.begin(), devices_.end(),
                                  [node](const std::unique_ptr<SimulatedDevice>& device)
                                  { return device->Node() == node; }),
                   devices_.end());
}

void NetworkSimulation::RunStorms(const Nanoseconds now)
{
    for (Storm& storm : storms_)
    {
        if (storm.next <= now)
        {
            const bool is_emergency = storm.action.kind == ActionKind::kEmcyStorm;
            static_cast<void>(storm.port->Send(is_emergency ? EmergencyFrame(storm.action) : FrameOf(storm.action)));
            const Nanoseconds next = now + storm.action.every;
            storm.next = (next > storm.action.until) ? kNever : next;
        }
        host::LiveFrame unread;
        while (storm.port->Receive(unread))
        {
        }
    }
}

SimulatedDevice* NetworkSimulation::DeviceOf(const NodeIndex node)
{
    const auto found =
        std::find_if(devices_.begin(), devices_.end(),
                     [node](const std::unique_ptr<SimulatedDevice>& device) { return device->Node() == node; });
    return (found == devices_.end()) ? nullptr : found->get();
}

SimulatedManager& ManagerOf(const SimulatedManagers& managers, const std::uint8_t node_id, const Source& source)
{
    for (const auto& manager : managers)
    {
        if (node_id == 0U || manager->node == node_id)
        {
            return *manager;
        }
    }
    throw YamlError(source.file, source.place, "no manager with node-ID " + std::to_string(node_id),
                    "one of the scenario's managers");
}
} // namespace counterpoint::simulator
