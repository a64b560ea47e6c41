// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_OCTETS_HPP
#define CHANNEL_A_OCTETS_HPP

#include "channel_a/storage.hpp"
#include "channel_a/voice.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

// Inlined by force where a compiler knows the way from eight bytes to one or two words: only inline it is seen, and
// then smaller than the call.
//
// Data of frames: kept as bytes, looked at as all eight of them at once, so that there is neither a length to be wrong
// nor a branch that depends on data.
namespace counterpoint::channel_a
{

constexpr std::size_t kBytesPerWord = 4U;
constexpr std::uint32_t kBitsPerByte = 8U;
constexpr std::uint32_t kBitsPerWord = 32U;

/// What the bytes of an inverse frame are flipped with.
constexpr std::uint64_t kInverseFlip = 0xFFFFFFFFFFFFFFFFU;

constexpr std::uint32_t kShiftMask = 0x3FU;
constexpr std::uint32_t kWholeBytes = 0x78U;

/// @brief Four bytes from `place` on, byte 0 as the lowest bits, whatever the order of the processor.
[[nodiscard, gnu::always_inline]] inline std::uint32_t WordAt(const std::uint8_t* const place) noexcept
{
    return std::uint32_t{place[0]} | (std::uint32_t{place[1]} << 8U) |          // MISRA D-002
           (std::uint32_t{place[2]} << 16U) | (std::uint32_t{place[3]} << 24U); // MISRA D-002
}

/// @brief Eight bytes likewise, in two words, for which a 32-bit processor has instructions.
[[nodiscard, gnu::always_inline]] inline std::uint64_t BitsAt(const std::uint8_t* const place) noexcept
{
    return std::uint64_t{WordAt(place)} | (std::uint64_t{WordAt(place + kBytesPerWord)} << kBitsPerWord); // MISRA D-002
}

[[nodiscard, gnu::always_inline]] inline std::uint64_t Bits(const Octets& octets) noexcept
{
    return BitsAt(&octets.at[0]);
}

/// @brief The lowest bits, 1 to 64 of them. Another count occurs only in a corrupted record, which its seal gives away.
[[nodiscard, gnu::always_inline]] inline std::uint64_t LowBits(const std::uint32_t count) noexcept
{
    return kInverseFlip >> ((0U - count) & kShiftMask);
}

/// @brief The bits of a frame that have a meaning.
[[nodiscard, gnu::always_inline]] inline std::uint64_t FrameBits(const Record& record) noexcept
{
    return LowBits((record.length_bits + 7U) & kWholeBytes);
}

[[gnu::always_inline]] inline void PutWord(std::uint8_t* const to, const std::uint32_t word) noexcept
{
    to[0] = static_cast<std::uint8_t>(word);        // MISRA D-002
    to[1] = static_cast<std::uint8_t>(word >> 8U);  // MISRA D-002
    to[2] = static_cast<std::uint8_t>(word >> 16U); // MISRA D-002
    to[3] = static_cast<std::uint8_t>(word >> 24U); // MISRA D-002
}

[[nodiscard, gnu::always_inline]] inline Octets OctetsOf(const std::uint64_t bits) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(bits);
    const std::uint32_t high = static_cast<std::uint32_t>(bits >> kBitsPerWord);
    return Octets{{static_cast<std::uint8_t>(low), static_cast<std::uint8_t>(low >> 8U),
                   static_cast<std::uint8_t>(low >> 16U), static_cast<std::uint8_t>(low >> 24U),
                   static_cast<std::uint8_t>(high), static_cast<std::uint8_t>(high >> 8U),
                   static_cast<std::uint8_t>(high >> 16U), static_cast<std::uint8_t>(high >> 24U)}};
}

[[nodiscard]] inline Payload PayloadOf(const Octets& octets) noexcept
{
    return Payload{WordAt(&octets.at[0]), WordAt(&octets.at[kBytesPerWord])};
}

/// @brief The frame becomes the pending normal frame. With late detection SRVT has no deadline, but the slot is served
/// until the frame has become too old or is gone.
[[gnu::always_inline]] inline void Keep(Voice& voice, const CanFrame& frame, const Instant stamp,
                                        const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    record.pending = OctetsOf(BitsAt(&frame.data[0]));
    record.frame_since = stamp;
    if (record.detection == SrvtDetection::kLate)
    {
        Mark(voice, slot);
        return;
    }
    record.since = stamp;
    record.limit_us = SrvtUs(record);
}

} // namespace counterpoint::channel_a

#endif
