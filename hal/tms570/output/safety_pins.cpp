// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Outputs on a GIO port (reference manual, chapter GIO, "I/O function"; facts/tms570 2). After reset all pins are
// inputs; a pull-down outside makes that the safe state.
#include "hal/tms570/output/safety_pins.hpp"

#include "hal/tms570/diagnosis/esm.hpp"
#include "hal/tms570/output/cut_off.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace gio;

/// A pin follows its output register within some cycles of the bus, loaded as the data sheet allows.
constexpr Looks kPinLooks{64U};

[[nodiscard]] bool IsPort(const RegisterBase port) noexcept
{
    return (port.address == kPortA.address) || (port.address == kPortB.address);
}

} // namespace

SafetyPins::SafetyPins(hal::Clocks& clocks) noexcept : clocks_(clocks)
{
}

Outcome SafetyPins::Start(const SafetyPinsSetup& setup) noexcept
{
    live_.Store(0U);
    gate_.Close();
    driven_ = 0U;
    driven_copy_ = ~driven_;
    setup_ = setup;
    copy_.port_address = ~setup.port.address;
    copy_.limit_us = ~setup.limit.us;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        copy_.slots[pin] = ~setup.pins[pin].slots;
    }
    const std::uint32_t used = Used();
    if ((!IsPort(setup.port)) || (used == 0U))
    {
        return Outcome::kFailed;
    }
    Outcome outcome = WriteChecked(At(kBase, kGlobalControl), kOutOfReset, kOutOfReset);
    // Low before they are outputs.
    Write(At(setup.port, kClear), used);
    const std::uint32_t others = Read(At(setup.port, kDirection)) & ~used;
    outcome = Both(outcome, WriteChecked(At(setup.port, kOpenDrain), Read(At(setup.port, kOpenDrain)) & ~used, used));
    outcome = Both(outcome, WriteChecked(At(setup.port, kDirection), others | used, used));
    outcome = Both(outcome, WaitFor(At(setup.port, kInput), Bits{used, 0U}, kPinLooks));
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

// Pins follow the gate alone, which does not open once it was interrupted. [SRS_TMS_300]
void SafetyPins::Drive(const hal::PermitSet& permits) noexcept
{
    const Instant now = clocks_.Now().a;
    gate_.Drive(permits, now);
    SetPins(now);
}

hal::ProbeAnswer SafetyPins::Probe(const hal::PermitSet& permits, const std::uint32_t challenge) const noexcept
{
    return hal::OutputGate::Probe(permits, challenge);
}

void SafetyPins::CutOff() noexcept
{
    live_.Store(0U);
    CloseAllPins();
    if ((Read(At(kPortA, kDirection)) | Read(At(kPortB, kDirection))) != 0U)
    {
        CloseAllPins();
        ForceErrorPin();
    }
}

Outcome SafetyPins::Examine() noexcept
{
    // Before anything is written: what was wrong since the last Drive must not be mended unseen.
    if ((live_.Load() != kLive) || (!IsSetUp()) || (!DoPinsFollow()))
    {
        CutOff();
        return Outcome::kFailed;
    }
    SetPins(clocks_.Now().a);
    return (live_.Load() == kLive) ? Outcome::kDone : Outcome::kFailed;
}

SrdoMask SafetyPins::Open() noexcept
{
    const bool is_live = live_.Load() == kLive;
    return is_live ? gate_.Open(clocks_.Now().a, setup_.limit) : 0U;
}

bool SafetyPins::IsSetUp() const noexcept
{
    const std::uint32_t members = (setup_.port.address ^ copy_.port_address) & (setup_.limit.us ^ copy_.limit_us);
    return ((members & (driven_ ^ driven_copy_)) == ~0U) && IsPort(setup_.port);
}

bool SafetyPins::DoPinsFollow() const noexcept
{
    const std::uint32_t used = Used();
    const bool are_outputs = (Read(At(setup_.port, kDirection)) & used) == used;
    return are_outputs && (WaitFor(At(setup_.port, kInput), Bits{used, driven_}, kPinLooks) == Outcome::kDone);
}

// Pins of which every slot is open.
std::uint32_t SafetyPins::High(const SrdoMask open) const noexcept
{
    std::uint32_t high = 0U;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        const SrdoMask slots = setup_.pins[pin].slots;
        const bool is_open = (slots != 0U) && ((open & slots) == slots);
        high |= is_open ? (1U << pin) : 0U;
    }
    return high;
}

// Pins that have a closed slot, by the copy of the setup.
std::uint32_t SafetyPins::Low(const SrdoMask closed) const noexcept
{
    std::uint32_t low = 0U;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        low |= ((~copy_.slots[pin] & closed) != 0U) ? (1U << pin) : 0U;
    }
    return low;
}

// Pins that are safety outputs.
std::uint32_t SafetyPins::Used() const noexcept
{
    return Low(~SrdoMask{0U});
}

// Twice: by the setup and by its copy, each with a reading of the gate of its own.
void SafetyPins::SetPins(const Instant now) noexcept
{
    const std::uint32_t high = High(gate_.Open(now, setup_.limit));
    const std::uint32_t low = Low(~gate_.Open(now, hal::GateLimit{~copy_.limit_us}));
    const std::uint32_t used = Used();
    const bool is_one_answer = (high ^ low) == used;
    if ((live_.Load() != kLive) || (!IsSetUp()) || (!is_one_answer))
    {
        CutOff();
        return;
    }
    driven_ = high;
    driven_copy_ = low | ~used;
    Write(At(setup_.port, kClear), low);
    Write(At(setup_.port, kSet), high);
    // An interrupt may have cut off in between.
    if (live_.Load() != kLive)
    {
        CloseAllPins();
    }
}

} // namespace counterpoint::tms570
