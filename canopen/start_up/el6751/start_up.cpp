// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Course of the whole network. SDOs and start of a slave, its supervision, and commands are in files of their own.
#include "canopen/start_up/el6751/start_up.hpp"

namespace counterpoint::cia302
{

El6751StartUp::El6751StartUp(const El6751Parts& parts) noexcept
    : parts_(parts), pdos_(El6751PdoParts{parts.common.setup, parts.common.sink, parts.pdos, parts.times}),
      controller_(ControllerState::kRunning), master_(kEl6751Ended), is_active_(false), is_usable_(true),
      is_reset_due_(false), has_started_all_(false)
{
}

void El6751StartUp::Begin(const Instant now) noexcept
{
    is_active_ = true;
    has_started_all_ = false;
    is_usable_ = pdos_.Begin();
    is_reset_due_ = is_usable_ && (controller_ == ControllerState::kRunning);
    const std::int16_t lost = (controller_ == ControllerState::kBusOff) ? kNodeBusOff : kNodeBusFault;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        if (parts_.common.setup.IsListed(node))
        {
            const NodeStatus before = Of(node).status;
            Of(node) = El6751Node{};
            Of(node).status.code = before.code;
            BeginRows(node, is_reset_due_ ? kNodeStarts : lost, now);
        }
        else
        {
            Of(node) = El6751Node{};
        }
    }
    SendReset(now);
    TellMaster(now);
}

/// The one reset of all slaves. [SRS_ELM_001]
void El6751StartUp::SendReset(const Instant now) noexcept
{
    if (is_reset_due_)
    {
        const NmtAnswer answer = parts_.common.nmt.Request(NmtCommand::kResetCommunication, kAllNodes, now);
        is_reset_due_ = (answer != NmtAnswer::kTaken);
    }
}

void El6751StartUp::End() noexcept
{
    is_active_ = false;
    pdos_.End();
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.common.sdo.Cancel(NodeId{id}, SdoAbort::kGeneral);
        Of(NodeId{id}) = El6751Node{};
    }
}

El6751Node& El6751StartUp::Of(const NodeId node) const noexcept
{
    return parts_.nodes[node.value & kLastNode];
}

const El6751Slave& El6751StartUp::SetupOf(const NodeId node) const noexcept
{
    return El6751SlaveOf(parts_.common.setup, node);
}

El6751Context El6751StartUp::Context(const NodeId node) const noexcept
{
    return El6751Context{parts_.common.setup, node, pdos_.IsSyncSent()};
}

bool El6751StartUp::IsSafety(const NodeId node) const noexcept
{
    return parts_.common.setup.IsSafetySlave(node);
}

void El6751StartUp::Tell(const NodeId node, const std::int16_t code, const StartUpStep step, const Instant now) noexcept
{
    NodeStatus& status = Of(node).status;
    const bool has_changed = (status.code != code) || (status.step != step);
    status.code = code;
    status.step = step;
    if (has_changed)
    {
        parts_.common.listener.OnNodeStatus(node, now);
    }
}

void El6751StartUp::TellMaster(const Instant now) noexcept
{
    const std::int16_t state = MasterState();
    if (state != master_)
    {
        master_ = state;
        parts_.common.listener.OnMasterState(state, now);
    }
}

void El6751StartUp::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    pdos_.OnFrame(frame, now);
    for (std::uint8_t id = 1U; (id <= kLastNode) && is_active_; ++id)
    {
        // At once: the next frame may be right again.
        if ((Of(NodeId{id}).phase == El6751Phase::kRunning) && (pdos_.Fault(NodeId{id}) != 0))
        {
            Watch(NodeId{id}, now);
        }
    }
}

void El6751StartUp::OnSent(const CanFrame& frame) noexcept
{
    pdos_.OnSent(frame);
}

void El6751StartUp::OnCycle(const Instant now) noexcept
{
    const bool is_working = is_active_ && is_usable_ && (controller_ == ControllerState::kRunning);
    if (is_working && is_reset_due_)
    {
        SendReset(now);
    }
    else if (is_working)
    {
        pdos_.OnCycle(now);
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            Drive(NodeId{id}, now);
        }
        StartAll(now);
    }
    else
    {
        // Nothing to work for, or with.
    }
    TellMaster(now);
}

/// One step of one slave.
void El6751StartUp::Drive(const NodeId node, const Instant now) noexcept
{
    switch (Of(node).phase)
    {
    case El6751Phase::kResetting:
        DriveReset(node, now);
        break;
    case El6751Phase::kRows:
        DriveRows(node, now);
        break;
    case El6751Phase::kVerify:
        DriveVerify(node, now);
        break;
    case El6751Phase::kStarting:
        DriveStart(node, now);
        break;
    case El6751Phase::kRunning:
        Watch(node, now);
        break;
    case El6751Phase::kStoppingToReset:
    case El6751Phase::kStoppingHeld:
    case El6751Phase::kStoppingFailed:
    case El6751Phase::kStoppingForGood:
        DriveStop(node, now);
        break;
    case El6751Phase::kHeld:
    case El6751Phase::kFailed:
    case El6751Phase::kDeactivated:
        DriveIdle(node, now);
        break;
    case El6751Phase::kOutside:
    default:
        break;
    }
}

/// Once, when all run that were started singly. While a safety slave is assigned nothing goes to node 0: this device
/// alone is OPERATIONAL then. [SRS_ELM_027, SRS_MGR_020]
void El6751StartUp::StartAll(const Instant now) noexcept
{
    const NodeId whom = parts_.common.setup.HasSafetySlave() ? parts_.common.setup.own : kAllNodes;
    bool is_time = !has_started_all_;
    std::uint8_t slaves = 0U;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        if (parts_.common.setup.IsListed(node))
        {
            ++slaves;
            is_time = is_time && SetupOf(node).is_started && (Of(node).phase == El6751Phase::kRunning);
        }
    }
    if (is_time && (slaves > 0U))
    {
        has_started_all_ = (parts_.common.nmt.Request(NmtCommand::kStart, whom, now) == NmtAnswer::kTaken);
    }
}

void El6751StartUp::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_working = is_active_ && is_usable_ && (controller_ == ControllerState::kRunning);
    if (is_working && (Of(node).phase != El6751Phase::kOutside))
    {
        switch (event)
        {
        case NodeEvent::kBootUp:
            OnRestartOfSlave(node, now);
            break;
        case NodeEvent::kHeartbeatLost:
        case NodeEvent::kGuardLost:
            OnFault(node, kNodeDeactivated, now);
            break;
        case NodeEvent::kToggleError:
            OnFault(node, kNodeToggle, now);
            break;
        case NodeEvent::kStarted:
        case NodeEvent::kChanged:
        case NodeEvent::kGuardMissed:
        case NodeEvent::kNeverSeen:
        case NodeEvent::kUnexpected:
        case NodeEvent::kInvalid:
        default:
            break; // States are read in each cycle.
        }
    }
}

/// The boot-up message. [SRS_ELM_002]
void El6751StartUp::OnRestartOfSlave(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const bool has_run = (slave.phase == El6751Phase::kRunning) || (slave.phase == El6751Phase::kStarting);
    const bool is_left = (slave.phase == El6751Phase::kDeactivated) || IsStopping(slave.phase) ||
                         (slave.phase == El6751Phase::kResetting);
    if (has_run && (SetupOf(node).restart == El6751Restart::kByHand))
    {
        OnFault(node, kNodePreOperational, now);
        slave.has_restarted = true; // It may be another device: the hand's start asks it first.
    }
    else if (!is_left)
    {
        BeginRows(node, kNodeStarts, now);
    }
    else
    {
        slave.has_restarted = true; // What is under way goes on; a deactivated slave waits for a hand.
    }
}

/// Error control of a slave whose SDOs are done.
void El6751StartUp::OnFault(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const bool is_under_way = (slave.phase == El6751Phase::kRunning) || (slave.phase == El6751Phase::kStarting) ||
                              (slave.phase == El6751Phase::kVerify);
    const bool is_held = (slave.phase == El6751Phase::kHeld);
    const bool has_reaction = (SetupOf(node).node_reaction == El6751NodeReaction::kStop) && !slave.is_held_by_hand;
    if ((is_under_way || is_held) && has_reaction)
    {
        React(node, code, now);
    }
    else if (is_under_way || is_held)
    {
        slave.control_fault = code;
        slave.cause = code;
        slave.signs = parts_.common.table.Record(node).signs;
        slave.beats = parts_.common.table.Record(node).beats;
        if (!slave.is_held_by_hand)
        {
            StopOthers(node, now);
        }
    }
    else
    {
        // Not supervised.
    }
}

void El6751StartUp::OnController(const ControllerState state, const Instant now) noexcept
{
    const bool has_changed = (state != controller_);
    controller_ = state;
    if (has_changed && is_active_)
    {
        Begin(now);
    }
}

NodeStatus El6751StartUp::Status(const NodeId node) const noexcept
{
    const El6751Node& slave = Of(node);
    NodeStatus status = slave.status;
    status.is_busy = (slave.phase == El6751Phase::kResetting) || (slave.phase == El6751Phase::kRows) ||
                     (slave.phase == El6751Phase::kVerify) || (slave.phase == El6751Phase::kStarting) ||
                     IsStopping(slave.phase);
    // Who booted while it was deactivated, or was held before it said who it is, is asked by its next start-up.
    const bool is_unasked = slave.has_restarted || (slave.place.row <= El6751Row::kSerialNumber);
    status.is_other = status.is_other || (IsSafety(node) && !status.is_busy && is_unasked); // [SRS_SFS_009]
    return status;
}

std::int16_t El6751StartUp::MasterState() const noexcept
{
    bool is_started = true;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        is_started = is_started && (!parts_.common.setup.IsListed(NodeId{id}) || Of(NodeId{id}).was_started);
    }
    std::int16_t state = is_started ? kEl6751Runs : kEl6751Starts;
    state = (controller_ == ControllerState::kRunning) ? state : kEl6751NoBus;
    state = is_usable_ ? state : kEl6751Unusable;
    return is_active_ ? state : kEl6751Ended;
}

std::int16_t El6751StartUp::Cause(const NodeId node) const noexcept
{
    return Of(node).cause;
}

} // namespace counterpoint::cia302
