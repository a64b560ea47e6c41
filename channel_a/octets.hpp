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

/// The bytes of a frame that are mapped, for lengths of 1 to 7 bytes and, as row 0, 8 bytes. Another length occurs only
/// in a corrupted record, which its seal gives away.
constexpr std::uint32_t kLengthMask = 0x07U;
extern const std::uint64_t kMapped[kLengthMask + 1U]; // MISRA D-001

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

/// @brief The bytes of the frame that are mapped.
[[nodiscard]] inline std::uint64_t MappedBits(const CanFrame& frame) noexcept
{
    return kMapped[frame.length_bytes & kLengthMask];
}

[[gnu::always_inline]] inline void PutWord(std::uint8_t* const to, const std::uint32_t word) noexcept
{
    to[0] = static_cast<std::uint8_t>(word);        // MISRA D-002
    to[1] = static_cast<std::uint8_t>(word >> 8U);  // MISRA D-002
    to[2] = static_cast<std::uint8_t>(word >> 16U); // MISRA D-002
    to[3] = static_cast<std::uint8_t>(word >> 24U); // MISRA D-002
}

[[gnu::always_inline]] inline void PutBits(Octets& to, const std::uint64_t bits) noexcept
{
    PutWord(&to.at[0], static_cast<std::uint32_t>(bits));
    PutWord(&to.at[kBytesPerWord], static_cast<std::uint32_t>(bits >> kBitsPerWord));
}

[[nodiscard]] inline Payload PayloadOf(const Octets& octets) noexcept
{
    return Payload{WordAt(&octets.at[0]), WordAt(&octets.at[kBytesPerWord])};
}

/// @brief Whether identifier, controller and length are those of this half of the SRDO.
[[nodiscard]] inline bool IsFitting(const Voice& voice, const Record& record, const CanFrame& frame,
                                    const Half half) noexcept
{
    const auto place = static_cast<std::size_t>(half);
    return (frame.identifier == record.values[kCobIdPlace + place]) && (frame.port == voice.ports[place]) &&
           (frame.length_bytes == record.length_bytes);
}

/// @brief The frame becomes the pending normal frame. With late detection SRVT has no deadline, but the slot is served
/// until the frame has become too old or is gone.
inline void Keep(Voice& voice, const CanFrame& frame, const Instant stamp, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    PutBits(record.pending, BitsAt(&frame.data[0]) & MappedBits(frame));
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
