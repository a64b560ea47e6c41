// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Recheck of signature and table, in every state.
#include "verification/conformance/gold.hpp"
#include "verification/conformance/stores.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr ConfigFault kSound = ConfigFault::kNone;

constexpr Step kHolds[] = {
    Configure(), Recheck(0U, kSound, 0x4370U), Cycle(0U), Recheck(0U, kSound, 0x4370U), Normal(1000U),
    Recheck(0U, kSound, 0x4370U), Inverse(2000U), Cycle(3000U),
    Recheck(0U, kSound, 0x4370U), Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
};

// The stored signature changed in OPERATIONAL: found, no state changes, but no return to it.
constexpr Step kSignatureChanged[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Signature(0U, 0x4371U),
    Recheck(0U, ConfigFault::kSignature, 0x4370U),
    Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 0U), OtherNormal(5000U),
    OtherInverse(5500U), Cycle(6000U), Masks(1U, 0U, 0U, 0U, 1U),
    Nmt(NmtState::kPreOperational), Cycle(7000U), Nmt(NmtState::kOperational), Cycle(8000U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Counts(0U, 0U, 1U, 0U),
    // Mended and found so: active again from the next entering on.
    Signature(0U, 0x4370U), Recheck(0U, kSound, 0x4370U), Cycle(9000U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Nmt(NmtState::kPreOperational), Cycle(10000U),
    Nmt(NmtState::kOperational), Cycle(11000U), Slot(0U, kWaiting, Cause::kNotOperational, 0U, 1U, 0U),
};

constexpr Step kParameterChanged[] = {
    Configure(), Cycle(0U), Sct(0U, 0U), Recheck(0U, ConfigFault::kSignature, 0xAC92U), Sct(0U, 50U),
    Recheck(0U, ConfigFault::kTable, 0x4370U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Counts(1U, 0U, 0U, 0U),
};

constexpr Step kEntryChanged[] = {
    Configure(), Entry(0U, 4U, 0x60110209U), Recheck(0U, ConfigFault::kSignature, 0x35C4U), Signature(0U, 0x35C4U),
    Recheck(0U, ConfigFault::kTable, 0x35C4U), Entry(0U, 4U, 0x60110208U), Signature(0U, 0x4370U),
    Recheck(0U, ConfigFault::kTable, 0x4370U),
    Validate(0U, kSound, 0x4370U), Recheck(0U, kSound, 0x4370U),
};

constexpr Step kNeverValidated[] = {
    StoreAll(), Recheck(0U, ConfigFault::kTable, 0x4370U), Signature(0U, 1U),
    Recheck(0U, ConfigFault::kSignature, 0x4370U),
};

// A Validate that found a fault leaves nothing resolved.
constexpr Step kAfterFault[] = {
    Configure(), Signature(0U, 1U), Validate(0U, ConfigFault::kSignature, 0x4370U), Signature(0U, 0x4370U),
    Recheck(0U, ConfigFault::kTable, 0x4370U),
    Validate(0U, kSound, 0x4370U), Recheck(0U, kSound, 0x4370U), Cycle(0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kOffHasNoTable[] = {
    Configure(), Recheck(2U, kSound, 0x88E9U), Signature(2U, 0x88E8U), Recheck(2U, ConfigFault::kSignature, 0x88E9U),
    Recheck(1U, kSound, 0xF2B5U),
    Recheck(0U, kSound, 0x4370U),
};

// An identifier changed behind the look-up: the frame that still finds its way is a fault.
constexpr Step kAstray[] = {
    Configure(), Cycle(0U), CobId1(0U, 0x113U), Normal(1000U), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U),
    Inverse(2000U),
    Slot(0U, kFaulted, Cause::kIdentifier, 0U, 2U, 0U),
};

constexpr Step kInverseAstray[] = {
    Configure(), Cycle(0U), CobId2(0U, 0x114U), Inverse(1000U), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U),
    Cycle(2000U), Signals(0U, Bit(Cause::kIdentifier)),
};

// Of a producer: it goes on sending, and is off from the next entering on, until its signature is found right.
constexpr Step kOfAProducer[] = {
    Configure(), Put(0x6210U, 1U, 0x12U), Put(0x6210U, 2U, 0x34U), Put(0x6211U, 1U, 0xEDU), Put(0x6211U, 2U, 0xCBU), Cycle(0U),
    Cycle(2000U), Recheck(0U, kSound, 0xF2B5U), ReadyPair(0U), Signature(0U, 0xF2B4U), Recheck(0U, ConfigFault::kSignature, 0xF2B5U),
    ConfirmFirst(0U, 2100U), TakeSecond(0U), ConfirmSecond(0U, 2200U), Request(0U), Cycle(3000U), Due(1U), Counts(0U, 1U, 0U, 0U),
    Slot(0U, kProducing, kNoCause, 1U, 0U, 0U), Nmt(NmtState::kPreOperational), Cycle(4000U), Nmt(NmtState::kOperational),
    Cycle(5000U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Counts(0U, 0U, 1U, 0U), NotProducing(0U), Signature(0U, 0xF2B5U),
    Recheck(0U, kSound, 0xF2B5U), Cycle(6000U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Nmt(NmtState::kPreOperational), Cycle(7000U),
    Nmt(NmtState::kOperational), Cycle(8000U), Slot(0U, kProducing, kNoCause, 0U, 0U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("RecheckHoldsInEveryState", {req::SRS_CFG_030}, kGold, kHolds),
    MakeCase("RecheckFindsAChangedSignature", {req::SRS_CFG_030, req::SRS_CONS_002}, kGold, kSignatureChanged),
    MakeCase("RecheckFindsAChangedParameter", {req::SRS_CFG_030, req::SRS_CFG_003}, kGold, kParameterChanged),
    MakeCase("RecheckFindsAChangedEntry", {req::SRS_CFG_030, req::SRS_CFG_003}, kGold, kEntryChanged),
    MakeCase("RecheckOfWhatWasNeverValidated", {req::SRS_CFG_030}, kGold, kNeverValidated),
    MakeCase("RecheckAfterAFaultOfValidate", {req::SRS_CFG_030, req::SRS_CFG_029}, kGold, kAfterFault),
    MakeCase("RecheckWithoutATable", {req::SRS_CFG_030}, kMixed, kOffHasNoTable),
    MakeCase("FrameLedToAnotherSrdo", {req::SRS_CONS_004}, kGold, kAstray),
    MakeCase("InverseFrameLedToAnotherSrdo", {req::SRS_CONS_004}, kGold, kInverseAstray),
    MakeCase("RecheckOfAProducer", {req::SRS_CFG_030, req::SRS_CONS_002}, kSender, kOfAProducer),
};
// clang-format on
} // namespace

const CaseTable kRecheckCases = MakeTable("recheck", kCases);

} // namespace counterpoint::conformance
