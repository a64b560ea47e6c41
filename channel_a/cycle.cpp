// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstdint>

// One cycle: OPERATIONAL first, then a scan that finds the few slots that have something to do, then those. After it
// the release.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kTokenRotation = 8U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kEachByte = 0x01010101U;
constexpr std::uint32_t kPermitRotation = 16U;
constexpr std::uint32_t kLongAgoUs = 0x80000000U; // As far as instants have a difference.
constexpr std::uint32_t kWaitingPastSctBit = std::uint32_t{1U} << static_cast<std::uint8_t>(SrdoCause::kWaitingPastSct);

// [SRS-CFG-031]
GuardView GuardOf(const CycleInput& input, const std::uint8_t configuration_valid) noexcept
{
    const std::uint32_t rotated =
        (input.challenge << kTokenRotation) | (input.challenge >> (kWordBits - kTokenRotation));
    GuardView view = GuardView::kStale;
    if (input.guard_token == (rotated ^ (configuration_valid * kEachByte)))
    {
        view = (configuration_valid == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
    }
    return view;
}

// [SRS-CONS-002]
void FollowOperational(Voice& voice, const bool is_active) noexcept
{
    if (is_active && !voice.is_active)
    {
        Enter(voice, voice.now);
    }
    if (!is_active && voice.is_active)
    {
        voice.new_fault = ConsumersOf(voice);
        Leave(voice);
    }
    voice.is_active = is_active;
}

// Finds the producers that still wait for a confirmation after SRVT. [SRS-PROD-008]
void ScanFlying(Voice& voice) noexcept
{
    SrdoMask flying = voice.flying;
    while (flying != 0U)
    {
        const std::uint32_t slot = TakeLowest(flying);
        const Record& record = At(voice, slot);
        if ((voice.now.us - record.frame_since.us) > SrvtUs(record))
        {
            Mark(voice, slot);
        }
    }
}

// The one loop over all slots. What it passes over has no limit that expired, fits its seal, and has nothing to tell,
// to wait for or to release.
void ScanLimits(Voice& voice) noexcept
{
    // A new pair is of interest to a slot that is not released yet.
    voice.attention |=
        (voice.edges & ~voice.groups[kGroupOff]) | voice.standing | (voice.fresh & ~voice.groups[kGroupReleased]);
    if (voice.is_late || voice.has_overflow || voice.has_gfc)
    {
        voice.attention |= ConsumersOf(voice);
    }
    const std::uint32_t count = voice.count;
    const Record* record = voice.storage.records;
    for (std::uint32_t slot = 0U; slot < count; ++slot)
    {
        if (IsExpired(*record, voice.now) || !IsSealed(*record))
        {
            Mark(voice, slot);
        }
        ++record; // MISRA D-002
    }
}

// A corrupted record; its old mode cannot be trusted to tell its old group.
void Break(Voice& voice, const std::uint32_t slot) noexcept
{
    Raise(voice, slot, Event::kCorrupted, SrdoCause::kNone);
    MoveTo(voice, BitOf(slot), FactsOf(At(voice, slot).mode).group);
}

void ExamineConsumer(Voice& voice, const std::uint32_t slot) noexcept
{
    const Record& record = At(voice, slot);
    if (!IsSealed(record))
    {
        Break(voice, slot);
    }
    const bool is_expired = IsExpired(record, voice.now);
    if (is_expired)
    {
        Expire(voice, slot, voice.now, Half::kNormal);
    }
    if (voice.is_late && !is_expired)
    {
        Raise(voice, slot, Event::kError, SrdoCause::kLateCall);
    }
    if (voice.has_overflow)
    {
        Raise(voice, slot, Event::kError, SrdoCause::kQueueOverflow);
    }
    if (voice.has_gfc)
    {
        Raise(voice, slot, Event::kError, SrdoCause::kGfc);
    }
}

// An edge is good for a release until its window is over, and for nothing afterwards. [SRS-REL-003..007]
void Acknowledge(Voice& voice, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    const SrdoMask bit = BitOf(slot);
    if ((voice.edges & bit) != 0U)
    {
        record.edge = kMarked;
        record.edge_since = voice.now;
    }
    if ((voice.now.us - record.edge_since.us) > voice.config->acknowledge_window_us)
    {
        record.edge = kUnmarked;
    }
    const bool has_edge = record.edge == kMarked;
    if (has_edge || (record.policy == ReleasePolicy::kAutomatic))
    {
        Raise(voice, slot, Event::kRelease, SrdoCause::kNone);
    }
    if (has_edge && ((voice.groups[kGroupReleased] & bit) != 0U))
    {
        SetFirstCause(record, SrdoCause::kNone);
        record.edge = kUnmarked;
    }
}

// t      frames of this cycle        now
//        faults in bus order | SRVT or SCT, late call, overflow, GFC | report: nothing held, or acknowledge and release
// Returns what else is to be signalled.
std::uint32_t ServeConsumer(Voice& voice, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    ExamineConsumer(voice, slot);
    if ((voice.now.us - record.frame_since.us) > kLongAgoUs)
    {
        record.frame_since.us = voice.now.us - kLongAgoUs; // Still too old, however long it waits.
    }
    if (record.unreported != 0U)
    {
        Raise(voice, slot, Event::kDiscard, SrdoCause::kNone);
        voice.new_fault |= BitOf(slot);
    }
    else
    {
        Acknowledge(voice, slot);
    }
    std::uint32_t extra = 0U;
    if ((record.awaiting == kMarked) && ((voice.now.us - voice.entered.us) > SctUs(record)))
    {
        record.awaiting = kUnmarked;
        extra = kWaitingPastSctBit;
    }
    return extra;
}

// Exact addition keeps the phase. A refresh that cannot be is skipped. [SRS-PROD-002]
void Refresh(Voice& voice, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    const SrdoMask bit = BitOf(slot);
    record.since.us += SctUs(record);
    if (((voice.flying | voice.refreshed) & bit) != 0U)
    {
        Report(voice, slot, SrdoCause::kRefreshMissed);
    }
    else
    {
        voice.refreshed |= bit;
    }
}

// The limit of a producer is its next refresh. [SRS-PROD-010]
void ExamineSending(Voice& voice, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    const SrdoMask bit = BitOf(slot);
    const bool is_called = record.form == ProducerForm::kProviderCalled;
    if (is_called && ((voice.standing & bit) != 0U))
    {
        record.since.us += voice.step_us;
    }
    record.limit_us = SctUs(record) + (is_called ? 0U : voice.late_after_us);
    if (!voice.may_send || ((voice.now.us - record.since.us) <= record.limit_us))
    {
        return;
    }
    if (is_called)
    {
        Refresh(voice, slot);
    }
    else if ((voice.requested & bit) != 0U)
    {
        record.since.us = voice.now.us - (record.limit_us + 1U); // Still too long ago, however long the request waits.
    }
    else
    {
        record.since = voice.now;
        Report(voice, slot, SrdoCause::kRefreshMissed);
    }
}

void ServeProducer(Voice& voice, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    if (!IsSealed(record))
    {
        Break(voice, slot);
        record.limit_us = kNoLimit;
        record.ordinal = 0U;
        return;
    }
    if ((voice.now.us - record.frame_since.us) > SrvtUs(record))
    {
        Raise(voice, slot, Event::kAbort, SrdoCause::kNoConfirmation); // Without effect where nothing is in flight.
    }
    ExamineSending(voice, slot);
    if (((voice.edges & BitOf(slot)) != 0U) && (record.unreported == 0U))
    {
        SetFirstCause(record, SrdoCause::kNone);
    }
}

// Each cause once in a window of SCT. [SRS-CONS-021]
void Signal(Voice& voice, Record& record, const SrdoMask bit, const std::uint32_t extra) noexcept
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
        voice.signalled |= bit;
    }
}

void Serve(Voice& voice, const std::uint32_t slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    Record& record = At(voice, slot);
    std::uint32_t extra = 0U;
    if ((voice.groups[kGroupProducer] & bit) != 0U)
    {
        ServeProducer(voice, slot);
    }
    else if ((voice.groups[kGroupOff] & bit) == 0U)
    {
        extra = ServeConsumer(voice, slot);
    }
    else
    {
        // Only what was reported before it went off is to be told.
    }
    Signal(voice, record, bit, extra);
    const std::uint32_t unfinished = record.told | record.edge | record.awaiting;
    const bool is_watched = (record.detection == SrvtDetection::kLate) && HasFirstFrame(record.mode);
    voice.attention |= ((unfinished != 0U) || is_watched) ? bit : 0U;
}

// Due: asked for or refreshed, and nothing in flight. [SRS-PROD-004]
SrdoMask DueOf(const Voice& voice) noexcept
{
    const SrdoMask due = (voice.requested | voice.refreshed) & voice.groups[kGroupProducer] & ~voice.flying;
    return voice.may_send ? due : 0U;
}

} // namespace

CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    const GuardView guard = GuardOf(input, voice_.globals[kConfigurationValidPlace]);
    voice_.step_us = input.now.us - voice_.now.us;
    voice_.is_late = voice_.has_run && (voice_.step_us > voice_.late_after_us);
    voice_.has_overflow = input.queue != QueueState::kIntact;
    voice_.has_gfc = voice_.gfc_pending;
    voice_.edges = input.acknowledge & ~voice_.levels;
    voice_.new_fault = 0U;
    voice_.signalled = 0U;
    voice_.levels = input.acknowledge;
    voice_.has_run = true;
    voice_.gfc_pending = false;
    voice_.now = input.now;
    ++voice_.cycle;

    const bool is_active = (input.nmt == NmtState::kOperational) && (guard == GuardView::kConfigured);
    FollowOperational(voice_, is_active);
    voice_.requested |= input.request & voice_.groups[kGroupProducer];
    voice_.standing = voice_.may_send ? (input.stand & voice_.groups[kGroupProducer]) : 0U;
    if ((voice_.now.us - voice_.entered.us) >= voice_.first_delay_us)
    {
        voice_.may_send = true; // Kept: the difference wraps after 71 minutes.
    }
    ScanFlying(voice_);
    ScanLimits(voice_);
    SrdoMask to_serve = voice_.attention;
    voice_.attention = 0U;
    while (to_serve != 0U)
    {
        Serve(voice_, TakeLowest(to_serve));
    }

    CycleOutcome outcome{};
    outcome.released = voice_.groups[kGroupReleased];
    outcome.faulted = voice_.groups[kGroupFaulted];
    outcome.waiting = voice_.groups[kGroupWaiting];
    outcome.new_fault = voice_.new_fault;
    outcome.fresh = voice_.fresh;
    outcome.due = DueOf(voice_);
    outcome.signalled = voice_.signalled;
    outcome.cycle = voice_.cycle;
    outcome.ordinal_sum = voice_.ordinal_sum;
    outcome.guard = guard;
    outcome.sct_checked = voice_.consumer_count;
    outcome.is_tx = voice_.producer_count;
    outcome.is_invalid = voice_.off_count;
    outcome.not_operational = voice_.is_active ? 0U : 1U;
    voice_.unwritten |= voice_.fresh;
    voice_.fresh = 0U;
    return outcome;
}

void Channel::Commit(const Agreement& agreement) noexcept
{
    const SrdoMask own = agreement.agreed & voice_.groups[kGroupReleased];
    SrdoMask to_write = own & agreement.matched & (voice_.unwritten | voice_.fresh);
    SrdoMask to_drop = voice_.committed & ~own;
    voice_.unwritten &= ~to_write;
    voice_.committed = (voice_.committed | to_write) & ~to_drop;
    while (to_write != 0U)
    {
        const std::uint32_t slot = TakeLowest(to_write);
        WriteObjects(voice_, slot, At(voice_, slot).held);
    }
    while (to_drop != 0U)
    {
        const std::uint32_t slot = TakeLowest(to_drop);
        WriteObjects(voice_, slot, At(voice_, slot).safe);
    }
}

Permit Channel::Answer(const std::uint32_t challenge) const noexcept
{
    Permit permit{};
    permit.mask = voice_.committed & ConsumersOf(voice_);
    const std::uint32_t low = static_cast<std::uint32_t>(permit.mask);
    const std::uint32_t high = static_cast<std::uint32_t>(permit.mask >> kWordBits);
    permit.response = ((challenge + low) ^ ((high << kPermitRotation) | (high >> kPermitRotation))) * kPermitConstantA;
    return permit;
}

} // namespace counterpoint::channel_a
