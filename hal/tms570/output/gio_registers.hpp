// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_OUTPUT_GIO_REGISTERS_HPP
#define HAL_TMS570_OUTPUT_GIO_REGISTERS_HPP

#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// General purpose pins: offsets. Source: facts/tms570 2; reference manual, chapter "General-Purpose Input/Output
/// (GIO)".
namespace counterpoint::tms570::gio
{

inline constexpr RegisterBase kBase{0xFFF7BC00U};
inline constexpr std::uint32_t kGlobalControl = 0x00U;
inline constexpr std::uint32_t kOutOfReset = 1U;

/// Ports A and B; offsets below count from here.
inline constexpr RegisterBase kPortA{0xFFF7BC34U};
inline constexpr RegisterBase kPortB{0xFFF7BC54U};
inline constexpr std::uint32_t kDirection = 0x00U; ///< 1: output.
inline constexpr std::uint32_t kInput = 0x04U;     ///< What the pins are.
inline constexpr std::uint32_t kOutput = 0x08U;
inline constexpr std::uint32_t kSet = 0x0CU;
inline constexpr std::uint32_t kClear = 0x10U;
inline constexpr std::uint32_t kOpenDrain = 0x14U;
inline constexpr std::uint32_t kPullDisable = 0x18U;

inline constexpr std::uint32_t kPins = 8U;

} // namespace counterpoint::tms570::gio

#endif
