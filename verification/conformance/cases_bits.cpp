// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Objects of any length: where their bits lie, what is written above them, and the bits of a frame that nobody maps.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step Normal3(std::uint32_t data, std::uint32_t stamp)
{
    return Frame(0x111U, 1U, data, 0U, stamp);
}

constexpr Step Inverse3(std::uint32_t data, std::uint32_t stamp)
{
    return Frame(0x112U, 1U, data, 0U, stamp);
}

// Three bits: safe value 5h, then 3h. The bits of the object's byte above them become 0, whatever was there.
constexpr Step kThree[] = {
    Configure(), NormalObject(0x6302U, 3U, 0x05U), InverseObject(0x6303U, 3U, 0x02U), Cycle(0U), Normal3(0x03U, 1000U),
    Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Inverse3(0xFCU, 2000U), Data(0U, 0x03U), Cycle(3000U),
    Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U), NormalObject(0x6302U, 3U, 0x03U), InverseObject(0x6303U, 3U, 0x04U),
    Commit(0U, 1U), NormalObject(0x6302U, 3U, 0x05U), InverseObject(0x6303U, 3U, 0x02U),
};

// Bits above the length are not looked at; each of the three is.
constexpr Step kThreeExamined[] = {
    Configure(), Cycle(0U), Normal3(0x03U, 1000U), Inverse3(0xFCU, 2000U), Cycle(3000U), Commit(1U, 1U),
    Put(0x6302U, 3U, 0xFBU), Put(0x6303U, 3U, 0xFCU), Cycle(4000U), Examine(1U, 0U), Commit(1U, 1U),
    Put(0x6302U, 3U, 0x07U), Put(0x6303U, 3U, 0x00U), Cycle(5000U), Examine(1U, 1U), Commit(1U, 1U),
    Put(0x6302U, 3U, 0x01U), Put(0x6303U, 3U, 0x06U), Cycle(6000U), Examine(1U, 1U), Commit(1U, 1U),
    Put(0x6302U, 3U, 0x02U), Put(0x6303U, 3U, 0x05U), Cycle(7000U), Examine(1U, 1U), Commit(1U, 1U),
    Put(0x6302U, 3U, 0x0BU), Put(0x6303U, 3U, 0x84U), Cycle(8000U), Examine(1U, 0U), Commit(1U, 1U),
};

// Each bit above the length: 1 in the normal frame, with and without its inverse.
constexpr Step kAboveInNormal[] = {
    Configure(), Cycle(0U),
    Normal3(0x0BU, 1000U), Slot(0U, kWaiting, kNoCause, 0U, 0U, 0U), Inverse3(0xFCU, 1001U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U), Normal3(0x0BU, 1002U), Inverse3(0xF4U, 1003U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U), Normal3(0x13U, 1004U), Inverse3(0xFCU, 1005U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U), Normal3(0x13U, 1006U), Inverse3(0xECU, 1007U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 4U, 0U), Normal3(0x23U, 1008U), Inverse3(0xFCU, 1009U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 5U, 0U), Normal3(0x23U, 1010U), Inverse3(0xDCU, 1011U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 6U, 0U), Normal3(0x43U, 1012U), Inverse3(0xFCU, 1013U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 7U, 0U), Normal3(0x43U, 1014U), Inverse3(0xBCU, 1015U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 8U, 0U), Normal3(0x83U, 1016U), Inverse3(0xFCU, 1017U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 9U, 0U), Normal3(0x83U, 1018U), Inverse3(0x7CU, 1019U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 10U, 0U), Normal3(0x03U, 1020U), Inverse3(0xFCU, 1021U),
    Slot(0U, kFaulted, Cause::kNotInverse, 1U, 10U, 1U),
};

// 0 in the inverse frame alone.
constexpr Step kAboveInInverse[] = {
    Configure(), Cycle(0U),
    Normal3(0x03U, 1000U), Inverse3(0xF4U, 1001U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
    Normal3(0x03U, 1002U), Inverse3(0xECU, 1003U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Normal3(0x03U, 1004U), Inverse3(0xDCU, 1005U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
    Normal3(0x03U, 1006U), Inverse3(0xBCU, 1007U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 4U, 0U),
    Normal3(0x03U, 1008U), Inverse3(0x7CU, 1009U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 5U, 0U),
    Normal3(0x03U, 1010U), Inverse3(0x04U, 1011U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 6U, 0U),
    Normal3(0x03U, 1012U), Inverse3(0xFCU, 1013U), Slot(0U, kFaulted, Cause::kNotInverse, 1U, 6U, 1U),
};

// The mapped bits themselves.
constexpr Step kMappedBits[] = {
    Configure(), Cycle(0U),
    Normal3(0x03U, 1000U), Inverse3(0xFDU, 1001U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
    Normal3(0x03U, 1002U), Inverse3(0xFEU, 1003U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Normal3(0x03U, 1004U), Inverse3(0xF8U, 1005U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
    Normal3(0x00U, 1006U), Inverse3(0xFFU, 1007U), Slot(0U, kFaulted, Cause::kNotInverse, 1U, 3U, 1U), Data(0U, 0U),
    Normal3(0x07U, 1008U), Inverse3(0xF8U, 1009U), Slot(0U, kFaulted, Cause::kNotInverse, 2U, 3U, 1U), Data(0U, 7U),
};

// Three bits are one byte.
constexpr Step kLengthOfThree[] = {
    Configure(), Cycle(0U), Frame(0x111U, 0U, 0U, 0U, 1000U), Slot(0U, kFaulted, Cause::kLength, 0U, 1U, 0U),
    Frame(0x111U, 2U, 0x03U, 0U, 1001U), Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U), Normal3(0x03U, 1002U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 2U, 0U), Frame(0x112U, 2U, 0xFFFCU, 0U, 1003U),
    Slot(0U, kFaulted, Cause::kLength, 0U, 3U, 0U),
};

// 5h, ABCh, 1, 55h as 3, 12, 1 and 7 bits: 101b, then ABCh from bit 3 on, bit 15, 55h from bit 16 on; bit 23 is free.
constexpr Step kRow[] = {
    Configure(), NormalObject(0x6302U, 3U, 0x04U), NormalObject(0x6302U, 12U, 0xA7EU),
    NormalObject(0x6302U, 1U, 0x00U), NormalObject(0x6302U, 7U, 0x2DU),
    InverseObject(0x6303U, 3U, 0x03U), InverseObject(0x6303U, 12U, 0x581U),
    InverseObject(0x6303U, 1U, 0x01U), InverseObject(0x6303U, 7U, 0x52U),
    Cycle(0U), Frame(0x111U, 3U, 0x55D5E5U, 0U, 1000U), Frame(0x112U, 3U, 0xAA2A1AU, 0U, 2000U), Data(0U, 0x55D5E5U),
    Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U),
    NormalObject(0x6302U, 3U, 0x05U), NormalObject(0x6302U, 12U, 0x0ABCU), NormalObject(0x6302U, 1U, 0x01U),
    NormalObject(0x6302U, 7U, 0x55U), InverseObject(0x6303U, 3U, 0x02U), InverseObject(0x6303U, 12U, 0x0543U),
    InverseObject(0x6303U, 1U, 0x00U), InverseObject(0x6303U, 7U, 0x2AU),
    // Neighbours stay as they were.
    NormalObject(0x6302U, 4U, 0x66U), InverseObject(0x6303U, 2U, 0x66U), NormalObject(0x6302U, 9U, 0x6666U),
};

constexpr Step kRowAbove[] = {
    Configure(), Cycle(0U), Frame(0x111U, 3U, 0xD5D5E5U, 0U, 1000U), Frame(0x112U, 3U, 0x2A2A1AU, 0U, 2000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U), Frame(0x111U, 3U, 0x55D5E5U, 0U, 3000U),
    Frame(0x112U, 3U, 0x2A2A1AU, 0U, 4000U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Frame(0x111U, 3U, 0x55D5E5U, 0U, 5000U), Frame(0x112U, 3U, 0xEA2A1AU, 0U, 6000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U), Frame(0x111U, 3U, 0x55D5E5U, 0U, 7000U),
    Frame(0x112U, 3U, 0xAA2A1AU, 0U, 8000U), Slot(0U, kFaulted, Cause::kNotInverse, 1U, 3U, 1U),
};

// 64 + 64 objects of one bit: 9A3C5F01h, 8000C00Ah. Object n is bit n - 1.
constexpr Step kSixtyFour[] = {
    Configure(), NormalObject(0x6304U, 1U, 1U), NormalObject(0x6304U, 2U, 0U), NormalObject(0x6304U, 10U, 1U),
    NormalObject(0x6304U, 64U, 0U), InverseObject(0x6305U, 1U, 0U), InverseObject(0x6305U, 2U, 1U),
    InverseObject(0x6305U, 10U, 0U), InverseObject(0x6305U, 64U, 1U), Cycle(0U),
    Frame(0x111U, 8U, 0x9A3C5F01U, 0x8000C00AU, 1000U), Frame(0x112U, 8U, 0x65C3A0FEU, 0x7FFF3FF5U, 2000U),
    Data(0U, 0x9A3C5F01U, 0x8000C00AU), Cycle(3000U), Commit(1U, 1U),
    NormalObject(0x6304U, 1U, 1U), NormalObject(0x6304U, 2U, 0U), NormalObject(0x6304U, 8U, 0U),
    NormalObject(0x6304U, 9U, 1U), NormalObject(0x6304U, 13U, 1U), NormalObject(0x6304U, 14U, 0U),
    NormalObject(0x6304U, 19U, 1U), NormalObject(0x6304U, 32U, 1U), NormalObject(0x6304U, 33U, 0U),
    NormalObject(0x6304U, 34U, 1U), NormalObject(0x6304U, 36U, 1U), NormalObject(0x6304U, 47U, 1U),
    NormalObject(0x6304U, 63U, 0U), NormalObject(0x6304U, 64U, 1U), InverseObject(0x6305U, 1U, 0U),
    InverseObject(0x6305U, 2U, 1U), InverseObject(0x6305U, 9U, 0U), InverseObject(0x6305U, 32U, 0U),
    InverseObject(0x6305U, 33U, 1U), InverseObject(0x6305U, 34U, 0U), InverseObject(0x6305U, 63U, 1U),
    InverseObject(0x6305U, 64U, 0U),
};

constexpr Step kSixtyFourNotInverse[] = {
    Configure(), Cycle(0U), Frame(0x111U, 8U, 0x9A3C5F01U, 0x8000C00AU, 1000U),
    Frame(0x112U, 8U, 0x65C3A0FEU, 0xFFFF3FF5U, 2000U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U),
    Frame(0x111U, 8U, 0x9A3C5F01U, 0x8000C00AU, 3000U), Frame(0x112U, 8U, 0x65C3A0FFU, 0x7FFF3FF5U, 4000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U), Frame(0x111U, 7U, 0U, 0U, 5000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
};

// One object of 63 bits: bit 63 is free.
constexpr Step kSixtyThree[] = {
    Configure(), NormalObject(0x6302U, 63U, 0x04030201U, 0x78070605U),
    InverseObject(0x6303U, 63U, 0xFBFCFDFEU, 0x07F8F9FAU), Cycle(0U),
    Frame(0x111U, 8U, 0x89ABCDEFU, 0x41234567U, 1000U), Frame(0x112U, 8U, 0x76543210U, 0xBEDCBA98U, 2000U),
    Data(0U, 0x89ABCDEFU, 0x41234567U), Cycle(3000U), Masks(1U, 0U, 0U, 0U, 1U), Commit(1U, 1U),
    NormalObject(0x6302U, 63U, 0x89ABCDEFU, 0x41234567U), InverseObject(0x6303U, 63U, 0x76543210U, 0x3EDCBA98U),
    Frame(0x111U, 8U, 0x89ABCDEFU, 0xC1234567U, 4000U), Frame(0x112U, 8U, 0x76543210U, 0x3EDCBA98U, 5000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 1U, 0U), Frame(0x111U, 8U, 0x89ABCDEFU, 0x41234567U, 6000U),
    Frame(0x112U, 8U, 0x76543210U, 0x3EDCBA98U, 7000U), Slot(0U, kFaulted, Cause::kNotInverse, 0U, 2U, 0U),
    Frame(0x111U, 8U, 0x89ABCDEFU, 0x01234567U, 8000U), Frame(0x112U, 8U, 0x76543210U, 0xBEDCBA98U, 9000U),
    Slot(0U, kFaulted, Cause::kNotInverse, 0U, 3U, 0U),
};

// 33 bits over the border of the words, 31 behind them.
constexpr Step kSplit[] = {
    Configure(), NormalObject(0x6302U, 33U, 0x04030201U, 0x01U), NormalObject(0x6302U, 31U, 0x4038302U),
    InverseObject(0x6303U, 33U, 0xFBFCFDFEU, 0x00U), InverseObject(0x6303U, 31U, 0x7BFC7CFDU),
    Cycle(0U), Frame(0x111U, 8U, 0x89ABCDEFU, 0xC1234566U, 1000U), Frame(0x112U, 8U, 0x76543210U, 0x3EDCBA99U, 2000U),
    Data(0U, 0x89ABCDEFU, 0xC1234566U), Cycle(3000U), Commit(1U, 1U), NormalObject(0x6302U, 33U, 0x89ABCDEFU, 0x00U),
    NormalObject(0x6302U, 31U, 0x6091A2B3U), InverseObject(0x6303U, 33U, 0x76543210U, 0x01U),
    InverseObject(0x6303U, 31U, 0x1F6E5D4CU),
};

// A safe value with every bit above the mapped length set: none of them is written, nor looked for.
constexpr Step kSafeAbove[] = {
    Alter(Parameter::kSafeLow, 0xFFFFFFFDU), Alter(Parameter::kSafeHigh, 0xFFFFFFFFU), Configure(), NormalObject(0x6302U, 3U, 0x05U),
    InverseObject(0x6303U, 3U, 0x02U), Cycle(0U), Data(0U, 0U), Normal3(0x03U, 1000U), Inverse3(0xFCU, 2000U), Data(0U, 0x03U),
    Cycle(3000U), Commit(1U, 1U), NormalObject(0x6302U, 3U, 0x03U), Cycle(4000U), Commit(0U, 0U), NormalObject(0x6302U, 3U, 0x05U),
    InverseObject(0x6303U, 3U, 0x02U),
};

constexpr Case kCases[] = {
    MakeCase("BitsAreExamined", {req::SRS_REL_011}, kBits3, kThreeExamined),
    MakeCase("BitsOfThreeBitObjects", {req::SRS_CFG_036, req::SRS_REL_002, req::SRS_CONS_009}, kBits3, kThree),
    MakeCase("BitsAboveTheLengthInTheNormalFrame", {req::SRS_CONS_009, req::SRS_CFG_036}, kBits3, kAboveInNormal),
    MakeCase("BitsAboveTheLengthInTheInverseFrame", {req::SRS_CONS_009, req::SRS_CFG_036}, kBits3, kAboveInInverse),
    MakeCase("EachOfThreeMappedBits", {req::SRS_CONS_009}, kBits3, kMappedBits),
    MakeCase("LengthOfThreeBits", {req::SRS_CONS_005, req::SRS_CFG_036}, kBits3, kLengthOfThree),
    MakeCase("BitsAcrossBordersOfBytes", {req::SRS_CFG_036, req::SRS_REL_002}, kBitRow, kRow),
    MakeCase("BitAboveTwentyThree", {req::SRS_CONS_009, req::SRS_CFG_036}, kBitRow, kRowAbove),
    MakeCase("SixtyFourObjectsOfOneBit", {req::SRS_CFG_036, req::SRS_REL_002, req::SRS_CFG_003}, kBits64, kSixtyFour),
    MakeCase("SixtyFourBitsNotInverted", {req::SRS_CONS_009, req::SRS_CONS_005}, kBits64, kSixtyFourNotInverse),
    MakeCase("BitsOfSixtyThree", {req::SRS_CFG_036, req::SRS_CONS_009}, kBits63, kSixtyThree),
    MakeCase("BitsAcrossTheBorderOfTheWords", {req::SRS_CFG_036, req::SRS_REL_002}, kBitsSplit, kSplit),
    MakeCase("SafeValueAboveTheMappedLength", {req::SRS_CFG_036, req::SRS_REL_002, req::SRS_REL_340}, kBits3, kSafeAbove),
};
// clang-format on
} // namespace

const CaseTable kBitCases = MakeTable("bits", kCases);

} // namespace counterpoint::conformance
