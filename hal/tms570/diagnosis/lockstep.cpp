// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/diagnosis/lockstep.hpp"

#include "hal/tms570/diagnosis/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace ccm;

/// The self test takes 4947 cycles of the processor (match and mismatch patterns); a look takes some of them.
constexpr Looks kSelfTestLooks{20000U};
constexpr Looks kForceLooks{256U};

[[nodiscard]] Outcome SelfTest(const Comparator& comparator) noexcept
{
    Write(At(kBase, comparator.key), kKeySelfTest);
    const Outcome done = WaitFor(At(kBase, comparator.status), Bits{kSelfTestDone, kSelfTestDone}, kSelfTestLooks);
    const bool has_failed = (Read(At(kBase, comparator.status)) & kSelfTestError) != 0U;
    const bool is_reported = (ReadEsm().group_1_low & kEsmLockstepSelfTest) != 0U;
    return (has_failed || is_reported) ? Outcome::kFailed : done;
}

/// The hardware forces one error and goes back to lockstep by itself. A compare error raises the flag of the self test
/// as well, which must not be taken for that of the next test.
[[nodiscard]] Outcome ForceError(const Comparator& comparator) noexcept
{
    Write(At(kBase, comparator.key), kKeyForceError);
    const Outcome back = WaitFor(At(kBase, comparator.key), Bits{kWholeWord, kKeyLockstep}, kForceLooks);
    const bool is_reported = (ReadEsm().group_2 & comparator.esm_2) != 0U;
    ClearEsm(EsmStatus{kEsmLockstepSelfTest, 0U, comparator.esm_2, 0U});
    Write(At(kBase, comparator.status), kCompareError);
    ReleaseErrorPin();
    return is_reported ? back : Outcome::kFailed;
}

[[nodiscard]] Outcome ForceSelfTestError(const Comparator& comparator) noexcept
{
    Write(At(kBase, comparator.key), kKeyForceSelfTestError);
    const Outcome back = WaitFor(At(kBase, comparator.key), Bits{kWholeWord, kKeyLockstep}, kForceLooks);
    const bool is_reported = (ReadEsm().group_1_low & kEsmLockstepSelfTest) != 0U;
    ClearEsm(EsmStatus{kEsmLockstepSelfTest, 0U, 0U, 0U});
    return is_reported ? back : Outcome::kFailed;
}

[[nodiscard]] Outcome ExamineOne(const Comparator& comparator) noexcept
{
    const bool is_lockstep = Read(At(kBase, comparator.key)) == kKeyLockstep;
    const bool is_equal = (Read(At(kBase, comparator.status)) & kCompareError) == 0U;
    return (is_lockstep && is_equal) ? Outcome::kDone : Outcome::kFailed;
}

[[nodiscard]] Outcome TestOne(const Comparator& comparator) noexcept
{
    Outcome outcome = SelfTest(comparator);
    outcome = Both(outcome, (outcome == Outcome::kDone) ? ForceError(comparator) : Outcome::kFailed);
    outcome = Both(outcome, (outcome == Outcome::kDone) ? ForceSelfTestError(comparator) : Outcome::kFailed);
    Write(At(kBase, comparator.key), kKeyLockstep);
    return Both(outcome, ExamineOne(comparator));
}

[[nodiscard]] Outcome IsCountRight(const std::uint8_t comparators) noexcept
{
    const bool is_right = (comparators != 0U) && (comparators <= kMostComparators);
    return is_right ? Outcome::kDone : Outcome::kFailed;
}

} // namespace

Outcome Lockstep::Test(const std::uint8_t comparators) noexcept
{
    Outcome outcome = IsCountRight(comparators);
    for (std::uint32_t number = 0U; (number < kMostComparators) && (number < comparators); ++number)
    {
        outcome = Both(outcome, (outcome == Outcome::kDone) ? TestOne(kComparators[number]) : Outcome::kFailed);
    }
    return outcome;
}

Outcome Lockstep::Examine(const std::uint8_t comparators) noexcept
{
    Outcome outcome = IsCountRight(comparators);
    for (std::uint32_t number = 0U; (number < kMostComparators) && (number < comparators); ++number)
    {
        outcome = Both(outcome, ExamineOne(kComparators[number]));
    }
    return outcome;
}

} // namespace counterpoint::tms570
