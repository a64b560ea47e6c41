// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_OCTETS_HPP
#define CHANNEL_A_OCTETS_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>

// Bytes in the order of the bus and the words they are kept as: byte 0 in the lowest bits, whatever the order of the
// processor. Inlined by force where a compiler knows the way from bytes to a word: only inline it is seen, and then
// smaller than the call.
namespace counterpoint::channel_a
{

constexpr std::size_t kBytesPerWord = 4U;
constexpr std::uint32_t kBitsPerByte = 8U;
constexpr std::uint32_t kBitsPerWord = 32U;
constexpr std::uint32_t kAllBits = 0xFFFFFFFFU;

[[nodiscard, gnu::always_inline]] inline std::uint32_t WordOf(const std::uint8_t first, const std::uint8_t second,
                                                              const std::uint8_t third,
                                                              const std::uint8_t fourth) noexcept
{
    return std::uint32_t{first} | (std::uint32_t{second} << 8U) | (std::uint32_t{third} << 16U) |
           (std::uint32_t{fourth} << 24U);
}

/// @brief Four bytes from `place` on.
[[nodiscard, gnu::always_inline]] inline std::uint32_t WordAt(const std::uint8_t* const place) noexcept
{
    return WordOf(place[0], place[1], place[2], place[3]); // MISRA D-002
}

[[nodiscard, gnu::always_inline]] inline std::uint64_t Joined(const std::uint32_t low,
                                                              const std::uint32_t high) noexcept
{
    return std::uint64_t{low} | (std::uint64_t{high} << kBitsPerWord);
}

/// @brief All eight bytes of a frame, so that there is no branch that depends on its length.
[[nodiscard, gnu::always_inline]] inline std::uint64_t BitsOf(const CanFrame& frame) noexcept
{
    return Joined(WordAt(&frame.data[0]), WordAt(&frame.data[kBytesPerWord]));
}

[[nodiscard, gnu::always_inline]] inline std::uint32_t LowOf(const std::uint64_t bits) noexcept
{
    return static_cast<std::uint32_t>(bits);
}

[[nodiscard, gnu::always_inline]] inline std::uint32_t HighOf(const std::uint64_t bits) noexcept
{
    return static_cast<std::uint32_t>(bits >> kBitsPerWord);
}

[[gnu::always_inline]] inline void PutWord(std::uint8_t* const to, const std::uint32_t word) noexcept
{
    to[0] = static_cast<std::uint8_t>(word);        // MISRA D-002
    to[1] = static_cast<std::uint8_t>(word >> 8U);  // MISRA D-002
    to[2] = static_cast<std::uint8_t>(word >> 16U); // MISRA D-002
    to[3] = static_cast<std::uint8_t>(word >> 24U); // MISRA D-002
}

} // namespace counterpoint::channel_a

#endif
