// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Course of a boot and its transfers. What the steps do is in files of their own.
#include "canopen/start_up/cia302/boot_slave.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

/// More steps than there are: a call ends also if two steps handed a boot to each other.
constexpr std::uint8_t kMaxStepsPerCall = 32U;

/// It is another device than the expected one, or never said which it is.
bool IsOfIdentity(const char letter) noexcept
{
    return (letter == 'B') || (letter == 'C') || (letter == 'D') || (letter == 'M') || (letter == 'N') ||
           (letter == 'O');
}

} // namespace

BootSlave::BootSlave(const StartUpParts& parts, BootRecord* const records, BootListener& listener) noexcept
    : parts_(parts), records_(records), listener_(listener)
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

BootSlave::Job BootSlave::JobOf(const NodeId node, const BootTime& time) noexcept
{
    return Job{node, Record(node), parts_.setup.Slave(node), time};
}

/// The boot begins from nothing; what ran is given up.
void BootSlave::Clear(const Job& job) noexcept
{
    End(job.node);
    const bool is_at_once = (job.setup.heartbeat.arming == Arming::kImmediately);
    const std::uint16_t watched_ms = is_at_once ? job.setup.heartbeat.consumer_ms : std::uint16_t{0U};
    parts_.table.WatchHeartbeat(job.node, watched_ms, Arming::kImmediately, job.time.now); // Others are not watched.
    parts_.gate.Close(job.node);
    parts_.nmt.DropStarts(job.node);
    job.record = BootRecord{};
    job.record.began_us = job.time.clock_us;
    job.record.status.is_busy = true;
}

void BootSlave::Ask(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    Clear(job);
    Enter(job, job.setup.Has(kBootSlave) ? StartUpStep::kDeviceType : StartUpStep::kErrorControl);
    OnCycle(node, time);
}

void BootSlave::Resume(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    Clear(job);
    job.record.is_fresh = true;
    job.record.is_resumed = true;
    Enter(job, job.setup.Has(kBootSlave) ? StartUpStep::kDeviceType : StartUpStep::kErrorControl);
    OnCycle(node, time);
}

void BootSlave::Await(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    Clear(job);
    Enter(job, StartUpStep::kReset);
    job.record.part = 1U; // The reset was sent by somebody else.
    Wait(job, BootWait::kBootUp);
}

void BootSlave::Reset(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    Clear(job);
    Enter(job, StartUpStep::kReset);
    OnCycle(node, time);
}

void BootSlave::OnBootUp(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    const bool is_awaited = job.record.status.is_busy && (job.record.wait == BootWait::kBootUp);
    const StartUpStep step = job.record.status.step;
    const std::uint8_t updates = job.record.updates;
    const bool is_first = (step == StartUpStep::kReset) || (step == StartUpStep::kWaitBootUp);
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
    if (!is_awaited || is_first)
    {
        Enter(job, job.setup.Has(kBootSlave) ? StartUpStep::kDeviceType : StartUpStep::kErrorControl);
    }
    else if (step == StartUpStep::kStateCheck)
    {
        Enter(job, StartUpStep::kSoftwareVersion);
    }
    else if (step == StartUpStep::kRestore)
    {
        // Who runs and is reset by its new configuration (1F25h) is supervised, verified and started again.
        job.record.is_extra = job.record.is_extra && !job.record.is_booted;
        job.record.was_operational = false;
        Enter(job, StartUpStep::kConfigure);
    }
    else
    {
        Enter(job, StartUpStep::kDeviceType); // New software: it is another device until it was looked at.
    }
    OnCycle(node, time);
}

void BootSlave::Configure(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    End(node);
    job.record.status.is_busy = true;
    job.record.is_extra = true;
    Enter(job, StartUpStep::kRestore);
    OnCycle(node, time);
}

void BootSlave::End(const NodeId node) noexcept
{
    BootRecord& record = Record(node);
    if (record.wait == BootWait::kTransfer)
    {
        parts_.sdo.Cancel(node, SdoAbort::kGeneral);
    }
    if (record.wait == BootWait::kGate)
    {
        parts_.gate.Close(node);
    }
    record.wait = BootWait::kNothing;
    record.status.is_busy = false;
    record.is_extra = false;
    record.is_start_wanted = false;
    record.is_start_owed = false;
}

void BootSlave::Enter(const Job& job, const StartUpStep step) noexcept
{
    job.record.status.step = step;
    job.record.wait = BootWait::kNothing;
    job.record.part = 0U;
    job.record.checks = 0U;
    job.record.position = ConcisePosition{};
    job.record.offset = 0U;
    const bool is_new_look = (step != StartUpStep::kDone) && (job.record.status.letter == '\0');
    if (is_new_look) // What an earlier step read belongs to that step.
    {
        job.record.status.object = ObjectAddress{0U, 0U};
        job.record.status.abort = SdoAbort::kNone;
        job.record.status.expected = 0U;
        job.record.status.read = 0U;
    }
    parts_.listener.OnNodeStatus(job.node, job.time.now);
}

void BootSlave::Wait(const Job& job, const BootWait wait) noexcept
{
    job.record.wait = wait;
    job.record.since_us = job.time.clock_us;
    job.record.beats = parts_.table.Record(job.node).beats;
}

bool BootSlave::IsOver(const Job& job, const std::uint64_t limit_us) noexcept
{
    return (job.time.clock_us - job.record.since_us) > limit_us;
}

/// A slave that failed is not supervised: it has nothing to lose. But one that failed in an extra still runs.
void BootSlave::Fail(const Job& job, const char letter) noexcept
{
    const bool is_extra = job.record.is_extra;
    const bool was_booted = job.record.is_booted && is_extra && (job.record.status.step != StartUpStep::kSafety);
    job.record.status.letter = letter;
    job.record.identity = IsOfIdentity(letter) ? letter : job.record.identity;
    job.record.status.is_other = job.record.status.is_other || IsOfIdentity(letter);
    job.record.is_booted = was_booted;
    End(job.node);
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

void BootSlave::Finish(const Job& job) noexcept
{
    const bool is_boot = !job.record.is_extra;
    const char before = job.record.status.letter;
    job.record.is_booted = job.record.is_booted || is_boot;
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
    End(job.node);
    Enter(job, StartUpStep::kDone);
    if (is_boot)
    {
        listener_.OnBooted(job.node, job.time);
    }
}

void BootSlave::OnCycle(const NodeId node, const BootTime& time) noexcept
{
    const Job job = JobOf(node, time);
    bool is_going = true;
    for (std::uint8_t i = 0U; is_going && (i < kMaxStepsPerCall); ++i)
    {
        const StartUpStep step = job.record.status.step;
        const std::uint8_t part = job.record.part;
        const std::uint32_t entry = job.record.position.entry + job.record.offset;
        if (job.record.status.is_busy)
        {
            Run(job);
        }
        is_going = job.record.status.is_busy && ((step != job.record.status.step) || (part != job.record.part) ||
                                                 (entry != (job.record.position.entry + job.record.offset)));
    }
}

/// The steps of this profile; in all others nothing is to be done.
void BootSlave::Run(const Job& job) noexcept
{
    const StartUpStep step = job.record.status.step;
    if (step == StartUpStep::kReset)
    {
        AwaitReset(job);
    }
    else if (step == StartUpStep::kDeviceType)
    {
        ReadDeviceType(job);
    }
    else if (step == StartUpStep::kVendorId)
    {
        Compare(job, 1U, job.setup.vendor_id, 'D');
    }
    else if (step == StartUpStep::kProductCode)
    {
        Compare(job, 2U, job.setup.product_code, 'M');
    }
    else if (step == StartUpStep::kRevisionNumber)
    {
        Compare(job, 3U, job.setup.revision_number, 'N');
    }
    else if (step == StartUpStep::kSerialNumber)
    {
        Compare(job, 4U, job.setup.serial_number, 'O');
    }
    else if (step == StartUpStep::kStateCheck)
    {
        CheckState(job);
    }
    else
    {
        RunLater(job, step);
    }
}

void BootSlave::RunLater(const Job& job, const StartUpStep step) noexcept
{
    if (step == StartUpStep::kSoftwareVersion)
    {
        CheckSoftware(job);
    }
    else if (step == StartUpStep::kSoftwareUpdate)
    {
        UpdateSoftware(job);
    }
    else if (step == StartUpStep::kConfigurationDate)
    {
        CompareDate(job);
    }
    else if (step == StartUpStep::kRestore)
    {
        Restore(job);
    }
    else if (step == StartUpStep::kConfigure)
    {
        WriteConfiguration(job);
    }
    else if (step == StartUpStep::kErrorControl)
    {
        BeginSupervision(job);
    }
    else if (step == StartUpStep::kSafety)
    {
        VerifySafety(job);
    }
    else if (step == StartUpStep::kStart)
    {
        StartNode(job);
    }
}

BootSlave::Got BootSlave::Fetch(const Job& job, const ObjectAddress& object) noexcept
{
    Got got = Got::kNothingYet;
    if (job.record.wait == BootWait::kTransfer)
    {
        got = Take(job);
    }
    else if (parts_.sdo.Upload(job.node, object, Room{job.record.value, 4U}, SdoMode::kNormal, job.time.now))
    {
        Wait(job, BootWait::kTransfer);
        job.record.status.object = object;
        job.record.status.abort = SdoAbort::kNone;
    }
    if (got == Got::kDone)
    {
        const std::uint32_t size = parts_.sdo.Outcome(job.node).size_bytes;
        job.record.status.read = cia301::FromLittleEndian(job.record.value, (size < 4U) ? size : 4U);
    }
    return got;
}

BootSlave::Got BootSlave::Put(const Job& job, const ObjectAddress& object, const Bytes& value,
                              const SdoMode mode) noexcept
{
    Got got = Got::kNothingYet;
    if (job.record.wait == BootWait::kTransfer)
    {
        got = Take(job);
    }
    else if (parts_.sdo.Download(job.node, object, value, mode, job.time.now))
    {
        Wait(job, BootWait::kTransfer);
        job.record.status.object = object;
        job.record.status.abort = SdoAbort::kNone;
    }
    return got;
}

BootSlave::Got BootSlave::PutByte(const Job& job, const ObjectAddress& object, const std::uint8_t value) noexcept
{
    job.record.value[0] = value;
    return Put(job, object, Bytes{job.record.value, 1U}, SdoMode::kNormal);
}

/// The end of the running transfer, if it has one.
BootSlave::Got BootSlave::Take(const Job& job) noexcept
{
    const TransferState state = parts_.sdo.State(job.node);
    Got got = Got::kNothingYet;
    if (state == TransferState::kDone)
    {
        got = Got::kDone;
        job.record.wait = BootWait::kNothing;
    }
    else if (state != TransferState::kBusy)
    {
        got = Got::kRefused;
        job.record.wait = BootWait::kNothing;
        job.record.status.abort = parts_.sdo.Outcome(job.node).abort;
    }
    return got;
}

} // namespace counterpoint::cia302
