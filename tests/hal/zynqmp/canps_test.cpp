// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Bus-off, which the emulator's controllers do not have, and a moment that no program can hit. The registers are words
// of the test; they do what UG1085 says of reset, enabling and bus-off, and no more.
#include "hal/zynqmp/can/can_ports.hpp"

#include "verification/trace/ids/zynqmp_hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

namespace counterpoint::zynqmp
{
namespace
{

using namespace canps;

constexpr std::uint32_t kBase = kCan0.address;
constexpr std::uint8_t kPauseCycles = 3U;
constexpr std::uint8_t kMostReturns = 2U;
constexpr std::uint16_t kReceived[]{0x103U};

struct Registers
{
    std::map<std::uint32_t, std::uint32_t> words;
    std::vector<std::uint32_t> waiting; ///< Identifiers in the transmit FIFO: they stay there over bus-off.
    bool can_be_enabled{true};
    bool does_reset_empty{true};
    bool brings_frame{false}; ///< A frame ends right before the time stamps begin anew, and has one of before.
};
Registers registers;

void WriteRegister(const std::uint32_t offset, const std::uint32_t value)
{
    if ((offset == kReset) && (value == kResetNow))
    {
        registers.words.clear();
        if (registers.does_reset_empty)
        {
            registers.waiting.clear();
        }
        registers.words[kStatus] = kIsConfiguring;
        registers.words[kEvents] = registers.waiting.empty() ? kTransmitEmpty : 0U;
        return;
    }
    if (offset == kClearEvents)
    {
        registers.words[kEvents] &= ~value;
        return;
    }
    registers.words[offset] = value;
    if ((offset == kTimeStamp) && registers.brings_frame)
    {
        registers.words[kEvents] |= kNotEmpty;
        registers.words[kReceive] = std::uint32_t{kReceived[0]} << kIdentifierShift;
        registers.words[kReceive + kLengthWord] = (1U << kLengthShift) | 0x8000U;
    }
    if ((offset == kReset) && (value == kEnabled) && registers.can_be_enabled)
    {
        registers.words[kStatus] = kIsNormal;
    }
    if (offset == (kTransmit + kLastDataWord))
    {
        registers.waiting.push_back(registers.words[kTransmit] >> kIdentifierShift);
    }
}

class Time final : public hal::Clocks
{
  public:
    InstantPair Now() noexcept override
    {
        ++now_;
        return InstantPair{Instant{now_}, Instant{now_}};
    }

  private:
    std::uint32_t now_{0U};
};

CanpsSetup SetupOfTest()
{
    return CanpsSetup{kCan0, 2U,    BitTiming(12U, 3U, 3U), 24U,         IdentifierList{&kReceived[0], 1U},
                      1500U, 0x80U, kPauseCycles,           kMostReturns};
}

class CanpsTest : public testing::Test
{
  protected:
    CanpsTest()
    {
        registers = Registers{};
        EXPECT_EQ(can_.Start(SetupOfTest(), time_), CanFault::kNone);
    }

    hal::TransmitStatus Send(const std::uint32_t identifier)
    {
        return can_.Send(CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 1U, {}});
    }
    void FallOff()
    {
        registers.words[kEvents] |= kBusOff;
        registers.words[kStatus] |= kErrorIsBusOff;
    }
    void Cycle()
    {
        can_.Look(time_, queue_, CanPortId::kFirst);
        can_.OnCycle(time_, queue_, CanPortId::kFirst);
    }
    void Cycles(const std::uint32_t count)
    {
        for (std::uint32_t cycle = 0U; cycle < count; ++cycle)
        {
            Cycle();
        }
    }
    [[nodiscard]] bool IsOnBus() const
    {
        return registers.words[kStatus] == kIsNormal;
    }

    Time time_{};
    Canps can_{};
    FrameQueue queue_{};
};

// Each of bus-off's two signs is enough: the event stays when the controller has come back by itself since.
TEST_F(CanpsTest, WithdrawsWhatWaitsByEitherSign)
{
    Verifies(req::SRS_ZYN_051);
    ASSERT_EQ(Send(0x101U), hal::TransmitStatus::kAccepted);
    ASSERT_EQ(Send(0x102U), hal::TransmitStatus::kAccepted);
    ASSERT_EQ(registers.waiting, std::vector<std::uint32_t>{0x101U});
    registers.words[kEvents] |= kBusOff;
    can_.Look(time_, queue_, CanPortId::kFirst);
    EXPECT_TRUE(can_.IsBusOff());
    EXPECT_TRUE(registers.waiting.empty());
    EXPECT_FALSE(IsOnBus());
    EXPECT_EQ(Send(0x103U), hal::TransmitStatus::kBusOff);
    Cycles(kPauseCycles + 1U);
    ASSERT_TRUE(IsOnBus());
    ASSERT_EQ(Send(0x104U), hal::TransmitStatus::kAccepted);
    EXPECT_EQ(registers.waiting, std::vector<std::uint32_t>{0x104U});

    registers.words[kStatus] |= kErrorIsBusOff;
    can_.Look(time_, queue_, CanPortId::kFirst);
    EXPECT_TRUE(can_.IsBusOff());
    EXPECT_TRUE(registers.waiting.empty());
}

// A confirmation that came together with bus-off is told; the frame that waited behind it does not leave.
TEST_F(CanpsTest, TellsWhatWasSentBefore)
{
    Verifies(req::SRS_ZYN_051);
    ASSERT_EQ(Send(0x101U), hal::TransmitStatus::kAccepted);
    ASSERT_EQ(Send(0x102U), hal::TransmitStatus::kAccepted);
    registers.words[kEvents] |= kSent;
    FallOff();
    can_.Look(time_, queue_, CanPortId::kFirst);
    const QueuedFrame told = queue_.Take(time_.Now().a);
    EXPECT_EQ(told.kind, QueuedKind::kConfirmed);
    EXPECT_EQ(told.frame.frame.identifier, 0x101U);
    EXPECT_TRUE(registers.waiting.empty());
    Cycles(10U);
    EXPECT_TRUE(IsOnBus());
    EXPECT_TRUE(registers.waiting.empty());
    EXPECT_EQ(queue_.Take(time_.Now().a).kind, QueuedKind::kNothing);
}

TEST_F(CanpsTest, ComesBackAfterThePauseAndNotTooOften)
{
    Verifies(req::SRS_ZYN_051);
    for (std::uint8_t back = 1U; back <= kMostReturns; ++back)
    {
        FallOff();
        Cycles(kPauseCycles);
        EXPECT_FALSE(IsOnBus());
        Cycle();
        EXPECT_TRUE(IsOnBus());
        EXPECT_FALSE(can_.IsBusOff());
        EXPECT_EQ(can_.Returns(), back);
    }
    FallOff();
    Cycles(100U);
    EXPECT_TRUE(can_.IsBusOff());
    EXPECT_FALSE(IsOnBus());
    EXPECT_EQ(can_.Returns(), 2U);
    EXPECT_EQ(can_.Fault(), CanFault::kNone);
    EXPECT_EQ(Send(0x101U), hal::TransmitStatus::kBusOff);
}

// Between Look and OnCycle the controller is not as it was set up, either; that is bus-off and no fault.
TEST_F(CanpsTest, IsNoFaultOfRegisters)
{
    Verifies(req::SRS_ZYN_051);
    can_.Look(time_, queue_, CanPortId::kFirst);
    registers.words[kEvents] |= kBusOff;
    registers.words[kStatus] = kErrorIsBusOff;
    can_.OnCycle(time_, queue_, CanPortId::kFirst);
    EXPECT_TRUE(can_.IsBusOff());
    EXPECT_EQ(can_.Fault(), CanFault::kNone);
}

TEST_F(CanpsTest, AControllerThatDoesNotComeBackIsAFault)
{
    Verifies(req::SRS_ZYN_051);
    FallOff();
    registers.can_be_enabled = false;
    Cycles(kPauseCycles + 1U);
    EXPECT_EQ(can_.Fault(), CanFault::kRegisters);
    EXPECT_EQ(Send(0x101U), hal::TransmitStatus::kRefused);
    EXPECT_EQ(registers.words[kReset], 0U);
}

// UG1085, "TX Messages": they are retained in bus-off and in configuration mode. Should a reset retain them, too, the
// controller stays off the bus, or a frame of before the pause would be sent as a new one.
TEST_F(CanpsTest, AFrameThatOutlivesTheResetIsAFault)
{
    Verifies(req::SRS_ZYN_051);
    registers.does_reset_empty = false;
    ASSERT_EQ(Send(0x101U), hal::TransmitStatus::kAccepted);
    FallOff();
    Cycles(kPauseCycles + 1U);
    EXPECT_EQ(can_.Fault(), CanFault::kRegisters);
    EXPECT_NE(registers.words[kReset], kEnabled);
    EXPECT_EQ(registers.waiting, std::vector<std::uint32_t>{0x101U});
}

TEST_F(CanpsTest, EachRegisterThatChangedIsAFault)
{
    Verifies(req::SRS_ZYN_052);
    const std::uint32_t offsets[]{kReset,  kMode,       kPrescaler, kBitTiming,
                                  kStatus, kFilterMask, kFilters,   kFilterIdentifier};
    for (const std::uint32_t offset : offsets)
    {
        ASSERT_EQ(can_.Start(SetupOfTest(), time_), CanFault::kNone);
        Cycle();
        ASSERT_EQ(can_.Fault(), CanFault::kNone);
        registers.words[offset] ^= (offset == kStatus) ? kIsNormal : 0x2U;
        Cycle();
        EXPECT_EQ(can_.Fault(), CanFault::kRegisters) << offset;
        EXPECT_NE(registers.words[kStatus] & kIsConfiguring, 0U) << offset;
    }
}

// A time stamp of before the anchor would make the frame older, or younger, than it is: it is taken at once, with the
// moment of the look.
TEST_F(CanpsTest, AFrameAtTheAnchorHasTheMomentOfTheLook)
{
    Verifies(req::SRS_ZYN_046);
    Cycle();
    const Instant before = time_.Now().a;
    registers.brings_frame = true;
    can_.OnCycle(time_, queue_, CanPortId::kFirst);
    EXPECT_EQ(registers.words[kEvents], 0U);
    const QueuedFrame queued = queue_.Take(time_.Now().a);
    EXPECT_EQ(queued.kind, QueuedKind::kReceived);
    EXPECT_EQ(queued.frame.frame.identifier, 0x103U);
    EXPECT_GT(queued.frame.stamp.a.us, before.us);
}

// The confirmation has the moment of the look that found it, which is after the look began: another controller's frame
// may still come before it.
TEST_F(CanpsTest, WhatEndedAfterTheLookBeganWaitsForTheNext)
{
    Verifies(req::SRS_ZYN_047);
    CanPorts ports{time_};
    ASSERT_EQ(ports.Start(CanPortsSetup{SetupOfTest(), CanpsSetup{}, BusLayout::kOneController}), CanFault::kNone);
    ASSERT_EQ(ports.Transmit(CanFrame{0x101U, FrameKind::kData, CanPortId::kFirst, 1U, {}}),
              hal::TransmitStatus::kAccepted);
    registers.words[kEvents] |= kSent;
    static_cast<void>(ports.Look());
    EXPECT_EQ(ports.Next().kind, QueuedKind::kNothing);
    static_cast<void>(ports.Look());
    EXPECT_EQ(ports.Next().kind, QueuedKind::kConfirmed);
    EXPECT_EQ(ports.Next().kind, QueuedKind::kNothing);
}

} // namespace
} // namespace counterpoint::zynqmp

namespace counterpoint::tms570
{

std::uint32_t Read(const Register place) noexcept
{
    return zynqmp::registers.words[place.address - zynqmp::kBase];
}

void Write(const Register place, const std::uint32_t value) noexcept
{
    zynqmp::WriteRegister(place.address - zynqmp::kBase, value);
}

} // namespace counterpoint::tms570
