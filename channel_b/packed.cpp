// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/packed.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// Each six consecutive bits of the sequence are at one place only; the table says at which.
constexpr std::uint64_t kDeBruijn = 0x03F79D71B4CB0A89U;
constexpr SlotIndex kPlaceOf[64] = { // MISRA D-001
    0U,  1U,  48U, 2U,  57U, 49U, 28U, 3U,  61U, 58U, 50U, 42U, 38U, 29U, 17U, 4U,  62U, 55U, 59U, 36U, 53U, 51U,
    43U, 22U, 45U, 39U, 33U, 30U, 24U, 18U, 12U, 5U,  63U, 47U, 56U, 27U, 60U, 41U, 37U, 16U, 54U, 35U, 52U, 21U,
    44U, 32U, 23U, 11U, 46U, 26U, 40U, 15U, 34U, 20U, 31U, 10U, 25U, 14U, 19U, 9U,  13U, 8U,  7U,  6U};

} // namespace

SlotIndex TakeLowest(SrdoMask& mask) noexcept
{
    const SrdoMask others = mask & (mask - 1U);
    const std::uint64_t lowest = mask ^ others;
    mask = others;
    return kPlaceOf[(lowest * kDeBruijn) >> 58U];
}

/// By sums in ever wider fields.
std::uint8_t CountOf(SrdoMask mask) noexcept
{
    const std::uint64_t pairs = mask - ((mask >> 1U) & 0x5555555555555555U);
    const std::uint64_t nibbles = (pairs & 0x3333333333333333U) + ((pairs >> 2U) & 0x3333333333333333U);
    const std::uint64_t bytes = (nibbles + (nibbles >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
    return static_cast<std::uint8_t>((bytes * 0x0101010101010101U) >> 56U);
}

} // namespace counterpoint::channel_b
