// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/model.hpp"

#include "runtime/device/source.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint8_t kIntervalSub = 4U;

const char* MeaningOf(const AbortCode code)
{
    switch (code)
    {
    case AbortCode::kNone:
        return "no error";
    case AbortCode::kUnsupportedAccess:
        return "mapping in use";
    case AbortCode::kReadOnly:
        return "read only";
    case AbortCode::kObjectUnknown:
        return "unknown object";
    case AbortCode::kNotMappable:
        return "not mappable, or another length";
    case AbortCode::kMapTooLong:
        return "odd count, or more than 64 bits";
    case AbortCode::kIncompatible:
        return "the configuration does not hold: signature, timing, identifiers or mapping";
    case AbortCode::kLengthMismatch:
        return "wrong size";
    case AbortCode::kSubUnknown:
        return "unknown sub-index";
    case AbortCode::kValueRange:
        return "value out of range, or identifiers that are in use or no pair";
    case AbortCode::kGeneral:
        return "the channels differ";
    case AbortCode::kDeviceState:
        return "not in this state";
    }
    return "unknown abort code";
}
std::uint8_t BytesOf(const MappableObject& object)
{
    return static_cast<std::uint8_t>((object.length_bits + 7U) / 8U);
}
} // namespace

DeviceModel::DeviceModel(const std::string& file, const std::optional<std::uint8_t> node_id, const SafetyNeed need)
    : file_(file)
{
    const cia306::Device device = cia306::ReadDeviceFile(file);
    DeviceSource source(device, file, node_id, need);
    srdos_ = source.Srdos();
    setups_ = source.Setups();
    writes_ = source.Writes();
    const std::vector<SourceVariable> variables = source.Variables();
    for (const SrdoModel& srdo : srdos_)
    {
        numbers_.push_back(srdo.number);
    }
    LayOut(variables, source.StaticMappings());
    pairs_ = source.Pairs();
    if (need == SafetyNeed::kOptional)
    {
        KeepSafetyObjects(device);
    }
    const cia306::Entry* const interval = device.Find(cia306::kDeviceParametersIndex, kIntervalSub);
    interval_place_ = interval == nullptr ? cia306::Place{} : interval->ValuePlace();
    config_ = source.Config();
    config_.srdos = setups_.data();
    config_.objects = objects_.data();
    config_.object_count = static_cast<std::uint16_t>(objects_.size());
    config_.srdo_count = static_cast<std::uint8_t>(setups_.size());
    ResetVariables();
}

// The fields of static mappings first, each without a gap, then everything else.
void DeviceModel::LayOut(const std::vector<SourceVariable>& variables, const std::vector<StaticMapping>& maps)
{
    std::size_t bytes = 0U;
    std::vector<std::size_t> all;
    for (const SourceVariable& variable : variables)
    {
        bytes += BytesOf(variable.object);
        objects_.push_back(variable.object);
        addresses_.push_back({variable.object.index, variable.object.sub});
        all.push_back(all.size());
    }
    memory_.resize(bytes);
    initial_.reserve(bytes); // `Place` appends to it.
    for (const StaticMapping& map : maps)
    {
        StaticTable table;
        std::copy(map.entries.begin(), map.entries.end(), table.entries.begin());
        table.number = map.number;
        table.count = static_cast<std::uint8_t>(map.entries.size());
        table.place = map.place;
        table.normal = initial_.size();
        Place(map.normal, variables);
        table.inverse = initial_.size();
        Place(map.inverse, variables);
        tables_.push_back(table);
    }
    Place(all, variables);
    JoinTables();
}

// Those of the list that have no place yet, one behind the other.
void DeviceModel::Place(const std::vector<std::size_t>& variables, const std::vector<SourceVariable>& source)
{
    for (const std::size_t index : variables)
    {
        if (objects_[index].place != nullptr)
        {
            continue;
        }
        objects_[index].place = memory_.data() + initial_.size();
        for (std::uint8_t byte = 0U; byte < BytesOf(objects_[index]); ++byte)
        {
            initial_.push_back(static_cast<std::uint8_t>(source[index].value >> (8U * byte)));
        }
    }
}

void DeviceModel::JoinTables() noexcept
{
    for (const StaticTable& table : tables_)
    {
        setups_[SlotOf(table.number).value_or(0U)].map = {table.entries.data(), table.count};
    }
}

void DeviceModel::KeepSafetyObjects(const cia306::Device& device)
{
    std::vector<std::size_t> places(objects_.size(), objects_.size()); // By the place before.
    std::size_t kept = 0U;
    for (std::size_t place = 0U; place < objects_.size(); ++place)
    {
        const cia306::Entry* const entry = device.Find(objects_[place].index, objects_[place].sub);
        const bool is_mapped = std::any_of(pairs_.begin(), pairs_.end(), [place](const VariablePair& pair)
                                           { return pair.normal == place || pair.inverse == place; });
        if (is_mapped || (entry != nullptr && entry->is_srdo_mappable.value_or(false)))
        {
            places[place] = kept;
            objects_[kept] = objects_[place];
            addresses_[kept] = addresses_[place];
            ++kept;
        }
    }
    objects_.resize(kept);
    addresses_.resize(kept);
    for (VariablePair& pair : pairs_)
    {
        pair.normal = places[pair.normal];
        pair.inverse = places[pair.inverse];
    }
}

const std::string& DeviceModel::File() const noexcept
{
    return file_;
}

const DeviceConfig& DeviceModel::Config() const noexcept
{
    return config_;
}

const std::vector<SrdoModel>& DeviceModel::Srdos() const noexcept
{
    return srdos_;
}

const std::vector<VariablePair>& DeviceModel::Pairs() const noexcept
{
    return pairs_;
}

const std::vector<MappableObject>& DeviceModel::Objects() const noexcept
{
    return objects_;
}

const std::vector<ConfigurationWrite>& DeviceModel::Writes() const noexcept
{
    return writes_;
}

const std::vector<StaticTable>& DeviceModel::StaticTables() const noexcept
{
    return tables_;
}

StaticFields DeviceModel::FieldsOf(const StaticTable& table) noexcept
{
    return {memory_.data() + table.normal, memory_.data() + table.inverse};
}

StaticTable* DeviceModel::StaticTableOf(const std::uint8_t number) noexcept
{
    const auto found = std::find_if(tables_.begin(), tables_.end(),
                                    [number](const StaticTable& table) { return table.number == number; });
    return (found == tables_.end()) ? nullptr : &*found;
}

std::optional<SlotIndex> DeviceModel::SlotOf(const std::uint8_t number) const noexcept
{
    const auto found = std::find(numbers_.begin(), numbers_.end(), number);
    if (found == numbers_.end())
    {
        return std::nullopt;
    }
    return static_cast<SlotIndex>(found - numbers_.begin());
}

std::uint8_t DeviceModel::NumberOf(const SlotIndex slot) const noexcept
{
    return (slot < numbers_.size()) ? numbers_[slot] : std::uint8_t{0U};
}

const VariablePair* DeviceModel::PairOf(const ObjectAddress& normal) const noexcept
{
    for (const VariablePair& pair : pairs_)
    {
        const ObjectAddress& address = addresses_[pair.normal];
        if (address.index == normal.index && address.sub == normal.sub)
        {
            return &pair;
        }
    }
    return nullptr;
}

void DeviceModel::UseTwoControllers() noexcept
{
    if (config_.normal_port == config_.inverse_port)
    {
        config_.normal_port = CanPortId::kFirst;
        config_.inverse_port = CanPortId::kSecond;
        config_.digest = 0U;
    }
}

std::uint32_t DeviceModel::ControllerCount() const noexcept
{
    return (config_.normal_port == config_.inverse_port) ? 1U : 2U;
}

std::vector<std::uint8_t>& DeviceModel::Memory() noexcept
{
    return memory_;
}

std::vector<MappableObject>& DeviceModel::ObjectTable() noexcept
{
    return objects_;
}

std::vector<SrdoSetup>& DeviceModel::SetupTable() noexcept
{
    return setups_;
}

void DeviceModel::ResetVariables() noexcept
{
    std::copy(initial_.begin(), initial_.end(), memory_.begin());
}

std::string AbortText(const AbortCode code)
{
    std::array<char, 16U> text{};
    const auto number = static_cast<std::uint32_t>(code);
    static_cast<void>(std::snprintf(text.data(), text.size(), "%04X %04Xh", static_cast<unsigned>(number >> 16U),
                                    static_cast<unsigned>(number & 0xFFFFU)));
    return text.data();
}

ObjectData DataOf(const ConfigurationWrite& write)
{
    ObjectData data{};
    data.size_bytes = write.size_bytes;
    for (std::uint8_t byte = 0U; byte < write.size_bytes; ++byte)
    {
        data.bytes[byte] = static_cast<std::uint8_t>(write.value >> (8U * byte));
    }
    return data;
}

cia306::InputError RefusalOf(const DeviceModel& model, const ConfigurationWrite& write, const AbortCode code)
{
    const std::string object = cia306::ObjectName(write.object.index, write.object.sub);
    const auto digits = static_cast<int>(write.size_bytes * 2U);
    return {model.File(),
            write.place,
            {object + ": the device refuses " + cia306::Hex(write.value, digits) + " with abort code " +
                 AbortText(code) + " (" + MeaningOf(code) + ")",
             "a configuration that it accepts; 'counterpoint check' tells more"}};
}
} // namespace counterpoint::runtime
