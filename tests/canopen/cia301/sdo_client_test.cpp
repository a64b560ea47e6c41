// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/store/crc16.hpp"
#include "tests/canopen/cia301/sdo_client_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

namespace counterpoint::cia301
{
namespace
{

using SdoClientTest = SdoClientRig;

TEST_F(SdoClientTest, ExpeditedDownloadsOfOneToFourBytes)
{
    Verifies(req::SRS_SDC_001);
    const Octets heads{0x2FU, 0x2BU, 0x27U, 0x23U};
    for (std::size_t count = 1U; count <= 4U; ++count)
    {
        EXPECT_TRUE(Download(0x2103U, Octets{1U, 2U, 3U, 4U}, SdoMode::kNormal));
        static_cast<void>(requests.Next());
        client.Cancel(SdoAbort::kGeneral);
        client.OnServerRestart();
        requests.frames.clear();
        EXPECT_TRUE(Download(0x2103U, Octets(count, 7U), SdoMode::kNormal));
        Octets expected{heads[count - 1U], 0x03U, 0x21U, 0U, 0U, 0U, 0U, 0U};
        std::fill_n(expected.begin() + 4, count, std::uint8_t{7U});
        EXPECT_EQ(requests.Next(), expected);
        EXPECT_EQ(requests.identifier, 0x605U);
        Answer({0x60U, 0x03U, 0x21U});
        EXPECT_EQ(Result(), 0U);
        EXPECT_EQ(client.Outcome().size_bytes, count);
    }
}

TEST_F(SdoClientTest, ExpeditedUploads)
{
    Verifies(req::SRS_SDC_001);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_EQ(requests.frames[0].data[0], 0x40U);
    Carry();
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(client.State(), SdoClientState::kDone);
    EXPECT_EQ(client.Outcome().size_bytes, 2U);
    EXPECT_EQ(got[0], 0x34U);
    EXPECT_EQ(got[1], 0x12U);
    // A stated length of 1 to 4 bytes
    const Octets heads{0x4FU, 0x4BU, 0x47U, 0x43U};
    for (std::size_t count = 1U; count <= 4U; ++count)
    {
        std::fill(got.begin(), got.end(), std::uint8_t{0U});
        EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
        Answer({heads[count - 1U], 0x05U, 0x21U, 0U, 1U, 2U, 3U, 4U});
        EXPECT_EQ(client.Outcome().size_bytes, count);
        EXPECT_EQ(got[count - 1U], count);
        EXPECT_EQ(got[count], 0U);
    }
    // Without a stated length the room is the limit
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal, 3U));
    Answer({0x42U, 0x05U, 0x21U, 0U, 1U, 2U, 3U, 4U});
    EXPECT_EQ(client.Outcome().size_bytes, 3U);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    Answer({0x42U, 0x05U, 0x21U, 0U, 1U, 2U, 3U, 4U});
    EXPECT_EQ(client.Outcome().size_bytes, 4U);
    EXPECT_EQ(got[3], 4U);
}

TEST_F(SdoClientTest, EveryLengthArrivesWholeInBothModesAndDirections)
{
    Verifies(req::SRS_SDC_002);
    Verifies(req::SRS_SDC_003);
    Verifies(req::SRS_SDC_004);
    for (const SdoMode mode : {SdoMode::kNormal, SdoMode::kBlock})
    {
        for (const std::uint32_t size : {0U, 1U, 4U, 5U, 6U, 7U, 8U, 14U, 27U, 28U, 29U, 34U, 35U, 36U, 999U, 1000U})
        {
            Octets value(size);
            for (std::uint32_t i = 0U; i < size; ++i)
            {
                value[i] = static_cast<std::uint8_t>((i * 7U) + size);
            }
            EXPECT_TRUE(Download(0x2103U, value, mode));
            Carry();
            EXPECT_EQ(Result(), 0U) << size;
            EXPECT_EQ(domain_length, size);
            EXPECT_EQ(Octets(domain.begin(), domain.begin() + size), value);
            got.fill(0xEEU);
            EXPECT_TRUE(Upload(0x2103U, mode, size));
            Carry();
            EXPECT_EQ(Result(), 0U) << size;
            EXPECT_EQ(client.Outcome().size_bytes, size);
            EXPECT_EQ(Octets(got.begin(), got.begin() + size), value);
            EXPECT_EQ(got[size], 0xEEU);
        }
    }
}

TEST_F(SdoClientTest, AbortsOfTheServerComeBack)
{
    Verifies(req::SRS_SDC_007);
    EXPECT_TRUE(Upload(0x2999U, SdoMode::kNormal));
    Carry();
    EXPECT_EQ(Result(), 0x06020000U);
    EXPECT_TRUE(client.Outcome().by_server);
    EXPECT_TRUE(Download(0x1000U, {1U, 2U, 3U, 4U}, SdoMode::kNormal));
    Carry();
    EXPECT_EQ(Result(), 0x06010002U);
    EXPECT_TRUE(Upload(0x2999U, SdoMode::kBlock));
    Carry();
    EXPECT_EQ(Result(), 0x06020000U);
    // While one transfer runs no other starts
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_FALSE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_FALSE(Download(0x2105U, {1U}, SdoMode::kNormal));
    EXPECT_FALSE(client.Connect(NodeId{6U}));
    Carry();
    EXPECT_EQ(Result(), 0U);
    EXPECT_TRUE(client.Connect(NodeId{6U}));
    EXPECT_EQ(client.Server().value, 6U);
}

TEST_F(SdoClientTest, WrongTogglesAndLengthsEndATransfer)
{
    Verifies(req::SRS_SDC_002);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    Answer({0x41U, 0x03U, 0x21U, 0U, 9U});
    Answer({0x10U});
    EXPECT_EQ(Result(), 0x05030000U);
    client.OnServerRestart();
    requests.frames.clear();
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    Answer({0x41U, 0x03U, 0x21U, 0U, 9U});
    Answer({0x00U});
    Answer({0x19U}); // 3 bytes: 10 of 9
    EXPECT_EQ(Result(), 0x06070012U);
    client.OnServerRestart();
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    Answer({0x41U, 0x03U, 0x21U, 0U, 9U});
    Answer({0x01U}); // 7 of 9
    EXPECT_EQ(Result(), 0x06070013U);
    client.OnServerRestart();
    EXPECT_TRUE(Download(0x2103U, Octets(20U, 1U), SdoMode::kNormal));
    Answer({0x60U, 0x03U, 0x21U});
    Answer({0x30U});
    EXPECT_EQ(Result(), 0x05030000U);
    client.OnServerRestart();
    requests.frames.clear();
    EXPECT_TRUE(Download(0x2103U, Octets(20U, 1U), SdoMode::kNormal));
    Answer({0x60U, 0x03U, 0x21U});
    Answer({0x60U, 0x03U, 0x22U}); // no answer to a segment, nor the first one again
    EXPECT_EQ(Result(), 0x05040001U);
    static_cast<void>(requests.Next());
    static_cast<void>(requests.Next());
    EXPECT_EQ(requests.Next(), AbortOf(0x2103U, 0U, 0x05040001U));
}

TEST_F(SdoClientTest, TheRoomIsNeverLeft)
{
    Verifies(req::SRS_SDC_005);
    for (const SdoMode mode : {SdoMode::kNormal, SdoMode::kBlock})
    {
        domain_length = 20U;
        got.fill(0xEEU);
        EXPECT_TRUE(Upload(0x2103U, mode, 19U));
        Carry();
        EXPECT_EQ(Result(), 0x05040005U);
        EXPECT_EQ(got[0], 0xEEU); // with a stated length at once
        client.OnServerRestart();
    }
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal, 1U));
    Carry();
    EXPECT_EQ(Result(), 0x05040005U);
    // Without a stated length
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal, 13U));
    Answer({0x40U, 0x03U, 0x21U});
    Answer({0x00U});
    Answer({0x11U});
    EXPECT_EQ(Result(), 0x05040005U);
    client.OnServerRestart();
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock, 13U));
    Answer({0xC0U, 0x03U, 0x21U});
    Answer({0x01U, 1U, 1U, 1U, 1U, 1U, 1U, 1U});
    Answer({0x82U, 1U, 1U, 1U, 1U, 1U, 1U, 1U});
    Answer({0xC1U});
    EXPECT_EQ(Result(), 0x05040005U);
    EXPECT_EQ(got[13], 0xEEU);
}

TEST_F(SdoClientTest, BlockDownloadRepeatsWhatWasLost)
{
    Verifies(req::SRS_SDC_003);
    EXPECT_TRUE(Download(0x2103U, Octets{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U}, SdoMode::kBlock));
    EXPECT_EQ(requests.Next(), (Octets{0xC6U, 0x03U, 0x21U, 0U, 9U, 0U, 0U, 0U}));
    Answer({0xA4U, 0x03U, 0x21U, 0U, 4U});
    EXPECT_EQ(requests.Next(), (Octets{0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}));
    EXPECT_EQ(requests.Next(), (Octets{0x82U, 8U, 9U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0xA2U, 1U, 4U}); // the second was lost
    EXPECT_EQ(requests.Next(), (Octets{0x81U, 8U, 9U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0xA2U, 1U, 4U});
    const Octets end = requests.Next();
    EXPECT_EQ(end[0], 0xD5U);
    const std::uint8_t value[9] = {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U};
    EXPECT_EQ(end[1] | (end[2] << 8U), ContinueCrc(0U, {value, 9U}));
    Answer({0xA1U});
    EXPECT_EQ(Result(), 0U);
    // Sizes and acknowledgements that are none
    const Octets wrong[] = {{0xA4U, 0x03U, 0x21U, 0U, 0U}, {0xA4U, 0x03U, 0x21U, 0U, 128U}};
    for (const Octets& answer : wrong)
    {
        EXPECT_TRUE(Download(0x2103U, Octets(9U), SdoMode::kBlock));
        Answer(answer);
        EXPECT_EQ(Result(), 0x05040002U);
        client.OnServerRestart();
    }
    EXPECT_TRUE(Download(0x2103U, Octets(9U), SdoMode::kBlock));
    Answer({0xA4U, 0x03U, 0x21U, 0U, 4U});
    Answer({0xA2U, 3U, 4U});
    EXPECT_EQ(Result(), 0x05040003U);
    client.OnServerRestart();
    EXPECT_TRUE(Download(0x2103U, Octets(9U), SdoMode::kBlock));
    Answer({0xA4U, 0x03U, 0x21U, 0U, 4U});
    Answer({0xA2U, 1U, 0U});
    EXPECT_EQ(Result(), 0x05040002U);
}

TEST_F(SdoClientTest, AServerWithoutCrcGivesAndGetsNone)
{
    Verifies(req::SRS_SDC_003);
    Verifies(req::SRS_SDC_004);
    EXPECT_TRUE(Download(0x2103U, Octets{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U}, SdoMode::kBlock));
    EXPECT_EQ(requests.Next()[0], 0xC6U);
    Answer({0xA0U, 0x03U, 0x21U, 0U, 1U}); // No CRC, one segment a block.
    EXPECT_EQ(requests.Next(), (Octets{0x01U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}));
    EXPECT_TRUE(requests.frames.empty());
    Answer({0xA2U, 1U, 1U});
    EXPECT_EQ(requests.Next(), (Octets{0x81U, 8U, 9U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0xA2U, 1U, 1U});
    EXPECT_EQ(requests.Next(), (Octets{0xD5U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0xA1U});
    EXPECT_EQ(Result(), 0U);
    // What stands in the place of the CRC of an upload is nothing then
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
    Answer({0xC2U, 0x03U, 0x21U, 0U, 7U});
    Answer({0x81U, '1', '2', '3', '4', '5', '6', '7'});
    Answer({0xC1U, 0xFFU, 0xFFU});
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(got[6], '7');
}

TEST_F(SdoClientTest, AnEarlyAcknowledgementDropsASegmentThatStillWaits)
{
    Verifies(req::SRS_SDC_003);
    requests.room = 3;
    EXPECT_TRUE(
        Download(0x2103U, Octets{1U, 1U, 1U, 1U, 1U, 1U, 1U, 2U, 2U, 2U, 2U, 2U, 2U, 2U, 3U, 3U}, SdoMode::kBlock));
    Answer({0xA4U, 0x03U, 0x21U, 0U, 4U});
    EXPECT_EQ(requests.frames.size(), 3U); // request and two segments; the third waits
    requests.frames.clear();
    Answer({0xA2U, 1U, 4U});
    requests.room = 9;
    client.OnCycle(Instant{now_us});
    EXPECT_EQ(requests.Next(), (Octets{0x01U, 2U, 2U, 2U, 2U, 2U, 2U, 2U}));
    EXPECT_EQ(requests.Next(), (Octets{0x82U, 3U, 3U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_TRUE(requests.frames.empty());
}

TEST_F(SdoClientTest, BlockUploadAcknowledgesWhatCameInOrder)
{
    Verifies(req::SRS_SDC_004);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
    EXPECT_EQ(requests.Next(), (Octets{0xA4U, 0x03U, 0x21U, 0U, 5U, 0U, 0U, 0U}));
    Answer({0xC6U, 0x03U, 0x21U, 0U, 9U});
    EXPECT_EQ(requests.Next()[0], 0xA3U);
    Answer({0x82U, '8', '9'}); // the first was lost
    EXPECT_EQ(requests.Next(), (Octets{0xA2U, 0U, 5U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0x01U, '1', '2', '3', '4', '5', '6', '7'});
    Answer({0x01U, 9U}); // doubled
    Answer({0x82U, '8', '9'});
    EXPECT_EQ(requests.Next(), (Octets{0xA2U, 2U, 5U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0xD5U, 0xC3U, 0x31U});
    EXPECT_EQ(requests.Next()[0], 0xA1U);
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(got[8], '9');
    // A wrong CRC, a number beyond the block, more than stated
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
    Answer({0xC6U, 0x03U, 0x21U, 0U, 7U});
    Answer({0x81U, '1', '2', '3', '4', '5', '6', '7'});
    Answer({0xC1U, 0xFFU, 0xFFU});
    EXPECT_EQ(Result(), 0x05040004U);
    for (const std::uint8_t number : Octets{0U, 6U, 0x86U})
    {
        client.OnServerRestart();
        EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
        Answer({0xC6U, 0x03U, 0x21U, 0U, 7U});
        Answer({number});
        EXPECT_EQ(Result(), 0x05040003U);
    }
    client.OnServerRestart();
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
    Answer({0xC6U, 0x03U, 0x21U, 0U, 7U});
    Answer({0x01U});
    Answer({0x02U});
    EXPECT_EQ(Result(), 0x06070012U);
    // A server may answer as to a normal upload
    client.OnServerRestart();
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
    Answer({0x4FU, 0x03U, 0x21U, 0U, 0x77U});
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(got[0], 0x77U);
}

} // namespace
} // namespace counterpoint::cia301
