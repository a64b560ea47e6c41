// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_ESM_REGISTERS_HPP
#define HAL_TMS570_DIAGNOSIS_ESM_REGISTERS_HPP

#include "hal/tms570/chip/registers.hpp"

#include <cstdint>

/// Error signalling module: offsets, keys. Source: facts/tms570 4; reference manual, chapter "Error Signaling Module
/// (ESM)".
namespace counterpoint::tms570::esm
{

inline constexpr RegisterBase kBase{0xFFFFF500U};

inline constexpr std::uint32_t kPinSet1 = 0x00U;
inline constexpr std::uint32_t kPinClear1 = 0x04U;
inline constexpr std::uint32_t kInterruptSet1 = 0x08U;
inline constexpr std::uint32_t kInterruptClear1 = 0x0CU;
inline constexpr std::uint32_t kLevelSet1 = 0x10U;
inline constexpr std::uint32_t kLevelClear1 = 0x14U;
inline constexpr std::uint32_t kStatus1 = 0x18U;
inline constexpr std::uint32_t kStatus2 = 0x1CU;
inline constexpr std::uint32_t kStatus3 = 0x20U;
inline constexpr std::uint32_t kPinStatus = 0x24U;
inline constexpr std::uint32_t kLowTimePreload = 0x34U;
inline constexpr std::uint32_t kErrorKey = 0x38U;
inline constexpr std::uint32_t kShadowStatus2 = 0x3CU;
inline constexpr std::uint32_t kPinSet4 = 0x40U;
inline constexpr std::uint32_t kPinClear4 = 0x44U;
inline constexpr std::uint32_t kInterruptSet4 = 0x48U;
inline constexpr std::uint32_t kInterruptClear4 = 0x4CU;
inline constexpr std::uint32_t kLevelSet4 = 0x50U;
inline constexpr std::uint32_t kLevelClear4 = 0x54U;
inline constexpr std::uint32_t kStatus4 = 0x58U; ///< Channels 32 to 63 of group 1.
inline constexpr std::uint32_t kStatus7 = 0x98U; ///< Channels 64 to 95 of group 1; LC43x alone has them.

inline constexpr std::uint32_t kKeyNormal = 0x0U;
inline constexpr std::uint32_t kKeyRelease = 0x5U; ///< nERROR goes high when its low time is over.
inline constexpr std::uint32_t kKeyForce = 0xAU;
inline constexpr std::uint32_t kPinIsHigh = 1U;
/// Shortest low time that the hardware has.
inline constexpr std::uint32_t kLeastLowTime = 0x3FFFU;

} // namespace counterpoint::tms570::esm

#endif
