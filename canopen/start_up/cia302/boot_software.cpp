// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_software.hpp"

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

/// A write of an update that has no other way.
BootFinding Written(const Got got) noexcept
{
    return (got == Got::kRefused) ? Failed('I') : Found((got == Got::kDone) ? BootEvent::kDone : BootEvent::kNone);
}

} // namespace

BootFinding BootSoftware::Check(const BootJob& job) noexcept
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
        if (got == Got::kRefused)
        {
            finding = Failed('G');
        }
        else if ((got == Got::kDone) && (job.record.status.read == number.expected))
        {
            finding = Found(BootEvent::kDone);
        }
        else if (got == Got::kDone)
        {
            job.record.status.expected = number.expected;
            finding = Judge(job);
        }
    }
    return finding;
}

BootFinding BootSoftware::Update(const BootJob& job) noexcept
{
    const BootState state = job.record.state;
    BootFinding finding = Found(BootEvent::kNone);
    if (state == BootState::kProgramStop)
    {
        finding = Written(transfer_.PutByte(job, kControl, kStopProgram));
    }
    else if (state == BootState::kProgramClear)
    {
        finding = Written(transfer_.PutByte(job, kControl, kClearProgram));
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
        finding = Written(transfer_.PutByte(job, kControl, kStartProgram));
        job.record.is_updated = job.record.is_updated || (finding.event == BootEvent::kDone);
    }
    else if (job.IsOver(kResetUs)) // It started its program without a boot-up message.
    {
        job.record.is_fresh = true;
        finding = Found(BootEvent::kSilence);
    }
    return finding;
}

/// A slave that refuses a block transfer gets the program by segments.
BootFinding BootSoftware::Load(const BootJob& job, const SdoMode mode) noexcept
{
    const Got got = transfer_.Put(job, kProgram, job.setup.software.program, mode);
    const bool has_other_way = (mode == SdoMode::kBlock) && sdo_.Outcome(job.node).by_server;
    return ((got == Got::kRefused) && has_other_way) ? Found(BootEvent::kElse) : Written(got);
}

/// Reads 1F57h until the flash is ready.
BootFinding BootSoftware::CheckFlash(const BootJob& job) noexcept
{
    const bool is_cleared = (job.record.state == BootState::kClearCheck);
    const Got got = transfer_.Fetch(job, kFlashStatus);
    const std::uint64_t error = job.record.status.read & kFlashErrorMask;
    const bool is_good = (error == 0U) || (is_cleared && (error == kNoValidProgram));
    const bool is_busy = (job.record.status.read & kFlashBusy) != 0U;
    BootFinding finding = Written(got);
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

} // namespace counterpoint::cia302
