// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SLOT_HPP
#define CHANNEL_A_SLOT_HPP

#include "channel_a/state.hpp"
#include "channel_a/storage.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// The state of one slot, and what follows every change of it: the only source that writes Record::state.
namespace counterpoint::channel_a
{

/// @brief The state of a record; kBroken where it is none. [SRS_CONS_024]
[[nodiscard]] inline State StateOf(const Record& record) noexcept
{
    const std::uint8_t value = record.grants.Of(Grant::kState);
    return (record.grants.IsWhole(Grant::kState) && (value < kStateCount)) ? static_cast<State>(value) : State::kBroken;
}

[[nodiscard]] inline const Facts& FactsOf(const Record& record) noexcept
{
    return FactsOf(StateOf(record));
}

/// @brief Whether every grant is beside its complement, and nothing was found broken before.
[[nodiscard]] inline bool IsSound(const Record& record) noexcept
{
    return record.grants.AreWhole() && (StateOf(record) != State::kBroken);
}

[[nodiscard]] inline SrdoCause FirstCauseOf(const Record& record) noexcept
{
    return static_cast<SrdoCause>(record.grants.Of(Grant::kFirstCause));
}

void SetFirstCause(Record& record, SrdoCause cause) noexcept;
/// @brief The slot in the mask of its state, and in no other. [SRS_CONS_023]
void Show(Voice& voice, std::size_t slot, SrdoState shown) noexcept;

/// @brief The state after an event, by the table; masks follow. `before` is the state of the slot's record.
inline State Advance(Voice& voice, Record& record, const std::size_t slot, const State before,
                     const Event event) noexcept
{
    const State after = After(before, event);
    record.grants.Set(Grant::kState, static_cast<std::uint8_t>(after));
    if (FactsOf(after).shown != FactsOf(before).shown)
    {
        Show(voice, slot, FactsOf(after).shown);
    }
    return after;
}

/// @brief Counts a fault and keeps it if it is the first. [SRS_CONS_020]
void Count(Record& record, SrdoCause cause) noexcept;
/// @brief A fault that the next OnCycle, or the one that goes on, tells.
void Report(Record& record, SrdoCause cause) noexcept;
/// @brief A consumer loses what it held; Event::kDrop or Event::kFault.
void Discard(Voice& voice, std::size_t slot, Event event) noexcept;
/// @brief A fault of a consumer. [SRS_CONS_012]
void Fail(Voice& voice, std::size_t slot, SrdoCause cause) noexcept;
/// @brief What a corrupted record comes to, in every cycle: faulted, holding nothing. [SRS_CONS_024]
void Break(Voice& voice, std::size_t slot) noexcept;
/// @brief Every SRDO with a valid configuration becomes active, as of `now`.
void EnterOperational(Voice& voice) noexcept;
/// @brief None is active any more.
void LeaveOperational(Voice& voice) noexcept;

} // namespace counterpoint::channel_a

#endif
