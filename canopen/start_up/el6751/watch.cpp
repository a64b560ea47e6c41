// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A slave that was started: waiting for its TxPDOs, its errors and what follows them.
#include "canopen/start_up/el6751/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kSettlingUs = 1000000U;
constexpr std::uint32_t kFirstPdoUs = 10000000U;

} // namespace

void El6751StartUp::Run(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    slave.phase = Next(slave.phase, El6751Event::kRun);
    slave.started = now;
    slave.signs = parts_.common.table.Record(node).signs;
    slave.is_settled = false;
    slave.is_wait_over = false;
    slave.was_operational = false;
    slave.control_fault = 0;
    slave.was_started = true;
    slave.status.is_started = true;
    const NodeRecord& record = parts_.common.table.Record(node);
    if ((record.watch == cia302::Watch::kNone) || (record.state == SlaveState::kMissing))
    {
        Supervise(node, now);
    }
    const bool has_all = pdos_.HasAll(node);
    Tell(node, has_all ? kNodeRuns : kNodeWaitsForPdos, has_all ? StartUpStep::kRunning : StartUpStep::kWaitPdos, now);
}

void El6751StartUp::Watch(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const std::uint32_t elapsed_us = now.us - slave.started.us;
    if (!slave.is_settled && (elapsed_us >= kSettlingUs))
    {
        slave.is_settled = true;
        slave.signs = parts_.common.table.Record(node).signs;
        pdos_.Feed(node);
    }
    const std::int16_t fault = FaultOf(node);
    const bool is_overdue = !slave.is_wait_over && (elapsed_us >= kFirstPdoUs);
    slave.is_wait_over = slave.is_wait_over || is_overdue;
    if ((fault != 0) && (SetupOf(node).node_reaction == El6751NodeReaction::kStop))
    {
        React(node, fault, now);
    }
    else if (is_overdue && SetupOf(node).is_restarted_without_pdos && !pdos_.HasAny(node))
    {
        slave.phase = Next(slave.phase, El6751Event::kReset);
        pdos_.Rest(node);
        DriveReset(node, now);
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
        Tell(node, (fault != 0) ? fault : good, has_all ? StartUpStep::kRunning : StartUpStep::kWaitPdos, now);
        VerifyAgain(node, now);
    }
}

/// One that was started, and whose gate did not stay open, runs on verified or not at all. [SRS_ELM_049]
void El6751StartUp::VerifyAgain(const NodeId node, const Instant now) noexcept
{
    const El6751Node& slave = Of(node);
    const NodeRecord& record = parts_.common.table.Record(node);
    const bool has_left = slave.was_operational && (record.runs == 0U) && (record.state != SlaveState::kOperational);
    if (IsSafety(node) && has_left && parts_.common.gate.MayStart(node))
    {
        parts_.common.gate.Close(node);
    }
    const GateState gate = parts_.common.gate.State(node);
    const bool is_refused = (gate == GateState::kDiffers) || (gate == GateState::kFailed);
    const bool is_back = (gate == GateState::kClosed) && parts_.common.table.RunsSurely(node);
    DriveCheck(node, IsSafety(node) && (is_refused || is_back), now);
}

/// NodeState of what is wrong now; 0: nothing. [SRS_ELM_034, SRS_ELM_035, SRS_ELM_036, SRS_ELM_037, SRS_ELM_038,
/// SRS_ELM_039, SRS_ELM_040, SRS_ELM_041]
std::int16_t El6751StartUp::FaultOf(const NodeId node) noexcept
{
    El6751Node& slave = Of(node);
    const NodeRecord& record = parts_.common.table.Record(node);
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

/// Stop, and what is configured to follow. [SRS_ELM_042, SRS_ELM_043]
void El6751StartUp::React(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const bool is_by_hand = (SetupOf(node).restart == El6751Restart::kByHand);
    slave.cause = code;
    slave.is_checking = false;
    parts_.common.gate.Close(node);
    Tell(node, code, slave.status.step, now);
    if (is_by_hand)
    {
        Tell(node, kNodeDeactivated, slave.status.step, now);
    }
    StopOthers(node, now);
    Stop(node, is_by_hand ? El6751Event::kDeactivate : El6751Event::kRestart, now);
}

/// The reaction of the network, which does not depend on that of the node.
void El6751StartUp::StopOthers(const NodeId node, const Instant now) noexcept
{
    const bool is_asked = (SetupOf(node).network_reaction == El6751NetworkReaction::kStopAll);
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        El6751Node& other = Of(NodeId{id});
        const bool is_started = (other.phase == El6751Phase::kRunning) || (other.phase == El6751Phase::kStarting);
        if (is_asked && is_started && (id != node.value))
        {
            other.cause = kNodeDeactivated;
            Tell(NodeId{id}, kNodeDeactivated, other.status.step, now);
            Stop(NodeId{id}, El6751Event::kDeactivate, now);
        }
    }
}

void El6751StartUp::Stop(const NodeId node, const El6751Event event, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    parts_.common.table.Unwatch(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, event);
    DriveStop(node, now);
}

void El6751StartUp::DriveStop(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    if (parts_.common.nmt.Request(NmtCommand::kStop, node, now) == NmtAnswer::kTaken)
    {
        slave.phase = Next(slave.phase, El6751Event::kStopped);
        slave.signs = parts_.common.table.Record(node).signs;
        slave.was_checked = false;
        slave.status.is_started = false;
        if (slave.phase == El6751Phase::kResetting)
        {
            DriveReset(node, now);
        }
    }
}

/// Not started, and why.
void El6751StartUp::Hold(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    pdos_.Rest(node);
    slave.phase = Next(slave.phase, El6751Event::kHold);
    slave.held_code = code;
    slave.control_fault = 0;
    slave.is_checking = false;
    slave.was_checked = false;
    slave.signs = parts_.common.table.Record(node).signs;
    slave.status.is_started = false;
    Tell(node, code, StartUpStep::kManual, now);
}

/// A slave that is not to run: held, failed or deactivated. A safety slave that runs all the same is verified.
/// [SRS_ELM_049]
void El6751StartUp::DriveIdle(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const NodeRecord& record = parts_.common.table.Record(node);
    const bool has_sign = (record.signs != slave.signs);
    const bool is_found = IsSafety(node) && has_sign && parts_.common.table.IsFoundRunning(node);
    const GateState gate = parts_.common.gate.State(node);
    if (slave.phase == El6751Phase::kHeld)
    {
        slave.control_fault = (record.beats != slave.beats) ? std::int16_t{0} : slave.control_fault;
        Tell(node, (slave.control_fault != 0) ? slave.control_fault : slave.held_code, slave.status.step, now);
    }
    slave.was_checked = slave.was_checked && is_found;
    const bool is_left = (gate == GateState::kClosed) && parts_.common.table.RunsSurely(node);
    DriveCheck(node, is_found && (!slave.was_checked || is_left), now);
}

/// The gate reads a slave that runs.
void El6751StartUp::DriveCheck(const NodeId node, const bool is_suspect, const Instant now) noexcept
{
    El6751Node& slave = Of(node);
    const GateState gate = parts_.common.gate.State(node);
    if (slave.is_checking)
    {
        slave.is_checking = (gate == GateState::kBusy);
        slave.was_checked = (gate == GateState::kOpen);
        if ((gate == GateState::kDiffers) || (gate == GateState::kFailed))
        {
            RefuseSafety(node, now);
        }
    }
    else if (is_suspect)
    {
        slave.is_checking = true;
        parts_.common.gate.Verify(node, now);
    }
    else
    {
        // As it is to be.
    }
}

} // namespace counterpoint::cia302
