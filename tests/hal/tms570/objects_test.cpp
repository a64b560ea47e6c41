// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Message objects of a controller that hold other than the driver gave them, and controllers with many objects.
#include "tests/hal/tms570/rig.hpp"
#include "verification/trace/ids/tms570.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>

namespace counterpoint::tms570
{
namespace
{

/// Interface 1 of DCAN 1, and commands that write arbitration or control of one object.
constexpr std::uint32_t kCommandRegister = 0xFFF7DD00U;
constexpr std::uint32_t kArbitrationRegister = 0xFFF7DD08U;
constexpr std::uint32_t kControlRegister = 0xFFF7DD0CU;
constexpr std::uint32_t kWriteArbitration = 0x00A00000U;
constexpr std::uint32_t kWriteControl = 0x00900000U;
constexpr std::uint32_t kWriteDataB = 0x00810000U;
constexpr std::uint32_t kDataBRegister = 0xFFF7DD14U;

class ObjectsTest : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    }
    /// Writes one register of an object behind the driver's back.
    void Put(const std::uint32_t which, const std::uint32_t value, const std::uint32_t command)
    {
        rig.machine.Write(which, value);
        rig.machine.Write(kCommandRegister, command);
    }
    /// The board is safe after this cycle, because of a controller.
    void ExpectFault()
    {
        EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kCan);
        EXPECT_TRUE(rig.IsSafe());
    }

    Rig rig;
};

TEST_F(ObjectsTest, ReceivedFrameOfAnotherIdentifierThanTheObjectHadIsAFault)
{
    Verifies(req::SRS_TMS_019);
    Verifies(req::SRS_TMS_010);
    // Given object 1, which receives 121h, when its identifier becomes 123h and such a frame comes
    Put(kArbitrationRegister, 0x80000000U | (0x123U << 18U), kWriteArbitration | 1U);
    ASSERT_TRUE(rig.machine.dcan1.Receive(Frame(0x123U, 1U)));
    rig.TakeInterrupts();
    // Then it is no frame, and the device is safe
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    ExpectFault();
}

TEST_F(ObjectsTest, InterruptOfAReceiveObjectWithoutANewFrameIsNoFrame)
{
    Verifies(req::SRS_TMS_010);
    // Given object 1 with its interrupt pending and no new frame in it
    Put(kControlRegister, 0x3480U, kWriteControl | 1U);
    rig.TakeInterrupts();
    // When the program takes what there is, then that is nothing, and no fault
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kNone);
}

TEST_F(ObjectsTest, InterruptOfATransmitObjectThatNothingWasGivenToConfirmsNothing)
{
    Verifies(req::SRS_TMS_016);
    // Given object 3, which sends 101h and was given no frame, with its interrupt pending
    Put(kControlRegister, 0x2880U, kWriteControl | 3U);
    rig.TakeInterrupts();
    // Then nothing is confirmed, and that is no fault
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    EXPECT_EQ(rig.board.BeginCycle(), BoardFault::kNone);
}

TEST_F(ObjectsTest, InterruptOfATransmitObjectThatStillWaitsConfirmsNothing)
{
    Verifies(req::SRS_TMS_016);
    // Given a frame that waits for the bus, and its interrupt all the same
    ASSERT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kAccepted);
    Put(kControlRegister, 0x2982U, kWriteControl | 3U);
    rig.TakeInterrupts();
    // Then nothing is confirmed yet
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    // and once it is on the bus, it is
    ASSERT_TRUE(rig.machine.dcan1.Transmit().has_value());
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kConfirmed);
}

TEST_F(ObjectsTest, SentFrameWithAnotherSecondWordIsAFaultWithoutConfirmation)
{
    Verifies(req::SRS_TMS_016);
    // Given a frame on its way, when bytes 4 to 7 of its object change
    ASSERT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kAccepted);
    Put(kDataBRegister, 0x01000000U, kWriteDataB | 3U);
    ASSERT_TRUE(rig.machine.dcan1.Transmit().has_value());
    rig.TakeInterrupts();
    // Then it is not confirmed, and the device is safe
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    ExpectFault();
}

TEST_F(ObjectsTest, SentFrameOfAnotherLengthIsAFaultWithoutConfirmation)
{
    Verifies(req::SRS_TMS_016);
    // Given a frame of 2 bytes on its way, when the length of its object becomes 3
    ASSERT_EQ(rig.board.Can().Transmit(Frame(kSentNormal, 1U)), hal::TransmitStatus::kAccepted);
    Put(kControlRegister, 0x1983U, kWriteControl | 3U);
    ASSERT_TRUE(rig.machine.dcan1.Transmit().has_value());
    rig.TakeInterrupts();
    // Then it is not confirmed, and the device is safe
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
    ExpectFault();
}

TEST_F(ObjectsTest, LengthBeyondEightBytesIsReceivedAsEight)
{
    Verifies(req::SRS_TMS_010);
    // Given a frame whose length on the bus is 9: eight bytes, by ISO 11898-1
    CanFrame frame = Frame(kNormal, 0x12U);
    frame.length_bytes = 9U;
    rig.machine.dcan1.Receive(frame);
    rig.TakeInterrupts();
    // Then the program gets eight
    const QueuedFrame received = rig.board.NextFrame();
    EXPECT_EQ(received.kind, QueuedKind::kReceived);
    EXPECT_EQ(received.frame.frame.length_bytes, 8U);
}

TEST_F(ObjectsTest, InterfaceThatStaysBusyInBusOffIsAFault)
{
    Verifies(req::SRS_TMS_018);
    Verifies(req::SRS_TMS_019);
    // Given a controller in bus-off whose interface to the objects stays busy, so that nothing can be withdrawn
    rig.machine.dcan1.GoBusOff();
    rig.machine.faults.Set(model::Fault::kDcanBusyForEver);
    // When the cycle begins, then the device is safe
    ExpectFault();
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kFirst).Fault(), CanFault::kBusy);
}

/// Objects 1 to 34: 200h to 221h are received.
[[nodiscard]] std::array<CanObject, 34U> ManyObjects()
{
    std::array<CanObject, 34U> objects{};
    for (std::uint16_t i = 0U; i < objects.size(); ++i)
    {
        objects[i] = CanObject{static_cast<std::uint16_t>(0x200U + i), ObjectUse::kReceive};
    }
    return objects;
}

class ManyObjectsTest : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        rig.setup.can.first.objects = objects.data();
        rig.setup.can.first.object_count = 34U;
        ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    }
    void Receive(const std::uint32_t identifier)
    {
        ASSERT_TRUE(rig.machine.dcan1.Receive(Frame(identifier, 0x12U)));
    }

    const std::array<CanObject, 34U> objects = ManyObjects();
    Rig rig;
};

TEST_F(ManyObjectsTest, OneFrameBeyondObject32IsNoLoss)
{
    Verifies(req::SRS_TMS_012);
    // Given a frame in object 33, when it is taken, then it is there, without a loss
    Receive(0x220U);
    rig.TakeInterrupts();
    const QueuedFrame received = rig.board.NextFrame();
    EXPECT_EQ(received.kind, QueuedKind::kReceived);
    EXPECT_EQ(received.frame.frame.identifier, 0x220U);
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kNothing);
}

TEST_F(ManyObjectsTest, TwoFramesBeyondObject32AreALoss)
{
    Verifies(req::SRS_TMS_012);
    // Given frames in objects 33 and 34 before the interrupt came, then the kernel is told of a loss first
    Receive(0x220U);
    Receive(0x221U);
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
    EXPECT_EQ(rig.board.NextFrame().frame.frame.identifier, 0x220U);
}

TEST_F(ManyObjectsTest, OneFrameOnEitherSideOfObject32IsALoss)
{
    Verifies(req::SRS_TMS_012);
    // Given frames in objects 1 and 33 before the interrupt came, then the kernel is told of a loss first
    Receive(0x200U);
    Receive(0x220U);
    rig.TakeInterrupts();
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
    EXPECT_EQ(rig.board.NextFrame().frame.frame.identifier, 0x200U);
}

TEST(CanSetupTest, LayoutThatIsNoneAndSetUpsThatCannotBeAreRefused)
{
    Verifies(req::SRS_TMS_011);
    // Given a layout that nobody chose, then the ports refuse
    Rig rig{kLs12x, BusLayout::kInvalid};
    EXPECT_EQ(rig.Start().answer, StartAnswer::kRefused);
    EXPECT_TRUE(rig.IsSafe());
    // and a controller refuses objects that are nowhere, and one more than it has room for; with as many it starts
    Dcan controller;
    DcanSetup setup = rig.setup.can.first;
    setup.base = kDcan1Base;
    setup.object_room = 4U;
    setup.objects = nullptr;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    setup.objects = kObjects;
    setup.object_room = 3U;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    // and what is wrong in the first of three objects is not mended by the others
    constexpr CanObject kFirstIsLarge[] = {
        {0x800U, ObjectUse::kReceive}, {0x121U, ObjectUse::kReceive}, {0x122U, ObjectUse::kReceive}};
    setup.object_room = 4U;
    setup.objects = kFirstIsLarge;
    setup.object_count = 3U;
    EXPECT_EQ(controller.Start(setup), CanFault::kSetup);
    setup.objects = kObjects;
    setup.object_count = 4U;
    EXPECT_EQ(controller.Start(setup), CanFault::kNone);
}

TEST(CanSetupTest, SecondControllerWithTwoPendingFramesIsALoss)
{
    Verifies(req::SRS_TMS_012);
    // Given two buses, the second with two objects that receive, when both hold a frame before the interrupt came
    constexpr CanObject kTwoReceived[] = {{0x131U, ObjectUse::kReceive}, {0x132U, ObjectUse::kReceive}};
    Rig rig{kLs12x, BusLayout::kTwoBuses};
    rig.setup.can.second.objects = kTwoReceived;
    ASSERT_EQ(rig.Start().answer, StartAnswer::kStarted);
    ASSERT_TRUE(rig.machine.dcan2.Receive(Frame(0x131U, 1U)));
    ASSERT_TRUE(rig.machine.dcan2.Receive(Frame(0x132U, 1U)));
    rig.TakeInterrupts();
    // Then the kernel is told of a loss before the frames
    EXPECT_EQ(rig.board.NextFrame().kind, QueuedKind::kLoss);
    EXPECT_EQ(rig.board.NextFrame().frame.frame.port, CanPortId::kSecond);
    EXPECT_EQ(rig.board.Can().Controller(CanPortId::kSecond).Fault(), CanFault::kNone);
}

TEST(PinsSetupTest, PortThatIsNoneIsRefused)
{
    Verifies(req::SRS_TMS_025);
    Verifies(req::SRS_TMS_061);
    // Given pins of an address that is no port, then the start is refused and nothing opens
    Rig none;
    none.setup.pins.port = RegisterBase{0xFFF7BC74U};
    EXPECT_EQ(none.Start().answer, StartAnswer::kRefused);
    EXPECT_TRUE(none.IsSafe());
}

TEST(PinsSetupTest, PinsWithoutAnySlotAreRefused)
{
    Verifies(req::SRS_TMS_025);
    Verifies(req::SRS_TMS_061);
    // Given a port of which no pin has a slot, then the start is refused; port B with one starts
    {
        Rig without;
        without.setup.pins.pins[0U].slots = 0U;
        EXPECT_EQ(without.Start().answer, StartAnswer::kRefused);
        EXPECT_TRUE(without.IsSafe());
    }
    Rig second;
    second.setup.pins.port = RegisterBase{0xFFF7BC54U};
    EXPECT_EQ(second.Start().answer, StartAnswer::kStarted);
    EXPECT_EQ(second.CyclesUntilFault(8), BoardFault::kNone);
}

} // namespace
} // namespace counterpoint::tms570
