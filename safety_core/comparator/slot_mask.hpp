// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_COMPARATOR_SLOT_MASK_HPP
#define SAFETY_CORE_COMPARATOR_SLOT_MASK_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint
{

namespace slot_mask
{

inline constexpr std::uint32_t kHalfBits = 32U;
inline constexpr std::uint32_t kHighestBit = 0x80000000U;
inline constexpr std::uint32_t kPlaceShift = 27U;
// A sequence in which each group of five bits occurs once (de Bruijn), and which bit its shifts belong to.
inline constexpr std::uint32_t kSequence = 0x077CB531U;
inline constexpr std::uint8_t kNumberAt[kHalfBits] = {
    0U,  1U,  28U, 2U, 29U, 14U, 24U, 3U,  30U, 22U, 20U, // MISRA D-001
    15U, 25U, 17U, 4U, 8U,  31U, 27U, 13U, 23U, 21U, 19U, 16U, 7U, 26U, 12U, 18U, 6U, 11U, 5U, 10U, 9U};

} // namespace slot_mask

/// A set of slots that is walked from the lowest to the highest.
struct SlotSet
{
    SrdoMask mask;
};

/// @brief The set that holds this slot alone; `slot` is below 64, checked by the caller. O(1)
[[nodiscard]] inline SlotSet OnlySlot(const SlotIndex slot) noexcept
{
    return SlotSet{SrdoMask{1U} << slot};
}

/// @brief The first `count` slots; `count` is 1 to 64, checked by Kernel::Start. O(1)
[[nodiscard]] inline SrdoMask FirstSlots(const std::uint8_t count) noexcept
{
    return ~SrdoMask{0U} >> (std::uint32_t{kMaxSrdoCount} - count);
}

/// @brief The lowest slot of a set that is not empty. O(1), without an instruction that a target may lack.
[[nodiscard]] inline SlotIndex LowestOf(const SlotSet set) noexcept
{
    const std::uint32_t low = static_cast<std::uint32_t>(set.mask);
    const std::uint32_t high = static_cast<std::uint32_t>(set.mask >> slot_mask::kHalfBits);
    const std::uint32_t base = (low == 0U) ? slot_mask::kHalfBits : 0U;
    // The highest bit is never below another one: with it there is always a lowest bit.
    const std::uint32_t half = ((low == 0U) ? high : low) | slot_mask::kHighestBit;
    // A word with one bit, times the sequence, has that bit's number in its five highest bits as a place in the table.
    const std::uint32_t lowest_bit = half & (0U - half);
    const std::uint32_t place = (lowest_bit * slot_mask::kSequence) >> slot_mask::kPlaceShift;
    return static_cast<SlotIndex>(base + slot_mask::kNumberAt[place]); // MISRA D-002
}

/// @brief Takes the lowest slot out of a set that is not empty. O(1)
[[nodiscard]] inline SlotIndex TakeLowest(SlotSet& set) noexcept
{
    const SlotIndex lowest = LowestOf(set);
    set.mask &= set.mask - 1U;
    return lowest;
}

} // namespace counterpoint

#endif
