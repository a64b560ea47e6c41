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

void Complete(Voice& voice, Record& record, const std::uint64_t data, const std::uint32_t slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    record.held = OctetsOf(data);
    record.since = record.frame_since;
    record.limit_us = SctUs(record);
    record.awaiting = kUnmarked;
    ++record.ordinal;
    ++voice.ordinal_sum;
    voice.fresh |= bit;
    voice.unwritten |= bit;
}

bool IsFitting(const Voice& voice, const Record& record, const CanFrame& frame, const std::uint32_t half) noexcept
{
    return (frame.identifier == record.values[kCobIdPlace + half]) && (frame.port == voice.ports[half]) &&
           (frame.length_bytes == LengthBytes(record));
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
    const std::uint32_t slot = SlotOfPlace(voice_, place);
    if (slot >= voice_.count)
    {
        return;
    }
    Record& record = At(voice_, slot);
    if (IsExpired(record, stamp))
    {
        ReceiveLate(voice_, frame, stamp, slot);
        return;
    }
    const std::uint32_t half = place & kHalfMask;
    if ((half != 0U) && IsTooOld(record, stamp))
    {
        ReceiveLate(voice_, frame, stamp, slot);
        return;
    }
    if (!IsFitting(voice_, record, frame, half))
    {
        ReceiveOdd(voice_, frame, slot, Event::kNormal);
        return;
    }
    if (half == 0U) // The common cells of both halves stay within their group of modes.
    {
        const Cell& cell = NextCell(record.mode, Event::kNormal);
        if (cell.effect != Effect::kTake)
        {
            ReceiveOdd(voice_, frame, slot, Event::kNormal);
            return;
        }
        SetMode(record, cell.next);
        Keep(voice_, frame, stamp, slot);
        return;
    }
    // Bits above the length are 0 in the normal frame, so they are 1 in the inverse one.
    const std::uint64_t pending = Bits(record.pending);
    const std::uint64_t data = pending & LowBits(record.length_bits);
    const std::uint64_t wrong = (BitsAt(&frame.data[0]) ^ ~data) | (pending ^ data);
    if ((wrong & FrameBits(record)) != 0U)
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
    Complete(voice_, record, data, slot);
}

HeldPair Channel::Held(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    HeldPair pair{};
    if ((FactsOf(record.mode).data & kHoldsMask) != 0U)
    {
        pair.data = PayloadOf(record.held);
        pair.ordinal = record.ordinal;
        pair.holds_pair = 1U;
    }
    return pair;
}

void Channel::Demote(const SlotIndex slot) noexcept
{
    Record& record = At(voice_, slot);
    const std::uint32_t group = FactsOf(record.mode).group;
    if ((group - kGroupWaiting) < kConsumerGroups)
    {
        Raise(voice_, slot, Event::kDiscard, SrdoCause::kNone);
        // Counted and kept like a fault, but told to nobody: the other channel has reported it. [SRS-REL-006]
        Count(record, SrdoCause::kDemoted);
    }
}

} // namespace counterpoint::channel_a
