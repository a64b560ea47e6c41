// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Producers: requests, Prepare, frames and their confirmations, in order and out of it.
#include "verification/differential/differential.hpp"

namespace counterpoint::differential
{

/// The application writes its pair, as a rule inverse in every bit, into both memories; above the objects it leaves
/// what it likes.
void Differential::WriteObjects(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
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
            const std::uint32_t value = random_.Below(256U);
            const std::uint32_t above = random_.Below(256U) & (0xFFU ^ mask);
            device_.memory_a.bytes[at + offset] = static_cast<std::uint8_t>(value);
            device_.memory_a.bytes[at + Memory::kInverseAt + offset] =
                static_cast<std::uint8_t>(((0xFFU ^ value) & mask) | above);
            ++offset;
        }
    }
    if (random_.Chance(80U) && (offset != 0U))
    {
        const std::uint32_t place = at + random_.Below(offset);
        const std::uint32_t wrong = place + (random_.Chance(500U) ? Memory::kInverseAt : 0U);
        device_.memory_a.bytes[wrong] =
            static_cast<std::uint8_t>(device_.memory_a.bytes[wrong] ^ (1U << random_.Below(8U)));
    }
    for (std::uint32_t i = 0U; i < Memory::kSlotBytes; ++i)
    {
        device_.memory_b.bytes[at + i] = device_.memory_a.bytes[at + i];
    }
}

/// The normal frame of these data; bytes behind the length are 0.
CanFrame Differential::NormalOf(SlotIndex slot, const Payload& data) const noexcept
{
    CanFrame frame = FrameOf(slot, false, data);
    for (std::uint32_t i = frame.length_bytes; i < kMaxPayloadBytes; ++i)
    {
        frame.data[i] = 0U;
    }
    return frame;
}

/// Each frame is what the memory of the channel's own side says; that they differ is no difference of the channels.
void Differential::ComparePrepared(SlotIndex slot, const PreparedPair& a, const PreparedPair& b) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    Same("status of Prepare", slot, static_cast<std::uint64_t>(a.status), static_cast<std::uint64_t>(b.status));
    if (a.status != PrepareStatus::kReady)
    {
        SameFrame(slot, a.normal, CanFrame{});
        SameFrame(slot, CanFrame{}, b.normal);
        return;
    }
    Same("identifier of the prepared frame", slot, a.normal.identifier, b.normal.identifier);
    Same("kind of the prepared frame", slot, static_cast<std::uint64_t>(a.normal.kind),
         static_cast<std::uint64_t>(b.normal.kind));
    Same("controller of the prepared frame", slot, static_cast<std::uint64_t>(a.normal.port),
         static_cast<std::uint64_t>(b.normal.port));
    Same("length of the prepared frame", slot, a.normal.length_bytes, b.normal.length_bytes);
    if (!has_odd_mapping_)
    {
        const Payload inverse = device_.memory_b.Read(slot, plan, true);
        SameFrame(slot, a.normal, NormalOf(slot, device_.memory_a.Read(slot, plan, false)));
        SameFrame(slot, NormalOf(slot, Payload{0xFFFFFFFFU ^ inverse.low, 0xFFFFFFFFU ^ inverse.high}), b.normal);
    }
}

void Differential::PrepareBoth(SlotIndex slot) noexcept
{
    Step("Prepare", slot, 0U, 0U, 0U);
    const PreparedPair a = a_.Prepare(slot);
    const PreparedPair b = b_.Prepare(slot);
    ComparePrepared(slot, a, b);
    reached_.Add(Item::kPreparedNotProducer, (a.status == PrepareStatus::kNotProducer) ? 1U : 0U);
    if (a.status != PrepareStatus::kReady)
    {
        CompareSlot(slot);
        return;
    }
    bool is_equal = true;
    for (std::uint32_t i = 0U; i < kMaxPayloadBytes; ++i)
    {
        is_equal = is_equal && (a.normal.data[i] == b.normal.data[i]);
    }
    if (is_equal)
    {
        CompareSlot(slot);
        transmissions_[slot] = Transmission{a.normal, a.normal};
        reached_.Add(Item::kPreparedReady);
    }
    else
    {
        transmissions_[slot] = Transmission{};
        reached_.Add(Item::kPreparedUnequal);
        FailBoth(slot, SrdoCause::kNotInverse);
    }
}

/// What B has to hand out after the last ready Prepare.
CanFrame Differential::InverseOf(SlotIndex slot) const noexcept
{
    CanFrame frame = transmissions_[slot].normal;
    frame.identifier = device_.plans[slot].cob_id_2;
    frame.port = device_.config_b.inverse_port;
    for (std::uint32_t i = 0U; i < frame.length_bytes; ++i)
    {
        frame.data[i] = static_cast<std::uint8_t>(0xFFU ^ frame.data[i]);
    }
    return frame;
}

/// Both are asked; only B may have one.
void Differential::TakeInverse(SlotIndex slot) noexcept
{
    Step("InverseFrame", slot, 0U, 0U, 0U);
    SameFrame(slot, a_.InverseFrame(slot), CanFrame{});
    const CanFrame frame = b_.InverseFrame(slot);
    if (frame.kind == FrameKind::kInvalid)
    {
        SameFrame(slot, CanFrame{}, frame);
    }
    else
    {
        SameFrame(slot, InverseOf(slot), frame);
        transmissions_[slot].frame = frame;
        reached_.Add(Item::kInverseFrame);
    }
    CompareSlot(slot);
}

void Differential::ConfirmBoth(const CanFrame& frame, SlotIndex slot) noexcept
{
    Step("OnConfirm: identifier, length << 8 | kind, stamp", slot, frame.identifier,
         (static_cast<std::uint64_t>(frame.length_bytes) << 8U) | static_cast<std::uint64_t>(frame.kind), clock_us_);
    const Confirmation a = a_.OnConfirm(frame, Instant{clock_us_});
    const Confirmation b = b_.OnConfirm(frame, Instant{clock_us_});
    Same("slot of OnConfirm", slot, a.slot, b.slot);
    Same("step of OnConfirm", slot, static_cast<std::uint64_t>(a.step), static_cast<std::uint64_t>(b.step));
    CompareSlot(slot);
    reached_.Add(Item::kConfirmedNormal, (a.step == ConfirmStep::kNormal) ? 1U : 0U);
    if (a.step == ConfirmStep::kPair)
    {
        NoteSent(slot);
    }
}

/// What kind of SRDO sent a pair, for the counts.
void Differential::NoteSent(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    reached_.Add(Item::kSentPair);
    reached_.Add(Item::kSentBits, ((plan.bits % 8U) != 0U) ? 1U : 0U);
    reached_.Add(Item::kSentStatic, plan.is_static ? 1U : 0U);
    reached_.Add(Item::kSentManyEntries, (plan.pairs > 8U) ? 1U : 0U);
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
    a_.OnTransmitFault(slot, TransmitFault{cause});
    b_.OnTransmitFault(slot, TransmitFault{cause});
    CompareSlot(slot);
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
        for (std::uint32_t half = 0U; half < 2U; ++half)
        {
            if ((half == 1U) && random_.Chance(60U))
            {
                transmissions_[slot].frame = InverseOf(slot); // On the bus, although nobody asked for it.
            }
            else
            {
                TakeInverse(slot);
            }
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
    const SrdoMask bit = SrdoMask{1U} << slot;
    switch (random_.Below(9U))
    {
    case 0U:
        WriteObjects(slot);
        PrepareBoth(slot);
        break;
    case 1U:
    case 2U:
        TakeInverse(slot);
        break;
    case 3U:
        FailBoth(slot,
                 random_.Chance(200U) ? SrdoCause::kNotInverse : static_cast<SrdoCause>(random_.Between(11U, 19U)));
        break;
    case 4U:
    case 5U:
        TakeInverse(slot);
        Confirm(slot);
        break;
    case 6U:
        stand_ |= bit;
        break;
    default:
        request_ |= bit;
        break;
    }
}

} // namespace counterpoint::differential
