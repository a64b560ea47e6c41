// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Registers of a Cortex-R4F or R5F. The instructions have no other name in C++ than an assembler statement, and they
// stand here alone. [MISRA D-005]
#include "hal/tms570/processor.hpp"

namespace counterpoint::tms570
{

std::uint32_t ReadProcessor(const ProcessorRegister which) noexcept
{
    std::uint32_t value = 0U;
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        asm volatile("mrc p15, 0, %0, c1, c0, 0" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kAuxiliaryControl:
        asm volatile("mrc p15, 0, %0, c1, c0, 1" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kMpuType:
        asm volatile("mrc p15, 0, %0, c0, c0, 4" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kRegionNumber:
        asm volatile("mrc p15, 0, %0, c6, c2, 0" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kRegionBase:
        asm volatile("mrc p15, 0, %0, c6, c1, 0" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kRegionSize:
        asm volatile("mrc p15, 0, %0, c6, c1, 2" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kRegionAccess:
        asm volatile("mrc p15, 0, %0, c6, c1, 4" : "=r"(value)); // MISRA D-005
        break;
    case ProcessorRegister::kInvalid:
        break;
    }
    return value;
}

void WriteProcessor(const ProcessorRegister which, const std::uint32_t value) noexcept
{
    Synchronise();
    switch (which)
    {
    case ProcessorRegister::kSystemControl:
        asm volatile("mcr p15, 0, %0, c1, c0, 0" : : "r"(value) : "memory"); // MISRA D-005
        break;
    case ProcessorRegister::kAuxiliaryControl:
        asm volatile("mcr p15, 0, %0, c1, c0, 1" : : "r"(value) : "memory"); // MISRA D-005
        break;
    case ProcessorRegister::kRegionNumber:
        asm volatile("mcr p15, 0, %0, c6, c2, 0" : : "r"(value) : "memory"); // MISRA D-005
        break;
    case ProcessorRegister::kRegionBase:
        asm volatile("mcr p15, 0, %0, c6, c1, 0" : : "r"(value) : "memory"); // MISRA D-005
        break;
    case ProcessorRegister::kRegionSize:
        asm volatile("mcr p15, 0, %0, c6, c1, 2" : : "r"(value) : "memory"); // MISRA D-005
        break;
    case ProcessorRegister::kRegionAccess:
        asm volatile("mcr p15, 0, %0, c6, c1, 4" : : "r"(value) : "memory"); // MISRA D-005
        break;
    case ProcessorRegister::kMpuType:
    case ProcessorRegister::kInvalid:
        break;
    }
    Synchronise();
}

void WriteRegionAccess(const std::uint32_t region, const std::uint32_t access) noexcept
{
    asm volatile("mcr p15, 0, %0, c6, c2, 0\n\t" // MISRA D-005
                 "mcr p15, 0, %1, c6, c1, 4"
                 :
                 : "r"(region), "r"(access)
                 : "memory");
}

void Synchronise() noexcept
{
    asm volatile("dsb\n\tisb" : : : "memory"); // MISRA D-005
}

void WaitForInterrupt() noexcept
{
    asm volatile("dsb\n\twfi" : : : "memory"); // MISRA D-005
}

std::uint32_t LockInterrupts() noexcept
{
    std::uint32_t before = 0U;
    asm volatile("mrs %0, cpsr\n\tcpsid if" : "=r"(before) : : "memory"); // MISRA D-005
    return before;
}

void UnlockInterrupts(const std::uint32_t before) noexcept
{
    asm volatile("msr cpsr_c, %0" : : "r"(before) : "memory"); // MISRA D-005
}

} // namespace counterpoint::tms570
