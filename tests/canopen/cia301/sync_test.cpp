// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

class SyncTest : public ServiceRig, public SyncListener
{
  public:
    void OnSync(const SyncEvent& event) noexcept override
    {
        counters.push_back(event.counter);
        window_us = event.window_us;
    }
    SdoAbort Set(std::uint16_t index, std::uint32_t value)
    {
        return Write(heard, index, 0U, value);
    }

    std::vector<std::uint8_t> counters{};
    std::uint32_t window_us{0U};
    Sync heard{SyncParts{sink, errors, *this}};
};

TEST_F(SyncTest, ADataFrameOnTheIdentifierIsASync)
{
    Verifies(req::SRS_SYNC_001);
    heard.OnFrame(FrameOf(0x80U, {}), Now());
    EXPECT_EQ(counters, (Octets{0U}));
    heard.OnFrame(FrameOf(0x81U, {}), Now());
    heard.OnFrame(RemoteOf(0x80U), Now());
    EXPECT_EQ(counters.size(), 1U);
    EXPECT_EQ(Set(0x1005U, 0x100U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1007U, 500U), SdoAbort::kNone);
    heard.OnFrame(FrameOf(0x80U, {}), Now());
    EXPECT_EQ(counters.size(), 1U);
    heard.OnFrame(FrameOf(0x100U, {}), Now());
    EXPECT_EQ(counters.size(), 2U);
    EXPECT_EQ(window_us, 500U);
}

TEST_F(SyncTest, ASyncIsOneInPreOperationalAndOperationalOnlyAndHasItsCounter)
{
    Verifies(req::SRS_SYNC_001);
    EXPECT_EQ(Set(0x1019U, 10U), SdoAbort::kNone);
    for (const NodeState state : {NodeState::kInvalid, NodeState::kInitialising, NodeState::kResetApplication,
                                  NodeState::kResetCommunication, NodeState::kStopped})
    {
        heard.OnFrame(FrameOf(0x80U, {1U}), Moment{state, Instant{now_us}});
    }
    EXPECT_TRUE(counters.empty());
    heard.OnFrame(FrameOf(0x80U, {2U}), Moment{NodeState::kPreOperational, Instant{now_us}});
    heard.OnFrame(FrameOf(0x80U, {3U}), Moment{NodeState::kOperational, Instant{now_us}});
    EXPECT_EQ(counters, (Octets{2U, 3U}));
}

TEST_F(SyncTest, TheProducerIsSilentInStoppedAndBeforePreOperational)
{
    Verifies(req::SRS_SYNC_003);
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone);
    for (const NodeState state : {NodeState::kInvalid, NodeState::kInitialising, NodeState::kResetApplication,
                                  NodeState::kResetCommunication, NodeState::kStopped})
    {
        heard.OnCycle(Moment{state, Instant{now_us}});
        now_us += 1000U;
    }
    EXPECT_TRUE(sink.frames.empty());
    heard.OnCycle(Moment{NodeState::kPreOperational, Instant{now_us}});
    EXPECT_EQ(sink.frames.size(), 1U);
    now_us += 1000U;
    heard.OnCycle(Moment{NodeState::kOperational, Instant{now_us}});
    EXPECT_EQ(sink.frames.size(), 2U);
}

TEST_F(SyncTest, AnotherIdentifierOrCounterEndsTheErrorOfTheLength)
{
    Verifies(req::SRS_SYNC_006);
    heard.OnFrame(FrameOf(0x80U, {1U}), Now());
    EXPECT_EQ(Emergency(), 0x8240U);
    EXPECT_EQ(Set(0x1005U, 0x80U), SdoAbort::kNone); // as it was
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone); // the same identifier, which it sends now
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(Set(0x1005U, 0x80U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(Set(0x1005U, 0x81U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    heard.OnFrame(FrameOf(0x81U, {1U}), Now());
    EXPECT_EQ(Emergency(), 0x8240U);
    EXPECT_EQ(Set(0x1019U, 10U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    heard.OnFrame(FrameOf(0x81U, {}), Now());
    EXPECT_EQ(Emergency(), 0x8240U);
    EXPECT_EQ(Set(0x1019U, 20U), SdoAbort::kNone); // a byte as before
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(Set(0x1019U, 0U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
}

TEST_F(SyncTest, AWrongLengthIsToldOnceAndIsNoSync)
{
    Verifies(req::SRS_SYNC_002);
    Verifies(req::SRS_ERR_001);
    heard.OnFrame(FrameOf(0x80U, {1U}), Now());
    heard.OnFrame(FrameOf(0x80U, {2U}), Now());
    EXPECT_TRUE(counters.empty());
    EXPECT_EQ(Emergency(), 0x8240U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    heard.OnFrame(FrameOf(0x80U, {}), Now());
    EXPECT_EQ(Emergency(), 0x0000U);
    // With a counter the byte is demanded
    EXPECT_EQ(Set(0x1019U, 10U), SdoAbort::kNone);
    heard.OnFrame(FrameOf(0x80U, {}), Now());
    EXPECT_EQ(counters.size(), 1U);
    EXPECT_EQ(Emergency(), 0x8240U);
    heard.OnFrame(FrameOf(0x80U, {7U, 0U}), Now());
    EXPECT_EQ(counters.size(), 1U);
    heard.OnFrame(FrameOf(0x80U, {7U}), Now());
    EXPECT_EQ(counters, (Octets{0U, 7U}));
    EXPECT_EQ(Emergency(), 0x0000U);
}

TEST_F(SyncTest, TheProducerKeepsItsPeriod)
{
    Verifies(req::SRS_SYNC_003);
    heard.OnCycle(Now());
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone);
    heard.OnCycle(Now());
    EXPECT_TRUE(sink.frames.empty()); // bit 30 is missing
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone);
    heard.OnCycle(Now());
    ASSERT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(sink.frames[0].identifier, 0x80U);
    EXPECT_EQ(sink.frames[0].length_bytes, 0U);
    EXPECT_EQ(counters, (Octets{0U})); // it acts on itself
    now_us += 999U;
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 1U);
    // 300 us late, then in phase: due at 1000 and 2000
    now_us += 301U;
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 2U);
    now_us += 700U;
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 3U);
    // After three missed periods only one is sent, and the phase begins anew
    now_us += 3500U;
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 4U);
    now_us += 999U;
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 4U);
    now_us += 1U;
    // What the sink does not take is tried again
    sink.room = 0;
    heard.OnCycle(Now());
    EXPECT_EQ(counters.size(), 4U);
    sink.room = 9;
    heard.OnCycle(Now());
    EXPECT_EQ(counters.size(), 5U);
}

TEST_F(SyncTest, ANewPeriodBeginsAtOnce)
{
    Verifies(req::SRS_SYNC_003);
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone);
    heard.OnCycle(Now());
    now_us += 100U;
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone); // the same
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 1U);
    EXPECT_EQ(Set(0x1006U, 2000U), SdoAbort::kNone);
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 2U);
    now_us += 1999U;
    heard.OnCycle(Now());
    EXPECT_EQ(sink.frames.size(), 2U);
}

TEST_F(SyncTest, TheCounterBeginsAtOneAndOverflows)
{
    Verifies(req::SRS_SYNC_004);
    EXPECT_EQ(Set(0x1019U, 3U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone);
    for (int i = 0; i < 5; ++i)
    {
        heard.OnCycle(Now());
        now_us += 1000U;
    }
    EXPECT_EQ(counters, (Octets{1U, 2U, 3U, 1U, 2U}));
    EXPECT_EQ(sink.frames[4].length_bytes, 1U);
    EXPECT_EQ(sink.frames[4].data[0], 2U);
    Command(2U);
    heard.OnCycle(Now());
    EXPECT_EQ(counters.size(), 5U);
    Command(128U);
    heard.OnCycle(Now());
    EXPECT_EQ(counters.back(), 1U);
    // A start of the node goes on with it
    Command(1U);
    now_us += 1000U;
    heard.OnCycle(Now());
    EXPECT_EQ(counters.back(), 2U);
    // A production that starts anew begins at 1, whatever ended it
    for (const std::uint16_t index : {std::uint16_t{0x1005U}, std::uint16_t{0x1006U}})
    {
        EXPECT_EQ(Set(index, (index == 0x1005U) ? 0x00000080U : 0U), SdoAbort::kNone);
        now_us += 1000U;
        heard.OnCycle(Now());
        EXPECT_EQ(Set(index, (index == 0x1005U) ? 0x40000080U : 1000U), SdoAbort::kNone);
        heard.OnCycle(Now());
        EXPECT_EQ(counters.back(), 1U) << index;
        now_us += 1000U;
        heard.OnCycle(Now());
        EXPECT_EQ(counters.back(), 2U) << index;
    }
}

TEST_F(SyncTest, ObjectsAreChecked)
{
    Verifies(req::SRS_SYNC_005);
    EXPECT_EQ(Read(heard, 0x1005U, 0U), 0x400000080U);
    EXPECT_EQ(Read(heard, 0x1006U, 0U), 0x400000000U);
    EXPECT_EQ(Read(heard, 0x1007U, 0U), 0x400000000U);
    EXPECT_EQ(Read(heard, 0x1019U, 0U), 0x100000000U);
    static_cast<void>(Read(heard, 0x1005U, 1U));
    EXPECT_EQ(abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(Set(0x1008U, 0U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(Set(0x1005U, 0x20000080U), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0x1005U, 0x00000181U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1005U, 0x00000601U), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1005U, 0x40000080U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1005U, 0x40000081U), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0x1005U, 0x00000081U), SdoAbort::kNone);
    for (const std::uint32_t wrong : {1U, 241U, 255U})
    {
        EXPECT_EQ(Set(0x1019U, wrong), SdoAbort::kValueRange);
    }
    for (const std::uint32_t right : {2U, 0U, 240U})
    {
        EXPECT_EQ(Set(0x1019U, right), SdoAbort::kNone);
    }
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1019U, 240U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1019U, 2U), SdoAbort::kDeviceState);
    heard.Reset();
    EXPECT_EQ(Read(heard, 0x1005U, 0U), 0x400000080U);
    EXPECT_EQ(Read(heard, 0x1019U, 0U), 0x100000000U);
}

} // namespace
} // namespace counterpoint::cia301
