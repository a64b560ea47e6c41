// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The instructions have no name in C++ and stand in cycle_counter.S.
#include "hal/zynqmp/chip/cycle_counter.hpp"

extern "C"
{
    std::uint32_t ProcessorReadCycleControl() noexcept;
    std::uint32_t ProcessorReadCycleEnable() noexcept;
    std::uint32_t ProcessorReadCycleUserMode() noexcept;
    std::uint32_t ProcessorReadCycleCounter() noexcept;
    void ProcessorWriteCycleControl(std::uint32_t value) noexcept;
    void ProcessorWriteCycleEnable(std::uint32_t value) noexcept;
    void ProcessorWriteCycleUserMode(std::uint32_t value) noexcept;
}

namespace counterpoint::zynqmp
{

void SetUpCycles(const CycleSetup& setup) noexcept
{
    ProcessorWriteCycleUserMode(setup.user);
    ProcessorWriteCycleControl(setup.control);
    ProcessorWriteCycleEnable(setup.enabled);
}

CycleSetup ReadCycleSetup() noexcept
{
    return CycleSetup{ProcessorReadCycleControl(), ProcessorReadCycleEnable(), ProcessorReadCycleUserMode()};
}

std::uint32_t ReadCycleCounter() noexcept
{
    return ProcessorReadCycleCounter();
}

} // namespace counterpoint::zynqmp
