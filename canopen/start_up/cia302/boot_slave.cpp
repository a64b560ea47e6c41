// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_slave.hpp"

namespace counterpoint::cia302
{
namespace
{

/// More states than a boot passes in one call: it ends also if two states handed a boot to each other.
constexpr std::uint8_t kMaxStatesPerCall = 32U;

/// It is another device than the expected one, or never said which it is.
bool IsOfIdentity(const char letter) noexcept
{
    return (letter == 'B') || (letter == 'C') || (letter == 'D') || (letter == 'M') || (letter == 'N') ||
           (letter == 'O');
}

/// These lead to a state from everywhere: its step begins, whatever the step was.
bool IsOrder(const BootEvent event) noexcept
{
    return (event == BootEvent::kBegin) || (event == BootEvent::kBeginUnasked) || (event == BootEvent::kAwait) ||
           (event == BootEvent::kReset) || (event == BootEvent::kConfigure) || (event == BootEvent::kVerify);
}

} // namespace

BootSlave::BootSlave(const StartUpParts& parts, BootRecord* const records, BootListener& listener) noexcept
    : parts_(parts), records_(records), listener_(listener), nmt_(parts), identity_(parts), writer_(parts)
{
}

BootRecord& BootSlave::Record(const NodeId node) noexcept
{
    return records_[node.value & kLastNode];
}

const BootRecord& BootSlave::Record(const NodeId node) const noexcept
{
    return records_[node.value & kLastNode];
}

bool BootSlave::IsRefused(const NodeId node) const noexcept
{
    const BootRecord& record = Record(node);
    const bool is_ended = !record.status.is_busy && !record.status.is_started && record.HasFailed();
    return parts_.setup.IsListed(node) && !parts_.setup.IsSafetySlave(node) && is_ended;
}

BootJob BootSlave::JobOf(const NodeId node, const BootTime& time) noexcept
{
    return BootJob{node, Record(node), parts_.setup.Slave(node), time};
}

/// The boot begins from nothing; what ran is given up. What a command holds stays so: only an order ends that, for a
/// boot-up message does not say whether it is behind the command, and whose reset it follows. [SRS_BOOT_033]
void BootSlave::Clear(const BootJob& job) noexcept
{
    const bool is_at_once = (job.setup.heartbeat.arming == Arming::kImmediately);
    const std::uint16_t watched_ms = is_at_once ? job.setup.heartbeat.consumer_ms : std::uint16_t{0U};
    parts_.table.WatchHeartbeat(job.node, watched_ms, Arming::kImmediately, job.time.now); // Others are not watched.
    parts_.gate.Close(job.node);
    parts_.nmt.DropStarts(job.node);
    Forget(job.node);
    job.record.began_us = job.time.clock_us;
    job.record.status.is_busy = true;
}

void BootSlave::Ask(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    Clear(job);
    job.record.is_end_waiting = false; // It is there, and runs no more.
    Go(job, BeginOf(job.setup));
    OnCycle(node, time);
}

void BootSlave::AskAgain(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    const bool is_start_wanted = job.record.is_start_wanted;
    Clear(job);
    job.record.is_start_wanted = is_start_wanted;
    Go(job, BeginOf(job.setup));
    OnCycle(node, time);
}

void BootSlave::Resume(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    Clear(job);
    job.record.is_fresh = true;
    job.record.is_resumed = true;
    Go(job, BeginOf(job.setup));
    OnCycle(node, time);
}

void BootSlave::Await(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    Clear(job);
    Go(job, BootEvent::kAwait);
}

/// What runs goes on, and ends without a start; one that it does not answer is not woken. [SRS_BOOT_030]
void BootSlave::Hold(const NodeId node) noexcept
{
    BootRecord& record = Record(node);
    record.is_held = true;
    record.is_start_wanted = false;
    record.is_start_owed = false;
    record.is_unread = false;
}

void BootSlave::Free(const NodeId node) noexcept
{
    Record(node).is_held = false;
}

void BootSlave::Release(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    job.record.is_held = false;
    if (!job.record.status.is_busy && (job.record.status.step == StartUpStep::kManual))
    {
        EnterStep(job, StartUpStep::kDone);
    }
}

void BootSlave::Reset(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    Clear(job);
    Go(job, BootEvent::kReset);
    OnCycle(node, time);
}

void BootSlave::OnBootUp(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    const bool is_awaited = job.record.IsAwaitingBootUp();
    const BootState state = job.record.state;
    const bool is_in_boot = is_awaited && (state != BootState::kResetSent) && (state != BootState::kUnheard);
    const std::uint8_t updates = job.record.updates;
    const HeartbeatSetup& heartbeat = job.setup.heartbeat;
    if (!is_awaited)
    {
        Clear(job);
    }
    job.record.updates = updates; // Or a slave that restarts within each update would be cleared without end.
    job.record.is_fresh = true;
    job.record.status.is_started = false;
    if (heartbeat.arming == Arming::kBootUp)
    {
        parts_.table.WatchHeartbeat(node, heartbeat.consumer_ms, Arming::kBootUp, time.now);
    }
    if (state == BootState::kRestored)
    {
        // Who runs and is reset by its new configuration (1F25h) is supervised, verified and started again.
        // [SRS_NMM_153]
        job.record.is_extra = job.record.is_extra && !job.record.is_booted;
        job.record.was_operational = false;
        if (!job.record.is_extra)
        {
            job.record.status.has_ended = false;
        }
    }
    Go(job, is_in_boot ? BootEvent::kBootUp : BeginOf(job.setup));
    OnCycle(node, time);
}

void BootSlave::Configure(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    End(node);
    job.record.status.is_busy = true;
    job.record.is_extra = true;
    Go(job, BootEvent::kConfigure);
    OnCycle(node, time);
}

void BootSlave::Start(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    job.record.is_start_wanted = true;
    job.record.is_held = false;
    if (!job.record.status.is_busy)
    {
        parts_.gate.Close(node); // What was verified at the boot may be long ago.
        if (cia302::IsStopped(parts_.table, node) && parts_.setup.IsSafetySlave(node))
        {
            // STOPPED, it has no SDO to be read by.
            static_cast<void>(parts_.nmt.Request(NmtCommand::kPreOperational, node, time.now));
        }
        job.record.status.is_busy = true;
        job.record.is_extra = true;
        Go(job, BootEvent::kVerify);
        OnCycle(node, time);
    }
}

void BootSlave::Verify(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    parts_.gate.Close(node); // What was verified before it ran may be long ago.
    job.record.was_operational = true;
    job.record.status.is_busy = true;
    job.record.is_extra = true;
    Go(job, BootEvent::kVerify);
    OnCycle(node, time);
}

void BootSlave::TakeOver(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    Clear(job);
    job.record.is_end_waiting = false;
    job.record.was_operational = true;
    job.record.status.is_started = true;
    Go(job, BootEvent::kBeginUnasked);
    OnCycle(node, time);
}

/// What an earlier boot found holds no more: neither a start nor a writing may lean on it.
void BootSlave::Doubt(const NodeId node, const BootTime& time) noexcept
{
    BootRecord& record = Record(node);
    parts_.nmt.DropStarts(node);
    End(node);
    parts_.gate.Close(node);
    record.is_booted = false;
    record.status.has_ended = false;
    record.status.is_started = false;
    record.is_end_waiting = false;
    record.status.is_other = true;
    parts_.listener.OnNodeStatus(node, time.now);
}

void BootSlave::End(const NodeId node) noexcept
{
    const bool is_verifying = (Record(node).state == BootState::kGateBusy);
    Rest(node, BootEvent::kGivenUp);
    if (is_verifying)
    {
        parts_.gate.Close(node);
    }
}

void BootSlave::Forget(const NodeId node) noexcept
{
    End(node);
    BootRecord& record = Record(node);
    const bool is_held = record.is_held;
    const bool is_end_waiting = record.IsSeenStarted() && parts_.nmt.IsLeaving(node);
    record = BootRecord{};
    record.is_held = is_held;
    record.is_end_waiting = is_end_waiting;
}

/// Nothing runs any more; the gate keeps what it found.
void BootSlave::Rest(const NodeId node, const BootEvent event) noexcept
{
    BootRecord& record = Record(node);
    if (record.is_transferring)
    {
        parts_.sdo.Cancel(node, SdoAbort::kGeneral);
    }
    record.state = Next(record.state, event);
    record.is_transferring = false;
    record.status.is_busy = false;
    record.is_extra = false;
    record.is_start_wanted = false;
    record.is_start_owed = false;
}

/// The next state, and what is done as it is entered.
void BootSlave::Go(const BootJob& job, const BootEvent event) noexcept
{
    const BootRow& before = RowOf(job.record.state);
    job.record.state = Next(job.record.state, event);
    const BootRow& after = RowOf(job.record.state);
    if (IsOrder(event) || (after.step != before.step))
    {
        EnterStep(job, after.step);
    }
    if (!ActsAtOnce(after.state))
    {
        job.record.since_us = job.time.clock_us;
        job.record.beats = parts_.table.Record(job.node).beats;
    }
    if (after.state == BootState::kUnheard)
    {
        parts_.table.SetMissing(job.node);
    }
}

void BootSlave::EnterStep(const BootJob& job, const StartUpStep step) noexcept
{
    job.record.status.step = step;
    job.record.is_transferring = false;
    job.record.checks = 0U;
    job.record.position = ConcisePosition{};
    job.record.offset = 0U;
    const bool is_end = (step == StartUpStep::kDone) || (step == StartUpStep::kManual);
    const bool is_new_look = !is_end && (job.record.status.letter == '\0');
    if (is_new_look) // What an earlier step read belongs to that step.
    {
        job.record.status.ForgetObject();
    }
    parts_.listener.OnNodeStatus(job.node, job.time.now);
}

/// A slave that failed is not supervised: it has nothing to lose. But one that failed in an extra still runs.
void BootSlave::Fail(const BootJob& job, const char letter) noexcept
{
    const bool is_extra = job.record.is_extra;
    const bool was_booted = job.record.is_booted && is_extra && (job.record.status.step != StartUpStep::kSafety);
    job.record.status.letter = letter;
    job.record.identity = IsOfIdentity(letter) ? letter : job.record.identity;
    job.record.status.is_other = job.record.status.is_other || IsOfIdentity(letter);
    job.record.is_booted = was_booted;
    if (!is_extra)
    {
        job.record.status.has_ended = true;
    }
    Rest(job.node, BootEvent::kFailed);
    if (!was_booted)
    {
        parts_.table.Unwatch(job.node);
    }
    parts_.listener.OnNodeStatus(job.node, job.time.now);
    if (!was_booted)
    {
        listener_.OnBootFailed(job.node, job.time);
    }
}

void BootSlave::Finish(const BootJob& job) noexcept
{
    const bool is_boot = !job.record.is_extra;
    const char before = job.record.status.letter;
    job.record.is_booted = job.record.is_booted || is_boot;
    if (is_boot)
    {
        job.record.status.has_ended = true;
    }
    job.record.updates = is_boot ? std::uint8_t{0U} : job.record.updates;
    // An extra does not heal what it did not do: a slave of another vendor that runs is still one.
    const bool is_repaired = is_boot || (before == 'J') || (before == 'L') || (before == '\0');
    const char good = job.record.was_operational ? 'L' : '\0';
    job.record.status.letter = is_repaired ? good : before;
    if ((before == 'J') && (job.record.identity != '\0'))
    {
        job.record.status.letter = job.record.identity;
        job.record.status.object = ObjectAddress{0U, 0U}; // That was J's.
    }
    Rest(job.node, BootEvent::kFinished);
    EnterStep(job, (is_boot && job.record.is_held) ? StartUpStep::kManual : StartUpStep::kDone);
    if (is_boot)
    {
        listener_.OnBooted(job.node, job.time);
    }
}

void BootSlave::OnCycle(const NodeId node, const BootTime& time) noexcept
{
    const BootJob job = JobOf(node, time);
    bool is_going = job.record.status.is_busy;
    for (std::uint8_t i = 0U; is_going && (i < kMaxStatesPerCall); ++i)
    {
        const BootFinding finding = Work(job);
        Act(job, finding);
        is_going = (finding.event != BootEvent::kNone) && job.record.status.is_busy && ActsAtOnce(job.record.state);
    }
}

void BootSlave::Act(const BootJob& job, const BootFinding& finding) noexcept
{
    if (finding.event == BootEvent::kFailed)
    {
        Fail(job, finding.letter);
    }
    else if (finding.event == BootEvent::kFinished)
    {
        Finish(job);
    }
    else if (finding.event != BootEvent::kNone)
    {
        Go(job, finding.event);
    }
}

/// What the state has to do in this call, and what came of it.
BootFinding BootSlave::Work(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    const StartUpStep step = RowOf(state).step;
    const bool is_ours = job.record.IsAwaitingBootUp() && (state != BootState::kProgramStarted);
    BootFinding finding = Found(BootEvent::kNone);
    if (is_ours || (state == BootState::kResetDue))
    {
        finding = nmt_.Restart(job);
    }
    else if (step == StartUpStep::kSoftwareVersion)
    {
        finding = writer_.Check(job);
    }
    else if (step == StartUpStep::kSoftwareUpdate)
    {
        finding = writer_.Update(job);
    }
    else if ((step == StartUpStep::kConfigurationDate) || (step == StartUpStep::kRestore) ||
             (step == StartUpStep::kConfigure))
    {
        finding = writer_.Configure(job);
    }
    else if ((step == StartUpStep::kErrorControl) || (step == StartUpStep::kSafety))
    {
        finding = nmt_.Release(job);
    }
    else if (step == StartUpStep::kStart)
    {
        finding = nmt_.Start(job, listener_.IsMasterOperational());
    }
    else
    {
        finding = identity_.Work(job);
    }
    return finding;
}

} // namespace counterpoint::cia302
