// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_TIME_TTC_REGISTERS_HPP
#define HAL_ZYNQMP_TIME_TTC_REGISTERS_HPP

#include "hal/zynqmp/chip/registers.hpp"

#include <cstdint>

/// Triple timer counter, its first counter. Source: QEMU's hw/timer/cadence_ttc.c; no manual was at hand.
namespace counterpoint::zynqmp::ttc
{

inline constexpr RegisterBase kTtc0{0xFF110000U};
inline constexpr RegisterBase kTtc1{0xFF120000U};

inline constexpr std::uint32_t kClockControl = 0x00U;
inline constexpr std::uint32_t kCounterControl = 0x0CU;
inline constexpr std::uint32_t kCounterValue = 0x18U;
inline constexpr std::uint32_t kInterruptEnable = 0x60U;

inline constexpr std::uint32_t kPrescalerOn = 1U << 0U;
inline constexpr std::uint32_t kPrescalerShift = 1U; ///< Divides by 2 to the power of its value + 1.
inline constexpr std::uint32_t kMostPower = 16U;

inline constexpr std::uint32_t kStopped = 1U << 0U;
inline constexpr std::uint32_t kRestart = 1U << 4U;
inline constexpr std::uint32_t kWaveformOff = 1U << 5U; ///< No output; up, overflow mode, running.

} // namespace counterpoint::zynqmp::ttc

#endif
