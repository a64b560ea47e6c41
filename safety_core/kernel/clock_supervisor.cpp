// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/clock_supervisor.hpp"

#include "safety_core/kernel/limits.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kSignBit = 31U;
constexpr std::uint32_t kLeastCycles = 4U;

std::uint32_t Apart(const std::uint32_t left, const std::uint32_t right) noexcept
{
    return (left > right) ? (left - right) : (right - left);
}

} // namespace

std::uint32_t ClockSupervisor::LeastIntervalUs(const DeviceConfig& config) noexcept
{
    return kLeastCycles * LateCycleUs(config);
}

void ClockSupervisor::Restart(const DeviceConfig& config) noexcept
{
    late_us_ = LateCycleUs(config);
    window_us_ = (config.clock_interval_us - late_us_) / 2U;
    // The share of the tolerance that belongs to a window. One late cycle is as good as `cycles`-th of the interval,
    // rounded up. Kernel::Start has made sure that there are some.
    const std::uint32_t cycles = config.clock_interval_us / (late_us_ + 1U);
    tolerance_us_ = (config.clock_tolerance_us - ((config.clock_tolerance_us + (cycles - 1U)) / cycles)) / 2U;
    started_ = false;
}

DeviceFault ClockSupervisor::OnCycle(const InstantPair& now) noexcept
{
    OnFrame(now);
    const bool is_ordered = (disorder_ >> kSignBit) == 0U;
    disorder_ = 0U;
    if (!started_)
    {
        reference_ = now;
        previous_ = now;
        started_ = true;
        return DeviceFault::kNone;
    }

    DeviceFault fault = is_ordered ? DeviceFault::kNone : DeviceFault::kFrameOrder;
    if (((now.a.us - previous_.a.us) > late_us_) || ((now.b.us - previous_.b.us) > late_us_))
    {
        fault = DeviceFault::kLateCall;
    }
    // Last, because a counter that runs wild also looks like a late call or like frames out of order.
    const std::uint32_t progress_a_us = now.a.us - reference_.a.us;
    const std::uint32_t progress_b_us = now.b.us - reference_.b.us;
    if (Apart(progress_a_us, progress_b_us) > tolerance_us_)
    {
        fault = DeviceFault::kClock;
    }
    if ((progress_a_us >= window_us_) || (progress_b_us >= window_us_))
    {
        reference_ = now;
    }
    previous_ = now;
    return fault;
}

} // namespace counterpoint
