// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/network_faults.hpp"

#include "simulator/faults/random.hpp"

#include <algorithm>

// How faults are brought about: each changes bytes, calls, clocks or frames at its time. [SRS_SIM_020, SRS_SIM_021,
// SRS_SIM_022, SRS_SIM_023, SRS_SIM_024, SRS_SIM_025, SRS_SIM_063, SRS_SIM_064]
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
    if (fault.kind == FaultKind(NodeFault::kBitFlip) && fault.part == Part::kSetup)
    {
        return FaultClass::kSharedSource;
    }
    if (fault.kind == FaultKind(FrameFault::kRepetition) && fault.by == 0)
    {
        return FaultClass::kWrongFrame; // Nothing is between the frame and its copy; a late one begins a new pair.
    }
    const bool is_of_frames =
        std::holds_alternative<FrameFault>(fault.kind) || std::holds_alternative<ControllerFault>(fault.kind);
    const bool is_of_node =
        std::holds_alternative<PartFault>(fault.kind) || std::holds_alternative<NodeFault>(fault.kind);
    const bool is_normal = is_of_frames ? ChoosesNormal(fault.frames) : (fault.identifier & 1U) != 0U;
    const bool is_asked = fault.part == Part::kChannelA || fault.part == Part::kChannelB ||
                          fault.part == Part::kChallenge || fault.part == Part::kQuestion;
    const FaultLimit& limit = RowOf(fault.kind).limit;
    return (is_of_node ? is_asked : is_normal) ? limit.first : limit.other;
}

NetworkFaults::NetworkFaults(World& world, Agenda& agenda) : world_(world), scenario_(world.scenario), agenda_(agenda)
{
    BuildForeignControllers();
    Install();
}

void NetworkFaults::PlanAll()
{
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        if (!scenario_.faults[index].is_left_out)
        {
            std::visit([this, index](const auto kind) { Plan(kind, index); }, scenario_.faults[index].kind);
        }
    }
}

const std::map<std::size_t, std::uint32_t>& NetworkFaults::Dropped() const noexcept
{
    static const std::map<std::size_t, std::uint32_t> kNone;
    return (frame_faults_ == nullptr) ? kNone : frame_faults_->Dropped();
}

// A fault that sends frames of its own does it by a controller of its own.
void NetworkFaults::BuildForeignControllers()
{
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultKind kind = scenario_.faults[index].kind;
        if (kind == FaultKind(FrameFault::kDuplicate) || kind == FaultKind(ForeignFault::kBabbling))
        {
            foreign_[index] = std::make_unique<ForeignController>(world_.bus);
            world_.places.push_back({kNoNode, 1U, index});
        }
    }
}

template <typename Family> std::vector<FrameSelector> NetworkFaults::SelectorsOf() const
{
    std::vector<FrameSelector> selectors;
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultSetup& fault = scenario_.faults[index];
        if (!std::holds_alternative<Family>(fault.kind))
        {
            continue;
        }
        std::vector<std::uint32_t> identifiers = fault.frames.identifiers;
        for (const runtime::SrdoModel& srdo : world_.models[fault.frames.srdo_of.value_or(0U)]->Srdos())
        {
            const bool is_it = fault.frames.srdo_of && srdo.number == fault.frames.srdo;
            if (is_it && fault.frames.has_normal)
            {
                identifiers.push_back(srdo.cob_id_1);
            }
            if (is_it && fault.frames.has_inverse)
            {
                identifiers.push_back(srdo.cob_id_2);
            }
        }
        selectors.emplace_back(fault, index, std::move(identifiers));
    }
    return selectors;
}

void NetworkFaults::Install()
{
    const FaultStage stage{scenario_, world_.bus, world_.places, world_.journal};
    const bool has_masquerade =
        std::any_of(scenario_.faults.begin(), scenario_.faults.end(),
                    [](const FaultSetup& fault) { return fault.kind == FaultKind(ForeignFault::kMasquerade); });
    std::vector<FrameSelector> on_receptions = SelectorsOf<FrameFault>();
    if (!on_receptions.empty() || has_masquerade || !foreign_.empty())
    {
        frame_faults_ = std::make_unique<FrameFaults>(stage, std::move(on_receptions));
        world_.bus.Install(*frame_faults_);
    }
    std::vector<FrameSelector> in_controllers = SelectorsOf<ControllerFault>();
    if (!in_controllers.empty())
    {
        controller_faults_ = std::make_unique<ControllerFaults>(stage, std::move(in_controllers));
        world_.bus.Install(*controller_faults_);
    }
}

void NetworkFaults::NoteFault(const std::size_t index, const NodeIndex node)
{
    world_.journal.Note({world_.Now(), EventKind::kFault, node, 0U, index, 0U});
}

void NetworkFaults::NoteBegin(const std::size_t index)
{
    const NodeIndex node = scenario_.faults[index].node;
    if (world_.Present(node).HasSupply())
    {
        NoteFault(index, node);
        return;
    }
    waiting_.insert(index);
}

void NetworkFaults::LookAtSupply()
{
    for (auto place = waiting_.begin(); place != waiting_.end();)
    {
        const NodeIndex node = scenario_.faults[*place].node;
        const bool is_there = world_.nodes[node]->HasSupply();
        if (is_there)
        {
            NoteFault(*place, node);
        }
        place = is_there ? waiting_.erase(place) : std::next(place);
    }
}

void NetworkFaults::PlanInstant(const std::size_t index, const std::function<void(Node&)>& act)
{
    const FaultSetup& fault = scenario_.faults[index];
    agenda_.Plan(fault.at,
                 [this, index, act, &fault]()
                 {
                     Node& node = world_.Present(fault.node);
                     if (node.HasSupply())
                     {
                         NoteFault(index, fault.node);
                         act(node);
                     }
                 });
}

void NetworkFaults::Plan(const FrameFault /*kind*/, const std::size_t /*index*/)
{
}

void NetworkFaults::Plan(const ControllerFault /*kind*/, const std::size_t /*index*/)
{
}

void NetworkFaults::Plan(const ForeignFault kind, const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const CanFrame frame = ForeignFrame(fault);
    switch (kind)
    {
    case ForeignFault::kInsertion:
        PlanTimes(index, [this, index]() { Insert(index); });
        return;
    case ForeignFault::kMasquerade:
        PlanTimes(index,
                  [this, &fault, frame]()
                  {
                      const host::NodeIndex sender = world_.nodes[fault.node]->Controllers().BusNodes().front();
                      static_cast<void>(world_.bus.Submit(sender, frame));
                  });
        return;
    case ForeignFault::kBabbling:
        ForeignController& controller = *foreign_.at(index);
        PlanState(index, [&controller, frame]() { controller.Babble(frame); }, [&controller]() { controller.Stop(); });
        return;
    }
}

void NetworkFaults::Plan(const PartFault /*kind*/, const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    PlanState(
        index, [this, index, &fault]() { world_.nodes[fault.node]->Processor().Faults().Begin(fault, index); },
        [this, &fault]() { world_.nodes[fault.node]->Processor().Faults().End(fault); });
}

void NetworkFaults::Plan(const NodeFault kind, const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    Node& device = *world_.nodes[fault.node];
    switch (kind)
    {
    case NodeFault::kBitFlip:
        PlanInstant(index, [&fault, place = PlaceOfBit(index)](Node& node)
                    { node.Parts().Flip(fault.part, fault.srdo, place); });
        return;
    case NodeFault::kStuckBit:
        agenda_.Plan(fault.at, [&device, &fault, index, place = PlaceOfBit(index)]()
                     { device.Parts().Stick(fault, place, index); });
        return;
    case NodeFault::kStandstill:
        PlanInstant(index, [](Node& node) { node.Processor().StandStill(); });
        return;
    case NodeFault::kClock:
        PlanClock(index);
        return;
    case NodeFault::kCycle:
        PlanInstant(index, [&fault](Node& node) { node.Clock().Shift(fault.by); });
        return;
    case NodeFault::kNotInverse:
        PlanState(
            index,
            [this, index, &device, &fault]()
            {
                device.App().Disturb(fault.object, BitsOf(fault));
                NoteBegin(index);
            },
            [&device, &fault]() { device.App().Disturb(fault.object, 0U); });
        return;
    case NodeFault::kBusOff:
        PlanAbsence(index, &host::VirtualBus::ForceBusOff, &host::VirtualBus::Recover);
        return;
    case NodeFault::kUnplugged:
        PlanAbsence(index, &host::VirtualBus::Disconnect, &host::VirtualBus::Connect);
        return;
    case NodeFault::kQueueOverflow:
        PlanState(
            index, [&device, &fault, index]() { device.Controllers().Poll(fault.capacity, index); },
            [&device]() { device.Controllers().Poll(0U, kNoFaultIndex); });
        return;
    }
}

void NetworkFaults::Plan(const LinkFault kind, const std::size_t index)
{
    if (kind == LinkFault::kInsertion)
    {
        LinkWire& wire = *world_.wires.at(scenario_.faults[index].node);
        PlanTimes(index, [this, &wire, index]() { wire.Insert(index, world_.Now()); });
    }
}

void NetworkFaults::PlanTimes(const std::size_t index, const std::function<void()>& act)
{
    const FaultSetup& fault = scenario_.faults[index];
    for (std::uint32_t time = 0U; time < fault.times; ++time)
    {
        agenda_.Plan(fault.at + fault.by * time, act);
    }
}

void NetworkFaults::PlanState(const std::size_t index, const std::function<void()>& begin,
                              const std::function<void()>& act_at_end)
{
    const FaultSetup& fault = scenario_.faults[index];
    const auto end = [this, index, act_at_end]()
    {
        waiting_.erase(index);
        act_at_end();
    };
    const Nanoseconds last = std::min(fault.until, scenario_.duration);
    for (Nanoseconds at = fault.at; at < last; at += fault.on + fault.off)
    {
        agenda_.Plan(at, begin);
        if (fault.on == 0)
        {
            break;
        }
        if (at + fault.on < last)
        {
            agenda_.Plan(at + fault.on, end);
        }
    }
    if (fault.until != kNever)
    {
        agenda_.Plan(fault.until, end);
    }
}

void NetworkFaults::Insert(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const CanFrame frame = ForeignFrame(fault);
    bool is_heard = false;
    for (NodeIndex node = 0U; node < world_.nodes.size(); ++node)
    {
        if (fault.frames.receiver.value_or(node) != node)
        {
            continue;
        }
        for (const host::NodeIndex place :
             world_.nodes[node]->Controllers().BusNodes()) // Filters decide which of two it is for.
        {
            world_.bus.Plan(place, frame, world_.Now());
            is_heard = is_heard || world_.bus.IsOnBus(place);
        }
    }
    if (!is_heard)
    {
        return;
    }
    NoteFault(index, fault.frames.receiver.value_or(kNoNode));
    world_.journal.Tell(FrameEntry{world_.Now(), world_.Now(), frame, kNoNode, host::FrameFate::kComplete});
}

void NetworkFaults::PlanAbsence(const std::size_t index, void (host::VirtualBus::* const go)(host::NodeIndex),
                                void (host::VirtualBus::* const come)(host::NodeIndex))
{
    const FaultSetup& fault = scenario_.faults[index];
    const auto for_each = [this, &fault](void (host::VirtualBus::* const act)(host::NodeIndex))
    {
        const std::vector<host::NodeIndex>& places = world_.nodes[fault.node]->Controllers().BusNodes();
        for (std::uint32_t place = 0U; place < places.size(); ++place)
        {
            if (fault.controller == 0U || fault.controller == place + 1U)
            {
                (world_.bus.*act)(places[place]);
            }
        }
    };
    PlanState(
        index,
        [this, for_each, go, index]()
        {
            for_each(go);
            NoteBegin(index);
        },
        [for_each, come]() { for_each(come); });
}

runtime::BitPlace NetworkFaults::PlaceOfBit(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    Node& node = *world_.nodes[fault.node];
    const std::size_t size = SizeOf(node.Parts().PiecesOf(fault.part, fault.srdo));
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

void NetworkFaults::PlanClock(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const auto for_each = [this, &fault](const auto& act)
    {
        for (const bool is_a : {true, false})
        {
            if (is_a ? fault.hits_counter_a : fault.hits_counter_b)
            {
                act(world_.nodes[fault.node]->Clock(), is_a);
            }
        }
    };
    const NodeSetup& setup = scenario_.nodes[fault.node];
    const bool is_as_before = !fault.jump && (!fault.hits_counter_a || fault.rate_ppm == setup.counter_a.drift_ppm) &&
                              (!fault.hits_counter_b || fault.rate_ppm == setup.counter_b.drift_ppm);
    const auto begin = [this, index, for_each, is_as_before, &fault]()
    {
        if (is_as_before || (fault.jump && !world_.Present(fault.node).HasSupply()))
        {
            return; // Nothing differs; a counter without supply begins anew.
        }
        for_each([&fault](NodeClock& clock, const bool is_a)
                 { fault.jump ? clock.Jump(is_a, *fault.jump) : clock.SetRate(is_a, fault.rate_ppm); });
        NoteBegin(index);
    };
    const auto end = [for_each, &setup]()
    {
        for_each([&setup](NodeClock& clock, const bool is_a)
                 { clock.SetRate(is_a, is_a ? setup.counter_a.drift_ppm : setup.counter_b.drift_ppm); });
    };
    PlanState(index, begin, end);
}
} // namespace counterpoint::simulator
