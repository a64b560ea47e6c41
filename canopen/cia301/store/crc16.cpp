// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/store/crc16.hpp"

namespace counterpoint::cia301
{
namespace
{

/// CRC of the sixteen values of four bits.
constexpr std::uint16_t kNibbles[16] = {0x0000U, 0x1021U, 0x2042U, 0x3063U, 0x4084U, 0x50A5U, 0x60C6U, 0x70E7U,
                                        0x8108U, 0x9129U, 0xA14AU, 0xB16BU, 0xC18CU, 0xD1ADU, 0xE1CEU, 0xF1EFU};

std::uint16_t TakeNibble(const std::uint16_t crc, const std::uint32_t nibble) noexcept
{
    const std::uint32_t at = ((crc >> 12U) ^ nibble) & 0x0FU;
    return static_cast<std::uint16_t>((static_cast<std::uint32_t>(crc) << 4U) ^ kNibbles[at]);
}

} // namespace

std::uint16_t ContinueCrc(const std::uint16_t crc, const Bytes& bytes) noexcept
{
    std::uint16_t now = crc;
    for (std::uint32_t i = 0U; i < bytes.size_bytes; ++i)
    {
        now = TakeNibble(now, static_cast<std::uint32_t>(bytes.data[i]) >> 4U);
        now = TakeNibble(now, bytes.data[i]);
    }
    return now;
}

} // namespace counterpoint::cia301
