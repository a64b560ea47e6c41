// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Which frames count, and what makes a pair. Times in microseconds; SCT 50 ms, SRVT 20 ms.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
// t     0      1000   2000   3000   4000
//       enter  N      I      cycle  cycle
constexpr Step kPair[] = {
    Configure(), Cycle(0U), Masks(0U, 0U, 1U, 0U, 0U), Counts(1U, 0U, 0U, 0U), Guard(GuardView::kConfigured),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Normal(1000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U),
    Inverse(2000U), Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U), Data(0U, 0x3412U),
    Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Slot(0U, kReleased, kNoCause, 1U, 0U, 1U), OrdinalSum(1U),
    Cycle(4000U), Masks(1U, 0U, 0U, 0U, 0U), Data(0U, 0x3412U), Signalled(0U),
};

constexpr Step kNewestPair[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), OtherNormal(3000U), Data(0U, 0x3412U), OtherInverse(4000U),
    Slot(0U, kWaiting, kNoCause, 2U, 0U, 1U), Data(0U, 0x7856U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 1U),
    OrdinalSum(2U),
    Normal(6000U), Inverse(7000U), Slot(0U, kReleased, kNoCause, 3U, 0U, 1U), Cycle(8000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kOtherKinds[] = {
    Configure(), Cycle(0U),
    OfKind(Normal(1000U), FrameKind::kRemote), OfKind(Inverse(1001U), FrameKind::kRemote),
    OfKind(Normal(1002U), FrameKind::kExtended), OfKind(Inverse(1003U), FrameKind::kExtended),
    OfKind(Normal(1004U), FrameKind::kExtendedRemote), OfKind(Inverse(1005U), FrameKind::kExtendedRemote),
    OfKind(Normal(1006U), FrameKind::kFlexibleDataRate), OfKind(Inverse(1007U), FrameKind::kFlexibleDataRate),
    OfKind(Normal(1008U), FrameKind::kInvalid), OfKind(Inverse(1009U), FrameKind::kInvalid),
    OfKind(Normal(1010U), static_cast<FrameKind>(0x3DU)), OfKind(Inverse(1011U), static_cast<FrameKind>(0x3DU)),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
    // Between the halves of a pair they do no harm either.
    Normal(3000U), OfKind(Normal(3001U), FrameKind::kRemote), OfKind(Inverse(3002U), FrameKind::kFlexibleDataRate),
    Inverse(4000U), Slot(0U, kWaiting, kNoCause, 1U, 0U, 1U), Cycle(5000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kOtherIdentifiers[] = {
    Configure(), Cycle(0U),
    Frame(0x110U, 2U, 0x3412U, 0U, 1000U), Frame(0x113U, 2U, 0x3412U, 0U, 1001U), Frame(0x101U, 2U, 0x3412U, 0U, 1002U),
    Frame(0x180U, 2U, 0x3412U, 0U, 1003U), Frame(0x100U, 1U, 0U, 0U, 1004U), Frame(0x181U, 1U, 0U, 0U, 1005U),
    Frame(0x000U, 2U, 0U, 0U, 1006U), Frame(0x7FFU, 8U, 0U, 0U, 1007U), Frame(0x911U, 2U, 0x3412U, 0U, 1008U),
    Frame(0x20000111U, 2U, 0x3412U, 0U, 1009U), Frame(0x80000112U, 2U, 0xCBEDU, 0U, 1010U),
    Frame(0x10111U, 1U, 0U, 0U, 1011U), Frame(0xFFFFFFFFU, 0U, 0U, 0U, 1012U),
    On(Frame(0x113U, 2U, 0U, 0U, 1013U), CanPortId::kSecond),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Cycle(2000U), Masks(0U, 0U, 1U, 0U, 0U),
};

constexpr Step kOwnFrames[] = {
    Configure(), Cycle(0U), Counts(1U, 1U, 1U, 0U), Frame(0x101U, 2U, 0x3412U, 0U, 1000U),
    Frame(0x102U, 1U, 0U, 0U, 1001U),
    Cycle(2000U), Slot(1U, kProducing, kNoCause, 0U, 0U, 0U), Masks(0U, 0U, 1U, 0U, 0U),
};

constexpr Step kNormalOnSecond[] = {
    Configure(), Cycle(0U), On(Normal(1000U), CanPortId::kSecond), Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U),
    Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U), Signals(0U, Bit(Cause::kIdentifier)),
};

constexpr Step kInverseOnSecond[] = {
    Configure(), Cycle(0U), Normal(1000U), On(Inverse(1500U), CanPortId::kSecond), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U),
    // The normal frame is gone with the fault.
    Inverse(2500U), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 2U, 0U),
};

constexpr Step kNoController[] = {
    Configure(), Cycle(0U), On(Normal(1000U), CanPortId::kInvalid), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U),
    On(Normal(1001U), static_cast<CanPortId>(3U)), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 2U, 0U),
};

constexpr Step kTwoControllers[] = {
    Configure(), Cycle(0U), Normal(1000U), On(Inverse(2000U), CanPortId::kSecond), Cycle(3000U),
    Masks(1U, 0U, 0U, 0U, 1U),
    Normal(4000U), Inverse(4500U), Cycle(5000U), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U),
    On(Normal(6000U), CanPortId::kSecond), Cycle(7000U), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 2U, 0U),
    Normal(8000U), On(Inverse(9000U), CanPortId::kSecond), Cycle(10000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kNormalLength[] = {
    Configure(), Cycle(0U), Frame(0x111U, 1U, 0x12U, 0U, 1000U), Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U),
    Frame(0x111U, 3U, 0x3412U, 0U, 1001U), Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U),
    Frame(0x111U, 0U, 0x3412U, 0U, 1002U), Slot(0U, kFaulted, Cause::kLength, 0U, 3U, 0U),
    Frame(0x111U, 8U, 0x3412U, 0U, 1003U), Slot(0U, kFaulted, Cause::kLength, 0U, 4U, 0U),
    Frame(0x111U, 9U, 0x3412U, 0U, 1004U), Slot(0U, kFaulted, Cause::kLength, 0U, 5U, 0U),
    Frame(0x111U, 255U, 0x3412U, 0U, 1005U), Slot(0U, kFaulted, Cause::kLength, 0U, 6U, 0U),
    Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kLength)),
    Normal(3000U), Inverse(3001U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U), Frame(0x111U, 1U, 0x12U, 0U, 5000U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 7U, 0U),
};

constexpr Step kInverseLength[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x112U, 1U, 0xEDU, 0U, 1001U), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U),
    Normal(3000U), Frame(0x112U, 3U, 0xFFCBEDU, 0U, 3001U), Cycle(4000U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U),
    Normal(5000U), Inverse(5001U), Cycle(6000U), Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kFullLength[] = {
    Configure(), Cycle(0U),
    Frame(0x17FU, 7U, 0x04030201U, 0x00070605U, 1000U), Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U),
    Frame(0x17FU, 9U, 0x04030201U, 0x08070605U, 1001U), Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U), Cycle(2000U),
    Frame(0x17FU, 8U, 0x04030201U, 0x08070605U, 3000U), Frame(0x180U, 8U, 0xFBFCFDFEU, 0xF7F8F9FAU, 3001U),
    Slot(0U, kFaulted, Cause::kLength, 1U, 2U, 1U), Data(0U, 0x04030201U, 0x08070605U), Cycle(4000U),
    Masks(1U, 0U, 0U, 0U, 1U),
};

constexpr Step kBytesBehind[] = {
    Configure(), Cycle(0U), Frame(0x111U, 2U, 0xFFFF3412U, 0x12345678U, 1000U),
    Frame(0x112U, 2U, 0xFFFFCBEDU, 0x9ABCDEF0U, 2000U),
    Data(0U, 0x3412U, 0U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// t     0      1000   2000   3000         4000
//       enter  N      N      cycle        I
constexpr Step kNormalTwice[] = {
    Configure(), Cycle(0U), Normal(1000U), Normal(2000U), Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 1U, 0U),
    Cycle(3000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kNormalTwice)),
    Inverse(4000U), Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 2U, 0U), Cycle(5000U),
    Signals(0U, Bit(Cause::kInverseFirst)),
};

// The same while a pair is held and released: N1 I1 released N2 N3 I3.
constexpr Step kNormalTwiceReleased[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Normal(4000U),
    OtherNormal(5000U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 1U, 0U), OtherInverse(6000U),
    Slot(0U, kFaulted, Cause::kNormalTwice, 0U, 2U, 0U), Cycle(7000U), Masks(0U, 1U, 0U, 1U, 0U),
};

constexpr Step kInverseFirst[] = {
    Configure(), Cycle(0U), Inverse(1000U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U), Cycle(2000U),
    Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kInverseFirst)),
};

constexpr Step kInverseTwice[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(2000U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Inverse(4000U),
    Cycle(5000U),
    Masks(0U, 1U, 0U, 1U, 0U), Slot(0U, kFaulted, Cause::kInverseFirst, 0U, 1U, 0U),
};

/// Every bit of the pair alone not inverted, then the near miss: all inverted.
constexpr Step kEveryBit[] = {
    Configure(), Cycle(0U),
    Normal(1000U), WrongInverse(0U, 1001U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
    Normal(1002U), WrongInverse(1U, 1003U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Normal(1004U), WrongInverse(2U, 1005U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
    Normal(1006U), WrongInverse(3U, 1007U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 4U, 0U),
    Normal(1008U), WrongInverse(4U, 1009U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 5U, 0U),
    Normal(1010U), WrongInverse(5U, 1011U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 6U, 0U),
    Normal(1012U), WrongInverse(6U, 1013U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 7U, 0U),
    Normal(1014U), WrongInverse(7U, 1015U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 8U, 0U),
    Normal(1016U), WrongInverse(8U, 1017U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 9U, 0U),
    Normal(1018U), WrongInverse(9U, 1019U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 10U, 0U),
    Normal(1020U), WrongInverse(10U, 1021U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 11U, 0U),
    Normal(1022U), WrongInverse(11U, 1023U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 12U, 0U),
    Normal(1024U), WrongInverse(12U, 1025U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 13U, 0U),
    Normal(1026U), WrongInverse(13U, 1027U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 14U, 0U),
    Normal(1028U), WrongInverse(14U, 1029U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 15U, 0U),
    Normal(1030U), WrongInverse(15U, 1031U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 16U, 0U),
    Cycle(2000U), Masks(0U, 1U, 0U, 1U, 0U), Signals(0U, Bit(Cause::kNotInverse)),
    Normal(3000U), Inverse(3001U), Cycle(4000U), Masks(1U, 0U, 0U, 0U, 1U),
};

/// The inverse frame repeats the normal frame: nothing is inverted.
constexpr Step kNothingInverted[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x112U, 2U, 0x3412U, 0U, 2000U), Cycle(3000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
};

constexpr Step kEveryByte[] = {
    Configure(), Cycle(0U),
    Frame(0x17FU, 8U, 0U, 0U, 1000U), Frame(0x180U, 8U, 0xFFFFFF7FU, 0xFFFFFFFFU, 1001U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1002U), Frame(0x180U, 8U, 0xFFFFFEFFU, 0xFFFFFFFFU, 1003U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1004U), Frame(0x180U, 8U, 0xFF7FFFFFU, 0xFFFFFFFFU, 1005U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1006U), Frame(0x180U, 8U, 0xFEFFFFFFU, 0xFFFFFFFFU, 1007U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 4U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1008U), Frame(0x180U, 8U, 0xFFFFFFFFU, 0xFFFFFFFEU, 1009U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 5U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1010U), Frame(0x180U, 8U, 0xFFFFFFFFU, 0xFFFF7FFFU, 1011U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 6U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1012U), Frame(0x180U, 8U, 0xFFFFFFFFU, 0xFFFEFFFFU, 1013U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 7U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1014U), Frame(0x180U, 8U, 0xFFFFFFFFU, 0x7FFFFFFFU, 1015U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 8U, 0U),
    Frame(0x17FU, 8U, 0U, 0U, 1016U), Frame(0x180U, 8U, 0xFFFFFFFFU, 0xFFFFFFFFU, 1017U),
    Slot(0U, kFaulted, Cause::kNotInverse, 1U, 8U, 1U),
};

// One frame wrong in several ways: the first rule in the order of the checks names the cause.
constexpr Step kControllerBeforeLength[] = {
    Configure(), Cycle(0U), On(Frame(0x111U, 1U, 0U, 0U, 1000U), CanPortId::kSecond), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U), Signals(0U, Bit(Cause::kIdentifier)),
};

constexpr Step kControllerBeforeOrder[] = {
    Configure(), Cycle(0U), On(Inverse(1000U), CanPortId::kSecond), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U),
};

constexpr Step kLengthBeforeOrder[] = {
    Configure(), Cycle(0U), Frame(0x112U, 1U, 0U, 0U, 1000U), Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U),
    Cycle(2000U),
    Normal(3000U), Frame(0x111U, 3U, 0U, 0U, 3001U), Cycle(4000U), Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U),
    Inverse(4001U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 3U, 0U), Signals(0U, Bit(Cause::kLength)),
};

constexpr Step kLengthBeforeInversion[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x112U, 8U, 0x3412U, 0U, 1001U), Cycle(2000U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U),
};

// t     0      1000   21001           22000
//       enter  N      I, SRVT over    cycle
constexpr Step kLimitBeforeOrder[] = {
    Configure(), Cycle(0U), Normal(1000U), Inverse(21001U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(22000U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kInverseFirst)), Masks(0U, 1U, 0U, 1U, 0U),
};

constexpr Step kLimitBeforeLength[] = {
    Configure(), Cycle(0U), Normal(1000U), Frame(0x112U, 1U, 0U, 0U, 21001U), Cycle(22000U),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U),
    Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kLength)),
};

// The second normal frame comes when the first is already too old: it is the first half of the next pair.
constexpr Step kNormalAfterSrvt[] = {
    Configure(), Cycle(0U), Normal(1000U), OtherNormal(21001U), Slot(0U, kFaulted, Cause::kSrvt, 0U, 1U, 0U),
    Cycle(22000U),
    Masks(0U, 1U, 0U, 1U, 0U), OtherInverse(23000U), Slot(0U, kFaulted, Cause::kSrvt, 1U, 1U, 1U), Data(0U, 0x7856U),
    Cycle(24000U), Masks(1U, 0U, 0U, 0U, 1U),
};

// SRVT, then SCT, each before the controller of the frame.
constexpr Step kLimitBeforeController[] = {
    Configure(), Cycle(0U), Normal(1000U), On(Inverse(21001U), CanPortId::kSecond),
    Slot(0U, kFaulted, Cause::kSrvt, 0U, 2U, 0U), Cycle(22000U), Signals(0U, Bit(Cause::kSrvt) | Bit(Cause::kIdentifier)),
    Normal(23000U), Inverse(23500U), Cycle(24000U), Masks(1U, 0U, 0U, 0U, 1U),
    On(OtherNormal(73001U), CanPortId::kSecond), Slot(0U, kFaulted, Cause::kSrvt, 0U, 4U, 0U), Cycle(74000U),
    Signals(0U, Bit(Cause::kSct) | Bit(Cause::kIdentifier)),
};

// The other way round: normal frames on the second controller, inverse ones on the first.
constexpr Step kSwappedControllers[] = {
    Alter(Parameter::kNormalPort, static_cast<std::uint32_t>(CanPortId::kSecond)), Configure(), Cycle(0U),
    On(Normal(1000U), CanPortId::kSecond), Inverse(2000U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Normal(4000U),
    Slot(0U, kFaulted, Cause::kIdentifier, 0U, 1U, 0U), Cycle(5000U), On(Normal(6000U), CanPortId::kSecond),
    On(Inverse(6500U), CanPortId::kSecond), Slot(0U, kFaulted, Cause::kIdentifier, 0U, 2U, 0U), Cycle(7000U),
    Signals(0U, Bit(Cause::kIdentifier)),
};

constexpr Case kCases[] = {
    MakeCase("PairIsTakenAndReleased", {req::SRS_CONS_006, req::SRS_CONS_010, req::SRS_CONS_001, req::SRS_REL_003,
             req::SRS_CONS_023}, kGold, kPair),
    MakeCase("NewestPairIsHeld", {req::SRS_CONS_010, req::SRS_CONS_023}, kGold, kNewestPair),
    MakeCase("OtherKindsOfFrameNeverCount", {req::SRS_CONS_001}, kGold, kOtherKinds),
    MakeCase("OtherIdentifiersNeverCount", {req::SRS_CONS_001}, kGold, kOtherIdentifiers),
    MakeCase("OwnFramesAreNotConsumed", {req::SRS_CONS_001, req::SRS_CONS_023}, kMixed, kOwnFrames),
    MakeCase("NormalFrameOnOtherController", {req::SRS_CONS_004, req::SRS_CONS_012}, kGold, kNormalOnSecond),
    MakeCase("InverseFrameOnOtherController", {req::SRS_CONS_004, req::SRS_CONS_012}, kGold, kInverseOnSecond),
    MakeCase("FrameOnUnknownController", {req::SRS_CONS_004}, kGold, kNoController),
    MakeCase("HalvesOnTwoControllers", {req::SRS_CONS_004}, kGoldPorts, kTwoControllers),
    MakeCase("LengthOfNormalFrame", {req::SRS_CONS_005, req::SRS_CONS_012}, kGold, kNormalLength),
    MakeCase("LengthOfInverseFrame", {req::SRS_CONS_005}, kGold, kInverseLength),
    MakeCase("LengthOfEightBytes", {req::SRS_CONS_005}, kWide, kFullLength),
    MakeCase("BytesBehindTheLengthMeanNothing", {req::SRS_CONS_009, req::SRS_CONS_010}, kGold, kBytesBehind),
    MakeCase("SecondNormalFrame", {req::SRS_CONS_007, req::SRS_CONS_012}, kGold, kNormalTwice),
    MakeCase("SecondNormalFrameWhileReleased", {req::SRS_CONS_007, req::SRS_CONS_012}, kGold, kNormalTwiceReleased),
    MakeCase("InverseFrameFirst", {req::SRS_CONS_008}, kGold, kInverseFirst),
    MakeCase("InverseFrameAfterTheWholePair", {req::SRS_CONS_008}, kGold, kInverseTwice),
    MakeCase("EverySingleBitNotInverted", {req::SRS_CONS_009, req::SRS_CONS_013}, kGold, kEveryBit),
    MakeCase("NoBitInverted", {req::SRS_CONS_009}, kGold, kNothingInverted),
    MakeCase("EveryByteOfEightNotInverted", {req::SRS_CONS_009}, kWide, kEveryByte),
    MakeCase("ControllerIsCheckedBeforeLength", {req::SRS_CONS_011}, kGold, kControllerBeforeLength),
    MakeCase("ControllerIsCheckedBeforeOrder", {req::SRS_CONS_011}, kGold, kControllerBeforeOrder),
    MakeCase("LengthIsCheckedBeforeOrder", {req::SRS_CONS_011}, kGold, kLengthBeforeOrder),
    MakeCase("LengthIsCheckedBeforeInversion", {req::SRS_CONS_011}, kGold, kLengthBeforeInversion),
    MakeCase("LimitIsCheckedBeforeOrder", {req::SRS_CONS_011, req::SRS_CONS_003, req::SRS_CONS_012}, kGold,
             kLimitBeforeOrder),
    MakeCase("LimitIsCheckedBeforeLength", {req::SRS_CONS_011, req::SRS_CONS_003}, kGold, kLimitBeforeLength),
    MakeCase("NormalFrameAfterSrvtStartsTheNextPair", {req::SRS_CONS_012, req::SRS_CONS_003}, kGold, kNormalAfterSrvt),
    MakeCase("LimitIsCheckedBeforeController", {req::SRS_CONS_011, req::SRS_CONS_003}, kGold, kLimitBeforeController),
    MakeCase("NormalFramesOnTheSecondController", {req::SRS_CONS_004}, kGold, kSwappedControllers),
};
// clang-format on
} // namespace

const CaseTable kFrameCases = MakeTable("frame", kCases);

} // namespace counterpoint::conformance
