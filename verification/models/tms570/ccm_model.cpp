// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/ccm_model.hpp"

#include "hal/tms570/lockstep.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace ccm;

constexpr std::uint32_t kCompareChannel = 2U;
constexpr std::uint32_t kSelfTestChannel = 31U;
/// 4947 cycles of 160 MHz.
constexpr std::uint64_t kTestNs = 30'919U;

} // namespace

CcmModel::CcmModel(const FaultSet& faults, EsmModel& esm) : Peripheral(faults), esm_(esm)
{
}

void CcmModel::Differ()
{
    Kept(kStatus) |= kCompareError;
    esm_.Raise(2U, kCompareChannel);
}

std::uint32_t CcmModel::Read(const std::uint32_t offset)
{
    if ((offset == kKey) && Has(Fault::kCcmNotLockstep))
    {
        return kKeySelfTest;
    }
    return Kept(offset);
}

void CcmModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (offset == kStatus)
    {
        Kept(kStatus) &= ~(value & kCompareError);
        return;
    }
    Kept(kKey) = value;
    switch (value)
    {
    case kKeySelfTest:
        Kept(kStatus) &= ~(kSelfTestDone | kSelfTestError);
        test_left_ns_ = kTestNs;
        break;
    case kKeyForceError:
        Kept(kKey) = kKeyLockstep;
        if (!Has(Fault::kCcmForcedErrorUnseen))
        {
            Differ();
        }
        break;
    case kKeyForceSelfTestError:
        Kept(kKey) = kKeyLockstep;
        if (!Has(Fault::kCcmSelfTestErrorUnseen))
        {
            esm_.Raise(1U, kSelfTestChannel);
        }
        break;
    default:
        break;
    }
}

void CcmModel::Advance(const std::uint64_t ns)
{
    if ((test_left_ns_ == 0U) || Has(Fault::kCcmSelfTestEndless))
    {
        return;
    }
    test_left_ns_ -= (ns < test_left_ns_) ? ns : test_left_ns_;
    if (test_left_ns_ == 0U)
    {
        const bool has_failed = Has(Fault::kCcmSelfTestFails);
        Kept(kStatus) |= kSelfTestDone | (has_failed ? kSelfTestError : 0U);
        if (has_failed)
        {
            esm_.Raise(1U, kSelfTestChannel);
        }
    }
}

} // namespace counterpoint::tms570::model
