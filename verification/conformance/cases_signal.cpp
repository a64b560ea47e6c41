// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What is signalled: every fault, by the call that reports it. SCT 50 ms. Times in microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr std::uint32_t kOrderBit = Bit(Cause::kInverseFirst);
constexpr std::uint32_t kLengthBit = Bit(Cause::kLength);
constexpr std::uint32_t kPastSctBit = Bit(Cause::kWaitingPastSct);

constexpr Step Short(std::uint32_t stamp)
{
    return Frame(0x111U, 1U, 0x12U, 0U, stamp);
}

// The same cause in two consecutive calls, then a call without a fault, then the cause once more.
constexpr Step kEvery[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signals(0U, kOrderBit), Signalled(1U), Inverse(2500U),
    Cycle(3000U), Signals(0U, kOrderBit), Signalled(1U), Masks(0U, 1U, 0U, 1U, 0U), Cycle(4000U), Signals(0U, 0U),
    Signalled(0U), Inverse(4500U), Cycle(5000U), Signals(0U, kOrderBit), Signalled(1U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 3U, 0U),
};

// One cause does not keep another back, nor a call with one what the next has.
constexpr Step kOtherCause[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signals(0U, kOrderBit), Short(2500U), Cycle(3000U),
    Signals(0U, kLengthBit), Inverse(3500U), Short(3501U), Cycle(4000U), Signals(0U, kOrderBit | kLengthBit),
    Inverse(4500U), Cycle(5000U), Signals(0U, kOrderBit), Cycle(6000U), Signals(0U, 0U),
};

// What OnCycle finds itself is signalled like the fault of a frame: lost frames in three calls.
constexpr Step kOfTheCycle[] = {
    Configure(), Cycle(0U), Queue(QueueState::kOverflowed), Cycle(1000U), Signals(0U, Bit(Cause::kQueueOverflow)),
    Queue(QueueState::kOverflowed), Cycle(2000U), Signals(0U, Bit(Cause::kQueueOverflow)), Signalled(1U),
    Queue(QueueState::kOverflowed), Cycle(3000U), Signals(0U, Bit(Cause::kQueueOverflow)), Signalled(1U),
    Slot(0U, kFaulted, Cause::kQueueOverflow, 0U, 3U, 0U), Cycle(4000U), Signals(0U, 0U), Signalled(0U),
};

// Left, entered and left again, each in one call.
constexpr Step kLeftTwice[] = {
    Configure(), Cycle(0U), Nmt(NmtState::kStopped), Cycle(1000U), Signals(0U, Bit(Cause::kNotOperational)),
    Nmt(NmtState::kOperational), Cycle(2000U), Signals(0U, 0U), Nmt(NmtState::kStopped), Cycle(3000U),
    Signals(0U, Bit(Cause::kNotOperational)), Signalled(1U), Cycle(4000U), Signals(0U, 0U), Signalled(0U),
};

constexpr Step kTwiceInOneCall[] = {
    Configure(), Cycle(0U), Inverse(1000U), Inverse(1001U), Short(1002U), Short(1003U), Cycle(2000U),
    Signals(0U, kOrderBit | kLengthBit),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 4U, 0U),
};

// Signals are made by OnCycle: a frame alone shows nothing yet, and takes nothing away.
constexpr Step kByTheCycle[] = {
    Configure(), Cycle(0U), Inverse(1000U), Signals(0U, 0U), Cycle(2000U), Signals(0U, kOrderBit), Short(2500U),
    Signals(0U, kOrderBit), Cycle(3000U),
    Signals(0U, kLengthBit),
};

constexpr Step kBothSlots[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signalled(1U), Frame(0x104U, 4U, 0U, 0U, 2500U), Cycle(3000U),
    Signalled(2U), Signals(0U, 0U), Signals(1U, kOrderBit), Inverse(3500U), Frame(0x104U, 4U, 0U, 0U, 3600U),
    Cycle(4000U), Signalled(3U), Signals(0U, kOrderBit), Signals(1U, kOrderBit),
};

// t     0      50000 (on)   50001 (over)   50002
constexpr Step kPastSct[] = {
    Configure(), Cycle(0U), Cycle(50000U), Signals(0U, 0U), Cycle(50001U), Signals(0U, kPastSctBit), Signalled(1U),
    Masks(0U, 0U, 1U, 0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Cycle(50002U), Signals(0U, 0U), Cycle(200000U), Signals(0U, 0U),
    Normal(210000U), Inverse(210001U),
    Cycle(211000U), Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U),
};

// Counted from entering OPERATIONAL, each time.
constexpr Step kPastSctAgain[] = {
    Configure(), Cycle(1000U), Cycle(51000U), Signals(0U, 0U), Cycle(51001U), Signals(0U, kPastSctBit),
    Nmt(NmtState::kPreOperational), Cycle(60000U),
    Nmt(NmtState::kOperational), Cycle(300000U), Signals(0U, 0U), Cycle(350000U), Signals(0U, 0U), Cycle(350001U),
    Signals(0U, kPastSctBit),
    Cycle(350002U), Signals(0U, 0U),
};

constexpr Step kPairEnds[] = {
    Configure(), Cycle(0U), Normal(40000U), Inverse(41000U), Cycle(50001U), Masks(0U, 0U, 1U, 0U, 1U), Signals(0U, 0U),
    Cycle(60000U), Signals(0U, 0U),
};

constexpr Step kHalfPairDoesNot[] = {
    Configure(), Cycle(0U), Normal(49000U), Cycle(50001U), Masks(0U, 0U, 1U, 0U, 0U), Signals(0U, kPastSctBit),
};

constexpr Step kFaultEnds[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signals(0U, kOrderBit), Cycle(50001U), Signals(0U, 0U),
    Cycle(100000U), Signals(0U, 0U),
};

constexpr Step kDemoteEnds[] = {
    Configure(), Cycle(0U), Demote(0U), Cycle(50001U), Signals(0U, 0U), Masks(0U, 1U, 0U, 0U, 0U),
};

// More than half the range of the counter after entering OPERATIONAL it is still signalled only once.
constexpr Step kPastSctRound[] = {
    Configure(), Cycle(0U), Cycle(50001U), Signals(0U, kPastSctBit), Repeat(1100U, 2000000U), Signals(0U, 0U),
    Repeat(2200U, 2000000U), Signals(0U, 0U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
};

// A fault that the same call tells ends the waiting before it: lost frames, SRVT of half a pair, a frame.
constexpr Step kFaultOfTheCallEnds[] = {
    Configure(), Cycle(0U), Queue(QueueState::kOverflowed), Cycle(50001U), Signals(0U, Bit(Cause::kQueueOverflow)),
    Restart(), Configure(), Cycle(60000U), Normal(90001U), Cycle(110002U), Signals(0U, Bit(Cause::kSrvt)),
    Restart(), Configure(), Cycle(120000U), Inverse(121000U), Cycle(170001U), Signals(0U, kOrderBit),
};

// A pair and a fault from before OPERATIONAL was left do not count.
constexpr Step kPastSctAfterAPair[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Inverse(4000U), Cycle(5000U),
    Nmt(NmtState::kStopped), Cycle(6000U), Nmt(NmtState::kOperational), Cycle(7000U), Masks(0U, 0U, 1U, 0U, 0U),
    Cycle(57000U), Signals(0U, 0U), Cycle(57001U), Signals(0U, kPastSctBit),
};

// OPERATIONAL is entered with the call that sees both: NMT state and valid configuration.
constexpr Step kPastSctFromBoth[] = {
    Configure(), Store(0U, ConfigField::kConfigurationValid, 0U), Cycle(0U),
    Store(0U, ConfigField::kConfigurationValid, 0xA5U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U), Cycle(52000U),
    Signals(0U, 0U), Cycle(52001U), Signals(0U, kPastSctBit),
};

constexpr Case kCases[] = {
    MakeCase("EveryFaultIsSignalled", {req::SRS_CONS_021}, kGold, kEvery),
    MakeCase("OtherCausesAreSignalledBesides", {req::SRS_CONS_021}, kGold, kOtherCause),
    MakeCase("EveryFaultOfTheCycleIsSignalled", {req::SRS_CONS_021, req::SRS_CONS_016}, kGold, kOfTheCycle),
    MakeCase("EveryLeavingIsSignalled", {req::SRS_CONS_021, req::SRS_CONS_019}, kGold, kLeftTwice),
    MakeCase("SameCauseTwiceInOneCall", {req::SRS_CONS_021, req::SRS_CONS_020}, kGold, kTwiceInOneCall),
    MakeCase("SignalsAreThoseOfTheLastCall", {req::SRS_CONS_021}, kGold, kByTheCycle),
    MakeCase("EachSlotHasItsSignals", {req::SRS_CONS_021}, kTwo, kBothSlots),
    MakeCase("WaitingPastSct", {req::SRS_CONS_022, req::SRS_TIME_004}, kGold, kPastSct),
    MakeCase("WaitingPastSctAfterReentering", {req::SRS_CONS_022, req::SRS_CONS_019}, kGold, kPastSctAgain),
    MakeCase("NotWaitingAfterAPair", {req::SRS_CONS_022}, kGoldLocked, kPairEnds),
    MakeCase("HalfAPairIsStillWaiting", {req::SRS_CONS_022}, kGold, kHalfPairDoesNot),
    MakeCase("NotWaitingAfterAFault", {req::SRS_CONS_022}, kGold, kFaultEnds),
    MakeCase("NotWaitingAfterDemote", {req::SRS_CONS_022, req::SRS_REL_006}, kGold, kDemoteEnds),
    MakeCase("WaitingPastSctAfterARoundOfTheCounter", {req::SRS_CONS_022, req::SRS_TIME_001}, kGold, kPastSctRound),
    MakeCase("NotWaitingInTheCallThatTellsAFault", {req::SRS_CONS_022}, kGold, kFaultOfTheCallEnds),
    MakeCase("WaitingPastSctAfterAPairOfBefore", {req::SRS_CONS_022, req::SRS_CONS_019}, kGold, kPastSctAfterAPair),
    MakeCase("WaitingPastSctFromTheValidConfiguration", {req::SRS_CONS_022, req::SRS_CONS_002}, kGold,
             kPastSctFromBoth),
};
// clang-format on
} // namespace

const CaseTable kSignalCases = MakeTable("signal", kCases);

} // namespace counterpoint::conformance
