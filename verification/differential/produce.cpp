// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Producers: requests, Prepare, Launch, frames and their confirmations, in order and out of it.
#include "verification/differential/differential.hpp"

namespace counterpoint::differential
{

namespace
{
std::uint32_t ByteOf(const Payload& data, std::uint32_t at) noexcept
{
    const std::uint32_t half = (at < 4U) ? data.low : data.high;
    return (half >> (8U * (at % 4U))) & 0xFFU;
}
} // namespace

/// The application writes its pair, as a rule inverse in every bit, into both memories.
void Differential::WriteObjects(SlotIndex slot) noexcept
{
    const std::uint32_t at = Memory::kSlotBytes * slot;
    const std::uint32_t bytes = device_.plans[slot].bytes;
    if (device_.plans[slot].direction != kDirectionProducer)
    {
        return; // The objects of a consumer are the channels'.
    }
    for (std::uint32_t i = 0U; i < bytes; ++i)
    {
        const std::uint32_t value = random_.Below(256U);
        device_.memory_a.bytes[at + i] = static_cast<std::uint8_t>(value);
        device_.memory_a.bytes[at + Memory::kInverseAt + i] = static_cast<std::uint8_t>(0xFFU ^ value);
    }
    if (random_.Chance(80U))
    {
        const std::uint32_t place = at + random_.Below(bytes);
        const std::uint32_t wrong = place + (random_.Chance(500U) ? Memory::kInverseAt : 0U);
        device_.memory_a.bytes[wrong] =
            static_cast<std::uint8_t>(device_.memory_a.bytes[wrong] ^ (1U << random_.Below(8U)));
    }
    for (std::uint32_t i = 0U; i < Memory::kSlotBytes; ++i)
    {
        device_.memory_b.bytes[at + i] = device_.memory_a.bytes[at + i];
    }
}

void Differential::PrepareBoth(SlotIndex slot) noexcept
{
    Step("Prepare", slot, 0U, 0U, 0U);
    const PreparedPair a = a_.Prepare(slot);
    const PreparedPair b = b_.Prepare(slot);
    Same("status of Prepare", slot, static_cast<std::uint64_t>(a.status), static_cast<std::uint64_t>(b.status));
    Same("length of the prepared pair", slot, a.length_bytes, b.length_bytes);
    Same("prepared data, bytes 0 to 3", slot, a.normal.low, b.normal.low);
    Same("prepared data, bytes 4 to 7", slot, a.normal.high, b.normal.high);
    CompareView(slot);
    Transmission& transmission = transmissions_[slot];
    if (a.status == PrepareStatus::kReady)
    {
        reached_.Add(Item::kPreparedReady);
        transmission = Transmission{};
        transmission.data = a.normal;
        transmission.length_bytes = a.length_bytes;
    }
    reached_.Add(Item::kPreparedNotInverse, (a.status == PrepareStatus::kNotInverse) ? 1U : 0U);
    reached_.Add(Item::kPreparedNotProducer, (a.status == PrepareStatus::kNotProducer) ? 1U : 0U);
}

void Differential::LaunchBoth(SlotIndex slot) noexcept
{
    Step("Launch", slot, 0U, 0U, 0U);
    a_.Launch(slot);
    b_.Launch(slot);
    CompareView(slot);
}

/// A frame that a channel handed out: that of the last ready Prepare, normal from A, inverse from B.
void Differential::CheckFrame(SlotIndex slot, const CanFrame& frame, bool is_inverse) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    const Transmission& transmission = transmissions_[slot];
    const CanPortId port = is_inverse ? device_.config_a.inverse_port : device_.config_a.normal_port;
    Same("kind of the next frame", slot, static_cast<std::uint64_t>(frame.kind),
         static_cast<std::uint64_t>(FrameKind::kData));
    Same("identifier of the next frame", slot, frame.identifier, is_inverse ? plan.cob_id_2 : plan.cob_id_1);
    Same("controller of the next frame", slot, static_cast<std::uint64_t>(frame.port),
         static_cast<std::uint64_t>(port));
    Same("length of the next frame", slot, frame.length_bytes, transmission.length_bytes);
    for (std::uint32_t i = 0U; i < transmission.length_bytes; ++i)
    {
        const std::uint32_t normal = ByteOf(transmission.data, i);
        Same("data of the next frame", slot, frame.data[i], is_inverse ? (0xFFU ^ normal) : normal);
    }
}

/// Both are asked; at most one has a frame.
void Differential::TakeFrames(SlotIndex slot) noexcept
{
    Step("NextFrame", slot, 0U, 0U, 0U);
    const CanFrame a = a_.NextFrame(slot);
    const CanFrame b = b_.NextFrame(slot);
    const bool has_a = a.kind != FrameKind::kInvalid;
    const bool has_b = b.kind != FrameKind::kInvalid;
    Same("frames of both at once", slot, (has_a && has_b) ? 1U : 0U, 0U);
    if (has_a)
    {
        CheckFrame(slot, a, false);
        transmissions_[slot].frame = a;
        transmissions_[slot].is_inverse = false;
    }
    if (has_b)
    {
        CheckFrame(slot, b, true);
        transmissions_[slot].frame = b;
        transmissions_[slot].is_inverse = true;
    }
}

void Differential::ConfirmBoth(const CanFrame& frame, SlotIndex slot) noexcept
{
    Step("OnConfirm: identifier, length << 8 | kind, stamp", slot, frame.identifier,
         (static_cast<std::uint64_t>(frame.length_bytes) << 8U) | static_cast<std::uint64_t>(frame.kind), clock_us_);
    const std::uint32_t before = a_.View(slot).ordinal;
    const SlotIndex a = a_.OnConfirm(frame, Instant{clock_us_});
    const SlotIndex b = b_.OnConfirm(frame, Instant{clock_us_});
    Same("slot of OnConfirm", slot, a, b);
    CompareView(slot);
    const SrdoView view = a_.View(slot);
    reached_.Add(Item::kSentPair, ((view.state == SrdoState::kProducer) && (view.ordinal == (before + 1U))) ? 1U : 0U);
}

/// The frame on the bus is confirmed: as a rule as it was, now and then another, or just on or behind its limit.
void Differential::Confirm(SlotIndex slot) noexcept
{
    Transmission& transmission = transmissions_[slot];
    CanFrame frame = transmission.frame;
    if (frame.kind == FrameKind::kInvalid)
    {
        // One after the other: compilers differ in the order in which they evaluate arguments.
        const bool is_inverse = random_.Chance(500U);
        frame = FrameOf(slot, is_inverse, AnyData());
    }
    if (random_.Chance(60U))
    {
        GoNear(slot);
    }
    else
    {
        LetTimePass(device_.config_a.cycle_us / 16U);
    }
    switch (random_.Below(40U))
    {
    case 0U:
        frame.data[0] = static_cast<std::uint8_t>(frame.data[0] ^ (1U << random_.Below(8U)));
        break;
    case 1U:
        frame.length_bytes = static_cast<std::uint8_t>(random_.Below(10U));
        break;
    case 2U:
        frame.kind = FrameKind::kRemote;
        break;
    case 3U:
        frame.identifier ^= 1U << random_.Below(11U);
        break;
    default:
        break;
    }
    ConfirmBoth(frame, slot);
    last_us_[slot] = clock_us_;
    transmission.frame.kind = FrameKind::kInvalid;
}

void Differential::FailBoth(SlotIndex slot, SrdoCause cause) noexcept
{
    Step("OnTransmitFault: cause", slot, static_cast<std::uint64_t>(cause), 0U, 0U);
    a_.OnTransmitFault(slot, cause);
    b_.OnTransmitFault(slot, cause);
    CompareView(slot);
}

/// What the kernel does for the producers that are due.
void Differential::Serve(SrdoMask due) noexcept
{
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        if ((((due >> slot) & 1U) == 0U) || random_.Chance(120U))
        {
            continue;
        }
        WriteObjects(slot);
        PrepareBoth(slot);
        if (random_.Chance(960U))
        {
            LaunchBoth(slot);
        }
        for (std::uint32_t half = 0U; half < 2U; ++half)
        {
            TakeFrames(slot);
            if (random_.Chance(50U))
            {
                FailBoth(slot, random_.Chance(500U) ? SrdoCause::kTransmitQueue : SrdoCause::kBusOff);
            }
            if (random_.Chance(100U))
            {
                break; // The rest later, or never.
            }
            Confirm(slot);
        }
    }
}

void Differential::ProducerStep() noexcept
{
    const SlotIndex slot = AnySlot();
    switch (random_.Below(9U))
    {
    case 0U:
        WriteObjects(slot);
        PrepareBoth(slot);
        break;
    case 1U:
        LaunchBoth(slot);
        break;
    case 2U:
        TakeFrames(slot);
        break;
    case 3U:
        FailBoth(slot, static_cast<SrdoCause>(random_.Between(11U, 19U)));
        break;
    case 4U:
    case 5U:
        TakeFrames(slot);
        Confirm(slot);
        break;
    case 6U:
        Step("Hold", slot, 0U, 0U, 0U);
        a_.Hold(slot);
        b_.Hold(slot);
        CompareView(slot);
        break;
    default:
        Step("Request", slot, 0U, 0U, 0U);
        a_.Request(slot);
        b_.Request(slot);
        CompareView(slot);
        break;
    }
}

} // namespace counterpoint::differential
