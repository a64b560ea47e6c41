// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/diagnosis/ecc.hpp"

#include "hal/tms570/chip/processor.hpp"
#include "hal/tms570/diagnosis/esm.hpp"
#include "hal/tms570/probe.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace tcram;

constexpr std::uint32_t kOneBitFlip = 1U;
constexpr std::uint32_t kTwoBitFlip = 3U;
constexpr std::uint32_t kDoubleWord = 8U;
constexpr std::uint32_t kPattern = 0x5AA53CC3U;

struct Bank
{
    RegisterBase module;
    std::uint32_t corrected;     ///< Channel of group 1.
    std::uint32_t uncorrected;   ///< Channel of group 2.
    std::uint32_t uncorrected_3; ///< Channel of group 3.
    ProbeKind kind;
};

constexpr Bank kEven{kEvenBank, kEsmEvenRamCorrected, kEsm2EvenRam, kEsm3EvenRam, ProbeKind::kEvenRam};
constexpr Bank kOdd{kOddBank, kEsmOddRamCorrected, kEsm2OddRam, kEsm3OddRam, ProbeKind::kOddRam};

/// While the processor does not look: the ECC of this word gets other bits than its data would give it.
void Flip(const Bank& bank, const Register word, const std::uint32_t bits) noexcept
{
    const Register ecc{word.address + kEccOffset};
    const std::uint32_t control = ReadProcessor(ProcessorRegister::kAuxiliaryControl);
    WriteProcessor(ProcessorRegister::kAuxiliaryControl, control & ~kProcessorChecks);
    Write(At(bank.module, kControl), kDetectAndWrite);
    Write(ecc, Read(ecc) ^ bits);
    Write(At(bank.module, kControl), kDetect);
    WriteProcessor(ProcessorRegister::kAuxiliaryControl, control | kProcessorChecks);
}

[[nodiscard]] bool IsOneBitSeen(const Bank& bank, const Register word) noexcept
{
    Write(word, kPattern);
    Flip(bank, word, kOneBitFlip);
    const bool is_right = Read(word) == kPattern;
    const bool is_flagged = (Read(At(bank.module, kErrorStatus)) & kCorrected) != 0U;
    const bool is_reported = (ReadEsm().group_1_low & bank.corrected) != 0U;
    Flip(bank, word, kOneBitFlip);
    Touch(At(bank.module, kCorrectedAddress));
    Write(At(bank.module, kErrorStatus), kCorrected);
    ClearEsm(EsmStatus{bank.corrected, 0U, 0U, 0U});
    return is_right && is_flagged && is_reported;
}

[[nodiscard]] bool AreTwoBitsSeen(const Bank& bank, const Register word) noexcept
{
    Write(word, kPattern);
    Flip(bank, word, kTwoBitFlip);
    ArmProbe(bank.kind, word);
    static_cast<void>(Probe(word));
    ArmProbe(ProbeKind::kInvalid, word);
    const bool is_flagged = (Read(At(bank.module, kErrorStatus)) & kUncorrected) != 0U;
    const bool is_reported = (ReadEsm().group_3 & bank.uncorrected_3) != 0U;
    Flip(bank, word, kTwoBitFlip);
    Touch(At(bank.module, kUncorrectedAddress));
    Write(At(bank.module, kErrorStatus), kUncorrected);
    ClearEsm(EsmStatus{0U, 0U, bank.uncorrected, bank.uncorrected_3});
    ReleaseErrorPin();
    return is_flagged && is_reported;
}

[[nodiscard]] bool IsBankGood(const Bank& bank, const Register word) noexcept
{
    Write(At(bank.module, kOccurrences), 0U);
    Write(At(bank.module, kThreshold), 1U);
    Write(At(bank.module, kInterrupt), 1U);
    const bool one = IsOneBitSeen(bank, word);
    const bool two = AreTwoBitsSeen(bank, word);
    // As it was, and without an error any more.
    const bool is_restored = Read(word) == kPattern;
    const bool is_quiet = (Read(At(bank.module, kErrorStatus)) & (kCorrected | kUncorrected)) == 0U;
    const bool is_on = Read(At(bank.module, kControl)) == kDetect;
    return one && two && is_restored && is_quiet && is_on;
}

} // namespace

Outcome TestRamEcc(const EccTestPlace place) noexcept
{
    if ((place.address % kEccTestBytes) != 0U)
    {
        return Outcome::kFailed;
    }
    const bool is_even_good = IsBankGood(kEven, Register{place.address});
    const bool is_odd_good = IsBankGood(kOdd, Register{place.address + kDoubleWord});
    const std::uint32_t control = ReadProcessor(ProcessorRegister::kAuxiliaryControl);
    const bool is_checked = (control & kProcessorChecks) == kProcessorChecks;
    return (is_even_good && is_odd_good && is_checked) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
