// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace counterpoint::host
{
namespace
{

using hal::TransmitStatus;

TEST(BusSteps, IdleBusHasNoEvent)
{
    Verifies(req::SRS_BUS_012);
    // Given a bus with nothing to do, when it runs, then only the time moves
    BusRig rig;
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
    rig.RunTo(1'000'000 * kSecond);
    EXPECT_EQ(rig.bus.Now(), 1'000'000 * kSecond);
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
}

TEST(BusSteps, TimeDoesNotGoBack)
{
    Verifies(req::SRS_BUS_012);
    // Given a bus at 1 ms, when it is advanced to an earlier instant, then it stays
    BusRig rig;
    rig.RunTo(kMillisecond);
    rig.RunTo(0);
    EXPECT_EQ(rig.bus.Now(), kMillisecond);
}

TEST(BusSteps, EventLoopThatFollowsNextEventSeesEveryEnd)
{
    Verifies(req::SRS_BUS_012);
    // Given two frames
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    // They have one arbitration field and different lengths: a collision first; one of them is therefore sent alone
    rig.bus.AbortAll(1U);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(1U, {})), TransmitStatus::kAccepted);
    // When the loop goes from event to event
    int steps = 0;
    std::vector<BusTime> ends;
    while ((rig.bus.NextEvent() != kNever) && (steps < 20))
    {
        const std::size_t before = rig.recorder.records.size();
        const BusTime next = rig.bus.NextEvent();
        ASSERT_GE(next, rig.bus.Now());
        rig.RunTo(next);
        ++steps;
        if (rig.recorder.records.size() > before)
        {
            EXPECT_EQ(rig.recorder.records.back().end, next);
            ends.push_back(next);
        }
    }
    // Then each frame took a choice and an end
    EXPECT_EQ(steps, 4);
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_EQ(ends[0], 50'000);
}

TEST(BusSteps, AllFramesOfOneInstantCompeteThoughAdvanceWasCalledBetween)
{
    Verifies(req::SRS_BUS_012);
    Verifies(req::SRS_BUS_003);
    // Given 102h submitted at 1 ms
    BusRig rig;
    rig.RunTo(kMillisecond);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
    // When Advance is called for the same instant before 101h is submitted
    rig.RunTo(kMillisecond);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    // Then 101h still goes first, from that instant on
    EXPECT_EQ(rig.recorder.records[0].sent.frame.identifier, 0x101U);
    EXPECT_EQ(rig.recorder.records[0].sent.start, kMillisecond);
}

TEST(BusSteps, FrameWithdrawnBeforeItsStartLeavesTheBusIdle)
{
    Verifies(req::SRS_BUS_012);
    // Given a frame submitted and aborted at the same instant
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.bus.AbortAll(0U);
    // When the bus runs, then nothing was on it, and the next frame is sent as ever
    rig.RunTo(kMillisecond);
    EXPECT_TRUE(rig.recorder.records.empty());
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    ASSERT_EQ(rig.recorder.records.size(), 1U);
    EXPECT_EQ(rig.recorder.records[0].sent.start, kMillisecond);
}

TEST(BusSteps, AdvanceIncludesItsInstant)
{
    Verifies(req::SRS_BUS_012);
    // Given a frame that ends at 50 us, when the bus runs to 50 us sharp, then it has ended
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(50'000);
    EXPECT_EQ(rig.recorder.records.size(), 1U);
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
}

/// Submits one frame from within the confirmation of another, as channel B's inverse frame.
class Follower final : public BusListener
{
  public:
    explicit Follower(VirtualBus& bus) : bus_(bus)
    {
    }
    void OnReceived(const CanFrame& frame, const BusTime at) override
    {
        static_cast<void>(frame);
        static_cast<void>(at);
    }
    void OnConfirmed(const CanFrame& frame, const BusTime at) override
    {
        if (frame.identifier == 0x101U)
        {
            EXPECT_EQ(bus_.Now(), at);
            EXPECT_EQ(bus_.Submit(0U, MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
        }
        ends.push_back(at);
    }

    std::vector<BusTime> ends{};

  private:
    VirtualBus& bus_;
};

TEST(BusSteps, FrameSubmittedInAConfirmationFollowsAfterTheIntermission)
{
    Verifies(req::SRS_BUS_012);
    // Given a node that answers its own confirmation with the next frame
    VirtualBus bus(BitRate::k1M);
    Follower follower(bus);
    Listener other;
    Recorder recorder;
    static_cast<void>(bus.Attach(follower, NodeSetup{CanPortId::kFirst, 1U}));
    static_cast<void>(bus.Attach(other, NodeSetup{CanPortId::kFirst, 1U}));
    // When the first is sent from a queue of one
    ASSERT_EQ(bus.Submit(0U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    bus.Advance(kMillisecond, &recorder);
    // Then the second starts three bits after the first
    ASSERT_EQ(recorder.records.size(), 2U);
    EXPECT_EQ(recorder.records[1].sent.start, recorder.records[0].end + 3'000);
    EXPECT_EQ(follower.ends.size(), 2U);
}

TEST(BusSteps, ObserverIsToldBeforeTheReceivers)
{
    Verifies(req::SRS_BUS_013);
    // Given an observer that looks at what the receivers have
    class Early final : public BusObserver
    {
      public:
        explicit Early(const BusRig& rig) : rig_(rig)
        {
        }
        void OnBusRecord(const BusRecord& record) override
        {
            heard_then = rig_.listeners[1].received.size();
            last = record;
        }
        std::size_t heard_then{99U};
        BusRecord last{};

      private:
        const BusRig& rig_;
    };
    BusRig rig;
    Early early(rig);
    // When a frame is sent from node 2 at 1 ms
    rig.bus.Advance(kMillisecond);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    rig.bus.Advance(2 * kMillisecond, &early);
    // Then it was told everything before anybody had it
    EXPECT_EQ(early.heard_then, 0U);
    EXPECT_EQ(rig.listeners[1].received.size(), 1U);
    EXPECT_EQ(early.last.sent.frame.length_bytes, 1U);
    EXPECT_EQ(early.last.sent.sender, 2U);
    EXPECT_EQ(early.last.sent.start, 1'000'000);
    EXPECT_EQ(early.last.sent.attempt, 1U);
    EXPECT_EQ(early.last.end, 1'056'000);
    EXPECT_EQ(early.last.bits, 56U);
    EXPECT_EQ(early.last.receivers, 2U);
    EXPECT_EQ(early.last.fate, FrameFate::kComplete);
    // and what was in it
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0x123U, {0xA5U, 0x5AU})), TransmitStatus::kAccepted);
    rig.bus.Advance(3 * kMillisecond, &early);
    EXPECT_EQ(early.last.sent.frame.identifier, 0x123U);
    EXPECT_EQ(early.last.sent.frame.data[0], 0xA5U);
    EXPECT_EQ(early.last.sent.frame.data[1], 0x5AU);
}

TEST(BusSteps, SameCallsGiveTheSameResultsHoweverTimeIsCutUp)
{
    Verifies(req::SRS_BUS_012);
    // Given two buses with the same submissions, one advanced in many small steps
    BusRig coarse;
    BusRig fine;
    std::mt19937 random(13U);
    for (int round = 0; round < 200; ++round)
    {
        const BusTime next = coarse.bus.Now() + static_cast<BusTime>(random() % 200'000U);
        coarse.RunTo(next);
        while (fine.bus.Now() < next)
        {
            fine.RunTo(std::min(next, fine.bus.Now() + 777));
        }
        const NodeIndex node = random() % 3U;
        const CanFrame frame = MakeFrame(static_cast<std::uint32_t>(((random() % 64U) * 4U) + node),
                                         {static_cast<std::uint8_t>(random() % 256U)});
        ASSERT_EQ(coarse.bus.Submit(node, frame), fine.bus.Submit(node, frame));
    }
    coarse.RunTo(coarse.bus.Now() + kSecond);
    fine.RunTo(coarse.bus.Now());
    // Then the records are the same
    ASSERT_EQ(coarse.recorder.records.size(), fine.recorder.records.size());
    ASSERT_GE(coarse.recorder.records.size(), 100U);
    for (std::size_t place = 0U; place < coarse.recorder.records.size(); ++place)
    {
        const BusRecord& left = coarse.recorder.records[place];
        const BusRecord& right = fine.recorder.records[place];
        ASSERT_EQ(left.sent.frame.identifier, right.sent.frame.identifier);
        ASSERT_EQ(left.sent.start, right.sent.start);
        ASSERT_EQ(left.end, right.end);
    }
}

TEST(BusSteps, UnknownNodeIsAnError)
{
    Verifies(req::SRS_BUS_012);
    // Given three nodes, when a fourth is named, then that is an error of the caller
    BusRig rig;
    EXPECT_THROW(static_cast<void>(rig.bus.Submit(3U, MakeFrame(0U, {}))), std::out_of_range);
    EXPECT_THROW(rig.bus.Plan(3U, MakeFrame(0U, {}), 0), std::out_of_range);
}

} // namespace
} // namespace counterpoint::host
