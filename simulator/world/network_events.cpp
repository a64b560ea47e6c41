// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/network_events.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
NetworkEvents::NetworkEvents(World& world, Agenda& agenda) : world_(world), scenario_(world.scenario), agenda_(agenda)
{
}

void NetworkEvents::PlanAll()
{
    for (NodeIndex index = 0U; index < scenario_.nodes.size(); ++index)
    {
        agenda_.Plan(scenario_.nodes[index].start_at, [this, index]() { Start(index); });
    }
    for (const Stimulus& stimulus : scenario_.stimuli)
    {
        agenda_.Plan(
            stimulus.at,
            [this, &stimulus]()
            {
                const std::uint64_t object = (std::uint64_t{stimulus.object.index} << 8U) | stimulus.object.sub;
                world_.nodes[stimulus.node]->App().SetInput(stimulus.object, stimulus.value);
                world_.journal.Tell({world_.Now(), EventKind::kInput, stimulus.node, 0U, stimulus.value, object});
            });
    }
    for (const Acknowledge& acknowledge : scenario_.acknowledges)
    {
        agenda_.Plan(acknowledge.at, [this, &acknowledge]()
                     { world_.nodes[acknowledge.node]->App().SetAcknowledge(acknowledge.srdo, true); });
        agenda_.Plan(acknowledge.at + acknowledge.pulse, [this, &acknowledge]()
                     { world_.nodes[acknowledge.node]->App().SetAcknowledge(acknowledge.srdo, false); });
    }
    PlanNmt();
    PlanActions();
    for (const GfcEvent& event : scenario_.gfc)
    {
        agenda_.Plan(event.at, [this, &event]() { world_.nodes[event.node]->Firmware().SendGfc(); });
    }
}

void NetworkEvents::PlanNmt()
{
    for (const NmtEvent& event : scenario_.nmt)
    {
        for (NodeIndex index = 0U; index < scenario_.nodes.size(); ++index)
        {
            if (event.node != kNoNode && event.node != index)
            {
                continue;
            }
            agenda_.Plan(event.at, [this, &event, index]() { Command(index, event); });
            if (event.start_after != kNever)
            {
                agenda_.Plan(event.at + event.start_after, [this, index]() { Start(index); });
            }
        }
    }
    for (const PowerCycle& cycle : scenario_.power)
    {
        agenda_.Plan(cycle.at,
                     [this, &cycle]()
                     {
                         NoteCommand(cycle.node, true);
                         world_.nodes[cycle.node]->PowerOff();
                     });
        agenda_.Plan(cycle.at + cycle.off, [this, &cycle]() { world_.nodes[cycle.node]->PowerOn(); });
        if (cycle.start_after != kNever)
        {
            agenda_.Plan(cycle.at + cycle.off + cycle.start_after, [this, &cycle]() { Start(cycle.node); });
        }
    }
}

void NetworkEvents::NoteCommand(const NodeIndex node, const bool closes)
{
    world_.journal.Note(CommandEntry{world_.Now(), node, closes});
}

void NetworkEvents::Start(const NodeIndex node)
{
    NoteCommand(node, false);
    world_.nodes[node]->SetNmt(NmtState::kOperational);
}

void NetworkEvents::Command(const NodeIndex node, const NmtEvent& event)
{
    NoteCommand(node, event.command != cia301::NmtCommand::kStart && event.state != NmtState::kOperational);
    Node& device = *world_.nodes[node];
    switch (event.command)
    {
    case cia301::NmtCommand::kInvalid:
        return device.SetNmt(event.state);
    case cia301::NmtCommand::kStart:
        return device.SetNmt(NmtState::kOperational);
    case cia301::NmtCommand::kStop:
        return device.SetNmt(NmtState::kStopped);
    case cia301::NmtCommand::kPreOperational:
        return device.SetNmt(NmtState::kPreOperational);
    case cia301::NmtCommand::kResetNode:
        return device.ResetNode();
    case cia301::NmtCommand::kResetCommunication:
        return device.ResetCommunication();
    }
}

// Those of managers are theirs.
void NetworkEvents::PlanActions()
{
    constexpr Nanoseconds kPress = 200 * kNanosecondsPerMillisecond;
    NodeIndex duplicate = scenario_.nodes.size();
    for (const Action& action : scenario_.actions)
    {
        if (!IsOfDevice(action.kind))
        {
            continue;
        }
        if (action.kind == ActionKind::kDuplicate)
        {
            agenda_.Plan(action.at, [this, duplicate]() { world_.nodes[duplicate]->PowerOn(); });
            ++duplicate;
            continue;
        }
        agenda_.Plan(action.at, [this, &action]() { Act(action, world_.Present(action.node)); });
        if (action.kind == ActionKind::kAcknowledge)
        {
            agenda_.Plan(action.at + kPress,
                         [this, &action]() { world_.nodes[action.node]->App().SetAcknowledge(action.srdo, false); });
        }
    }
}

/// Whatever happens to a device but a store and an acknowledge is its supply: all that is not in its file is new.
/// [SRS_SIM_211, SRS_SIM_212]
void NetworkEvents::Act(const Action& action, Node& node)
{
    switch (action.kind)
    {
    case ActionKind::kAcknowledge:
        node.App().SetAcknowledge(action.srdo, true);
        return;
    case ActionKind::kStore:
        node.Firmware().Store(action.object, action.value);
        return;
    case ActionKind::kPull:
        PullAll(action.node);
        return;
    case ActionKind::kReplace:
        node.Firmware().SetSerial(action.serial);
        break;
    default:
        break;
    }
    if (action.kind != ActionKind::kInsert)
    {
        PullAll(action.node);
    }
    node.PowerOn();
}

/// Also a second one with its node-ID.
void NetworkEvents::PullAll(const NodeIndex index)
{
    for (const std::unique_ptr<Node>& node : world_.nodes)
    {
        if (node->Index() == index && node->HasSupply())
        {
            NoteCommand(index, true);
            node->PowerOff();
        }
    }
}
} // namespace counterpoint::simulator
