// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/tms570/lockstep.hpp"

#include "hal/tms570/esm.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace ccm;

/// The self test takes 4947 cycles of the processor (match and mismatch patterns); a look takes some of them.
constexpr Looks kSelfTestLooks{20000U};
constexpr Looks kForceLooks{256U};

[[nodiscard]] Outcome SelfTest() noexcept
{
    Write(At(kBase, kKey), kKeySelfTest);
    const Outcome done = WaitFor(At(kBase, kStatus), Bits{kSelfTestDone, kSelfTestDone}, kSelfTestLooks);
    const bool has_failed = (Read(At(kBase, kStatus)) & kSelfTestError) != 0U;
    const bool is_reported = (ReadEsm().group_1_low & kEsmLockstepSelfTest) != 0U;
    return (has_failed || is_reported) ? Outcome::kFailed : done;
}

/// The hardware forces one error and goes back to lockstep by itself.
[[nodiscard]] Outcome ForceError() noexcept
{
    Write(At(kBase, kKey), kKeyForceError);
    const Outcome back = WaitFor(At(kBase, kKey), Bits{kWholeWord, kKeyLockstep}, kForceLooks);
    const bool is_reported = (ReadEsm().group_2 & kEsm2Lockstep) != 0U;
    ClearEsm(EsmStatus{0U, 0U, kEsm2Lockstep, 0U});
    Write(At(kBase, kStatus), kCompareError);
    ReleaseErrorPin();
    return is_reported ? back : Outcome::kFailed;
}

[[nodiscard]] Outcome ForceSelfTestError() noexcept
{
    Write(At(kBase, kKey), kKeyForceSelfTestError);
    const Outcome back = WaitFor(At(kBase, kKey), Bits{kWholeWord, kKeyLockstep}, kForceLooks);
    const bool is_reported = (ReadEsm().group_1_low & kEsmLockstepSelfTest) != 0U;
    ClearEsm(EsmStatus{kEsmLockstepSelfTest, 0U, 0U, 0U});
    return is_reported ? back : Outcome::kFailed;
}

} // namespace

Outcome Lockstep::Test() noexcept
{
    Outcome outcome = SelfTest();
    outcome = Both(outcome, (outcome == Outcome::kDone) ? ForceError() : Outcome::kFailed);
    outcome = Both(outcome, (outcome == Outcome::kDone) ? ForceSelfTestError() : Outcome::kFailed);
    Write(At(kBase, kKey), kKeyLockstep);
    return Both(outcome, Examine());
}

Outcome Lockstep::Examine() noexcept
{
    const bool is_lockstep = Read(At(kBase, kKey)) == kKeyLockstep;
    const bool is_equal = (Read(At(kBase, kStatus)) & kCompareError) == 0U;
    return (is_lockstep && is_equal) ? Outcome::kDone : Outcome::kFailed;
}

} // namespace counterpoint::tms570
