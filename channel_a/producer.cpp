// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// What became of a pair of a producer. When to send: cycle.cpp; what: objects.cpp.
//
// Idle --Prepare--> NormalAwaited --normal frame--> InverseAwaited --inverse frame--> Idle
namespace counterpoint::channel_a
{
namespace
{

constexpr Confirmation kNotOurs{kNoSlot, ConfirmStep::kNone};

// Whether the frame is the awaited half of the SRDO: 0 the normal, 1 the inverse one.
inline bool IsAwaited(const Record& record, const CanFrame& frame, const std::uint32_t half) noexcept
{
    return (frame.identifier == record.values[kCobIdPlace + half]) && (record.mode == (kNormalAwaited + half));
}

// Whether it says what is expected of this half.
inline bool IsEcho(const Record& record, const CanFrame& frame, const std::uint32_t half) noexcept
{
    const std::uint64_t wrong =
        BitsOf(frame) ^ Joined(record.held.low, record.held.high) ^ (std::uint64_t{0U} - std::uint64_t{half});
    return ((wrong & record.mapped) == 0U) && (frame.length_bytes == record.length_bytes);
}

} // namespace

// Finds the record anew.
[[gnu::noinline]] Confirmation Channel::GiveUp(const CanFrame& frame, const SrdoCause cause) noexcept
{
    Abort(At(voice_, LookUp(voice_, frame.identifier)), cause);
    return kNotOurs;
}

// Each of the two frames is awaited in a mode of its own; an identifier that is none of an SRDO is not that of the slot
// that it leads to.
Confirmation Channel::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const std::size_t slot = LookUp(voice_, frame.identifier);
    if ((slot >= voice_.count) || (frame.kind != FrameKind::kData))
    {
        return kNotOurs;
    }
    Record& record = At(voice_, slot);
    if (IsAwaited(record, frame, 0U))
    {
        if (!IsEcho(record, frame, 0U))
        {
            return GiveUp(frame, SrdoCause::kWrongEcho);
        }
        StepMode(record, kNormalAwaited, kInverseAwaited);
        record.frame_since = stamp;
        return Confirmation{static_cast<SlotIndex>(slot), ConfirmStep::kNormal};
    }
    if (IsAwaited(record, frame, 1U))
    {
        if (!IsEcho(record, frame, 1U))
        {
            return GiveUp(frame, SrdoCause::kWrongEcho);
        }
        if ((stamp.us - record.frame_since.us) > SrvtUs(record))
        {
            return GiveUp(frame, SrdoCause::kNoConfirmation);
        }
        StepMode(record, kInverseAwaited, kProducer);
        record.todo = static_cast<std::uint8_t>(record.todo & ~kInFlight);
        ++record.ordinal;
        return Confirmation{static_cast<SlotIndex>(slot), ConfirmStep::kPair};
    }
    return kNotOurs;
}

// The inverse frame is the other channel's.
CanFrame Channel::InverseFrame(SlotIndex /*slot*/) noexcept
{
    return CanFrame{};
}

void Channel::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    const bool is_of_port = (fault.cause == SrdoCause::kTransmitQueue) || (fault.cause == SrdoCause::kBusOff);
    if (is_of_port || (fault.cause == SrdoCause::kNotInverse))
    {
        Abort(At(voice_, slot), fault.cause);
    }
}

} // namespace counterpoint::channel_a
