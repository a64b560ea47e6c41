// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The checksums of channel B against published check values, and the proof of the closed form when it runs.
#include "channel_b/checksum.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr std::uint8_t kDigits[] = {0x31U, 0x32U, 0x33U, 0x34U, 0x35U, 0x36U, 0x37U, 0x38U, 0x39U};

TEST(ChannelBChecksum, DividesByTheirPolynomials)
{
    Verifies(req::SRS_CFG_010);
    Verifies(req::SRS_CFG_034);
    // Given the digits 1 to 9, then both give the check values of the catalogues
    channel_b::Crc16 crc16;
    channel_b::Crc32 crc32{0U};
    for (const std::uint8_t digit : kDigits)
    {
        crc16.AddByte(digit);
        crc32.AddByte(digit);
    }
    EXPECT_EQ(crc16.Value(), 0x31C3U);
    EXPECT_EQ(crc32.Value(), 0xCBF43926U);
}

TEST(ChannelBChecksum, TakesAWordLowByteFirst)
{
    Verifies(req::SRS_CFG_010);
    Verifies(req::SRS_CFG_034);
    channel_b::Crc16 crc16;
    channel_b::Crc32 crc32{0U};
    crc16.AddWord(0x34333231U);
    crc32.AddWord(0x34333231U);
    crc16.AddWord(0x38373635U);
    crc32.AddWord(0x38373635U);
    // and what stands above a byte does not count
    crc16.AddByte(0xFFFFFF39U);
    crc32.AddByte(0xFFFFFF39U);
    EXPECT_EQ(crc16.Value(), 0x31C3U);
    EXPECT_EQ(crc32.Value(), 0xCBF43926U);
}

TEST(ChannelBChecksum, ContinuesWhereAnotherEnded)
{
    Verifies(req::SRS_CFG_034);
    channel_b::Crc32 first{0U};
    first.AddWord(0x34333231U);
    channel_b::Crc32 second{first.Value()};
    second.AddWord(0x38373635U);
    second.AddByte(0x39U);
    EXPECT_EQ(second.Value(), 0xCBF43926U);
}

TEST(ChannelBChecksum, ClosedFormIsTheDivision)
{
    Verifies(req::SRS_CFG_010);
    EXPECT_TRUE(channel_b::IsShiftedAsDivided());
    EXPECT_EQ(channel_b::Divided(0U, 0x01U), 0x1021U);
    EXPECT_EQ(channel_b::Shifted(0U, 0x01U), 0x1021U);
    EXPECT_EQ(channel_b::Divided(0x8000U, 0U), 0x9188U);
    EXPECT_EQ(channel_b::Shifted(0x8000U, 0U), 0x9188U);
    EXPECT_EQ(channel_b::Mirrored(0x04C11DB7U), 0xEDB88320U);
}

} // namespace
} // namespace counterpoint
