// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/store/crc16.hpp"
#include "tests/canopen/cia301/sdo_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

#include <algorithm>

namespace counterpoint::cia301
{
namespace
{

class SdoBlockTest : public SdoRig
{
  public:
    /// Segments `from` to `to` of a block; each but an acknowledged one must go without an answer.
    Octets SendSegments(int from, int to)
    {
        Octets answer{};
        for (int i = from; i <= to; ++i)
        {
            EXPECT_TRUE(answer.empty());
            answer = Send({static_cast<std::uint8_t>(i), 1U, 2U, 3U, 4U, 5U, 6U, 7U});
        }
        return answer;
    }
};

TEST_F(SdoBlockTest, CrcOfTheStandardsExample)
{
    Verifies(req::SRS_SDO_008);
    const std::uint8_t digits[9] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(ContinueCrc(0U, {digits, 9U}), 0x31C3U);
    EXPECT_EQ(ContinueCrc(ContinueCrc(0U, {digits, 4U}), {&digits[4], 5U}), 0x31C3U);
    EXPECT_EQ(ContinueCrc(0U, {digits, 0U}), 0U);
}

// A download that its client has left: whoever asks meanwhile gets no answer, and does not keep it alive.
TEST_F(SdoBlockTest, AnAbandonedDownloadEndsHoweverOftenSomebodyAsks)
{
    Verifies(req::SRS_SDO_010);
    // Requests whose first byte is a segment that came, or a later one, behind 0 to 2 segments of a block of 4
    for (const std::uint8_t asked : Octets{0x02U, 0x03U, 0x04U, 0x82U})
    {
        for (int segments = 0; segments < 3; ++segments)
        {
            ASSERT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
            static_cast<void>(SendSegments(1, segments));
            const bool goes_on = static_cast<int>(asked & 0x7FU) == segments + 1;
            Octets last{};
            for (int i = 0; (i < 5) && server.IsBusy(); ++i)
            {
                now_us += 300U;
                last = Poll();
                static_cast<void>(server.IsBusy() && !goes_on ? Send({asked, 0x00U, 0x10U, 0x00U}) : Octets{});
            }
            ASSERT_FALSE(server.IsBusy()) << int{asked} << " " << segments;
            EXPECT_EQ(last, AbortOf(0x2103U, 0U, 0x05040000U));
        }
    }
    // A client that goes on slowly is not cut off
    ASSERT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    for (int i = 1; i <= 3; ++i)
    {
        now_us += 450U;
        static_cast<void>(Poll());
        static_cast<void>(Send({static_cast<std::uint8_t>(i), 1U}));
        EXPECT_TRUE(server.IsBusy());
    }
    now_us += 999U;
    static_cast<void>(Poll());
    EXPECT_TRUE(server.IsBusy());
    now_us += 1U;
    EXPECT_EQ(Poll(), AbortOf(0x2103U, 0U, 0x05040000U));
}

TEST_F(SdoBlockTest, DownloadOfNineBytesWithCrc)
{
    Verifies(req::SRS_SDO_006);
    Verifies(req::SRS_SDO_008);
    EXPECT_EQ(Send({0xC6U, 0x03U, 0x21U, 0x00U, 9U}), (Octets{0xA4U, 0x03U, 0x21U, 0x00U, 4U, 0U, 0U, 0U}));
    EXPECT_TRUE(Send({0x01U, '1', '2', '3', '4', '5', '6', '7'}).empty());
    EXPECT_EQ(Send({0x82U, '8', '9'}), (Octets{0xA2U, 2U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(domain_length, 0U);
    EXPECT_EQ(Send({0xD5U, 0xC3U, 0x31U}), (Octets{0xA1U, 0U, 0U, 0U, 0U, 0U, 0U, 0U})); // 5 bytes unused
    EXPECT_EQ(domain_length, 9U);
    EXPECT_EQ(domain[8], '9');
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoBlockTest, AWrongCrcWritesNothing)
{
    Verifies(req::SRS_SDO_008);
    EXPECT_EQ(Send({0xC6U, 0x03U, 0x21U, 0x00U, 9U})[0], 0xA4U);
    EXPECT_TRUE(Send({0x01U, '1', '2', '3', '4', '5', '6', '7'}).empty());
    EXPECT_EQ(Send({0x82U, '8', '8'})[1], 2U);
    EXPECT_EQ(Send({0xD5U, 0xC3U, 0x31U}), AbortOf(0x2103U, 0U, 0x05040004U));
    EXPECT_EQ(domain_length, 0U);
    // A client without CRC is not asked for one
    EXPECT_EQ(Send({0xC2U, 0x03U, 0x21U, 0x00U, 9U})[0], 0xA4U);
    EXPECT_TRUE(Send({0x01U, '1', '2', '3', '4', '5', '6', '7'}).empty());
    EXPECT_EQ(Send({0x82U, '8', '8'})[1], 2U);
    EXPECT_EQ(Send({0xD5U, 0xFFU, 0xFFU})[0], 0xA1U);
    EXPECT_EQ(domain_length, 9U);
}

// The segment that ends a sub-block, and the last one of all, come twice; then what follows is as if they had not.
TEST_F(SdoBlockTest, ADoubledEndOfASubBlockIsIgnored)
{
    Verifies(req::SRS_SDO_151);
    EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    EXPECT_EQ(SendSegments(1, 4), (Octets{0xA2U, 4U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Send({0x04U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}).empty());
    EXPECT_TRUE(SendSegments(1, 1).empty());
    // Number 4 of this sub-block is no double any more: 2 and 3 are lost
    EXPECT_EQ(Send({0x04U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}), (Octets{0xA2U, 1U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Send({0x04U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}).empty());
    EXPECT_TRUE(SendSegments(1, 1).empty());
    EXPECT_EQ(Send({0x82U, 8U, 9U}), (Octets{0xA2U, 2U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Send({0x82U, 8U, 9U}).empty());
    EXPECT_TRUE(server.IsBusy());
    EXPECT_EQ(Send({0xD5U})[0], 0xA1U); // 5 bytes unused of 7 segments
    EXPECT_EQ(domain_length, 44U);
    EXPECT_EQ(domain[43], 9U);
    // Other bytes in the same place are no double: 81h is an abort of the client then
    EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    EXPECT_EQ(Send({0x81U, 1U}), (Octets{0xA2U, 1U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Send({0x81U, 1U}).empty());
    EXPECT_TRUE(server.IsBusy());
    EXPECT_TRUE(Send({0x81U, 2U}).empty());
    EXPECT_FALSE(server.IsBusy());
}

// Behind an abort such a frame would be a request: number 40h, as an example, an upload.
TEST_F(SdoBlockTest, ADoubledEndOfAnAbortedSubBlockIsNoRequest)
{
    Verifies(req::SRS_SDO_151);
    SdoServer long_blocks{SdoServerParts{dictionary, Room{buffer.data(), 8U}, 1000U, 0x40U}};
    const auto send = [&long_blocks, this](const std::uint8_t head)
    { return long_blocks.OnFrame(SdoFrame{{head, 0x03U, 0x21U, 0U, 1U, 0U, 0U, 0U}}, 8U, Instant{now_us}); };
    EXPECT_EQ(send(0xC0U).frame.bytes[0], 0xA4U);
    for (std::uint8_t number = 1U; number < 0x40U; ++number)
    {
        EXPECT_EQ(send(number).presence, SdoPresence::kNothing);
    }
    EXPECT_EQ(send(0x40U).frame.bytes[0], 0x80U); // Too long for the buffer.
    EXPECT_EQ(send(0x40U).presence, SdoPresence::kNothing);
    EXPECT_FALSE(long_blocks.IsBusy());
    // What a client asks for then is a request
    EXPECT_EQ(send(0xC0U).frame.bytes[0], 0xA4U);
}

// Of sub-blocks of one segment, the same frame again is the next segment.
TEST_F(SdoBlockTest, EqualSegmentsOfSubBlocksOfOneAreNoDoubles)
{
    Verifies(req::SRS_SDO_151);
    SdoServer short_blocks{SdoServerParts{dictionary, Room{buffer.data(), 64U}, 1000U, 1U}};
    const auto send = [&short_blocks, this](const std::uint8_t head)
    { return short_blocks.OnFrame(SdoFrame{{head, 0x03U, 0x21U, 0U, 1U, 0U, 0U, 0U}}, 8U, Instant{now_us}); };
    EXPECT_EQ(send(0xC0U).frame.bytes[0], 0xA4U);
    EXPECT_EQ(send(0x01U).frame.bytes[0], 0xA2U);
    EXPECT_EQ(send(0x01U).frame.bytes[0], 0xA2U);
    EXPECT_EQ(send(0x81U).frame.bytes[0], 0xA2U);
    EXPECT_EQ(send(0xC1U).frame.bytes[0], 0xA1U);
    EXPECT_EQ(domain_length, 21U);
}

TEST_F(SdoBlockTest, LostSegmentsAreRepeatedAndDoubledOnesIgnored)
{
    Verifies(req::SRS_SDO_150);
    Verifies(req::SRS_SDO_151);
    Verifies(req::SRS_SDO_006);
    EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    // Given that segment 3 of 4 is lost and 2 is doubled
    EXPECT_TRUE(SendSegments(1, 2).empty());
    EXPECT_TRUE(Send({0x02U, 9U}).empty());
    EXPECT_EQ(Send({0x04U, 9U}), (Octets{0xA2U, 2U, 4U, 0U, 0U, 0U, 0U, 0U}));
    // When the client goes on after 2, the second block is full
    EXPECT_EQ(SendSegments(1, 4), (Octets{0xA2U, 4U, 4U, 0U, 0U, 0U, 0U, 0U}));
    // and the last segment comes out of order, which does not end the data
    EXPECT_EQ(Send({0x82U, 9U}), (Octets{0xA2U, 0U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x81U, 0x77U}), (Octets{0xA2U, 1U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0xD9U})[0], 0xA1U); // 6 unused
    EXPECT_EQ(domain_length, 43U);      // 6 segments and 1 byte
    EXPECT_EQ(domain[14], 1U);
    EXPECT_EQ(domain[42], 0x77U);
}

TEST_F(SdoBlockTest, SequenceNumbersThatTheBlockDoesNotHaveAreNotReceived)
{
    Verifies(req::SRS_SDO_152);
    Verifies(req::SRS_SDO_006);
    for (const std::uint8_t number : Octets{0x00U, 0x05U, 0x2FU, 0x7FU})
    {
        // Given a block of 4 segments, of which the first one came
        EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
        EXPECT_TRUE(SendSegments(1, 1).empty());
        // When one with such a number comes, then it is left aside, and so are the others, which are no requests
        EXPECT_TRUE(Send({number, 0x00U, 0x20U, 0x01U, 0x55U}).empty()) << int{number};
        EXPECT_TRUE(Send({0x03U, 1U}).empty());
        // and the end of the block tells the last good one
        EXPECT_EQ(Send({0x04U, 1U}), (Octets{0xA2U, 1U, 4U, 0U, 0U, 0U, 0U, 0U}));
        EXPECT_EQ(Send({0x81U, 0x77U}), (Octets{0xA2U, 1U, 4U, 0U, 0U, 0U, 0U, 0U}));
        EXPECT_EQ(Send({0xD9U})[0], 0xA1U);
        EXPECT_EQ(domain_length, 8U);
    }
    // One that says it is the last ends the block, too
    for (const std::uint8_t number : Octets{0x85U, 0xFFU})
    {
        EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
        EXPECT_TRUE(SendSegments(1, 2).empty());
        EXPECT_EQ(Send({number}), (Octets{0xA2U, 2U, 4U, 0U, 0U, 0U, 0U, 0U})) << int{number};
        EXPECT_EQ(Send({0x80U, 0x03U, 0x21U}).size(), 0U);
    }
}

TEST_F(SdoBlockTest, DownloadsOfOtherLengthsThanStatedAreRefused)
{
    Verifies(req::SRS_SDO_003);
    Verifies(req::SRS_SDO_013);
    EXPECT_EQ(Send({0xC2U, 0x03U, 0x21U, 0x00U, 7U})[0], 0xA4U);
    EXPECT_TRUE(SendSegments(1, 1).empty());
    EXPECT_EQ(Send({0x82U}), AbortOf(0x2103U, 0U, 0x06070012U));
    EXPECT_EQ(Send({0xC2U, 0x03U, 0x21U, 0x00U, 9U})[0], 0xA4U);
    EXPECT_EQ(Send({0x81U})[1], 1U);
    EXPECT_EQ(Send({0xC1U}), AbortOf(0x2103U, 0U, 0x06070013U));
    EXPECT_EQ(Send({0xC2U, 0x03U, 0x21U, 0x00U, 5U})[0], 0xA4U);
    EXPECT_EQ(Send({0x81U})[1], 1U);
    EXPECT_EQ(Send({0xC5U}), AbortOf(0x2103U, 0U, 0x06070012U)); // 6 bytes
    // Without a stated length the buffer is the limit: 143 segments are 1001 bytes
    EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    for (int block = 0; block < 35; ++block)
    {
        EXPECT_EQ(SendSegments(1, 4)[1], 4U);
    }
    EXPECT_TRUE(SendSegments(1, 3).empty());
    EXPECT_EQ(Send({0x04U}), AbortOf(0x2103U, 0U, 0x05040005U));
}

// Segments 2Fh 00h 21h 00h 01h of a file, read as a request, would write 2100h
TEST_F(SdoBlockTest, TheRestOfARefusedSubBlockIsNoRequest)
{
    Verifies(req::SRS_SDO_011);
    SdoServer wide{SdoServerParts{dictionary, Room{buffer.data(), 7U}, 1000U, 0x40U}};
    const auto send = [&](const Octets& bytes)
    {
        SdoFrame frame{};
        std::copy(bytes.begin(), bytes.end(), frame.bytes);
        return Plain(wide.OnFrame(frame, 8U, Instant{now_us}));
    };
    const auto poll = [&] { return Plain(wide.Poll(Instant{now_us})); };
    const auto segments = [&](const unsigned first, const unsigned last)
    {
        for (unsigned number = first; number <= last; ++number)
        {
            EXPECT_TRUE(send({static_cast<std::uint8_t>(number), 0x00U, 0x21U, 0x00U, 0x01U}).empty()) << number;
            now_us += 400U; // They keep it alive, however long they take.
            EXPECT_TRUE(poll().empty()) << number;
        }
    };
    const Octets begin{0xC0U, 0x03U, 0x21U, 0x00U};
    const Octets too_long = AbortOf(0x2103U, 0U, 0x05040005U);
    // To the last number of the sub-block
    EXPECT_EQ(send(begin)[0], 0xA4U);
    segments(1U, 0x3FU);
    EXPECT_EQ(send({0x40U, 0x00U, 0x21U, 0x00U}), too_long);
    EXPECT_FALSE(wide.IsBusy());
    // To the mark of the last segment
    EXPECT_EQ(send(begin)[0], 0xA4U);
    segments(1U, 0x2EU);
    EXPECT_EQ(send({0xAFU, 0x00U, 0x21U, 0x00U, 0x01U}), too_long);
    // To half the time-out without a next one, where some are lost
    EXPECT_EQ(send(begin)[0], 0xA4U);
    segments(1U, 2U);
    EXPECT_TRUE(send({0x2FU, 0x00U, 0x21U, 0x00U, 0x01U}).empty());
    now_us += 99U;
    EXPECT_TRUE(poll().empty());
    now_us += 1U;
    EXPECT_EQ(poll(), too_long);
    EXPECT_TRUE(poll().empty());
    EXPECT_EQ(u8[0], 0x7FU);
    // An abort of the client ends it without an answer; then requests are requests
    EXPECT_EQ(send(begin)[0], 0xA4U);
    segments(1U, 3U);
    EXPECT_TRUE(send({0x80U}).empty());
    EXPECT_EQ(send({0x2FU, 0x00U, 0x21U, 0x00U, 0x01U})[0], 0x60U);
    EXPECT_EQ(u8[0], 1U);
}

TEST_F(SdoBlockTest, TheBufferIsFilledToItsLastByteAndNoFurther)
{
    Verifies(req::SRS_SDO_013);
    for (const std::uint8_t unused : Octets{1U, 0U})
    {
        EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
        for (int block = 0; block < 35; ++block)
        {
            EXPECT_EQ(SendSegments(1, 4)[1], 4U);
        }
        EXPECT_TRUE(SendSegments(1, 2).empty());
        EXPECT_EQ(Send({0x83U, 5U, 5U, 5U, 5U, 5U, 6U, 7U})[1], 3U);
        const Octets answer = Send({static_cast<std::uint8_t>(0xC1U + (4U * unused))});
        EXPECT_EQ(answer,
                  (unused == 1U) ? (Octets{0xA1U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}) : AbortOf(0x2103U, 0U, 0x05040005U));
    }
    EXPECT_EQ(domain_length, 1000U);
    EXPECT_EQ(domain[999], 6U);
}

TEST_F(SdoBlockTest, DownloadOfNothing)
{
    Verifies(req::SRS_SDO_006);
    domain_length = 3U;
    EXPECT_EQ(Send({0xC6U, 0x03U, 0x21U, 0x00U, 0U})[0], 0xA4U);
    EXPECT_EQ(Send({0x81U})[1], 1U);
    EXPECT_EQ(Send({0xDDU})[0], 0xA1U);
    EXPECT_EQ(domain_length, 0U);
}

TEST_F(SdoBlockTest, ASubBlockThatStopsIsAcknowledgedOnceAndThenTimesOut)
{
    Verifies(req::SRS_SDO_010);
    EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    now_us += 600U;
    EXPECT_TRUE(Poll().empty()); // no segment came
    EXPECT_TRUE(SendSegments(1, 2).empty());
    now_us += 499U;
    EXPECT_TRUE(Poll().empty());
    now_us += 1U;
    EXPECT_EQ(Poll(), (Octets{0xA2U, 2U, 4U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(SendSegments(1, 1).empty());
    now_us += 500U;
    EXPECT_TRUE(Poll().empty()); // once in a sub-block
    now_us += 500U;
    EXPECT_EQ(Poll(), AbortOf(0x2103U, 0U, 0x05040000U));
    // Nothing but an end is taken after the last segment
    EXPECT_EQ(Send({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    EXPECT_EQ(Send({0x81U})[1], 1U);
    EXPECT_EQ(Send({0xC0U}), AbortOf(0x2103U, 0U, 0x05040001U));
}

// Segments 47 and 64 of a sub-block of 64 look like the begin of a download and of an upload.
class SdoRestTest : public SdoRig
{
  public:
    Octets SendWhole(const Octets& request)
    {
        SdoFrame frame{};
        std::copy(request.begin(), request.end(), frame.bytes);
        return Plain(whole.OnFrame(frame, 8U, Instant{now_us}));
    }
    Octets PollWhole()
    {
        return Plain(whole.Poll(Instant{now_us}));
    }
    /// A transfer with one segment of its sub-block.
    void Begin()
    {
        EXPECT_EQ(SendWhole({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
        EXPECT_TRUE(SendWhole({0x01U}).empty());
    }
    void BeginAndClose()
    {
        Begin();
        EXPECT_EQ(Plain(whole.Close(SdoAbort::kDeviceState)), AbortOf(0x2103U, 0U, 0x08000022U));
        EXPECT_FALSE(whole.IsBusy());
    }

    const Octets write{0x2FU, 0x00U, 0x21U, 0x00U, 0x01U};
    const Octets done{0x60U, 0x00U, 0x21U, 0x00U, 0U, 0U, 0U, 0U};
    SdoServer whole{SdoServerParts{dictionary, Room{buffer.data(), 1000U}, 1000U, 64U}};
};

TEST_F(SdoRestTest, TheRestOfASubBlockThatWasCutIsNoRequest)
{
    Verifies(req::SRS_SDO_019);
    // Given a reset, and segments up to the last one
    BeginAndClose();
    EXPECT_TRUE(SendWhole(write).empty());
    EXPECT_TRUE(SendWhole({0x40U, 0x00U, 0x21U, 0x00U}).empty());
    EXPECT_EQ(u8[0], 0x7FU);
    EXPECT_EQ(SendWhole({0x40U, 0x00U, 0x21U, 0x00U})[0], 0x4FU);
    // The mark of the last segment ends it as well
    BeginAndClose();
    EXPECT_TRUE(SendWhole({0xA4U, 0x00U, 0x21U, 0x00U, 4U, 1U}).empty());
    EXPECT_EQ(SendWhole({0xA4U, 0x00U, 0x21U, 0x00U, 4U, 1U})[0], 0x4FU);
    // An abort of the client, and a frame that is none of the sub-block
    BeginAndClose();
    EXPECT_TRUE(SendWhole({0x80U}).empty());
    EXPECT_EQ(SendWhole(write), done);
    EXPECT_EQ(u8[0], 0x01U);
    BeginAndClose();
    EXPECT_EQ(SendWhole({0x60U}), AbortOf(0U, 0U, 0x05040001U));
}

TEST_F(SdoRestTest, ThatEndsWithAPauseAndBeginsWithATimeOutToo)
{
    Verifies(req::SRS_SDO_019);
    // A pause of half the time-out, counted from the first time that the server is asked, then from the last segment
    BeginAndClose();
    now_us += 5000U;
    EXPECT_TRUE(PollWhole().empty());
    now_us += 499U;
    EXPECT_TRUE(PollWhole().empty());
    EXPECT_TRUE(SendWhole(write).empty());
    now_us += 499U;
    EXPECT_TRUE(PollWhole().empty());
    EXPECT_TRUE(SendWhole(write).empty());
    EXPECT_EQ(u8[0], 0x7FU);
    now_us += 500U;
    EXPECT_TRUE(PollWhole().empty());
    EXPECT_EQ(SendWhole(write), done);
    // A time-out
    u8[0] = 0x7FU;
    Begin();
    now_us += 1000U;
    EXPECT_EQ(PollWhole(), AbortOf(0x2103U, 0U, 0x05040000U));
    EXPECT_TRUE(SendWhole(write).empty());
    EXPECT_EQ(u8[0], 0x7FU);
    // Between sub-blocks, and outside of block downloads, nothing is left over
    EXPECT_TRUE(SendWhole({0x80U}).empty());
    Begin();
    EXPECT_EQ(SendWhole({0x82U})[0], 0xA2U);
    static_cast<void>(whole.Close(SdoAbort::kDeviceState));
    EXPECT_EQ(SendWhole(write), done);
}

// A client that gave up and asks for the same again and again: 40h is the last segment of a sub-block of 64, 2Fh one of
// it
TEST_F(SdoRestTest, ARequestThatIsRepeatedHasAnAnswerBehindAnAbandonedDownload)
{
    Verifies(req::SRS_SDO_151);
    Verifies(req::SRS_SDO_019);
    const Octets read{0x40U, 0x00U, 0x21U, 0x00U};
    EXPECT_EQ(SendWhole({0xC0U, 0x03U, 0x21U, 0x00U})[0], 0xA4U);
    EXPECT_EQ(SendWhole(read)[0], 0xA2U);
    EXPECT_TRUE(SendWhole(read).empty()); // the end of the sub-block came twice
    EXPECT_EQ(SendWhole(read)[0], 0xA2U); // not three times
    now_us += 1000U;
    EXPECT_EQ(PollWhole(), AbortOf(0x2103U, 0U, 0x05040000U));
    EXPECT_TRUE(SendWhole(read).empty()); // twice again
    EXPECT_TRUE(SendWhole(read).empty()); // the end of what is left over
    EXPECT_EQ(SendWhole(read)[0], 0x4FU);
    // Sooner than the pause that ends the rest
    Begin();
    now_us += 1000U;
    EXPECT_EQ(PollWhole(), AbortOf(0x2103U, 0U, 0x05040000U));
    for (int i = 0; i < 2; ++i)
    {
        EXPECT_TRUE(SendWhole(write).empty()) << i;
        now_us += 400U;
        EXPECT_TRUE(PollWhole().empty());
    }
    EXPECT_EQ(u8[0], 0x7FU);
    EXPECT_EQ(SendWhole(write), done);
    EXPECT_EQ(u8[0], 0x01U);
}

TEST_F(SdoRestTest, ANumberBelowTheOneBeforeIsNoRestUnlessTheSubBlockBeginsAnew)
{
    Verifies(req::SRS_SDO_019);
    // 22h, a download of one byte, behind 2Fh
    BeginAndClose();
    EXPECT_TRUE(SendWhole(write).empty());
    EXPECT_EQ(SendWhole({0x22U, 0x00U, 0x21U, 0x00U, 0x02U}), done);
    EXPECT_EQ(u8[0], 0x02U);
    // Segments that come twice each
    BeginAndClose();
    for (const std::uint8_t number : Octets{0x21U, 0x21U, 0x22U, 0x22U, 0x2FU, 0x2FU})
    {
        EXPECT_TRUE(SendWhole({number, 0x00U, 0x21U, 0x00U, 0x03U}).empty()) << int{number};
    }
    EXPECT_TRUE(SendWhole({0x80U}).empty());
    EXPECT_EQ(u8[0], 0x02U);
    // A client that was told how far its sub-block came sends what follows as 1, 2, 3 ...; up to 1Fh nothing begins a
    // transfer
    for (const std::uint8_t first : Octets{0x01U, 0x1FU})
    {
        BeginAndClose();
        EXPECT_TRUE(SendWhole({0x30U}).empty());
        EXPECT_TRUE(SendWhole({first}).empty());
        EXPECT_TRUE(SendWhole(write).empty());
        EXPECT_TRUE(SendWhole({0x80U}).empty());
        EXPECT_EQ(u8[0], 0x02U);
    }
    BeginAndClose();
    EXPECT_TRUE(SendWhole({0x30U}).empty());
    EXPECT_EQ(SendWhole({0x20U, 0x03U, 0x21U, 0x00U})[0], 0x60U);
}

TEST_F(SdoBlockTest, UploadInBlocksOfTheClientsSizeWithCrc)
{
    Verifies(req::SRS_SDO_007);
    Verifies(req::SRS_SDO_008);
    const Octets digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    std::copy(digits.begin(), digits.end(), domain.begin());
    domain_length = 9U;
    EXPECT_EQ(Send({0xA4U, 0x03U, 0x21U, 0x00U, 1U}), (Octets{0xC6U, 0x03U, 0x21U, 0x00U, 9U, 0U, 0U, 0U}));
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(Send({0xA3U}), (Octets{0x01U, '1', '2', '3', '4', '5', '6', '7'}));
    EXPECT_TRUE(Poll().empty()); // the block is full
    EXPECT_EQ(Send({0xA2U, 1U, 127U}), (Octets{0x81U, '8', '9', 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(Send({0xA2U, 1U, 127U}), (Octets{0xD5U, 0xC3U, 0x31U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(Send({0xA1U}).empty());
    EXPECT_FALSE(server.IsBusy());
}

TEST_F(SdoBlockTest, WhatWasNotAcknowledgedIsRepeated)
{
    Verifies(req::SRS_SDO_007);
    domain_length = 20U;
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 2U})[0], 0xC6U);
    EXPECT_EQ(Send({0xA3U})[0], 0x01U);
    EXPECT_EQ(Poll(), (Octets{0x02U, 7U, 8U, 9U, 10U, 11U, 12U, 13U}));
    EXPECT_EQ(Send({0xA2U, 1U, 3U}), (Octets{0x01U, 7U, 8U, 9U, 10U, 11U, 12U, 13U}));
    EXPECT_EQ(Poll(), (Octets{0x82U, 14U, 15U, 16U, 17U, 18U, 19U, 0U}));
    EXPECT_TRUE(Poll().empty());
    EXPECT_EQ(Send({0xA2U, 0U, 3U})[1], 7U); // nothing came
    EXPECT_EQ(Poll()[0], 0x82U);
    EXPECT_EQ(Send({0xA2U, 2U, 3U}), (Octets{0xC5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U})); // no CRC asked for
    EXPECT_TRUE(Send({0xA1U}).empty());
}

TEST_F(SdoBlockTest, WrongBlockSizesAndAcknowledgementsAreRefused)
{
    Verifies(req::SRS_SDO_007);
    domain_length = 20U;
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 0U}), AbortOf(0x2103U, 0U, 0x05040002U));
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 128U}), AbortOf(0x2103U, 0U, 0x05040002U));
    for (const std::uint8_t size : Octets{0U, 128U})
    {
        EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 127U})[0], 0xC6U);
        EXPECT_EQ(Send({0xA3U})[0], 0x01U);
        EXPECT_EQ(Send({0xA2U, 1U, size}), AbortOf(0x2103U, 0U, 0x05040002U));
    }
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 127U})[0], 0xC6U);
    EXPECT_EQ(Send({0xA3U})[0], 0x01U);
    EXPECT_EQ(Send({0xA2U, 2U, 127U}), AbortOf(0x2103U, 0U, 0x05040003U));
    // Commands out of place in each phase
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 127U})[0], 0xC6U);
    EXPECT_EQ(Send({0xA2U, 0U, 127U}), AbortOf(0x2103U, 0U, 0x05040001U));
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 127U})[0], 0xC6U);
    EXPECT_EQ(Send({0xA3U})[0], 0x01U);
    EXPECT_EQ(Send({0xA3U}), AbortOf(0x2103U, 0U, 0x05040001U));
    EXPECT_EQ(Send({0xA0U, 0x03U, 0x21U, 0x00U, 127U})[0], 0xC6U);
    EXPECT_EQ(Send({0x60U}), AbortOf(0x2103U, 0U, 0x05040001U));
}

TEST_F(SdoBlockTest, ASmallValueIsUploadedAsTheThresholdSays)
{
    Verifies(req::SRS_SDO_009);
    EXPECT_EQ(Send({0xA4U, 0x00U, 0x21U, 0x00U, 4U, 1U}), (Octets{0x4FU, 0x00U, 0x21U, 0x00U, 0x7FU, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0xA4U, 0x02U, 0x21U, 0x00U, 4U, 8U}), (Octets{0x41U, 0x02U, 0x21U, 0x00U, 8U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x60U})[0], 0x00U);
    EXPECT_EQ(Send({0x70U})[0], 0x1DU);
    EXPECT_EQ(Send({0xA4U, 0x02U, 0x21U, 0x00U, 4U, 7U})[0], 0xC6U); // longer than the threshold
    EXPECT_TRUE(Send({0x80U}).empty());
    EXPECT_EQ(Send({0xA4U, 0x03U, 0x21U, 0x00U, 4U, 0U})[0], 0xC6U); // nothing, without a threshold
    EXPECT_EQ(Send({0xA3U})[0], 0x81U);
    EXPECT_EQ(Send({0xA2U, 1U, 4U}), (Octets{0xDDU, 0U, 0U, 0U, 0U, 0U, 0U, 0U}));
}

} // namespace
} // namespace counterpoint::cia301
