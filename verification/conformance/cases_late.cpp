// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Late detection: SRVT is looked at by the inverse frame alone, SCT at every frame and in every cycle. Times in
// microseconds; SCT 50 ms, SRVT 20 ms.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step kInside[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(20000U), Inverse(20999U), Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U),
    Cycle(22000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// The call at the limit does not make the frame too old either.
constexpr Step kOn[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(21000U), Masks(0U, 0U, 1U, 0U, 0U), Inverse(21000U),
    Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U), Cycle(22000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// Too late, and then without a normal frame before it: two faults in one call.
constexpr Step kBehind[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(21001U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
    Cycle(22000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kInverseFirst)),
    Normal(23000U), Inverse(43000U), Cycle(44000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// t     1000  21001  50001: waiting past SCT  200000
//       N     cycle  cycle                    I: too late
constexpr Step kNoCycleFindsIt[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(21001U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Cycle(50000U), Signals(0U, 0U), Cycle(50001U),
    Signals(0U, Bit(Cause::kWaitingPastSct)), Cycle(51001U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Inverse(200000U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
};

// The pair is valid for SCT, and its end takes the pending normal frame with it.
// t     1000  2000  3000      40000  51000     51001  51500
//       N     I     released  N      released  SCT    I: without a normal frame
constexpr Step kSctInCycle[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(40000U), Cycle(50999U),
    Masks(1U, 0U, 0U, 0U, 0U), Cycle(51000U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(51001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)), Inverse(51500U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Cycle(52000U), Signals(0U, Bit(Cause::kInverseFirst)),
};

constexpr Step kSctInsideAtInverse[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(45000U), Inverse(50999U),
    Slot(0U, kReleased, kNoCause, 2U, 0U, 1U), Cycle(52000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kSctOnAtInverse[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(45000U), Inverse(51000U),
    Slot(0U, kReleased, kNoCause, 2U, 0U, 1U), Cycle(52000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kSctBehindAtInverse[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(45000U), Inverse(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Cycle(52000U), Masks(0U, 1U, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSct) | Bit(Cause::kInverseFirst)),
};

// Without a pending normal frame an inverse frame finds SCT, too.
constexpr Step kSctAtLoneInverse[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Inverse(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Cycle(52000U), Signals(0U, Bit(Cause::kSct) | Bit(Cause::kInverseFirst)),
};

// Deadlines at the same instant: N at 31000 + SRVT 20000 = 51000 = N at 1000 + SCT 50000.
constexpr Step kTie[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(31000U), Inverse(51001U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(52000U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kInverseFirst)),
};

constexpr Step kTieOnTheLimit[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(31000U), Inverse(51000U),
    Slot(0U, kReleased, kNoCause, 2U, 0U, 1U),
};

// At the same tie a cycle looks at SCT alone.
constexpr Step kTieInCycle[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(31000U), Cycle(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)),
};

// N one microsecond later: SCT is the earlier deadline; with both over it is SCT.
constexpr Step kSctEarlier[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(31001U), Inverse(51002U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Cycle(52000U), Signals(0U, Bit(Cause::kSct) | Bit(Cause::kInverseFirst)),
};

constexpr Step kSctAlone[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(31001U), Inverse(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U),
};

// N one microsecond earlier: SRVT is the earlier deadline.
constexpr Step kSrvtEarlier[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(30999U), Inverse(51001U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(52000U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kInverseFirst)),
};

constexpr Step kSrvtAlone[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(30999U), Inverse(51000U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
};

// A second normal frame is a second normal frame, however old the first is.
constexpr Step kTwiceOld[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(21001U), Normal(22000U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 1U, 0U), Inverse(22500U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 2U, 0U), Cycle(23000U),
    Signals(0U, Bit(Cause::kNormalTwice) | Bit(Cause::kInverseFirst)),
    // What was too old is gone with it.
    Normal(24000U), Inverse(44000U), Slot(0U, kFaulted, Cause::kNormalTwice, 1U, 2U, 1U), Cycle(45000U),
    Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kTwiceWithPair[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(10000U), Normal(45000U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 1U, 0U),
};

// SCT first: the second normal frame is then the only one.
constexpr Step kTwiceAfterSct[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(10000U), Normal(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Inverse(71001U), Slot(0U, kFaulted, Cause::kSct, 1U, 1U, 1U),
    Cycle(72000U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
};

constexpr Step kTwiceOnSct[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(10000U), Normal(51000U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 1U, 0U),
};

// Limits come before controller and length.
constexpr Step kThenLength[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x112U, 3U, 0xCBEDU, 0U, 21001U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(22000U), Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kLength)),
};

constexpr Step kThenController[] = {
    Configure(), Cycle(0U), Normal(1000U), On(Inverse(21001U), CanPortId::kSecond),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(22000U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kIdentifier)),
};

// A normal frame does not examine SRVT, whatever else is wrong with it.
constexpr Step kNormalOfWrongLength[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x111U, 3U, 0x3412U, 0U, 22000U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U), Inverse(22001U), Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U),
};

// Nothing held, calls every two seconds: more than half a round of the counter later the frame is as old as ever.
constexpr Step kHalfARound[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(2000U), Repeat(1100U, 2000000U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Inverse(2200002500U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
};

// A whole round and 9 ms later, by the difference of the instants the frame would be in time.
constexpr Step kWholeRound[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(2000U), Repeat(2147U, 2000000U), Cycle(1500U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Inverse(10000U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
    // The next pair is not too old.
    Cycle(11000U), Normal(12000U), Inverse(32000U), Cycle(33000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// Too old once, a second normal frame, then a pair: only the first one was too old.
constexpr Step kNotForGood[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(30000U), Normal(31000U), Normal(32000U), Inverse(33000U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 1U, 1U, 1U),
};

constexpr Step kNotAfterLeaving[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(30000U), Nmt(NmtState::kPreOperational), Cycle(31000U),
    Nmt(NmtState::kOperational), Cycle(32000U), Inverse(32500U),
    Slot(0U, kFaulted, Cause::kNotOperational, 0U, 2U, 0U), Normal(33000U), Inverse(34000U),
    Slot(0U, kFaulted, Cause::kNotOperational, 1U, 2U, 1U),
};

// A pending normal frame outlives the report of a fault and Demote; what it is too old for stays the same.
constexpr Step kOutlivesReport[] = {
    Configure(), Cycle(0U), Normal(1000U), WrongInverse(0U, 2000U), Normal(3000U), Cycle(4000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U), Cycle(23001U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U), Inverse(23002U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
};

constexpr Step kOutlivesDemote[] = {
    Configure(), Cycle(0U), Normal(1000U), Demote(0U), Inverse(21000U), Slot(0U, kFaulted, Cause::kDemoted, 1U, 1U, 1U),
    Cycle(22000U), Masks(1U, 0U, 0U, 0U, 1U), Normal(23000U), Demote(0U), Inverse(43001U),
    Slot(0U, kFaulted, Cause::kDemoted, 0U, 4U, 0U),
};

// Cycle 10 ms, tolerance 5 ms. A late call has no expired SRVT to go before it, but an expired SCT.
constexpr Step kLateCall[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(10000U), Cycle(20000U), Cycle(35001U),
    Slot(0U, kFaulted, Cause::kLateCall, 0U, 1U, 0U), Signals(0U, Bit(Cause::kLateCall)), Inverse(35500U),
    Slot(0U, kFaulted, Cause::kLateCall, 0U, 2U, 0U),
};

constexpr Step kLateCallAndSct[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(10000U), Cycle(25000U), Normal(30000U),
    Cycle(40000U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(55001U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSct)),
};

// t         1000  21001            22000              23000/24000  26000/27000  75000  76001
// slot 0    N     cycle: SRVT      I: inverse first   pair         pair         N      released
// slot 1    N     -                I: SRVT, inv. first pair        pair         N      SCT
constexpr Step kMixedDetection[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x103U, 4U, 0x44332211U, 0U, 1000U), Cycle(21000U),
    Masks(0U, 0U, 3U, 0U, 0U), Cycle(21001U), Masks(0U, 1U, 2U, 1U, 0U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
    Slot(1U, kWaiting, kNoCause, 0U, 0U, 0U), Inverse(22000U), Frame(0x104U, 4U, 0xBBCCDDEEU, 0U, 22000U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Slot(1U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(22500U),
    Masks(0U, 3U, 0U, 3U, 0U), Normal(26000U), Frame(0x103U, 4U, 0x44332211U, 0U, 26000U), Inverse(27000U),
    Frame(0x104U, 4U, 0xBBCCDDEEU, 0U, 27000U), Cycle(28000U), Masks(3U, 0U, 0U, 0U, 3U), Normal(75000U),
    Frame(0x103U, 4U, 0x44332211U, 0U, 75000U), Cycle(76000U), Masks(3U, 0U, 0U, 0U, 0U), Cycle(76001U),
    Masks(1U, 2U, 0U, 2U, 0U), Slot(1U, kFaulted, Cause::kSrvt, 0U, 3U, 0U), Cycle(95000U),
    Masks(1U, 2U, 0U, 0U, 0U), Cycle(95001U), Masks(0U, 3U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 3U, 0U),
};

// Each pair starts SCT anew from its normal frame.
constexpr Step kFromNormal[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(30000U), Inverse(50000U), Cycle(51001U),
    Masks(1U, 0U, 0U, 0U, 1U), Cycle(80000U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(80001U), Masks(0U, 1U, 0U, 1U, 0U),
};

constexpr Step kNeitherIsEarly[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(21000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(21001U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
};

// A normal frame examines SCT where nothing is pending, too.
// t     1000  2000  3000      51000 (SCT)  51001       52000  53000  54000     102001   103000
//       N     I     released  N            cycle: SCT  N      I      released  N: SCT   I
constexpr Step kSctAtLoneNormal[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(51000U),
    Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), Cycle(51001U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Normal(52000U), Inverse(53000U), Cycle(54000U), Masks(1U, 0U, 0U, 0U, 1U), Normal(102001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Inverse(103000U), Slot(0U, kFaulted, Cause::kSct, 1U, 2U, 1U),
    Cycle(104000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)),
};

// A pair behind a fault has no SCT, neither at a frame nor in the cycle; what is pending behind it stays.
// t     1000       2000  2500  40000  (52000 SCT)  52001  53000
//       I (fault)  N     I     N                   I      cycle: the fault alone
constexpr Step kNoSctBehind[] = {
    Configure(), Cycle(0U), Inverse(1000U), Normal(2000U), Inverse(2500U), Normal(40000U), Inverse(52001U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 2U, 1U, 1U), Cycle(53000U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Signals(0U, Bit(Cause::kInverseFirst)),
    Inverse(54000U), Normal(55000U), Inverse(55500U), Normal(104000U), Cycle(105001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 2U, 0U), Signals(0U, Bit(Cause::kInverseFirst)), Inverse(124000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 1U, 2U, 1U), Cycle(125000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Case kCases[] = {
    MakeCase("LateSrvtInside", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_006}, kGoldLate, kInside),
    MakeCase("LateSrvtOnTheLimit", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_004}, kGoldLate, kOn),
    MakeCase("LateSrvtOneMicrosecondBehind", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_004, req::SRS_CONS_003}, kGoldLate,
             kBehind),
    MakeCase("LateSrvtIsNoAffairOfTheCycle", {req::SRS_TIME_009, req::SRS_CONS_014, req::SRS_CONS_022}, kGoldLate,
             kNoCycleFindsIt),
    MakeCase("LateSctInTheCycleWithAPendingFrame", {req::SRS_TIME_009, req::SRS_CONS_014, req::SRS_CONS_012,
             req::SRS_TIME_005}, kGoldLate, kSctInCycle),
    MakeCase("LateSctInsideAtInverseFrame", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_CONS_003}, kGoldLate, kSctInsideAtInverse),
    MakeCase("LateSctOnTheLimitAtInverseFrame", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_004}, kGoldLate, kSctOnAtInverse),
    MakeCase("LateSctBehindAtInverseFrame", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_CONS_003}, kGoldLate, kSctBehindAtInverse),
    MakeCase("LateSctAtALoneInverseFrame", {req::SRS_TIME_009, req::SRS_CONS_011}, kGoldLate, kSctAtLoneInverse),
    MakeCase("LateTieIsSrvt", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_008}, kGoldLate, kTie),
    MakeCase("LateTieOnTheLimit", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_004}, kGoldLate, kTieOnTheLimit),
    MakeCase("LateTieInTheCycleIsSct", {req::SRS_TIME_009, req::SRS_CONS_014}, kGoldLate, kTieInCycle),
    MakeCase("LateSctIsEarlierOfBoth", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_008}, kGoldLate, kSctEarlier),
    MakeCase("LateSctAlone", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_008}, kGoldLate, kSctAlone),
    MakeCase("LateSrvtIsEarlierOfBoth", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_008}, kGoldLate, kSrvtEarlier),
    MakeCase("LateSrvtAlone", {req::SRS_TIME_009, req::SRS_TIME_340, req::SRS_TIME_008}, kGoldLate, kSrvtAlone),
    MakeCase("LateSecondNormalFrameOfAnOldOne", {req::SRS_TIME_009, req::SRS_CONS_007}, kGoldLate, kTwiceOld),
    MakeCase("LateSecondNormalFrameBesideAPair", {req::SRS_TIME_009, req::SRS_CONS_007}, kGoldLate, kTwiceWithPair),
    MakeCase("LateSecondNormalFrameAfterSct", {req::SRS_TIME_009, req::SRS_CONS_003, req::SRS_CONS_013}, kGoldLate,
             kTwiceAfterSct),
    MakeCase("LateSecondNormalFrameOnSct", {req::SRS_TIME_009, req::SRS_TIME_004}, kGoldLate, kTwiceOnSct),
    MakeCase("LateLimitBeforeLength", {req::SRS_TIME_009, req::SRS_CONS_011, req::SRS_CONS_005}, kGoldLate,
             kThenLength),
    MakeCase("LateLimitBeforeController", {req::SRS_TIME_009, req::SRS_CONS_011, req::SRS_CONS_004}, kGoldLate,
             kThenController),
    MakeCase("LateNormalFrameOfWrongLength", {req::SRS_TIME_009, req::SRS_CONS_005}, kGoldLate, kNormalOfWrongLength),
    MakeCase("LatePendingForHalfARound", {req::SRS_TIME_009, req::SRS_TIME_341, req::SRS_TIME_001}, kGoldLate, kHalfARound),
    MakeCase("LatePendingForAWholeRound", {req::SRS_TIME_009, req::SRS_TIME_341, req::SRS_TIME_001}, kGoldLate, kWholeRound),
    MakeCase("LateOnlyTheOldFrameIsTooOld", {req::SRS_TIME_009, req::SRS_TIME_341, req::SRS_CONS_006}, kGoldLate, kNotForGood),
    MakeCase("LateTooOldIsForgottenOnLeaving", {req::SRS_TIME_009, req::SRS_TIME_341, req::SRS_CONS_019}, kGoldLate, kNotAfterLeaving),
    MakeCase("LatePendingOutlivesTheReport", {req::SRS_TIME_009, req::SRS_CONS_013}, kGoldLate, kOutlivesReport),
    MakeCase("LatePendingOutlivesDemote", {req::SRS_TIME_009, req::SRS_REL_006}, kGoldLate, kOutlivesDemote),
    MakeCase("LateDetectionAndLateCall", {req::SRS_TIME_009, req::SRS_CONS_015}, kGoldLatePrompt, kLateCall),
    MakeCase("LateDetectionSctBeforeLateCall", {req::SRS_TIME_009, req::SRS_CONS_015, req::SRS_CONS_018},
             kGoldLatePrompt, kLateCallAndSct),
    MakeCase("EarlyAndLateInOneDevice", {req::SRS_TIME_007, req::SRS_TIME_009, req::SRS_CONS_014}, kTwoLate,
             kMixedDetection),
    MakeCase("LateSctRunsFromTheNormalFrame", {req::SRS_TIME_009, req::SRS_TIME_005}, kGoldLate, kFromNormal),
    MakeCase("DetectionThatIsNeitherIsEarly", {req::SRS_TIME_007}, kGoldNoLate, kNeitherIsEarly),
    MakeCase("LateSctAtALoneNormalFrame", {req::SRS_TIME_009, req::SRS_CONS_003, req::SRS_TIME_004}, kGoldLate,
             kSctAtLoneNormal),
    MakeCase("LatePairBehindAFaultHasNoSct", {req::SRS_CONS_013, req::SRS_TIME_009, req::SRS_TIME_340}, kGoldLate,
             kNoSctBehind),
};
// clang-format on
} // namespace

const CaseTable kLateCases = MakeTable("late", kCases);

} // namespace counterpoint::conformance
