// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia301/sdo_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

using SdoServerTest = SdoRig;

TEST_F(SdoServerTest, FramesOfAnotherLengthAreIgnored)
{
    Verifies(req::SRS_SDO_001);
    for (std::uint8_t length = 0U; length <= 64U; ++length)
    {
        const SdoFrame request{{0x40U, 0x00U, 0x10U}};
        const SdoAnswer answer = server.OnFrame(request, length, Instant{now_us});
        EXPECT_EQ(answer.presence == SdoPresence::kFrame, length == 8U);
    }
    EXPECT_TRUE(Poll().empty());
}

TEST_F(SdoServerTest, ExpeditedUploadOfOneToFourBytes)
{
    Verifies(req::SRS_SDO_002);
    EXPECT_EQ(Send({0x40U, 0x00U, 0x21U, 0x00U}), (Octets{0x4FU, 0x00U, 0x21U, 0x00U, 0x7FU, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x40U, 0x05U, 0x21U, 0x00U}), (Octets{0x4BU, 0x05U, 0x21U, 0x00U, 0x34U, 0x12U, 0U, 0U}));
    EXPECT_EQ(Send({0x40U, 0x04U, 0x21U, 0x00U}), (Octets{0x47U, 0x04U, 0x21U, 0x00U, 0xAAU, 0xBBU, 0xCCU, 0U}));
    EXPECT_EQ(Send({0x40U, 0x00U, 0x10U, 0x00U}), (Octets{0x43U, 0x00U, 0x10U, 0x00U, 0x44U, 0x33U, 0x22U, 0x11U}));
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoServerTest, ExpeditedDownloadOfOneToFourBytes)
{
    Verifies(req::SRS_SDO_002);
    EXPECT_EQ(Send({0x2FU, 0x00U, 0x21U, 0x00U, 0x01U}), (Octets{0x60U, 0x00U, 0x21U, 0x00U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x2BU, 0x05U, 0x21U, 0x00U, 0x02U, 0x03U}), (Octets{0x60U, 0x05U, 0x21U, 0x00U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x27U, 0x04U, 0x21U, 0x00U, 4U, 5U, 6U}), (Octets{0x60U, 0x04U, 0x21U, 0x00U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x23U, 0x01U, 0x21U, 0x02U, 7U, 8U, 9U, 10U}),
              (Octets{0x60U, 0x01U, 0x21U, 0x02U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(u8[0], 0x01U);
    EXPECT_EQ(u16, (std::array<std::uint8_t, 2>{0x02U, 0x03U}));
    EXPECT_EQ(u24, (std::array<std::uint8_t, 3>{4U, 5U, 6U}));
    EXPECT_EQ(u32, (std::array<std::uint8_t, 4>{7U, 8U, 9U, 10U}));
}

TEST_F(SdoServerTest, WithoutStatedLengthTheEntrysIsTaken)
{
    Verifies(req::SRS_SDO_002);
    EXPECT_EQ(Send({0x22U, 0x05U, 0x21U, 0x00U, 0x0AU, 0x0BU, 0xFFU, 0xFFU})[0], 0x60U);
    EXPECT_EQ(u16, (std::array<std::uint8_t, 2>{0x0AU, 0x0BU}));
    EXPECT_EQ(Send({0x22U, 0x00U, 0x13U, 0x00U, 0x00U, 0xFFU, 0xFFU, 0xFFU})[0], 0x60U); // the kernel's
    EXPECT_EQ(foreign.gate.size_bytes, 1U);
    EXPECT_EQ(Send({0x22U, 0x02U, 0x21U, 0x00U}), AbortOf(0x2102U, 0U, 0x06070013U)); // 8 bytes do not fit
    EXPECT_EQ(Send({0x22U, 0x00U, 0x30U, 0x00U}), AbortOf(0x3000U, 0U, 0x06020000U));
}

TEST_F(SdoServerTest, TheDictionarysRefusalsAreTold)
{
    Verifies(req::SRS_SDO_011);
    EXPECT_EQ(Send({0x40U, 0x00U, 0x30U, 0x05U}), AbortOf(0x3000U, 5U, 0x06020000U));
    EXPECT_EQ(Send({0x40U, 0x01U, 0x21U, 0x01U}), AbortOf(0x2101U, 1U, 0x06090011U));
    EXPECT_EQ(Send({0x23U, 0x00U, 0x10U, 0x00U, 1U, 2U, 3U, 4U}), AbortOf(0x1000U, 0U, 0x06010002U));
    EXPECT_EQ(Send({0x2BU, 0x01U, 0x21U, 0x02U, 1U, 2U}), AbortOf(0x2101U, 2U, 0x06070013U));
    EXPECT_EQ(Send({0x23U, 0x05U, 0x21U, 0x00U, 1U, 2U}), AbortOf(0x2105U, 0U, 0x06070012U));
    EXPECT_EQ(Send({0x21U, 0x00U, 0x10U, 0x00U, 4U}), AbortOf(0x1000U, 0U, 0x06010002U));
    EXPECT_EQ(Send({0xC6U, 0x00U, 0x10U, 0x00U, 4U}), AbortOf(0x1000U, 0U, 0x06010002U));
    EXPECT_EQ(Send({0xA4U, 0x00U, 0x30U, 0x00U, 4U}), AbortOf(0x3000U, 0U, 0x06020000U));
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoServerTest, SegmentedDownloadIsWrittenOnceAtItsEnd)
{
    Verifies(req::SRS_SDO_003);
    // Given the announced download of 10 bytes
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 10U}), (Octets{0x60U, 0x03U, 0x21U, 0x00U, 0U, 0U, 0U, 0U}));
    // When seven and three bytes come
    EXPECT_EQ(Send({0x00U, 'c', 'o', 'u', 'n', 't', 'e', 'r'}), (Octets{0x20U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(domain_length, 0U);
    EXPECT_EQ(Send({0x19U, 'p', 'o', 'i'}), (Octets{0x30U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}));
    // Then the value is there
    EXPECT_EQ(domain_length, 10U);
    EXPECT_EQ(domain[0], 'c');
    EXPECT_EQ(domain[9], 'i');
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoServerTest, ASegmentedDownloadAsksItsHookOnce)
{
    Verifies(req::SRS_SDO_003);
    class Counting final : public WriteHook
    {
      public:
        [[nodiscard]] SdoAbort OnWrite(const ObjectAddress&, const Bytes& value) noexcept override
        {
            lengths.push_back(value.size_bytes);
            return SdoAbort::kNone;
        }
        std::vector<std::uint32_t> lengths{};
    };
    Counting counting{};
    entries[4].write_hook = &counting;
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 15U})[0], 0x60U);
    EXPECT_EQ(Send({0x00U})[0], 0x20U);
    EXPECT_EQ(Send({0x10U})[0], 0x30U);
    EXPECT_TRUE(counting.lengths.empty());
    EXPECT_EQ(Send({0x0DU})[0], 0x20U); // One byte, and the last segment.
    EXPECT_EQ(counting.lengths, (std::vector<std::uint32_t>{15U}));
}

TEST_F(SdoServerTest, SegmentedDownloadWithoutLengthAndOfNothing)
{
    Verifies(req::SRS_SDO_003);
    EXPECT_EQ(Send({0x20U, 0x02U, 0x21U, 0x00U})[0], 0x60U);
    EXPECT_EQ(Send({0x00U, 9U, 9U, 9U, 9U, 9U, 9U, 9U})[0], 0x20U);
    EXPECT_EQ(Send({0x1DU, 0x42U})[0], 0x30U);
    EXPECT_EQ(u64[7], 0x42U);
    domain_length = 5U;
    EXPECT_EQ(Send({0x20U, 0x03U, 0x21U, 0x00U})[0], 0x60U);
    EXPECT_EQ(Send({0x0FU})[0], 0x20U);
    EXPECT_EQ(domain_length, 0U);
}

TEST_F(SdoServerTest, MoreOrLessThanStatedIsRefused)
{
    Verifies(req::SRS_SDO_003);
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 6U})[0], 0x60U);
    EXPECT_EQ(Send({0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), AbortOf(0x2103U, 0U, 0x06070012U));
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 8U})[0], 0x60U);
    EXPECT_EQ(Send({0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), AbortOf(0x2103U, 0U, 0x06070013U));
    EXPECT_EQ(Send({0x21U, 0x02U, 0x21U, 0x00U, 9U}), AbortOf(0x2102U, 0U, 0x06070012U));
    EXPECT_EQ(Send({0x21U, 0x02U, 0x21U, 0x00U, 7U}), AbortOf(0x2102U, 0U, 0x06070013U));
    EXPECT_EQ(domain_length, 0U);
    EXPECT_EQ(u64[0], 1U);
}

// The greatest length that can be stated is not that of a client that states none.
TEST_F(SdoServerTest, TheGreatestStatedLengthIsRefusedAtOnce)
{
    Verifies(req::SRS_SDO_160);
    entries[4].size_bytes = 0xFFFFFFFEU; // As if the object had room: the buffer has none.
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 0xFFU, 0xFFU, 0xFFU, 0xFFU}), AbortOf(0x2103U, 0U, 0x05040005U));
    EXPECT_EQ(Send({0xC6U, 0x03U, 0x21U, 0x00U, 0xFFU, 0xFFU, 0xFFU, 0xFFU}), AbortOf(0x2103U, 0U, 0x05040005U));
    entries[4].size_bytes = 2000U;
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 0xFFU, 0xFFU, 0xFFU, 0xFFU}), AbortOf(0x2103U, 0U, 0x06070012U));
    EXPECT_EQ(Send({0xC6U, 0x03U, 0x21U, 0x00U, 0xFFU, 0xFFU, 0xFFU, 0xFFU}), AbortOf(0x2103U, 0U, 0x06070012U));
    EXPECT_EQ(Send({0x21U, 0x02U, 0x21U, 0x00U, 0xFFU, 0xFFU, 0xFFU, 0xFFU}), AbortOf(0x2102U, 0U, 0x06070012U));
    // And what would have been its only segment writes nothing
    EXPECT_EQ(Send({0x09U, 'a', 'b', 'c'})[0], 0x80U);
    EXPECT_EQ(domain_length, 0U);
    // A client that states no length may have the same bytes there
    EXPECT_EQ(Send({0x20U, 0x03U, 0x21U, 0x00U, 0xFFU, 0xFFU, 0xFFU, 0xFFU})[0], 0x60U);
    EXPECT_EQ(Send({0x09U, 'a', 'b', 'c'})[0], 0x20U);
    EXPECT_EQ(domain_length, 3U);
}

TEST_F(SdoServerTest, SegmentedUploadIsOneReading)
{
    Verifies(req::SRS_SDO_004);
    EXPECT_EQ(Send({0x40U, 0x02U, 0x21U, 0x00U}), (Octets{0x41U, 0x02U, 0x21U, 0x00U, 8U, 0U, 0U, 0U}));
    u64.fill(0xEEU); // When the value changes meanwhile, then the old one is sent
    EXPECT_EQ(Send({0x60U}), (Octets{0x00U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}));
    EXPECT_EQ(Send({0x70U}), (Octets{0x1DU, 8U, 0U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_FALSE(server.IsBusy());
    // Nothing, and exactly two segments
    EXPECT_EQ(Send({0x40U, 0x03U, 0x21U, 0x00U}), (Octets{0x41U, 0x03U, 0x21U, 0x00U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x60U}), (Octets{0x0FU, 0U, 0U, 0U, 0U, 0U, 0U, 0U}));
    // One byte more than a frame takes
    domain_length = 5U;
    EXPECT_EQ(Send({0x40U, 0x03U, 0x21U, 0x00U}), (Octets{0x41U, 0x03U, 0x21U, 0x00U, 5U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x60U}), (Octets{0x05U, 0U, 1U, 2U, 3U, 4U, 0U, 0U}));
    domain_length = 14U;
    EXPECT_EQ(Send({0x40U, 0x03U, 0x21U, 0x00U})[4], 14U);
    EXPECT_EQ(Send({0x60U})[0], 0x00U);
    EXPECT_EQ(Send({0x70U}), (Octets{0x11U, 7U, 8U, 9U, 10U, 11U, 12U, 13U}));
}

TEST_F(SdoServerTest, AToggleBitThatStandsStillEndsTheTransfer)
{
    Verifies(req::SRS_SDO_005);
    EXPECT_EQ(Send({0x40U, 0x02U, 0x21U, 0x00U})[0], 0x41U);
    EXPECT_EQ(Send({0x70U}), AbortOf(0x2102U, 0U, 0x05030000U));
    EXPECT_EQ(Send({0x40U, 0x02U, 0x21U, 0x00U})[0], 0x41U);
    EXPECT_EQ(Send({0x60U})[0], 0x00U);
    EXPECT_EQ(Send({0x60U}), AbortOf(0x2102U, 0U, 0x05030000U));
    EXPECT_EQ(Send({0x20U, 0x02U, 0x21U, 0x00U})[0], 0x60U);
    EXPECT_EQ(Send({0x10U}), AbortOf(0x2102U, 0U, 0x05030000U));
    EXPECT_EQ(Send({0x20U, 0x02U, 0x21U, 0x00U})[0], 0x60U);
    EXPECT_EQ(Send({0x00U})[0], 0x20U);
    EXPECT_EQ(Send({0x00U}), AbortOf(0x2102U, 0U, 0x05030000U));
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoServerTest, ASilentClientTimesOutOverTheWrapOfTheCounter)
{
    Verifies(req::SRS_SDO_010);
    EXPECT_EQ(Send({0x40U, 0x02U, 0x21U, 0x00U})[0], 0x41U);
    now_us += 999U;
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(Send({0x60U})[0], 0x00U); // begins the time anew
    now_us += 999U;
    EXPECT_TRUE(Poll().empty());
    now_us += 1U;
    EXPECT_EQ(Poll(), AbortOf(0x2102U, 0U, 0x05040000U));
    EXPECT_TRUE(Poll().empty());
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoServerTest, ASilentClientTimesOutInEveryPhase)
{
    Verifies(req::SRS_SDO_010);
    // Given a transfer that waits for a segment, for its end, for the start of its blocks, for their acknowledgement,
    // for the end behind that
    domain_length = 7U;
    for (const std::vector<Octets>& requests :
         {std::vector<Octets>{{0x20U, 0x03U, 0x21U}}, std::vector<Octets>{{0x20U, 0x03U, 0x21U}, {0x00U}},
          std::vector<Octets>{{0xC0U, 0x03U, 0x21U}}, std::vector<Octets>{{0xC0U, 0x03U, 0x21U}, {0x81U}},
          std::vector<Octets>{{0xA0U, 0x03U, 0x21U, 0U, 4U}},
          std::vector<Octets>{{0xA0U, 0x03U, 0x21U, 0U, 4U}, {0xA3U}},
          std::vector<Octets>{{0xA0U, 0x03U, 0x21U, 0U, 4U}, {0xA3U}, {0xA2U, 1U, 4U}}})
    {
        for (const Octets& request : requests)
        {
            now_us += 999U; // Each of them begins the time anew.
            EXPECT_EQ(Send(request).size(), 8U);
        }
        now_us += 999U;
        EXPECT_TRUE(Poll().empty());
        EXPECT_TRUE(server.IsBusy());
        now_us += 1U;
        EXPECT_EQ(Poll(), AbortOf(0x2103U, 0U, 0x05040000U)) << int{requests.back()[0]};
        EXPECT_FALSE(server.IsBusy());
    }
}

TEST_F(SdoServerTest, AnAbortOfTheClientEndsEveryTransferWithoutAnswer)
{
    Verifies(req::SRS_SDO_011);
    domain_length = 100U;
    for (const Octets& begin : {Octets{0x40U, 0x02U, 0x21U}, Octets{0x20U, 0x02U, 0x21U}, Octets{0xC4U, 0x02U, 0x21U},
                                Octets{0xA4U, 0x03U, 0x21U, 0U, 4U}})
    {
        EXPECT_EQ(Send(begin).size(), 8U);
        EXPECT_TRUE(server.IsBusy());
        EXPECT_TRUE(Send({0x80U, 0x02U, 0x21U, 0x00U, 0U, 0U, 4U, 5U}).empty());
        EXPECT_FALSE(server.IsBusy());
    }
    EXPECT_TRUE(Send({0x80U}).empty());
    EXPECT_TRUE(Send({0x9FU}).empty()); // Its other bits have no meaning.
}

TEST_F(SdoServerTest, UnknownCommandsAndThoseOutOfPlaceAreRefused)
{
    Verifies(req::SRS_SDO_012);
    // Given no transfer
    for (const std::uint8_t command : Octets{0x00U, 0x10U, 0x60U, 0x70U, 0xA1U, 0xA2U, 0xA3U, 0xC1U, 0xE0U, 0xFFU})
    {
        EXPECT_EQ(Send({command, 0x02U, 0x21U}), AbortOf(0U, 0U, 0x05040001U)) << int{command};
    }
    // Given a segmented upload
    for (const std::uint8_t command : Octets{0x00U, 0x20U, 0x40U, 0xA0U, 0xA1U, 0xA2U, 0xA3U, 0xC0U, 0xC1U, 0xE0U})
    {
        EXPECT_EQ(Send({0x40U, 0x02U, 0x21U, 0x00U})[0], 0x41U);
        EXPECT_EQ(Send({command}), AbortOf(0x2102U, 0U, 0x05040001U)) << int{command};
    }
    // Given a segmented download
    for (const std::uint8_t command : Octets{0x20U, 0x40U, 0x60U, 0xA0U, 0xA1U, 0xA2U, 0xA3U, 0xC0U, 0xC1U, 0xE0U})
    {
        EXPECT_EQ(Send({0x20U, 0x02U, 0x21U, 0x00U})[0], 0x60U);
        EXPECT_EQ(Send({command}), AbortOf(0x2102U, 0U, 0x05040001U)) << int{command};
    }
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoServerTest, MoreThanTheBufferIsRefused)
{
    Verifies(req::SRS_SDO_013);
    EXPECT_EQ(Send({0x21U, 0x03U, 0x21U, 0x00U, 0xE9U, 0x03U}), AbortOf(0x2103U, 0U, 0x05040005U)); // 1001
    EXPECT_EQ(Send({0xC6U, 0x03U, 0x21U, 0x00U, 0xE9U, 0x03U}), AbortOf(0x2103U, 0U, 0x05040005U));
    EXPECT_EQ(Send({0x20U, 0x03U, 0x21U, 0x00U})[0], 0x60U);
    for (int i = 0; i < 142; ++i) // 994 bytes
    {
        EXPECT_EQ(Send({static_cast<std::uint8_t>((i % 2) * 16)}).at(0), (i % 2 == 0) ? 0x20U : 0x30U);
    }
    EXPECT_EQ(Send({0x00U}), AbortOf(0x2103U, 0U, 0x05040005U));
    domain_length = 1001U;
    EXPECT_EQ(Send({0x40U, 0x03U, 0x21U, 0x00U}), AbortOf(0x2103U, 0U, 0x05040005U));
    EXPECT_EQ(Send({0xA4U, 0x03U, 0x21U, 0x00U, 4U}), AbortOf(0x2103U, 0U, 0x05040005U));
}

TEST_F(SdoServerTest, TheOwnerClosesARunningTransfer)
{
    Verifies(req::SRS_SDO_014);
    EXPECT_TRUE(Plain(server.Close(SdoAbort::kDeviceState)).empty());
    EXPECT_EQ(Send({0x20U, 0x02U, 0x21U, 0x00U})[0], 0x60U);
    EXPECT_EQ(Plain(server.Close(SdoAbort::kDeviceState)), AbortOf(0x2102U, 0U, 0x08000022U));
    EXPECT_TRUE(Plain(server.Close(SdoAbort::kDeviceState)).empty());
}

TEST_F(SdoServerTest, ABlockSizeOfItsOwnIsAtMostTheGreatestOne)
{
    Verifies(req::SRS_SDO_006);
    const std::pair<std::uint8_t, std::uint8_t> sizes[] = {{std::uint8_t{0U}, std::uint8_t{127U}},
                                                           {std::uint8_t{1U}, std::uint8_t{1U}},
                                                           {std::uint8_t{127U}, std::uint8_t{127U}},
                                                           {std::uint8_t{128U}, std::uint8_t{127U}}};
    for (const auto& [own, told] : sizes)
    {
        SdoServer other{SdoServerParts{dictionary, Room{buffer.data(), 1000U}, 1000U, own}};
        const SdoFrame request{{0xC6U, 0x03U, 0x21U, 0U, 20U, 0U, 0U, 0U}};
        const Octets answer = Plain(other.OnFrame(request, 8U, Instant{now_us}));
        ASSERT_EQ(answer.size(), 8U);
        EXPECT_EQ(answer[0], 0xA4U);
        EXPECT_EQ(answer[4], told) << int{own};
    }
}

TEST_F(SdoServerTest, WhatIsNotTheEndOfABlockUploadIsNone)
{
    Verifies(req::SRS_SDO_012);
    domain_length = 7U;
    EXPECT_EQ(Send({0xA4U, 0x03U, 0x21U, 0U, 4U})[0], 0xC6U);
    EXPECT_EQ(Send({0xA3U})[0], 0x81U);
    EXPECT_EQ(Send({0xA2U, 1U, 4U})[0], 0xC1U);
    EXPECT_EQ(Send({0xA2U, 1U, 4U}), AbortOf(0x2103U, 0U, 0x05040001U)); // Acknowledged already.
}

TEST_F(SdoServerTest, AWriteThatIsDelayedHasToFitTheBuffer)
{
    Verifies(req::SRS_SDO_013);
    class Later final : public WriteHook
    {
      public:
        [[nodiscard]] SdoAbort OnWrite(const ObjectAddress&, const Bytes&) noexcept override
        {
            return SdoAbort::kPending;
        }
    };
    Later later{};
    Entry entry = entries[0];
    entry.access = Access::kReadWrite;
    entry.write_hook = &later;
    Dictionary own{EntryTable{&entry, 1U}, foreign};
    own.SetNmtState(NmtState::kPreOperational);
    const SdoFrame request{{0x23U, 0x00U, 0x10U, 0U, 1U, 2U, 3U, 4U}};
    SdoServer small{SdoServerParts{own, Room{buffer.data(), 3U}, 1000U, 4U}};
    EXPECT_EQ(Plain(small.OnFrame(request, 8U, Instant{now_us})), AbortOf(0x1000U, 0U, 0x05040005U));
    EXPECT_FALSE(small.IsBusy());
    SdoServer fitting{SdoServerParts{own, Room{buffer.data(), 4U}, 1000U, 4U}};
    EXPECT_TRUE(Plain(fitting.OnFrame(request, 8U, Instant{now_us})).empty());
    EXPECT_TRUE(fitting.IsBusy());
}

} // namespace
} // namespace counterpoint::cia301
