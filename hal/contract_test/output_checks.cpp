// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kChallenges = 100U;
constexpr std::uint32_t kCycles = 10U;
constexpr std::uint32_t kMoment = 1U;
constexpr const char* kPins = "pins that are high (bit n: slot n)";

[[nodiscard]] bool Begin(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.output == nullptr)
    {
        check.NotShown("the port has no output");
        return false;
    }
    Settle(port);
    return true;
}

/// With an output that opens by the next right permits.
[[nodiscard]] bool BeginArmed(const PortUnderTest& port, Check& check) noexcept
{
    const bool is_there = Begin(port, check);
    if (is_there)
    {
        Arm(port);
    }
    return is_there;
}

[[nodiscard]] std::uint32_t Pins(const PortUnderTest& port) noexcept
{
    return static_cast<std::uint32_t>(port.bench.pins(port.bench.bench) & 0xFFFFFFFFU);
}

/// Cycles with right permits and right answers.
void DriveCycles(const PortUnderTest& port, const std::uint32_t cycles) noexcept
{
    for (std::uint32_t cycle = 0U; cycle < cycles; ++cycle)
    {
        PassCycles(port, 1U);
        Open(port);
    }
}

} // namespace

void ChallengesDiffer(const PortUnderTest& port, Check& check) noexcept
{
    if (!BeginArmed(port, check))
    {
        return;
    }
    std::uint32_t before = 0U;
    for (std::uint32_t number = 0U; number < kChallenges; ++number)
    {
        const std::uint32_t challenge = port.parts.output->Challenge();
        check.Equal("challenges that are 0 or the one before", 0U,
                    ((challenge == 0U) || (challenge == before)) ? 1U : 0U);
        before = challenge;
    }
}

void ClosedAfterStart(const PortUnderTest& port, Check& check) noexcept
{
    if (Begin(port, check))
    {
        check.EqualCode(kPins, 0U, Pins(port));
    }
}

void OpensByThreePermits(const PortUnderTest& port, Check& check) noexcept
{
    if (!BeginArmed(port, check))
    {
        return;
    }
    for (std::uint32_t cycle = 0U; cycle < kCycles; ++cycle)
    {
        DriveCycles(port, 1U);
        check.EqualCode(kPins, 1U, Pins(port));
    }
    port.parts.output->Drive(RightPermits(port.parts.output->Challenge(), 0U));
    port.bench.pass(port.bench.bench, kMoment);
    check.EqualCode("pins that are high by permits for no slot", 0U, Pins(port));
}

void WrongPermitCloses(const PortUnderTest& port, Check& check) noexcept
{
    if (!BeginArmed(port, check))
    {
        return;
    }
    for (std::uint32_t wrong = 0U; wrong < 4U; ++wrong)
    {
        Arm(port);
        DriveCycles(port, 1U);
        check.EqualCode(kPins, 1U, Pins(port));
        const std::uint32_t challenge = port.parts.output->Challenge();
        PermitSet permits = RightPermits((wrong == 3U) ? (challenge - 2U) : challenge, 1U);
        permits.a.response ^= (wrong == 0U) ? 1U : 0U;
        permits.b.response ^= (wrong == 1U) ? 0x80000000U : 0U;
        permits.kernel.response ^= (wrong == 2U) ? 0x100U : 0U;
        port.parts.output->Drive(permits);
        port.bench.pass(port.bench.bench, kMoment);
        check.EqualCode("pins that are high by a wrong permit", 0U, Pins(port));
    }
    Arm(port);
    const PermitSet permits = RightPermits(port.parts.output->Challenge(), 1U);
    port.parts.output->Drive(permits);
    port.parts.output->Drive(permits);
    port.bench.pass(port.bench.bench, kMoment);
    check.EqualCode("pins that are high by permits that were used up", 0U, Pins(port));
}

void InterruptedStaysClosed(const PortUnderTest& port, Check& check) noexcept
{
    if (!BeginArmed(port, check))
    {
        return;
    }
    DriveCycles(port, 1U);
    check.EqualCode(kPins, 1U, Pins(port));
    PermitSet wrong = RightPermits(port.parts.output->Challenge(), 1U);
    wrong.kernel.response ^= 1U;
    port.parts.output->Drive(wrong);
    DriveCycles(port, kCycles);
    check.EqualCode("pins that are high by right permits behind a wrong one", 0U, Pins(port));
    check.Equal("challenge of an interrupted output", 0U, port.parts.output->Challenge());
    Arm(port);
    DriveCycles(port, 1U);
    check.EqualCode("pins that are high once it is armed again", 1U, Pins(port));
}

void ClosesByItself(const PortUnderTest& port, Check& check) noexcept
{
    if (!BeginArmed(port, check))
    {
        return;
    }
    DriveCycles(port, 2U);
    if (port.numbers.gate_limit_us > port.numbers.cycle_us)
    {
        port.bench.pass(port.bench.bench, port.numbers.cycle_us - kMoment);
        check.EqualCode("pins that are high before the limit", 1U, Pins(port));
        Serve(port);
    }
    else
    {
        PassCycles(port, 1U);
    }
    // Limit and one cycle, for a port that looks once a cycle. The watchdog goes on being answered: the gate closes.
    PassCycles(port, port.numbers.gate_limit_us / port.numbers.cycle_us);
    port.bench.pass(port.bench.bench, (port.numbers.gate_limit_us % port.numbers.cycle_us) + port.numbers.tolerance_us);
    check.EqualCode("pins that are high after the limit", 0U, Pins(port));
    const bool is_seen = (port.parts.watchdog != nullptr) && (port.bench.is_alive != nullptr);
    check.Equal("watchdog alive", 1U, (!is_seen || port.bench.is_alive(port.bench.bench)) ? 1U : 0U);
}

void ClosedOnceTripped(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.watchdog == nullptr)
    {
        check.NotShown("the port has no watchdog");
        return;
    }
    if (!BeginArmed(port, check))
    {
        return;
    }
    DriveCycles(port, 2U);
    check.EqualCode(kPins, 1U, Pins(port));
    port.bench.pass(port.bench.bench, port.numbers.cycle_us + port.numbers.window.ends_us);
    check.EqualCode("pins that are high once it has tripped", 0U, Pins(port));
    Arm(port); // What keeps it closed is the watchdog, and not that its time was over.
    DriveCycles(port, 2U);
    check.EqualCode("pins that are high by right permits afterwards", 0U, Pins(port));
}

void PinsAreReadBack(const PortUnderTest& port, Check& check) noexcept
{
    const bool can_hold = (port.bench.hold_pin != nullptr) && (port.bench.read_back != nullptr);
    if ((port.parts.cut_off == nullptr) || !can_hold)
    {
        check.NotShown("the bench cannot pull a pin high, or the port has no reading of it");
        return;
    }
    if (!BeginArmed(port, check))
    {
        return;
    }
    port.parts.cut_off->CutOff();
    port.bench.pass(port.bench.bench, kMoment);
    check.EqualCode("pins that the port reads as high", 0U,
                    static_cast<std::uint32_t>(port.bench.read_back(port.bench.bench)));
    port.bench.hold_pin(port.bench.bench, Hold::kHeld);
    port.bench.pass(port.bench.bench, kMoment);
    check.EqualCode("pins that the port reads as high while slot 0 is held high", 1U,
                    static_cast<std::uint32_t>(port.bench.read_back(port.bench.bench)));
    port.bench.hold_pin(port.bench.bench, Hold::kReleased);
}

void CutOffIsFinal(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.cut_off == nullptr)
    {
        check.NotShown("the port has no cut-off");
        return;
    }
    if (!BeginArmed(port, check))
    {
        return;
    }
    DriveCycles(port, 2U);
    check.EqualCode(kPins, 1U, Pins(port));
    port.parts.cut_off->CutOff();
    check.EqualCode("pins that are high after it", 0U, Pins(port));
    Arm(port);
    DriveCycles(port, kCycles);
    check.EqualCode("pins that are high by right permits afterwards", 0U, Pins(port));
}

} // namespace counterpoint::hal::contract
