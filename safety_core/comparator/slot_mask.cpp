// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/comparator/slot_mask.hpp"

#include <cstdint>

namespace counterpoint
{

SlotSet OnlySlot(const SlotIndex slot) noexcept
{
    return SlotSet{SrdoMask{1U} << slot};
}

SlotIndex TakeLowest(SlotSet& set) noexcept
{
    SrdoMask rest = set.mask;
    std::uint32_t lowest = 0U;
    for (std::uint32_t width = kMaxSrdoCount / 2U; width != 0U; width /= 2U)
    {
        const SrdoMask low_half = rest << (kMaxSrdoCount - width);
        if (low_half == 0U)
        {
            rest >>= width;
            lowest += width;
        }
    }
    set.mask &= set.mask - 1U;
    return static_cast<SlotIndex>(lowest);
}

} // namespace counterpoint
