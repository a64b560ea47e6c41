// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/frame_bits.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace counterpoint::host
{
namespace
{

CanFrame Data(const std::uint32_t identifier, const std::vector<std::uint8_t>& bytes)
{
    CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(bytes.size()), {}};
    std::copy(bytes.begin(), bytes.end(), frame.data);
    return frame;
}

// Identifier 0, no data: SOF, 11 + 3 + 4 bits and the CRC of nothing but zeros are 34 dominant bits; after every five a
// stuff bit: 6. With CRC delimiter, ACK and EOF 34 + 6 + 10 = 50 bits, with the intermission 53.
TEST(FrameBits, FrameOfZerosOnly)
{
    Verifies(req::SRS_BUS_001);
    // When the frame of zeros is measured
    const FrameBits bits = MeasureFrame(Data(0U, {}));
    // Then it is as worked out above
    EXPECT_EQ(bits.crc, 0U);
    EXPECT_EQ(bits.stuffable, 34U);
    EXPECT_EQ(bits.stuff, 6U);
    EXPECT_EQ(bits.OnWire(), 50U);
    EXPECT_EQ(bits.WithIntermission(), 53U);
}

// Identifier 0, one byte 00h: the CRC is the remainder of x^23 (the 1 of the DLC, eight zeros, fifteen zeros). Powers
// of x modulo the polynomial, from x^15 on: 4599 4EAB 58CF 7407 2D97 5B2E 73C5 2213 4426. 000000000000000000 1 00000000
// 100010000100110: three stuff bits in the first run, one in the second; 42 + 4 + 10 = 56.
TEST(FrameBits, OneByteOfZeros)
{
    Verifies(req::SRS_BUS_001);
    // When the frame is measured
    const FrameBits bits = MeasureFrame(Data(0U, {0x00U}));
    // Then CRC and length are as worked out above
    EXPECT_EQ(bits.crc, 0x4426U);
    EXPECT_EQ(bits.stuffable, 42U);
    EXPECT_EQ(bits.stuff, 4U);
    EXPECT_EQ(bits.OnWire(), 56U);
}

CanFrame Of(const FrameKind kind, const std::uint32_t identifier, const std::uint8_t length)
{
    return CanFrame{identifier, kind, CanPortId::kFirst, length, {0x55U}};
}

struct LengthCase
{
    std::uint32_t identifier;
    std::vector<std::uint8_t> bytes;
    std::uint16_t crc;
    std::uint16_t stuff;
    std::uint16_t with_intermission;
};

/// CRC by long division of the written-out bits, stuff bits counted in them, outside of this program.
TEST(FrameBits, FramesWorkedOutBySeparateLongDivision)
{
    Verifies(req::SRS_BUS_001);
    const std::vector<LengthCase> cases{
        {0x2AAU, std::vector<std::uint8_t>(8U, 0xAAU), 0x43D6U, 0U, 111U},
        {0x555U, std::vector<std::uint8_t>(8U, 0x55U), 0x1B04U, 1U, 112U},
        {0x101U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}, 0x5F12U, 10U, 121U},
        {0x7FFU, std::vector<std::uint8_t>(8U, 0xFFU), 0x4C89U, 15U, 126U},
        {0x000U, std::vector<std::uint8_t>(8U, 0x00U), 0x145BU, 16U, 127U},
        {0x078U, {0x3CU, 0x3FU, 0xE1U, 0xE1U, 0xE1U, 0xE1U, 0xE1U, 0xE7U}, 0x60F8U, 21U, 132U},
    };
    for (const LengthCase& worked : cases)
    {
        // When the frame is measured, then CRC, stuff bits and length are as worked out
        const FrameBits bits = MeasureFrame(Data(worked.identifier, worked.bytes));
        EXPECT_EQ(bits.crc, worked.crc) << worked.identifier;
        EXPECT_EQ(bits.stuff, worked.stuff) << worked.identifier;
        EXPECT_EQ(bits.WithIntermission(), worked.with_intermission) << worked.identifier;
    }
}

TEST(FrameBits, NoFrameIsLongerThanThePublishedWorstCase)
{
    Verifies(req::SRS_BUS_001);
    // Published worst cases of 0, 1, 2, 4 and 8 bytes with an 11-bit identifier, intermission included
    struct Worst
    {
        std::size_t bytes;
        std::uint16_t bits;
    };
    std::mt19937 random(304U);
    for (const Worst& worst : {Worst{0U, 55U}, Worst{1U, 65U}, Worst{2U, 75U}, Worst{4U, 95U}, Worst{8U, 135U}})
    {
        std::uint16_t longest = 0U;
        for (int count = 0; count < 20'000; ++count)
        {
            // Given frames of long runs, which need most stuff bits
            std::vector<std::uint8_t> bytes(worst.bytes);
            for (std::uint8_t& byte : bytes)
            {
                constexpr std::uint8_t kRuns[] = {0x00U, 0xFFU, 0x3CU, 0xC3U, 0xE1U, 0x1EU, 0x87U, 0x78U};
                byte = kRuns[random() % 8U];
            }
            // When one is measured
            longest = std::max(
                longest, MeasureFrame(Data(static_cast<std::uint32_t>(random() % 0x800U), bytes)).WithIntermission());
        }
        // Then none is longer
        EXPECT_LE(longest, worst.bits) << worst.bytes;
        EXPECT_GE(longest + 12U, worst.bits) << worst.bytes;
    }
}

CanFrame RandomFrame(std::mt19937& random)
{
    constexpr FrameKind kKinds[] = {FrameKind::kData, FrameKind::kRemote, FrameKind::kExtended,
                                    FrameKind::kExtendedRemote};
    CanFrame frame{};
    frame.kind = kKinds[random() % 4U];
    const bool standard = (frame.kind == FrameKind::kData) || (frame.kind == FrameKind::kRemote);
    frame.identifier = static_cast<std::uint32_t>(random()) % (standard ? 0x800U : 0x2000'0000U);
    frame.port = CanPortId::kFirst;
    frame.length_bytes = static_cast<std::uint8_t>(random() % 9U);
    for (std::uint8_t& byte : frame.data)
    {
        byte = static_cast<std::uint8_t>(((random() % 3U) == 0U) ? random() : ((random() % 2U) * 0xFFU));
    }
    return frame;
}

/// Takes the stuff bits out again and divides by the polynomial, bit by bit; 0 for a right frame.
struct Judgement
{
    bool six_equal;
    std::uint32_t remainder;
    std::uint32_t plain_bits;
};

Judgement Judge(const WireImage& image)
{
    Judgement judgement{false, 0U, 0U};
    std::uint32_t equal = 0U;
    std::uint32_t last = 2U;
    bool is_stuff_bit = false;
    for (std::uint16_t place = 0U; place < (image.count - 10U); ++place)
    {
        const std::uint32_t level = image.level[place];
        equal = (level == last) ? (equal + 1U) : 1U;
        last = level;
        judgement.six_equal = judgement.six_equal || (equal > 5U);
        if (!is_stuff_bit)
        {
            judgement.remainder = (judgement.remainder << 1U) | level;
            judgement.remainder ^= ((judgement.remainder & 0x8000U) != 0U) ? 0xC599U : 0U;
            ++judgement.plain_bits;
        }
        is_stuff_bit = equal == 5U;
    }
    return judgement;
}

TEST(FrameBits, MeasuredLengthIsThatOfTheDrawnFrameAndAReceiverWouldTakeIt)
{
    Verifies(req::SRS_BUS_001);
    std::mt19937 random(50'325U);
    for (int count = 0; count < 20'000; ++count)
    {
        // Given a frame of any classical kind
        const CanFrame frame = RandomFrame(random);
        ASSERT_TRUE(IsClassicalFrame(frame));
        // When it is measured and drawn
        const FrameBits bits = MeasureFrame(frame);
        const WireImage image = DrawFrame(frame);
        // Then the lengths agree, there are never six equal bits, and the CRC divides without remainder
        const Judgement judgement = Judge(image);
        ASSERT_EQ(bits.OnWire(), image.count);
        ASSERT_EQ(bits.stuffable, judgement.plain_bits);
        ASSERT_FALSE(judgement.six_equal);
        ASSERT_EQ(judgement.remainder, 0U);
        ASSERT_EQ(image.level[image.ack_slot], 0U);
        ASSERT_EQ(image.level[image.ack_slot - 1U], 1U);
    }
}

TEST(FrameBits, PlainBitsOfEachKind)
{
    Verifies(req::SRS_BUS_001);
    // Given 8 bytes announced, when measured, then 98 or 118 bits with data and 34 or 54 without (remote)
    CanFrame frame = Data(0x123U, std::vector<std::uint8_t>(8U, 0x5AU));
    EXPECT_EQ(MeasureFrame(frame).stuffable, 98U);
    frame.kind = FrameKind::kRemote;
    EXPECT_EQ(MeasureFrame(frame).stuffable, 34U);
    frame.kind = FrameKind::kExtended;
    EXPECT_EQ(MeasureFrame(frame).stuffable, 118U);
    frame.kind = FrameKind::kExtendedRemote;
    EXPECT_EQ(MeasureFrame(frame).stuffable, 54U);
}

// SOF 0 | 101h: 00100000001 | RTR 0 IDE 0 r0 0 | DLC 0001 | 55h: 01010101 | CRC
TEST(FrameBits, FieldsAreDrawnInTheirOrder)
{
    Verifies(req::SRS_BUS_001);
    // When a frame is drawn
    const WireImage image = DrawFrame(Data(0x101U, {0x55U}));
    // Then its first bits are SOF, identifier and control field with their stuff bits (s)
    const std::vector<std::uint8_t> expected{0, 0, 0, 1,       0, 0, 0, 0, 0, 1 /*s*/, 0, 0, 1, 0, 0,
                                             0, 0, 0, 1 /*s*/, 0, 1, 0, 1, 0, 1,       0, 1, 0, 1};
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), image.level.begin()));
}

/// The same division, of remote frames and of those with 29 bits; a remote frame has no data, whatever its length says.
TEST(FrameBits, LengthsOfTheOtherKindsAreThoseOfASeparateLongDivision)
{
    Verifies(req::SRS_BUS_001);
    struct KindCase
    {
        FrameKind kind;
        std::uint32_t identifier;
        std::uint8_t length;
        std::uint16_t crc;
        std::uint16_t stuff;
        std::uint16_t with_intermission;
    };
    for (const KindCase& worked : {KindCase{FrameKind::kRemote, 0x101U, 8U, 0x1DDBU, 2U, 49U},
                                   KindCase{FrameKind::kRemote, 0x7FFU, 0U, 0x54EAU, 3U, 50U},
                                   KindCase{FrameKind::kExtended, 0x12345678U, 1U, 0x5DFDU, 2U, 77U},
                                   KindCase{FrameKind::kExtended, 0x40000U, 0U, 0x7449U, 7U, 74U},
                                   KindCase{FrameKind::kExtendedRemote, 0U, 0U, 0x35D5U, 6U, 73U},
                                   KindCase{FrameKind::kExtendedRemote, 0x12345678U, 8U, 0x6B55U, 0U, 67U}})
    {
        // When the frame is measured, then CRC, stuff bits and length are as worked out
        const FrameBits bits = MeasureFrame(Of(worked.kind, worked.identifier, worked.length));
        EXPECT_EQ(bits.crc, worked.crc) << worked.identifier;
        EXPECT_EQ(bits.stuff, worked.stuff) << worked.identifier;
        EXPECT_EQ(bits.WithIntermission(), worked.with_intermission) << worked.identifier;
    }
}

// 101h:      SOF 0 | 00100000001 | RTR 1 IDE 0 r0 0 | DLC 1000
// 12345678h: SOF 0 | 10010001101 | SRR 1 IDE 1 | 000101011001111000 | RTR, r1 0, r0 0 | DLC | data
TEST(FrameBits, FieldsOfTheOtherKindsAreDrawnInTheirOrder)
{
    Verifies(req::SRS_BUS_001);
    const auto begins = [](const CanFrame& frame, const std::string& expected)
    {
        const WireImage image = DrawFrame(frame);
        std::string drawn;
        for (std::size_t place = 0U; place < expected.size(); ++place)
        {
            drawn += (image.level[place] == 0U) ? '0' : '1';
        }
        EXPECT_EQ(drawn, expected) << frame.identifier;
    };
    // When frames of the other kinds are drawn, then their headers are these, with their stuff bits
    begins(Of(FrameKind::kRemote, 0x101U, 8U), "0001000001" // The last one is a stuff bit.
                                               "0011001000");
    begins(Of(FrameKind::kExtended, 0x12345678U, 1U), "0100100011011"
                                                      "1000101011001111000"
                                                      "001" // RTR, r1 and a stuff bit.
                                                      "00001"
                                                      "01010101");
    begins(Of(FrameKind::kExtendedRemote, 0x12345678U, 8U), "0100100011011"
                                                            "1000101011001111000"
                                                            "100"
                                                            "1000");
}

TEST(FrameBits, OnlyClassicalFramesAreCarried)
{
    Verifies(req::SRS_BUS_001);
    // Given frames just inside and outside of what CAN carries
    CanFrame frame = Data(0x7FFU, {});
    EXPECT_TRUE(IsClassicalFrame(frame));
    frame.identifier = 0x800U;
    EXPECT_FALSE(IsClassicalFrame(frame));
    frame.kind = FrameKind::kExtended;
    EXPECT_TRUE(IsClassicalFrame(frame));
    frame.identifier = 0x1FFF'FFFFU;
    EXPECT_TRUE(IsClassicalFrame(frame));
    frame.identifier = 0x2000'0000U;
    EXPECT_FALSE(IsClassicalFrame(frame));
    frame.identifier = 0U;
    frame.length_bytes = 9U;
    EXPECT_FALSE(IsClassicalFrame(frame));
    frame.length_bytes = 0U;
    frame.kind = FrameKind::kFlexibleDataRate;
    EXPECT_FALSE(IsClassicalFrame(frame));
    frame.kind = FrameKind::kInvalid;
    EXPECT_FALSE(IsClassicalFrame(frame));
}

} // namespace
} // namespace counterpoint::host
