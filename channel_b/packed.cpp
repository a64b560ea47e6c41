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

std::uint64_t Turned(std::uint64_t word, std::uint32_t count) noexcept
{
    return (word >> (count & 63U)) | (word << ((64U - count) & 63U));
}

SlotIndex LowestOf(HalfMask mask) noexcept
{
    const HalfMask lowest = mask & (0U - mask);
    return kPlaceOf[(lowest * kDeBruijn) >> 27U];
}

} // namespace counterpoint::channel_b
