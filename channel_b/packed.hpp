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

/// `slot` is 0 to 63.
[[nodiscard]] inline SrdoMask BitOf(SlotIndex slot) noexcept
{
    return SrdoMask{1U} << slot;
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

/// @brief Clears the lowest set bit of a mask that is not 0 and returns its number.
[[nodiscard]] SlotIndex TakeLowest(SrdoMask& mask) noexcept;
/// @brief Number of set bits.
[[nodiscard]] std::uint8_t CountOf(SrdoMask mask) noexcept;

} // namespace counterpoint::channel_b

#endif
