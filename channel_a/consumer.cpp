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

// In the order of SRS-CONS-011; what order means is the table's affair.
Event Classify(const Record& record, const CanFrame& frame, const Ports& ports) noexcept
{
    const std::uint32_t half = ~frame.identifier & kHalfMask; // Identifiers of normal frames are odd.
    Event event = Event::kNormal;
    if ((frame.identifier != record.values[kCobIdPlace + half]) || (frame.port != ports.of_half[half]))
    {
        event = Event::kWrongIdentifier;
    }
    else if (frame.length_bytes != record.length_bytes)
    {
        event = Event::kWrongLength;
    }
    else if (half != 0U)
    {
        event = IsEqual(record, frame, record.pending, kInverted) ? Event::kInverse : Event::kNotInverse;
    }
    else
    {
        // Nothing else can be wrong with a normal frame in itself.
    }
    return event;
}

} // namespace

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
    const Record& record = At(slot);
    if ((stamp.us - record.since.us) > record.limit_us)
    {
        ReceiveLate(frame, stamp, slot);
        return;
    }
    ReceiveInTime(frame, stamp, slot);
}

void Channel::ReceiveOther(const CanFrame& frame) noexcept
{
    if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && (gfc_parameter_ == kGfcEnabled))
    {
        gfc_pending_ = true;
    }
}

// The limit first; the frame is then taken as if nothing had been there before it.
void Channel::ReceiveLate(const CanFrame& frame, const Instant stamp, const SlotIndex slot) noexcept
{
    Raise(At(slot), BitOf(slot), Event::kExpired, SrdoCause::kNone);
    ReceiveInTime(frame, stamp, slot);
}

// The common cells stay within their group of modes, so only the mode itself is set for them.
void Channel::ReceiveInTime(const CanFrame& frame, const Instant stamp, const SlotIndex slot) noexcept
{
    Record& record = At(slot);
    const Event event = Classify(record, frame, ports_);
    const Cell& cell = NextCell(record.mode, event);
    if (cell.effect == Effect::kTake)
    {
        SetMode(record, cell.next);
        record.pending = TakenFrom(record, frame);
        record.since = stamp;
        record.limit_us = record.values[kSrvtPlace] * kMicrosecondsPerMillisecond;
    }
    else if (cell.effect == Effect::kComplete)
    {
        SetMode(record, cell.next);
        Complete(record, BitOf(slot));
    }
    else
    {
        Raise(record, BitOf(slot), event, SrdoCause::kNone);
    }
}

void Channel::Complete(Record& record, const SrdoMask bit) noexcept
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
