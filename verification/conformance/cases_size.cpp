// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// 64 SRDOs, and numbers with gaps. Times in microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr SrdoMask kAll = 0xFFFFFFFFFFFFFFFFU;

constexpr Step Pair(std::uint32_t slot, std::uint32_t stamp)
{
    return Frame(0x101U + (2U * slot), 8U, 0x11223300U + slot, 0xA5A5A500U + slot, stamp);
}

constexpr Step Complement(std::uint32_t slot, std::uint32_t stamp)
{
    return Frame(0x102U + (2U * slot), 8U, 0xEEDDCCFFU - slot, 0x5A5A5AFFU - slot, stamp);
}

constexpr std::uint32_t kFullSteps = 4U + (2U * kMaxSrdoCount) + 9U + kMaxSrdoCount;

struct FullSteps
{
    Step steps[kFullSteps];
};

/// All 64 normal frames, then all inverse frames in the opposite order: every slot pairs its own.
constexpr FullSteps MakeFull()
{
    FullSteps full{};
    std::uint32_t at = 0U;
    full.steps[at++] = Configure();
    full.steps[at++] = Cycle(0U);
    full.steps[at++] = Counts(64U, 0U, 0U, 0U);
    full.steps[at++] = Mask(MaskName::kWaiting, kAll);
    for (std::uint32_t slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        full.steps[at++] = Pair(slot, 1000U + slot);
    }
    for (std::uint32_t slot = kMaxSrdoCount; slot > 0U; --slot)
    {
        full.steps[at++] = Complement(slot - 1U, 5000U - slot);
    }
    full.steps[at++] = Cycle(6000U);
    full.steps[at++] = Mask(MaskName::kReleased, kAll);
    full.steps[at++] = Mask(MaskName::kFresh, kAll);
    full.steps[at++] = OrdinalSum(64U);
    full.steps[at++] = Commit(kAll, kAll);
    full.steps[at++] = Answer(0xFFFFFFFFU, kAll, 0x9E3779B1U, 0x85EBCA77U);
    full.steps[at++] = Cycle(7000U);
    full.steps[at++] = Mask(MaskName::kReleased, kAll);
    full.steps[at++] = Counts(64U, 0U, 0U, 0U);
    for (std::uint32_t slot = 0U; slot < kMaxSrdoCount; ++slot)
    {
        full.steps[at++] = NormalObject(static_cast<std::uint16_t>(0x7000U + slot), 1U, 0x11223300U + slot);
    }
    return full;
}

constexpr FullSteps kFull = MakeFull();

// t     0      1000..1003      2000            51000   51001      51002
//       enter  pairs 0 and 63  both released   cycle   0: SCT     63 holds: its frame came 2 us later
constexpr Step kFirstAndLast[] = {
    Configure(), Cycle(0U), Pair(0U, 1000U), Complement(0U, 1001U), Pair(63U, 1002U), Complement(63U, 1003U),
    Cycle(2000U), Mask(MaskName::kReleased, 0x8000000000000001U),
    Mask(MaskName::kFresh, 0x8000000000000001U), Mask(MaskName::kWaiting, 0x7FFFFFFFFFFFFFFEU), OrdinalSum(2U),
    Data(63U, 0x1122333FU, 0xA5A5A53FU), Cycle(51000U),
    Mask(MaskName::kReleased, 0x8000000000000001U), Cycle(51002U), Mask(MaskName::kReleased, 0x8000000000000000U),
    Mask(MaskName::kFaulted, 1U),
    Mask(MaskName::kNewFault, 1U), Cycle(51003U), Mask(MaskName::kNewFault, 0x8000000000000000U),
    Mask(MaskName::kFaulted, 0x8000000000000001U),
};

// Late by more than cycle and tolerance: every one of the 64.
constexpr Step kEveryFault[] = {
    Configure(), Cycle(0U), Queue(QueueState::kOverflowed), Cycle(1000U), Mask(MaskName::kFaulted, kAll),
    Mask(MaskName::kNewFault, kAll), Mask(MaskName::kSignalled, kAll),
    Slot(31U, kFaulted, Cause::kQueueOverflow, 0U, 1U, 0U), Slot(32U, kFaulted, Cause::kQueueOverflow, 0U, 1U, 0U),
    Nmt(NmtState::kStopped), Cycle(2000U),
    Mask(MaskName::kNewFault, kAll), Mask(MaskName::kFaulted, 0U), Counts(0U, 0U, 0U, 1U),
};

constexpr Step kInUseAtTheEnds[] = {
    StoreAll(), Store(63U, ConfigField::kCobId1, 0x101U), Store(63U, ConfigField::kCobId2, 0x102U),
    Validate(0U, ConfigFault::kIdentifierInUse, 0x766CU),
    Store(63U, ConfigField::kDirection, 0U), Validate(0U, ConfigFault::kNone, 0x766CU),
    Validate(62U, ConfigFault::kNone, 0x2746U),
};

// Numbers 2, 17, 33, 64: slots 0 to 3. Slots 1 and 3 are off.
constexpr Step kNumbersWithGaps[] = {
    Configure(), Cycle(0U), Counts(2U, 0U, 2U, 0U), Masks(0U, 0U, 5U, 0U, 0U), Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(3U, kOff, kNoCause, 0U, 0U, 0U),
    Frame(0x101U, 2U, 0U, 0U, 500U), Normal(1000U), Inverse(1001U), Frame(0x103U, 4U, 0xDDCCBBAAU, 0U, 1002U),
    Frame(0x104U, 4U, 0x22334455U, 0U, 1003U), Cycle(2000U),
    Masks(5U, 0U, 0U, 0U, 5U), Data(2U, 0xDDCCBBAAU), Commit(0xFU, 0xFU), NormalObject(0x6010U, 1U, 0x12U),
    NormalObject(0x6200U, 1U, 0xDDCCBBAAU),
    InverseObject(0x6201U, 1U, 0x22334455U), Answer(0x00000001U, 5U, 0xB54CDA26U, 0x2386BECAU),
};

// Sixteen producers: all due at once; one sends, the others stay due.
constexpr Step kManySenders[] = {
    Configure(), Put(0x6210U, 1U, 0x12U), Put(0x6210U, 2U, 0x34U), Put(0x6211U, 1U, 0xEDU), Put(0x6211U, 2U, 0xCBU),
    Cycle(0U), Counts(0U, 16U, 0U, 0U), Request(0U), Request(1U), Request(7U), Request(8U), Request(15U),
    Cycle(2000U), Due(0x8183U), Ready(8U, CanPortId::kFirst, 0x111U, 2U, 0x3412U),
    ConfirmNormal(8U, 0x111U, 2U, 0x3412U, 0U, 2100U),
    TakeInverse(8U, CanPortId::kFirst, 0x112U, 2U, 0xCBEDU), ConfirmPair(8U, 0x112U, 2U, 0xCBEDU, 0U, 2200U),
    Slot(8U, kProducing, kNoCause, 1U, 0U, 0U), Slot(7U, kProducing, kNoCause, 0U, 0U, 0U),
    Cycle(3000U), Due(0x8083U), Counts(0U, 16U, 0U, 0U), Masks(0U, 0U, 0U, 0U, 0U), Signalled(0U),
    Nmt(NmtState::kStopped), Cycle(4000U), Due(0U), Slot(8U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("SixtyFourPairsAtOnce", {req::SRS_CONS_001, req::SRS_CONS_023, req::SRS_REL_002, req::SRS_REL_010},
             kSixtyFour, kFull.steps),
    MakeCase("FirstAndLastOfSixtyFour", {req::SRS_CONS_014, req::SRS_CONS_023}, kSixtyFour, kFirstAndLast),
    MakeCase("EveryOneOfSixtyFourFaults", {req::SRS_CONS_016, req::SRS_CONS_019, req::SRS_CONS_023}, kSixtyFour,
             kEveryFault),
    MakeCase("IdentifierInUseOfSixtyFour", {req::SRS_CFG_024}, kSixtyFour, kInUseAtTheEnds),
    MakeCase("SixteenProducers", {req::SRS_PROD_003, req::SRS_PROD_004, req::SRS_PROD_011, req::SRS_CONS_023}, kSenders,
             kManySenders),
    MakeCase("NumbersWithGaps", {req::SRS_CONS_023, req::SRS_REL_002, req::SRS_CFG_002}, kGaps, kNumbersWithGaps),
};
// clang-format on
} // namespace

const CaseTable kSizeCases = MakeTable("size", kCases);

} // namespace counterpoint::conformance
