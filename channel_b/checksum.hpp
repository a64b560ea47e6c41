// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CHECKSUM_HPP
#define CHANNEL_B_CHECKSUM_HPP

#include <cstdint>

/// The two checksums, by shifts and without a table.
namespace counterpoint::channel_b
{

/// CRC-16 with polynomial 1021h, start value 0, most significant bit first. [SRS_CFG_010]
class Crc16
{
  public:
    void AddByte(std::uint32_t byte) noexcept;
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
