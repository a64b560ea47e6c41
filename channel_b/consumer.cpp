// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// Global fail-safe command. [SRS-CONS-017]
void Channel::TakeCommand(const CanFrame& frame) noexcept
{
    const bool is_accepted = x_storage.device[kGfcParameterAt] == 1U;
    if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && is_accepted)
    {
        x_gfc |= x_running;
    }
}

[[gnu::always_inline]] inline void Channel::TakeNormal(SlotIndex slot, const CanFrame& frame,
                                                       std::uint32_t since_call) noexcept
{
    Row& row = x_storage.rows[slot];
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    if ((marks.pending & bit) != 0U)
    {
        Fault(slot, SrdoCause::kNormalTwice);
        return;
    }
    marks.pending |= bit;
    row.pending_data = PackBytes(&frame.data[0]);
    StartBudget(x_storage, slot, since_call);
}

[[gnu::always_inline]] inline void Channel::TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept
{
    Row& row = x_storage.rows[slot];
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    if ((marks.pending & bit) == 0U)
    {
        Fault(slot, SrdoCause::kInverseFirst);
        return;
    }
    const std::uint64_t normal = row.pending_data;
    const std::uint64_t inverse = PackBytes(&frame.data[0]);
    const std::uint64_t alike = ~(normal ^ inverse) & row.mask; // Behind the length anything may be.
    if ((alike | (normal & row.spare)) != 0U)
    {
        Fault(slot, SrdoCause::kNotInverse);
        return;
    }
    // Both limits count from the normal frame, so that the greater one has the difference more left.
    const std::uint32_t sct_us = SctUs(row);
    x_storage.pair_left[slot] += sct_us - x_storage.pair_limit[slot];
    x_storage.pair_limit[slot] = sct_us;
    marks.pending &= ~bit;
    marks.fresh |= bit;
    marks.unwritten |= bit;
    Grant(marks.held, bit);
    row.inverse_data = inverse;
    x_storage.ordinal[slot] += 1U;
}

/// The checks are made in the order of SRS-CONS-011.
void Channel::TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::uint32_t parity = frame.identifier & 1U;
    if (row.stage != Stage::kOff)
    {
        return; // A producer's own.
    }
    if ((frame.identifier != OwnIdentifier(row, parity)) || (frame.port != x_port[parity])) // MISRA D-002
    {
        Fault(slot, SrdoCause::kIdentifier);
        return;
    }
    if (frame.length_bytes != row.length_bytes)
    {
        Fault(slot, SrdoCause::kLength);
        return;
    }
    if (parity != 0U)
    {
        TakeNormal(slot, frame, since_call);
        return;
    }
    TakeInverse(slot, frame);
}

void Channel::OnFrame(const CanFrame& frame, Instant stamp) noexcept
{
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    const SlotIndex slot = LookUp(x_storage, frame);
    if (slot >= x_count)
    {
        TakeCommand(frame);
        return;
    }
    // From the last OnCycle to the frame, modular, so that it may be before that call as well.
    const std::uint32_t since_call = stamp.us - x_last_us;
    const bool is_expired = (x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot];
    if (is_expired || (x_any_late != 0U))
    {
        TakeSlowly(slot, frame, since_call);
        return;
    }
    TakeFrame(slot, frame, since_call);
}

/// A frame where a limit has run out or may be examined late: what was there before the frame is discarded, the frame
/// is then taken as the first one. With late detection SRVT has a budget of its own, which takes the place of the other
/// one as long as the frame is looked at. [SRS-CONS-003, SRS-CONS-012, SRS-TIME-009]
void Channel::TakeSlowly(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const Marks& marks = MarksOf(x_storage, slot);
    Row& row = x_storage.rows[slot];
    const HalfMask late = marks.late & marks.consumers & BitOf(slot);
    std::uint32_t& left = x_storage.pair_left[slot];
    std::uint32_t& limit = x_storage.pair_limit[slot];
    const bool is_normal = (frame.identifier & 1U) != 0U;
    const std::uint32_t srvt_left = row.srvt_left - since_call;
    const bool is_examined = ((late & marks.pending) != 0U) && (!is_normal);
    // Further below zero is earlier.
    const bool is_srvt_over = is_examined && (srvt_left > row.srvt_limit);
    const bool is_sct_over = (left - since_call) > limit;
    const bool is_sct_first = is_sct_over && ((left - since_call) < srvt_left);
    if (is_srvt_over && (!is_sct_first))
    {
        Fault(slot, SrdoCause::kSrvt);
    }
    else if (is_sct_over)
    {
        Expire(slot);
    }
    else if (is_examined)
    {
        left = row.srvt_left;
        limit = row.srvt_limit;
    }
    else
    {
        // In time, or examined early.
    }
    const std::uint32_t sct_left = left;
    const std::uint32_t sct_limit = limit;
    TakeFrame(slot, frame, since_call);
    if ((late & marks.pending) != 0U)
    {
        row.srvt_left = left;
        row.srvt_limit = limit;
        left = sct_left;
        limit = sct_limit;
    }
}

void Channel::Demote(SlotIndex slot) noexcept
{
    const Marks& marks = MarksOf(x_storage, slot);
    if ((marks.consumers & BitOf(slot)) == 0U)
    {
        return;
    }
    Discard(slot);
    Count(slot, SrdoCause::kDemoted);
}

/// The consumers' part of OnCycle up to the faults that it reports. [SRS-CONS-013 to 018]
void Channel::ExamineConsumers(const Call& call, const Half& half) noexcept
{
    const Marks& marks = *half.marks;
    const HalfMask expired = half.spent & marks.consumers;
    const HalfMask alarmed = marks.consumers & ~expired & call.late;
    for (HalfMask rest = expired; rest != 0U; rest = WithoutLowest(rest))
    {
        Expire(LowestOf(rest, half.first));
    }
    FaultEach(half.first, alarmed, SrdoCause::kLateCall);
    FaultEach(half.first, marks.consumers & call.overflowed, SrdoCause::kQueueOverflow);
    FaultEach(half.first, marks.consumers & x_gfc, SrdoCause::kGfc);
    for (HalfMask rest = marks.consumers & marks.reporting & marks.held.on; rest != 0U; rest = WithoutLowest(rest))
    {
        Discard(LowestOf(rest, half.first)); // Completed after the fault, before it was reported.
    }
}

/// Edges of this call. [SRS-REL-005]
void Channel::Acknowledge(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    const HalfMask taken = half.edges & ~marks.reporting;
    const HalfMask waiting = taken & marks.consumers;
    Grant(marks.acknowledged, waiting);
    for (HalfMask rest = waiting; rest != 0U; rest = WithoutLowest(rest))
    {
        x_storage.phase_left[LowestOf(rest, half.first)] = x_config->acknowledge_window_us;
    }
    ForgetCauses(half.first, taken & marks.producers);
}

void Channel::ForgetCauses(SlotIndex first, HalfMask slots) noexcept
{
    for (HalfMask rest = slots; rest != 0U; rest = WithoutLowest(rest))
    {
        x_storage.first_cause[LowestOf(rest, first)] = Code(SrdoCause::kNone);
    }
}

/// [SRS-REL-003, SRS-REL-004, SRS-REL-007]
void Channel::Release(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    const HalfMask permitted = Granted(marks.automatic) | Granted(marks.acknowledged);
    const HalfMask ready = marks.consumers & Granted(marks.held) & ~marks.reporting & permitted;
    for (HalfMask rest = ready & ~marks.released.on; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        if (IsRecordable(x_storage.first_cause[slot]))
        {
            Grant(marks.released, BitOf(slot));
            marks.faulted &= ~BitOf(slot);
        }
    }
    const HalfMask read = Granted(marks.acknowledged) & Granted(marks.released) & marks.consumers;
    ForgetCauses(half.first, read);
    Withdraw(marks.acknowledged, read);
}

/// [SRS-REL-002]
void Channel::Commit(const Agreement& agreement) noexcept
{
    for (SlotIndex first = 0U; first < x_count; first = static_cast<SlotIndex>(first + kSlotsInHalf))
    {
        Marks& marks = MarksOf(x_storage, first);
        const HalfMask present = x_present[first / kSlotsInHalf];
        const HalfMask released =
            PartOf(agreement.agreed, first) & Granted(marks.released) & Granted(marks.held) & present;
        const HalfMask written = released & PartOf(agreement.matched, first) & marks.unwritten;
        const HalfMask withdrawn = marks.committed & ~released & present;
        for (HalfMask rest = written | withdrawn; rest != 0U; rest = WithoutLowest(rest))
        {
            const SlotIndex slot = LowestOf(rest, first);
            const bool is_written = (written & BitOf(slot)) != 0U;
            WriteInverse(slot, is_written ? x_storage.rows[slot].inverse_data : SafeDataOf(slot));
        }
        marks.unwritten &= ~written;
        marks.committed = (marks.committed & released) | written;
    }
}

} // namespace counterpoint::channel_b
