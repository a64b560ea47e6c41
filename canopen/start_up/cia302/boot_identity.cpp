// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_identity.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint64_t kUsPerMs = 1000U;
constexpr ObjectAddress kDeviceTypeObject{0x1000U, 0U};
constexpr std::uint16_t kIdentityIndex = 0x1018U;

/// A number of 1018h: zero is not asked for.
struct Number
{
    std::uint8_t sub;
    std::uint32_t expected;
    char letter;
};

Number NumberOf(const BootState state, const SlaveSetup& setup) noexcept
{
    Number number{4U, setup.serial_number, 'O'};
    if (state == BootState::kVendorId)
    {
        number = Number{1U, setup.vendor_id, 'D'};
    }
    else if (state == BootState::kProductCode)
    {
        number = Number{2U, setup.product_code, 'M'};
    }
    else if (state == BootState::kRevisionNumber)
    {
        number = Number{3U, setup.revision_number, 'N'};
    }
    return number;
}

} // namespace

BootFinding BootIdentity::Work(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    BootFinding finding = Found(BootEvent::kNone);
    if ((state == BootState::kTypeFirst) || (state == BootState::kTypeAgain))
    {
        finding = WakeUp(job);
    }
    else if (state == BootState::kType)
    {
        finding = ReadDeviceType(job);
    }
    else if (state == BootState::kTypePause)
    {
        finding = Pause(job);
    }
    else if (state == BootState::kStateAsk)
    {
        finding = AskState(job);
    }
    else if (state == BootState::kStateSign)
    {
        finding = TakeState(job);
    }
    else
    {
        finding = Compare(job);
    }
    return finding;
}

/// STOPPED, it has no SDO to be asked by, and may send nothing that tells so, or not yet. One command for each try: a
/// lane for it may have to be waited for. Who was stopped in the middle of this boot stays so, and so does who is held
/// by a stop: a boot-up message behind it does not say whether the slave has obeyed. [SRS_BOOT_030]
BootFinding BootIdentity::WakeUp(const BootJob& job) noexcept
{
    const NodeRecord& heard = parts_.table.Record(job.node);
    const bool is_first = (job.record.state == BootState::kTypeFirst);
    const bool was_stopped = !is_first && (heard.asked == SlaveState::kStopped);
    const bool is_held = job.record.is_held && (heard.asked != SlaveState::kPreOperational);
    if (IsStopped(parts_.table, job.node) && !was_stopped && !is_held)
    {
        static_cast<void>(parts_.nmt.Request(NmtCommand::kPreOperational, job.node, job.time.now));
    }
    return Found(BootEvent::kDone);
}

BootFinding BootIdentity::ReadDeviceType(const BootJob& job) noexcept
{
    const Got got = transfer_.Fetch(job, kDeviceTypeObject);
    const bool is_too_long = (got == Got::kRefused) && IsTooLong(parts_.sdo.Outcome(job.node));
    const bool is_compared = (job.setup.device_type != 0U);
    const bool is_wrong = is_too_long || ((got == Got::kDone) && (job.record.status.read != job.setup.device_type));
    BootFinding finding = Found(BootEvent::kNone);
    if (is_compared && is_wrong)
    {
        job.record.status.expected = job.setup.device_type;
        job.record.status.abort = is_too_long ? SdoAbort::kLengthMismatch : SdoAbort::kNone;
        finding = Failed('C');
    }
    else if ((got == Got::kDone) || is_too_long)
    {
        job.record.status.abort = SdoAbort::kNone;
        finding = Found(BootEvent::kDone);
    }
    else if (got == Got::kRefused)
    {
        const bool is_ours = job.record.is_unread && (parts_.table.Record(job.node).asked == SlaveState::kStopped);
        reader_.StopUnread(job.record.is_unread, job.node, is_ours, job.time.now);
        const SdoOutcome outcome = parts_.sdo.Outcome(job.node);
        if ((outcome.abort == SdoAbort::kTimeOut) && !outcome.by_server) // Who refuses, or errs, is there.
        {
            parts_.table.SetMissing(job.node);
        }
        parts_.listener.OnNodeStatus(job.node, job.time.now); // There may be no letter, ever.
        finding = Found(BootEvent::kElse);
    }
    else
    {
        // It is waited for.
    }
    return finding;
}

/// Asked for until there is an answer; of a mandatory slave only as long as 1F89h allows.
BootFinding BootIdentity::Pause(const BootJob& job) const noexcept
{
    const std::uint64_t limit_us = kUsPerMs * parts_.setup.boot_time_ms;
    const bool is_limited = job.setup.Has(kMandatory) && (limit_us > 0U);
    const bool is_too_late = is_limited && ((job.time.clock_us - job.record.began_us) >= limit_us);
    const bool is_over = job.IsOver(kAskAgainUs - 1U);
    return is_too_late ? Failed('B') : Found(is_over ? BootEvent::kDone : BootEvent::kNone);
}

BootFinding BootIdentity::Compare(const BootJob& job) noexcept
{
    const Number number = NumberOf(job.record.state, job.setup);
    const bool is_asked = (number.expected != 0U);
    const Got got = is_asked ? transfer_.Fetch(job, ObjectAddress{kIdentityIndex, number.sub}) : Got::kDone;
    const bool is_too_long = is_asked && (got == Got::kRefused) && IsTooLong(parts_.sdo.Outcome(job.node));
    const bool is_wrong = is_asked && (got == Got::kDone) && (job.record.status.read != number.expected);
    const bool is_failed = (got == Got::kRefused) || is_wrong;
    if (is_failed)
    {
        job.record.status.expected = number.expected;
        job.record.status.abort = is_too_long ? SdoAbort::kLengthMismatch : job.record.status.abort;
    }
    const BootEvent event = (got == Got::kDone) ? BootEvent::kDone : BootEvent::kNone;
    return is_failed ? Failed(number.letter) : Found(event);
}

/// Only slaves that are kept alive, and only if they have not just booted up.
BootFinding BootIdentity::AskState(const BootJob& job) noexcept
{
    BootEvent event = BootEvent::kNone;
    if (IsStateUnasked(job))
    {
        event = BootEvent::kSkip;
    }
    else if ((job.setup.heartbeat.consumer_ms > 0U) || parts_.table.AskState(job.node))
    {
        event = BootEvent::kDone;
    }
    return Found(event);
}

/// A sign came, or none within its time; then a slave that does not run is reset.
BootFinding BootIdentity::TakeState(const BootJob& job) noexcept
{
    const NodeRecord& heard = parts_.table.Record(job.node);
    const bool has_heartbeat = (job.setup.heartbeat.consumer_ms > 0U);
    const std::uint64_t limit_us = has_heartbeat ? (kUsPerMs * job.setup.heartbeat.consumer_ms) : kGuardAnswerUs;
    BootFinding finding = Found(BootEvent::kNone);
    if (IsStateUnasked(job))
    {
        finding = Found(BootEvent::kSkip);
    }
    else if (heard.beats == job.record.beats)
    {
        finding = job.IsOver(limit_us) ? Failed(has_heartbeat ? 'E' : 'F') : finding;
    }
    else if (heard.state == SlaveState::kOperational)
    {
        job.record.was_operational = true;
        job.record.status.is_started = true;
        finding = Found(BootEvent::kDone);
    }
    else if (parts_.nmt.Request(NmtCommand::kResetCommunication, job.node, job.time.now) == NmtAnswer::kTaken)
    {
        finding = Found(BootEvent::kElse);
    }
    return finding;
}

} // namespace counterpoint::cia302
