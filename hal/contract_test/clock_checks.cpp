// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kCycles = 10U;
constexpr std::uint32_t kReadings = 1000U;
/// The greatest difference of two instants that means "later".
constexpr std::uint32_t kHalfWrap = 0x7FFFFFFFU;
constexpr const char* kNoClocks = "the port has no clocks";

/// Both counters over some cycles, and what they must have done.
struct Progress
{
    std::uint32_t a;
    std::uint32_t b;
};

[[nodiscard]] Progress ProgressOver(const PortUnderTest& port, const std::uint32_t cycles) noexcept
{
    const InstantPair before = port.parts.clocks->Now();
    PassCycles(port, cycles);
    const InstantPair after = port.parts.clocks->Now();
    return Progress{after.a.us - before.a.us, after.b.us - before.b.us};
}

[[nodiscard]] Span Around(const PortUnderTest& port, const std::uint32_t us) noexcept
{
    const std::uint32_t tolerance = port.numbers.tolerance_us;
    return Span{(us > tolerance) ? (us - tolerance) : 1U, us + tolerance};
}

} // namespace

void BothCountersGoOn(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.clocks == nullptr)
    {
        check.NotShown(kNoClocks);
        return;
    }
    Settle(port);
    const Progress progress = ProgressOver(port, kCycles);
    const Span expected = Around(port, kCycles * port.numbers.cycle_us);
    check.Within("us of counter A in 10 cycles", expected, progress.a);
    check.Within("us of counter B in 10 cycles", expected, progress.b);
}

void CountersNeverGoBack(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.clocks == nullptr)
    {
        check.NotShown(kNoClocks);
        return;
    }
    Settle(port);
    InstantPair before = port.parts.clocks->Now();
    for (std::uint32_t reading = 0U; reading < kReadings; ++reading)
    {
        const InstantPair now = port.parts.clocks->Now();
        check.Within("us of counter A between two readings", Span{0U, kHalfWrap}, now.a.us - before.a.us);
        check.Within("us of counter B between two readings", Span{0U, kHalfWrap}, now.b.us - before.b.us);
        before = now;
    }
}

void CountersAreIndependent(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.clocks == nullptr) || (port.bench.hold_counter == nullptr))
    {
        check.NotShown("the bench cannot stop one of the counters");
        return;
    }
    Settle(port);
    // Held for different times, so that the counters are apart afterwards and no stamp can be of the wrong one unseen.
    port.bench.hold_counter(port.bench.bench, Counter::kA, Hold::kHeld);
    const Progress without_a = ProgressOver(port, 2U * kCycles);
    port.bench.hold_counter(port.bench.bench, Counter::kA, Hold::kReleased);
    port.bench.hold_counter(port.bench.bench, Counter::kB, Hold::kHeld);
    const Progress without_b = ProgressOver(port, kCycles);
    port.bench.hold_counter(port.bench.bench, Counter::kB, Hold::kReleased);
    const std::uint32_t cycle_us = port.numbers.cycle_us;
    check.Within("us of counter A while its source stands", Span{0U, port.numbers.tolerance_us}, without_a.a);
    check.Within("us of counter B while the source of A stands", Around(port, 2U * kCycles * cycle_us), without_a.b);
    check.Within("us of counter B while its source stands", Span{0U, port.numbers.tolerance_us}, without_b.b);
    check.Within("us of counter A while the source of B stands", Around(port, kCycles * cycle_us), without_b.a);
}

void CountersDoNotWrapEarly(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.clocks == nullptr) || (port.numbers.long_time_us == 0U))
    {
        check.NotShown("long_time_us is 0");
        return;
    }
    Settle(port);
    // A counter of processor cycles that is divided after it has wrapped goes back to 0 after some seconds.
    const std::uint32_t rounds = port.numbers.long_time_us / (kCycles * port.numbers.cycle_us);
    for (std::uint32_t round = 0U; (round < rounds) && check.IsHeld(); ++round)
    {
        const Progress progress = ProgressOver(port, kCycles);
        const Span expected = Around(port, kCycles * port.numbers.cycle_us);
        check.Within("us of counter A in 10 cycles", expected, progress.a);
        check.Within("us of counter B in 10 cycles", expected, progress.b);
    }
}

} // namespace counterpoint::hal::contract
