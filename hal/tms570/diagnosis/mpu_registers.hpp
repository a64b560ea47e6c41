// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_DIAGNOSIS_MPU_REGISTERS_HPP
#define HAL_TMS570_DIAGNOSIS_MPU_REGISTERS_HPP

#include <cstdint>

/// Memory protection unit of a Cortex-R4F and R5F: bits. Source: ARM DDI 0406, "Protected Memory System Architecture";
/// facts/tms570 1.
namespace counterpoint::tms570::mpu
{

inline constexpr std::uint32_t kControlOn = 1U << 0U;          ///< SCTLR.M
inline constexpr std::uint32_t kControlBackground = 1U << 17U; ///< SCTLR.BR: privileged code sees the default map.
inline constexpr std::uint32_t kTypeRegionsShift = 8U;
inline constexpr std::uint32_t kTypeRegionsMask = 0xFFU;

inline constexpr std::uint32_t kSizeOn = 1U << 0U;
inline constexpr std::uint32_t kSizeShift = 1U;

inline constexpr std::uint32_t kNoExecution = 1U << 12U;
inline constexpr std::uint32_t kPrivilegedWrites = 2U << 8U; ///< Privileged read and write, user read.
inline constexpr std::uint32_t kAllWrite = 3U << 8U;
inline constexpr std::uint32_t kNobodyWrites = 6U << 8U;
inline constexpr std::uint32_t kNormalMemory = 1U << 3U; ///< Normal, not cached, not shared.

inline constexpr std::uint32_t kLeastBytes = 32U;
inline constexpr std::uint32_t kMostRegions = 16U;

} // namespace counterpoint::tms570::mpu

#endif
