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
    const FaultKindRow& row = RowOf(fault.kind);
    if (fault.kind == FaultKind::kBitFlip && fault.part == Part::kSetup)
    {
        return FaultClass::kSharedSource;
    }
    const bool is_of_frames = row.site == FaultSite::kReceptions || row.site == FaultSite::kController;
    const bool is_normal = is_of_frames ? ChoosesNormal(fault.frames) : (fault.identifier & 1U) != 0U;
    const bool is_asked = fault.part == Part::kChannelA || fault.part == Part::kChannelB ||
                          fault.part == Part::kChallenge || fault.part == Part::kQuestion;
    const bool is_first = (row.site == FaultSite::kNode) ? is_asked : is_normal;
    return is_first ? row.limit : row.other_limit;
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
        PlanFault(index);
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
        if (kind == FaultKind::kDuplicate || kind == FaultKind::kBabbling)
        {
            foreign_[index] = std::make_unique<ForeignController>(world_.bus);
            world_.places.push_back({kNoNode, 1U, index});
        }
    }
}

std::vector<FrameSelector> NetworkFaults::SelectorsOf(const FaultSite site) const
{
    std::vector<FrameSelector> selectors;
    for (std::size_t index = 0U; index < scenario_.faults.size(); ++index)
    {
        const FaultSetup& fault = scenario_.faults[index];
        if (RowOf(fault.kind).site != site)
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
                    [](const FaultSetup& fault) { return fault.kind == FaultKind::kMasquerade; });
    std::vector<FrameSelector> on_receptions = SelectorsOf(FaultSite::kReceptions);
    if (!on_receptions.empty() || has_masquerade || !foreign_.empty())
    {
        frame_faults_ = std::make_unique<FrameFaults>(stage, std::move(on_receptions));
        world_.bus.Install(*frame_faults_);
    }
    std::vector<FrameSelector> in_controllers = SelectorsOf(FaultSite::kController);
    if (!in_controllers.empty())
    {
        controller_faults_ = std::make_unique<ControllerFaults>(stage, std::move(in_controllers));
        world_.bus.Install(*controller_faults_);
    }
}

void NetworkFaults::PlanInsertedMessages(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    for (std::uint32_t time = 0U; time < fault.times; ++time)
    {
        agenda_.Plan(fault.at + fault.by * time,
                     [this, index, &fault]() { world_.wires.at(fault.node)->Insert(index, world_.Now()); });
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

void NetworkFaults::PlanFault(const std::size_t index)
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

void NetworkFaults::PlanForeignFrames(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    for (std::uint32_t time = 0U; time < fault.times; ++time)
    {
        agenda_.Plan(fault.at + fault.by * time,
                     [this, index, &fault]()
                     {
                         if (fault.kind == FaultKind::kInsertion)
                         {
                             Insert(index);
                             return;
                         }
                         static_cast<void>(world_.bus.Submit(world_.nodes[fault.node]->Controllers().BusNodes().front(),
                                                             ForeignFrame(fault)));
                     });
    }
}

void NetworkFaults::PlanBabbling(const std::size_t index)
{
    const CanFrame frame = ForeignFrame(scenario_.faults[index]);
    ForeignController& controller = *foreign_.at(index);
    PlanState(index, [&controller, frame]() { controller.Babble(frame); }, [&controller]() { controller.Stop(); });
}

void NetworkFaults::PlanControllerFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    if (fault.kind == FaultKind::kQueueOverflow)
    {
        Node& node = *world_.nodes[fault.node];
        PlanState(
            index, [&node, &fault, index]() { node.Controllers().Poll(fault.capacity, index); },
            [&node]() { node.Controllers().Poll(0U, kNoFaultIndex); });
        return;
    }
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
    const bool is_bus_off = fault.kind == FaultKind::kBusOff;
    PlanState(
        index,
        [this, for_each, is_bus_off, index]()
        {
            for_each(is_bus_off ? &host::VirtualBus::ForceBusOff : &host::VirtualBus::Disconnect);
            NoteBegin(index);
        },
        [for_each, is_bus_off]() { for_each(is_bus_off ? &host::VirtualBus::Recover : &host::VirtualBus::Connect); });
}

void NetworkFaults::PlanStandstill(const std::size_t index)
{
    PlanInstant(index, [](Node& node) { node.Processor().StandStill(); });
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

void NetworkFaults::PlanBitFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const runtime::BitPlace place = PlaceOfBit(index);
    if (fault.kind == FaultKind::kStuckBit)
    {
        agenda_.Plan(fault.at,
                     [this, index, &fault, place]() { world_.nodes[fault.node]->Parts().Stick(fault, place, index); });
        return;
    }
    PlanInstant(index, [&fault, place](Node& node) { node.Parts().Flip(fault.part, fault.srdo, place); });
}

void NetworkFaults::PlanPartFault(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    PlanState(
        index, [this, index, &fault]() { world_.nodes[fault.node]->Processor().Faults().Begin(fault, index); },
        [this, &fault]() { world_.nodes[fault.node]->Processor().Faults().End(fault); });
}

void NetworkFaults::PlanClock(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    const auto for_each = [this, &fault](const std::function<void(Node&, bool)>& act)
    {
        if (fault.hits_counter_a)
        {
            act(*world_.nodes[fault.node], true);
        }
        if (fault.hits_counter_b)
        {
            act(*world_.nodes[fault.node], false);
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
        for_each([&fault](Node& node, const bool is_a)
                 { fault.jump ? node.Clock().Jump(is_a, *fault.jump) : node.Clock().SetRate(is_a, fault.rate_ppm); });
        NoteBegin(index);
    };
    const auto end = [for_each, &setup]()
    {
        for_each([&setup](Node& node, const bool is_a)
                 { node.Clock().SetRate(is_a, is_a ? setup.counter_a.drift_ppm : setup.counter_b.drift_ppm); });
    };
    PlanState(index, begin, end);
}

void NetworkFaults::PlanDisturbance(const std::size_t index)
{
    const FaultSetup& fault = scenario_.faults[index];
    if (fault.kind == FaultKind::kCycle)
    {
        PlanInstant(index, [&fault](Node& node) { node.Clock().Shift(fault.by); });
        return;
    }
    PlanState(
        index,
        [this, index, &fault]()
        {
            world_.nodes[fault.node]->App().Disturb(fault.object, BitsOf(fault));
            NoteBegin(index);
        },
        [this, &fault]() { world_.nodes[fault.node]->App().Disturb(fault.object, 0U); });
}
} // namespace counterpoint::simulator
