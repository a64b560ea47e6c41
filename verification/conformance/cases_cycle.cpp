// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Faults that only the cycle can find: late call, lost frames, GFC; and their order. Times in microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr std::uint32_t kGfcOn = 1U;

// Cycle 10 ms, tolerance 5 ms.
// t     0    15000 (on)   30001 (1 us over)
constexpr Step kLate[] = {
    Configure(), Cycle(0U), Cycle(15000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(30001U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kLateCall, 0U, 1U, 0U), Signals(0U, Bit(Cause::kLateCall)), Cycle(45001U),
    Slot(0U, kFaulted, Cause::kLateCall, 0U, 1U, 0U), Masks(0U, 1U, 0U, 0U, 0U),
};

constexpr Step kLateDiscards[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(10000U), Masks(1U, 0U, 0U, 0U, 1U), Cycle(25001U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kLateCall, 0U, 1U, 0U), Normal(26000U), Inverse(27000U),
    Cycle(35000U),
    Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, Cause::kLateCall, 1U, 1U, 1U),
};

constexpr Step kFirstNeverLate[] = {
    Configure(), Cycle(0x40000000U), Masks(0U, 0U, 1U, 0U, 0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Restart(),
    Configure(),
    Cycle(0x60000000U), Masks(0U, 0U, 1U, 0U, 0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

// The late call never hides the expired limit, and adds nothing to it.
// t     1000  2000  10000   60000: SCT over and late
constexpr Step kLateAndSct[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(10000U), Cycle(60000U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSct)),
};

constexpr Step kLateAndSrvt[] = {
    Configure(), Cycle(0U), Normal(1000U), Cycle(10000U), Cycle(60000U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSrvt)),
};

// SCT was over at a frame, not in this call: the late call counts, too.
constexpr Step kLateAfterSctAtFrame[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(10000U), Normal(51001U), Cycle(60000U),
    Slot(0U, kFaulted, Cause::kSct, 0U, 2U, 0U), Signals(0U, Bit(Cause::kSct) | Bit(Cause::kLateCall)),
};

// The calls before OPERATIONAL count, too: a late call is measured from the call before it.
constexpr Step kLateAtEntering[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Cycle(20000U), Counts(0U, 0U, 0U, 1U),
    Masks(0U, 0U, 0U, 0U, 0U),
    Slot(0U, kOff, kNoCause, 0U, 0U, 0U), Nmt(NmtState::kOperational), Cycle(35000U), Masks(0U, 0U, 1U, 0U, 0U),
};

constexpr Step kOverflow[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Queue(QueueState::kOverflowed), Cycle(4000U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kQueueOverflow)),
    Queue(QueueState::kIntact), Normal(5000U), Inverse(5001U), Cycle(6000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kOverflowValues[] = {
    Configure(), Cycle(0U), Queue(QueueState::kInvalid), Cycle(1000U),
    Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 1U, 0U),
    Queue(static_cast<QueueState>(0x67U)), Cycle(2000U), Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 2U, 0U),
    Queue(static_cast<QueueState>(0xFFU)), Cycle(3000U), Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 3U, 0U),
    Queue(QueueState::kIntact), Cycle(4000U), Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 3U, 0U),
};

// A pending normal frame goes with an overflow, too: its inverse frame may be the one that was lost.
constexpr Step kOverflowPending[] = {
    Configure(), Cycle(0U), Normal(1000U), Queue(QueueState::kOverflowed), Cycle(2000U), Inverse(3000U),
    Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 2U, 0U),
};

constexpr Step kAllConsumers[] = {
    Configure(), Cycle(0U), Queue(QueueState::kOverflowed), Cycle(1000U), Masks(0U, 3U, 0U, 3U, 0U), Signalled(3U),
    Slot(1U, kFaulted, Cause::kQueueOverflow, 0U, 1U, 0U),
};

constexpr Step kProducerUntouched[] = {
    Configure(), Cycle(0U), Queue(QueueState::kOverflowed), Cycle(100000U), Masks(0U, 1U, 0U, 1U, 0U),
    Queue(QueueState::kOverflowed),
    Cycle(100100U), Signals(1U, 0U),
};

constexpr Step kGfc[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U),
    Gfc(4000U),
    Cycle(5000U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kGfc, 0U, 1U, 0U), Signals(0U, Bit(Cause::kGfc)),
    Cycle(6000U), Masks(0U, 1U, 0U, 0U, 0U), Normal(7000U), Inverse(7001U), Cycle(8000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kGfcEvery[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), On(Gfc(1000U), CanPortId::kSecond),
    Gfc(1001U), Cycle(2000U),
    Masks(0U, 3U, 0U, 3U, 0U), Slot(0U, kFaulted, Cause::kGfc, 0U, 1U, 0U), Slot(1U, kFaulted, Cause::kGfc, 0U, 1U, 0U),
};

// Nothing on the first one in this cycle.
constexpr Step kGfcOnTheSecond[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), On(Gfc(1000U), CanPortId::kSecond),
    Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kGfc, 0U, 1U, 0U), Signals(0U, Bit(Cause::kGfc)),
};

constexpr Step kGfcParameterOff[] = {
    Configure(), Cycle(0U), Gfc(1000U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
    Store(0U, ConfigField::kGfcParameter, 2U),
    Gfc(3000U), Cycle(4000U), Masks(0U, 0U, 1U, 0U, 0U), Store(0U, ConfigField::kGfcParameter, 1U), Gfc(5000U),
    Cycle(6000U),
    Masks(0U, 1U, 0U, 1U, 0U),
};

constexpr Step kGfcOtherFrames[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Frame(0x001U, 1U, 0U, 0U, 1000U),
    Frame(0x001U, 8U, 0U, 0U, 1001U), OfKind(Gfc(1002U), FrameKind::kRemote), OfKind(Gfc(1003U), FrameKind::kExtended),
    OfKind(Gfc(1004U), FrameKind::kFlexibleDataRate), Frame(0x000U, 0U, 0U, 0U, 1005U),
    Frame(0x002U, 0U, 0U, 0U, 1006U),
    Frame(0x10001U, 0U, 0U, 0U, 1007U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

constexpr Step kGfcNotOperational[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Gfc(1000U),
    Nmt(NmtState::kOperational), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Cycle(3000U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

// One that the cycle of its time did not take is none once OPERATIONAL was left, nor is one that came meanwhile.
constexpr Step kGfcThenLeft[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Gfc(500U), Nmt(NmtState::kPreOperational),
    Cycle(1000U), Slot(0U, kOff, Cause::kNotOperational, 0U, 1U, 0U), Signals(0U, Bit(Cause::kNotOperational)),
    Gfc(1500U), Nmt(NmtState::kOperational), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U), Signals(0U, 0U), Cycle(3000U),
    Slot(0U, kWaiting, Cause::kNotOperational, 0U, 1U, 0U), Masks(0U, 0U, 1U, 0U, 0U),
};

// Cycle 10 ms: limit, overflow and GFC in one call; the late call counts only without an expired limit.
constexpr Step kOrderWithLimit[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Normal(1000U), Gfc(2000U),
    Queue(QueueState::kOverflowed),
    Cycle(40000U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 3U, 0U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kQueueOverflow) | Bit(Cause::kGfc)),
};

constexpr Step kOrderWithoutLimit[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Gfc(2000U), Queue(QueueState::kOverflowed),
    Cycle(40000U),
    Slot(0U, kFaulted, Cause::kLateCall, 0U, 3U, 0U),
    Signals(0U, Bit(Cause::kLateCall) | Bit(Cause::kQueueOverflow) | Bit(Cause::kGfc)),
};

constexpr Step kOrderOverflowGfc[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Gfc(2000U), Queue(QueueState::kOverflowed),
    Cycle(10000U),
    Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 2U, 0U),
};

// The frame's fault comes before the GFC, even if the GFC was on the bus before it.
constexpr Step kOrderFrameFirst[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Gfc(1000U), Inverse(2000U), Cycle(3000U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 2U, 0U),
};

// Cycle 10 ms, tolerance 5 ms, two consumers. The limit of one is no excuse for the other.
// t     1000/2000    20000/21000   25000      40000   55001 (late)       70002 (late)
//       pair of 0    pair of 1     released           0: SCT, 1: late    both late
constexpr Step kLateOfEach[] = {
    Alter(Parameter::kCycle, 10000U), Alter(Parameter::kCycleTolerance, 5000U), Configure(), Cycle(0U), Normal(1000U),
    Inverse(2000U), Cycle(10000U), Frame(0x103U, 4U, 0xDDCCBBAAU, 0U, 20000U),
    Frame(0x104U, 4U, 0x22334455U, 0U, 21000U), Cycle(25000U), Masks(3U, 0U, 0U, 0U, 2U), Cycle(40000U),
    Masks(3U, 0U, 0U, 0U, 0U), Cycle(55001U), Masks(0U, 3U, 0U, 3U, 0U), Slot(0U, kFaulted, Cause::kSct, 0U, 1U, 0U),
    Signals(0U, Bit(Cause::kSct)), Slot(1U, kFaulted, Cause::kLateCall, 0U, 1U, 0U), Signals(1U, Bit(Cause::kLateCall)),
    Cycle(70002U), Masks(0U, 3U, 0U, 3U, 0U), Signals(0U, Bit(Cause::kLateCall)), Signals(1U, Bit(Cause::kLateCall)),
};

// A call that enters OPERATIONAL finds what any other one finds: the consumer is active in it.
constexpr Step kLateAndEntering[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Nmt(NmtState::kOperational), Cycle(15001U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kLateCall, 0U, 1U, 0U), Signals(0U, Bit(Cause::kLateCall)),
};

constexpr Step kOverflowAndEntering[] = {
    Configure(), Nmt(NmtState::kPreOperational), Cycle(0U), Nmt(NmtState::kOperational),
    Queue(QueueState::kOverflowed), Cycle(1000U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 1U, 0U), Signals(0U, Bit(Cause::kQueueOverflow)),
};

// Nothing happens at the frame; the cycle takes a pending normal frame, too.
constexpr Step kGfcPending[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Normal(1000U), Gfc(1500U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Cycle(2000U), Slot(0U, kFaulted, Cause::kGfc, 0U, 1U, 0U),
    Inverse(3000U), Slot(0U, kFaulted, Cause::kGfc, 0U, 2U, 0U), Cycle(4000U), Signals(0U, Bit(Cause::kInverseFirst)),
};

// 1300h changes between the frame and the cycle: it counts as it was when the frame came.
constexpr Step kGfcParameterThen[] = {
    Configure(), Cycle(0U), Gfc(1000U), Store(0U, ConfigField::kGfcParameter, kGfcOn), Cycle(2000U),
    Masks(0U, 0U, 1U, 0U, 0U), Gfc(3000U), Store(0U, ConfigField::kGfcParameter, 0U), Cycle(4000U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kGfc, 0U, 1U, 0U),
};

constexpr Step kGfcNoProducer[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Gfc(1000U), Cycle(2000U),
    Masks(0U, 1U, 0U, 1U, 0U), Signalled(1U), Slot(1U, kProducing, kNoCause, 0U, 0U, 0U),
    Slot(2U, kOff, kNoCause, 0U, 0U, 0U),
};

constexpr Step kOrderWithSct[] = {
    Store(0U, ConfigField::kGfcParameter, kGfcOn), Configure(), Cycle(0U), Normal(1000U), Inverse(2000U),
    Cycle(10000U), Cycle(25000U), Cycle(40000U), Masks(1U, 0U, 0U, 0U, 0U), Gfc(41000U),
    Queue(QueueState::kOverflowed), Cycle(55001U), Slot(0U, kFaulted, Cause::kSct, 0U, 3U, 0U),
    Signals(0U, Bit(Cause::kSct) | Bit(Cause::kQueueOverflow) | Bit(Cause::kGfc)),
};

constexpr Case kCases[] = {
    MakeCase("LateCall", {req::SRS_CONS_015, req::SRS_TIME_004, req::SRS_TIME_001}, kGoldPrompt, kLate),
    MakeCase("LateCallDiscardsThePair", {req::SRS_CONS_015, req::SRS_CONS_012}, kGoldPrompt, kLateDiscards),
    MakeCase("FirstCallIsNeverLate", {req::SRS_CONS_015}, kGoldPrompt, kFirstNeverLate),
    MakeCase("LateCallWithSctOver", {req::SRS_CONS_015, req::SRS_CONS_018}, kGoldPrompt, kLateAndSct),
    MakeCase("LateCallWithSrvtOver", {req::SRS_CONS_015, req::SRS_CONS_018}, kGoldPrompt, kLateAndSrvt),
    MakeCase("LateCallAfterSctOverAtAFrame", {req::SRS_CONS_015, req::SRS_CONS_018}, kGoldPrompt, kLateAfterSctAtFrame),
    MakeCase("CallsBeforeOperationalCountForTheNext", {req::SRS_CONS_015}, kGoldPrompt, kLateAtEntering),
    MakeCase("LostFrames", {req::SRS_CONS_016}, kGold, kOverflow),
    MakeCase("AnyOtherQueueStateMeansLostFrames", {req::SRS_CONS_016}, kGold, kOverflowValues),
    MakeCase("LostFramesDiscardThePendingFrame", {req::SRS_CONS_016, req::SRS_CONS_012}, kGold, kOverflowPending),
    MakeCase("LostFramesConcernEveryConsumer", {req::SRS_CONS_016}, kTwo, kAllConsumers),
    MakeCase("LostFramesConcernNoProducer", {req::SRS_CONS_016}, kMixed, kProducerUntouched),
    MakeCase("GlobalFailsafeCommand", {req::SRS_CONS_017}, kGold, kGfc),
    MakeCase("GlobalFailsafeCommandConcernsEveryConsumer", {req::SRS_CONS_017}, kTwo, kGfcEvery),
    MakeCase("GlobalFailsafeCommandOnTheSecondController", {req::SRS_CONS_017}, kGold, kGfcOnTheSecond),
    MakeCase("GlobalFailsafeCommandNeeds1300h", {req::SRS_CONS_017}, kGold, kGfcParameterOff),
    MakeCase("NoGlobalFailsafeCommand", {req::SRS_CONS_017}, kGold, kGfcOtherFrames),
    MakeCase("GlobalFailsafeCommandOutsideOperational", {req::SRS_CONS_017, req::SRS_CONS_002}, kGold,
             kGfcNotOperational),
    MakeCase("GlobalFailsafeCommandBeforeLeaving", {req::SRS_CONS_017, req::SRS_CONS_019}, kGold, kGfcThenLeft),
    MakeCase("OrderOfCausesWithALimit", {req::SRS_CONS_018, req::SRS_CONS_020}, kGoldPrompt, kOrderWithLimit),
    MakeCase("OrderOfCausesWithoutALimit", {req::SRS_CONS_018, req::SRS_CONS_020}, kGoldPrompt, kOrderWithoutLimit),
    MakeCase("LostFramesBeforeGlobalFailsafeCommand", {req::SRS_CONS_018}, kGoldPrompt, kOrderOverflowGfc),
    MakeCase("FaultOfAFrameBeforeGlobalFailsafeCommand", {req::SRS_CONS_018}, kGoldPrompt, kOrderFrameFirst),
    MakeCase("LateCallOfEachConsumer", {req::SRS_CONS_015, req::SRS_CONS_018}, kTwo, kLateOfEach),
    MakeCase("LateCallThatEntersOperational", {req::SRS_CONS_015, req::SRS_CONS_002}, kGoldPrompt, kLateAndEntering),
    MakeCase("LostFramesInTheCallThatEntersOperational", {req::SRS_CONS_016, req::SRS_CONS_002}, kGold,
             kOverflowAndEntering),
    MakeCase("GlobalFailsafeCommandDiscardsThePendingFrame", {req::SRS_CONS_017, req::SRS_CONS_012}, kGold,
             kGfcPending),
    MakeCase("GlobalFailsafeCommandCountsBy1300hOfItsTime", {req::SRS_CONS_017}, kGold, kGfcParameterThen),
    MakeCase("GlobalFailsafeCommandConcernsNoProducer", {req::SRS_CONS_017}, kMixed, kGfcNoProducer),
    MakeCase("OrderOfCausesWithSct", {req::SRS_CONS_018, req::SRS_CONS_020}, kGoldPrompt, kOrderWithSct),
};
// clang-format on
} // namespace

const CaseTable kCycleCases = MakeTable("cycle", kCases);

} // namespace counterpoint::conformance
