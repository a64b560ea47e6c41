// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/pair_moments.hpp"

#include "safety_core/comparator/slot_mask.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kOldestAgeUs = 0x20000000U;

// Identifiers 101h and 102h belong to place 0, and so on.
std::uint32_t PlaceOf(const std::uint32_t identifier) noexcept
{
    return (identifier - kFirstSrdoIdentifier) >> 1U;
}

} // namespace

void PairMoments::Restart() noexcept
{
    for (SlotIndex& slot : slot_of_)
    {
        slot = kNoSlot;
    }
}

void PairMoments::Register(const SlotIndex slot, const std::uint32_t cob_id_1) noexcept
{
    for (SlotIndex& place : slot_of_)
    {
        place = (place == slot) ? kNoSlot : place;
    }
    const std::uint32_t place = PlaceOf(cob_id_1);
    if (place < kMaxSrdoCount)
    {
        slot_of_[place] = slot; // MISRA D-002
    }
}

SlotIndex PairMoments::SlotOfFrame(const CanFrame& frame) const noexcept
{
    const std::uint32_t place = PlaceOf(frame.identifier);
    if ((place >= kMaxSrdoCount) || (frame.kind != FrameKind::kData))
    {
        return kNoSlot;
    }
    return slot_of_[place]; // MISRA D-002
}

void PairMoments::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    const SlotIndex slot = SlotOfFrame(frame);
    const bool is_inverse = (frame.identifier & 1U) == 0U;
    if (is_inverse && (slot != kNoSlot))
    {
        Moments& moments = moments_[slot]; // MISRA D-002
        moments.former = moments.newest;
        moments.newest = stamp;
    }
}

void PairMoments::Complete(const SrdoMask fresh) noexcept
{
    SlotSet to_note{fresh};
    while (to_note.mask != 0U)
    {
        Moments& moments = moments_[TakeLowest(to_note)]; // MISRA D-002
        moments.pair = moments.newest;
        moments.before = moments.former;
    }
}

void PairMoments::Discard(const SrdoMask slots, const Instant at) noexcept
{
    SlotSet to_note{slots};
    while (to_note.mask != 0U)
    {
        moments_[TakeLowest(to_note)].discarded = at; // MISRA D-002
    }
}

void PairMoments::LimitAge(const SlotIndex slot, const Instant now) noexcept
{
    Moments& moments = moments_[slot]; // MISRA D-002
    if ((now.us - moments.discarded.us) > kOldestAgeUs)
    {
        moments.discarded.us = now.us - kOldestAgeUs;
    }
}

bool PairMoments::IsPair(const SlotIndex slot, const Window& window) const noexcept
{
    const Moments& moments = moments_[slot]; // MISRA D-002
    return Holds(window, moments.pair) && (!Holds(window, moments.before));
}

Instant PairMoments::PairAt(const SlotIndex slot) const noexcept
{
    return moments_[slot].pair; // MISRA D-002
}

Instant PairMoments::DiscardedAt(const SlotIndex slot) const noexcept
{
    return moments_[slot].discarded; // MISRA D-002
}

} // namespace counterpoint
