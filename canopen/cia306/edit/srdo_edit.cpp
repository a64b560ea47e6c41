// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/srdo_edit.hpp"

#include "canopen/cia306/check/sides.hpp"
#include "canopen/cia306/edit/dictionary_edits.hpp"
#include "canopen/cia306/edit/mapping_text.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/file/value_edits.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint16_t kFirstProducedIndex = 0x2000U;
constexpr std::uint16_t kFirstConsumedIndex = 0x2200U;
constexpr std::uint16_t kInverseDistance = 0x100U;
constexpr std::uint16_t kLastNewIndex = 0x5DFFU; ///< With its inverse object before 5F00h.

std::string Name(const ObjectPlace& place)
{
    return ObjectName(place.index, place.sub);
}

/// The text of the value of this type whose bits are none of these.
std::string Complement(const DataType& type, const std::uint64_t bits)
{
    const std::uint64_t mask = ~std::uint64_t{0U} >> (64U - type.bits);
    const std::uint64_t image = ~bits & mask;
    const bool is_negative = type.kind == DataKind::kSigned && (image >> (type.bits - 1U)) != 0U;
    if (type.kind == DataKind::kSigned)
    {
        return is_negative ? "-" + std::to_string((~image & mask) + 1U) : std::to_string(image);
    }
    return Hex(image, type.bits / 4);
}

/// Builds one SRDO of a file.
class SrdoBuilder
{
  public:
    SrdoBuilder(const IniDocument& document, const Device& device, const SrdoPlan& plan,
                const std::optional<std::uint8_t> node_id)
        : document_(document), device_(device), plan_(plan), node_id_(node_id), edits_(document, device)
    {
    }

    /// The document with the objects of the SRDO and places for its values.
    IniDocument Build();
    /// The values of objects that may have been in the file before.
    [[nodiscard]] std::vector<ValueEdit> Values(const Device& built) const;

  private:
    void RequireFree() const;
    void RequireNormal(const Entry& entry) const;
    void MapPairs();
    void MapPresent(const PlannedPair& pair);
    void AddMapping(const ObjectPlace& normal, const ObjectPlace& inverse, std::uint8_t bits);
    [[nodiscard]] ObjectPlace InverseOf(const PlannedPair& pair, const Entry& normal);
    [[nodiscard]] std::uint64_t BitsOf(const Entry& entry, const Text& value) const;
    [[nodiscard]] std::uint16_t FreeIndex() const;
    void AddNewObjects(const std::vector<PlannedPair>& pairs);
    [[nodiscard]] NewEntry VariableOf(const PlannedPair& pair, std::uint8_t place, bool is_normal) const;
    void AddCommunication();
    void AddMappingObject();
    void AddCommonObjects();

    const IniDocument& document_;
    const Device& device_;
    const SrdoPlan& plan_;
    std::optional<std::uint8_t> node_id_;
    DictionaryEdits edits_;
    std::vector<std::uint32_t> mapping_;
};

IniDocument SrdoBuilder::Build()
{
    RequireFree();
    MapPairs();
    AddCommunication();
    AddMappingObject();
    AddCommonObjects();
    return edits_.Apply();
}

void SrdoBuilder::RequireFree() const
{
    for (const std::uint16_t first : {kFirstCommunicationIndex, kFirstMappingIndex})
    {
        const auto index = static_cast<std::uint16_t>(first + plan_.number - 1U);
        const Object* const object = device_.Find(index);
        const auto listed = device_.missing.find(index);
        if (object != nullptr || listed != device_.missing.end())
        {
            throw InputError(device_.file, object != nullptr ? object->place : listed->second,
                             {"SRDO " + std::to_string(plan_.number) + " is there already", "a number that is free"});
        }
    }
}

void SrdoBuilder::MapPairs()
{
    std::vector<PlannedPair> fresh;
    for (const PlannedPair& pair : plan_.pairs)
    {
        if (!pair.normal)
        {
            fresh.push_back(pair);
        }
    }
    if (!fresh.empty())
    {
        AddNewObjects(fresh);
    }
    // New objects and those of the file take turns as the plan has them.
    const std::vector<std::uint32_t> made = std::exchange(mapping_, {});
    auto next = made.begin();
    for (const PlannedPair& pair : plan_.pairs)
    {
        if (pair.normal)
        {
            MapPresent(pair);
        }
        else
        {
            mapping_.insert(mapping_.end(), next, next + 2);
            next += 2;
        }
    }
}

void SrdoBuilder::AddMapping(const ObjectPlace& normal, const ObjectPlace& inverse, const std::uint8_t bits)
{
    for (const ObjectPlace& place : {normal, inverse})
    {
        mapping_.push_back((std::uint32_t{place.index} << 16U) | (std::uint32_t{place.sub} << 8U) | bits);
    }
}

/// Inverse data would be signed as data, and taken for it; so would a safety object, of a device that has none before
/// this SRDO, too. [SRS_NEW_730]
void SrdoBuilder::RequireNormal(const Entry& entry) const
{
    const bool is_of_kernel = entry.index >= kGfcIndex && entry.index <= kSignatureIndex;
    const bool is_parameter = entry.index >= kDeviceParametersIndex && entry.index <= kDetectionIndex;
    if (is_of_kernel || is_parameter)
    {
        throw InputError(
            device_.file, entry.place,
            {ObjectName(entry.index, entry.sub) + " is a safety object of the device", "an object of the application"});
    }
    const std::map<std::uint32_t, const Entry*> inverses = InverseObjects(device_);
    const auto found = inverses.find((std::uint32_t{entry.index} << 8U) | entry.sub);
    if (found != inverses.end())
    {
        const std::string name = ObjectName(found->second->index, found->second->sub);
        throw InputError(
            device_.file, found->second->inverted_srad_place,
            {ObjectName(entry.index, entry.sub) + " is the InvertedSRAD of " + name, "normal data, such as " + name});
    }
}

void SrdoBuilder::MapPresent(const PlannedPair& pair)
{
    const Entry* const normal = device_.Find(pair.normal->index, pair.normal->sub);
    if (normal == nullptr)
    {
        throw InputError(device_.file, {},
                         {Name(*pair.normal) + " is not in the file",
                          "an object that it describes, or a length such as 8 for a new one"});
    }
    RequireNormal(*normal);
    if (normal->type.bits == 0U)
    {
        throw InputError(device_.file, normal->place,
                         {Name(*pair.normal) + " is of " + normal->type.name, "a data type of 1 to 64 bits"});
    }
    AddMapping(*pair.normal, InverseOf(pair, *normal), normal->type.bits);
}

/// The inverse object that is named, or the one that the normal object names, or a new one, which begins with the
/// inverse value: a pair that is not inverse is never sent. [SRS_NEW_013]
ObjectPlace SrdoBuilder::InverseOf(const PlannedPair& pair, const Entry& normal)
{
    if (pair.inverse)
    {
        return *pair.inverse;
    }
    if (normal.inverted_srad)
    {
        return {static_cast<std::uint16_t>(*normal.inverted_srad >> 8U),
                static_cast<std::uint8_t>(*normal.inverted_srad & 0xFFU)};
    }
    if (normal.is_compact)
    {
        throw InputError(device_.file, normal.place,
                         {Name(*pair.normal) + " of a compact object has no inverse object",
                          "one that is named behind it, such as " + Name(*pair.normal) + "/0x2100:01"});
    }
    const ObjectPlace place{FreeIndex(), 0U};
    const std::string name = normal.name + ", inverse";
    edits_.Add({place.index,
                name,
                ObjectType::kVar,
                {{0U,
                  name,
                  normal.data_type,
                  plan_.is_producer ? "ro" : "rww",
                  Complement(normal.type, BitsOf(normal, normal.default_value)),
                  normal.parameter_value.IsSet() ? Complement(normal.type, BitsOf(normal, normal.parameter_value)) : "",
                  {{"SRDOMapping", "1"}}}}});
    edits_.Set(normal.section, "SRDOMapping", "1");
    edits_.Set(normal.section, "InvertedSRAD", Hex((std::uint32_t{place.index} << 8U) | place.sub, 6));
    return place;
}

/// A value of the file; 0, with which the device begins, where there is none.
std::uint64_t SrdoBuilder::BitsOf(const Entry& entry, const Text& value) const
{
    const ValueResult result = value.IsSet() ? ParseValue(value.text, entry.type, node_id_) : ValueResult{};
    return result.value ? result.value->bits : 0U;
}

/// The first index of the manufacturer's area that is free, and free 100h behind it.
std::uint16_t SrdoBuilder::FreeIndex() const
{
    std::uint16_t index = plan_.is_producer ? kFirstProducedIndex : kFirstConsumedIndex;
    while (index <= kLastNewIndex)
    {
        const auto inverse = static_cast<std::uint16_t>(index + kInverseDistance);
        if (edits_.IsFree(index) && edits_.IsFree(inverse))
        {
            return index;
        }
        ++index;
    }
    throw InputError(device_.file, {}, {"no index is free for a new object", "one from 0x2000 to 0x5DFF"});
}

NewEntry SrdoBuilder::VariableOf(const PlannedPair& pair, const std::uint8_t place, const bool is_normal) const
{
    const DataType type = DataTypeOf(pair.data_type);
    const std::string made = std::string(plan_.is_producer ? "Sent" : "Received") + " data " +
                             std::to_string(plan_.number) + "." + std::to_string(place);
    NewEntry entry;
    entry.sub = place;
    entry.name = (pair.name.empty() ? made : pair.name) + (is_normal ? "" : ", inverse");
    entry.data_type = pair.data_type;
    entry.access = plan_.is_producer ? "ro" : "rww";
    entry.default_value = is_normal ? "0" : Complement(type, 0U);
    entry.more = {{"SRDOMapping", "1"}};
    return entry;
}

void SrdoBuilder::AddNewObjects(const std::vector<PlannedPair>& pairs)
{
    const std::uint16_t index = FreeIndex();
    const auto inverse_index = static_cast<std::uint16_t>(index + kInverseDistance);
    const std::string name =
        std::string(plan_.is_producer ? "Sent" : "Received") + " data of SRDO " + std::to_string(plan_.number);
    NewObject normal{index, name, ObjectType::kRecord, {}};
    NewObject inverse{inverse_index, name + ", inverse", ObjectType::kRecord, {}};
    std::uint8_t sub = 0U;
    for (const PlannedPair& pair : pairs)
    {
        ++sub;
        NewEntry entry = VariableOf(pair, sub, true);
        entry.more.emplace_back("InvertedSRAD", Hex((std::uint32_t{inverse_index} << 8U) | sub, 6));
        normal.entries.push_back(std::move(entry));
        inverse.entries.push_back(VariableOf(pair, sub, false));
        AddMapping({index, sub}, {inverse_index, sub}, DataTypeOf(pair.data_type).bits);
    }
    edits_.Add(normal);
    edits_.Add(inverse);
}

void SrdoBuilder::AddCommunication()
{
    // SRDO 1 has defaults, in either direction; check asks for them where a file gives defaults.
    const auto default_cob_id = plan_.number == 1U ? PreDefinedCobId(node_id_.value_or(0U)) : std::nullopt;
    const std::uint32_t base = default_cob_id.value_or(0U);
    const std::string number = std::to_string(plan_.number);
    const std::string sct = std::to_string(plan_.sct_ms);
    const std::string srvt = std::to_string(plan_.srvt_ms);
    edits_.Add({static_cast<std::uint16_t>(kFirstCommunicationIndex + plan_.number - 1U),
                "SRDO " + number + " communication parameter",
                ObjectType::kRecord,
                {{1U,
                  "Information direction",
                  kUnsigned8,
                  "rw",
                  "0",
                  plan_.is_producer ? "1" : "2",
                  {{"LowLimit", "0"}, {"HighLimit", "2"}}},
                 {2U, "Refresh time or SCT", kUnsigned16, "rw", sct, sct},
                 {3U, "SRVT", kUnsigned8, "rw", srvt, srvt},
                 {4U, "Transmission type", kUnsigned8, "const", "254"},
                 {5U, "COB-ID 1 (normal data)", kUnsigned32, "rw", Hex(base, 8), Hex(plan_.cob_id, 8)},
                 {6U, "COB-ID 2 (inverse data)", kUnsigned32, "rw", Hex(default_cob_id ? base + 1U : 0U, 8),
                  Hex(plan_.cob_id + 1U, 8)}}});
}

void SrdoBuilder::AddMappingObject()
{
    NewObject mapping{static_cast<std::uint16_t>(kFirstMappingIndex + plan_.number - 1U),
                      "SRDO " + std::to_string(plan_.number) + " mapping parameter",
                      ObjectType::kArray,
                      {{0U, "Number of mapped objects", kUnsigned8, "rw", "0", std::to_string(mapping_.size())}}};
    std::uint8_t sub = 0U;
    for (const std::uint32_t raw : mapping_)
    {
        const std::string pair = std::to_string(sub / 2U + 1U);
        const bool is_normal = sub % 2U == 0U;
        ++sub;
        mapping.entries.push_back(
            {sub, (is_normal ? "Normal data " : "Inverse data ") + pair, kUnsigned32, "rw", Hex(0U, 8), Hex(raw, 8)});
    }
    edits_.Add(mapping);
}

/// What all SRDOs share: 1300h, 13FEh and 5F04h, and a place in each array. The digest needs a node-ID.
void SrdoBuilder::AddCommonObjects()
{
    const std::uint8_t sub = plan_.number;
    const std::string srdo = " of SRDO " + std::to_string(plan_.number);
    const bool has_gfc =
        device_.Find(kGfcIndex) != nullptr || device_.Find(kDeviceParametersIndex, kGfcUseSub) != nullptr;
    if (!has_gfc)
    {
        edits_.Add(
            {kGfcIndex, "", ObjectType::kVar, {{0U, "Global fail-safe command parameter", kUnsigned8, "rw", "0"}}});
    }
    if (device_.Find(kConfigurationValidIndex) == nullptr)
    {
        edits_.Add(
            {kConfigurationValidIndex, "", ObjectType::kVar, {{0U, "Configuration valid", kUnsigned8, "rw", "0x00"}}});
    }
    if (device_.Find(kDigestIndex) == nullptr && node_id_)
    {
        edits_.Add({kDigestIndex,
                    "",
                    ObjectType::kVar,
                    {{0U, "Device digest (0: none is expected)", kUnsigned32, "rw", "0x00000000"}}});
    }
    edits_.Ensure(kSignatureIndex, "Safety configuration signature",
                  {sub, "Signature" + srdo, kUnsigned16, "rw", "0x0000"});
    const auto ensure =
        [&](const std::uint16_t index, const std::string& name, const NewEntry& entry, const bool is_default)
    {
        // Without the object each SRDO has its default.
        if (!is_default || device_.Find(index) != nullptr)
        {
            edits_.Ensure(index, name, entry);
        }
    };
    ensure(kReleasePolicyIndex, "Release policy", {sub, "Release policy" + srdo, kUnsigned8, "rw", "0x00"},
           !plan_.is_automatic);
    ensure(kSafeValueIndex, "Safe value", {sub, "Safe value" + srdo, kUnsigned64, "rw", Hex(0U, 16)},
           plan_.safe_value == 0U);
    ensure(kProducerFormIndex, "Producer form", {sub, "Producer form" + srdo, kUnsigned8, "rw", "0x00"},
           !plan_.is_producer);
    ensure(kDetectionIndex, "SRVT detection",
           {sub, "SRVT detection" + srdo + " (0x3C: late)", kUnsigned8, "rw", "0x00"}, !plan_.is_late);
    const bool is_told = device_.is_safety_supported.value_or(false) || document_.Find("DeviceInfo") == nullptr;
    if (!is_told)
    {
        edits_.Set("DeviceInfo", "CANopenSafetySupported", "1");
    }
}

std::vector<ValueEdit> SrdoBuilder::Values(const Device& built) const
{
    std::vector<ValueEdit> edits;
    const auto set = [&](const std::uint16_t index, const std::uint8_t sub, const std::uint64_t value, const int digits)
    {
        const Entry* const entry = built.Find(index, sub);
        const ValueResult present = entry == nullptr ? ValueResult{} : ConfiguredValue(*entry, node_id_);
        const bool is_there =
            entry == nullptr || (entry->parameter_value.IsSet() && present.value && present.value->bits == value);
        if (!is_there)
        {
            edits.push_back({entry, Hex(value, digits)});
        }
    };
    set(kConfigurationValidIndex, 0U, kConfigurationIsValid, 2);
    set(kReleasePolicyIndex, plan_.number, plan_.is_automatic ? kAutomaticRelease : 0U, 2);
    set(kSafeValueIndex, plan_.number, plan_.safe_value, 16);
    set(kProducerFormIndex, plan_.number, plan_.is_producer ? kProviderCalled : 0U, 2);
    set(kDetectionIndex, plan_.number, plan_.is_late ? kLateDetection : 0U, 2);
    const Entry* const room = built.Find(kDeviceParametersIndex, kMapEntriesSub);
    const ValueResult entries = room == nullptr ? ValueResult{} : ConfiguredValue(*room, node_id_);
    if (entries.value && entries.value->bits < mapping_.size())
    {
        set(kDeviceParametersIndex, kMapEntriesSub, mapping_.size(), 2);
    }
    return edits;
}
} // namespace

std::optional<std::uint8_t> FreeSrdoNumber(const Device& device)
{
    for (std::uint8_t number = 1U; number <= kMaxSrdos; ++number)
    {
        const auto communication = static_cast<std::uint16_t>(kFirstCommunicationIndex + number - 1U);
        const auto mapping = static_cast<std::uint16_t>(kFirstMappingIndex + number - 1U);
        const bool is_listed = device.missing.count(communication) != 0U || device.missing.count(mapping) != 0U;
        const bool is_free = !is_listed && device.Find(communication) == nullptr && device.Find(mapping) == nullptr;
        if (is_free)
        {
            return number;
        }
    }
    return std::nullopt;
}

IniDocument WithSrdo(const IniDocument& document, const SrdoPlan& plan, const std::optional<std::uint8_t> node_id)
{
    const Device device = ReadDevice(document);
    SrdoBuilder builder(document, device, plan, node_id);
    const IniDocument built = builder.Build();
    const Device built_device = ReadDevice(built);
    const IniDocument with_values = WithParameterValues(built, built_device, builder.Values(built_device));
    return WithSignatures(with_values, ReadDevice(with_values), node_id);
}
} // namespace counterpoint::cia306
