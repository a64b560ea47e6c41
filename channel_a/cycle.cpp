// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// One cycle: OPERATIONAL first, then what comes from outside is noted at the slots it is for, then one loop that passes
// over every slot with nothing to do and serves the few others. After it the release.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kTokenRotation = 8U;
constexpr std::uint32_t kEachByte = 0x01010101U;
constexpr std::uint32_t kPermitRotation = 16U;
constexpr std::uint32_t kLongAgoUs = 0x80000000U; // As far as instants have a difference.
constexpr std::uint32_t kWaitingPastSctBit = std::uint32_t{1U} << static_cast<std::uint8_t>(SrdoCause::kWaitingPastSct);

// [SRS_CFG_031]
GuardView GuardOf(const CycleInput& input, const std::uint8_t configuration_valid) noexcept
{
    const std::uint32_t rotated =
        (input.challenge << kTokenRotation) | (input.challenge >> (kBitsPerWord - kTokenRotation));
    GuardView view = GuardView::kStale;
    if (input.guard_token == (rotated ^ (configuration_valid * kEachByte)))
    {
        view = (configuration_valid == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
    }
    return view;
}

// [SRS_CONS_002]
void FollowOperational(Voice& voice, const NmtState nmt) noexcept
{
    const bool is_active = (nmt == NmtState::kOperational) && (voice.outcome.guard == GuardView::kConfigured);
    if (is_active == IsActive(voice))
    {
        return;
    }
    if (is_active)
    {
        Enter(voice);
        return;
    }
    Leave(voice);
}

// Every active consumer is to be looked at, and whatever else there is.
void DemandAll(const Voice& voice) noexcept
{
    for (std::size_t slot = 0U; slot < voice.count; ++slot)
    {
        Demand(At(voice, slot), kLook);
    }
}

// The phase of those producers that are called. [SRS_PROD_012]
void Shift(const Voice& voice, const SrdoMask standing) noexcept
{
    SrdoMask left = standing;
    while (left != 0U)
    {
        Record& record = At(voice, TakeLowest(left));
        if (record.form == ProducerForm::kProviderCalled)
        {
            record.since.us += voice.step_us;
        }
    }
}

// An edge at a slot that is off is forgotten when it is served. [SRS_REL_005]
void NoteEdges(Voice& voice, const SrdoMask levels) noexcept
{
    SrdoMask edges = levels & ~voice.levels;
    voice.levels = levels;
    while (edges != 0U)
    {
        const std::size_t slot = TakeLowest(edges);
        if (slot < voice.count)
        {
            Record& record = At(voice, slot);
            record.edge = kMarked;
            record.edge_since = voice.now;
            Demand(record, kLook);
        }
    }
}

// A corrupted record: a consumer is faulted, everything else is off.
void Break(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    if (Is(record, kConsumer))
    {
        Fail(voice, slot, SrdoCause::kInvalid);
        return;
    }
    if (Is(record, kProducer))
    {
        Report(record, SrdoCause::kInvalid);
    }
    Turn(voice, slot, kOff);
    record.limit_us = kNoLimit;
    record.ordinal = 0U;
}

void ExamineConsumer(Voice& voice, const Record& record, const std::size_t slot) noexcept
{
    SrdoCause cause = ExpiredLimit(record, voice.now, 0U);
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
// SRS_REL_005, SRS_REL_006, SRS_REL_007]
void Acknowledge(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    if ((voice.now.us - record.edge_since.us) > voice.config->acknowledge_window_us)
    {
        record.edge = kUnmarked;
    }
    const bool has_edge = record.edge == kMarked;
    if (Is(record, kHeld) && (has_edge || (record.policy == ReleasePolicy::kAutomatic)))
    {
        Turn(voice, slot, (record.mode & (kPending | kHeld)) | kReleased);
    }
    if (has_edge && Is(record, kReleased))
    {
        SetFirstCause(record, SrdoCause::kNone);
        record.edge = kUnmarked;
    }
}

// t      frames of this cycle        now
//        faults in bus order | SRVT or SCT, late call, overflow, GFC | report: nothing held, or acknowledge and release
// Returns what else is to be signalled.
std::uint32_t ServeConsumer(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    ExamineConsumer(voice, record, slot);
    if ((voice.now.us - record.frame_since.us) > kLongAgoUs)
    {
        record.frame_since.us = voice.now.us - kLongAgoUs; // Still too old, however long it waits.
    }
    if (record.unreported != 0U)
    {
        Drop(voice, slot, kPending);
        Put(voice.outcome.new_fault, slot, 1U);
    }
    else
    {
        Acknowledge(voice, record, slot);
    }
    if ((record.awaiting == kMarked) && ((voice.now.us - voice.entered.us) > SctUs(record)))
    {
        record.awaiting = kUnmarked;
        return kWaitingPastSctBit;
    }
    return 0U;
}

// Due already, or in flight: the refresh that falls due now is skipped. [SRS_PROD_010]
void Refresh(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    record.since.us += SctUs(record); // Exact addition keeps the phase. [SRS_PROD_002]
    if (Is(record, kFlying) || ((record.refreshed == kMarked)))
    {
        Report(record, SrdoCause::kRefreshMissed);
        return;
    }
    record.refreshed = kMarked;
    Put(voice.wanted, slot, 1U);
    Put(voice.outcome.due, slot, 1U);
}

// The limit of a producer is its next refresh.
void ExamineSending(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    const bool is_called = record.form == ProducerForm::kProviderCalled;
    record.limit_us = SctUs(record) + (is_called ? 0U : voice.late_after_us);
    if (!voice.may_send || !IsExpired(record, voice.now))
    {
        return;
    }
    if (is_called)
    {
        Refresh(voice, record, slot);
    }
    else if ((voice.wanted & BitOf(slot)) != 0U)
    {
        record.since.us = voice.now.us - (record.limit_us + 1U); // Still too long ago, however long the request waits.
    }
    else
    {
        record.since = voice.now;
        Report(record, SrdoCause::kRefreshMissed);
    }
}

void ServeProducer(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    if ((voice.now.us - record.frame_since.us) > SrvtUs(record))
    {
        Abort(record, SrdoCause::kNoConfirmation); // [SRS_PROD_008]
    }
    if (Is(record, kFlying))
    {
        Put(voice.outcome.due, slot, 0U);
    }
    ExamineSending(voice, record, slot);
    if ((record.edge == kMarked) && (record.unreported == 0U))
    {
        SetFirstCause(record, SrdoCause::kNone);
    }
    record.edge = kUnmarked;
}

// Each cause once in a window of SCT. [SRS_CONS_021]
void Signal(Voice& voice, Record& record, const std::size_t slot, const std::uint32_t extra) noexcept
{
    if ((voice.now.us - record.told_since.us) > SctUs(record))
    {
        record.told = 0U;
    }
    record.signals = (record.unreported | extra) & ~record.told;
    record.unreported = 0U;
    if (record.signals != 0U)
    {
        record.told_since = (record.told == 0U) ? voice.now : record.told_since;
        record.told |= record.signals;
        Put(voice.outcome.signalled, slot, 1U);
    }
}

void Serve(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    record.todo = static_cast<std::uint8_t>(record.todo & ~kLook);
    if (!IsSealed(record))
    {
        Break(voice, record, slot);
    }
    std::uint32_t extra = 0U;
    if (Is(record, kConsumer))
    {
        extra = ServeConsumer(voice, record, slot);
    }
    else if (Is(record, kProducer))
    {
        ServeProducer(voice, record, slot);
    }
    else
    {
        record.edge = kUnmarked; // Only what was reported before it went off is to be told.
    }
    Signal(voice, record, slot, extra);
    const std::uint32_t unfinished = record.told | record.edge | record.awaiting;
    const bool is_watched = (record.detection == SrvtDetection::kLate) && Is(record, kPending);
    if ((unfinished != 0U) || is_watched)
    {
        Demand(record, kLook);
    }
}

// The one loop over all slots. What it passes over has no limit that expired, fits its seal, and has nothing to tell,
// to wait for or to release.
void ServeAll(Voice& voice) noexcept
{
    const std::uint32_t count = voice.count;
    const Instant now = voice.now;
    const Record* record = voice.storage.records;
    for (std::size_t slot = 0U; slot < count; ++slot)
    {
        if ((record->todo != 0U) || IsExpired(*record, now) || !IsSealed(*record))
        {
            Serve(voice, At(voice, slot), slot);
        }
        ++record; // MISRA D-002
    }
}

} // namespace

CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    Voice& voice = voice_;
    CycleOutcome& outcome = voice.outcome;
    voice.step_us = input.now.us - voice.now.us;
    voice.is_late = voice.has_run && (voice.step_us > voice.late_after_us);
    voice.has_overflow = input.queue != QueueState::kIntact;
    voice.has_run = true;
    voice.now = input.now;
    ++outcome.cycle;
    outcome.guard = GuardOf(input, voice.globals[kConfigurationValidPlace]);

    FollowOperational(voice, input.nmt);
    if (voice.may_send)
    {
        Shift(voice, input.stand & voice.producers);
    }
    if ((voice.now.us - voice.entered.us) >= voice.first_delay_us)
    {
        voice.may_send = true; // Kept: the difference wraps after 71 minutes.
    }
    voice.origin = voice.may_send ? voice.now : voice.origin;
    voice.wanted = (voice.wanted | input.request) & voice.producers;
    outcome.due = voice.may_send ? voice.wanted : 0U;
    NoteEdges(voice, input.acknowledge);
    if (voice.is_late || voice.has_overflow || voice.gfc_pending)
    {
        DemandAll(voice);
    }
    ServeAll(voice);
    voice.gfc_pending = false;

    const CycleOutcome result = outcome;
    voice.unwritten |= outcome.fresh;
    outcome.fresh = 0U;
    outcome.new_fault = 0U;
    outcome.signalled = 0U;
    return result;
}

void Channel::Commit(const Agreement& agreement) noexcept
{
    const SrdoMask own = agreement.agreed & voice_.outcome.released;
    SrdoMask to_write = own & agreement.matched & (voice_.unwritten | voice_.outcome.fresh);
    SrdoMask to_drop = voice_.committed & ~own;
    voice_.unwritten &= ~to_write;
    voice_.committed = (voice_.committed | to_write) & ~to_drop;
    while (to_write != 0U)
    {
        const std::size_t slot = TakeLowest(to_write);
        WriteObjects(voice_, slot, At(voice_, slot).held);
    }
    while (to_drop != 0U)
    {
        const std::size_t slot = TakeLowest(to_drop);
        WriteObjects(voice_, slot, At(voice_, slot).safe);
    }
}

Permit Channel::Answer(const std::uint32_t challenge) const noexcept
{
    Permit permit{};
    permit.mask = IsActive(voice_) ? voice_.committed : 0U;
    const std::uint32_t low = LowOf(permit.mask);
    const std::uint32_t high = HighOf(permit.mask);
    permit.response = ((challenge + low) ^ ((high << kPermitRotation) | (high >> kPermitRotation))) * kPermitConstantA;
    return permit;
}

} // namespace counterpoint::channel_a
