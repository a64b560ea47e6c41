// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// SCT and SRVT: just inside, on, just outside, by frames and by cycles. Times in microseconds; SCT 50 ms, SRVT 20 ms.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
// t     1000  2000   51000 (SCT)   71000 (SRVT)
//       N     I      N             I
constexpr Step kSctOnAtFrame[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(51000U),
    Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
    Inverse(71000U), Slot(0U, kReleased, kNoCause, 2U, 0U, 1U), Cycle(72000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kSctInsideAtFrame[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(50999U), Inverse(70998U),
    Slot(0U, kReleased, kNoCause, 2U, 0U, 1U), Cycle(72000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kSctOverAtFrame[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Cycle(52000U), Masks(0U, 1U, 0U, 1U, 0U),
};

constexpr Step kSrvtInside[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(20999U), Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U),
};

constexpr Step kSrvtOn[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(21000U), Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U), Cycle(22000U),
    Masks(1U, 0U, 0U, 0U, 1U),
};

// The inverse frame that comes too late is also one without a normal frame: two faults.
constexpr Step kSrvtOver[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(21001U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(22000U),
    Masks(0U, 1U, 0U, 1U, 0U),
};

// t     1000  2000  3000   50999   51000   51001
//       N     I     cycle  cycle   cycle   cycle: SCT
constexpr Step kSctInCycle[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Cycle(50999U), Masks(1U, 0U, 0U, 0U, 0U),
    Cycle(51000U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(51001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)),
    // A pair that is no longer held does not expire again.
    Cycle(60000U), Masks(0U, 1U, 0U, 0U, 0U), Cycle(200000U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
};

// t     1000  20999   21000   21001
//       N     cycle   cycle   cycle: SRVT
constexpr Step kSrvtInCycle[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(20999U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(21000U),
    Masks(0U, 0U, 1U, 0U, 0U),
    Cycle(21001U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSrvt)),
    Cycle(50000U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
};

// SCT on its limit, then SRVT on its limit: the pair is valid for SCT + SRVT after its normal frame.
// t     1000  2000  3000      51000  51001      71000     71001
//       N     I     released  N      released   released  SRVT
constexpr Step kEarly[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(51000U), Cycle(51001U),
    Masks(1U, 0U, 0U, 0U, 0U),
    Cycle(71000U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(71001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
};

// Both are over when the cycle looks: the pending frame answered SCT, so it is SRVT.
constexpr Step kBothOver[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(40000U), Cycle(200000U),
    Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSrvt)),
};

// Deadlines at the same instant: N at 31000 + SRVT 20000 = 51000 = N at 1000 + SCT 50000.
constexpr Step kTie[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(31000U), Cycle(51000U),
    Masks(1U, 0U, 0U, 0U, 0U),
    Cycle(51001U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSrvt)),
};

// SCT at the frame by its stamp, SRVT later because the inverse frame stays away.
// t     1000  2000  51001    55000       71001   71002
//       N     I     N: SCT   cycle: SCT  cycle   cycle: SRVT
constexpr Step kSctThenSrvt[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(51001U), Cycle(55000U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)), Cycle(71001U),
    Masks(0U, 1U, 0U, 0U, 0U),
    Cycle(71002U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U),
    Signals(0U, Bit(Cause::kSrvt)),
};

// Both seen by one call: the SCT fault of the frame first, then SRVT.
constexpr Step kSctThenSrvtInOne[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(51001U), Cycle(80000U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Signals(0U, Bit(Cause::kSct) | Bit(Cause::kSrvt)),
};

// SCT runs from the normal frame of the pair, not from its inverse frame.
// t     1000 2000  41000  60000    91000   91001
//       N    I     N      I        cycle   cycle: SCT
constexpr Step kFromNormal[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(41000U), Inverse(60000U), Cycle(61000U),
    Slot(0U, kReleased, kNoCause, 2U, 0U, 1U), Cycle(91000U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(91001U),
    Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
};

// A normal frame alone does not restart SCT: its SRVT runs out though SCT would still hold.
constexpr Step kHalfPair[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(10000U), Cycle(30000U),
    Masks(1U, 0U, 0U, 0U, 0U),
    Cycle(30001U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
};

// A pair within its limits seen late by the kernel: its stamps count, then SCT runs on to `now`.
// t     1000  2000        51000
//       N     I           first cycle that sees them
constexpr Step kSeenLate[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(51000U), Masks(1U, 0U, 0U, 0U, 1U), Cycle(51001U),
    Masks(0U, 1U, 0U, 1U, 0U),
};

constexpr Step kSeenTooLate[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(51001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
};

// The longest limits: SCT 65535 ms, SRVT 255 ms.
constexpr Step kLongest[] = {
    Configure(), Cycle(0U), Frame(0x105U, 8U, 0U, 0U, 1000U), Frame(0x106U, 8U, 0xFFFFFFFFU, 0xFFFFFFFFU, 256000U),
    Cycle(257000U),
    Repeat(32U, 2000000U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), Cycle(65536000U), Masks(1U, 0U, 0U, 0U, 0U),
    Cycle(65536001U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Frame(0x105U, 8U, 0U, 0U, 65537000U),
    Cycle(65792000U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Cycle(65792001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U),
};

// The shortest limits: SCT 2 ms, SRVT 1 ms.
constexpr Step kShortestLimits[] = {
    Configure(), Cycle(0U), Frame(0x109U, 1U, 0x0FU, 0U, 100U), Frame(0x10AU, 1U, 0xF0U, 0U, 1100U), Cycle(1200U),
    Masks(1U, 0U, 0U, 0U, 1U),
    Cycle(2100U), Masks(1U, 0U, 0U, 0U, 0U), Cycle(2101U), Masks(0U, 1U, 0U, 1U, 0U),
    Frame(0x109U, 1U, 0x0FU, 0U, 3000U),
    Frame(0x10AU, 1U, 0xF0U, 0U, 4001U), Cycle(4002U), Slot(0U, kFaulted, Cause::kSct, 0U, 3U, 0U),
};

// Both are over at a frame: the pending frame answered SCT (over at 51000), so it is SRVT (over at 60000).
constexpr Step kBothOverAtInverse[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(40000U), Inverse(60001U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(61000U), Masks(0U, 1U, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kInverseFirst)),
};

constexpr Step kBothOverAtNormal[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(40000U), OtherNormal(60001U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U), OtherInverse(61000U), Slot(0U, kFaulted, Cause::kSrvt, 1U, 1U, 1U),
    Cycle(62000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSrvt)),
};

// The counter wraps between the halves (at 30000, with the second origin).
constexpr Step kSrvtAcrossTheWrap[] = {
    Configure(), Cycle(0U), Normal(15000U), Inverse(35000U), Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U), Cycle(36000U),
    Masks(1U, 0U, 0U, 0U, 1U),
    Restart(), Configure(), Cycle(0U), Normal(15000U), Inverse(35001U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("SctInsideAtNormalFrame", {req::SRS_TIME_003, req::SRS_TIME_005}, kGold, kSctInsideAtFrame),
    MakeCase("SctOnTheLimitAtNormalFrame", {req::SRS_TIME_004, req::SRS_TIME_005, req::SRS_CONS_003, req::SRS_TIME_001},
             kGold, kSctOnAtFrame),
    MakeCase("SctOneMicrosecondOverAtNormalFrame", {req::SRS_TIME_004, req::SRS_TIME_005, req::SRS_CONS_003,
             req::SRS_TIME_001}, kGold, kSctOverAtFrame),
    MakeCase("SrvtInside", {req::SRS_TIME_006}, kGold, kSrvtInside),
    MakeCase("SrvtOnTheLimit", {req::SRS_TIME_004, req::SRS_TIME_006, req::SRS_CONS_003}, kGold, kSrvtOn),
    MakeCase("SrvtOneMicrosecondOver", {req::SRS_TIME_004, req::SRS_TIME_006, req::SRS_CONS_003}, kGold, kSrvtOver),
    MakeCase("SctInTheCycle", {req::SRS_CONS_014, req::SRS_TIME_004, req::SRS_TIME_001}, kGold, kSctInCycle),
    MakeCase("SrvtInTheCycle", {req::SRS_CONS_014, req::SRS_TIME_004, req::SRS_TIME_001}, kGold, kSrvtInCycle),
    MakeCase("PairIsValidForSctPlusSrvt", {req::SRS_TIME_007, req::SRS_CONS_014}, kGold, kEarly),
    MakeCase("BothLimitsOverInOneCall", {req::SRS_TIME_008, req::SRS_TIME_007}, kGold, kBothOver),
    MakeCase("TieOfBothLimits", {req::SRS_TIME_008, req::SRS_TIME_004}, kGold, kTie),
    MakeCase("SctAtTheFrameThenSrvt", {req::SRS_TIME_008, req::SRS_TIME_003}, kGold, kSctThenSrvt),
    MakeCase("SctAtTheFrameThenSrvtInOneCall", {req::SRS_TIME_008, req::SRS_CONS_018}, kGold, kSctThenSrvtInOne),
    MakeCase("SctRunsFromTheNormalFrame", {req::SRS_TIME_005, req::SRS_CONS_010}, kGold, kFromNormal),
    MakeCase("HalfAPairDoesNotRestartSct", {req::SRS_TIME_005, req::SRS_TIME_007}, kGold, kHalfPair),
    MakeCase("PairSeenLateIsJudgedByItsStamps", {req::SRS_TIME_003, req::SRS_TIME_002}, kGold, kSeenLate),
    MakeCase("PairSeenTooLateIsOver", {req::SRS_TIME_003, req::SRS_CONS_014}, kGold, kSeenTooLate),
    MakeCase("LongestLimits", {req::SRS_TIME_004, req::SRS_TIME_001}, kLong, kLongest),
    MakeCase("ShortestLimits", {req::SRS_TIME_004, req::SRS_TIME_006}, kShortest, kShortestLimits),
    MakeCase("BothLimitsOverAtAnInverseFrame", {req::SRS_TIME_008, req::SRS_TIME_007, req::SRS_CONS_003}, kGold,
             kBothOverAtInverse),
    MakeCase("BothLimitsOverAtANormalFrame", {req::SRS_TIME_008, req::SRS_TIME_007, req::SRS_CONS_012}, kGold,
             kBothOverAtNormal),
    MakeCase("SrvtAcrossTheWrapOfTheCounter", {req::SRS_TIME_001, req::SRS_TIME_004, req::SRS_TIME_006}, kGold,
             kSrvtAcrossTheWrap),
};
// clang-format on
} // namespace

const CaseTable kTimeCases = MakeTable("time", kCases);

} // namespace counterpoint::conformance
