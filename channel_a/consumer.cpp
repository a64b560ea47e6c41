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

constexpr std::uint32_t kSpareMasks = 0xFF00U; // Moved right by the number of spare bits: these bits of a byte.
constexpr std::uint32_t kHalfMask = 1U;        // Of the place of an identifier: 0 the normal, 1 the inverse frame.

void Complete(Voice& voice, Record& record, const std::uint32_t slot) noexcept
{
    record.held = record.pending;
    record.since = record.frame_since;
    record.limit_us = SctUs(record);
    record.awaiting = kUnmarked;
    ++record.ordinal;
    ++voice.ordinal_sum;
    voice.fresh |= BitOf(slot);
}

[[gnu::noinline]] void TakeNormal(Voice& voice, const CanFrame& frame, const Instant stamp,
                                  const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    const Mode next = kAfterNormal[static_cast<std::uint8_t>(record.mode) & kModeMask];
    if (!IsFitting(voice, record, frame, Half::kNormal) || (next == Mode::kBroken))
    {
        ReceiveOdd(voice, frame, slot);
        return;
    }
    SetMode(record, next);
    Keep(voice, frame, stamp, slot);
}

// Whether the pending normal frame, of the same length as this one, has bits above the mapped ones. [SRS-CONS-009]
inline bool HasSpareBits(const Record& record, const CanFrame& frame) noexcept
{
    const std::uint32_t last = record.pending.at[(frame.length_bytes - 1U) & kLengthMask];
    return (record.spare_bits != 0U) && ((last & (kSpareMasks >> (record.spare_bits & kLengthMask))) != 0U);
}

// Where the spare bits are 0 in the normal frame they are 1 in its inverse.
[[gnu::noinline]] void TakeInverse(Voice& voice, const CanFrame& frame, const std::uint32_t slot) noexcept
{
    Record& record = At(voice, slot);
    if (!IsFitting(voice, record, frame, Half::kInverse))
    {
        ReceiveOdd(voice, frame, slot);
        return;
    }
    const std::uint64_t wrong = (BitsAt(&frame.data[0]) ^ Bits(record.pending) ^ kInverseFlip) & MappedBits(frame);
    const Mode next = kAfterInverse[static_cast<std::uint8_t>(record.mode) & kModeMask];
    if ((wrong != 0U) || (next == Mode::kBroken) || HasSpareBits(record, frame))
    {
        ReceiveOdd(voice, frame, slot);
        return;
    }
    SetMode(record, next);
    Complete(voice, record, slot);
}

// The limit first; the frame is then taken as if nothing had been there before it.
[[gnu::noinline]] void TakeAfterLimit(Voice& voice, const CanFrame& frame, const Instant stamp,
                                      const std::uint32_t slot) noexcept
{
    const bool is_inverse = (~frame.identifier & kHalfMask) != 0U; // Odd are those of normal frames.
    Expire(voice, slot, stamp, is_inverse ? Half::kInverse : Half::kNormal);
    if (is_inverse)
    {
        ReceiveOdd(voice, frame, slot);
        return;
    }
    TakeNormal(voice, frame, stamp, slot);
}

// [SRS-TIME-009]
[[gnu::noinline]] void TakeLateInverse(Voice& voice, const CanFrame& frame, const Instant stamp,
                                       const std::uint32_t slot) noexcept
{
    if (IsTooOld(At(voice, slot), stamp))
    {
        TakeAfterLimit(voice, frame, stamp, slot);
        return;
    }
    TakeInverse(voice, frame, slot);
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
    const Record& record = At(voice_, slot);
    if (IsExpired(record, stamp))
    {
        TakeAfterLimit(voice_, frame, stamp, slot);
    }
    else if ((place & kHalfMask) == 0U)
    {
        TakeNormal(voice_, frame, stamp, slot);
    }
    else if (record.detection != SrvtDetection::kLate)
    {
        TakeInverse(voice_, frame, slot);
    }
    else
    {
        TakeLateInverse(voice_, frame, stamp, slot);
    }
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
