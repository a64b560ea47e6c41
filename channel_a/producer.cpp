// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"

#include <cstdint>

// Producers: when to send, what to send, and what became of it.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kHalfMask = 1U; // Of the place of an identifier: 0 the normal, 1 the inverse frame.
constexpr std::uint32_t kConfirmOfHalf = static_cast<std::uint32_t>(Effect::kConfirmNormal);
static_assert(static_cast<std::uint32_t>(Effect::kConfirmInverse) == kConfirmOfHalf + 1U, "the halves in their order");

std::uint32_t RefreshUs(const Record& record) noexcept
{
    return record.values[kSctPlace] * kMicrosecondsPerMillisecond;
}

} // namespace

// refresh_since is one refresh time before the first possible transmission where the kernel asks for data, so that the
// first refresh falls due there; it is the first possible transmission itself where the application sends.
void Channel::StartProducing(Record& record) const noexcept
{
    record.refresh_since.us = entered_.us + first_delay_us_;
    if (record.form == ProducerForm::kProviderCalled)
    {
        record.refresh_since.us -= RefreshUs(record);
    }
}

void Channel::StopProducing(Record& record) noexcept
{
    record.limit_us = kNoLimit;
    record.ordinal = 0U;
    record.refresh = kUnmarked;
    record.request = kUnmarked;
    record.prepared = kUnmarked;
}

// Exact addition keeps the phase. A refresh that cannot be is skipped. [SRS-PROD-002]
void Channel::Refresh(Record& record, const SrdoMask bit) noexcept
{
    record.refresh_since.us += RefreshUs(record);
    if ((record.mode != Mode::kIdle) || (record.refresh == kMarked))
    {
        Report(record, bit, SrdoCause::kRefreshMissed);
    }
    else
    {
        record.refresh = kMarked;
    }
}

// [SRS-PROD-010]
inline void Channel::ExamineSending(const Instant now, Record& record, const SrdoMask bit) noexcept
{
    const std::uint32_t elapsed_us = now.us - record.refresh_since.us;
    const std::uint32_t refresh_us = RefreshUs(record);
    const std::uint32_t limit_us = refresh_us + late_after_us_;
    if (record.form == ProducerForm::kProviderCalled)
    {
        if (elapsed_us >= refresh_us)
        {
            Refresh(record, bit);
        }
    }
    else if (elapsed_us > limit_us)
    {
        if (record.request == kMarked)
        {
            record.refresh_since.us = now.us - (limit_us + 1U); // Still too long ago, however long the request waits.
        }
        else
        {
            record.refresh_since = now;
            Report(record, bit, SrdoCause::kRefreshMissed);
        }
    }
    else
    {
        // The application has sent in time.
    }
}

// Between two pairs the limit is the next refresh, so that the scan passes over a producer with nothing to do. A pair
// in flight or due is served in every cycle.
inline void Channel::Arm(SrdoMask& due, Record& record, const SrdoMask bit) noexcept
{
    if (!may_send_ || (record.mode != Mode::kIdle))
    {
        attention_ |= bit;
        return;
    }
    if ((record.refresh == kMarked) || (record.request == kMarked))
    {
        attention_ |= bit;
        due |= bit;
        return;
    }
    record.since = record.refresh_since;
    record.limit_us = RefreshUs(record);
    if (record.form == ProducerForm::kProviderCalled)
    {
        --record.since.us; // The refresh time itself is due.
    }
    else
    {
        record.limit_us += late_after_us_;
    }
}

void Channel::ServeProducer(Cycle& cycle, Record& record, const SrdoMask bit) noexcept
{
    if (!IsSealed(record))
    {
        Raise(record, bit, Event::kCorrupted, SrdoCause::kNone);
        MoveTo(bit, FactsOf(record.mode).group);
        StopProducing(record);
        return;
    }
    if ((cycle.now.us - record.since.us) > record.limit_us)
    {
        Raise(record, bit, Event::kUnconfirmed, SrdoCause::kNone);
    }
    if ((standing_ & bit) != 0U)
    {
        record.refresh_since.us += step_us_;
        standing_ &= ~bit;
    }
    if (may_send_)
    {
        ExamineSending(cycle.now, record, bit);
    }
    Arm(cycle.due, record, bit);
    if (((cycle.edges & bit) != 0U) && (record.unreported == 0U))
    {
        SetFirstCause(record, SrdoCause::kNone);
    }
}

void Channel::Request(const SlotIndex slot) noexcept
{
    if ((groups_[kGroupProducer] & BitOf(slot)) != 0U)
    {
        At(slot).request = kMarked;
        attention_ |= BitOf(slot);
    }
}

// [SRS-PROD-012]
void Channel::Hold(const SlotIndex slot) noexcept
{
    if (may_send_ && (At(slot).form == ProducerForm::kProviderCalled))
    {
        standing_ |= groups_[kGroupProducer] & BitOf(slot);
    }
}

void Channel::Launch(const SlotIndex slot) noexcept
{
    Record& record = At(slot);
    if (record.prepared != kMarked)
    {
        return;
    }
    record.prepared = kUnmarked;
    const Cell& cell = StepWithin(record, Event::kLaunch);
    if (cell.effect == Effect::kLaunch)
    {
        attention_ |= BitOf(slot);
        record.held = record.pending;
        record.since = now_;
        record.limit_us = record.values[kSrvtPlace] * kMicrosecondsPerMillisecond;
        if (may_send_ && (record.form != ProducerForm::kProviderCalled))
        {
            record.refresh_since = now_;
        }
    }
}

CanFrame Channel::NextFrame(const SlotIndex slot) noexcept
{
    CanFrame frame{};
    Record& record = At(slot);
    const Cell& cell = StepWithin(record, Event::kHandOut);
    if (cell.effect == Effect::kHandOut)
    {
        frame.identifier = record.values[kCobIdPlace];
        frame.kind = FrameKind::kData;
        frame.port = ports_.of_half[0];
        frame.length_bytes = record.length_bytes;
        for (std::uint32_t place = 0U; place < kMaxPayloadBytes; ++place)
        {
            frame.data[place] = record.held.at[place];
        }
    }
    return frame;
}

SlotIndex Channel::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if ((frame.kind != FrameKind::kData) || (place >= kSrdoIdentifierCount))
    {
        return kNoSlot;
    }
    const SlotIndex slot = SlotOfPlace(place);
    if (slot >= count_)
    {
        return kNoSlot;
    }
    Record& record = At(slot);
    const std::uint32_t half = place & kHalfMask;
    const Cell& cell = NextCell(record.mode, Event::kConfirm);
    const std::uint32_t wanted = half + kConfirmOfHalf;
    if ((static_cast<std::uint32_t>(cell.effect) != wanted) || (record.values[kCobIdPlace + half] != frame.identifier))
    {
        return kNoSlot;
    }
    if ((frame.length_bytes != record.length_bytes) || !IsEqual(record, frame, record.held, kFlips[half]))
    {
        return GiveUp(slot, Event::kAbort, SrdoCause::kWrongEcho);
    }
    if (half == 0U)
    {
        SetMode(record, cell.next);
        record.since = stamp;
        return slot;
    }
    if ((stamp.us - record.since.us) > record.limit_us)
    {
        return GiveUp(slot, Event::kUnconfirmed, SrdoCause::kNone);
    }
    SetMode(record, cell.next);
    return Finish(slot);
}

// The pair was sent. A slot with nothing more to do waits for its next refresh, as if OnCycle had armed it.
SlotIndex Channel::Finish(const SlotIndex slot) noexcept
{
    Record& record = At(slot);
    const SrdoMask bit = BitOf(slot);
    ++record.ordinal;
    attention_ &= ~bit;
    SrdoMask due = 0U; // Told by the next OnCycle.
    Arm(due, record, bit);
    const std::uint32_t unfinished = record.told | record.unreported;
    attention_ |= (unfinished != 0U) ? bit : 0U;
    return slot;
}

void Channel::OnTransmitFault(const SlotIndex slot, const SrdoCause cause) noexcept
{
    if ((cause == SrdoCause::kTransmitQueue) || (cause == SrdoCause::kBusOff))
    {
        Raise(At(slot), BitOf(slot), Event::kAbort, cause);
    }
}

} // namespace counterpoint::channel_a
