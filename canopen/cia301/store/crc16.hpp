// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_STORE_CRC16_HPP
#define CANOPEN_CIA301_STORE_CRC16_HPP

#include "canopen/cia301/dictionary/entry.hpp"

namespace counterpoint::cia301
{

/// @brief CRC of block transfers: polynomial 1021h, from `crc` (0 at first), most significant bit first. O(length)
/// [SRS_SDO_008]
[[nodiscard]] std::uint16_t ContinueCrc(std::uint16_t crc, const Bytes& bytes) noexcept;

} // namespace counterpoint::cia301

#endif
