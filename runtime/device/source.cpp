// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/source.hpp"

#include "canopen/cia306/check/rules.hpp"
#include "canopen/cia306/check/sides.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
namespace
{
using cia306::InputError;

static_assert(cia306::kMaxMappingEntries == kMaxMapEntries, "what the reader lets through has room");

constexpr std::size_t kMostObjects = 1024U;
constexpr std::uint8_t kPorts = 2U;

std::uint32_t Number(const cia306::Field& field)
{
    return static_cast<std::uint32_t>(field.value.value_or(0U));
}

ObjectAddress AddressOf(const cia306::MappingEntry& entry)
{
    return {entry.Index(), entry.Sub()};
}

/// 5F05h; everything but the word of late detection is early.
SrvtDetection DetectionOf(const cia306::SrdoParameters& parameters)
{
    return (parameters.srvt_detection == cia306::kLateDetection) ? SrvtDetection::kLate : SrvtDetection::kEarly;
}

bool IsBefore(const SourceVariable& left, const SourceVariable& right)
{
    const std::uint32_t first = (std::uint32_t{left.object.index} << 8U) | left.object.sub;
    const std::uint32_t second = (std::uint32_t{right.object.index} << 8U) | right.object.sub;
    return first < second;
}
} // namespace

DeviceSource::DeviceSource(const cia306::Device& device, const std::string& file,
                           const std::optional<std::uint8_t> node_id, const SafetyNeed need)
    : device_(device), file_(file), node_id_(node_id ? node_id : device.node_id)
{
    if (!node_id_)
    {
        throw InputError(file_, {},
                         {"no node-ID", "NodeID in [DeviceComissioning], --node-id, or node_id in the scenario"});
    }
    safety_ = cia306::ExtractSafety(device_, node_id_);
    cia306::RequireNone(file_, safety_.missing);
    cia306::RequireNone(file_, safety_.problems);
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        cia306::RequireNone(file_, srdo.signature_problems);
        cia306::RequireNone(file_, srdo.other_problems);
    }
    cia306::RequireNone(file_, safety_.limits);
    const auto safety_object = cia306::FirstSafetyObject(device_);
    is_plain_ = need == SafetyNeed::kOptional && !safety_object;
    if (safety_.srdos.empty() && !is_plain_)
    {
        throw InputError(file_, safety_object ? safety_object->second : cia306::Place{},
                         {"no SRDO", "objects 0x1301 to 0x1340 with at least one SRDO"});
    }
    std::vector<cia306::Finding> problems;
    parameters_ = cia306::ReadDeviceParameters(device_, node_id_, problems);
    cia306::RequireNone(file_, problems);
    FollowNodeId();
}

/// Values with $NODEID have followed it; the signatures of the file are those of its own. [SRS_NODE_551]
void DeviceSource::FollowNodeId()
{
    if (!device_.node_id || device_.node_id == node_id_)
    {
        return;
    }
    const cia306::SafetyConfiguration own = cia306::ExtractSafety(device_, device_.node_id);
    for (std::size_t place = 0U; place < safety_.srdos.size(); ++place)
    {
        cia306::SrdoConfiguration& srdo = safety_.srdos[place];
        const auto signature = cia306::SignatureWithNode(own.srdos[place], srdo);
        if (signature)
        {
            srdo.signature.value = *signature;
        }
    }
}

std::vector<SrdoModel> DeviceSource::Srdos() const
{
    std::vector<SrdoModel> models;
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        SrdoModel model;
        model.number = srdo.number;
        model.direction = static_cast<std::uint8_t>(Number(srdo.direction));
        model.times = {static_cast<std::uint16_t>(Number(srdo.sct_ms)), static_cast<std::uint8_t>(Number(srdo.srvt_ms)),
                       DetectionOf(parameters_.Srdo(srdo.number))};
        model.cob_id_1 = Number(srdo.cob_id_1);
        model.cob_id_2 = Number(srdo.cob_id_2);
        for (const cia306::MappingEntry& entry : srdo.mapping)
        {
            if (entry.IsNormal())
            {
                model.normal_objects.push_back(AddressOf(entry));
            }
        }
        models.push_back(model);
    }
    return models;
}

std::vector<SrdoSetup> DeviceSource::Setups() const
{
    std::vector<SrdoSetup> setups;
    if (is_plain_)
    {
        SrdoSetup off{};
        off.number = 1U;
        off.policy = ReleasePolicy::kInterlock;
        off.form = ProducerForm::kProviderCalled;
        off.detection = SrvtDetection::kEarly;
        setups.push_back(off);
    }
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        const cia306::SrdoParameters& parameters = parameters_.Srdo(srdo.number);
        SrdoSetup setup{};
        setup.number = srdo.number;
        const bool is_automatic = parameters.release_policy == cia306::kAutomaticRelease;
        setup.policy = is_automatic ? ReleasePolicy::kAutomatic : ReleasePolicy::kInterlock;
        const bool is_called = parameters.producer_form == 1U;
        setup.form = is_called ? ProducerForm::kProviderCalled : ProducerForm::kApplicationSends;
        setup.detection = DetectionOf(parameters);
        setup.safe_value = {static_cast<std::uint32_t>(parameters.safe_value & 0xFFFFFFFFU),
                            static_cast<std::uint32_t>(parameters.safe_value >> 32U)};
        setups.push_back(setup);
    }
    return setups;
}

MapAccess DeviceSource::AccessOf(const cia306::Entry& entry) const
{
    switch (entry.access)
    {
    case cia306::Access::kReadOnly:
    case cia306::Access::kReadWriteInput:
    case cia306::Access::kConstant:
        return MapAccess::kProducer;
    case cia306::Access::kWriteOnly:
    case cia306::Access::kReadWriteOutput:
        return MapAccess::kConsumer;
    case cia306::Access::kReadWrite:
        break;
    case cia306::Access::kUnknown:
        return MapAccess::kNone;
    }
    // rw fits both directions: what the DCF maps it to decides.
    return safety_.MapsToReceive(entry) ? MapAccess::kConsumer : MapAccess::kProducer;
}

void DeviceSource::AppendVariable(const cia306::Entry& entry, std::vector<SourceVariable>& variables) const
{
    const bool is_mappable = entry.is_srdo_mappable.value_or(entry.is_pdo_mappable);
    const std::uint8_t bits = entry.type.bits; // At most 64.
    const bool has_length = bits != 0U;
    if (!is_mappable || !has_length)
    {
        return;
    }
    SourceVariable variable;
    variable.object = {entry.index, entry.sub, bits, AccessOf(entry), nullptr};
    const std::optional<cia306::Value> value = cia306::UsableValue(file_, entry, node_id_);
    if (!value && entry.Configured().IsSet() && safety_.Maps(entry))
    {
        cia306::Problem problem = cia306::ConfiguredValue(entry, node_id_).problem;
        problem.wrong = cia306::ObjectName(entry.index, entry.sub) + ": " + problem.wrong;
        throw InputError(file_, entry.ValuePlace(), problem);
    }
    variable.value = value ? value->bits : 0U;
    variables.push_back(variable);
}

std::vector<SourceVariable> DeviceSource::Variables() const
{
    std::vector<SourceVariable> variables;
    for (const auto& [index, object] : device_.objects)
    {
        static_cast<void>(index);
        if (is_plain_)
        {
            continue; // None that an SRDO could map.
        }
        for (const auto& [sub, entry] : object.entries)
        {
            static_cast<void>(sub);
            AppendVariable(entry, variables);
        }
    }
    if (variables.size() > kMostObjects)
    {
        throw InputError(file_, {}, {std::to_string(variables.size()) + " mappable objects", "at most 1024"});
    }
    std::sort(variables.begin(), variables.end(), IsBefore);
    return variables;
}

std::size_t DeviceSource::IndexOf(const cia306::MappingEntry& entry, const std::vector<SourceVariable>& variables) const
{
    for (std::size_t index = 0U; index < variables.size(); ++index)
    {
        if (variables[index].object.index == entry.Index() && variables[index].object.sub == entry.Sub())
        {
            return index;
        }
    }
    throw InputError(file_, entry.place,
                     {"the mapping names " + cia306::ObjectName(entry.Index(), entry.Sub()),
                      "an object of the file with SRDOMapping=1 and a length of 1 to 64 bits"});
}

std::vector<VariablePair> DeviceSource::Pairs() const
{
    const std::vector<SourceVariable> variables = Variables();
    std::vector<VariablePair> pairs;
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        std::uint32_t bit = 0U;
        for (std::size_t entry = 0U; entry + 1U < srdo.mapping.size(); entry += 2U)
        {
            const cia306::MappingEntry& normal = srdo.mapping[entry];
            if (!normal.IsDummy())
            {
                VariablePair pair;
                pair.normal = IndexOf(normal, variables);
                pair.inverse = IndexOf(srdo.mapping[entry + 1U], variables);
                pair.srdo = srdo.number;
                pair.first_bit = bit;
                pair.is_consumer = srdo.IsConsumer();
                pairs.push_back(pair);
            }
            bit += normal.Bits();
        }
        // Nobody behind here knows the sides of an object: the kernel's table has none. [SRS_NODE_550]
        cia306::RequireNone(file_, cia306::WrongSides(device_, srdo));
    }
    cia306::RequireNone(file_, cia306::ExchangedSides(safety_));
    return pairs;
}

std::vector<StaticMapping> DeviceSource::StaticMappings() const
{
    const std::vector<SourceVariable> variables = Variables();
    std::vector<StaticMapping> maps;
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        if (!srdo.is_static)
        {
            continue;
        }
        StaticMapping map;
        map.number = srdo.number;
        map.place = srdo.entry_count.place;
        for (const cia306::MappingEntry& entry : srdo.mapping)
        {
            std::vector<std::size_t>& field = entry.IsNormal() ? map.normal : map.inverse;
            field.push_back(IndexOf(entry, variables));
            map.entries.push_back(entry.raw);
        }
        maps.push_back(map);
    }
    return maps;
}

void DeviceSource::AppendMapping(const cia306::SrdoConfiguration& srdo, std::vector<ConfigurationWrite>& writes)
{
    const std::uint16_t mapping = srdo.MappingIndex();
    writes.push_back({{mapping, 0U}, 0U, 1U, srdo.entry_count.place});
    for (const cia306::MappingEntry& entry : srdo.mapping)
    {
        writes.push_back({{mapping, entry.sub}, entry.raw, 4U, entry.place});
    }
    writes.push_back({{mapping, 0U}, Number(srdo.entry_count), 1U, srdo.entry_count.place});
}

void DeviceSource::AppendParameters(const cia306::SrdoConfiguration& srdo,
                                    std::vector<ConfigurationWrite>& writes) const
{
    const std::uint16_t index = srdo.CommunicationIndex();
    const auto add = [&writes](const std::uint16_t object, const std::uint8_t sub, const cia306::Field& field,
                               const std::uint8_t size_bytes)
    { writes.push_back({{object, sub}, Number(field), size_bytes, field.place}); };
    add(index, 2U, srdo.sct_ms, 2U);
    add(index, 3U, srdo.srvt_ms, 1U);
    add(index, 4U, srdo.transmission_type, 1U);
    add(index, 5U, srdo.cob_id_1, 4U);
    add(index, 6U, srdo.cob_id_2, 4U);
    if (!srdo.is_static)
    {
        AppendMapping(srdo, writes);
    }
    add(cia306::kSignatureIndex, srdo.number, srdo.signature, 2U);
}

std::vector<ConfigurationWrite> DeviceSource::Writes() const
{
    std::vector<ConfigurationWrite> writes;
    if (is_plain_)
    {
        return writes;
    }
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        writes.push_back({{srdo.CommunicationIndex(), 1U}, 0U, 1U, srdo.direction.place});
    }
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        AppendParameters(srdo, writes);
    }
    for (const cia306::SrdoConfiguration& srdo : safety_.srdos)
    {
        writes.push_back({{srdo.CommunicationIndex(), 1U}, Number(srdo.direction), 1U, srdo.direction.place});
    }
    if (safety_.gfc.value)
    {
        writes.push_back({{cia306::kGfcIndex, 0U}, Number(safety_.gfc), 1U, safety_.gfc.place});
    }
    const std::uint32_t valid = safety_.configuration_valid.value ? Number(safety_.configuration_valid) : 0U;
    writes.push_back({{cia306::kConfigurationValidIndex, 0U}, valid, 1U, safety_.configuration_valid.place});
    return writes;
}

void DeviceSource::Refuse(const std::uint8_t sub, const cia306::Problem& problem) const
{
    // The defaults are none of these: the value stands in the file.
    const cia306::Entry* const entry = device_.Find(cia306::kDeviceParametersIndex, sub);
    const std::string name = cia306::ObjectName(cia306::kDeviceParametersIndex, sub);
    throw InputError(file_, entry->ValuePlace(), {name + ": " + problem.wrong, problem.expected});
}

/// Much is counted in cycles before the kernel sees them, and it names no place. [SRS_NODE_490, SRS_NODE_711]
void DeviceSource::RequireTimes() const
{
    cia306::Findings findings;
    cia306::CheckTimes({device_, safety_, parameters_, node_id_, parameters_.granularity_bits}, findings);
    for (const cia306::Finding& finding : findings.Sorted())
    {
        if (finding.severity == cia306::Severity::kError)
        {
            throw InputError(file_, finding.place, {finding.object + ": " + finding.text, ""});
        }
    }
}

void DeviceSource::RequirePort(const std::uint8_t sub, const std::uint8_t port) const
{
    if (port == 0U || port > kPorts)
    {
        Refuse(sub, {"controller " + std::to_string(port), "1 or 2"});
    }
}

DeviceConfig DeviceSource::Config() const
{
    RequireTimes();
    RequirePort(cia306::kNormalPortSub, parameters_.normal_port);
    RequirePort(cia306::kInversePortSub, parameters_.inverse_port);
    const bool has_two_ports = parameters_.normal_port != parameters_.inverse_port;
    const bool has_dummies = parameters_.dummy_mapping == cia306::kDummiesAllowed;
    const bool has_gaps = parameters_.number_gaps == cia306::kGapsSearched;
    const bool has_gfc = parameters_.gfc_use == cia306::kGfcPresent;
    DeviceConfig config{};
    config.node_id = *node_id_;
    config.granularity_bits = parameters_.granularity_bits;
    config.map_entries = parameters_.map_entries;
    config.dummies = has_dummies ? DummyMapping::kAllowed : DummyMapping::kRefused;
    config.gaps = has_gaps ? NumberGaps::kSearched : NumberGaps::kRefused;
    config.gfc = has_gfc ? GfcUse::kPresent : GfcUse::kRemoved;
    config.normal_port = CanPortId::kFirst;
    config.inverse_port = has_two_ports ? CanPortId::kSecond : CanPortId::kFirst;
    config.cycle_us = parameters_.cycle_us;
    config.cycle_tolerance_us = parameters_.cycle_tolerance_us;
    config.discrepancy_us = parameters_.discrepancy_us;
    config.acknowledge_window_us = parameters_.acknowledge_window_us;
    config.diagnostic_interval_us = parameters_.diagnostic_interval_ms * kMicrosecondsPerMillisecond;
    config.test_interval_us = parameters_.test_interval_ms * kMicrosecondsPerMillisecond;
    config.clock_tolerance_us = parameters_.clock_tolerance_us;
    config.clock_interval_us = parameters_.clock_tolerance_interval_us;
    config.output_time_us = parameters_.output_us;
    // With another node-ID or other controllers it is another device. [SRS_SIM_490]
    const bool is_same = node_id_ == device_.node_id && parameters_.normal_port == 1U;
    config.digest = is_same ? parameters_.digest : 0U;
    return config;
}
} // namespace counterpoint::runtime
