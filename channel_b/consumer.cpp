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
    if (slot >= x_count)
    {
        TakeCommand(frame);
        return;
    }
    if ((x_storage.marks->consumers & BitOf(slot)) == 0U)
    {
        return;
    }
    // From the last OnCycle to the frame, modular, so that it may be before that call as well.
    const std::uint32_t since_call = stamp.us - x_last_us;
    if ((x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot])
    {
        TakeLateFrame(slot, frame, since_call);
        return;
    }
    TakeFrame(slot, frame, since_call);
}

/// Global fail-safe command. [SRS-CONS-017]
void Channel::TakeCommand(const CanFrame& frame) noexcept
{
    const bool is_accepted = x_storage.device[kGfcParameterAt] == 1U;
    if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && is_accepted)
    {
        x_gfc |= x_active;
    }
}

/// The identifiers of normal frames are odd, those of inverse frames are even.
void Channel::TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    if ((frame.identifier & 1U) != 0U)
    {
        TakeNormal(slot, frame, since_call);
    }
    else
    {
        TakeInverse(slot, frame);
    }
}

/// The checks are made in the order of SRS-CONS-011.
inline void Channel::TakeNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    Marks& marks = *x_storage.marks;
    if ((frame.identifier != NormalIdentifier(x_storage, slot)) || (frame.port != x_config->normal_port))
    {
        Fault(slot, SrdoCause::kIdentifier);
        return;
    }
    if (frame.length_bytes != x_storage.length_bytes[slot])
    {
        Fault(slot, SrdoCause::kLength);
        return;
    }
    if ((marks.pending & BitOf(slot)) != 0U)
    {
        Fault(slot, SrdoCause::kNormalTwice);
        return;
    }
    const std::uint32_t srvt_us = SrvtUs(x_storage, slot);
    marks.pending |= BitOf(slot);
    x_storage.pending_data[slot] = PackBytes(&frame.data[0]);
    x_storage.pair_limit[slot] = srvt_us;
    x_storage.pair_left[slot] = srvt_us + since_call; // The next OnCycle takes away what lay before the frame.
}

/// The checks are made in the order of SRS-CONS-011.
inline void Channel::TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask bit = BitOf(slot);
    if ((frame.identifier != InverseIdentifier(x_storage, slot)) || (frame.port != x_config->inverse_port))
    {
        Fault(slot, SrdoCause::kIdentifier);
        return;
    }
    const std::uint8_t length_bytes = x_storage.length_bytes[slot];
    if (frame.length_bytes != length_bytes)
    {
        Fault(slot, SrdoCause::kLength);
        return;
    }
    if ((marks.pending & bit) == 0U)
    {
        Fault(slot, SrdoCause::kInverseFirst);
        return;
    }
    const std::uint64_t inverse = PackBytes(&frame.data[0]);
    const std::uint64_t alike = ~(x_storage.pending_data[slot] ^ inverse);
    if ((alike & PayloadMask(length_bytes)) != 0U) // Behind the mapped length anything may be.
    {
        Fault(slot, SrdoCause::kNotInverse);
        return;
    }
    const std::uint32_t sct_us = SctUs(x_storage, slot);
    const std::uint32_t srvt_us = x_storage.pair_limit[slot];
    marks.pending &= ~bit;
    marks.fresh |= bit;
    marks.unwritten |= bit;
    Grant(marks.held, bit);
    x_storage.inverse_data[slot] = inverse;
    x_storage.ordinal[slot] += 1U;
    // Both budgets count from the normal frame, so that the greater one has the difference more left.
    x_storage.pair_left[slot] += sct_us - srvt_us;
    x_storage.pair_limit[slot] = sct_us;
}

void Channel::Demote(SlotIndex slot) noexcept
{
    if ((x_storage.marks->consumers & BitOf(slot)) == 0U)
    {
        return;
    }
    x_storage.marks->released &= ~BitOf(slot);
    Withdraw(x_storage.marks->acknowledged, BitOf(slot));
    Discard(slot);
    x_storage.state[slot] = Code(SrdoState::kFaulted);
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
    for (SrdoMask rest = faulted & marks.held.on; rest != 0U;)
    {
        Discard(TakeLowest(rest)); // Completed after the fault, before it was reported.
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
    for (SrdoMask rest = waiting; rest != 0U;)
    {
        x_storage.edge_left[TakeLowest(rest)] = x_config->acknowledge_window_us;
    }
    for (SrdoMask rest = taken & census.producers; rest != 0U;)
    {
        x_storage.first_cause[TakeLowest(rest)] = Code(SrdoCause::kNone);
    }
}

/// [SRS-REL-003, SRS-REL-004, SRS-REL-007]
void Channel::Release(Census& census) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask permitted = Granted(marks.automatic) | Granted(marks.acknowledged);
    const SrdoMask ready = Granted(marks.held) & ~marks.reporting & permitted;
    SrdoMask released = 0U;
    for (SrdoMask rest = (census.waiting | census.faulted) & ready; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        if (IsRecordable(x_storage.first_cause[slot]))
        {
            x_storage.state[slot] = Code(SrdoState::kReleased);
            released |= BitOf(slot);
        }
    }
    census.released |= released;
    census.waiting &= ~released;
    census.faulted &= ~released;
    const SrdoMask read = Granted(marks.acknowledged) & census.released;
    for (SrdoMask rest = read; rest != 0U;)
    {
        x_storage.first_cause[TakeLowest(rest)] = Code(SrdoCause::kNone);
    }
    Withdraw(marks.acknowledged, read);
    marks.released = census.released;
}

/// [SRS-REL-002]
void Channel::Commit(const Agreement& agreement) noexcept
{
    Marks& marks = *x_storage.marks;
    const SrdoMask released = agreement.agreed & marks.released & Granted(marks.held) & x_present;
    const SrdoMask written = released & agreement.matched & marks.unwritten;
    for (SrdoMask rest = written; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        WriteInverse(slot, x_storage.inverse_data[slot]);
    }
    for (SrdoMask rest = marks.committed & ~released & x_present; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        WriteInverse(slot, x_storage.safe_data[slot]);
    }
    marks.unwritten &= ~written;
    marks.committed = (marks.committed & released) | written;
}

} // namespace counterpoint::channel_b
