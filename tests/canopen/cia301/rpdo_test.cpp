// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

using RpdoTest = ServiceRig;

TEST_F(RpdoTest, EventDrivenValuesAreWrittenAtOnce)
{
    Verifies(req::SRS_PDO_020);
    for (const std::uint8_t type : Octets{254U, 255U})
    {
        rpdos.Reset();
        UseRpdo(type);
        Hear({0x01U, 0x02U, type});
        EXPECT_EQ(u8[0], 0x01U);
        EXPECT_EQ(u16[0], 0x02U);
        EXPECT_EQ(u16[1], type);
    }
    EXPECT_EQ(written, (std::vector<std::uint16_t>{1U, 1U}));
    rpdos.OnFrame(FrameOf(0x206U, {9U, 9U, 9U}), Now());
    rpdos.OnFrame(RemoteOf(0x205U), Now());
    EXPECT_EQ(u8[0], 0x01U);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x80000205U), SdoAbort::kNone);
    Hear({9U, 9U, 9U});
    EXPECT_EQ(u8[0], 0x01U);
}

TEST_F(RpdoTest, OnlyInOperational)
{
    Verifies(req::SRS_PDO_008);
    UseRpdo(1U);
    Hear({1U, 2U, 3U});
    Command(128U);
    Cycle();
    Hear({4U, 5U, 6U});
    Command(1U);
    Cycle();
    Sync0();
    EXPECT_EQ(u8[0], 0x11U); // what waited was forgotten
    Command(2U);
    Hear({4U, 5U, 6U});
    Command(1U);
    Sync0();
    EXPECT_EQ(u8[0], 0x11U);
}

TEST_F(RpdoTest, SynchronousValuesWaitForSyncAndTheLastOnesCount)
{
    Verifies(req::SRS_PDO_021);
    for (const std::uint8_t type : Octets{0U, 1U, 240U})
    {
        rpdos.Reset();
        UseRpdo(type);
        u8[0] = 0x11U;
        Hear({1U, 2U, 3U});
        Hear({2U, 2U, 3U});
        EXPECT_EQ(u8[0], 0x11U);
        Sync0();
        EXPECT_EQ(u8[0], 2U);
        u8[0] = 0x55U;
        Sync0();
        EXPECT_EQ(u8[0], 0x55U); // once
    }
    // Received values take effect before values are sampled
    UseTpdo(1U);
    Hear({0x42U, 2U, 3U});
    Sync0();
    EXPECT_EQ(sink.Next()[0], 0x42U);
}

TEST_F(RpdoTest, SynchronousPdosAfterTheWindowAreIgnored)
{
    Verifies(req::SRS_PDO_015);
    EXPECT_EQ(Write(sync, 0x1007U, 0U, 500U), SdoAbort::kNone);
    UseRpdo(1U);
    Sync0();
    now_us += 500U;
    Hear({1U, 2U, 3U});
    Sync0();
    EXPECT_EQ(u8[0], 1U);
    now_us += 501U;
    Hear({2U, 2U, 3U});
    Sync0();
    EXPECT_EQ(u8[0], 1U);
    // The window is none for event-driven ones
    EXPECT_EQ(WritePdo(0x1400U, 2U, 254U), SdoAbort::kNone);
    now_us += 501U;
    Hear({2U, 2U, 3U});
    EXPECT_EQ(u8[0], 2U);
}

TEST_F(RpdoTest, TheWindowOfASyncBeforeOperationalDoesNotCount)
{
    Verifies(req::SRS_PDO_015);
    EXPECT_EQ(Write(sync, 0x1007U, 0U, 500U), SdoAbort::kNone);
    UseRpdo(1U);
    Sync0();
    Command(128U);
    Cycle();
    now_us += 10000U;
    Command(1U);
    Hear({1U, 2U, 3U});
    Sync0();
    EXPECT_EQ(u8[0], 1U);
}

TEST_F(RpdoTest, WrongLengthsAreToldOnce)
{
    Verifies(req::SRS_PDO_022);
    UseRpdo(254U);
    Hear({1U, 2U});
    Hear({1U, 2U});
    EXPECT_EQ(u8[0], 0x11U);
    EXPECT_EQ(Emergency(), 0x8210U);
    EXPECT_EQ(source, 1U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    Hear({3U, 2U, 1U, 0U});
    EXPECT_EQ(u8[0], 3U);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(Emergency(), 0x8220U);
    Hear({5U, 2U, 1U, 0U, 0U});
    EXPECT_EQ(u8[0], 5U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    // One that is too short is no right one either
    Hear({6U});
    EXPECT_EQ(Emergency(), 0x8210U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    Hear({4U, 2U, 1U});
    EXPECT_EQ(u8[0], 4U);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
}

TEST_F(RpdoTest, TurnedOffEndsTheErrorsOfItsLength)
{
    Verifies(req::SRS_PDO_024);
    UseRpdo(254U);
    Hear({1U, 2U});
    EXPECT_EQ(Emergency(), 0x8210U);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x80000205U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    Hear({3U, 2U, 1U, 0U});
    EXPECT_EQ(Emergency(), 0x8220U);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone); // as it was: nothing ends
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x80000205U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
}

TEST_F(RpdoTest, TurnedOffOrWithoutADeadlineIsNotLateAnyMore)
{
    Verifies(req::SRS_PDO_024);
    EXPECT_EQ(WritePdo(0x1400U, 5U, 10U), SdoAbort::kNone);
    UseRpdo(254U);
    Hear({1U, 2U, 3U});
    now_us += 10001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0x8250U);
    EXPECT_EQ(WritePdo(0x1400U, 5U, 20U), SdoAbort::kNone); // still late, by any deadline
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    EXPECT_EQ(WritePdo(0x1400U, 5U, 0U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(WritePdo(0x1400U, 5U, 10U), SdoAbort::kNone);
    Hear({1U, 2U, 3U});
    now_us += 10001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0x8250U);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x80000205U), SdoAbort::kNone);
    EXPECT_EQ(Emergency(), 0x0000U);
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
}

// t [ms]    0      10         10.001
// frame     R                 8250h        event time 10 ms
TEST_F(RpdoTest, TheDeadlineIsToldAndLeavesTheStateAlone)
{
    Verifies(req::SRS_PDO_023);
    EXPECT_EQ(WritePdo(0x1400U, 5U, 10U), SdoAbort::kNone);
    UseRpdo(254U);
    now_us += 50000U;
    Cycle(); // nobody was there yet
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    Hear({1U, 2U, 3U});
    now_us += 10000U;
    Cycle();
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    now_us += 1U;
    Cycle();
    EXPECT_EQ(Emergency(), 0x8250U);
    EXPECT_EQ(source, 1U);
    EXPECT_EQ(slave.State(), NodeState::kOperational);
    // Supervision begins anew with the next reception, which clears the error
    now_us += 50000U;
    Cycle();
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    Hear({1U, 2U, 3U});
    EXPECT_EQ(Emergency(), 0x0000U);
    now_us += 10001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0x8250U);
    EXPECT_EQ(slave.State(), NodeState::kOperational);
}

TEST_F(RpdoTest, ThereIsNoDeadlineWithoutAnEventTimeOrAReceptionInOperational)
{
    Verifies(req::SRS_PDO_023);
    // Given no event time, when nothing comes for the longest one, 65.535 s, behind a reception
    UseRpdo(254U);
    Hear({1U, 2U, 3U});
    now_us += 65'535'001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    // Given one of 10 ms, and a reception before OPERATIONAL was left
    EXPECT_EQ(WritePdo(0x1400U, 5U, 10U), SdoAbort::kNone);
    Hear({1U, 2U, 3U});
    Command(128U);
    Cycle();
    // When frames come in PRE-OPERATIONAL alone, then nothing is late there, nor behind it before the next reception
    Hear({1U, 2U, 3U});
    now_us += 10'001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    Command(1U);
    now_us += 10'001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0xFFFFFFFFU);
    Hear({1U, 2U, 3U});
    now_us += 10'001U;
    Cycle();
    EXPECT_EQ(Emergency(), 0x8250U);
}

} // namespace
} // namespace counterpoint::cia301
