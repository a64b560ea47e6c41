// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_TIME_SWDT_REGISTERS_HPP
#define HAL_ZYNQMP_TIME_SWDT_REGISTERS_HPP

#include "hal/zynqmp/chip/registers.hpp"

#include <cstdint>

/// System watchdog timer of the low-power domain. Source: register header of the vendor's public driver
/// wdtps; base address as in Linux's zynqmp.dtsi. The emulator has none.
namespace counterpoint::zynqmp::swdt
{

inline constexpr RegisterBase kLowPowerDomain{0xFF150000U};

inline constexpr std::uint32_t kMode = 0x00U;    ///< ZMR
inline constexpr std::uint32_t kControl = 0x04U; ///< CCR
inline constexpr std::uint32_t kRestart = 0x08U;
inline constexpr std::uint32_t kStatus = 0x0CU;

inline constexpr std::uint32_t kHasEnded = 1U << 0U; ///< Of kStatus: WDZ.
inline constexpr std::uint32_t kOn = 1U << 0U;
inline constexpr std::uint32_t kResets = 1U << 1U;
inline constexpr std::uint32_t kModeMask = 0x7U;
inline constexpr std::uint32_t kModeKey = 0xABC000U;
inline constexpr std::uint32_t kControlKey = 0x920000U;
inline constexpr std::uint32_t kRestartKey = 0x1999U;
inline constexpr std::uint32_t kControlMask = 0x3FFFU;
inline constexpr std::uint32_t kReloadShift = 2U;
/// The counter starts from the reload value, of 12 bits, followed by 12 bits 1.
inline constexpr std::uint32_t kStepCounts = 4096U;
inline constexpr std::uint32_t kDivider = 8U;
inline constexpr std::uint32_t kMostReload = 0xFFFU;

} // namespace counterpoint::zynqmp::swdt

#endif
