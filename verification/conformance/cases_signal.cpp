// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What is signalled, and how often: once per cause in a window of SCT (50 ms). Times in microseconds.
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

// t     1000      2000               3000   4000     5000
// window          |----------------------------------------> 52000 (still in it)
constexpr Step kOnce[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signals(0U, kOrderBit), Signalled(1U), Cycle(3000U),
    Signals(0U, 0U), Signalled(0U),
    Inverse(4000U), Cycle(5000U), Signals(0U, 0U), Signalled(0U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 2U, 0U),
};

constexpr Step kOnWindowEnd[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signals(0U, kOrderBit), Inverse(51000U), Cycle(52000U),
    Signals(0U, 0U),
    // The window is over one microsecond later, and the next fault opens a new one.
    Inverse(52000U), Cycle(52001U), Signals(0U, kOrderBit), Signalled(1U), Inverse(102000U), Cycle(102001U),
    Signals(0U, 0U),
    Inverse(102002U), Cycle(102002U), Signals(0U, kOrderBit),
};

// Another cause is signalled in the same window; the window is that of the first.
constexpr Step kOtherCause[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Short(20000U), Cycle(21000U), Signals(0U, kLengthBit),
    Inverse(22000U), Short(22001U),
    Cycle(23000U), Signals(0U, 0U), Inverse(52000U), Short(52001U), Cycle(52002U), Signals(0U, kOrderBit | kLengthBit),
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

// One whole round of the counter later the window is not open again.
// t     2000 (window opens)   ... 2147 calls 2 s apart ...   4294002000   4294967296 + 3000 = 3000
constexpr Step kRound[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signals(0U, kOrderBit), Repeat(2147U, 2000000U),
    Signals(0U, 0U), Inverse(3000U),
    Cycle(3000U), Signals(0U, kOrderBit),
};

constexpr Step kBothSlots[] = {
    Configure(), Cycle(0U), Inverse(1000U), Cycle(2000U), Signalled(1U), Frame(0x104U, 4U, 0U, 0U, 2500U), Cycle(3000U),
    Signalled(2U),
    Signals(0U, 0U), Signals(1U, kOrderBit),
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

constexpr Case kCases[] = {
    MakeCase("SignalledOnceInAWindow", {req::SRS_CONS_021}, kGold, kOnce),
    MakeCase("EndOfTheSignalWindow", {req::SRS_CONS_021, req::SRS_TIME_004}, kGold, kOnWindowEnd),
    MakeCase("OtherCauseInTheSameWindow", {req::SRS_CONS_021}, kGold, kOtherCause),
    MakeCase("SameCauseTwiceInOneCall", {req::SRS_CONS_021, req::SRS_CONS_020}, kGold, kTwiceInOneCall),
    MakeCase("SignalsAreThoseOfTheLastCall", {req::SRS_CONS_021}, kGold, kByTheCycle),
    MakeCase("SignalWindowAfterARoundOfTheCounter", {req::SRS_CONS_021, req::SRS_TIME_001}, kGold, kRound),
    MakeCase("EachSlotHasItsWindow", {req::SRS_CONS_021}, kTwo, kBothSlots),
    MakeCase("WaitingPastSct", {req::SRS_CONS_022, req::SRS_TIME_004}, kGold, kPastSct),
    MakeCase("WaitingPastSctAfterReentering", {req::SRS_CONS_022, req::SRS_CONS_019}, kGold, kPastSctAgain),
    MakeCase("NotWaitingAfterAPair", {req::SRS_CONS_022}, kGoldLocked, kPairEnds),
    MakeCase("HalfAPairIsStillWaiting", {req::SRS_CONS_022}, kGold, kHalfPairDoesNot),
    MakeCase("NotWaitingAfterAFault", {req::SRS_CONS_022}, kGold, kFaultEnds),
    MakeCase("NotWaitingAfterDemote", {req::SRS_CONS_022, req::SRS_REL_006}, kGold, kDemoteEnds),
    MakeCase("WaitingPastSctAfterARoundOfTheCounter", {req::SRS_CONS_022, req::SRS_TIME_001}, kGold, kPastSctRound),
};
// clang-format on
} // namespace

const CaseTable kSignalCases = MakeTable("signal", kCases);

} // namespace counterpoint::conformance
