// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/state.hpp"

namespace counterpoint::channel_a
{
namespace
{

// The names of the table: a standing, then what it has. `kX`: cannot happen, and if it does nothing is granted.
constexpr State kX = State::kBroken;
constexpr State kOff = State::kOff;
constexpr State kW = State::kWaiting;
constexpr State kWp = State::kWaitingPending;
constexpr State kWh = State::kWaitingHeld;
constexpr State kWb = State::kWaitingBoth;
constexpr State kF = State::kFaulted;
constexpr State kFp = State::kFaultedPending;
constexpr State kFh = State::kFaultedHeld;
constexpr State kFb = State::kFaultedBoth;
constexpr State kRh = State::kReleasedHeld;
constexpr State kRb = State::kReleasedBoth;
constexpr State kI = State::kIdle;
constexpr State kNa = State::kNormalAwaited;
constexpr State kIa = State::kInverseAwaited;

} // namespace

constexpr FactsTable kFacts = {{
    // clang-format off
    {SrdoState::kOff,      Role::kNone,     false, false, false},
    {SrdoState::kFaulted,  Role::kNone,     false, false, false},
    {SrdoState::kWaiting,  Role::kConsumer, false, false, false},
    {SrdoState::kWaiting,  Role::kConsumer, true,  false, false},
    {SrdoState::kWaiting,  Role::kConsumer, false, true,  false},
    {SrdoState::kWaiting,  Role::kConsumer, true,  true,  false},
    {SrdoState::kFaulted,  Role::kConsumer, false, false, false},
    {SrdoState::kFaulted,  Role::kConsumer, true,  false, false},
    {SrdoState::kFaulted,  Role::kConsumer, false, true,  false},
    {SrdoState::kFaulted,  Role::kConsumer, true,  true,  false},
    {SrdoState::kReleased, Role::kConsumer, false, true,  false},
    {SrdoState::kReleased, Role::kConsumer, true,  true,  false},
    {SrdoState::kProducer, Role::kProducer, false, false, false},
    {SrdoState::kProducer, Role::kProducer, false, false, true},
    {SrdoState::kProducer, Role::kProducer, false, false, true},
    // clang-format on
}};

constexpr Transitions kTransitions = {{
    // clang-format off
    //            consumer prod. left  broke normal inverse fault drop rel. prepared normal pair given up
    /* off     */ {kW,  kI,  kOff, kX,   kX,  kX,   kX,  kX,  kX,   kX,    kX,  kX,  kX},
    /* broken  */ {kX,  kX,  kX,   kX,   kX,  kX,   kX,  kX,  kX,   kX,    kX,  kX,  kX},
    /* waiting */ {kX,  kX,  kOff, kX,   kWp, kX,   kF,  kF,  kX,   kX,    kX,  kX,  kX},
    /* pending */ {kX,  kX,  kOff, kX,   kX,  kWh,  kF,  kFp, kX,   kX,    kX,  kX,  kX},
    /* held    */ {kX,  kX,  kOff, kX,   kWb, kX,   kF,  kF,  kRh,  kX,    kX,  kX,  kX},
    /* both    */ {kX,  kX,  kOff, kX,   kX,  kWh,  kF,  kFp, kRb,  kX,    kX,  kX,  kX},
    /* faulted */ {kX,  kX,  kOff, kX,   kFp, kX,   kF,  kF,  kX,   kX,    kX,  kX,  kX},
    /* pending */ {kX,  kX,  kOff, kX,   kX,  kFh,  kF,  kFp, kX,   kX,    kX,  kX,  kX},
    /* held    */ {kX,  kX,  kOff, kX,   kFb, kX,   kF,  kF,  kRh,  kX,    kX,  kX,  kX},
    /* both    */ {kX,  kX,  kOff, kX,   kX,  kFh,  kF,  kFp, kRb,  kX,    kX,  kX,  kX},
    /* rel.    */ {kX,  kX,  kOff, kX,   kRb, kX,   kF,  kF,  kRh,  kX,    kX,  kX,  kX},
    /* both    */ {kX,  kX,  kOff, kX,   kX,  kRh,  kF,  kFp, kRb,  kX,    kX,  kX,  kX},
    /* idle    */ {kX,  kX,  kOff, kX,   kX,  kX,   kX,  kX,  kX,   kNa,   kX,  kX,  kX},
    /* normal  */ {kX,  kX,  kOff, kX,   kX,  kX,   kX,  kX,  kX,   kX,    kIa, kX,  kI},
    /* inverse */ {kX,  kX,  kOff, kX,   kX,  kX,   kX,  kX,  kX,   kX,    kX,  kI,  kI},
    // clang-format on
}};
static_assert(Flaws(kTransitions, kFacts) == 0U, "the table is total and grants nothing by itself");

} // namespace counterpoint::channel_a
