// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/transitions.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{
namespace
{

static_assert(static_cast<std::size_t>(Event::kCorrupted) + 1U == kEventCount, "a row for each event");

// Numbers of the cells. Cells that change nothing, by the column they stand in.
constexpr std::uint8_t kOff = 1U;
constexpr std::uint8_t kWaitingEmpty = 2U;
constexpr std::uint8_t kWaitingFirst = 3U;
constexpr std::uint8_t kWaitingHeld = 4U;
constexpr std::uint8_t kWaitingNext = 5U;
constexpr std::uint8_t kFaultedEmpty = 6U;
constexpr std::uint8_t kFaultedFirst = 7U;
constexpr std::uint8_t kFaultedHeld = 8U;
constexpr std::uint8_t kFaultedNext = 9U;
constexpr std::uint8_t kReleasedHeld = 10U;
constexpr std::uint8_t kReleasedNext = 11U;
constexpr std::uint8_t kIdle = 12U;
constexpr std::uint8_t kNormalAwaited = 13U;
constexpr std::uint8_t kInverseAwaited = 14U;

// Leaving OPERATIONAL.
constexpr std::uint8_t kLeaveC = 15U;
constexpr std::uint8_t kLeaveP = 16U;

// Faults of a consumer.
constexpr std::uint8_t kCorrupt = 17U;
constexpr std::uint8_t kGiven = 18U;
constexpr std::uint8_t kDropAll = 19U;
constexpr std::uint8_t kDropHeld = 20U;

// Transmission.
constexpr std::uint8_t kAbortC = 21U;
constexpr std::uint8_t kLost = 22U;
constexpr std::uint8_t kVoid = 23U;

} // namespace

constexpr ModeFacts kModeFacts[kModeCount] = {
    // MISRA D-001
    {Mode::kBroken, SrdoState::kFaulted, kGroupFaulted, kNoData},
    {Mode::kOff, SrdoState::kOff, kGroupOff, kNoData},
    {Mode::kWaitingEmpty, SrdoState::kWaiting, kGroupWaiting, kNoData},
    {Mode::kWaitingFirst, SrdoState::kWaiting, kGroupWaiting, kFirstFrame},
    {Mode::kWaitingHeld, SrdoState::kWaiting, kGroupWaiting, kHeldPair},
    {Mode::kWaitingNext, SrdoState::kWaiting, kGroupWaiting, kHeldPair | kFirstFrame},
    {Mode::kFaultedEmpty, SrdoState::kFaulted, kGroupFaulted, kNoData},
    {Mode::kFaultedFirst, SrdoState::kFaulted, kGroupFaulted, kFirstFrame},
    {Mode::kFaultedHeld, SrdoState::kFaulted, kGroupFaulted, kHeldPair},
    {Mode::kFaultedNext, SrdoState::kFaulted, kGroupFaulted, kHeldPair | kFirstFrame},
    {Mode::kReleasedHeld, SrdoState::kReleased, kGroupReleased, kHeldPair},
    {Mode::kReleasedNext, SrdoState::kReleased, kGroupReleased, kHeldPair | kFirstFrame},
    {Mode::kIdle, SrdoState::kProducer, kGroupProducer, kNoData},
    {Mode::kBroken, SrdoState::kFaulted, kGroupFaulted, kNoData}, // No mode has this place.
    {Mode::kNormalAwaited, SrdoState::kProducer, kGroupProducer, kInFlight},
    {Mode::kInverseAwaited, SrdoState::kProducer, kGroupProducer, kInFlight},
};

// The cells by their numbers.
constexpr Cell kCells[kCellCount] = {
    // MISRA D-001
    {Mode::kBroken, Effect::kInvalid, SrdoCause::kInvalid},
    {Mode::kOff, Effect::kNothing, SrdoCause::kNone},
    {Mode::kWaitingEmpty, Effect::kNothing, SrdoCause::kNone},
    {Mode::kWaitingFirst, Effect::kNothing, SrdoCause::kNone},
    {Mode::kWaitingHeld, Effect::kNothing, SrdoCause::kNone},
    {Mode::kWaitingNext, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedEmpty, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedFirst, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedHeld, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedNext, Effect::kNothing, SrdoCause::kNone},
    {Mode::kReleasedHeld, Effect::kNothing, SrdoCause::kNone},
    {Mode::kReleasedNext, Effect::kNothing, SrdoCause::kNone},
    {Mode::kIdle, Effect::kNothing, SrdoCause::kNone},
    {Mode::kNormalAwaited, Effect::kNothing, SrdoCause::kNone},
    {Mode::kInverseAwaited, Effect::kNothing, SrdoCause::kNone},
    {Mode::kOff, Effect::kFault, SrdoCause::kNotOperational},
    {Mode::kOff, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kInvalid},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNone},
    {Mode::kFaultedEmpty, Effect::kDropAll, SrdoCause::kNone},
    {Mode::kFaultedFirst, Effect::kDropHeld, SrdoCause::kNone},
    {Mode::kIdle, Effect::kAbort, SrdoCause::kNone},
    {Mode::kOff, Effect::kFault, SrdoCause::kInvalid},
    {Mode::kOff, Effect::kAbort, SrdoCause::kInvalid},
};

// Rows: events by their number. Columns: modes by their low four bits, those of no mode (0 and 13) included. A
// corrupted mode is a fault whatever happens, only leaving OPERATIONAL is done at once.
constexpr std::uint8_t kTransitions[kEventCount][kModeCount] = {
    // MISRA D-001
    // kLeave
    {kLeaveC, kOff, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveC, kLeaveP,
     kLeaveC, kLeaveP, kLeaveP},
    // kError
    {kCorrupt, kOff, kGiven, kGiven, kGiven, kGiven, kGiven, kGiven, kGiven, kGiven, kGiven, kGiven, kIdle, kCorrupt,
     kNormalAwaited, kInverseAwaited},
    // kDiscard
    {kCorrupt, kOff, kDropAll, kDropHeld, kDropAll, kDropHeld, kDropAll, kDropHeld, kDropAll, kDropHeld, kDropAll,
     kDropHeld, kIdle, kCorrupt, kNormalAwaited, kInverseAwaited},
    // kRelease
    {kCorrupt, kOff, kWaitingEmpty, kWaitingFirst, kReleasedHeld, kReleasedNext, kFaultedEmpty, kFaultedFirst,
     kReleasedHeld, kReleasedNext, kReleasedHeld, kReleasedNext, kIdle, kCorrupt, kNormalAwaited, kInverseAwaited},
    // kAbort
    {kCorrupt, kOff, kWaitingEmpty, kWaitingFirst, kWaitingHeld, kWaitingNext, kFaultedEmpty, kFaultedFirst,
     kFaultedHeld, kFaultedNext, kReleasedHeld, kReleasedNext, kIdle, kCorrupt, kAbortC, kAbortC},
    // kCorrupted
    {kCorrupt, kLost, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt,
     kCorrupt, kVoid, kCorrupt, kVoid, kVoid},
};

constexpr Mode kAfterNormal[kModeCount] = {
    // MISRA D-001
    Mode::kBroken,       Mode::kBroken, Mode::kWaitingFirst, Mode::kBroken, Mode::kWaitingNext,  Mode::kBroken,
    Mode::kFaultedFirst, Mode::kBroken, Mode::kFaultedNext,  Mode::kBroken, Mode::kReleasedNext, Mode::kBroken,
    Mode::kBroken,       Mode::kBroken, Mode::kBroken,       Mode::kBroken,
};

constexpr Mode kAfterInverse[kModeCount] = {
    // MISRA D-001
    Mode::kBroken, Mode::kBroken,      Mode::kBroken, Mode::kWaitingHeld, Mode::kBroken, Mode::kWaitingHeld,
    Mode::kBroken, Mode::kFaultedHeld, Mode::kBroken, Mode::kFaultedHeld, Mode::kBroken, Mode::kReleasedHeld,
    Mode::kBroken, Mode::kBroken,      Mode::kBroken, Mode::kBroken,
};

namespace
{

// An omitted entry is cell 0, whose effect is kInvalid.
// Counted by a variable and not by a function, so that nothing stays unexecuted.
template <std::size_t kEntries>
constexpr std::size_t kDefined =
    kDefined<kEntries - 1U> +
    ((kCells[kTransitions[(kEntries - 1U) / kModeCount][(kEntries - 1U) % kModeCount]].effect != Effect::kInvalid)
         ? 1U
         : 0U);
template <> constexpr std::size_t kDefined<0U> = 0U;
static_assert(kDefined<kModeCount * kEventCount> == (kModeCount * kEventCount), "the table of transitions is total");

} // namespace

} // namespace counterpoint::channel_a
