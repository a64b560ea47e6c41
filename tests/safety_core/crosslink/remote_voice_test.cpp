// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

constexpr HeldPair kPair{Payload{0x1234U, 0x5678U}, 3U, 1U};
constexpr HeldPair kNoPair{Payload{0U, 0U}, 0U, 0U};

SlotReport PairReport(const std::uint32_t age_us, const std::uint32_t ordinal = 9U, const std::uint32_t low = 0x1234U)
{
    return SlotReport{0U,      Holding::kPair, SrdoState::kReleased, SrdoCause::kNone,
                      ordinal, age_us,         Payload{low, 0x5678U}};
}

SlotReport NothingReport(const std::uint32_t age_us)
{
    return SlotReport{0U, Holding::kNothing, SrdoState::kFaulted, SrdoCause::kSct, 0U, age_us, Payload{0U, 0U}};
}

/// CPU A in contact; the own channel holds kPair, its inverse frame on the bus at 8.0 ms.
class RemoteVoice_ : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        rig.Contact(1000U);
        rig.channel.outcome.waiting = 0U;
        rig.channel.outcome.released = 1U;
        rig.Complete(8000U, 10000U, kPair);
    }
    /// A report composed between 11.0 and 12.0 ms of the own clock.
    void Tell(const SlotReport& report)
    {
        LinkMessage word = rig.AnswerTo(10000U);
        word.reports[2] = report;
        word.released = 1U;
        rig.Hear(word, 12000U);
    }
    PeerRig rig{PeerRole::kA};
};

// Given the own pair at 8.0 ms, when the peer tells a pair of 3 to 4 ms ago (0.1 ms and 1/2048 of slack), then it is
// the own pair: the peer's data under the own ordinal.
TEST_F(RemoteVoice_, PairInTheWindowIsTheOwnOne)
{
    Verifies(req::SRS_TWO_002);
    Verifies(req::SRS_TWO_003);
    Tell(PairReport(3000U, 9U, 0x9999U));
    const HeldPair held = rig.Remote().Held(0U);
    EXPECT_EQ(held.ordinal, 3U);
    EXPECT_EQ(held.holds_pair, 1U);
    EXPECT_EQ(held.data.low, 0x9999U);
}

// Given the window [11.0 - age - 0.101, 12.0 - age + 0.101] ms, when its ends lie on 8.0 ms, then the pair is the own
// one; one microsecond beyond it is not.
TEST_F(RemoteVoice_, EndsOfTheWindowBelongToIt)
{
    Verifies(req::SRS_TWO_002);
    Tell(PairReport(2899U)); // slack 101: from 8000
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 3U);
    Tell(PairReport(2898U, 10U));
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~3U);
    Tell(PairReport(4102U, 11U)); // slack 102: to 8000
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 3U);
    Tell(PairReport(4103U, 12U));
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~3U);
}

// Given two pairs 0.5 ms apart, when both lie in the window, then the peer's pair is not taken for either.
TEST_F(RemoteVoice_, PairsWithinOneWindowAreNotMatched)
{
    Verifies(req::SRS_TWO_002);
    rig.Complete(8500U, 10000U, kPair);
    Tell(PairReport(3000U));
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~3U);
}

// Given no report, then in contact nothing matches; out of contact, for other slots and inactive ones, the own pair is
// shown.
TEST_F(RemoteVoice_, WithoutReportNothingMatches)
{
    Verifies(req::SRS_TWO_003);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~3U);
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 0U);
    rig.channel.held[1].ordinal = 77U;
    EXPECT_EQ(rig.Remote().Held(1U).ordinal, 77U);
    PeerRig alone{PeerRole::kA};
    alone.channel.held[0] = kPair;
    alone.Cycle(10000U);
    EXPECT_EQ(alone.Remote().Held(0U).ordinal, 3U);
    EXPECT_EQ(alone.remote.released, 0U);
}

// Given a pair here and none there, when the peer's discard may have come after it, then there is no difference and no
// release; when it was before, there is a difference.
TEST_F(RemoteVoice_, PairThatThePeerDiscardedIsNoDifference)
{
    Verifies(req::SRS_TWO_004);
    Verifies(req::SRS_TWO_005);
    Tell(NothingReport(3000U)); // discarded not after 9101
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 3U);
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 1U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.released, 0U);
    Tell(NothingReport(4200U));                   // not after 7902
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 3U); // the first report was as wide and is kept: the same discard
    Tell(NothingReport(14000U));
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~3U);
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 0U);
}

// Given no pair here and one there, when it may have been complete before the own discard, then there is no difference;
// else there is; with none on either side they are alike.
TEST_F(RemoteVoice_, OwnDiscardIsNoDifference)
{
    Verifies(req::SRS_TWO_004);
    rig.Own().Demote(0U); // as of 10.0 ms
    rig.channel.held[0] = kNoPair;
    Tell(PairReport(1200U)); // from 9700
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 0U);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 0U);
    Tell(PairReport(800U, 10U)); // from 10100
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 1U);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~0U);
    Tell(NothingReport(1000U));
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 0U);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 0U);
}

// Given a pair at 8.0 ms here and a discard at 10.0 ms, when the other one's discard, or its pair, may have been at
// that very instant, then there is no difference; a microsecond apart there is.
TEST_F(RemoteVoice_, DiscardAtTheInstantOfThePairIsNoDifference)
{
    Verifies(req::SRS_TWO_004);
    const auto nothing = [](const std::uint32_t age_us, const std::uint32_t ordinal)
    {
        SlotReport report = NothingReport(age_us);
        report.ordinal = ordinal; // Else it would be the report of before.
        return report;
    };
    Tell(nothing(4102U, 1U)); // slack 102: not after 8000
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 1U);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, 3U);
    Tell(nothing(4103U, 2U));
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 0U);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~3U);
    rig.Own().Demote(0U); // as of 10.0 ms
    rig.channel.held[0] = kNoPair;
    Tell(PairReport(900U, 3U)); // slack 100: from 10000
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 0U);
    Tell(PairReport(899U, 4U));
    EXPECT_EQ(rig.Remote().Held(0U).holds_pair, 1U);
    EXPECT_EQ(rig.Remote().Held(0U).ordinal, ~0U);
}

// Given a report of the same pair again, then the slot is fresh once; with a narrower window of a pair that is not
// known yet, or with other data, again.
TEST_F(RemoteVoice_, RepeatedReportIsFreshOnce)
{
    Verifies(req::SRS_TWO_003);
    Tell(PairReport(3000U));
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.fresh, 1U);
    Tell(PairReport(3000U));
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.fresh, 0U);
    Tell(PairReport(3000U, 9U, 0x1235U));
    rig.Cycle(40000U);
    EXPECT_EQ(rig.remote.fresh, 1U);
    SlotReport other = PairReport(3000U, 9U, 0x1235U);
    other.data.high = 1U;
    Tell(other);
    rig.Cycle(50000U);
    EXPECT_EQ(rig.remote.fresh, 1U);
}

TEST_F(RemoteVoice_, NarrowerWindowIsTakenWhileThePairIsNotKnown)
{
    Verifies(req::SRS_TWO_003);
    Tell(PairReport(2000U)); // [8900, 10100]: not the own pair
    rig.Cycle(20000U);
    LinkMessage word = rig.AnswerTo(10500U);
    word.reports[0] = PairReport(2300U); // [9099, 9801]: narrower
    rig.Hear(word, 12000U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.fresh, 1U);
    // The same ordinal and data a long time away is another pair.
    Tell(PairReport(900000U));
    rig.Cycle(40000U);
    EXPECT_EQ(rig.remote.fresh, 1U);
    // A window that holds the one before it is wider and the same pair.
    Tell(PairReport(900001U));
    rig.Cycle(50000U);
    EXPECT_EQ(rig.remote.fresh, 0U);
}

TEST_F(RemoteVoice_, NarrowerWindowOfAKnownPairIsNotNeeded)
{
    Verifies(req::SRS_TWO_003);
    Tell(PairReport(3500U)); // [7399, 8601]: the own pair
    rig.Cycle(20000U);
    LinkMessage word = rig.AnswerTo(10500U);
    word.reports[0] = PairReport(3800U); // [7599, 8301]
    rig.Hear(word, 12000U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.fresh, 0U);
}

// Given reports of a slot that cannot be, or without a holding, then they say nothing.
TEST_F(RemoteVoice_, EmptyReportsSayNothing)
{
    Verifies(req::SRS_TWO_014);
    SlotReport report = PairReport(3000U);
    report.slot = 64U;
    Tell(report);
    report.slot = 0U;
    report.holding = Holding::kUnknown;
    Tell(report);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.fresh, 0U);
    EXPECT_EQ(rig.remote.released, 0U);
}

// Given a pair reported and released, then the remote voice releases it; demoted here, or lost, no longer.
TEST_F(RemoteVoice_, ReleasesWhatThePeerReleases)
{
    Verifies(req::SRS_TWO_005);
    Tell(PairReport(3000U));
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.released, 1U);
    EXPECT_EQ(rig.remote.faulted, 0U);
    EXPECT_EQ(rig.remote.ordinal_sum, 0U);
    rig.Remote().Demote(0U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.released, 0U);
    Tell(PairReport(3000U));
    rig.Cycle(40000U);
    EXPECT_EQ(rig.remote.released, 1U);
    rig.Cycle(52001U);
    EXPECT_EQ(rig.remote.released, 0U);
    EXPECT_EQ(rig.remote.guard, GuardView::kInvalid);
}

// Given a fault told in several messages, then it is new once; told anew after it was gone, again.
TEST_F(RemoteVoice_, FaultIsNewOnce)
{
    Verifies(req::SRS_TWO_006);
    const auto tell = [this](SrdoMask faults, std::uint32_t at_us)
    {
        LinkMessage word = rig.AnswerTo(at_us);
        word.new_faults = faults;
        rig.Hear(word, at_us + 2000U);
        rig.Cycle(at_us + 5000U);
    };
    tell(1U, 10000U);
    EXPECT_EQ(rig.remote.new_fault, 1U);
    tell(1U, 20000U);
    EXPECT_EQ(rig.remote.new_fault, 0U);
    tell(0U, 30000U);
    tell(1U, 40000U);
    EXPECT_EQ(rig.remote.new_fault, 1U);
}

// Given a released slot, when it is agreed and matched, then the permit is B's on CPU A; unmatched it stays, not agreed
// it goes.
TEST_F(RemoteVoice_, PermitFollowsTheCommittedSlots)
{
    Verifies(req::SRS_TWO_009);
    Tell(PairReport(3000U));
    rig.Cycle(20000U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 0U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 0U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 1U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 1U);
    EXPECT_EQ(rig.Remote().Answer(100U).response, 101U * 0x85EBCA77U);
    // What it did not release it does not permit, whatever is agreed
    EXPECT_EQ(rig.Remote().Commit(Agreement{5U, 5U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 1U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 0U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 1U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{0U, 1U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 0U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 1U}, 0U), 0U);
    rig.Cycle(60000U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 0U);
    EXPECT_NE(rig.Remote().Answer(100U).response, 100U * 0x85EBCA77U);
}

// Given a report, then View tells the peer's state, cause and pair; of other slots and out of contact the own ones
// without signals.
TEST_F(RemoteVoice_, ViewTellsThePeersState)
{
    Verifies(req::SRS_TWO_003);
    rig.channel.view[1].signals = 8U;
    rig.channel.view[1].state = SrdoState::kProducer;
    Tell(PairReport(3000U, 9U, 0x77U));
    const SrdoView view = rig.Remote().View(0U);
    EXPECT_EQ(view.state, SrdoState::kReleased);
    EXPECT_EQ(view.first_cause, SrdoCause::kNone);
    EXPECT_EQ(view.data.low, 0x77U);
    EXPECT_EQ(view.ordinal, 3U);
    EXPECT_EQ(view.holds_pair, 1U);
    EXPECT_EQ(rig.Remote().View(1U).signals, 0U);
    EXPECT_EQ(rig.Remote().View(1U).state, SrdoState::kProducer);
    PeerRig alone{PeerRole::kA};
    alone.channel.view[0].state = SrdoState::kWaiting;
    alone.Cycle(10000U);
    EXPECT_EQ(alone.Remote().View(0U).state, SrdoState::kWaiting);
}

} // namespace
} // namespace counterpoint
