// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_nmt.hpp"

#include "canopen/start_up/cia302/boot_identity.hpp"
#include "canopen/start_up/cia302/boot_writer.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint64_t kUsPerMs = 1000U;

/// Letter of an identity that differs, as where the start-up itself finds it.
char LetterOf(const ObjectAddress& object) noexcept
{
    constexpr std::uint8_t kSubs = 5U;
    constexpr char kLetters[kSubs] = {'C', 'D', 'M', 'N', 'O'}; // 1000h is sub-index 0, 1018h has the others.
    return (object.sub < kSubs) ? kLetters[object.sub] : 'J';
}

} // namespace

BootFinding BootNmt::Restart(const BootJob& job) noexcept
{
    return (job.record.state == BootState::kResetDue) ? Send(job) : AwaitBootUp(job);
}

BootFinding BootNmt::Send(const BootJob& job) noexcept
{
    const bool is_taken = (parts_.nmt.Request(NmtCommand::kResetNode, job.node, job.time.now) == NmtAnswer::kTaken);
    return Found(is_taken ? BootEvent::kDone : BootEvent::kNone);
}

/// What follows if the boot-up message does not come.
BootFinding BootNmt::AwaitBootUp(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    const bool is_unasked = ((state == BootState::kStateReset) && IsStateUnasked(job)) ||
                            ((state == BootState::kRestored) && IsRestoreUnasked(job));
    BootFinding finding = Found(BootEvent::kNone);
    if (is_unasked)
    {
        finding = Found(BootEvent::kSkip);
    }
    else if ((state == BootState::kUnheard) || !IsSilent(job))
    {
        // It is still waited for.
    }
    else if (state == BootState::kResetSent)
    {
        const bool is_called_for = job.setup.Has(kMandatory) || job.setup.Has(kKeepAlive);
        finding = Found(is_called_for ? BeginOf(job.setup) : BootEvent::kSilence);
    }
    else if (state == BootState::kStateReset)
    {
        job.record.is_fresh = true; // It is not reset a second time.
        finding = Found(BootEvent::kSilence);
    }
    else
    {
        job.record.status.ForgetObject(); // No SDO is unanswered. [SRS_BOOT_471]
        job.record.status.abort = SdoAbort::kTimeOut;
        finding = Failed('J');
    }
    return finding;
}

/// No boot-up message in its time, which begins when the reset has left. The message has the lowest priority on the
/// bus: behind the SDOs of all other slaves.
bool BootNmt::IsSilent(const BootJob& job) noexcept
{
    if (parts_.nmt.Waiting() != 0U)
    {
        job.record.since_us = job.time.clock_us;
    }
    const std::uint64_t slow_us = std::uint64_t{kCrowdedTimeOuts} * parts_.sdo.TimeOutUs();
    const std::uint64_t crowded_us = (slow_us > kCrowdedUs) ? slow_us : kCrowdedUs;
    return job.IsOver(kResetUs) && (!parts_.sdo.IsBusy() || job.IsOver(crowded_us));
}

BootFinding BootNmt::Release(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    BootFinding finding = Found(BootEvent::kNone);
    if (state == BootState::kWatch)
    {
        finding = Watch(job);
    }
    else if (state == BootState::kWatched)
    {
        finding = AwaitSign(job);
    }
    else if (state == BootState::kGateBusy)
    {
        finding = AwaitGate(job);
    }
    else
    {
        finding = Verify(job);
    }
    return finding;
}

/// Its first answer would be right once more: who was lost again and again because no further one was ends here, and is
/// not reset for ever. [SRS_BOOT_026]
BootFinding BootNmt::Watch(const BootJob& job) noexcept
{
    const bool is_stuck = (parts_.table.Record(job.node).untoggled >= kMostUntoggled);
    parts_.table.WatchAsSetUp(job.node, job.time.now);
    const NodeRecord& record = parts_.table.Record(job.node);
    BootFinding finding = Found((record.watch == cia302::Watch::kNone) ? BootEvent::kSkip : BootEvent::kDone);
    if (is_stuck && (record.watch == cia302::Watch::kGuarding))
    {
        job.record.status.abort = SdoAbort::kToggle;
        finding = Failed('K');
    }
    return finding;
}

/// The slave must show a heartbeat, or answer a remote frame; the boot-up message is none.
BootFinding BootNmt::AwaitSign(const BootJob& job) const noexcept
{
    const std::uint64_t guarded_us = kUsPerMs * job.setup.GuardTimeMs() * job.setup.RetryFactor();
    const std::uint64_t beaten_us = kUsPerMs * job.setup.heartbeat.consumer_ms;
    const std::uint64_t limit_us = (beaten_us == 0U) ? guarded_us : beaten_us;
    BootFinding finding = Found(BootEvent::kNone);
    if ((limit_us == 0U) || (parts_.table.Record(job.node).beats != job.record.beats))
    {
        finding = Found(BootEvent::kDone);
    }
    else if (job.IsOver(limit_us))
    {
        finding = Failed('K');
    }
    return finding;
}

BootFinding BootNmt::Verify(const BootJob& job) noexcept
{
    const bool is_open = (parts_.gate.State(job.node) == GateState::kOpen); // As for each that is no safety slave.
    if (!is_open)
    {
        parts_.gate.Verify(job.node, job.time.now);
    }
    return Found(is_open ? BootEvent::kSkip : BootEvent::kDone);
}

BootFinding BootNmt::AwaitGate(const BootJob& job) noexcept
{
    const GateState state = parts_.gate.State(job.node);
    BootFinding finding = Found(BootEvent::kNone);
    if (state == GateState::kOpen) // Also when it is a safety slave no more.
    {
        finding = Found(BootEvent::kDone);
    }
    else if ((state == GateState::kDiffers) || (state == GateState::kFailed))
    {
        finding = Refuse(job);
    }
    else if (state == GateState::kClosed)
    {
        finding = Found(BootEvent::kElse);
    }
    return finding;
}

/// A slave that runs with a configuration that is not the expected one is stopped, and so are two devices of one
/// node-ID: what is known of their state may be said of the other one. So is one that never told its state, and one
/// that was found running: what it said since may be of before.
BootFinding BootNmt::Refuse(const BootJob& job) noexcept
{
    const GateFinding found = parts_.gate.Finding(job.node);
    const bool is_doubted = (found.object.index == 0U);
    const NodeRecord& heard = parts_.table.Record(job.node);
    const bool is_running =
        is_doubted || job.record.was_operational || (heard.state == SlaveState::kOperational) || (heard.beats == 0U);
    const bool is_done = !is_running || (parts_.nmt.Halt(job.node, job.time.now) == NmtAnswer::kTaken);
    BootFinding finding = Found(BootEvent::kNone);
    if (is_done)
    {
        job.record.status.Take(found);
        job.record.status.is_started = false;
        job.record.was_operational = false;
        finding = Failed(parts_.gate.IsOther(job.node) ? LetterOf(found.object) : 'J');
    }
    return finding;
}

/// Started, or left as it is: with L it runs unless somebody stopped it and asks for a start, and 1F80h may leave it to
/// others. One that a command holds is not started: the later order counts. [SRS_BOOT_030]
BootFinding BootNmt::Start(const BootJob& job, const bool is_master_operational) noexcept
{
    const bool is_alone = !parts_.setup.Has(kStartAllAtOnce) || is_master_operational;
    const bool is_booting = !job.record.is_extra && job.setup.Has(kBootSlave);
    const bool is_left = parts_.setup.Has(kApplicationStartsSlaves) || job.record.was_operational;
    const bool is_due = is_booting && !is_left && is_alone && !job.record.is_held;
    BootEvent event = BootEvent::kFinished;
    if (is_due || job.record.is_start_wanted)
    {
        const NmtAnswer answer = parts_.nmt.Request(NmtCommand::kStart, job.node, job.time.now);
        event = (answer == NmtAnswer::kNotVerified) ? BootEvent::kElse : BootEvent::kNone;
        if (answer == NmtAnswer::kTaken)
        {
            job.record.NoteCommand(true, parts_.nmt.IsStarting(job.node), parts_.nmt.IsLeaving(job.node));
            job.record.was_operational = false;
            event = BootEvent::kFinished;
        }
    }
    return Found(event);
}

} // namespace counterpoint::cia302
