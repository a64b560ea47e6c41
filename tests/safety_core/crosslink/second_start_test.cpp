// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Nothing of the time before is left over in the voices of a CPU when its kernel is started again.
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

/// What a kernel's Start does to both channels, and the begin of the first cycle to the link.
void StartAgain(PeerRig& rig)
{
    rig.Own().Restart(rig.config);
    rig.Remote().Restart(rig.config);
    static_cast<void>(rig.peer.Examine(Instant{0U}));
}

// Given a CPU that was in contact, with a check, a digest, news, a fault and an identifier of its own, when it is
// started again, then the next message tells none of it but its counting sequence.
TEST(SecondStart, OwnVoiceTellsNothingOfBefore)
{
    Verifies(req::SRS_TWO_001);
    Verifies(req::SRS_TWO_007);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.due = 2U;
    rig.channel.outcome.fresh = 1U;
    rig.channel.outcome.new_fault = 1U;
    for (std::uint32_t cycle = 1U; cycle < 6U; ++cycle) // One whole sweep, and two slots of the next one.
    {
        rig.Cycle(cycle * 1000U);
    }
    rig.Contact(6000U);
    EXPECT_EQ(rig.said.digest.value, 321U);
    EXPECT_EQ(rig.said.check.slot, 2U);
    StartAgain(rig);
    const LinkMessage said = rig.Say(7000U);
    EXPECT_EQ(said.sequence, 2U);
    EXPECT_EQ(said.echo.heard, 0U);
    EXPECT_EQ(said.echo.sequence, 0U);
    EXPECT_EQ(said.echo.stamp.us, 0U);
    EXPECT_EQ(said.echo.hold_us, 7000U);
    EXPECT_EQ(said.digest.value, 0U);
    EXPECT_EQ(said.check.slot, kNoSlot);
    EXPECT_EQ(said.check.result.fault, ConfigFault::kInvalid);
    EXPECT_EQ(said.check.result.signature, 0U);
    EXPECT_EQ(said.statement.guard, GuardView::kUnconfigured);
    EXPECT_EQ(said.statement.sct_checked, 0U);
    EXPECT_EQ(said.statement.is_tx, 0U);
    EXPECT_EQ(said.statement.is_invalid, 0U);
    EXPECT_EQ(said.statement.not_operational, 1U);
    EXPECT_EQ(said.due, 0U);
    EXPECT_EQ(said.released, 0U);
    EXPECT_EQ(said.reports[0].slot, kNoSlot);
    // The sweep begins anew: three cycles, with the first slot first
    rig.channel.outcome.new_fault = 0U;
    rig.channel.outcome.fresh = 0U;
    rig.Cycle(8000U);
    rig.Cycle(9000U);
    EXPECT_EQ(rig.Say(9000U).digest.value, 0U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.Say(10000U).digest.value, 321U);
    // Nobody to send with yet, and no identifier is known before its SRDO was validated
    EXPECT_EQ(rig.own.due, 0U);
    EXPECT_FALSE(rig.peer.IsEcho(PeerRig::Frame(0x103U)));
}

// Given faults and news that were not told yet, when the CPU is started again, then they are not told.
TEST(SecondStart, FaultsAndNewsOfBeforeAreNotTold)
{
    Verifies(req::SRS_TWO_006);
    Verifies(req::SRS_TWO_014);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.new_fault = 1U;
    rig.Cycle(1000U); // Slot 0 is news.
    StartAgain(rig);
    rig.channel.outcome.waiting = 5U;
    rig.channel.outcome.new_fault = 0U;
    rig.channel.outcome.not_operational = 1U; // Entering would be news of all.
    rig.Cycle(2000U);
    const LinkMessage said = rig.Say(3000U);
    EXPECT_EQ(said.new_faults, 0U);
    EXPECT_EQ(said.reports[0].slot, 2U); // In turn behind slot 0, not slot 0 as news.
}

// Given CPU B with a frame armed, a slot that waits for the leader and one that the leader called due, when it is
// started again, then nothing stands, is requested or armed.
TEST(SecondStart, FollowerHasNothingArmedOrStanding)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_150);
    Verifies(req::SRS_TWO_151);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    LinkMessage word = rig.AnswerTo(2000U);
    word.due = 6U;
    rig.Hear(word, 4000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    rig.channel.outcome.due = 2U | 1U; // Slot 0 was not told due: it stands.
    rig.Cycle(5000U);
    static_cast<void>(rig.Remote().Prepare(1U));
    ASSERT_EQ(rig.Say(5000U).armed[0].slot, 1U);
    StartAgain(rig);
    EXPECT_EQ(rig.Own().Prepare(1U).status, PrepareStatus::kInvalid); // Nothing was prepared.
    rig.Cycle(6000U);
    EXPECT_EQ(rig.channel.last_input.stand, 0U);
    EXPECT_EQ(rig.channel.last_input.request, 0U);
    EXPECT_EQ(rig.remote.due, 0U);
    EXPECT_EQ(rig.own.due, 0U);
    EXPECT_EQ(rig.Say(6000U).armed[0].slot, kNoSlot);
    EXPECT_EQ(rig.Say(6000U).armed[0].number, 0U);
}

// Given a CPU that was at 30 ms, when it is started again and a frame is armed or a slot demoted before its first
// cycle, then both count from 0.
TEST(SecondStart, TimeBeginsAnew)
{
    Verifies(req::SRS_TWO_001);
    PeerRig follower{PeerRole::kB};
    follower.Cycle(30000U);
    StartAgain(follower);
    follower.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(follower.Remote().Prepare(1U));
    EXPECT_EQ(follower.Say(20000U).armed[0].slot, 1U);
    EXPECT_EQ(follower.Say(20001U).armed[0].slot, kNoSlot);
    PeerRig leader{PeerRole::kA};
    leader.Cycle(30000U);
    StartAgain(leader);
    leader.Own().Demote(0U);
    leader.channel.outcome.not_operational = 1U; // Entering would be a discard.
    leader.Cycle(40000U);
    EXPECT_EQ(leader.Say(40000U).reports[0].age_us, 40000U);
}

// Given CPU A in contact with reports, checks, an armed frame, a new fault and a commitment, when it is started again,
// then its remote voice waits for contact and shows nothing of it.
TEST(SecondStart, RemoteVoiceShowsNothingOfBefore)
{
    Verifies(req::SRS_LNK_005);
    Verifies(req::SRS_TWO_003);
    Verifies(req::SRS_TWO_009);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.waiting = 0U;
    rig.channel.outcome.released = 1U;
    rig.Contact(1000U);
    rig.Complete(8000U, 10000U, HeldPair{Payload{0x12U, 0U}, 3U, 1U});
    LinkMessage word = rig.AnswerTo(10000U);
    word.released = 1U;
    word.new_faults = 4U;
    word.reports[0] =
        SlotReport{0U, Holding::kPair, SrdoState::kReleased, SrdoCause::kNone, 9U, 3000U, Payload{0x12U, 0U}};
    word.check = SlotCheck{1U, {ConfigFault::kSignature, 0x9999U}};
    word.digest = DeviceDigest{5U};
    word.armed[0] = ArmedFrame{1U, 7U, PeerRig::Frame(0x103U)};
    rig.Hear(word, 12000U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 1U}, 0U), 0U);
    ASSERT_EQ(rig.Remote().Answer(100U).mask, 1U);
    rig.Hear(word, 12000U);
    rig.Remote().OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
    ASSERT_EQ(rig.Say(20000U).refusal.number, 7U);
    StartAgain(rig);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 0U);
    EXPECT_EQ(rig.peer.Link().State(), LinkState::kWaiting);
    EXPECT_EQ(rig.peer.Link().Finding(), LinkFinding::kNone);
    EXPECT_EQ(rig.peer.Link().Counts().taken, 0U);
    EXPECT_EQ(rig.Say(21000U).refusal.number, 0U);
    EXPECT_EQ(rig.Say(21000U).refusal.cause, SrdoCause::kNone);
    rig.Cycle(22000U);
    EXPECT_EQ(rig.remote.cycle, 1U);
    EXPECT_EQ(rig.remote.released, 0U);
    EXPECT_EQ(rig.remote.new_fault, 0U);
    EXPECT_EQ(rig.remote.fresh, 0U);
    EXPECT_EQ(rig.remote.due, 0U);
    EXPECT_EQ(rig.remote.guard, GuardView::kConfigured);
    // In contact again, with a message that tells nothing, there is still nothing
    rig.Contact(23000U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.released, 0U);
    EXPECT_EQ(rig.remote.due, 0U);
    EXPECT_EQ(rig.Remote().Recheck(1U).signature, 0x1234U);
    EXPECT_EQ(rig.Remote().View(0U).state, SrdoState::kInvalid);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 0U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 0U);
}

// Given a pair, a release, a commitment and faults 0 and 2 of the peer, told before its CPU is started again, then
// nothing is fresh, a fault, released without a report or committed without a match by it; the faults are new again.
TEST(SecondStart, WordOfBeforeCountsNoMore)
{
    Verifies(req::SRS_TWO_005);
    Verifies(req::SRS_TWO_006);
    Verifies(req::SRS_TWO_009);
    PeerRig rig{PeerRole::kA};
    const SlotReport report{0U, Holding::kPair, SrdoState::kReleased, SrdoCause::kNone, 9U, 3000U, Payload{0x12U, 0U}};
    const auto tell = [&rig](const std::uint32_t at_us, const SlotReport& told, const SrdoMask faults)
    {
        LinkMessage word = rig.AnswerTo(at_us);
        word.released = 1U;
        word.new_faults = faults;
        word.reports[0] = told;
        rig.Hear(word, at_us + 2000U);
    };
    tell(1000U, report, 0U);
    rig.Cycle(5000U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 1U}, 0U), 0U);
    ASSERT_EQ(rig.Remote().Answer(100U).mask, 1U);
    SlotReport newer = report;
    newer.ordinal = 10U;
    tell(6000U, newer, 5U);
    StartAgain(rig);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.remote.fresh, 0U);
    EXPECT_EQ(rig.remote.new_fault, 0U);
    SlotReport none{};
    none.slot = kNoSlot;
    tell(11000U, none, 5U);
    rig.Cycle(15000U);
    EXPECT_EQ(rig.remote.released, 0U);
    EXPECT_EQ(rig.remote.new_fault, 5U);
    tell(16000U, report, 5U);
    rig.Cycle(20000U);
    ASSERT_EQ(rig.remote.released, 1U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 0U}, 0U), 0U);
    EXPECT_EQ(rig.Remote().Answer(100U).mask, 0U);
}

// Given a leader that used the frame of number 7, when both CPUs are started again and the follower, which counts anew,
// comes to number 7, then the frame is used: what was used before counts no more.
TEST(SecondStart, NumberUsedBeforeIsANewFrame)
{
    Verifies(req::SRS_TWO_214);
    PeerRig rig{PeerRole::kA};
    rig.Cycle(1000U);
    const auto tell = [&rig](const std::uint32_t at_us)
    {
        LinkMessage word = rig.AnswerTo(at_us);
        word.armed[0] = ArmedFrame{1U, 7U, PeerRig::Frame(0x103U)};
        rig.Hear(word, at_us + 2000U);
        rig.Cycle(at_us + 3000U);
    };
    tell(2000U);
    ASSERT_EQ(rig.remote.due, 2U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Own().Prepare(1U));
    static_cast<void>(rig.Remote().Prepare(1U));
    tell(12000U);
    ASSERT_EQ(rig.remote.due, 0U);
    StartAgain(rig);
    tell(22000U);
    EXPECT_EQ(rig.remote.due, 2U);
}

// Given a CPU that has not run a cycle yet, then the flow that it tells is none.
TEST(SecondStart, FlowBeforeTheFirstCycleIsNone)
{
    Verifies(req::SRS_LNK_010);
    FakeChannel channel{};
    FakeWatchdog watchdog{};
    Peer peer{channel, watchdog, LinkConfig{PeerRole::kA, 40000U, 20000U, 400000U, 100U}};
    hal::LinkFrame frame{};
    LinkMessage said{};
    peer.Compose(PeerMoment{Instant{0U}, DeviceFault::kNone}, frame);
    ASSERT_EQ(Decode(frame, LinkSender{PeerRole::kA, 0U}, said), DecodeResult::kIntact);
    EXPECT_EQ(said.flow, 0U);
    EXPECT_EQ(said.sequence, 1U);
    EXPECT_EQ(said.new_faults, 0U);
    EXPECT_EQ(peer.Link().State(), LinkState::kLost);
    EXPECT_EQ(peer.Link().Acknowledged(), 0U);
}

// Given counts that are all different, then CPU B shows each in its own place a cycle later, and the message has them
// so.
TEST(SecondStart, CountsOfTheFollowerKeepTheirPlaces)
{
    Verifies(req::SRS_TWO_001);
    PeerRig rig{PeerRole::kB};
    rig.channel.outcome.sct_checked = 11U;
    rig.channel.outcome.is_tx = 12U;
    rig.channel.outcome.is_invalid = 13U;
    rig.channel.outcome.not_operational = 0U;
    rig.Cycle(1000U);
    rig.channel.outcome.sct_checked = 21U;
    rig.channel.outcome.is_tx = 22U;
    rig.channel.outcome.is_invalid = 23U;
    rig.Cycle(2000U);
    for (const CycleOutcome& shown : {rig.own, rig.remote})
    {
        EXPECT_EQ(shown.sct_checked, 11U);
        EXPECT_EQ(shown.is_tx, 12U);
        EXPECT_EQ(shown.is_invalid, 13U);
    }
    const Statement said = rig.Say(2000U).statement;
    EXPECT_EQ(said.sct_checked, 21U);
    EXPECT_EQ(said.is_tx, 22U);
    EXPECT_EQ(said.is_invalid, 23U);
    EXPECT_EQ(said.not_operational, 0U);
    EXPECT_EQ(said.guard, GuardView::kConfigured);
}

} // namespace
} // namespace counterpoint
