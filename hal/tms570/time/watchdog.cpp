// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Digital windowed watchdog (reference manual, chapter RTI, "Digital watchdog"; facts/tms570 4).
#include "hal/tms570/time/watchdog.hpp"

#include "hal/tms570/time/rti_registers.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace rti;

/// Questions follow each other without a pattern that a stuck bit would repeat (an odd step reaches all 2^32).
constexpr std::uint32_t kQuestionStep = 0x9E3779B9U;
constexpr std::uint32_t kLowHalf = 0xFFFFU;
constexpr std::uint32_t kHalfBits = 16U;
/// Longest period that fits into 32 bits of cycles, and into the 12 bits of the preload value.
constexpr std::uint32_t kMostPeriodUs = 300000U;

[[nodiscard]] std::uint32_t QuestionOf(const std::uint32_t sequence) noexcept
{
    return (sequence * kQuestionStep) | 1U;
}

} // namespace

WatchdogPlan PlanWatchdog(const hal::WatchdogWindow& wanted, const RtiClock clock,
                          const std::uint32_t latest_open_us) noexcept
{
    WatchdogPlan plan{Outcome::kFailed, 0U, 0U, hal::WatchdogWindow{0U, 0U}, Presence::kPresent};
    const bool is_sensible = (wanted.opens_us < wanted.ends_us) && (wanted.ends_us <= kMostPeriodUs) &&
                             (wanted.opens_us <= latest_open_us) && (clock.mhz != 0U);
    if (!is_sensible)
    {
        return plan;
    }
    const std::uint32_t steps = (wanted.ends_us * clock.mhz) / kPreloadCycles;
    if ((steps == 0U) || (steps > (kMostPreload + 1U)))
    {
        return plan;
    }
    const std::uint32_t period_cycles = steps * kPreloadCycles;
    plan.preload = steps - 1U;
    plan.real.ends_us = period_cycles / clock.mhz;
    for (std::uint32_t size = 0U; size < kWindowSizes; ++size)
    {
        const std::uint32_t opens_us = (period_cycles - (period_cycles >> size)) / clock.mhz;
        if ((opens_us >= wanted.opens_us) && (opens_us <= latest_open_us))
        {
            plan.outcome = Outcome::kDone;
            plan.window = kWindowFull << (kWindowStepBits * size);
            plan.real.opens_us = opens_us;
        }
    }
    return plan;
}

Outcome WindowedWatchdog::Start(const WatchdogPlan& plan) noexcept
{
    if (plan.outcome != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    plan_ = plan;
    sequence_ = 1U;
    Write(At(kBase, kWatchdogStatus), kStatusBits);
    Outcome outcome = WriteChecked(At(kBase, kWatchdogPreload), plan.preload, kWholeWord);
    if (plan.has_window == Presence::kPresent)
    {
        outcome = Both(outcome, WriteChecked(At(kBase, kWatchdogReaction), kReactionReset, kWholeWord));
        outcome = Both(outcome, WriteChecked(At(kBase, kWatchdogWindow), plan.window, kWholeWord));
    }
    return Both(outcome, WriteChecked(At(kBase, kWatchdogControl), kWatchdogOn, kWholeWord));
}

hal::WatchdogQuestion WindowedWatchdog::Question() noexcept
{
    return hal::WatchdogQuestion{QuestionOf(sequence_)};
}

void WindowedWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    // 0 for the right answer. Each half spoils a key, so that no difference passes both.
    const std::uint32_t right = (hal::kFlowReference + QuestionOf(sequence_)) * hal::kWatchdogConstant;
    const std::uint32_t difference = answer.value - right;
    Write(At(kBase, kWatchdogKey), (kKeyFirst + difference) & kLowHalf);
    Write(At(kBase, kWatchdogKey), (kKeySecond + (difference >> kHalfBits)) & kLowHalf);
    ++sequence_;
}

Outcome WindowedWatchdog::Examine() const noexcept
{
    const bool is_on = Read(At(kBase, kWatchdogControl)) == kWatchdogOn;
    const bool same_period = Read(At(kBase, kWatchdogPreload)) == plan_.preload;
    const bool has_window = plan_.has_window == Presence::kPresent;
    const bool same_window = !has_window || (Read(At(kBase, kWatchdogWindow)) == plan_.window);
    const bool same_reaction = !has_window || (Read(At(kBase, kWatchdogReaction)) == kReactionReset);
    return (is_on && same_period && same_window && same_reaction) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
