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
constexpr std::uint32_t kSpareBytes = 0x38U;

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

/// @brief The bits but for the uppermost `spare` ones, 0 to 63 of them.
[[nodiscard, gnu::always_inline]] inline std::uint64_t Mapped(const std::uint64_t bits,
                                                              const std::uint32_t spare) noexcept
{
    return (bits << (spare & kShiftMask)) >> (spare & kShiftMask);
}

/// @brief Whether a bit is set in the bytes of a frame of this SRDO.
[[nodiscard, gnu::always_inline]] inline bool HasBits(const Record& record, const std::uint64_t bits) noexcept
{
    return (bits << (record.spare_bits & kSpareBytes)) != 0U;
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

/// @brief Whether identifier, controller and length are those of this half of the SRDO.
[[nodiscard, gnu::always_inline]] inline bool IsFitting(const Voice& voice, const Record& record, const CanFrame& frame,
                                                        const Half half) noexcept
{
    const auto place = static_cast<std::size_t>(half);
    return (frame.identifier == record.values[kCobIdPlace + place]) && (frame.port == voice.ports[place]) &&
           (frame.length_bytes == LengthBytes(record));
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
