// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/octets.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"
#include "channel_a/voice.hpp"

#include <cstdint>

// A pair of a producer: what to send and what became of it. When to send: cycle.cpp.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint32_t kHalfMask = 1U; // Of the place of an identifier: 0 the normal, 1 the inverse frame.
constexpr std::uint32_t kConfirmOfHalf = static_cast<std::uint32_t>(Effect::kConfirmNormal);
static_assert(static_cast<std::uint32_t>(Effect::kConfirmInverse) == kConfirmOfHalf + 1U, "the halves in their order");
constexpr std::uint64_t kFlips[2] = {0U, kInverseFlip}; // MISRA D-001
constexpr Confirmation kNotOurs{kNoSlot, ConfirmStep::kNone};

[[gnu::noinline]] Confirmation GiveUp(Voice& voice, const SlotIndex slot, const Event event,
                                      const SrdoCause cause) noexcept
{
    Raise(voice, slot, event, cause);
    return kNotOurs;
}

} // namespace

PreparedPair Channel::Prepare(const SlotIndex slot) noexcept
{
    PreparedPair pair{};
    pair.status = PrepareStatus::kNotProducer;
    Record& record = At(voice_, slot);
    const Cell& cell = NextCell(record.mode, Event::kAdvance);
    if (cell.effect != Effect::kLaunch)
    {
        return pair;
    }
    const SrdoMask bit = BitOf(slot);
    voice_.refreshed &= ~bit;
    voice_.requested &= ~bit;
    if (!ReadObjects(*voice_.config, record))
    {
        pair.status = PrepareStatus::kNotInverse;
        Report(voice_, slot, SrdoCause::kNotInverse);
        return pair;
    }
    SetMode(record, cell.next);
    voice_.flying |= bit;
    record.sent_since = voice_.now;
    if (voice_.may_send && (record.form != ProducerForm::kProviderCalled))
    {
        record.since = voice_.now;
    }
    pair.normal.identifier = record.values[kCobIdPlace];
    pair.normal.kind = FrameKind::kData;
    pair.normal.port = voice_.ports[0];
    pair.normal.length_bytes = record.length_bytes;
    for (std::uint32_t place = 0U; place < kMaxPayloadBytes; ++place)
    {
        pair.normal.data[place] = record.held.at[place];
    }
    pair.status = PrepareStatus::kReady;
    return pair;
}

Confirmation Channel::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const std::uint32_t place = frame.identifier - kFirstSrdoIdentifier; // Every other identifier is a greater place.
    if ((frame.kind != FrameKind::kData) || (place >= kSrdoIdentifierCount))
    {
        return kNotOurs;
    }
    const SlotIndex slot = SlotOfPlace(voice_, place);
    if (slot >= voice_.count)
    {
        return kNotOurs;
    }
    Record& record = At(voice_, slot);
    const std::uint32_t half = place & kHalfMask;
    const Cell& cell = NextCell(record.mode, Event::kAdvance);
    const std::uint32_t wanted = half + kConfirmOfHalf;
    if ((static_cast<std::uint32_t>(cell.effect) != wanted) || (record.values[kCobIdPlace + half] != frame.identifier))
    {
        return kNotOurs;
    }
    if ((frame.length_bytes != record.length_bytes) || !IsEqual(record, frame, record.held, kFlips[half]))
    {
        return GiveUp(voice_, slot, Event::kAbort, SrdoCause::kWrongEcho);
    }
    if (half == 0U)
    {
        SetMode(record, cell.next);
        record.sent_since = stamp;
        return Confirmation{slot, ConfirmStep::kNormal};
    }
    if ((stamp.us - record.sent_since.us) > SrvtUs(record))
    {
        return GiveUp(voice_, slot, Event::kUnconfirmed, SrdoCause::kNone);
    }
    SetMode(record, cell.next);
    ++record.ordinal;
    voice_.flying &= ~BitOf(slot);
    return Confirmation{slot, ConfirmStep::kPair};
}

// The inverse frame is the other channel's.
CanFrame Channel::InverseFrame(SlotIndex /*slot*/) noexcept
{
    return CanFrame{};
}

void Channel::OnTransmitFault(const SlotIndex slot, const SrdoCause cause) noexcept
{
    if ((cause == SrdoCause::kTransmitQueue) || (cause == SrdoCause::kBusOff))
    {
        Raise(voice_, slot, Event::kAbort, cause);
    }
}

} // namespace counterpoint::channel_a
