// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A request, or a pair on its way, between the refreshes of both channels: counters that differ by a microsecond have
// them in two cycles.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

constexpr CommunicationIndex kProducer{0x1303U};

/// Node-ID 2, refresh 25 ms, cycle 1 ms: by the counter that is ahead the refreshes fall due in the cycles 1, 26, 51 of
/// OPERATIONAL, by the other one a cycle later.
class Refresh : public Rig
{
  protected:
    void OperateWithClocks(const std::uint32_t tolerance_us)
    {
        config.clock_tolerance_us = tolerance_us;
        Operate();
        ports.sent.clear();
    }
    InstantPair NowBehind(const std::uint32_t lag_us) const
    {
        return is_a_behind ? InstantPair{{now_us - lag_us}, {now_us}} : InstantPair{{now_us}, {now_us - lag_us}};
    }
    /// A cycle in which one counter is behind.
    void CycleBehind(const std::uint32_t lag_us)
    {
        now_us += 1000U - (now_us % 1000U);
        kernel.Cycle(CycleCall{NowBehind(lag_us), 0U, 0U});
    }
    void CyclesBehind(const std::uint32_t count, const std::uint32_t lag_us = 1U)
    {
        for (std::uint32_t cycle = 0U; cycle < count; ++cycle)
        {
            CycleBehind(lag_us);
        }
    }
    /// Both frames of the pair whose normal frame was handed over last are on the bus now.
    void ConfirmPair(const std::uint32_t lag_us = 1U)
    {
        ASSERT_FALSE(ports.sent.empty());
        kernel.OnConfirm(StampedFrame{ports.sent.back(), NowBehind(lag_us)});
        kernel.OnConfirm(StampedFrame{ports.sent.back(), NowBehind(lag_us)});
        ports.sent.clear();
    }

    bool is_a_behind{false};
};

// cycle     1    2         ...   26                 27                28 to 51   52
// A ahead   .    pair 1          refresh, Send      stands            .          pair 3
// B behind  .    pair 1          Send               refresh, pair 2   .
TEST_F(Refresh, RequestWaitsForTheChannelThatIsBehind)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_KRN_146);
    Verifies(req::SRS_KRN_017);
    for (const bool is_a : {false, true})
    {
        // Given a pair that was sent by the refresh of both channels in cycle 2, since one counter is behind
        is_a_behind = is_a;
        OperateWithClocks(100U);
        CycleBehind(1U);
        EXPECT_EQ(ports.sent.size(), 0U);
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        CyclesBehind(23U);
        // When the application asks for a pair in the cycle in which the refresh of one channel alone falls due
        EXPECT_EQ(kernel.Send(kProducer), Result::kSuccessful);
        CycleBehind(1U);
        // Then it waits for the other one's,
        EXPECT_EQ(ports.sent.size(), 0U);
        EXPECT_EQ(application.refreshed.size(), 1U);
        CycleBehind(1U);
        // and one pair is both the refresh of both and what was asked for
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        CyclesBehind(24U);
        EXPECT_EQ(ports.sent.size(), 0U);
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_EQ(application.errors.size(), 0U);
        application.refreshed.clear();
    }
}

// cycle     25           26               27               28               29
// asked     pair 2
// A ahead   on its way   refresh waits    waits, stands    pair 2 is over   pair 3
// B behind  on its way   .                refresh waits
TEST_F(Refresh, ThatFallsDueBesideAPairOnItsWayWaitsUntilItIsOver)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_PROD_013);
    for (const bool is_a : {false, true})
    {
        is_a_behind = is_a;
        OperateWithClocks(100U);
        CyclesBehind(2U);
        ConfirmPair();
        CyclesBehind(22U);
        // Given a pair that was asked for, is sent in cycle 25 and on its way
        EXPECT_EQ(kernel.Send(kProducer), Result::kSuccessful);
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        // When the refresh of one channel falls due beside it, then that of the other, and the pair is confirmed
        CycleBehind(1U);
        CycleBehind(1U);
        ConfirmPair();
        // Then the pair of the refresh follows, and none is missed
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        CyclesBehind(10U);
        EXPECT_EQ(ports.sent.size(), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_EQ(application.errors.size(), 0U);
    }
}

// cycle     25           26                27
// A ahead   on its way   refresh waits     pair 3
// B behind  on its way   .   (over)        refresh, pair 3
TEST_F(Refresh, ThatOneChannelAloneFoundAPairOnItsWayIsThatOfBoth)
{
    Verifies(req::SRS_KRN_145);
    for (const bool is_a : {false, true})
    {
        is_a_behind = is_a;
        OperateWithClocks(100U);
        CyclesBehind(2U);
        ConfirmPair();
        CyclesBehind(22U);
        EXPECT_EQ(kernel.Send(kProducer), Result::kSuccessful);
        CycleBehind(1U);
        // Given a pair on its way when the refresh of one channel falls due, that is over when the other one's does
        CycleBehind(1U);
        ConfirmPair();
        // When the next cycle comes, then both refresh
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        CyclesBehind(10U);
        EXPECT_EQ(ports.sent.size(), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_EQ(application.errors.size(), 0U);
    }
}

// SRVT 20 ms from cycle 2: by the counter that is behind, the confirmation of the normal frame in cycle 22 is in time;
// by the other one, which had gone on by a microsecond more, it is not.
TEST_F(Refresh, ConfirmationAtTheVeryLimitEndsInNoDeviceFault)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_KRN_147);
    Verifies(req::SRS_PROD_008);
    OperateWithClocks(100U);
    CyclesBehind(2U, 1U);
    CyclesBehind(19U, 2U);
    now_us += 1000U;
    const InstantPair limit{{now_us}, {now_us - 2U}};
    // Given a normal frame that is confirmed 20 ms after its cycle by A, and 19.999 ms by B
    kernel.OnConfirm(StampedFrame{ports.sent.back(), limit});
    // When the inverse frame is not confirmed for as long again, and a refresh falls due
    for (std::uint32_t cycle = 0U; cycle < 60U; ++cycle)
    {
        CycleBehind(2U);
    }
    // Then the causes are those of the SRDO
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    ASSERT_FALSE(CausesOf(0x1303U).empty());
    EXPECT_EQ(CausesOf(0x1303U)[0], SrdoCause::kNoConfirmation);
}

// Counters that part by 100 ppm for 100 s, and a Send every 50, 73 or 200 ms, each pair confirmed a cycle later
TEST_F(Refresh, CountersThatDriftApartAndRequestsAreNoDeviceFault)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_KRN_017);
    for (const std::uint32_t every : {50U, 73U, 200U})
    {
        OperateWithClocks(500U);
        std::uint32_t lag_us = 0U;
        for (std::uint32_t cycle = 1U; cycle <= 100000U; ++cycle)
        {
            if ((cycle % every) == 0U)
            {
                static_cast<void>(kernel.Send(kProducer));
            }
            lag_us = cycle / 10U;
            CycleBehind(lag_us);
            if (ports.sent.size() > 1U)
            {
                ports.sent.erase(ports.sent.begin());
                kernel.OnConfirm(StampedFrame{ports.sent.back(), NowBehind(lag_us)});
                ports.sent.clear();
            }
            else if (!ports.sent.empty())
            {
                kernel.OnConfirm(StampedFrame{ports.sent.back(), NowBehind(lag_us)});
            }
            else
            {
            }
            application.flow.clear(); // Of no interest here, and more than a target has room for.
            application.events.clear();
            application.refreshed.clear();
            ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << every << " " << cycle;
        }
        EXPECT_EQ(application.errors.size(), 0U) << every;
    }
}

// t       k to k+4            k+5, k+6
// B       its refresh never falls due; what is asked for each second cycle does not hide it
TEST_F(Refresh, ThatOneChannelNeverHasIsFoundWhateverIsAskedFor)
{
    Verifies(req::SRS_KRN_146);
    Verifies(req::SRS_CMP_008);
    for (const bool is_a : {false, true})
    {
        Operate();
        Tap& broken = is_a ? a : b;
        // Given a channel that has no refresh, so that it is due for what is asked for alone
        broken.on_outcome = [this](CycleOutcome& outcome)
        {
            outcome.refresh = 0U;
            outcome.due &= (now_us % 2000U == 0U) ? 2U : 0U;
        };
        std::uint32_t cycles = 0U;
        while ((kernel.DeviceState().fault == DeviceFault::kNone) && (cycles < 20U))
        {
            static_cast<void>(kernel.Send(kProducer));
            Cycle();
            ++cycles;
        }
        // Then nothing is sent, and the discrepancy time of 5 ms is over in the sixth cycle
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kUnmatched);
        EXPECT_EQ(cycles, 6U);
        EXPECT_TRUE(ports.sent.empty());
        broken.on_outcome = nullptr;
    }
}

} // namespace
} // namespace counterpoint
