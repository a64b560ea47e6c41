// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The table of states, event by event, and that its check while compiling finds what a table may not say.
#include "channel_a/slot.hpp"
#include "channel_a/state.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::channel_a
{
namespace
{

using S = State;
constexpr State kX = State::kBroken;

struct Column
{
    Event event;
    State after[kStateCount]; // By the state before, in the order of the enumeration.
};

// What is required, event by event.
constexpr Column kColumns[] = {
    {Event::kBecomesConsumer, {S::kWaiting, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX}},
    {Event::kBecomesProducer, {S::kIdle, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX}},
    {Event::kLeft,
     {S::kOff, kX, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff, S::kOff,
      S::kOff, S::kOff}},
    {Event::kBroke, {kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX}},
    {Event::kNormal,
     {kX, kX, S::kWaitingPending, kX, S::kWaitingBoth, kX, S::kFaultedPending, kX, S::kFaultedBoth, kX,
      S::kReleasedBoth, kX, kX, kX, kX}},
    {Event::kInverse,
     {kX, kX, kX, S::kWaitingHeld, kX, S::kWaitingHeld, kX, S::kFaultedHeld, kX, S::kFaultedHeld, kX, S::kReleasedHeld,
      kX, kX, kX}},
    {Event::kFault,
     {kX, kX, S::kFaulted, S::kFaulted, S::kFaulted, S::kFaulted, S::kFaulted, S::kFaulted, S::kFaulted, S::kFaulted,
      S::kFaulted, S::kFaulted, kX, kX, kX}},
    {Event::kDrop,
     {kX, kX, S::kFaulted, S::kFaultedPending, S::kFaulted, S::kFaultedPending, S::kFaulted, S::kFaultedPending,
      S::kFaulted, S::kFaultedPending, S::kFaulted, S::kFaultedPending, kX, kX, kX}},
    {Event::kRelease,
     {kX, kX, kX, kX, S::kReleasedHeld, S::kReleasedBoth, kX, kX, S::kReleasedHeld, S::kReleasedBoth, S::kReleasedHeld,
      S::kReleasedBoth, kX, kX, kX}},
    {Event::kPrepared, {kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, S::kNormalAwaited, kX, kX}},
    {Event::kNormalSent, {kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, S::kInverseAwaited, kX}},
    {Event::kPairSent, {kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, S::kIdle}},
    {Event::kGivenUp, {kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, kX, S::kIdle, S::kIdle}},
};

TEST(ChannelAState, FollowsTheTable)
{
    Verifies(req::SRS_CONS_012);
    Verifies(req::SRS_CONS_013);
    Verifies(req::SRS_REL_001);
    ASSERT_EQ(sizeof(kColumns) / sizeof(kColumns[0]), kEventCount);
    for (const Column& column : kColumns)
    {
        for (std::size_t state = 0U; state < kStateCount; ++state)
        {
            EXPECT_EQ(After(static_cast<State>(state), column.event), column.after[state])
                << "state " << state << ", event " << static_cast<std::uint32_t>(column.event);
        }
    }
}

TEST(ChannelAState, CheckOfTheTableFindsWhatMayNotBe)
{
    Verifies(req::SRS_CONS_024);
    EXPECT_EQ(Flaws(kTransitions, kFacts), 0U);
    const auto flaws_of = [](State from, Event event, State to)
    {
        Transitions spoiled = kTransitions;
        spoiled.after[static_cast<std::size_t>(from)][static_cast<std::size_t>(event)] = to;
        return Flaws(spoiled, kFacts);
    };
    // Not total
    EXPECT_EQ(flaws_of(S::kIdle, Event::kPrepared, static_cast<State>(15U)), 0xFFFFFFFFU);
    // Released without a pair, without an event that releases, by a fault; by the events that may
    EXPECT_EQ(flaws_of(S::kWaiting, Event::kRelease, S::kReleasedHeld), 2U);
    EXPECT_EQ(flaws_of(S::kOff, Event::kRelease, S::kReleasedHeld), 2U);
    EXPECT_EQ(flaws_of(S::kWaiting, Event::kBecomesConsumer, S::kReleasedHeld), 2U);
    EXPECT_EQ(flaws_of(S::kWaitingHeld, Event::kNormal, S::kReleasedHeld), 1U);
    EXPECT_EQ(flaws_of(S::kReleasedHeld, Event::kFault, S::kReleasedHeld), 1U);
    EXPECT_EQ(flaws_of(S::kReleasedHeld, Event::kInverse, S::kReleasedHeld), 0U);
    // Held without an inverse frame, or without the normal one before it
    EXPECT_EQ(flaws_of(S::kWaitingPending, Event::kNormal, S::kWaitingHeld), 1U);
    EXPECT_EQ(flaws_of(S::kWaiting, Event::kInverse, S::kWaitingHeld), 1U);
    // Active although OPERATIONAL was left, and out of what is broken
    EXPECT_EQ(flaws_of(S::kFaulted, Event::kLeft, S::kFaulted), 1U);
    EXPECT_EQ(flaws_of(S::kBroken, Event::kLeft, S::kOff), 1U);
}

TEST(ChannelAState, OfAnUnknownValueIsBroken)
{
    Verifies(req::SRS_CONS_024);
    Record record{};
    // Zeros are no state, nor is a value beyond the last one with its complement, nor one without it
    EXPECT_EQ(StateOf(record), State::kBroken);
    record.grants.Set(Grant::kState, 14U);
    EXPECT_EQ(StateOf(record), State::kInverseAwaited);
    record.grants.Set(Grant::kState, 15U);
    EXPECT_EQ(StateOf(record), State::kBroken);
    record.grants.Set(Grant::kState, 10U);
    EXPECT_EQ(StateOf(record), State::kReleasedHeld);
    EXPECT_FALSE(IsSound(record)) << "the other grants are zeros";
}

TEST(ChannelAGrants, AreOnlyWhatIsBesideItsComplement)
{
    Verifies(req::SRS_CONS_024);
    Grants grants{};
    for (std::uint8_t grant = 0U; grant < 8U; ++grant)
    {
        EXPECT_FALSE(grants.Is(static_cast<Grant>(grant), 0U));
        EXPECT_FALSE(grants.AreWhole());
        grants.Set(static_cast<Grant>(grant), kYes);
        EXPECT_TRUE(grants.Is(static_cast<Grant>(grant), kYes));
        EXPECT_FALSE(grants.Is(static_cast<Grant>(grant), kNo));
    }
    EXPECT_TRUE(grants.AreWhole());
    // Every single bit
    for (std::size_t bit = 0U; bit < (8U * sizeof(grants)); ++bit)
    {
        Grants flipped = grants;
        std::uint8_t& byte = reinterpret_cast<std::uint8_t*>(&flipped)[bit / 8U];
        byte = static_cast<std::uint8_t>(byte ^ (1U << (bit % 8U)));
        EXPECT_FALSE(flipped.AreWhole()) << bit;
        EXPECT_FALSE(flipped.Is(static_cast<Grant>((bit / 8U) % 8U), kYes)) << bit;
    }
}

} // namespace
} // namespace counterpoint::channel_a
