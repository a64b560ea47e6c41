// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Defects of other implementations, each as a case; the number is that of the list of known findings. Times in
// microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr ConfigFault kBadMap = ConfigFault::kMapping;

constexpr Step kP1 = Put(0x6210U, 1U, 0x12U);
constexpr Step kP2 = Put(0x6210U, 2U, 0x34U);
constexpr Step kI1 = Put(0x6211U, 1U, 0xEDU);
constexpr Step kI2 = Put(0x6211U, 2U, 0xCBU);

constexpr Step kT2[] = {
    StoreAll(), Srvt(0U, 60U), Signature(0U, 0x3849U), Validate(0U, ConfigFault::kTiming, 0x3849U),
};

// N1 N2 I2: the second pair looks whole, yet an inverse frame is missing.
constexpr Step kT3[] = {
    Configure(), Cycle(0U), Normal(1000U), OtherNormal(2000U), OtherInverse(3000U), Cycle(4000U),
    Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 2U, 0U),
};

constexpr Step kT4[] = {
    Configure(), Cycle(0U), Inverse(1000U), Normal(1001U), Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
};

// An error is left by an acknowledge, without leaving OPERATIONAL.
constexpr Step kT5[] = {
    Configure(), Cycle(0U), Normal(1000U), WrongInverse(0U, 1001U), Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U),
    Normal(3000U), Inverse(3001U), Acknowledge(1U), Cycle(3900U), Masks(0U, 1U, 0U, 0U, 1U), Cycle(4000U),
    Masks(1U, 0U, 0U, 0U, 0U),
};

// One short frame while not OPERATIONAL is nothing; one in OPERATIONAL is over with the next pair.
constexpr Step kT6[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Frame(0x111U, 1U, 0U, 0U, 100U),
    Nmt(NmtState::kOperational), Cycle(1000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Frame(0x111U, 1U, 0U, 0U, 1100U), Cycle(2000U), Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U), Normal(2100U),
    Inverse(2200U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// A pair that comes 100 ms too late, and a call 200 ms late: the limit of the first pair is told; the one behind has none.
constexpr Step kT7[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Normal(151000U), Inverse(152000U),
    Cycle(203000U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U), Signals(0U, Bit(Cause::kSct)),
};

// An inverse frame 45 ms after the normal frame, both seen by one late call.
constexpr Step kT19[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(46000U), Cycle(47000U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
};

// On a time-out the objects take the safe value.
constexpr Step kT8[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Commit(1U, 1U),
    NormalObject(0x6010U, 1U, 0x12U), InverseObject(0x6011U, 1U, 0xEDU), Cycle(51001U),
    Commit(0U, 0U), NormalObject(0x6010U, 1U, 0xA5U), NormalObject(0x6010U, 2U, 0xC3U),
    InverseObject(0x6011U, 1U, 0x5AU), InverseObject(0x6011U, 2U, 0x3CU),
};

// A dummy object in the mapping is refused, not half accepted.
constexpr Step kT9[] = {
    StoreAll(), Entry(0U, 3U, 0x00050008U), Entry(0U, 4U, 0x00050008U), Signature(0U, 0x1063U),
    Validate(0U, kBadMap, 0x1063U), Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
};

// Totals agree, pairs do not: 16 with 32 bits and 32 with 16.
constexpr Step kT10[] = {
    StoreAll(), Entry(0U, 1U, 0x63000210U), Entry(0U, 2U, 0x63010420U), Entry(0U, 3U, 0x63000420U),
    Entry(0U, 4U, 0x63010210U),
    Signature(0U, 0x36CAU), Validate(0U, kBadMap, 0x36CAU),
};

constexpr Step kT11[] = {
    StoreAll(), Entry(0U, 2U, 0x60100108U), MapCount(0U, 2U), Signature(0U, 0x4D8FU), Validate(0U, kBadMap, 0x4D8FU),
};

constexpr Step kT12Pair = UnequalPair(0U, 0x3412U, 0x9912U);

// Calls every 0.7 ms: the tenth refresh is due at 2000 + 10 * 25000 = 252000, seen by the call at 252000.
constexpr Step kT12[] = {
    Configure(), kP1, kP2, kI1, Cycle(0U), Cycle(2100U), Due(1U), kT12Pair, NotInverse(0U), Cycle(27300U),
    Due(1U), kT12Pair, NotInverse(0U), Cycle(52500U), Due(1U), kT12Pair, NotInverse(0U), Cycle(77000U),
    Due(1U), kT12Pair, NotInverse(0U), Cycle(102200U), Due(1U), kT12Pair, NotInverse(0U), Cycle(127400U),
    Due(1U), kT12Pair, NotInverse(0U), Cycle(152600U), Due(1U), kT12Pair, NotInverse(0U), Cycle(177100U),
    Due(1U), kT12Pair, NotInverse(0U), Cycle(202300U), Due(1U), kT12Pair, NotInverse(0U), Cycle(227500U),
    Due(1U), kT12Pair, NotInverse(0U), Cycle(251999U), Due(0U), Cycle(252000U), Due(1U),
};

// One full queue is one fault; the next pair is sent.
constexpr Step kT13[] = {
    Configure(), kP1, kP2, kI1, kI2, Cycle(0U), Cycle(2000U), ReadyPair(0U),
    TransmitFault(0U, Cause::kTransmitQueue), Cycle(3000U),
    Slot(0U, kProducing, Cause::kTransmitQueue, 0U, 1U, 0U), Request(0U), Cycle(4000U), Due(1U), ReadyPair(0U), ConfirmFirst(0U, 4100U), TakeSecond(0U),
    ConfirmSecond(0U, 4200U), Slot(0U, kProducing, Cause::kTransmitQueue, 1U, 1U, 0U),
};

// A parameter that changes in OPERATIONAL is found by the cyclic check.
constexpr Step kT14[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Srvt(0U, 255U),
    Recheck(0U, ConfigFault::kSignature, 0x8BEEU),
};

constexpr Step kT15[] = {
    StoreAll(), Direction(0U, 3U), Signature(0U, 0xCEACU), Validate(0U, ConfigFault::kDirection, 0xCEACU),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U),
};

// A map count greater than the memory for entries.
constexpr Step kOverflow[] = {
    StoreAll(), MapCount(0U, 255U), Signature(0U, 0x72C4U), Validate(0U, kBadMap, 0x72C4U),
    Recheck(0U, ConfigFault::kTable, 0x72C4U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 100U), Commit(1U, 1U), Cycle(1000U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
};

// Two SRDOs with the same identifiers.
constexpr Step kUnique[] = {
    StoreAll(), CobId1(1U, 0x111U), CobId2(1U, 0x112U), Signature(1U, 0xDD3AU),
    Validate(1U, ConfigFault::kIdentifierInUse, 0xDD3AU),
};

// The cause of a frame is not replaced by a time-out found in the same call.
constexpr Step kNotReplaced[] = {
    Configure(), Cycle(0U), Normal(1000U), WrongInverse(9U, 2000U), Normal(3000U), Cycle(30000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Signals(0U, Bit(Cause::kNotInverse) | Bit(Cause::kSrvt)),
};

constexpr Case kCases[] = {
    MakeCase("T2_SrvtAboveSct", {req::SRS_CFG_025}, kGold, kT2),
    MakeCase("T3_DuplicateNormalFrame", {req::SRS_CONS_007}, kGold, kT3),
    MakeCase("T4_InverseFrameFirstIsSilent", {req::SRS_CONS_008}, kGold, kT4),
    MakeCase("T5_LatchedUntilNmt", {req::SRS_REL_004}, kGoldLocked, kT5),
    MakeCase("T6_ShortFrameLatched", {req::SRS_CONS_005, req::SRS_CONS_002}, kGold, kT6),
    MakeCase("T7_SctMaskedByALateCall", {req::SRS_TIME_003, req::SRS_CONS_014}, kGold, kT7),
    MakeCase("T8_LastValueAfterATimeOut", {req::SRS_REL_002}, kGold, kT8),
    MakeCase("T9_DummyMappingHalfAccepted", {req::SRS_CFG_027, req::SRS_CONS_002}, kGold, kT9),
    MakeCase("T10_OnlyTotalsCompared", {req::SRS_CFG_027}, kGold, kT10),
    MakeCase("T11_SameObjectNormalAndInverse", {req::SRS_CFG_027}, kGold, kT11),
    MakeCase("T12_RefreshDrifts", {req::SRS_PROD_002}, kProvider, kT12),
    MakeCase("T13_OneFullQueueLatches", {req::SRS_PROD_009}, kSender, kT13),
    MakeCase("T14_CorruptionInOperational", {req::SRS_CFG_030}, kGold, kT14),
    MakeCase("T15_Direction3", {req::SRS_CFG_021, req::SRS_CONS_002}, kGold, kT15),
    MakeCase("T19_SrvtMaskedByALateCall", {req::SRS_TIME_003, req::SRS_CONS_003}, kGold, kT19),
    MakeCase("Ovf_MapCountAboveTheMemory", {req::SRS_CFG_026, req::SRS_CFG_020}, kWide, kOverflow),
    MakeCase("IdentifiersNotUnique", {req::SRS_CFG_024}, kTwo, kUnique),
    MakeCase("CauseReplacedByATimeOut", {req::SRS_CONS_020, req::SRS_CONS_018}, kGold, kNotReplaced),
};
// clang-format on
} // namespace

const CaseTable kDefectCases = MakeTable("defect", kCases);

} // namespace counterpoint::conformance
