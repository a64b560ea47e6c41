// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/sdo_pool.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

#include <array>

namespace counterpoint::cia302
{
namespace
{

using cia301::KeepingSink;
using cia301::Octets;

constexpr ObjectAddress kVendor{0x1018U, 1U};
constexpr ObjectAddress kType{0x1000U, 0U};

/// Two lanes, 100 ms, 3 tries.
class SdoPoolTest : public ::testing::Test
{
  public:
    [[nodiscard]] Instant Now() const
    {
        return Instant{0xFFFF'FF00U + (1000U * ms)};
    }
    void After(std::uint32_t time_ms)
    {
        for (std::uint32_t i = 0U; i < time_ms; ++i)
        {
            ++ms;
            pool.OnCycle(Now());
        }
    }
    bool Upload(std::uint8_t node, const ObjectAddress& object)
    {
        return pool.Upload(NodeId{node}, object, Room{value[node].data(), 4U}, SdoMode::kNormal, Now());
    }
    void Answer(std::uint8_t node, const Octets& bytes)
    {
        CanFrame frame{0x580U + node, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(bytes.begin(), bytes.end(), frame.data);
        pool.OnFrame(frame, Now());
    }

    std::uint32_t ms{0U};
    KeepingSink sink{};
    std::array<std::array<std::uint8_t, 4>, 10> value{};
    SdoLanes<2> lanes{sink, SdoTimes{100'000U, 3U}};
    SdoPool pool{lanes.All(), SdoTimes{100'000U, 3U}};
};

TEST_F(SdoPoolTest, SlavesAreServedAtTheSameTime)
{
    Verifies(req::SRS_NMM_030);
    EXPECT_TRUE(Upload(1U, kType));
    EXPECT_TRUE(Upload(2U, kVendor));
    EXPECT_FALSE(Upload(1U, kVendor)); // Busy.
    EXPECT_EQ(sink.Next(), (Octets{0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(sink.identifier, 0x601U);
    EXPECT_EQ(sink.Next(), (Octets{0x40U, 0x18U, 0x10U, 1U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(sink.identifier, 0x602U);
    Answer(2U, {0x43U, 0x18U, 0x10U, 1U, 0x2AU, 0U, 0U, 0U});
    EXPECT_EQ(pool.State(NodeId{2U}), TransferState::kDone);
    EXPECT_EQ(value[2][0], 0x2AU);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kBusy);
    Answer(1U, {0x43U, 0x00U, 0x10U, 0U, 0x91U, 0x01U, 0U, 0U});
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kDone);
    EXPECT_EQ(pool.State(NodeId{3U}), TransferState::kIdle);
}

TEST_F(SdoPoolTest, ATransferIsTriedOnceIfItsUserSaysSo)
{
    Verifies(req::SRS_NMM_031);
    EXPECT_TRUE(Upload(1U, kType));
    pool.TryOnce(NodeId{1U});
    pool.TryOnce(NodeId{9U}); // Has no lane.
    After(99U);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kBusy);
    After(1U);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(NodeId{1U}).abort, SdoAbort::kTimeOut);
    // The next one has all its tries again
    EXPECT_TRUE(Upload(1U, kType));
    After(299U);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kBusy);
    After(1U);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
}

TEST_F(SdoPoolTest, ALaneChangesHandsWhenItsOutcomeCouldBeTaken)
{
    Verifies(req::SRS_NMM_030);
    EXPECT_TRUE(Upload(7U, kType));
    EXPECT_TRUE(Upload(8U, kType));
    EXPECT_FALSE(Upload(9U, kType)); // No lane is free.
    Answer(7U, {0x43U, 0x00U, 0x10U, 0U, 0x91U, 0x01U, 0U, 0U});
    EXPECT_FALSE(Upload(9U, kType)); // Its outcome may not have been looked at.
    After(2U);
    EXPECT_TRUE(Upload(9U, kType));
    EXPECT_EQ(pool.State(NodeId{7U}), TransferState::kIdle);
    Answer(9U, {0x43U, 0x00U, 0x10U, 0U, 0x92U, 0x01U, 0U, 0U});
    EXPECT_EQ(value[9][0], 0x92U);
}

TEST_F(SdoPoolTest, SilenceIsTriedThreeTimes)
{
    Verifies(req::SRS_NMM_031);
    EXPECT_TRUE(Upload(1U, kVendor));
    After(299U);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kBusy);
    After(1U);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(NodeId{1U}).abort, SdoAbort::kTimeOut);
    EXPECT_FALSE(pool.Outcome(NodeId{1U}).by_server);
    // An answer to the second try is one
    EXPECT_TRUE(Upload(2U, kVendor));
    After(150U);
    const CanFrame mark = sink.frames.back(); // The second try begins with a mark, see SdoClient.
    Answer(2U, {0x80U, mark.data[1], mark.data[2], mark.data[3], 0x11U, 0x00U, 0x09U, 0x06U});
    Answer(2U, {0x43U, 0x18U, 0x10U, 1U, 0x2AU, 0U, 0U, 0U});
    EXPECT_EQ(pool.State(NodeId{2U}), TransferState::kDone);
}

TEST_F(SdoPoolTest, AnAbortAndABootUpMessageEndIt)
{
    Verifies(req::SRS_NMM_031);
    EXPECT_TRUE(Upload(1U, kVendor));
    Answer(1U, {0x80U, 0x18U, 0x10U, 1U, 0x00U, 0x00U, 0x02U, 0x06U});
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(NodeId{1U}).abort, SdoAbort::kObjectUnknown);
    EXPECT_TRUE(pool.Outcome(NodeId{1U}).by_server);
    const std::uint8_t four[4] = {1U, 2U, 3U, 4U};
    EXPECT_TRUE(pool.Download(NodeId{2U}, kVendor, Bytes{four, 4U}, SdoMode::kNormal, Now()));
    pool.OnBootUp(NodeId{2U});
    EXPECT_EQ(pool.State(NodeId{2U}), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(NodeId{2U}).abort, SdoAbort::kNoConnection);
    EXPECT_TRUE(Upload(1U, kVendor));
    pool.Cancel(NodeId{1U}, SdoAbort::kGeneral);
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(NodeId{1U}).abort, SdoAbort::kGeneral);
}

TEST_F(SdoPoolTest, LateAnswersAreNeverTakenForCurrentOnes)
{
    Verifies(req::SRS_NMM_032);
    // Given an upload of the vendor-ID that was given up after three tries
    EXPECT_TRUE(Upload(1U, kVendor));
    After(300U);
    ASSERT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
    // When the same object is asked for again, and the old answer (with another value) comes only now
    sink.frames.clear();
    EXPECT_TRUE(Upload(1U, kVendor));
    Answer(1U, {0x43U, 0x18U, 0x10U, 1U, 0xBAU, 0xD0U, 0U, 0U});
    Answer(1U, {0x43U, 0x18U, 0x10U, 1U, 0xBAU, 0xD1U, 0U, 0U});
    // Then it is nobody's answer
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kBusy);
    const CanFrame mark = sink.frames.back();
    Answer(1U, {0x80U, mark.data[1], mark.data[2], mark.data[3], 0x11U, 0x00U, 0x09U, 0x06U});
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kBusy);
    Answer(1U, {0x43U, 0x18U, 0x10U, 1U, 0x2AU, 0U, 0U, 0U});
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kDone);
    EXPECT_EQ(value[1][0], 0x2AU);
}

TEST_F(SdoPoolTest, FramesOfNobodyAndTriesOfZero)
{
    Verifies(req::SRS_NMM_031);
    SdoPool one{lanes.All(), SdoTimes{100'000U, 0U}};
    Answer(9U, {0x43U, 0x18U, 0x10U, 1U, 0x2AU, 0U, 0U, 0U});
    EXPECT_EQ(pool.Outcome(NodeId{9U}).abort, SdoAbort::kNoConnection);
    pool.OnBootUp(NodeId{9U});
    pool.Cancel(NodeId{9U}, SdoAbort::kGeneral);
    EXPECT_TRUE(one.Upload(NodeId{1U}, kVendor, Room{value[1].data(), 4U}, SdoMode::kNormal, Now()));
    one.OnCycle(Instant{Now().us + 100'000U});
    EXPECT_EQ(one.State(NodeId{1U}), TransferState::kFailed);
}

TEST_F(SdoPoolTest, NobodyElseHasALaneThatChangedHands)
{
    Verifies(req::SRS_NMM_030);
    EXPECT_TRUE(Upload(7U, kType));
    EXPECT_TRUE(Upload(8U, kType));
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kIdle);
    EXPECT_EQ(pool.State(NodeId{2U}), TransferState::kIdle);
    EXPECT_EQ(pool.State(NodeId{0U}), TransferState::kIdle);
    EXPECT_EQ(pool.State(NodeId{7U}), TransferState::kBusy);
    EXPECT_EQ(pool.State(NodeId{8U}), TransferState::kBusy);
    const std::uint8_t number[2] = {1U, 2U};
    EXPECT_FALSE(pool.Download(NodeId{7U}, kType, Bytes{number, 2U}, SdoMode::kNormal, Now()));
    EXPECT_FALSE(pool.Download(NodeId{9U}, kType, Bytes{number, 2U}, SdoMode::kNormal, Now()));
}

TEST_F(SdoPoolTest, ATimeOutThatTheServerTellsIsNoSilence)
{
    Verifies(req::SRS_NMM_031);
    EXPECT_TRUE(Upload(1U, kVendor));
    Answer(1U, {0x80U, 0x18U, 0x10U, 1U, 0U, 0U, 0x04U, 0x05U}); // 0504 0000h
    EXPECT_EQ(pool.State(NodeId{1U}), TransferState::kFailed);
    EXPECT_EQ(pool.Outcome(NodeId{1U}).abort, SdoAbort::kTimeOut);
    EXPECT_TRUE(pool.Outcome(NodeId{1U}).by_server);
    EXPECT_EQ(sink.frames.size(), 1U); // Not asked again.
}

TEST_F(SdoPoolTest, BusyUntilATimeOutBehindTheLastTransfer)
{
    Verifies(req::SRS_NMM_030);
    EXPECT_EQ(pool.TimeOutUs(), 100'000U);
    EXPECT_FALSE(pool.IsBusy());
    EXPECT_TRUE(Upload(1U, kVendor));
    After(1U);
    EXPECT_TRUE(pool.IsBusy());
    Answer(1U, {0x43U, 0x18U, 0x10U, 1U, 0x2AU, 0U, 0U, 0U});
    After(99U);
    EXPECT_TRUE(pool.IsBusy());
    After(1U);
    EXPECT_FALSE(pool.IsBusy());
}

} // namespace
} // namespace counterpoint::cia302
