// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/commit.hpp"

#include "channel_a/objects.hpp"
#include "channel_a/slot_walk.hpp"

#include <cstddef>

namespace counterpoint::channel_a
{
namespace
{

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
