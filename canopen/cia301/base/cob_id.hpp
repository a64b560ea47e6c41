// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_BASE_COB_ID_HPP
#define CANOPEN_CIA301_BASE_COB_ID_HPP

#include <cstdint>

namespace counterpoint::cia301
{

constexpr std::uint32_t kCobOff = 0x80000000U;      ///< Bit 31: not valid.
constexpr std::uint32_t kCobBit30 = 0x40000000U;    ///< TPDO: no RTR. SYNC: produced here. Elsewhere reserved.
constexpr std::uint32_t kCobExtended = 0x20000000U; ///< Bit 29: 29-bit identifier, which nothing here uses.
constexpr std::uint32_t kCobIdentifier = 0x1FFFFFFFU;

/// @brief Whether a service may get this identifier: 11 bits, and of no other service (000h to 07Fh, 101h to 180h,
/// 581h to 5FFh, 601h to 67Fh, 6E0h to 6FFh, 701h to 7FFh). O(1) [SRS_EMCY_003]
[[nodiscard]] bool IsConfigurable(std::uint32_t identifier) noexcept;

} // namespace counterpoint::cia301

#endif
