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
        if (!HasAny(x_rest, 1U))
        {
            PassClear();
        }
        x_slot = x_ahead;
        Pass(1U);
        return true;
    }

    /// @brief Where the last Next went.
    [[nodiscard]] SlotIndex Slot() const noexcept
    {
        return static_cast<SlotIndex>(x_slot);
    }

  private:
    /// The clear bits below the lowest set one, half as many at each turn.
    void PassClear() noexcept
    {
        for (std::uint32_t count = kMaxSrdoCount / 2U; count != 0U; count /= 2U)
        {
            if (!HasAny(x_rest, (SrdoMask{1U} << count) - 1U))
            {
                Pass(count);
            }
        }
    }

    void Pass(std::uint32_t count) noexcept
    {
        x_rest >>= count;
        x_ahead += count;
    }

    SrdoMask x_rest;           ///< What was not visited yet, ...
    std::uint32_t x_ahead{0U}; ///< ... beginning with this slot.
    std::uint32_t x_slot{0U};
};

} // namespace counterpoint::channel_b

#endif
