// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/producer_part.hpp"

namespace counterpoint::differential
{

/// The application writes its pair, as a rule inverse in every bit, into both memories; above the objects it leaves
/// what it likes.
void ProducerPart::WriteObjects(SlotIndex slot) noexcept
{
    const SlotPlan& plan = scene_.device.plans[slot];
    const std::uint32_t at = Memory::kSlotBytes * slot;
    if (plan.direction != kDirectionProducer)
    {
        return; // The objects of a consumer are the channels'.
    }
    std::uint32_t offset = 0U;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        const std::uint32_t bytes = BytesOf(plan.lengths[pair]);
        for (std::uint32_t i = 0U; i < bytes; ++i)
        {
            const std::uint32_t mask = ((i + 1U) == bytes) ? LastByteMask(plan.lengths[pair]) : 0xFFU;
            const std::uint32_t value = scene_.random.Below(256U);
            const std::uint32_t above = scene_.random.Below(256U) & (0xFFU ^ mask);
            scene_.device.memory_a.bytes[at + offset] = static_cast<std::uint8_t>(value);
            scene_.device.memory_a.bytes[at + Memory::kInverseAt + offset] =
                static_cast<std::uint8_t>(((0xFFU ^ value) & mask) | above);
            ++offset;
        }
    }
    if (scene_.random.Chance(80U) && (offset != 0U))
    {
        const std::uint32_t place = at + scene_.random.Below(offset);
        const std::uint32_t wrong = place + (scene_.random.Chance(500U) ? Memory::kInverseAt : 0U);
        scene_.device.memory_a.bytes[wrong] =
            static_cast<std::uint8_t>(scene_.device.memory_a.bytes[wrong] ^ (1U << scene_.random.Below(8U)));
    }
    for (std::uint32_t i = 0U; i < Memory::kSlotBytes; ++i)
    {
        scene_.device.memory_b.bytes[at + i] = scene_.device.memory_a.bytes[at + i];
    }
}

/// The normal frame of these data; bytes behind the length are 0.
CanFrame ProducerPart::NormalOf(SlotIndex slot, const Payload& data) const noexcept
{
    CanFrame frame = scene_.FrameOf(slot, false, data);
    for (std::uint32_t i = frame.length_bytes; i < kMaxPayloadBytes; ++i)
    {
        frame.data[i] = 0U;
    }
    return frame;
}

/// Each frame is what the memory of the channel's own side says; that they differ is no difference of the channels.
void ProducerPart::ComparePrepared(SlotIndex slot, const PreparedPair& a, const PreparedPair& b) noexcept
{
    const SlotPlan& plan = scene_.device.plans[slot];
    compare_.Same("status of Prepare", slot, static_cast<std::uint64_t>(a.status),
                  static_cast<std::uint64_t>(b.status));
    if (a.status != PrepareStatus::kReady)
    {
        compare_.Frames(slot, a.normal, CanFrame{});
        compare_.Frames(slot, CanFrame{}, b.normal);
        return;
    }
    compare_.Same("identifier of the prepared frame", slot, a.normal.identifier, b.normal.identifier);
    compare_.Same("kind of the prepared frame", slot, static_cast<std::uint64_t>(a.normal.kind),
                  static_cast<std::uint64_t>(b.normal.kind));
    compare_.Same("controller of the prepared frame", slot, static_cast<std::uint64_t>(a.normal.port),
                  static_cast<std::uint64_t>(b.normal.port));
    compare_.Same("length of the prepared frame", slot, a.normal.length_bytes, b.normal.length_bytes);
    if (!scene_.has_odd_mapping)
    {
        const Payload inverse = scene_.device.memory_b.Read(slot, plan, true);
        compare_.Frames(slot, a.normal, NormalOf(slot, scene_.device.memory_a.Read(slot, plan, false)));
        compare_.Frames(slot, NormalOf(slot, Payload{0xFFFFFFFFU ^ inverse.low, 0xFFFFFFFFU ^ inverse.high}), b.normal);
    }
}

void ProducerPart::Prepare(SlotIndex slot) noexcept
{
    compare_.Step("Prepare", slot, 0U, 0U, 0U);
    const PreparedPair a = scene_.a.Prepare(slot);
    const PreparedPair b = scene_.b.Prepare(slot);
    ComparePrepared(slot, a, b);
    scene_.reached.Add(Item::kPreparedNotProducer, (a.status == PrepareStatus::kNotProducer) ? 1U : 0U);
    if (a.status != PrepareStatus::kReady)
    {
        compare_.Slot(slot);
        return;
    }
    bool is_equal = true;
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        is_equal = is_equal && (a.normal.data[i] == b.normal.data[i]);
    }
    if (is_equal)
    {
        compare_.Slot(slot);
        transmissions_[slot] = Transmission{a.normal, a.normal};
        scene_.reached.Add(Item::kPreparedReady);
    }
    else
    {
        transmissions_[slot] = Transmission{};
        scene_.reached.Add(Item::kPreparedUnequal);
        Fail(slot, SrdoCause::kNotInverse);
    }
}

/// What both have to hand out after the last ready Prepare.
CanFrame ProducerPart::InverseOf(SlotIndex slot) const noexcept
{
    CanFrame frame = transmissions_[slot].normal;
    frame.identifier = scene_.device.plans[slot].cob_id_2;
    frame.port = scene_.device.config_b.inverse_port;
    for (std::uint32_t i = 0U; i < frame.length_bytes; ++i)
    {
        frame.data[i] = static_cast<std::uint8_t>(0xFFU ^ frame.data[i]);
    }
    return frame;
}

/// Both are asked, and asked again: nothing may have changed.
void ProducerPart::TakeInverse(SlotIndex slot) noexcept
{
    compare_.Step("InverseFrame", slot, 0U, 0U, 0U);
    const CanFrame a = scene_.a.InverseFrame(slot);
    const CanFrame b = scene_.b.InverseFrame(slot);
    const CanFrame expected = (b.kind == FrameKind::kInvalid) ? CanFrame{} : InverseOf(slot);
    compare_.Frames(slot, a, expected);
    compare_.Frames(slot, expected, b);
    compare_.Frames(slot, scene_.a.InverseFrame(slot), b);
    compare_.Frames(slot, a, scene_.b.InverseFrame(slot));
    if (b.kind != FrameKind::kInvalid)
    {
        transmissions_[slot].frame = b;
        scene_.reached.Add(Item::kInverseFrame);
    }
    compare_.Slot(slot);
}

void ProducerPart::ConfirmBoth(const CanFrame& frame, SlotIndex slot) noexcept
{
    compare_.Step("OnConfirm: identifier, length << 8 | kind, stamp", slot, frame.identifier,
                  (static_cast<std::uint64_t>(frame.length_bytes) << 8U) | static_cast<std::uint64_t>(frame.kind),
                  scene_.clock_us);
    const Confirmation a = scene_.a.OnConfirm(frame, Instant{scene_.clock_us});
    const Confirmation b = scene_.b.OnConfirm(frame, Instant{scene_.clock_us});
    compare_.Same("slot of OnConfirm", slot, a.slot, b.slot);
    compare_.Same("step of OnConfirm", slot, static_cast<std::uint64_t>(a.step), static_cast<std::uint64_t>(b.step));
    compare_.Slot(slot);
    scene_.reached.Add(Item::kConfirmedNormal, (a.step == ConfirmStep::kNormal) ? 1U : 0U);
    if (a.step == ConfirmStep::kPair)
    {
        NoteSent(slot);
    }
}

/// What kind of SRDO sent a pair, for the counts.
void ProducerPart::NoteSent(SlotIndex slot) noexcept
{
    const SlotPlan& plan = scene_.device.plans[slot];
    scene_.reached.Add(Item::kSentPair);
    scene_.reached.Add(Item::kSentBits, ((plan.bits % 8U) != 0U) ? 1U : 0U);
    scene_.reached.Add(Item::kSentStatic, plan.is_static ? 1U : 0U);
    scene_.reached.Add(Item::kSentManyEntries, (plan.pairs > 8U) ? 1U : 0U);
}

/// The frame on the bus is confirmed: as a rule as it was, now and then another, or just on or behind its limit.
void ProducerPart::Confirm(SlotIndex slot) noexcept
{
    Transmission& transmission = transmissions_[slot];
    CanFrame frame = transmission.frame;
    if (frame.kind == FrameKind::kInvalid)
    {
        // One after the other: compilers differ in the order in which they evaluate arguments.
        const bool is_inverse = scene_.random.Chance(500U);
        frame = scene_.FrameOf(slot, is_inverse, scene_.AnyData());
    }
    if (scene_.random.Chance(60U))
    {
        scene_.GoNear(slot);
    }
    else
    {
        scene_.LetTimePass(scene_.device.config_a.cycle_us / 16U);
    }
    switch (scene_.random.Below(40U))
    {
    case 0U:
        frame.data[0] = static_cast<std::uint8_t>(frame.data[0] ^ (1U << scene_.random.Below(8U)));
        break;
    case 1U:
        frame.length_bytes = static_cast<std::uint8_t>(scene_.random.Below(10U));
        break;
    case 2U:
        frame.kind = FrameKind::kRemote;
        break;
    case 3U:
        frame.identifier ^= 1U << scene_.random.Below(11U);
        break;
    default:
        break;
    }
    ConfirmBoth(frame, slot);
    scene_.last_us[slot] = scene_.clock_us;
    transmission.frame.kind = FrameKind::kInvalid;
}

void ProducerPart::Fail(SlotIndex slot, SrdoCause cause) noexcept
{
    compare_.Step("OnTransmitFault: cause", slot, static_cast<std::uint64_t>(cause), 0U, 0U);
    scene_.a.OnTransmitFault(slot, TransmitFault{cause});
    scene_.b.OnTransmitFault(slot, TransmitFault{cause});
    compare_.Slot(slot);
}

/// As if its refresh waited in this channel alone, since the counters of a device drift: it stands until the next
/// OnCycle and nothing is prepared, while the application asks or does not.
bool ProducerPart::IsHeld(SlotIndex slot, SrdoMask refresh) noexcept
{
    const SrdoMask bit = SrdoMask{1U} << slot;
    if (((refresh & bit) == 0U) || (!scene_.random.Chance(250U)))
    {
        return false;
    }
    scene_.stand |= bit;
    scene_.request |= scene_.random.Chance(500U) ? bit : 0U;
    return true;
}

void ProducerPart::Serve(SrdoMask due, SrdoMask refresh) noexcept
{
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        const bool is_held = IsHeld(slot, refresh);
        if ((((due >> slot) & 1U) == 0U) || is_held || scene_.random.Chance(120U))
        {
            continue;
        }
        WriteObjects(slot);
        Prepare(slot);
        for (std::uint32_t half = 0U; half < 2U; ++half)
        {
            if ((half == 1U) && scene_.random.Chance(60U))
            {
                transmissions_[slot].frame = InverseOf(slot); // On the bus, although nobody asked for it.
            }
            else
            {
                TakeInverse(slot);
            }
            if (scene_.random.Chance(50U))
            {
                Fail(slot, scene_.random.Chance(500U) ? SrdoCause::kTransmitQueue : SrdoCause::kBusOff);
            }
            if (scene_.random.Chance(100U))
            {
                break; // The rest later, or never.
            }
            Confirm(slot);
        }
    }
}

void ProducerPart::Step() noexcept
{
    const SlotIndex slot = scene_.AnySlot();
    const SrdoMask bit = SrdoMask{1U} << slot;
    switch (scene_.random.Below(9U))
    {
    case 0U:
        WriteObjects(slot);
        Prepare(slot);
        break;
    case 1U:
    case 2U:
        TakeInverse(slot);
        break;
    case 3U:
        Fail(slot, scene_.random.Chance(200U) ? SrdoCause::kNotInverse
                                              : static_cast<SrdoCause>(scene_.random.Between(11U, 19U)));
        break;
    case 4U:
    case 5U:
        TakeInverse(slot);
        Confirm(slot);
        break;
    case 6U:
        scene_.stand |= bit;
        break;
    default:
        scene_.request |= bit;
        break;
    }
}

} // namespace counterpoint::differential
