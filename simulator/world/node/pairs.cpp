// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/pairs.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint16_t kCommunicationBase = 0x1300U;
constexpr std::uint8_t kCobIdSub1 = 5U;

void KeepFirst(Nanoseconds& first, const Nanoseconds now)
{
    first = (first < 0) ? now : first;
}
} // namespace

NodePairs::NodePairs(const NodePlace& place, const runtime::DeviceModel& model) : place_(place), model_(model)
{
    slot_of_.fill(kNoSlot);
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        if (srdo.direction == kDirectionConsumer)
        {
            TakeIdentifier(srdo.cob_id_1, model.SlotOf(srdo.number).value_or(kNoSlot));
        }
    }
}

void NodePairs::Follow(Kernel& kernel)
{
    slot_of_.fill(kNoSlot);
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const auto index = static_cast<std::uint16_t>(kCommunicationBase + model_.NumberOf(slot));
        if (kernel.GetParameters({index}).direction == kDirectionConsumer)
        {
            TakeIdentifier(ToValue(kernel.ReadObject({index, kCobIdSub1}).data), slot);
        }
    }
}

/// Of the normal frame; that of the inverse frame is the next one.
void NodePairs::TakeIdentifier(const std::uint32_t identifier, const SlotIndex slot)
{
    if (identifier >= kFirstSrdoIdentifier && identifier < kLastSrdoIdentifier)
    {
        slot_of_.at(identifier - kFirstSrdoIdentifier) = slot;
        slot_of_.at(identifier - kFirstSrdoIdentifier + 1U) = slot;
    }
}

SlotIndex NodePairs::ConsumerOf(const CanFrame& frame) const
{
    const bool is_srdo = frame.kind == FrameKind::kData && frame.identifier >= kFirstSrdoIdentifier &&
                         frame.identifier <= kLastSrdoIdentifier;
    return is_srdo ? slot_of_.at(frame.identifier - kFirstSrdoIdentifier) : kNoSlot;
}

void NodePairs::OnFrame(const CanFrame& frame)
{
    const SlotIndex slot = ConsumerOf(frame);
    if (slot == kNoSlot)
    {
        return;
    }
    PairTimes& times = times_.at(slot);
    Payload data{0U, 0U};
    for (std::uint8_t byte = 0U; byte < std::min(frame.length_bytes, kMaxPayloadBytes); ++byte)
    {
        std::uint32_t& word = (byte < 4U) ? data.low : data.high;
        word |= std::uint32_t{frame.data[byte]} << (8U * (byte % 4U));
    }
    if ((frame.identifier & 1U) != 0U)
    {
        times.pending = place_.Now();
        KeepFirst(times.behind_good.next_normal, times.pending);
        KeepFirst(times.behind_judged.next_normal, times.pending);
        times.data = data;
        times.length_bytes = frame.length_bytes;
        place_.Tell(EventKind::kReception, model_.NumberOf(slot), frame.identifier, 0U);
        return;
    }
    const std::uint64_t normal = (std::uint64_t{times.data.high} << 32U) | times.data.low;
    const std::uint64_t inverse = (std::uint64_t{data.high} << 32U) | data.low;
    const std::uint64_t mask = ~std::uint64_t{0U} >> (64U - 8U * std::max<unsigned>(times.length_bytes, 1U));
    const bool is_good =
        times.pending >= 0 && times.length_bytes == frame.length_bytes && ((normal ^ inverse) & mask) == mask;
    if (is_good)
    {
        times.last_good_normal = times.pending;
        times.behind_good = {};
    }
    else
    {
        KeepFirst(times.behind_good.wrong_inverse, place_.Now());
        KeepFirst(times.behind_judged.wrong_inverse, place_.Now());
    }
    times.pending = -1;
    place_.Tell(EventKind::kReception, model_.NumberOf(slot), frame.identifier, is_good ? 1U : 0U);
}

void NodePairs::OnCycle()
{
    for (PairTimes& times : times_)
    {
        if (times.judged_normal != times.last_good_normal)
        {
            times.judged_normal = times.last_good_normal;
            times.behind_judged = times.behind_good;
        }
    }
}

} // namespace counterpoint::simulator
