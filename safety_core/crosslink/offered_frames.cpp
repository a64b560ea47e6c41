// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/offered_frames.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{

void OfferedFrames::Restart() noexcept
{
    for (Place& place : places_)
    {
        place.armed.slot = kNoSlot;
        place.used = 0U;
    }
    refusal_ = Refusal{0U, SrdoCause::kNone};
}

void OfferedFrames::Take(const LinkMessage& message) noexcept
{
    for (std::uint8_t place = 0U; place < kArmedCount; ++place)
    {
        places_[place].armed = message.armed[place]; // MISRA D-002
    }
}

SrdoMask OfferedFrames::Due() const noexcept
{
    SrdoMask due = 0U;
    for (const Place& place : places_)
    {
        const bool is_new = (place.armed.slot < kMaxSrdoCount) && (place.armed.number != place.used);
        due |= is_new ? OnlySlot(place.armed.slot).mask : SrdoMask{0U};
    }
    return due;
}

CanFrame OfferedFrames::Use(const SlotIndex slot) noexcept
{
    CanFrame frame{};
    for (Place& place : places_)
    {
        if (place.armed.slot == slot)
        {
            place.used = place.armed.number;
            frame = place.armed.frame;
        }
    }
    return frame;
}

void OfferedFrames::GiveUp(const SlotIndex slot, const SrdoCause cause) noexcept
{
    for (const Place& place : places_)
    {
        if (place.armed.slot == slot)
        {
            refusal_ = Refusal{place.armed.number, cause};
        }
    }
}

} // namespace counterpoint
