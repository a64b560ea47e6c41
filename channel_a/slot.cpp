// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/slot.hpp"

namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint16_t kErrorCountMax = 0xFFFFU;
constexpr std::uint32_t kCauseBits = 0x1FU; // Causes are smaller, but for the one that is none.

// No pair any more, nor what came of one.
void Forget(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    voice.outcome.ordinal_sum -= record.ordinal;
    record.ordinal = 0U;
    record.grants.Set(Grant::kEdge, kNo);
    record.awaiting = kNo;
    TakeOut(voice.outcome.fresh, slot);
}

// Only directions 1 and 2 come as far as a resolved mapping. `since` of a producer that is called is one refresh and a
// microsecond before the first possible transmission, so that the first refresh falls due there; it is the first
// possible transmission itself where the application sends. [SRS_PROD_001, SRS_PROD_002, SRS_REL_001]
void EnterSlot(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    LookUp(voice, record.values.cob_id[kNormalHalf]) = static_cast<std::uint8_t>(slot);
    LookUp(voice, record.values.cob_id[kInverseHalf]) = static_cast<std::uint8_t>(slot);
    --voice.outcome.is_invalid;
    if (record.grants.Of(Grant::kDirection) == kDirectionConsumer)
    {
        static_cast<void>(Advance(voice, record, slot, StateOf(record), Event::kBecomesConsumer));
        record.awaiting = kYes;
        ++voice.outcome.sct_checked;
        return;
    }
    static_cast<void>(Advance(voice, record, slot, StateOf(record), Event::kBecomesProducer));
    ++voice.outcome.is_tx;
    record.since = voice.origin;
    if (record.form == ProducerForm::kProviderCalled)
    {
        record.since.us -= SctUs(record) + 1U;
    }
}

} // namespace

void SetFirstCause(Record& record, const SrdoCause cause) noexcept
{
    record.grants.Set(Grant::kFirstCause, static_cast<std::uint8_t>(cause));
}

void Show(Voice& voice, const std::size_t slot, const SrdoState shown) noexcept
{
    TakeOut(voice.outcome.released, slot);
    TakeOut(voice.outcome.faulted, slot);
    TakeOut(voice.outcome.waiting, slot);
    TakeOut(voice.producers, slot);
    if (shown == SrdoState::kReleased)
    {
        PutIn(voice.outcome.released, slot);
    }
    if (shown == SrdoState::kFaulted)
    {
        PutIn(voice.outcome.faulted, slot);
    }
    if (shown == SrdoState::kWaiting)
    {
        PutIn(voice.outcome.waiting, slot);
    }
    if (shown == SrdoState::kProducer)
    {
        PutIn(voice.producers, slot);
    }
}

void Count(Record& record, const SrdoCause cause) noexcept
{
    if (FirstCauseOf(record) == SrdoCause::kNone)
    {
        SetFirstCause(record, cause);
    }
    if (record.error_count != kErrorCountMax)
    {
        ++record.error_count;
    }
}

void Report(Record& record, const SrdoCause cause) noexcept
{
    Count(record, cause);
    record.unreported |= std::uint32_t{1U} << (static_cast<std::uint32_t>(cause) & kCauseBits);
    Demand(record, kLook);
}

// With late detection the limit is always that of the held pair. [SRS_CONS_012, SRS_CONS_013]
void Discard(Voice& voice, const std::size_t slot, const Event event) noexcept
{
    Record& record = At(voice, slot);
    const State state = Advance(voice, record, slot, StateOf(record), event);
    if (!FactsOf(state).has_pending || (record.detection == SrvtDetection::kLate))
    {
        record.limit_us = kNoLimit;
    }
    Forget(voice, slot);
}

void Fail(Voice& voice, const std::size_t slot, const SrdoCause cause) noexcept
{
    Discard(voice, slot, Event::kFault);
    Report(At(voice, slot), cause);
}

// The masks are written whatever they say. What was a producer or off is shown as faulted, too: nobody knows any more.
void Break(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    static_cast<void>(Advance(voice, record, slot, StateOf(record), Event::kBroke));
    Show(voice, slot, IsActive(voice) ? SrdoState::kFaulted : SrdoState::kOff);
    Forget(voice, slot);
    record.limit_us = kNoLimit;
    record.sent = 0U;
    if (IsActive(voice))
    {
        PutIn(voice.outcome.new_fault, slot);
        Report(record, SrdoCause::kInvalid);
    }
}

void EnterOperational(Voice& voice) noexcept
{
    voice.entered = voice.now;
    voice.origin.us = voice.now.us + voice.first_delay_us;
    voice.may_send = false;
    voice.wanted = 0U;
    voice.outcome.ordinal_sum = 0U;
    voice.outcome.not_operational = 0U;
    voice.outcome.is_invalid = voice.count;
    for (std::size_t place = 0U; place < kLookUpSize; ++place)
    {
        voice.storage.look_up[place] = kNoSlot; // MISRA D-002
    }
    for (std::size_t slot = 0U; slot < voice.count; ++slot)
    {
        const Record& record = At(voice, slot);
        if (record.grants.Is(Grant::kResolved, kYes) && record.grants.Is(Grant::kChecked, kYes) && IsSound(record))
        {
            EnterSlot(voice, slot);
        }
        Demand(At(voice, slot), kLook);
    }
}

// What an SRDO that is off has to leave is nothing; the next OnCycle, the one that goes on, looks at each.
// [SRS_CONS_019, SRS_PROD_011, SRS_REL_008]
void LeaveOperational(Voice& voice) noexcept
{
    for (std::size_t slot = 0U; slot < voice.count; ++slot)
    {
        Record& record = At(voice, slot);
        if (FactsOf(record).role == Role::kConsumer)
        {
            Fail(voice, slot, SrdoCause::kNotOperational);
            PutIn(voice.outcome.new_fault, slot);
        }
        static_cast<void>(Advance(voice, record, slot, StateOf(record), Event::kLeft));
        Show(voice, slot, SrdoState::kOff);
        record.limit_us = kNoLimit;
        record.ordinal = 0U;
        record.sent = 0U;
        record.todo = kLook;
        record.refreshed = kNo;
    }
    voice.outcome.sct_checked = 0U;
    voice.outcome.is_tx = 0U;
    voice.outcome.is_invalid = 0U;
    voice.outcome.not_operational = 1U;
}

} // namespace counterpoint::channel_a
