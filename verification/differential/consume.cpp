// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Frames from the bus: good, wrong, late, out of order, near every limit.
#include "verification/differential/differential.hpp"

namespace counterpoint::differential
{

namespace
{
Payload Complement(const Payload& data) noexcept
{
    return Payload{0xFFFFFFFFU ^ data.low, 0xFFFFFFFFU ^ data.high};
}
} // namespace

Payload Differential::AnyData() noexcept
{
    return Payload{random_.Next(), random_.Next()};
}

CanFrame Differential::FrameOf(SlotIndex slot, bool is_inverse, const Payload& data) const noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    CanFrame frame{is_inverse ? plan.cob_id_2 : plan.cob_id_1,
                   FrameKind::kData,
                   is_inverse ? device_.config_a.inverse_port : device_.config_a.normal_port,
                   BytesOf((plan.bits <= kMaxPayloadBits) ? plan.bits : kMaxPayloadBits),
                   {}};
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        const std::uint32_t half = (i < 4U) ? data.low : data.high;
        frame.data[i] = static_cast<std::uint8_t>((half >> (8U * (i % 4U))) & 0xFFU);
    }
    if (frame.length_bytes != 0U)
    {
        const std::uint8_t mask = LastByteMask(plan.bits);
        std::uint8_t& last = frame.data[frame.length_bytes - 1U];
        last = static_cast<std::uint8_t>(is_inverse ? (last | (0xFFU ^ mask)) : (last & mask));
    }
    return frame;
}

/// Bytes behind the length have no meaning: now and then no complement of those of the normal frame.
void Differential::ScatterBehind(CanFrame& frame) noexcept
{
    if (random_.Chance(200U))
    {
        for (std::uint32_t i = frame.length_bytes; i < kMaxPayloadBytes; ++i)
        {
            frame.data[i] = static_cast<std::uint8_t>(random_.Below(256U));
        }
    }
}

/// The bus moves on by less than `most_us`.
void Differential::LetTimePass(std::uint32_t most_us) noexcept
{
    clock_us_ += random_.Below(most_us + 1U);
}

/// The bus moves on to one of the limits of `slot`, or one microsecond before or behind it, if that lies ahead and
/// near.
void Differential::GoNear(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    const std::uint32_t ms = random_.Chance(500U) ? plan.sct_ms : plan.srvt_ms;
    const std::uint32_t limit = last_us_[slot] + (ms * kMicrosecondsPerMillisecond) + random_.Below(3U) - 1U;
    const std::uint32_t ahead = limit - clock_us_;
    // Mostly within the time in which a call is not late.
    const std::uint32_t room = (now_us_ + device_.config_a.cycle_us + device_.config_a.cycle_tolerance_us) - clock_us_;
    const bool is_near = (room < 0x80000000U) && (ahead <= room);
    if (is_near || ((ahead <= 60000U) && random_.Chance(100U)))
    {
        clock_us_ = limit;
    }
}

void Differential::Feed(const CanFrame& frame, SlotIndex slot) noexcept
{
    // Two controllers may stamp a little out of order; before the call that came before it, no frame can be.
    const std::uint32_t since_call = clock_us_ - now_us_;
    const std::uint32_t back_us = random_.Chance(15U) ? random_.Below(since_call + 1U) : 0U;
    const Instant stamp{clock_us_ - back_us};
    Step("OnFrame: identifier, length << 8 | kind << 4 | port, stamp", slot, frame.identifier,
         (static_cast<std::uint64_t>(frame.length_bytes) << 8U) | (static_cast<std::uint64_t>(frame.kind) << 4U) |
             static_cast<std::uint64_t>(frame.port),
         stamp.us);
    a_.OnFrame(frame, stamp);
    b_.OnFrame(frame, stamp);
    CompareSlot(slot);
}

void Differential::NormalFrame(SlotIndex slot, const Payload& data) noexcept
{
    Feed(FrameOf(slot, false, data), slot);
    last_us_[slot] = clock_us_;
}

void Differential::InverseFrame(SlotIndex slot, const Payload& data) noexcept
{
    CanFrame frame = FrameOf(slot, true, Complement(data));
    ScatterBehind(frame);
    Feed(frame, slot);
}

void Differential::GoodPair(SlotIndex slot) noexcept
{
    const Payload data = AnyData();
    if (random_.Chance(100U))
    {
        GoNear(slot);
    }
    NormalFrame(slot, data);
    if (random_.Chance(100U))
    {
        GoNear(slot);
    }
    else
    {
        LetTimePass(device_.config_a.cycle_us / 8U);
    }
    if (random_.Chance(60U))
    {
        CycleStep();
    }
    InverseFrame(slot, data);
}

void Differential::WrongFrame(SlotIndex slot) noexcept
{
    static constexpr FrameKind kKinds[] = {FrameKind::kInvalid, FrameKind::kRemote, FrameKind::kExtended,
                                           FrameKind::kExtendedRemote, FrameKind::kFlexibleDataRate};
    const bool is_inverse = random_.Chance(500U);
    CanFrame frame = FrameOf(slot, is_inverse, AnyData());
    switch (random_.Below(6U))
    {
    case 0U:
        frame.length_bytes = static_cast<std::uint8_t>(random_.Below(10U));
        break;
    case 1U:
        frame.port = static_cast<CanPortId>(random_.Below(4U));
        break;
    case 2U:
        frame.kind = kKinds[random_.Below(5U)];
        break;
    case 3U:
        frame.identifier = random_.Chance(500U) ? random_.Between(0xFFU, 0x183U) : random_.Next();
        break;
    case 4U:
        frame = CanFrame{kGfcIdentifier, FrameKind::kData, CanPortId::kSecond, 0U, {}};
        frame.length_bytes = random_.Chance(200U) ? std::uint8_t{1U} : std::uint8_t{0U};
        break;
    default: // Not inverted, or not at all the data of the normal frame before it.
        if (random_.Chance(700U))
        {
            SpoiledPair(slot);
            return;
        }
        break;
    }
    Feed(frame, slot);
}

/// One bit of the inverse frame, or one of the normal frame with its inverse if nobody maps it.
void Differential::SpoiledPair(SlotIndex slot) noexcept
{
    const Payload data = AnyData();
    const std::uint32_t used = device_.plans[slot].bits % 8U;
    CanFrame normal = FrameOf(slot, false, data);
    CanFrame inverse = FrameOf(slot, true, Complement(data));
    const std::uint32_t length = (normal.length_bytes == 0U) ? 1U : normal.length_bytes;
    std::uint32_t byte = random_.Below(length);
    std::uint32_t bit = 1U << random_.Below(8U);
    if ((used != 0U) && random_.Chance(500U))
    {
        byte = length - 1U;
        bit = 1U << random_.Between(used, 7U);
        if (random_.Chance(500U))
        {
            normal.data[byte] = static_cast<std::uint8_t>(normal.data[byte] | bit);
        }
        reached_.Add(Item::kUnusedBit);
    }
    inverse.data[byte] = static_cast<std::uint8_t>(inverse.data[byte] ^ bit);
    ScatterBehind(inverse);
    Feed(normal, slot);
    last_us_[slot] = clock_us_;
    LetTimePass(300U);
    Feed(inverse, slot);
}

/// What kind of SRDO took a pair, for the counts.
void Differential::NoteAccepted(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    bool has_dummy = false;
    for (std::uint32_t pair = 0U; pair < plan.pairs; ++pair)
    {
        has_dummy = has_dummy || (plan.dummies[pair] != 0U);
    }
    reached_.Add(Item::kAcceptedBits, ((plan.bits % 8U) != 0U) ? 1U : 0U);
    reached_.Add(Item::kAcceptedDummies, has_dummy ? 1U : 0U);
    reached_.Add(Item::kAcceptedStatic, plan.is_static ? 1U : 0U);
    reached_.Add(Item::kAcceptedManyEntries, (plan.pairs > 8U) ? 1U : 0U);
}

void Differential::ConsumerStep() noexcept
{
    const SlotIndex slot = AnySlot();
    LetTimePass(random_.Chance(30U) ? 6000U : (device_.config_a.cycle_us / 8U));
    const std::uint32_t kind = random_.Below(100U);
    if (kind < 64U)
    {
        GoodPair(slot);
    }
    else if (kind < 72U)
    {
        GoNear(slot);
        NormalFrame(slot, AnyData());
    }
    else if (kind < 77U)
    {
        InverseFrame(slot, AnyData());
    }
    else if (kind < 94U)
    {
        WrongFrame(slot);
    }
    else
    {
        Step("Demote", slot, 0U, 0U, 0U);
        a_.Demote(slot);
        b_.Demote(slot);
        CompareSlot(slot);
    }
}

} // namespace counterpoint::differential
