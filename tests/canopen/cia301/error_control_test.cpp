// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/nmt/heartbeat_consumer.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "canopen/cia301/nmt/node_guarding.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <vector>

namespace counterpoint::cia301
{
namespace
{

TEST(HeartbeatProducerTest, SendsAtOnceAndThenWithItsPeriodWithoutDrift)
{
    Verifies(req::SRS_HB_001);
    HeartbeatProducer producer{NodeId{5U}};
    const std::uint32_t start = 0xFFFFFF00U; // the counter wraps within the first period
    EXPECT_FALSE(producer.Poll(NodeState::kPreOperational, Instant{start}).is_present);
    producer.SetPeriod(10U);
    EXPECT_EQ(producer.PeriodMs(), 10U);
    const FrameToSend first = producer.Poll(NodeState::kPreOperational, Instant{start});
    ASSERT_TRUE(first.is_present);
    EXPECT_EQ(first.frame.identifier, 0x705U);
    EXPECT_EQ(first.frame.length_bytes, 1U);
    EXPECT_EQ(first.frame.data[0], 127U);
    EXPECT_FALSE(producer.Poll(NodeState::kPreOperational, Instant{start + 9999U}).is_present);
    EXPECT_TRUE(producer.Poll(NodeState::kPreOperational, Instant{start + 10900U}).is_present); // late
    EXPECT_FALSE(producer.Poll(NodeState::kPreOperational, Instant{start + 19999U}).is_present);
    EXPECT_TRUE(producer.Poll(NodeState::kPreOperational, Instant{start + 20000U}).is_present); // no drift
    EXPECT_TRUE(producer.Poll(NodeState::kPreOperational, Instant{start + 75000U}).is_present); // only one
    EXPECT_FALSE(producer.Poll(NodeState::kPreOperational, Instant{start + 84999U}).is_present);
    EXPECT_TRUE(producer.Poll(NodeState::kPreOperational, Instant{start + 85000U}).is_present);
    producer.SetPeriod(0U);
    EXPECT_FALSE(producer.Poll(NodeState::kPreOperational, Instant{start + 99000U}).is_present);
}

TEST(HeartbeatProducerTest, TellsTheState)
{
    Verifies(req::SRS_HB_002);
    constexpr std::array<std::uint8_t, 8> kBytes{0U, 0U, 0U, 0U, 127U, 5U, 4U, 0U};
    for (std::uint8_t state = 0U; state < 8U; ++state)
    {
        EXPECT_EQ(StateByte(static_cast<NodeState>(state)), kBytes[state]);
        HeartbeatProducer producer{NodeId{5U}};
        producer.SetPeriod(1U);
        const FrameToSend sent = producer.Poll(static_cast<NodeState>(state), Instant{0U});
        EXPECT_EQ(sent.is_present, kBytes[state] != 0U);
        EXPECT_EQ(sent.frame.data[0], kBytes[state]);
    }
}

struct Told
{
    std::uint8_t node;
    HeartbeatEvent event;
    std::uint8_t state;
};

class ConsumerTest : public ::testing::Test, public HeartbeatListener
{
  public:
    void OnHeartbeat(NodeId node, HeartbeatEvent event, std::uint8_t state) noexcept override
    {
        told.push_back(Told{node.value, event, state});
    }
    static CanFrame Beat(std::uint8_t node, std::uint8_t state)
    {
        return ErrorControlFrame(NodeId{node}, state);
    }
    void ExpectLast(std::size_t count, const Told& last)
    {
        ASSERT_EQ(told.size(), count);
        EXPECT_EQ(told.back().node, last.node);
        EXPECT_EQ(told.back().event, last.event);
        EXPECT_EQ(told.back().state, last.state);
    }

    std::vector<Told> told{};
    std::array<SupervisedNode, 3> room{};
    HeartbeatConsumer consumer{SupervisedNodes{room.data(), 3U}, *this};
};

TEST_F(ConsumerTest, ConsumerTimesAreChecked)
{
    Verifies(req::SRS_HB_003);
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone);
    EXPECT_EQ(consumer.Value(1U), 0x00070064U);
    EXPECT_EQ(consumer.Write(2U, 0x00070032U), SdoAbort::kIncompatible);
    EXPECT_EQ(consumer.Write(1U, 0x00070032U), SdoAbort::kNone); // the same entry anew
    EXPECT_EQ(consumer.Write(2U, 0x00070000U), SdoAbort::kNone); // time 0 is off
    EXPECT_EQ(consumer.Write(2U, 0x00000064U), SdoAbort::kNone);
    EXPECT_EQ(consumer.Write(3U, 0x00800064U), SdoAbort::kNone); // node 128 is off
    EXPECT_EQ(consumer.Write(2U, 0x00800064U), SdoAbort::kNone);
    EXPECT_EQ(consumer.Write(2U, 0x01080064U), SdoAbort::kValueRange);
    EXPECT_EQ(consumer.Write(2U, 0x80080064U), SdoAbort::kValueRange);
    EXPECT_EQ(consumer.Write(2U, 0x007F0064U), SdoAbort::kNone); // node 127 is on
    EXPECT_EQ(consumer.Write(3U, 0x007F0032U), SdoAbort::kIncompatible);
    EXPECT_EQ(consumer.Write(0U, 0U), SdoAbort::kSubUnknown);
    EXPECT_EQ(consumer.Write(4U, 0U), SdoAbort::kSubUnknown);
    EXPECT_EQ(consumer.Value(0U), 0U);
    EXPECT_EQ(consumer.Value(4U), 0U);
}

// t [us]   0        fffff       +100000   +100001
TEST_F(ConsumerTest, SupervisionBeginsWithTheFirstHeartbeatAndTellsALossOnce)
{
    Verifies(req::SRS_HB_004);
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone); // 100 ms
    // Given a node that was never there
    consumer.Poll(Instant{900000U});
    consumer.OnFrame(Beat(7U, 0U), Instant{0xFFFFFF00U}); // boot-up does not arm
    consumer.Poll(Instant{900000U});
    ExpectLast(1U, {7U, HeartbeatEvent::kBootUp, 0U});
    // When it speaks, then falls silent
    consumer.OnFrame(Beat(7U, 127U), Instant{0xFFFFFF00U});
    ExpectLast(2U, {7U, HeartbeatEvent::kStarted, 127U});
    consumer.Poll(Instant{0xFFFFFF00U + 100000U});
    EXPECT_EQ(told.size(), 2U);
    consumer.Poll(Instant{0xFFFFFF00U + 100001U});
    ExpectLast(3U, {7U, HeartbeatEvent::kLost, 127U});
    // Then it is told once, and again only after a new heartbeat
    consumer.Poll(Instant{0xFFFFFF00U + 300000U});
    EXPECT_EQ(told.size(), 3U);
    consumer.OnFrame(Beat(7U, 5U), Instant{400000U});
    ExpectLast(4U, {7U, HeartbeatEvent::kStarted, 5U});
    consumer.Poll(Instant{600000U});
    ExpectLast(5U, {7U, HeartbeatEvent::kLost, 5U});
}

TEST_F(ConsumerTest, AShortTimeThatBeginsLateIsNotMissed)
{
    Verifies(req::SRS_HB_004);
    EXPECT_EQ(consumer.Write(1U, 0x000703E8U), SdoAbort::kNone); // 1 s
    EXPECT_EQ(consumer.Write(2U, 0x0008000AU), SdoAbort::kNone); // 10 ms
    consumer.OnFrame(Beat(7U, 5U), Instant{0U});
    consumer.Poll(Instant{1000U});
    // When a second node speaks while the first one is awaited for long, and again, and then falls silent
    consumer.OnFrame(Beat(8U, 5U), Instant{300000U});
    consumer.OnFrame(Beat(8U, 5U), Instant{305000U});
    consumer.Poll(Instant{315000U});
    EXPECT_EQ(told.size(), 2U);
    // Then it is lost a microsecond after its own time, and the first one after its own
    consumer.Poll(Instant{315001U});
    ExpectLast(3U, {8U, HeartbeatEvent::kLost, 5U});
    consumer.Poll(Instant{1000000U});
    EXPECT_EQ(told.size(), 3U);
    consumer.Poll(Instant{1000001U});
    ExpectLast(4U, {7U, HeartbeatEvent::kLost, 5U});
}

TEST_F(ConsumerTest, EachNodeHasItsOwnEvents)
{
    Verifies(req::SRS_HB_005);
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone);
    EXPECT_EQ(consumer.Write(3U, 0x00080032U), SdoAbort::kNone);
    consumer.OnFrame(Beat(7U, 127U), Instant{0U});
    consumer.OnFrame(Beat(8U, 127U), Instant{0U});
    consumer.OnFrame(Beat(7U, 127U), Instant{10U}); // the same state is no event
    EXPECT_EQ(told.size(), 2U);
    consumer.OnFrame(Beat(7U, 5U), Instant{20U});
    ExpectLast(3U, {7U, HeartbeatEvent::kChanged, 5U});
    // A boot-up directly followed by a heartbeat is both
    consumer.OnFrame(Beat(7U, 0U), Instant{30U});
    ExpectLast(4U, {7U, HeartbeatEvent::kBootUp, 0U});
    consumer.OnFrame(Beat(7U, 127U), Instant{30U});
    ExpectLast(5U, {7U, HeartbeatEvent::kStarted, 127U});
    consumer.Poll(Instant{60000U});
    ExpectLast(6U, {8U, HeartbeatEvent::kLost, 127U});
}

TEST_F(ConsumerTest, ABootUpEndsSupervisionUntilTheNextHeartbeat)
{
    Verifies(req::SRS_HB_005);
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone); // 100 ms
    consumer.OnFrame(Beat(7U, 5U), Instant{0U});
    ExpectLast(1U, {7U, HeartbeatEvent::kStarted, 5U});
    // When a supervised node restarts and says nothing for longer than its time
    consumer.OnFrame(Beat(7U, 0U), Instant{50000U});
    ExpectLast(2U, {7U, HeartbeatEvent::kBootUp, 0U});
    consumer.Poll(Instant{900000U});
    // Then it is not lost, and after its next heartbeat it may be
    EXPECT_EQ(told.size(), 2U);
    consumer.OnFrame(Beat(7U, 127U), Instant{900000U});
    ExpectLast(3U, {7U, HeartbeatEvent::kStarted, 127U});
    consumer.Poll(Instant{1000000U});
    EXPECT_EQ(told.size(), 3U);
    consumer.Poll(Instant{1000001U});
    ExpectLast(4U, {7U, HeartbeatEvent::kLost, 127U});
}

TEST_F(ConsumerTest, WhatIsNoHeartbeatChangesNothing)
{
    Verifies(req::SRS_HB_006);
    EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone);
    CanFrame frame = Beat(7U, 5U);
    frame.length_bytes = 0U;
    consumer.OnFrame(frame, Instant{0U});
    frame.length_bytes = 2U;
    consumer.OnFrame(frame, Instant{0U});
    frame.length_bytes = 1U;
    for (const FrameKind kind : {FrameKind::kInvalid, FrameKind::kRemote, FrameKind::kExtended,
                                 FrameKind::kExtendedRemote, FrameKind::kFlexibleDataRate})
    {
        frame.kind = kind;
        consumer.OnFrame(frame, Instant{0U});
    }
    consumer.OnFrame(Beat(9U, 5U), Instant{0U});
    for (std::uint32_t state = 0U; state < 256U; ++state)
    {
        if ((state != 0U) && (state != 4U) && (state != 5U) && (state != 127U))
        {
            consumer.OnFrame(Beat(7U, static_cast<std::uint8_t>(state)), Instant{0U});
        }
    }
    EXPECT_TRUE(told.empty());
    consumer.OnFrame(Beat(7U, 4U), Instant{0U});
    EXPECT_EQ(told.size(), 1U);
}

TEST_F(ConsumerTest, WhatIsNoHeartbeatProlongsNoSupervision)
{
    Verifies(req::SRS_HB_006);
    CanFrame empty = Beat(7U, 5U);
    empty.length_bytes = 0U;
    CanFrame long_one = Beat(7U, 5U);
    long_one.length_bytes = 2U;
    CanFrame remote = Beat(7U, 5U);
    remote.kind = FrameKind::kRemote;
    CanFrame extended = Beat(7U, 5U);
    extended.kind = FrameKind::kExtended;
    for (const CanFrame& frame :
         {empty, long_one, remote, extended, Beat(9U, 5U), Beat(7U, 0x85U), Beat(7U, 1U), Beat(7U, 255U)})
    {
        // Given a node that is supervised with 100 ms since its heartbeat at 0
        told.clear();
        EXPECT_EQ(consumer.Write(1U, 0x00070064U), SdoAbort::kNone);
        consumer.OnFrame(Beat(7U, 5U), Instant{0U});
        ASSERT_EQ(told.size(), 1U);
        // When something that is no heartbeat comes before they are over
        consumer.OnFrame(frame, Instant{99000U});
        EXPECT_EQ(told.size(), 1U);
        // Then it is lost as without it, in the state of its heartbeat
        consumer.Poll(Instant{100000U});
        EXPECT_EQ(told.size(), 1U);
        consumer.Poll(Instant{100001U});
        ExpectLast(2U, {7U, HeartbeatEvent::kLost, 5U});
    }
}

class GuardingTest : public ::testing::Test
{
  public:
    /// The first byte of the answer, or 0.
    std::uint8_t Ask(NodeState state, std::uint32_t now_us, std::uint8_t length = 1U, std::uint16_t heartbeat_ms = 0U)
    {
        const CanFrame request{0x705U, FrameKind::kRemote, CanPortId::kFirst, length, {}};
        const GuardReply answer = guarding.OnFrame(request, GuardMoment{state, heartbeat_ms, Instant{now_us}});
        event = answer.event;
        EXPECT_TRUE(!answer.reply.is_present || (answer.reply.frame.identifier == 0x705U));
        EXPECT_TRUE(!answer.reply.is_present || (answer.reply.frame.kind == FrameKind::kData));
        EXPECT_TRUE(!answer.reply.is_present || (answer.reply.frame.length_bytes == 1U));
        return answer.reply.is_present ? answer.reply.frame.data[0] : std::uint8_t{0U};
    }

    NodeGuarding guarding{NodeId{5U}};
    GuardEvent event{GuardEvent::kNone};
};

TEST_F(GuardingTest, RemoteFramesAreAnsweredWithAnAlternatingToggle)
{
    Verifies(req::SRS_GRD_001);
    EXPECT_EQ(Ask(NodeState::kPreOperational, 0U, 0U), 0x7FU);
    EXPECT_EQ(Ask(NodeState::kOperational, 0U, 1U), 0x85U);
    EXPECT_EQ(Ask(NodeState::kStopped, 0U, 8U), 0x04U);
    guarding.Reset();
    EXPECT_EQ(Ask(NodeState::kPreOperational, 0U), 0x7FU);
    EXPECT_EQ(Ask(NodeState::kInitialising, 0U), 0U);
    EXPECT_EQ(Ask(NodeState::kPreOperational, 0U, 1U, 100U), 0U); // heartbeat is on
    EXPECT_EQ(Ask(NodeState::kPreOperational, 0U), 0xFFU);
    const GuardMoment moment{NodeState::kPreOperational, 0U, Instant{0U}};
    const CanFrame data{0x705U, FrameKind::kData, CanPortId::kFirst, 1U, {}};
    const CanFrame foreign{0x706U, FrameKind::kRemote, CanPortId::kFirst, 1U, {}};
    EXPECT_FALSE(guarding.OnFrame(data, moment).reply.is_present);
    EXPECT_FALSE(guarding.OnFrame(foreign, moment).reply.is_present);
}

TEST_F(GuardingTest, AMasterThatFallsSilentIsToldOnceAndItsReturnToo)
{
    Verifies(req::SRS_GRD_002);
    guarding.SetLifeTime(100U, 3U);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{900000U}}),
              GuardEvent::kNone); // not before the first remote frame
    EXPECT_EQ(Ask(NodeState::kOperational, 1000000U), 0x05U);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{1300000U}}), GuardEvent::kNone);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{1300001U}}), GuardEvent::kLost);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{1900000U}}), GuardEvent::kNone);
    EXPECT_EQ(Ask(NodeState::kOperational, 2000000U), 0x85U);
    EXPECT_EQ(event, GuardEvent::kResumed);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{2300001U}}), GuardEvent::kLost);
    guarding.SetLifeTime(100U, 0U);
    EXPECT_EQ(Ask(NodeState::kOperational, 3000000U), 0x05U);
    EXPECT_EQ(event, GuardEvent::kNone);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{9000000U}}), GuardEvent::kNone);
    guarding.SetLifeTime(0U, 3U);
    EXPECT_EQ(Ask(NodeState::kOperational, 9000000U), 0x85U);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{19000000U}}), GuardEvent::kNone);
}

// Guarded at 1 s with a life time of 300 ms, heartbeat on at 1.1 s
TEST_F(GuardingTest, HeartbeatsEndLifeGuarding)
{
    Verifies(req::SRS_GRD_010);
    guarding.SetLifeTime(100U, 3U);
    EXPECT_EQ(Ask(NodeState::kOperational, 1000000U), 0x05U);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 100U, Instant{1100000U}}), GuardEvent::kNone);
    EXPECT_EQ(Ask(NodeState::kOperational, 1200000U, 1U, 100U), 0U); // No answer, and nothing begins.
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 100U, Instant{1300001U}}), GuardEvent::kNone);
    EXPECT_FALSE(guarding.IsLost());
    // Off again: from the next remote frame on, with the life time from there
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{9000000U}}), GuardEvent::kNone);
    EXPECT_EQ(Ask(NodeState::kOperational, 9100000U), 0x85U);
    EXPECT_EQ(event, GuardEvent::kNone);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{9400000U}}), GuardEvent::kNone);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{9400001U}}), GuardEvent::kLost);
}

TEST_F(GuardingTest, AMasterIsNotLostAnyMoreWhereNobodyIsGuarded)
{
    Verifies(req::SRS_GRD_011);
    guarding.SetLifeTime(100U, 3U);
    EXPECT_EQ(Ask(NodeState::kOperational, 0U), 0x05U);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{300001U}}), GuardEvent::kLost);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{400000U}}), GuardEvent::kNone);
    EXPECT_TRUE(guarding.IsLost());
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 100U, Instant{500000U}}), GuardEvent::kNone);
    EXPECT_FALSE(guarding.IsLost());
    EXPECT_EQ(Ask(NodeState::kOperational, 600000U), 0x85U);
    EXPECT_EQ(event, GuardEvent::kNone); // Its end was told when heartbeats began.
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{900001U}}), GuardEvent::kLost);
    guarding.SetLifeTime(100U, 0U);
    EXPECT_FALSE(guarding.IsLost());
}

TEST_F(GuardingTest, ALifeTimeBeyondTheCounterIsKept)
{
    Verifies(req::SRS_GRD_002);
    guarding.SetLifeTime(65535U, 255U); // 16711425 ms
    std::uint32_t now_us = 0U;
    EXPECT_EQ(Ask(NodeState::kOperational, now_us), 0x05U);
    for (int second = 0; second < 16711; ++second)
    {
        now_us += 1000000U;
        ASSERT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{now_us}}), GuardEvent::kNone) << second;
    }
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{now_us + 425000U}}), GuardEvent::kNone);
    EXPECT_EQ(guarding.Poll({NodeState::kOperational, 0U, Instant{now_us + 425001U}}), GuardEvent::kLost);
}

} // namespace
} // namespace counterpoint::cia301
