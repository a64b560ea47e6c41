// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// When SRDOs are active: NMT state, guard token, valid configuration. Times in microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step kBefore[] = {
    Configure(), Normal(100U), Inverse(200U), Cycle(1000U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    // A half that came before entering OPERATIONAL is no half.
    Inverse(1500U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
};

constexpr Step kStates[] = {
    Configure(), Nmt(NmtState::kInitialising), Cycle(0U), Counts(0U, 0U, 0U, 1U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Nmt(NmtState::kPreOperational), Cycle(1000U), Counts(0U, 0U, 0U, 1U), Nmt(NmtState::kStopped), Cycle(2000U),
    Counts(0U, 0U, 0U, 1U),
    Nmt(NmtState::kInvalid), Cycle(3000U), Counts(0U, 0U, 0U, 1U), Nmt(static_cast<NmtState>(0xD9U)), Cycle(4000U),
    Counts(0U, 0U, 0U, 1U),
    Nmt(static_cast<NmtState>(0x05U)), Cycle(5000U), Counts(0U, 0U, 0U, 1U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
    Nmt(NmtState::kOperational),
    Cycle(6000U), Counts(1U, 0U, 0U, 0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kLeave[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Normal(3500U),
    Nmt(NmtState::kPreOperational),
    Cycle(4000U), Masks(0U, 0U, 0U, 1U, 0U), Counts(0U, 0U, 0U, 1U), Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kNotOperational)), Signalled(1U), OrdinalSum(0U), Cycle(5000U), Masks(0U, 0U, 0U, 0U, 0U),
    Signalled(0U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Nmt(NmtState::kOperational), Cycle(6000U),
    Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, Cause::kNotOperational, 0U, 1U, 0U),
    // The normal frame of before is gone.
    Inverse(6500U), Slot(0U, kFaulted, Cause::kNotOperational, 0U, 2U, 0U),
};

constexpr Step kLeaveToEach[] = {
    Configure(), Cycle(0U), Nmt(NmtState::kStopped), Cycle(1000U), Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U),
    Nmt(NmtState::kOperational),
    Cycle(2000U), Nmt(NmtState::kInitialising), Cycle(3000U), Slot(0U, kOff, Cause::kNotOperational, 0U, 2U, 0U),
    Nmt(NmtState::kOperational),
    Cycle(4000U), Nmt(NmtState::kInvalid), Cycle(5000U), Slot(0U, kOff, Cause::kNotOperational, 0U, 3U, 0U),
};

// A fault of a frame and leaving OPERATIONAL in one call: both recorded, the frame's first, both signalled.
constexpr Step kFaultThenLeave[] = {
    Configure(), Cycle(0U), Inverse(1000U), Nmt(NmtState::kStopped), Cycle(2000U),
    Slot(0U, kOff, Cause::kInverseFirst, 0U, 2U, 0U),
    Masks(0U, 0U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kInverseFirst) | Bit(Cause::kNotOperational)),
};

// Leaving is examined before everything else: no limit, late call or overflow is found in that call.
constexpr Step kLeaveIsFirst[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Nmt(NmtState::kStopped),
    Queue(QueueState::kOverflowed), Cycle(3000000U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Signals(0U, Bit(Cause::kNotOperational)),
};

constexpr Step kIgnoredWhileOff[] = {
    Configure(), Cycle(0U), Nmt(NmtState::kStopped), Cycle(1000U), Inverse(1500U),
    On(Normal(1600U), CanPortId::kSecond), Cycle(2000U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Masks(0U, 0U, 0U, 0U, 0U), Queue(QueueState::kOverflowed),
    Cycle(2001U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U),
};

constexpr Step kUnconfigured[] = {
    Configure(), Store(0U, ConfigField::kConfigurationValid, 0U), Cycle(0U), Guard(GuardView::kUnconfigured),
    Counts(0U, 0U, 0U, 1U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Store(0U, ConfigField::kConfigurationValid, 0xA4U), Cycle(1000U),
    Guard(GuardView::kUnconfigured),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(2000U), Guard(GuardView::kConfigured),
    Masks(0U, 0U, 1U, 0U, 0U),
    Store(0U, ConfigField::kConfigurationValid, 0x5AU), Cycle(3000U), Guard(GuardView::kUnconfigured),
    Masks(0U, 0U, 0U, 1U, 0U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Counts(0U, 0U, 0U, 1U),
};

constexpr Step kStale[] = {
    Configure(), Cycle(0U), Token(0x00000001U), Cycle(1000U), Guard(GuardView::kStale),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U),
    Counts(0U, 0U, 0U, 1U), Cycle(2000U), Guard(GuardView::kConfigured),
    Slot(0U, kWaiting, Cause::kNotOperational, 0U, 1U, 0U),
    Token(0x80000000U), Cycle(3000U), Guard(GuardView::kStale), Token(0xFFFFFFFFU), Cycle(4000U),
    Guard(GuardView::kStale),
    // The token of a guard that believes in 00h while this copy says A5h.
    Token(0xA5A5A5A5U), Cycle(5000U), Guard(GuardView::kStale), Token(0x000000A5U), Cycle(6000U),
    Guard(GuardView::kStale), Cycle(7000U),
    Guard(GuardView::kConfigured),
};

constexpr Step kStaleUnconfigured[] = {
    Cycle(0U), Guard(GuardView::kUnconfigured), Token(0x00010000U), Cycle(1000U), Guard(GuardView::kStale),
    Token(0xA5A5A5A5U), Cycle(2000U),
    Guard(GuardView::kStale), Counts(0U, 0U, 0U, 1U), Cycle(3000U), Guard(GuardView::kUnconfigured),
};

constexpr Step kNeverValidated[] = {
    StoreAll(), Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Guard(GuardView::kConfigured),
    Counts(0U, 0U, 1U, 0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Masks(0U, 0U, 0U, 0U, 0U), Normal(1000U), Inverse(2000U), Cycle(3000U),
    Masks(0U, 0U, 0U, 0U, 0U),
};

constexpr Step kWrongSignature[] = {
    StoreAll(), Store(0U, ConfigField::kSignature, 0x4371U), Validate(0U, ConfigFault::kSignature, 0x4370U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(0U), Counts(0U, 0U, 1U, 0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kOneOfTwo[] = {
    Configure(), Store(1U, ConfigField::kSct, 51U), Cycle(0U), Counts(1U, 0U, 1U, 0U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U), Frame(0x104U, 4U, 0U, 0U, 500U), Cycle(1000U),
    Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kRestarted[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
    Restart(),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Signals(0U, 0U), Load(0U, ConfigField::kDirection, 0U), Cycle(0U),
    Guard(GuardView::kUnconfigured),
    Configure(), Cycle(1000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kDirectionOff[] = {
    Configure(), Cycle(0U), Counts(1U, 1U, 1U, 0U), Slot(2U, kOff, kNoCause, 0U, 0U, 0U), Nmt(NmtState::kStopped),
    Cycle(1000U),
    Slot(2U, kOff, kNoCause, 0U, 0U, 0U), Slot(1U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U),
    Masks(0U, 0U, 0U, 1U, 0U), Counts(0U, 0U, 0U, 1U),
};

constexpr Step kCycleNumbers[] = {
    Cycle(0U), Cycle(1000U), Cycle(2000U), Configure(), Cycle(3000U), Cycle(4000U), Restart(), Cycle(5000U),
};

// A pair that was completed just before is not fresh any more, now or later.
constexpr Step kLeaveWithAPair[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Nmt(NmtState::kStopped), Cycle(1000U),
    Masks(0U, 0U, 0U, 1U, 0U), Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Data(0U, 0U),
    Nmt(NmtState::kOperational), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, Cause::kNotOperational, 0U, 1U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("FramesBeforeOperationalAreIgnored", {req::SRS_CONS_002, req::SRS_REL_001}, kGold, kBefore),
    MakeCase("OnlyOperationalActivates", {req::SRS_CONS_002, req::SRS_CONS_023}, kGold, kStates),
    MakeCase("LeavingOperational", {req::SRS_CONS_019, req::SRS_CONS_023, req::SRS_CONS_002}, kGold, kLeave),
    MakeCase("LeavingToEachState", {req::SRS_CONS_019, req::SRS_CONS_002}, kGold, kLeaveToEach),
    MakeCase("FaultAndLeavingInOneCall", {req::SRS_CONS_019, req::SRS_CONS_020, req::SRS_CONS_018}, kGold,
             kFaultThenLeave),
    MakeCase("LeavingIsExaminedFirst", {req::SRS_CONS_002, req::SRS_CONS_019}, kGold, kLeaveIsFirst),
    MakeCase("NothingCountsWhileOff", {req::SRS_CONS_002, req::SRS_CONS_001}, kGold, kIgnoredWhileOff),
    MakeCase("NotActiveWithout13FEh", {req::SRS_CFG_031, req::SRS_CONS_002}, kGold, kUnconfigured),
    MakeCase("StaleGuardToken", {req::SRS_CFG_031, req::SRS_CONS_019}, kGold, kStale),
    MakeCase("StaleGuardTokenWithout13FEh", {req::SRS_CFG_031}, kGold, kStaleUnconfigured),
    MakeCase("NeverValidatedStaysOff", {req::SRS_CONS_002, req::SRS_CFG_003}, kGold, kNeverValidated),
    MakeCase("InvalidConfigurationStaysOff", {req::SRS_CONS_002, req::SRS_CFG_029}, kGold, kWrongSignature),
    MakeCase("OneOfTwoStaysOff", {req::SRS_CONS_002, req::SRS_CFG_003, req::SRS_CONS_023}, kTwo, kOneOfTwo),
    MakeCase("RestartForgetsEverything", {req::SRS_CFG_002, req::SRS_CONS_020}, kGold, kRestarted),
    MakeCase("DirectionOffIsNeverActive", {req::SRS_CONS_023, req::SRS_CONS_019, req::SRS_PROD_011}, kMixed,
             kDirectionOff),
    MakeCase("CyclesAreNumbered", {req::SRS_CONS_023}, kGold, kCycleNumbers),
    MakeCase("LeavingWithAFreshPair", {req::SRS_CONS_023, req::SRS_CONS_019, req::SRS_CONS_025}, kGold,
             kLeaveWithAPair),
};
// clang-format on
} // namespace

const CaseTable kActivityCases = MakeTable("activity", kCases);

} // namespace counterpoint::conformance
