// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/consumer.hpp"

#include "channel_a/slot.hpp"

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint8_t kGfcEnabled = 1U;
constexpr std::uint32_t kLongAgoUs = 0x80000000U; // As far as instants have a difference.
constexpr std::uint32_t kWaitingPastSctBit = std::uint32_t{1U} << static_cast<std::uint8_t>(SrdoCause::kWaitingPastSct);

// The normal frame has the odd identifier.
std::size_t HalfOf(const CanFrame& frame) noexcept
{
    return ((frame.identifier % 2U) == 0U) ? kInverseHalf : kNormalHalf;
}

// [SRS_CONS_017]
void TakeCommand(Voice& voice, const CanFrame& frame) noexcept
{
    const bool is_gfc = (frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U);
    if (is_gfc && IsActive(voice) && (voice.gfc_parameter == kGfcEnabled))
    {
        voice.gfc_pending = true;
    }
}

// The limit that runs, if it has expired: with late detection it is always SCT. A fault that is not told yet came
// before the held pair, and SCT of such a pair never runs. [SRS_CONS_013, SRS_CONS_014, SRS_TIME_003, SRS_TIME_005,
// SRS_TIME_006, SRS_TIME_007, SRS_TIME_009]
SrdoCause ExpiredLimit(const Record& record, const bool has_pending, const Instant when) noexcept
{
    if (!IsExpired(record, when))
    {
        return SrdoCause::kNone;
    }
    if (has_pending && (record.detection != SrvtDetection::kLate))
    {
        return SrdoCause::kSrvt;
    }
    return (record.unreported == 0U) ? SrdoCause::kSct : SrdoCause::kNone;
}

// With late detection SRVT counts for an inverse frame alone; where SCT has expired as well, that which did so longer
// ago had the earlier deadline, at a tie SRVT. [SRS_TIME_008, SRS_TIME_009]
SrdoCause ExpiredLate(const Record& record, const SrdoCause limit, const Instant when) noexcept
{
    const std::uint32_t age_us = AgeUs(record.frame_since, when);
    const std::uint32_t srvt_us = SrvtUs(record);
    const std::uint32_t over_sct_us = AgeUs(record.since, when) - record.limit_us;
    const bool is_first = (limit == SrdoCause::kNone) || ((age_us - srvt_us) >= over_sct_us);
    return ((age_us > srvt_us) && is_first) ? SrdoCause::kSrvt : limit;
}

// The limit that has expired at a frame. [SRS_CONS_003]
SrdoCause ExpiredAtFrame(const Record& record, const bool has_pending, const Instant when,
                         const std::size_t half) noexcept
{
    const SrdoCause limit = ExpiredLimit(record, has_pending, when);
    const bool is_late = (record.detection == SrvtDetection::kLate) && has_pending && (half == kInverseHalf);
    return is_late ? ExpiredLate(record, limit, when) : limit;
}

// Of a frame without a byte it is the last one that there could be.
std::uint32_t LastByteOf(const Bytes& data, const std::uint32_t length_bytes) noexcept
{
    return data.at[(length_bytes + (kMaxPayloadBytes - 1U)) % kMaxPayloadBytes];
}

// Every mapped bit is inverted, and the bits above the mapped ones are 0 in the normal frame, so that they are 1 in its
// inverse. Bytes behind the length have no meaning. [SRS_CONS_009]
bool IsInverse(const Record& record, const CanFrame& frame) noexcept
{
    const std::uint32_t spare = LastByteOf(record.pending, frame.length_bytes) & record.spare_bits;
    return (spare == 0U) && HasData(frame, record.pending, kByteMask, record.mapped);
}

// What is wrong with a frame, in the order in which it is asked. [SRS_CONS_011]
SrdoCause Judge(const Voice& voice, const Record& record, const bool has_pending, const CanFrame& frame,
                const std::size_t half) noexcept
{
    if ((frame.identifier != record.values.cob_id[half]) || (frame.port != voice.ports[half]))
    {
        return SrdoCause::kIdentifier; // [SRS_CONS_004]
    }
    if (frame.length_bytes != record.grants.Of(Grant::kLength))
    {
        return SrdoCause::kLength; // [SRS_CONS_005]
    }
    if (half == kNormalHalf)
    {
        return has_pending ? SrdoCause::kNormalTwice : SrdoCause::kNone; // [SRS_CONS_007]
    }
    if (!has_pending)
    {
        return SrdoCause::kInverseFirst; // [SRS_CONS_008]
    }
    return IsInverse(record, frame) ? SrdoCause::kNone : SrdoCause::kNotInverse;
}

// With late detection SRVT has no deadline, but the slot is served until the frame has become too old or is gone.
// [SRS_CONS_006]
void Keep(Record& record, const CanFrame& frame, const Instant stamp) noexcept
{
    Bytes data{};
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        data.at[place] = static_cast<std::uint8_t>(frame.data[place] & record.mapped.at[place]);
    }
    record.pending = data;
    record.frame_since = stamp;
    if (record.detection == SrvtDetection::kLate)
    {
        Demand(record, kLook);
        return;
    }
    record.since = stamp;
    record.limit_us = SrvtUs(record);
}

// A new pair is of interest to a slot that is not released yet. [SRS_CONS_010]
void Complete(Voice& voice, Record& record, const std::size_t slot, const State state) noexcept
{
    record.held = record.pending;
    record.since = record.frame_since;
    record.limit_us = SctUs(record);
    record.awaiting = kNo;
    ++record.ordinal;
    ++voice.outcome.ordinal_sum;
    voice.outcome.fresh |= BitOf(slot);
    if (!IsReleased(state))
    {
        Demand(record, kLook);
    }
}

// [SRS_CONS_015, SRS_CONS_016, SRS_CONS_018]
void Examine(Voice& voice, const std::size_t slot) noexcept
{
    const Record& record = At(voice, slot);
    SrdoCause cause = ExpiredLimit(record, FactsOf(record).has_pending, voice.now);
    if ((cause == SrdoCause::kNone) && voice.is_late)
    {
        cause = SrdoCause::kLateCall;
    }
    if (cause != SrdoCause::kNone)
    {
        Fail(voice, slot, cause);
    }
    if (voice.has_overflow)
    {
        Fail(voice, slot, SrdoCause::kQueueOverflow);
    }
    if (voice.gfc_pending)
    {
        Fail(voice, slot, SrdoCause::kGfc);
    }
}

// An edge is good for a release until its window is over, and for nothing afterwards. [SRS_REL_003, SRS_REL_004,
// SRS_REL_005, SRS_REL_007]
void Acknowledge(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    if (AgeUs(record.edge_since, voice.now) > voice.config->acknowledge_window_us)
    {
        record.grants.Set(Grant::kEdge, kNo);
    }
    const bool has_edge = record.grants.Is(Grant::kEdge, kYes);
    const bool is_automatic = record.grants.Is(Grant::kPolicy, static_cast<std::uint8_t>(ReleasePolicy::kAutomatic));
    State state = StateOf(record);
    if (FactsOf(state).holds_pair && (has_edge || is_automatic))
    {
        state = Advance(voice, record, slot, state, Event::kRelease);
    }
    if (has_edge && IsReleased(state))
    {
        SetFirstCause(record, SrdoCause::kNone);
        record.grants.Set(Grant::kEdge, kNo);
    }
}

} // namespace

void TakeFrame(Voice& voice, const CanFrame& frame, const Instant stamp) noexcept
{
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    if (place >= kSrdoIdentifierCount)
    {
        TakeCommand(voice, frame);
        return;
    }
    const std::size_t slot = LookUp(voice, frame.identifier);
    if (slot >= voice.count)
    {
        return;
    }
    Record& record = At(voice, slot);
    State state = StateOf(record);
    if (FactsOf(state).role != Role::kConsumer)
    {
        return;
    }
    // The limit first; the frame is then taken as if nothing had been there before it.
    const std::size_t half = HalfOf(frame);
    const SrdoCause limit = ExpiredAtFrame(record, FactsOf(state).has_pending, stamp, half);
    if (limit != SrdoCause::kNone)
    {
        Fail(voice, slot, limit);
        state = StateOf(record);
    }
    const SrdoCause cause = Judge(voice, record, FactsOf(state).has_pending, frame, half);
    if (cause != SrdoCause::kNone)
    {
        Fail(voice, slot, cause);
        return;
    }
    if (half == kNormalHalf)
    {
        static_cast<void>(Advance(voice, record, slot, state, Event::kNormal));
        Keep(record, frame, stamp);
        return;
    }
    state = Advance(voice, record, slot, state, Event::kInverse);
    Complete(voice, record, slot, state);
}

// t      frames of this cycle        now
//        faults in bus order | SRVT or SCT, late call, overflow, GFC | report: nothing held, or acknowledge and release
std::uint32_t ServeConsumer(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    std::uint32_t extra = 0U;
    Examine(voice, slot);
    if (AgeUs(record.frame_since, voice.now) > kLongAgoUs)
    {
        record.frame_since.us = voice.now.us - kLongAgoUs; // Still too old, however long it waits. [SRS_TIME_009]
    }
    if (record.unreported != 0U)
    {
        Discard(voice, slot, Event::kDrop);
        PutIn(voice.outcome.new_fault, slot);
    }
    else
    {
        Acknowledge(voice, slot);
    }
    if ((record.awaiting == kYes) && (AgeUs(voice.entered, voice.now) > SctUs(record)))
    {
        record.awaiting = kNo; // [SRS_CONS_022]
        extra = kWaitingPastSctBit;
    }
    const bool is_watched = (record.detection == SrvtDetection::kLate) && FactsOf(record).has_pending;
    if (is_watched || (record.awaiting == kYes))
    {
        Demand(record, kLook);
    }
    return extra;
}

// Counted and kept like a fault, but told to nobody: the other channel has reported it.
void DemoteConsumer(Voice& voice, const std::size_t slot) noexcept
{
    if (FactsOf(At(voice, slot)).role == Role::kConsumer)
    {
        Discard(voice, slot, Event::kDrop);
        Count(At(voice, slot), SrdoCause::kDemoted);
    }
}

} // namespace counterpoint::channel_a
