// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Permits: literal answers of ((challenge + lower half) XOR (upper half rotated left by 16)) * constant. Times in
// microseconds.
#include "verification/conformance/gold.hpp"
#include "verification/trace/ids/channel.hpp"

namespace counterpoint::conformance
{

namespace
{
// clang-format off: a line is a moment, a step stands beside what it must lead to.
constexpr Step kNothing[] = {
    Answer(0x00000001U, 0U, 0x9E3779B1U, 0x85EBCA77U), Configure(), Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U),
    Cycle(0U),
    Answer(0xFFFFFFFFU, 0U, 0x61C8864FU, 0x7A143589U), Commit(1U, 1U),
    Answer(0x00000001U, 0U, 0x9E3779B1U, 0x85EBCA77U),
};

constexpr Step kOne[] = {
    Configure(), Cycle(0U), Normal(100U), Inverse(200U), Cycle(1000U),
    // Released, but not written yet: no permit.
    Answer(0x12345678U, 0U, 0xF6D680F8U, 0x7AB6E1C8U), Commit(1U, 1U),
    Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
    // The sum wraps; the same challenge gives the same answer.
    Answer(0xFFFFFFFFU, 1U, 0U, 0U), Answer(0x12345678U, 1U, 0x950DFAA9U, 0x00A2AC3FU),
};

// t     0      100  200   1000
// slot 31, 32, 63 and 0 hold pairs
constexpr Step Pair(std::uint32_t slot, std::uint32_t stamp)
{
    return Frame(0x101U + (2U * slot), 8U, slot, 0x01020304U, stamp);
}

constexpr Step Complement(std::uint32_t slot, std::uint32_t stamp)
{
    return Frame(0x102U + (2U * slot), 8U, 0xFFFFFFFFU ^ slot, 0xFEFDFCFBU, stamp);
}

constexpr Step kUpperHalf[] = {
    Configure(), Cycle(0U), Pair(0U, 100U), Complement(0U, 101U), Pair(31U, 102U), Complement(31U, 103U),
    Pair(32U, 104U), Complement(32U, 105U),
    Pair(63U, 106U), Complement(63U, 107U), Cycle(1000U), Mask(MaskName::kReleased, 0x8000000180000001U),
    Commit(0x8000000000000000U, 0x8000000000000000U),
    Answer(0x00000005U, 0x8000000000000000U, 0xD3EDE075U, 0x82D67453U),
    Commit(0x0000000100000000U, 0x0000000100000000U),
    Answer(0x00000005U, 0x0000000100000000U, 0x90C66075U, 0x6811F453U),
    Commit(0x0000000080000000U, 0x0000000080000000U),
    Answer(0x00001000U, 0x0000000080000000U, 0xF79B1000U, 0x3CA77000U), NormalObject(0x701FU, 1U, 31U),
    InverseObject(0x701FU, 4U, 0xFEFDFCFBU),
    NormalObject(0x703FU, 1U, 0x04030201U), InverseObject(0x703FU, 4U, 0xF7F8F9FAU),
};

constexpr Case kCases[] = {
    MakeCase("PermitOfNothing", {req::SRS_REL_010}, kGold, kNothing),
    MakeCase("PermitOfACommittedSlot", {req::SRS_REL_010}, kGold, kOne),
    MakeCase("PermitOfTheUpperHalf", {req::SRS_REL_010, req::SRS_REL_002}, kSixtyFour, kUpperHalf),
};
// clang-format on
} // namespace

const CaseTable kPermitCases = MakeTable("permit", kCases);

} // namespace counterpoint::conformance
