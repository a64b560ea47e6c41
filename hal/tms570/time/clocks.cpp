// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Clock tree (reference manual, chapters "Oscillator and PLL", "Architecture"; facts/tms570 2, 4).
#include "hal/tms570/time/clocks.hpp"

#include "hal/tms570/chip/system_registers.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace system_module;

constexpr Looks kSwitchLooks{1000U};
/// The PLL locks within 127 + 1024 * NR cycles of the oscillator, NR at most 64; a look takes one of them at least.
constexpr Looks kLockLooks{70000U};
/// One cycle for a word of the greatest memory.
constexpr Looks kInitLooks{70000U};
constexpr std::uint32_t kPowerRegisters = 4U;
constexpr std::uint32_t kWordBytes = 4U;

[[nodiscard]] Outcome LockPll(const ClockTree& clocks, const std::uint32_t sources_off) noexcept
{
    constexpr std::uint32_t kBothPlls = kPllBit | kOtherPllBit;
    Write(At(kBase, kSourcesOffSet), kBothPlls);
    Outcome outcome = WaitFor(At(kBase, kSourcesOff), Bits{kBothPlls, kBothPlls}, kSwitchLooks);
    Write(At(kBase, kGlobalStatus), kGlobalErrors);
    outcome = Both(outcome, WriteChecked(At(kBase, kPll1), clocks.pll_control_1 | kPllDivider, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kPll2), clocks.pll_control_2, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kSourcesOff), sources_off, kWholeWord));
    outcome = Both(outcome, WaitFor(At(kBase, kSourcesValid), Bits{kUsedSources, kUsedSources}, kLockLooks));
    return Both(outcome, WriteChecked(At(kBase, kPll1), clocks.pll_control_1, kWholeWord));
}

void PowerUp(const RegisterBase controller) noexcept
{
    if (controller.address == 0U)
    {
        return;
    }
    for (std::uint32_t number = 0U; number < kPowerRegisters; ++number)
    {
        Write(At(controller, kPowerUp + (number * kWordBytes)), kWholeWord);
    }
}

} // namespace

ResetReason ReadResetReason() noexcept
{
    return ResetReason{Read(At(kBase, kResetStatus)) & kResetAll};
}

void ClearResetReason(const ResetReason reason) noexcept
{
    Write(At(kBase, kResetStatus), reason.bits & kResetAll);
}

Outcome StartClocks(const ClockTree& clocks, const SystemSetup& system) noexcept
{
    Outcome outcome = WriteChecked(At(kFlash, kReadControl), system.flash_read, kWholeWord);
    outcome = Both(outcome, LockPll(clocks, system.sources_off));
    if (outcome != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    const std::uint32_t dividers = (Read(At(kBase, kClockControl)) & ~(kVclkMask | kPeripheralsOn)) | kHalfVclk;
    outcome = Both(outcome, WriteChecked(At(kBase, kClockControl), dividers, kVclkMask));
    outcome = Both(outcome, WriteChecked(At(kBase, kMainSource), kPllIsMain, kWholeWord));
    outcome = Both(outcome, WriteChecked(At(kBase, kRtiSource), system.rti_source, kWholeWord));
    for (const RegisterBase controller : system.power)
    {
        PowerUp(controller);
    }
    outcome = Both(outcome, WriteChecked(At(kBase, kClockControl), dividers | kPeripheralsOn, kPeripheralsOn));
    return Both(outcome, ExamineClocks(system.rti_source));
}

Outcome ExamineClocks(const std::uint32_t rti_source) noexcept
{
    const bool same_main = Read(At(kBase, kMainSource)) == kPllIsMain;
    const bool same_rti = Read(At(kBase, kRtiSource)) == rti_source;
    const bool is_valid = (Read(At(kBase, kSourcesValid)) & kUsedSources) == kUsedSources;
    const bool is_clean = (Read(At(kBase, kGlobalStatus)) & kGlobalErrors) == 0U;
    return (same_main && same_rti && is_valid && is_clean) ? Outcome::kDone : Outcome::kFailed;
}

Outcome InitialiseMemories(const MemorySelection& memories) noexcept
{
    Write(At(kBase, kInitControl), kKeyOn);
    Write(At(kBase, kInitEnable), memories.initialise);
    const Outcome done = WaitFor(At(kBase, kTestStatus), Bits{kInitDone, kInitDone}, kInitLooks);
    Write(At(kBase, kTestStatus), kInitDone);
    Write(At(kBase, kInitControl), kKeyOff);
    return done;
}

} // namespace counterpoint::tms570
