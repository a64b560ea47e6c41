// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/network.hpp"

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
    : scenario_(scenario), journal_(journal), bus_(RateOf(scenario)), frame_faults_(scenario, bus_, journal)
{
    BuildNodes();
    RequireThatEverythingExists();
    for (const LogicRule& rule : scenario_.logic)
    {
        nodes_[rule.node]->App().AddRule(rule);
    }
    if (!frame_faults_.IsEmpty())
    {
        bus_.Install(frame_faults_);
    }
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
        models_.push_back(std::make_unique<DeviceModel>(setup.dcf, setup.node_id));
        nodes_.push_back(std::make_unique<Node>(index, setup, *models_.back(), bus_, journal_, insight));
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
    for (const NmtEvent& event : scenario_.nmt)
    {
        for (NodeIndex index = 0U; index < nodes_.size(); ++index)
        {
            if (event.node == kNoNode || event.node == index)
            {
                Plan(event.at, [this, &event, index]() { nodes_[index]->SetNmt(event.state); });
            }
        }
    }
    for (const GfcEvent& event : scenario_.gfc)
    {
        Plan(event.at, [this, &event]() { nodes_[event.node]->SendGfc(); });
    }
}

// t = the next instant of bus, world and nodes; first the bus up to t, then the world, then the nodes in their order.
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
        if (next > until)
        {
            break;
        }
        bus_.Advance(next, observer);
        RunActions();
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
    journal_.Tell(FrameEntry{record.sent.start, record.end, record.sent.frame, record.sent.sender, record.fate});
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

std::uint64_t Network::CycleCount() const noexcept
{
    return cycles_;
}
} // namespace counterpoint::simulator
