// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_BASE_LITTLE_ENDIAN_HPP
#define CANOPEN_CIA301_BASE_LITTLE_ENDIAN_HPP

#include <cstdint>

namespace counterpoint::cia301
{

/// @brief The number that `count` bytes (at most 8) hold in little-endian order. O(count)
[[nodiscard]] inline std::uint64_t FromLittleEndian(const std::uint8_t* const bytes, const std::uint32_t count) noexcept
{
    std::uint64_t value = 0U;
    for (std::uint32_t i = count; i > 0U; --i)
    {
        value = (value << 8U) | bytes[i - 1U];
    }
    return value;
}

/// @brief Writes the low `count` bytes (at most 8) of a number in little-endian order. O(count)
inline void ToLittleEndian(const std::uint64_t value, std::uint8_t* const bytes, const std::uint32_t count) noexcept
{
    for (std::uint32_t i = 0U; i < count; ++i)
    {
        bytes[i] = static_cast<std::uint8_t>((value >> (8U * i)) & 0xFFU);
    }
}

} // namespace counterpoint::cia301

#endif
