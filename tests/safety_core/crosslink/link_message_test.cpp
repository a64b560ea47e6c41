// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/link_message.hpp"

#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace counterpoint
{
namespace
{

LinkMessage Example()
{
    LinkMessage message{};
    message.sender = LinkSender{PeerRole::kA, 5U};
    message.fault = DeviceFault::kNone;
    message.sequence = 0x04030201U;
    message.stamp = Instant{0x14131211U};
    message.echo = LinkEcho{0x24232221U, Instant{0x34333231U}, 0x44434241U, kHeard};
    message.flow = 0x54535251U;
    message.digest = DeviceDigest{0x64636261U};
    message.statement = Statement{GuardView::kConfigured, 1U, 2U, 3U, 4U};
    message.check = SlotCheck{6U, {ConfigFault::kNone, 0x7271U}};
    message.released = 0x8887868584838281U;
    message.new_faults = 0x9897969594939291U;
    message.due = 0xA8A7A6A5A4A3A2A1U;
    message.reports[3] = SlotReport{9U,
                                    Holding::kPair,
                                    SrdoState::kReleased,
                                    SrdoCause::kSct,
                                    0xB4B3B2B1U,
                                    0xC4C3C2C1U,
                                    Payload{0xD4D3D2D1U, 0xD8D7D6D5U}};
    message.armed[1].slot = 10U;
    message.armed[1].number = 11U;
    message.armed[1].frame =
        CanFrame{0x103U, FrameKind::kData, CanPortId::kSecond, 3U, {0xE1U, 0xE2U, 0xE3U, 0U, 0U, 0U, 0U, 0xE8U}};
    return message;
}

// Given a message with another value in every member, when it is laid out, then each byte stands where the layout says.
TEST(LinkMessage, EveryMemberHasItsPlace)
{
    Verifies(req::SRS_LNK_001);
    hal::LinkFrame frame{};
    Encode(Example(), frame);
    ASSERT_EQ(frame.length, 188U);
    const std::array<std::uint8_t, 68U> head{
        0x01U, 0xA5U, 0x05U, 0x5AU, 0x01U, 0x02U, 0x03U, 0x04U, 0x11U, 0x12U, 0x13U, 0x14U, 0x21U, 0x22U,
        0x23U, 0x24U, 0x31U, 0x32U, 0x33U, 0x34U, 0x41U, 0x42U, 0x43U, 0x44U, 0x51U, 0x52U, 0x53U, 0x54U,
        0x61U, 0x62U, 0x63U, 0x64U, 0x96U, 0xA5U, 0x01U, 0x02U, 0x03U, 0x04U, 0x06U, 0x5AU, 0x71U, 0x72U,
        0x00U, 0x00U, 0x81U, 0x82U, 0x83U, 0x84U, 0x85U, 0x86U, 0x87U, 0x88U, 0x91U, 0x92U, 0x93U, 0x94U,
        0x95U, 0x96U, 0x97U, 0x98U, 0xA1U, 0xA2U, 0xA3U, 0xA4U, 0xA5U, 0xA6U, 0xA7U, 0xA8U};
    EXPECT_EQ(std::memcmp(frame.bytes, head.data(), head.size()), 0);
    const std::array<std::uint8_t, 20U> report{0x09U, 0x33U, 0xB7U, 0x06U, 0xB1U, 0xB2U, 0xB3U, 0xB4U, 0xC1U, 0xC2U,
                                               0xC3U, 0xC4U, 0xD1U, 0xD2U, 0xD3U, 0xD4U, 0xD5U, 0xD6U, 0xD7U, 0xD8U};
    EXPECT_EQ(std::memcmp(&frame.bytes[128], report.data(), report.size()), 0);
    const std::array<std::uint8_t, 18U> armed{0x0AU, 0x0BU, 0x03U, 0x01U, 0x00U, 0x00U, 0x3CU, 0x02U, 0x03U,
                                              0xE1U, 0xE2U, 0xE3U, 0x00U, 0x00U, 0x00U, 0x00U, 0xE8U, 0x00U};
    EXPECT_EQ(std::memcmp(&frame.bytes[166], armed.data(), armed.size()), 0);
}

// Given a report and an armed frame in each of their places, and a refusal, then they lie one behind the other.
TEST(LinkMessage, EachReportAndArmedFrameHasItsPlace)
{
    Verifies(req::SRS_LNK_001);
    LinkMessage message = Example();
    message.refusal = Refusal{0x3AU, SrdoCause::kSct};
    std::uint8_t slot = 1U;
    for (SlotReport& report : message.reports)
    {
        const std::uint32_t high = 0x10101010U * slot;
        report = SlotReport{slot,
                            Holding::kNothing,
                            SrdoState::kReleased,
                            SrdoCause::kSct,
                            0x04030201U + high,
                            0x08070605U + high,
                            Payload{0x0C0B0A09U + high, 0x100F0E0DU + high}};
        ++slot;
    }
    message.armed[0].slot = 7U;
    message.armed[0].number = 8U;
    message.armed[0].frame = CanFrame{
        0x1F2E3D4CU, FrameKind::kData, CanPortId::kFirst, 8U, {0xF1U, 0xF2U, 0xF3U, 0xF4U, 0xF5U, 0xF6U, 0xF7U, 0xF8U}};
    hal::LinkFrame frame{};
    Encode(message, frame);
    const std::array<std::uint8_t, 2U> refusal{0x3AU, 0x06U};
    EXPECT_EQ(std::memcmp(&frame.bytes[42], refusal.data(), refusal.size()), 0);
    const std::array<std::uint8_t, 80U> reports{
        0x01U, 0xCCU, 0xB7U, 0x06U, 0x11U, 0x12U, 0x13U, 0x14U, 0x15U, 0x16U, 0x17U, 0x18U, 0x19U, 0x1AU, 0x1BU, 0x1CU,
        0x1DU, 0x1EU, 0x1FU, 0x20U, 0x02U, 0xCCU, 0xB7U, 0x06U, 0x21U, 0x22U, 0x23U, 0x24U, 0x25U, 0x26U, 0x27U, 0x28U,
        0x29U, 0x2AU, 0x2BU, 0x2CU, 0x2DU, 0x2EU, 0x2FU, 0x30U, 0x03U, 0xCCU, 0xB7U, 0x06U, 0x31U, 0x32U, 0x33U, 0x34U,
        0x35U, 0x36U, 0x37U, 0x38U, 0x39U, 0x3AU, 0x3BU, 0x3CU, 0x3DU, 0x3EU, 0x3FU, 0x40U, 0x04U, 0xCCU, 0xB7U, 0x06U,
        0x41U, 0x42U, 0x43U, 0x44U, 0x45U, 0x46U, 0x47U, 0x48U, 0x49U, 0x4AU, 0x4BU, 0x4CU, 0x4DU, 0x4EU, 0x4FU, 0x50U};
    EXPECT_EQ(std::memcmp(&frame.bytes[68], reports.data(), reports.size()), 0);
    const std::array<std::uint8_t, 36U> armed{0x07U, 0x08U, 0x4CU, 0x3DU, 0x2EU, 0x1FU, 0x3CU, 0x01U, 0x08U,
                                              0xF1U, 0xF2U, 0xF3U, 0xF4U, 0xF5U, 0xF6U, 0xF7U, 0xF8U, 0x00U,
                                              0x0AU, 0x0BU, 0x03U, 0x01U, 0x00U, 0x00U, 0x3CU, 0x02U, 0x03U,
                                              0xE1U, 0xE2U, 0xE3U, 0x00U, 0x00U, 0x00U, 0x00U, 0xE8U, 0x00U};
    EXPECT_EQ(std::memcmp(&frame.bytes[148], armed.data(), armed.size()), 0);
}

// Given the layout of a zero message, then its CRC-32 is the one of any other program (computed with Python's zlib).
TEST(LinkMessage, ChecksumIsTheUsualCrc32)
{
    Verifies(req::SRS_LNK_001);
    hal::LinkFrame frame{};
    Encode(LinkMessage{}, frame);
    EXPECT_EQ(frame.bytes[184], 0x33U);
    EXPECT_EQ(frame.bytes[185], 0xC3U);
    EXPECT_EQ(frame.bytes[186], 0xF8U);
    EXPECT_EQ(frame.bytes[187], 0xA5U);
}

TEST(LinkMessage, UnusedBytesAreZeroWhateverStoodThere)
{
    Verifies(req::SRS_LNK_001);
    // Given room that holds an older message, when one without refusal, reports and armed frames is laid out in it
    hal::LinkFrame frame{};
    std::memset(frame.bytes, 0xEE, sizeof(frame.bytes));
    LinkMessage message = Example();
    for (SlotReport& report : message.reports)
    {
        report = SlotReport{};
    }
    message.armed[1] = ArmedFrame{};
    Encode(message, frame);
    EXPECT_EQ(frame.length, 188U);
    EXPECT_EQ(frame.bytes[42], 0U);
    EXPECT_EQ(frame.bytes[43], 0U);
    for (std::size_t place = 68U; place < 184U; ++place)
    {
        EXPECT_EQ(frame.bytes[place], 0U) << place;
    }
}

// Given a laid out message, when it is read back, then every member is as it was.
TEST(LinkMessage, IsReadBackAsItWas)
{
    Verifies(req::SRS_LNK_001);
    hal::LinkFrame frame{};
    Encode(Example(), frame);
    LinkMessage message{};
    ASSERT_EQ(Decode(frame, LinkSender{PeerRole::kA, 5U}, message), DecodeResult::kIntact);
    hal::LinkFrame again{};
    Encode(message, again);
    EXPECT_EQ(std::memcmp(frame.bytes, again.bytes, 188U), 0);
    EXPECT_EQ(message.reports[3].cause, SrdoCause::kSct);
    EXPECT_EQ(message.armed[1].frame.data[7], 0xE8U);
}

// Given a message, when any single bit is flipped, then it is not intact.
TEST(LinkMessage, EveryFlippedBitIsSeen)
{
    Verifies(req::SRS_LNK_002);
    hal::LinkFrame frame{};
    Encode(Example(), frame);
    LinkMessage message{};
    for (std::uint32_t bit = 0U; bit < (188U * 8U); ++bit)
    {
        hal::LinkFrame flipped = frame;
        flipped.bytes[bit / 8U] ^= static_cast<std::uint8_t>(1U << (bit % 8U));
        EXPECT_EQ(Decode(flipped, LinkSender{PeerRole::kA, 5U}, message), DecodeResult::kInvalid) << bit;
    }
}

// Given an intact message, when its length, its sender's role, its node-ID or its version is another, then it is
// refused.
TEST(LinkMessage, AnotherSenderLengthOrVersionIsRefused)
{
    Verifies(req::SRS_LNK_002);
    hal::LinkFrame frame{};
    Encode(Example(), frame);
    LinkMessage message{};
    EXPECT_EQ(Decode(frame, LinkSender{PeerRole::kB, 5U}, message), DecodeResult::kInvalid);
    EXPECT_EQ(Decode(frame, LinkSender{PeerRole::kA, 6U}, message), DecodeResult::kInvalid);
    frame.length = 187U;
    EXPECT_EQ(Decode(frame, LinkSender{PeerRole::kA, 5U}, message), DecodeResult::kInvalid);
    // A zero message of version 2: version changed, CRC right.
    hal::LinkFrame newer{};
    LinkMessage zero{};
    Encode(zero, newer);
    EXPECT_EQ(Decode(newer, LinkSender{PeerRole::kInvalid, 0U}, message), DecodeResult::kIntact);
    newer.bytes[0] = 0x02U;
    newer.bytes[184] = 0xFDU;
    newer.bytes[185] = 0x50U;
    newer.bytes[186] = 0xA4U;
    newer.bytes[187] = 0x60U;
    EXPECT_EQ(Decode(newer, LinkSender{PeerRole::kInvalid, 0U}, message), DecodeResult::kInvalid);
}

} // namespace
} // namespace counterpoint
