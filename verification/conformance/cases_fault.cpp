// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What a fault does to a consumer, and the cycle that reports it. Times in microseconds; SCT 50 ms, SRVT 20 ms.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
// t     1000  2000  3000      4000        4500   5000
//       N     I     released  I (fault)   N      cycle: faulted
constexpr Step kDiscards[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U),
    Inverse(4000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
    Cycle(5000U), Masks(0U, 1U, 0U, 1U, 0U), OrdinalSum(0U), Signals(0U, Bit(Cause::kInverseFirst)),
    // Nothing new in the next call, and without a pair nothing is released.
    Cycle(6000U), Masks(0U, 1U, 0U, 0U, 0U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Signals(0U, 0U),
};

// t     1000       2000  2500  3000                   4000   5000
//       I (fault)  N     I     cycle: pair discarded  cycle  N
constexpr Step kReportingCycle[] = {
    Configure(), Cycle(0U), Inverse(1000U), Normal(2000U), Inverse(2500U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 1U, 1U, 1U),
    Cycle(3000U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), OrdinalSum(0U),
    Cycle(4000U), Masks(0U, 1U, 0U, 0U, 0U),
    Normal(5000U), Inverse(5500U), Cycle(6000U), Masks(1U, 0U, 0U, 0U, 1U),
    Slot(0U, kReleased, Cause::kInverseFirst, 1U, 1U, 1U),
};

// A pair completed, then a fault, then another pair: still safe in that cycle.
constexpr Step kFaultBetweenPairs[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Inverse(2000U), Normal(2500U), Inverse(3000U), Cycle(3500U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
};

// A pair behind a fault has no SCT, however long the next call or frame is in coming.
// t     1000       2000  2500  (52000 SCT)  52001
//       I (fault)  N     I                  cycle: the fault alone
constexpr Step kNoSctBehind[] = {
    Configure(), Cycle(0U), Inverse(1000U), Normal(2000U), Inverse(2500U), Cycle(52001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Signals(0U, Bit(Cause::kInverseFirst)),
    Inverse(53000U), Normal(54000U), Inverse(54500U), OtherNormal(104001U), OtherInverse(104500U), Cycle(105000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 2U, 0U), Signals(0U, Bit(Cause::kInverseFirst)),
    // The next pair has one again.
    Normal(106000U), Inverse(106500U), Cycle(107000U), Masks(1U, 0U, 0U, 0U, 1U), Cycle(156000U), Masks(1U, 0U, 0U, 0U, 0U),
    Cycle(156001U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)),
};

// t     1000       2000  3000                      3500  4000
//       I (fault)  N     cycle: N stays pending    I     released
constexpr Step kPendingStays[] = {
    Configure(), Cycle(0U), Inverse(1000U), Normal(2000U), Cycle(3000U), Masks(0U, 1U, 0U, 1U, 0U),
    Inverse(3500U), Slot(0U, kFaulted, Cause::kInverseFirst, 1U, 1U, 1U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// With a lock, and an edge that is complete in the very call that tells of the fault: neither the pair of before nor the
// one behind the fault is released by it, nor is the edge kept.
// t     0  100  800 (1)  900        950  980  1000 (1: edge)  2000 N I  3000        5000 (edge)
//                        I (fault)  N    I    faulted                   faulted     released
constexpr Step kWithEdge[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(800U), Inverse(900U), Normal(950U), Inverse(980U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 1U, 1U, 1U),
    Cycle(1000U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), OrdinalSum(0U),
    Normal(2000U), Inverse(2500U), Cycle(3000U), Masks(0U, 1U, 0U, 0U, 1U), Acknowledge(0U), Cycle(4000U),
    Cycle(4100U), Acknowledge(1U), Cycle(4900U), Masks(0U, 1U, 0U, 0U, 0U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 0U),
};

constexpr Step kReportedOnce[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U), Cycle(3000U),
    Masks(0U, 1U, 0U, 0U, 0U),
    Normal(3500U), Inverse(3600U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 0U),
};

constexpr Step kFirstCause[] = {
    Configure(), Cycle(0U), Inverse(1000U), Normal(1001U), Normal(1002U), Frame(0x111U, 1U, 0U, 0U, 1003U),
    Cycle(2000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 3U, 0U),
    Signals(0U, Bit(Cause::kInverseFirst) | Bit(Cause::kNormalTwice) | Bit(Cause::kLength)),
    // Released again, the cause is still there until acknowledged.
    Normal(3000U), Inverse(3001U), Cycle(4000U), Slot(0U, kReleased, Cause::kInverseFirst, 1U, 3U, 1U),
    Normal(5000U), WrongInverse(3U, 5001U), Cycle(6000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 4U, 0U),
};

constexpr Step kCountStays[] = {
    Configure(), Cycle(0U), Inverse(1000U), Repeat(65532U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 65533U, 0U),
    Inverse(1000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 65534U, 0U),
    Inverse(1000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 65535U, 0U),
    Inverse(1000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 65535U, 0U), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 65535U, 0U),
};

// The faults of one slot are none of the other's.
constexpr Step kOtherSlot[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1001U), Frame(0x103U, 4U, 0xDDCCBBAAU, 0U, 1002U),
    Frame(0x104U, 4U, 0x22334455U, 0U, 1003U), Cycle(2000U), Masks(3U, 0U, 0U, 0U, 3U), OrdinalSum(2U),
    Data(1U, 0xDDCCBBAAU),
    Inverse(3000U), Cycle(4000U), Masks(2U, 1U, 0U, 1U, 0U), Signalled(1U), OrdinalSum(1U),
    Slot(1U, kReleased, kNoCause, 1U, 0U, 1U), Frame(0x104U, 4U, 0x22334455U, 0U, 5000U), Cycle(6000U),
    Masks(0U, 3U, 0U, 2U, 0U), Signalled(2U), Slot(1U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
};

// Interleaved halves of two pairs: each slot pairs its own.
constexpr Step kInterleaved[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x103U, 4U, 0xDDCCBBAAU, 0U, 1001U), Inverse(1002U),
    Frame(0x104U, 4U, 0x22334455U, 0U, 1003U), Cycle(2000U), Masks(3U, 0U, 0U, 0U, 3U), Data(0U, 0x3412U),
    Data(1U, 0xDDCCBBAAU),
};

// SCT expires at a frame: what was held goes, the frame is the first half of the next pair.
// t     1000  2000  3000      51001             52000  53000                54000
//       N     I     released  N (SCT over)      I      cycle: SCT, discard  cycle
constexpr Step kSctAtFrame[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), OtherNormal(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), OtherInverse(52000U), Slot(0U, kFaulted, Cause::kSct, 1U, 1U, 1U),
    Cycle(53000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Normal(53500U), Inverse(53600U), Cycle(54000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// An inverse frame without a normal frame when SCT is over: two faults, SCT first.
constexpr Step kSctThenOrder[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Inverse(51001U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Cycle(52000U),
    Signals(0U, Bit(Cause::kSct) | Bit(Cause::kInverseFirst)),
};

// A wrong frame within SCT is one fault.
constexpr Step kOrderWithinSct[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Inverse(51000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Cycle(52000U), Signals(0U, Bit(Cause::kInverseFirst)),
};

// Where there is no pair there is no data: before the first one, after a fault, while off.
constexpr Step kNoPairNoData[] = {
    Configure(), Data(0U, 0U), Cycle(0U), Data(0U, 0U), Normal(1000U), Data(0U, 0U), Inverse(1500U), Data(0U, 0x3412U),
    OtherNormal(2000U), Data(0U, 0x3412U),
    Cycle(3000U), Data(0U, 0x3412U), Demote(0U), Data(0U, 0U), Slot(0U, kFaulted, Cause::kDemoted, 0U, 1U, 0U),
    OtherInverse(4000U), Data(0U, 0x7856U),
    Nmt(NmtState::kStopped), Cycle(5000U), Data(0U, 0U), Slot(0U, kOff, Cause::kDemoted, 0U, 2U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("NoPairNoData", {req::SRS_CONS_025, req::SRS_CONS_012}, kGold, kNoPairNoData),
    MakeCase("FaultDiscardsHeldPair", {req::SRS_CONS_012, req::SRS_CONS_013}, kGold, kDiscards),
    MakeCase("CycleThatReportsAFaultReleasesNothing", {req::SRS_CONS_013, req::SRS_CONS_020}, kGold, kReportingCycle),
    MakeCase("FaultBetweenTwoPairsOfOneCycle", {req::SRS_CONS_013}, kGold, kFaultBetweenPairs),
    MakeCase("PairBehindAFaultHasNoSct", {req::SRS_CONS_013, req::SRS_CONS_014, req::SRS_CONS_003}, kGold,
             kNoSctBehind),
    MakeCase("PendingFrameSurvivesTheReport", {req::SRS_CONS_013}, kGold, kPendingStays),
    MakeCase("CycleThatReportsAFaultReleasesNothingByAnEdge", {req::SRS_CONS_013, req::SRS_REL_005}, kGoldLocked,
             kWithEdge),
    MakeCase("FaultIsReportedOnce", {req::SRS_CONS_013, req::SRS_CONS_023}, kGold, kReportedOnce),
    MakeCase("FirstCauseIsKept", {req::SRS_CONS_020, req::SRS_CONS_018}, kGold, kFirstCause),
    MakeCase("ErrorCountStaysAt65535", {req::SRS_CONS_020}, kGold, kCountStays),
    MakeCase("FaultOfOneSlotLeavesTheOtherAlone", {req::SRS_CONS_012, req::SRS_CONS_023}, kTwo, kOtherSlot),
    MakeCase("InterleavedPairs", {req::SRS_CONS_001, req::SRS_CONS_010}, kTwo, kInterleaved),
    MakeCase("SctOverAtANormalFrame", {req::SRS_CONS_003, req::SRS_CONS_012}, kGold, kSctAtFrame),
    MakeCase("SctOverAtAnInverseFrame", {req::SRS_CONS_003, req::SRS_CONS_011}, kGold, kSctThenOrder),
    MakeCase("InverseFrameWithinSct", {req::SRS_CONS_003, req::SRS_TIME_004}, kGold, kOrderWithinSct),
};
// clang-format on
} // namespace

const CaseTable kFaultCases = MakeTable("fault", kCases);

} // namespace counterpoint::conformance
