// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_TIME_CLOCKS_HPP
#define HAL_TMS570_TIME_CLOCKS_HPP

#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/variant.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// Why the controller started. More than one may be set.
struct ResetReason
{
    std::uint32_t bits; ///< system_module::kReset...
};

/// @brief Flags of the resets since they were cleared. The logic test ends in a reset, too, so do not clear the flags
/// before it is over: they say why the controller started. [SRS_TMS_051]
[[nodiscard]] ResetReason ReadResetReason() noexcept;
/// @brief Clears these flags.
void ClearResetReason(ResetReason reason) noexcept;

/// @brief Oscillator, PLL, dividers, sources, peripherals; every wait bounded, everything read back. [SRS_TMS_050]
[[nodiscard]] Outcome StartClocks(const ClockTree& clocks, const SystemSetup& system) noexcept;

/// @brief Once a cycle: sources as set up, no slip of the PLL, no failure of the oscillator.
[[nodiscard]] Outcome ExamineClocks(std::uint32_t rti_source) noexcept;

/// @brief Memories of the peripherals are written by hardware, with a right parity. [SRS_TMS_049]
[[nodiscard]] Outcome InitialiseMemories(const MemorySelection& memories) noexcept;

} // namespace counterpoint::tms570

#endif
