// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

/// What a fault does to a slot: the rare way, apart from the ways of frames and cycles.
namespace counterpoint::channel_b
{

void Channel::Count(SlotIndex slot, SrdoCause cause) noexcept
{
    std::uint16_t& count = x_storage.rows[slot].error_count;
    if (count != 0xFFFFU)
    {
        ++count;
    }
    if (x_storage.first_cause[slot] == Code(SrdoCause::kNone))
    {
        x_storage.first_cause[slot] = Code(cause);
    }
}

/// A fault that the next OnCycle, or this one, reports.
void Channel::Record(SlotIndex slot, SrdoCause cause) noexcept
{
    Count(slot, cause);
    x_storage.rows[slot].causes |= std::uint32_t{1U} << (static_cast<std::uint32_t>(cause) & 31U);
    MarksOf(x_storage, slot).reporting |= BitOf(slot);
}

/// Nothing is granted any longer. A pending normal frame stays, and the budget is its own then (with late detection it
/// has another one).
void Channel::Discard(SlotIndex slot) noexcept
{
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    Withdraw(marks.held, bit);
    Withdraw(marks.acknowledged, bit);
    Withdraw(marks.released, bit);
    marks.unwritten &= ~bit;
    marks.faulted |= bit;
    x_storage.ordinal[slot] = 0U;
    if ((marks.pending & ~marks.late & bit) == 0U)
    {
        x_storage.pair_limit[slot] = kNothingRuns;
    }
}

void Channel::Fault(SlotIndex slot, SrdoCause cause) noexcept
{
    MarksOf(x_storage, slot).pending &= ~BitOf(slot);
    Discard(slot);
    Record(slot, cause);
}

/// A limit ran out: SRVT while a normal frame waits (not with late detection), else SCT. No effect on a slot that is no
/// active consumer.
void Channel::Expire(SlotIndex slot) noexcept
{
    const Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    const SrdoCause cause = ((marks.pending & ~marks.late & bit) != 0U) ? SrdoCause::kSrvt : SrdoCause::kSct;
    FaultEach(static_cast<SlotIndex>(slot - (slot % kSlotsInHalf)), marks.consumers & bit, cause);
}

void Channel::FaultEach(SlotIndex first, HalfMask slots, SrdoCause cause) noexcept
{
    for (HalfMask rest = slots; rest != 0U; rest = WithoutLowest(rest))
    {
        Fault(LowestOf(rest, first), cause);
    }
}

/// Nothing is in flight any longer.
void Channel::Ground(SlotIndex slot, Stage stage) noexcept
{
    x_storage.rows[slot].stage = stage;
    x_storage.pair_limit[slot] = kNothingRuns;
}

/// A fault of a producer that gives up the pair in flight; returns what OnConfirm then tells. [SRS-PROD-009]
Confirmation Channel::Fail(SlotIndex slot, SrdoCause cause) noexcept
{
    Record(slot, cause);
    Ground(slot, Stage::kIdle);
    return Confirmation{kNoSlot, ConfirmStep::kNone};
}

} // namespace counterpoint::channel_b
