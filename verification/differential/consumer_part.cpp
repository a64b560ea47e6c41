// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/consumer_part.hpp"

namespace counterpoint::differential
{

namespace
{
Payload Complement(const Payload& data) noexcept
{
    return Payload{0xFFFFFFFFU ^ data.low, 0xFFFFFFFFU ^ data.high};
}
} // namespace

/// Bytes behind the length have no meaning: now and then no complement of those of the normal frame.
void ConsumerPart::ScatterBehind(CanFrame& frame) noexcept
{
    if (scene_.random.Chance(200U))
    {
        for (std::uint32_t i = frame.length_bytes; i < kMaxPayloadBytes; ++i)
        {
            frame.data[i] = static_cast<std::uint8_t>(scene_.random.Below(256U));
        }
    }
}

void ConsumerPart::Feed(const CanFrame& frame, SlotIndex slot) noexcept
{
    // Two controllers may stamp a little out of order; before the call that came before it, no frame can be.
    const std::uint32_t since_call = scene_.clock_us - scene_.now_us;
    const std::uint32_t back_us = scene_.random.Chance(15U) ? scene_.random.Below(since_call + 1U) : 0U;
    const Instant stamp{scene_.clock_us - back_us};
    compare_.Step("OnFrame: identifier, length << 8 | kind << 4 | port, stamp", slot, frame.identifier,
                  (static_cast<std::uint64_t>(frame.length_bytes) << 8U) |
                      (static_cast<std::uint64_t>(frame.kind) << 4U) | static_cast<std::uint64_t>(frame.port),
                  stamp.us);
    scene_.a.OnFrame(frame, stamp);
    scene_.b.OnFrame(frame, stamp);
    compare_.Slot(slot);
}

void ConsumerPart::NormalFrame(SlotIndex slot, const Payload& data) noexcept
{
    Feed(scene_.FrameOf(slot, false, data), slot);
    scene_.last_us[slot] = scene_.clock_us;
}

void ConsumerPart::InverseFrame(SlotIndex slot, const Payload& data) noexcept
{
    CanFrame frame = scene_.FrameOf(slot, true, Complement(data));
    ScatterBehind(frame);
    Feed(frame, slot);
}

void ConsumerPart::GoodPair(SlotIndex slot) noexcept
{
    const Payload data = scene_.AnyData();
    if (scene_.random.Chance(100U))
    {
        scene_.GoNear(slot);
    }
    NormalFrame(slot, data);
    if (scene_.random.Chance(100U))
    {
        scene_.GoNear(slot);
    }
    else
    {
        scene_.LetTimePass(scene_.device.config_a.cycle_us / 8U);
    }
    if (scene_.random.Chance(60U))
    {
        cycle_.Step();
    }
    InverseFrame(slot, data);
}

void ConsumerPart::WrongFrame(SlotIndex slot) noexcept
{
    static constexpr FrameKind kKinds[] = {FrameKind::kInvalid, FrameKind::kRemote, FrameKind::kExtended,
                                           FrameKind::kExtendedRemote, FrameKind::kFlexibleDataRate};
    const bool is_inverse = scene_.random.Chance(500U);
    CanFrame frame = scene_.FrameOf(slot, is_inverse, scene_.AnyData());
    switch (scene_.random.Below(6U))
    {
    case 0U:
        frame.length_bytes = static_cast<std::uint8_t>(scene_.random.Below(10U));
        break;
    case 1U:
        frame.port = static_cast<CanPortId>(scene_.random.Below(4U));
        break;
    case 2U:
        frame.kind = kKinds[scene_.random.Below(5U)];
        break;
    case 3U:
        frame.identifier = scene_.random.Chance(500U) ? scene_.random.Between(0xFFU, 0x183U) : scene_.random.Next();
        break;
    case 4U:
        frame = CanFrame{kGfcIdentifier, FrameKind::kData, CanPortId::kSecond, 0U, {}};
        frame.length_bytes = scene_.random.Chance(200U) ? std::uint8_t{1U} : std::uint8_t{0U};
        break;
    default: // Not inverted, or not at all the data of the normal frame before it.
        if (scene_.random.Chance(700U))
        {
            SpoiledPair(slot);
            return;
        }
        break;
    }
    Feed(frame, slot);
}

/// One bit of the inverse frame, or one of the normal frame with its inverse if nobody maps it.
void ConsumerPart::SpoiledPair(SlotIndex slot) noexcept
{
    const Payload data = scene_.AnyData();
    const std::uint32_t used = scene_.device.plans[slot].bits % 8U;
    CanFrame normal = scene_.FrameOf(slot, false, data);
    CanFrame inverse = scene_.FrameOf(slot, true, Complement(data));
    const std::uint32_t length = (normal.length_bytes == 0U) ? 1U : normal.length_bytes;
    std::uint32_t byte = scene_.random.Below(length);
    std::uint32_t bit = 1U << scene_.random.Below(8U);
    if ((used != 0U) && scene_.random.Chance(500U))
    {
        byte = length - 1U;
        bit = 1U << scene_.random.Between(used, 7U);
        if (scene_.random.Chance(500U))
        {
            normal.data[byte] = static_cast<std::uint8_t>(normal.data[byte] | bit);
        }
        scene_.reached.Add(Item::kUnusedBit);
    }
    inverse.data[byte] = static_cast<std::uint8_t>(inverse.data[byte] ^ bit);
    ScatterBehind(inverse);
    Feed(normal, slot);
    scene_.last_us[slot] = scene_.clock_us;
    scene_.LetTimePass(300U);
    Feed(inverse, slot);
}

void ConsumerPart::Step() noexcept
{
    const SlotIndex slot = scene_.AnySlot();
    scene_.LetTimePass(scene_.random.Chance(30U) ? 6000U : (scene_.device.config_a.cycle_us / 8U));
    const std::uint32_t kind = scene_.random.Below(100U);
    if (kind < 64U)
    {
        GoodPair(slot);
    }
    else if (kind < 72U)
    {
        scene_.GoNear(slot);
        NormalFrame(slot, scene_.AnyData());
    }
    else if (kind < 77U)
    {
        InverseFrame(slot, scene_.AnyData());
    }
    else if (kind < 94U)
    {
        WrongFrame(slot);
    }
    else
    {
        compare_.Step("Demote", slot, 0U, 0U, 0U);
        scene_.a.Demote(slot);
        scene_.b.Demote(slot);
        compare_.Slot(slot);
    }
}

} // namespace counterpoint::differential
