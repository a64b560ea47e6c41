// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/ccm_model.hpp"

#include "hal/tms570/diagnosis/lockstep.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace ccm;

constexpr std::uint32_t kSelfTestChannel = 31U;

/// Offsets and channel as the manual has them, not as the driver has.
struct Wires
{
    std::uint32_t status;
    std::uint32_t key;
    std::uint32_t channel;
    std::uint64_t test_ns;
};

/// 4947 cycles of 160 MHz; 151 of 75 MHz; some 10 of 150 MHz.
constexpr Wires kWires[] = {
    {0x00U, 0x04U, 2U, 30'919U}, {0x08U, 0x0CU, 25U, 2'014U}, {0x10U, 0x14U, 26U, 60U}, {0x1CU, 0x20U, 28U, 60U}};

} // namespace

CcmModel::CcmModel(const FaultSet& faults, EsmModel& esm, const std::uint32_t comparators)
    : Peripheral(faults), esm_(esm), comparators_(comparators)
{
}

bool CcmModel::IsFaulty(const std::uint32_t comparator, const Fault fault) const
{
    return (comparator == faulty) && Has(fault);
}

/// On both paths to the error signalling: its own channel and that of the self test.
void CcmModel::Differ(const std::uint32_t comparator)
{
    Kept(kWires[comparator].status) |= kCompareError;
    esm_.Raise(2U, kWires[comparator].channel);
    esm_.Raise(1U, kSelfTestChannel);
}

std::uint32_t CcmModel::Read(const std::uint32_t offset)
{
    for (std::uint32_t number = 0U; number < comparators_; ++number)
    {
        if ((offset == kWires[number].key) && IsFaulty(number, Fault::kCcmNotLockstep))
        {
            return kKeySelfTest;
        }
    }
    return Kept(offset);
}

void CcmModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    for (std::uint32_t number = 0U; number < comparators_; ++number)
    {
        if (offset == kWires[number].status)
        {
            Kept(offset) &= ~(value & kCompareError);
        }
        if (offset == kWires[number].key)
        {
            WriteKey(number, value);
        }
    }
}

void CcmModel::WriteKey(const std::uint32_t comparator, const std::uint32_t value)
{
    const Wires& wires = kWires[comparator];
    Kept(wires.key) = value;
    switch (value)
    {
    case kKeySelfTest:
        Kept(wires.status) &= ~(kSelfTestDone | kSelfTestError);
        test_left_ns_[comparator] = wires.test_ns;
        break;
    case kKeyForceError:
        Kept(wires.key) = kKeyLockstep;
        if (!IsFaulty(comparator, Fault::kCcmForcedErrorUnseen))
        {
            Differ(comparator);
        }
        break;
    case kKeyForceSelfTestError:
        Kept(wires.key) = kKeyLockstep;
        if (!IsFaulty(comparator, Fault::kCcmSelfTestErrorUnseen))
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
    for (std::uint32_t number = 0U; number < comparators_; ++number)
    {
        std::uint64_t& left = test_left_ns_[number];
        if ((left == 0U) || IsFaulty(number, Fault::kCcmSelfTestEndless))
        {
            continue;
        }
        left -= (ns < left) ? ns : left;
        if (left == 0U)
        {
            const bool has_failed = IsFaulty(number, Fault::kCcmSelfTestFails);
            Kept(kWires[number].status) |= kSelfTestDone | (has_failed ? kSelfTestError : 0U);
            if (has_failed)
            {
                esm_.Raise(1U, kSelfTestChannel);
            }
        }
    }
}

} // namespace counterpoint::tms570::model
