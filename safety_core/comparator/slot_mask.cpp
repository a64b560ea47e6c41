// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/slot_mask.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kHalfBits = 32U;
constexpr std::uint32_t kHighestBit = 0x80000000U;
constexpr std::uint32_t kPlaceShift = 27U;
// A sequence in which each group of five bits occurs once (de Bruijn), and which bit its shifts belong to.
constexpr std::uint32_t kSequence = 0x077CB531U;
constexpr std::uint8_t kNumberAt[kHalfBits] = {0U,  1U,  28U, 2U,  29U, 14U, 24U, 3U,  30U, 22U, 20U, // MISRA D-001
                                               15U, 25U, 17U, 4U,  8U,  31U, 27U, 13U, 23U, 21U, 19U,
                                               16U, 7U,  26U, 12U, 18U, 6U,  11U, 5U,  10U, 9U};

} // namespace

SlotIndex LowestOf(const SlotSet set) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(set.mask);
    const std::uint32_t high = static_cast<std::uint32_t>(set.mask >> kHalfBits);
    const std::uint32_t base = (low == 0U) ? kHalfBits : 0U;
    // The highest bit is never below another one: with it there is always a lowest bit.
    const std::uint32_t half = ((low == 0U) ? high : low) | kHighestBit;
    // A word with one bit, times the sequence, has that bit's number in its five highest bits as a place in the table.
    const std::uint32_t lowest_bit = half & (0U - half);
    const std::uint32_t place = (lowest_bit * kSequence) >> kPlaceShift;
    return static_cast<SlotIndex>(base + kNumberAt[place]); // MISRA D-002
}

} // namespace counterpoint
