// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/manager/manager.hpp"

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
      watch_(parts_.setup, parts.room.watched, *this), own_(parts_.setup.own, parts_.sink, parts.heartbeat_ms),
      permissions_(parts_.setup, parts.room.gates, gate_, table_),
      role_(RoleParts{parts_.setup, table_, nmt_, own_, parts_.listener})
{
}

StartUpParts Manager::ProfileParts() noexcept
{
    return StartUpParts{parts_.setup, table_, nmt_, sdo_, gate_, parts_.sink, parts_.listener};
}

void Manager::Use(StartUp& profile) noexcept
{
    role_.Use(profile);
    gate_.Use(profile.Identity());
}

void Manager::Begin(const Instant now) noexcept
{
    role_.Begin(now);
}

void Manager::End() noexcept
{
    role_.End();
}

void Manager::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    if (role_.IsRunning())
    {
        role_.OnFrame(frame, now);
        OnCommandFrame(frame, now);
        CountHeartbeats(frame);
        watch_.OnFrame(frame, now);
        table_.OnFrame(frame, now);
        permissions_.OnFrame(frame, role_.Leading(), now);
        SendWaiting(now);
        sdo_.OnFrame(frame, now);
        role_.Profile()->OnFrame(frame, now);
    }
}

/// A slave that was not started up since it booted sends heartbeats by a time of its own. [SRS_MGR_010]
void Manager::CountHeartbeats(const CanFrame& frame) noexcept
{
    constexpr std::uint32_t kErrorControl = 0x700U;
    const NodeId node{static_cast<std::uint8_t>(frame.identifier & kLastNode)};
    const bool is_sign = ((frame.identifier & ~std::uint32_t{kLastNode}) == kErrorControl) && (node.value != 0U);
    if (is_sign && parts_.setup.IsListed(node))
    {
        const NodeStatus status = Status(node);
        const bool is_set_up = status.is_started || (table_.Record(node).watch != Watch::kNone);
        if (!is_set_up || status.is_other)
        {
            watch_.CountAnew(node);
        }
    }
}

/// What waits for room in the sink has the first place that is free: who sends requests and remote frames would take
/// each one. [SRS_NMM_230] [SRS_MGR_231] [SRS_ELM_230]
void Manager::SendWaiting(const Instant now) noexcept
{
    if (nmt_.Waiting() > 0U)
    {
        nmt_.OnCycle(now);
    }
    if (own_.IsWaiting())
    {
        own_.Send(role_.IsInitialising(), now);
    }
    if (StartUp* const profile = role_.Leading())
    {
        profile->OnRoom(now);
    }
    parts_.listener.OnRoom(now);
}

void Manager::OnCycle(const Instant now) noexcept
{
    if (role_.IsRunning())
    {
        role_.OnCycle(now);
        SendWaiting(now);
        own_.Send(role_.IsInitialising(), now);
        watch_.OnCycle(now);
        table_.OnCycle(now);
        sdo_.OnCycle(now);
        gate_.OnCycle(now);
        permissions_.Tell(parts_.listener, now);
        role_.Profile()->OnCycle(now);
        nmt_.OnCycle(now);
    }
}

bool Manager::WriteSafety(const NodeId node, const Instant now) noexcept
{
    const NodeStatus status = Status(node);
    const bool is_running = (table_.RequestValue(node) == static_cast<std::uint8_t>(SlaveState::kOperational)) &&
                            !cia302::HasLeft(table_, node);
    const bool is_free = IsActive() && !is_running && !status.is_other && !status.is_busy && (nmt_.Waiting() == 0U) &&
                         (gate_.State(node) != GateState::kBusy);
    if (is_free && (table_.Record(node).asked == SlaveState::kStopped))
    {
        // STOPPED, it has no SDO to be written by. Where the command has to wait, the next call goes on.
        static_cast<void>(nmt_.Request(NmtCommand::kPreOperational, node, now));
    }
    return is_free && (nmt_.Waiting() == 0U) && gate_.Write(node, now);
}

void Manager::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_boot_up = (event == NodeEvent::kBootUp);
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    if (is_boot_up)
    {
        sdo_.OnBootUp(node);
    }
    if (is_boot_up || is_lost || (event == NodeEvent::kToggleError))
    {
        permissions_.Close(node);
    }
    parts_.listener.OnNodeEvent(node, event, now);
    if (is_lost)
    {
        role_.OnHeartbeatLost(node, now);
    }
    if (StartUp* const profile = role_.Leading())
    {
        profile->OnNodeEvent(node, event, now);
    }
}

void Manager::OnEmergency(const NodeId node, const EmergencyRecord& emergency, const Instant now) noexcept
{
    parts_.listener.OnEmergency(node, emergency, now);
}

/// What a device says that may be two is worth nothing. [SRS_MGR_225, SRS_MGR_226]
void Manager::OnDuplicate(const NodeId node, const Instant now) noexcept
{
    gate_.Doubt(node);
    parts_.listener.OnDuplicate(node, now);
}

NodeState Manager::OwnState() const noexcept
{
    return role_.IsInitialising() ? NodeState::kInitialising : own_.State();
}

NodeStatus Manager::Status(const NodeId node) const noexcept
{
    return (role_.Profile() != nullptr) ? role_.Profile()->Status(node) : NodeStatus{};
}

std::int16_t Manager::MasterState() const noexcept
{
    return (role_.Profile() != nullptr) ? role_.Profile()->MasterState() : std::int16_t{0};
}

/// Commands of the active master to this device while it is not the master itself. A master is not commanded by
/// others: they show themselves by 071h.
void Manager::OnCommandFrame(const CanFrame& frame, const Instant now) noexcept
{
    constexpr std::uint8_t kCommandBytes = 2U;
    const bool is_command =
        (frame.kind == FrameKind::kData) && (frame.identifier == 0U) && (frame.length_bytes == kCommandBytes);
    if (is_command)
    {
        const auto command = static_cast<NmtCommand>(frame.data[0]);
        const NodeId node{frame.data[1]};
        const bool is_for_us = (node.value == kAllNodes.value) || (node.value == parts_.setup.own.value);
        const StartUp* const profile = role_.Leading();
        OnCommand(command, node);
        if ((profile != nullptr) && (command == NmtCommand::kStart))
        {
            permissions_.OnForeignStart(node, *profile, now);
        }
        if (is_for_us && (role_.Flying() != nullptr) && (profile == nullptr))
        {
            own_.Obey(command);
        }
    }
}

/// [SRS_SFS_152]
void Manager::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    if (StartUp* const profile = role_.Leading())
    {
        permissions_.OnStartDropped(node);
        profile->OnStartDropped(node, now);
    }
}

void Manager::OnNmtSent(const NmtRequest& request, const Instant now) noexcept
{
    const bool is_own = (request.node.value == parts_.setup.own.value);
    OnCommand(request.command, request.node);
    if (is_own || (request.node.value == kAllNodes.value))
    {
        own_.Obey(request.command);
    }
    if (is_own && IsReset(request.command) && (request.node.value != kAllNodes.value))
    {
        role_.OnOwnReset();
    }
    parts_.listener.OnNmtSent(request, now);
}

/// What a command, of whomever, makes of what is known of its nodes.
void Manager::OnCommand(const NmtCommand command, const NodeId node) noexcept
{
    if (IsReset(command))
    {
        permissions_.OnReset(node);
        watch_.OnReset(node);
    }
    if (IsLeave(command))
    {
        permissions_.OnLeave(node);
    }
}

void Manager::OnLost(const Instant now) noexcept
{
    watch_.OnLost();
    permissions_.OnLost(role_.Leading(), now);
}

void Manager::OnBus(const bool is_there, const Instant now) noexcept
{
    const bool is_back = is_there && !role_.IsOnBus();
    StartUp* const profile = role_.Leading();
    role_.OnBus(is_there, now);
    if (is_back)
    {
        OnLost(now);
    }
    if (is_back && (profile != nullptr))
    {
        profile->OnBusBack(now);
    }
}

} // namespace counterpoint::cia302
