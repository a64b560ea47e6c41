// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Time for two processors that run at once, each in a thread of the host: real time would make a verdict of how busy
// the host is. Here time is what both programs do: each reading of a processor's timer is a microsecond more, and no
// processor is more than kAhead before the other one; it waits inside of the reading. Between two readings both run
// free. Timer, cycle counter and time stamps of received frames are made of that time; a frame is as old as its look.
#include "hal/zynqmp/can/canps_registers.hpp"
#include "hal/zynqmp/chip/cycle_counter.hpp"
#include "hal/zynqmp/time/ttc_registers.hpp"
#include "verification/target/zynqmp/hal/machine_registers.hpp"

extern "C"
{
    extern const std::uint8_t image_core[]; // Its address is the number of the processor, plus 1.
    std::uint32_t ProcessorReadCycleControl() noexcept;
    std::uint32_t ProcessorReadCycleEnable() noexcept;
    std::uint32_t ProcessorReadCycleUserMode() noexcept;
    void ProcessorWriteCycleControl(std::uint32_t value) noexcept;
    void ProcessorWriteCycleEnable(std::uint32_t value) noexcept;
    void ProcessorWriteCycleUserMode(std::uint32_t value) noexcept;
}

namespace
{

using namespace counterpoint::zynqmp;

/// Less than half of what an answer takes: who sends has looked again before the other processor can have answered.
constexpr std::uint32_t kAhead = 400U;
constexpr std::uint32_t kLeft = 0x7FFFFFFFU; ///< Of a processor that has stopped its timer.
constexpr std::uint32_t kTimes = 0xFFFDD000U;
constexpr std::uint32_t kTimeBytes = 0x40U;
constexpr std::uint32_t kTimerBytes = 0x00010000U;
constexpr std::uint32_t kCanBytes = 0x00010000U;
constexpr std::uint32_t kNanosecondsPerMicrosecond = 1000U;
constexpr std::uint32_t kCanMhz = 24U;
/// 1064 / 1024 are the 1.0390625 MHz of the emulator's timer behind its prescaler.
constexpr std::uint32_t kTimerCounts = 1064U;
constexpr std::uint32_t kTimerShift = 10U;

std::uint32_t passed;      ///< Microseconds of this processor.
std::uint32_t set_back_at; ///< Of the timer.
std::uint32_t cleared_at;  ///< Of the time stamps.
bool does_run;

std::uint32_t Core() noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(image_core)) - 1U;
}

volatile std::uint32_t& TimeOf(const std::uint32_t core) noexcept
{
    return *reinterpret_cast<volatile std::uint32_t*>(kTimes + (core * kTimeBytes));
}

std::uint32_t TimerValue() noexcept
{
    ++passed;
    TimeOf(Core()) = passed;
    while (passed > (TimeOf(1U - Core()) + kAhead))
    {
        asm volatile("wfe");
    }
    return (((passed - set_back_at) * kTimerCounts) >> kTimerShift) & 0xFFFFU;
}

void ControlTimer(const std::uint32_t value) noexcept
{
    const bool stops = (value & ttc::kStopped) != 0U;
    if (stops && does_run)
    {
        TimeOf(Core()) = kLeft;
    }
    does_run = !stops;
    set_back_at = passed;
}

std::uint32_t Plain(const std::uint32_t address) noexcept
{
    return *reinterpret_cast<const volatile std::uint32_t*>(address);
}

} // namespace

namespace counterpoint::target
{

std::uint32_t ReadMachine(const std::uint32_t address) noexcept
{
    const std::uint32_t timer = ttc::kTtc0.address + (Core() * kTimerBytes);
    const std::uint32_t can = canps::kCan0.address + (Core() * kCanBytes);
    if (address == (timer + ttc::kCounterValue))
    {
        return TimerValue();
    }
    if (address == (timer + ttc::kCounterControl))
    {
        return does_run ? ttc::kWaveformOff : (ttc::kWaveformOff | ttc::kStopped);
    }
    const std::uint32_t value = Plain(address);
    if (address == (can + canps::kReceive + canps::kLengthWord))
    {
        return (value & ~canps::kTimeStampMask) | (((passed - cleared_at) * kCanMhz) & canps::kTimeStampMask);
    }
    return value;
}

void WriteMachine(const std::uint32_t address, const std::uint32_t value) noexcept
{
    if (address == (ttc::kTtc0.address + (Core() * kTimerBytes) + ttc::kCounterControl))
    {
        ControlTimer(value);
        return;
    }
    if (address == (canps::kCan0.address + (Core() * kCanBytes) + canps::kTimeStamp))
    {
        cleared_at = passed;
    }
    *reinterpret_cast<volatile std::uint32_t*>(address) = value;
}

} // namespace counterpoint::target

namespace counterpoint::zynqmp
{

void SetUpCycles(const CycleSetup& setup) noexcept
{
    ProcessorWriteCycleUserMode(setup.user);
    ProcessorWriteCycleControl(setup.control);
    ProcessorWriteCycleEnable(setup.enabled);
}

CycleSetup ReadCycleSetup() noexcept
{
    return CycleSetup{ProcessorReadCycleControl(), ProcessorReadCycleEnable(), ProcessorReadCycleUserMode()};
}

std::uint32_t ReadCycleCounter() noexcept
{
    return passed * kNanosecondsPerMicrosecond;
}

} // namespace counterpoint::zynqmp
