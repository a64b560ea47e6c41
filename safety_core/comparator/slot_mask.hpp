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

/// @brief Takes the lowest slot out of a set that is not empty. O(1): six halvings, no instruction that a target may
/// lack.
[[nodiscard]] SlotIndex TakeLowest(SlotSet& set) noexcept;

} // namespace counterpoint

#endif
