// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

// Given two messages, then their sequence numbers follow each other, and each carries stamp, echo and hold.
TEST(PeerMessages, CarrySequenceStampAndEcho)
{
    Verifies(req::SRS_LNK_003);
    Verifies(req::SRS_LNK_004);
    PeerRig rig{PeerRole::kB};
    LinkMessage said = rig.Say(1000U);
    EXPECT_EQ(said.sequence, 1U);
    EXPECT_EQ(said.stamp.us, 1000U);
    EXPECT_EQ(said.echo.heard, 0U);
    rig.Hear(rig.Word(2000U), 2500U);
    said = rig.Say(4000U);
    EXPECT_EQ(said.sequence, 2U);
    EXPECT_EQ(said.echo.heard, kHeard);
    EXPECT_EQ(said.echo.sequence, 101U);
    EXPECT_EQ(said.echo.stamp.us, 1002000U);
    EXPECT_EQ(said.echo.hold_us, 1500U);
    EXPECT_EQ(said.flow, hal::kFlowReference);
    EXPECT_EQ(said.fault, DeviceFault::kNone);
}

// Given a message of the own role, or a damaged one, then it is corrupt and says nothing.
TEST(PeerMessages, DamagedOnesAreCounted)
{
    Verifies(req::SRS_LNK_002);
    PeerRig rig{PeerRole::kA};
    LinkMessage own = rig.AnswerTo(1000U);
    own.sender.role = PeerRole::kA;
    rig.Hear(own, 3000U);
    Encode(rig.Word(2000U), rig.frame);
    rig.frame.bytes[20] ^= 1U;
    rig.peer.OnMessage(rig.frame, Instant{3000U});
    EXPECT_EQ(rig.peer.Link().Counts().corrupt, 2U);
    EXPECT_EQ(rig.peer.Link().State(), LinkState::kWaiting);
    // Nor one of another node-ID, or of another length; none of them is echoed
    LinkMessage other = rig.AnswerTo(4000U);
    other.sender.node_id = static_cast<std::uint8_t>(other.sender.node_id + 1U);
    rig.Hear(other, 5000U);
    for (const std::uint8_t length : std::initializer_list<std::uint8_t>{0U, 187U, 189U})
    {
        Encode(rig.Word(5000U), rig.frame);
        rig.frame.length = length;
        rig.peer.OnMessage(rig.frame, Instant{6000U});
    }
    EXPECT_EQ(rig.peer.Link().Counts().corrupt, 6U);
    EXPECT_EQ(rig.peer.Link().Counts().taken, 0U);
    EXPECT_EQ(rig.peer.Link().State(), LinkState::kWaiting);
    EXPECT_EQ(rig.Say(7000U).echo.heard, 0U);
}

// Given contact, when a message comes a second time, then what it says is not taken again.
TEST(PeerMessages, RepeatedOneSaysNothing)
{
    Verifies(req::SRS_LNK_003);
    PeerRig rig{PeerRole::kA};
    rig.Contact(1000U);
    LinkMessage word = rig.Word(3000U);
    rig.Hear(word, 4000U);
    word.new_faults = 1U;
    rig.Hear(word, 4500U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.remote.new_fault, 0U);
    EXPECT_EQ(rig.peer.Link().Counts().repeated, 1U);
}

// Given contact, when a message comes behind a later one, then what it says is not taken.
TEST(PeerMessages, OldOneSaysNothing)
{
    Verifies(req::SRS_LNK_003);
    PeerRig rig{PeerRole::kA};
    rig.Contact(1000U);
    LinkMessage old = rig.Word(3000U);
    old.new_faults = 1U;
    const LinkMessage later = rig.Word(3000U);
    EXPECT_EQ(later.sequence, old.sequence + 1U);
    rig.Hear(later, 4000U);
    rig.Hear(old, 4500U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.remote.new_fault, 0U);
    EXPECT_EQ(rig.peer.Link().Counts().old, 1U);
    EXPECT_EQ(rig.peer.Link().Counts().lost, 1U);
    EXPECT_EQ(rig.peer.Link().Echo(Instant{4500U}).sequence, later.sequence);
}

// Given contact, when the peer tells another flow signature, or its device safe state, then the link is lost at once.
TEST(PeerMessages, PeerThatIsNotWellIsLost)
{
    Verifies(req::SRS_LNK_010);
    PeerRig rig{PeerRole::kA};
    rig.Contact(1000U);
    EXPECT_EQ(rig.peer.Examine(Instant{3000U}), LinkFinding::kNone);
    LinkMessage word = rig.Word(3000U);
    word.flow = hal::kFlowReference + 1U;
    rig.Hear(word, 4000U);
    EXPECT_EQ(rig.peer.Examine(Instant{4000U}), LinkFinding::kFlow);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.remote.guard, GuardView::kInvalid);
    PeerRig other{PeerRole::kB};
    other.Contact(1000U);
    word = other.Word(3000U);
    word.fault = DeviceFault::kDisagreement;
    other.Hear(word, 4000U);
    EXPECT_EQ(other.peer.Examine(Instant{4000U}), LinkFinding::kPeerSafe);
}

// Given contact with an echo of 1 ms, when nothing more comes, then Examine finds the time-out just beyond 41 ms.
TEST(PeerMessages, SilenceIsFound)
{
    Verifies(req::SRS_LNK_006);
    PeerRig rig{PeerRole::kA};
    rig.Contact(1000U);
    EXPECT_EQ(rig.peer.Examine(Instant{41000U}), LinkFinding::kNone);
    EXPECT_EQ(rig.peer.Examine(Instant{41001U}), LinkFinding::kTimeout);
}

// Given a new fault, then every message carries it until one that carried it is echoed; a second fault meanwhile waits
// for an echo of its own.
TEST(PeerMessages, FaultsAreCarriedUntilEchoed)
{
    Verifies(req::SRS_TWO_006);
    PeerRig rig{PeerRole::kA};
    rig.Contact(1000U); // sequence 1
    rig.channel.outcome.new_fault = 1U;
    rig.Cycle(10000U);
    rig.channel.outcome.new_fault = 0U;
    const LinkMessage second = rig.Say(10000U);
    EXPECT_EQ(second.new_faults, 1U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.Say(20000U).new_faults, 1U); // 3
    rig.channel.outcome.new_fault = 4U;
    rig.Cycle(30000U);
    rig.channel.outcome.new_fault = 0U;
    EXPECT_EQ(rig.Say(30000U).new_faults, 5U); // 4
    rig.said = second;
    rig.Hear(rig.Word(31000U), 32000U);
    EXPECT_EQ(rig.Say(33000U).new_faults, 5U); // 5
    rig.Hear(rig.Word(34000U), 35000U);
    EXPECT_EQ(rig.Say(36000U).new_faults, 0U);
}

// Given six active consumers, then each message reports four: news first, then in turn.
TEST(PeerMessages, ReportsNewsFirstThenInTurn)
{
    Verifies(req::SRS_TWO_014);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.waiting = 7U;
    rig.Cycle(10000U); // entering: all are news
    LinkMessage said = rig.Say(10000U);
    EXPECT_EQ(said.reports[0].slot, 1U);
    EXPECT_EQ(said.reports[1].slot, 2U);
    EXPECT_EQ(said.reports[2].slot, 0U);
    EXPECT_EQ(said.reports[3].slot, kNoSlot);
    rig.channel.outcome.fresh = 4U;
    rig.Cycle(20000U);
    said = rig.Say(20000U);
    EXPECT_EQ(said.reports[0].slot, 2U);
    EXPECT_EQ(said.reports[1].slot, 0U);
    EXPECT_EQ(said.reports[2].slot, 1U);
    rig.channel.outcome.fresh = 0U;
    rig.channel.outcome.waiting = 0U;
    rig.channel.outcome.new_fault = 1U;
    rig.Cycle(30000U);
    EXPECT_EQ(rig.Say(30000U).reports[0].slot, kNoSlot);
}

// Given received frames, then the halves of own producers' pairs are echoes; consumers' and others' are not.
TEST(PeerMessages, EchoIsTheOtherHalfOfAnOwnPair)
{
    Verifies(req::SRS_TWO_217);
    PeerRig rig{PeerRole::kB};
    EXPECT_TRUE(rig.peer.IsEcho(PeerRig::Frame(0x103U)));
    EXPECT_TRUE(rig.peer.IsEcho(PeerRig::Frame(0x104U)));
    EXPECT_FALSE(rig.peer.IsEcho(PeerRig::Frame(0x101U)));
    EXPECT_FALSE(rig.peer.IsEcho(PeerRig::Frame(0x105U)));
    EXPECT_FALSE(rig.peer.IsEcho(PeerRig::Frame(0x200U)));
}

// Given an SRDO whose identifier was changed, then frames with the old one are no longer its.
TEST(PeerMessages, ValidatedIdentifierReplacesTheOldOne)
{
    Verifies(req::SRS_TWO_217);
    PeerRig rig{PeerRole::kB};
    rig.channel.cob_id_1[1] = 0x107U;
    static_cast<void>(rig.Own().Validate(1U));
    EXPECT_FALSE(rig.peer.IsEcho(PeerRig::Frame(0x103U)));
    EXPECT_TRUE(rig.peer.IsEcho(PeerRig::Frame(0x107U)));
}

} // namespace
} // namespace counterpoint
