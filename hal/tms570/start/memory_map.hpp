// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_START_MEMORY_MAP_HPP
#define HAL_TMS570_START_MEMORY_MAP_HPP

#include "hal/tms570/diagnosis/mpu.hpp"

#include <cstdint>

extern "C"
{
    /// Top of the stack of code in user mode: tms570.ld.
    extern std::uint32_t stack_non_safety_top[];
}

namespace counterpoint::tms570
{

/// @brief The regions of the MPU that are the same for every party, as the linker placed them. [SRS_FW_002]
[[nodiscard]] MpuSetup FixedRegions() noexcept;

/// @brief Gives the regions of channel A, channel B and core to the protection. False where one was refused.
[[nodiscard]] bool ProtectParties(hal::MemoryProtection& protection) noexcept;

} // namespace counterpoint::tms570

#endif
