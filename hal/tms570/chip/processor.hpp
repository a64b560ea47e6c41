// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CHIP_PROCESSOR_HPP
#define HAL_TMS570_CHIP_PROCESSOR_HPP

#include <cstdint>

/// Registers of the processor itself (ARM DDI 0363, system control coprocessor), defined as those of registers.hpp:
/// hal/tms570/silicon for a Cortex-R4F or R5F, verification/models/tms570 for a host. [SRS_TMS_001]
namespace counterpoint::tms570
{

enum class ProcessorRegister : std::uint8_t
{
    kInvalid = 0U,
    kSystemControl = 1U,    ///< SCTLR
    kAuxiliaryControl = 2U, ///< ACTLR
    kMpuType = 3U,          ///< MPUIR
    kRegionNumber = 4U,     ///< RGNR
    kRegionBase = 5U,       ///< DRBAR
    kRegionSize = 6U,       ///< DRSR
    kRegionAccess = 7U,     ///< DRACR
};

/// @brief Reads a register of the processor.
[[nodiscard]] std::uint32_t ReadProcessor(ProcessorRegister which) noexcept;
/// @brief Takes effect before the next instruction.
void WriteProcessor(ProcessorRegister which, std::uint32_t value) noexcept;

/// @brief Selects a region of the MPU and sets its access bits: what a change of the running party takes.
void WriteRegionAccess(std::uint32_t region, std::uint32_t access) noexcept;
/// @brief All writes have reached memory, and what follows is fetched anew.
void Synchronise() noexcept;
/// @brief Sleeps until an interrupt or, where a self test of the processor was asked for, until its reset.
void WaitForInterrupt() noexcept;
/// @brief Turns interrupts off (IRQ and FIQ). Returns what they were before.
[[nodiscard]] std::uint32_t LockInterrupts() noexcept;
/// @brief Sets interrupts as they were `before`.
void UnlockInterrupts(std::uint32_t before) noexcept;

} // namespace counterpoint::tms570

#endif
