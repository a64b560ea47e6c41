// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/network.hpp"

#include "simulator/scenario/parts.hpp"
#include "simulator/world/network_check.hpp"

#include "canopen/cia306/file/device_reader.hpp"

#include <algorithm>
#include <optional>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint32_t kHeartbeats = 0x700U;

host::BitRate RateOf(const Scenario& scenario)
{
    return host::BitRateFrom(scenario.bitrate).value_or(host::BitRate::k500k);
}

/// Whether anybody wants to know what goes on inside the nodes.
bool IsInsightWanted(const Scenario& scenario, const Journal& journal)
{
    return journal.KeepsAll() || !scenario.faults.empty() ||
           std::any_of(scenario.expectations.begin(), scenario.expectations.end(),
                       [](const Expectation& expectation) { return expectation.kind == ExpectationKind::kDetectedBy; });
}
} // namespace

Network::Network(const Scenario& scenario, Journal& journal)
    : unheard_(false), world_{scenario, journal, host::VirtualBus(RateOf(scenario)), {}, {}, {}, {}},
      events_(world_, agenda_)
{
    if (!scenario.managers.empty())
    {
        world_.bus.TakeTurns(); // Managers and second devices send the same identifiers, each by its own clock.
    }
    BuildNodes();
    RequireThatEverythingExists(world_);
    BuildLinks();
    for (const runtime::LogicRule& rule : scenario.logic)
    {
        static_cast<void>(At(rule.node).App().Logic().AddRule(rule)); // Its objects exist.
    }
    faults_ = std::make_unique<NetworkFaults>(world_, agenda_);
    // What the DCFs make impossible is found now and not in the middle of the run.
    for (const std::unique_ptr<Node>& node : world_.nodes)
    {
        node->Rehearse();
    }
    BuildStorms();
    events_.PlanAll();
    faults_->PlanAll();
}

void Network::BuildNodes()
{
    const bool is_tapped = IsInsightWanted(world_.scenario, world_.journal);
    for (NodeIndex index = 0U; index < world_.scenario.nodes.size(); ++index)
    {
        BuildNode(index, world_.scenario.nodes[index], world_.journal, is_tapped);
    }
    for (const Action& action : world_.scenario.actions)
    {
        if (action.kind == ActionKind::kDuplicate)
        {
            duplicates_.push_back(world_.scenario.nodes[action.node]);
            duplicates_.back().phase = kNever;
            BuildNode(action.node, duplicates_.back(), unheard_, false);
        }
    }
}

// With managers each device runs its services; of two CPUs the first one does. [SRS_SIM_060, SRS_SIM_210]
void Network::BuildNode(const NodeIndex index, const NodeSetup& setup, Journal& journal, const bool is_tapped)
{
    const bool has_managers = !world_.scenario.managers.empty();
    const runtime::SafetyNeed need = has_managers ? runtime::SafetyNeed::kOptional : runtime::SafetyNeed::kRequired;
    RequireFile(setup.dcf, setup.source, "a DCF");
    world_.models.push_back(std::make_unique<runtime::DeviceModel>(setup.dcf, setup.node_id, need));
    runtime::DeviceModel& model = *world_.models.back();
    if (setup.controllers > 1U)
    {
        model.UseTwoControllers();
    }
    std::optional<cia306::Device> file;
    if (has_managers && setup.role != runtime::CpuRole::kB)
    {
        file = cia306::ReadDeviceFile(setup.dcf);
    }
    world_.nodes.push_back(std::make_unique<Node>(
        NodePlace{index, world_.bus, journal, is_tapped, file ? &*file : nullptr}, setup, model));
    std::uint32_t controller = 0U;
    for (const host::NodeIndex place : world_.nodes.back()->Controllers().BusNodes())
    {
        ++controller;
        world_.places.resize(place + 1U);
        world_.places[place] = {index, controller, kNoFaultIndex};
        world_.bus.WaitOnce(place, kHeartbeats + model.Config().node_id);
    }
}

void Network::BuildLinks()
{
    for (NodeIndex index = 0U; index < Size(); ++index)
    {
        if (world_.scenario.nodes[index].role == runtime::CpuRole::kA)
        {
            LinkWire& wire =
                *world_.wires.emplace(index, std::make_unique<LinkWire>(world_.scenario, index, world_.journal))
                     .first->second;
            At(index).Firmware().Join(wire);
            At(index + 1U).Firmware().Join(wire);
        }
    }
}

void Network::BuildStorms()
{
    for (const Action& action : world_.scenario.actions)
    {
        if (IsStorm(action.kind))
        {
            Storm& storm = storms_.emplace_back(action, world_.bus);
            Join(storm, storm.BusNode(), world_.scenario.nodes.size() + world_.scenario.managers.size());
        }
    }
}

void Network::Join(Participant& participant, const host::NodeIndex bus_node, const NodeIndex whose)
{
    world_.places.resize(std::max<std::size_t>(world_.places.size(), bus_node + 1U));
    world_.places[bus_node] = {whose, 1U, kNoFaultIndex};
    participants_.push_back(&participant);
}

void Network::DeliverMessages()
{
    for (const auto& [first, wire] : world_.wires)
    {
        while (const std::optional<LinkArrival> arrival = wire->Take(Now()))
        {
            At(arrival->receiver).Firmware().OnMessage(arrival->frame);
        }
    }
}

Nanoseconds Network::NextEvent() const noexcept
{
    // Services and managers act on what the bus brings.
    const Nanoseconds of_bus = world_.scenario.managers.empty() ? kNever : world_.bus.NextEvent();
    Nanoseconds next = std::min(agenda_.NextEvent(), of_bus);
    for (const std::unique_ptr<Node>& node : world_.nodes)
    {
        next = std::min(next, node->NextEvent());
    }
    for (const auto& [first, wire] : world_.wires)
    {
        next = std::min(next, wire->NextArrival());
    }
    for (const Participant* const participant : participants_)
    {
        next = std::min(next, participant->NextEvent());
    }
    return next;
}

// t = the next instant of bus, world, links, nodes and others; first the bus up to t, then the world, then messages
// between CPUs, then the nodes in their order, then the others.
void Network::RunUntil(const Nanoseconds until)
{
    host::BusObserver* const observer = world_.journal.KeepsAll() ? this : nullptr;
    for (Nanoseconds next = NextEvent(); next <= until && next != kNever; next = NextEvent())
    {
        world_.bus.Advance(next, observer);
        agenda_.Run(next);
        if (!world_.wires.empty())
        {
            DeliverMessages();
        }
        for (const std::unique_ptr<Node>& node : world_.nodes)
        {
            if (node->NextEvent() <= next)
            {
                node->Run();
            }
        }
        faults_->LookAtSupply();
        for (Participant* const participant : participants_)
        {
            if (participant->NextEvent() <= next)
            {
                participant->Run(next);
            }
        }
    }
    world_.bus.Advance(until, observer);
}

void Network::OnBusRecord(const host::BusRecord& record)
{
    const BusPlace& sender = world_.places[record.sent.sender];
    world_.journal.Tell(FrameEntry{record.sent.start, record.end, record.sent.frame, sender.node, record.fate});
}

const std::map<std::size_t, std::uint32_t>& Network::DroppedCopies() const noexcept
{
    return faults_->Dropped();
}
} // namespace counterpoint::simulator
