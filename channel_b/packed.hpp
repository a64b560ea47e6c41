// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_PACKED_HPP
#define CHANNEL_B_PACKED_HPP

#include "channel_b/storage.hpp"

#include <cstddef>
#include <cstdint>

/// Words: payload of a frame, one bit for each slot of a half, or one byte of each of eight slots. Packing is by
/// shifts, so that the order of bytes of the processor does not matter.
namespace counterpoint::channel_b
{

/// The slot's bit in the marks of its half.
[[nodiscard]] inline HalfMask BitOf(SlotIndex slot) noexcept
{
    return HalfMask{1U} << (static_cast<std::uint32_t>(slot) % kSlotsInHalf);
}

[[nodiscard]] inline Marks& MarksOf(const Storage& storage, SlotIndex slot) noexcept
{
    return storage.marks[slot / kSlotsInHalf];
}

/// The part of a mask of all slots that belongs to the half whose first slot is `first`.
[[nodiscard]] inline HalfMask PartOf(SrdoMask mask, SlotIndex first) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(mask & 0xFFFFFFFFU);
    const std::uint32_t high = static_cast<std::uint32_t>(mask >> 32U);
    return (first == 0U) ? low : high;
}

/// Behind the last slot of the half, of a device with `count` slots.
[[nodiscard]] inline SlotIndex EndOf(SlotIndex first, SlotIndex count) noexcept
{
    const std::uint32_t full = static_cast<std::uint32_t>(first) + kSlotsInHalf;
    return (count < full) ? count : static_cast<SlotIndex>(full);
}

[[nodiscard]] inline SrdoMask Join(HalfMask low, HalfMask high) noexcept
{
    return static_cast<SrdoMask>(low) | (static_cast<SrdoMask>(high) << 32U);
}

/// No slot has the mark.
constexpr TwinMask kUnmarked{0U, 0xFFFFFFFFU};

/// Set only if both twins say so.
[[nodiscard]] inline HalfMask Granted(const TwinMask& mask) noexcept
{
    return mask.on & ~mask.off;
}

inline void Grant(TwinMask& mask, HalfMask slots) noexcept
{
    mask.on |= slots;
    mask.off &= ~slots;
}

inline void Withdraw(TwinMask& mask, HalfMask slots) noexcept
{
    mask.on &= ~slots;
    mask.off |= slots;
}

[[nodiscard]] inline std::uint32_t PackFourBytes(const std::uint8_t* bytes) noexcept
{
    const Column<const std::uint8_t> byte{bytes};
    return static_cast<std::uint32_t>(byte[0U]) | (static_cast<std::uint32_t>(byte[1U]) << 8U) |
           (static_cast<std::uint32_t>(byte[2U]) << 16U) | (static_cast<std::uint32_t>(byte[3U]) << 24U);
}

/// Byte n of the result is bits 8n to 8n + 7 of the word.
[[nodiscard]] inline std::uint64_t PackBytes(const std::uint8_t* bytes) noexcept
{
    const Column<const std::uint8_t> byte{bytes};
    return static_cast<std::uint64_t>(PackFourBytes(bytes)) |
           (static_cast<std::uint64_t>(PackFourBytes(&byte[4U])) << 32U);
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

[[nodiscard]] inline Payload PayloadOf(std::uint64_t word) noexcept
{
    return Payload{static_cast<std::uint32_t>(word & 0xFFFFFFFFU), static_cast<std::uint32_t>(word >> 32U)};
}

/// @brief The slot of the lowest set bit of a mask that is not 0, in the half that starts at `first`.
[[nodiscard]] SlotIndex LowestOf(HalfMask mask, SlotIndex first) noexcept;
/// @brief The mask without its lowest set bit.
[[nodiscard]] constexpr HalfMask WithoutLowest(HalfMask mask) noexcept
{
    return mask & (mask - 1U);
}

/// @brief Number of set bits of both halves.
[[nodiscard]] std::uint8_t CountOf(HalfMask low, HalfMask high) noexcept;

} // namespace counterpoint::channel_b

#endif
