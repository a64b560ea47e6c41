// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_PACKED_HPP
#define CHANNEL_B_PACKED_HPP

#include "channel_b/storage.hpp"

#include <cstddef>
#include <cstdint>

/// Words: payload of a frame, or one bit for each slot of a half. Packing is by shifts, so that the order of bytes of
/// the processor does not matter.
namespace counterpoint::channel_b
{

/// One bit for each slot of one half: slots 0 to 31, or 32 to 63. A word of a small processor holds it.
using HalfMask = std::uint32_t;
constexpr std::uint8_t kSlotsInHalf = 32U;
constexpr std::uint8_t kHalves = kMaxSrdoCount / kSlotsInHalf;

/// The slot's bit in a mask of its half.
[[nodiscard]] inline HalfMask BitOf(SlotIndex slot) noexcept
{
    return HalfMask{1U} << (static_cast<std::uint32_t>(slot) % kSlotsInHalf);
}

/// The part of a mask of all slots that belongs to a half.
[[nodiscard]] inline HalfMask PartOf(SrdoMask mask, std::size_t half) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(mask & 0xFFFFFFFFU);
    const std::uint32_t high = static_cast<std::uint32_t>(mask >> 32U);
    return (half == 0U) ? low : high;
}

[[nodiscard]] inline SrdoMask Join(HalfMask low, HalfMask high) noexcept
{
    return static_cast<SrdoMask>(low) | (static_cast<SrdoMask>(high) << 32U);
}

[[nodiscard]] constexpr std::uint32_t FourBytes(std::uint32_t first, std::uint32_t second, std::uint32_t third,
                                                std::uint32_t fourth) noexcept
{
    return first | (second << 8U) | (third << 16U) | (fourth << 24U);
}

[[nodiscard]] inline std::uint32_t PackFourBytes(const std::uint8_t* bytes) noexcept
{
    const Column<const std::uint8_t> byte{bytes};
    return FourBytes(byte[0U], byte[1U], byte[2U], byte[3U]);
}

/// Byte n of the result is bits 8n to 8n + 7 of the word.
[[nodiscard]] inline std::uint64_t PackBytes(const std::uint8_t* bytes) noexcept
{
    return Join(PackFourBytes(bytes), PackFourBytes(&Column<const std::uint8_t>{bytes}[4U]));
}

inline void UnpackFourBytes(std::uint32_t word, std::uint8_t* bytes) noexcept
{
    const Column<std::uint8_t> byte{bytes};
    byte[0U] = static_cast<std::uint8_t>(word & 0xFFU);
    byte[1U] = static_cast<std::uint8_t>((word >> 8U) & 0xFFU);
    byte[2U] = static_cast<std::uint8_t>((word >> 16U) & 0xFFU);
    byte[3U] = static_cast<std::uint8_t>((word >> 24U) & 0xFFU);
}

inline void UnpackBytes(std::uint64_t word, std::uint8_t* bytes) noexcept
{
    UnpackFourBytes(static_cast<std::uint32_t>(word & 0xFFFFFFFFU), bytes);
    UnpackFourBytes(static_cast<std::uint32_t>(word >> 32U), &Column<std::uint8_t>{bytes}[4U]);
}

/// 1 to 64 bits.
[[nodiscard]] inline std::uint64_t LowBits(std::uint32_t count) noexcept
{
    return ~std::uint64_t{0U} >> ((64U - count) & 63U);
}

/// @brief The lowest `count` bits leave the word at its low end and come back at its high end; 64 is as good as 0.
[[nodiscard]] std::uint64_t Turned(std::uint64_t word, std::uint32_t count) noexcept;

/// @brief The slot of the lowest set bit of a mask that is not 0, in its half.
[[nodiscard]] SlotIndex LowestOf(HalfMask mask) noexcept;

/// The mask without its lowest set bit.
[[nodiscard]] constexpr HalfMask WithoutLowest(HalfMask mask) noexcept
{
    return mask & (mask - 1U);
}

} // namespace counterpoint::channel_b

#endif
