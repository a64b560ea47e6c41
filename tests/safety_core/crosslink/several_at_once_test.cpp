// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What happens twice, or together with something else: neither hides the other one.
#include "tests/safety_core/crosslink/wide_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>

namespace counterpoint
{
namespace
{

/// CPU A in contact, with consumers in slots 5 and 50.
class SeveralAtOnce : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        rig.Cycle(1000U);
        rig.Contact(2000U);
        rig.channel.outcome.waiting = MaskOf({5U, 50U});
        rig.Cycle(5000U);
    }
    /// What the peer tells of slot 5, between 11 and 12 ms; whether that is news is shown by the next cycle.
    [[nodiscard]] bool IsNews(const SlotReport& report)
    {
        rig.Tell({report}, 0U);
        rig.Cycle(20000U);
        return rig.remote.fresh == MaskOf({5U});
    }
    WideRig rig{PeerRole::kA};
};

// Given a fault of slot 5 in each of two cycles, when both are told by one message, or the second one while the first
// is carried, then it is told as a fault.
TEST_F(SeveralAtOnce, SecondFaultDoesNotTakeTheFirstBack)
{
    Verifies(req::SRS_TWO_006);
    rig.channel.outcome.new_fault = MaskOf({5U});
    rig.Cycle(10000U);
    rig.Cycle(11000U);
    EXPECT_EQ(rig.Say(12000U).new_faults, MaskOf({5U}));
    rig.Cycle(13000U);
    EXPECT_EQ(rig.Say(14000U).new_faults, MaskOf({5U}));
}

// Given a fault that message 2 carries, when the peer echoes 2 while 3 is the newest, then message 4 carries it no
// more.
TEST_F(SeveralAtOnce, EchoOfTheMessageThatCarriedTheFaultIsEnough)
{
    Verifies(req::SRS_TWO_006);
    rig.channel.outcome.new_fault = MaskOf({5U});
    rig.Cycle(10000U);
    rig.channel.outcome.new_fault = 0U;
    const LinkMessage second = rig.Say(10000U);
    EXPECT_EQ(rig.Say(11000U).new_faults, MaskOf({5U}));
    rig.said = second;
    rig.Hear(rig.Word(12000U), 13000U);
    EXPECT_EQ(rig.Say(14000U).new_faults, 0U);
}

// Given a fault that message 2 carries, when the echo is half the circle of numbers ahead, then it is one before.
TEST_F(SeveralAtOnce, EchoIsModular)
{
    Verifies(req::SRS_TWO_006);
    rig.channel.outcome.new_fault = MaskOf({5U});
    rig.Cycle(10000U);
    rig.channel.outcome.new_fault = 0U;
    ASSERT_EQ(rig.Say(10000U).sequence, 2U);
    LinkMessage word = rig.Word(12000U);
    word.echo.sequence = 0x80000002U;
    rig.Hear(word, 13000U);
    EXPECT_EQ(rig.Say(14000U).new_faults, MaskOf({5U}));
    word = rig.Word(15000U);
    word.echo.sequence = 0x80000001U;
    rig.Hear(word, 16000U);
    EXPECT_EQ(rig.Say(17000U).new_faults, 0U);
}

// Given the peer's fault told, gone and told anew before the next cycle, then that cycle shows it.
TEST_F(SeveralAtOnce, FaultToldTwiceWithinACycleIsShown)
{
    Verifies(req::SRS_TWO_006);
    std::uint32_t now_us = 10000U;
    for (const SrdoMask faults : {MaskOf({5U}), SrdoMask{0U}, MaskOf({5U})})
    {
        LinkMessage word = rig.AnswerTo(now_us);
        word.new_faults = faults;
        rig.Hear(word, now_us + 1000U);
        now_us += 2000U;
    }
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.new_fault, MaskOf({5U}));
}

// Given two new pairs of slot 5 told before the next cycle, then that cycle shows it fresh.
TEST_F(SeveralAtOnce, TwoPairsWithinACycleAreFresh)
{
    Verifies(req::SRS_TWO_003);
    rig.Tell({PairReport(5U, 3000U, 1U)}, 0U);
    EXPECT_TRUE(IsNews(PairReport(5U, 3000U, 2U)));
}

// Given a report whose differences have the same bits in both halves of the data, in ordinal and data, or in ordinal
// and holding, then it is news.
TEST_F(SeveralAtOnce, DifferencesOfTheSameBitsInAReportAreNews)
{
    Verifies(req::SRS_TWO_003);
    const SlotReport first = PairReport(5U, 3000U, 8U);
    EXPECT_TRUE(IsNews(first));
    EXPECT_FALSE(IsNews(first));
    SlotReport second = first;
    second.data = Payload{9U, 1U};
    EXPECT_TRUE(IsNews(second));
    SlotReport third = second;
    third.data.low = 8U;
    third.ordinal = first.ordinal ^ 1U;
    EXPECT_TRUE(IsNews(third));
    SlotReport fourth = third;
    fourth.holding = Holding::kNothing;
    fourth.ordinal = third.ordinal ^ 0xFFU;
    EXPECT_TRUE(IsNews(fourth));
}

// Given a pair of slot 5 that is known, when a narrower window of it is told, then it is not needed.
TEST_F(SeveralAtOnce, PairIsKnownByTheMomentsOfItsOwnSlot)
{
    Verifies(req::SRS_TWO_003);
    rig.Hold(5U, 8000U, 3U);
    rig.Cycle(10000U);
    EXPECT_TRUE(IsNews(PairReport(5U, 3500U, 1U))); // [7399, 8601] us: the own pair
    LinkMessage word = rig.AnswerTo(10500U);
    word.reports[0] = PairReport(5U, 3800U, 1U); // [7599, 8301]
    rig.Hear(word, 12000U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.fresh, 0U);
}

// Given pairs in both slots, when the peer's slot 5 holds nothing any more, then slot 50 alone is released.
TEST_F(SeveralAtOnce, SlotThatHoldsNothingChangesNoOther)
{
    Verifies(req::SRS_TWO_005);
    const SrdoMask all = ~SrdoMask{0U};
    rig.Tell({PairReport(5U, 3000U, 1U), PairReport(50U, 3000U, 1U)}, all);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.released, MaskOf({5U, 50U}));
    SlotReport nothing = PairReport(5U, 3000U, 1U);
    nothing.holding = Holding::kNothing;
    rig.Tell({nothing}, all);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.released, MaskOf({50U}));
    // Nor when it held nothing before
    rig.Tell({nothing}, all);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.released, MaskOf({50U}));
}

// Given a pair of slot 5 at 8.0 ms here, when the peer discarded its own not after 7.9 ms, then that excuses nothing;
// the view tells the same.
TEST_F(SeveralAtOnce, PairIsExcusedByTheMomentOfItsOwnSlot)
{
    Verifies(req::SRS_TWO_004);
    rig.Hold(5U, 8000U, 3U);
    rig.Cycle(10000U);
    SlotReport nothing = PairReport(5U, 4200U, 0U);
    nothing.holding = Holding::kNothing;
    rig.Tell({nothing}, 0U);
    EXPECT_EQ(rig.Remote().Held(5U).holds_pair, 0U);
    EXPECT_EQ(rig.Remote().Held(5U).ordinal, ~3U);
    EXPECT_EQ(rig.Remote().View(5U).holds_pair, 0U);
    EXPECT_EQ(rig.Remote().View(5U).ordinal, ~3U);
}

// Given that slot 5 was discarded here at 5 ms and slot 0 at 20 ms, when the peer tells a pair of slot 5 from 7.9 ms
// on, then that is a difference.
TEST_F(SeveralAtOnce, DiscardOfAnotherSlotExcusesNothing)
{
    Verifies(req::SRS_TWO_004);
    rig.Own().Demote(5U);
    rig.Cycle(20000U);
    rig.Own().Demote(0U);
    rig.Tell({PairReport(5U, 3000U, 1U)}, 0U);
    EXPECT_EQ(rig.Remote().Held(5U).holds_pair, 1U);
    EXPECT_EQ(rig.Remote().Held(5U).ordinal, ~0U);
}

// Given a slot that is no consumer, then in contact the remote voice shows the data of the own channel.
TEST_F(SeveralAtOnce, SlotThatIsNoConsumerShowsTheOwnData)
{
    Verifies(req::SRS_TWO_003);
    rig.channel.held[2] = HeldPair{Payload{0x55U, 0x66U}, 0U, 0U};
    EXPECT_EQ(rig.Remote().Held(2U).data.low, 0x55U);
    EXPECT_EQ(rig.Remote().Held(2U).data.high, 0x66U);
}

// Given a released slot, when it is agreed and matched in two cycles, then the permit stays.
TEST_F(SeveralAtOnce, PermitStaysWhileMatched)
{
    Verifies(req::SRS_TWO_009);
    const SrdoMask bit = MaskOf({5U});
    rig.Tell({PairReport(5U, 3000U, 1U)}, bit);
    for (std::uint32_t now_us = 20000U; now_us < 23000U; now_us += 1000U)
    {
        rig.Cycle(now_us);
        EXPECT_EQ(rig.Remote().Commit(Agreement{bit, bit}, 0U), 0U);
        EXPECT_EQ(rig.Remote().Answer(100U).mask, bit);
    }
}

// Given the peer's check of slot 0 told twice, then it is given; once both CPUs were not operational, the own one.
TEST_F(SeveralAtOnce, CheckToldTwiceIsGivenWhileOperational)
{
    Verifies(req::SRS_TWO_210);
    LinkMessage word = rig.AnswerTo(6000U);
    word.check = SlotCheck{0U, {ConfigFault::kSignature, 0x9999U}};
    rig.Hear(word, 8000U);
    EXPECT_EQ(rig.Remote().Recheck(0U).signature, 0x9999U);
    word.sequence = ++rig.sequence;
    rig.Hear(word, 9000U);
    EXPECT_EQ(rig.Remote().Recheck(0U).signature, 0x9999U);
    // When the own CPU leaves, then the peer too: with a check told in the same message
    rig.channel.outcome.not_operational = 1U;
    rig.Cycle(10000U);
    word = rig.AnswerTo(11000U);
    word.statement.not_operational = 1U;
    word.check = SlotCheck{5U, {ConfigFault::kSignature, 0x5555U}};
    rig.Hear(word, 13000U);
    EXPECT_EQ(rig.Remote().Recheck(5U).signature, 0x1234U);
    // When both are back, then the check of slot 0 is forgotten
    rig.channel.outcome.not_operational = 0U;
    rig.Cycle(20000U);
    rig.Hear(rig.AnswerTo(21000U), 23000U);
    EXPECT_EQ(rig.Remote().Recheck(5U).signature, 0x5555U);
    EXPECT_EQ(rig.Remote().Recheck(0U).signature, 0x1234U);
}

// Given a message that tells two neighbouring members wrong in the same bits for longer than the discrepancy time, then
// that is a disagreement, as it is when the own CPU alone is not operational.
TEST_F(SeveralAtOnce, WrongStatementsDoNotCancelEachOther)
{
    Verifies(req::SRS_TWO_007);
    const auto after = [](const Statement& statement, const std::uint8_t not_operational)
    {
        PeerRig cpu{PeerRole::kA};
        cpu.channel.outcome.not_operational = not_operational;
        for (std::uint32_t now_us = 1000U; now_us < 71000U; now_us += 10000U)
        {
            cpu.Cycle(now_us);
            LinkMessage word = cpu.AnswerTo(now_us + 1000U);
            word.statement = statement;
            cpu.Hear(word, now_us + 3000U);
        }
        return cpu.remote.guard;
    };
    // A5h and 0Fh differ in AAh
    EXPECT_EQ(after(Statement{GuardView::kUnconfigured, 0xABU, 1U, 1U, 0U}, 0U), GuardView::kInvalid);
    EXPECT_EQ(after(Statement{GuardView::kConfigured, 2U, 2U, 1U, 0U}, 0U), GuardView::kInvalid);
    EXPECT_EQ(after(Statement{GuardView::kConfigured, 1U, 2U, 2U, 0U}, 0U), GuardView::kInvalid);
    EXPECT_EQ(after(Statement{GuardView::kConfigured, 1U, 1U, 0U, 1U}, 0U), GuardView::kInvalid);
    EXPECT_EQ(after(Statement{GuardView::kConfigured, 1U, 1U, 1U, 0U}, 1U), GuardView::kInvalid);
    EXPECT_EQ(after(Statement{GuardView::kConfigured, 1U, 1U, 1U, 1U}, 1U), GuardView::kConfigured);
}

// Given a channel that calls one consumer two of released, faulted and waiting at once, then it is a consumer.
TEST_F(SeveralAtOnce, ConsumerInTwoStatesIsOne)
{
    Verifies(req::SRS_TWO_014);
    rig.channel.outcome.waiting = 0U;
    rig.channel.outcome.released = MaskOf({5U});
    rig.channel.outcome.faulted = MaskOf({5U});
    rig.Cycle(10000U);
    EXPECT_EQ(rig.Say(10000U).reports[0].slot, 5U);
    rig.channel.outcome.waiting = MaskOf({5U});
    rig.channel.outcome.released = 0U;
    rig.Cycle(11000U);
    EXPECT_EQ(rig.Say(11000U).reports[0].slot, 5U);
    rig.channel.outcome.faulted = 0U;
    rig.channel.outcome.released = MaskOf({5U});
    rig.Cycle(12000U);
    EXPECT_EQ(rig.Say(12000U).reports[0].slot, 5U);
}

// Given six consumers, then news are told before the others: a pair with a fault, a pair of a slot whose last news was
// not told yet, and a demotion.
TEST_F(SeveralAtOnce, NewsOfOneSlotAreToldWhateverTheyAre)
{
    Verifies(req::SRS_TWO_014);
    WideRig cpu{PeerRole::kA};
    cpu.channel.outcome.waiting = MaskOf({0U, 31U, 32U, 47U, 48U, 63U});
    cpu.Cycle(10000U); // Entering: all are news.
    const auto told = [&cpu]
    {
        const LinkMessage said = cpu.Say(10000U);
        return std::array<std::uint32_t, 4>{said.reports[0].slot, said.reports[1].slot, said.reports[2].slot,
                                            said.reports[3].slot};
    };
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{31U, 32U, 47U, 48U}));
    cpu.channel.outcome.fresh = MaskOf({63U}); // Its entering was not told yet.
    cpu.Cycle(20000U);
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{63U, 0U, 31U, 32U}));
    cpu.channel.outcome.fresh = MaskOf({31U});
    cpu.channel.outcome.new_fault = MaskOf({31U});
    cpu.Cycle(30000U);
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{31U, 32U, 47U, 48U}));
    cpu.Own().Demote(47U);
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{47U, 48U, 63U, 0U}));
}

// Given pairs in slots 5 (at 8 ms) and 50 (at 9 ms), then each report has ordinal, data, age, state and cause of its
// slot.
TEST_F(SeveralAtOnce, EachReportIsThatOfItsSlot)
{
    Verifies(req::SRS_TWO_002);
    Verifies(req::SRS_TWO_014);
    rig.Hold(5U, 8000U, 3U);
    rig.Hold(50U, 9000U, 7U);
    rig.channel.view[5].state = SrdoState::kReleased;
    rig.channel.view[50].state = SrdoState::kWaiting;
    rig.channel.view[50].first_cause = SrdoCause::kSct;
    rig.Cycle(10000U);
    const LinkMessage said = rig.Say(11000U);
    EXPECT_EQ(said.reports[0].slot, 5U);
    EXPECT_EQ(said.reports[0].ordinal, 3U);
    EXPECT_EQ(said.reports[0].data.low, 0x105U);
    EXPECT_EQ(said.reports[0].age_us, 3000U);
    EXPECT_EQ(said.reports[0].state, SrdoState::kReleased);
    EXPECT_EQ(said.reports[1].slot, 50U);
    EXPECT_EQ(said.reports[1].ordinal, 7U);
    EXPECT_EQ(said.reports[1].data.low, 0x132U);
    EXPECT_EQ(said.reports[1].age_us, 2000U);
    EXPECT_EQ(said.reports[1].state, SrdoState::kWaiting);
    EXPECT_EQ(said.reports[1].cause, SrdoCause::kSct);
}

} // namespace
} // namespace counterpoint
