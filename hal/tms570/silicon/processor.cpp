// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Registers of a Cortex-R4F or R5F. The instructions have no name in C++ and stand in processor.S.
#include "hal/tms570/chip/processor.hpp"

extern "C"
{
    std::uint32_t ProcessorReadSystemControl() noexcept;
    std::uint32_t ProcessorReadAuxiliaryControl() noexcept;
    std::uint32_t ProcessorReadMpuType() noexcept;
    std::uint32_t ProcessorReadRegionNumber() noexcept;
    std::uint32_t ProcessorReadRegionBase() noexcept;
    std::uint32_t ProcessorReadRegionSize() noexcept;
    std::uint32_t ProcessorReadRegionAccess() noexcept;
    void ProcessorWriteSystemControl(std::uint32_t value) noexcept;
    void ProcessorWriteAuxiliaryControl(std::uint32_t value) noexcept;
    void ProcessorWriteRegionNumber(std::uint32_t value) noexcept;
    void ProcessorWriteRegionBase(std::uint32_t value) noexcept;
    void ProcessorWriteRegionSize(std::uint32_t value) noexcept;
    void ProcessorWriteRegionAccess(std::uint32_t value) noexcept;
    void ProcessorSelectAccess(std::uint32_t region, std::uint32_t access) noexcept;
    void ProcessorSynchronise() noexcept;
    void ProcessorSleep() noexcept;
    std::uint32_t ProcessorLock() noexcept;
    void ProcessorUnlock(std::uint32_t before) noexcept;
}

namespace counterpoint::tms570
{

std::uint32_t ReadProcessor(const ProcessorRegister which) noexcept
{
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        return ProcessorReadSystemControl();
    case ProcessorRegister::kAuxiliaryControl:
        return ProcessorReadAuxiliaryControl();
    case ProcessorRegister::kMpuType:
        return ProcessorReadMpuType();
    case ProcessorRegister::kRegionNumber:
        return ProcessorReadRegionNumber();
    case ProcessorRegister::kRegionBase:
        return ProcessorReadRegionBase();
    case ProcessorRegister::kRegionSize:
        return ProcessorReadRegionSize();
    case ProcessorRegister::kRegionAccess:
        return ProcessorReadRegionAccess();
    case ProcessorRegister::kInvalid:
        break;
    }
    return 0U;
}

void WriteProcessor(const ProcessorRegister which, const std::uint32_t value) noexcept
{
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        ProcessorWriteSystemControl(value);
        break;
    case ProcessorRegister::kAuxiliaryControl:
        ProcessorWriteAuxiliaryControl(value);
        break;
    case ProcessorRegister::kRegionNumber:
        ProcessorWriteRegionNumber(value);
        break;
    case ProcessorRegister::kRegionBase:
        ProcessorWriteRegionBase(value);
        break;
    case ProcessorRegister::kRegionSize:
        ProcessorWriteRegionSize(value);
        break;
    case ProcessorRegister::kRegionAccess:
        ProcessorWriteRegionAccess(value);
        break;
    case ProcessorRegister::kMpuType: // Read-only.
    case ProcessorRegister::kInvalid:
        break;
    }
}

void WriteRegionAccess(const std::uint32_t region, const std::uint32_t access) noexcept
{
    ProcessorSelectAccess(region, access);
}

void Synchronise() noexcept
{
    ProcessorSynchronise();
}

void WaitForInterrupt() noexcept
{
    ProcessorSleep();
}

std::uint32_t LockInterrupts() noexcept
{
    return ProcessorLock();
}

void UnlockInterrupts(const std::uint32_t before) noexcept
{
    ProcessorUnlock(before);
}

} // namespace counterpoint::tms570
