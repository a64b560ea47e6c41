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
    /// Passes the clear bits before the first set one, half as many at each turn; if none is set, the walk is over.
    explicit SlotWalk(SrdoMask mask) noexcept : x_rest(mask)
    {
        for (std::uint32_t count = kMaxSrdoCount / 2U; count != 0U; count /= 2U)
        {
            if (!HasAny(x_rest, (SrdoMask{1U} << count) - 1U))
            {
                Pass(count);
            }
        }
    }

    [[nodiscard]] bool IsOn() const noexcept
    {
        return x_rest != 0U;
    }

    [[nodiscard]] SlotIndex Slot() const noexcept
    {
        return static_cast<SlotIndex>(x_slot);
    }

    [[nodiscard]] SrdoMask Bit() const noexcept
    {
        return x_bit;
    }

    /// To the next set bit; each turn shortens the rest, so that it ends.
    void Step() noexcept
    {
        Pass(1U);
        while ((x_rest != 0U) && (!HasAny(x_rest, 1U)))
        {
            Pass(1U);
        }
    }

  private:
    void Pass(std::uint32_t count) noexcept
    {
        x_rest >>= count;
        x_bit <<= count;
        x_slot += count;
    }

    SrdoMask x_rest;    ///< What was not visited yet, beginning with the slot at hand.
    SrdoMask x_bit{1U}; ///< Of the slot at hand.
    std::uint32_t x_slot{0U};
};

} // namespace counterpoint::channel_b

#endif
