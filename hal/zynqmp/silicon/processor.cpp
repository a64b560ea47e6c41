// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Registers of a Cortex-R5F. The instructions have no name in C++ and stand in processor.S.
#include "hal/zynqmp/chip/processor.hpp"

extern "C"
{
    std::uint32_t ProcessorReadSystemControl() noexcept;
    std::uint32_t ProcessorReadMpuType() noexcept;
    std::uint32_t ProcessorReadRegionNumber() noexcept;
    std::uint32_t ProcessorReadRegionBase() noexcept;
    std::uint32_t ProcessorReadRegionSize() noexcept;
    std::uint32_t ProcessorReadRegionAccess() noexcept;
    std::uint32_t ProcessorReadCycleControl() noexcept;
    std::uint32_t ProcessorReadCycleEnable() noexcept;
    std::uint32_t ProcessorReadCycleCounter() noexcept;
    std::uint32_t ProcessorReadCycleUserMode() noexcept;
    void ProcessorWriteSystemControl(std::uint32_t value) noexcept;
    void ProcessorWriteRegionNumber(std::uint32_t value) noexcept;
    void ProcessorWriteRegionBase(std::uint32_t value) noexcept;
    void ProcessorWriteRegionSize(std::uint32_t value) noexcept;
    void ProcessorWriteRegionAccess(std::uint32_t value) noexcept;
    void ProcessorWriteCycleControl(std::uint32_t value) noexcept;
    void ProcessorWriteCycleEnable(std::uint32_t value) noexcept;
    void ProcessorWriteCycleCounter(std::uint32_t value) noexcept;
    void ProcessorWriteCycleUserMode(std::uint32_t value) noexcept;
    void ProcessorSelectAccess(std::uint32_t region, std::uint32_t access) noexcept;
    void ProcessorSynchronise() noexcept;
    void ProcessorSleep() noexcept;
    std::uint32_t ProcessorLock() noexcept;
    void ProcessorUnlock(std::uint32_t before) noexcept;
}

namespace counterpoint::zynqmp
{

std::uint32_t ReadProcessor(const ProcessorRegister which) noexcept
{
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        return ProcessorReadSystemControl();
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
    case ProcessorRegister::kCycleControl:
        return ProcessorReadCycleControl();
    case ProcessorRegister::kCycleEnable:
        return ProcessorReadCycleEnable();
    case ProcessorRegister::kCycleCounter:
        return ProcessorReadCycleCounter();
    case ProcessorRegister::kCycleUserMode:
        return ProcessorReadCycleUserMode();
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
    case ProcessorRegister::kCycleControl:
        ProcessorWriteCycleControl(value);
        break;
    case ProcessorRegister::kCycleEnable:
        ProcessorWriteCycleEnable(value);
        break;
    case ProcessorRegister::kCycleCounter:
        ProcessorWriteCycleCounter(value);
        break;
    case ProcessorRegister::kCycleUserMode:
        ProcessorWriteCycleUserMode(value);
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

} // namespace counterpoint::zynqmp
