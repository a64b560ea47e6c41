// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/armed_frames.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{

void ArmedFrames::Restart() noexcept
{
    for (Place& place : places_)
    {
        place.stage = Stage::kFree;
    }
}

void ArmedFrames::Arm(const Arming& arming) noexcept
{
    for (Place& place : places_)
    {
        if (place.stage == Stage::kFree)
        {
            // Never 0: to a leader that is the number of no frame.
            number_ = static_cast<std::uint8_t>((number_ % 0xFFU) + 1U);
            place = Place{ArmedFrame{arming.slot, number_, arming.frame}, arming.now, arming.limit_us, Stage::kAwaited};
            return;
        }
    }
}

void ArmedFrames::Answer(const SlotIndex slot, const Instant at) noexcept
{
    for (Place& place : places_)
    {
        if ((place.stage == Stage::kAwaited) && (place.armed.slot == slot))
        {
            place.stage = Stage::kAnswered;
            place.since = at;
        }
    }
}

SlotIndex ArmedFrames::Refuse(const Refusal& refusal, const Instant at) noexcept
{
    SlotIndex slot = kNoSlot;
    for (Place& place : places_)
    {
        if ((place.stage == Stage::kAwaited) && (place.armed.number == refusal.number))
        {
            place.stage = Stage::kAnswered;
            place.since = at;
            slot = place.armed.slot;
        }
    }
    return slot;
}

void ArmedFrames::Examine(const Instant now) noexcept
{
    for (Place& place : places_)
    {
        if ((place.stage == Stage::kAwaited) && ((now.us - place.since.us) > place.limit_us))
        {
            place.stage = Stage::kAnswered;
            place.since = now;
        }
    }
}

void ArmedFrames::Clear(const Window& composed) noexcept
{
    for (Place& place : places_)
    {
        if ((place.stage == Stage::kAnswered) && IsNotAfter(place.since, composed.first))
        {
            place.stage = Stage::kFree;
        }
    }
}

SrdoMask ArmedFrames::Slots() const noexcept
{
    SrdoMask slots = 0U;
    for (const Place& place : places_)
    {
        slots |= (place.stage != Stage::kFree) ? OnlySlot(place.armed.slot).mask : SrdoMask{0U};
    }
    return slots;
}

SrdoMask ArmedFrames::Fitting(const SrdoMask wanted) const noexcept
{
    SrdoMask rest = wanted;
    for (const Place& place : places_)
    {
        // Each free place takes the lowest that is left.
        rest &= (place.stage == Stage::kFree) ? (rest - 1U) : ~SrdoMask{0U};
    }
    return wanted & ~rest;
}

ArmedFrame ArmedFrames::At(const std::uint8_t place) const noexcept
{
    const Place& asked = places_[place]; // MISRA D-002
    return (asked.stage == Stage::kAwaited) ? asked.armed : ArmedFrame{kNoSlot, 0U, CanFrame{}};
}

} // namespace counterpoint
