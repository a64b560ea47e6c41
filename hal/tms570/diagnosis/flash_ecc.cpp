// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/diagnosis/ecc.hpp"

#include "hal/tms570/diagnosis/esm.hpp"
#include "hal/tms570/probe.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace flash;

void Corrupt(const std::uint32_t bits) noexcept
{
    Write(At(kBase, kDiagnosisControl), kDiagnosisOn);
    Write(At(kBase, kParityOverride), bits);
    Write(At(kBase, kDiagnosisControl), kDiagnosisOn | kDiagnosisTrigger);
}

[[nodiscard]] bool IsOneBitSeen() noexcept
{
    Corrupt(kOneBit);
    Touch(kMirror);
    Write(At(kBase, kDiagnosisControl), kDiagnosisOff);
    const bool is_flagged = (Read(At(kBase, kErrorStatus)) & kCorrected) != 0U;
    const bool is_reported = (ReadEsm().group_1_low & kEsmFlashCorrected) != 0U;
    Write(At(kBase, kErrorStatus), kCorrected);
    ClearEsm(EsmStatus{kEsmFlashCorrected, 0U, 0U, 0U});
    return is_flagged && is_reported;
}

[[nodiscard]] bool AreTwoBitsSeen() noexcept
{
    ArmProbe(ProbeKind::kFlash, kMirrorNext);
    Corrupt(kTwoBits);
    static_cast<void>(Probe(kMirrorNext));
    Write(At(kBase, kDiagnosisControl), kDiagnosisOff);
    ArmProbe(ProbeKind::kInvalid, kMirrorNext);
    const bool is_flagged = (Read(At(kBase, kErrorStatus)) & kUncorrected) != 0U;
    const bool is_reported = (ReadEsm().group_3 & kEsm3Flash) != 0U;
    Touch(At(kBase, kUncorrectedAddress));
    Write(At(kBase, kErrorStatus), kUncorrected);
    ClearEsm(EsmStatus{0U, 0U, 0U, kEsm3Flash});
    ReleaseErrorPin();
    return is_flagged && is_reported;
}

} // namespace

Outcome TestFlashEcc() noexcept
{
    const Outcome on = WriteChecked(At(kBase, kErrorControl), kErrorsOn, kWholeWord);
    const bool one = IsOneBitSeen();
    const bool two = AreTwoBitsSeen();
    const bool is_off = Read(At(kBase, kDiagnosisControl)) == kDiagnosisOff;
    const bool is_quiet = (Read(At(kBase, kErrorStatus)) & (kCorrected | kUncorrected)) == 0U;
    return (one && two && is_off && is_quiet) ? on : Outcome::kFailed;
}

} // namespace counterpoint::tms570
