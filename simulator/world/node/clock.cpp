// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/clock.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr std::int64_t kMillion = 1000000;

Nanoseconds Scaled(const std::uint32_t cycle_us)
{
    return std::int64_t{cycle_us} * kNanosecondsPerMicrosecond * kMillion;
}
} // namespace

NodeClock::NodeClock(const host::VirtualBus& bus, const NodeSetup& setup, const std::uint32_t cycle_us)
    : bus_(bus), setup_(setup), counters_(bus, {{setup.counter_a.start_us}, {setup.counter_b.start_us}}),
      is_one_of_two_(setup.role != runtime::CpuRole::kWhole), oscillator_(kMillion + setup.counter_a.drift_ppm),
      cycle_ns_(Scaled(cycle_us) / oscillator_), cycle_fraction_(Scaled(cycle_us) % oscillator_),
      next_cycle_(setup.phase)
{
    SetRate(true, setup.counter_a.drift_ppm);
    SetRate(false, setup.counter_b.drift_ppm);
}

void NodeClock::Begin() noexcept
{
    fraction_sum_ = 0;
    next_cycle_ = bus_.Now();
    Advance();
}

void NodeClock::Advance() noexcept
{
    next_cycle_ += cycle_ns_;
    fraction_sum_ += cycle_fraction_;
    if (fraction_sum_ >= oscillator_)
    {
        fraction_sum_ -= oscillator_;
        ++next_cycle_;
    }
}

void NodeClock::Shift(const Nanoseconds by) noexcept
{
    next_cycle_ = std::max(next_cycle_ + by, bus_.Now());
}

void NodeClock::SetRate(const bool is_counter_a, const std::int32_t drift_ppm)
{
    host::HostClock& counter = is_counter_a ? counters_.A() : counters_.B();
    counter.SetRate(bus_.Now(), static_cast<std::uint32_t>(kMillion + drift_ppm));
}

void NodeClock::Jump(const bool is_counter_a, const Nanoseconds by)
{
    host::HostClock& counter = is_counter_a ? counters_.A() : counters_.B();
    counter.Jump(bus_.Now(), static_cast<std::int32_t>(by / kNanosecondsPerMicrosecond));
}

void NodeClock::RestartCounters()
{
    const InstantPair now = counters_.Now();
    counters_.A().Jump(bus_.Now(), static_cast<std::int32_t>(setup_.counter_a.start_us - now.a.us));
    counters_.B().Jump(bus_.Now(), static_cast<std::int32_t>(setup_.counter_b.start_us - now.b.us));
}

InstantPair NodeClock::Instants() noexcept
{
    const InstantPair now = counters_.Now();
    return is_one_of_two_ ? InstantPair{now.a, now.a} : now;
}

StampedFrame NodeClock::Stamped(const StampedFrame& frame) const noexcept
{
    StampedFrame stamped = frame;
    stamped.stamp.b = is_one_of_two_ ? frame.stamp.a : frame.stamp.b;
    return stamped;
}
} // namespace counterpoint::simulator
