// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the voices of a CPU pass on, argument by argument, for a slot other than the first.
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

// Given the own voice, when the kernel configures slot 2, then the channel has the same device, item, slot and fields.
TEST(PassedOn, ConfigurationHasEveryArgument)
{
    Verifies(req::SRS_TWO_001);
    PeerRig rig{PeerRole::kA};
    Channel& own = rig.Own();
    EXPECT_EQ(rig.channel.device, &rig.config);
    own.Store(ConfigItem{{2U, ConfigField::kMapEntry, 7U}, 25U});
    ASSERT_EQ(rig.channel.stored.size(), 1U);
    EXPECT_EQ(rig.channel.stored[0].address.slot, 2U);
    EXPECT_EQ(rig.channel.stored[0].address.field, ConfigField::kMapEntry);
    EXPECT_EQ(rig.channel.stored[0].address.sub, 7U);
    EXPECT_EQ(rig.channel.stored[0].value, 25U);
    std::uint8_t normal = 0U;
    std::uint8_t inverse = 0U;
    own.SetFields(2U, StaticFields{&normal, &inverse});
    EXPECT_EQ(rig.channel.asked, 2U);
    EXPECT_EQ(rig.channel.fields.normal, &normal);
    EXPECT_EQ(rig.channel.fields.inverse, &inverse);
}

// Given either voice, when slot 1 is checked, then it is slot 1 that the channel checks.
TEST(PassedOn, ChecksAreOfTheSlotAskedFor)
{
    Verifies(req::SRS_TWO_001);
    Verifies(req::SRS_TWO_008);
    Verifies(req::SRS_TWO_210);
    PeerRig rig{PeerRole::kA};
    for (Channel* const voice : {&rig.Own(), &rig.Remote()})
    {
        rig.channel.asked = kNoSlot;
        static_cast<void>(voice->Validate(1U));
        EXPECT_EQ(rig.channel.asked, 1U);
        rig.channel.asked = kNoSlot;
        static_cast<void>(voice->Recheck(1U));
        EXPECT_EQ(rig.channel.asked, 1U);
        EXPECT_EQ(voice->Digest(1U, DeviceDigest{5U}).value, 25U);
    }
}

// Given frames on the bus, then the channel has each with its stamp, and the kernel the channel's confirmation.
TEST(PassedOn, FramesHaveTheirStamps)
{
    Verifies(req::SRS_TWO_001);
    PeerRig rig{PeerRole::kB};
    rig.Own().OnFrame(PeerRig::Frame(0x106U), Instant{123U});
    EXPECT_EQ(rig.channel.heard.first.identifier, 0x106U);
    EXPECT_EQ(rig.channel.heard.second.us, 123U);
    rig.channel.confirmation = Confirmation{1U, ConfirmStep::kPair};
    const Confirmation confirmation = rig.Own().OnConfirm(PeerRig::Frame(0x104U), Instant{456U});
    EXPECT_EQ(rig.channel.heard.first.identifier, 0x104U);
    EXPECT_EQ(rig.channel.heard.second.us, 456U);
    EXPECT_EQ(confirmation.slot, 1U);
    EXPECT_EQ(confirmation.step, ConfirmStep::kPair);
}

// Given slot 1, then its demotion, its transmit fault and its inverse frame are those of slot 1.
TEST(PassedOn, CallsOfASlotNameIt)
{
    Verifies(req::SRS_TWO_001);
    Verifies(req::SRS_TWO_216);
    PeerRig rig{PeerRole::kB};
    rig.Own().Demote(1U);
    EXPECT_EQ(rig.channel.demoted, std::vector<SlotIndex>{1U});
    rig.Own().OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
    ASSERT_EQ(rig.channel.transmit_faults.size(), 1U);
    EXPECT_EQ(rig.channel.transmit_faults[0].first, 1U);
    EXPECT_EQ(rig.channel.transmit_faults[0].second, SrdoCause::kBusOff);
    EXPECT_EQ(rig.Own().InverseFrame(1U).data[0], 1U);
}

// Given slot 1, when the leader or the follower prepares it, then the channel prepares slot 1.
TEST(PassedOn, PrepareIsOfTheSlotAskedFor)
{
    Verifies(req::SRS_TWO_214);
    Verifies(req::SRS_TWO_151);
    PeerRig leader{PeerRole::kA};
    static_cast<void>(leader.Own().Prepare(1U));
    EXPECT_EQ(leader.channel.asked, 1U);
    PeerRig follower{PeerRole::kB};
    static_cast<void>(follower.Remote().Prepare(1U));
    EXPECT_EQ(follower.channel.asked, 1U);
}

// Given an SRVT of 5 ms for slot 1 alone, when its frame is armed at 30 ms, then it is awaited for 5 ms.
TEST(PassedOn, ArmedFrameIsAwaitedForTheSrvtOfItsSlot)
{
    Verifies(req::SRS_TWO_151);
    PeerRig rig{PeerRole::kB};
    rig.channel.srvt_ms[1] = 5U;
    rig.Cycle(30000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    EXPECT_EQ(rig.Say(35000U).armed[0].slot, 1U);
    EXPECT_EQ(rig.Say(35001U).armed[0].slot, kNoSlot);
}

// Given CPU A, then what the channel says in the first cycle is shown in that cycle.
TEST(PassedOn, LeaderShowsTheCountsOfTheSameCycle)
{
    Verifies(req::SRS_TWO_001);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.sct_checked = 11U;
    rig.channel.outcome.is_tx = 12U;
    rig.channel.outcome.is_invalid = 13U;
    rig.Cycle(500U);
    EXPECT_EQ(rig.own.guard, GuardView::kConfigured);
    EXPECT_EQ(rig.own.sct_checked, 11U);
    EXPECT_EQ(rig.own.is_tx, 12U);
    EXPECT_EQ(rig.own.is_invalid, 13U);
    EXPECT_EQ(rig.own.not_operational, 0U);
}

// Given CPU A and slots 0 and 1 due, then both are shown once a message was taken, and none before.
TEST(PassedOn, ContactLetsEverySlotBeDue)
{
    Verifies(req::SRS_TWO_010);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.due = 3U;
    rig.Cycle(500U);
    EXPECT_EQ(rig.own.due, 0U);
    // Nor after a start that follows contact
    rig.Contact(1000U);
    rig.Own().Restart(rig.config);
    rig.Cycle(5000U);
    EXPECT_EQ(rig.own.due, 0U);
    rig.Contact(6000U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.own.due, 3U);
}

// Given frames of the consumer in slot 0, then the remote voice names their steps as those of any other slot.
TEST(PassedOn, StepIsTheLowestBitOfTheIdentifier)
{
    Verifies(req::SRS_TWO_013);
    PeerRig rig{PeerRole::kB};
    EXPECT_EQ(rig.Remote().OnConfirm(PeerRig::Frame(0x101U), Instant{1U}).step, ConfirmStep::kNormal);
    EXPECT_EQ(rig.Remote().OnConfirm(PeerRig::Frame(0x102U), Instant{1U}).step, ConfirmStep::kPair);
}

// Given a CPU whose kernel was never started, then its message tells nothing.
TEST(PassedOn, NothingIsToldBeforeTheFirstStart)
{
    Verifies(req::SRS_TWO_006);
    Verifies(req::SRS_TWO_008);
    FakeChannel channel{};
    FakeWatchdog watchdog{};
    Peer peer{channel, watchdog, LinkConfig{PeerRole::kA, 40000U, 20000U, 400000U, 100U}};
    hal::LinkFrame frame{};
    LinkMessage said{};
    peer.Compose(PeerMoment{Instant{0U}, DeviceFault::kNone}, frame);
    ASSERT_EQ(Decode(frame, LinkSender{PeerRole::kA, 0U}, said), DecodeResult::kIntact);
    EXPECT_EQ(said.digest.value, 0U);
    EXPECT_EQ(said.check.slot, kNoSlot);
    EXPECT_EQ(said.check.result.signature, 0U);
    EXPECT_EQ(said.refusal.number, 0U);
    EXPECT_EQ(said.new_faults, 0U);
    EXPECT_EQ(said.released, 0U);
    EXPECT_EQ(said.due, 0U);
    EXPECT_EQ(said.echo.sequence, 0U);
    EXPECT_EQ(said.echo.stamp.us, 0U);
    EXPECT_EQ(said.echo.hold_us, 0U);
}

} // namespace
} // namespace counterpoint
