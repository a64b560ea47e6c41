// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/watch.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint32_t kSettlingUs = 1000000U;
constexpr std::uint32_t kFirstPdoUs = 10000000U;

} // namespace

El6751Watch::El6751Watch(El6751Slaves& slaves, El6751Pdos& pdos, El6751Sdos& sdos, El6751Stops& stops) noexcept
    : parts_(slaves.Parts()), slaves_(slaves), pdos_(pdos), sdos_(sdos), stops_(stops), reader_(slaves.Parts())
{
}

void El6751Watch::Watch(const NodeId node, const Instant now) noexcept
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
            stops_.StopOthers(node, now);
        }
        slaves_.Tell(node, (fault != 0) ? fault : good, has_all ? StartUpStep::kRunning : StartUpStep::kWaitPdos, now);
        VerifyAgain(node, now);
    }
}

/// One that was started, and whose gate did not stay open, runs on verified or not at all. [SRS_ELM_049]
void El6751Watch::VerifyAgain(const NodeId node, const Instant now) noexcept
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
std::int16_t El6751Watch::FaultOf(const NodeId node) noexcept
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

void El6751Watch::OnFault(const NodeId node, const std::int16_t code, const Instant now) noexcept
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
            stops_.StopOthers(node, now);
        }
    }
    else
    {
        // Not supervised.
    }
}

/// Stop, and what is configured to follow. [SRS_ELM_042, SRS_ELM_043]
void El6751Watch::React(const NodeId node, const std::int16_t code, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const bool is_by_hand = (slaves_.SetupOf(node).restart == El6751Restart::kByHand);
    slave.cause = code;
    slave.reading.is_checking = false;
    parts_.gate.Close(node);
    slaves_.Tell(node, code, slave.status.step, now);
    if (is_by_hand)
    {
        slaves_.Tell(node, kNodeDeactivated, slave.status.step, now);
    }
    stops_.StopOthers(node, now);
    stops_.Stop(node, is_by_hand ? El6751Event::kDeactivate : El6751Event::kRestart, now);
}

/// A slave that is not to run: held, failed or deactivated. A safety slave that runs all the same is verified.
/// [SRS_ELM_049]
void El6751Watch::WatchIdle(const NodeId node, const Instant now) noexcept
{
    El6751Node& slave = slaves_.Of(node);
    const NodeRecord& record = parts_.table.Record(node);
    const bool has_sign = (record.signs != slave.signs);
    const bool is_found = slaves_.IsSafety(node) && has_sign && parts_.table.IsFoundRunning(node);
    const GateState gate = parts_.gate.State(node);
    if (slave.phase == El6751Phase::kHeld)
    {
        slave.control_fault = (record.beats != slave.beats) ? std::int16_t{0} : slave.control_fault;
        slaves_.Tell(node, (slave.control_fault != 0) ? slave.control_fault : slave.held_code, slave.status.step, now);
    }
    slave.reading.was_checked = slave.reading.was_checked && is_found;
    const bool is_left = (gate == GateState::kClosed) && parts_.table.RunsSurely(node);
    Check(node, is_found && (!slave.reading.was_checked || is_left), now);
}

/// The gate reads a slave that runs.
void El6751Watch::Check(const NodeId node, const bool is_suspect, const Instant now) noexcept
{
    if (reader_.OfRunning(slaves_.Of(node).reading, node, is_suspect, now) == ReadingEnd::kRefused)
    {
        stops_.Refuse(node, now);
    }
}

} // namespace counterpoint::cia302
