// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CHIP_PROCESSOR_HPP
#define HAL_ZYNQMP_CHIP_PROCESSOR_HPP

#include <cstdint>

/// Registers of the Cortex-R5F itself (ARM DDI 0460, system control coprocessor), defined in hal/zynqmp/silicon.
/// [SRS_ZYN_040]
namespace counterpoint::zynqmp
{

enum class ProcessorRegister : std::uint8_t
{
    kInvalid = 0U,
    kSystemControl = 1U,  ///< SCTLR
    kMpuType = 2U,        ///< MPUIR, read only.
    kRegionNumber = 3U,   ///< RGNR
    kRegionBase = 4U,     ///< DRBAR
    kRegionSize = 5U,     ///< DRSR
    kRegionAccess = 6U,   ///< DRACR
    kCycleControl = 7U,   ///< PMCR
    kCycleEnable = 8U,    ///< PMCNTENSET
    kCycleCounter = 9U,   ///< PMCCNTR
    kCycleUserMode = 10U, ///< PMUSERENR
};

/// @brief Reads a register of the processor.
[[nodiscard]] std::uint32_t ReadProcessor(ProcessorRegister which) noexcept;
/// @brief Takes effect before the next instruction.
void WriteProcessor(ProcessorRegister which, std::uint32_t value) noexcept;

/// @brief Selects a region of the MPU and sets its access bits: what a change of the running party takes.
void WriteRegionAccess(std::uint32_t region, std::uint32_t access) noexcept;
/// @brief All writes have reached memory, and what follows is fetched anew.
void Synchronise() noexcept;
/// @brief Sleeps until an interrupt or a reset.
void WaitForInterrupt() noexcept;
/// @brief Turns interrupts off (IRQ and FIQ). Returns what they were before.
[[nodiscard]] std::uint32_t LockInterrupts() noexcept;
/// @brief Sets interrupts as they were `before`.
void UnlockInterrupts(std::uint32_t before) noexcept;

} // namespace counterpoint::zynqmp

#endif
