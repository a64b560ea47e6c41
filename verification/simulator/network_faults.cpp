// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/network.hpp"
#include "verification/simulator/random.hpp"

#include <algorithm>

// How faults are brought about: each changes bytes, calls, clocks or frames at its time. [SRS-SIM-020..025]
namespace counterpoint::simulator
{
namespace
{
/// Far apart from the numbers of the frame faults.
constexpr std::uint64_t kFlipSalt = 0xA5A5F00DU;

CanFrame ForeignFrame(const FaultSetup& fault)
{
    CanFrame frame{};
    frame.identifier = fault.identifier;
    frame.kind = fault.frame_kind;
    frame.port = CanPortId::kFirst;
    frame.length_bytes = static_cast<std::uint8_t>(fault.data.size());
    std::copy(fault.data.begin(), fault.data.end(), frame.data);
    return frame;
}

std::uint64_t BitsOf(const FaultSetup& fault)
{
    std::uint64_t bits = 0U;
    for (const std::uint8_t bit : fault.bits)
    {
        bits |= std::uint64_t{1U} << bit;
    }
    return bits;
}

/// An SRDO's normal frames have odd identifiers.
bool IsNormalIdentifier(const std::uint32_t identifier)
{
    return (identifier & 1U) != 0U;
}
} // namespace

FaultClass ClassOf(const FaultSetup& fault)
{
    const bool is_normal = IsNormalIdentifier(fault.frames.identifier.value_or(1U));
    const bool is_channel = fault.part == Part::kChannelA || fault.part == Part::kChannelB;
    switch (fault.kind)
    {
    case FaultKind::kCorruption:
    case FaultKind::kRepetition:
    case FaultKind::kWrongSequence:
        return FaultClass::kWrongFrame;
    case FaultKind::kLoss:
    case FaultKind::kDelay:
    case FaultKind::kAddressing:
        return is_normal ? FaultClass::kBus : FaultClass::kBusNextNormal;
    case FaultKind::kInsertion:
    case FaultKind::kMasquerade:
        return IsNormalIdentifier(fault.identifier) ? FaultClass::kBusNextNormal : FaultClass::kWrongFrame;
    case FaultKind::kNotInverse:
        return FaultClass::kBus;
    case FaultKind::kBitFlip:
        return FaultClass::kConfiguration;
    case FaultKind::kClock:
    case FaultKind::kCycle:
        return FaultClass::kClock;
    case FaultKind::kSkipped:
    case FaultKind::kDoubled:
    case FaultKind::kHung:
    case FaultKind::kFrozen:
    case FaultKind::kNotCalled:
    case FaultKind::kAlwaysGood:
        break;
    }
    return is_channel ? FaultClass::kChannel : FaultClass::kSupervisor;
}

void Network::NoteFault(const std::size_t index, const NodeIndex node)
{
    journal_.Note({Now(), EventKind::kFault, node, 0U, index, 0U});
}

void Network::PlanFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    switch (fault.kind)
    {
    case FaultKind::kInsertion:
    case FaultKind::kMasquerade:
        PlanForeignFrames(index);
        return;
    case FaultKind::kBitFlip:
        PlanBitFlip(index);
        return;
    case FaultKind::kSkipped:
    case FaultKind::kDoubled:
    case FaultKind::kHung:
    case FaultKind::kFrozen:
    case FaultKind::kNotCalled:
    case FaultKind::kAlwaysGood:
        PlanPartFault(index);
        return;
    case FaultKind::kClock:
    case FaultKind::kCycle:
    case FaultKind::kNotInverse:
        PlanDisturbance(index);
        return;
    case FaultKind::kCorruption:
    case FaultKind::kRepetition:
    case FaultKind::kWrongSequence:
    case FaultKind::kLoss:
    case FaultKind::kDelay:
    case FaultKind::kAddressing:
        return; // FrameFaults makes these.
    }
}

void Network::PlanForeignFrames(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    for (std::uint32_t time = 0U; time < fault.times; ++time)
    {
        Plan(fault.at + fault.by * time,
             [this, index, &fault]()
             {
                 const CanFrame frame = ForeignFrame(fault);
                 if (fault.kind == FaultKind::kMasquerade)
                 {
                     const host::NodeIndex sender = nodes_[fault.node]->Can().NodeOf(CanPortId::kFirst);
                     static_cast<void>(bus_.Submit(sender, frame));
                     return;
                 }
                 NoteFault(index, fault.frames.receiver.value_or(kNoNode));
                 for (NodeIndex node = 0U; node < nodes_.size(); ++node)
                 {
                     if (fault.frames.receiver.value_or(node) == node)
                     {
                         bus_.Plan(nodes_[node]->Can().NodeOf(CanPortId::kFirst), frame, Now());
                     }
                 }
                 journal_.Tell(FrameEntry{Now(), Now(), frame, kNoNode, host::FrameFate::kComplete});
             });
    }
}

void Network::PlanBitFlip(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    Node& node = *nodes_[fault.node];
    BitPlace place{fault.offset.value_or(0U), fault.bit};
    if (fault.config)
    {
        ConfigAddress address = *fault.config;
        address.slot = node.Model().SlotOf(address.slot).value_or(0U);
        const Letter letter = (fault.part == Part::kChannelA) ? Letter::kA : Letter::kB;
        const std::optional<BitPlace> found = FindConfigBit(letter, node.Model().Config(), address, fault.bit);
        if (!found)
        {
            throw ScenarioError(fault.source.file, fault.source.place,
                                "bit " + std::to_string(fault.bit) + " of that value", "a bit that the channel keeps");
        }
        place = *found;
    }
    else if (fault.offset && *fault.offset >= node.StorageSize(fault.part))
    {
        throw ScenarioError(fault.source.file, fault.source.place, "offset " + std::to_string(*fault.offset),
                            "an offset below " + std::to_string(node.StorageSize(fault.part)) +
                                ", the bytes of this channel's storage");
    }
    else if (!fault.offset)
    {
        Random random(scenario_.seed + kFlipSalt + index);
        place.offset = random.Below(static_cast<std::uint32_t>(node.StorageSize(fault.part)));
        place.bit = static_cast<std::uint8_t>(random.Below(8U));
    }
    Plan(fault.at,
         [this, index, &fault, place]()
         {
             nodes_[fault.node]->FlipBit(fault.part, place);
             NoteFault(index, fault.node);
         });
}

void Network::PlanPartFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    Plan(fault.at, [this, index, &fault]() { nodes_[fault.node]->Faults().Begin(fault, index); });
    if (fault.until != kNever)
    {
        Plan(fault.until, [this, &fault]() { nodes_[fault.node]->Faults().End(fault); });
    }
}

void Network::PlanDisturbance(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const CounterSetup& counter =
        fault.is_counter_a ? scenario_.nodes[fault.node].counter_a : scenario_.nodes[fault.node].counter_b;
    const std::int32_t normal_ppm = counter.drift_ppm;
    const auto begin = [this, index, &fault]()
    {
        Node& node = *nodes_[fault.node];
        if (fault.kind == FaultKind::kClock)
        {
            node.SetCounterRate(fault.is_counter_a, fault.rate_ppm);
        }
        else if (fault.kind == FaultKind::kCycle)
        {
            node.ShiftCycle(fault.by);
        }
        else
        {
            node.App().Disturb(fault.object, BitsOf(fault));
        }
        NoteFault(index, fault.node);
    };
    Plan(fault.at, begin);
    if (fault.until == kNever)
    {
        return;
    }
    Plan(fault.until,
         [this, &fault, normal_ppm]()
         {
             Node& node = *nodes_[fault.node];
             if (fault.kind == FaultKind::kClock)
             {
                 node.SetCounterRate(fault.is_counter_a, normal_ppm);
             }
             else
             {
                 node.App().Disturb(fault.object, 0U);
             }
         });
}
} // namespace counterpoint::simulator
