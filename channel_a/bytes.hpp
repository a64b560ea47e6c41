// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_BYTES_HPP
#define CHANNEL_A_BYTES_HPP

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

// Data as they come over the bus: one byte after the other. Only the contract's Payload has words; they are made at the
// border, by shifts, so that the order of the processor has no part in it.
namespace counterpoint::channel_a
{

constexpr std::uint32_t kBitsPerByte = 8U;
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::size_t kBytesPerWord = 4U;

/// Data of one frame, byte 0 of the frame first. Bytes behind the mapped length are 0.
struct Bytes
{
    std::uint8_t at[kMaxPayloadBytes]; // MISRA D-001
};

[[nodiscard]] constexpr std::uint8_t ByteOf(const std::uint32_t word, const std::uint32_t place) noexcept
{
    return static_cast<std::uint8_t>((word >> (place * kBitsPerByte)) & kByteMask);
}

/// @brief Four bytes from `first` on, the first one lowest.
[[nodiscard]] constexpr std::uint32_t WordOf(const Bytes& bytes, const std::size_t first) noexcept
{
    return std::uint32_t{bytes.at[first]} | (std::uint32_t{bytes.at[first + 1U]} << 8U) |
           (std::uint32_t{bytes.at[first + 2U]} << 16U) | (std::uint32_t{bytes.at[first + 3U]} << 24U);
}

[[nodiscard]] constexpr Payload PayloadOf(const Bytes& bytes) noexcept
{
    return Payload{WordOf(bytes, 0U), WordOf(bytes, kBytesPerWord)};
}

/// @brief Whether a frame has these data, byte by byte, where `mapped` has ones; with an inversion of FFh, their
/// inverse.
[[nodiscard]] constexpr bool HasData(const CanFrame& frame, const Bytes& data, const std::uint32_t inversion,
                                     const Bytes& mapped) noexcept
{
    std::uint8_t wrong = 0U;
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        const std::uint32_t differing = std::uint32_t{frame.data[place]} ^ data.at[place] ^ inversion;
        wrong = static_cast<std::uint8_t>(wrong | (differing & mapped.at[place]));
    }
    return wrong == 0U;
}

[[nodiscard]] constexpr Bytes BytesOf(const Payload& data) noexcept
{
    return Bytes{{ByteOf(data.low, 0U), ByteOf(data.low, 1U), ByteOf(data.low, 2U), ByteOf(data.low, 3U),
                  ByteOf(data.high, 0U), ByteOf(data.high, 1U), ByteOf(data.high, 2U), ByteOf(data.high, 3U)}};
}

} // namespace counterpoint::channel_a

#endif
