// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/commit.hpp"

#include "channel_a/objects.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{
namespace
{

/// Slots that are passed over at once where none of them is in the mask.
constexpr std::uint32_t kGroup = 8U;
constexpr SrdoMask kGroupMask = 0xFFU;

// The bits of 1 to 64 slots: a mask that is corrupted leads to no other one.
SrdoMask SlotsOf(const std::uint8_t count) noexcept
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

// What the objects of a slot have to hold: its pair, or the safe value.
const Bytes& DataOf(const Voice& voice, const std::size_t slot, const SrdoMask safe) noexcept
{
    const Record& record = At(voice, slot);
    return IsIn(safe, slot) ? record.safe : record.held;
}

} // namespace

// All is written before the first object is read, so that one that overwrites another is found.
SrdoMask WriteAndHold(Voice& voice, const SrdoMask slots, const SrdoMask kept, const SrdoMask safe) noexcept
{
    const SlotWalk first{slots & SlotsOf(voice.count)};
    for (SlotWalk walk = first; walk.IsAtSlot(); walk.GoOn())
    {
        const std::size_t slot = walk.Slot();
        if (!IsIn(kept, slot))
        {
            WriteObjects(voice, slot, DataOf(voice, slot, safe));
        }
    }
    SrdoMask found = 0U;
    for (SlotWalk walk = first; walk.IsAtSlot(); walk.GoOn())
    {
        const std::size_t slot = walk.Slot();
        if (!HoldObjects(voice, slot, DataOf(voice, slot, safe)))
        {
            found |= BitOf(slot);
        }
    }
    return found;
}

} // namespace counterpoint::channel_a
