// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/time/time_stamp.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

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
    // In OPERATIONAL until now; in PRE-OPERATIONAL as well, in STOPPED not
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    Command(128U);
    stamp.OnFrame(time, Now());
    EXPECT_EQ(count, 2);
    Command(2U);
    stamp.OnFrame(time, Now());
    EXPECT_EQ(count, 2);
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
    EXPECT_TRUE(sink.frames.empty());
    // In OPERATIONAL until now; in PRE-OPERATIONAL as well, in STOPPED not
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    Command(128U);
    EXPECT_EQ(slave.State(), NodeState::kPreOperational);
    EXPECT_TRUE(stamp.Send({2U, 0U}, Now()));
    EXPECT_EQ(sink.Next(), (Octets{2U, 0U, 0U, 0U, 0U, 0U}));
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
    EXPECT_EQ(Set(0x400000FFU), SdoAbort::kValueRange);
    EXPECT_EQ(Set(0x800000FFU), SdoAbort::kValueRange); // The other role is one, too.
    EXPECT_EQ(Read(stamp, 0x1012U, 0U), 0x440000100U);
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
