// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/checksum.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// The polynomials without their highest bit.
constexpr std::uint32_t kPolynomial16 = 0x1021U;
constexpr std::uint32_t kPolynomial32 = 0x04C11DB7U;
constexpr std::uint32_t kByteValues = 256U;

/// One byte leaves the remainder at its high end; what it takes away on its way is its quotient times the polynomial,
/// whose bits are 12, 5 and 0. The quotient is the byte and what its upper half throws back upon its lower half.
[[nodiscard]] constexpr std::uint32_t Shifted(std::uint32_t remainder, std::uint32_t byte) noexcept
{
    const std::uint32_t leaving = (remainder >> 8U) ^ byte;
    const std::uint32_t quotient = leaving ^ (leaving >> 4U);
    return ((remainder << 8U) ^ (quotient << 12U) ^ (quotient << 5U) ^ quotient) & 0xFFFFU;
}

/// The definition: bit after bit, each that leaves takes the polynomial away.
[[nodiscard]] constexpr std::uint32_t Divided(std::uint32_t remainder, std::uint32_t byte) noexcept
{
    std::uint32_t rest = remainder ^ (byte << 8U);
    for (std::uint32_t bit = 0U; bit < 8U; ++bit)
    {
        const bool is_leaving = (rest & 0x8000U) != 0U;
        rest = ((rest << 1U) ^ (is_leaving ? kPolynomial16 : 0U)) & 0xFFFFU;
    }
    return rest;
}

/// Both are linear, so that it is enough to look at each byte that leaves, each that enters and each that moves up.
[[nodiscard]] constexpr bool IsShiftedAsDivided() noexcept
{
    bool is_equal = true;
    for (std::uint32_t byte = 0U; byte < kByteValues; ++byte)
    {
        is_equal = is_equal && (Shifted(byte << 8U, 0U) == Divided(byte << 8U, 0U));
        is_equal = is_equal && (Shifted(0U, byte) == Divided(0U, byte));
        is_equal = is_equal && (Shifted(byte, 0U) == Divided(byte, 0U));
    }
    return is_equal;
}
static_assert(IsShiftedAsDivided(), "shifts divide by the polynomial");

/// Bit 0 becomes bit 31.
[[nodiscard]] constexpr std::uint32_t Mirrored(std::uint32_t word) noexcept
{
    std::uint32_t mirrored = 0U;
    for (std::uint32_t bit = 0U; bit < 32U; ++bit)
    {
        mirrored = (mirrored << 1U) | ((word >> bit) & 1U);
    }
    return mirrored;
}
constexpr std::uint32_t kMirroredPolynomial32 = Mirrored(kPolynomial32);

} // namespace

void Crc16::AddByte(std::uint32_t byte) noexcept
{
    x_remainder = Shifted(x_remainder, byte & 0xFFU);
}

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
