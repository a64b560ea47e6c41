// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Outputs on a GIO port (reference manual, chapter GIO, "I/O function"; facts/tms570 2). After reset all pins are
// inputs; a pull-down outside makes that the safe state.
#include "hal/tms570/output/safety_pins.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace gio;

/// A pin follows its output register within some cycles of the bus, loaded as the data sheet allows.
constexpr Looks kPinLooks{64U};

} // namespace

SafetyPins::SafetyPins(hal::Clocks& clocks) noexcept : clocks_(clocks)
{
}

Outcome SafetyPins::Start(const SafetyPinsSetup& setup) noexcept
{
    setup_ = setup;
    live_.Store(0U);
    gate_.Close();
    driven_ = 0U;
    used_ = 0U;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        used_ |= (setup.pins[pin].slots != 0U) ? (1U << pin) : 0U;
    }
    const bool is_port = (setup.port.address == kPortA.address) || (setup.port.address == kPortB.address);
    if (!is_port || (used_ == 0U))
    {
        return Outcome::kFailed;
    }
    Outcome outcome = WriteChecked(At(kBase, kGlobalControl), kOutOfReset, kOutOfReset);
    // Low before they are outputs.
    Write(At(setup.port, kClear), used_);
    const std::uint32_t others = Read(At(setup.port, kDirection)) & ~used_;
    outcome = Both(outcome, WriteChecked(At(setup.port, kOpenDrain), Read(At(setup.port, kOpenDrain)) & ~used_, used_));
    outcome = Both(outcome, WriteChecked(At(setup.port, kDirection), others | used_, used_));
    outcome = Both(outcome, WaitFor(At(setup.port, kInput), Bits{used_, 0U}, kPinLooks));
    if (outcome == Outcome::kDone)
    {
        live_.Store(kLive);
    }
    return outcome;
}

std::uint32_t SafetyPins::Challenge() noexcept
{
    return gate_.Challenge();
}

void SafetyPins::Drive(const hal::PermitSet& permits) noexcept
{
    const Instant now = clocks_.Now().a;
    gate_.Drive(permits, now);
    SetPins(gate_.Open(now, setup_.limit));
}

hal::ProbeAnswer SafetyPins::Probe(const hal::PermitSet& permits, const std::uint32_t challenge) const noexcept
{
    return hal::OutputGate::Probe(permits, challenge);
}

void SafetyPins::CutOff() noexcept
{
    live_.Store(0U);
    // Both ports, whatever the setup says by now; inputs again, so that no later write of an output is seen.
    constexpr RegisterBase kPorts[]{kPortA, kPortB}; // MISRA D-001
    for (const RegisterBase& port : kPorts)
    {
        Write(At(port, kClear), used_);
        Write(At(port, kDirection), Read(At(port, kDirection)) & ~used_);
    }
}

Outcome SafetyPins::Examine() noexcept
{
    if (live_.Load() != kLive)
    {
        return Outcome::kFailed;
    }
    SetPins(gate_.Open(clocks_.Now().a, setup_.limit));
    const bool are_outputs = (Read(At(setup_.port, kDirection)) & used_) == used_;
    const Outcome pins = WaitFor(At(setup_.port, kInput), Bits{used_, driven_}, kPinLooks);
    if (!are_outputs || (pins != Outcome::kDone))
    {
        CutOff();
        return Outcome::kFailed;
    }
    return Outcome::kDone;
}

SrdoMask SafetyPins::Open() noexcept
{
    const bool is_live = live_.Load() == kLive;
    return is_live ? gate_.Open(clocks_.Now().a, setup_.limit) : 0U;
}

void SafetyPins::SetPins(const SrdoMask open) noexcept
{
    std::uint32_t high = 0U;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        const SrdoMask slots = setup_.pins[pin].slots;
        const bool is_open = (slots != 0U) && ((open & slots) == slots);
        high |= is_open ? (1U << pin) : 0U;
    }
    const bool is_live = live_.Load() == kLive;
    driven_ = is_live ? high : 0U;
    Write(At(setup_.port, kClear), used_ & ~driven_);
    Write(At(setup_.port, kSet), driven_);
    // An interrupt may have cut off in between.
    if (live_.Load() != kLive)
    {
        Write(At(setup_.port, kClear), used_);
    }
}

} // namespace counterpoint::tms570
