// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_CHIP_CYCLE_COUNTER_HPP
#define HAL_ZYNQMP_CHIP_CYCLE_COUNTER_HPP

#include <cstdint>

/// The cycle counter of the Cortex-R5F (ARM DDI 0460, "Performance Monitoring Unit"), defined in hal/zynqmp/silicon.
namespace counterpoint::zynqmp
{

/// What of the unit is set up.
struct CycleSetup
{
    std::uint32_t control; ///< PMCR
    std::uint32_t enabled; ///< PMCNTENSET
    std::uint32_t user;    ///< PMUSERENR: 0, code in user mode has no way to it.
};

inline constexpr std::uint32_t kCyclesOn = 1U << 0U;        ///< PMCR.E
inline constexpr std::uint32_t kCyclesReset = 1U << 2U;     ///< PMCR.C
inline constexpr std::uint32_t kCyclesEach64th = 1U << 3U;  ///< PMCR.D
inline constexpr std::uint32_t kCycleCounterOn = 1U << 31U; ///< PMCNTENSET.C

/// @brief Takes effect before the next instruction.
void SetUpCycles(const CycleSetup& setup) noexcept;
/// @brief What the registers read now.
[[nodiscard]] CycleSetup ReadCycleSetup() noexcept;
/// @brief PMCCNTR
[[nodiscard]] std::uint32_t ReadCycleCounter() noexcept;

} // namespace counterpoint::zynqmp

#endif
