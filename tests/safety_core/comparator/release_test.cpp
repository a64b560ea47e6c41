// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/comparator/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace counterpoint
{
namespace
{

TEST_F(Comparing, FaultWithoutANewOneInAnAgreedSlotDemotesAtOnce)
{
    Verifies(req::SRS_CMP_004);
    Verifies(req::SRS_CMP_341);
    // Given slot 2 agreed, and one channel alone that calls it faulted without a new fault
    std::uint32_t now_us = 0U;
    for (SpokenChannel* const faulty : {&a, &b})
    {
        EXPECT_EQ(CompareAt(now_us).agreement.agreed, 4U);
        faulty->outcome.released = 0U;
        faulty->outcome.faulted = 4U;
        EXPECT_EQ(CompareAt(now_us + 1000U).demote, 4U);
        // What was not agreed in the comparison before has the window
        EXPECT_EQ(CompareAt(now_us + 2000U).demote, 0U);
        faulty->outcome.released = 4U;
        faulty->outcome.faulted = 0U;
        now_us += 3000U;
    }
    // Nor is what was agreed before a restart
    EXPECT_EQ(CompareAt(now_us).agreement.agreed, 4U);
    comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    b.outcome.released = 0U;
    b.outcome.faulted = 4U;
    EXPECT_EQ(CompareAt(1000U).demote, 0U);
}

// t      k-1       k               k+1
//        agreed    one lost it     demoted: no longer agreed
TEST_F(Comparing, ReleaseThatOneChannelLostInAnAgreedSlotDemotesAtOnce)
{
    Verifies(req::SRS_CMP_250);
    std::uint32_t now_us = 0U;
    for (SpokenChannel* const lost : {&a, &b})
    {
        // Given slot 2 agreed
        EXPECT_EQ(CompareAt(now_us).agreement.agreed, 4U);
        // When one channel alone calls it released no more, and no channel reports a fault
        lost->outcome.released = 0U;
        // Then it is demoted in that comparison
        const Verdict verdict = CompareAt(now_us + 1000U);
        EXPECT_EQ(verdict.demote, 4U);
        EXPECT_EQ(verdict.agreement.agreed, 0U);
        EXPECT_EQ(verdict.fault, DeviceFault::kNone);
        // What was not agreed in the comparison before has the window
        EXPECT_EQ(CompareAt(now_us + 2000U).demote, 0U);
        lost->outcome.released = 4U;
        now_us += 3000U;
    }
    // Both that lose it, as both do when OPERATIONAL is left, are of one mind
    EXPECT_EQ(CompareAt(now_us).agreement.agreed, 4U);
    a.outcome.released = 0U;
    b.outcome.released = 0U;
    EXPECT_EQ(CompareAt(now_us + 1000U).demote, 0U);
}

// t      k-1       k                            k+1
//        agreed    a bit of the comparator's     right again
//                  memory is wrong
TEST_F(Comparing, WrongBitOfItsMemoryTakesNoReleaseBackWithoutAWord)
{
    Verifies(req::SRS_CMP_251);
    // Given slot 2 agreed
    EXPECT_EQ(CompareAt(0U).agreement.agreed, 4U);
    const Comparator sound{comparator};
    std::uint32_t lost = 0U;
    for (std::size_t byte = 0U; byte < sizeof(Comparator); ++byte)
    {
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            // When one bit is wrong for one comparison
            comparator = sound;
            unsigned char* const bytes = reinterpret_cast<unsigned char*>(&comparator);
            bytes[byte] = static_cast<unsigned char>(bytes[byte] ^ (1U << bit));
            const Verdict verdict = CompareAt(1000U);
            // Then the slot is agreed all the same, or somebody is told
            const bool is_told = (verdict.fault != DeviceFault::kNone) || (verdict.demote != 0U);
            EXPECT_TRUE(((verdict.agreement.agreed & 4U) != 0U) || is_told) << byte << '.' << bit;
            lost += (verdict.fault == DeviceFault::kComparator) ? 1U : 0U;
        }
    }
    // which is so for the bit of slot 2 in the mask of slots, and for those of the 60 slots that do not exist in the
    // mask of what was agreed
    EXPECT_EQ(lost, 61U);
}

TEST_F(Comparing, ProducerDueInOneChannelIsFoundThoughTheOtherCallsItFaultedInEveryCycle)
{
    Verifies(req::SRS_CMP_217);
    // Given slot 1 due in B alone, and newly faulted in A, from the comparison at 1000 us on
    (void)CompareAt(0U);
    a.outcome.new_fault = 2U;
    b.outcome.due = 2U;
    EXPECT_EQ(CompareAt(1000U).demote & 2U, 2U);
    EXPECT_EQ(CompareAt(5000U).fault, DeviceFault::kNone);
    // When the discrepancy time of 5000 us is over, counted from the comparison before
    const Verdict verdict = CompareAt(5001U);
    // Then it is a device fault of that slot
    EXPECT_EQ(verdict.fault, DeviceFault::kUnmatched);
    EXPECT_EQ(verdict.slot, 1U);
}

// A's or B's edge alone, behind a fault and before the first release
class ComparingOneRelease : public Comparing, public ::testing::WithParamInterface<SrdoState>
{
  protected:
    ComparingOneRelease()
    {
        early = &a;
        late = &b;
        ((GetParam() == SrdoState::kFaulted) ? late->outcome.faulted : late->outcome.waiting) = 4U;
        late->outcome.released = 0U;
    }

    void Release()
    {
        late->outcome.released = 4U;
        late->outcome.faulted = 0U;
        late->outcome.waiting = 0U;
    }

    void Turn()
    {
        std::swap(a.outcome, b.outcome);
        std::swap(early, late);
        comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    }

    SpokenChannel* early{};
    SpokenChannel* late{};
};

// t [us]   1000 (seen)   21000 (window)   21001
TEST_P(ComparingOneRelease, IsDemotedOneMicrosecondAfterTheWindow)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_341);
    for (std::uint32_t turn = 0U; turn < 2U; ++turn)
    {
        EXPECT_EQ(CompareAt(1000U).demote, 0U);
        Verdict verdict = CompareAt(21000U);
        EXPECT_EQ(verdict.demote, 0U);
        EXPECT_EQ(verdict.agreement.agreed, 0U);
        EXPECT_EQ(verdict.agreement.matched & 4U, 0U);
        verdict = CompareAt(21001U);
        EXPECT_EQ(verdict.demote, 4U);
        EXPECT_EQ(verdict.fault, DeviceFault::kNone);
        // A difference that is seen again has a window of its own
        EXPECT_EQ(CompareAt(22000U).demote, 0U);
        EXPECT_EQ(CompareAt(42000U).demote, 0U);
        EXPECT_EQ(CompareAt(42001U).demote, 4U);
        Turn();
    }
}

TEST_P(ComparingOneRelease, SecondEdgeOnTheWindowReleases)
{
    Verifies(req::SRS_CMP_008);
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    EXPECT_EQ(CompareAt(1000U).newly_matched, 0U);
    a.outcome.fresh = 0U;
    b.outcome.fresh = 0U;
    (void)CompareAt(11000U);
    Release();
    Verdict verdict = CompareAt(21000U);
    EXPECT_EQ(verdict.demote, 0U);
    EXPECT_EQ(verdict.agreement.agreed, 4U);
    EXPECT_EQ(verdict.agreement.matched & 4U, 4U);
    EXPECT_EQ(verdict.newly_matched, 4U);
    // and is not looked at again
    verdict = CompareAt(90000U);
    EXPECT_EQ(verdict.demote, 0U);
    EXPECT_EQ(verdict.agreement.agreed, 4U);
    EXPECT_EQ(verdict.newly_matched, 0U);
}

TEST_P(ComparingOneRelease, SecondEdgeBehindTheWindowDoesNotRelease)
{
    Verifies(req::SRS_CMP_008);
    a.outcome.fresh = 4U;
    (void)CompareAt(1000U);
    a.outcome.fresh = 0U;
    Release();
    const Verdict verdict = CompareAt(21001U);
    EXPECT_EQ(verdict.demote, 4U);
    EXPECT_EQ(verdict.agreement.agreed, 0U);
    EXPECT_EQ(verdict.newly_matched, 0U);
}

// t [us]   1000 (one release)   21001 (both: too late)   22000 (one again)   42000 (window)   42001
TEST_P(ComparingOneRelease, EdgeRightBehindADemotionHasAWindowOfItsOwn)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_341);
    (void)CompareAt(1000U);
    Release();
    EXPECT_EQ(CompareAt(21001U).demote, 4U);
    // What was demoted was not agreed: this is no fault of one channel alone
    late->outcome.released = 0U;
    late->outcome.faulted = 4U;
    EXPECT_EQ(CompareAt(22000U).demote, 0U);
    EXPECT_EQ(CompareAt(42000U).demote, 0U);
    EXPECT_EQ(CompareAt(42001U).demote, 4U);
}

// t [us]   0 (one release)   300000: pairs differ   301000: no more   302000, 307000 (limit), 307001
TEST_P(ComparingOneRelease, PairsThatDifferMeanwhileHaveTheDiscrepancyTimeOfTheirOwn)
{
    Verifies(req::SRS_CMP_007);
    Verifies(req::SRS_CMP_216);
    comparator.Restart(ComparatorSetup{5000U, 1000000U, 4U});
    (void)CompareAt(0U);
    (void)CompareAt(299000U);
    const auto ahead = [this](const std::uint32_t ordinal)
    {
        a.outcome.ordinal_sum = ordinal;
        a.held[2].ordinal = ordinal;
    };
    ahead(10U);
    EXPECT_EQ(CompareAt(300000U).fault, DeviceFault::kNone);
    ahead(9U);
    EXPECT_EQ(CompareAt(302000U).fault, DeviceFault::kNone);
    ahead(10U);
    EXPECT_EQ(CompareAt(303000U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(307000U).fault, DeviceFault::kNone);
    EXPECT_EQ(CompareAt(307001U).fault, DeviceFault::kUnmatched);
    // The release has gone on differing since the first comparison
    ahead(9U);
    EXPECT_EQ(CompareAt(1000000U).demote, 0U);
    EXPECT_EQ(CompareAt(1000001U).demote, 4U);
}

TEST_P(ComparingOneRelease, WindowShorterThanTheDiscrepancyTimeLeavesThat)
{
    Verifies(req::SRS_CMP_008);
    comparator.Restart(ComparatorSetup{5000U, 0U, 4U});
    (void)CompareAt(1000U);
    EXPECT_EQ(CompareAt(6000U).demote, 0U);
    EXPECT_EQ(CompareAt(6001U).demote, 4U);
}

TEST_P(ComparingOneRelease, NewFaultEndsItAtOnce)
{
    Verifies(req::SRS_CMP_004);
    (void)CompareAt(1000U);
    early->outcome.new_fault = 4U;
    early->outcome.released = 0U;
    early->outcome.faulted = 4U;
    EXPECT_EQ(CompareAt(2000U).demote, 4U);
}

INSTANTIATE_TEST_SUITE_P(States, ComparingOneRelease, ::testing::Values(SrdoState::kFaulted, SrdoState::kWaiting),
                         [](const ::testing::TestParamInfo<SrdoState>& state)
                         { return (state.param == SrdoState::kFaulted) ? "BehindAFault" : "BeforeTheFirstRelease"; });

} // namespace
} // namespace counterpoint
