// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kPolynomial = 0x1021U;
constexpr std::uint32_t kCrcBits = 16U;
constexpr std::uint32_t kCrcMask = 0xFFFFU;

// What bits do to an empty register, CRC-16, most significant bit first: the rest of bits * X^16 by
// X^16 + X^12 + X^5 + 1 is what the polynomial's lower terms make of the quotient.
constexpr std::uint32_t Rest(const std::uint32_t quotient) noexcept
{
    return (quotient ^ (quotient << 5U) ^ (quotient << 12U)) & kCrcMask;
}

// The quotient q is the one with q + (q >> 4) + (q >> 11) + (q >> 16) = bits, without carries. With s for the three
// shifts that is q = bits / (1 + s), which is (1 + s) (1 + s^2) (1 + s^4) times bits, because s^8 leaves nothing of 32.
constexpr std::uint32_t RestOfWord(const std::uint32_t bits) noexcept
{
    std::uint32_t quotient = bits ^ (bits >> 16U);
    quotient ^= (quotient >> 8U) ^ (quotient >> 22U);
    return Rest(quotient ^ (quotient >> 4U) ^ (quotient >> 11U) ^ (quotient >> 16U));
}

// Of eight bits only q + (q >> 4) is left.
constexpr std::uint32_t RestOfByte(const std::uint32_t bits) noexcept
{
    return Rest(bits ^ (bits >> 4U));
}

// One bit more in the register.
template <std::uint32_t kCrc>
constexpr std::uint32_t kShifted = ((kCrc << 1U) & kCrcMask) ^ ((kCrc >> (kCrcBits - 1U)) * kPolynomial);
// Both are linear: they are right if they are for each single bit. That of a bit is that of the lower bit shifted.
template <std::uint32_t kBit>
constexpr std::uint32_t kRight =
    kRight<kBit - 1U> + ((RestOfWord(1U << kBit) == kShifted<RestOfWord(1U << (kBit - 1U))>) ? 1U : 0U);
template <> constexpr std::uint32_t kRight<0U> = (RestOfWord(1U) == kPolynomial) ? 1U : 0U;
static_assert(kRight<31U> == 32U, "the rest of a word is that of the polynomial");
template <std::uint32_t kBit>
constexpr std::uint32_t kSame = kSame<kBit - 1U> + ((RestOfByte(1U << kBit) == RestOfWord(1U << kBit)) ? 1U : 0U);
template <> constexpr std::uint32_t kSame<0U> = (RestOfByte(1U) == RestOfWord(1U)) ? 1U : 0U;
static_assert(kSame<7U> == 8U, "that of a byte is the same");

std::uint32_t Fed(const std::uint32_t crc, const std::uint32_t byte) noexcept
{
    return RestOfByte((crc >> 8U) ^ byte) ^ ((crc << 8U) & kCrcMask);
}

// Four bytes of the stream, the low one first.
std::uint32_t FedWord(const std::uint32_t crc, const std::uint32_t word) noexcept
{
    const std::uint32_t swapped = (word << 24U) | ((word & 0xFF00U) << 8U) | ((word >> 8U) & 0xFF00U) | (word >> 24U);
    return RestOfWord(swapped ^ (crc << kCrcBits));
}

} // namespace

// The fields before the COB-IDs make up a word.
std::uint32_t Signature(const Record& record, const Mapping& mapping) noexcept
{
    std::uint32_t crc =
        FedWord(0U, record.direction ^ (record.values[kSctPlace] << 8U) ^ (record.values[kSrvtPlace] << 24U));
    crc = FedWord(crc, record.values[kCobIdPlace]);
    crc = FedWord(crc, record.values[kCobIdPlace + 1U]);
    crc = Fed(crc, mapping.count);
    for (std::uint32_t position = 0U; position < mapping.count; ++position)
    {
        crc = Fed(crc, position + 1U);
        crc = FedWord(crc, mapping.entries[position]); // MISRA D-002
    }
    return crc;
}

} // namespace counterpoint::channel_a
