// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_STATE_HPP
#define CHANNEL_A_STATE_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

// What an SRDO is in, what can happen to it, and the one table that says what comes of it.
namespace counterpoint::channel_a
{

/// Every state of an SRDO. Of a consumer the name says the standing (waiting, faulted, released), then what it has: a
/// pending normal frame, a held pair, or both. A released one always holds a pair. [SRS_REL_001, SRS_CONS_010]
enum class State : std::uint8_t
{
    kOff = 0U,
    kBroken = 1U, ///< Its record is corrupted: nothing leads out of it but Restart. [SRS_CONS_024]
    kWaiting = 2U,
    kWaitingPending = 3U,
    kWaitingHeld = 4U,
    kWaitingBoth = 5U,
    kFaulted = 6U,
    kFaultedPending = 7U,
    kFaultedHeld = 8U,
    kFaultedBoth = 9U,
    kReleasedHeld = 10U,
    kReleasedBoth = 11U,
    kIdle = 12U,           ///< Producer without a pair in flight.
    kNormalAwaited = 13U,  ///< Producer: the confirmation of the normal frame comes next.
    kInverseAwaited = 14U, ///< Producer: that of the inverse frame.
};
constexpr std::size_t kStateCount = 15U;

enum class Event : std::uint8_t
{
    kBecomesConsumer = 0U, ///< OPERATIONAL is entered.
    kBecomesProducer = 1U,
    kLeft = 2U,    ///< OPERATIONAL is left. [SRS_CONS_019, SRS_PROD_011]
    kBroke = 3U,   ///< The record was found corrupted.
    kNormal = 4U,  ///< A normal frame as it should be. [SRS_CONS_006]
    kInverse = 5U, ///< An inverse frame as it should be.
    kFault = 6U,   ///< Nothing is pending or held any more. [SRS_CONS_012]
    kDrop = 7U,    ///< The held pair goes, what is pending stays. [SRS_CONS_013, SRS_REL_006]
    kRelease = 8U,
    kPrepared = 9U, ///< A pair is in flight. [SRS_PROD_006]
    kNormalSent = 10U,
    kPairSent = 11U,
    kGivenUp = 12U, ///< [SRS_PROD_009]
};
constexpr std::size_t kEventCount = 13U;

/// What Flaws says of a table that does not lead to a state everywhere.
constexpr std::uint32_t kNotTotal = 0xFFFFFFFFU;

enum class Role : std::uint8_t
{
    kNone = 0U,
    kConsumer = 1U,
    kProducer = 2U,
};

/// What is true of a state.
struct Facts
{
    SrdoState shown;
    Role role;
    bool has_pending;
    bool holds_pair;
    bool is_flying; ///< A producer's pair is in flight.
};

struct FactsTable
{
    Facts of[kStateCount]; // MISRA D-001
};

struct Transitions
{
    State after[kStateCount][kEventCount]; // MISRA D-001
};

/// @brief How much of a table is wrong; 0 of a sound one. Total: every event leads from every state to a state. Nothing
/// is granted by itself: a released state comes of kRelease in a state that holds a pair, or in a released state of a
/// frame of the next pair; a pair is held only after an inverse frame. Nothing leads out of kBroken, and what has left
/// OPERATIONAL is neither consumer nor producer.
[[nodiscard]] constexpr std::uint32_t Flaws(const Transitions& table, const FactsTable& facts) noexcept
{
    std::uint32_t flaws = 0U;
    for (std::size_t from = 0U; from < kStateCount; ++from)
    {
        const Facts& before = facts.of[from];
        for (std::size_t event = 0U; event < kEventCount; ++event)
        {
            const State next = table.after[from][event];
            if (static_cast<std::size_t>(next) >= kStateCount)
            {
                return kNotTotal;
            }
            const Facts& after = facts.of[static_cast<std::size_t>(next)];
            const bool is_inverse = event == static_cast<std::size_t>(Event::kInverse);
            const bool is_frame = is_inverse || (event == static_cast<std::size_t>(Event::kNormal));
            const bool is_release = event == static_cast<std::size_t>(Event::kRelease);
            const bool is_left = event == static_cast<std::size_t>(Event::kLeft);
            const bool was_released = before.shown == SrdoState::kReleased;
            const bool is_released = after.shown == SrdoState::kReleased;
            const bool may_release = (is_release && before.holds_pair) || (is_frame && was_released);
            const bool may_hold = (is_inverse && before.has_pending) || before.holds_pair;
            flaws += (is_released && !may_release) ? 1U : 0U;
            flaws += (after.holds_pair && !may_hold) ? 1U : 0U;
            flaws += (is_left && (after.role != Role::kNone)) ? 1U : 0U;
            flaws += ((from == static_cast<std::size_t>(State::kBroken)) && (next != State::kBroken)) ? 1U : 0U;
        }
    }
    return flaws;
}

/// The tables. That they are sound is checked where they are, in state.cpp.
extern const FactsTable kFacts;
extern const Transitions kTransitions;

[[nodiscard]] inline const Facts& FactsOf(const State state) noexcept
{
    return kFacts.of[static_cast<std::size_t>(state)];
}

[[nodiscard]] inline bool IsReleased(const State state) noexcept
{
    return FactsOf(state).shown == SrdoState::kReleased;
}

/// @brief What an event makes of a state.
[[nodiscard]] inline State After(const State state, const Event event) noexcept
{
    return kTransitions.after[static_cast<std::size_t>(state)][static_cast<std::size_t>(event)];
}

} // namespace counterpoint::channel_a

#endif
