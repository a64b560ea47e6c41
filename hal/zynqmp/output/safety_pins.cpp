// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Outputs on pins of the controller (gpio_registers.hpp). After reset all pins are inputs; a pull-down outside
// makes that the safe state.
#include "hal/zynqmp/output/safety_pins.hpp"

#include "hal/zynqmp/output/cut_off.hpp"

namespace counterpoint::zynqmp
{

namespace
{

using namespace gpio;

/// A pin follows its output register within some cycles of the bus, loaded as the data sheet allows.
constexpr Looks kPinLooks{64U};
constexpr std::uint32_t kOwnBanks = 3U;

[[nodiscard]] Outcome MakeOutputs(const std::uint32_t bank, const std::uint32_t pins) noexcept
{
    // Low before they are outputs.
    Write(MaskedLow(bank), Masked(pins, 0U));
    const std::uint32_t direction = Read(Direction(bank)) | pins;
    const Outcome are_outputs = WriteChecked(Direction(bank), direction, pins);
    const std::uint32_t enabled = Read(OutputEnable(bank)) | pins;
    const Outcome are_on = WriteChecked(OutputEnable(bank), enabled, pins);
    return Both(are_outputs, Both(are_on, WaitFor(Input(bank), Bits{pins, 0U}, kPinLooks)));
}

} // namespace

SafetyPins::SafetyPins(hal::Clocks& clocks, const SafetyPinsSetup& setup) noexcept : clocks_(clocks), setup_(setup)
{
}

Outcome SafetyPins::Start() noexcept
{
    live_ = 0U;
    gate_.Close();
    driven_ = 0U;
    driven_copy_ = ~driven_;
    copy_.gate_bank = ~setup_.gate_bank;
    copy_.other_bank = ~setup_.other_bank;
    copy_.outputs = ~setup_.outputs;
    copy_.limit.us = ~setup_.limit.us;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        copy_.slots[pin] = ~setup_.slots[pin];
    }
    const bool are_banks =
        (setup_.gate_bank < kOwnBanks) && (setup_.other_bank < kOwnBanks) && (setup_.gate_bank != setup_.other_bank);
    if (!are_banks || ((setup_.outputs & ~kPinMask) != 0U))
    {
        return Outcome::kFailed;
    }
    Outcome outcome = MakeOutputs(setup_.gate_bank, Used());
    outcome = Both(outcome, MakeOutputs(setup_.other_bank, setup_.outputs));
    if (outcome == Outcome::kDone)
    {
        live_ = kLive;
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
    SetPins(now);
}

hal::ProbeAnswer SafetyPins::Probe(const hal::PermitSet& permits, const std::uint32_t challenge) const noexcept
{
    return hal::OutputGate::Probe(permits, challenge);
}

void SafetyPins::CutOff() noexcept
{
    live_ = 0U;
    CloseAllPins();
}

Outcome SafetyPins::Examine() noexcept
{
    // Before anything is written: what was wrong since the last Drive must not be mended unseen.
    if ((live_ != kLive) || !IsSetUp() || !DoPinsFollow())
    {
        CutOff();
        return Outcome::kFailed;
    }
    SetPins(clocks_.Now().a);
    return (live_ == kLive) ? Outcome::kDone : Outcome::kFailed;
}

SrdoMask SafetyPins::Open() noexcept
{
    return (live_ == kLive) ? gate_.Open(clocks_.Now().a, setup_.limit) : 0U;
}

std::uint32_t SafetyPins::Inputs() noexcept
{
    return Read(Input(setup_.other_bank)) & ~setup_.outputs & kPinMask;
}

// Bit 0 of the device's outputs is the lowest of its output pins.
void SafetyPins::SetOutputs(const std::uint32_t bits) noexcept
{
    if (live_ == kLive)
    {
        const std::uint32_t lowest = setup_.outputs & (~setup_.outputs + 1U);
        Write(MaskedLow(setup_.other_bank), Masked(setup_.outputs, bits * lowest));
    }
}

bool SafetyPins::IsSetUp() const noexcept
{
    const std::uint32_t banks = (setup_.gate_bank ^ copy_.gate_bank) & (setup_.other_bank ^ copy_.other_bank);
    const std::uint32_t rest = (setup_.outputs ^ copy_.outputs) & (setup_.limit.us ^ copy_.limit.us);
    return (banks & rest & (driven_ ^ driven_copy_)) == ~0U;
}

bool SafetyPins::DoPinsFollow() const noexcept
{
    const std::uint32_t used = Used();
    const std::uint32_t on = Read(Direction(setup_.gate_bank)) & Read(OutputEnable(setup_.gate_bank));
    const Outcome follow = WaitFor(Input(setup_.gate_bank), Bits{used, driven_}, kPinLooks);
    return ((on & used) == used) && (follow == Outcome::kDone);
}

// Pins of which every slot is open.
std::uint32_t SafetyPins::High(const SrdoMask open) const noexcept
{
    std::uint32_t high = 0U;
    for (std::uint32_t pin = 0U; pin < kPins; ++pin)
    {
        const SrdoMask slots = setup_.slots[pin];
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

// Pins that are gates.
std::uint32_t SafetyPins::Used() const noexcept
{
    return Low(~SrdoMask{0U});
}

// Twice: by the setup and by its copy, each with a reading of the gate of its own.
void SafetyPins::SetPins(const Instant now) noexcept
{
    const std::uint32_t high = High(gate_.Open(now, setup_.limit));
    const std::uint32_t low = Low(~gate_.Open(now, hal::GateLimit{~copy_.limit.us}));
    const std::uint32_t used = Used();
    const bool is_one_answer = (high ^ low) == used;
    if ((live_ != kLive) || !IsSetUp() || !is_one_answer)
    {
        CutOff();
        return;
    }
    driven_ = high;
    driven_copy_ = low | ~used;
    Write(MaskedLow(setup_.gate_bank), Masked(used, high));
}

} // namespace counterpoint::zynqmp
