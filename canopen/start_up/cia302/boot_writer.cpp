// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_writer.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia302/network/text_dcf.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr ObjectAddress kProgram{0x1F50U, 1U};
constexpr ObjectAddress kControl{0x1F51U, 1U};
constexpr ObjectAddress kDate{0x1F52U, 1U};
constexpr ObjectAddress kTime{0x1F52U, 2U};
constexpr ObjectAddress kIdentification{0x1F56U, 1U};
constexpr ObjectAddress kFlashStatus{0x1F57U, 1U};

constexpr std::uint8_t kStopProgram = 0U;
constexpr std::uint8_t kStartProgram = 1U;
constexpr std::uint8_t kClearProgram = 3U;

/// Bit 0 of 1F57h: busy; bits 1 to 7: 0 no error, 1 no valid program.
constexpr std::uint64_t kFlashBusy = 1U;
constexpr std::uint64_t kFlashErrorMask = 0xFEU;
constexpr std::uint64_t kNoValidProgram = 0x02U;

/// An object that tells the software. Zero is not asked for.
struct Number
{
    ObjectAddress object;
    std::uint32_t expected;
};

Number NumberOf(const BootState state, const SoftwareSetup& software) noexcept
{
    const Number date =
        (state == BootState::kSoftwareDate) ? Number{kDate, software.date} : Number{kTime, software.time};
    return (state == BootState::kSoftwareId) ? Number{kIdentification, software.identification} : date;
}

/// The software is another one: it is replaced, or the boot ends.
BootFinding Judge(const BootJob& job) noexcept
{
    const bool is_allowed = job.setup.Has(kMayUpdateSoftware) && !job.setup.Has(kKeepAlive);
    BootFinding finding = Found(BootEvent::kElse);
    if (job.record.is_updated || (job.record.updates >= kMaxUpdates))
    {
        finding = Failed('I'); // The download did not change it, or never came to its end.
    }
    else if (!is_allowed)
    {
        finding = Failed('H');
    }
    else if (job.setup.software.program.size_bytes == 0U)
    {
        finding = Failed('G');
    }
    else
    {
        ++job.record.updates;
    }
    return finding;
}

constexpr ObjectAddress kConfigurationDate{0x1020U, 1U};
constexpr ObjectAddress kConfigurationTime{0x1020U, 2U};
constexpr std::uint16_t kRestoreIndex = 0x1011U;
constexpr std::uint16_t kTextIndex = 0x1F20U;
constexpr std::uint16_t kConciseIndex = 0x1F22U;
constexpr std::uint8_t kLoad[4] = {0x6CU, 0x6FU, 0x61U, 0x64U}; ///< "load"
constexpr std::uint8_t kCommunicationSub = 2U;

/// What an SDO came to that has no other way: `letter`, or `done`.
BootFinding Written(const Got got, const char letter, const BootEvent done) noexcept
{
    return (got == Got::kRefused) ? Failed(letter) : Found((got == Got::kDone) ? done : BootEvent::kNone);
}

/// The domain of the master, not the slave, is wrong: its own object is named.
BootFinding RefuseDomain(const BootJob& job, const std::uint16_t index) noexcept
{
    job.record.status.object = ObjectAddress{index, job.node.value};
    job.record.status.abort = SdoAbort::kNoDictionary;
    return Failed('J');
}

} // namespace

BootFinding BootWriter::Check(const BootJob& job) noexcept
{
    const SoftwareSetup& software = job.setup.software;
    const Number number = NumberOf(job.record.state, software);
    BootFinding finding = Found(BootEvent::kNone);
    if (!job.setup.Has(kVerifySoftware))
    {
        finding = Found(BootEvent::kSkip);
    }
    else if ((software.identification | software.date | software.time) == 0U)
    {
        finding = Failed('G');
    }
    else if (number.expected == 0U)
    {
        finding = Found(BootEvent::kDone);
    }
    else
    {
        const Got got = transfer_.Fetch(job, number.object);
        finding = Written(got, 'G', BootEvent::kDone);
        if ((got == Got::kDone) && (job.record.status.read != number.expected))
        {
            job.record.status.expected = number.expected;
            finding = Judge(job);
        }
    }
    return finding;
}

BootFinding BootWriter::Update(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    BootFinding finding = Found(BootEvent::kNone);
    if (state == BootState::kProgramStop)
    {
        finding = Written(transfer_.PutByte(job, kControl, kStopProgram), 'I', BootEvent::kDone);
    }
    else if (state == BootState::kProgramClear)
    {
        finding = Written(transfer_.PutByte(job, kControl, kClearProgram), 'I', BootEvent::kDone);
    }
    else if ((state == BootState::kClearCheck) || (state == BootState::kProgramCheck))
    {
        finding = CheckFlash(job);
    }
    else if ((state == BootState::kClearPause) || (state == BootState::kProgramPause))
    {
        finding = Found(job.IsOver(kFlashCheckUs - 1U) ? BootEvent::kDone : BootEvent::kNone);
    }
    else if (state == BootState::kLoadBlocks)
    {
        finding = Load(job, SdoMode::kBlock);
    }
    else if (state == BootState::kLoadSegments)
    {
        finding = Load(job, SdoMode::kNormal);
    }
    else if (state == BootState::kProgramStart)
    {
        finding = Written(transfer_.PutByte(job, kControl, kStartProgram), 'I', BootEvent::kDone);
        job.record.is_updated = (finding.event == BootEvent::kDone);
    }
    else if (job.IsOver(kResetUs)) // It started its program without a boot-up message.
    {
        job.record.is_fresh = true;
        finding = Found(BootEvent::kSilence);
    }
    return finding;
}

/// A slave that refuses a block transfer gets the program by segments.
BootFinding BootWriter::Load(const BootJob& job, const SdoMode mode) noexcept
{
    const Got got = transfer_.Put(job, kProgram, job.setup.software.program, mode);
    const bool has_other_way = (mode == SdoMode::kBlock) && parts_.sdo.Outcome(job.node).by_server;
    return ((got == Got::kRefused) && has_other_way) ? Found(BootEvent::kElse) : Written(got, 'I', BootEvent::kDone);
}

/// Reads 1F57h until the flash is ready.
BootFinding BootWriter::CheckFlash(const BootJob& job) noexcept
{
    const bool is_cleared = (job.record.state == BootState::kClearCheck);
    const Got got = transfer_.Fetch(job, kFlashStatus);
    const std::uint64_t error = job.record.status.read & kFlashErrorMask;
    const bool is_good = (error == 0U) || (is_cleared && (error == kNoValidProgram));
    const bool is_busy = (job.record.status.read & kFlashBusy) != 0U;
    BootFinding finding = Written(got, 'I', BootEvent::kDone);
    if ((got == Got::kDone) && is_busy && (job.record.checks < kMaxFlashChecks))
    {
        ++job.record.checks;
        finding = Found(BootEvent::kElse);
    }
    else if ((got == Got::kDone) && (is_busy || !is_good))
    {
        finding = Failed('I');
    }
    else if (got == Got::kDone)
    {
        job.record.checks = 0U;
    }
    return finding;
}

BootFinding BootWriter::Configure(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    BootFinding finding = Found(BootEvent::kNone);
    if (state == BootState::kRestore)
    {
        finding = Restore(job);
    }
    else if (state == BootState::kRestoreReset)
    {
        finding = ResetRestored(job);
    }
    else if (state == BootState::kText)
    {
        finding = WriteText(job);
    }
    else if (state == BootState::kConcise)
    {
        finding = WriteConcise(job);
    }
    else
    {
        finding = CompareDate(job);
    }
    return finding;
}

/// A slave that does not tell them is configured.
BootFinding BootWriter::CompareDate(const BootJob& job) noexcept
{
    const std::uint32_t date = job.setup.configuration_date;
    const std::uint32_t time = job.setup.configuration_time;
    const bool is_date = (job.record.state == BootState::kConfigurationDate);
    BootEvent event = BootEvent::kSkip;
    if ((date != 0U) && (time != 0U))
    {
        const Got got = transfer_.Fetch(job, is_date ? kConfigurationDate : kConfigurationTime);
        const bool is_same = (got == Got::kDone) && (job.record.status.read == (is_date ? date : time));
        event = is_same ? BootEvent::kDone : BootEvent::kNone;
        if (!is_same && (got != Got::kNothingYet))
        {
            job.record.status.abort = SdoAbort::kNone;
            event = BootEvent::kElse;
        }
    }
    return Found(event);
}

BootFinding BootWriter::Restore(const BootJob& job) noexcept
{
    BootFinding finding = Found(BootEvent::kSkip);
    if (!IsRestoreUnasked(job))
    {
        const ObjectAddress object{kRestoreIndex, job.setup.restore_sub};
        finding = Written(transfer_.Put(job, object, Bytes{kLoad, 4U}, SdoMode::kNormal), 'J', BootEvent::kDone);
    }
    return finding;
}

BootFinding BootWriter::ResetRestored(const BootJob& job) noexcept
{
    const bool is_communication = (job.setup.restore_sub == kCommunicationSub);
    const NmtCommand command = is_communication ? NmtCommand::kResetCommunication : NmtCommand::kResetNode;
    BootEvent event = BootEvent::kNone;
    if (IsRestoreUnasked(job))
    {
        event = BootEvent::kSkip;
    }
    else if (parts_.nmt.Request(command, job.node, job.time.now) == NmtAnswer::kTaken)
    {
        event = BootEvent::kDone;
    }
    return Found(event);
}

/// Object by object. The text is read once for each: what runs needs to know only where it goes on.
BootFinding BootWriter::WriteText(const BootJob& job) noexcept
{
    BootFinding finding = Found(BootEvent::kNone);
    if (job.record.is_transferring)
    {
        finding = Written(transfer_.Take(job), 'J', BootEvent::kElse);
        job.record.offset = (finding.event == BootEvent::kElse) ? job.record.next : job.record.offset;
    }
    else
    {
        const TextReading entry = ReadTextDcf(job.setup.dcf, job.record.offset, job.node);
        if (entry.state == TextState::kMalformed)
        {
            finding = RefuseDomain(job, kTextIndex);
        }
        else if ((entry.state == TextState::kEnd) && !IsConcise(job.setup.concise_dcf))
        {
            finding = RefuseDomain(job, kConciseIndex); // Before any of it is written.
        }
        else if (entry.state == TextState::kEnd)
        {
            finding = Found(BootEvent::kDone);
        }
        else
        {
            cia301::ToLittleEndian(entry.number, job.record.value, sizeof(job.record.value));
            const Bytes number{job.record.value, entry.size_bytes};
            const Bytes value = (entry.text == nullptr) ? number : Bytes{entry.text, entry.size_bytes};
            job.record.next = entry.next;
            static_cast<void>(transfer_.Put(job, entry.object, value, SdoMode::kNormal));
        }
    }
    return finding;
}

/// Entry by entry. The position is moved when an entry was taken.
BootFinding BootWriter::WriteConcise(const BootJob& job) noexcept
{
    const ConciseReading entry = ReadConcise(job.setup.concise_dcf, job.record.position);
    BootFinding finding = Found(BootEvent::kNone);
    if (entry.state == ConciseState::kMalformed)
    {
        finding = RefuseDomain(job, kConciseIndex);
    }
    else if (entry.state == ConciseState::kEnd)
    {
        finding = Found(job.record.is_extra ? BootEvent::kSkip : BootEvent::kDone); // An extra is not supervised anew.
    }
    else
    {
        finding = Written(transfer_.Put(job, entry.object, entry.value, SdoMode::kNormal), 'J', BootEvent::kElse);
        job.record.position = (finding.event == BootEvent::kElse) ? entry.next : job.record.position;
    }
    return finding;
}

} // namespace counterpoint::cia302
