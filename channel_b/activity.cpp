// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

/// Entering and leaving OPERATIONAL with a valid configuration: rare, apart from what every cycle does.
namespace counterpoint::channel_b
{

void Channel::EnterSlot(SlotIndex slot, Stage stage) noexcept
{
    // Identifiers were checked by Validate; the remainder keeps a corrupted one within the table.
    Row& row = x_storage.rows[slot];
    const std::uint32_t offset = NormalIdentifier(row) - kFirstSrdoIdentifier;
    x_storage.slot_of[offset % kSrdoIdentifierCount] = slot;
    x_storage.slot_of[(offset + 1U) % kSrdoIdentifierCount] = slot;
    x_storage.ordinal[slot] = 0U;
    row.sent = 0U;
    Ground(slot, stage);
    x_storage.phase_left[slot] = kFirstTransmissionStepUs * x_config->node_id; // Of a consumer: whatever.
}

void Channel::Enter(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    marks.held = kUnmarked;
    marks.acknowledged = kUnmarked;
    marks.released = kUnmarked;
    marks.enrolled = kUnmarked;
    marks.producers = 0U;
    marks.unheard = half.present;
    marks.faulted = 0U;
    marks.pending = 0U;
    marks.started = 0U;
    marks.requested = 0U;
    marks.refresh_due = 0U;
    const HalfMask usable = Granted(marks.valid) & marks.resolved & half.present;
    for (HalfMask rest = usable; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        const std::uint8_t direction = x_storage.direction[slot];
        if (direction == kDirectionProducer)
        {
            marks.producers |= BitOf(slot);
        }
        if ((direction == kDirectionProducer) || (direction == kDirectionConsumer))
        {
            Grant(marks.enrolled, BitOf(slot));
            EnterSlot(slot, (direction == kDirectionProducer) ? Stage::kIdle : Stage::kOff);
        }
    }
}

/// Returns the consumers that were active. [SRS-CONS-019, SRS-PROD-011]
HalfMask Channel::Leave(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    const HalfMask left = marks.consumers & half.present;
    const SlotIndex end = EndOf(half.first, x_count);
    FaultEach(half.first, left, SrdoCause::kNotOperational);
    for (SlotIndex slot = half.first; slot < end; ++slot)
    {
        x_storage.rows[slot].sent = 0U;
        Ground(slot, Stage::kOff);
    }
    marks.enrolled = kUnmarked;
    return left;
}

} // namespace counterpoint::channel_b
