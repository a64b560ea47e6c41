// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

/// Entering and leaving OPERATIONAL with a valid configuration: rare, apart from what every cycle does.
namespace counterpoint::channel_b
{

void Channel::EnterSlot(SlotIndex slot, SrdoState state) noexcept
{
    // Identifiers were checked by Validate; the remainder keeps a corrupted one within the table.
    const std::uint32_t offset = NormalIdentifier(x_storage.rows[slot]) - kFirstSrdoIdentifier;
    x_storage.slot_of[offset % kSrdoIdentifierCount] = slot;
    x_storage.slot_of[(offset + 1U) % kSrdoIdentifierCount] = slot;
    x_storage.state[slot] = Code(state);
    x_storage.ordinal[slot] = 0U;
    x_storage.rows[slot].sent = 0U;
    Ground(slot, (state == SrdoState::kProducer) ? Stage::kIdle : Stage::kOff);
    x_storage.phase_left[slot] = kFirstTransmissionStepUs * x_config->node_id; // Of a consumer: whatever.
}

void Channel::Enter(const Census& half) noexcept
{
    Marks& marks = *half.marks;
    const HalfMask present = half.present;
    Withdraw(marks.held, present);
    Withdraw(marks.acknowledged, present);
    marks.unheard = present;
    marks.pending = 0U;
    marks.started = 0U;
    marks.requested = 0U;
    marks.refresh_due = 0U;
    const HalfMask usable = Granted(marks.valid) & marks.resolved & present;
    for (HalfMask rest = usable; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        if (x_storage.direction[slot] == kDirectionConsumer)
        {
            EnterSlot(slot, SrdoState::kWaiting);
        }
        if (x_storage.direction[slot] == kDirectionProducer)
        {
            EnterSlot(slot, SrdoState::kProducer);
        }
    }
}

/// Returns the consumers that were active. [SRS-CONS-019, SRS-PROD-011]
HalfMask Channel::Leave(const Census& half) noexcept
{
    const SlotIndex end = EndOf(half.first, x_count);
    const HalfMask left = half.marks->consumers & half.present;
    FaultEach(half.first, left, SrdoCause::kNotOperational);
    for (SlotIndex slot = half.first; slot < end; ++slot)
    {
        x_storage.state[slot] = Code(SrdoState::kOff);
        x_storage.rows[slot].sent = 0U;
        Ground(slot, Stage::kOff);
    }
    return left;
}

} // namespace counterpoint::channel_b
