// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Two CPUs with 64 SRDOs: more than one consumer, one that is unused, slots in both halves of a mask, and slots that
// the link names though they cannot be.
#include "tests/safety_core/crosslink/wide_rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <memory>

namespace counterpoint
{
namespace
{

// Given pairs in slots 5 (on the bus at 8 ms) and 50 (at 9 ms), when the peer tells both, then each is its own pair
// with its own data; the consumer of which it told nothing does not match, and the unused slot shows what the own
// channel has.
TEST(ManySlots, PairsOfTwoConsumersAreKeptApart)
{
    Verifies(req::SRS_TWO_002);
    Verifies(req::SRS_TWO_003);
    Verifies(req::SRS_TWO_005);
    WideRig rig{PeerRole::kA};
    rig.Contact(1000U);
    rig.channel.outcome.waiting = MaskOf({3U});
    rig.channel.held[3] = HeldPair{Payload{0U, 0U}, 2U, 1U};
    rig.channel.held[2].ordinal = 77U;
    rig.Hold(5U, 8000U, 3U);
    rig.Hold(50U, 9000U, 7U);
    rig.Cycle(10000U);
    rig.channel.outcome.fresh = 0U;
    rig.Tell({PairReport(50U, 2000U, 0x150U), PairReport(5U, 3500U, 0x105U)}, MaskOf({2U, 3U, 5U, 50U}));
    EXPECT_EQ(rig.Remote().Held(5U).ordinal, 3U);
    EXPECT_EQ(rig.Remote().Held(5U).data.low, 0x105U);
    EXPECT_EQ(rig.Remote().Held(50U).ordinal, 7U);
    EXPECT_EQ(rig.Remote().Held(50U).data.low, 0x150U);
    EXPECT_EQ(rig.Remote().Held(3U).ordinal, ~2U);
    EXPECT_EQ(rig.Remote().Held(2U).ordinal, 77U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.fresh, MaskOf({5U, 50U}));
    EXPECT_EQ(rig.remote.released, MaskOf({5U, 50U}));
    // A demotion of one is none of the other
    rig.Remote().Demote(50U);
    rig.Cycle(30000U);
    EXPECT_EQ(rig.remote.released, MaskOf({5U}));
    // And the pair of one is not that of the other: told with the age of slot 50's, slot 5's does not match
    rig.Tell({PairReport(5U, 2000U, 0x105U)}, MaskOf({5U}));
    EXPECT_EQ(rig.Remote().Held(5U).ordinal, ~3U);
    EXPECT_EQ(rig.Remote().Held(50U).ordinal, 7U);
}

// Given new faults of slots 5 and 50 in one cycle and a discard of slot 60 in a later one, when they are reported, then
// each has the age of its own discard.
TEST(ManySlots, EachDiscardHasItsOwnAge)
{
    Verifies(req::SRS_TWO_004);
    Verifies(req::SRS_TWO_006);
    WideRig rig{PeerRole::kA};
    rig.channel.outcome.waiting = MaskOf({0U, 5U, 50U, 60U});
    rig.Cycle(10000U); // Entering is a discard of all.
    rig.channel.outcome.new_fault = MaskOf({5U, 50U});
    rig.Cycle(20000U);
    rig.channel.outcome.new_fault = 0U;
    rig.Cycle(25000U);
    rig.Own().Demote(60U);
    const LinkMessage said = rig.Say(30000U);
    EXPECT_EQ(said.new_faults, MaskOf({5U, 50U}));
    EXPECT_EQ(said.reports[0].slot, 5U);
    EXPECT_EQ(said.reports[0].age_us, 10000U);
    EXPECT_EQ(said.reports[1].slot, 50U);
    EXPECT_EQ(said.reports[1].age_us, 10000U);
    EXPECT_EQ(said.reports[2].slot, 60U);
    EXPECT_EQ(said.reports[2].age_us, 5000U);
    EXPECT_EQ(said.reports[3].slot, 0U);
    EXPECT_EQ(said.reports[3].age_us, 20000U);
}

// Given six consumers in both halves of a mask, then each message reports the four next ones, the lowest again behind
// the highest, what is new or demoted before the others.
TEST(ManySlots, ReportsGoRoundThroughBothHalves)
{
    Verifies(req::SRS_TWO_014);
    WideRig rig{PeerRole::kA};
    rig.channel.outcome.waiting = MaskOf({0U, 31U, 32U, 47U, 48U, 63U});
    rig.Cycle(10000U); // Entering: all are news.
    const auto told = [&rig]
    {
        const LinkMessage said = rig.Say(10000U);
        return std::array<std::uint32_t, 4>{said.reports[0].slot, said.reports[1].slot, said.reports[2].slot,
                                            said.reports[3].slot};
    };
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{31U, 32U, 47U, 48U}));
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{63U, 0U, 31U, 32U}));
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{47U, 48U, 63U, 0U}));
    rig.channel.outcome.fresh = MaskOf({48U});
    rig.Cycle(20000U);
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{48U, 63U, 0U, 31U}));
    rig.Own().Demote(0U);
    EXPECT_EQ(told(), (std::array<std::uint32_t, 4>{0U, 31U, 32U, 47U}));
}

// Given one slot of each quarter at a time, when the peer releases it and the comparator agrees, then the permit is
// that of the slot: its mask, and the answer to challenge 89ABCDEFh with the constant of channel B.
TEST(ManySlots, PermitOfEachQuarterOfTheMask)
{
    Verifies(req::SRS_TWO_009);
    struct Case
    {
        SlotIndex slot;
        std::uint32_t response;
    };
    for (const Case& given :
         {Case{0U, 0x4AAC1A90U}, Case{15U, 0xA9FBD019U}, Case{16U, 0x8F375019U}, Case{31U, 0x44C05019U},
          Case{32U, 0xFA495019U}, Case{47U, 0x44C05019U}, Case{48U, 0x3ED485A2U}, Case{63U, 0xDF84D019U}})
    {
        WideRig rig{PeerRole::kA};
        rig.Contact(1000U);
        rig.Hold(given.slot, 8000U, 3U);
        rig.Cycle(10000U);
        const SrdoMask bit = MaskOf({given.slot});
        rig.Tell({PairReport(given.slot, 3500U, 1U)}, bit);
        rig.Cycle(20000U);
        EXPECT_EQ(rig.remote.released, bit);
        EXPECT_EQ(rig.Remote().Commit(Agreement{bit, bit}, 0U), 0U);
        const Permit permit = rig.Remote().Answer(0x89ABCDEFU);
        EXPECT_EQ(permit.mask, bit);
        EXPECT_EQ(permit.response, given.response) << static_cast<int>(given.slot);
    }
}

// Given CPU B, when the leader calls slots 31, 32 and 63 due, then they are requested of the channel, and as many as
// have room are prepared.
TEST(ManySlots, DueSlotsOfBothHalvesAreRequested)
{
    Verifies(req::SRS_TWO_011);
    Verifies(req::SRS_TWO_150);
    WideRig rig{PeerRole::kB};
    rig.Cycle(1000U);
    LinkMessage word = rig.AnswerTo(2000U);
    word.due = MaskOf({31U, 32U, 63U});
    rig.Hear(word, 4000U);
    rig.channel.outcome.due = MaskOf({32U, 63U});
    rig.Cycle(10000U);
    EXPECT_EQ(rig.channel.last_input.request, MaskOf({31U, 32U, 63U}));
    EXPECT_EQ(rig.remote.due, MaskOf({31U, 32U, 63U}));
    EXPECT_EQ(rig.own.due, MaskOf({32U, 63U}));
    rig.channel.prepared = PreparedPair{PeerRig::Frame(0x17FU), PrepareStatus::kReady};
    static_cast<void>(rig.Remote().Prepare(63U));
    EXPECT_EQ(rig.Say(10000U).armed[0].slot, 63U);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.channel.last_input.request, MaskOf({31U, 32U}));
    EXPECT_EQ(rig.channel.last_input.stand, MaskOf({63U}));
}

// Given CPU A and armed frames for slots 63 and 0, then each is due and gives its frame; slots that cannot be are not.
TEST(ManySlots, ArmedFramesOfBothEndsAreUsed)
{
    Verifies(req::SRS_TWO_214);
    WideRig rig{PeerRole::kA};
    rig.Cycle(1000U);
    LinkMessage word = rig.AnswerTo(2000U);
    word.armed[0] = ArmedFrame{63U, 4U, PeerRig::Frame(0x17FU)};
    word.armed[1] = ArmedFrame{0U, 5U, PeerRig::Frame(0x101U)};
    rig.Hear(word, 4000U);
    rig.Cycle(10000U);
    EXPECT_EQ(rig.remote.due, MaskOf({0U, 63U}));
    rig.channel.prepared = PreparedPair{CanFrame{}, PrepareStatus::kReady};
    static_cast<void>(rig.Own().Prepare(63U));
    EXPECT_EQ(rig.Remote().Prepare(63U).normal.identifier, 0x17FU);
    rig.Cycle(20000U);
    EXPECT_EQ(rig.remote.due, MaskOf({0U}));
    EXPECT_EQ(rig.Remote().Prepare(0U).normal.identifier, 0x101U);
    // Two frames for one slot call it due as one does
    word = rig.AnswerTo(20000U);
    word.armed[0] = ArmedFrame{40U, 7U, PeerRig::Frame(0x151U)};
    word.armed[1] = ArmedFrame{40U, 8U, PeerRig::Frame(0x151U)};
    rig.Hear(word, 22000U);
    rig.Cycle(22100U);
    EXPECT_EQ(rig.remote.due, MaskOf({40U}));
    for (const SlotIndex slot : std::initializer_list<SlotIndex>{64U, 66U, 127U, 128U, 254U})
    {
        word = rig.AnswerTo(23000U);
        word.armed[0] = ArmedFrame{slot, 9U, PeerRig::Frame(0x17FU)};
        rig.Hear(word, 25000U);
        rig.Cycle(30000U);
        EXPECT_EQ(rig.remote.due, 0U) << static_cast<int>(slot);
    }
}

// Given 64 slots, then a frame belongs to the slot whose identifiers it has, up to 180h; one beyond belongs to none.
TEST(ManySlots, FrameOfTheLastIdentifierBelongsToTheLastSlot)
{
    Verifies(req::SRS_TWO_013);
    Verifies(req::SRS_TWO_217);
    WideRig rig{PeerRole::kB};
    const auto slot_of = [&rig](const std::uint32_t identifier)
    { return static_cast<std::uint32_t>(rig.Remote().OnConfirm(PeerRig::Frame(identifier), Instant{1U}).slot); };
    EXPECT_EQ(slot_of(0x100U), 255U);
    EXPECT_EQ(slot_of(0x101U), 0U);
    EXPECT_EQ(slot_of(0x165U), 50U);
    EXPECT_EQ(slot_of(0x17FU), 63U);
    EXPECT_EQ(slot_of(0x180U), 63U);
    EXPECT_EQ(slot_of(0x181U), 255U);
    // A producer's frame is an echo in the last slot as in any other
    EXPECT_FALSE(rig.peer.IsEcho(PeerRig::Frame(0x17FU)));
    rig.channel.direction[63] = 1U;
    EXPECT_TRUE(rig.peer.IsEcho(PeerRig::Frame(0x180U)));
}

// Given 64 slots, then the digest is told once all of them were gone through, and each has its part.
TEST(ManySlots, DigestHasThePartOfEverySlot)
{
    Verifies(req::SRS_TWO_007);
    WideRig rig{PeerRole::kA};
    rig.channel.digest_of.fill(2U);
    for (std::uint32_t cycle = 1U; cycle < 64U; ++cycle)
    {
        rig.Cycle(cycle * 10000U);
    }
    EXPECT_EQ(rig.Say(630000U).digest.value, 0U);
    rig.Cycle(640000U);
    EXPECT_EQ(rig.Say(640000U).digest.value, 128U);
}

/// The two voices of CPU A with something behind each that nobody may write to.
struct Fenced
{
    static constexpr std::uint8_t kFence = 0xC5U;

    FakeChannel channel{};
    DeviceConfig config{};
    OwnVoice own{channel, PeerRole::kA};
    std::array<std::uint8_t, 512> behind_own{};
    RemoteVoice remote{own, LinkConfig{PeerRole::kA, 40000U, 20000U, 400000U, 100U}};
    std::array<std::uint8_t, 8192> behind_remote{}; // As far as a slot of eight bits can lead.

    Fenced()
    {
        behind_own.fill(kFence);
        behind_remote.fill(kFence);
        config.srdo_count = 64U;
        own.Restart(config);
        remote.Restart(config);
        remote.Link().Examine(Instant{0U});
        remote.Link().OnCompose(1U);
    }
    [[nodiscard]] bool IsWhole() const
    {
        const auto is_fence = [](const std::uint8_t byte) { return byte == kFence; };
        return std::all_of(behind_own.begin(), behind_own.end(), is_fence) &&
               std::all_of(behind_remote.begin(), behind_remote.end(), is_fence);
    }
    void Hear(LinkMessage message)
    {
        message.sequence = ++sequence;
        message.stamp = Instant{sequence * 1000U};
        message.echo = LinkEcho{1U, Instant{sequence * 1000U}, 0U, kHeard};
        message.flow = hal::kFlowReference;
        message.fault = DeviceFault::kNone;
        remote.OnMessage(message, Instant{sequence * 1000U});
    }
    std::uint32_t sequence{0U};
};

// Given a pair told of every slot, when the link names a check of a slot from 64 up, then nothing that was told
// changes: what a slot of eight bits leads to is never written outside of its array.
TEST(ManySlots, CheckOfASlotThatCannotBeIsWrittenNowhere)
{
    Verifies(req::SRS_TWO_008);
    Verifies(req::SRS_TWO_210);
    const std::unique_ptr<Fenced> fenced = std::make_unique<Fenced>();
    fenced->channel.outcome.waiting = ~SrdoMask{0U};
    static_cast<void>(fenced->own.OnCycle(CycleInput{}));
    for (std::uint32_t first = 0U; first < 64U; first += 4U)
    {
        LinkMessage word = Silence();
        for (std::uint32_t number = 0U; number < 4U; ++number)
        {
            const SlotIndex slot = static_cast<SlotIndex>(first + number);
            word.reports[number] =
                SlotReport{slot, Holding::kNothing, SrdoState::kFaulted, SrdoCause::kSct, 0U, 0U, Payload{0U, 0U}};
        }
        fenced->Hear(word);
    }
    for (std::uint32_t slot = 64U; slot < 256U; ++slot)
    {
        LinkMessage word = Silence();
        word.check = SlotCheck{static_cast<SlotIndex>(slot), {ConfigFault::kMapping, 0xEEEEU}};
        fenced->Hear(word);
        for (SlotIndex told = 0U; told < 64U; ++told)
        {
            const SrdoView view = fenced->remote.View(told);
            ASSERT_EQ(view.state, SrdoState::kFaulted) << slot << " changed " << static_cast<int>(told);
            ASSERT_EQ(view.first_cause, SrdoCause::kSct) << slot << " changed " << static_cast<int>(told);
            ASSERT_EQ(fenced->remote.Held(told).ordinal, 0U) << slot << " changed " << static_cast<int>(told);
            ASSERT_EQ(fenced->remote.Recheck(told).signature, 0x1234U) << slot << " changed " << static_cast<int>(told);
        }
    }
    EXPECT_TRUE(fenced->IsWhole());
}

// Given checks of the first and the last slot, then each is told back for its slot alone.
TEST(ManySlots, CheckOfTheLastSlotIsKept)
{
    Verifies(req::SRS_TWO_008);
    Verifies(req::SRS_TWO_210);
    const std::unique_ptr<Fenced> fenced = std::make_unique<Fenced>();
    static_cast<void>(fenced->own.OnCycle(CycleInput{}));
    LinkMessage word = Silence();
    word.check = SlotCheck{63U, {ConfigFault::kNone, 0x6363U}};
    fenced->Hear(word);
    word.check = SlotCheck{0U, {ConfigFault::kSignature, 0x0101U}};
    fenced->Hear(word);
    EXPECT_EQ(fenced->remote.Recheck(63U).signature, 0x6363U);
    EXPECT_EQ(fenced->remote.Recheck(63U).fault, ConfigFault::kNone);
    EXPECT_EQ(fenced->remote.Recheck(0U).signature, 0x0101U);
    EXPECT_EQ(fenced->remote.Recheck(0U).fault, ConfigFault::kSignature);
    EXPECT_EQ(fenced->remote.Recheck(62U).signature, 0x1234U);
}

// Given reports of slots from 64 up, then nothing behind the voices is written, and no slot becomes fresh.
TEST(ManySlots, ReportOfASlotThatCannotBeIsWrittenNowhere)
{
    Verifies(req::SRS_TWO_014);
    const std::unique_ptr<Fenced> fenced = std::make_unique<Fenced>();
    for (std::uint32_t slot = 64U; slot < 256U; ++slot)
    {
        LinkMessage word = Silence();
        word.reports[0] = PairReport(static_cast<SlotIndex>(slot), 0U, 0xEEEEEEEEU);
        word.released = ~SrdoMask{0U};
        fenced->Hear(word);
        CycleInput input{};
        input.now = Instant{fenced->sequence * 1000U};
        const CycleOutcome outcome = fenced->remote.OnCycle(input);
        EXPECT_EQ(outcome.fresh, 0U) << slot;
        EXPECT_EQ(outcome.released, 0U) << slot;
    }
    EXPECT_TRUE(fenced->IsWhole());
}

// Given an identifier behind the last one, when its SRDO is registered, then nothing behind the voice is written.
TEST(ManySlots, IdentifierThatCannotBeIsRegisteredNowhere)
{
    Verifies(req::SRS_TWO_013);
    const std::unique_ptr<Fenced> fenced = std::make_unique<Fenced>();
    for (const std::uint32_t identifier : std::initializer_list<std::uint32_t>{0x181U, 0x183U, 0x1FFU, 0x0FFU, 0U})
    {
        fenced->channel.cob_id_1[7] = identifier;
        static_cast<void>(fenced->own.Validate(7U));
        EXPECT_EQ(fenced->own.Moments().SlotOfFrame(PeerRig::Frame(identifier)), kNoSlot) << identifier;
    }
    EXPECT_TRUE(fenced->IsWhole());
}

} // namespace
} // namespace counterpoint
