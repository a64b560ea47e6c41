// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstdint>

// Frames of consumers and the pairs that come of them. The common case is one function without calls, so that it has
// no registers to save; what is rare follows it by a jump.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kHalfMask = 1U; // Of the place of an identifier: 0 the normal, 1 the inverse frame.
constexpr std::uint8_t kGfcEnabled = 1U;

// [SRS-CONS-017]
void ReceiveOther(Voice& voice, const CanFrame& frame) noexcept
{
    const bool is_gfc = (frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U);
    if (is_gfc && voice.is_active && (voice.gfc_parameter == kGfcEnabled))
    {
        voice.gfc_pending = true;
    }
}

// The common cells of both halves stay within their group of modes.
void Take(Record& record, const CanFrame& frame, const Instant stamp, const Cell& cell) noexcept
{
    SetMode(record, cell.next);
    record.pending = TakenFrom(record, frame);
    record.since = stamp;
    record.limit_us = SrvtUs(record);
}

void Complete(Voice& voice, Record& record, const SlotIndex slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    record.held = record.pending;
    record.limit_us = SctUs(record);
    record.awaiting = kUnmarked;
    ++record.ordinal;
    ++voice.ordinal_sum;
    voice.fresh |= bit;
    voice.unwritten |= bit;
}

bool IsOnPlace(const Voice& voice, const Record& record, const CanFrame& frame, const std::uint32_t half) noexcept
{
    return (frame.identifier == record.values[kCobIdPlace + half]) && (frame.port == voice.ports[half]);
}

// What order of frames means is the table's affair.
[[gnu::noinline]] void ReceiveOdd(Voice& voice, const CanFrame& frame, const SlotIndex slot, const Event order) noexcept
{
    const Record& record = At(voice, slot);
    const std::uint32_t half = ~frame.identifier & kHalfMask;
    Event event = order;
    if (frame.length_bytes != record.length_bytes)
    {
        event = Event::kWrongLength;
    }
    if (!IsOnPlace(voice, record, frame, half))
    {
        event = Event::kWrongIdentifier;
    }
    Raise(voice, slot, event, SrdoCause::kNone);
}

// The limit first; the frame is then taken as if nothing had been there before it.
[[gnu::noinline]] void ReceiveLate(Voice& voice, const CanFrame& frame, const Instant stamp,
                                   const SlotIndex slot) noexcept
{
    Raise(voice, slot, Event::kExpired, SrdoCause::kNone);
    Record& record = At(voice, slot);
    const std::uint32_t half = ~frame.identifier & kHalfMask;
    const Cell& cell = NextCell(record.mode, Event::kNormal);
    const bool is_good = IsOnPlace(voice, record, frame, half) && (frame.length_bytes == record.length_bytes);
    if (is_good && (half == 0U) && (cell.effect == Effect::kTake))
    {
        Take(record, frame, stamp, cell);
        return;
    }
    ReceiveOdd(voice, frame, slot, Event::kInverse);
}

} // namespace

// Where no SRDO is active no identifier leads to one.
void Channel::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    if (place >= kSrdoIdentifierCount)
    {
        ReceiveOther(voice_, frame);
        return;
    }
    const SlotIndex slot = SlotOfPlace(voice_, place);
    if (slot >= voice_.count)
    {
        return;
    }
    Record& record = At(voice_, slot);
    if ((stamp.us - record.since.us) > record.limit_us)
    {
        ReceiveLate(voice_, frame, stamp, slot);
        return;
    }
    const std::uint32_t half = place & kHalfMask;
    const bool is_good = IsOnPlace(voice_, record, frame, half) && (frame.length_bytes == record.length_bytes);
    if (half == 0U)
    {
        const Cell& cell = NextCell(record.mode, Event::kNormal);
        if (!is_good || (cell.effect != Effect::kTake))
        {
            ReceiveOdd(voice_, frame, slot, Event::kNormal);
            return;
        }
        Take(record, frame, stamp, cell);
        return;
    }
    if (!is_good || !IsEqual(record, frame, record.pending, kInverseFlip))
    {
        ReceiveOdd(voice_, frame, slot, Event::kNotInverse);
        return;
    }
    const Cell& cell = NextCell(record.mode, Event::kInverse);
    if (cell.effect != Effect::kComplete)
    {
        ReceiveOdd(voice_, frame, slot, Event::kInverse);
        return;
    }
    SetMode(record, cell.next);
    Complete(voice_, record, slot);
}

HeldPair Channel::Held(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    HeldPair pair{};
    if (FactsOf(record.mode).data == kHeldPair)
    {
        pair.data = PayloadOf(record.held);
        pair.ordinal = record.ordinal;
        pair.holds_pair = 1U;
    }
    return pair;
}

void Channel::Demote(const SlotIndex slot) noexcept
{
    if ((ConsumersOf(voice_) & BitOf(slot)) != 0U)
    {
        Discard(voice_, slot);
        // Counted and kept like a fault, but told to nobody: the other channel has reported it. [SRS-REL-006]
        Count(At(voice_, slot), SrdoCause::kDemoted);
    }
}

} // namespace counterpoint::channel_a
