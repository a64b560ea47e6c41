// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_PACKED_HPP
#define CHANNEL_B_PACKED_HPP

#include "channel_b/storage.hpp"

#include <cstddef>
#include <cstdint>

/// Words of 64 bits: payload of a frame, one bit a slot, or one byte of each of eight slots. Packing is by shifts, so
/// that the order of bytes of the processor does not matter.
namespace counterpoint::channel_b
{

constexpr std::uint8_t kSlotsInWord = 8U;

[[nodiscard]] inline SrdoMask BitOf(SlotIndex slot) noexcept
{
    return SrdoMask{1U} << (slot & 63U);
}

/// Set only if both twins say so.
[[nodiscard]] inline SrdoMask Granted(const TwinMask& mask) noexcept
{
    return mask.on & ~mask.off;
}

inline void Grant(TwinMask& mask, SrdoMask slots) noexcept
{
    mask.on |= slots;
    mask.off &= ~slots;
}

inline void Withdraw(TwinMask& mask, SrdoMask slots) noexcept
{
    mask.on &= ~slots;
    mask.off |= slots;
}

/// Byte n of the result is bits 8n to 8n + 7 of the word.
[[nodiscard]] inline std::uint64_t PackBytes(const std::uint8_t* bytes) noexcept
{
    const Column<const std::uint8_t> byte{bytes};
    return static_cast<std::uint64_t>(byte[0U]) | (static_cast<std::uint64_t>(byte[1U]) << 8U) |
           (static_cast<std::uint64_t>(byte[2U]) << 16U) | (static_cast<std::uint64_t>(byte[3U]) << 24U) |
           (static_cast<std::uint64_t>(byte[4U]) << 32U) | (static_cast<std::uint64_t>(byte[5U]) << 40U) |
           (static_cast<std::uint64_t>(byte[6U]) << 48U) | (static_cast<std::uint64_t>(byte[7U]) << 56U);
}

inline void UnpackBytes(std::uint64_t word, std::uint8_t* bytes) noexcept
{
    const Column<std::uint8_t> byte{bytes};
    byte[0U] = static_cast<std::uint8_t>(word & 0xFFU);
    byte[1U] = static_cast<std::uint8_t>((word >> 8U) & 0xFFU);
    byte[2U] = static_cast<std::uint8_t>((word >> 16U) & 0xFFU);
    byte[3U] = static_cast<std::uint8_t>((word >> 24U) & 0xFFU);
    byte[4U] = static_cast<std::uint8_t>((word >> 32U) & 0xFFU);
    byte[5U] = static_cast<std::uint8_t>((word >> 40U) & 0xFFU);
    byte[6U] = static_cast<std::uint8_t>((word >> 48U) & 0xFFU);
    byte[7U] = static_cast<std::uint8_t>((word >> 56U) & 0xFFU);
}

[[nodiscard]] inline std::uint32_t PackFourBytes(const std::uint8_t* bytes) noexcept
{
    const Column<const std::uint8_t> byte{bytes};
    return static_cast<std::uint32_t>(byte[0U]) | (static_cast<std::uint32_t>(byte[1U]) << 8U) |
           (static_cast<std::uint32_t>(byte[2U]) << 16U) | (static_cast<std::uint32_t>(byte[3U]) << 24U);
}

/// All mapped bits of a payload of 1 to 8 bytes.
[[nodiscard]] inline std::uint64_t PayloadMask(std::uint8_t length_bytes) noexcept
{
    return ~std::uint64_t{0U} >> ((64U - (8U * static_cast<std::uint32_t>(length_bytes))) & 63U);
}

[[nodiscard]] inline Payload PayloadOf(std::uint64_t word) noexcept
{
    return Payload{static_cast<std::uint32_t>(word & 0xFFFFFFFFU), static_cast<std::uint32_t>(word >> 32U)};
}

/// The number of the lowest set bit of a mask that is not 0: a De Bruijn sequence has each six bits at one place only.
[[nodiscard]] inline SlotIndex LowestSlot(SrdoMask mask) noexcept
{
    constexpr std::uint64_t kSequence = 0x03F79D71B4CB0A89U;
    constexpr SlotIndex kSlot[64] = {// MISRA D-001
                                     0U,  1U,  48U, 2U,  57U, 49U, 28U, 3U,  61U, 58U, 50U, 42U, 38U, 29U, 17U, 4U,
                                     62U, 55U, 59U, 36U, 53U, 51U, 43U, 22U, 45U, 39U, 33U, 30U, 24U, 18U, 12U, 5U,
                                     63U, 47U, 56U, 27U, 60U, 41U, 37U, 16U, 54U, 35U, 52U, 21U, 44U, 32U, 23U, 11U,
                                     46U, 26U, 40U, 15U, 34U, 20U, 31U, 10U, 25U, 14U, 19U, 9U,  13U, 8U,  7U,  6U};
    const std::uint64_t lowest = mask & (~mask + 1U);
    return kSlot[(lowest * kSequence) >> 58U];
}

/// Number of set bits, by sums in ever wider fields.
[[nodiscard]] inline std::uint8_t CountOf(SrdoMask mask) noexcept
{
    const std::uint64_t pairs = mask - ((mask >> 1U) & 0x5555555555555555U);
    const std::uint64_t nibbles = (pairs & 0x3333333333333333U) + ((pairs >> 2U) & 0x3333333333333333U);
    const std::uint64_t bytes = (nibbles + (nibbles >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
    return static_cast<std::uint8_t>((bytes * 0x0101010101010101U) >> 56U);
}

} // namespace counterpoint::channel_b

#endif
