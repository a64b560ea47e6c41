// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/manager.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::NodeState;

bool IsReset(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication);
}

/// Takes a node out of OPERATIONAL without a reset.
bool IsLeave(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kStop) || (command == NmtCommand::kPreOperational);
}

} // namespace

Manager::Manager(const ManagerParts& parts) noexcept
    : parts_(parts), sdo_(parts.room.lanes, parts.room.times),
      table_(NodeTableParts{parts.room.records, parts_.setup, parts_.sink, *this}),
      gate_(parts_.setup, parts.room.safety, sdo_),
      nmt_(NmtMasterParts{parts_.setup, parts.room.commands, parts_.sink, table_, *this, gate_}),
      watch_(parts_.setup, parts.room.watched, *this), producer_(parts_.setup.own), profile_(nullptr), flying_(nullptr),
      negotiation_(NegotiationBy::kManager), state_(NodeState::kInitialising), is_running_(false), is_leading_(false),
      owes_boot_up_(false), is_to_start_(false), is_refused_(false), is_off_bus_(false), is_to_reset_(false)
{
    producer_.SetPeriod(parts.heartbeat_ms);
}

StartUpParts Manager::ProfileParts() noexcept
{
    return StartUpParts{parts_.setup, table_, nmt_, sdo_, gate_, parts_.sink, *this};
}

void Manager::Use(StartUp& profile) noexcept
{
    profile_ = &profile;
}

void Manager::Use(FlyingMaster& flying, const NegotiationBy by) noexcept
{
    flying_ = &flying;
    negotiation_ = by;
}

void Manager::Begin(const Instant now) noexcept
{
    is_running_ = (profile_ != nullptr);
    if (is_running_)
    {
        state_ = NodeState::kPreOperational;
        owes_boot_up_ = true;
        is_to_start_ = (flying_ != nullptr) && (negotiation_ == NegotiationBy::kManager);
        SendOwn(now);
        if (flying_ == nullptr)
        {
            Lead(true, now);
        }
        else
        {
            parts_.listener.OnInitialising(now);
        }
    }
}

void Manager::End() noexcept
{
    if (is_running_)
    {
        profile_->End();
        nmt_.SetActive(false);
    }
    is_leading_ = false;
    is_running_ = false;
}

/// Without a flying master it leads from the beginning; with one the negotiation says so. [SRS-MGR-002]
void Manager::Lead(const bool is_leader, const Instant now) noexcept
{
    if (is_leader && !is_leading_)
    {
        is_leading_ = true;
        nmt_.SetActive(true);
        profile_->Begin(now);
    }
    else if (!is_leader && is_leading_)
    {
        is_leading_ = false;
        profile_->End();
        nmt_.SetActive(false);
        UnwatchAll();
    }
    else
    {
        // As before.
    }
}

/// Nobody but the active master guards, and what was watched in another role counts no more.
void Manager::UnwatchAll() noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        table_.Unwatch(NodeId{id});
    }
}

void Manager::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    if (is_running_)
    {
        if (flying_ != nullptr)
        {
            flying_->OnFrame(frame, now);
            FollowRole(now);
        }
        OnCommandFrame(frame);
        watch_.OnFrame(frame, now);
        table_.OnFrame(frame, now);
        sdo_.OnFrame(frame, now);
        profile_->OnFrame(frame, now);
    }
}

void Manager::OnCycle(const Instant now) noexcept
{
    if (is_running_)
    {
        ResetRole(now);
        if (is_to_start_ && !is_off_bus_)
        {
            TryNegotiation(now);
        }
        if (flying_ != nullptr)
        {
            flying_->OnCycle(now);
            FollowRole(now);
        }
        SendOwn(now);
        table_.OnCycle(now);
        sdo_.OnCycle(now);
        gate_.OnCycle(now);
        TellGates(now);
        profile_->OnCycle(now);
        nmt_.OnCycle(now);
    }
}

/// Commands of the active master to this device while it is not the master itself. A master is not commanded by
/// others: they show themselves by 071h.
void Manager::OnCommandFrame(const CanFrame& frame) noexcept
{
    constexpr std::uint8_t kCommandBytes = 2U;
    const bool is_command =
        (frame.kind == FrameKind::kData) && (frame.identifier == 0U) && (frame.length_bytes == kCommandBytes);
    const bool is_for_us =
        is_command && ((frame.data[1] == kAllNodes.value) || (frame.data[1] == parts_.setup.own.value));
    if (is_command && IsReset(static_cast<NmtCommand>(frame.data[0])))
    {
        OnReset(NodeId{frame.data[1]});
    }
    if (is_command && IsLeave(static_cast<NmtCommand>(frame.data[0])))
    {
        OnLeave(NodeId{frame.data[1]});
    }
    if (is_for_us && (flying_ != nullptr) && !is_leading_)
    {
        Obey(static_cast<NmtCommand>(frame.data[0]));
    }
}

void Manager::Obey(const NmtCommand command) noexcept
{
    switch (command)
    {
    case NmtCommand::kStart:
        state_ = NodeState::kOperational;
        break;
    case NmtCommand::kStop:
        state_ = NodeState::kStopped;
        break;
    case NmtCommand::kPreOperational:
        state_ = NodeState::kPreOperational;
        break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication:
        state_ = NodeState::kPreOperational;
        owes_boot_up_ = true;
        break;
    case NmtCommand::kInvalid:
    default:
        break;
    }
}

bool Manager::IsInitialising() const noexcept
{
    return (flying_ != nullptr) && flying_->IsInitialising();
}

/// Boot-up message and heartbeat of this device. What the sink does not take comes in a later cycle.
void Manager::SendOwn(const Instant now) noexcept
{
    if (!IsInitialising() && owes_boot_up_)
    {
        owes_boot_up_ = !parts_.sink.Send(cia301::ErrorControlFrame(parts_.setup.own, 0U));
    }
    else if (!IsInitialising())
    {
        const cia301::FrameToSend heartbeat = producer_.Poll(state_, now);
        if (heartbeat.is_present)
        {
            static_cast<void>(parts_.sink.Send(heartbeat.frame)); // The next one is as good.
        }
    }
    else
    {
        // Nobody is to take this device for one that is there. Whoever leaves INITIALISATION says so. [SRS-FLY-028]
        state_ = NodeState::kPreOperational;
        owes_boot_up_ = true;
    }
}

NmtAnswer Manager::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    return is_leading_ ? profile_->Command(command, node, now) : NmtAnswer::kNotActive;
}

bool Manager::Boot(const NodeId node, const Instant now) noexcept
{
    return is_leading_ && profile_->Boot(node, now);
}

bool Manager::WriteSafety(const NodeId node, const Instant now) noexcept
{
    const bool is_running = table_.RequestValue(node) == static_cast<std::uint8_t>(SlaveState::kOperational);
    const bool is_free = is_leading_ && !is_running && (nmt_.Waiting() == 0U) &&
                         (gate_.State(node) != GateState::kBusy) && !profile_->Status(node).is_busy;
    if (is_free && (table_.Record(node).asked == SlaveState::kStopped))
    {
        // STOPPED, it has no SDO to be written by. Where the command has to wait, the next call goes on.
        static_cast<void>(nmt_.Request(NmtCommand::kPreOperational, node, now));
    }
    return is_free && (nmt_.Waiting() == 0U) && gate_.Write(node, now);
}

void Manager::TellGates(const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        if (parts_.setup.IsSafetySlave(node) && (gate_.State(node) != parts_.room.gates[id]))
        {
            parts_.room.gates[id] = gate_.State(node);
            parts_.listener.OnGate(node, parts_.room.gates[id], now);
        }
    }
}

/// A reset ends what was verified, at once and not when the slave comes back, and what was suspected: whoever sent it.
/// [SRS-SFS-002]
void Manager::OnReset(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        if ((node.value == kAllNodes.value) || (node.value == id))
        {
            CloseGate(NodeId{id});
            gate_.Trust(NodeId{id});
            watch_.Forget(NodeId{id});
        }
    }
}

/// Out of OPERATIONAL it can be changed, and be back there before it says so. What was found before stays to be told.
/// [SRS-SFS-002]
void Manager::OnLeave(const NodeId node) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const GateState gate = gate_.State(NodeId{id});
        const bool is_hit = (node.value == kAllNodes.value) || (node.value == id);
        if (is_hit && ((gate == GateState::kOpen) || (gate == GateState::kBusy)))
        {
            CloseGate(NodeId{id});
        }
    }
}

void Manager::OnNmtSent(const NmtRequest& request, const Instant now) noexcept
{
    const bool is_all = (request.node.value == kAllNodes.value);
    if (IsReset(request.command))
    {
        OnReset(request.node);
    }
    if (IsLeave(request.command))
    {
        OnLeave(request.node);
    }
    if (is_all || (request.node.value == parts_.setup.own.value))
    {
        Obey(request.command);
    }
    // Not here: the queue of commands is being worked through.
    is_to_reset_ =
        is_to_reset_ || (!is_all && IsReset(request.command) && (request.node.value == parts_.setup.own.value));
    parts_.listener.OnNmtSent(request, now);
}

void Manager::CloseGate(const NodeId node) noexcept
{
    if (parts_.setup.IsSafetySlave(node))
    {
        gate_.Close(node);
    }
}

void Manager::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_boot_up = (event == NodeEvent::kBootUp);
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    if (is_boot_up)
    {
        sdo_.OnBootUp(node);
    }
    if (is_boot_up || is_lost)
    {
        CloseGate(node);
    }
    parts_.listener.OnNodeEvent(node, event, now);
    if ((flying_ != nullptr) && is_lost)
    {
        flying_->OnHeartbeatLost(node, now);
    }
    if (is_leading_)
    {
        profile_->OnNodeEvent(node, event, now);
    }
}

void Manager::OnNodeStatus(const NodeId node, const Instant now) noexcept
{
    parts_.listener.OnNodeStatus(node, now);
}

void Manager::OnMasterState(const std::int16_t state, const Instant now) noexcept
{
    parts_.listener.OnMasterState(state, now);
}

void Manager::OnEmergency(const NodeId node, const EmergencyRecord& emergency, const Instant now) noexcept
{
    parts_.listener.OnEmergency(node, emergency, now);
}

/// What a device says that may be two is worth nothing. [SRS-MGR-010]
void Manager::OnDuplicate(const NodeId node, const Instant now) noexcept
{
    gate_.Doubt(node);
    parts_.listener.OnDuplicate(node, now);
}

NodeState Manager::OwnState() const noexcept
{
    return IsInitialising() ? NodeState::kInitialising : state_;
}

NodeStatus Manager::Status(const NodeId node) const noexcept
{
    return (profile_ != nullptr) ? profile_->Status(node) : NodeStatus{};
}

std::int16_t Manager::MasterState() const noexcept
{
    return (profile_ != nullptr) ? profile_->MasterState() : std::int16_t{0};
}

} // namespace counterpoint::cia302
