// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The acknowledge edge and its window (100 ms). Times in microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
// The level before the first call counts as 1.
constexpr Step kFirstLevel[] = {
    Configure(), Acknowledge(1U), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U),
    Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(0U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U), Acknowledge(1U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 0U),
};

constexpr Step kConstantOne[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(1000U), Normal(1100U), Inverse(1200U), Cycle(2000U),
    Masks(1U, 0U, 0U, 0U, 1U), Inverse(2500U),
    Cycle(3000U), Masks(0U, 1U, 0U, 1U, 0U), Normal(3500U), Inverse(3600U), Cycle(4000U), Masks(0U, 1U, 0U, 0U, 1U),
    Cycle(5000U), Masks(0U, 1U, 0U, 0U, 0U),
    Normal(40000U), Inverse(40100U), Cycle(41000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// A 1-to-0 change is no edge.
constexpr Step kFalling[] = {
    Configure(), Acknowledge(1U), Cycle(0U), Normal(1000U), Inverse(1500U), Acknowledge(0U), Cycle(2000U),
    Masks(0U, 0U, 1U, 0U, 1U),
};

// t     0   10000 (edge)   109000 N   109500 I   110000 (window on its limit)
constexpr Step kWindowOn[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(10000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(60000U), Normal(109000U),
    Inverse(109500U), Cycle(110000U),
    Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
};

constexpr Step kWindowOver[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(10000U), Cycle(60000U), Normal(109000U), Inverse(109500U),
    Cycle(110001U), Masks(0U, 0U, 1U, 0U, 1U),
    Cycle(110002U), Masks(0U, 0U, 1U, 0U, 0U), Acknowledge(0U), Cycle(111000U), Acknowledge(1U), Cycle(112000U),
    Masks(1U, 0U, 0U, 0U, 0U),
};

// A new edge starts the window anew.
// t     0   10000 edge   50000 0   60000 edge   160000 (limit of the second)
constexpr Step kNewEdge[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(10000U), Acknowledge(0U), Cycle(50000U), Acknowledge(1U),
    Cycle(60000U), Normal(159000U), Inverse(159500U),
    Cycle(160000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// A level that falls again leaves the edge waiting.
constexpr Step kPulse[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(1000U), Acknowledge(0U), Cycle(2000U), Normal(3000U), Inverse(3500U),
    Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// An edge in the call that reports a fault is forgotten, though the pair that follows comes within the window.
constexpr Step kWithFault[] = {
    Configure(), Cycle(0U), Inverse(500U), Acknowledge(1U), Cycle(1000U), Masks(0U, 1U, 0U, 1U, 0U), Normal(2000U),
    Inverse(2500U), Cycle(3000U),
    Masks(0U, 1U, 0U, 0U, 1U), Acknowledge(0U), Cycle(4000U), Acknowledge(1U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// A fault after the edge forgets it, too.
constexpr Step kThenFault[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(1000U), Inverse(1500U), Normal(1600U), Cycle(2000U), Inverse(2500U),
    Cycle(3000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// An edge before the slot is active is none; in the call that makes it active it counts.
constexpr Step kBeforeActive[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Acknowledge(1U), Cycle(1000U), Nmt(NmtState::kOperational),
    Cycle(2000U), Normal(2100U),
    Inverse(2200U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 1U),
};

constexpr Step kWithActivation[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Acknowledge(1U), Nmt(NmtState::kOperational), Cycle(1000U),
    Normal(2100U), Inverse(2200U),
    Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// The level is followed while nothing is active: 0 there, 1 at activation is an edge; 1 there is none.
constexpr Step kFollowed[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(1000U), Nmt(NmtState::kStopped), Acknowledge(0U), Cycle(2000U),
    Nmt(NmtState::kOperational), Acknowledge(1U),
    Cycle(3000U), Normal(3100U), Inverse(3200U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// An edge that waited when OPERATIONAL was left does not release afterwards.
constexpr Step kLeft[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(1000U), Nmt(NmtState::kStopped), Cycle(2000U),
    Nmt(NmtState::kOperational), Cycle(3000U), Normal(3100U),
    Inverse(3200U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 1U),
};

// Used up by the release: a fault soon after it needs a new edge.
constexpr Step kUsedUp[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Acknowledge(1U), Cycle(1000U), Masks(1U, 0U, 0U, 0U, 1U),
    Demote(0U), Normal(1100U), Inverse(1200U),
    Cycle(2000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// With the automatic policy the acknowledge only clears the cause, once the slot is released.
constexpr Step kClears[] = {
    Configure(), Cycle(0U), Inverse(100U), Cycle(1000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
    Acknowledge(1U), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Normal(2100U), Inverse(2200U), Cycle(3000U),
    Slot(0U, kReleased, kNoCause, 1U, 1U, 1U),
    // Used up: the next cause stays.
    Inverse(3500U), Cycle(4000U), Normal(4100U), Inverse(4200U), Cycle(5000U),
    Slot(0U, kReleased, Cause::kInverseFirst, 1U, 2U, 1U), Acknowledge(0U),
    Cycle(6000U), Slot(0U, kReleased, Cause::kInverseFirst, 1U, 2U, 1U), Acknowledge(1U), Cycle(7000U),
    Slot(0U, kReleased, kNoCause, 1U, 2U, 1U),
};

// An acknowledge of a released slot without a cause is used up all the same.
constexpr Step kUsedWhileReleased[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Cycle(1000U), Acknowledge(1U), Cycle(2000U),
    Masks(1U, 0U, 0U, 0U, 0U), Inverse(2100U), Cycle(3000U),
    Normal(3100U), Inverse(3200U), Cycle(4000U), Slot(0U, kReleased, Cause::kInverseFirst, 1U, 1U, 1U),
};

constexpr Step kOwnBit[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Frame(0x103U, 4U, 1U, 0U, 300U),
    Frame(0x104U, 4U, 0xFFFFFFFEU, 0U, 400U), Acknowledge(2U),
    Cycle(1000U), Masks(2U, 0U, 1U, 0U, 3U), Acknowledge(3U), Cycle(2000U), Masks(3U, 0U, 0U, 0U, 0U),
};

constexpr Step kOtherBits[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Acknowledge(0xFFFFFFFFFFFFFFFEU), Cycle(1000U),
    Masks(0U, 0U, 1U, 0U, 1U),
};

// Half a round and a whole round of the counter after an edge it is forgotten still.
constexpr Step kRound[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(1000U), Repeat(2147U, 2000000U), Normal(500U), Inverse(600U),
    Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U),
};

constexpr Case kCases[] = {
    MakeCase("LevelBeforeTheFirstCallIsOne", {req::SRS_REL_005}, kGoldLocked, kFirstLevel),
    MakeCase("ConstantOneNeverAcknowledges", {req::SRS_REL_005, req::SRS_REL_004}, kGoldLocked, kConstantOne),
    MakeCase("FallingLevelIsNoEdge", {req::SRS_REL_005}, kGoldLocked, kFalling),
    MakeCase("AcknowledgeWindowOnTheLimit", {req::SRS_REL_005, req::SRS_TIME_004, req::SRS_TIME_001}, kGoldLocked,
             kWindowOn),
    MakeCase("AcknowledgeWindowOver", {req::SRS_REL_005, req::SRS_TIME_004, req::SRS_TIME_001}, kGoldLocked,
             kWindowOver),
    MakeCase("NewEdgeStartsTheWindowAnew", {req::SRS_REL_005}, kGoldLocked, kNewEdge),
    MakeCase("PulseIsAnEdge", {req::SRS_REL_005}, kGoldLocked, kPulse),
    MakeCase("EdgeInTheCallThatReportsAFault", {req::SRS_REL_005}, kGoldLocked, kWithFault),
    MakeCase("FaultForgetsTheEdge", {req::SRS_CONS_012, req::SRS_REL_005}, kGoldLocked, kThenFault),
    MakeCase("EdgeBeforeActive", {req::SRS_REL_005}, kGoldLocked, kBeforeActive),
    MakeCase("EdgeWithActivation", {req::SRS_REL_005}, kGoldLocked, kWithActivation),
    MakeCase("LevelIsFollowedWhileOff", {req::SRS_REL_005}, kGoldLocked, kFollowed),
    MakeCase("LeavingForgetsTheEdge", {req::SRS_CONS_019, req::SRS_REL_008, req::SRS_CONS_012}, kGoldLocked, kLeft),
    MakeCase("EdgeIsUsedUpByTheRelease", {req::SRS_REL_007}, kGoldLocked, kUsedUp),
    MakeCase("AcknowledgeClearsTheCause", {req::SRS_REL_007, req::SRS_CONS_020}, kGold, kClears),
    MakeCase("AcknowledgeWhileReleasedIsUsedUp", {req::SRS_REL_007}, kGold, kUsedWhileReleased),
    MakeCase("EachSlotHasItsAcknowledge", {req::SRS_REL_005}, kTwoLocked, kOwnBit),
    MakeCase("AcknowledgeOfOthersIsNone", {req::SRS_REL_005}, kGoldLocked, kOtherBits),
    MakeCase("EdgeAfterARoundOfTheCounter", {req::SRS_REL_005, req::SRS_TIME_001}, kGoldLocked, kRound),
};
// clang-format on
} // namespace

const CaseTable kAcknowledgeCases = MakeTable("acknowledge", kCases);

} // namespace counterpoint::conformance
