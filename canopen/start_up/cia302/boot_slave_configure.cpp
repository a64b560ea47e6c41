// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The slave is configured, supervised, verified and started: letters J and K.
#include "canopen/start_up/cia302/boot_slave.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint64_t kUsPerMs = 1000U;
constexpr ObjectAddress kDate{0x1020U, 1U};
constexpr ObjectAddress kTime{0x1020U, 2U};
constexpr std::uint16_t kRestoreIndex = 0x1011U;
constexpr std::uint16_t kTextIndex = 0x1F20U;
constexpr std::uint16_t kConciseIndex = 0x1F22U;
constexpr std::uint8_t kLoad[4] = {0x6CU, 0x6FU, 0x61U, 0x64U}; ///< "load"
constexpr std::uint8_t kCommunicationSub = 2U;
constexpr std::uint8_t kStoppedByte = 4U; ///< As 1F82h reads it.

/// Letter of an identity that differs, as where the start-up itself finds it.
char LetterOf(const ObjectAddress& object) noexcept
{
    constexpr std::uint8_t kSubs = 5U;
    constexpr char kLetters[kSubs] = {'C', 'D', 'M', 'N', 'O'}; // 1000h is sub-index 0, 1018h has the others.
    return (object.sub < kSubs) ? kLetters[object.sub] : 'J';
}

} // namespace

/// Parts 0 and 1: date and time. A slave that does not tell them is configured.
void BootSlave::CompareDate(const Job& job) noexcept
{
    const std::uint32_t date = job.setup.configuration_date;
    const std::uint32_t time = job.setup.configuration_time;
    const bool is_date = (job.record.part == 0U);
    if ((date == 0U) || (time == 0U))
    {
        Enter(job, StartUpStep::kRestore);
    }
    else
    {
        const Got got = Fetch(job, is_date ? kDate : kTime);
        const bool is_same = (got == Got::kDone) && (job.record.status.read == (is_date ? date : time));
        if (is_same && is_date)
        {
            ++job.record.part;
        }
        else if (is_same)
        {
            Enter(job, StartUpStep::kErrorControl);
        }
        else if (got != Got::kNothingYet)
        {
            job.record.status.abort = SdoAbort::kNone;
            Enter(job, StartUpStep::kRestore);
        }
    }
}

/// Part 0: "load"; part 1: the reset that makes it come true; part 2: the boot-up message.
void BootSlave::Restore(const Job& job) noexcept
{
    const std::uint8_t sub = job.setup.restore_sub;
    if (!job.setup.Has(kRestoreDefaults) || (sub == 0U) || job.record.is_resumed)
    {
        Enter(job, StartUpStep::kConfigure);
    }
    else if (job.record.part == 0U)
    {
        const Got got = Put(job, ObjectAddress{kRestoreIndex, sub}, Bytes{kLoad, 4U}, SdoMode::kNormal);
        if (got == Got::kRefused)
        {
            Fail(job, 'J');
        }
        job.record.part = (got == Got::kDone) ? std::uint8_t{1U} : job.record.part;
    }
    else if (job.record.part == 1U)
    {
        const NmtCommand command =
            (sub == kCommunicationSub) ? NmtCommand::kResetCommunication : NmtCommand::kResetNode;
        if (parts_.nmt.Request(command, job.node, job.time.now) == NmtAnswer::kTaken)
        {
            job.record.part = 2U;
            Wait(job, BootWait::kBootUp);
        }
    }
    else if (IsSilent(job))
    {
        job.record.status.abort = SdoAbort::kTimeOut;
        Fail(job, 'J');
    }
}

/// Part 0: 1F20h, part 1: 1F22h.
void BootSlave::WriteConfiguration(const Job& job) noexcept
{
    if (job.record.part == 0U)
    {
        WriteText(job);
    }
    else
    {
        WriteConcise(job);
    }
}

/// Object by object. The text is read once for each: what runs needs to know only where it goes on.
void BootSlave::WriteText(const Job& job) noexcept
{
    if (job.record.wait == BootWait::kTransfer)
    {
        const Got got = Take(job);
        if (got == Got::kRefused)
        {
            Fail(job, 'J');
        }
        job.record.offset = (got == Got::kDone) ? job.record.next : job.record.offset;
    }
    else
    {
        const TextReading entry = ReadTextDcf(job.setup.dcf, job.record.offset, job.node);
        if (entry.state == TextState::kMalformed)
        {
            RefuseDomain(job, kTextIndex);
        }
        else if ((entry.state == TextState::kEnd) && !IsConcise(job.setup.concise_dcf))
        {
            RefuseDomain(job, kConciseIndex); // Before any of it is written.
        }
        else if (entry.state == TextState::kEnd)
        {
            job.record.part = 1U;
        }
        else
        {
            cia301::ToLittleEndian(entry.number, job.record.value, sizeof(job.record.value));
            const Bytes number{job.record.value, entry.size_bytes};
            const Bytes value = (entry.text == nullptr) ? number : Bytes{entry.text, entry.size_bytes};
            job.record.next = entry.next;
            static_cast<void>(Put(job, entry.object, value, SdoMode::kNormal));
        }
    }
}

/// Entry by entry. The position is moved when an entry was taken.
void BootSlave::WriteConcise(const Job& job) noexcept
{
    const ConciseReading entry = ReadConcise(job.setup.concise_dcf, job.record.position);
    if (entry.state == ConciseState::kMalformed)
    {
        RefuseDomain(job, kConciseIndex);
    }
    else if (entry.state == ConciseState::kEnd)
    {
        Enter(job, job.record.is_extra ? StartUpStep::kStart : StartUpStep::kErrorControl);
    }
    else
    {
        const Got got = Put(job, entry.object, entry.value, SdoMode::kNormal);
        if (got == Got::kRefused)
        {
            Fail(job, 'J');
        }
        job.record.position = (got == Got::kDone) ? entry.next : job.record.position;
    }
}

/// The domain of the master, not the slave, is wrong: its own object is named.
void BootSlave::RefuseDomain(const Job& job, const std::uint16_t index) noexcept
{
    job.record.status.object = ObjectAddress{index, job.node.value};
    job.record.status.abort = SdoAbort::kNoDictionary;
    Fail(job, 'J');
}

/// With heartbeat the slave must show one; the boot-up message is none.
void BootSlave::BeginSupervision(const Job& job) noexcept
{
    const std::uint64_t limit_us = kUsPerMs * job.setup.heartbeat.consumer_ms;
    if (job.record.wait != BootWait::kSign)
    {
        parts_.table.WatchAsSetUp(job.node, job.time.now);
        Wait(job, BootWait::kSign);
    }
    if ((limit_us == 0U) || (parts_.table.Record(job.node).beats != job.record.beats))
    {
        Enter(job, StartUpStep::kSafety);
    }
    else if (IsOver(job, limit_us))
    {
        Fail(job, 'K');
    }
}

void BootSlave::Start(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    job.record.is_start_wanted = true;
    if (!job.record.status.is_busy)
    {
        parts_.gate.Close(node); // What was verified at the boot may be long ago.
        const SlaveState state = parts_.table.Record(node).state;
        const bool is_deaf = (state == SlaveState::kStopped) || (parts_.table.RequestValue(node) == kStoppedByte);
        if (is_deaf && parts_.setup.IsSafetySlave(node))
        {
            // STOPPED, it has no SDO to be read by.
            static_cast<void>(parts_.nmt.Request(NmtCommand::kPreOperational, node, time.now));
        }
        job.record.status.is_busy = true;
        job.record.is_extra = true;
        Enter(job, StartUpStep::kSafety);
        OnCycle(node, time);
    }
}

void BootSlave::Verify(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    parts_.gate.Close(node); // What was verified before it ran may be long ago.
    job.record.was_operational = true;
    job.record.status.is_busy = true;
    job.record.is_extra = true;
    Enter(job, StartUpStep::kSafety);
    OnCycle(node, time);
}

void BootSlave::VerifySafety(const Job& job) noexcept
{
    const GateState state = parts_.gate.State(job.node);
    if ((state == GateState::kOpen) || !parts_.setup.IsSafetySlave(job.node))
    {
        Enter(job, StartUpStep::kStart);
    }
    else if (job.record.wait != BootWait::kGate)
    {
        Wait(job, BootWait::kGate);
        parts_.gate.Verify(job.node, job.time.now);
    }
    else if ((state == GateState::kDiffers) || (state == GateState::kFailed))
    {
        RefuseSafety(job);
    }
    else if (state == GateState::kClosed)
    {
        job.record.wait = BootWait::kNothing; // Somebody closed it meanwhile: from the beginning.
    }
}

/// A slave that runs with a configuration that is not the expected one is stopped, and so are two devices of one
/// node-ID: what is known of their state may be said of the other one. So is one that never told its state, and one
/// that was found running: what it said since may be of before.
void BootSlave::RefuseSafety(const Job& job) noexcept
{
    const GateFinding finding = parts_.gate.Finding(job.node);
    const bool is_doubted = (finding.object.index == 0U);
    const NodeRecord& heard = parts_.table.Record(job.node);
    const bool is_running =
        is_doubted || job.record.was_operational || (heard.state == SlaveState::kOperational) || (heard.beats == 0U);
    const bool is_done =
        !is_running || (parts_.nmt.Request(NmtCommand::kStop, job.node, job.time.now) == NmtAnswer::kTaken);
    if (is_done)
    {
        job.record.status.object = finding.object;
        job.record.status.abort = finding.abort;
        job.record.status.expected = finding.expected;
        job.record.status.read = finding.read;
        job.record.status.is_started = false;
        job.record.was_operational = false;
        job.record.wait = BootWait::kNothing;
        Fail(job, parts_.gate.IsOther(job.node) ? LetterOf(finding.object) : 'J');
    }
}

/// Started, or left as it is: with L it runs unless somebody stopped it and asks for a start, and 1F80h may leave it to
/// others.
void BootSlave::StartNode(const Job& job) noexcept
{
    const bool is_alone = !parts_.setup.Has(kStartAllAtOnce) || listener_.IsMasterOperational();
    const bool is_booting = !job.record.is_extra && job.setup.Has(kBootSlave);
    const bool is_left = parts_.setup.Has(kApplicationStartsSlaves) || job.record.was_operational;
    const bool is_due = is_booting && !is_left && is_alone;
    if (!is_due && !job.record.is_start_wanted)
    {
        Finish(job);
    }
    else
    {
        const NmtAnswer answer = parts_.nmt.Request(NmtCommand::kStart, job.node, job.time.now);
        if (answer == NmtAnswer::kTaken)
        {
            job.record.status.is_started = true;
            job.record.was_operational = false;
            Finish(job);
        }
        else if (answer == NmtAnswer::kNotVerified)
        {
            Enter(job, StartUpStep::kSafety);
        }
    }
}

} // namespace counterpoint::cia302
