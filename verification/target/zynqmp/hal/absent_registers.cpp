// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Pins and watchdog, which the emulator's machine does not have, for the drivers of hal/zynqmp as they ship: in an
// image with this file a register of one of the two is a word here that does what gpio_registers.hpp and
// swdt_registers.hpp say of it; every other address is the machine's. It takes the place of
// hal/tms570/silicon/registers.cpp.
#include "hal/zynqmp/chip/cycle_counter.hpp"
#include "hal/zynqmp/output/gpio_registers.hpp"
#include "hal/zynqmp/time/swdt_registers.hpp"
#include "verification/target/zynqmp/hal/machine_registers.hpp"

extern "C"
{
    /// Direction of the pins of each bank. The runner knows the name, and turns a pin behind the driver's back.
    volatile std::uint32_t absent_pin_directions[counterpoint::zynqmp::gpio::kBanks];
}

namespace
{

using namespace counterpoint::zynqmp;

constexpr std::uint32_t kPinsBytes = 0x400U;
constexpr std::uint32_t kWatchdogBytes = 0x10U;
constexpr std::uint32_t kModeKeyBits = 0xFFF000U;
constexpr std::uint32_t kControlKeyBits = 0xFFC000U;
constexpr std::uint32_t kRestartKeyBits = 0xFFFFU;
constexpr std::uint32_t kWatchdogMhz = 100U;
constexpr std::uint32_t kNanosecondsPerMicrosecond = 1000U; // What the emulator's cycle counter counts.

std::uint32_t outputs[gpio::kBanks];
std::uint32_t enabled[gpio::kBanks];
std::uint32_t mode;
std::uint32_t control;
std::uint32_t restarted_at;
bool has_ended;

std::uint32_t PeriodNs() noexcept
{
    const std::uint32_t steps = ((control >> swdt::kReloadShift) & swdt::kMostReload) + 1U;
    return steps * ((swdt::kStepCounts * swdt::kDivider * 10U) / (kWatchdogMhz / 100U));
}

/// At its end the controller is reset: its pins are inputs, and stay so.
void LetTimePass() noexcept
{
    const bool is_over = (mode & swdt::kOn) != 0U && ((ReadCycleCounter() - restarted_at) > PeriodNs());
    has_ended = has_ended || is_over;
    if (has_ended)
    {
        for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
        {
            outputs[bank] = 0U;
            enabled[bank] = 0U;
            absent_pin_directions[bank] = 0U;
        }
    }
}

/// A register of the pins, by its place; nullptr: another one.
volatile std::uint32_t* PinRegister(const std::uint32_t address) noexcept
{
    for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
    {
        if (address == gpio::Output(bank).address)
        {
            return &outputs[bank];
        }
        if (address == gpio::Direction(bank).address)
        {
            return &absent_pin_directions[bank];
        }
        if (address == gpio::OutputEnable(bank).address)
        {
            return &enabled[bank];
        }
    }
    return nullptr;
}

std::uint32_t ReadPins(const std::uint32_t address) noexcept
{
    for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
    {
        if (address == gpio::Input(bank).address)
        {
            return outputs[bank] & absent_pin_directions[bank] & enabled[bank]; // A pull-down is at each.
        }
    }
    const volatile std::uint32_t* const place = PinRegister(address);
    return (place != nullptr) ? *place : 0U;
}

void WritePins(const std::uint32_t address, const std::uint32_t value) noexcept
{
    for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
    {
        if (address == gpio::MaskedLow(bank).address)
        {
            const std::uint32_t pins = ~(value >> gpio::kPins) & gpio::kPinMask;
            outputs[bank] = (outputs[bank] & ~pins) | (value & pins);
            return;
        }
    }
    volatile std::uint32_t* const place = PinRegister(address);
    if (place != nullptr)
    {
        *place = value;
    }
}

std::uint32_t ReadWatchdog(const std::uint32_t offset) noexcept
{
    if (offset == swdt::kMode)
    {
        return mode;
    }
    if (offset == swdt::kControl)
    {
        return control;
    }
    return ((offset == swdt::kStatus) && has_ended) ? swdt::kHasEnded : 0U;
}

void WriteWatchdog(const std::uint32_t offset, const std::uint32_t value) noexcept
{
    const bool is_mode = (offset == swdt::kMode) && ((value & kModeKeyBits) == swdt::kModeKey);
    const bool is_restart = (offset == swdt::kRestart) && ((value & kRestartKeyBits) == swdt::kRestartKey);
    const bool begins = is_mode && ((mode & swdt::kOn) == 0U) && ((value & swdt::kOn) != 0U);
    mode = is_mode ? (value & swdt::kModeMask) : mode;
    if ((offset == swdt::kControl) && ((value & kControlKeyBits) == swdt::kControlKey))
    {
        control = value & swdt::kControlMask;
    }
    if (is_restart || begins)
    {
        restarted_at = ReadCycleCounter();
    }
}

bool IsOfPins(const counterpoint::tms570::Register place) noexcept
{
    return (place.address - gpio::kBase.address) < kPinsBytes;
}

bool IsOfWatchdog(const counterpoint::tms570::Register place) noexcept
{
    return (place.address - swdt::kLowPowerDomain.address) < kWatchdogBytes;
}

} // namespace

namespace counterpoint::tms570
{

std::uint32_t Read(const Register place) noexcept
{
    if (IsOfPins(place))
    {
        LetTimePass();
        return ReadPins(place.address);
    }
    if (IsOfWatchdog(place))
    {
        LetTimePass();
        return ReadWatchdog(place.address - swdt::kLowPowerDomain.address);
    }
    return target::ReadMachine(place.address);
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    if (IsOfPins(place))
    {
        LetTimePass();
        WritePins(place.address, value);
        LetTimePass();
    }
    else if (IsOfWatchdog(place))
    {
        LetTimePass();
        WriteWatchdog(place.address - swdt::kLowPowerDomain.address, value);
    }
    else
    {
        target::WriteMachine(place.address, value);
    }
}

} // namespace counterpoint::tms570
