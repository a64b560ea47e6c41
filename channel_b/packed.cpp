// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/packed.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// Each five consecutive bits of the sequence are at one place only; the table says at which.
constexpr std::uint32_t kDeBruijn = 0x077CB531U;
constexpr SlotIndex kPlaceOf[kSlotsInHalf] = { // MISRA D-001
    0U,  1U,  28U, 2U,  29U, 14U, 24U, 3U, 30U, 22U, 20U, 15U, 25U, 17U, 4U,  8U,
    31U, 27U, 13U, 23U, 21U, 19U, 16U, 7U, 26U, 12U, 18U, 6U,  11U, 5U,  10U, 9U};

} // namespace

SlotIndex LowestOf(HalfMask mask, SlotIndex first) noexcept
{
    const HalfMask lowest = mask & (0U - mask);
    return static_cast<SlotIndex>(first + kPlaceOf[(lowest * kDeBruijn) >> 27U]);
}

/// By sums in ever wider fields: two halves together have at most 8 in four bits.
std::uint8_t CountOf(HalfMask low, HalfMask high) noexcept
{
    if ((low | high) == 0U)
    {
        return 0U;
    }
    const std::uint32_t low_pairs = low - ((low >> 1U) & 0x55555555U);
    const std::uint32_t high_pairs = high - ((high >> 1U) & 0x55555555U);
    const std::uint32_t low_nibbles = (low_pairs & 0x33333333U) + ((low_pairs >> 2U) & 0x33333333U);
    const std::uint32_t nibbles = low_nibbles + (high_pairs & 0x33333333U) + ((high_pairs >> 2U) & 0x33333333U);
    const std::uint32_t bytes = (nibbles & 0x0F0F0F0FU) + ((nibbles >> 4U) & 0x0F0F0F0FU);
    return static_cast<std::uint8_t>((bytes * 0x01010101U) >> 24U);
}

} // namespace counterpoint::channel_b
