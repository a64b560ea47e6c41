// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The slave is there, is the one that is expected, and may be reset: letters B to F and M to O.
#include "canopen/start_up/cia302/boot_slave.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint64_t kUsPerMs = 1000U;
constexpr ObjectAddress kDeviceTypeObject{0x1000U, 0U};
constexpr std::uint16_t kIdentityIndex = 0x1018U;

/// The step behind each of the numbers of 1018h.
StartUpStep StepAfter(const std::uint8_t sub) noexcept
{
    StartUpStep step = StartUpStep::kStateCheck;
    switch (sub)
    {
    case 1U:
        step = StartUpStep::kProductCode;
        break;
    case 2U:
        step = StartUpStep::kRevisionNumber;
        break;
    case 3U:
        step = StartUpStep::kSerialNumber;
        break;
    default:
        break;
    }
    return step;
}

} // namespace

/// What an earlier boot found holds no more: neither a start nor a writing may lean on it.
void BootSlave::Doubt(const NodeId node, const BootTime& time) noexcept
{
    BootRecord& record = Record(node);
    parts_.nmt.DropStarts(node);
    End(node);
    parts_.gate.Close(node);
    record.is_booted = false;
    record.status.is_started = false;
    record.status.is_other = true;
    parts_.listener.OnNodeStatus(node, time.now);
}

/// No boot-up message in its time, which begins when the reset has left. The message has the lowest priority on the
/// bus: behind the SDOs of all other slaves.
bool BootSlave::IsSilent(const Job& job) noexcept
{
    if (parts_.nmt.Waiting() != 0U)
    {
        job.record.since_us = job.time.clock_us;
    }
    const std::uint64_t slow_us = std::uint64_t{kCrowdedTimeOuts} * parts_.sdo.TimeOutUs();
    const std::uint64_t crowded_us = (slow_us > kCrowdedUs) ? slow_us : kCrowdedUs;
    return IsOver(job, kResetUs) && (!parts_.sdo.IsBusy() || IsOver(job, crowded_us));
}

/// Part 0 sends the reset, part 1 waits for the boot-up message.
void BootSlave::AwaitReset(const Job& job) noexcept
{
    if (job.record.part == 0U)
    {
        const NmtAnswer answer = parts_.nmt.Request(NmtCommand::kResetNode, job.node, job.time.now);
        if (answer == NmtAnswer::kTaken)
        {
            job.record.part = 1U;
            Wait(job, BootWait::kBootUp);
        }
    }
    else if (IsSilent(job))
    {
        const bool is_called_for = job.setup.Has(kMandatory) || job.setup.Has(kKeepAlive);
        const StartUpStep first = job.setup.Has(kBootSlave) ? StartUpStep::kDeviceType : StartUpStep::kErrorControl;
        Enter(job, is_called_for ? first : StartUpStep::kWaitBootUp);
        if (!is_called_for)
        {
            job.record.wait = BootWait::kBootUp;
            parts_.table.SetMissing(job.node);
        }
    }
}

/// STOPPED, it has no SDO to be asked by, and may send nothing that tells so, or not yet. One command for each try: a
/// lane for it may have to be waited for. Who was stopped in the middle of this boot stays so.
void BootSlave::WakeUp(const Job& job) noexcept
{
    const NodeRecord& heard = parts_.table.Record(job.node);
    const bool is_stopped = (heard.asked == SlaveState::kStopped) && !parts_.table.RunsSurely(job.node);
    const bool is_deaf = (heard.state == SlaveState::kStopped) || is_stopped;
    const auto this_try = static_cast<std::uint16_t>(job.record.part + 1U);
    const bool is_first = (job.record.checks == 0U);
    const bool is_held = !is_first && (heard.asked == SlaveState::kStopped);
    if ((job.record.wait == BootWait::kNothing) && (job.record.checks != this_try))
    {
        job.record.checks = this_try;
        if (is_deaf && !is_held)
        {
            static_cast<void>(parts_.nmt.Request(NmtCommand::kPreOperational, job.node, job.time.now));
        }
    }
}

/// Asked for until there is an answer; of a mandatory slave only as long as 1F89h allows.
void BootSlave::ReadDeviceType(const Job& job) noexcept
{
    const std::uint64_t limit_us = kUsPerMs * parts_.setup.boot_time_ms;
    const bool is_limited = job.setup.Has(kMandatory) && (limit_us > 0U);
    if (job.record.wait == BootWait::kTime)
    {
        const bool is_too_late = is_limited && ((job.time.clock_us - job.record.began_us) >= limit_us);
        if (is_too_late)
        {
            Fail(job, 'B');
        }
        else if (IsOver(job, kAskAgainUs - 1U))
        {
            job.record.wait = BootWait::kNothing;
            ++job.record.part; // Asks in this very call.
        }
    }
    else
    {
        WakeUp(job);
        const Got got = Fetch(job, kDeviceTypeObject);
        const bool is_expected = (job.setup.device_type == 0U) || (job.record.status.read == job.setup.device_type);
        if (got == Got::kRefused)
        {
            StopUnread(job);
            const SdoOutcome outcome = parts_.sdo.Outcome(job.node);
            if ((outcome.abort == SdoAbort::kTimeOut) && !outcome.by_server) // Who refuses, or errs, is there.
            {
                parts_.table.SetMissing(job.node);
            }
            Wait(job, BootWait::kTime);
        }
        else if ((got == Got::kDone) && !is_expected)
        {
            job.record.status.expected = job.setup.device_type;
            Fail(job, 'C');
        }
        else if (got == Got::kDone)
        {
            Enter(job, StartUpStep::kVendorId);
        }
    }
}

/// A safety slave that runs and cannot be read is stopped, and asked on in PRE-OPERATIONAL. [SRS_SFS_006]
void BootSlave::StopUnread(const Job& job) noexcept
{
    const bool is_ours = job.record.is_unread && (parts_.table.Record(job.node).asked == SlaveState::kStopped);
    const bool is_running = parts_.setup.IsSafetySlave(job.node) && parts_.table.RunsSurely(job.node);
    if (is_ours || is_running) // A full queue: at the next silence.
    {
        const NmtCommand command = is_running ? NmtCommand::kStop : NmtCommand::kPreOperational;
        const NmtAnswer answer = parts_.nmt.Request(command, job.node, job.time.now);
        job.record.is_unread = (answer == NmtAnswer::kTaken) ? is_running : job.record.is_unread;
    }
}

void BootSlave::Compare(const Job& job, const std::uint8_t sub, const std::uint32_t expected,
                        const char letter) noexcept
{
    const Got got = (expected == 0U) ? Got::kDone : Fetch(job, ObjectAddress{kIdentityIndex, sub});
    const bool is_wrong = (expected != 0U) && (got == Got::kDone) && (job.record.status.read != expected);
    if ((got == Got::kRefused) || is_wrong)
    {
        job.record.status.expected = expected;
        Fail(job, letter);
    }
    else if (got == Got::kDone)
    {
        Enter(job, StepAfter(sub));
    }
}

/// Only slaves that are kept alive, and only if they have not just booted up.
void BootSlave::CheckState(const Job& job) noexcept
{
    const bool has_heartbeat = (job.setup.heartbeat.consumer_ms > 0U);
    if (!job.setup.Has(kKeepAlive) || job.record.is_fresh)
    {
        Enter(job, StartUpStep::kSoftwareVersion);
    }
    else if (job.record.wait == BootWait::kSign)
    {
        TakeState(job);
    }
    else if (job.record.wait == BootWait::kBootUp)
    {
        if (IsSilent(job))
        {
            job.record.is_fresh = true; // It is not reset a second time.
            Enter(job, StartUpStep::kDeviceType);
        }
    }
    else if (has_heartbeat || parts_.table.AskState(job.node))
    {
        Wait(job, BootWait::kSign);
    }
}

/// A sign came, or none within its time; then a slave that does not run is reset.
void BootSlave::TakeState(const Job& job) noexcept
{
    const NodeRecord& heard = parts_.table.Record(job.node);
    const bool has_heartbeat = (job.setup.heartbeat.consumer_ms > 0U);
    const std::uint64_t limit_us = has_heartbeat ? (kUsPerMs * job.setup.heartbeat.consumer_ms) : kGuardAnswerUs;
    if (heard.beats == job.record.beats)
    {
        if (IsOver(job, limit_us))
        {
            Fail(job, has_heartbeat ? 'E' : 'F');
        }
    }
    else if (heard.state == SlaveState::kOperational)
    {
        job.record.was_operational = true;
        job.record.status.is_started = true;
        Enter(job, StartUpStep::kErrorControl);
    }
    else if (parts_.nmt.Request(NmtCommand::kResetCommunication, job.node, job.time.now) == NmtAnswer::kTaken)
    {
        Wait(job, BootWait::kBootUp);
    }
}

} // namespace counterpoint::cia302
