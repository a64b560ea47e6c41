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

[[gnu::always_inline]] inline SrdoCause Channel::TakeNormal(SlotIndex slot, const CanFrame& frame,
                                                            std::uint32_t since_call) noexcept
{
    Row& row = x_storage.rows[slot];
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    if ((marks.pending & bit) != 0U)
    {
        return SrdoCause::kNormalTwice;
    }
    marks.pending |= bit;
    row.pending_data = PackBytes(&frame.data[0]);
    const std::uint32_t srvt_us = SrvtUs(row);
    row.srvt_limit = srvt_us;
    row.srvt_left = srvt_us + since_call;
    if ((marks.late & bit) == 0U)
    {
        x_storage.pair_limit[slot] = srvt_us;
        x_storage.pair_left[slot] = srvt_us + since_call;
    }
    return SrdoCause::kNone;
}

[[gnu::always_inline]] inline SrdoCause Channel::TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept
{
    Row& row = x_storage.rows[slot];
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    if ((marks.pending & bit) == 0U)
    {
        return SrdoCause::kInverseFirst;
    }
    const std::uint64_t normal = row.pending_data;
    const std::uint64_t inverse = PackBytes(&frame.data[0]);
    const std::uint64_t alike = ~(normal ^ inverse) & row.mask; // Behind the length anything may be.
    if ((alike | (normal & row.spare)) != 0U)
    {
        return SrdoCause::kNotInverse;
    }
    // Both limits count from the normal frame, so that the greater one has the difference more left.
    const std::uint32_t sct_us = SctUs(row);
    const bool is_late = (marks.late & bit) != 0U;
    const std::uint32_t left_us = is_late ? row.srvt_left : x_storage.pair_left[slot];
    x_storage.pair_left[slot] = left_us + (sct_us - row.srvt_limit);
    x_storage.pair_limit[slot] = sct_us;
    marks.pending &= ~bit;
    marks.fresh |= bit;
    marks.unwritten |= bit;
    Grant(marks.held, bit);
    row.inverse_data = inverse;
    x_storage.ordinal[slot] += 1U;
    return SrdoCause::kNone;
}

/// The limits at the stamp of a frame, where one has run out or SRVT is examined late: what was there before the frame
/// is discarded, the frame is then taken as the first one. [SRS-CONS-003, SRS-CONS-012, SRS-TIME-009]
void Channel::ExamineLimits(SlotIndex slot, std::uint32_t parity, std::uint32_t since_call) noexcept
{
    const Marks& marks = MarksOf(x_storage, slot);
    const Row& row = x_storage.rows[slot];
    const HalfMask waiting = marks.pending & marks.late & marks.consumers & BitOf(slot);
    const std::uint32_t srvt_left = row.srvt_left - since_call;
    const std::uint32_t sct_left = x_storage.pair_left[slot] - since_call;
    const bool is_expired = sct_left > x_storage.pair_limit[slot];
    const bool is_inverse_waited_for = (waiting != 0U) && (parity == 0U);
    const bool is_srvt_over = is_inverse_waited_for && (srvt_left > row.srvt_limit);
    // Further below zero is earlier.
    const bool is_sct_before = is_expired && (sct_left < srvt_left);
    if (is_srvt_over && (!is_sct_before))
    {
        Fault(slot, SrdoCause::kSrvt);
    }
    else if (is_expired)
    {
        Expire(slot);
    }
    else
    {
        // All is in time.
    }
}

/// The checks are made in the order of SRS-CONS-011.
void Channel::TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::uint32_t parity = frame.identifier & 1U;
    SrdoCause cause = SrdoCause::kNone;
    if ((MarksOf(x_storage, slot).consumers & BitOf(slot)) == 0U)
    {
        return; // Not ours.
    }
    if ((frame.identifier != OwnIdentifier(row, parity)) || (frame.port != x_port[parity])) // MISRA D-002
    {
        cause = SrdoCause::kIdentifier;
    }
    else if (frame.length_bytes != row.length_bytes)
    {
        cause = SrdoCause::kLength;
    }
    else
    {
        cause = (parity != 0U) ? TakeNormal(slot, frame, since_call) : TakeInverse(slot, frame);
    }
    if (cause != SrdoCause::kNone)
    {
        Fault(slot, cause);
    }
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
    if (is_expired || ((MarksOf(x_storage, slot).late & BitOf(slot)) != 0U))
    {
        ExamineLimits(slot, frame.identifier & 1U, since_call);
    }
    TakeFrame(slot, frame, since_call);
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
