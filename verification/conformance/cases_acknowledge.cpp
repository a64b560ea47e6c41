// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The acknowledge: its level is what two consecutive calls read, its edge waits for a window of 100 ms. Times in
// microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
// Level and bit before the first call count as 1. What is read twice is the level.
constexpr Step kFirstLevel[] = {
    Configure(), Acknowledge(1U), Cycle(0U), Cycle(100U), Normal(1000U), Inverse(1500U), Cycle(2000U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(0U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(4100U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(1U), Cycle(4900U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// A 0 in the first call alone lowers nothing.
constexpr Step kFirstBit[] = {
    Configure(), Cycle(0U), Acknowledge(1U), Cycle(100U), Cycle(200U), Cycle(300U), Normal(1000U), Inverse(1500U),
    Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U),
};

// Neither the level nor the bit of the time before outlives a power-on.
constexpr Step kRestarted[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(200U), Restart(), Configure(), Acknowledge(1U),
    Cycle(300U), Cycle(400U), Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U), Cycle(3000U),
    Masks(0U, 0U, 1U, 0U, 0U),
};

constexpr Step kConstantOne[] = {
    Configure(), Cycle(0U), Cycle(500U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Normal(1100U), Inverse(1200U),
    Cycle(2000U), Masks(1U, 0U, 0U, 0U, 1U), Inverse(2500U),
    Cycle(3000U), Masks(0U, 1U, 0U, 1U, 0U), Normal(3500U), Inverse(3600U), Cycle(4000U), Masks(0U, 1U, 0U, 0U, 1U),
    Cycle(5000U), Masks(0U, 1U, 0U, 0U, 0U),
    Normal(40000U), Inverse(40100U), Cycle(41000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// A 1-to-0 change is no edge.
constexpr Step kFalling[] = {
    Configure(), Acknowledge(1U), Cycle(0U), Cycle(500U), Normal(1000U), Inverse(1500U), Acknowledge(0U), Cycle(2000U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(2100U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(2200U), Masks(0U, 0U, 1U, 0U, 0U),
};

// A 1 that lasted one call only, again and again; then one that lasts two.
// bit   0  0  1  0  1  0  0  1  1
constexpr Step kGlitchOfOne[] = {
    Configure(), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U),
    Acknowledge(1U), Cycle(1000U), Masks(0U, 0U, 1U, 0U, 1U), Acknowledge(0U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(1U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U), Acknowledge(0U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U),
    Cycle(5000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(1U), Cycle(6000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(7000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// A 0 that lasted one call only leaves the level at 1: what follows is no edge.
// bit   1  1  0  1  0  1  1  0  0  1  1
constexpr Step kGlitchOfZero[] = {
    Configure(), Acknowledge(1U), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U),
    Acknowledge(0U), Cycle(1000U), Masks(0U, 0U, 1U, 0U, 1U), Acknowledge(1U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(0U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U), Acknowledge(1U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U),
    Cycle(5000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(0U), Cycle(6000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(7000U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(1U), Cycle(8000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(9000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// Two readings that are not consecutive are none, even where the level was 0 all the time.
// bit   0  0  1  0  1  1: the edge is that of the last two, and its window starts there
constexpr Step kGlitchBefore[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(8000U), Acknowledge(0U), Cycle(9000U), Acknowledge(1U),
    Cycle(10000U), Cycle(20000U), Normal(119000U), Inverse(119500U), Cycle(120000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// t     0   100   9000   10000 (edge: the second call)   109000 N   109500 I   110000 (window on its limit)
constexpr Step kWindowOn[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(9000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(10000U),
    Masks(0U, 0U, 1U, 0U, 0U), Cycle(60000U), Normal(109000U), Inverse(109500U), Cycle(110000U),
    Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
};

constexpr Step kWindowOver[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(9000U), Cycle(10000U), Cycle(60000U), Normal(109000U),
    Inverse(109500U), Cycle(110001U), Masks(0U, 0U, 1U, 0U, 1U),
    Cycle(110002U), Masks(0U, 0U, 1U, 0U, 0U), Acknowledge(0U), Cycle(111000U), Cycle(111100U), Acknowledge(1U),
    Cycle(111900U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(112000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// A new edge starts the window anew.
// t     0   10000 edge   50000 0   60000 edge   160000 (limit of the second)
constexpr Step kNewEdge[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(9000U), Cycle(10000U), Acknowledge(0U), Cycle(49000U),
    Cycle(50000U), Acknowledge(1U), Cycle(59000U), Cycle(60000U), Normal(159000U), Inverse(159500U),
    Cycle(160000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// A glitch within the ones does not.
// t     0   10000 edge   50000 0   59000 1   60000 1   110001 (behind the window of the edge)
constexpr Step kGlitchInTheWindow[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(9000U), Cycle(10000U), Acknowledge(0U), Cycle(50000U),
    Acknowledge(1U), Cycle(59000U), Cycle(60000U), Normal(109000U), Inverse(109500U), Cycle(110001U),
    Masks(0U, 0U, 1U, 0U, 1U),
};

// Nor does it end it.
constexpr Step kGlitchKeepsTheWindow[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(9000U), Cycle(10000U), Acknowledge(0U), Cycle(50000U),
    Acknowledge(1U), Cycle(59000U), Normal(109000U), Inverse(109500U), Cycle(110000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// A level that falls again leaves the edge waiting.
constexpr Step kPulse[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Acknowledge(0U), Cycle(2000U),
    Cycle(2100U), Normal(3000U), Inverse(3500U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// An edge in the call that reports a fault is forgotten, though the pair that follows comes within the window.
constexpr Step kWithFault[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(800U), Inverse(900U), Cycle(1000U),
    Masks(0U, 1U, 0U, 1U, 0U), Normal(2000U), Inverse(2500U), Cycle(3000U),
    Masks(0U, 1U, 0U, 0U, 1U), Acknowledge(0U), Cycle(4000U), Cycle(4100U), Acknowledge(1U), Cycle(4900U),
    Masks(0U, 1U, 0U, 0U, 0U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// The fault was told in the first of the two calls: the edge comes behind it.
constexpr Step kBehindFault[] = {
    Configure(), Cycle(0U), Cycle(100U), Inverse(500U), Acknowledge(1U), Cycle(800U), Masks(0U, 1U, 0U, 1U, 0U),
    Normal(900U), Inverse(950U), Cycle(1000U), Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 1U, 1U),
};

// A fault after the edge forgets it, too.
constexpr Step kThenFault[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Inverse(1500U), Normal(1600U),
    Cycle(2000U), Inverse(2500U), Cycle(3000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// An edge before the slot is active is none; in the call that makes it active it counts.
constexpr Step kBeforeActive[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U),
    Nmt(NmtState::kOperational), Cycle(2000U), Normal(2100U),
    Inverse(2200U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 1U),
};

constexpr Step kWithActivation[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U),
    Nmt(NmtState::kOperational), Cycle(1000U), Normal(2100U), Inverse(2200U),
    Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// The level is followed while nothing is active: 0 there, 1 at activation is an edge; 1 there is none.
constexpr Step kFollowed[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Nmt(NmtState::kStopped),
    Acknowledge(0U), Cycle(2000U), Cycle(2100U), Acknowledge(1U), Cycle(2900U), Nmt(NmtState::kOperational),
    Cycle(3000U), Normal(3100U), Inverse(3200U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// An edge that waited when OPERATIONAL was left does not release afterwards.
constexpr Step kLeft[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Nmt(NmtState::kStopped),
    Cycle(2000U), Nmt(NmtState::kOperational), Cycle(3000U), Normal(3100U),
    Inverse(3200U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 1U),
};

// Used up by the release: a fault soon after it needs a new edge.
constexpr Step kUsedUp[] = {
    Configure(), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U), Acknowledge(1U), Cycle(900U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(1000U), Masks(1U, 0U, 0U, 0U, 0U),
    Demote(0U), Normal(1100U), Inverse(1200U),
    Cycle(2000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// With the automatic policy the acknowledge only clears the cause, once the slot is released.
constexpr Step kClears[] = {
    Configure(), Cycle(0U), Inverse(100U), Cycle(1000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
    Acknowledge(1U), Cycle(1900U), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Normal(2100U), Inverse(2200U), Cycle(3000U),
    Slot(0U, kReleased, kNoCause, 1U, 1U, 1U),
    // Used up: the next cause stays.
    Inverse(3500U), Cycle(4000U), Normal(4100U), Inverse(4200U), Cycle(5000U),
    Slot(0U, kReleased, Cause::kInverseFirst, 1U, 2U, 1U), Acknowledge(0U),
    Cycle(6000U), Cycle(6100U), Slot(0U, kReleased, Cause::kInverseFirst, 1U, 2U, 1U), Acknowledge(1U), Cycle(6900U),
    Slot(0U, kReleased, Cause::kInverseFirst, 1U, 2U, 1U), Cycle(7000U), Slot(0U, kReleased, kNoCause, 1U, 2U, 1U),
};

// An acknowledge of a released slot without a cause is used up all the same.
constexpr Step kUsedWhileReleased[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Cycle(1000U), Acknowledge(1U), Cycle(1900U), Cycle(2000U),
    Masks(1U, 0U, 0U, 0U, 0U), Inverse(2100U), Cycle(3000U),
    Normal(3100U), Inverse(3200U), Cycle(4000U), Slot(0U, kReleased, Cause::kInverseFirst, 1U, 1U, 1U),
};

constexpr Step kOwnBit[] = {
    Configure(), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U), Frame(0x103U, 4U, 1U, 0U, 300U),
    Frame(0x104U, 4U, 0xFFFFFFFEU, 0U, 400U), Acknowledge(2U), Cycle(900U), Masks(0U, 0U, 3U, 0U, 3U),
    Cycle(1000U), Masks(2U, 0U, 1U, 0U, 0U), Acknowledge(3U), Cycle(1900U), Masks(2U, 0U, 1U, 0U, 0U), Cycle(2000U),
    Masks(3U, 0U, 0U, 0U, 0U),
};

// One reading of each of two slots: no two of either.
constexpr Step kInTurn[] = {
    Configure(), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U), Frame(0x103U, 4U, 1U, 0U, 300U),
    Frame(0x104U, 4U, 0xFFFFFFFEU, 0U, 400U), Acknowledge(1U), Cycle(1000U), Masks(0U, 0U, 3U, 0U, 3U),
    Acknowledge(2U), Cycle(2000U), Masks(0U, 0U, 3U, 0U, 0U), Acknowledge(1U), Cycle(3000U), Masks(0U, 0U, 3U, 0U, 0U),
    Acknowledge(3U), Cycle(4000U), Masks(1U, 0U, 2U, 0U, 0U), Acknowledge(2U), Cycle(5000U), Masks(3U, 0U, 0U, 0U, 0U),
};

constexpr Step kOtherBits[] = {
    Configure(), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U), Acknowledge(0xFFFFFFFFFFFFFFFEU), Cycle(1000U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(1100U), Masks(0U, 0U, 1U, 0U, 0U),
};

// Half a round and a whole round of the counter after an edge it is forgotten still.
constexpr Step kRound[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Repeat(2147U, 2000000U),
    Normal(500U), Inverse(600U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U),
};

// The fault of one slot takes no edge of the other.
constexpr Step kFaultOfAnother[] = {
    Configure(), Cycle(0U), Cycle(50U), Normal(100U), Inverse(200U), Frame(0x103U, 4U, 1U, 0U, 300U),
    Frame(0x104U, 4U, 0xFFFFFFFEU, 0U, 400U), Acknowledge(3U), Cycle(900U), Masks(0U, 0U, 3U, 0U, 3U), Inverse(950U),
    Cycle(1000U), Masks(2U, 1U, 0U, 1U, 0U), Normal(1100U), Inverse(1200U), Cycle(2000U), Masks(2U, 1U, 0U, 0U, 1U),
};

// The edge is complete in the call that leaves OPERATIONAL: the slot is not active in it.
constexpr Step kWithLeaving[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Nmt(NmtState::kStopped), Cycle(1000U),
    Nmt(NmtState::kOperational), Cycle(2000U), Normal(2100U), Inverse(2200U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 1U),
};

constexpr Case kCases[] = {
    MakeCase("LevelBeforeTheFirstCallIsOne", {req::SRS_REL_005}, kGoldLocked, kFirstLevel),
    MakeCase("BitBeforeTheFirstCallIsOne", {req::SRS_REL_005}, kGoldLocked, kFirstBit),
    MakeCase("PowerOnForgetsLevelAndBit", {req::SRS_REL_005, req::SRS_REL_008}, kGoldLocked, kRestarted),
    MakeCase("ConstantOneNeverAcknowledges", {req::SRS_REL_005, req::SRS_REL_004}, kGoldLocked, kConstantOne),
    MakeCase("FallingLevelIsNoEdge", {req::SRS_REL_005}, kGoldLocked, kFalling),
    MakeCase("GlitchOfOneIsNoEdge", {req::SRS_REL_005, req::SRS_REL_004}, kGoldLocked, kGlitchOfOne),
    MakeCase("GlitchOfZeroIsNoEdge", {req::SRS_REL_005, req::SRS_REL_004}, kGoldLocked, kGlitchOfZero),
    MakeCase("GlitchBeforeTheEdgeStartsNoWindow", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_TIME_004}, kGoldLocked, kGlitchBefore),
    MakeCase("AcknowledgeWindowOnTheLimit", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_TIME_004, req::SRS_TIME_001}, kGoldLocked,
             kWindowOn),
    MakeCase("AcknowledgeWindowOver", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_TIME_004, req::SRS_TIME_001}, kGoldLocked,
             kWindowOver),
    MakeCase("NewEdgeStartsTheWindowAnew", {req::SRS_REL_005, req::SRS_REL_341}, kGoldLocked, kNewEdge),
    MakeCase("GlitchOfZeroStartsNoWindow", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_TIME_004}, kGoldLocked, kGlitchInTheWindow),
    MakeCase("GlitchOfZeroEndsNoWindow", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_TIME_004}, kGoldLocked, kGlitchKeepsTheWindow),
    MakeCase("PulseIsAnEdge", {req::SRS_REL_005, req::SRS_REL_341}, kGoldLocked, kPulse),
    MakeCase("EdgeInTheCallThatReportsAFault", {req::SRS_REL_005, req::SRS_REL_341}, kGoldLocked, kWithFault),
    MakeCase("FaultInTheFirstOfTheTwoCalls", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_REL_007}, kGoldLocked, kBehindFault),
    MakeCase("FaultForgetsTheEdge", {req::SRS_CONS_012, req::SRS_REL_005}, kGoldLocked, kThenFault),
    MakeCase("EdgeBeforeActive", {req::SRS_REL_005, req::SRS_REL_341}, kGoldLocked, kBeforeActive),
    MakeCase("EdgeWithActivation", {req::SRS_REL_005, req::SRS_REL_341}, kGoldLocked, kWithActivation),
    MakeCase("LevelIsFollowedWhileOff", {req::SRS_REL_005}, kGoldLocked, kFollowed),
    MakeCase("LeavingForgetsTheEdge", {req::SRS_CONS_019, req::SRS_REL_008, req::SRS_CONS_012}, kGoldLocked, kLeft),
    MakeCase("EdgeIsUsedUpByTheRelease", {req::SRS_REL_007}, kGoldLocked, kUsedUp),
    MakeCase("AcknowledgeClearsTheCause", {req::SRS_REL_007, req::SRS_CONS_020}, kGold, kClears),
    MakeCase("AcknowledgeWhileReleasedIsUsedUp", {req::SRS_REL_007}, kGold, kUsedWhileReleased),
    MakeCase("EachSlotHasItsAcknowledge", {req::SRS_REL_005}, kTwoLocked, kOwnBit),
    MakeCase("ReadingsOfTwoSlotsDoNotAddUp", {req::SRS_REL_005}, kTwoLocked, kInTurn),
    MakeCase("AcknowledgeOfOthersIsNone", {req::SRS_REL_005}, kGoldLocked, kOtherBits),
    MakeCase("EdgeAfterARoundOfTheCounter", {req::SRS_REL_005, req::SRS_REL_341, req::SRS_TIME_001}, kGoldLocked, kRound),
    MakeCase("FaultOfAnotherSlotLeavesTheEdge", {req::SRS_REL_341}, kTwoLocked, kFaultOfAnother),
    MakeCase("EdgeInTheCallThatLeavesOperational", {req::SRS_REL_341, req::SRS_CONS_019}, kGoldLocked, kWithLeaving),
};
// clang-format on
} // namespace

const CaseTable kAcknowledgeCases = MakeTable("acknowledge", kCases);

} // namespace counterpoint::conformance
