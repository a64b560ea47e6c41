// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/network.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
host::BitRate RateOf(const Scenario& scenario)
{
    return host::BitRateFrom(scenario.bitrate).value_or(host::BitRate::k500k);
}

/// Whether anybody wants to know what goes on inside the nodes.
Insight InsightOf(const Scenario& scenario, const Journal& journal)
{
    const bool is_wanted =
        journal.KeepsAll() || !scenario.faults.empty() ||
        std::any_of(scenario.expectations.begin(), scenario.expectations.end(),
                    [](const Expectation& expectation) { return expectation.kind == ExpectationKind::kDetectedBy; });
    return is_wanted ? Insight::kTapped : Insight::kNone;
}
} // namespace

Network::Network(const Scenario& scenario, Journal& journal)
    : scenario_(scenario), journal_(journal), bus_(RateOf(scenario))
{
    BuildNodes();
    RequireThatEverythingExists();
    BuildLinks();
    for (const runtime::LogicRule& rule : scenario_.logic)
    {
        nodes_[rule.node]->App().AddRule(rule);
    }
    BuildForeignControllers();
    InstallFaults();
    // What the DCFs make impossible is found now and not in the middle of the run.
    for (const std::unique_ptr<Node>& node : nodes_)
    {
        node->Rehearse();
    }
    PlanWorld();
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        PlanFault(index);
    }
    std::stable_sort(actions_.begin(), actions_.end(),
                     [](const Action& left, const Action& right) { return left.at < right.at; });
}

void Network::BuildNodes()
{
    const Insight insight = InsightOf(scenario_, journal_);
    for (NodeIndex index = 0U; index < scenario_.nodes.size(); ++index)
    {
        const NodeSetup& setup = scenario_.nodes[index];
        models_.push_back(std::make_unique<runtime::DeviceModel>(setup.dcf, setup.node_id));
        if (setup.controllers > 1U)
        {
            models_.back()->UseTwoControllers();
        }
        nodes_.push_back(std::make_unique<Node>(index, setup, *models_.back(), bus_, journal_, insight));
        std::uint32_t controller = 0U;
        for (const host::NodeIndex place : nodes_.back()->BusNodes())
        {
            ++controller;
            places_.resize(place + 1U);
            places_[place] = {index, controller, kNoFaultIndex};
        }
    }
}

void Network::BuildLinks()
{
    for (NodeIndex index = 0U; index < nodes_.size(); ++index)
    {
        if (scenario_.nodes[index].role == runtime::CpuRole::kA)
        {
            LinkWire& wire =
                *wires_.emplace(index, std::make_unique<LinkWire>(scenario_, index, journal_)).first->second;
            nodes_[index]->Join(wire);
            nodes_[index + 1U]->Join(wire);
        }
    }
}

void Network::DeliverMessages()
{
    for (const auto& [first, wire] : wires_)
    {
        while (const std::optional<LinkArrival> arrival = wire->Take(Now()))
        {
            nodes_[arrival->receiver]->TakeMessage(arrival->frame);
        }
    }
}

// A fault that sends frames of its own does it by a controller of its own.
void Network::BuildForeignControllers()
{
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultKind kind = scenario_.faults[index].kind;
        if (kind == FaultKind::kDuplicate || kind == FaultKind::kBabbling)
        {
            foreign_[index] = std::make_unique<ForeignController>(bus_);
            places_.push_back({kNoNode, 1U, index});
        }
    }
}

std::vector<FrameSelector> Network::SelectorsOf(bool (*const is_wanted)(FaultKind)) const
{
    std::vector<FrameSelector> selectors;
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultSetup& fault = scenario_.faults[index];
        if (!is_wanted(fault.kind))
        {
            continue;
        }
        std::vector<std::uint32_t> identifiers = fault.frames.identifiers;
        for (const runtime::SrdoModel& srdo : models_[fault.frames.srdo_of.value_or(0U)]->Srdos())
        {
            const bool is_it = fault.frames.srdo_of && srdo.number == fault.frames.srdo;
            if (is_it && fault.frames.has_normal)
            {
                identifiers.push_back(srdo.cob_id_1);
            }
            if (is_it && fault.frames.has_inverse)
            {
                identifiers.push_back(srdo.cob_id_2);
            }
        }
        selectors.emplace_back(fault, index, std::move(identifiers));
    }
    return selectors;
}

void Network::InstallFaults()
{
    const FaultStage stage{scenario_, bus_, places_, journal_};
    const bool has_masquerade =
        std::any_of(scenario_.faults.begin(), scenario_.faults.end(),
                    [](const FaultSetup& fault) { return fault.kind == FaultKind::kMasquerade; });
    std::vector<FrameSelector> on_receptions = SelectorsOf(&ActsOnReceptions);
    if (!on_receptions.empty() || has_masquerade || !foreign_.empty())
    {
        frame_faults_ = std::make_unique<FrameFaults>(stage, std::move(on_receptions));
        bus_.Install(*frame_faults_);
    }
    std::vector<FrameSelector> in_controllers = SelectorsOf(&ActsInControllers);
    if (!in_controllers.empty())
    {
        controller_faults_ = std::make_unique<ControllerFaults>(stage, std::move(in_controllers));
        bus_.Install(*controller_faults_);
    }
}

void Network::Plan(const Nanoseconds at, std::function<void()> act)
{
    actions_.push_back({at, std::move(act)});
}

void Network::PlanWorld()
{
    for (NodeIndex index = 0U; index < nodes_.size(); ++index)
    {
        Plan(scenario_.nodes[index].start_at, [this, index]() { nodes_[index]->SetNmt(NmtState::kOperational); });
    }
    for (const Stimulus& stimulus : scenario_.stimuli)
    {
        Plan(stimulus.at,
             [this, &stimulus]()
             {
                 const std::uint64_t object = (std::uint64_t{stimulus.object.index} << 8U) | stimulus.object.sub;
                 nodes_[stimulus.node]->App().SetInput(stimulus.object, stimulus.value);
                 journal_.Tell({Now(), EventKind::kInput, stimulus.node, 0U, stimulus.value, object});
             });
    }
    for (const Acknowledge& acknowledge : scenario_.acknowledges)
    {
        Plan(acknowledge.at,
             [this, &acknowledge]() { nodes_[acknowledge.node]->SetAcknowledge(acknowledge.srdo, true); });
        Plan(acknowledge.at + acknowledge.pulse,
             [this, &acknowledge]() { nodes_[acknowledge.node]->SetAcknowledge(acknowledge.srdo, false); });
    }
    PlanNmt();
    for (const GfcEvent& event : scenario_.gfc)
    {
        Plan(event.at, [this, &event]() { nodes_[event.node]->SendGfc(); });
    }
}

void Network::PlanNmt()
{
    for (const NmtEvent& event : scenario_.nmt)
    {
        for (NodeIndex index = 0U; index < nodes_.size(); ++index)
        {
            if (event.node != kNoNode && event.node != index)
            {
                continue;
            }
            Plan(event.at, [this, &event, index]() { Command(index, event); });
            if (event.start_after != kNever)
            {
                Plan(event.at + event.start_after, [this, index]() { nodes_[index]->SetNmt(NmtState::kOperational); });
            }
        }
    }
    for (const PowerCycle& cycle : scenario_.power)
    {
        Plan(cycle.at, [this, &cycle]() { nodes_[cycle.node]->PowerOff(); });
        Plan(cycle.at + cycle.off, [this, &cycle]() { nodes_[cycle.node]->PowerOn(); });
        if (cycle.start_after != kNever)
        {
            Plan(cycle.at + cycle.off + cycle.start_after,
                 [this, &cycle]() { nodes_[cycle.node]->SetNmt(NmtState::kOperational); });
        }
    }
}

void Network::Command(const NodeIndex node, const NmtEvent& event)
{
    switch (event.command)
    {
    case NmtCommand::kNone:
        nodes_[node]->SetNmt(event.state);
        return;
    case NmtCommand::kStart:
        nodes_[node]->SetNmt(NmtState::kOperational);
        return;
    case NmtCommand::kStop:
        nodes_[node]->SetNmt(NmtState::kStopped);
        return;
    case NmtCommand::kEnterPreOperational:
        nodes_[node]->SetNmt(NmtState::kPreOperational);
        return;
    case NmtCommand::kResetNode:
        nodes_[node]->ResetNode();
        return;
    case NmtCommand::kResetCommunication:
        nodes_[node]->ResetCommunication();
        return;
    }
}

// t = the next instant of bus, world, links and nodes; first the bus up to t, then the world, then messages between
// CPUs, then the nodes in their order.
void Network::RunUntil(const Nanoseconds until)
{
    host::BusObserver* const observer = journal_.KeepsAll() ? this : nullptr;
    while (true)
    {
        Nanoseconds next = (next_action_ < actions_.size()) ? actions_[next_action_].at : kNever;
        for (const std::unique_ptr<Node>& node : nodes_)
        {
            next = std::min(next, node->NextEvent());
        }
        for (const auto& [first, wire] : wires_)
        {
            next = std::min(next, wire->NextArrival());
        }
        if (next > until)
        {
            break;
        }
        bus_.Advance(next, observer);
        RunActions();
        DeliverMessages();
        for (const std::unique_ptr<Node>& node : nodes_)
        {
            if (node->NextEvent() <= next)
            {
                node->Run();
                ++cycles_;
            }
        }
    }
    bus_.Advance(until, observer);
}

void Network::RunActions()
{
    while (next_action_ < actions_.size() && actions_[next_action_].at <= Now())
    {
        actions_[next_action_].act();
        ++next_action_;
    }
}

void Network::OnBusRecord(const host::BusRecord& record)
{
    const BusPlace& sender = places_[record.sent.sender];
    journal_.Tell(FrameEntry{record.sent.start, record.end, record.sent.frame, sender.node, record.fate});
}

Nanoseconds Network::Now() const noexcept
{
    return bus_.Now();
}

Node& Network::At(const NodeIndex node)
{
    return *nodes_.at(node);
}

std::size_t Network::Size() const noexcept
{
    return nodes_.size();
}

host::VirtualBus& Network::Bus() noexcept
{
    return bus_;
}

const std::map<std::size_t, std::uint32_t>& Network::DroppedCopies() const noexcept
{
    static const std::map<std::size_t, std::uint32_t> kNone;
    return (frame_faults_ == nullptr) ? kNone : frame_faults_->Dropped();
}

std::uint64_t Network::CycleCount() const noexcept
{
    return cycles_;
}
} // namespace counterpoint::simulator
