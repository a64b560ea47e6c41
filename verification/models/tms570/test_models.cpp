// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/test_models.hpp"

#include "hal/tms570/chip/system_registers.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace system_module;

constexpr std::uint64_t kMemoryTestNs = 300'000U;

} // namespace

StcModel::StcModel(const FaultSet& faults, SystemModel& system) : Peripheral(faults), system_(system)
{
}

bool StcModel::OnSleep()
{
    if (Kept(kStcControl1) != kKeyOn)
    {
        return false;
    }
    Kept(kStcControl1) = kKeyOff;
    const bool is_check = Kept(kStcSelfCheck) == kStcFault;
    const bool has_failed = is_check ? !Has(Fault::kLbistCheckPasses) : Has(Fault::kLbistFails);
    const bool is_done = is_check || !Has(Fault::kLbistTimesOut);
    Kept(kStcStatus) = (is_done ? kStcDone : 0U) | (has_failed ? kStcFailed : 0U);
    system_.SetReset(kResetProcessor);
    return true;
}

std::uint32_t StcModel::Read(const std::uint32_t offset)
{
    return Kept(offset);
}

void StcModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if (offset == kStcStatus)
    {
        Kept(offset) &= ~value;
        return;
    }
    Kept(offset) = value;
}

PbistModel::PbistModel(const FaultSet& faults, SystemModel& system) : Peripheral(faults), system_(system)
{
}

void PbistModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    Kept(offset) = value;
    const bool is_program = (offset == kPbistRun) && (value == 1U);
    const bool is_rom = (offset == kPbistLogger) && (value == 0x14U);
    if (is_program || is_rom)
    {
        Kept(kPbistFail0) = 0U;
        left_ns_ = kMemoryTestNs;
        must_fail_ = is_program;
    }
}

void PbistModel::Advance(const std::uint64_t ns)
{
    if ((left_ns_ == 0U) || Has(Fault::kPbistEndless))
    {
        return;
    }
    left_ns_ -= (ns < left_ns_) ? ns : left_ns_;
    if (left_ns_ == 0U)
    {
        const bool has_failed = must_fail_ ? !Has(Fault::kPbistCheckPasses) : Has(Fault::kPbistFails);
        Kept(kPbistFail0) = has_failed ? 1U : 0U;
        system_.EndMemoryTest();
    }
}

} // namespace counterpoint::tms570::model
