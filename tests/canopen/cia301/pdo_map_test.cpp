// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Mappings as they are loaded in any order, at the edges of 64 bits, and PDOs that hold nothing.
#include "tests/canopen/cia301/service_rig.hpp"
#include "verification/trace/ids/pdo.hpp"

namespace counterpoint::cia301
{
namespace
{

class PdoMapTest : public ServiceRig
{
  public:
    void BeginLoading()
    {
        tpdos.BeginConfiguration();
        rpdos.BeginConfiguration();
    }
    void EndLoading()
    {
        tpdos.EndConfiguration();
        rpdos.EndConfiguration();
    }
    std::size_t Sent()
    {
        const std::size_t count = sink.frames.size();
        sink.frames.clear();
        return count;
    }
    [[nodiscard]] std::uint64_t CobId(std::uint16_t index)
    {
        return Read(objects, index, 1U) & 0xFFFFFFFFU;
    }
};

/// Allows nobody 206h, and 1801h 305h.
class NotTwice final : public WriteRule
{
  public:
    [[nodiscard]] bool Allows(const ObjectAddress& object, std::uint32_t value) const noexcept override
    {
        return (object.sub == 1U) && (value != 0x206U) && ((object.index != 0x19FFU) || (value != 0x305U));
    }
};

TEST_F(PdoMapTest, ANumberOfSixtyFourBitsIsAWholePdo)
{
    Verifies(req::SRS_PDO_006);
    EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21040040U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 2U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    Sync0();
    EXPECT_EQ(sink.Next(), (Octets{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}));
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x21040040U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1600U, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 2U, 254U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    Hear({0xFFU, 0xFEU, 0xFDU, 0xFCU, 0xFBU, 0xFAU, 0xF9U, 0xF8U});
    EXPECT_EQ(u64[0], 0xFFU);
    EXPECT_EQ(u64[7], 0xF8U);
}

TEST_F(PdoMapTest, DummiesAreSubIndexZeroOfOneToSeven)
{
    Verifies(req::SRS_PDO_005);
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x00050008U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x00000008U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x00050108U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(WritePdo(0x1600U, 1U, 0x00080008U), SdoAbort::kObjectUnknown);
}

TEST_F(PdoMapTest, FieldsThatAreNotThereAndEntriesOfMoreThanEightBytes)
{
    Verifies(req::SRS_PDO_001);
    Verifies(req::SRS_PDO_005);
    std::array<std::uint8_t, 9> nine{};
    const Entry table[] = {{0x2200U, 0U, DataType::kDomain, Access::kReadWrite, kInBoth, kInBoth, 9U, nine.data(),
                            nullptr, nullptr, nullptr, nullptr, kInTpdo | kInRpdo}};
    Dictionary own{EntryTable{table, 1U}, foreign};
    std::array<PdoField, 2> fields{};
    PdoMap map{fields.data(), 2U};
    EXPECT_EQ(WriteField(map, 0U, 0x22000048U, kInTpdo, own), SdoAbort::kSubUnknown);
    EXPECT_EQ(WriteField(map, 3U, 0x22000048U, kInTpdo, own), SdoAbort::kSubUnknown);
    EXPECT_EQ(WriteField(map, 1U, 0x22000048U, kInTpdo, own), SdoAbort::kNotMappable);
    EXPECT_EQ(fields[0].mapping, 0U);
}

TEST_F(PdoMapTest, ALoadedMappingThatDoesNotHoldTurnsItsPdoOff)
{
    Verifies(req::SRS_PDO_007);
    // More fields than there is room for, a count of more than a byte, two fields that are none
    for (const std::uint32_t count : {1U, 2U, 65U, 0x100U})
    {
        BeginLoading();
        EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 0U, count), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21000008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 2U, (count == 2U) ? 0x22220008U : 0x21010010U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1A00U, 3U, 0x22230008U), SdoAbort::kNone);
        EndLoading();
        EXPECT_EQ(CobId(0x1800U), (count == 1U) ? 0x185U : 0x80000185U) << count;
        EXPECT_EQ(Read(objects, 0x1A00U, 0U), (count == 1U) ? 0x100000001U : 0x100000000U) << count;
        tpdos.Reset();
    }
    for (const bool is_right : {true, false})
    {
        BeginLoading();
        EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1600U, 1U, 0x22220008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1600U, 2U, 0x22230008U), SdoAbort::kNone);
        EXPECT_EQ(WritePdo(0x1600U, 0U, is_right ? 0U : 2U), SdoAbort::kNone);
        EndLoading();
        EXPECT_EQ(CobId(0x1400U), is_right ? 0x205U : 0x80000205U);
        rpdos.Reset();
    }
    // What comes for a field that is not there changes none
    std::array<PdoField, 1> fields{};
    PdoMap map{fields.data(), 1U};
    PrepareMap(map, 2U, 0x21000008U);
    EXPECT_EQ(fields[0].mapping, 0U);
    PrepareMap(map, 0U, 0x1FFU);
    EXPECT_EQ(map.count, 0xFFU);
}

TEST_F(PdoMapTest, TheEndOfALoadingThatHasNotBegunChangesNothing)
{
    Verifies(req::SRS_PDO_007);
    UseTpdo(254U);
    UseRpdo(254U);
    Cycle();
    EXPECT_EQ(Sent(), 1U);
    EndLoading();
    Cycle();
    EXPECT_EQ(Sent(), 0U); // Not sent as on becoming valid.
    EXPECT_EQ(CobId(0x1800U), 0x185U);
    EXPECT_EQ(CobId(0x1400U), 0x205U);
}

TEST_F(PdoMapTest, ValuesPassTheHooksOfTheirEntries)
{
    Verifies(req::SRS_PDO_006);
    class Hook final : public ReadHook, public WriteHook
    {
      public:
        Reading OnRead(const ObjectAddress& address, const Room& room) noexcept override
        {
            asked = address.index;
            room.data[0] = 0x5AU;
            return Reading{SdoAbort::kNone, 1U};
        }
        SdoAbort OnWrite(const ObjectAddress&, const Bytes& value) noexcept override
        {
            written.push_back(value.data[0]);
            return (value.data[0] == 0x66U) ? SdoAbort::kHardware : SdoAbort::kNone;
        }
        std::uint16_t asked{0U};
        Octets written{};
    };
    Hook hook{};
    entries[0].read_hook = &hook;
    entries[0].write_hook = &hook;
    UseTpdo(254U);
    UseRpdo(254U);
    Cycle();
    EXPECT_EQ(sink.Next(), (Octets{0x5AU, 0x22U, 0x33U}));
    EXPECT_EQ(hook.asked, 0x2100U);
    Hear({0x65U, 1U, 2U});
    EXPECT_EQ(u8[0], 0x65U);
    // A value that the hook refuses leaves its entry as it was, and the other one is taken
    Hear({0x66U, 3U, 4U});
    EXPECT_EQ(hook.written, (Octets{0x65U, 0x66U}));
    EXPECT_EQ(u8[0], 0x65U);
    EXPECT_EQ(u16, (std::array<std::uint8_t, 2>{3U, 4U}));
}

TEST_F(PdoMapTest, AFieldWithoutAnEntryIsZeroAndNothingIsBehindTheLastBit)
{
    Verifies(req::SRS_PDO_006);
    Entry hollow = entries[0];
    hollow.place = nullptr; // Neither room nor hook.
    std::array<PdoField, 3> fields{{{0x21000008U, nullptr}, {0x21000008U, &hollow}, {0x21000008U, &entries[0]}}};
    const PdoMap three{fields.data(), 3U, 3U, 24U};
    EXPECT_EQ(Pack(three).bytes[0], 0U);
    EXPECT_EQ(Pack(three).bytes[1], 0U);
    EXPECT_EQ(Pack(three).bytes[2], 0x11U);
    // Two fields of 64 bits: the second one has no place
    std::array<PdoField, 2> wide{{{0x21040040U, &entries[4]}, {0x21000008U, &entries[0]}}};
    const PdoMap two{wide.data(), 2U, 2U, 72U};
    EXPECT_EQ(Pack(two).bytes[0], 1U);
    EXPECT_EQ(Pack(two).bytes[7], 8U);
    EXPECT_FALSE(IsChanged(two, Pack(two), Pack(two)));
    EXPECT_TRUE(IsChanged(two, Pack(two), PdoData{{9U, 9U, 9U, 9U, 9U, 9U, 9U, 9U}}));
    Unpack(two, PdoData{{9U, 9U, 9U, 9U, 9U, 9U, 9U, 9U}});
    EXPECT_EQ(u64[7], 9U);
    EXPECT_EQ(u8[0], 0x11U);
}

TEST_F(PdoMapTest, AValidPdoWithoutAMappingIsNeitherSentNorTaken)
{
    Verifies(req::SRS_PDO_012);
    Verifies(req::SRS_PDO_020);
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    EXPECT_TRUE(tpdos.Request(1U));
    Cycle();
    EXPECT_EQ(Sent(), 0U);
    Hear({});
    EXPECT_TRUE(written.empty());
}

TEST_F(PdoMapTest, WithoutAStartValueTheCounterOfSyncHasNoEffect)
{
    Verifies(req::SRS_PDO_010);
    EXPECT_EQ(Write(sync, 0x1019U, 0U, 10U), SdoAbort::kNone);
    UseTpdo(1U);
    Sync0({7U});
    EXPECT_EQ(Sent(), 1U);
    Sync0({8U});
    EXPECT_EQ(Sent(), 1U);
}

TEST_F(PdoMapTest, AnAnswerToARemoteFrameWaitsForRoomAndOneThatIsTurnedOffIsForgotten)
{
    Verifies(req::SRS_PDO_016);
    UseTpdo(253U);
    Cycle();
    Sent();
    sink.room = 0;
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(Sent(), 0U);
    sink.room = 10;
    now_us += 1'000'000U; // No window.
    Cycle();
    EXPECT_EQ(Sent(), 1U);
    sink.room = 0;
    tpdos.OnFrame(RemoteOf(0x185U), Now());
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x80000185U), SdoAbort::kNone);
    sink.room = 10;
    Cycle();
    EXPECT_EQ(Sent(), 0U);
}

TEST_F(PdoMapTest, ReceivedValuesAreWrittenAlsoWhereNobodyListens)
{
    Verifies(req::SRS_PDO_020);
    Rpdos deaf{RpdoParts{errors, dictionary, RpdoTable{rpdo_room.data(), 1U}, nullptr}};
    UseRpdo(254U);
    deaf.OnFrame(FrameOf(0x205U, {0x42U, 1U, 2U}), Now());
    EXPECT_EQ(u8[0], 0x42U);
    EXPECT_TRUE(written.empty());
}

TEST_F(PdoMapTest, WhoUsesAnIdentifierAndWhoIsTurnedOffForIt)
{
    Verifies(req::SRS_PDO_009);
    UseTpdo(254U);
    UseRpdo(254U);
    EXPECT_TRUE(tpdos.Uses(0x185U, 2U));
    EXPECT_FALSE(tpdos.Uses(0x185U, 1U)); // Its own.
    EXPECT_FALSE(tpdos.Uses(0x186U, 2U));
    EXPECT_TRUE(rpdos.Uses(0x205U, 2U));
    EXPECT_FALSE(rpdos.Uses(0x205U, 1U));
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x80000185U), SdoAbort::kNone);
    EXPECT_FALSE(tpdos.Uses(0x185U, 2U)); // Off.
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x305U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x19FFU, 1U, 0x305U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x80000205U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1400U, 1U, 0x206U), SdoAbort::kNone);
    const NotTwice rule{};
    tpdos.TurnOffShared(rule);
    rpdos.TurnOffShared(rule);
    EXPECT_EQ(CobId(0x1800U), 0x305U);
    EXPECT_EQ(CobId(0x19FFU), 0x80000305U);
    EXPECT_EQ(CobId(0x1400U), 0x80000206U);
}

TEST_F(PdoMapTest, SettingsOfTheOwnersRoomThatAreNoneTurnThePdoOff)
{
    Verifies(req::SRS_PDO_007);
    struct Case
    {
        std::uint32_t cob_id;
        std::uint8_t type;
        bool is_on;
    };
    for (const Case& one : {Case{0x205U, 254U, true}, Case{0x205U, 245U, false}, Case{0x101U, 254U, false}})
    {
        BeginLoading();
        tpdo_room[0].settings.cob_id = one.cob_id;
        tpdo_room[0].settings.type = one.type;
        rpdo_room[0].settings.cob_id = one.cob_id;
        rpdo_room[0].settings.type = one.type;
        EndLoading();
        EXPECT_EQ(CobId(0x1800U), one.is_on ? 0x205U : (0x80000000U | one.cob_id));
        EXPECT_EQ(CobId(0x1400U), one.is_on ? 0x205U : (0x80000000U | one.cob_id));
    }
}

TEST_F(PdoMapTest, WhatWaitsForRoomIsNotSentByAPdoThatWasTurnedOffForAnother)
{
    Verifies(req::SRS_PDO_009);
    UseTpdo(1U);
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x80000185U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x206U), SdoAbort::kNone);
    sink.room = 0;
    Sync0();
    const NotTwice rule{};
    tpdos.TurnOffShared(rule);
    sink.room = 10;
    Cycle();
    EXPECT_EQ(Sent(), 0U);
}

} // namespace
} // namespace counterpoint::cia301
