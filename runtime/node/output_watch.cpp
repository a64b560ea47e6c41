// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/output_watch.hpp"

#include <algorithm>
#include <string>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint8_t kCobIdSub2 = 6U;
} // namespace

OutputWatch::OutputWatch(const DeviceModel& model, host::HostOutput& output, NodeReport& report)
    : model_(model), output_(output), report_(report)
{
    slot_of_.fill(kNoSlot);
}

void OutputWatch::Follow(Kernel& kernel)
{
    slot_of_.fill(kNoSlot);
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const CommunicationIndex index = CommunicationIndexOf(model_.NumberOf(slot));
        const std::uint32_t identifier = ToValue(kernel.ReadObject({index.value, kCobIdSub2}).data);
        const std::uint32_t number = identifier - kFirstSrdoIdentifier;
        if (kernel.GetParameters(index).direction == kDirectionConsumer && number < kSrdoIdentifierCount)
        {
            slot_of_.at(number) = slot;
        }
    }
}

void OutputWatch::OnFrame(const host::LiveFrame& frame)
{
    const std::uint32_t number = frame.identifier - kFirstSrdoIdentifier;
    if (number < kSrdoIdentifierCount && slot_of_.at(number) != kNoSlot)
    {
        received_ns_.at(slot_of_.at(number)) = frame.time_ns;
    }
}

void OutputWatch::OnPair(const std::uint8_t srdo)
{
    paired_ |= SrdoMask{1U} << model_.SlotOf(srdo).value_or(0U);
}

void OutputWatch::Look(const std::uint64_t closed_ns, const std::uint64_t now_ns)
{
    const SrdoMask open = output_.Open();
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const bool is_open = ((open >> slot) & 1U) != 0U;
        const bool is_new = ((paired_ >> slot) & 1U) != 0U;
        const std::uint64_t received_ns = received_ns_.at(slot);
        if (is_open && is_new && received_ns != 0U && received_ns < now_ns)
        {
            latency_.Add(now_ns - received_ns);
        }
        if (((open_ ^ open) >> slot) & 1U)
        {
            const std::uint8_t number = model_.NumberOf(slot);
            report_.Tell(is_open ? now_ns : std::min(closed_ns, now_ns),
                         "output of SRDO " + std::to_string(number) + (is_open ? " open" : " closed"), "output",
                         {{"srdo", number}, {"open", is_open}});
        }
    }
    paired_ = 0U;
    open_ = open;
}
} // namespace counterpoint::runtime
