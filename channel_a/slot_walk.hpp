// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_SLOT_WALK_HPP
#define CHANNEL_A_SLOT_WALK_HPP

#include "safety_core/contract/limits.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// @brief The bits of 1 to 64 slots: a mask that is corrupted leads to no other one.
[[nodiscard]] inline SrdoMask SlotsOf(const std::uint8_t count) noexcept
{
    return ~SrdoMask{0U} >> (std::uint32_t{kMaxSrdoCount} - count);
}

/// The slots of a mask in order, counted from 0.
class SlotWalk
{
  public:
    explicit SlotWalk(const SrdoMask slots) noexcept : left_{slots}
    {
        Find();
    }

    /// @brief False behind the last slot.
    [[nodiscard]] bool IsAtSlot() const noexcept
    {
        return left_ != 0U;
    }

    [[nodiscard]] std::size_t Slot() const noexcept
    {
        return slot_;
    }

    void GoOn() noexcept
    {
        ++slot_;
        left_ >>= 1U;
        Find();
    }

  private:
    /// Slots that are passed over at once where none of them is in the mask.
    static constexpr std::uint32_t kGroup = 8U;
    static constexpr SrdoMask kGroupMask = 0xFFU;

    // Where there is one each loop ends at it, or before.
    void Find() noexcept
    {
        if (!IsAtSlot())
        {
            return;
        }
        for (; (left_ & kGroupMask) == 0U; left_ >>= kGroup)
        {
            slot_ += kGroup;
        }
        for (; (left_ & 1U) == 0U; left_ >>= 1U)
        {
            ++slot_;
        }
    }

    std::size_t slot_{0U};
    SrdoMask left_; ///< Bit 0 is `slot_`.
};

} // namespace counterpoint::channel_a

#endif
