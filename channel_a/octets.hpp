// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_OCTETS_HPP
#define CHANNEL_A_OCTETS_HPP

#include "channel_a/storage.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

// Data of frames, byte by byte. Every loop runs over all eight bytes, so that it has neither a length to be wrong nor a
// branch that depends on data.
namespace counterpoint::channel_a
{

constexpr std::uint32_t kLengthMask = 0x0FU;
constexpr std::uint8_t kInverted = 0xFFU; ///< What every byte of an inverse frame is flipped with.
constexpr std::uint32_t kWordBytes = 4U;
constexpr std::uint32_t kBitsPerByte = 8U;

/// For each length the bytes that are mapped. 9 to 15 occur only in a corrupted record, which its seal gives away.
constexpr Octets kMapped[kLengthMask + 1U] = {
    // MISRA D-001
    {{0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0x00U}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
    {{0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU, 0xFFU}},
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

/// @brief Every bit in which the mapped bytes of the frame differ from `expected` XOR `flip`; 0: none.
[[nodiscard]] inline std::uint8_t Difference(const Record& record, const CanFrame& frame, const Octets& expected,
                                             const std::uint8_t flip) noexcept
{
    const Octets& mapped = kMapped[record.length_bytes & kLengthMask];
    std::uint8_t difference = 0U;
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        const std::uint8_t wanted = static_cast<std::uint8_t>(expected.at[place] ^ flip);
        const std::uint8_t wrong = static_cast<std::uint8_t>(wanted ^ frame.data[place]);
        difference |= static_cast<std::uint8_t>(wrong & mapped.at[place]);
    }
    return difference;
}

/// @brief Bytes 0 to 3 or 4 to 7 as the word of a Payload.
[[nodiscard]] inline std::uint32_t PackedWord(const Octets& octets, const std::uint32_t first) noexcept
{
    return static_cast<std::uint32_t>(octets.at[first]) | (static_cast<std::uint32_t>(octets.at[first + 1U]) << 8U) |
           (static_cast<std::uint32_t>(octets.at[first + 2U]) << 16U) |
           (static_cast<std::uint32_t>(octets.at[first + 3U]) << 24U);
}

[[nodiscard]] inline Payload Packed(const Octets& octets) noexcept
{
    return Payload{PackedWord(octets, 0U), PackedWord(octets, kWordBytes)};
}

[[nodiscard]] inline Octets Unpacked(const Payload& payload) noexcept
{
    Octets octets{};
    for (std::uint32_t place = 0U; place < kWordBytes; ++place)
    {
        octets.at[place] = static_cast<std::uint8_t>(payload.low >> (place * kBitsPerByte));
        octets.at[place + kWordBytes] = static_cast<std::uint8_t>(payload.high >> (place * kBitsPerByte));
    }
    return octets;
}

} // namespace counterpoint::channel_a

#endif
