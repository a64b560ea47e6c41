// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace counterpoint::host
{
namespace
{

using hal::TransmitStatus;

/// Hits the first `times` attempts at one bit.
class HitAt final : public BusFault
{
  public:
    HitAt(const std::uint16_t bit, const std::uint32_t times) : bit_(bit), times_(times)
    {
    }
    WireHit OnWire(const FrameOnBus& sent) override
    {
        return WireHit{(sent.attempt <= times_) ? bit_ : WireHit::kNone};
    }

  private:
    std::uint16_t bit_;
    std::uint32_t times_;
};

// bit     0 ... 20 | 21 ... 40     | 41 42 43     | 44 ... 93
// bus     frame    | error frame 20| intermission | the frame again, 50 bits
TEST(BusErrors, HitFrameEndsWithAnErrorFrameAndIsSentAgain)
{
    Verifies(req::SRS_BUS_007);
    Verifies(req::SRS_BUS_010);
    // Given a disturbance in bit 20 of the first attempt
    BusRig rig;
    HitAt fault(20U, 1U);
    rig.bus.Install(fault);
    // When the frame of 50 bits is sent
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    // Then the first attempt ends after 21 + 20 bits
    ASSERT_EQ(rig.recorder.records.size(), 2U);
    EXPECT_EQ(rig.recorder.records[0].fate, FrameFate::kHit);
    EXPECT_EQ(rig.recorder.records[0].bits, 41U);
    EXPECT_EQ(rig.recorder.records[0].end, 41'000);
    EXPECT_EQ(rig.recorder.records[0].receivers, 0U);
    // and the second starts after the intermission and arrives once
    EXPECT_EQ(rig.recorder.records[1].sent.attempt, 2U);
    EXPECT_EQ(rig.recorder.records[1].sent.start, 44'000);
    EXPECT_EQ(rig.recorder.records[1].fate, FrameFate::kComplete);
    ASSERT_EQ(rig.listeners[1].received.size(), 1U);
    EXPECT_EQ(rig.listeners[1].received[0].at, 94'000);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
}

TEST(BusErrors, DestroyedFrameIsSentAgainWithoutAnObserverToo)
{
    Verifies(req::SRS_BUS_007);
    // Given a disturbance of the first attempt and nobody who writes it down
    BusRig rig;
    HitAt fault(20U, 1U);
    rig.bus.Install(fault);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    // When the bus runs, then the frame arrives at its second attempt
    rig.bus.Advance(kMillisecond);
    ASSERT_EQ(rig.listeners[1].received.size(), 1U);
    EXPECT_EQ(rig.listeners[1].received[0].at, 94'000);
}

TEST(BusErrors, HitBehindTheEndCountsAsTheLastBit)
{
    Verifies(req::SRS_BUS_007);
    // Given a disturbance beyond the frame of 50 bits
    BusRig rig;
    HitAt fault(200U, 1U);
    rig.bus.Install(fault);
    // When it is sent
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(60 * BusRig::kBit);
    // Then its last bit is hit: 50 + 20 bits
    EXPECT_TRUE(rig.recorder.records.empty());
    rig.RunTo(70 * BusRig::kBit);
    ASSERT_EQ(rig.recorder.records.size(), 1U);
    EXPECT_EQ(rig.recorder.records[0].bits, 70U);
}

TEST(BusErrors, CountersGoUpByEightAndOneAndDownByOne)
{
    Verifies(req::SRS_BUS_008);
    // Given two hit attempts
    BusRig rig;
    HitAt fault(20U, 2U);
    rig.bus.Install(fault);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    // When they are over (2 x 44 bits)
    rig.RunTo(88 * BusRig::kBit);
    // Then the sender counts 16, a receiver 2
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 16U);
    EXPECT_EQ(rig.bus.ReceiveErrors(1U), 2U);
    EXPECT_EQ(rig.bus.TransmitErrors(1U), 0U);
    EXPECT_EQ(rig.bus.ReceiveErrors(0U), 0U);
    // and after the third, which is complete, 15 and 1
    rig.RunTo(kMillisecond);
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 15U);
    EXPECT_EQ(rig.bus.ReceiveErrors(1U), 1U);
}

TEST(BusErrors, SenderGoesBusOffAfterThirtyTwoDestroyedFrames)
{
    Verifies(req::SRS_BUS_008);
    // Given every attempt hit at SOF: 21 + 3 bits each
    BusRig rig;
    HitAt fault(0U, 1'000U);
    rig.bus.Install(fault);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(1U, {})), TransmitStatus::kAccepted);
    // When 31 attempts are over, then the sender is error-passive
    rig.RunTo(31 * 24 * BusRig::kBit);
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 248U);
    EXPECT_EQ(rig.bus.State(0U), ControllerState::kErrorPassive);
    EXPECT_EQ(rig.bus.State(1U), ControllerState::kErrorActive);
    // When the 32nd is, then it is bus-off with nothing left to send
    rig.RunTo(kMillisecond);
    EXPECT_EQ(rig.bus.State(0U), ControllerState::kBusOff);
    ASSERT_EQ(rig.listeners[0].bus_off.size(), 1U);
    EXPECT_EQ(rig.listeners[0].bus_off[0], ((31 * 24) + 21) * BusRig::kBit);
    EXPECT_EQ(rig.bus.Pending(0U), 0U);
    EXPECT_EQ(rig.recorder.records.size(), 32U);
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kBusOff);
}

TEST(BusErrors, BusOffNodeHearsNothingUntilRecovered)
{
    Verifies(req::SRS_BUS_008);
    // Given node 1 forced into bus-off with a frame waiting
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(5U, {})), TransmitStatus::kAccepted);
    rig.bus.ForceBusOff(1U);
    rig.bus.ForceBusOff(1U);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    // When node 0 sends
    rig.RunTo(kMillisecond);
    // Then node 1 hears nothing and sent nothing, and was told of its state once
    EXPECT_TRUE(rig.listeners[1].received.empty());
    EXPECT_EQ(rig.listeners[1].bus_off.size(), 1U);
    EXPECT_EQ(rig.recorder.records.size(), 1U);
    // When it is recovered
    rig.bus.Recover(1U);
    EXPECT_EQ(rig.bus.State(1U), ControllerState::kErrorActive);
    EXPECT_EQ(rig.bus.TransmitErrors(1U), 0U);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    // Then it hears again, and the old frame never leaves
    EXPECT_EQ(rig.listeners[1].received.size(), 1U);
    EXPECT_EQ(rig.recorder.records.size(), 2U);
}

TEST(BusErrors, FrameOfASenderThatGoesBusOffUnderWayReachesNobody)
{
    Verifies(req::SRS_BUS_008);
    // Given a frame on the bus
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(10 * BusRig::kBit);
    // When its sender goes bus-off and is recovered at once
    rig.bus.ForceBusOff(0U);
    rig.bus.Recover(0U);
    rig.RunTo(kMillisecond);
    // Then nobody receives it, nobody confirms it, and it is not sent again
    ASSERT_EQ(rig.recorder.records.size(), 1U);
    EXPECT_EQ(rig.recorder.records[0].fate, FrameFate::kSenderGone);
    EXPECT_TRUE(rig.listeners[1].received.empty());
    EXPECT_TRUE(rig.listeners[0].confirmed.empty());
}

TEST(BusErrors, FrameOfASenderThatLosesItsCableIsSentAgainLater)
{
    Verifies(req::SRS_BUS_007);
    // Given a frame on the bus whose sender is disconnected under way
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(10 * BusRig::kBit);
    rig.bus.Disconnect(0U);
    rig.RunTo(kMillisecond);
    EXPECT_TRUE(rig.listeners[1].received.empty());
    // When the cable is back, then it is sent again
    rig.bus.Connect(0U);
    rig.RunTo(2 * kMillisecond);
    EXPECT_EQ(rig.listeners[1].received.size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
}

TEST(BusErrors, EachReasonToBeAwayEndsByItself)
{
    Verifies(req::SRS_BUS_016);
    // Given node 1 without cable and forced into bus-off
    BusRig rig;
    rig.bus.Disconnect(1U);
    rig.bus.ForceBusOff(1U);
    // When its supply goes and comes back, then both still hold
    rig.bus.SwitchOff(1U);
    EXPECT_FALSE(rig.bus.IsOnBus(1U));
    rig.bus.SwitchOn(1U);
    EXPECT_FALSE(rig.bus.IsOnBus(1U));
    EXPECT_EQ(rig.bus.State(1U), ControllerState::kBusOff);
    // When the cable comes back, then bus-off still holds; and when that ends, the node is there
    rig.bus.Connect(1U);
    EXPECT_FALSE(rig.bus.IsOnBus(1U));
    rig.bus.Recover(1U);
    EXPECT_TRUE(rig.bus.IsOnBus(1U));
    // Neither cable nor recovery are a supply
    rig.bus.SwitchOff(1U);
    rig.bus.Connect(1U);
    rig.bus.Recover(1U);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    EXPECT_TRUE(rig.listeners[1].received.empty());
    EXPECT_EQ(rig.listeners[2].received.size(), 1U);
}

TEST(BusErrors, SupplyThatReturnsFindsAnEmptyQueueAndEndsBusOffByTheCounters)
{
    Verifies(req::SRS_BUS_016);
    // Given a node that its counters put into bus-off: 32 attempts that are hit
    BusRig rig;
    HitAt hits(10U, 1000U);
    rig.bus.Install(hits);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(10 * kMillisecond);
    rig.bus.Remove(hits);
    ASSERT_EQ(rig.bus.State(0U), ControllerState::kBusOff);
    // When its supply blinks, then it is error-active
    rig.bus.SwitchOff(0U);
    rig.bus.SwitchOn(0U);
    EXPECT_EQ(rig.bus.State(0U), ControllerState::kErrorActive);
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 0U);
    // And what it queued without supply never leaves
    rig.bus.SwitchOff(0U);
    static_cast<void>(rig.bus.Submit(0U, MakeFrame(5U, {})));
    rig.bus.SwitchOn(0U);
    EXPECT_EQ(rig.bus.Pending(0U), 0U);
    rig.RunTo(20 * kMillisecond);
    EXPECT_TRUE(rig.listeners[1].received.empty());
}

// The frame of 50 bits: CRC delimiter is bit 40, ACK slot bit 41; 42 + 20 bits and the intermission of 3.
TEST(BusErrors, LonelyNodeTriesForEverAndDoesNotGoBusOff)
{
    Verifies(req::SRS_BUS_009);
    // Given nobody else on the bus
    BusRig rig;
    rig.bus.Disconnect(1U);
    rig.bus.ForceBusOff(2U);
    // When node 0 sends
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(65 * 100 * BusRig::kBit);
    // Then each attempt ends after the ACK slot, and its counter stops at 128
    ASSERT_EQ(rig.recorder.records.size(), 100U);
    EXPECT_EQ(rig.recorder.records[0].fate, FrameFate::kNotAcknowledged);
    EXPECT_EQ(rig.recorder.records[0].bits, 62U);
    EXPECT_EQ(rig.recorder.records[99].sent.attempt, 100U);
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 128U);
    EXPECT_TRUE(rig.listeners[0].confirmed.empty());
    // When somebody listens again, then it gets through
    rig.bus.Connect(1U);
    rig.RunTo(65 * 102 * BusRig::kBit);
    EXPECT_EQ(rig.listeners[1].received.size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
}

// Identifier 0 with byte 00h and with byte 80h. Plain bits 0 to 18: header; the last three of its 18 dominant bits come
// after the third stuff bit; bit 21 is the 1 of the DLC, bit 22 the first bit of data, in which they differ: 23 + 20
// bits.
TEST(BusErrors, TwoNodesWithOneIdentifierAndDifferentDataCollide)
{
    Verifies(req::SRS_BUS_004);
    Verifies(req::SRS_BUS_015);
    // Given the same identifier with different data in two nodes
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {0x80U})), TransmitStatus::kAccepted);
    // When they start together
    rig.RunTo(45 * BusRig::kBit);
    // Then the first differing bit destroys both, and both count
    ASSERT_EQ(rig.recorder.records.size(), 1U);
    EXPECT_EQ(rig.recorder.records[0].fate, FrameFate::kCollision);
    EXPECT_EQ(rig.recorder.records[0].bits, 43U);
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 8U);
    EXPECT_EQ(rig.bus.TransmitErrors(1U), 8U);
    EXPECT_EQ(rig.bus.ReceiveErrors(2U), 1U);
    // and they go on until both are bus-off
    rig.RunTo(10 * kMillisecond);
    EXPECT_EQ(rig.recorder.records.size(), 32U);
    EXPECT_EQ(rig.bus.State(0U), ControllerState::kBusOff);
    EXPECT_EQ(rig.bus.State(1U), ControllerState::kBusOff);
    EXPECT_TRUE(rig.listeners[2].received.empty());
}

TEST(BusErrors, NodesThatTakeTurnsSendOneAfterTheOther)
{
    Verifies(req::SRS_BUS_015);
    // Given the same identifier with different data in two nodes that take turns
    BusRig rig;
    rig.bus.TakeTurns();
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {0x80U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    // When both could start
    rig.RunTo(kMillisecond);
    // Then the first node's frame comes first, and neither counts an error
    ASSERT_EQ(rig.listeners[2].received.size(), 2U);
    EXPECT_EQ(rig.listeners[2].received[0].frame.data[0], 0x00U);
    EXPECT_EQ(rig.listeners[2].received[1].frame.data[0], 0x80U);
    EXPECT_EQ(rig.recorder.records[0].fate, FrameFate::kComplete);
    EXPECT_EQ(rig.bus.TransmitErrors(0U), 0U);
    EXPECT_EQ(rig.bus.TransmitErrors(1U), 0U);
}

TEST(BusErrors, ThreeNodesThatTakeTurnsSendInTheOrderOfTheirAttachment)
{
    Verifies(req::SRS_BUS_015);
    // Given one identifier with different data in three nodes, handed over in another order
    BusRig rig;
    rig.bus.TakeTurns();
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x101U, {0x03U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {0x01U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0x101U, {0x02U})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    // When two of them have another identifier each
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {0x05U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x100U, {0x04U})), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    // Then those alike follow as they were attached, and else the lower identifier wins
    ASSERT_EQ(rig.recorder.records.size(), 5U);
    std::vector<std::uint32_t> order;
    for (const auto& record : rig.recorder.records)
    {
        EXPECT_EQ(record.fate, FrameFate::kComplete);
        order.push_back(record.sent.frame.data[0]);
    }
    EXPECT_EQ(order, (std::vector<std::uint32_t>{1U, 2U, 3U, 4U, 5U}));
    for (NodeIndex node = 0U; node < 3U; ++node)
    {
        EXPECT_EQ(rig.bus.TransmitErrors(node), 0U);
    }
}

TEST(BusErrors, TwoNodesWithTheSameFrameBothGetTheirConfirmation)
{
    Verifies(req::SRS_BUS_004);
    // Given the very same frame in two nodes
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    // When they start together
    rig.RunTo(kMillisecond);
    // Then one frame is on the bus, both senders are confirmed, the third hears it once
    ASSERT_EQ(rig.recorder.records.size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
    EXPECT_EQ(rig.listeners[1].confirmed.size(), 1U);
    EXPECT_EQ(rig.listeners[2].received.size(), 1U);
    EXPECT_TRUE(rig.listeners[0].received.empty());
}

TEST(BusErrors, EarlierOfHitAndCollisionCounts)
{
    Verifies(req::SRS_BUS_004);
    Verifies(req::SRS_BUS_007);
    Verifies(req::SRS_BUS_013);
    // Given frames that collide in bit 22 and a disturbance in bit 5, then in bit 30
    for (const std::uint16_t hit : {std::uint16_t{5U}, std::uint16_t{30U}})
    {
        BusRig rig;
        HitAt fault(hit, 1U);
        rig.bus.Install(fault);
        ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
        ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {0x80U})), TransmitStatus::kAccepted);
        // When they start
        rig.RunTo(50 * BusRig::kBit);
        // Then whichever is first ends the frame
        EXPECT_EQ(rig.recorder.records[0].fate, (hit == 5U) ? FrameFate::kHit : FrameFate::kCollision);
        EXPECT_EQ(rig.recorder.records[0].bits, (hit == 5U) ? 26U : 43U);
    }
}

} // namespace
} // namespace counterpoint::host
