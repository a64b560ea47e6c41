// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Silence, late answers, and frames that are none.
#include "tests/canopen/cia301/sdo_client_rig.hpp"
#include "verification/trace/ids/cia301.hpp"

#include <algorithm>
#include <random>

namespace counterpoint::cia301
{
namespace
{

class SdoClientTimeTest : public SdoClientRig
{
  public:
    Octets Cycle()
    {
        client.OnCycle(Instant{now_us});
        return requests.Next();
    }
};

TEST_F(SdoClientTimeTest, SilenceEndsATransferInEveryPhase)
{
    Verifies(req::SRS_SDC_006);
    const std::vector<std::vector<Octets>> uploads{
        {}, {{0x41U, 0x03U, 0x21U, 0U, 99U}}, {{0x41U, 0x03U, 0x21U, 0U, 99U}, {0x00U}}};
    const std::vector<std::vector<Octets>> block_uploads{
        {}, {{0xC6U, 0x03U, 0x21U, 0U, 99U}}, {{0xC6U, 0x03U, 0x21U, 0U, 7U}, {0x81U}}};
    const std::vector<std::vector<Octets>> downloads{{}, {{0x60U, 0x03U, 0x21U}}, {{0x60U, 0x03U, 0x21U}, {0x20U}}};
    const std::vector<std::vector<Octets>> block_downloads{
        {}, {{0xA4U, 0x03U, 0x21U, 0U, 127U}}, {{0xA4U, 0x03U, 0x21U, 0U, 127U}, {0xA2U, 5U, 127U}}};
    const auto run = [this](const std::vector<std::vector<Octets>>& cases, bool is_upload, SdoMode mode)
    {
        for (const std::vector<Octets>& answers_before : cases)
        {
            EXPECT_TRUE(is_upload ? Upload(0x2103U, mode) : Download(0x2103U, Octets(30U), mode));
            for (const Octets& answer : answers_before)
            {
                now_us += 900U;
                Answer(answer);
            }
            requests.frames.clear();
            now_us += 999U;
            EXPECT_TRUE(Cycle().empty());
            now_us += 1U;
            EXPECT_EQ(Cycle(), AbortOf(0x2103U, 0U, 0x05040000U)) << answers_before.size();
            EXPECT_EQ(Result(), 0x05040000U);
            EXPECT_FALSE(client.Outcome().by_server);
            client.OnServerRestart();
        }
    };
    run(uploads, true, SdoMode::kNormal);
    run(block_uploads, true, SdoMode::kBlock);
    run(downloads, false, SdoMode::kNormal);
    run(block_downloads, false, SdoMode::kBlock);
}

TEST_F(SdoClientTimeTest, ASubBlockThatStopsIsAcknowledgedOnce)
{
    Verifies(req::SRS_SDC_006);
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kBlock));
    Answer({0xC6U, 0x03U, 0x21U, 0U, 99U});
    Answer({0x01U});
    Answer({0x02U});
    requests.frames.clear();
    now_us += 499U;
    EXPECT_TRUE(Cycle().empty());
    now_us += 1U;
    EXPECT_EQ(Cycle(), (Octets{0xA2U, 2U, 5U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0x01U});
    now_us += 500U;
    EXPECT_TRUE(Cycle().empty());
    now_us += 500U;
    EXPECT_EQ(Cycle(), AbortOf(0x2103U, 0U, 0x05040000U));
}

TEST_F(SdoClientTimeTest, ASinkWithoutRoomDelaysAndIsNeverSkipped)
{
    Verifies(req::SRS_SDC_006);
    requests.room = 0;
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    now_us += 900U;
    EXPECT_TRUE(Cycle().empty());
    requests.room = 1;
    EXPECT_EQ(Cycle()[0], 0x40U);
    now_us += 999U;
    EXPECT_TRUE(Cycle().empty());
    Answer({0x4BU, 0x05U, 0x21U, 0U, 1U, 2U});
    EXPECT_EQ(Result(), 0U);
    // The abort of one transfer leaves before the request of the next one
    requests.room = 1;
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    static_cast<void>(requests.Next());
    client.Cancel(SdoAbort::kGeneral);
    client.OnCycle(Instant{now_us});
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    EXPECT_TRUE(requests.frames.empty());
    requests.room = 9;
    EXPECT_EQ(Cycle(), AbortOf(0x2105U, 0U, 0x08000000U));
    EXPECT_EQ(requests.Next(), (Octets{0x40U, 0x00U, 0x10U, 1U, 0U, 0U, 0U, 0U}));
    // A sink that stays full ends it too
    requests.room = 0;
    Answer({0x80U, 0x00U, 0x10U, 1U, 0x11U, 0x00U, 0x09U, 0x06U});
    now_us += 1000U;
    client.OnCycle(Instant{now_us});
    EXPECT_EQ(Result(), 0x05040000U);
}

TEST_F(SdoClientTimeTest, WhatIsNoAnswerIsIgnored)
{
    Verifies(req::SRS_SDC_007);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    CanFrame frame{0x586U, FrameKind::kData, CanPortId::kFirst, 8U, {0x4BU, 0x05U, 0x21U, 0U, 1U, 2U}};
    client.OnFrame(frame, Instant{now_us}); // of another server
    frame.identifier = 0x585U;
    frame.length_bytes = 7U;
    client.OnFrame(frame, Instant{now_us});
    frame.length_bytes = 8U;
    frame.kind = FrameKind::kRemote;
    client.OnFrame(frame, Instant{now_us});
    Answer({0x4BU, 0x06U, 0x21U, 0U, 1U, 2U}); // index
    Answer({0x4BU, 0x05U, 0x21U, 1U, 1U, 2U}); // sub-index
    Answer({0x80U, 0x05U, 0x22U, 0U, 0U, 0U, 0U, 8U});
    Answer({0x60U, 0x05U, 0x21U, 0U});
    Answer({0xA4U, 0x05U, 0x21U, 0U, 9U});
    Answer({0x00U, 0x05U, 0x21U, 0U});
    EXPECT_EQ(Result(), 0xFFFFFFFFU);
    Answer({0x4BU, 0x05U, 0x21U, 0U, 1U, 2U});
    EXPECT_EQ(Result(), 0U);
    Answer({0x4BU, 0x05U, 0x21U, 0U, 3U, 4U}); // nobody asked
    EXPECT_EQ(got[0], 1U);
    // A server that forgot the transfer names no object
    EXPECT_TRUE(Upload(0x2103U, SdoMode::kNormal));
    Answer({0x41U, 0x03U, 0x21U, 0U, 9U});
    Answer({0x80U, 0x07U, 0x21U, 0U, 0x01U, 0U, 0x04U, 0x05U});
    EXPECT_EQ(Result(), 0xFFFFFFFFU);
    Answer({0x80U, 0U, 0U, 0U, 0x01U, 0U, 0x04U, 0x05U});
    EXPECT_EQ(Result(), 0x05040001U);
}

// The same object twice: the late answer to the first request must not become the answer to the second one.
//
// client   40 2105          80 (time-out)   40 1000:01              40 2105
// server          (slow)                        4B 2105   80 1000:01        4B 2105
TEST_F(SdoClientTimeTest, ALateAnswerIsNotTakenForTheNextOne)
{
    Verifies(req::SRS_SDC_008);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    now_us += 1000U;
    client.OnCycle(Instant{now_us});
    EXPECT_EQ(Result(), 0x05040000U);
    requests.frames.clear();
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_EQ(requests.Next(), (Octets{0x40U, 0x00U, 0x10U, 1U, 0U, 0U, 0U, 0U}));
    Answer({0x4BU, 0x05U, 0x21U, 0U, 0xAAU, 0xAAU});               // late
    Answer({0x80U, 0x05U, 0x21U, 0U, 0x00U, 0x00U, 0x04U, 0x05U}); // and its abort
    Answer({0x40U, 0x05U, 0x21U, 0U});                             // a segment that looks like an answer
    EXPECT_TRUE(requests.frames.empty());
    Answer({0x80U, 0x00U, 0x10U, 1U, 0x11U, 0x00U, 0x09U, 0x06U});
    EXPECT_EQ(requests.Next(), (Octets{0x40U, 0x05U, 0x21U, 0U, 0U, 0U, 0U, 0U}));
    Answer({0x4BU, 0x05U, 0x21U, 0U, 0x34U, 0x12U});
    EXPECT_EQ(Result(), 0U);
    EXPECT_EQ(got[0], 0x34U);
    // From now on there is no doubt
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_EQ(requests.Next()[1], 0x05U);
    // After a boot-up message there is none either
    client.Cancel(SdoAbort::kGeneral);
    client.OnServerRestart();
    requests.frames.clear();
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_EQ(requests.Next()[1], 0x05U);
    client.OnServerRestart();
    EXPECT_EQ(Result(), 0x060A0023U);
}

TEST_F(SdoClientTimeTest, EachMarkIsLikeNoOtherOfTheLast254)
{
    Verifies(req::SRS_SDC_008);
    EXPECT_TRUE(client.StartUpload({0x1000U, 3U}, Room{got.data(), 9U}, SdoMode::kNormal, Instant{now_us}));
    std::vector<int> marks{};
    for (int i = 0; i < 260; ++i)
    {
        now_us += 1000U;
        client.OnCycle(Instant{now_us});
        requests.frames.clear();
        EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
        marks.push_back(requests.Next()[3]);
        EXPECT_EQ(requests.Next(), Octets{});
    }
    EXPECT_EQ(marks[0], 1);
    EXPECT_EQ(marks[1], 2);
    EXPECT_EQ(marks[2], 4); // 1000h:03 may still be answered
    EXPECT_EQ(marks[252], 254);
    EXPECT_EQ(marks[253], 1);
    // A server that has this sub-index is told that nobody wants its value
    Answer({0x41U, 0x00U, 0x10U, static_cast<std::uint8_t>(marks.back()), 9U});
    EXPECT_EQ(requests.Next(), AbortOf(0x1000U, static_cast<std::uint8_t>(marks.back()), 0x08000000U));
    EXPECT_EQ(requests.Next()[1], 0x05U);
}

TEST_F(SdoClientTimeTest, AServerThatIsReturnedToIsInDoubt)
{
    Verifies(req::SRS_SDC_008);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    now_us += 1000U;
    client.OnCycle(Instant{now_us});
    requests.frames.clear();
    EXPECT_TRUE(client.Connect(NodeId{6U}));
    EXPECT_TRUE(client.Connect(NodeId{5U}));
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_EQ(requests.Next()[1], 0x00U); // the mark
    // also after another server has cleared its own doubt
    client.OnServerRestart();
    EXPECT_TRUE(client.Connect(NodeId{6U}));
    client.OnServerRestart();
    EXPECT_TRUE(client.Connect(NodeId{5U}));
    requests.frames.clear();
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    EXPECT_EQ(requests.Next()[1], 0x00U);
}

TEST_F(SdoClientTimeTest, GivingUpTellsTheServer)
{
    Verifies(req::SRS_SDC_009);
    EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
    requests.frames.clear();
    client.Cancel(SdoAbort::kDeviceState);
    EXPECT_EQ(requests.Next(), AbortOf(0x2105U, 0U, 0x08000022U));
    EXPECT_EQ(client.State(), SdoClientState::kAborted);
    client.Cancel(SdoAbort::kDeviceState);
    EXPECT_TRUE(requests.frames.empty());
}

// A server that answers each request whole, in order, and after a random time, also beyond the client's time-out. Each
// value is new, so that a late answer is seen.
TEST_F(SdoClientTimeTest, SlowServersNeverGiveAnOldValue)
{
    Verifies(req::SRS_SDC_008);
    std::mt19937 random{20261121U};
    struct Slow
    {
        CanFrame frame;
        std::uint32_t at;
    };
    std::vector<Slow> under_way{};
    std::uint32_t last_at = now_us;
    int done = 0;
    int late = 0;
    std::uint16_t asked_from = 0U;
    std::uint16_t value = 1U;
    for (int step = 0; step < 200000; ++step)
    {
        if (client.State() != SdoClientState::kBusy)
        {
            late += (client.State() == SdoClientState::kAborted) ? 1 : 0;
            asked_from = value;
            EXPECT_TRUE(Upload(0x2105U, SdoMode::kNormal));
        }
        while (!requests.frames.empty())
        {
            u16 = {static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>(value >> 8U)};
            ++value;
            port.OnFrame(requests.frames.front(), Now());
            requests.frames.erase(requests.frames.begin());
        }
        while (!answers.frames.empty())
        {
            const auto at = static_cast<std::uint32_t>(now_us + 1U + (random() % 1600U));
            const bool is_after = static_cast<std::int32_t>(at - last_at) > 0;
            last_at = is_after ? at : last_at;
            under_way.push_back({answers.frames.front(), last_at});
            answers.frames.erase(answers.frames.begin());
        }
        now_us += 20U;
        while (!under_way.empty() && (static_cast<std::int32_t>(now_us - under_way.front().at) >= 0))
        {
            client.OnFrame(under_way.front().frame, Instant{now_us});
            under_way.erase(under_way.begin());
        }
        client.OnCycle(Instant{now_us});
        if (client.State() == SdoClientState::kDone)
        {
            ++done;
            const auto taken = static_cast<std::uint16_t>(got[0] | (got[1] << 8U));
            ASSERT_LT(static_cast<std::uint16_t>(taken - asked_from), 8U); // an older one is far above, modulo 2^16
        }
    }
    EXPECT_GT(done, 500);
    EXPECT_GT(late, 500);
}

// Both ways lose one frame in fifty. A transfer may fail, but what is done is right.
TEST_F(SdoClientTimeTest, AWireThatLosesFramesNeverGivesWrongData)
{
    Verifies(req::SRS_SDC_003);
    Verifies(req::SRS_SDC_004);
    Verifies(req::SRS_SDC_006);
    std::mt19937 random{7U};
    int done = 0;
    int repeated = 0;
    for (int round = 0; round < 400; ++round)
    {
        const bool is_upload = (round % 2) == 0;
        const SdoMode mode = ((round % 4) < 3) ? SdoMode::kBlock : SdoMode::kNormal;
        Octets value(1U + (random() % 300U));
        std::generate(value.begin(), value.end(), [&random] { return static_cast<std::uint8_t>(random() & 0xFFU); });
        if (is_upload)
        {
            std::copy(value.begin(), value.end(), domain.begin());
            domain_length = static_cast<std::uint32_t>(value.size());
        }
        ASSERT_TRUE(is_upload ? Upload(0x2103U, mode) : Download(0x2103U, value, mode));
        for (int step = 0; (step < 4000) && (Result() == 0xFFFFFFFFU); ++step)
        {
            now_us += 50U;
            client.OnCycle(Instant{now_us});
            port.OnCycle(Now());
            for (const CanFrame& frame : requests.frames)
            {
                repeated += (frame.data[0] == 0xA2U) && (frame.data[1] < 5U) && (round % 4 == 0) ? 1 : 0;
                if ((random() % 50U) != 0U)
                {
                    port.OnFrame(frame, Now());
                }
            }
            requests.frames.clear();
            for (const CanFrame& frame : answers.frames)
            {
                if ((random() % 50U) != 0U)
                {
                    client.OnFrame(frame, Instant{now_us});
                }
            }
            answers.frames.clear();
        }
        ASSERT_NE(Result(), 0xFFFFFFFFU) << round;
        if (Result() == 0U)
        {
            ++done;
            const auto* const from = is_upload ? got.data() : domain.data();
            ASSERT_EQ(is_upload ? client.Outcome().size_bytes : domain_length, value.size()) << round;
            ASSERT_EQ(Octets(from, from + value.size()), value) << round;
        }
        now_us += 2000U; // the server's time-out, too
        port.OnCycle(Now());
        answers.frames.clear();
    }
    EXPECT_GT(done, 100);
    EXPECT_LT(done, 400);
    EXPECT_GT(repeated, 20);
}

} // namespace
} // namespace counterpoint::cia301
