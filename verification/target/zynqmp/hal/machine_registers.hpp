// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_HAL_MACHINE_REGISTERS_HPP
#define VERIFICATION_TARGET_ZYNQMP_HAL_MACHINE_REGISTERS_HPP

#include <cstdint>

/// Registers that the emulator's machine has, for absent_registers.cpp: as they are (machine_registers.cpp), or with
/// the time of both processors coupled (coupled_time.cpp).
namespace counterpoint::target
{

[[nodiscard]] std::uint32_t ReadMachine(std::uint32_t address) noexcept;
void WriteMachine(std::uint32_t address, std::uint32_t value) noexcept;

} // namespace counterpoint::target

#endif
