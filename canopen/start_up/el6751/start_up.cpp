// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/start_up.hpp"

namespace counterpoint::cia302
{

El6751StartUp::El6751StartUp(const El6751Parts& parts) noexcept
    : parts_(parts.common), pdos_(El6751PdoParts{parts.common.setup, parts.common.sink, parts.pdos, parts.times}),
      slaves_(parts), sdos_(slaves_, pdos_), stops_(slaves_, pdos_, sdos_), release_(slaves_, pdos_, stops_),
      watch_(slaves_, pdos_, sdos_, stops_), by_hand_(slaves_, sdos_, stops_, release_),
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
        if (parts_.setup.IsListed(node))
        {
            const NodeStatus before = slaves_.Of(node).status;
            slaves_.Of(node) = El6751Node{};
            slaves_.Of(node).status.code = before.code;
            sdos_.Begin(node, is_reset_due_ ? kNodeStarts : lost, now);
        }
        else
        {
            slaves_.Of(node) = El6751Node{};
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
        const NmtAnswer answer = parts_.nmt.Request(NmtCommand::kResetCommunication, kAllNodes, now);
        is_reset_due_ = (answer != NmtAnswer::kTaken);
    }
}

void El6751StartUp::End() noexcept
{
    is_active_ = false;
    pdos_.End();
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        parts_.sdo.Cancel(NodeId{id}, SdoAbort::kGeneral);
        slaves_.Of(NodeId{id}) = El6751Node{};
    }
}

void El6751StartUp::TellMaster(const Instant now) noexcept
{
    const std::int16_t state = MasterState();
    if (state != master_)
    {
        master_ = state;
        parts_.listener.OnMasterState(state, now);
    }
}

void El6751StartUp::OnFrame(const CanFrame& frame, const Instant now) noexcept
{
    pdos_.OnFrame(frame, now);
    for (std::uint8_t id = 1U; (id <= kLastNode) && is_active_; ++id)
    {
        // At once: the next frame may be right again.
        if ((slaves_.Of(NodeId{id}).phase == El6751Phase::kRunning) && (pdos_.Fault(NodeId{id}) != 0))
        {
            watch_.Watch(NodeId{id}, now);
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
    switch (slaves_.Of(node).phase)
    {
    case El6751Phase::kResetting:
        sdos_.Reset(node, now);
        break;
    case El6751Phase::kRows:
        if (sdos_.Drive(node, now))
        {
            release_.Begin(node, now);
        }
        break;
    case El6751Phase::kVerify:
    case El6751Phase::kStarting:
        release_.Drive(node, now);
        break;
    case El6751Phase::kRunning:
        watch_.Watch(node, now);
        break;
    case El6751Phase::kStoppingToReset:
    case El6751Phase::kStoppingHeld:
    case El6751Phase::kStoppingFailed:
    case El6751Phase::kStoppingForGood:
        stops_.Drive(node, now);
        break;
    case El6751Phase::kHeld:
    case El6751Phase::kFailed:
    case El6751Phase::kDeactivated:
        watch_.WatchIdle(node, now);
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
    const NodeId whom = parts_.setup.HasSafetySlave() ? parts_.setup.own : kAllNodes;
    bool is_time = !has_started_all_;
    std::uint8_t slaves = 0U;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        if (parts_.setup.IsListed(node))
        {
            ++slaves;
            is_time = is_time && slaves_.SetupOf(node).is_started && (slaves_.Of(node).phase == El6751Phase::kRunning);
        }
    }
    if (is_time && (slaves > 0U))
    {
        has_started_all_ = (parts_.nmt.Request(NmtCommand::kStart, whom, now) == NmtAnswer::kTaken);
    }
}

void El6751StartUp::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const bool is_working = is_active_ && is_usable_ && (controller_ == ControllerState::kRunning);
    if (is_working && (slaves_.Of(node).phase != El6751Phase::kOutside))
    {
        switch (event)
        {
        case NodeEvent::kBootUp:
            OnRestartOfSlave(node, now);
            break;
        case NodeEvent::kHeartbeatLost:
        case NodeEvent::kGuardLost:
            watch_.OnFault(node, kNodeDeactivated, now);
            break;
        case NodeEvent::kToggleError:
            watch_.OnFault(node, kNodeToggle, now);
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
    El6751Node& slave = slaves_.Of(node);
    const bool has_run = (slave.phase == El6751Phase::kRunning) || (slave.phase == El6751Phase::kStarting);
    const bool is_left = (slave.phase == El6751Phase::kDeactivated) || IsStopping(slave.phase) ||
                         (slave.phase == El6751Phase::kResetting);
    if (has_run && (slaves_.SetupOf(node).restart == El6751Restart::kByHand))
    {
        watch_.OnFault(node, kNodePreOperational, now);
        slave.has_restarted = true; // It may be another device: the hand's start asks it first.
    }
    else if (!is_left)
    {
        sdos_.Begin(node, kNodeStarts, now);
    }
    else
    {
        slave.has_restarted = true; // What is under way goes on; a deactivated slave waits for a hand.
    }
}

void El6751StartUp::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    release_.OnStartDropped(node, now);
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

NmtAnswer El6751StartUp::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    return is_active_ ? by_hand_.Command(command, node, now) : NmtAnswer::kNotActive;
}

NmtAnswer El6751StartUp::Control(const NodeId node, const std::uint16_t ads_state, const std::uint16_t device_state,
                                 const Instant now) noexcept
{
    return is_active_ ? by_hand_.Control(node, ads_state, device_state, now) : NmtAnswer::kNotActive;
}

bool El6751StartUp::Boot(const NodeId node, const Instant now) noexcept
{
    const bool is_one = is_active_ && (slaves_.Of(node).phase != El6751Phase::kOutside);
    if (is_one)
    {
        El6751Node& slave = slaves_.Of(node);
        slave.is_held_by_hand = false;
        slave.phase = Next(slave.phase, El6751Event::kReset);
        slaves_.Tell(node, kNodeStarts, StartUpStep::kReset, now);
    }
    return is_one;
}

/// A slave that is held by hand waits for a hand.
bool El6751StartUp::Resume(const NodeId node, const Instant now) noexcept
{
    const bool is_one = is_active_ && (slaves_.Of(node).phase != El6751Phase::kOutside);
    if (is_one && !slaves_.Of(node).is_held_by_hand)
    {
        sdos_.Begin(node, kNodeStarts, now);
    }
    return is_one;
}

NodeStatus El6751StartUp::Status(const NodeId node) const noexcept
{
    const El6751Node& slave = slaves_.Of(node);
    NodeStatus status = slave.status;
    status.is_busy = slaves_.IsBusy(node);
    // Who booted while it was deactivated, or was held before it said who it is, is asked by its next start-up.
    const bool is_unasked = slave.has_restarted || (slave.place.row <= El6751Row::kSerialNumber);
    status.is_other = status.is_other || (slaves_.IsSafety(node) && !status.is_busy && is_unasked); // [SRS_SFS_009]
    return status;
}

std::int16_t El6751StartUp::MasterState() const noexcept
{
    bool is_started = true;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        is_started = is_started && (!parts_.setup.IsListed(NodeId{id}) || slaves_.Of(NodeId{id}).was_started);
    }
    std::int16_t state = is_started ? kEl6751Runs : kEl6751Starts;
    state = (controller_ == ControllerState::kRunning) ? state : kEl6751NoBus;
    state = is_usable_ ? state : kEl6751Unusable;
    return is_active_ ? state : kEl6751Ended;
}

std::int16_t El6751StartUp::Cause(const NodeId node) const noexcept
{
    return slaves_.Of(node).cause;
}

} // namespace counterpoint::cia302
