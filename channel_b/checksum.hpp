// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CHECKSUM_HPP
#define CHANNEL_B_CHECKSUM_HPP

#include <cstdint>

/// The two checksums, by shifts and without a table.
namespace counterpoint::channel_b
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
    std::uint32_t differences = 0U;
    for (std::uint32_t byte = 0U; byte < kByteValues; ++byte)
    {
        differences |= Shifted(byte << 8U, 0U) ^ Divided(byte << 8U, 0U);
        differences |= Shifted(0U, byte) ^ Divided(0U, byte);
        differences |= Shifted(byte, 0U) ^ Divided(byte, 0U);
    }
    return differences == 0U;
}

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

/// CRC-16 with polynomial 1021h, start value 0, most significant bit first. [SRS_CFG_010]
class Crc16
{
  public:
    void AddByte(std::uint32_t byte) noexcept
    {
        x_remainder = Shifted(x_remainder, byte & 0xFFU);
    }

    /// @brief Four bytes, the lowest first.
    void AddWord(std::uint32_t word) noexcept;

    [[nodiscard]] std::uint16_t Value() const noexcept
    {
        return static_cast<std::uint16_t>(x_remainder & 0xFFFFU);
    }

  private:
    std::uint32_t x_remainder{0U};
};

/// CRC-32 with polynomial 04C11DB7h, least significant bit first, complemented before and after. [SRS_CFG_034]
class Crc32
{
  public:
    /// @brief Continues from the value of another one; 0 starts.
    explicit Crc32(std::uint32_t before) noexcept : x_remainder(~before)
    {
    }

    void AddByte(std::uint32_t byte) noexcept;
    /// @brief Four bytes, the lowest first.
    void AddWord(std::uint32_t word) noexcept;

    [[nodiscard]] std::uint32_t Value() const noexcept
    {
        return ~x_remainder;
    }

  private:
    std::uint32_t x_remainder;
};

} // namespace counterpoint::channel_b

#endif
