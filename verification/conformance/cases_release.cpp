// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Policies of release, and Demote. Times in microseconds; SCT 50 ms, SRVT 20 ms.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step kAutomatic[] = {
    Configure(), Cycle(0U), Masks(0U, 0U, 1U, 0U, 0U), Normal(1000U), Inverse(1500U), Cycle(2000U),
    Masks(1U, 0U, 0U, 0U, 1U), Inverse(3000U),
    Cycle(4000U), Masks(0U, 1U, 0U, 1U, 0U), Normal(5000U), Inverse(5500U), Cycle(6000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kLocked[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U),
    Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U),
    Acknowledge(1U), Cycle(2900U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 0U), Acknowledge(0U),
    Cycle(4000U), Masks(1U, 0U, 0U, 0U, 0U),
    // A new pair keeps it released, a fault does not.
    OtherNormal(5000U), OtherInverse(5500U), Cycle(6000U), Masks(1U, 0U, 0U, 0U, 1U), Inverse(7000U), Cycle(8000U),
    Masks(0U, 1U, 0U, 1U, 0U),
    Normal(9000U), Inverse(9500U), Cycle(10000U), Masks(0U, 1U, 0U, 0U, 1U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 1U, 1U, 1U),
    Acknowledge(1U), Cycle(10900U), Masks(0U, 1U, 0U, 0U, 0U), Slot(0U, kFaulted, Cause::kInverseFirst, 1U, 1U, 1U),
    Cycle(11000U), Masks(1U, 0U, 0U, 0U, 0U), Slot(0U, kReleased, kNoCause, 1U, 1U, 1U),
};

constexpr Step kOtherPolicy[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U), Cycle(3000U),
    Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(1U), Cycle(3900U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 0U),
};

// The interlock outlives leaving and entering OPERATIONAL: pairs alone never release.
constexpr Step kSurvives[] = {
    Configure(), Cycle(0U), Cycle(500U), Normal(1000U), Inverse(1500U), Acknowledge(1U), Cycle(1900U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(2000U), Masks(1U, 0U, 0U, 0U, 0U), Nmt(NmtState::kPreOperational),
    Cycle(3000U), Nmt(NmtState::kOperational), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U), Normal(5000U), Inverse(5500U),
    Cycle(6000U),
    Masks(0U, 0U, 1U, 0U, 1U), Nmt(NmtState::kStopped), Cycle(7000U), Nmt(NmtState::kInitialising), Cycle(8000U),
    Nmt(NmtState::kOperational),
    Cycle(9000U), Normal(9100U), Inverse(9200U), Cycle(10000U), Masks(0U, 0U, 1U, 0U, 1U), Acknowledge(0U),
    Cycle(11000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(11100U), Masks(0U, 0U, 1U, 0U, 0U),
    Acknowledge(1U), Cycle(11900U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(12000U), Masks(1U, 0U, 0U, 0U, 0U),
};

constexpr Step kSurvivesFault[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U), Nmt(NmtState::kStopped),
    Cycle(3000U), Nmt(NmtState::kOperational),
    Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U), Normal(5000U), Inverse(5500U), Cycle(6000U), Masks(0U, 0U, 1U, 0U, 1U),
    Slot(0U, kWaiting, Cause::kInverseFirst, 1U, 2U, 1U),
};

constexpr Step kSurvivesRestart[] = {
    Configure(), Cycle(0U), Cycle(500U), Normal(1000U), Inverse(1500U), Acknowledge(1U), Cycle(1900U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(2000U), Masks(1U, 0U, 0U, 0U, 0U), Restart(), Configure(),
    Acknowledge(1U), Cycle(3000U), Cycle(3100U), Normal(4000U), Inverse(4500U), Cycle(5000U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(5100U), Masks(0U, 0U, 1U, 0U, 0U),
};

constexpr Step kDemoteReleased[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(1U, 0U, 0U, 0U, 1U), Demote(0U),
    Slot(0U, kFaulted, Cause::kDemoted, 0U, 1U, 0U), Signals(0U, 0U), Cycle(3000U), Masks(0U, 1U, 0U, 0U, 0U),
    Signals(0U, 0U), Signalled(0U),
    Normal(4000U), Inverse(4500U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 1U),
    Slot(0U, kReleased, Cause::kDemoted, 1U, 1U, 1U),
};

constexpr Step kDemoteWaiting[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1500U), Demote(0U), Slot(0U, kFaulted, Cause::kDemoted, 0U, 1U, 0U),
    Cycle(2000U),
    Masks(0U, 1U, 0U, 0U, 0U),
};

constexpr Step kDemoteFaulted[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Demote(0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 2U, 0U), Normal(2500U), Inverse(2600U),
    Demote(0U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 3U, 0U), Cycle(3000U), Masks(0U, 1U, 0U, 0U, 0U),
};

// A pending normal frame stays: its inverse frame still completes the pair.
constexpr Step kDemotePending[] = {
    Configure(), Cycle(0U), Normal(1000U), Demote(0U), Inverse(2000U), Slot(0U, kFaulted, Cause::kDemoted, 1U, 1U, 1U),
    Cycle(3000U),
    Masks(1U, 0U, 0U, 0U, 1U),
};

// A fault of a frame before Demote is still reported.
constexpr Step kDemoteAfterFault[] = {
    Configure(), Cycle(0U), Inverse(1000U), Demote(0U), Normal(1100U), Inverse(1200U), Cycle(2000U),
    Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 2U, 0U), Signals(0U, Bit(Cause::kInverseFirst)),
};

// Demote forgets an acknowledge edge that waits.
constexpr Step kDemoteEdge[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Cycle(1000U), Demote(0U), Normal(1100U),
    Inverse(1200U), Cycle(2000U), Masks(0U, 1U, 0U, 0U, 1U),
};

// Between the two calls there is no edge yet, and the second reports no fault.
constexpr Step kDemoteBetween[] = {
    Configure(), Cycle(0U), Cycle(100U), Acknowledge(1U), Cycle(900U), Demote(0U), Normal(950U), Inverse(960U),
    Cycle(1000U), Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 1U, 1U),
};

constexpr Step kDemoteOff[] = {
    Configure(), Demote(0U), Demote(1U), Demote(2U), Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Cycle(0U), Demote(1U),
    Demote(2U),
    Slot(1U, kProducing, kNoCause, 0U, 0U, 0U), Slot(2U, kOff, kNoCause, 0U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Nmt(NmtState::kStopped), Cycle(100U), Demote(0U), Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U),
};

constexpr Step kDemoteOne[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(1001U), Frame(0x103U, 4U, 1U, 0U, 1002U),
    Frame(0x104U, 4U, 0xFFFFFFFEU, 0U, 1003U), Cycle(2000U),
    Masks(3U, 0U, 0U, 0U, 3U), Demote(1U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
    Slot(1U, kFaulted, Cause::kDemoted, 0U, 1U, 0U), Cycle(3000U),
    Masks(1U, 2U, 0U, 0U, 0U), OrdinalSum(1U),
};

// Neither does 0, nor a value that is one bit away from kAutomatic.
constexpr Step kPolicyZero[] = {
    Alter(Parameter::kPolicy, 0U), Configure(), Cycle(0U), Cycle(500U), Normal(1000U), Inverse(1500U), Cycle(2000U),
    Masks(0U, 0U, 1U, 0U, 1U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U), Acknowledge(1U), Cycle(3900U),
    Masks(0U, 0U, 1U, 0U, 0U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 0U),
    Alter(Parameter::kPolicy, static_cast<std::uint32_t>(ReleasePolicy::kAutomatic) ^ 0x80U), Configure(), Cycle(0U),
    Normal(1000U), Inverse(1500U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 1U), Cycle(3000U), Masks(0U, 0U, 1U, 0U, 0U),
};

constexpr Case kCases[] = {
    MakeCase("AutomaticReleasesTheNextPair", {req::SRS_REL_003, req::SRS_REL_001}, kGold, kAutomatic),
    MakeCase("InterlockNeedsAnAcknowledge", {req::SRS_REL_004, req::SRS_REL_001, req::SRS_REL_007}, kGoldLocked,
             kLocked),
    MakeCase("AnyOtherPolicyIsTheInterlock", {req::SRS_REL_004}, kGoldOther, kOtherPolicy),
    MakeCase("InterlockSurvivesNmt", {req::SRS_REL_008, req::SRS_REL_004}, kGoldLocked, kSurvives),
    MakeCase("InterlockAfterAFaultSurvivesNmt", {req::SRS_REL_008, req::SRS_CONS_020}, kGoldLocked, kSurvivesFault),
    MakeCase("InterlockSurvivesRestart", {req::SRS_REL_008, req::SRS_REL_005}, kGoldLocked, kSurvivesRestart),
    MakeCase("DemoteOfAReleasedSlot", {req::SRS_REL_006}, kGold, kDemoteReleased),
    MakeCase("DemoteOfAWaitingSlot", {req::SRS_REL_006}, kGold, kDemoteWaiting),
    MakeCase("DemoteOfAFaultedSlot", {req::SRS_REL_006, req::SRS_CONS_020}, kGold, kDemoteFaulted),
    MakeCase("DemoteLeavesThePendingFrame", {req::SRS_REL_006}, kGold, kDemotePending),
    MakeCase("DemoteDoesNotHideAFault", {req::SRS_REL_006, req::SRS_CONS_013}, kGold, kDemoteAfterFault),
    MakeCase("DemoteForgetsTheEdge", {req::SRS_REL_006, req::SRS_REL_005}, kGoldLocked, kDemoteEdge),
    MakeCase("DemoteBetweenTheTwoReadings", {req::SRS_REL_006, req::SRS_REL_005}, kGoldLocked, kDemoteBetween),
    MakeCase("DemoteOfWhatIsNoActiveConsumer", {req::SRS_REL_006}, kMixed, kDemoteOff),
    MakeCase("DemoteOfOneSlot", {req::SRS_REL_006}, kTwo, kDemoteOne),
    MakeCase("PolicyOfZeroIsTheInterlock", {req::SRS_REL_004}, kGold, kPolicyZero),
};
// clang-format on
} // namespace

const CaseTable kReleaseCases = MakeTable("release", kCases);

} // namespace counterpoint::conformance
