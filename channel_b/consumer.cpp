// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

void Channel::OnFrame(const CanFrame& frame, Instant stamp) noexcept
{
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    const SlotIndex slot = LookUp(x_storage, frame);
    if (slot < x_count)
    {
        TakeFrame(slot, frame, stamp.us - x_last_us);
        return;
    }
    const bool is_accepted = x_storage.device[kGfcParameterAt] == 1U;
    if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && is_accepted)
    {
        x_gfc |= x_active;
    }
}

/// `since_call` is the time from the last OnCycle to the frame, modular, so that it may be before that call as well.
void Channel::TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    if (!IsConsumer(x_storage.state[slot]))
    {
        return;
    }
    if ((x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot])
    {
        const bool is_pending = (x_storage.marks->pending & BitOf(slot)) != 0U;
        Fault(slot, is_pending ? SrdoCause::kSrvt : SrdoCause::kSct);
    }
    const bool is_normal = frame.identifier == NormalIdentifier(x_storage, slot);
    const bool is_inverse = frame.identifier == InverseIdentifier(x_storage, slot);
    const CanPortId port = is_normal ? x_config->normal_port : x_config->inverse_port;
    const std::uint8_t length_bytes = x_storage.length_bytes[slot];
    if (((!is_normal) && (!is_inverse)) || (frame.port != port))
    {
        Fault(slot, SrdoCause::kIdentifier);
    }
    else if (frame.length_bytes != length_bytes)
    {
        Fault(slot, SrdoCause::kLength);
    }
    else
    {
        const std::uint64_t data = PackBytes(&frame.data[0]) & PayloadMask(length_bytes);
        if (is_normal)
        {
            TakeNormal(slot, data, since_call);
        }
        else
        {
            TakeInverse(slot, data);
        }
    }
}

void Channel::TakeNormal(SlotIndex slot, std::uint64_t data, std::uint32_t since_call) noexcept
{
    if ((x_storage.marks->pending & BitOf(slot)) != 0U)
    {
        Fault(slot, SrdoCause::kNormalTwice);
        return;
    }
    const std::uint32_t srvt_us = SrvtUs(x_storage, slot);
    x_storage.marks->pending |= BitOf(slot);
    x_storage.pending_data[slot] = data;
    x_storage.pair_limit[slot] = srvt_us;
    x_storage.pair_left[slot] = srvt_us + since_call; // The next OnCycle takes away what lay before the frame.
}

void Channel::TakeInverse(SlotIndex slot, std::uint64_t data) noexcept
{
    if ((x_storage.marks->pending & BitOf(slot)) == 0U)
    {
        Fault(slot, SrdoCause::kInverseFirst);
        return;
    }
    if ((x_storage.pending_data[slot] ^ data) != PayloadMask(x_storage.length_bytes[slot]))
    {
        Fault(slot, SrdoCause::kNotInverse);
        return;
    }
    const std::uint32_t sct_us = SctUs(x_storage, slot);
    x_storage.marks->pending &= ~BitOf(slot);
    x_storage.marks->fresh |= BitOf(slot);
    x_storage.marks->unwritten |= BitOf(slot);
    Grant(x_storage.marks->held, BitOf(slot));
    x_storage.inverse_data[slot] = data;
    x_storage.ordinal[slot] += 1U;
    // Both budgets count from the normal frame, so that the greater one has the difference more left.
    x_storage.pair_left[slot] += sct_us - x_storage.pair_limit[slot];
    x_storage.pair_limit[slot] = sct_us;
}

/// The pair is no longer held; a pending normal frame stays, and the budget is its own then.
void Channel::Discard(SlotIndex slot) noexcept
{
    Withdraw(x_storage.marks->held, BitOf(slot));
    x_storage.marks->unwritten &= ~BitOf(slot);
    x_storage.ordinal[slot] = 0U;
    if ((x_storage.marks->pending & BitOf(slot)) == 0U)
    {
        x_storage.pair_limit[slot] = kNothingRuns;
    }
}

void Channel::Fault(SlotIndex slot, SrdoCause cause) noexcept
{
    x_storage.marks->pending &= ~BitOf(slot);
    x_storage.marks->released &= ~BitOf(slot);
    Withdraw(x_storage.marks->acknowledged, BitOf(slot));
    Discard(slot);
    x_storage.state[slot] = SrdoState::kFaulted;
    Record(slot, cause);
}

void Channel::FaultEach(SrdoMask slots, SrdoCause cause) noexcept
{
    for (SrdoMask rest = slots; rest != 0U; rest &= rest - 1U)
    {
        Fault(LowestSlot(rest), cause);
    }
}

void Channel::Demote(SlotIndex slot) noexcept
{
    if (!IsConsumer(x_storage.state[slot]))
    {
        return;
    }
    x_storage.marks->released &= ~BitOf(slot);
    Withdraw(x_storage.marks->acknowledged, BitOf(slot));
    Discard(slot);
    x_storage.state[slot] = SrdoState::kFaulted;
    Count(slot, SrdoCause::kDemoted);
}

/// The consumers' part of OnCycle up to the faults that it reports. [SRS-CONS-013 to 018]
void Channel::ExamineConsumers(const CycleInput& input, SrdoMask spent, bool is_late, Census& census) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask consumers = census.waiting | census.faulted | census.released;
    const SrdoMask expired = spent & consumers;
    const SrdoMask half = expired & marks.pending;
    FaultEach(half, SrdoCause::kSrvt);
    FaultEach(expired & ~half, SrdoCause::kSct);
    if (is_late)
    {
        FaultEach(consumers & ~expired, SrdoCause::kLateCall);
    }
    if (input.queue != QueueState::kIntact)
    {
        FaultEach(consumers, SrdoCause::kQueueOverflow);
    }
    FaultEach(consumers & x_gfc, SrdoCause::kGfc);
    const SrdoMask faulted = consumers & marks.reporting;
    for (SrdoMask rest = faulted & marks.held.on; rest != 0U; rest &= rest - 1U)
    {
        Discard(LowestSlot(rest)); // Completed after the fault, before it was reported.
    }
    census.faulted |= faulted;
    census.waiting &= ~faulted;
    census.released &= ~faulted;
}

/// Edges of this call, and the end of those that waited too long. [SRS-REL-005]
void Channel::Acknowledge(SrdoMask edges, const Census& census) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask taken = edges & ~marks.reporting;
    const SrdoMask waiting = taken & (census.waiting | census.faulted | census.released);
    Grant(marks.acknowledged, waiting);
    for (SrdoMask rest = waiting; rest != 0U; rest &= rest - 1U)
    {
        x_storage.edge_left[LowestSlot(rest)] = x_config->acknowledge_window_us;
    }
    for (SrdoMask rest = taken & census.producers; rest != 0U; rest &= rest - 1U)
    {
        x_storage.first_cause[LowestSlot(rest)] = SrdoCause::kNone;
    }
}

/// [SRS-REL-003, SRS-REL-004, SRS-REL-007]
void Channel::Release(Census& census) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask permitted = Granted(marks.automatic) | Granted(marks.acknowledged);
    const SrdoMask ready = Granted(marks.held) & census.sound & ~marks.reporting & permitted;
    const SrdoMask released = (census.waiting | census.faulted) & ready;
    for (SrdoMask rest = released; rest != 0U; rest &= rest - 1U)
    {
        x_storage.state[LowestSlot(rest)] = SrdoState::kReleased;
    }
    census.released |= released;
    census.waiting &= ~released;
    census.faulted &= ~released;
    const SrdoMask read = Granted(marks.acknowledged) & census.released;
    for (SrdoMask rest = read; rest != 0U; rest &= rest - 1U)
    {
        x_storage.first_cause[LowestSlot(rest)] = SrdoCause::kNone;
    }
    Withdraw(marks.acknowledged, read);
    marks.released = census.released;
}

/// [SRS-REL-002]
void Channel::Commit(const Agreement& agreement) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask released = agreement.agreed & marks.released & Granted(marks.held);
    const SrdoMask written = released & agreement.matched & marks.unwritten;
    for (SrdoMask rest = written; rest != 0U; rest &= rest - 1U)
    {
        const SlotIndex slot = LowestSlot(rest);
        WriteInverse(slot, x_storage.inverse_data[slot]);
    }
    for (SrdoMask rest = marks.committed & ~released; rest != 0U; rest &= rest - 1U)
    {
        const SlotIndex slot = LowestSlot(rest);
        WriteInverse(slot, x_storage.safe_data[slot]);
    }
    marks.unwritten &= ~written;
    marks.committed = (marks.committed & released) | written;
}

} // namespace counterpoint::channel_b
