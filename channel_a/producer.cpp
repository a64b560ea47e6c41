// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/producer.hpp"

#include "channel_a/objects.hpp"
#include "channel_a/slot.hpp"

#include <cstdint>

namespace counterpoint::channel_a
{
namespace
{

constexpr Confirmation kNotOurs{kNoSlot, ConfirmStep::kNone};

bool IsFlying(const Record& record) noexcept
{
    return FactsOf(record).is_flying;
}

// The one before still waits: the refresh that falls due now is skipped. [SRS_PROD_010, SRS_PROD_013]
void Refresh(Record& record) noexcept
{
    record.since.us += SctUs(record); // Exact addition keeps the phase. [SRS_PROD_002]
    if (record.refreshed == kYes)
    {
        Report(record, SrdoCause::kRefreshMissed);
        return;
    }
    record.refreshed = kYes;
}

// The limit of a producer is its next refresh; where that stands it moves on and is not examined. [SRS_PROD_012]
void ExamineRefresh(const Voice& voice, const std::size_t slot, const bool stands) noexcept
{
    Record& record = At(voice, slot);
    const bool is_called = record.form == ProducerForm::kProviderCalled;
    record.limit_us = SctUs(record) + (is_called ? 0U : voice.late_after_us);
    if (stands)
    {
        record.since.us += voice.step_us;
        return;
    }
    if (!voice.may_send || !IsExpired(record, voice.now))
    {
        return;
    }
    if (is_called)
    {
        Refresh(record);
    }
    else if (IsIn(voice.wanted, slot))
    {
        record.since.us = voice.now.us - (record.limit_us + 1U); // Still too long ago, however long the request waits.
    }
    else
    {
        record.since = voice.now;
        Report(record, SrdoCause::kRefreshMissed);
    }
}

// What waits is a refresh, or what is asked for; it goes on waiting while a pair is in flight. [SRS_PROD_004,
// SRS_PROD_013]
void TellWhatWaits(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    const bool has_refresh = record.refreshed == kYes;
    if (has_refresh)
    {
        Demand(record, kLook); // Until it is prepared.
        PutIn(voice.outcome.refresh, slot);
    }
    const bool is_due = voice.may_send && (has_refresh || IsIn(voice.wanted, slot));
    if (is_due && !IsFlying(record))
    {
        PutIn(voice.outcome.due, slot);
    }
}

// One half of the pair in flight: what was read, or with an inversion of FFh its inverse; bytes behind the length stay
// 0. Bits of the last byte that are not mapped were read as 0. [SRS_PROD_005, SRS_PROD_006]
CanFrame FrameOf(const Voice& voice, const Record& record, const std::size_t half,
                 const std::uint32_t inversion) noexcept
{
    CanFrame frame{};
    frame.identifier = record.values.cob_id[half];
    frame.kind = FrameKind::kData;
    frame.port = voice.ports[half];
    frame.length_bytes = record.grants.Of(Grant::kLength);
    for (std::size_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        const std::uint32_t inverted = inversion & record.mapped.at[place];
        frame.data[place] = static_cast<std::uint8_t>(record.held.at[place] ^ inverted);
    }
    return frame;
}

// Why a frame is not the confirmation that is awaited: its data, or its stamp, SRVT after the start of the pair or the
// normal frame. [SRS_PROD_007, SRS_PROD_008]
SrdoCause JudgeEcho(const Record& record, const CanFrame& frame, const Instant stamp, const State awaited) noexcept
{
    const std::uint32_t inversion = (awaited == State::kInverseAwaited) ? kByteMask : 0U;
    if ((frame.length_bytes != record.grants.Of(Grant::kLength)) ||
        !HasData(frame, record.held, inversion, record.mapped))
    {
        return SrdoCause::kWrongEcho;
    }
    return (AgeUs(record.frame_since, stamp) > SrvtUs(record)) ? SrdoCause::kNoConfirmation : SrdoCause::kNone;
}

} // namespace

void GiveUp(Voice& voice, const std::size_t slot, const SrdoCause cause) noexcept
{
    Record& record = At(voice, slot);
    if (IsFlying(record))
    {
        static_cast<void>(Advance(voice, record, slot, StateOf(record), Event::kGivenUp));
        record.todo = 0U;
        Report(record, cause);
    }
}

// The refresh is examined beside what waited before this call: a request of this one hides no fault. [SRS_PROD_010]
void ServeProducer(Voice& voice, const std::size_t slot, const Asked& asked) noexcept
{
    Record& record = At(voice, slot);
    if (AgeUs(record.frame_since, voice.now) > SrvtUs(record))
    {
        GiveUp(voice, slot, SrdoCause::kNoConfirmation); // [SRS_PROD_008]
    }
    ExamineRefresh(voice, slot, IsIn(asked.standing, slot));
    voice.wanted |= asked.requested & BitOf(slot);
    TellWhatWaits(voice, slot);
    if (record.grants.Is(Grant::kEdge, kYes) && (record.unreported == 0U))
    {
        SetFirstCause(record, SrdoCause::kNone);
    }
    record.grants.Set(Grant::kEdge, kNo);
}

// What was read is what is sent, once it is confirmed. [SRS_PROD_005, SRS_PROD_006]
PreparedPair PreparePair(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    const State state = StateOf(record);
    if (state != State::kIdle)
    {
        return PreparedPair{CanFrame{}, PrepareStatus::kNotProducer};
    }
    static_cast<void>(Advance(voice, record, slot, state, Event::kPrepared));
    Demand(record, kInFlight);
    record.held = ReadObjects(voice, slot);
    record.refreshed = kNo; // [SRS_PROD_013]
    record.frame_since = voice.now;
    if (record.form != ProducerForm::kProviderCalled)
    {
        record.since = voice.origin;
    }
    voice.wanted &= ~BitOf(slot);
    return PreparedPair{FrameOf(voice, record, kNormalHalf, 0U), PrepareStatus::kReady};
}

// [SRS_PROD_006, SRS_PROD_011]
CanFrame InverseOf(const Voice& voice, const std::size_t slot) noexcept
{
    const Record& record = At(voice, slot);
    return (StateOf(record) == State::kInverseAwaited) ? FrameOf(voice, record, kInverseHalf, kByteMask) : CanFrame{};
}

// Each of the two frames is awaited in a state of its own; an identifier that is none of an SRDO is not that of the
// slot that it leads to. [SRS_PROD_007, SRS_PROD_008]
Confirmation ConfirmFrame(Voice& voice, const CanFrame& frame, const Instant stamp) noexcept
{
    const std::size_t slot = LookUp(voice, frame.identifier);
    if ((slot >= voice.count) || (frame.kind != FrameKind::kData))
    {
        return kNotOurs;
    }
    Record& record = At(voice, slot);
    const State awaited = StateOf(record);
    const std::size_t half = (awaited == State::kInverseAwaited) ? kInverseHalf : kNormalHalf;
    if (!FactsOf(awaited).is_flying || (frame.identifier != record.values.cob_id[half]))
    {
        return kNotOurs;
    }
    const SrdoCause cause = JudgeEcho(record, frame, stamp, awaited);
    if (cause != SrdoCause::kNone)
    {
        GiveUp(voice, slot, cause);
        return kNotOurs;
    }
    if (awaited == State::kNormalAwaited)
    {
        static_cast<void>(Advance(voice, record, slot, awaited, Event::kNormalSent));
        record.frame_since = stamp;
        return Confirmation{static_cast<SlotIndex>(slot), ConfirmStep::kNormal};
    }
    static_cast<void>(Advance(voice, record, slot, awaited, Event::kPairSent));
    record.todo = static_cast<std::uint8_t>(record.todo & ~kInFlight);
    ++record.sent;
    return Confirmation{static_cast<SlotIndex>(slot), ConfirmStep::kPair};
}

} // namespace counterpoint::channel_a
