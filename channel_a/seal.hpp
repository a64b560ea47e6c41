// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SEAL_HPP
#define CHANNEL_A_SEAL_HPP

#include "channel_a/storage.hpp"
#include "channel_a/transitions.hpp"

#include <cstdint>

// The only places that change a sealed byte. Each changes the seal by the difference of old and new value and never
// builds it anew, so that nobody seals somebody else's corruption.
namespace counterpoint::channel_a
{

constexpr std::uint32_t kModeShift = 0U;
constexpr std::uint32_t kCauseShift = 8U;
constexpr std::uint32_t kDirectionShift = 16U;
constexpr std::uint32_t kLengthShift = 24U;

/// @brief The sealed bytes in one word.
[[nodiscard]] inline std::uint32_t SealedBytes(const Record& record) noexcept
{
    return (static_cast<std::uint32_t>(record.mode) << kModeShift) |
           (static_cast<std::uint32_t>(record.first_cause) << kCauseShift) |
           (static_cast<std::uint32_t>(record.direction) << kDirectionShift) |
           (static_cast<std::uint32_t>(record.length_bytes) << kLengthShift);
}

[[nodiscard]] inline bool IsSealed(const Record& record) noexcept
{
    return SealedBytes(record) == ~record.seal;
}

inline void SetMode(Record& record, const Mode mode) noexcept
{
    record.seal ^= (static_cast<std::uint32_t>(record.mode) ^ static_cast<std::uint32_t>(mode)) << kModeShift;
    record.mode = mode;
}

inline void SetFirstCause(Record& record, const SrdoCause cause) noexcept
{
    record.seal ^= (static_cast<std::uint32_t>(record.first_cause) ^ static_cast<std::uint32_t>(cause)) << kCauseShift;
    record.first_cause = cause;
}

inline void SetDirection(Record& record, const std::uint8_t direction) noexcept
{
    record.seal ^= (std::uint32_t{record.direction} ^ std::uint32_t{direction}) << kDirectionShift;
    record.direction = direction;
}

inline void SetLength(Record& record, const std::uint8_t length_bytes) noexcept
{
    record.seal ^= (std::uint32_t{record.length_bytes} ^ std::uint32_t{length_bytes}) << kLengthShift;
    record.length_bytes = length_bytes;
}

} // namespace counterpoint::channel_a

#endif
