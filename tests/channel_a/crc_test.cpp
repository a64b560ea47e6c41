// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The tables of both checksums, and that their check while compiling finds a wrong one.
#include "channel_a/crc.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace counterpoint::channel_a
{
namespace
{

constexpr char kText[] = "123456789";

TEST(ChannelACrc, OfSixteenBitsIsThatOfTheStandard)
{
    Verifies(req::SRS_CFG_010);
    Crc16 crc{};
    for (std::size_t place = 0U; place < 9U; ++place)
    {
        crc.AddByte(static_cast<std::uint8_t>(kText[place]));
    }
    EXPECT_EQ(crc.Value(), 0x31C3U);
    // Low byte first, and only as many as told
    Crc16 two{};
    two.AddBytes(0x00993231U, 2U);
    Crc16 other{};
    other.AddByte(0x31U);
    other.AddByte(0x32U);
    EXPECT_EQ(two.Value(), other.Value());
}

TEST(ChannelACrc, OfThirtyTwoBitsIsThatOfTheStandard)
{
    Verifies(req::SRS_CFG_034);
    Crc32 crc{0U};
    crc.AddWord(0x34333231U);
    crc.AddWord(0x38373635U);
    crc.AddByte(0x39U);
    EXPECT_EQ(crc.Value(), 0xCBF43926U);
    // It continues
    Crc32 first{0U};
    first.AddWord(0x34333231U);
    Crc32 second{first.Value()};
    second.AddWord(0x38373635U);
    second.AddByte(0x39U);
    EXPECT_EQ(second.Value(), 0xCBF43926U);
}

TEST(ChannelACrc, TablesAreThoseWorkedOutNow)
{
    Verifies(req::SRS_CFG_010);
    Verifies(req::SRS_CFG_034);
    const Table16 table16 = MakeTable16();
    const Table32 table32 = MakeTable32();
    EXPECT_EQ(std::memcmp(&table16, &kTable16, sizeof(table16)), 0);
    EXPECT_EQ(std::memcmp(&table32, &kTable32, sizeof(table32)), 0);
    EXPECT_EQ(kTable16.rest[0x80], 0x9188U);
    EXPECT_EQ(kTable16.rest[0xFF], 0x1EF0U);
    EXPECT_EQ(kTable32.rest[0x01], 0x77073096U);
    EXPECT_EQ(kTable32.rest[0xFF], 0x2D02EF8DU);
}

TEST(ChannelACrc, CheckOfTheTablesFindsEverySingleBit)
{
    Verifies(req::SRS_CFG_010);
    Verifies(req::SRS_CFG_034);
    EXPECT_EQ(WrongEntries(MakeTable16()), 0U);
    EXPECT_EQ(WrongEntries(MakeTable32()), 0U);
    for (std::size_t entry = 0U; entry < kByteValues; ++entry)
    {
        for (std::uint32_t bit = 0U; bit < 32U; ++bit)
        {
            Table16 table16 = MakeTable16();
            Table32 table32 = MakeTable32();
            table16.rest[entry] = static_cast<std::uint16_t>(table16.rest[entry] ^ (1U << (bit % 16U)));
            table32.rest[entry] ^= std::uint32_t{1U} << bit;
            EXPECT_NE(WrongEntries(table16), 0U) << entry << ", bit " << bit;
            EXPECT_NE(WrongEntries(table32), 0U) << entry << ", bit " << bit;
        }
    }
}

} // namespace
} // namespace counterpoint::channel_a
