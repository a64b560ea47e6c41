// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// Frames of consumers and the pairs that come of them. The common case is two functions, one behind the other by a
// jump, without calls, so that they have no registers to save; what is rare follows them by a jump.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint8_t kGfcEnabled = 1U;
constexpr std::size_t kHalfMask = 1U;
constexpr std::uint32_t kRestOfByte = 7U;
constexpr std::uint32_t kShiftMask = 63U;

// Which half of a pair a frame is: 0 the normal one, whose identifier is odd, 1 the inverse one.
inline std::size_t HalfOf(const CanFrame& frame) noexcept
{
    return ~std::size_t{frame.identifier} & kHalfMask;
}

// Whether identifier and controller are those of this half of the SRDO.
inline bool IsAddressed(const Voice& voice, const Record& record, const CanFrame& frame,
                        const std::size_t half) noexcept
{
    return (frame.identifier == record.values[kCobIdPlace + half]) && (frame.port == voice.ports[half]);
}

inline bool IsFitting(const Voice& voice, const Record& record, const CanFrame& frame, const std::size_t half) noexcept
{
    return IsAddressed(voice, record, frame, half) && (frame.length_bytes == record.length_bytes);
}

// Whether the pending normal frame has bits above the mapped ones. [SRS_CONS_009]
inline bool HasSpareBits(const Record& record) noexcept
{
    return ((record.total_bits & kRestOfByte) != 0U) && ((record.pending >> (record.total_bits & kShiftMask)) != 0U);
}

// [SRS_CONS_017]
void ReceiveOther(Voice& voice, const CanFrame& frame) noexcept
{
    const bool is_gfc = (frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U);
    if (is_gfc && IsActive(voice) && (voice.globals[kGfcParameterPlace] == kGfcEnabled))
    {
        voice.gfc_pending = true;
    }
}

// A frame that is not as it should be. [SRS_CONS_011]
[[gnu::noinline]] void ReceiveOdd(Voice& voice, const CanFrame& frame, const std::size_t slot) noexcept
{
    const Record& record = At(voice, slot);
    const std::size_t half = HalfOf(frame);
    SrdoCause cause = SrdoCause::kIdentifier;
    if (IsAddressed(voice, record, frame, half))
    {
        const SrdoCause of_inverse = Is(record, kPending) ? SrdoCause::kNotInverse : SrdoCause::kInverseFirst;
        cause = (half == 0U) ? SrdoCause::kNormalTwice : of_inverse;
        cause = (frame.length_bytes != record.length_bytes) ? SrdoCause::kLength : cause;
    }
    Fail(voice, slot, cause);
}

// With late detection SRVT has no deadline, but the slot is served until the frame has become too old or is gone.
inline void Keep(Record& record, const CanFrame& frame, const Instant stamp) noexcept
{
    FlipMode(record, kPending);
    record.pending = BitsOf(frame) & record.mapped;
    record.frame_since = stamp;
    if (record.detection == SrvtDetection::kLate)
    {
        Demand(record, kLook);
        return;
    }
    record.since = stamp;
    record.limit_us = SrvtUs(record);
}

// A new pair is of interest to a slot that is not released yet.
inline void Complete(Voice& voice, Record& record, const std::size_t slot) noexcept
{
    FlipMode(record, kPending | (~std::uint32_t{record.mode} & kHeld));
    record.held = Payload{LowOf(record.pending), HighOf(record.pending)};
    record.since = record.frame_since;
    record.limit_us = SctUs(record);
    record.awaiting = kUnmarked;
    ++record.ordinal;
    ++voice.outcome.ordinal_sum;
    voice.outcome.fresh |= BitOf(slot);
    if (!Is(record, kReleased))
    {
        Demand(record, kLook);
    }
}

// A frame of this SRDO whose limits have been examined.
[[gnu::noinline]] void Take(Voice& voice, const CanFrame& frame, const Instant stamp, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    const bool has_pending = Is(record, kPending);
    if (HalfOf(frame) == 0U)
    {
        if (!IsFitting(voice, record, frame, 0U) || has_pending)
        {
            ReceiveOdd(voice, frame, slot);
            return;
        }
        Keep(record, frame, stamp);
        return;
    }
    // Where the spare bits are 0 in the normal frame they are 1 in its inverse.
    const std::uint64_t wrong = ~(BitsOf(frame) ^ record.pending) & record.mapped;
    if (!IsFitting(voice, record, frame, 1U) || !has_pending || (wrong != 0U) || HasSpareBits(record))
    {
        ReceiveOdd(voice, frame, slot);
        return;
    }
    Complete(voice, record, slot);
}

// The limit first; the frame is then taken as if nothing had been there before it.
[[gnu::noinline]] void TakeAfterLimit(Voice& voice, const CanFrame& frame, const Instant stamp,
                                      const std::size_t slot) noexcept
{
    const SrdoCause cause = ExpiredLimit(At(voice, slot), stamp, HalfOf(frame));
    if (cause != SrdoCause::kNone)
    {
        Fail(voice, slot, cause);
    }
    Take(voice, frame, stamp, slot);
}

} // namespace

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
    const std::size_t slot = LookUp(voice_, frame.identifier);
    if (slot >= voice_.count)
    {
        return;
    }
    const Record& record = At(voice_, slot);
    if (!Is(record, kConsumer))
    {
        return;
    }
    if (IsExpired(record, stamp) || (record.detection == SrvtDetection::kLate))
    {
        TakeAfterLimit(voice_, frame, stamp, slot);
        return;
    }
    Take(voice_, frame, stamp, slot);
}

HeldPair Channel::Held(const SlotIndex slot) const noexcept
{
    const Record& record = At(voice_, slot);
    HeldPair pair{};
    if (Is(record, kHeld))
    {
        pair.data = record.held;
        pair.ordinal = record.ordinal;
        pair.holds_pair = 1U;
    }
    return pair;
}

// Counted and kept like a fault, but told to nobody: the other channel has reported it. [SRS_REL_006]
void Channel::Demote(const SlotIndex slot) noexcept
{
    Record& record = At(voice_, slot);
    if (Is(record, kConsumer))
    {
        Drop(voice_, slot, kPending);
        Count(record, SrdoCause::kDemoted);
    }
}

} // namespace counterpoint::channel_a
