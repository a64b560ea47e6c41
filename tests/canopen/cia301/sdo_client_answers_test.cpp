// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Answers that do not fit the phase of a transfer, and sizes that only its end tells.
#include "canopen/cia301/sdo/parameters.hpp"
#include "tests/canopen/cia301/sdo_client_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

using SdoClientAnswersTest = SdoClientRig;

TEST_F(SdoClientAnswersTest, AFirstAnswerOfAnotherCommandIsIgnored)
{
    Verifies(req::SRS_SDC_007);
    const Octets heads{0x43U, 0x60U, 0xA0U, 0xC0U, 0x20U};
    const Octets eight(8U, 1U);
    struct Case
    {
        bool is_upload;
        SdoMode mode;
        std::size_t fits; ///< Place in `heads`.
    };
    // An upload in blocks also takes the answer of a normal one
    const Case cases[] = {{true, SdoMode::kNormal, 0U},
                          {false, SdoMode::kNormal, 1U},
                          {false, SdoMode::kBlock, 2U},
                          {true, SdoMode::kBlock, 3U}};
    for (const Case& one : cases)
    {
        EXPECT_TRUE(one.is_upload ? Upload(0x2103U, one.mode) : Download(0x2103U, eight, one.mode));
        requests.frames.clear();
        for (std::size_t i = 0U; i < heads.size(); ++i)
        {
            const bool is_normal = (one.mode == SdoMode::kBlock) && one.is_upload && (i == 0U);
            if ((i != one.fits) && !is_normal)
            {
                Answer({heads[i], 0x03U, 0x21U, 0U, 1U});
                EXPECT_EQ(Result(), 0xFFFFFFFFU) << int{heads[i]};
                EXPECT_TRUE(requests.frames.empty()) << int{heads[i]};
            }
        }
        client.Cancel(SdoAbort::kGeneral);
        client.OnServerRestart();
    }
}

TEST_F(SdoClientAnswersTest, AWrongCommandWithinATransferEndsIt)
{
    Verifies(req::SRS_SDC_007);
    const Octets eight(8U, 1U);
    const std::array<std::vector<Octets>, 5> answers_before{{
        {{0x41U, 0x03U, 0x21U, 0U, 9U}},                                      // Segments of an upload,
        {{0xA4U, 0x03U, 0x21U, 0U, 4U}},                                      // an acknowledgement,
        {{0xA4U, 0x03U, 0x21U, 0U, 4U}, {0xA2U, 2U, 4U}},                     // the end of a download,
        {{0xC6U, 0x03U, 0x21U, 0U, 7U}, {0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}}, // and of an upload in blocks.
        {{0x60U, 0x03U, 0x21U}},
    }};
    for (std::size_t i = 0U; i < answers_before.size(); ++i)
    {
        const bool is_upload = (i == 0U) || (i == 3U);
        const SdoMode mode = ((i == 0U) || (i == 4U)) ? SdoMode::kNormal : SdoMode::kBlock;
        EXPECT_TRUE(is_upload ? Upload(0x2103U, mode) : Download(0x2103U, eight, mode));
        for (const Octets& answer : answers_before[i])
        {
            Answer(answer);
        }
        EXPECT_EQ(Result(), 0xFFFFFFFFU) << i;
        Answer({0xE0U, 0x03U, 0x21U});
        EXPECT_EQ(Result(), 0x05040001U) << i;
        EXPECT_EQ(requests.frames.back().data[0], 0x80U) << i;
        client.OnServerRestart();
    }
}

/// A transfer of several frames: its first answer, and the answer behind it.
struct Begun
{
    bool is_upload;
    SdoMode mode;
    Octets first;
    Octets next;
};

const Octets kFirstSegment{0x00U, 1U, 2U, 3U, 4U, 5U, 6U, 7U};
const Begun kBegun[] = {{true, SdoMode::kNormal, {0x41U, 0x03U, 0x21U, 0U, 9U}, kFirstSegment},
                        {false, SdoMode::kNormal, {0x60U, 0x03U, 0x21U}, {0x20U}},
                        {false, SdoMode::kBlock, {0xA4U, 0x03U, 0x21U, 0U, 1U}, {0xA2U, 1U, 1U}}};

class SdoClientBegunTest : public SdoClientRig
{
  public:
    /// Up to the first answer.
    void Begin(const Begun& transfer)
    {
        client.OnServerRestart();
        EXPECT_TRUE(transfer.is_upload ? Upload(0x2103U, transfer.mode)
                                       : Download(0x2103U, Octets(8U, 1U), transfer.mode));
        Answer(transfer.first);
        requests.frames.clear();
    }
};

// Given a first answer that comes again, and once more, then the transfer goes on as if it had come once.
TEST_F(SdoClientBegunTest, AFirstAnswerThatComesAgainIsIgnored)
{
    Verifies(req::SRS_SDC_450);
    for (const Begun& one : kBegun)
    {
        Begin(one);
        Answer(one.first);
        Answer(one.first);
        EXPECT_EQ(Result(), 0xFFFFFFFFU) << int{one.first[0]};
        EXPECT_TRUE(requests.frames.empty()) << int{one.first[0]};
        Answer(one.next);
        EXPECT_EQ(Result(), 0xFFFFFFFFU) << int{one.first[0]};
        EXPECT_FALSE(requests.frames.empty()) << int{one.first[0]};
        // Behind a further frame it is a wrong command
        Answer(one.first);
        EXPECT_EQ(Result(), 0x05040001U) << int{one.first[0]};
    }
    // The value is that of the segments
    Begin(kBegun[0]);
    for (const Octets& answer : {kBegun[0].first, kFirstSegment, Octets{0x1BU, 8U, 9U}})
    {
        Answer(answer);
    }
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(client.Outcome().size_bytes, 9U);
    EXPECT_EQ(got[8], 9U);
}

TEST_F(SdoClientBegunTest, OneOfAnotherObjectOrCommandEndsTheTransfer)
{
    Verifies(req::SRS_SDC_450);
    for (const Begun& one : kBegun)
    {
        Begin(one);
        Octets other = one.first;
        other[1] = 0x04U;
        Answer(other);
        EXPECT_EQ(Result(), 0x05040001U) << int{one.first[0]};
        Begin(one);
        other = one.first;
        other[0] = 0xE0U;
        Answer(other);
        EXPECT_EQ(Result(), 0x05040001U) << int{one.first[0]};
        // An abort of the server ends it by its code
        Begin(one);
        Answer({0x80U, 0x03U, 0x21U, 0U, 0U, 0U, 0x02U, 0x06U});
        EXPECT_EQ(Result(), 0x06020000U) << int{one.first[0]};
        EXPECT_TRUE(client.Outcome().by_server);
    }
}

TEST_F(SdoClientAnswersTest, AnUploadWithoutALengthEndsWithItsLastSegment)
{
    Verifies(req::SRS_SDC_002);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    Answer({0x40U, 0x03U, 0x21U, 0U});
    Answer({0x00U, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
    Answer({0x1BU, 8U, 9U}); // The last one, with two bytes.
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(client.Outcome().size_bytes, 9U);
    EXPECT_EQ(got[8], 9U);
}

TEST_F(SdoClientAnswersTest, AnUploadInBlocksWithoutALengthIsBoundByItsRoom)
{
    Verifies(req::SRS_SDC_005);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock, 7U));
    Answer({0xC0U, 0x03U, 0x21U, 0U});
    Answer({0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
    Answer({0xC1U});
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(client.Outcome().size_bytes, 7U);
    // One more segment than there is room for
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock, 7U));
    Answer({0xC0U, 0x03U, 0x21U, 0U});
    Answer({0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
    got[7] = 0x77U;
    Answer({0x82U, 8U});
    EXPECT_EQ(Result(), 0x05040005U);
    EXPECT_EQ(got[7], 0x77U);
}

TEST_F(SdoClientAnswersTest, AnUploadInBlocksOfAnotherLengthThanStatedIsWrong)
{
    Verifies(req::SRS_SDC_004);
    // 6 bytes stated, 7 or 5 come
    const std::pair<std::uint8_t, std::uint32_t> ends[] = {{std::uint8_t{0xC1U}, 0x06070012U},
                                                           {std::uint8_t{0xC9U}, 0x06070013U}};
    for (const auto& [end, result] : ends)
    {
        EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
        Answer({0xC2U, 0x03U, 0x21U, 0U, 6U});
        Answer({0x81U, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
        Answer({end});
        EXPECT_EQ(Result(), result);
        client.OnServerRestart();
    }
}

TEST_F(SdoClientAnswersTest, ABlockSizeThatIsNoneIsTheGreatestOne)
{
    Verifies(req::SRS_SDC_004);
    for (const std::uint8_t size : Octets{0U, 128U, 255U})
    {
        KeepingSink sink{};
        SdoClient other{SdoClientParts{sink, NodeId{5U}, 1000U, size}};
        EXPECT_TRUE(other.StartUpload({0x2103U, 0U}, Room{got.data(), 8U}, SdoMode::kBlock, Instant{now_us}));
        EXPECT_EQ(sink.Next(), (Octets{0xA4U, 0x03U, 0x21U, 0U, 127U, 0U, 0U, 0U})) << int{size};
    }
}

TEST_F(SdoClientAnswersTest, AMarkThatAServerHasIsOneToo)
{
    Verifies(req::SRS_SDC_008);
    // Given a transfer that was given up, so that the next one begins with a mark
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    client.Cancel(SdoAbort::kGeneral);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    const Octets mark{0x40U, 0x00U, 0x10U, 1U, 0U, 0U, 0U, 0U};
    requests.frames.erase(requests.frames.begin(), requests.frames.begin() + 2);
    EXPECT_EQ(requests.Next(), mark);
    // What is neither its value nor its abort is no answer to it
    Answer({0x60U, 0x00U, 0x10U, 1U});
    EXPECT_TRUE(requests.frames.empty());
    // A value in one frame needs no abort
    Answer({0x4FU, 0x00U, 0x10U, 1U, 9U});
    EXPECT_EQ(requests.Next(), (Octets{0x40U, 0x03U, 0x21U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(requests.frames.empty());
}

TEST_F(SdoClientAnswersTest, AMarkOfSegmentsIsAbortedBeforeTheRequestAlsoWhereTheSinkIsFull)
{
    Verifies(req::SRS_SDC_008);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    client.Cancel(SdoAbort::kGeneral);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    requests.frames.clear();
    requests.room = 0;
    Answer({0x41U, 0x00U, 0x10U, 1U, 20U});
    client.OnCycle(Instant{now_us});
    EXPECT_TRUE(requests.frames.empty());
    requests.room = 9;
    client.OnCycle(Instant{now_us});
    EXPECT_EQ(requests.Next(), AbortOf(0x1000U, 1U, 0x08000000U));
    EXPECT_EQ(requests.Next(), (Octets{0x40U, 0x03U, 0x21U, 0U, 0U, 0U, 0U, 0U}));
}

TEST_F(SdoClientAnswersTest, WhatWaitsBehindAnAbortIsGivenUpWithoutAFrame)
{
    Verifies(req::SRS_SDC_009);
    // Given an abort that the sink does not take, and a transfer behind it
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    requests.frames.clear();
    requests.room = 0;
    client.Cancel(SdoAbort::kGeneral);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    client.OnCycle(Instant{now_us});
    Answer({0x4FU, 0x03U, 0x21U, 0U, 1U}); // It was not asked for.
    EXPECT_EQ(Result(), 0xFFFFFFFFU);
    client.Cancel(SdoAbort::kDeviceState);
    EXPECT_EQ(Result(), 0x08000022U);
    // Then the server is told of the first one alone
    requests.room = 9;
    client.OnCycle(Instant{now_us});
    EXPECT_EQ(requests.Next(), AbortOf(0x2105U, 0U, 0x08000000U));
    EXPECT_TRUE(requests.frames.empty());
}

TEST_F(SdoClientAnswersTest, AnAnswerBetweenSegmentsOfABlockThatTheSinkDoesNotTakeEndsIt)
{
    Verifies(req::SRS_SDC_007);
    requests.room = 2;
    EXPECT_TRUE(Download(0x2103U, Octets(40U, 1U), SdoMode::kBlock));
    Answer({0xA4U, 0x03U, 0x21U, 0U, 4U});
    EXPECT_EQ(requests.frames.size(), 2U); // The request and one segment; the others wait.
    Answer({0x60U, 0x03U, 0x21U});
    EXPECT_EQ(Result(), 0x05040001U);
}

TEST(SdoParametersTest, IdentifiersAtTheEdgesOfTheDefaultServers)
{
    Verifies(req::SRS_SDC_011);
    struct Case
    {
        std::uint8_t sub;
        std::uint32_t identifier;
        SdoAbort of_client;
        SdoAbort of_server;
    };
    // 600h and 580h are of no node, and free; 680h as well; 6E0h is of no service that may be configured
    const SdoAbort none = SdoAbort::kNone;
    const SdoAbort range = SdoAbort::kValueRange;
    const Case cases[] = {{1U, 0x600U, none, none},  {1U, 0x601U, none, range},  {1U, 0x67FU, none, range},
                          {1U, 0x680U, none, none},  {1U, 0x581U, range, range}, {1U, 0x6E0U, range, range},
                          {2U, 0x580U, none, none},  {2U, 0x581U, none, range},  {2U, 0x5FFU, none, range},
                          {2U, 0x601U, range, range}};
    for (const Case& one : cases)
    {
        SdoParameters client{};
        SdoParameters server{};
        EXPECT_EQ(StoreSdo(client, SdoSide::kClient, one.sub, one.identifier), one.of_client) << one.identifier;
        EXPECT_EQ(StoreSdo(server, SdoSide::kServer, one.sub, one.identifier), one.of_server) << one.identifier;
    }
}

TEST(SdoParametersTest, WhatIsOnIsLoadedOverAndNotWrittenOver)
{
    Verifies(req::SRS_OBD_016);
    Verifies(req::SRS_SDC_011);
    SdoParameters client{};
    for (const std::uint8_t sub : Octets{1U, 2U})
    {
        const std::uint32_t base = (sub == 1U) ? 0x600U : 0x580U;
        EXPECT_EQ(StoreSdo(client, SdoSide::kClient, sub, base + 1U), SdoAbort::kNone);
        EXPECT_EQ(StoreSdo(client, SdoSide::kClient, sub, base + 2U), SdoAbort::kValueRange);
        EXPECT_EQ(LoadSdo(client, SdoSide::kClient, sub, base + 3U), SdoAbort::kNone);
        EXPECT_EQ(FetchSdo(client, sub).value, base + 3U);
        EXPECT_EQ(LoadSdo(client, SdoSide::kClient, sub, 0x701U), SdoAbort::kValueRange);
        EXPECT_EQ(FetchSdo(client, sub).value, base + 3U);
    }
    EXPECT_EQ(StoreSdo(client, SdoSide::kClient, 4U, 1U), SdoAbort::kSubUnknown);
}

} // namespace
} // namespace counterpoint::cia301
