// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/operation.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.
constexpr std::uint32_t kSettlingUs = 1000000U;
constexpr std::uint32_t kFirstPdoUs = 10000000U;

} // namespace

El6751Operation::El6751Operation(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos) noexcept
    : parts_(slaves.Parts()), slaves_(slaves), pdos_(pdos), sdos_(sdos), reader_(slaves.Parts())
{
}

void El6751Operation::Begin(const NodeId node, const Instant now) noexcept
{
    const El6751Node& slave = slaves_.Of(node);
    const bool is_started = slaves_.SetupOf(node).is_started && !slave.is_held_by_hand;
    Supervise(node, now);
    if (is_started || slave.is_start_wanted)
    {
        Start(node, now);
    }
    else
    {
        Hold(node, kNodePreOperational, now);
        slaves_.Of(node).signs = slaves_.SignsBefore(node);
    }
}

/// Heartbeat if the slave took it, else guarding; what the network's list says if this profile has no times.
void El6751Operation::Supervise(const NodeId node, const Instant now) noexcept
{
    const El6751Slave& setup = slaves_.SetupOf(node);
    NodeTable& table = parts_.table;
    constexpr std::uint32_t kLongestTime = 0xFFFFU;
    const std::uint32_t life_ms = std::uint32_t{setup.guard_time_ms} * setup.life_time_factor;
    const auto time_ms = static_cast<std::uint16_t>((life_ms > kLongestTime) ? kLongestTime : life_ms);
    const std::uint16_t listed_ms = parts_.setup.Slave(node).heartbeat.consumer_ms;
    const bool was_lost = (table.Record(node).state == SlaveState::kMissing);
    if (!setup.IsWatched() && was_lost && (listed_ms > 0U))
    {
        table.WatchHeartbeat(node, listed_ms, Arming::kImmediately, now); // It was there once.
    }
    else if (!setup.IsWatched())
    {
        table.WatchAsSetUp(node, now);
    }
    else if (slaves_.Of(node).place.is_heartbeat_aborted)
    {
        table.WatchGuarding(node, setup.guard_time_ms, setup.life_time_factor, now);
    }
    else if (slaves_.Of(node).place.is_heartbeat_answered)
    {
        table.WatchHeartbeat(node, time_ms, Arming::kImmediately, now);
    }
    else
    {
        // Started by hand after a start-up that did not come so far: it was told to send nothing.
    }
}

void El6751Operation::Start(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    slave.is_requested = false;
    slave.is_held_by_hand = false;
    slave.is_start_wanted = false;
    slave.reading = SafetyReading{};
    slave.control_fault = 0;
    slave.phase = Next(slave.phase, slaves_.IsSafety(node) ? El6751Event::kVerify : El6751Event::kStart);
    slaves_.Tell(node, kNodeStarts, slaves_.IsSafety(node) ? StartUpStep::kSafety : StartUpStep::kStart, now);
    Drive(node, now);
}

void El6751Operation::Drive(const NodeId node, const Instant now) noexcept
{
    switch (slaves_.Of(node).phase)
    {
    case El6751Phase::kResetting:
        sdos_.Reset(node, now);
        break;
    case El6751Phase::kRows:
        if (sdos_.Drive(node, now))
        {
            Begin(node, now);
        }
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
        SendStop(node, now);
        break;
    case El6751Phase::kHeld:
    case El6751Phase::kFailed:
    case El6751Phase::kDeactivated:
        WatchIdle(node, now);
        break;
    case El6751Phase::kOutside:
    default:
        break;
    }
}

/// The gate reads; a STOPPED slave has no SDO and is made PRE-OPERATIONAL before.
void El6751Operation::DriveVerify(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool is_deaf =
        (parts_.table.Record(node).asked == SlaveState::kStopped) || (parts_.table.RequestValue(node) == kStoppedByte);
    const ReadingEnd end = reader_.BeforeStart(slave.reading, node, is_deaf, now);
    if (end == ReadingEnd::kOpen)
    {
        slave.reading = SafetyReading{};
        slave.phase = Next(slave.phase, El6751Event::kStart);
        slaves_.Tell(node, kNodeStarts, StartUpStep::kStart, now);
        DriveStart(node, now);
    }
    else if (end == ReadingEnd::kRefused)
    {
        Refuse(node, now);
    }
    else
    {
        // The gate or the queue is waited for.
    }
}

void El6751Operation::OnStartDropped(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    if ((slave.phase == El6751Phase::kStarting) && slave.is_requested)
    {
        slave.phase = Next(slave.phase, El6751Event::kVerify);
        slave.is_requested = false;
        slave.reading = SafetyReading{};
        slaves_.Tell(node, kNodeStarts, StartUpStep::kSafety, now);
    }
}

void El6751Operation::DriveStart(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    if (!slave.is_requested)
    {
        pdos_.Await(node);
        const NmtAnswer answer = parts_.nmt.Request(NmtCommand::kStart, node, now);
        slave.is_requested = (answer == NmtAnswer::kTaken);
        if (answer == NmtAnswer::kNotVerified)
        {
            slave.phase = Next(slave.phase, El6751Event::kVerify);
        }
    }
    // By the queue: what it was asked for last may be of before, or of somebody else since. [SRS_ELM_771]
    if (slave.is_requested && !parts_.nmt.HasStart(node))
    {
        Run(node, now);
    }
}

void El6751Operation::Run(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    slave.phase = Next(slave.phase, El6751Event::kRun);
    slave.started = now;
    slave.signs = parts_.table.Record(node).signs;
    slave.is_settled = false;
    slave.is_wait_over = false;
    slave.was_operational = false;
    slave.control_fault = 0;
    slave.was_started = true;
    slave.status.is_started = true;
    const NodeRecord& record = parts_.table.Record(node);
    if ((record.watch == Watch::kNone) || (record.state == SlaveState::kMissing))
    {
        Supervise(node, now);
    }
    const bool has_all = pdos_.HasAll(node);
    slaves_.Tell(node, has_all ? kNodeRuns : kNodeWaitsForPdos,
                 has_all ? StartUpStep::kRunning : StartUpStep::kWaitPdos, now);
}

void El6751Operation::Watch(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const std::uint32_t elapsed_us = now.us - slave.started.us;
    if (!slave.is_settled && (elapsed_us >= kSettlingUs))
    {
        slave.is_settled = true;
        slave.signs = parts_.table.Record(node).signs;
        pdos_.Feed(node);
    }
    const std::int16_t fault = FaultOf(node);
    const bool is_overdue = !slave.is_wait_over && (elapsed_us >= kFirstPdoUs);
    slave.is_wait_over = slave.is_wait_over || is_overdue;
    if ((fault != 0) && (slaves_.SetupOf(node).node_reaction == El6751NodeReaction::kStop))
    {
        React(node, fault, now);
    }
    else if (is_overdue && slaves_.SetupOf(node).is_restarted_without_pdos && !pdos_.HasAny(node))
    {
        slave.phase = Next(slave.phase, El6751Event::kReset);
        pdos_.Rest(node);
        sdos_.Reset(node, now);
    }
    else
    {
        const bool has_all = pdos_.HasAll(node);
        const std::int16_t good = has_all ? kNodeRuns : kNodeWaitsForPdos;
        slave.cause = (fault != 0) ? fault : slave.cause;
        if ((fault != 0) && (slave.status.code != fault))
        {
            StopOthers(node, now);
        }
        slaves_.Tell(node, (fault != 0) ? fault : good, has_all ? StartUpStep::kRunning : StartUpStep::kWaitPdos, now);
        VerifyAgain(node, now);
    }
}

/// One that was started, and whose gate did not stay open, runs on verified or not at all. [SRS_ELM_049]
void El6751Operation::VerifyAgain(const NodeId node, const Instant now) noexcept
{
    const El6751Node& slave = slaves_.Of(node);
    const NodeRecord& record = parts_.table.Record(node);
    const bool has_left = slave.was_operational && (record.runs == 0U) && (record.state != SlaveState::kOperational);
    if (slaves_.IsSafety(node) && has_left && parts_.gate.MayStart(node))
    {
        parts_.gate.Close(node);
    }
    const GateState gate = parts_.gate.State(node);
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed);
    const bool is_back = (gate == GateState::kClosed) && parts_.table.RunsSurely(node);
    Check(node, slaves_.IsSafety(node) && (is_refused || is_back), now);
}

/// NodeState of what is wrong now; 0: nothing. [SRS_ELM_034, SRS_ELM_035, SRS_ELM_036, SRS_ELM_037, SRS_ELM_038,
/// SRS_ELM_039, SRS_ELM_040, SRS_ELM_041]
std::int16_t El6751Operation::FaultOf(const NodeId node) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const NodeRecord& record = parts_.table.Record(node);
    const bool has_sign = (record.signs != slave.signs); // Since the start, the settling or the fault.
    slave.control_fault = (record.beats != slave.beats) ? std::int16_t{0} : slave.control_fault;
    slave.was_operational = slave.was_operational || (has_sign && (record.state == SlaveState::kOperational));
    const bool is_judged = slave.was_operational || (slave.is_settled && has_sign);
    std::int16_t fault = slave.control_fault;
    if ((fault == 0) && is_judged && (record.state == SlaveState::kPreOperational))
    {
        fault = kNodePreOperational;
    }
    else if ((fault == 0) && is_judged && (record.state == SlaveState::kStopped))
    {
        fault = kNodeDeactivated;
    }
    else
    {
        // As it should be, or told already.
    }
    return (fault != 0) ? fault : pdos_.Fault(node);
}

void El6751Operation::OnFault(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool is_under_way = (slave.phase == El6751Phase::kRunning) || (slave.phase == El6751Phase::kStarting) ||
                              (slave.phase == El6751Phase::kVerify);
    const bool is_held = (slave.phase == El6751Phase::kHeld);
    const bool has_reaction =
        (slaves_.SetupOf(node).node_reaction == El6751NodeReaction::kStop) && !slave.is_held_by_hand;
    if ((is_under_way || is_held) && has_reaction)
    {
        React(node, code, now);
    }
    else if (is_under_way || is_held)
    {
        slave.control_fault = code;
        slave.cause = code;
        slave.signs = parts_.table.Record(node).signs;
        slave.beats = parts_.table.Record(node).beats;
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

/// Stop, and what is configured to follow. [SRS_ELM_042, SRS_ELM_043]
void El6751Operation::React(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool is_by_hand = (slaves_.SetupOf(node).restart == El6751Restart::kByHand);
    slave.cause = code;
    slave.reading.is_checking = false;
    parts_.gate.Close(node);
    slaves_.Tell(node, code, slave.status.step, now);
    StopOthers(node, now);
    if (is_by_hand)
    {
        Deactivate(node, now);
    }
    else
    {
        Stop(node, El6751Event::kRestart, now);
    }
}

void El6751Operation::Deactivate(const NodeId node, const Instant now) noexcept
{
    slaves_.Of(node).held_code = kNodeDeactivated;
    Stop(node, El6751Event::kDeactivate, now);
    TellDeactivated(node, now);
}

/// It runs until its stop was sent. [SRS_ELM_800]
void El6751Operation::TellDeactivated(const NodeId node, const Instant now) noexcept
{
    const El6751Node& slave = slaves_.Of(node);
    if ((slave.phase == El6751Phase::kDeactivated) && !parts_.nmt.IsLeaving(node))
    {
        slaves_.Tell(node, slave.held_code, slave.status.step, now);
    }
}

/// A slave that is not to run: held, failed or deactivated. A safety slave that runs all the same is verified.
/// [SRS_ELM_049]
void El6751Operation::WatchIdle(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const NodeRecord& record = parts_.table.Record(node);
    const bool has_sign = (record.signs != slave.signs);
    const bool is_found = slaves_.IsSafety(node) && has_sign && parts_.table.IsFoundRunning(node);
    const GateState gate = parts_.gate.State(node);
    if ((slave.phase == El6751Phase::kHeld) && !parts_.nmt.IsLeaving(node))
    {
        slave.control_fault = (record.beats != slave.beats) ? std::int16_t{0} : slave.control_fault;
        slaves_.Tell(node, (slave.control_fault != 0) ? slave.control_fault : slave.held_code, slave.status.step, now);
    }
    TellDeactivated(node, now);
    slave.reading.was_checked = slave.reading.was_checked && is_found;
    const bool is_left = (gate == GateState::kClosed) && parts_.table.RunsSurely(node);
    Check(node, is_found && (!slave.reading.was_checked || is_left), now);
}

/// The gate reads a slave that runs.
void El6751Operation::Check(const NodeId node, const bool is_suspect, const Instant now) noexcept
{
    if (reader_.OfRunning(slaves_.Of(node).reading, node, is_suspect, now) == ReadingEnd::kRefused)
    {
        Refuse(node, now);
    }
}

void El6751Operation::Stop(const NodeId node, const El6751Event event, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    parts_.table.Unwatch(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, event);
    SendStop(node, now);
}

void El6751Operation::SendStop(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool is_safety = slaves_.IsSafety(node);
    const NmtAnswer answer = is_safety ? parts_.nmt.Halt(node, now) : parts_.nmt.Request(NmtCommand::kStop, node, now);
    if (answer == NmtAnswer::kTaken)
    {
        slave.phase = Next(slave.phase, El6751Event::kStopped);
        slave.signs = parts_.table.Record(node).signs;
        slave.reading.was_checked = false;
        slave.status.is_started = false;
        if (slave.phase == El6751Phase::kResetting)
        {
            sdos_.Reset(node, now);
        }
    }
}

void El6751Operation::StopOthers(const NodeId node, const Instant now) noexcept
{
    const bool is_asked = (slaves_.SetupOf(node).network_reaction == El6751NetworkReaction::kStopAll);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        El6751Node& other = slaves_.Of(NodeId{id});
        const bool is_started = (other.phase == El6751Phase::kRunning) || (other.phase == El6751Phase::kStarting);
        if (is_asked && is_started && (id != node.value))
        {
            other.cause = kNodeDeactivated;
            Deactivate(NodeId{id}, now);
        }
    }
}

/// NodeState is told when the command was sent: WatchIdle. [SRS_ELM_800]
void El6751Operation::Hold(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, El6751Event::kHold);
    slave.held_code = code;
    slave.control_fault = 0;
    slave.reading.is_checking = false;
    slave.reading.was_checked = false;
    slave.signs = parts_.table.Record(node).signs;
    slave.status.is_started = false;
    slaves_.Tell(node, parts_.nmt.IsLeaving(node) ? slave.status.code : code, StartUpStep::kManual, now);
}

/// A slave that was stopped, and is read once more because somebody's start came so near that it may run, is silent:
/// what was found before stays, unless it said itself that it runs.
void El6751Operation::Refuse(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool differs = parts_.gate.State(node) == GateState::kDiffers;
    const GateFinding finding = parts_.gate.Finding(node);
    const NodeRecord& record = parts_.table.Record(node);
    const bool says_so = (record.state == SlaveState::kOperational) && !record.is_presumed;
    const bool is_silence = !differs && (finding.abort == SdoAbort::kTimeOut) && !says_so;
    const bool has_finding = (slave.status.step == StartUpStep::kSafety) &&
                             ((slave.status.code == kNodeMismatch) || (slave.status.code == kNodeSyntax));
    if (!is_silence || !has_finding)
    {
        slave.status.Take(finding);
        slave.cause = differs ? kNodeMismatch : kNodeSyntax;
        slave.held_code = slave.cause;
        slaves_.Tell(node, slave.cause, StartUpStep::kSafety, now);
    }
    slave.status.is_other = slave.status.is_other || parts_.gate.IsOther(node);
    slave.status.is_started = false;
    slave.reading.is_checking = false;
    Stop(node, El6751Event::kRefuse, now);
}

} // namespace counterpoint::cia302
