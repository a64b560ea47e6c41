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

/// Node-ID 2, refresh 25 ms, cycle 1 ms. The first pair leaves in cycle 1 of OPERATIONAL, by equal counters; from then
/// on one counter is a microsecond behind: the refreshes fall due in cycle 26 by the one that is ahead, in 27 by the
/// other.
class Refresh : public Rig
{
  protected:
    void OperateWithClocks(const std::uint32_t tolerance_us)
    {
        config.clock_tolerance_us = tolerance_us;
        Operate();
        ports.sent.clear();
        application.refreshed.clear();
        application.errors.clear();
        Cycle();
        ASSERT_EQ(ports.sent.size(), 1U);
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

// cycle     1        ...   25   26                27                28 to 51   52
// ahead     pair 1         .    refresh, Send     waits, stands     .          pair 3
// behind    pair 1         .    Send              refresh, pair 2   .
TEST_F(Refresh, RequestWaitsForTheChannelThatIsBehind)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_KRN_146);
    Verifies(req::SRS_KRN_017);
    for (const bool is_a : {false, true})
    {
        // Given a pair that was sent by the refresh of both channels
        is_a_behind = is_a;
        OperateWithClocks(100U);
        ConfirmPair(0U);
        CyclesBehind(24U);
        EXPECT_EQ(ports.sent.size(), 0U);
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
        EXPECT_TRUE(CausesOf(0x1303U).empty());
    }
}

// since pair 1   25 ms            26.5 ms          48.501 ms   50.001 ms        51.499 ms        52 ms
// ahead          refresh, waits   pair 2, moved    .           .                .                refresh, pair 3
// behind         .                refresh          .           refresh, waits   stands           waits
TEST_F(Refresh, TwoLateCyclesOfDiscrepancyHoldWhatStandingMovesThePhases)
{
    Verifies(req::SRS_KRN_310);
    const auto cycle_at = [this](const std::uint32_t instant_us)
    {
        now_us = instant_us;
        kernel.Cycle(CycleCall{NowBehind(1U), 0U, 0U});
    };
    for (const bool is_a : {false, true})
    {
        // Given calls of which some are as late as allowed, one of them while one channel alone stands
        is_a_behind = is_a;
        config.discrepancy_us = 3000U;
        OperateWithClocks(100U);
        ConfirmPair(0U);
        const std::uint32_t first_us = now_us;
        CyclesBehind(25U);
        EXPECT_EQ(ports.sent.size(), 0U);
        cycle_at(first_us + 26500U);
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        for (std::uint32_t cycle_us = 27500U; cycle_us <= 47500U; cycle_us += 1000U)
        {
            cycle_at(first_us + cycle_us);
        }
        // When the next refresh of the other one falls due as early, and as late after a call, as it may
        for (const std::uint32_t cycle_us : std::initializer_list<std::uint32_t>{48501U, 50001U, 51000U, 51499U})
        {
            cycle_at(first_us + cycle_us);
            EXPECT_EQ(ports.sent.size(), 0U) << cycle_us;
        }
        // Then they wait for each other without a device fault
        cycle_at(first_us + 52000U);
        EXPECT_EQ(ports.sent.size(), 1U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_TRUE(CausesOf(0x1303U).empty());
    }
}

// cycle     24           25           26               27               28
// asked     pair 2
// ahead     on its way   on its way   refresh waits    waits, stands    pair 2 was confirmed: pair 3
// behind    on its way   on its way   .                refresh waits
TEST_F(Refresh, ThatFallsDueBesideAPairOnItsWayWaitsUntilItIsOver)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_PROD_013);
    for (const bool is_a : {false, true})
    {
        is_a_behind = is_a;
        OperateWithClocks(100U);
        ConfirmPair(0U);
        CyclesBehind(22U);
        // Given a pair that was asked for, and is on its way
        EXPECT_EQ(kernel.Send(kProducer), Result::kSuccessful);
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        // When the refresh of one channel falls due beside it, then that of the other, and the pair is confirmed
        CyclesBehind(3U);
        EXPECT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        // Then the pair of the refresh follows, and none is missed
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        CyclesBehind(10U);
        EXPECT_EQ(ports.sent.size(), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_TRUE(CausesOf(0x1303U).empty());
    }
}

// cycle     25           26                       27
// ahead     on its way   refresh waits, is over   stands, pair 3
// behind    on its way   .              is over   refresh, pair 3
TEST_F(Refresh, ThatOneChannelAloneFoundAPairOnItsWayIsThatOfBoth)
{
    Verifies(req::SRS_KRN_145);
    for (const bool is_a : {false, true})
    {
        is_a_behind = is_a;
        OperateWithClocks(100U);
        ConfirmPair(0U);
        CyclesBehind(23U);
        EXPECT_EQ(kernel.Send(kProducer), Result::kSuccessful);
        CycleBehind(1U);
        ASSERT_EQ(ports.sent.size(), 1U);
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
        EXPECT_TRUE(CausesOf(0x1303U).empty());
    }
}

// SRVT 20 ms from cycle 1: by the counter that is ahead the confirmation of the normal frame comes 20.001 ms after it,
// by the other one 20.000 ms.
TEST_F(Refresh, ConfirmationAtTheVeryLimitEndsInNoDeviceFault)
{
    Verifies(req::SRS_KRN_147);
    Verifies(req::SRS_PROD_008);
    for (const bool is_a : {false, true})
    {
        is_a_behind = is_a;
        OperateWithClocks(100U);
        CyclesBehind(20U);
        // Given a normal frame that is confirmed in time by one counter alone
        now_us += 1U;
        kernel.OnConfirm(StampedFrame{ports.sent.back(), NowBehind(1U)});
        EXPECT_EQ(ports.sent.size(), 1U);
        for (Tap* const tap : {&a, &b})
        {
            EXPECT_EQ(tap->transmit_faults, std::vector<SrdoCause>{SrdoCause::kNoConfirmation});
            EXPECT_EQ(tap->given_up, 1U);
            tap->transmit_faults.clear();
        }
        // When a refresh falls due, which may be before the inverse frame would be late
        CyclesBehind(5U);
        EXPECT_EQ(ports.sent.size(), 1U);
        CyclesBehind(1U);
        // Then it is sent in time, and the cause is that of the SRDO
        EXPECT_EQ(ports.sent.size(), 2U);
        ConfirmPair();
        CyclesBehind(10U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kNoConfirmation});
    }
}

// A slot that does not exist is given up nowhere.
TEST_F(Refresh, HalfAConfirmationOfASlotThatDoesNotExistHasNoEffect)
{
    Verifies(req::SRS_KRN_147);
    for (const bool is_a : {false, true})
    {
        OperateWithClocks(100U);
        Tap& broken = is_a ? a : b;
        Tap& other = is_a ? b : a;
        // Given one channel that tells the confirmation of a slot behind the last, and another that tells none
        broken.on_confirmed = [](Confirmation& confirmation) { confirmation = {3U, ConfirmStep::kNormal}; };
        other.on_confirmed = [](Confirmation& confirmation) { confirmation = {kNoSlot, ConfirmStep::kNone}; };
        kernel.OnConfirm(StampedFrame{ports.sent.back(), NowBehind(0U)});
        broken.on_confirmed = nullptr;
        other.on_confirmed = nullptr;
        // Then nothing follows, and nobody has given up a pair
        EXPECT_EQ(ports.sent.size(), 1U);
        EXPECT_TRUE(a.transmit_faults.empty());
        EXPECT_TRUE(b.transmit_faults.empty());
        Cycle();
        EXPECT_TRUE(CausesOf(0x1303U).empty());
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
}

// cycle     26 to 50            51 (late by 0.5 ms)        52
// provider  not ready           ready                      ready
// A         waits since 26      .                          next one missed, pair 2
// B         waits since 27      next one missed            stands, pair 2
// The counter that was ahead in cycle 26 stood, and is the later one in 51 (the other way round where B is ahead).
TEST_F(Refresh, ThatIsMissedInOneChannelAloneWaitsUntilItIsInBoth)
{
    Verifies(req::SRS_KRN_148);
    Verifies(req::SRS_KRN_145);
    for (const bool is_a : {false, true})
    {
        // Given a refresh that waits in both channels for a provider that is not ready
        is_a_behind = is_a;
        OperateWithClocks(100U);
        ConfirmPair(0U);
        CyclesBehind(24U);
        application.refresh = RefreshAnswer::kSkip;
        CyclesBehind(25U);
        const int stands_a = a.stands;
        const int stands_b = b.stands;
        // When it is ready in the call in which the next refresh falls due by one counter alone
        application.refresh = RefreshAnswer::kReady;
        now_us += 1500U;
        kernel.Cycle(CycleCall{NowBehind(1U), 0U, 0U});
        // Then nothing is sent yet,
        EXPECT_EQ(ports.sent.size(), 0U);
        EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kRefreshMissed});
        // the channel that missed it first stands, and the pair is sent when both have missed it,
        CycleBehind(1U);
        EXPECT_EQ(a.stands - stands_a, is_a ? 1 : 0);
        EXPECT_EQ(b.stands - stands_b, is_a ? 0 : 1);
        ASSERT_EQ(ports.sent.size(), 1U);
        ConfirmPair();
        // and the next one a refresh time later
        CyclesBehind(24U);
        EXPECT_EQ(ports.sent.size(), 0U);
        CycleBehind(1U);
        EXPECT_EQ(ports.sent.size(), 1U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
}

// t         k to k+5, B never misses what A has missed
// A         next one missed, stands         B is not due: the discrepancy time of 5 ms is over in the sixth comparison
TEST_F(Refresh, ThatOneChannelNeverMissesIsFound)
{
    Verifies(req::SRS_KRN_148);
    for (const bool is_a : {false, true})
    {
        Operate();
        // Given a refresh that waits in both channels
        Tap& first = is_a ? a : b;
        Tap& other = is_a ? b : a;
        application.refresh = RefreshAnswer::kSkip;
        Cycles(3U);
        // When one of them alone signals a missed one, and the other one another cause
        other.on_outcome = [](CycleOutcome& outcome) { outcome.signalled |= 2U; };
        first.on_outcome = [](CycleOutcome& outcome) { outcome.signalled |= 2U; };
        first.more_signals = 1U << static_cast<std::uint32_t>(SrdoCause::kRefreshMissed);
        Cycle();
        first.on_outcome = nullptr;
        other.on_outcome = nullptr;
        first.more_signals = 0U;
        application.refresh = RefreshAnswer::kReady;
        std::uint32_t cycles = 1U;
        while ((kernel.DeviceState().fault == DeviceFault::kNone) && (cycles < 20U))
        {
            Cycle();
            ++cycles;
        }
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kUnmatched);
        EXPECT_EQ(cycles, 6U);
        EXPECT_TRUE(ports.sent.empty());
    }
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
        EXPECT_TRUE(CausesOf(0x1303U).empty()) << every;
    }
}

// t       k to k+4            k+5, k+6
// B       its refresh never falls due; what is asked for each second cycle does not hide it
TEST_F(Refresh, ThatOneChannelNeverHasIsFoundWhateverIsAskedFor)
{
    Verifies(req::SRS_KRN_146);
    Verifies(req::SRS_CMP_217);
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

// Calls at any distance up to a late one, counters that wander apart within their tolerance, requests at any time, and
// confirmations at once or some calls later.
TEST_F(Refresh, CallsOfAnyDistanceAndRequestsAreNoDeviceFaultWithTwoLateCyclesOfDiscrepancy)
{
    Verifies(req::SRS_KRN_145);
    Verifies(req::SRS_KRN_310);
    for (std::uint32_t seed = 1U; seed <= 8U; ++seed)
    {
        std::uint32_t state = seed;
        const auto draw = [&state](const std::uint32_t below)
        {
            state = (state * 1664525U) + 1013904223U;
            return static_cast<std::uint32_t>((std::uint64_t{state} * below) >> 32U);
        };
        is_a_behind = (seed & 1U) == 0U;
        config.discrepancy_us = 3000U;
        OperateWithClocks(500U);
        const bool has_requests = (seed & 2U) != 0U;
        const std::uint32_t latest = (seed <= 4U) ? 1U : 6U;
        std::uint32_t lag_us = 0U;
        std::uint32_t waits = 0U;
        for (std::uint32_t cycle = 1U; cycle <= 20000U; ++cycle)
        {
            lag_us += ((cycle % 16U) == 0U) ? 1U : 0U;
            now_us += 1U + draw((draw(4U) == 0U) ? 1499U : 1000U);
            kernel.Cycle(CycleCall{NowBehind(lag_us), 0U, 0U});
            ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << seed << " " << cycle;
            if (has_requests && (draw(20U) == 0U))
            {
                static_cast<void>(kernel.Send(kProducer));
            }
            if (waits != 0U)
            {
                --waits;
            }
            else if (!ports.sent.empty())
            {
                ConfirmPair(lag_us);
                waits = draw(latest);
            }
            else
            {
            }
            application.flow.clear(); // Of no interest here, and more than a target has room for.
            application.events.clear();
            application.refreshed.clear();
        }
        EXPECT_TRUE(CausesOf(0x1303U).empty()) << seed;
    }
}

} // namespace
} // namespace counterpoint
