// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/memory.hpp"

#include <algorithm>
#include <cstring>

// The members of a manager are private. A structure with the same members lies in memory alike, so that each of them
// has a name; that both are of one size is checked when this is compiled.
namespace counterpoint::campaign::managed
{
namespace
{
struct ManagerShape
{
    void* tables[3];
    cia302::ManagerParts parts;
    cia302::SdoPool sdo;
    cia302::NodeTable table;
    cia302::SafetyGate gate;
    cia302::NmtMaster nmt;
    cia302::NodeWatch watch;
    cia302::OwnDevice own;
    cia302::SafetyPermissions permissions;
    cia302::ManagerRole role;
};
static_assert(sizeof(ManagerShape) == sizeof(cia302::Manager), "the members of the manager");

struct AssemblyShape
{
    const network_plan::LoadedNetwork* net;
    std::array<cia302::NodeRecord, cia302::kNodeRoom> records;
    std::array<cia302::WatchedNode, cia302::kNodeRoom> watched;
    std::array<cia302::GateState, cia302::kNodeRoom> gates;
    std::array<cia302::NmtRequest, 256U> commands;
    std::array<cia302::SafetySlot, cia302::kLastNode> safety;
    cia302::SdoTimes times;
    cia302::SdoLanes<cia302::kLastNode> lanes;
    cia302::Manager manager;
    std::array<cia302::BootRecord, cia302::kNodeRoom> boots;
    std::array<cia302::El6751Node, cia302::kNodeRoom> el6751_nodes;
    std::vector<cia302::El6751PdoRecord> el6751_pdos;
    std::array<cia302::PlcNode, cia302::kNodeRoom> plc_nodes;
    std::unique_ptr<cia302::Cia302StartUp> cia302;
    std::unique_ptr<cia302::El6751StartUp> el6751;
    std::unique_ptr<cia302::PlcStartUp> plc;
    cia302::StartUp* profile;
    cia302::FlyingMasterTimes flying_times;
    cia302::FlyingMasterOptions flying_options;
    bool is_held;
    std::unique_ptr<cia302::FlyingMaster> flying;
};
static_assert(sizeof(AssemblyShape) == sizeof(runtime::ManagerAssembly), "the members of the assembly");

constexpr std::size_t kCommandsUsed = 16U;

class Lister
{
  public:
    void Add(const std::string& name, const void* const object, const std::size_t size)
    {
        if (object != nullptr && size != 0U)
        {
            auto* const bytes = const_cast<std::uint8_t*>(static_cast<const std::uint8_t*>(object));
            places.push_back({name, bytes, size});
        }
    }
    template <typename Object> void Add(const std::string& name, const Object& object)
    {
        Add(name, &object, sizeof(object));
    }
    template <typename Object> void Add(const std::string& name, const std::unique_ptr<Object>& object)
    {
        Add(name, object.get(), sizeof(Object));
    }

    std::vector<ManagerPlace> places{};
};

void AddSlave(Lister& list, network_plan::LoadedNetwork& net, const AssemblyShape& shape, const std::uint8_t node)
{
    const std::string behind = " " + std::to_string(node);
    const network_plan::LoadedSlave& slave = *net.Find(node);
    list.Add("expectation" + behind, slave.objects.data(), slave.objects.size() * sizeof(slave.objects[0]));
    list.Add("expectation_count" + behind, slave.safety.count);
    list.Add("slave" + behind, net.SlaveRoom()[node]);
    list.Add("concise_dcf" + behind, slave.concise.data(), slave.concise.size());
    list.Add("record" + behind, shape.records.at(node));
    list.Add("watched" + behind, shape.watched.at(node));
    list.Add("gate_told" + behind, shape.gates.at(node));
    list.Add("boot" + behind, shape.boots.at(node));
    if (shape.el6751)
    {
        list.Add("el6751_node" + behind, shape.el6751_nodes.at(node));
    }
    if (shape.plc)
    {
        list.Add("plc_node" + behind, shape.plc_nodes.at(node));
    }
}

void AddManager(Lister& list, const AssemblyShape& shape)
{
    const auto& manager = reinterpret_cast<const ManagerShape&>(shape.manager);
    list.Add("parts", manager.parts);
    list.Add("sdo", manager.sdo);
    list.Add("table", manager.table);
    list.Add("gate", manager.gate);
    list.Add("nmt", manager.nmt);
    list.Add("watch", manager.watch);
    list.Add("own", manager.own);
    list.Add("permissions", manager.permissions);
    list.Add("role", manager.role);
    list.Add("cia302", shape.cia302);
    list.Add("el6751", shape.el6751);
    list.Add("el6751_pdos", shape.el6751_pdos.data(), shape.el6751_pdos.size() * sizeof(cia302::El6751PdoRecord));
    list.Add("plc", shape.plc);
    list.Add("flying", shape.flying);
    list.Add("flying_times", shape.flying_times);
}

/// Where a system puts programs, heaps, libraries and stacks, wherever it puts them this time.
[[nodiscard]] bool IsAddress(const std::uint64_t word)
{
    constexpr std::uint32_t kPage = 40U;
    const std::uint64_t begin = word >> kPage;
    return begin == 0x55U || begin == 0x56U || begin == 0x7EU || begin == 0x7FU;
}

/// The word of the machine that holds this byte, of which the byte before the place may be a part, too.
[[nodiscard]] std::uint64_t WordAround(const std::uint8_t* const byte)
{
    constexpr std::uintptr_t kInWord = sizeof(std::uint64_t) - 1U;
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(byte) & ~kInWord;
    std::uint64_t word = 0U;
    std::memcpy(&word, reinterpret_cast<const void*>(address), sizeof(word));
    return word;
}
} // namespace

std::vector<ManagerPlace> PlacesOf(simulator::SimulatedManager& manager)
{
    Lister list;
    if (manager.Station() == nullptr)
    {
        return {};
    }
    network_plan::LoadedNetwork& net = manager.NetRoom();
    const auto& shape = reinterpret_cast<const AssemblyShape&>(manager.Station()->Assembly());
    list.Add("network", net.SetupRoom());
    for (const auto& slave : net.Slaves())
    {
        AddSlave(list, net, shape, slave->plan.node);
    }
    // One for each slave, and one for the manager's own use.
    const std::size_t used = net.Slaves().size() + 1U;
    list.Add("commands", shape.commands.data(), kCommandsUsed * sizeof(shape.commands[0]));
    list.Add("safety", shape.safety.data(), std::min(used, shape.safety.size()) * sizeof(shape.safety[0]));
    list.Add("times", shape.times);
    list.Add("lanes", &shape.lanes, std::min<std::size_t>(used, cia302::kLastNode) * sizeof(cia302::SdoLane));
    AddManager(list, shape);
    return list.places;
}

void MemoryWatch::Look(const std::size_t index, simulator::SimulatedManager& manager)
{
    seen_.resize(std::max(seen_.size(), index + 1U));
    std::vector<ManagerMember>& all = seen_.at(index);
    const std::vector<ManagerPlace> places = PlacesOf(manager);
    for (std::size_t place = all.size(); place < places.size(); ++place)
    {
        all.push_back({index, places[place].name, static_cast<std::uint32_t>(places[place].size)});
    }
}

std::vector<ManagerMember> MemoryWatch::Members() const
{
    std::vector<ManagerMember> members;
    for (const std::vector<ManagerMember>& all : seen_)
    {
        members.insert(members.end(), all.begin(), all.end());
    }
    return members;
}

void FlipIn(simulator::SimulatedManager& manager, const std::string& member, const std::uint32_t byte,
            const std::uint32_t bit)
{
    for (const ManagerPlace& place : PlacesOf(manager))
    {
        if (place.name == member && byte < place.size && !IsAddress(WordAround(place.bytes + byte)))
        {
            place.bytes[byte] = static_cast<std::uint8_t>(place.bytes[byte] ^ (1U << bit));
        }
    }
}
} // namespace counterpoint::campaign::managed
