// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_START_MEMORY_MAP_HPP
#define HAL_ZYNQMP_START_MEMORY_MAP_HPP

#include "hal/tms570/diagnosis/mpu.hpp"

#include <cstdint>

extern "C"
{
    /// Top of the stack of code in user mode: zynqmp.ld.
    extern std::uint32_t stack_non_safety_top[];
}

/// The memory protection unit belongs to the processor and is that of a TMS570's: its driver is
/// hal/tms570/diagnosis/mpu.
namespace counterpoint::zynqmp
{

/// @brief The regions of the MPU that are the same for every party, as the linker placed them. What they leave out, OCM
/// and peripherals, privileged code sees by the processor's default map: uncached. [SRS_ZYN_006]
[[nodiscard]] tms570::MpuSetup FixedRegions() noexcept;

/// @brief Gives the regions of channel A, channel B and core to the protection. False where one was refused.
[[nodiscard]] bool ProtectParties(hal::MemoryProtection& protection) noexcept;

} // namespace counterpoint::zynqmp

#endif
