// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

constexpr HeldPair kPair{Payload{0x1234U, 0x5678U}, 3U, 1U};

// Given either CPU, when the kernel calls the own voice, then the channel has the call and the kernel the answer.
TEST(OwnVoice, PassesCallsOn)
{
    Verifies(req::SRS_TWO_001);
    PeerRig rig{PeerRole::kA};
    Channel& own = rig.Own();
    EXPECT_EQ(rig.channel.restarts, 1);
    own.Store(ConfigItem{{0U, ConfigField::kSct, 0U}, 25U});
    EXPECT_EQ(rig.channel.stored.size(), 1U);
    EXPECT_EQ(own.Load(ConfigAddress{1U, ConfigField::kCobId1, 0U}).value, 0x103U);
    EXPECT_EQ(own.Room().slots, 7U);
    own.SetFields(0U, StaticFields{nullptr, nullptr});
    EXPECT_EQ(rig.channel.fields_set, 1);
    EXPECT_EQ(own.Digest(1U, DeviceDigest{5U}).value, 25U);
    EXPECT_EQ(own.Validate(0U).signature, 0x1234U);
    EXPECT_EQ(own.Recheck(0U).fault, ConfigFault::kNone);
    own.OnFrame(PeerRig::Frame(0x101U), Instant{1U});
    EXPECT_EQ(rig.channel.frames, 1);
    rig.channel.held[0] = kPair;
    rig.channel.view[0].state = SrdoState::kReleased;
    EXPECT_EQ(own.Held(0U).ordinal, 3U);
    EXPECT_EQ(own.View(0U).state, SrdoState::kReleased);
    own.Demote(0U);
    EXPECT_EQ(rig.channel.demoted.size(), 1U);
    rig.channel.found = 4U;
    EXPECT_EQ(own.Commit(Agreement{1U, 2U}, 8U), 4U);
    EXPECT_EQ(rig.channel.committed.matched, 2U);
    EXPECT_EQ(rig.channel.examined, 8U);
    EXPECT_EQ(own.Answer(9U).response, 9U);
    EXPECT_EQ(own.OnConfirm(PeerRig::Frame(0x200U), Instant{1U}).step, ConfirmStep::kNone);
    own.OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
    EXPECT_EQ(rig.channel.transmit_faults.size(), 1U);
}

// Given CPU A, when the channel tells its cycle, then the kernel sees all of it but the level of the faults and the
// sum.
TEST(OwnVoice, LeaderShowsItsCycleWithoutLevels)
{
    Verifies(req::SRS_TWO_001);
    Verifies(req::SRS_TWO_010);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.due = 2U;
    rig.Cycle(500U);
    EXPECT_EQ(rig.own.due, 0U); // Nobody to send with yet.
    rig.Contact(1000U);
    rig.channel.outcome.faulted = 1U;
    rig.channel.outcome.waiting = 0U;
    rig.channel.outcome.ordinal_sum = 44U;
    rig.channel.outcome.due = 2U;
    rig.channel.outcome.refresh = 2U;
    rig.channel.outcome.cycle = 8U;
    rig.Cycle(10000U);
    EXPECT_EQ(rig.own.faulted, 0U);
    EXPECT_EQ(rig.own.ordinal_sum, 0U);
    EXPECT_EQ(rig.own.refresh, 0U);
    EXPECT_EQ(rig.own.due, 2U);
    EXPECT_EQ(rig.own.cycle, 8U);
    EXPECT_EQ(rig.own.sct_checked, 1U);
    EXPECT_EQ(rig.own.guard, GuardView::kConfigured);
    CycleInput standing{};
    standing.stand = 2U;
    static_cast<void>(rig.Own().OnCycle(standing));
    EXPECT_EQ(rig.channel.last_input.stand, 0U);
}

// Given CPU B, when the counts change, then both voices show those of the cycle before; a stale guard shows at once.
TEST(OwnVoice, FollowerShowsTheCountsOfTheCycleBefore)
{
    Verifies(req::SRS_TWO_001);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(10000U);
    EXPECT_EQ(rig.own.not_operational, 1U);
    EXPECT_EQ(rig.own.sct_checked, 0U);
    EXPECT_EQ(rig.own.guard, GuardView::kUnconfigured);
    EXPECT_EQ(rig.remote.not_operational, 1U);
    EXPECT_EQ(rig.remote.guard, GuardView::kUnconfigured);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.own.not_operational, 0U);
    EXPECT_EQ(rig.own.sct_checked, 1U);
    EXPECT_EQ(rig.own.is_tx, 1U);
    EXPECT_EQ(rig.own.is_invalid, 1U);
    EXPECT_EQ(rig.remote.sct_checked, 1U);
    EXPECT_EQ(rig.remote.cycle, 2U);
    rig.channel.outcome.guard = GuardView::kStale;
    rig.Cycle(30000U);
    EXPECT_EQ(rig.own.guard, GuardView::kStale);
    EXPECT_EQ(rig.remote.guard, GuardView::kConfigured);
}

// Given a held pair whose inverse frame was on the bus at 8 ms, when it is reported at 11 ms, then its age is 3 ms.
TEST(OwnVoice, ReportsTheAgeOfThePair)
{
    Verifies(req::SRS_TWO_002);
    Verifies(req::SRS_TWO_014);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.waiting = 0U;
    rig.channel.outcome.released = 1U;
    rig.channel.view[0].state = SrdoState::kReleased;
    rig.channel.view[0].first_cause = SrdoCause::kSct;
    rig.Complete(8000U, 10000U, kPair);
    const LinkMessage said = rig.Say(11000U);
    EXPECT_EQ(said.reports[0].slot, 0U);
    EXPECT_EQ(said.reports[0].holding, Holding::kPair);
    EXPECT_EQ(said.reports[0].state, SrdoState::kReleased);
    EXPECT_EQ(said.reports[0].cause, SrdoCause::kSct);
    EXPECT_EQ(said.reports[0].ordinal, 3U);
    EXPECT_EQ(said.reports[0].age_us, 3000U);
    EXPECT_EQ(said.reports[0].data.low, 0x1234U);
    EXPECT_EQ(said.reports[1].slot, kNoSlot);
    EXPECT_EQ(said.released, 1U);
}

// Given a held pair, when frames come that are none of its, or of no SRDO, then its moment stays; a newer inverse frame
// that the channel has not shown fresh does not change it either.
TEST(OwnVoice, OnlyAFreshPairHasANewMoment)
{
    Verifies(req::SRS_TWO_002);
    PeerRig rig{PeerRole::kA};
    rig.Complete(8000U, 10000U, kPair);
    CanFrame remote = PeerRig::Frame(0x102U);
    remote.kind = FrameKind::kRemote;
    rig.Own().OnFrame(remote, Instant{10100U});
    rig.Own().OnFrame(PeerRig::Frame(0x100U), Instant{10200U});
    rig.Own().OnFrame(PeerRig::Frame(0x180U), Instant{10200U});
    rig.Own().OnFrame(PeerRig::Frame(0x182U), Instant{10200U});
    rig.Own().OnFrame(PeerRig::Frame(0x101U), Instant{10300U});
    EXPECT_EQ(rig.Say(11000U).reports[0].age_us, 3000U);
    rig.Own().OnFrame(PeerRig::Frame(0x102U), Instant{11500U});
    EXPECT_EQ(rig.Say(12000U).reports[0].age_us, 4000U);
}

// Given a consumer that holds nothing, when it entered OPERATIONAL, has a new fault or is demoted, then its report
// tells how long ago that was.
TEST(OwnVoice, ReportsTheAgeOfTheLastDiscard)
{
    Verifies(req::SRS_TWO_004);
    PeerRig rig{PeerRole::kA};
    rig.Cycle(10000U);
    EXPECT_EQ(rig.Say(11000U).reports[0].age_us, 1000U);
    EXPECT_EQ(rig.Say(11000U).reports[0].holding, Holding::kNothing);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.Say(21000U).reports[0].age_us, 11000U);
    rig.channel.outcome.new_fault = 1U;
    rig.Cycle(30000U);
    rig.channel.outcome.new_fault = 0U;
    EXPECT_EQ(rig.Say(31000U).reports[0].age_us, 1000U);
    rig.Cycle(40000U);
    rig.Own().Demote(0U);
    EXPECT_EQ(rig.Say(41000U).reports[0].age_us, 1000U);
    rig.channel.outcome.not_operational = 1U;
    rig.Cycle(50000U);
    rig.channel.outcome.not_operational = 0U;
    rig.Cycle(60000U);
    EXPECT_EQ(rig.Say(61000U).reports[0].age_us, 1000U);
}

// Given a discard long ago, when cycles go on, then its age stays at 2^29 us, and 60 minutes later still.
TEST(OwnVoice, AgeOfADiscardDoesNotComeRound)
{
    Verifies(req::SRS_TWO_015);
    PeerRig rig{PeerRole::kA};
    rig.Cycle(10000U);
    std::uint32_t now_us = 10000U;
    for (std::uint32_t step = 0U; step < 3600U; ++step)
    {
        now_us += 1000000U;
        rig.Cycle(now_us);
    }
    EXPECT_LE(rig.Say(now_us).reports[0].age_us, 0x20000000U + 3000000U);
    EXPECT_GE(rig.Say(now_us).reports[0].age_us, 0x20000000U);
}

// Given a discard of slot 2 longer than 2^29 us ago, when all three slots were swept, then its age is 2^29 us as of its
// own cycle.
TEST(OwnVoice, AgeOfADiscardOfEachSlotIsLimited)
{
    Verifies(req::SRS_TWO_015);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.waiting = 4U;
    rig.Cycle(10000U);
    for (std::uint32_t cycle = 0U; cycle < 3U; ++cycle)
    {
        rig.Cycle(0x30000000U + (cycle * 10000U));
    }
    const LinkMessage said = rig.Say(0x30000000U + 20000U);
    EXPECT_EQ(said.reports[0].slot, 2U);
    EXPECT_EQ(said.reports[0].age_us, 0x20000000U + 10000U); // Slot 2 was swept in the second of these cycles.
}

// Given a discard 100 us ago at a late hour, and one just 2^29 us ago, then both stay; a microsecond later the older
// one moves on.
TEST(PairMoments, OnlyAnOldDiscardIsMovedOn)
{
    Verifies(req::SRS_TWO_015);
    PairMoments moments{};
    moments.Discard(4U, Instant{0x30000000U});
    moments.LimitAge(2U, Instant{0x30000064U});
    EXPECT_EQ(moments.DiscardedAt(2U).us, 0x30000000U);
    moments.LimitAge(2U, Instant{0x50000000U});
    EXPECT_EQ(moments.DiscardedAt(2U).us, 0x30000000U);
    moments.LimitAge(2U, Instant{0x50000001U});
    EXPECT_EQ(moments.DiscardedAt(2U).us, 0x30000001U);
}

// Given three SRDOs, when as many cycles are over, then the digest of all is told.
TEST(OwnVoice, DigestIsThatOfTheLastWholeSweep)
{
    Verifies(req::SRS_TWO_007);
    PeerRig rig{PeerRole::kA};
    rig.Cycle(10000U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.Say(20000U).digest.value, 0U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.Say(30000U).digest.value, 321U);
    rig.channel.digest_of[0] = 4U;
    rig.Cycle(40000U);
    EXPECT_EQ(rig.Say(40000U).digest.value, 321U);
}

// Given a check of an SRDO by the guard, then the next message tells it.
TEST(OwnVoice, NewestCheckIsTold)
{
    Verifies(req::SRS_TWO_008);
    PeerRig rig{PeerRole::kA};
    rig.channel.check = CheckResult{ConfigFault::kSignature, 0x4321U};
    static_cast<void>(rig.Own().Recheck(1U));
    const LinkMessage said = rig.Say(10000U);
    EXPECT_EQ(said.check.slot, 1U);
    EXPECT_EQ(said.check.result.fault, ConfigFault::kSignature);
    EXPECT_EQ(said.check.result.signature, 0x4321U);
}

// Given CPU A with a due producer, when it is prepared, then it is told due before and no longer after.
TEST(OwnVoice, LeaderTellsWhatIsDueAndNotPrepared)
{
    Verifies(req::SRS_TWO_213);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.due = 2U;
    rig.Cycle(10000U);
    EXPECT_EQ(rig.Say(10000U).due, 2U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    EXPECT_EQ(rig.Own().Prepare(1U).normal.identifier, 0x103U);
    EXPECT_EQ(rig.Say(11000U).due, 0U);
}

// Given CPU A, when the follower tells slots due, then nothing is requested of the leader.
TEST(OwnVoice, LeaderIsNotLed)
{
    Verifies(req::SRS_TWO_212);
    PeerRig rig{PeerRole::kA};
    LinkMessage word = rig.AnswerTo(5000U);
    word.due = 2U;
    rig.Hear(word, 7000U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.channel.last_input.request, 0U);
    EXPECT_EQ(rig.channel.last_input.stand, 0U);
}

// Given CPU B, when the leader tells a slot due, then it is requested, shown due by both voices, and its frame is
// armed; when its normal frame was confirmed it is answered, and done with a word composed after that.
TEST(OwnVoice, FollowerArmsWhatTheLeaderWants)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_150);
    Verifies(req::SRS_TWO_151);
    Verifies(req::SRS_TWO_012);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    LinkMessage word = rig.AnswerTo(5000U);
    word.due = 2U;
    rig.Hear(word, 7000U);
    rig.channel.outcome.due = 2U;
    rig.Cycle(10000U);
    EXPECT_EQ(rig.channel.last_input.request, 2U);
    EXPECT_EQ(rig.remote.due, 2U);
    EXPECT_EQ(rig.own.due, 2U);
    // Prepare: the kernel asks the remote voice first.
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    const PreparedPair ahead = rig.Remote().Prepare(1U);
    const PreparedPair own = rig.Own().Prepare(1U);
    EXPECT_EQ(ahead.status, PrepareStatus::kReady);
    EXPECT_EQ(own.status, PrepareStatus::kReady);
    for (const PreparedPair& empty : {ahead, own})
    {
        EXPECT_EQ(empty.normal.kind, FrameKind::kInvalid);
        EXPECT_EQ(empty.normal.identifier, 0U);
        EXPECT_EQ(empty.normal.length_bytes, 0U);
    }
    LinkMessage said = rig.Say(10500U);
    EXPECT_EQ(said.armed[0].slot, 1U);
    EXPECT_EQ(said.armed[0].number, 1U);
    EXPECT_EQ(said.armed[0].frame.identifier, 0x103U);
    // While armed nothing is wanted, and its schedule stands.
    rig.channel.outcome.due = 0U;
    rig.Cycle(20000U);
    EXPECT_EQ(rig.channel.last_input.request, 0U);
    EXPECT_EQ(rig.channel.last_input.stand, 2U);
    EXPECT_EQ(rig.remote.due, 0U);
    // Confirmed at 21 ms: no longer told, but a word composed before that still does not start another.
    rig.channel.confirmation = Confirmation{1U, ConfirmStep::kNormal};
    static_cast<void>(rig.Own().OnConfirm(PeerRig::Frame(0x103U), Instant{21000U}));
    said = rig.Say(21500U);
    EXPECT_EQ(said.armed[0].slot, kNoSlot);
    said.stamp = Instant{20000U};
    rig.said = said;
    word = rig.Word(21900U);
    word.echo.hold_us = 999U;
    word.due = 2U;
    rig.Hear(word, 22000U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.due, 0U);
    word = rig.AnswerTo(30500U);
    word.due = 2U;
    rig.Hear(word, 32000U);
    rig.Cycle(40000U);
    EXPECT_EQ(rig.remote.due, 2U);
}

// Given CPU B with frames of slots 1 and 2 armed, then the message tells each in a place of its own.
TEST(OwnVoice, BothArmedFramesAreTold)
{
    Verifies(req::SRS_TWO_151);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(10000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    LinkMessage said = rig.Say(10500U);
    EXPECT_EQ(said.armed[0].slot, 1U);
    EXPECT_EQ(said.armed[1].slot, kNoSlot);
    rig.channel.prepared.normal = PeerRig::Frame(0x105U);
    static_cast<void>(rig.Remote().Prepare(2U));
    said = rig.Say(11000U);
    EXPECT_EQ(said.armed[1].slot, 2U);
    EXPECT_EQ(said.armed[1].number, 2U);
    EXPECT_EQ(said.armed[1].frame.identifier, 0x105U);
    // The inverse frame on the bus is no answer of the leader
    rig.channel.confirmation = Confirmation{1U, ConfirmStep::kPair};
    static_cast<void>(rig.Own().OnConfirm(PeerRig::Frame(0x104U), Instant{12000U}));
    EXPECT_EQ(rig.Say(12000U).armed[0].slot, 1U);
}

// Given CPU B with slot 1 armed, when the channel calls it due although the leader does not, then it stands; and what
// the application and the leader both ask for is requested.
TEST(OwnVoice, ReasonsToStandAndToRequestDoNotCancelEachOther)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_150);
    PeerRig rig{PeerRole::kB};
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    rig.channel.outcome.due = 2U;
    rig.Cycle(1000U);
    static_cast<void>(rig.Remote().Prepare(1U));
    rig.Cycle(2000U);
    EXPECT_EQ(rig.channel.last_input.stand, 2U);
    LinkMessage word = rig.AnswerTo(5000U);
    word.due = 4U;
    rig.Hear(word, 7000U);
    CycleInput input{};
    input.now = Instant{10000U};
    input.request = 4U;
    static_cast<void>(rig.Own().OnCycle(input));
    EXPECT_EQ(rig.channel.last_input.request, 4U);
}

// Given an armed frame and clocks past 2^31 us, when one message tells it given up and its slot due anew, then the slot
// is requested: a refusal is older than the message.
TEST(OwnVoice, RefusedSlotIsWantedAgainBySameMessage)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_215);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(0x90000000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    LinkMessage word = rig.AnswerTo(0x90001000U);
    word.refusal = Refusal{1U, SrdoCause::kNotInverse};
    word.due = 2U;
    rig.Hear(word, 0x90001000U + 2000U);
    ASSERT_EQ(rig.channel.transmit_faults.size(), 1U);
    rig.Cycle(0x90002000U);
    EXPECT_EQ(rig.channel.last_input.request, 2U);
}

// Given CPU B, when its own schedule is due and the leader's is not, then it is not shown and stands in the next cycle.
TEST(OwnVoice, FollowerWaitsForTheLeader)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_150);
    PeerRig rig{PeerRole::kB};
    rig.channel.outcome.due = 2U;
    rig.Cycle(10000U);
    EXPECT_EQ(rig.own.due, 0U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.channel.last_input.stand, 2U);
}

// Given CPU B, when the channel has nothing to send, then its status is shown and nothing is armed.
TEST(OwnVoice, FollowerArmsOnlyWhatIsReady)
{
    Verifies(req::SRS_TWO_151);
    PeerRig rig{PeerRole::kB};
    rig.channel.prepared = PreparedPair{CanFrame{}, PrepareStatus::kNotProducer};
    EXPECT_EQ(rig.Remote().Prepare(1U).status, PrepareStatus::kNotProducer);
    EXPECT_EQ(rig.Own().Prepare(1U).status, PrepareStatus::kNotProducer);
    EXPECT_EQ(rig.Say(10000U).armed[0].slot, kNoSlot);
}

// Given a frame armed in the cycle at 30 ms, when its SRVT of 20 ms is over by then, then it is told no more.
TEST(OwnVoice, FollowerGivesUpWhatNobodyAnswers)
{
    Verifies(req::SRS_TWO_151);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(30000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    EXPECT_EQ(rig.Say(50000U).armed[0].slot, 1U);
    EXPECT_EQ(rig.Say(50001U).armed[0].slot, kNoSlot);
}

// Given an armed frame, when the leader tells its number as given up, then the channel gives it up for the same cause
// and it is answered; another number changes nothing.
TEST(OwnVoice, FollowerGivesUpWhatTheLeaderGaveUp)
{
    Verifies(req::SRS_TWO_215);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    LinkMessage word = rig.AnswerTo(5000U);
    word.refusal = Refusal{2U, SrdoCause::kNotInverse};
    rig.Hear(word, 7000U);
    EXPECT_TRUE(rig.channel.transmit_faults.empty());
    word = rig.Word(7000U);
    word.refusal = Refusal{1U, SrdoCause::kNotInverse};
    rig.Hear(word, 8000U);
    ASSERT_EQ(rig.channel.transmit_faults.size(), 1U);
    EXPECT_EQ(rig.channel.transmit_faults[0].first, 1U);
    EXPECT_EQ(rig.channel.transmit_faults[0].second, SrdoCause::kNotInverse);
    EXPECT_EQ(rig.Say(9000U).armed[0].slot, kNoSlot);
    word = rig.Word(9500U);
    word.refusal = Refusal{1U, SrdoCause::kNotInverse};
    rig.Hear(word, 10000U);
    EXPECT_EQ(rig.channel.transmit_faults.size(), 1U);
}

// Given CPU B and three slots that the leader and the channel call due, then all are requested, and only as many are
// shown as armed frames have room for: two, then one.
TEST(OwnVoice, FollowerShowsAsManyAsArmedFramesHaveRoomFor)
{
    Verifies(req::SRS_TWO_011);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    LinkMessage word = rig.AnswerTo(5000U);
    word.due = 7U;
    rig.Hear(word, 7000U);
    rig.channel.outcome.due = 7U;
    rig.Cycle(10000U);
    EXPECT_EQ(rig.channel.last_input.request, 7U);
    EXPECT_EQ(rig.own.due, 3U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    rig.Cycle(11000U);
    EXPECT_EQ(rig.channel.last_input.request, 5U);
    EXPECT_EQ(rig.own.due, 1U);
}

} // namespace
} // namespace counterpoint
