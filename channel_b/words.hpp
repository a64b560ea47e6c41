// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_WORDS_HPP
#define CHANNEL_B_WORDS_HPP

#include "channel_b/storage.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstdint>

/// Data of a frame as one word: byte n of the frame is bits 8n to 8n + 7. Everything is done by shifts, so that the
/// order of bytes of the processor does not matter. [SRS_CFG_036]
namespace counterpoint::channel_b
{

constexpr std::uint32_t kBitsPerByte = 8U;

/// The lowest bits of so many bytes as they take, at most 64.
[[nodiscard]] inline std::uint64_t Packed(Column<const std::uint8_t> bytes, std::uint32_t bits) noexcept
{
    std::uint64_t word = 0U;
    for (std::uint32_t at = 0U; (at < kMaxPayloadBits) && (at < bits); at += kBitsPerByte)
    {
        word |= std::uint64_t{bytes[at / kBitsPerByte]} << at;
    }
    return word;
}

inline void Unpack(std::uint64_t word, Column<std::uint8_t> bytes, std::uint32_t bits) noexcept
{
    std::uint64_t rest = word;
    for (std::uint32_t at = 0U; (at < kMaxPayloadBits) && (at < bits); at += kBitsPerByte)
    {
        bytes[at / kBitsPerByte] = static_cast<std::uint8_t>(rest & 0xFFU);
        rest >>= kBitsPerByte;
    }
}

/// A word of which only the lowest `count` bits are set, 1 to 64.
[[nodiscard]] inline std::uint64_t LowBits(std::uint32_t count) noexcept
{
    return ~std::uint64_t{0U} >> ((kMaxPayloadBits - count) % kMaxPayloadBits);
}

[[nodiscard]] inline std::uint32_t BytesFor(std::uint32_t bits) noexcept
{
    return (bits + (kBitsPerByte - 1U)) / kBitsPerByte;
}

/// All bits of so many bytes, 1 to 8.
[[nodiscard]] inline std::uint64_t LowBytes(std::uint32_t count) noexcept
{
    return LowBits(kBitsPerByte * count);
}

/// Bytes behind the length have no meaning.
[[nodiscard]] inline std::uint64_t FrameWord(const CanFrame& frame) noexcept
{
    return Packed({&frame.data[0U]}, kMaxPayloadBits);
}

[[nodiscard]] inline std::uint64_t WordOf(const Payload& payload) noexcept
{
    return std::uint64_t{payload.low} | (std::uint64_t{payload.high} << 32U);
}

[[nodiscard]] inline Payload PayloadOf(std::uint64_t word) noexcept
{
    return Payload{static_cast<std::uint32_t>(word & 0xFFFFFFFFU), static_cast<std::uint32_t>(word >> 32U)};
}

} // namespace counterpoint::channel_b

#endif
