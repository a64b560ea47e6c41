// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_CRC_HPP
#define CHANNEL_A_CRC_HPP

#include "channel_a/bytes.hpp"

#include <cstddef>
#include <cstdint>

// CRC-16 of the signature and CRC-32 of the digest, each by a table of what a byte leaves in an empty register. A table
// is worked out while compiling by dividing bit by bit, and is then compared with a property that the division does not
// use: the rest of a sum is the sum of the rests, and what one bit leaves is what its neighbour leaves, moved on by
// one.
namespace counterpoint::channel_a
{

constexpr std::size_t kByteValues = 256U;

constexpr std::uint32_t kPolynomial16 = 0x1021U; ///< Most significant bit first.
constexpr std::uint32_t kTopBit16 = 0x8000U;
constexpr std::uint32_t kMask16 = 0xFFFFU;
constexpr std::uint32_t kPolynomial32 = 0xEDB88320U; ///< 04C11DB7h, least significant bit first.

struct Table16
{
    std::uint16_t rest[kByteValues]; // MISRA D-001
};

struct Table32
{
    std::uint32_t rest[kByteValues]; // MISRA D-001
};

/// @brief The register one bit further.
[[nodiscard]] constexpr std::uint32_t Shifted16(const std::uint32_t crc) noexcept
{
    const std::uint32_t moved = (crc << 1U) & kMask16;
    return ((crc & kTopBit16) != 0U) ? (moved ^ kPolynomial16) : moved;
}

[[nodiscard]] constexpr std::uint32_t Shifted32(const std::uint32_t crc) noexcept
{
    const std::uint32_t moved = crc >> 1U;
    return ((crc & 1U) != 0U) ? (moved ^ kPolynomial32) : moved;
}

[[nodiscard]] constexpr Table16 MakeTable16() noexcept
{
    Table16 table{};
    for (std::uint32_t byte = 0U; byte < kByteValues; ++byte)
    {
        std::uint32_t crc = byte << kBitsPerByte;
        for (std::uint32_t bit = 0U; bit < kBitsPerByte; ++bit)
        {
            crc = Shifted16(crc);
        }
        table.rest[byte] = static_cast<std::uint16_t>(crc);
    }
    return table;
}

[[nodiscard]] constexpr Table32 MakeTable32() noexcept
{
    Table32 table{};
    for (std::uint32_t byte = 0U; byte < kByteValues; ++byte)
    {
        std::uint32_t crc = byte;
        for (std::uint32_t bit = 0U; bit < kBitsPerByte; ++bit)
        {
            crc = Shifted32(crc);
        }
        table.rest[byte] = crc;
    }
    return table;
}

/// @brief 0 when each entry is what the property says; the lowest bit of a byte is the last one in.
[[nodiscard]] constexpr std::uint32_t WrongEntries(const Table16& table) noexcept
{
    std::uint32_t wrong = (table.rest[0] ^ std::uint32_t{0U}) | (table.rest[1] ^ kPolynomial16);
    for (std::size_t byte = 1U; byte < (kByteValues / 2U); ++byte)
    {
        const std::uint32_t doubled = Shifted16(table.rest[byte]);
        wrong |= doubled ^ table.rest[2U * byte];
        wrong |= doubled ^ table.rest[1] ^ table.rest[(2U * byte) + 1U];
    }
    return wrong;
}

/// @brief Likewise; here the highest bit of a byte is the last one in.
[[nodiscard]] constexpr std::uint32_t WrongEntries(const Table32& table) noexcept
{
    constexpr std::size_t kHighest = kByteValues / 2U;
    std::uint32_t wrong = table.rest[0] | (table.rest[kHighest] ^ kPolynomial32);
    for (std::size_t byte = 1U; byte < kHighest; ++byte)
    {
        wrong |= table.rest[byte] ^ Shifted32(table.rest[2U * byte]);
        wrong |= table.rest[byte] ^ table.rest[kHighest] ^ table.rest[byte + kHighest];
    }
    return wrong;
}

inline constexpr Table16 kTable16 = MakeTable16();
inline constexpr Table32 kTable32 = MakeTable32();
static_assert(WrongEntries(kTable16) == 0U, "the table of the CRC-16 is that of its polynomial");
static_assert(WrongEntries(kTable32) == 0U, "the table of the CRC-32 is that of its polynomial");

/// Start value 0000h, no final XOR. [SRS_CFG_010]
class Crc16
{
  public:
    void AddByte(const std::uint32_t byte) noexcept
    {
        crc_ = ((crc_ << kBitsPerByte) & kMask16) ^ kTable16.rest[((crc_ >> kBitsPerByte) ^ byte) & kByteMask];
    }

    /// @brief The lowest `count` bytes of a value, the lowest first.
    void AddBytes(const std::uint32_t value, const std::uint32_t count) noexcept
    {
        for (std::uint32_t place = 0U; place < count; ++place)
        {
            AddByte(ByteOf(value, place));
        }
    }

    [[nodiscard]] std::uint16_t Value() const noexcept
    {
        return static_cast<std::uint16_t>(crc_);
    }

  private:
    std::uint32_t crc_{0U};
};

/// Start value FFFFFFFFh and final complement, so that it continues. [SRS_CFG_034]
class Crc32
{
  public:
    explicit Crc32(const std::uint32_t before) noexcept : crc_{~before}
    {
    }

    void AddByte(const std::uint32_t byte) noexcept
    {
        crc_ = (crc_ >> kBitsPerByte) ^ kTable32.rest[(crc_ ^ byte) & kByteMask];
    }

    /// @brief Four bytes, the lowest first.
    void AddWord(const std::uint32_t value) noexcept
    {
        for (std::uint32_t place = 0U; place < kBytesPerWord; ++place)
        {
            AddByte(ByteOf(value, place));
        }
    }

    [[nodiscard]] std::uint32_t Value() const noexcept
    {
        return ~crc_;
    }

  private:
    std::uint32_t crc_;
};

} // namespace counterpoint::channel_a

#endif
