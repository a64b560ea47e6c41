// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/comparator_self_test.hpp"
#include "safety_core/comparator/slot_mask.hpp"
#include "tests/safety_core/comparator/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace counterpoint
{
namespace
{

TEST_F(Comparing, SlotThatDoesNotExistIsNeverLookedAt)
{
    Verifies(req::SRS_CMP_150);
    // Given both channels speak of news in slot 5 of four, where one of them would show another pair
    a.outcome.fresh = 0x20U;
    b.outcome.fresh = 0x20U;
    b.held[5].ordinal = 1U;
    // When 6000 us pass, more than the discrepancy time
    const Verdict first = CompareAt(0U);
    const Verdict last = CompareAt(6000U);
    // Then nothing was compared there
    EXPECT_EQ(first.newly_matched & 0x20U, 0U);
    EXPECT_EQ(last.fault, DeviceFault::kNone);
}

TEST_F(Comparing, SlotThatDoesNotExistIsNeitherAgreedNorDemotedNorStarted)
{
    Verifies(req::SRS_CMP_150);
    // Given both channels release slots 4 to 63 of four, and call them due
    a.outcome.released = ~SrdoMask{0U};
    b.outcome.released = ~SrdoMask{0U};
    a.outcome.due = ~SrdoMask{0U};
    b.outcome.due = ~SrdoMask{0U};
    const Verdict both = CompareAt(0U);
    EXPECT_EQ(both.agreement.agreed, 0xFU);
    EXPECT_EQ(both.start, 0xFU);
    // When A alone calls them newly faulted, and then B alone faulted
    a.outcome.new_fault = ~SrdoMask{0U};
    EXPECT_EQ(CompareAt(1000U).demote, 0xFU);
    a.outcome.new_fault = 0U;
    (void)CompareAt(2000U);
    b.outcome.faulted = ~SrdoMask{0U};
    EXPECT_EQ(CompareAt(3000U).demote, 0xFU);
}

TEST_F(Comparing, RestartForgetsWhatDiffered)
{
    Verifies(req::SRS_CMP_007);
    // Given news in slots 0 and 2 that differ, before the counter wraps
    (void)CompareAt(0xFFFFEF00U);
    a.outcome.fresh = 5U;
    b.held[0].ordinal = 8U;
    b.held[2].ordinal = 8U;
    EXPECT_EQ(CompareAt(0xFFFFF000U).fault, DeviceFault::kNone);
    // When the comparator is restarted, then a difference has a discrepancy time of its own
    comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    a.outcome.fresh = 0U;
    a.outcome.ordinal_sum = 10U;
    EXPECT_EQ(CompareAt(3000U).fault, DeviceFault::kNone);
    // and what matches then is no news
    b.held[0].ordinal = 0U;
    b.held[2].ordinal = 9U;
    EXPECT_EQ(CompareAt(4000U).newly_matched, 0U);
}

TEST_F(Comparing, FirstAndLastSlotOfSixtyFourAreLookedAt)
{
    Verifies(req::SRS_CMP_006);
    comparator.Restart(ComparatorSetup{5000U, 20000U, 64U});
    for (const SlotIndex slot : std::initializer_list<SlotIndex>{0U, 63U})
    {
        a.outcome.fresh = SrdoMask{1U} << slot;
        a.held[slot].data.high = 1U;
        const Verdict verdict = CompareAt(0U);
        EXPECT_EQ(verdict.fault, DeviceFault::kDisagreement);
        EXPECT_EQ(verdict.slot, slot);
        a.held[slot].data.high = 0U;
    }
}

TEST_F(Comparing, EqualVoicesAgree)
{
    Verifies(req::SRS_CMP_001);
    Verifies(req::SRS_CMP_003);
    const Verdict verdict = CompareAt(0U);
    EXPECT_EQ(verdict.fault, DeviceFault::kNone);
    EXPECT_EQ(verdict.agreement.agreed, 4U);
    EXPECT_EQ(verdict.agreement.matched & 4U, 4U);
    EXPECT_EQ(verdict.demote, 0U);
    EXPECT_EQ(verdict.newly_matched, 0U);
    EXPECT_EQ(verdict.echo, 0xABCDU);
}

TEST_F(Comparing, EachUnequalFieldOfTheWholeIsADisagreementAndAgreesToNothing)
{
    Verifies(req::SRS_CMP_002);
    Verifies(req::SRS_TWO_007);
    const auto differs = [this](std::uint8_t& field)
    {
        field = static_cast<std::uint8_t>(field ^ 1U);
        const Verdict verdict = CompareAt(0U);
        EXPECT_EQ(verdict.fault, DeviceFault::kDisagreement);
        EXPECT_EQ(verdict.agreement.agreed, 0U);
        EXPECT_EQ(verdict.echo, 0xABCDU);
        field = static_cast<std::uint8_t>(field ^ 1U);
    };
    differs(a.outcome.sct_checked);
    differs(b.outcome.is_tx);
    differs(a.outcome.is_invalid);
    differs(b.outcome.not_operational);
    b.outcome.guard = GuardView::kUnconfigured;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
    // What a peer shows whose statement differs for too long
    b.outcome.guard = GuardView::kInvalid;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
}

TEST_F(Comparing, CycleOfAnotherNumberIsADisagreementForEitherChannelAndForBoth)
{
    Verifies(req::SRS_CMP_002);
    a.outcome.cycle = 16U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
    b.outcome.cycle = 16U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
    a.outcome.cycle = 17U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
}

TEST_F(Comparing, StaleTokenSeenByEitherChannelIsTheGuardsFault)
{
    Verifies(req::SRS_CMP_002);
    a.outcome.guard = GuardView::kStale;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kGuard);
    b.outcome.guard = GuardView::kStale;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kGuard);
    a.outcome.guard = GuardView::kConfigured;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kGuard);
}

TEST_F(Comparing, FaultOfEitherChannelTakesTheReleaseAndDemotes)
{
    Verifies(req::SRS_CMP_003);
    Verifies(req::SRS_CMP_004);
    // Given that B alone reports slot 2 faulted while A still releases it
    b.outcome.released = 0U;
    b.outcome.faulted = 4U;
    b.outcome.new_fault = 4U;
    Verdict verdict = CompareAt(0U);
    EXPECT_EQ(verdict.agreement.agreed, 0U);
    EXPECT_EQ(verdict.demote, 4U);
    EXPECT_EQ(verdict.fault, DeviceFault::kNone);
    // And the same the other way round
    a.outcome.released = 0U;
    a.outcome.faulted = 4U;
    a.outcome.new_fault = 4U;
    b.outcome.released = 4U;
    b.outcome.faulted = 0U;
    b.outcome.new_fault = 0U;
    verdict = CompareAt(1000U);
    EXPECT_EQ(verdict.agreement.agreed, 0U);
    EXPECT_EQ(verdict.demote, 4U);
}

TEST_F(Comparing, AnotherFaultOfOneChannelAloneDemotesAFaultedSlot)
{
    Verifies(req::SRS_CMP_004);
    // Given that both call slot 2 faulted, and A alone found another fault
    for (SpokenChannel* const channel : {&a, &b})
    {
        channel->outcome.released = 0U;
        channel->outcome.faulted = 4U;
    }
    a.outcome.new_fault = 4U;
    EXPECT_EQ(CompareAt(0U).demote, 4U);
    // And the same the other way round
    a.outcome.new_fault = 0U;
    b.outcome.new_fault = 4U;
    EXPECT_EQ(CompareAt(1000U).demote, 4U);
}

TEST_F(Comparing, ReleaseAndFaultOfOneChannelAtOnceIsNoRelease)
{
    Verifies(req::SRS_CMP_003);
    for (SpokenChannel* const channel : {&a, &b})
    {
        channel->outcome.new_fault = 4U;
    }
    const Verdict verdict = CompareAt(0U);
    EXPECT_EQ(verdict.agreement.agreed, 0U);
    EXPECT_EQ(verdict.demote, 0U);
}

TEST_F(Comparing, FaultSeenByBothDemotesNobody)
{
    Verifies(req::SRS_CMP_004);
    for (SpokenChannel* const channel : {&a, &b})
    {
        channel->outcome.released = 0U;
        channel->outcome.faulted = 4U;
        channel->outcome.new_fault = 4U;
    }
    EXPECT_EQ(CompareAt(0U).demote, 0U);
}

TEST_F(Comparing, FreshEqualPairIsNewlyMatched)
{
    Verifies(req::SRS_CMP_005);
    Verifies(req::SRS_CMP_215);
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    const Verdict verdict = CompareAt(0U);
    EXPECT_EQ(verdict.newly_matched, 4U);
    EXPECT_EQ(verdict.agreement.matched & 4U, 4U);
    // and is not looked at again without news
    a.outcome.fresh = 0U;
    b.outcome.fresh = 0U;
    EXPECT_EQ(CompareAt(1000U).newly_matched, 0U);
}

// t [us]   1000   2000 another slot's ordinals differ: slot 2 is looked at, and matches as before
TEST_F(Comparing, PairThatIsLookedAtBecauseOfAnotherSlotIsNotNewlyMatched)
{
    Verifies(req::SRS_CMP_215);
    (void)CompareAt(1000U);
    a.outcome.fresh = 2U;
    a.outcome.ordinal_sum = 10U;
    a.held[1].ordinal = 1U;
    const Verdict verdict = CompareAt(2000U);
    EXPECT_EQ(verdict.agreement.matched & 6U, 4U);
    EXPECT_EQ(verdict.newly_matched, 0U);
    // When the other slot's pair comes in channel B too, it alone is newly matched
    a.outcome.fresh = 0U;
    b.outcome.fresh = 2U;
    b.outcome.ordinal_sum = 10U;
    b.held[1].ordinal = 1U;
    EXPECT_EQ(CompareAt(3000U).newly_matched, 2U);
}

// A new pair of a slot that is demoted is forgotten: what matches later is not that pair.
TEST_F(Comparing, NewPairOfADemotedSlotIsNotNewlyMatchedLater)
{
    Verifies(req::SRS_CMP_215);
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    b.outcome.new_fault = 4U;
    EXPECT_EQ(CompareAt(1000U).newly_matched, 0U);
    a.outcome.fresh = 0U;
    b.outcome.fresh = 0U;
    b.outcome.new_fault = 0U;
    a.outcome.ordinal_sum = 10U;
    EXPECT_EQ(CompareAt(2000U).newly_matched, 0U);
}

TEST_F(Comparing, UnequalDataUnderOneOrdinalIsADisagreementInEveryBit)
{
    Verifies(req::SRS_CMP_006);
    b.outcome.fresh = 4U;
    for (std::uint32_t bit = 0U; bit < 64U; ++bit)
    {
        std::uint32_t& word = (bit < 32U) ? b.held[2].data.low : b.held[2].data.high;
        word ^= 1U << (bit % 32U);
        const Verdict verdict = CompareAt(0U);
        EXPECT_EQ(verdict.fault, DeviceFault::kDisagreement) << "bit " << bit;
        EXPECT_EQ(verdict.slot, 2U) << "bit " << bit;
        word ^= 1U << (bit % 32U);
    }
}

TEST_F(Comparing, UnequalDataIsADisagreementWhateverTheOtherBitsAre)
{
    Verifies(req::SRS_CMP_006);
    b.outcome.fresh = 4U;
    for (const std::uint32_t fill : {0x00000000U, 0xFFFFFFFFU})
    {
        a.held[2].data = Payload{fill, fill};
        b.held[2].data = Payload{fill, fill};
        EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kNone);
        for (std::uint32_t bit = 0U; bit < 32U; ++bit)
        {
            const std::uint32_t flipped = fill ^ (1U << bit);
            b.held[2].data = Payload{flipped, fill};
            EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement) << "bit " << bit;
            b.held[2].data = Payload{fill, flipped};
            EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement) << "bit " << bit;
            // The same bit in both words, which must not cancel
            b.held[2].data = Payload{flipped, flipped};
            EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement) << "bit " << bit;
        }
    }
}

// t [us]    1000   2000 (seen)     6000 (limit)   6001
// A's pair   9     10 .............10             10
// B's pair   9      9 ............. 9              9
TEST_F(Comparing, UnmatchedOrdinalsAreAFaultOneMicrosecondAfterTheDiscrepancyTime)
{
    Verifies(req::SRS_CMP_007);
    Verifies(req::SRS_TIME_004);
    (void)CompareAt(1000U);
    a.outcome.fresh = 4U;
    a.outcome.ordinal_sum = 10U;
    a.held[2].ordinal = 10U;
    Verdict verdict = CompareAt(2000U);
    EXPECT_EQ(verdict.fault, DeviceFault::kNone);
    EXPECT_EQ(verdict.agreement.agreed, 4U);
    EXPECT_EQ(verdict.agreement.matched & 4U, 0U);
    a.outcome.fresh = 0U;
    EXPECT_EQ(CompareAt(6000U).fault, DeviceFault::kNone);
    verdict = CompareAt(6001U);
    EXPECT_EQ(verdict.fault, DeviceFault::kUnmatched);
    EXPECT_EQ(verdict.slot, 2U);
}

TEST_F(Comparing, OrdinalsThatMeetWithinTheDiscrepancyTimeAreNoFaultAndTheTimeStartsAnew)
{
    Verifies(req::SRS_CMP_007);
    a.outcome.fresh = 4U;
    a.outcome.ordinal_sum = 10U;
    a.held[2].ordinal = 10U;
    (void)CompareAt(1000U);
    // When B has the pair too, 4000 us later
    a.outcome.fresh = 0U;
    b.outcome.ordinal_sum = 10U;
    b.held[2].ordinal = 10U;
    EXPECT_EQ(CompareAt(5000U).newly_matched, 4U);
    // and B is one pair ahead next time
    b.outcome.fresh = 4U;
    b.outcome.ordinal_sum = 11U;
    b.held[2].ordinal = 11U;
    EXPECT_EQ(CompareAt(6000U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(10000U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(10001U).fault, DeviceFault::kUnmatched);
}

TEST_F(Comparing, UnequalOrdinalSumsAloneMakeItLookAtEverySlot)
{
    Verifies(req::SRS_CMP_214);
    Verifies(req::SRS_CMP_007);
    // Given a corrupted ordinal that no channel calls fresh
    b.outcome.ordinal_sum = 13U;
    b.held[2].ordinal = 13U;
    EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 0U);
    EXPECT_EQ(CompareAt(5001U).fault, DeviceFault::kUnmatched);
}

TEST_F(Comparing, OnlyOneChannelHoldingAPairIsUnmatched)
{
    Verifies(req::SRS_CMP_007);
    a.outcome.fresh = 4U;
    b.held[2].holds_pair = 0U;
    (void)CompareAt(0U);
    EXPECT_EQ(CompareAt(5001U).fault, DeviceFault::kUnmatched);
}

// t [us]   1000 pair of slot 2   2000 a pair of slot 1 in one channel: slot 2 is looked at, and matches as before
TEST_F(Comparing, PairIsNewlyMatchedOnceEvenIfItIsLookedAtInTheNextComparison)
{
    Verifies(req::SRS_CMP_215);
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    EXPECT_EQ(CompareAt(1000U).newly_matched, 4U);
    a.outcome.fresh = 2U;
    b.outcome.fresh = 0U;
    a.outcome.ordinal_sum = 10U;
    a.held[1].ordinal = 1U;
    EXPECT_EQ(CompareAt(2000U).newly_matched, 0U);
}

TEST_F(Comparing, ProducerIsStartedWhenBothCallItDue)
{
    Verifies(req::SRS_CMP_010);
    a.outcome.due = 1U;
    EXPECT_EQ(CompareAt(0U).start, 0U);
    b.outcome.due = 1U;
    EXPECT_EQ(CompareAt(1000U).start, 1U);
}

TEST_F(Comparing, ProducerThatOneChannelNeverCallsDueIsAFault)
{
    Verifies(req::SRS_CMP_217);
    b.outcome.due = 1U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(5000U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(5001U).fault, DeviceFault::kUnmatched);
}

TEST_F(Comparing, ProducerThatBothCallDueInTimeIsNoFault)
{
    Verifies(req::SRS_CMP_217);
    a.outcome.due = 1U;
    (void)CompareAt(0U);
    EXPECT_EQ(CompareAt(5000U).fault, DeviceFault::kNone);
    b.outcome.due = 1U;
    EXPECT_EQ(CompareAt(5001U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(5001U).start, 1U);
}

// Cycle 1 ms, 0.5 ms late, interval 50 ms: a round may take 15 x 1.5 ms, so that it begins 27.5 ms after the one
// before.
TEST_F(Comparing, SelfTestWaitsForTheEndOfTheIntervalAndBeginsWithTheSameDifferenceAfterEachRestart)
{
    Verifies(req::SRS_CMP_211);
    DeviceConfig config{};
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.test_interval_us = 50000U;
    config.srdo_count = 4U;
    ComparatorSelfTest test{};
    Comparison comparison{&a.outcome, &b.outcome, &a, &b, Instant{0U}, 17U, 0xABCDU, HeldPair{}};
    const auto run_round = [&]()
    {
        std::uint32_t tests = 0U;
        while (test.TakeTurn(comparison.now))
        {
            EXPECT_EQ(test.Run(comparator, comparison), DeviceFault::kNone) << tests;
            comparison.now.us += 1000U;
            ++tests;
        }
        return tests;
    };
    for (const std::uint32_t start_us : {7000U, 0xFFFFFF00U})
    {
        test.Restart(config);
        EXPECT_FALSE(test.TakeTurn(Instant{start_us}));
        EXPECT_FALSE(test.TakeTurn(Instant{start_us + 27499U}));
        comparison.now.us = start_us + 27500U;
        EXPECT_EQ(run_round(), 15U);
        EXPECT_FALSE(test.TakeTurn(Instant{start_us + 54999U}));
        comparison.now.us = start_us + 55000U;
        EXPECT_EQ(run_round(), 15U);
        // And a start in the midst of a round waits anew
        EXPECT_TRUE(test.TakeTurn(Instant{start_us + 90000U}));
    }
}

// t [us]    1000   2000 bit 2 of open_, the first member, is 1 from now on     6000 (limit)   6001
TEST_F(Comparing, PairThatIsKeptBackWithoutADifferenceIsUnmatchedAfterTheDiscrepancyTime)
{
    Verifies(req::SRS_CMP_011);
    const auto set_bit = [this]()
    {
        SrdoMask open = 0U;
        std::memcpy(&open, &comparator, sizeof(open));
        open |= 4U;
        std::memcpy(static_cast<void*>(&comparator), &open, sizeof(open));
    };
    EXPECT_EQ(CompareAt(1000U).agreement.matched & 4U, 4U);
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    b.on_held = set_bit;
    EXPECT_EQ(CompareAt(2000U).agreement.matched & 4U, 0U);
    EXPECT_EQ(CompareAt(6000U).fault, DeviceFault::kNone);
    const Verdict verdict = CompareAt(6001U);
    EXPECT_EQ(verdict.fault, DeviceFault::kUnmatched);
    EXPECT_EQ(verdict.slot, 2U);
}

// The test's own voices are both channel A's.
TEST_F(Comparing, SelfTestDoesNotMindWhatTheChannelsSayAndAFaultOfTheirsStaysTheirs)
{
    Verifies(req::SRS_CMP_009);
    Verifies(req::SRS_CMP_212);
    DeviceConfig config{};
    config.test_interval_us = 1U;
    config.srdo_count = 4U;
    ComparatorSelfTest test{};
    test.Restart(config);
    a.outcome.guard = GuardView::kStale;
    a.outcome.new_fault = 1U;
    b.outcome.ordinal_sum = 3U;
    b.held[0].ordinal = 3U;
    const Comparison comparison{&a.outcome, &b.outcome, &a, &b, Instant{0U}, 17U, 0xABCDU, HeldPair{}};
    EXPECT_FALSE(test.TakeTurn(Instant{0U}));
    for (std::uint32_t number = 0U; number < 15U; ++number)
    {
        EXPECT_TRUE(test.TakeTurn(Instant{1U}));
        EXPECT_EQ(test.Run(comparator, comparison), DeviceFault::kNone) << number;
    }
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kGuard);
}

// t [us]    1000   2000 (seen)   3000, 5000 tried   6000 (limit)   6001
TEST_F(Comparing, TryCountsForNothing)
{
    Verifies(req::SRS_CMP_212);
    (void)CompareAt(1000U);
    a.outcome.fresh = 4U;
    a.outcome.ordinal_sum = 10U;
    a.held[2].ordinal = 10U;
    EXPECT_EQ(CompareAt(2000U).fault, DeviceFault::kNone);
    a.outcome.fresh = 0U;
    // When equal voices are tried, and such as differ in slot 1
    for (const std::uint32_t now_us : {3000U, 5000U})
    {
        CycleOutcome turned = a.outcome;
        Comparison test{&a.outcome, &turned, &a, &a, Instant{now_us}, 17U, 0xABCDU, HeldPair{}};
        EXPECT_EQ(comparator.Try(test).agreement.matched & 4U, 4U);
        turned.fresh = 2U;
        test.turned.data.high = 1U;
        EXPECT_EQ(comparator.Try(test).fault, DeviceFault::kDisagreement);
        turned.fresh = 0U;
        test.turned = HeldPair{};
        turned.ordinal_sum = 11U;
        test.turned.ordinal = 1U;
        EXPECT_EQ(comparator.Try(test).agreement.matched & 0xFU, 0U);
    }
    // Then slot 2 differs since the comparison at 1000, and slot 1 does not
    const Verdict verdict = CompareAt(6000U);
    EXPECT_EQ(verdict.fault, DeviceFault::kNone);
    EXPECT_EQ(verdict.agreement.matched & 6U, 2U);
    EXPECT_EQ(CompareAt(6001U).fault, DeviceFault::kUnmatched);
}

TEST(SlotSet, EverySlotIsTakenFromTheLowestToTheHighest)
{
    Verifies(req::SRS_CMP_214);
    SlotSet all{0xFFFFFFFFFFFFFFFFU};
    for (SlotIndex slot = 0U; slot < 64U; ++slot)
    {
        SlotSet one = OnlySlot(slot);
        EXPECT_EQ(TakeLowest(one), slot);
        EXPECT_EQ(one.mask, 0U);
        EXPECT_EQ(TakeLowest(all), slot);
    }
    EXPECT_EQ(all.mask, 0U);
}

} // namespace
} // namespace counterpoint
