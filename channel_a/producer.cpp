// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstdint>

// What became of a pair of a producer. When to send: cycle.cpp; what: mapping.cpp.
//
// Idle --Prepare--> NormalAwaited --normal frame--> InverseAwaited --inverse frame--> Idle
//
// Each of these steps is taken from the one mode that it starts from; every other event is the table's.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kHalfMask = 1U; // Of the place of an identifier: 0 the normal, 1 the inverse frame.
constexpr Mode kAwaited[2] = {Mode::kNormalAwaited, Mode::kInverseAwaited}; // By half. MISRA D-001
constexpr Confirmation kNotOurs{kNoSlot, ConfirmStep::kNone};

[[gnu::noinline]] Confirmation Abort(Voice& voice, const std::uint32_t slot, const SrdoCause cause) noexcept
{
    Raise(voice, slot, Event::kAbort, cause);
    return kNotOurs;
}

} // namespace

Confirmation Channel::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if ((frame.kind != FrameKind::kData) || (place >= kSrdoIdentifierCount))
    {
        return kNotOurs;
    }
    const std::uint32_t slot = SlotOfPlace(voice_, place);
    if (slot >= voice_.count)
    {
        return kNotOurs;
    }
    Record& record = At(voice_, slot);
    const std::uint32_t half = place & kHalfMask;
    if ((record.mode != kAwaited[half]) || (record.values[kCobIdPlace + half] != frame.identifier))
    {
        return kNotOurs;
    }
    if (frame.length_bytes != record.length_bytes)
    {
        return Abort(voice_, slot, SrdoCause::kWrongEcho);
    }
    const std::uint64_t wrong = BitsAt(&frame.data[0]) ^ Bits(record.held) ^ (std::uint64_t{0U} - half);
    if ((wrong & MappedBits(frame)) != 0U)
    {
        return Abort(voice_, slot, SrdoCause::kWrongEcho);
    }
    if (half == 0U)
    {
        SetMode(record, Mode::kInverseAwaited);
        record.frame_since = stamp;
        return Confirmation{static_cast<SlotIndex>(slot), ConfirmStep::kNormal};
    }
    if ((stamp.us - record.frame_since.us) > SrvtUs(record))
    {
        return Abort(voice_, slot, SrdoCause::kNoConfirmation);
    }
    SetMode(record, Mode::kIdle);
    ++record.ordinal;
    voice_.flying &= ~BitOf(slot);
    return Confirmation{static_cast<SlotIndex>(slot), ConfirmStep::kPair};
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
        Raise(voice_, slot, Event::kAbort, fault.cause);
    }
}

} // namespace counterpoint::channel_a
