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
constexpr std::uint8_t kGfcEnabled = 1U;
constexpr std::uint32_t kWaitingPastSctBit = std::uint32_t{1U} << static_cast<std::uint8_t>(SrdoCause::kWaitingPastSct);

std::uint32_t SctUs(const Record& record) noexcept
{
    return record.values[kSctPlace] * kMicrosecondsPerMillisecond;
}

} // namespace

void Channel::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    if ((frame.kind != FrameKind::kData) || !is_active_)
    {
        return;
    }
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if (place < kSrdoIdentifierCount)
    {
        ReceiveSrdo(frame, stamp, place);
    }
    if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && (gfc_parameter_ == kGfcEnabled))
    {
        gfc_pending_ = true;
    }
}

SlotIndex Channel::SlotOfPlace(const std::uint32_t place) const noexcept
{
    return static_cast<SlotIndex>(storage_.look_up[place >> 1U] - 1U); // MISRA D-002
}

void Channel::ReceiveSrdo(const CanFrame& frame, const Instant stamp, const std::uint32_t place) noexcept
{
    const SlotIndex slot = SlotOfPlace(place);
    if (slot >= count_)
    {
        return;
    }
    const SrdoMask bit = BitOf(slot);
    Record& record = At(slot);
    if ((stamp.us - record.since.us) > record.limit_us)
    {
        Raise(record, bit, Event::kExpired, SrdoCause::kNone);
    }
    const Cell cell = Step(record, bit, Classify(record, frame, place & kHalfMask));
    if (cell.effect == Effect::kTake)
    {
        record.pending = TakenFrom(record, frame);
        record.since = stamp;
        record.limit_us = record.values[kSrvtPlace] * kMicrosecondsPerMillisecond;
    }
    else if (cell.effect == Effect::kComplete)
    {
        Complete(record, bit);
    }
    else
    {
        Suffer(record, bit, cell, SrdoCause::kNone);
    }
}

// In the order of SRS-CONS-011; what order means is the table's affair.
Event Channel::Classify(const Record& record, const CanFrame& frame, const std::uint32_t half) const noexcept
{
    if ((frame.identifier != record.values[kCobIdPlace + half]) || (frame.port != ports_[half]))
    {
        return Event::kWrongIdentifier;
    }
    if (frame.length_bytes != record.length_bytes)
    {
        return Event::kWrongLength;
    }
    if (half == 0U)
    {
        return Event::kNormal;
    }
    const bool is_inverse = Difference(record, frame, record.pending, kInverted) == 0U;
    return is_inverse ? Event::kInverse : Event::kNotInverse;
}

void Channel::Complete(Record& record, const SrdoMask bit) noexcept
{
    record.held = record.pending;
    record.limit_us = SctUs(record);
    record.awaiting = kUnmarked;
    ++record.ordinal;
    ++ordinal_sum_;
    fresh_ |= bit;
    written_ &= ~bit;
    attention_ |= bit & ~groups_[kGroupReleased]; // A released slot has nothing to decide.
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
        MoveTo(bit, kModeFacts[RowOf(record.mode)].group); // The old mode cannot be trusted to tell the old group.
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
    const Cell cell = Step(record, bit, Event::kDiscard);
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
