// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/cycle.hpp"

#include "channel_a/commit.hpp"
#include "channel_a/consumer.hpp"
#include "channel_a/producer.hpp"
#include "channel_a/slot.hpp"
#include "channel_a/slot_walk.hpp"

#include <cstddef>

// OPERATIONAL first, then what comes from outside is noted at the slots it is for, then one loop that passes over every
// slot with nothing to do and serves the few others.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kBitsPerWord = 32U;
constexpr std::uint32_t kPermitRotation = 16U;
// Byte by byte: the token is the challenge moved up by a byte, its highest byte then being the lowest, and in every
// byte what the configuration is. [SRS_CFG_031]
GuardView GuardOf(const CycleInput& input, const std::uint8_t configuration_valid) noexcept
{
    std::uint32_t wrong = 0U;
    for (std::uint32_t place = 0U; place < kBytesPerWord; ++place)
    {
        const std::uint32_t above = (place + 1U) % kBytesPerWord;
        wrong |= std::uint32_t{ByteOf(input.guard_token, above)} ^ ByteOf(input.challenge, place) ^ configuration_valid;
    }
    if (wrong != 0U)
    {
        return GuardView::kStale;
    }
    return (configuration_valid == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
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
        EnterOperational(voice);
        return;
    }
    LeaveOperational(voice);
}

// A level changes when two calls have read the same. A level that is not beside its complement is no 0, so that nothing
// rises from it. Returns those that rise. [SRS_REL_005]
SrdoMask FollowLevels(Voice& voice, const SrdoMask reading) noexcept
{
    const SrdoMask both_high = reading & voice.reading;
    const SrdoMask both_low = ~(reading | voice.reading);
    const SrdoMask low = voice.low_levels & ~voice.high_levels;
    voice.reading = reading;
    voice.low_levels = (low & ~both_high) | both_low;
    voice.high_levels = ~voice.low_levels;
    return low & both_high;
}

// What comes from outside is noted at the slots it is for: an edge, which a slot that is off forgets when it is served,
// and what concerns every slot. [SRS_REL_005]
void NoteInputs(const Voice& voice, const SrdoMask edges) noexcept
{
    const bool concerns_all = voice.is_late || voice.has_overflow || voice.gfc_pending;
    if ((edges == 0U) && !concerns_all)
    {
        return;
    }
    for (std::size_t slot = 0U; slot < voice.count; ++slot)
    {
        Record& record = At(voice, slot);
        if (IsIn(edges, slot))
        {
            record.grants.Set(Grant::kEdge, kYes);
            record.edge_since = voice.now;
            Demand(record, kLook);
        }
        if (concerns_all)
        {
            Demand(record, kLook);
        }
    }
}

// Who is due, and by a refresh, is told by each slot when it is served; so those that were asked for, are it now, or
// stand, are to be served. None stands whose initial delay was not over in the call before. [SRS_PROD_003,
// SRS_PROD_004, SRS_PROD_012]
Asked NoteAsked(Voice& voice, const CycleInput& input) noexcept
{
    const SrdoMask standing = voice.may_send ? (input.stand & voice.producers) : 0U;
    const Asked asked{input.request & voice.producers, standing};
    if (AgeUs(voice.entered, voice.now) >= voice.first_delay_us)
    {
        voice.may_send = true; // Kept: the difference wraps after 71 minutes.
    }
    voice.origin = voice.may_send ? voice.now : voice.origin;
    voice.outcome.refresh = 0U;
    voice.outcome.due = 0U;
    const SrdoMask concerned = voice.wanted | asked.requested | asked.standing;
    for (SlotWalk walk{concerned & SlotsOf(voice.count)}; walk.IsAtSlot(); walk.GoOn())
    {
        Demand(At(voice, walk.Slot()), kLook);
    }
    return asked;
}

// Signals stay for one cycle: the next one has to look at the slot again. [SRS_CONS_021]
void Signal(Voice& voice, const std::size_t slot, const std::uint32_t extra) noexcept
{
    Record& record = At(voice, slot);
    record.signals = record.unreported | extra;
    record.unreported = 0U;
    if (record.signals != 0U)
    {
        PutIn(voice.outcome.signalled, slot);
        Demand(record, kLook);
    }
}

void Serve(Voice& voice, const std::size_t slot, const Asked& asked) noexcept
{
    Record& record = At(voice, slot);
    record.todo = static_cast<std::uint8_t>(record.todo & ~kLook);
    if (!IsSound(record))
    {
        Break(voice, slot);
    }
    std::uint32_t extra = 0U;
    const Role role = FactsOf(record).role;
    if (role == Role::kConsumer)
    {
        extra = ServeConsumer(voice, slot);
    }
    else if (role == Role::kProducer)
    {
        ServeProducer(voice, slot, asked);
    }
    else
    {
        record.grants.Set(Grant::kEdge, kNo); // Only what was reported before it went off is to be told.
    }
    Signal(voice, slot, extra);
    if (record.grants.Is(Grant::kEdge, kYes))
    {
        Demand(record, kLook); // Until its window is over.
    }
}

// What is passed over has no limit that expired, is intact, and has nothing to tell, to wait for or to release.
void ServeAll(Voice& voice, const Asked& asked) noexcept
{
    const Instant now = voice.now;
    const Record* const records = voice.storage.records;
    const Record* const end = records + voice.count;              // MISRA D-002
    for (const Record* record = records; record != end; ++record) // MISRA D-002
    {
        if ((record->todo != 0U) || IsExpired(*record, now) || !record->grants.AreWhole())
        {
            Serve(voice, static_cast<std::size_t>(record - records), asked); // MISRA D-002
        }
    }
}

} // namespace

CycleOutcome RunCycle(Voice& voice, const CycleInput& input) noexcept
{
    CycleOutcome& outcome = voice.outcome;
    voice.step_us = AgeUs(voice.now, input.now);
    voice.is_late = voice.has_run && (voice.step_us > voice.late_after_us);
    voice.has_overflow = input.queue != QueueState::kIntact;
    voice.has_run = true;
    voice.now = input.now;
    ++outcome.cycle;
    outcome.guard = GuardOf(input, voice.configuration_valid);
    SetPermitted(voice, 0U); // Until Commit.

    FollowOperational(voice, input.nmt);
    const Asked asked = NoteAsked(voice, input);
    NoteInputs(voice, FollowLevels(voice, input.acknowledge));
    ServeAll(voice, asked);
    voice.gfc_pending = false;

    const CycleOutcome result = outcome;
    voice.unwritten |= outcome.fresh;
    outcome.fresh = 0U;
    outcome.new_fault = 0U;
    outcome.signalled = 0U;
    return result;
}

// What waits to be written is not what the objects hold yet, and is not examined.
SrdoMask CommitPairs(Voice& voice, const Agreement& agreement, const SrdoMask examine) noexcept
{
    const SrdoMask own = agreement.agreed & voice.outcome.released;
    const SrdoMask unwritten = voice.unwritten | voice.outcome.fresh;
    const SrdoMask to_write = own & agreement.matched & unwritten;
    const SrdoMask to_drop = voice.committed & ~own;
    const SrdoMask to_keep = voice.committed & own;
    const SrdoMask to_examine = examine & to_keep & ~unwritten;
    const SrdoMask concerned = to_write | to_drop | to_examine;
    voice.unwritten &= ~to_write;
    voice.committed = to_keep | to_write;

    const SrdoMask found = (concerned == 0U) ? 0U : WriteAndHold(voice, concerned, to_examine, to_drop);
    SetPermitted(voice, voice.committed & ~found);
    return found;
}

// [SRS_REL_010]
Permit PermitFor(const Voice& voice, const std::uint32_t challenge) noexcept
{
    Permit permit{};
    permit.mask = IsActive(voice) ? PermittedOf(voice) : 0U;
    const std::uint32_t low = static_cast<std::uint32_t>(permit.mask & 0xFFFFFFFFU);
    const std::uint32_t high = static_cast<std::uint32_t>(permit.mask >> kBitsPerWord);
    const std::uint32_t halves_swapped = (high << kPermitRotation) | (high >> kPermitRotation);
    permit.response = ((challenge + low) ^ halves_swapped) * kPermitConstantA;
    return permit;
}

} // namespace counterpoint::channel_a
