// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kCycles = 50U;
constexpr const char* kAlive = "alive";

/// Whether the checks of the watchdog can be made; then the device is as after power-on.
[[nodiscard]] bool Begin(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.watchdog == nullptr) || (port.bench.is_alive == nullptr))
    {
        check.NotShown("the port has no watchdog, or the bench does not see what it does");
        return false;
    }
    Settle(port);
    return true;
}

[[nodiscard]] std::uint32_t IsAlive(const PortUnderTest& port) noexcept
{
    return port.bench.is_alive(port.bench.bench) ? 1U : 0U;
}

} // namespace

void QuestionChanges(const PortUnderTest& port, Check& check) noexcept
{
    if (!Begin(port, check))
    {
        return;
    }
    for (std::uint32_t cycle = 0U; cycle < kCycles; ++cycle)
    {
        const std::uint32_t question = port.parts.watchdog->Question().value;
        PassCycles(port, 1U);
        check.Equal("alive after right answers", 1U, IsAlive(port));
        check.Equal("questions that stay the same", 0U, (port.parts.watchdog->Question().value == question) ? 1U : 0U);
    }
}

void EarlyAnswerTrips(const PortUnderTest& port, Check& check) noexcept
{
    if (!Begin(port, check))
    {
        return;
    }
    if (port.numbers.window.opens_us == 0U)
    {
        check.NotShown("the window is open from the start");
        return;
    }
    port.bench.pass(port.bench.bench, port.numbers.window.opens_us / 2U);
    Serve(port);
    port.bench.pass(port.bench.bench, 1U);
    check.Equal(kAlive, 0U, IsAlive(port));
}

void MissingAnswerTrips(const PortUnderTest& port, Check& check) noexcept
{
    if (!Begin(port, check))
    {
        return;
    }
    port.bench.pass(port.bench.bench, port.numbers.cycle_us);
    check.Equal("alive within the window", 1U, IsAlive(port));
    port.bench.pass(port.bench.bench, port.numbers.window.ends_us);
    check.Equal(kAlive, 0U, IsAlive(port));
}

void WrongAnswerTrips(const PortUnderTest& port, Check& check) noexcept
{
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        if (!check.IsHeld() || !Begin(port, check))
        {
            return;
        }
        port.bench.pass(port.bench.bench, port.numbers.cycle_us);
        const std::uint32_t right = (kFlowReference + port.parts.watchdog->Question().value) * kWatchdogConstant;
        port.parts.watchdog->Answer(WatchdogAnswer{right ^ (1U << bit)});
        port.bench.pass(port.bench.bench, 1U);
        check.Equal(kAlive, 0U, IsAlive(port));
    }
}

void TrippedStaysTripped(const PortUnderTest& port, Check& check) noexcept
{
    if (!Begin(port, check))
    {
        return;
    }
    port.bench.pass(port.bench.bench, port.numbers.cycle_us + port.numbers.window.ends_us);
    PassCycles(port, kCycles);
    check.Equal("alive by right answers after it has tripped", 0U, IsAlive(port));
}

} // namespace counterpoint::hal::contract
