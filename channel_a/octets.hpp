// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_OCTETS_HPP
#define CHANNEL_A_OCTETS_HPP

#include "channel_a/storage.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

// Data of frames, byte by byte. Every loop runs over all eight bytes, so that it has neither a length to be wrong nor a
// branch that depends on data.
namespace counterpoint::channel_a
{

constexpr std::uint32_t kLengthMask = 0x0FU;
constexpr std::size_t kBytesPerWord = 4U;
constexpr std::uint32_t kBitsPerByte = 8U;

/// For each length the bytes that are mapped. 9 to 15 occur only in a corrupted record, which its seal gives away.
extern const Octets kMapped[kLengthMask + 1U]; // MISRA D-001

/// What every byte of a frame is flipped with: 0 the normal, 1 the inverse frame.
constexpr Octets kFlips[2] = {
    // MISRA D-001
    {{0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
};

/// @brief The mapped bytes of a frame of this record.
[[nodiscard]] inline Octets TakenFrom(const Record& record, const CanFrame& frame) noexcept
{
    const Octets& mapped = kMapped[record.length_bytes & kLengthMask];
    Octets taken{};
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        taken.at[place] = frame.data[place] & mapped.at[place];
    }
    return taken;
}

/// @brief Byte 0 as the lowest bits, whatever the order of the processor.
[[nodiscard]] inline std::uint64_t Bits(const Octets& octets) noexcept
{
    return std::uint64_t{octets.at[0]} | (std::uint64_t{octets.at[1]} << 8U) | (std::uint64_t{octets.at[2]} << 16U) |
           (std::uint64_t{octets.at[3]} << 24U) | (std::uint64_t{octets.at[4]} << 32U) |
           (std::uint64_t{octets.at[5]} << 40U) | (std::uint64_t{octets.at[6]} << 48U) |
           (std::uint64_t{octets.at[7]} << 56U);
}

[[nodiscard]] inline Octets OctetsOf(const std::uint64_t bits) noexcept
{
    return Octets{{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                   static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 24U),
                   static_cast<std::uint8_t>(bits >> 32U), static_cast<std::uint8_t>(bits >> 40U),
                   static_cast<std::uint8_t>(bits >> 48U), static_cast<std::uint8_t>(bits >> 56U)}};
}

[[nodiscard]] inline std::uint32_t WordAt(const std::uint8_t* const place) noexcept
{
    return std::uint32_t{place[0]} | (std::uint32_t{place[1]} << 8U) |          // MISRA D-002
           (std::uint32_t{place[2]} << 16U) | (std::uint32_t{place[3]} << 24U); // MISRA D-002
}

[[nodiscard]] inline Payload PayloadOf(const Octets& octets) noexcept
{
    return Payload{WordAt(&octets.at[0]), WordAt(&octets.at[kBytesPerWord])};
}

/// @brief Whether each mapped byte of the frame is the byte of `expected` XOR `flip`.
[[nodiscard]] inline bool IsEqual(const Record& record, const CanFrame& frame, const Octets& expected,
                                  const Octets& flip) noexcept
{
    const Octets& mapped = kMapped[record.length_bytes & kLengthMask];
    Octets wrong{};
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        const std::uint8_t wanted = static_cast<std::uint8_t>(expected.at[place] ^ flip.at[place]);
        const std::uint8_t difference = static_cast<std::uint8_t>(wanted ^ frame.data[place]);
        wrong.at[place] = difference & mapped.at[place];
    }
    return Bits(wrong) == 0U;
}

} // namespace counterpoint::channel_a

#endif
