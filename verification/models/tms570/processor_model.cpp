// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/processor_model.hpp"

#include "hal/tms570/diagnosis/ecc.hpp"
#include "hal/tms570/diagnosis/mpu_registers.hpp"

namespace counterpoint::tms570::model
{

namespace
{

constexpr std::uint32_t kAccessMask = 7U << 8U;

} // namespace

ProcessorModel::ProcessorModel(const FaultSet& faults, const std::uint32_t regions)
    : faults_(faults), region_count_(regions)
{
}

std::uint32_t ProcessorModel::Read(const ProcessorRegister which) const
{
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        return control_ & (faults_.Has(Fault::kMpuTurnedOff) ? ~mpu::kControlOn : 0xFFFFFFFFU);
    case ProcessorRegister::kAuxiliaryControl:
        return auxiliary_;
    case ProcessorRegister::kMpuType:
        return faults_.Has(Fault::kMpuWithoutRegions) ? 0U : (region_count_ << mpu::kTypeRegionsShift);
    case ProcessorRegister::kRegionNumber:
        return number_;
    case ProcessorRegister::kRegionBase:
        return regions_[number_].base;
    case ProcessorRegister::kRegionSize:
        return regions_[number_].size;
    case ProcessorRegister::kRegionAccess:
        return regions_[number_].access;
    case ProcessorRegister::kInvalid:
        break;
    }
    return 0U;
}

void ProcessorModel::Write(const ProcessorRegister which, const std::uint32_t value)
{
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        control_ = value;
        break;
    case ProcessorRegister::kAuxiliaryControl:
        auxiliary_ = value;
        break;
    case ProcessorRegister::kRegionNumber:
        number_ = value % kMostRegions;
        break;
    case ProcessorRegister::kRegionBase:
        regions_[number_].base = faults_.Has(Fault::kMpuRegionLost) ? 0x100U : value;
        break;
    case ProcessorRegister::kRegionSize:
        regions_[number_].size = value;
        break;
    case ProcessorRegister::kRegionAccess:
        regions_[number_].access = value;
        break;
    case ProcessorRegister::kMpuType:
    case ProcessorRegister::kInvalid:
        break;
    }
}

void ProcessorModel::WriteAccess(const std::uint32_t region, const std::uint32_t access)
{
    number_ = region % kMostRegions;
    regions_[number_].access = access;
}

const ProcessorModel::Region* ProcessorModel::RegionOf(const std::uint32_t address) const
{
    const Region* found = nullptr;
    for (const Region& region : regions_)
    {
        const std::uint32_t power = ((region.size >> mpu::kSizeShift) & 0x1FU) + 1U;
        const std::uint64_t end = static_cast<std::uint64_t>(region.base) + (std::uint64_t{1U} << power);
        const bool is_on = (region.size & mpu::kSizeOn) != 0U;
        if (is_on && (address >= region.base) && (address < end))
        {
            found = &region;
        }
    }
    return found;
}

bool ProcessorModel::MayWrite(const std::uint32_t address, const Privilege privilege) const
{
    if ((control_ & mpu::kControlOn) == 0U)
    {
        return true;
    }
    const Region* const region = RegionOf(address);
    if (region == nullptr)
    {
        return (privilege == Privilege::kPrivileged) && ((control_ & mpu::kControlBackground) != 0U);
    }
    const std::uint32_t access = region->access & kAccessMask;
    const bool privileged_writes = (access == mpu::kPrivilegedWrites) && (privilege == Privilege::kPrivileged);
    return privileged_writes || (access == mpu::kAllWrite);
}

bool ProcessorModel::MayRead(const std::uint32_t address, const Privilege privilege) const
{
    const Region* const region = RegionOf(address);
    const bool is_on = (control_ & mpu::kControlOn) != 0U;
    return !is_on || (region != nullptr) || (privilege == Privilege::kPrivileged);
}

bool ProcessorModel::MayExecute(const std::uint32_t address, const Privilege privilege) const
{
    const Region* const region = RegionOf(address);
    const bool is_forbidden = (region != nullptr) && ((region->access & mpu::kNoExecution) != 0U);
    return MayRead(address, privilege) && !is_forbidden;
}

bool ProcessorModel::ChecksRam() const
{
    return (auxiliary_ & tcram::kProcessorChecks) == tcram::kProcessorChecks;
}

} // namespace counterpoint::tms570::model
