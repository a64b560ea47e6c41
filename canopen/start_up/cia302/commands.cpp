// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Commands of the application and error handling of the CiA 302-2 start-up.
#include "canopen/start_up/cia302/start_up.hpp"

namespace counterpoint::cia302
{
namespace
{

bool IsReset(const NmtCommand command) noexcept
{
    return (command == NmtCommand::kResetNode) || (command == NmtCommand::kResetCommunication);
}

} // namespace

void Cia302StartUp::OnNodeEvent(const NodeId node, const NodeEvent event, const Instant now) noexcept
{
    const BootTime time = Tick(now);
    const bool is_listed = parts_.setup.IsListed(node);
    const bool is_active = (step_ != MasterStep::kIdle) && (step_ != MasterStep::kStopped);
    const bool is_boot_up = (event == NodeEvent::kBootUp);
    const bool is_lost = (event == NodeEvent::kHeartbeatLost) || (event == NodeEvent::kGuardLost);
    const bool is_state = (event == NodeEvent::kStarted) || (event == NodeEvent::kChanged);
    if (is_active && !is_listed && (is_boot_up || (event == NodeEvent::kUnexpected)))
    {
        OnForeign(node, now);
    }
    else if (is_listed && is_boot_up)
    {
        OnBootUp(node, time);
    }
    else if (is_active && is_listed && is_lost)
    {
        OnLost(node, time);
    }
    else if ((step_ != MasterStep::kIdle) && is_listed && is_state)
    {
        OnState(node, event, time);
    }
}

/// After a stop of all by error handling nobody is booted but by order. Who boots up then may be another device.
void Cia302StartUp::OnBootUp(const NodeId node, const BootTime& time) noexcept
{
    const BootRecord& record = boot_.Record(node);
    const bool is_stopped = (step_ == MasterStep::kStopped);
    const bool is_ordered = record.status.is_busy && (!record.is_extra || record.IsAwaitingBootUp());
    if ((step_ != MasterStep::kIdle) && (!is_stopped || is_ordered))
    {
        boot_.OnBootUp(node, time);
    }
    else if (is_stopped && parts_.setup.IsSafetySlave(node))
    {
        boot_.Doubt(node, time);
    }
    else
    {
        // Nothing was found of it, or it has no gate.
    }
}

void Cia302StartUp::OnForeign(const NodeId node, const Instant now) noexcept
{
    NodeStatus& status = boot_.Record(node).status;
    const bool is_news = (status.letter != 'A') && (node.value != parts_.setup.own.value);
    if (is_news)
    {
        status = NodeStatus{};
        status.letter = 'A';
        parts_.listener.OnNodeStatus(node, now);
    }
}

/// A safety slave that runs and was not verified, or not started by this master: it was verified before it ran, and
/// changed since. One that has left OPERATIONAL can be changed: what was verified holds no more.
void Cia302StartUp::OnState(const NodeId node, const NodeEvent event, const BootTime& time) noexcept
{
    const bool is_running = (parts_.table.Record(node).state == SlaveState::kOperational);
    const bool is_free = !boot_.Record(node).status.is_busy;
    const bool is_foreign = parts_.setup.IsSafetySlave(node) && !boot_.Record(node).status.is_started;
    const bool is_found = parts_.table.IsFoundRunning(node); // Else at its next sign: VerifyAgain.
    if (is_found && is_free && (is_foreign || !parts_.gate.MayStart(node)))
    {
        boot_.Verify(node, time);
    }
    else if (!is_running && is_free && (event == NodeEvent::kChanged) && parts_.gate.MayStart(node))
    {
        parts_.gate.Close(node);
    }
    else
    {
        // As it is to be, or under way.
    }
}

void Cia302StartUp::OnLost(const NodeId node, const BootTime& time) noexcept
{
    const BootRecord& record = boot_.Record(node);
    const bool is_mandatory = parts_.setup.Slave(node).Has(kMandatory);
    const bool is_booted = record.is_booted && (!record.status.is_busy || record.is_extra);
    if (is_booted && is_mandatory && parts_.setup.Has(kStopAllOnError))
    {
        reaction_ = Reaction::kStopAll;
    }
    else if (is_booted && is_mandatory && parts_.setup.Has(kResetAllOnError))
    {
        reaction_ = (reaction_ == Reaction::kStopAll) ? reaction_ : Reaction::kResetAll;
    }
    else if (is_booted)
    {
        boot_.Reset(node, time);
    }
    React(time);
}

/// What error handling owes, as soon as the queue has room.
void Cia302StartUp::React(const BootTime& time) noexcept
{
    if (reaction_ == Reaction::kStopAll)
    {
        if (parts_.nmt.Request(NmtCommand::kStop, kAllNodes, time.now) == NmtAnswer::kTaken)
        {
            reaction_ = Reaction::kNone;
            is_start_due_ = false;
            EndBoots(time);
            Go(MasterEvent::kStop, time.now);
        }
    }
    else if (reaction_ == Reaction::kResetAll)
    {
        Restart(NmtCommand::kResetNode, time.now);
    }
}

/// A safety slave in the middle of its boot was perhaps not asked yet who it is.
void Cia302StartUp::EndBoots(const BootTime& time) noexcept
{
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        BootRecord& record = boot_.Record(node);
        const bool is_booting = record.IsBooting();
        boot_.End(node);
        record.status.is_started = false;
        if (is_booting && parts_.setup.IsSafetySlave(node))
        {
            boot_.Doubt(node, time);
        }
    }
}

/// It is verified anew and started in the next cycle, unless it boots anew. [SRS_BOOT_014]
void Cia302StartUp::OnStartDropped(const NodeId node, const Instant /*now*/) noexcept
{
    BootRecord& record = boot_.Record(node);
    // Two starts of one slave may be given up in one cycle.
    record.is_start_owed = (record.is_start_owed || record.status.is_started) && parts_.setup.IsListed(node);
    record.status.is_started = false;
}

/// Whom the master asked before may have been replaced since, and it was itself that did not hear the others.
void Cia302StartUp::OnBusBack(const Instant now) noexcept
{
    const BootTime time = Tick(now);
    const bool is_booting = (step_ != MasterStep::kIdle) && (step_ != MasterStep::kStopped);
    for (std::uint8_t id = 1U; is_booting && (id <= kLastNode); ++id)
    {
        const NodeId node{id};
        const BootRecord& record = boot_.Record(node);
        const NodeStatus& status = record.status;
        const SlaveState asked = parts_.table.Record(node).asked;
        const bool is_to_start = !record.is_extra || record.is_start_wanted;
        const bool is_cut = status.is_busy && is_to_start && !record.IsAwaitingBootUp();
        const bool is_waiting = record.is_start_owed || (status.is_started && (asked != SlaveState::kOperational));
        const bool has_failed = (status.letter != '\0') && !record.is_booted && (asked != SlaveState::kStopped);
        const bool is_ended = !status.is_busy && (is_waiting || has_failed);
        if (parts_.setup.IsListed(node) && (is_cut || is_ended))
        {
            const bool is_start_wanted = record.is_start_wanted;
            boot_.Ask(node, time);
            boot_.Record(node).is_start_wanted = is_start_wanted;
        }
    }
}

NmtAnswer Cia302StartUp::Command(const NmtCommand command, const NodeId node, const Instant now) noexcept
{
    const BootTime time = Tick(now);
    NmtAnswer answer = NmtAnswer::kInvalid;
    if (node.value == kAllNodes.value)
    {
        answer = CommandAll(command, time);
    }
    else if (node.value == parts_.setup.own.value)
    {
        answer = CommandOwn(command, time);
    }
    else
    {
        answer = CommandNode(command, node, time);
    }
    return answer;
}

NmtAnswer Cia302StartUp::CommandAll(const NmtCommand command, const BootTime& time) noexcept
{
    const bool is_start = (command == NmtCommand::kStart);
    NmtAnswer answer = NmtAnswer::kTaken;
    if (is_start && parts_.setup.HasSafetySlave())
    {
        answer = StartEach(time);
    }
    else
    {
        answer = parts_.nmt.Request(command, kAllNodes, time.now);
        for (std::uint8_t id = 1U; (answer == NmtAnswer::kTaken) && (id <= kLastNode); ++id)
        {
            // Who was never there heard nothing of it.
            BootRecord& record = boot_.Record(NodeId{id});
            record.status.is_started = is_start && record.is_booted;
            record.is_start_owed = false;
        }
        const bool is_begun = (answer == NmtAnswer::kTaken) && (step_ != MasterStep::kIdle);
        if (is_begun && IsReset(command))
        {
            End();
            BootAll(time);
        }
        else if (is_begun && (is_start || IsMasterOperational()))
        {
            Go(is_start ? MasterEvent::kStart : MasterEvent::kLeave, time.now);
        }
    }
    return answer;
}

/// Another device than the expected one keeps nobody else from being started.
NmtAnswer Cia302StartUp::StartEach(const BootTime& time) noexcept
{
    NmtAnswer answer = NmtAnswer::kTaken;
    NmtAnswer refusal = NmtAnswer::kTaken;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const bool is_meant = parts_.setup.IsListed(NodeId{id}) && (answer == NmtAnswer::kTaken);
        const NmtAnswer one = is_meant ? CommandNode(NmtCommand::kStart, NodeId{id}, time) : NmtAnswer::kTaken;
        refusal = (one == NmtAnswer::kOtherDevice) ? one : refusal;
        answer = ((one == NmtAnswer::kTaken) || (one == NmtAnswer::kOtherDevice)) ? answer : one;
    }
    answer = (answer == NmtAnswer::kTaken) ? CommandOwn(NmtCommand::kStart, time) : answer;
    return (answer == NmtAnswer::kTaken) ? refusal : answer;
}

/// Without a node-ID of its own the master has no NMT state to change, and node 0 would be everybody.
NmtAnswer Cia302StartUp::CommandOwn(const NmtCommand command, const BootTime& time) noexcept
{
    const bool has_own = (parts_.setup.own.value != kAllNodes.value);
    const NmtAnswer answer = has_own ? parts_.nmt.Request(command, parts_.setup.own, time.now) : NmtAnswer::kTaken;
    const bool is_start = (command == NmtCommand::kStart);
    const bool was_operational = IsMasterOperational();
    if ((answer == NmtAnswer::kTaken) && is_start && (step_ != MasterStep::kIdle))
    {
        Go(MasterEvent::kStart, time.now);
        const bool is_due = parts_.setup.Has(kStartAllAtOnce) && !parts_.setup.Has(kApplicationStartsSlaves);
        if (is_due && !was_operational)
        {
            StartSlaves(time);
        }
    }
    else if ((answer == NmtAnswer::kTaken) && was_operational)
    {
        Go(MasterEvent::kLeave, time.now);
    }
    return answer;
}

NmtAnswer Cia302StartUp::CommandNode(const NmtCommand command, const NodeId node, const BootTime& time) noexcept
{
    const bool is_guarded =
        (command == NmtCommand::kStart) && parts_.setup.IsSafetySlave(node) && parts_.nmt.IsActive();
    const bool is_other = is_guarded && boot_.Record(node).status.is_other;
    const NmtAnswer guarded = is_other ? NmtAnswer::kOtherDevice : NmtAnswer::kTaken;
    const NmtAnswer answer = is_guarded ? guarded : parts_.nmt.Request(command, node, time.now);
    const bool is_listed = parts_.setup.IsListed(node);
    if (is_guarded && !is_other)
    {
        boot_.Start(node, time); // Verifies, whatever was verified before, and then starts.
    }
    else if ((answer == NmtAnswer::kTaken) && is_listed && IsReset(command) && (step_ != MasterStep::kIdle))
    {
        boot_.Await(node, time);
    }
    else if ((answer == NmtAnswer::kTaken) && is_listed)
    {
        boot_.Record(node).status.is_started = (command == NmtCommand::kStart);
        boot_.Record(node).is_start_owed = false;
    }
    return answer;
}

bool Cia302StartUp::Boot(const NodeId node, const Instant now) noexcept
{
    const BootTime time = Tick(now);
    const bool is_node = (node.value >= 1U) && (node.value <= kLastNode);
    const bool is_listed = parts_.setup.IsListed(node) && (step_ != MasterStep::kIdle);
    if (is_listed)
    {
        boot_.Ask(node, time);
    }
    else if (is_node && !parts_.setup.IsListed(node))
    {
        OnForeign(node, now);
    }
    return is_listed;
}

/// After a stop of all only orders start a slave. [SRS_BOOT_017]
bool Cia302StartUp::Resume(const NodeId node, const Instant now) noexcept
{
    const BootTime time = Tick(now);
    const bool is_going = (step_ != MasterStep::kIdle) && (step_ != MasterStep::kStopped);
    const bool is_one = parts_.setup.IsListed(node) && is_going;
    if (is_one)
    {
        boot_.Resume(node, time);
    }
    return is_one;
}

bool Cia302StartUp::Configure(const NodeId node, const Instant now) noexcept
{
    const BootTime time = Tick(now);
    constexpr auto kStopped = static_cast<std::uint8_t>(SlaveState::kStopped); // It has no SDO to be written by.
    const NodeStatus& status = boot_.Record(node).status;
    const bool is_other = parts_.setup.IsSafetySlave(node) && status.is_other;
    const bool is_free = parts_.setup.IsListed(node) && (step_ != MasterStep::kIdle) && !is_other && !status.is_busy &&
                         (parts_.table.RequestValue(node) != kStopped);
    if (is_free)
    {
        boot_.Configure(node, time);
    }
    return is_free;
}

} // namespace counterpoint::cia302
