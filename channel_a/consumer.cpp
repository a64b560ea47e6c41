// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"

#include <cstdint>

// Frames of consumers, their limits, acknowledge and release.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kHalfMask = 1U; // Of the place of an identifier: 0 the normal, 1 the inverse frame.
constexpr std::uint32_t kWaitingPastSctBit = std::uint32_t{1U} << static_cast<std::uint8_t>(SrdoCause::kWaitingPastSct);

std::uint32_t SctUs(const Record& record) noexcept
{
    return record.values[kSctPlace] * kMicrosecondsPerMillisecond;
}

} // namespace

// What is not the common case is done elsewhere (cycle.cpp), so that this one needs no registers saved.
void Channel::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if ((frame.kind != FrameKind::kData) || !is_active_)
    {
        return;
    }
    if (place >= kSrdoIdentifierCount)
    {
        ReceiveOther(frame);
        return;
    }
    const SlotIndex slot = SlotOfPlace(place);
    if (slot >= count_)
    {
        return;
    }
    Record& record = At(slot);
    if ((stamp.us - record.since.us) > record.limit_us)
    {
        ReceiveLate(frame, stamp, slot);
        return;
    }
    ReceiveInTime(frame, stamp, slot, record);
}

// In the order of SRS-CONS-011; what order of frames means is the table's affair.
void Channel::ReceiveInTime(const CanFrame& frame, const Instant stamp, const SlotIndex slot, Record& record) noexcept
{
    const std::uint32_t half = ~frame.identifier & kHalfMask; // Identifiers of normal frames are odd.
    if ((frame.identifier != record.values[kCobIdPlace + half]) || (frame.port != ports_.of_half[half]))
    {
        RaiseAt(slot, Event::kWrongIdentifier);
        return;
    }
    if (frame.length_bytes != record.length_bytes)
    {
        RaiseAt(slot, Event::kWrongLength);
        return;
    }
    if (half == 0U)
    {
        ReceiveNormal(frame, stamp, slot, record);
    }
    else
    {
        ReceiveInverse(frame, slot, record);
    }
}

// The common cells of both halves stay within their group of modes.
inline void Channel::ReceiveNormal(const CanFrame& frame, const Instant stamp, const SlotIndex slot,
                                   Record& record) noexcept
{
    const Cell& cell = NextCell(record.mode, Event::kNormal);
    if (cell.effect != Effect::kTake)
    {
        RaiseAt(slot, Event::kNormal);
        return;
    }
    SetMode(record, cell.next);
    record.pending = TakenFrom(record, frame);
    record.since = stamp;
    record.limit_us = record.values[kSrvtPlace] * kMicrosecondsPerMillisecond;
}

inline void Channel::ReceiveInverse(const CanFrame& frame, const SlotIndex slot, Record& record) noexcept
{
    if (!IsEqual(record, frame, record.pending, kFlips[1]))
    {
        RaiseAt(slot, Event::kNotInverse);
        return;
    }
    const Cell& cell = NextCell(record.mode, Event::kInverse);
    if (cell.effect != Effect::kComplete)
    {
        RaiseAt(slot, Event::kInverse);
        return;
    }
    SetMode(record, cell.next);
    Complete(record, BitOf(slot));
}

inline void Channel::Complete(Record& record, const SrdoMask bit) noexcept
{
    record.held = record.pending;
    record.limit_us = SctUs(record);
    record.awaiting = kUnmarked;
    ++record.ordinal;
    ++ordinal_sum_;
    fresh_ |= bit;
    unwritten_ |= bit;
}

// t      frames of this cycle        now
//        faults in bus order | SRVT or SCT, late call, overflow, GFC | report: nothing held, or acknowledge and release
// Returns what else is to be signalled.
std::uint32_t Channel::ServeConsumer(Cycle& cycle, Record& record, const SrdoMask bit) noexcept
{
    ExamineConsumer(cycle, record, bit);
    if (record.unreported != 0U)
    {
        Discard(record, bit);
        cycle.new_fault |= bit;
    }
    else
    {
        Acknowledge(cycle, record, bit);
    }
    std::uint32_t extra = 0U;
    if ((record.awaiting == kMarked) && ((cycle.now.us - entered_.us) > SctUs(record)))
    {
        record.awaiting = kUnmarked;
        extra = kWaitingPastSctBit;
    }
    return extra;
}

void Channel::ExamineConsumer(const Cycle& cycle, Record& record, const SrdoMask bit) noexcept
{
    if (!IsSealed(record))
    {
        Raise(record, bit, Event::kCorrupted, SrdoCause::kNone);
        MoveTo(bit, FactsOf(record.mode).group); // The old mode cannot be trusted to tell the old group.
    }
    const bool is_expired = (cycle.now.us - record.since.us) > record.limit_us;
    if (is_expired)
    {
        Raise(record, bit, Event::kExpired, SrdoCause::kNone);
    }
    if (cycle.is_late && !is_expired)
    {
        Raise(record, bit, Event::kError, SrdoCause::kLateCall);
    }
    if (cycle.has_overflow)
    {
        Raise(record, bit, Event::kError, SrdoCause::kQueueOverflow);
    }
    if (cycle.has_gfc)
    {
        Raise(record, bit, Event::kError, SrdoCause::kGfc);
    }
}

// An edge is good for a release until its window is over, and for nothing afterwards. [SRS-REL-003..007]
void Channel::Acknowledge(const Cycle& cycle, Record& record, const SrdoMask bit) noexcept
{
    if ((cycle.edges & bit) != 0U)
    {
        record.edge = kMarked;
        record.edge_since = cycle.now;
    }
    if ((cycle.now.us - record.edge_since.us) > config_->acknowledge_window_us)
    {
        record.edge = kUnmarked;
    }
    const bool has_edge = record.edge == kMarked;
    if (has_edge || (record.policy == ReleasePolicy::kAutomatic))
    {
        Raise(record, bit, Event::kRelease, SrdoCause::kNone);
    }
    if (has_edge && ((groups_[kGroupReleased] & bit) != 0U))
    {
        SetFirstCause(record, SrdoCause::kNone);
        record.edge = kUnmarked;
    }
}

void Channel::Demote(const SlotIndex slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    if ((Consumers() & bit) != 0U)
    {
        Record& record = At(slot);
        Discard(record, bit);
        // Counted and kept like a fault, but told to nobody: the other channel has reported it. [SRS-REL-006]
        Count(record, SrdoCause::kDemoted);
    }
}

// A pending normal frame stays, with its limit.
void Channel::Discard(Record& record, const SrdoMask bit) noexcept
{
    const Cell& cell = Step(record, bit, Event::kDiscard);
    DropPair(record, bit);
    if (cell.next == Mode::kFaultedEmpty)
    {
        record.limit_us = kNoLimit;
    }
}

void Channel::DropPair(Record& record, const SrdoMask bit) noexcept
{
    ordinal_sum_ -= record.ordinal;
    record.ordinal = 0U;
    record.edge = kUnmarked;
    record.awaiting = kUnmarked;
    fresh_ &= ~bit;
}

} // namespace counterpoint::channel_a
