// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/zynqmp/time/system_watchdog.hpp"

#include "hal/zynqmp/time/swdt_registers.hpp"

namespace counterpoint::zynqmp
{

namespace
{

using namespace swdt;

constexpr RegisterBase kBase = kLowPowerDomain;
constexpr std::uint32_t kKilo = 1000U;
constexpr std::uint32_t kMostClockKhz = 200000U;
constexpr std::uint32_t kMostPeriodUs = 20000U;
constexpr std::uint32_t kHalfBits = 16U;
constexpr std::uint32_t kLowHalf = 0xFFFFU;
/// One step of the reload value, in counts of the watchdog's clock.
constexpr std::uint32_t kStep = kStepCounts * kDivider;

[[nodiscard]] std::uint32_t ControlOf(const std::uint32_t steps) noexcept
{
    return (steps - 1U) << kReloadShift; // And the least divider, 8.
}

} // namespace

SystemWatchdog::SystemWatchdog(hal::Clocks& clocks) noexcept : clocks_(clocks)
{
}

Outcome SystemWatchdog::Plan(const SystemWatchdogSetup& setup) noexcept
{
    window_ = setup.window;
    clock_khz_ = setup.clock_khz;
    steps_ = 0U;
    const bool is_window = (setup.window.opens_us < setup.window.ends_us) && (setup.window.ends_us <= kMostPeriodUs);
    if (!is_window || (setup.clock_khz < kKilo) || (setup.clock_khz > kMostClockKhz))
    {
        return Outcome::kFailed;
    }
    steps_ = (setup.window.ends_us * (setup.clock_khz / kKilo)) / kStep;
    const bool is_period = (steps_ != 0U) && (steps_ <= (kMostReload + 1U));
    return (is_period && (PeriodUs() > setup.window.opens_us)) ? Outcome::kDone : Outcome::kFailed;
}

std::uint32_t SystemWatchdog::PeriodUs() const noexcept
{
    return (clock_khz_ < kKilo) ? 0U : ((steps_ * kStep) / (clock_khz_ / kKilo));
}

Outcome SystemWatchdog::Start() noexcept
{
    if (steps_ == 0U)
    {
        return Outcome::kFailed;
    }
    Write(At(kBase, kMode), kModeKey | kResets);
    Write(At(kBase, kControl), kControlKey | ControlOf(steps_));
    Write(At(kBase, kRestart), kRestartKey);
    Write(At(kBase, kMode), kModeKey | kResets | kOn);
    timer_.Start(window_, clocks_.Now().a);
    return Examine();
}

Outcome SystemWatchdog::Examine() noexcept
{
    timer_.Examine(clocks_.Now().a);
    const bool is_on = (Read(At(kBase, kMode)) & kModeMask) == (kResets | kOn);
    const bool same_period = (Read(At(kBase, kControl)) & kControlMask) == ControlOf(steps_);
    return (is_on && same_period && timer_.IsAlive()) ? Outcome::kDone : Outcome::kFailed;
}

hal::WatchdogQuestion SystemWatchdog::Question() noexcept
{
    return timer_.Question();
}

void SystemWatchdog::Answer(const hal::WatchdogAnswer& answer) noexcept
{
    // 0 for the right answer. Both halves spoil the key, each its own way.
    const std::uint32_t right = (hal::kFlowReference + timer_.Question().value) * hal::kWatchdogConstant;
    const std::uint32_t difference = answer.value - right;
    const std::uint32_t halves = (difference >> kHalfBits) | (difference & kLowHalf);
    timer_.Answer(answer, clocks_.Now().a);
    if (timer_.IsAlive())
    {
        Write(At(kBase, kRestart), kRestartKey ^ halves);
    }
}

} // namespace counterpoint::zynqmp
