// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/random.hpp"
#include "simulator/world/network.hpp"

#include <algorithm>

// How faults are brought about: each changes bytes, calls, clocks or frames at its time. [SRS_SIM_020, SRS_SIM_021,
// SRS_SIM_022, SRS_SIM_023, SRS_SIM_024, SRS_SIM_025]
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

} // namespace

FaultClass ClassOf(const FaultSetup& fault)
{
    const bool is_normal = ChoosesNormal(fault.frames);
    const bool is_channel = fault.part == Part::kChannelA || fault.part == Part::kChannelB;
    switch (fault.kind)
    {
    case FaultKind::kCorruption:
    case FaultKind::kRepetition:
    case FaultKind::kWrongSequence:
    case FaultKind::kQueueOverflow:
        return FaultClass::kWrongFrame;
    case FaultKind::kLoss:
    case FaultKind::kDelay:
    case FaultKind::kAddressing:
    case FaultKind::kStoreAndForward:
    case FaultKind::kQueueFull:
    case FaultKind::kSwallowed:
        return is_normal ? FaultClass::kBus : FaultClass::kBusNextNormal;
    case FaultKind::kDuplicate:
        return is_normal ? FaultClass::kBusNextNormal : FaultClass::kWrongFrame;
    case FaultKind::kInsertion:
    case FaultKind::kMasquerade:
        return ((fault.identifier & 1U) != 0U) ? FaultClass::kBusNextNormal : FaultClass::kWrongFrame;
    case FaultKind::kBabbling:
    case FaultKind::kWireError:
    case FaultKind::kBusOff:
    case FaultKind::kUnplugged:
    case FaultKind::kConfirmation:
    case FaultKind::kNotInverse:
        return FaultClass::kBus;
    case FaultKind::kFrozenInput:
        return (fault.part == Part::kChallenge || fault.part == Part::kQuestion) ? FaultClass::kSupervisor
                                                                                 : FaultClass::kBus;
    case FaultKind::kBitFlip:
    case FaultKind::kStuckBit:
        return FaultClass::kConfiguration;
    case FaultKind::kClock:
    case FaultKind::kCycle:
        return FaultClass::kClock;
    case FaultKind::kLinkLoss:
    case FaultKind::kLinkDelay:
    case FaultKind::kLinkRepetition:
    case FaultKind::kLinkReordering:
    case FaultKind::kLinkCorruption:
    case FaultKind::kLinkInsertion:
    case FaultKind::kLinkCut:
        return FaultClass::kCrossLink;
    default:
        return is_channel ? FaultClass::kChannel : FaultClass::kSupervisor;
    }
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
    case FaultKind::kStuckBit:
        PlanBitFault(index);
        return;
    case FaultKind::kStandstill:
        PlanStandstill(index);
        return;
    case FaultKind::kLinkInsertion:
        PlanInsertedMessages(index);
        return;
    case FaultKind::kClock:
        PlanClock(index);
        return;
    case FaultKind::kCycle:
    case FaultKind::kNotInverse:
        PlanDisturbance(index);
        return;
    case FaultKind::kBabbling:
        PlanBabbling(index);
        return;
    case FaultKind::kBusOff:
    case FaultKind::kUnplugged:
    case FaultKind::kQueueOverflow:
        PlanControllerFault(index);
        return;
    default:
        break;
    }
    if (fault.part != Part::kNone)
    {
        PlanPartFault(index); // Those of frames are made by FrameFaults and ControllerFaults.
    }
}

void Network::PlanState(const std::size_t index, const std::function<void()>& begin, const std::function<void()>& end)
{
    const FaultSetup& fault = scenario_.faults[index];
    const Nanoseconds last = std::min(fault.until, scenario_.duration);
    for (Nanoseconds at = fault.at; at < last; at += fault.on + fault.off)
    {
        Plan(at, begin);
        if (fault.on == 0)
        {
            break;
        }
        if (at + fault.on < last)
        {
            Plan(at + fault.on, end);
        }
    }
    if (fault.until != kNever)
    {
        Plan(fault.until, end);
    }
}

void Network::Insert(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const CanFrame frame = ForeignFrame(fault);
    NoteFault(index, fault.frames.receiver.value_or(kNoNode));
    for (NodeIndex node = 0U; node < nodes_.size(); ++node)
    {
        if (fault.frames.receiver.value_or(node) != node)
        {
            continue;
        }
        for (const host::NodeIndex place : nodes_[node]->BusNodes()) // Filters decide which of two it is for.
        {
            bus_.Plan(place, frame, Now());
        }
    }
    journal_.Tell(FrameEntry{Now(), Now(), frame, kNoNode, host::FrameFate::kComplete});
}

void Network::PlanForeignFrames(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    for (std::uint32_t time = 0U; time < fault.times; ++time)
    {
        Plan(fault.at + fault.by * time,
             [this, index, &fault]()
             {
                 if (fault.kind == FaultKind::kInsertion)
                 {
                     Insert(index);
                     return;
                 }
                 static_cast<void>(bus_.Submit(nodes_[fault.node]->BusNodes().front(), ForeignFrame(fault)));
             });
    }
}

void Network::PlanBabbling(const std::size_t index)
{
    const CanFrame frame = ForeignFrame(scenario_.faults[index]);
    ForeignController& controller = *foreign_.at(index);
    PlanState(index, [&controller, frame]() { controller.Babble(frame); }, [&controller]() { controller.Stop(); });
}

void Network::PlanControllerFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    if (fault.kind == FaultKind::kQueueOverflow)
    {
        Node& node = *nodes_[fault.node];
        PlanState(
            index, [&node, &fault, index]() { node.Poll(fault.capacity, index); },
            [&node]() { node.Poll(0U, kNoFaultIndex); });
        return;
    }
    const auto for_each = [this, &fault](void (host::VirtualBus::* const act)(host::NodeIndex))
    {
        const std::vector<host::NodeIndex>& places = nodes_[fault.node]->BusNodes();
        for (std::uint32_t place = 0U; place < places.size(); ++place)
        {
            if (fault.controller == 0U || fault.controller == place + 1U)
            {
                (bus_.*act)(places[place]);
            }
        }
    };
    const bool is_bus_off = fault.kind == FaultKind::kBusOff;
    PlanState(
        index,
        [this, for_each, is_bus_off, index, &fault]()
        {
            for_each(is_bus_off ? &host::VirtualBus::ForceBusOff : &host::VirtualBus::Disconnect);
            NoteFault(index, fault.node);
        },
        [for_each, is_bus_off]() { for_each(is_bus_off ? &host::VirtualBus::Recover : &host::VirtualBus::Connect); });
}

void Network::PlanStandstill(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    Plan(fault.at,
         [this, index, &fault]()
         {
             NoteFault(index, fault.node);
             nodes_[fault.node]->StandStill();
         });
}

runtime::BitPlace Network::PlaceOfBit(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    Node& node = *nodes_[fault.node];
    const std::size_t size = SizeOf(node.PiecesOfPart(fault.part, fault.srdo));
    runtime::BitPlace place{fault.offset.value_or(0U), fault.bit};
    if (fault.config)
    {
        ConfigAddress address = *fault.config;
        address.slot = node.Model().SlotOf(address.slot).value_or(0U);
        const runtime::Letter letter = (fault.part == Part::kChannelA) ? runtime::Letter::kA : runtime::Letter::kB;
        const std::optional<runtime::BitPlace> found =
            runtime::FindConfigBit(letter, node.Model().Config(), address, fault.bit);
        if (!found)
        {
            throw YamlError(fault.source.file, fault.source.place,
                            "bit " + std::to_string(fault.bit) + " of that value", "a bit that the channel keeps");
        }
        place = *found;
    }
    else if (fault.offset && *fault.offset >= size)
    {
        const char* const whose = (fault.part == Part::kChannelA || fault.part == Part::kChannelB)
                                      ? ", the bytes of this channel's storage"
                                      : ", the bytes of this part";
        throw YamlError(fault.source.file, fault.source.place, "offset " + std::to_string(*fault.offset),
                        "an offset below " + std::to_string(size) + whose);
    }
    else if (!fault.offset)
    {
        Random random(scenario_.seed + kFlipSalt + index);
        place.offset = random.Below(static_cast<std::uint32_t>(size));
        place.bit = static_cast<std::uint8_t>(random.Below(8U));
    }
    return place;
}

void Network::PlanBitFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const runtime::BitPlace place = PlaceOfBit(index);
    if (fault.kind == FaultKind::kStuckBit)
    {
        Plan(fault.at, [this, index, &fault, place]() { nodes_[fault.node]->StickBit(fault, place, index); });
        return;
    }
    Plan(fault.at,
         [this, index, &fault, place]()
         {
             nodes_[fault.node]->FlipBit(fault.part, fault.srdo, place);
             NoteFault(index, fault.node);
         });
}

void Network::PlanPartFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    PlanState(
        index, [this, index, &fault]() { nodes_[fault.node]->Faults().Begin(fault, index); },
        [this, &fault]() { nodes_[fault.node]->Faults().End(fault); });
}

void Network::PlanClock(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const auto for_each = [this, &fault](const std::function<void(Node&, bool)>& act)
    {
        if (fault.hits_counter_a)
        {
            act(*nodes_[fault.node], true);
        }
        if (fault.hits_counter_b)
        {
            act(*nodes_[fault.node], false);
        }
    };
    const NodeSetup& setup = scenario_.nodes[fault.node];
    const auto begin = [this, index, for_each, &fault]()
    {
        for_each([&fault](Node& node, const bool is_a)
                 { fault.jump ? node.JumpCounter(is_a, *fault.jump) : node.SetCounterRate(is_a, fault.rate_ppm); });
        NoteFault(index, fault.node);
    };
    const auto end = [for_each, &setup]()
    {
        for_each([&setup](Node& node, const bool is_a)
                 { node.SetCounterRate(is_a, is_a ? setup.counter_a.drift_ppm : setup.counter_b.drift_ppm); });
    };
    PlanState(index, begin, end);
}

void Network::PlanDisturbance(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    if (fault.kind == FaultKind::kCycle)
    {
        Plan(fault.at,
             [this, index, &fault]()
             {
                 nodes_[fault.node]->ShiftCycle(fault.by);
                 NoteFault(index, fault.node);
             });
        return;
    }
    PlanState(
        index,
        [this, index, &fault]()
        {
            nodes_[fault.node]->App().Disturb(fault.object, BitsOf(fault));
            NoteFault(index, fault.node);
        },
        [this, &fault]() { nodes_[fault.node]->App().Disturb(fault.object, 0U); });
}
} // namespace counterpoint::simulator
