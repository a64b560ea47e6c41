// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Triple timer counter (ttc_registers.hpp) and cycle counter (ARM DDI 0460, "Performance Monitoring
// Unit").
#include "hal/zynqmp/time/counters.hpp"

#include "hal/zynqmp/chip/cycle_counter.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"

namespace counterpoint::zynqmp
{

namespace
{

using namespace ttc;

constexpr std::uint32_t kComparedControl = kCyclesOn | kCyclesEach64th;
/// A look takes some cycles of the bus; the time that the start watches has passed long before.
constexpr std::uint32_t kMostLooks = 100000U;
constexpr std::uint32_t kWatchedUs = 20U;
constexpr std::uint32_t kMostApartAtStartUs = 3U;

[[nodiscard]] std::uint32_t ClockControl(const CountersSetup& setup) noexcept
{
    return ((setup.timer_power - 1U) << kPrescalerShift) | kPrescalerOn;
}

[[nodiscard]] bool IsRate(const CounterRate& rate) noexcept
{
    constexpr std::uint32_t kLeastHertz = 1000000U;
    constexpr std::uint32_t kMostHertz = 2000000000U;
    const bool is_speed = (rate.hertz > kLeastHertz) && (rate.hertz <= kMostHertz);
    return is_speed && (rate.bits >= 16U) && (rate.bits <= 32U);
}

[[nodiscard]] std::uint32_t Distance(const std::uint32_t one, const std::uint32_t other) noexcept
{
    return (one > other) ? (one - other) : (other - one);
}

} // namespace

Outcome Counters::Start(const CountersSetup& setup) noexcept
{
    setup_ = setup;
    outcome_ = Outcome::kFailed;
    const bool is_power = (setup.timer_power != 0U) && (setup.timer_power <= kMostPower);
    if (!is_power || !IsRate(setup.timer_rate) || !IsRate(setup.processor_rate) || (setup.compare_us == 0U))
    {
        return Outcome::kFailed;
    }
    Write(At(setup.timer, kCounterControl), kWaveformOff | kStopped);
    Write(At(setup.timer, kInterruptEnable), 0U);
    const Outcome clock = WriteChecked(At(setup.timer, kClockControl), ClockControl(setup), kWholeWord);
    Write(At(setup.timer, kCounterControl), kWaveformOff | kRestart);
    SetUpCycles(CycleSetup{kCyclesOn | kCyclesReset, kCycleCounterOn, 0U});
    // Read together: the start of a scale takes some microseconds.
    const std::uint32_t timer = Read(At(setup.timer, kCounterValue));
    const std::uint32_t cycles = ReadCycleCounter();
    timer_.Start(setup.timer_rate, timer);
    processor_.Start(setup.processor_rate, cycles);
    InstantPair now = Now();
    for (std::uint32_t look = 0U; (look < kMostLooks) && ((now.a.us < kWatchedUs) || (now.b.us < kWatchedUs)); ++look)
    {
        now = Now();
    }
    const bool both_run = (now.a.us >= kWatchedUs) && (now.b.us >= kWatchedUs);
    const bool are_together = Distance(now.a.us, now.b.us) <= kMostApartAtStartUs;
    compared_ = now;
    outcome_ = (both_run && are_together && IsSetUp()) ? clock : Outcome::kFailed;
    return outcome_;
}

InstantPair Counters::Now() noexcept
{
    const std::uint32_t timer = Read(At(setup_.timer, kCounterValue));
    const std::uint32_t cycles = ReadCycleCounter();
    const InstantPair now{timer_.Take(timer), processor_.Take(cycles)};
    if ((setup_.set_back_from != 0U) && (timer >= setup_.set_back_from))
    {
        Write(At(setup_.timer, kCounterControl), kWaveformOff | kRestart);
        timer_.SetBack();
    }
    return now;
}

bool Counters::IsSetUp() const noexcept
{
    const bool same_clock = Read(At(setup_.timer, kClockControl)) == ClockControl(setup_);
    const bool same_control = (Read(At(setup_.timer, kCounterControl)) & (kWaveformOff | kStopped)) == kWaveformOff;
    const CycleSetup cycles = ReadCycleSetup();
    const bool is_counting = ((cycles.enabled & kCycleCounterOn) != 0U) && (cycles.user == 0U);
    const bool each_cycle = (cycles.control & kComparedControl) == kCyclesOn;
    return same_clock && same_control && is_counting && each_cycle;
}

bool Counters::AreTogether(const InstantPair& now) const noexcept
{
    return Distance(now.a.us - compared_.a.us, now.b.us - compared_.b.us) <= setup_.most_apart_us;
}

Outcome Counters::Examine() noexcept
{
    const InstantPair now = Now();
    if ((outcome_ != Outcome::kDone) || !IsSetUp() || !AreTogether(now))
    {
        outcome_ = Outcome::kFailed;
        return outcome_;
    }
    const bool is_over = ((now.a.us - compared_.a.us) >= setup_.compare_us);
    compared_ = is_over ? now : compared_;
    return outcome_;
}

} // namespace counterpoint::zynqmp
