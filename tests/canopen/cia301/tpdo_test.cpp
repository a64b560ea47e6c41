// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

class TpdoTest : public ServiceRig
{
  public:
    /// Frames sent by now, which are forgotten.
    std::size_t Sent()
    {
        const std::size_t count = sink.frames.size();
        sink.frames.clear();
        return count;
    }
};

TEST_F(TpdoTest, OnlyInOperational)
{
    Verifies(req::SRS_PDO_008);
    UseTpdo(255U);
    Command(128U);
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    Command(2U);
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    Command(1U);
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x11U, 0x22U, 0x33U}));
    EXPECT_EQ(sink.identifier, 0x185U);
    // What waits when OPERATIONAL is left is forgotten
    EXPECT_TRUE(tpdos.Request(1U));
    Command(128U);
    Cycle();
    EXPECT_EQ(Sent(), 0U);
}

TEST_F(TpdoTest, WhatFoundNoRoomIsForgottenOutsideOfOperational)
{
    Verifies(req::SRS_PDO_008);
    for (const std::uint8_t command : {std::uint8_t{128U}, std::uint8_t{2U}})
    {
        UseTpdo(1U);
        Cycle();
        EXPECT_EQ(Sent(), 0U);
        // Given a PDO of a SYNC that waits for room
        sink.room = 0;
        Sync0();
        Cycle();
        EXPECT_EQ(Sent(), 0U);
        // When OPERATIONAL is left and entered again, then it does not come
        Command(command);
        Cycle();
        Command(1U);
        sink.room = 1000000;
        Cycle();
        EXPECT_EQ(Sent(), 0U);
        // but with the next SYNC
        Sync0();
        EXPECT_EQ(Sent(), 1U);
        EXPECT_EQ(WritePdo(0x1800U, 1U, 0x80000185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 0U, 0U), SdoAbort::kNone);
    }
}

TEST_F(TpdoTest, CyclicPdosFollowEachNthSync)
{
    Verifies(req::SRS_PDO_010);
    UseTpdo(3U);
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    for (int i = 0; i < 2; ++i)
    {
        Sync0();
        Sync0();
        EXPECT_EQ(Sent(), 0U);
        u8[0] = 0x99U;
        Sync0();
        EXPECT_EQ(sink.Next(), (Octets{0x99U, 0x22U, 0x33U}));
    }
    EXPECT_EQ(WritePdo(0x1800U, 2U, 1U), SdoAbort::kNone);
    Sync0();
    Sync0();
    EXPECT_EQ(Sent(), 2U);
    EXPECT_EQ(WritePdo(0x1800U, 2U, 240U), SdoAbort::kNone);
    for (int i = 0; i < 239; ++i)
    {
        Sync0();
    }
    EXPECT_EQ(Sent(), 0U);
    Sync0();
    EXPECT_EQ(Sent(), 1U);
}

TEST_F(TpdoTest, TheStartValueSetsThePhase)
{
    Verifies(req::SRS_PDO_010);
    EXPECT_EQ(WritePdo(0x1800U, 6U, 4U), SdoAbort::kNone);
    UseTpdo(3U);
    EXPECT_EQ(Write(sync, 0x1019U, 0U, 6U), SdoAbort::kNone);
    std::vector<int> sent_at{};
    for (int i = 1; i <= 12; ++i)
    {
        Sync0({static_cast<std::uint8_t>(1 + ((i - 1) % 6))});
        if (Sent() > 0U)
        {
            sent_at.push_back(i);
        }
    }
    EXPECT_EQ(sent_at, (std::vector<int>{4, 7, 10}));
    // Without a counter the start value has no effect
    EXPECT_EQ(Write(sync, 0x1019U, 0U, 0U), SdoAbort::kNone);
    Command(128U);
    Cycle();
    Command(1U);
    Sync0();
    Sync0();
    EXPECT_EQ(Sent(), 0U);
    Sync0();
    EXPECT_EQ(Sent(), 1U);
}

TEST_F(TpdoTest, AcyclicPdosWaitForSync)
{
    Verifies(req::SRS_PDO_011);
    UseTpdo(0U);
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    Sync0();
    EXPECT_EQ(Sent(), 1U); // the first values
    Sync0();
    EXPECT_EQ(Sent(), 0U);
    EXPECT_TRUE(tpdos.Request(1U));
    EXPECT_FALSE(tpdos.Request(2U));
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    u8[0] = 0x55U;
    Sync0();
    EXPECT_EQ(sink.Next(), (Octets{0x55U, 0x22U, 0x33U}));
    // A change counts only where the owner chose so
    u8[0] = 0x56U;
    Sync0();
    EXPECT_EQ(Sent(), 0U);
    tpdo_room[0].trigger = PdoTrigger::kChange;
    Sync0();
    EXPECT_EQ(sink.Next(), (Octets{0x56U, 0x22U, 0x33U}));
    Sync0();
    EXPECT_EQ(Sent(), 0U);
    // The event time is none of its events
    EXPECT_EQ(WritePdo(0x1800U, 5U, 10U), SdoAbort::kNone);
    for (int i = 0; i < 5; ++i)
    {
        now_us += 10000U;
        Cycle();
        Sync0();
    }
    EXPECT_EQ(Sent(), 0U);
}

TEST_F(TpdoTest, EventsSendAtOnce)
{
    Verifies(req::SRS_PDO_012);
    for (const std::uint8_t type : Octets{254U, 255U})
    {
        tpdos.Reset();
        tpdo_room[0].trigger = PdoTrigger::kChange;
        UseTpdo(type);
        Cycle();
        EXPECT_EQ(Sent(), 1U); // becoming valid in OPERATIONAL
        Cycle();
        Sync0();
        EXPECT_EQ(Sent(), 0U);
        ++u16[1];
        Cycle();
        Cycle();
        EXPECT_EQ(Sent(), 1U);
        EXPECT_TRUE(tpdos.Request(1U));
        Cycle();
        EXPECT_EQ(Sent(), 1U);
        tpdo_room[0].trigger = PdoTrigger::kRequest;
        ++u16[1];
        Cycle();
        EXPECT_EQ(Sent(), 0U);
        Command(128U);
        Cycle();
        Command(1U);
        Cycle();
        EXPECT_EQ(Sent(), 1U); // entering OPERATIONAL
    }
}

// 1013h in the frame says when the others changed. As an event of its own it would fill the bus.
TEST_F(TpdoTest, TheTimeThatGoesOnIsNoEvent)
{
    Verifies(req::SRS_PDO_150);
    entries[0] = {0x1013U,
                  0U,
                  DataType::kUnsigned32,
                  Access::kReadWrite,
                  kInBoth,
                  kInBoth,
                  4U,
                  u32.data(),
                  nullptr,
                  nullptr,
                  nullptr,
                  nullptr,
                  kInTpdo};
    for (const std::uint8_t type : Octets{0U, 254U, 255U})
    {
        tpdos.Reset();
        u32[0] = 0x44U;
        u16[1] = 0x33U;
        tpdo_room[0].trigger = PdoTrigger::kChange;
        EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21010010U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 2U, 0x10130020U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 3U, 0x21030001U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 0U, 3U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1800U, 2U, type), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
        Cycle();
        Sync0();
        EXPECT_EQ(Sent(), 1U); // the first values
        for (int i = 0; i < 10; ++i)
        {
            ++u32[0];
            Cycle();
            Sync0();
        }
        EXPECT_EQ(Sent(), 0U);
        // A change before and one behind the time are sent with the time of then
        u16[1] = 0x34U;
        Cycle();
        Sync0();
        EXPECT_EQ(sink.Next(), (Octets{0x22U, 0x34U, 0x4EU, 0x55U, 0x66U, 0x77U, 0x01U}));
        u32[0] = 0x50U;
        bit[0] = 0U;
        Cycle();
        Sync0();
        EXPECT_EQ(sink.Next(), (Octets{0x22U, 0x34U, 0x50U, 0x55U, 0x66U, 0x77U, 0x00U}));
        EXPECT_EQ(Sent(), 0U);
        bit[0] = 1U;
    }
}

TEST_F(TpdoTest, TheEventTimerHasNoDrift)
{
    Verifies(req::SRS_PDO_012);
    EXPECT_EQ(WritePdo(0x1800U, 5U, 10U), SdoAbort::kNone);
    UseTpdo(255U);
    Cycle();
    EXPECT_EQ(Sent(), 1U);
    // Cycles of 700 us: 10 000 us end in the 15th, 20 000 us in the 29th, 30 000 us in the 43rd
    std::vector<int> sent_at{};
    for (int i = 1; i <= 43; ++i)
    {
        now_us += 700U;
        Cycle();
        if (Sent() > 0U)
        {
            sent_at.push_back(i);
        }
    }
    EXPECT_EQ(sent_at, (std::vector<int>{15, 29, 43}));
    // Another event starts it anew
    now_us += 5000U;
    EXPECT_TRUE(tpdos.Request(1U));
    Cycle();
    EXPECT_EQ(Sent(), 1U);
    now_us += 9999U;
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    now_us += 1U;
    Cycle();
    EXPECT_EQ(Sent(), 1U);
    // After missed periods there is one, not many
    now_us += 55000U;
    Cycle();
    Cycle();
    EXPECT_EQ(Sent(), 1U);
}

TEST_F(TpdoTest, TheInhibitTimeIsKept)
{
    Verifies(req::SRS_PDO_013);
    tpdo_room[0].trigger = PdoTrigger::kChange;
    EXPECT_EQ(WritePdo(0x1800U, 3U, 50U), SdoAbort::kNone); // 5 ms
    UseTpdo(255U);
    Cycle();
    EXPECT_EQ(Sent(), 1U);
    u8[0] = 0x12U;
    Cycle();
    u8[0] = 0x13U;
    now_us += 4999U;
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    now_us += 1U;
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x13U, 0x22U, 0x33U}));
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    // An answer to a remote frame waits for nothing, and is a transmission that the next event keeps away from
    now_us += 4000U;
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(Sent(), 1U);
    u8[0] = 0x14U;
    now_us += 4999U;
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    now_us += 1U;
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x14U, 0x22U, 0x33U}));
    // OPERATIONAL begins anew
    Command(128U);
    Cycle();
    Command(1U);
    Cycle();
    EXPECT_EQ(Sent(), 1U);
}

TEST_F(TpdoTest, ARemoteFrameOfAnyLengthIsAnsweredAsTheTypeSays)
{
    Verifies(req::SRS_PDO_014);
    UseTpdo(1U);
    CanFrame remote = RemoteOf(0x185U);
    // Given a synchronous type: nothing before the first SYNC, then the values of the last one
    for (const std::uint32_t type : {0U, 1U, 240U})
    {
        Command(128U);
        Cycle();
        EXPECT_EQ(WritePdo(0x1800U, 2U, type), SdoAbort::kNone);
        Command(1U);
        Cycle();
        tpdos.OnFrame(remote, Now());
        EXPECT_EQ(Sent(), 0U) << type;
        u8[0] = 0x21U;
        Sync0();
        static_cast<void>(Sent());
        u8[0] = 0x31U;
        for (remote.length_bytes = 0U; remote.length_bytes <= 8U; ++remote.length_bytes)
        {
            tpdos.OnFrame(remote, Now());
            EXPECT_EQ(sink.Next(), (Octets{0x21U, 0x22U, 0x33U})) << type;
        }
    }
    // An event-driven one: the values of now
    for (const std::uint32_t type : {254U, 255U})
    {
        EXPECT_EQ(WritePdo(0x1800U, 2U, type), SdoAbort::kNone);
        Cycle();
        static_cast<void>(Sent());
        u8[0] = static_cast<std::uint8_t>(type);
        for (remote.length_bytes = 0U; remote.length_bytes <= 8U; ++remote.length_bytes)
        {
            tpdos.OnFrame(remote, Now());
            EXPECT_EQ(sink.Next(), (Octets{static_cast<std::uint8_t>(type), 0x22U, 0x33U})) << type;
        }
    }
}

TEST_F(TpdoTest, RemoteFramesAreAnsweredWhereTheyAreAllowed)
{
    Verifies(req::SRS_PDO_014);
    UseTpdo(253U);
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    u8[0] = 0x21U;
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(sink.Next(), (Octets{0x21U, 0x22U, 0x33U}));
    tpdos.OnFrame(RemoteOf(0x186U), Now());
    tpdos.OnFrame(FrameOf(0x185U, {}), Now());
    EXPECT_EQ(Sent(), 0U);
    // 252: what the last SYNC sampled
    EXPECT_EQ(WritePdo(0x1800U, 2U, 252U), SdoAbort::kNone);
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(Sent(), 0U);
    Sync0();
    EXPECT_EQ(Sent(), 0U);
    u8[0] = 0x31U;
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(sink.Next(), (Octets{0x21U, 0x22U, 0x33U}));
    // Not valid: bit 31
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x80000185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 2U, 253U), SdoAbort::kNone);
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(Sent(), 0U);
    // Not allowed: bit 30
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x40000185U), SdoAbort::kNone);
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(Sent(), 0U);
    // nor outside OPERATIONAL
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x80000185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x00000185U), SdoAbort::kNone);
    Command(128U);
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(Sent(), 0U);
}

TEST_F(TpdoTest, AfterTheWindowASynchronousPdoIsDropped)
{
    Verifies(req::SRS_PDO_015);
    Verifies(req::SRS_PDO_016);
    EXPECT_EQ(Write(sync, 0x1007U, 0U, 500U), SdoAbort::kNone);
    UseTpdo(1U);
    sink.room = 0;
    Sync0();
    now_us += 501U;
    sink.room = 9;
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    // On the limit it goes, with the values of its SYNC
    sink.room = 0;
    Sync0();
    u8[0] = 0x99U;
    now_us += 500U;
    sink.room = 9;
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x11U, 0x22U, 0x33U}));
    Cycle();
    EXPECT_EQ(Sent(), 0U);
}

TEST_F(TpdoTest, WhatFoundNoRoomIsTriedAgain)
{
    Verifies(req::SRS_PDO_016);
    UseTpdo(255U);
    sink.room = 0;
    Cycle();
    Cycle();
    u8[0] = 0x77U;
    sink.room = 9;
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x77U, 0x22U, 0x33U})); // an event has the values of now
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    EXPECT_EQ(WritePdo(0x1800U, 2U, 1U), SdoAbort::kNone);
    sink.room = 0;
    Sync0();
    u8[0] = 0x78U;
    Cycle();
    sink.room = 9;
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x77U, 0x22U, 0x33U}));
}

TEST_F(TpdoTest, WhatWaitsKeepsTheValuesOfItsSync)
{
    Verifies(req::SRS_PDO_016);
    UseTpdo(2U);
    Sync0();
    sink.room = 0;
    Sync0(); // its turn, but there is no room
    u8[0] = 0x99U;
    Sync0(); // not its turn
    sink.room = 9;
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x11U, 0x22U, 0x33U}));
    Sync0();
    EXPECT_EQ(sink.Next(), (Octets{0x99U, 0x22U, 0x33U}));
}

} // namespace
} // namespace counterpoint::cia301
