// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace counterpoint
{
namespace
{

constexpr HeldPair kPair{Payload{0x1234U, 0x5678U}, 3U, 1U};

/// What follows from a statement of the peer that lasts from 10 ms on, at `at_us`.
class Statements : public ::testing::Test
{
  protected:
    GuardView After(const Statement& statement, const std::uint32_t at_us, const std::uint32_t digest = 0U)
    {
        PeerRig rig{PeerRole::kA};
        rig.Cycle(1000U);
        std::uint32_t now_us = 10000U;
        while (now_us < at_us)
        {
            LinkMessage word = rig.AnswerTo(now_us - 3000U);
            word.statement = statement;
            word.digest = DeviceDigest{digest};
            rig.Hear(word, now_us - 1000U);
            rig.Cycle(now_us);
            now_us += 10000U;
        }
        rig.Cycle(at_us);
        return rig.remote.guard;
    }
};

// Given the cycle before the first that saw it at 1 ms and a discrepancy time of 50 ms, when a difference lasts until
// 51 ms, then it is tolerated; a microsecond longer is a disagreement, in whatever member.
TEST_F(Statements, DifferenceBeyondTheDiscrepancyTimeIsShown)
{
    Verifies(req::SRS_TWO_007);
    EXPECT_EQ(After(Statement{GuardView::kConfigured, 1U, 1U, 1U, 0U}, 51001U), GuardView::kConfigured);
    EXPECT_EQ(After(Statement{GuardView::kUnconfigured, 1U, 1U, 1U, 0U}, 51000U), GuardView::kConfigured);
    EXPECT_EQ(After(Statement{GuardView::kUnconfigured, 1U, 1U, 1U, 0U}, 51001U), GuardView::kInvalid);
    EXPECT_EQ(After(Statement{GuardView::kConfigured, 2U, 1U, 1U, 0U}, 51001U), GuardView::kInvalid);
    EXPECT_EQ(After(Statement{GuardView::kConfigured, 1U, 2U, 1U, 0U}, 51001U), GuardView::kInvalid);
    EXPECT_EQ(After(Statement{GuardView::kConfigured, 1U, 1U, 2U, 0U}, 51001U), GuardView::kInvalid);
    EXPECT_EQ(After(Statement{GuardView::kConfigured, 1U, 1U, 1U, 1U}, 51001U), GuardView::kInvalid);
}

// Given two devices that are not operational, of which the peer tells another digest, then it is no difference.
TEST_F(Statements, DigestIsComparedOnlyWhileBothAreOperational)
{
    Verifies(req::SRS_TWO_007);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.not_operational = 1U;
    rig.Cycle(1000U);
    for (std::uint32_t now_us = 10000U; now_us <= 300000U; now_us += 10000U)
    {
        LinkMessage word = rig.AnswerTo(now_us - 3000U);
        word.statement = Statement{GuardView::kConfigured, 1U, 1U, 1U, 1U};
        word.digest = DeviceDigest{5U};
        rig.Hear(word, now_us - 1000U);
        rig.Cycle(now_us);
        EXPECT_EQ(rig.remote.guard, GuardView::kConfigured) << now_us;
    }
}

// Given another digest (the own one is 0 for three cycles, then 321), when it lasts for the diagnostic interval of 100
// ms, then it is tolerated; longer is a disagreement.
TEST_F(Statements, DigestBeyondTheDiagnosticIntervalIsShown)
{
    Verifies(req::SRS_TWO_007);
    const Statement same{GuardView::kConfigured, 1U, 1U, 1U, 0U};
    EXPECT_EQ(After(same, 101000U, 5U), GuardView::kConfigured);
    EXPECT_EQ(After(same, 101001U, 5U), GuardView::kInvalid);
    EXPECT_EQ(After(same, 141001U, 321U), GuardView::kConfigured);
}

// Given no contact, then nothing is compared, nothing released, no permit given, and the own counts are shown.
TEST(RemoteVoiceAlone, SaysNothingOutOfContact)
{
    Verifies(req::SRS_LNK_005);
    Verifies(req::SRS_TWO_009);
    PeerRig rig{PeerRole::kA};
    for (std::uint32_t now_us = 10000U; now_us < 200000U; now_us += 10000U)
    {
        rig.Cycle(now_us);
    }
    EXPECT_EQ(rig.remote.guard, GuardView::kConfigured);
    EXPECT_EQ(rig.remote.sct_checked, 1U);
    EXPECT_EQ(rig.remote.released, 0U);
    EXPECT_EQ(rig.Remote().Commit(Agreement{1U, 1U}, 0U), 0U);
    const Permit permit = rig.Remote().Answer(100U);
    EXPECT_EQ(permit.mask, 0U);
    EXPECT_NE(permit.response, 100U * kPermitConstantB);
}

// Given CPU B, then the remote voice answers for A.
TEST(RemoteVoiceAlone, PermitOfCpuBIsTheOneOfA)
{
    Verifies(req::SRS_TWO_009);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    rig.Contact(2000U);
    EXPECT_EQ(rig.Remote().Answer(7U).response, 7U * 0x9E3779B1U);
}

// Given checks of the peer, then Recheck gives them while both are operational; before, and after the peer left, the
// own ones.
TEST(RemoteVoiceAlone, RecheckGivesThePeersResult)
{
    Verifies(req::SRS_TWO_210);
    PeerRig rig{PeerRole::kA};
    rig.Cycle(1000U);
    EXPECT_EQ(rig.Remote().Recheck(1U).signature, 0x1234U);
    LinkMessage word = rig.AnswerTo(2000U);
    word.check = SlotCheck{1U, {ConfigFault::kSignature, 0x9999U}};
    rig.Hear(word, 4000U);
    EXPECT_EQ(rig.Remote().Recheck(1U).signature, 0x9999U);
    EXPECT_EQ(rig.Remote().Recheck(0U).signature, 0x1234U);
    rig.channel.outcome.not_operational = 1U;
    rig.Cycle(10000U);
    EXPECT_EQ(rig.Remote().Recheck(1U).signature, 0x1234U);
    rig.channel.outcome.not_operational = 0U;
    rig.Cycle(20000U);
    EXPECT_EQ(rig.Remote().Recheck(1U).signature, 0x9999U);
    word = rig.AnswerTo(21000U);
    word.statement.not_operational = 1U;
    rig.Hear(word, 23000U);
    word = rig.Word(23000U);
    rig.Hear(word, 24000U);
    EXPECT_EQ(rig.Remote().Recheck(1U).signature, 0x1234U);
}

// Given the remote voice, then the configuration is the own channel's, and what it is told to keep or do has no effect.
TEST(RemoteVoiceAlone, ConfigurationIsTheOwnOne)
{
    Verifies(req::SRS_TWO_211);
    PeerRig rig{PeerRole::kA};
    Channel& remote = rig.Remote();
    remote.Store(ConfigItem{{0U, ConfigField::kSct, 0U}, 25U});
    remote.SetFields(0U, StaticFields{nullptr, nullptr});
    remote.OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
    remote.OnFrame(PeerRig::Frame(0x101U), Instant{5U});
    EXPECT_TRUE(rig.channel.stored.empty());
    EXPECT_EQ(rig.channel.fields_set, 0);
    EXPECT_TRUE(rig.channel.transmit_faults.empty());
    EXPECT_EQ(rig.channel.frames, 0);
    EXPECT_EQ(remote.Load(ConfigAddress{1U, ConfigField::kCobId1, 0U}).value, 0x103U);
    EXPECT_EQ(remote.Room().map_entries, 12U);
    EXPECT_EQ(remote.Digest(0U, DeviceDigest{4U}).value, 5U);
    EXPECT_EQ(remote.Validate(0U).signature, 0x1234U);
}

// Given CPU A and an armed frame of the peer, then its slot is due and Prepare gives the frame once; a new number arms
// anew.
TEST(RemoteVoiceAlone, ArmedFrameIsUsedOnce)
{
    Verifies(req::SRS_TWO_214);
    Verifies(req::SRS_TWO_215);
    PeerRig rig{PeerRole::kA};
    rig.Cycle(1000U);
    const auto tell = [&rig](std::uint8_t number, std::uint32_t at_us)
    {
        LinkMessage word = rig.AnswerTo(at_us);
        word.armed[1].slot = 1U;
        word.armed[1].number = number;
        word.armed[1].frame = PeerRig::Frame(0x103U);
        rig.Hear(word, at_us + 2000U);
        rig.Cycle(at_us + 3000U);
    };
    tell(1U, 10000U);
    EXPECT_EQ(rig.remote.due, 2U);
    // The own channel has nothing ready: its status, no frame, and the peer's frame is not used.
    rig.channel.prepared = PreparedPair{CanFrame{}, PrepareStatus::kNotProducer};
    static_cast<void>(rig.Own().Prepare(1U));
    const PreparedPair without = rig.Remote().Prepare(1U);
    EXPECT_EQ(without.status, PrepareStatus::kNotProducer);
    EXPECT_EQ(without.normal.identifier, 0U);
    rig.Cycle(13500U);
    EXPECT_EQ(rig.remote.due, 2U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Own().Prepare(1U));
    const PreparedPair pair = rig.Remote().Prepare(1U);
    EXPECT_EQ(pair.status, PrepareStatus::kReady);
    EXPECT_EQ(pair.normal.identifier, 0x103U);
    rig.Cycle(14000U);
    EXPECT_EQ(rig.remote.due, 0U);
    tell(1U, 20000U);
    EXPECT_EQ(rig.remote.due, 0U);
    tell(2U, 30000U);
    EXPECT_EQ(rig.remote.due, 2U);
    EXPECT_EQ(rig.Remote().InverseFrame(1U).kind, FrameKind::kInvalid);
    // Given up here: the follower is told which, and why.
    rig.Remote().OnTransmitFault(0U, TransmitFault{SrdoCause::kBusOff});
    EXPECT_EQ(rig.Say(34000U).refusal.number, 0U);
    rig.Remote().OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
    EXPECT_EQ(rig.Say(34000U).refusal.number, 2U);
    EXPECT_EQ(rig.Say(34000U).refusal.cause, SrdoCause::kBusOff);
}

// Given frames on the bus, then the remote voice names slot and step by the identifier alone.
TEST(RemoteVoiceAlone, ConfirmsByIdentifier)
{
    Verifies(req::SRS_TWO_013);
    PeerRig rig{PeerRole::kB};
    Confirmation confirmation = rig.Remote().OnConfirm(PeerRig::Frame(0x103U), Instant{1U});
    EXPECT_EQ(confirmation.slot, 1U);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNormal);
    confirmation = rig.Remote().OnConfirm(PeerRig::Frame(0x104U), Instant{1U});
    EXPECT_EQ(confirmation.step, ConfirmStep::kPair);
    confirmation = rig.Remote().OnConfirm(PeerRig::Frame(0x105U), Instant{1U});
    EXPECT_EQ(confirmation.slot, kNoSlot);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNone);
}

// Given a channel with an inverse frame, then the own voice has it on CPU B, and neither voice on CPU A.
TEST(RemoteVoiceAlone, InverseFrameIsThatOfCpuB)
{
    Verifies(req::SRS_TWO_216);
    PeerRig follower{PeerRole::kB};
    follower.channel.prepared.normal = PeerRig::Frame(0x104U);
    EXPECT_EQ(follower.Own().InverseFrame(1U).identifier, 0x104U);
    PeerRig leader{PeerRole::kA};
    leader.channel.prepared.normal = PeerRig::Frame(0x104U);
    static_cast<void>(leader.Remote().OnConfirm(PeerRig::Frame(0x103U), Instant{1U}));
    EXPECT_EQ(leader.Own().InverseFrame(1U).kind, FrameKind::kInvalid);
    EXPECT_EQ(leader.Remote().InverseFrame(1U).kind, FrameKind::kInvalid);
    EXPECT_EQ(leader.Own().InverseFrame(1U).identifier, 0U);
}

// Given CPU B, when the normal frame of slot 1 was on the bus, then the leader's voice has its inverse, for that slot
// alone, until another frame is there or the voice begins anew.
TEST(RemoteVoiceAlone, InverseFrameIsThatOfTheNormalFrameOnTheBus)
{
    Verifies(req::SRS_TWO_019);
    PeerRig rig{PeerRole::kB};
    rig.config.inverse_port = CanPortId::kSecond;
    EXPECT_EQ(rig.Remote().InverseFrame(1U).kind, FrameKind::kInvalid);
    CanFrame normal = PeerRig::Frame(0x103U);
    normal.length_bytes = 3U;
    const std::uint8_t seen[kMaxPayloadBytes] = {0x00U, 0xFFU, 0x5AU, 0x77U, 0x77U, 0x77U, 0x77U, 0x77U};
    std::copy(std::begin(seen), std::end(seen), std::begin(normal.data));
    static_cast<void>(rig.Remote().OnConfirm(normal, Instant{1U}));
    const CanFrame inverse = rig.Remote().InverseFrame(1U);
    EXPECT_EQ(inverse.identifier, 0x104U);
    EXPECT_EQ(inverse.kind, FrameKind::kData);
    EXPECT_EQ(inverse.port, CanPortId::kSecond);
    EXPECT_EQ(inverse.length_bytes, 3U);
    const std::uint8_t expected[kMaxPayloadBytes] = {0xFFU, 0x00U, 0xA5U, 0U, 0U, 0U, 0U, 0U};
    for (std::size_t byte = 0U; byte < kMaxPayloadBytes; ++byte)
    {
        EXPECT_EQ(inverse.data[byte], expected[byte]) << byte;
    }
    EXPECT_EQ(rig.Remote().InverseFrame(0U).kind, FrameKind::kInvalid);
    static_cast<void>(rig.Remote().OnConfirm(inverse, Instant{1U}));
    EXPECT_EQ(rig.Remote().InverseFrame(1U).identifier, 0x104U);
    static_cast<void>(rig.Remote().OnConfirm(PeerRig::Frame(0x101U), Instant{1U}));
    EXPECT_EQ(rig.Remote().InverseFrame(1U).kind, FrameKind::kInvalid);
    EXPECT_EQ(rig.Remote().InverseFrame(0U).identifier, 0x102U);
    rig.Remote().Restart(rig.config);
    EXPECT_EQ(rig.Remote().InverseFrame(0U).kind, FrameKind::kInvalid);
}

} // namespace
} // namespace counterpoint
