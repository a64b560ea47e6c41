// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/time/time_stamp.hpp"
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
    EXPECT_EQ(Set(0x1019U, 240U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1006U, 1000U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1019U, 240U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x1019U, 2U), SdoAbort::kDeviceState);
    heard.Reset();
    EXPECT_EQ(Read(heard, 0x1005U, 0U), 0x400000080U);
    EXPECT_EQ(Read(heard, 0x1019U, 0U), 0x100000000U);
}

class TimeStampTest : public ServiceRig, public TimeListener
{
  public:
    void OnTime(const TimeOfDay& time, Instant) noexcept override
    {
        heard = time;
        ++count;
    }
    SdoAbort Set(std::uint32_t value)
    {
        return Write(stamp, 0x1012U, 0U, value);
    }

    TimeOfDay heard{0U, 0U};
    int count{0};
    TimeStamp stamp{sink, *this};
};

TEST_F(TimeStampTest, ATimeIsHeardWhereItIsConsumed)
{
    Verifies(req::SRS_TIM_001);
    const CanFrame time = FrameOf(0x100U, {0x78U, 0x56U, 0x34U, 0xF2U, 0x3BU, 0x3CU});
    stamp.OnFrame(time, Now());
    EXPECT_EQ(count, 0);
    EXPECT_EQ(Set(0x80000100U), SdoAbort::kNone);
    stamp.OnFrame(time, Now());
    EXPECT_EQ(count, 1);
    EXPECT_EQ(heard.ms, 0x02345678U); // the upper four bits are reserved
    EXPECT_EQ(heard.days, 0x3C3BU);
    stamp.OnFrame(FrameOf(0x100U, {1U, 2U, 3U, 4U, 5U}), Now());
    stamp.OnFrame(FrameOf(0x100U, {1U, 2U, 3U, 4U, 5U, 6U, 7U}), Now());
    stamp.OnFrame(FrameOf(0x101U, {1U, 2U, 3U, 4U, 5U, 6U}), Now());
    stamp.OnFrame(RemoteOf(0x100U), Now());
    EXPECT_EQ(count, 1);
}

TEST_F(TimeStampTest, ATimeIsSentWhereItIsProduced)
{
    Verifies(req::SRS_TIM_002);
    EXPECT_FALSE(stamp.Send({0xF2345678U, 0x3C3BU}, Now()));
    EXPECT_EQ(Set(0x40000100U), SdoAbort::kNone);
    EXPECT_TRUE(stamp.Send({0xF2345678U, 0x3C3BU}, Now()));
    EXPECT_EQ(sink.Next(), (Octets{0x78U, 0x56U, 0x34U, 0x02U, 0x3BU, 0x3CU}));
    EXPECT_EQ(sink.identifier, 0x100U);
    sink.room = 0;
    EXPECT_FALSE(stamp.Send({1U, 1U}, Now()));
    sink.room = 9;
    Command(2U);
    EXPECT_FALSE(stamp.Send({1U, 1U}, Now()));
    EXPECT_TRUE(sink.frames.empty());
}

TEST_F(TimeStampTest, TheObjectIsChecked)
{
    Verifies(req::SRS_TIM_003);
    EXPECT_EQ(Read(stamp, 0x1012U, 0U), 0x400000100U);
    static_cast<void>(Read(stamp, 0x1012U, 1U));
    EXPECT_EQ(abort, SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(stamp, 0x1014U, 0U, 0x100U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(Set(0xA0000100U), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0x80000101U), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0x800000FFU), SdoAbort::kNone);
    EXPECT_EQ(Set(0x800000FFU), SdoAbort::kNone);
    EXPECT_EQ(Set(0x80000100U), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0xC00000FFU), SdoAbort::kNone);
    EXPECT_EQ(Set(0x00000100U), SdoAbort::kNone);
    EXPECT_EQ(Set(0x40000100U), SdoAbort::kNone);
    stamp.ResetCommunication(NodeId{5U});
    EXPECT_EQ(Read(stamp, 0x1012U, 0U), 0x400000100U);
}

TEST_F(TimeStampTest, TheHighResolutionTimeCountsMicrosecondsAndIsSet)
{
    Verifies(req::SRS_TIM_004);
    // Given a device whose time is just before its greatest value
    stamp.OnCycle({NodeState::kPreOperational, Instant{0xFFFFFFF0U}});
    EXPECT_EQ(Read(stamp, 0x1013U, 0U), 0x4FFFFFFF0U);
    stamp.OnCycle({NodeState::kPreOperational, Instant{0x10U}});
    EXPECT_EQ(Read(stamp, 0x1013U, 0U), 0x400000010U);
    // When it is set, it goes on from there
    EXPECT_EQ(Write(stamp, 0x1013U, 0U, 1000U), SdoAbort::kNone);
    stamp.OnCycle({NodeState::kPreOperational, Instant{0x11U}});
    EXPECT_EQ(Read(stamp, 0x1013U, 0U), 0x4000003E9U);
    static_cast<void>(Read(stamp, 0x1013U, 1U));
    EXPECT_EQ(abort, SdoAbort::kSubUnknown);
    // and reset communication undoes that
    stamp.ResetCommunication(NodeId{5U});
    EXPECT_EQ(Read(stamp, 0x1013U, 0U), 0x400000011U);
}

} // namespace
} // namespace counterpoint::cia301
