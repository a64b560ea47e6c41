// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Several things at once: none of them may hide another one.
#include "safety_core/comparator/comparator_self_test.hpp"
#include "tests/safety_core/comparator/rig.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <initializer_list>

namespace counterpoint
{
namespace
{

TEST_F(Comparing, WhateverNumberOfFaultMarksTakesTheRelease)
{
    Verifies(req::SRS_CMP_003);
    // Given that both release slot 2, and each choice of the four marks of a fault but none of them
    for (std::uint32_t marks = 1U; marks < 16U; ++marks)
    {
        a.outcome.faulted = ((marks & 1U) != 0U) ? 4U : 0U;
        b.outcome.faulted = ((marks & 2U) != 0U) ? 4U : 0U;
        a.outcome.new_fault = ((marks & 4U) != 0U) ? 4U : 0U;
        b.outcome.new_fault = ((marks & 8U) != 0U) ? 4U : 0U;
        // Then nothing is agreed
        EXPECT_EQ(CompareAt(0U).agreement.agreed, 0U) << marks;
    }
}

TEST_F(Comparing, NothingIsAgreedBehindARestart)
{
    Verifies(req::SRS_CMP_004);
    Verifies(req::SRS_CMP_341);
    // Given B alone calls the first slot faulted without a new fault
    b.outcome.faulted = 1U;
    // When that is the first comparison, then nobody is demoted at once
    EXPECT_EQ(CompareAt(0U).demote, 0U);
}

TEST_F(Comparing, VerdictWithoutAFaultNamesNoSlot)
{
    Verifies(req::SRS_CMP_006);
    EXPECT_EQ(CompareAt(0U).slot, kNoSlot);
    a.outcome.is_tx = 2U;
    EXPECT_EQ(CompareAt(0U).slot, kNoSlot);
}

// t [us]   0: A alone has pair 10, and A alone has released it; the sums of the ordinals are equal   5001: too late
TEST_F(Comparing, PairAndReleaseOfOneChannelAloneAreBothSeen)
{
    Verifies(req::SRS_CMP_005);
    Verifies(req::SRS_CMP_214);
    Verifies(req::SRS_CMP_007);
    a.outcome.fresh = 4U;
    a.held[2].ordinal = 10U;
    b.outcome.released = 0U;
    const Verdict first = CompareAt(0U);
    EXPECT_EQ(first.agreement.matched & 4U, 0U);
    EXPECT_EQ(first.newly_matched, 0U);
    EXPECT_EQ(first.fault, DeviceFault::kNone);
    a.outcome.fresh = 0U;
    EXPECT_EQ(CompareAt(5001U).fault, DeviceFault::kUnmatched);
}

TEST_F(Comparing, UnequalDataOfANewPairAreSeenWhateverElseDiffers)
{
    Verifies(req::SRS_CMP_006);
    a.outcome.fresh = 4U;
    a.held[2].data.low ^= 1U;
    // Given A alone releases the slot, then the data are looked at
    b.outcome.released = 0U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
    // and so they are when A alone calls it due
    comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    b.outcome.released = 4U;
    a.outcome.due = 4U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
}

TEST_F(Comparing, EqualPairMatchesOnlyWithEqualDataReleaseAndFault)
{
    Verifies(req::SRS_CMP_005);
    // Given both channels with a new pair of one ordinal and one content, then it is matched
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 4U);
    for (SpokenChannel* const other : {&a, &b})
    {
        // When the first or the last bit of the data differs under that ordinal, then not
        for (std::uint32_t* const half : {&other->held[2].data.low, &other->held[2].data.high})
        {
            for (const std::uint32_t bit : {1U, 0x80000000U})
            {
                comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
                *half ^= bit;
                EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 0U) << bit;
                *half ^= bit;
            }
        }
        // nor when the release differs, or the fault
        comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
        other->outcome.released = 0U;
        EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 0U);
        other->outcome.released = 4U;
        comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
        other->outcome.faulted = 4U;
        EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 0U);
        other->outcome.faulted = 0U;
    }
    // And when nothing differs any more, then it is again
    comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 4U);
}

TEST_F(Comparing, DifferencesOfTheSameBitsDoNotCancelEachOther)
{
    Verifies(req::SRS_CMP_007);
    // Given ordinal and data of slot 2 differ in bit 0
    a.outcome.fresh = 4U;
    a.held[2].ordinal = 8U;
    a.held[2].data.low ^= 1U;
    EXPECT_EQ(CompareAt(0U).agreement.matched & 4U, 0U);
    // and slot 0 differs in bit 0 of its ordinal, and is bit 0 of what one channel alone calls due
    comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    a.outcome.fresh = 1U;
    a.outcome.due = 1U;
    a.held[0].ordinal = 1U;
    EXPECT_EQ(CompareAt(0U).agreement.matched & 1U, 0U);
    EXPECT_EQ(CompareAt(5001U).fault, DeviceFault::kUnmatched);
    // and when it is bit 0 of its data instead, they are another pair under one ordinal
    comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
    a.held[0].ordinal = 0U;
    a.held[0].data.low = 1U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kDisagreement);
}

// t [us]   0: A alone releases   30000, behind the window: neither does, and both have a new pair
TEST_F(Comparing, ReleaseThatIsGoneIsNoReleaseThatIsLate)
{
    Verifies(req::SRS_CMP_008);
    b.outcome.released = 0U;
    EXPECT_EQ(CompareAt(0U).demote, 0U);
    a.outcome.released = 0U;
    a.outcome.fresh = 4U;
    b.outcome.fresh = 4U;
    EXPECT_EQ(CompareAt(30000U).demote, 0U);
}

// t [us]   0: A alone releases   30000, behind the window: both report a new fault, and both have a new pair
TEST_F(Comparing, NewFaultOfBothIsNoReleaseThatIsLate)
{
    Verifies(req::SRS_CMP_008);
    b.outcome.released = 0U;
    EXPECT_EQ(CompareAt(0U).demote, 0U);
    for (SpokenChannel* const channel : {&a, &b})
    {
        channel->outcome.released = 0U;
        channel->outcome.faulted = 4U;
        channel->outcome.new_fault = 4U;
        channel->outcome.fresh = 4U;
    }
    EXPECT_EQ(CompareAt(30000U).demote, 0U);
}

// t [us]   1000 (seen)   21000 (window)   21001
TEST_F(Comparing, FaultOfOneAloneIsDemotedBehindTheWindowThoughNobodyReleases)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_341);
    for (SpokenChannel* const faulty : {&a, &b})
    {
        comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
        for (SpokenChannel* const channel : {&a, &b})
        {
            channel->outcome.released = 0U;
            channel->outcome.faulted = (channel == faulty) ? 4U : 0U;
            channel->outcome.waiting = (channel == faulty) ? 0U : 4U;
        }
        EXPECT_EQ(CompareAt(1000U).demote, 0U);
        EXPECT_EQ(CompareAt(21000U).demote, 0U);
        EXPECT_EQ(CompareAt(21001U).demote, 4U);
    }
}

TEST_F(Comparing, EachReasonAloneHasASlotExamined)
{
    Verifies(req::SRS_CMP_214);
    // Given other data under one ordinal, equal sums and nothing new, then nobody looks at them
    b.held[2].data.low ^= 1U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kNone);
    const auto is_seen = [this]()
    {
        comparator.Restart(ComparatorSetup{5000U, 20000U, 4U});
        return CompareAt(0U).fault == DeviceFault::kDisagreement;
    };
    EXPECT_FALSE(is_seen());
    for (SpokenChannel* const channel : {&a, &b})
    {
        const CycleOutcome usual = channel->outcome;
        // When one channel alone calls the slot new, released, faulted or due, or has another sum, then they are seen
        channel->outcome.fresh = 4U;
        EXPECT_TRUE(is_seen());
        channel->outcome = usual;
        channel->outcome.released = 0U;
        EXPECT_TRUE(is_seen());
        channel->outcome = usual;
        channel->outcome.faulted = 4U;
        EXPECT_TRUE(is_seen());
        channel->outcome = usual;
        channel->outcome.due = 4U;
        EXPECT_TRUE(is_seen());
        channel->outcome = usual;
        channel->outcome.ordinal_sum = 10U;
        EXPECT_TRUE(is_seen());
        channel->outcome = usual;
    }
}

// t [us]   0: a pair of A alone   1000: B's ordinal is the same, with other data, and nothing is new
TEST_F(Comparing, SlotThatDoesNotMatchIsExaminedAgain)
{
    Verifies(req::SRS_CMP_214);
    a.outcome.fresh = 4U;
    a.held[2].ordinal = 10U;
    EXPECT_EQ(CompareAt(0U).fault, DeviceFault::kNone);
    a.outcome.fresh = 0U;
    b.held[2].ordinal = 10U;
    b.held[2].data.high ^= 1U;
    EXPECT_EQ(CompareAt(1000U).fault, DeviceFault::kDisagreement);
}

// t [us]   0   1000 slot 1 differs (counts from 0)   4000 slot 2 too (counts from 1000)   5001: slot 1 is too late
TEST_F(Comparing, EachSlotHasATimeOfItsOwn)
{
    Verifies(req::SRS_CMP_007);
    (void)CompareAt(0U);
    a.outcome.ordinal_sum = 10U;
    a.held[1].ordinal = 1U;
    EXPECT_EQ(CompareAt(1000U).fault, DeviceFault::kNone);
    a.outcome.ordinal_sum = 11U;
    a.held[2].ordinal = 10U;
    EXPECT_EQ(CompareAt(4000U).fault, DeviceFault::kNone);
    const Verdict late = CompareAt(5001U);
    EXPECT_EQ(late.fault, DeviceFault::kUnmatched);
    EXPECT_EQ(late.slot, 1U);
}

TEST_F(Comparing, SelfTestFindsItsDifferenceWhateverBitsAreSet)
{
    Verifies(req::SRS_CMP_009);
    DeviceConfig config{};
    config.test_interval_us = 1U;
    // Given a voice with all bits of its data set, in cycle 1, with a guard that says nothing
    a.held[0] = HeldPair{Payload{0xFFFFFFFFU, 0xFFFFFFFFU}, 0xFFFFFFFFU, 1U};
    a.outcome.guard = GuardView::kInvalid;
    for (const std::uint32_t cycle : {0U, 1U, 0xFFFFFFFFU})
    {
        a.outcome.cycle = cycle;
        const Comparison comparison{&a.outcome, &a.outcome, &a, &a, Instant{0U}, cycle, 0xABCDU, HeldPair{}};
        ComparatorSelfTest test{};
        test.Restart(config);
        EXPECT_FALSE(test.TakeTurn(Instant{0U}));
        for (std::uint32_t number = 0U; number < 15U; ++number)
        {
            EXPECT_TRUE(test.TakeTurn(Instant{1U}));
            EXPECT_EQ(test.Run(comparator, comparison), DeviceFault::kNone) << cycle << " " << number;
        }
    }
}

} // namespace
} // namespace counterpoint
