// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the voices hand on to the channel is what they were given, for another slot than the first.
#include "tests/safety_core/crosslink/peer_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

// Given the own voice of either CPU, then the channel has every argument of each call.
TEST(HandedOn, ByTheOwnVoice)
{
    Verifies(req::SRS_TWO_001);
    for (const PeerRole role : {PeerRole::kA, PeerRole::kB})
    {
        PeerRig rig{role};
        Channel& own = rig.Own();
        EXPECT_EQ(rig.channel.device, &rig.config);
        own.Store(ConfigItem{{1U, ConfigField::kSct, 0U}, 25U});
        EXPECT_EQ(rig.channel.stored[0].address.slot, 1U);
        EXPECT_EQ(rig.channel.stored[0].address.field, ConfigField::kSct);
        EXPECT_EQ(rig.channel.stored[0].value, 25U);
        std::uint8_t field = 0U;
        own.SetFields(1U, StaticFields{&field, nullptr});
        EXPECT_EQ(rig.channel.asked, 1U);
        EXPECT_EQ(rig.channel.fields.normal, &field);
        EXPECT_EQ(own.Validate(2U).signature, 0x1234U);
        EXPECT_EQ(rig.channel.asked, 2U);
        EXPECT_EQ(own.Recheck(1U).signature, 0x1234U);
        EXPECT_EQ(rig.channel.asked, 1U);
        own.OnFrame(PeerRig::Frame(0x105U), Instant{4U});
        EXPECT_EQ(rig.channel.heard, 0x105U);
        EXPECT_EQ(rig.channel.heard_at_us, 4U);
        own.Demote(2U);
        EXPECT_EQ(rig.channel.demoted[0], 2U);
        rig.channel.confirmation = Confirmation{1U, ConfirmStep::kPair};
        const Confirmation confirmation = own.OnConfirm(PeerRig::Frame(0x103U), Instant{7U});
        EXPECT_EQ(rig.channel.heard, 0x103U);
        EXPECT_EQ(rig.channel.heard_at_us, 7U);
        EXPECT_EQ(confirmation.slot, 1U);
        EXPECT_EQ(confirmation.step, ConfirmStep::kPair);
        own.OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
        EXPECT_EQ(rig.channel.transmit_faults[0].first, 1U);
        EXPECT_EQ(rig.channel.transmit_faults[0].second, SrdoCause::kBusOff);
    }
}

// Given the remote voice, then what it answers from the own channel is of the slot that was asked for.
TEST(HandedOn, ByTheRemoteVoice)
{
    Verifies(req::SRS_TWO_008);
    PeerRig rig{PeerRole::kB};
    EXPECT_EQ(rig.Remote().Digest(1U, DeviceDigest{4U}).value, 24U);
    EXPECT_EQ(rig.Remote().Validate(1U).signature, 0x1234U);
    EXPECT_EQ(rig.channel.asked, 1U);
    EXPECT_EQ(rig.Remote().Recheck(2U).signature, 0x1234U);
    EXPECT_EQ(rig.channel.asked, 2U);
    static_cast<void>(rig.Remote().InverseFrame(1U));
    EXPECT_EQ(rig.channel.asked, 1U);
    static_cast<void>(rig.Own().InverseFrame(2U));
    EXPECT_EQ(rig.channel.asked, 2U);
}

// Given CPU A, then its channel prepares the slot that is asked for; given CPU B, ahead, with that slot's SRVT.
TEST(HandedOn, ForPrepare)
{
    Verifies(req::SRS_TWO_011);
    PeerRig leader{PeerRole::kA};
    static_cast<void>(leader.Own().Prepare(1U));
    EXPECT_EQ(leader.channel.asked, 1U);
    PeerRig follower{PeerRole::kB};
    follower.Cycle(30000U);
    follower.channel.srvt_ms[1] = 5U;
    follower.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(follower.Remote().Prepare(1U));
    EXPECT_EQ(follower.channel.asked, 1U);
    EXPECT_EQ(follower.Say(35000U).armed[0].slot, 1U);
    EXPECT_EQ(follower.Say(35000U).armed[1].slot, kNoSlot);
    static_cast<void>(follower.Remote().Prepare(2U));
    const LinkMessage both = follower.Say(30000U);
    EXPECT_EQ(both.armed[0].slot, 1U);
    EXPECT_EQ(both.armed[1].slot, 2U);
    EXPECT_EQ(follower.Say(35001U).armed[0].slot, kNoSlot);
}

// Given an armed frame, when its pair is confirmed, or nothing of it is, then it still waits for its normal frame.
TEST(HandedOn, OnlyANormalFrameAnswersWhatIsArmed)
{
    Verifies(req::SRS_TWO_012);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(30000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    rig.channel.confirmation = Confirmation{1U, ConfirmStep::kPair};
    static_cast<void>(rig.Own().OnConfirm(PeerRig::Frame(0x104U), Instant{31000U}));
    EXPECT_EQ(rig.Say(32000U).armed[0].slot, 1U);
}

// Given slot 0 as a producer, then CPU A shows it due in contact alone.
TEST(HandedOn, FirstSlotIsDueInContactAlone)
{
    Verifies(req::SRS_TWO_010);
    PeerRig rig{PeerRole::kA};
    rig.channel.outcome.due = 1U;
    rig.Cycle(500U);
    EXPECT_EQ(rig.own.due, 0U);
    EXPECT_EQ(rig.own.sct_checked, 1U); // The leader shows its counts at once.
    EXPECT_EQ(rig.own.not_operational, 0U);
    rig.Contact(1000U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.own.due, 1U);
}

// Given CPU B and what two sides ask for at once, or what stands for two reasons, then neither takes the other back.
TEST(HandedOn, TwoReasonsAreNotFewerThanOne)
{
    Verifies(req::SRS_TWO_011);
    PeerRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    LinkMessage word = rig.AnswerTo(5000U);
    word.due = 2U;
    rig.Hear(word, 7000U);
    CycleInput input{};
    input.now = Instant{8000U};
    input.request = 2U;
    static_cast<void>(rig.Own().OnCycle(input));
    EXPECT_EQ(rig.channel.last_input.request, 2U);
    // Armed, and due by its own schedule, not by the leader's
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    rig.Contact(9000U);
    rig.channel.outcome.due = 2U;
    rig.Cycle(12000U);
    rig.Cycle(13000U);
    EXPECT_EQ(rig.channel.last_input.stand, 2U);
}

// t [us]   2^31 + 2^28 ...: the first half of the counter is over
TEST(HandedOn, RefusalCountsFromItsOwnMoment)
{
    Verifies(req::SRS_TWO_012);
    constexpr std::uint32_t kLate = 0x90000000U;
    PeerRig rig{PeerRole::kB};
    rig.Cycle(kLate);
    rig.Contact(kLate + 1000U);
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x103U), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(1U));
    LinkMessage word = rig.AnswerTo(kLate + 4000U);
    word.refusal = Refusal{1U, SrdoCause::kNotInverse};
    rig.Hear(word, kLate + 6000U);
    ASSERT_EQ(rig.channel.transmit_faults.size(), 1U);
    rig.Contact(kLate + 8000U);
    rig.Cycle(kLate + 11000U);
    rig.Cycle(kLate + 12000U);
    EXPECT_EQ(rig.channel.last_input.stand, 0U);
}

/// An own voice without a peer around it.
class NewsOfTheOwnVoice : public ::testing::Test
{
  protected:
    NewsOfTheOwnVoice()
    {
        config.srdo_count = 3U;
        own.Restart(config);
    }
    void Cycle(const SrdoMask new_fault, const SrdoMask fresh, const std::uint32_t at_us)
    {
        channel.outcome.new_fault = new_fault;
        channel.outcome.fresh = fresh;
        CycleInput input{};
        input.now = Instant{at_us};
        static_cast<void>(own.OnCycle(input));
    }

    FakeChannel channel{};
    DeviceConfig config{};
    OwnVoice own{channel, PeerRole::kA};
};

TEST_F(NewsOfTheOwnVoice, AreKeptUntilTheyAreTaken)
{
    Verifies(req::SRS_TWO_006);
    Verifies(req::SRS_TWO_014);
    Cycle(0U, 0U, 1000U);
    (void)own.TakeNews();
    // A fault and a pair of slot 1 in one cycle, and another fault of it in the next one
    Cycle(2U, 2U, 2000U);
    Cycle(2U, 0U, 3000U);
    News news = own.TakeNews();
    EXPECT_EQ(news.changed, 2U);
    EXPECT_EQ(news.faults, 2U);
    own.Demote(1U);
    news = own.TakeNews();
    EXPECT_EQ(news.changed, 2U);
    EXPECT_EQ(news.faults, 0U);
}

// Given discards in slots 0 and 1 at 1 ms, when 2^29 us are over, then the age of each stays there.
TEST_F(NewsOfTheOwnVoice, EachDiscardGetsNoOlderThanItMay)
{
    Verifies(req::SRS_TWO_015);
    Cycle(3U, 0U, 1000U);
    for (std::uint32_t cycle = 0U; cycle < 3U; ++cycle)
    {
        Cycle(0U, 0U, 0x30000000U);
    }
    EXPECT_EQ(own.Moments().DiscardedAt(0U).us, 0x10000000U);
    EXPECT_EQ(own.Moments().DiscardedAt(1U).us, 0x10000000U);
}

TEST(PairMoments_, AgeIsLimitedExactlyAndNotBefore)
{
    Verifies(req::SRS_TWO_015);
    PairMoments moments{};
    moments.Restart();
    moments.Discard(2U, Instant{1000U});
    moments.LimitAge(1U, Instant{0x20000000U + 500U});
    EXPECT_EQ(moments.DiscardedAt(1U).us, 1000U);
    moments.LimitAge(1U, Instant{0x20000000U + 1001U});
    EXPECT_EQ(moments.DiscardedAt(1U).us, 1001U);
}

TEST(Instants, AreInOrderWithinHalfTheCounter)
{
    Verifies(req::SRS_TWO_002);
    EXPECT_TRUE(IsNotAfter(Instant{5U}, Instant{5U}));
    EXPECT_TRUE(IsNotAfter(Instant{5U}, Instant{5U + 0x7FFFFFFFU}));
    EXPECT_FALSE(IsNotAfter(Instant{5U}, Instant{5U + 0x80000000U}));
    EXPECT_FALSE(IsNotAfter(Instant{5U}, Instant{4U}));
}

} // namespace
} // namespace counterpoint
