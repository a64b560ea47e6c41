// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/transitions.hpp"

#include "channel_a/octets.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{
namespace
{

static_assert(static_cast<std::size_t>(Event::kCorrupted) + 1U == kEventCount, "a column for each event");

// Numbers of the cells. Cells that change nothing, by the row they stand in.
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
constexpr std::uint8_t kLaunched = 13U;
constexpr std::uint8_t kNormalAwaited = 14U;
constexpr std::uint8_t kInverseAwaited = 15U;

// Entering and leaving OPERATIONAL.
constexpr std::uint8_t kBeginC = 16U;
constexpr std::uint8_t kBeginP = 17U;
constexpr std::uint8_t kLeaveC = 18U;
constexpr std::uint8_t kLeaveP = 19U;

// Faults of a consumer.
constexpr std::uint8_t kCorrupt = 20U;
constexpr std::uint8_t kEarly = 21U;
constexpr std::uint8_t kTwice = 22U;
constexpr std::uint8_t kUnlike = 23U;
constexpr std::uint8_t kForeign = 24U;
constexpr std::uint8_t kLength = 25U;
constexpr std::uint8_t kSrvt = 26U;
constexpr std::uint8_t kSct = 27U;
constexpr std::uint8_t kGiven = 28U;
constexpr std::uint8_t kDropAll = 29U;
constexpr std::uint8_t kDropHeld = 30U;

// Frames that are as they should be.
constexpr std::uint8_t kTakeW1 = 31U;
constexpr std::uint8_t kTakeWN = 32U;
constexpr std::uint8_t kTakeF1 = 33U;
constexpr std::uint8_t kTakeFN = 34U;
constexpr std::uint8_t kTakeRN = 35U;
constexpr std::uint8_t kPairW = 36U;
constexpr std::uint8_t kPairF = 37U;
constexpr std::uint8_t kPairR = 38U;

// Transmission.
constexpr std::uint8_t kStart = 39U;
constexpr std::uint8_t kOut = 40U;
constexpr std::uint8_t kHalf = 41U;
constexpr std::uint8_t kDone = 42U;
constexpr std::uint8_t kAbortC = 43U;
constexpr std::uint8_t kSilent = 44U;
constexpr std::uint8_t kCorruptP = 45U;
constexpr std::uint8_t kLost = 46U;
constexpr std::uint8_t kVoid = 47U;

} // namespace

constexpr ModeFacts kModeFacts[kRowCount] = {
    // MISRA D-001
    {Mode::kBroken, SrdoState::kFaulted, kGroupFaulted, 0U, kHidden},
    {Mode::kOff, SrdoState::kOff, kGroupOff, 0U, kHidden},
    {Mode::kWaitingEmpty, SrdoState::kWaiting, kGroupWaiting, 0U, kHidden},
    {Mode::kWaitingFirst, SrdoState::kWaiting, kGroupWaiting, 0U, kHidden},
    {Mode::kWaitingHeld, SrdoState::kWaiting, kGroupWaiting, 1U, kShown},
    {Mode::kWaitingNext, SrdoState::kWaiting, kGroupWaiting, 1U, kShown},
    {Mode::kFaultedEmpty, SrdoState::kFaulted, kGroupFaulted, 0U, kHidden},
    {Mode::kFaultedFirst, SrdoState::kFaulted, kGroupFaulted, 0U, kHidden},
    {Mode::kFaultedHeld, SrdoState::kFaulted, kGroupFaulted, 1U, kShown},
    {Mode::kFaultedNext, SrdoState::kFaulted, kGroupFaulted, 1U, kShown},
    {Mode::kReleasedHeld, SrdoState::kReleased, kGroupReleased, 1U, kShown},
    {Mode::kReleasedNext, SrdoState::kReleased, kGroupReleased, 1U, kShown},
    {Mode::kIdle, SrdoState::kProducer, kGroupProducer, 0U, kHidden},
    {Mode::kLaunched, SrdoState::kProducer, kGroupProducer, 0U, kShown},
    {Mode::kNormalAwaited, SrdoState::kProducer, kGroupProducer, 0U, kShown},
    {Mode::kInverseAwaited, SrdoState::kProducer, kGroupProducer, 0U, kShown},
};

constexpr Octets kMapped[kLengthMask + 1U] = {
    // MISRA D-001
    {{0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
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
    {Mode::kLaunched, Effect::kNothing, SrdoCause::kNone},
    {Mode::kNormalAwaited, Effect::kNothing, SrdoCause::kNone},
    {Mode::kInverseAwaited, Effect::kNothing, SrdoCause::kNone},
    {Mode::kWaitingEmpty, Effect::kNothing, SrdoCause::kNone},
    {Mode::kIdle, Effect::kNothing, SrdoCause::kNone},
    {Mode::kOff, Effect::kFault, SrdoCause::kNotOperational},
    {Mode::kOff, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kInvalid},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kInverseFirst},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNormalTwice},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNotInverse},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kIdentifier},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kLength},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kSrvt},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kSct},
    {Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNone},
    {Mode::kFaultedEmpty, Effect::kNothing, SrdoCause::kNone},
    {Mode::kFaultedFirst, Effect::kNothing, SrdoCause::kNone},
    {Mode::kWaitingFirst, Effect::kTake, SrdoCause::kNone},
    {Mode::kWaitingNext, Effect::kTake, SrdoCause::kNone},
    {Mode::kFaultedFirst, Effect::kTake, SrdoCause::kNone},
    {Mode::kFaultedNext, Effect::kTake, SrdoCause::kNone},
    {Mode::kReleasedNext, Effect::kTake, SrdoCause::kNone},
    {Mode::kWaitingHeld, Effect::kComplete, SrdoCause::kNone},
    {Mode::kFaultedHeld, Effect::kComplete, SrdoCause::kNone},
    {Mode::kReleasedHeld, Effect::kComplete, SrdoCause::kNone},
    {Mode::kLaunched, Effect::kLaunch, SrdoCause::kNone},
    {Mode::kNormalAwaited, Effect::kHandOut, SrdoCause::kNone},
    {Mode::kInverseAwaited, Effect::kConfirmNormal, SrdoCause::kNone},
    {Mode::kIdle, Effect::kConfirmInverse, SrdoCause::kNone},
    {Mode::kIdle, Effect::kAbort, SrdoCause::kNone},
    {Mode::kIdle, Effect::kAbort, SrdoCause::kNoConfirmation},
    {Mode::kIdle, Effect::kAbort, SrdoCause::kInvalid},
    {Mode::kOff, Effect::kFault, SrdoCause::kInvalid},
    {Mode::kOff, Effect::kAbort, SrdoCause::kInvalid},
};

// Rows: modes by their low four bits. Columns: events by their number. A corrupted mode is a fault whatever happens,
// only leaving OPERATIONAL is done at once.
constexpr std::uint8_t kTransitions[kRowCount][kEventCount] = {
    // MISRA D-001
    // kBroken
    {kCorrupt, kCorrupt, kLeaveC, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt,
     kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt, kCorrupt},
    // kOff
    {kBeginC, kBeginP, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kOff, kLost},
    // kWaitingEmpty
    {kCorrupt, kCorrupt, kLeaveC, kTakeW1, kEarly, kEarly, kForeign, kLength, kCorrupt, kGiven, kDropAll, kWaitingEmpty,
     kWaitingEmpty, kWaitingEmpty, kWaitingEmpty, kWaitingEmpty, kWaitingEmpty, kCorrupt},
    // kWaitingFirst
    {kCorrupt, kCorrupt, kLeaveC, kTwice, kPairW, kUnlike, kForeign, kLength, kSrvt, kGiven, kDropHeld, kWaitingFirst,
     kWaitingFirst, kWaitingFirst, kWaitingFirst, kWaitingFirst, kWaitingFirst, kCorrupt},
    // kWaitingHeld
    {kCorrupt, kCorrupt, kLeaveC, kTakeWN, kEarly, kEarly, kForeign, kLength, kSct, kGiven, kDropAll, kReleasedHeld,
     kWaitingHeld, kWaitingHeld, kWaitingHeld, kWaitingHeld, kWaitingHeld, kCorrupt},
    // kWaitingNext
    {kCorrupt, kCorrupt, kLeaveC, kTwice, kPairW, kUnlike, kForeign, kLength, kSrvt, kGiven, kDropHeld, kReleasedNext,
     kWaitingNext, kWaitingNext, kWaitingNext, kWaitingNext, kWaitingNext, kCorrupt},
    // kFaultedEmpty
    {kCorrupt, kCorrupt, kLeaveC, kTakeF1, kEarly, kEarly, kForeign, kLength, kCorrupt, kGiven, kDropAll, kFaultedEmpty,
     kFaultedEmpty, kFaultedEmpty, kFaultedEmpty, kFaultedEmpty, kFaultedEmpty, kCorrupt},
    // kFaultedFirst
    {kCorrupt, kCorrupt, kLeaveC, kTwice, kPairF, kUnlike, kForeign, kLength, kSrvt, kGiven, kDropHeld, kFaultedFirst,
     kFaultedFirst, kFaultedFirst, kFaultedFirst, kFaultedFirst, kFaultedFirst, kCorrupt},
    // kFaultedHeld
    {kCorrupt, kCorrupt, kLeaveC, kTakeFN, kEarly, kEarly, kForeign, kLength, kSct, kGiven, kDropAll, kReleasedHeld,
     kFaultedHeld, kFaultedHeld, kFaultedHeld, kFaultedHeld, kFaultedHeld, kCorrupt},
    // kFaultedNext
    {kCorrupt, kCorrupt, kLeaveC, kTwice, kPairF, kUnlike, kForeign, kLength, kSrvt, kGiven, kDropHeld, kReleasedNext,
     kFaultedNext, kFaultedNext, kFaultedNext, kFaultedNext, kFaultedNext, kCorrupt},
    // kReleasedHeld
    {kCorrupt, kCorrupt, kLeaveC, kTakeRN, kEarly, kEarly, kForeign, kLength, kSct, kGiven, kDropAll, kReleasedHeld,
     kReleasedHeld, kReleasedHeld, kReleasedHeld, kReleasedHeld, kReleasedHeld, kCorrupt},
    // kReleasedNext
    {kCorrupt, kCorrupt, kLeaveC, kTwice, kPairR, kUnlike, kForeign, kLength, kSrvt, kGiven, kDropHeld, kReleasedNext,
     kReleasedNext, kReleasedNext, kReleasedNext, kReleasedNext, kReleasedNext, kCorrupt},
    // kIdle
    {kCorruptP, kCorruptP, kLeaveP, kIdle, kIdle, kIdle, kIdle, kIdle, kIdle, kIdle, kIdle, kIdle, kStart, kIdle, kIdle,
     kIdle, kIdle, kVoid},
    // kLaunched
    {kCorruptP, kCorruptP, kLeaveP, kLaunched, kLaunched, kLaunched, kLaunched, kLaunched, kLaunched, kLaunched,
     kLaunched, kLaunched, kLaunched, kOut, kHalf, kAbortC, kSilent, kVoid},
    // kNormalAwaited
    {kCorruptP, kCorruptP, kLeaveP, kNormalAwaited, kNormalAwaited, kNormalAwaited, kNormalAwaited, kNormalAwaited,
     kNormalAwaited, kNormalAwaited, kNormalAwaited, kNormalAwaited, kNormalAwaited, kNormalAwaited, kHalf, kAbortC,
     kSilent, kVoid},
    // kInverseAwaited
    {kCorruptP, kCorruptP, kLeaveP, kInverseAwaited, kInverseAwaited, kInverseAwaited, kInverseAwaited, kInverseAwaited,
     kInverseAwaited, kInverseAwaited, kInverseAwaited, kInverseAwaited, kInverseAwaited, kInverseAwaited, kDone,
     kAbortC, kSilent, kVoid},
};

namespace
{

// An omitted entry is cell 0, whose effect is kInvalid.
// Counted by a variable and not by a function, so that nothing stays unexecuted.
template <std::size_t kEntries>
constexpr std::size_t kDefined =
    kDefined<kEntries - 1U> +
    ((kCells[kTransitions[(kEntries - 1U) / kEventCount][(kEntries - 1U) % kEventCount]].effect != Effect::kInvalid)
         ? 1U
         : 0U);
template <> constexpr std::size_t kDefined<0U> = 0U;
static_assert(kDefined<kRowCount * kEventCount> == (kRowCount * kEventCount), "the table of transitions is total");

} // namespace

} // namespace counterpoint::channel_a
