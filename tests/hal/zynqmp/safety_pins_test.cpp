// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Pins that do not follow at the start, one register and one pin at a time. The registers are words of the test.
#include "hal/zynqmp/output/safety_pins.hpp"

#include "verification/trace/ids/zynqmp_hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>

namespace counterpoint::zynqmp
{
namespace
{

/// A pin that does not follow: of the register at `place` the bits of `low` stay 0 and those of `high` 1.
struct Machine
{
    std::map<std::uint32_t, std::uint32_t> words;
    std::uint32_t place;
    std::uint32_t low;
    std::uint32_t high;
};
Machine machine;

std::uint32_t WordOf(const Register place)
{
    const std::uint32_t word = machine.words[place.address];
    return (place.address == machine.place) ? ((word & ~machine.low) | machine.high) : word;
}

/// What a pin is: driven where it is an output whose driver is on, else 0 by its pull-down.
std::uint32_t PinsOf(const std::uint32_t bank)
{
    return WordOf(gpio::Output(bank)) & WordOf(gpio::Direction(bank)) & WordOf(gpio::OutputEnable(bank));
}

class Time final : public hal::Clocks
{
  public:
    InstantPair Now() noexcept override
    {
        return InstantPair{Instant{1000U}, Instant{1000U}};
    }
};

constexpr std::uint32_t kGates = 0U;
constexpr std::uint32_t kOthers = 1U;

/// The formula of contract/channel.hpp for slots below 32, written down once more.
Permit PermitOf(const std::uint32_t challenge, const std::uint32_t mask, const std::uint32_t constant)
{
    return Permit{mask, (challenge + mask) * constant};
}

/// Pins 0 and 2 of bank 0 are the gates of slots 0 and 1, pins 4 and 5 of bank 1 outputs.
class SafetyPinsTest : public testing::Test
{
  protected:
    Outcome StartWith(const Register place, const std::uint32_t low, const std::uint32_t high)
    {
        machine = Machine{{}, place.address, low, high};
        return pins_.Start();
    }
    /// Slots that are open behind three right permits for both.
    SrdoMask Opened()
    {
        pins_.Drive(hal::PermitSet{}); // What a start gives: the gate is armed.
        const std::uint32_t challenge = pins_.Challenge();
        pins_.Drive(hal::PermitSet{PermitOf(challenge, 3U, 0x9E3779B1U), PermitOf(challenge, 3U, 0x85EBCA77U),
                                   PermitOf(challenge, 3U, 0xC2B2AE3DU)});
        return pins_.Open();
    }
    void ExpectRefused(const Register place, const std::uint32_t low, const std::uint32_t high)
    {
        EXPECT_EQ(StartWith(place, low, high), Outcome::kFailed) << place.address << " " << low << " " << high;
        EXPECT_EQ(Opened(), 0U) << place.address << " " << low << " " << high;
        EXPECT_EQ(PinsOf(kGates) & ~high, 0U) << place.address << " " << low << " " << high;
    }

    Time time_{};
    SafetyPinsSetup setup_{kGates, {1U, 0U, 2U}, kOthers, 0x30U, hal::GateLimit{1500U}};
    SafetyPins pins_{time_, setup_};
};

TEST_F(SafetyPinsTest, PinsThatFollowStartAndOpen)
{
    Verifies(req::SRS_ZYN_062);
    EXPECT_EQ(StartWith(Register{0U}, 0U, 0U), Outcome::kDone);
    EXPECT_EQ(PinsOf(kGates), 0U);
    EXPECT_EQ(machine.words[gpio::Direction(kGates).address], 0x05U);
    EXPECT_EQ(machine.words[gpio::OutputEnable(kGates).address], 0x05U);
    EXPECT_EQ(machine.words[gpio::Direction(kOthers).address], 0x30U);
    EXPECT_EQ(machine.words[gpio::OutputEnable(kOthers).address], 0x30U);
    EXPECT_EQ(Opened(), 3U);
    EXPECT_EQ(PinsOf(kGates), 0x05U);
    // Near misses: what a pin that nobody uses does
    EXPECT_EQ(StartWith(gpio::Direction(kGates), 0x02U, 0U), Outcome::kDone);
    EXPECT_EQ(StartWith(gpio::Input(kGates), 0U, 0x08U), Outcome::kDone);
}

TEST_F(SafetyPinsTest, APinWhoseDirectionDriverOrLevelIsAnotherRefusesTheStart)
{
    Verifies(req::SRS_ZYN_062);
    for (const std::uint32_t pin : {0x01U, 0x04U})
    {
        ExpectRefused(gpio::Direction(kGates), pin, 0U);
        ExpectRefused(gpio::OutputEnable(kGates), pin, 0U);
        ExpectRefused(gpio::Input(kGates), 0U, pin);
    }
    for (const std::uint32_t pin : {0x10U, 0x20U})
    {
        ExpectRefused(gpio::Direction(kOthers), pin, 0U);
        ExpectRefused(gpio::OutputEnable(kOthers), pin, 0U);
        ExpectRefused(gpio::Input(kOthers), 0U, pin);
    }
}

} // namespace
} // namespace counterpoint::zynqmp

namespace counterpoint::tms570
{

std::uint32_t Read(const Register place) noexcept
{
    using namespace zynqmp;
    for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
    {
        if (place.address == gpio::Input(bank).address)
        {
            return PinsOf(bank) | ((place.address == machine.place) ? machine.high : 0U);
        }
    }
    return WordOf(place);
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    using namespace zynqmp;
    for (std::uint32_t bank = 0U; bank < gpio::kBanks; ++bank)
    {
        if (place.address == gpio::MaskedLow(bank).address)
        {
            const std::uint32_t pins = ~(value >> gpio::kPins) & gpio::kPinMask;
            std::uint32_t& output = machine.words[gpio::Output(bank).address];
            output = (output & ~pins) | (value & pins);
            return;
        }
    }
    machine.words[place.address] = value;
}

} // namespace counterpoint::tms570
