// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/checksum.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

static_assert(IsShiftedAsDivided(), "shifts divide by the polynomial");
constexpr std::uint32_t kMirroredPolynomial32 = Mirrored(kPolynomial32);

void Crc16::AddWord(std::uint32_t word) noexcept
{
    for (std::uint32_t at = 0U; at < 32U; at += 8U)
    {
        AddByte(word >> at);
    }
}

void Crc32::AddByte(std::uint32_t byte) noexcept
{
    x_remainder ^= byte & 0xFFU;
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        const bool is_leaving = (x_remainder & 1U) != 0U;
        x_remainder = (x_remainder >> 1U) ^ (is_leaving ? kMirroredPolynomial32 : 0U);
    }
}

void Crc32::AddWord(std::uint32_t word) noexcept
{
    for (std::uint32_t at = 0U; at < 32U; at += 8U)
    {
        AddByte(word >> at);
    }
}

} // namespace counterpoint::channel_b
