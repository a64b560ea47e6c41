// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Level 2 RAM of an LC43x (reference manual SPNU563, chapter "Level 2 RAM (L2RAMW) Module", diagnostic test procedure):
// its own correction of writes below 64 bits is shown pairs of data and ECC, without a cell being touched.
#include "hal/tms570/diagnosis/ecc.hpp"

#include "hal/tms570/diagnosis/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace level_2_ram;

constexpr std::uint32_t kTestData = 0xAU;
constexpr std::uint32_t kEccOfTestData = 0x12U;
constexpr std::uint32_t kOneBitFlip = 1U;
constexpr std::uint32_t kTwoBitFlip = 3U;
/// The test is done in one cycle when the banks are free.
constexpr Looks kDoneLooks{64U};

/// What a pair with these bits flipped raises, of the diagnostic bits. The wait ends without an answer for a right
/// pair.
[[nodiscard]] std::uint32_t RaisedBy(const std::uint32_t flipped) noexcept
{
    Write(At(kBase, kErrorStatus), kAllDiagnosis);
    ClearEsm(EsmStatus{0U, 0U, kEsm2Level2Ram, 0U});
    Write(At(kBase, kDataHigh), 0U);
    Write(At(kBase, kDataLow), kTestData);
    Write(At(kBase, kEccVector), kEccOfTestData ^ flipped);
    Write(At(kBase, kTest), kEquality | kTestOn);
    Write(At(kBase, kTest), kEquality | kTestOn | kTrigger);
    static_cast<void>(WaitFor(At(kBase, kTest), Bits{kTrigger, 0U}, kDoneLooks));
    const std::uint32_t raised = Read(At(kBase, kErrorStatus)) & kAllDiagnosis;
    const bool is_reported = (ReadEsm().group_2 & kEsm2Level2Ram) != 0U;
    const bool is_alike = is_reported == (raised != 0U);
    Write(At(kBase, kTest), kTestOff);
    Write(At(kBase, kErrorStatus), kAllDiagnosis);
    ClearEsm(EsmStatus{0U, 0U, kEsm2Level2Ram, 0U});
    ReleaseErrorPin();
    return is_alike ? raised : kAllDiagnosis;
}

} // namespace

Outcome TestLevel2Ram() noexcept
{
    const Outcome on = WriteChecked(At(kBase, kControl), kDetect, kDetectMask);
    const bool is_right_pair_quiet = RaisedBy(0U) == 0U;
    const bool is_one_seen = RaisedBy(kOneBitFlip) == kOneBitErrors;
    const bool are_two_seen = RaisedBy(kTwoBitFlip) == kTwoBitErrors;
    const bool is_quiet = (Read(At(kBase, kErrorStatus)) & kAllDiagnosis) == 0U;
    const bool is_off = Read(At(kBase, kTest)) == kTestOff;
    return (is_right_pair_quiet && is_one_seen && are_two_seen && is_quiet && is_off) ? on : Outcome::kFailed;
}

} // namespace counterpoint::tms570
