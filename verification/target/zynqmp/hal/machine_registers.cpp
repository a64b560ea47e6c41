// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/zynqmp/hal/machine_registers.hpp"

namespace counterpoint::target
{

std::uint32_t ReadMachine(const std::uint32_t address) noexcept
{
    return *reinterpret_cast<const volatile std::uint32_t*>(address);
}

void WriteMachine(const std::uint32_t address, const std::uint32_t value) noexcept
{
    *reinterpret_cast<volatile std::uint32_t*>(address) = value;
}

} // namespace counterpoint::target
