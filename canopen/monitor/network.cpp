// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/network.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
using cia306::SrdoConfiguration;

constexpr std::uint16_t kReceive = 0x1400U;
constexpr std::uint16_t kReceiveMapping = 0x1600U;
constexpr std::uint16_t kTransmit = 0x1800U;
constexpr std::uint16_t kTransmitMapping = 0x1A00U;
constexpr std::uint16_t kMostPdos = 512U;
constexpr std::uint8_t kMostPdoFields = 64U;
constexpr std::uint16_t kEmergencyCobId = 0x1014U;
constexpr std::uint32_t kDefaultEmergency = 0x80U;
constexpr std::uint32_t kIdentifierMask = 0x7FFU;
constexpr std::uint64_t kFirstSrdoId = 0x101U;
constexpr std::uint64_t kLastSrdoId = 0x180U;
constexpr std::uint8_t kCobId1Sub = 5U;
constexpr std::uint8_t kCobId2Sub = 6U;
constexpr std::uint64_t kOffBit = 0x80000000U;
constexpr std::uint64_t kPdoBit = 0x40000000U; ///< Of a PDO: no remote request. Of emergencies it is reserved.

/// CiA 301: identifiers that no COB-ID may give to another service.
constexpr std::uint64_t kRestricted[][2] = {{0x000U, 0x07FU}, {0x101U, 0x180U}, {0x581U, 0x5FFU},
                                            {0x601U, 0x67FU}, {0x6E0U, 0x6FFU}, {0x701U, 0x7FFU}};

/// Whether a service runs with this COB-ID: on, of 11 bits, and of no other service. Its frames would be taken for
/// those of NMT, or of error control, otherwise. [SRS_MON_711]
bool IsInUse(const std::uint64_t cob_id)
{
    bool is_free = cob_id <= kIdentifierMask;
    for (const auto& range : kRestricted)
    {
        is_free = is_free && (cob_id < range[0] || cob_id > range[1]);
    }
    return is_free;
}

std::string NameIn(const cia306::IniDocument& document, const std::string& path)
{
    for (const char* section : {"DeviceComissioning", "DeviceCommissioning"})
    {
        const cia306::IniSection* const found = document.Find(section);
        const cia306::IniKey* const key = found == nullptr ? nullptr : found->Find("NodeName");
        if (key != nullptr && !key->value.empty())
        {
            return key->value;
        }
    }
    return std::filesystem::path(path).stem().string();
}

std::vector<MappedField> NormalFields(const SrdoConfiguration& srdo)
{
    std::vector<MappedField> fields;
    for (const cia306::MappingEntry& entry : srdo.mapping)
    {
        if (entry.IsNormal())
        {
            fields.push_back({entry.Index(), entry.Sub(), entry.Bits()});
        }
    }
    return fields;
}

std::uint32_t BitsOf(const std::vector<MappedField>& fields)
{
    std::uint32_t bits = 0U;
    for (const MappedField& field : fields)
    {
        bits += field.bits;
    }
    return bits;
}

/// Where it is none, what is watched may be frames of another service. [SRS_MON_332]
void RequireIdentifiers(const std::string& file, const SrdoConfiguration& srdo)
{
    const std::uint64_t first = srdo.cob_id_1.value.value_or(0U);
    const std::uint64_t second = srdo.cob_id_2.value.value_or(0U);
    const bool is_normal = first >= kFirstSrdoId && first < kLastSrdoId && (first & 1U) != 0U;
    if (!is_normal)
    {
        throw cia306::InputError(file, srdo.cob_id_1.place,
                                 {cia306::ObjectName(srdo.CommunicationIndex(), kCobId1Sub) + ": COB-ID " +
                                      cia306::Hex(first, 3) + " of an SRDO that is on",
                                  "an odd one from 0x101 to 0x17F"});
    }
    if (second != first + 1U)
    {
        throw cia306::InputError(file, srdo.cob_id_2.place,
                                 {cia306::ObjectName(srdo.CommunicationIndex(), kCobId2Sub) + ": COB-ID 2 " +
                                      cia306::Hex(second, 3) + " of an SRDO that is on",
                                  cia306::Hex(first + 1U, 3) + " (COB-ID 1 + 1)"});
    }
}

Time Milliseconds(const cia306::Field& field)
{
    return static_cast<Time>(field.value.value_or(0U)) * kMillisecond;
}

WatchModel WatchOf(const NodeModel& node, const SrdoConfiguration& srdo)
{
    WatchModel watch;
    watch.fields = NormalFields(srdo);
    watch.setup.normal_id = static_cast<std::uint32_t>(srdo.cob_id_1.value.value_or(0U));
    watch.setup.inverse_id = static_cast<std::uint32_t>(srdo.cob_id_2.value.value_or(0U));
    watch.setup.bits = BitsOf(watch.fields);
    watch.setup.sct = Milliseconds(srdo.sct_ms);
    watch.setup.srvt = Milliseconds(srdo.srvt_ms);
    watch.setup.is_late = node.parameters.Srdo(srdo.number).srvt_detection == cia306::kLateDetection;
    return watch;
}

std::vector<SrdoConfiguration> ActiveOf(const cia306::SafetyConfiguration& safety)
{
    std::vector<SrdoConfiguration> active;
    const bool is_valid = safety.configuration_valid.Is(cia306::kConfigurationIsValid);
    for (const SrdoConfiguration& srdo : safety.srdos)
    {
        if (is_valid && srdo.IsOn())
        {
            active.push_back(srdo);
        }
    }
    return active;
}
} // namespace

Network::Network(const std::vector<NodeFile>& files, const std::optional<Time> sct)
{
    for (const NodeFile& file : files)
    {
        AddNode(file);
        AddPdos(nodes_.size() - 1U);
    }
    AddWatches(sct);
}

void Network::AddNode(const NodeFile& file)
{
    const auto document = cia306::IniDocument::Parse(file.path, cia306::ReadTextFile(file.path));
    NodeModel node;
    node.device = cia306::ReadDevice(document);
    const std::optional<std::uint8_t> id = file.node_id ? file.node_id : node.device.node_id;
    if (!id)
    {
        throw cia306::InputError(file.path, {},
                                 {"no node-ID", "NodeID in [DeviceComissioning], or --dcf FILE=NODE_ID"});
    }
    if (Find(*id) != nullptr)
    {
        throw cia306::InputError(
            file.path, {},
            {"node-ID " + std::to_string(*id) + ", which " + Find(*id)->device.file + " has already",
             "a node-ID of its own for each file"});
    }
    node.id = *id;
    node.name = cia306::Printable(NameIn(document, file.path));
    node.safety = cia306::ExtractSafety(node.device, id);
    cia306::RequireNone(file.path, node.safety.problems);
    for (const SrdoConfiguration& srdo : node.safety.srdos)
    {
        cia306::RequireNone(file.path, srdo.signature_problems);
    }
    cia306::RequireNone(file.path, node.safety.limits);
    node.active = ActiveOf(node.safety);
    for (const SrdoConfiguration& srdo : node.active)
    {
        RequireIdentifiers(file.path, srdo);
    }
    std::vector<cia306::Finding> problems;
    node.parameters = cia306::ReadDeviceParameters(node.device, id, problems);
    cia306::RequireNone(file.path, problems);
    const std::uint64_t emergency = Number(node, kEmergencyCobId, 0U).value_or(0U);
    node.emergency_id = IsInUse(emergency) ? static_cast<std::uint32_t>(emergency) : kDefaultEmergency + *id;
    nodes_.push_back(std::move(node));
}

/// The configured number; nothing where there is none.
std::optional<std::uint64_t> Network::Number(const NodeModel& node, const std::uint16_t index,
                                             const std::uint8_t sub) const
{
    const cia306::Entry* const entry = node.device.Find(index, sub);
    const bool has_value = entry != nullptr && entry->Configured().IsSet();
    const cia306::ValueResult result = has_value ? cia306::ConfiguredValue(*entry, node.id) : cia306::ValueResult{};
    return result.value ? std::optional(result.value->bits) : std::nullopt;
}

void Network::AddPdos(const std::size_t node)
{
    for (std::uint16_t number = 0U; number < kMostPdos; ++number)
    {
        const auto pdo_number = static_cast<std::uint16_t>(number + 1U);
        AddPdo(node, static_cast<std::uint16_t>(kReceive + number),
               static_cast<std::uint16_t>(kReceiveMapping + number), {0U, node, pdo_number, false, {}});
        AddPdo(node, static_cast<std::uint16_t>(kTransmit + number),
               static_cast<std::uint16_t>(kTransmitMapping + number), {0U, node, pdo_number, true, {}});
    }
}

void Network::AddPdo(const std::size_t node, const std::uint16_t communication, const std::uint16_t mapping,
                     PdoModel pdo)
{
    const NodeModel& owner = nodes_[node];
    const std::uint64_t cob_id = Number(owner, communication, 1U).value_or(kOffBit) & ~kPdoBit;
    if (!IsInUse(cob_id))
    {
        return;
    }
    pdo.identifier = static_cast<std::uint32_t>(cob_id);
    const std::uint64_t count = std::min<std::uint64_t>(Number(owner, mapping, 0U).value_or(0U), kMostPdoFields);
    for (std::uint64_t place = 1U; place <= count; ++place)
    {
        const std::uint64_t entry = Number(owner, mapping, static_cast<std::uint8_t>(place)).value_or(0U);
        pdo.fields.push_back({static_cast<std::uint16_t>((entry >> 16U) & 0xFFFFU),
                              static_cast<std::uint8_t>((entry >> 8U) & 0xFFU),
                              static_cast<std::uint8_t>(entry & 0xFFU)});
    }
    pdos_.push_back(std::move(pdo));
}

void Network::AddWatches(const std::optional<Time> sct)
{
    for (std::size_t node = 0U; node < nodes_.size(); ++node)
    {
        for (const SrdoConfiguration& srdo : nodes_[node].active)
        {
            if (srdo.IsConsumer())
            {
                watches_.push_back(WatchOf(nodes_[node], srdo));
                watches_.back().consumer = SrdoEnd{node, srdo.number};
            }
        }
    }
    for (std::size_t node = 0U; node < nodes_.size(); ++node)
    {
        for (const SrdoConfiguration& srdo : nodes_[node].active)
        {
            if (!srdo.IsProducer())
            {
                continue;
            }
            WatchModel own = WatchOf(nodes_[node], srdo);
            own.setup.sct = sct.value_or(2 * own.setup.sct);
            own.setup.is_late = false;
            own.producer = SrdoEnd{node, srdo.number};
            bool is_consumed = false;
            for (WatchModel& watch : watches_)
            {
                const bool is_this = watch.setup.normal_id == own.setup.normal_id && watch.consumer.has_value();
                is_consumed = is_consumed || is_this;
                watch.producer = is_this ? own.producer : watch.producer;
            }
            if (!is_consumed)
            {
                watches_.push_back(own);
            }
        }
    }
}

const NodeModel* Network::Find(const std::uint8_t id) const noexcept
{
    const auto found =
        std::find_if(nodes_.begin(), nodes_.end(), [id](const NodeModel& node) { return node.id == id; });
    return found == nodes_.end() ? nullptr : &*found;
}

std::string Network::NameOf(const std::uint8_t id) const
{
    const NodeModel* const node = Find(id);
    return node == nullptr ? "node " + std::to_string(id) : node->name;
}

std::string Network::NameOf(const WatchModel& watch) const
{
    const auto end = [this](const std::optional<SrdoEnd>& srdo)
    { return srdo ? nodes_[srdo->node].name + " SRDO " + std::to_string(srdo->number) : std::string("nobody here"); };
    return end(watch.producer) + " -> " + end(watch.consumer);
}
} // namespace counterpoint::monitor
