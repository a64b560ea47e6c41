// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SEAL_HPP
#define CHANNEL_A_SEAL_HPP

#include "channel_a/octets.hpp"
#include "channel_a/storage.hpp"

#include <cstdint>

// The only places that change a sealed byte. Each changes the seal by the difference of old and new value and never
// builds it anew, so that nobody seals somebody else's corruption.
namespace counterpoint::channel_a
{

/// @brief The sealed bytes in one word.
[[nodiscard]] inline std::uint32_t SealedBytes(const Record& record) noexcept
{
    return WordOf(record.mode, record.length_bytes, static_cast<std::uint8_t>(record.first_cause), record.direction);
}

[[nodiscard]] inline bool IsSealed(const Record& record) noexcept
{
    return (SealedBytes(record) ^ WordAt(&record.seal[0])) == kAllBits;
}

inline void SetMode(Record& record, const std::uint32_t mode) noexcept
{
    record.seal[kModeSeal] = static_cast<std::uint8_t>(std::uint32_t{record.seal[kModeSeal]} ^ record.mode ^ mode);
    record.mode = static_cast<std::uint8_t>(mode);
}

/// @brief Other bits of the mode, its state stays.
inline void FlipMode(Record& record, const std::uint32_t bits) noexcept
{
    record.seal[kModeSeal] = static_cast<std::uint8_t>(record.seal[kModeSeal] ^ bits);
    record.mode = static_cast<std::uint8_t>(record.mode ^ bits);
}

/// @brief From a mode that the record was just found in.
inline void StepMode(Record& record, const std::uint32_t from, const std::uint32_t mode) noexcept
{
    record.seal[kModeSeal] = static_cast<std::uint8_t>(record.seal[kModeSeal] ^ from ^ mode);
    record.mode = static_cast<std::uint8_t>(mode);
}

inline void SetFirstCause(Record& record, const SrdoCause cause) noexcept
{
    record.seal[kCauseSeal] =
        static_cast<std::uint8_t>(std::uint32_t{record.seal[kCauseSeal]} ^
                                  static_cast<std::uint32_t>(record.first_cause) ^ static_cast<std::uint32_t>(cause));
    record.first_cause = cause;
}

inline void SetDirection(Record& record, const std::uint8_t direction) noexcept
{
    record.seal[kDirectionSeal] =
        static_cast<std::uint8_t>(std::uint32_t{record.seal[kDirectionSeal]} ^ record.direction ^ direction);
    record.direction = direction;
}

inline void SetLength(Record& record, const std::uint8_t length_bytes) noexcept
{
    record.seal[kLengthSeal] =
        static_cast<std::uint8_t>(std::uint32_t{record.seal[kLengthSeal]} ^ record.length_bytes ^ length_bytes);
    record.length_bytes = length_bytes;
}

} // namespace counterpoint::channel_a

#endif
