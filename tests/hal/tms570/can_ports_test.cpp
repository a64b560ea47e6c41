// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::tms570
{
namespace
{

/// A started board; frames are looked at as the kernel would get them.
class CanPortsTest : public ::testing::Test
{
  protected:
    explicit CanPortsTest(const BusLayout layout = BusLayout::kOneController) : rig{kLs12x, layout}
    {
    }
    void SetUp() override
    {
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    }

    Rig rig;
};

class TwoControllers : public CanPortsTest
{
  protected:
    TwoControllers() : CanPortsTest{BusLayout::kTwoBuses}
    {
    }
};

class TwoControllersOneBus : public CanPortsTest
{
  protected:
    TwoControllersOneBus() : CanPortsTest{BusLayout::kOneBus}
    {
    }
};

TEST_F(CanPortsTest, GivesOrderStampsAndConfirmations)
{
    Verifies(req::SRS_TMS_012);
    // Given a started board, then the kernel may rely on all three
    EXPECT_EQ(hal::CheckGuarantees(rig.board.Can().Guarantees()), hal::MissingGuarantee::kNone);
}

TEST_F(CanPortsTest, FramesComeInTheOrderOfTheBusWithBothStamps)
{
    Verifies(req::SRS_TMS_010);
    Verifies(req::SRS_TMS_012);
    Verifies(req::SRS_TMS_013);
    // Given the inverse frame first on the bus, in the object of the greater number, and the normal one 250 us later
    const Instant before = rig.board.Clocks().Now().a;
    rig.machine.dcan1.Receive(Frame(kInverse, 0xEDU));
    rig.TakeInterrupts();
    rig.machine.Advance(250U);
    rig.machine.dcan1.Receive(Frame(kNormal, 0x12U));
    rig.TakeInterrupts();
    // When the program takes them
    const QueuedFrame first = rig.board.NextFrame();
    const QueuedFrame second = rig.board.NextFrame();
    // Then the order is that of the bus, not that of the objects
    EXPECT_EQ(first.kind, QueuedKind::kReceived);
    EXPECT_EQ(first.frame.frame.identifier, 0x122U);
    EXPECT_EQ(first.frame.frame.port, CanPortId::kFirst);
    EXPECT_EQ(first.frame.frame.length_bytes, 2U);
    EXPECT_EQ(first.frame.frame.data[0], 0xEDU);
    EXPECT_EQ(first.frame.frame.data[1], 0x34U);
    EXPECT_EQ(first.frame.frame.data[2], 0U);
    EXPECT_EQ(second.frame.frame.identifier, 0x121U);
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    // and each has the stamps of its interrupt by both counters
    EXPECT_LE(first.frame.stamp.a.us - before.us, 2U);
    EXPECT_LE(second.frame.stamp.a.us - before.us - 250U, 8U);
    EXPECT_LE(second.frame.stamp.b.us - second.frame.stamp.a.us + 1U, 2U);
}

TEST_F(CanPortsTest, TwoPendingFramesAreALoss)
{
    Verifies(req::SRS_TMS_012);
    // Given both frames of a pair that arrived before the interrupt came
    rig.machine.dcan1.Receive(Frame(kNormal, 0x12U));
    rig.machine.dcan1.Receive(Frame(kInverse, 0xEDU));
    rig.TakeInterrupts();
    // When the program takes what there is, then the kernel is told of a loss first
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
    // and the frames are there, for what they are worth
    EXPECT_EQ(rig.board.NextFrame().frame.frame.identifier, 0x121U);
    EXPECT_EQ(rig.board.NextFrame().frame.frame.identifier, 0x122U);
}

TEST_F(CanPortsTest, LostMessageIsToldBeforeItsFrame)
{
    Verifies(req::SRS_TMS_014);
    // Given a frame that was overwritten before the interrupt came
    rig.machine.dcan1.Receive(Frame(kNormal, 0x11U));
    rig.machine.dcan1.Receive(Frame(kNormal, 0x12U));
    rig.TakeInterrupts();
    // When the program takes what there is, then a loss comes first
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
    EXPECT_EQ(rig.board.NextFrame().frame.frame.data[0], 0x12U);
    // and a frame after that is no loss any more
    rig.machine.dcan1.Receive(Frame(kNormal, 0x13U));
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kReceived);
}

TEST_F(CanPortsTest, FullQueueIsALoss)
{
    Verifies(req::SRS_TMS_014);
    // Given one frame more than the queue has places, each taken by its interrupt
    for (int i = 0; i < 65; ++i)
    {
        rig.machine.dcan1.Receive(Frame(kNormal, 0x12U));
        rig.TakeInterrupts();
    }
    // When the program takes what there is, then a loss comes first, then the 64 oldest
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
    int frames = 0;
    while (rig.board.NextFrame().kind == QueuedKind::kReceived)
    {
        ++frames;
    }
    EXPECT_EQ(frames, 64);
}

TEST_F(CanPortsTest, FramesOfOthersAreNotHeard)
{
    Verifies(req::SRS_TMS_010);
    // Given frames with identifiers and kinds that no object is for
    EXPECT_FALSE(rig.machine.dcan1.Receive(Frame(0x123U, 0x12U)));
    CanFrame remote = Frame(kNormal, 0x12U);
    remote.kind = FrameKind::kRemote;
    EXPECT_FALSE(rig.machine.dcan1.Receive(remote));
    rig.TakeInterrupts();
    // Then the kernel gets nothing
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
}

TEST_F(CanPortsTest, SentFrameIsConfirmedAfterItWasOnTheBus)
{
    Verifies(req::SRS_TMS_015);
    Verifies(req::SRS_TMS_016);
    // Given a frame that was accepted
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x12U)), hal::TransmitStatus::kAccepted);
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    // and an object that is not free for a second one
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x13U)), hal::TransmitStatus::kQueueFull);
    // When it was on the bus, as it was handed over
    const auto on_bus = rig.machine.dcan1.Transmit();
    ASSERT_TRUE(on_bus.has_value());
    EXPECT_EQ(on_bus->identifier, 0x101U);
    EXPECT_EQ(on_bus->length_bytes, 2U);
    EXPECT_EQ(on_bus->data[0], 0x12U);
    EXPECT_EQ(on_bus->data[1], 0x34U);
    // Then the object is busy until its confirmation was taken, which comes with its data
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x13U)), hal::TransmitStatus::kQueueFull);
    rig.machine.Advance(250U);
    const InstantPair interrupted = rig.board.Clocks().Now();
    rig.TakeInterrupts();
    rig.machine.Advance(100U);
    const QueuedFrame confirmed = rig.board.NextFrame();
    // and with the stamps of the interrupt, 250 us after the frame was handed over and 100 us before it is taken
    EXPECT_LE(confirmed.frame.stamp.a.us - interrupted.a.us, 8U);
    EXPECT_LE(confirmed.frame.stamp.b.us - interrupted.b.us, 8U);
    EXPECT_EQ(confirmed.kind, QueuedKind::kConfirmed);
    EXPECT_EQ(confirmed.frame.frame.identifier, 0x101U);
    EXPECT_EQ(confirmed.frame.frame.data[1], 0x34U);
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x13U)), hal::TransmitStatus::kAccepted);
}

TEST_F(CanPortsTest, WhatHasNoObjectIsRefused)
{
    Verifies(req::SRS_TMS_010);
    // Given a board with one controller, then other identifiers, received ones and the other port are refused
    EXPECT_EQ(rig.board.Can().Transmit(Frame(0x103U, 1U)), hal::TransmitStatus::kRefused);
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kNormal, 1U)), hal::TransmitStatus::kRefused);
    CanFrame second = Frame(kSentNormal, 1U);
    second.port = CanPortId::kSecond;
    EXPECT_EQ(rig.board.Can().Transmit(second), hal::TransmitStatus::kRefused);
}

// Pause 3 cycles, 2 ways back.
TEST_F(CanPortsTest, BusOffWithdrawsRefusesAndComesBackASetNumberOfTimes)
{
    Verifies(req::SRS_TMS_015);
    Verifies(req::SRS_TMS_018);
    for (int time = 0; time < 2; ++time)
    {
        // Given a frame that waits when the controller goes to bus-off
        EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x12U)), hal::TransmitStatus::kAccepted);
        rig.machine.dcan1.GoBusOff();
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
        // Then new frames are refused as such, and it is no fault of the board
        EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentInverse, 0x12U)), hal::TransmitStatus::kBusOff);
        // When the pause is over and the bus was silent for long enough
        for (int cycle = 0; cycle < 3; ++cycle)
        {
            EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
            EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
        }
        rig.machine.dcan1.Recover();
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
        // Then frames go out again, but not the old one
        EXPECT_FALSE(rig.machine.dcan1.Transmit().has_value());
    }
    // Given the third time
    rig.machine.dcan1.GoBusOff();
    for (int cycle = 0; cycle < 20; ++cycle)
    {
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
        rig.machine.dcan1.Recover();
    }
    // Then it stays off
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kBusOff);
    // until the board is started again
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    rig.machine.dcan1.Recover();
    EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
    EXPECT_TRUE(rig.machine.dcan1.IsOnBus());
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kAccepted);
}

TEST_F(CanPortsTest, BusOffAgainOnTheWayBackBeginsThePauseAnew)
{
    Verifies(req::SRS_TMS_018);
    // Given a controller whose pause of 3 cycles is over, so that it counts recessive bits
    rig.machine.dcan1.GoBusOff();
    for (int cycle = 0; cycle < 4; ++cycle)
    {
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
    }
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Returns(), 1U);
    // When it is in bus-off again before it was seen on the bus
    rig.machine.dcan1.GoBusOff();
    for (int cycle = 0; cycle < 3; ++cycle)
    {
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
        EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Returns(), 1U) << cycle;
    }
    for (int cycle = 0; cycle < 2; ++cycle)
    {
        EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
    }
    // Then it goes the way back a second time, and frames are taken
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Returns(), 2U);
    rig.machine.dcan1.Recover();
    EXPECT_EQ(rig.Cycle(), BoardFault::kNone);
    EXPECT_TRUE(rig.machine.dcan1.IsOnBus());
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x12U)), hal::TransmitStatus::kAccepted);
}

TEST_F(CanPortsTest, ControllerRunsWithParityAndWithoutAnAutomaticReturn)
{
    Verifies(req::SRS_TMS_011);
    // Given a started board, then the control register has parity on (bits 13 to 10: Ah), no automatic return after
    // bus-off (bit 9), and neither initialisation (bit 0) nor change of the set-up (bit 6)
    const std::uint32_t control = rig.machine.Read(0xFFF7DC00U);
    EXPECT_EQ(control & 0x3C00U, 0x2800U);
    EXPECT_EQ(control & 0x0241U, 0U);
    // and the bit timing is that of the setup
    EXPECT_EQ(rig.machine.Read(0xFFF7DC0CU), rig.setup.can.first.bit_timing);
}

TEST_F(CanPortsTest, FrameThatReadsOtherwiseThanItWasHandedOverIsNotConfirmed)
{
    Verifies(req::SRS_TMS_016);
    // Given a frame whose object holds something else when it was sent
    rig.machine.faults.Set(model::Fault::kDcanWrongReadBack);
    EXPECT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 0x12U)), hal::TransmitStatus::kAccepted);
    EXPECT_TRUE(rig.machine.dcan1.Transmit().has_value());
    // When the interrupt is taken, then nothing is confirmed, and the controller has a fault and is off the bus
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Fault(), CanFault::kReadBack);
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
}

TEST_F(CanPortsTest, SetupThatCannotWorkIsRefused)
{
    Verifies(req::SRS_TMS_011);
    // Given setups with an identifier twice, one out of 11 bits, no use, none at all, more than there is room
    constexpr CanObject kTwice[] = {{0x121U, ObjectUse::kReceive}, {0x121U, ObjectUse::kTransmit}};
    constexpr CanObject kLarge[] = {{0x800U, ObjectUse::kReceive}};
    constexpr CanObject kUseless[] = {{0x121U, ObjectUse::kInvalid}};
    Dcan controller{};
    DcanSetup setup = rig.setup.can.first;
    setup.base = kDcan1Base;
    setup.object_room = 64U;
    setup.objects = kTwice;
    setup.object_count = 2U;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    setup.object_count = 1U;
    setup.objects = kLarge;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    setup.objects = kUseless;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    setup.objects = kTwice;
    setup.object_count = 0U;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    setup.object_count = 1U;
    setup.object_room = 65U;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    // When the room is that of the controller, then it starts
    setup.object_room = 64U;
    EXPECT_EQ(controller.Start(setup), CanFault::kNone);
}

TEST_F(TwoControllers, FramesOfTwoBusesAreBothHeard)
{
    Verifies(req::SRS_TMS_012);
    // Given frames that end on two buses at the same moment
    rig.machine.dcan2.Receive(Frame(0x131U, 0x22U));
    rig.machine.dcan1.Receive(Frame(kNormal, 0x11U));
    rig.TakeInterrupts();
    // Then that is no loss: the first controller comes first, both with one stamp
    const QueuedFrame first = rig.board.NextFrame();
    const QueuedFrame second = rig.board.NextFrame();
    EXPECT_EQ(first.frame.frame.port, CanPortId::kFirst);
    EXPECT_EQ(second.frame.frame.port, CanPortId::kSecond);
    EXPECT_EQ(second.frame.frame.identifier, 0x131U);
    EXPECT_EQ(first.frame.stamp.a.us, second.frame.stamp.a.us);
}

TEST_F(TwoControllers, SecondControllerSendsAndConfirms)
{
    Verifies(req::SRS_TMS_015);
    // Given a frame for the second port
    CanFrame frame = Frame(0x132U, 0x12U);
    frame.port = CanPortId::kSecond;
    EXPECT_EQ(rig.board.Can().Transmit(frame), hal::TransmitStatus::kAccepted);
    // When it was on the second bus, then it is confirmed for that port
    EXPECT_FALSE(rig.machine.dcan1.Transmit().has_value());
    EXPECT_TRUE(rig.machine.dcan2.Transmit().has_value());
    rig.TakeInterrupts();
    const QueuedFrame confirmed = rig.board.NextFrame();
    EXPECT_EQ(confirmed.kind, QueuedKind::kConfirmed);
    EXPECT_EQ(confirmed.frame.frame.port, CanPortId::kSecond);
}

TEST_F(TwoControllers, SafeStateTakesBothOffTheirBuses)
{
    Verifies(req::SRS_TMS_062);
    // Given a device on two buses, when an uncorrectable error of its RAM is reported
    rig.machine.esm.Raise(2U, 6U);
    EXPECT_EQ(rig.Cycle(), BoardFault::kEsm);
    // Then it is on neither of them any more, and neither takes a frame
    EXPECT_FALSE(rig.machine.dcan1.IsOnBus());
    EXPECT_FALSE(rig.machine.dcan2.IsOnBus());
    CanFrame frame = Frame(0x132U, 1U);
    frame.port = CanPortId::kSecond;
    EXPECT_EQ(rig.board.Can().Transmit(frame), hal::TransmitStatus::kRefused);
}

TEST_F(TwoControllersOneBus, TwoFramesAtOnceAreALossOnOneBus)
{
    Verifies(req::SRS_TMS_012);
    // Given two controllers on one bus whose interrupts are both pending
    rig.machine.dcan2.Receive(Frame(0x131U, 0x22U));
    rig.machine.dcan1.Receive(Frame(kNormal, 0x11U));
    rig.TakeInterrupts();
    // Then their order is not known, and that is told
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
}

} // namespace
} // namespace counterpoint::tms570
