// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_COMPARATOR_SLOT_MASK_HPP
#define SAFETY_CORE_COMPARATOR_SLOT_MASK_HPP

#include "safety_core/contract/srdo.hpp"

namespace counterpoint
{

/// A set of slots that is walked from the lowest to the highest.
struct SlotSet
{
    SrdoMask mask;
};

/// @brief The set that holds one slot, which is below 64.
[[nodiscard]] inline SlotSet OnlySlot(const SlotIndex slot) noexcept
{
    return SlotSet{SrdoMask{1U} << slot};
}

/// @brief The lowest slot of a set that is not empty. O(1), without an instruction that a target may lack.
[[nodiscard]] SlotIndex LowestOf(SlotSet set) noexcept;

/// @brief Takes the lowest slot out of a set that is not empty. O(1)
[[nodiscard]] inline SlotIndex TakeLowest(SlotSet& set) noexcept
{
    const SlotIndex lowest = LowestOf(set);
    set.mask &= set.mask - 1U;
    return lowest;
}

} // namespace counterpoint

#endif
