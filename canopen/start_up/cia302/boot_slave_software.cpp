// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The slave has the software that is expected, or gets it: letters G, H, I.
#include "canopen/start_up/cia302/boot_slave.hpp"

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

/// The parts of an update in their order.
constexpr std::uint8_t kStopping = 0U;
constexpr std::uint8_t kClearing = 1U;
constexpr std::uint8_t kCheckingClear = 2U;
constexpr std::uint8_t kLoadingBlocks = 3U;
constexpr std::uint8_t kLoadingSegments = 4U;
constexpr std::uint8_t kCheckingProgram = 5U;
constexpr std::uint8_t kStarting = 6U;
constexpr std::uint8_t kRestarting = 7U;

} // namespace

/// Parts 0, 1, 2: identification, date, time.
void BootSlave::CheckSoftware(const Job& job) noexcept
{
    const SoftwareSetup& software = job.setup.software;
    const std::uint32_t expected[3] = {software.identification, software.date, software.time};
    constexpr ObjectAddress kObjects[3] = {kIdentification, kDate, kTime};
    if (!job.setup.Has(kVerifySoftware))
    {
        Enter(job, StartUpStep::kConfigurationDate);
    }
    else if ((expected[0] | expected[1] | expected[2]) == 0U)
    {
        Fail(job, 'G');
    }
    else if (job.record.part > 2U)
    {
        Enter(job, StartUpStep::kConfigurationDate);
    }
    else if (expected[job.record.part] == 0U)
    {
        ++job.record.part;
    }
    else
    {
        const Got got = Fetch(job, kObjects[job.record.part]);
        if (got == Got::kRefused)
        {
            Fail(job, 'G');
        }
        else if (got == Got::kDone)
        {
            JudgeSoftware(job, expected[job.record.part]);
        }
    }
}

void BootSlave::JudgeSoftware(const Job& job, const std::uint32_t expected) noexcept
{
    const bool is_allowed = job.setup.Has(kMayUpdateSoftware) && !job.setup.Has(kKeepAlive);
    if (job.record.status.read == expected)
    {
        ++job.record.part;
    }
    else
    {
        job.record.status.expected = expected;
        if (job.record.is_updated || (job.record.updates >= kMaxUpdates))
        {
            Fail(job, 'I'); // The download did not change it, or never came to its end.
        }
        else if (!is_allowed)
        {
            Fail(job, 'H');
        }
        else if (job.setup.software.program.size_bytes == 0U)
        {
            Fail(job, 'G');
        }
        else
        {
            ++job.record.updates;
            Enter(job, StartUpStep::kSoftwareUpdate);
        }
    }
}

void BootSlave::UpdateSoftware(const Job& job) noexcept
{
    Got got = Got::kNothingYet;
    switch (job.record.part)
    {
    case kStopping:
        got = PutByte(job, kControl, kStopProgram);
        break;
    case kClearing:
        got = PutByte(job, kControl, kClearProgram);
        break;
    case kCheckingClear:
        CheckFlash(job, true);
        break;
    case kLoadingBlocks:
        got = Put(job, kProgram, job.setup.software.program, SdoMode::kBlock);
        break;
    case kLoadingSegments:
        got = Put(job, kProgram, job.setup.software.program, SdoMode::kNormal);
        break;
    case kCheckingProgram:
        CheckFlash(job, false);
        break;
    case kStarting:
        got = PutByte(job, kControl, kStartProgram);
        break;
    default:
        if (IsOver(job, kResetUs)) // It started its program without a boot-up message.
        {
            job.record.is_fresh = true;
            Enter(job, StartUpStep::kDeviceType);
        }
        break;
    }
    const bool has_other_way = (job.record.part == kLoadingBlocks) && parts_.sdo.Outcome(job.node).by_server;
    if ((got == Got::kRefused) && !has_other_way)
    {
        Fail(job, 'I');
    }
    else if (got != Got::kNothingYet)
    {
        const bool is_loaded = (got == Got::kDone) && (job.record.part == kLoadingBlocks);
        job.record.part = is_loaded ? kCheckingProgram : static_cast<std::uint8_t>(job.record.part + 1U);
        job.record.is_updated = job.record.is_updated || (job.record.part == kRestarting);
        if (job.record.part == kRestarting)
        {
            Wait(job, BootWait::kBootUp);
        }
    }
}

/// Reads 1F57h until the flash is ready.
void BootSlave::CheckFlash(const Job& job, const bool is_cleared) noexcept
{
    if (job.record.wait == BootWait::kTime)
    {
        job.record.wait = IsOver(job, kFlashCheckUs - 1U) ? BootWait::kNothing : BootWait::kTime;
    }
    const Got got = (job.record.wait == BootWait::kTime) ? Got::kNothingYet : Fetch(job, kFlashStatus);
    const std::uint64_t error = job.record.status.read & kFlashErrorMask;
    const bool is_good = (error == 0U) || (is_cleared && (error == kNoValidProgram));
    const bool is_busy = (job.record.status.read & kFlashBusy) != 0U;
    if (got == Got::kRefused)
    {
        Fail(job, 'I');
    }
    else if ((got == Got::kDone) && is_busy && (job.record.checks < kMaxFlashChecks))
    {
        ++job.record.checks;
        Wait(job, BootWait::kTime);
    }
    else if ((got == Got::kDone) && (is_busy || !is_good))
    {
        Fail(job, 'I');
    }
    else if (got == Got::kDone)
    {
        ++job.record.part;
        job.record.checks = 0U;
    }
}

} // namespace counterpoint::cia302
