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

// Cells that change nothing, by the row they stand in.
constexpr Cell kOff{Mode::kOff, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kWaitingEmpty{Mode::kWaitingEmpty, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kWaitingFirst{Mode::kWaitingFirst, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kWaitingHeld{Mode::kWaitingHeld, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kWaitingNext{Mode::kWaitingNext, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kFaultedEmpty{Mode::kFaultedEmpty, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kFaultedFirst{Mode::kFaultedFirst, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kFaultedHeld{Mode::kFaultedHeld, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kFaultedNext{Mode::kFaultedNext, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kReleasedHeld{Mode::kReleasedHeld, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kReleasedNext{Mode::kReleasedNext, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kIdle{Mode::kIdle, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kLaunched{Mode::kLaunched, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kNormalAwaited{Mode::kNormalAwaited, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kInverseAwaited{Mode::kInverseAwaited, Effect::kNothing, SrdoCause::kNone};

// Entering and leaving OPERATIONAL.
constexpr Cell kBeginC{Mode::kWaitingEmpty, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kBeginP{Mode::kIdle, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kLeaveC{Mode::kOff, Effect::kFault, SrdoCause::kNotOperational};
constexpr Cell kLeaveP{Mode::kOff, Effect::kNothing, SrdoCause::kNone};

// Faults of a consumer.
constexpr Cell kCorrupt{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kInvalid};
constexpr Cell kEarly{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kInverseFirst};
constexpr Cell kTwice{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNormalTwice};
constexpr Cell kUnlike{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNotInverse};
constexpr Cell kForeign{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kIdentifier};
constexpr Cell kLength{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kLength};
constexpr Cell kSrvt{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kSrvt};
constexpr Cell kSct{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kSct};
constexpr Cell kGiven{Mode::kFaultedEmpty, Effect::kFault, SrdoCause::kNone};
constexpr Cell kDropAll{Mode::kFaultedEmpty, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kDropHeld{Mode::kFaultedFirst, Effect::kNothing, SrdoCause::kNone};

// Frames that are as they should be.
constexpr Cell kTakeW1{Mode::kWaitingFirst, Effect::kTake, SrdoCause::kNone};
constexpr Cell kTakeWN{Mode::kWaitingNext, Effect::kTake, SrdoCause::kNone};
constexpr Cell kTakeF1{Mode::kFaultedFirst, Effect::kTake, SrdoCause::kNone};
constexpr Cell kTakeFN{Mode::kFaultedNext, Effect::kTake, SrdoCause::kNone};
constexpr Cell kTakeRN{Mode::kReleasedNext, Effect::kTake, SrdoCause::kNone};
constexpr Cell kPairW{Mode::kWaitingHeld, Effect::kComplete, SrdoCause::kNone};
constexpr Cell kPairF{Mode::kFaultedHeld, Effect::kComplete, SrdoCause::kNone};
constexpr Cell kPairR{Mode::kReleasedHeld, Effect::kComplete, SrdoCause::kNone};

// Transmission.
constexpr Cell kStart{Mode::kLaunched, Effect::kLaunch, SrdoCause::kNone};
constexpr Cell kOut{Mode::kNormalAwaited, Effect::kHandOut, SrdoCause::kNone};
constexpr Cell kHalf{Mode::kInverseAwaited, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kDone{Mode::kIdle, Effect::kNothing, SrdoCause::kNone};
constexpr Cell kAbortC{Mode::kIdle, Effect::kAbort, SrdoCause::kNone};
constexpr Cell kSilent{Mode::kIdle, Effect::kAbort, SrdoCause::kNoConfirmation};
constexpr Cell kCorruptP{Mode::kIdle, Effect::kAbort, SrdoCause::kInvalid};
constexpr Cell kLost{Mode::kOff, Effect::kFault, SrdoCause::kInvalid};
constexpr Cell kVoid{Mode::kOff, Effect::kAbort, SrdoCause::kInvalid};

} // namespace

constexpr ModeFacts kModeFacts[kRowCount] = {
    // MISRA D-001
    {Mode::kBroken, SrdoState::kFaulted, kGroupFaulted, 0U, kAwaitsNothing, kHidden},
    {Mode::kOff, SrdoState::kOff, kGroupOff, 0U, kAwaitsNothing, kHidden},
    {Mode::kWaitingEmpty, SrdoState::kWaiting, kGroupWaiting, 0U, kAwaitsNothing, kHidden},
    {Mode::kWaitingFirst, SrdoState::kWaiting, kGroupWaiting, 0U, kAwaitsNothing, kHidden},
    {Mode::kWaitingHeld, SrdoState::kWaiting, kGroupWaiting, 1U, kAwaitsNothing, kShown},
    {Mode::kWaitingNext, SrdoState::kWaiting, kGroupWaiting, 1U, kAwaitsNothing, kShown},
    {Mode::kFaultedEmpty, SrdoState::kFaulted, kGroupFaulted, 0U, kAwaitsNothing, kHidden},
    {Mode::kFaultedFirst, SrdoState::kFaulted, kGroupFaulted, 0U, kAwaitsNothing, kHidden},
    {Mode::kFaultedHeld, SrdoState::kFaulted, kGroupFaulted, 1U, kAwaitsNothing, kShown},
    {Mode::kFaultedNext, SrdoState::kFaulted, kGroupFaulted, 1U, kAwaitsNothing, kShown},
    {Mode::kReleasedHeld, SrdoState::kReleased, kGroupReleased, 1U, kAwaitsNothing, kShown},
    {Mode::kReleasedNext, SrdoState::kReleased, kGroupReleased, 1U, kAwaitsNothing, kShown},
    {Mode::kIdle, SrdoState::kProducer, kGroupProducer, 0U, kAwaitsNothing, kHidden},
    {Mode::kLaunched, SrdoState::kProducer, kGroupProducer, 0U, kAwaitsNormal, kShown},
    {Mode::kNormalAwaited, SrdoState::kProducer, kGroupProducer, 0U, kAwaitsNormal, kShown},
    {Mode::kInverseAwaited, SrdoState::kProducer, kGroupProducer, 0U, kAwaitsInverse, kShown},
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

// Rows: modes by their low four bits. Columns: events by their number. A corrupted mode is a fault whatever happens,
// only leaving OPERATIONAL is done at once.
constexpr Cell kTransitions[kRowCount][kEventCount] = {
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

// An omitted cell has effect kInvalid. Counted by a variable and not by a function, so that nothing stays unexecuted.
template <std::size_t kCells>
constexpr std::size_t kDefined =
    kDefined<kCells - 1U> +
    ((kTransitions[(kCells - 1U) / kEventCount][(kCells - 1U) % kEventCount].effect != Effect::kInvalid) ? 1U : 0U);
template <> constexpr std::size_t kDefined<0U> = 0U;
static_assert(kDefined<kRowCount * kEventCount> == (kRowCount * kEventCount), "the table of transitions is total");

} // namespace

} // namespace counterpoint::channel_a
