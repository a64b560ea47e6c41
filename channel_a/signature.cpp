// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/signature.hpp"

#include "channel_a/storage.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kPolynomial = 0x1021U;
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kHalfMask = 0x0FU;
constexpr std::uint32_t kCrcMask = 0xFFFFU;
constexpr std::uint32_t kTopBit = 15U;
constexpr std::uint32_t kHalfShift = 4U;
constexpr std::uint32_t kHalfCount = 16U;

// What a byte does to an empty register, CRC-16, most significant bit first: by its low four bits, and by its high
// four. The register is linear: a byte does what its halves do.
constexpr std::uint16_t kLow[kHalfCount] = {
    // MISRA D-001
    // clang-format off
    0x0000U, 0x1021U, 0x2042U, 0x3063U, 0x4084U, 0x50A5U, 0x60C6U, 0x70E7U,
    0x8108U, 0x9129U, 0xA14AU, 0xB16BU, 0xC18CU, 0xD1ADU, 0xE1CEU, 0xF1EFU,
    // clang-format on
};
constexpr std::uint16_t kHigh[kHalfCount] = {
    // MISRA D-001
    // clang-format off
    0x0000U, 0x1231U, 0x2462U, 0x3653U, 0x48C4U, 0x5AF5U, 0x6CA6U, 0x7E97U,
    0x9188U, 0x83B9U, 0xB5EAU, 0xA7DBU, 0xD94CU, 0xCB7DU, 0xFD2EU, 0xEF1FU,
    // clang-format on
};

// One bit more in the register.
template <std::uint32_t kCrc>
constexpr std::uint32_t kShifted = ((kCrc << 1U) & kCrcMask) ^ ((kCrc >> kTopBit) * kPolynomial);
template <std::size_t kEntry>
constexpr bool kIsRight = (kLow[kEntry] == (kShifted<kLow[kEntry / 2U]> ^ ((kEntry % 2U) * kPolynomial))) &&
                          (kHigh[kEntry] == kShifted<kShifted<kShifted<kShifted<kLow[kEntry]>>>>);
// Entry n is entry n / 2 shifted, with the polynomial for the bit that came in: by induction all are right if this
// holds for each.
template <std::size_t kEntries>
constexpr std::size_t kRight = kRight<kEntries - 1U> + (kIsRight<kEntries - 1U> ? 1U : 0U);
template <> constexpr std::size_t kRight<0U> = 0U;
static_assert(kRight<kHalfCount> == kHalfCount, "the tables are those of the polynomial");

// One byte of the stream.
inline std::uint32_t Fed(const std::uint32_t crc, const std::uint32_t byte) noexcept
{
    const std::uint32_t in = ((crc >> 8U) ^ byte) & kByteMask;
    return (crc << 8U) ^ kHigh[in >> kHalfShift] ^ kLow[in & kHalfMask]; // What is above 16 bits is left there.
}

inline std::uint32_t FedWord(const std::uint32_t crc, const std::uint32_t word) noexcept
{
    return Fed(Fed(Fed(Fed(crc, word), word >> 8U), word >> 16U), word >> 24U);
}

} // namespace

std::uint32_t Signature(const Record& record, const Mapping& mapping) noexcept
{
    std::uint32_t crc = Fed(0U, record.direction);
    crc = Fed(crc, record.values[kSctPlace]);
    crc = Fed(crc, record.values[kSctPlace] >> 8U);
    crc = Fed(crc, record.values[kSrvtPlace]);
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
