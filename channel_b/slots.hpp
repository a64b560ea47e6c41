// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_SLOTS_HPP
#define CHANNEL_B_SLOTS_HPP

#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// The slot's bit in a mask of all slots.
[[nodiscard]] inline SrdoMask BitOf(SlotIndex slot) noexcept
{
    return SrdoMask{1U} << (std::uint32_t{slot} % kMaxSrdoCount);
}

[[nodiscard]] inline bool HasAny(SrdoMask mask, SrdoMask bits) noexcept
{
    return (mask & bits) != 0U;
}

/// Goes through the set bits of a mask, the lowest first, and to no other slot.
class SlotWalk
{
  public:
    explicit SlotWalk(SrdoMask mask) noexcept : x_rest(mask)
    {
    }

    /// @brief Goes to the next set bit; false if there is none left.
    [[nodiscard]] bool Next() noexcept
    {
        if (x_rest == 0U)
        {
            return false;
        }
        x_slot = kMaxSrdoCount - ShiftsUntilZero(x_rest);
        x_rest &= x_rest - 1U; // Clears the lowest set bit.
        return true;
    }

    /// @brief Where the last Next went.
    [[nodiscard]] SlotIndex Slot() const noexcept
    {
        return static_cast<SlotIndex>(x_slot);
    }

  private:
    /// How often a mask is shifted up until no bit is left in it: the lower the lowest bit, the more often;
    /// at most 64 times.
    [[nodiscard]] static std::uint32_t ShiftsUntilZero(SrdoMask mask) noexcept
    {
        std::uint32_t shifts = 0U;
        for (SrdoMask rest = mask; rest != 0U; rest <<= 1U)
        {
            ++shifts;
        }
        return shifts;
    }

    SrdoMask x_rest; ///< What was not visited yet.
    std::uint32_t x_slot{0U};
};

} // namespace counterpoint::channel_b

#endif
