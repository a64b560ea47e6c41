// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// LBIST (reference manual, chapter "CPU Self-Test Controller (STC)"; facts/tms570 4).
#include "hal/tms570/diagnosis/built_in_tests.hpp"

#include "hal/tms570/chip/processor.hpp"
#include "hal/tms570/chip/system_registers.hpp"
#include "hal/tms570/diagnosis/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace system_module;

constexpr std::uint32_t kCheckIntervals = 1U;
/// All intervals of a Cortex-R4F in this family.
constexpr std::uint32_t kTestIntervals = 24U;
constexpr std::uint32_t kLongestTime = 0xFFFFFFFFU;
/// 16 cycles of the bus between set-up and start.
constexpr Looks kSettleLooks{32U};

void Run(const std::uint32_t intervals, const std::uint32_t self_check) noexcept
{
    Write(At(kSystem2, kStcDivider), kStcHalfClock);
    Write(At(kStc, kStcStatus), kStcDone | kStcFailed);
    Write(At(kStc, kStcControl0), (intervals << kStcIntervalsShift) | kStcRestart);
    Write(At(kStc, kStcSelfCheck), self_check);
    Write(At(kStc, kStcTimeout), kLongestTime);
    // The value never comes: only the time of the looks counts.
    static_cast<void>(WaitFor(At(kStc, kStcTimeout), Bits{kWholeWord, 0U}, kSettleLooks));
    // A test that never begins leaves the processor asleep for ever. The pins are inputs since the reset; with nERROR
    // low the monitor outside knows as well. The steps that force errors let it go.
    ForceErrorPin();
    Write(At(kStc, kStcControl1), kKeyOn);
    WaitForInterrupt();
}

} // namespace

LogicTest ContinueLogicTest(const ResetReason reason) noexcept
{
    const bool is_after_test = (reason.bits & kResetProcessor) != 0U;
    ClearResetReason(ResetReason{kResetProcessor});
    if (!is_after_test)
    {
        Run(kCheckIntervals, kStcFault);
        return LogicTest::kResetComes;
    }
    const std::uint32_t status = Read(At(kStc, kStcStatus)) & (kStcDone | kStcFailed);
    const bool was_check = Read(At(kStc, kStcSelfCheck)) == kStcFault;
    if ((status & kStcDone) == 0U)
    {
        return LogicTest::kTimedOut;
    }
    const bool has_failed = (status & kStcFailed) != 0U;
    if (was_check)
    {
        if (!has_failed)
        {
            return LogicTest::kCheckPassed;
        }
        Run(kTestIntervals, kStcNoFault);
        return LogicTest::kResetComes;
    }
    return has_failed ? LogicTest::kFailed : LogicTest::kPassed;
}

} // namespace counterpoint::tms570
