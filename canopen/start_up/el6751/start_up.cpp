// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint16_t kAdsRun = 5U;
constexpr std::uint16_t kAdsStop = 6U;

/// A row of the table; a reset is followed by a start.
struct ControlRow
{
    std::uint16_t ads_state;
    std::uint16_t device_state;
    SlaveState from;
    NmtCommand command;
};

/// The text's table, row by row.
constexpr ControlRow kControlRows[]{
    {kAdsRun, 0U, SlaveState::kOperational, NmtCommand::kPreOperational},
    {kAdsRun, 1U, SlaveState::kPreOperational, NmtCommand::kStart},
    {kAdsStop, 0U, SlaveState::kOperational, NmtCommand::kStop},
    {kAdsRun, 1U, SlaveState::kStopped, NmtCommand::kResetCommunication},
    {kAdsRun, 3U, SlaveState::kStopped, NmtCommand::kStart},
    {kAdsStop, 0U, SlaveState::kPreOperational, NmtCommand::kStop},
    {kAdsRun, 2U, SlaveState::kStopped, NmtCommand::kPreOperational},
};

/// Whether all run, and were started singly.
bool DoAllRun(const NetworkSetup& setup, const El6751Slaves& slaves) noexcept
{
    bool do_all = true;
    std::uint8_t count = 0U;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        if (setup.IsListed(node))
        {
            ++count;
            do_all = do_all && slaves.SetupOf(node).is_started && (slaves.Of(node).phase == El6751Phase::kRunning);
        }
    }
    return do_all && (count > 0U);
}

} // namespace

El6751StartUp::El6751StartUp(const El6751Parts& parts) noexcept
    : parts_(parts.common), pdos_(El6751PdoParts{parts.common.setup, parts.common.sink, parts.pdos, parts.times}),
      slaves_(parts), sdos_(slaves_, pdos_), operation_(slaves_, pdos_, sdos_), controller_(ControllerState::kRunning),
      master_(kEl6751Ended), is_active_(false), is_usable_(true), is_reset_due_(false), has_started_all_(false)
{
}

/// [SRS_ELM_150]
void El6751StartUp::Begin(const Instant now) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        slaves_.Of(NodeId{id}).is_held_by_hand = false;
    }
    BeginAll(now);
}

/// What is held by hand stays so, unless a start was ordered since. [SRS_ELM_060]
void El6751StartUp::BeginAll(const Instant now) noexcept
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
            const bool is_held = slaves_.Of(node).is_held_by_hand && !slaves_.Of(node).is_start_wanted;
            slaves_.Of(node) = El6751Node{};
            slaves_.Of(node).is_held_by_hand = is_held;
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
        parts_.gate.Close(NodeId{id});
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
            operation_.Watch(NodeId{id}, now);
        }
    }
}

void El6751StartUp::OnSent(const CanFrame& frame) noexcept
{
    pdos_.OnSent(frame);
}

void El6751StartUp::OnRoom(const Instant now) noexcept
{
    pdos_.SendAgain(now);
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
            operation_.Drive(NodeId{id}, now);
        }
        StartAll(now);
    }
    else
    {
        // Nothing to work for, or with.
    }
    TellMaster(now);
}

/// One that waits is given up when a slave runs no more: it would start what is set up just now. [SRS_ELM_820]
void El6751StartUp::GiveUpStartOfAll() noexcept
{
    if (parts_.nmt.HasStart(kAllNodes) && !DoAllRun(parts_.setup, slaves_))
    {
        parts_.nmt.DropStarts(kAllNodes);
        has_started_all_ = false;
    }
}

/// Once. While a safety slave is assigned nothing goes to node 0: this device alone is OPERATIONAL then.
/// [SRS_ELM_027, SRS_MGR_152]
void El6751StartUp::StartAll(const Instant now) noexcept
{
    const NodeId whom = parts_.setup.HasSafetySlave() ? parts_.setup.own : kAllNodes;
    GiveUpStartOfAll();
    if (!has_started_all_ && DoAllRun(parts_.setup, slaves_))
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
            operation_.OnFault(node, kNodeDeactivated, now);
            break;
        case NodeEvent::kToggleError:
            operation_.OnFault(node, kNodeToggle, now);
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
        GiveUpStartOfAll();
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
        operation_.OnFault(node, kNodePreOperational, now);
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
    operation_.OnStartDropped(node, now);
}

void El6751StartUp::OnController(const ControllerState state, const Instant now) noexcept
{
    const bool has_changed = (state != controller_);
    controller_ = state;
    if (has_changed && is_active_)
    {
        BeginAll(now);
    }
}

SlaveState El6751StartUp::ControlState(const NodeId node) const noexcept
{
    // A deactivated slave was stopped, whatever became of it.
    const bool is_stopped = (slaves_.Of(node).phase == El6751Phase::kDeactivated);
    return is_stopped ? SlaveState::kStopped : static_cast<SlaveState>(parts_.table.RequestValue(node));
}

NmtAnswer El6751StartUp::Control(const NodeId node, const std::uint16_t ads_state, const std::uint16_t device_state,
                                 const Instant now) noexcept
{
    const bool is_free = !slaves_.IsBusy(node) && (slaves_.Of(node).phase != El6751Phase::kOutside);
    const SlaveState state = ControlState(node);
    NmtCommand command = NmtCommand::kInvalid;
    for (const ControlRow& row : kControlRows)
    {
        const bool is_asked = (row.ads_state == ads_state) && (row.device_state == device_state);
        const bool is_from = (state == row.from);
        command = (is_free && is_asked && is_from) ? row.command : command;
    }
    const NmtAnswer answer = is_active_ ? CommandOne(command, node, now) : NmtAnswer::kNotActive;
    if (command == NmtCommand::kResetCommunication)
    {
        slaves_.Of(node).is_start_wanted = (answer == NmtAnswer::kTaken);
    }
    return answer;
}

NmtAnswer El6751StartUp::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    NmtAnswer answer = is_active_ ? NmtAnswer::kWrong : NmtAnswer::kNotActive;
    if (is_active_ && (node.value == kAllNodes.value))
    {
        answer = NmtAnswer::kTaken;
        for (std::uint8_t id = 1U; id <= kLastNode; ++id)
        {
            const bool is_one = (slaves_.Of(NodeId{id}).phase != El6751Phase::kOutside);
            const NmtAnswer one = is_one ? CommandOne(command, NodeId{id}, now) : NmtAnswer::kTaken;
            answer = (one == NmtAnswer::kTaken) ? answer : one;
        }
    }
    else if (is_active_ && (slaves_.Of(node).phase != El6751Phase::kOutside))
    {
        answer = CommandOne(command, node, now);
    }
    else if (is_active_ && (node.value == parts_.setup.own.value))
    {
        answer = parts_.nmt.Request(command, node, now);
    }
    else
    {
        // Not in the network, or none is started up.
    }
    return answer;
}

NmtAnswer El6751StartUp::CommandOne(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    NmtAnswer answer = NmtAnswer::kWrong;
    switch (command)
    {
    case NmtCommand::kStart:
        answer = Start(node, now);
        break;
    case NmtCommand::kStop:
    case NmtCommand::kPreOperational:
        answer = Hold(command, node, now);
        break;
    case NmtCommand::kResetNode:
    case NmtCommand::kResetCommunication:
        answer = Reset(command, node, now);
        break;
    case NmtCommand::kInvalid:
    default:
        break;
    }
    return answer;
}

/// A start-up that runs is given up.
NmtAnswer El6751StartUp::Hold(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const NmtAnswer answer = parts_.nmt.Request(command, node, now);
    if (answer == NmtAnswer::kTaken)
    {
        parts_.gate.Close(node);
        parts_.sdo.Cancel(node, SdoAbort::kGeneral);
        slaves_.Of(node).is_cut = slaves_.Of(node).is_cut || (slaves_.Of(node).phase == El6751Phase::kRows);
        slaves_.Of(node).is_held_by_hand = true;
        slaves_.Of(node).is_start_wanted = false;
        operation_.Hold(node, (command == NmtCommand::kStop) ? kNodeDeactivated : kNodePreOperational, now);
    }
    return answer;
}

/// While SDOs are under way, the start follows them. A slave that restarted unnoticed needs them first. One that left
/// OPERATIONAL without a reaction is started again. One that was held in the middle of its SDOs gets all of them first.
NmtAnswer El6751StartUp::Start(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const std::uint8_t operational = static_cast<std::uint8_t>(SlaveState::kOperational);
    const bool runs = (parts_.table.RequestValue(node) == operational);
    const bool is_deaf = (parts_.table.Record(node).asked == SlaveState::kStopped);
    const bool is_unasked = slaves_.IsSafety(node) && (slave.place.row <= El6751Row::kSerialNumber); // Who it is.
    const bool is_unknown = slave.is_cut || is_unasked;
    const bool is_held = (slave.phase == El6751Phase::kHeld);
    NmtAnswer answer = NmtAnswer::kTaken;
    if (slaves_.IsSafety(node) && slave.status.is_other)
    {
        answer = NmtAnswer::kOtherDevice;
    }
    else if ((slave.has_restarted && !slaves_.IsBusy(node)) || (is_held && is_unknown && is_deaf))
    {
        answer = Reset(NmtCommand::kResetCommunication, node, now);
        slave.is_start_wanted = (answer == NmtAnswer::kTaken);
    }
    else if (slaves_.IsBusy(node))
    {
        slave.is_start_wanted = true;
    }
    else if (is_held && is_unknown)
    {
        slave.is_start_wanted = true;
        sdos_.Begin(node, kNodeStarts, now);
    }
    else if ((slave.phase != El6751Phase::kRunning) || !runs)
    {
        operation_.Start(node, now);
    }
    else
    {
        // It runs.
    }
    return answer;
}

NmtAnswer El6751StartUp::Reset(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const NmtAnswer answer = parts_.nmt.Request(command, node, now);
    if (answer == NmtAnswer::kTaken)
    {
        slaves_.Of(node).is_held_by_hand = false;
        sdos_.Begin(node, kNodeStarts, now);
    }
    return answer;
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

bool El6751StartUp::Configure(const NodeId node, const Instant now) noexcept
{
    return IsConfigurable(parts_, *this, node) && Boot(node, now);
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
