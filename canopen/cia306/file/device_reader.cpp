// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"

#include "canopen/cia306/file/entry_reader.hpp"
#include "canopen/cia306/file/limits.hpp"
#include "canopen/cia306/file/object_reader.hpp"
#include "canopen/cia306/text/nearest_word.hpp"
#include "canopen/cia306/text/number.hpp"
#include "canopen/cia306/text/text_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kMaxSubNumber = 256U;
constexpr std::uint64_t kMaxNodeId = 127U;
constexpr std::uint64_t kUnconfiguredNodeId = 255U;
constexpr std::uint64_t kMostBits = 64U;

/// The number that an object which describes a type holds at `sub`.
std::optional<std::uint64_t> NumberOf(const Object& type, const std::uint8_t sub)
{
    const auto found = type.entries.find(sub);
    const bool has_value = found != type.entries.end() && found->second.Configured().IsSet();
    if (!has_value)
    {
        return std::nullopt;
    }
    const ValueResult result = ParseValue(found->second.Configured().text, kUnsigned32, std::nullopt);
    return result.value ? std::optional(result.value->bits) : std::nullopt;
}

/// The data type that the DEFSTRUCT of a record gives a sub-index; 0 where there is none.
std::uint16_t MemberType(const Device& device, const Object& object, const std::uint8_t sub)
{
    const Object* const structure = device.Find(object.data_type);
    const bool is_structure = structure != nullptr && structure->type == ObjectType::kDefstruct;
    if (!is_structure)
    {
        return 0U;
    }
    if (sub == 0U)
    {
        return kUnsigned8;
    }
    const auto member = structure->entries.find(sub);
    const bool has_value = member != structure->entries.end() && member->second.Configured().IsSet();
    if (!has_value)
    {
        // Some files give the type of the member as its DataType instead of its value.
        return member == structure->entries.end() ? std::uint16_t{0U} : member->second.data_type;
    }
    const auto code = NumberOf(*structure, sub);
    const bool is_code = code && *code <= 0xFFFFU;
    return is_code ? static_cast<std::uint16_t>(*code) : std::uint16_t{0U};
}

DataType TypeOf(const Device& device, const std::uint16_t code)
{
    const DataType known = DataTypeOf(code);
    const Object* const object = device.Find(code);
    if (known.kind != DataKind::kUnknown || object == nullptr)
    {
        return known;
    }
    if (object->type == ObjectType::kDefstruct)
    {
        return {"a structure (DEFSTRUCT)", DataKind::kStructure, 0U};
    }
    const auto bits = object->type == ObjectType::kDeftype ? NumberOf(*object, 0U) : std::nullopt;
    const bool is_length = bits && *bits != 0U && *bits <= kMostBits;
    return is_length ? DataType{"DEFTYPE", DataKind::kUnsigned, static_cast<std::uint8_t>(*bits)} : known;
}

/// Gives every entry the type that its DataType stands for in this file: one of CiA 301, or what an object of type
/// DEFTYPE or DEFSTRUCT describes. [SRS_EDS_027]
void ResolveTypes(Device& device)
{
    for (auto& [index, object] : device.objects)
    {
        static_cast<void>(index);
        const bool is_record = object.type == ObjectType::kRecord || object.type == ObjectType::kArray;
        for (auto& [sub, entry] : object.entries)
        {
            const bool is_member = is_record && entry.data_type == 0U;
            entry.data_type = is_member ? MemberType(device, object, sub) : entry.data_type;
            entry.type = TypeOf(device, entry.data_type);
            LeaveOutComments(entry, device.warnings);
        }
    }
}

/// Reads what stands around the objects, and warns of what does not fit together.
class DeviceReader
{
  public:
    explicit DeviceReader(const IniDocument& document) : document_(document)
    {
        device_.file = document.File();
        device_.warnings = document.Warnings();
    }

    Device Read()
    {
        ObjectReader(document_, device_).Read();
        if (device_.objects.empty())
        {
            throw InputError(device_.file, {std::max<std::size_t>(document_.LineCount(), 1U), 1U},
                             {"the file describes no object", "sections such as [1000]"});
        }
        ReadDeviceInfo();
        ReadCommissioning();
        ReadDummyUsage();
        ReadLists();
        WarnOfSections();
        ResolveTypes(device_);
        WarnOfMissing();
        FinishEntries();
        device_.warnings = WithoutRepeated(SortedByLine(std::move(device_.warnings)));
        return std::move(device_);
    }

  private:
    void Warn(const Place place, const std::string& text)
    {
        device_.warnings.push_back({Severity::kWarning, place, "", text});
    }

    void Warn(const Place place, const std::uint16_t index, const std::string& text)
    {
        device_.warnings.push_back({Severity::kWarning, place, Hex(index, 4), text});
    }

    SectionReader ReaderOf(const IniSection& section)
    {
        return {device_.file, section, device_.warnings};
    }

    void ReadDeviceInfo();
    void ReadGranularity(const IniSection& section);
    void WarnOfCompactPdos(const IniSection& section);
    void ReadCommissioning();
    void ReadNodeId(const IniSection& section);
    void ReadDummyUsage();
    void ReadLists();
    void WarnOfSections();
    void ReadList(const IniSection& section, std::map<std::uint16_t, Place>& listed);
    void WarnOfMissing();
    void FinishEntries();
    void WarnOfSubNumber(const Object& object);

    const IniDocument& document_;
    Device device_;
};

void DeviceReader::ReadDeviceInfo()
{
    const IniSection* const section = document_.Find("DeviceInfo");
    if (section == nullptr)
    {
        Warn({1U, 1U}, "no section [DeviceInfo], expected one");
        return;
    }
    device_.device_info_place = section->place;
    ReaderOf(*section).WarnOfSlips({"CANopenSafetySupported", "LSS_Supported", "Granularity", "CompactPDO"});
    device_.is_safety_supported = ReaderOf(*section).FlagAt("CANopenSafetySupported");
    const IniKey* const lss = ReaderOf(*section).Find("LSS_Supported");
    device_.is_lss_supported = lss != nullptr && ParseUnsigned(lss->Bare(), 1U).value_or(0U) == 1U;
    ReadGranularity(*section);
    WarnOfCompactPdos(*section);
}

/// 0 stands for a mapping that cannot be changed and says nothing about lengths.
void DeviceReader::ReadGranularity(const IniSection& section)
{
    const IniKey* const key = ReaderOf(section).Find("Granularity");
    if (key == nullptr)
    {
        return;
    }
    const auto bits = ParseUnsigned(key->Bare(), 64U);
    const bool is_known = bits && IsGranularity(*bits);
    if (is_known)
    {
        device_.granularity_bits = static_cast<std::uint8_t>(*bits);
    }
    else if (bits.value_or(1U) != 0U)
    {
        Warn(key->place, "Granularity is " + Quoted(key->value) + ", expected 1, 8, 16, 32 or 64; it is ignored");
    }
}

/// PDO parameters that no section describes: with this key NrOfRXPDO and NrOfTXPDO stand for them. [SRS_EDS_150]
void DeviceReader::WarnOfCompactPdos(const IniSection& section)
{
    const IniKey* const key = ReaderOf(section).Find("CompactPDO");
    const bool is_used = key != nullptr && ParseUnsigned(key->Bare(), 0U) != 0U;
    if (is_used)
    {
        Warn(key->place, "CompactPDO is " + Quoted(key->value) +
                             ", expected 0 and a section for each PDO object; those without one are left out");
    }
}

void DeviceReader::ReadCommissioning()
{
    const IniSection* const standard = document_.Find("DeviceComissioning");
    const IniSection* const corrected = document_.Find("DeviceCommissioning");
    if (standard != nullptr && corrected != nullptr)
    {
        const bool is_first = standard->place.line < corrected->place.line;
        const Place first = is_first ? standard->place : corrected->place;
        throw InputError(
            device_.file, is_first ? corrected->place : standard->place,
            {"the commissioning section stands a second time", "it once, as in line " + std::to_string(first.line)});
    }
    if (standard != nullptr)
    {
        ReadNodeId(*standard);
    }
    if (corrected != nullptr)
    {
        Warn(corrected->place, "section [DeviceCommissioning], expected [DeviceComissioning] as CiA 306 writes it");
        ReadNodeId(*corrected);
    }
}

void DeviceReader::ReadNodeId(const IniSection& section)
{
    device_.commissioning_place = section.place;
    const SectionReader reader = ReaderOf(section);
    reader.WarnOfSlips({"NodeID"});
    const auto number = reader.NumberAt("NodeID", kUnconfiguredNodeId);
    if (!number)
    {
        return;
    }
    const IniKey& key = *section.Find("NodeID");
    const bool is_none = *number == 0U || *number == kUnconfiguredNodeId;
    if (is_none)
    {
        Warn(key.place, "NodeID is " + Quoted(key.value) + ", expected 1 to 127; the device has no node-ID");
        device_.is_node_id_refused = true;
        return;
    }
    if (*number > kMaxNodeId)
    {
        reader.Refuse(key, "a node-ID from 1 to 127, or 255 for none");
    }
    device_.node_id = static_cast<std::uint8_t>(*number);
}

void DeviceReader::ReadDummyUsage()
{
    constexpr std::string_view prefix = "dummy";
    const IniSection* const section = document_.Find("DummyUsage");
    if (section == nullptr)
    {
        return;
    }
    const SectionReader reader = ReaderOf(*section);
    for (const IniKey& key : section->keys)
    {
        const std::string lower = Lower(key.name);
        const bool is_dummy = lower.substr(0U, prefix.size()) == prefix;
        const auto index = ParseUnsigned("0x" + (is_dummy ? lower.substr(prefix.size()) : ""), 0xFFFFU);
        if (!index)
        {
            Warn(key.name_place,
                 "key " + Quoted(key.name) + " in [DummyUsage], expected Dummy and four digits; it is ignored");
            continue;
        }
        if (reader.FlagAt(key.name).value_or(false))
        {
            device_.dummies.insert(static_cast<std::uint16_t>(*index));
        }
    }
}

void DeviceReader::ReadLists()
{
    constexpr std::array<std::string_view, 3U> names{"MandatoryObjects", "OptionalObjects", "ManufacturerObjects"};
    std::map<std::uint16_t, Place> listed;
    for (const std::string_view name : names)
    {
        const IniSection* const section = document_.Find(name);
        if (section != nullptr)
        {
            ReadList(*section, listed);
        }
    }
    const IniSection* const mandatory = document_.Find(names[0]);
    device_.mandatory_place = (mandatory == nullptr) ? Place{} : mandatory->place;
    if (mandatory == nullptr && !listed.empty()) // Without any list each object is told.
    {
        Warn({1U, 1U}, "no section [MandatoryObjects], expected one that lists 0x1000, 0x1001 and 0x1018");
    }
    for (const auto& [index, object] : device_.objects)
    {
        const bool is_type = object.type == ObjectType::kDeftype || object.type == ObjectType::kDefstruct;
        if (listed.count(index) == 0U && !is_type)
        {
            Warn(object.place, index,
                 "is in none of the lists [MandatoryObjects], [OptionalObjects], [ManufacturerObjects]");
        }
    }
}

/// `listed`: what was listed so far, and where. [SRS_EDS_038]
void DeviceReader::ReadList(const IniSection& section, std::map<std::uint16_t, Place>& listed)
{
    const SectionReader reader = ReaderOf(section);
    const auto count = reader.NumberAt("SupportedObjects", 0xFFFFU);
    std::uint64_t found = 0U;
    for (const IniKey& key : section.keys)
    {
        const bool is_place = key.name.find_first_not_of("0123456789") == std::string::npos;
        if (!is_place)
        {
            continue;
        }
        const auto index = reader.NumberAt(key.name, 0xFFFFU);
        if (!index)
        {
            continue;
        }
        ++found;
        if (device_.Find(static_cast<std::uint16_t>(*index)) == nullptr)
        {
            device_.missing.emplace(static_cast<std::uint16_t>(*index), key.place);
        }
        const auto [first, is_new] = listed.emplace(static_cast<std::uint16_t>(*index), key.place);
        if (!is_new)
        {
            Warn(key.place, first->first,
                 "is listed a second time, in [" + section.name + "], expected it once, as in line " +
                     std::to_string(first->second.line));
        }
    }
    if (count.value_or(0U) != found)
    {
        Warn(section.place, "section " + Quoted(section.name) + " lists " + std::to_string(found) +
                                " objects, expected SupportedObjects of that number");
    }
}

/// [SRS_EDS_037]
void DeviceReader::WarnOfSections()
{
    const std::vector<std::string> known{"DeviceInfo",       "DeviceComissioning", "DummyUsage",
                                         "MandatoryObjects", "OptionalObjects",    "ManufacturerObjects"};
    for (const IniSection& section : document_.Sections())
    {
        const std::string name = Lower(section.name);
        const bool is_known =
            name == "devicecommissioning" ||
            std::any_of(known.begin(), known.end(), [&name](const std::string& word) { return Lower(word) == name; });
        const std::string meant = is_known ? "" : DidYouMean(section.name, known);
        if (!meant.empty())
        {
            Warn(section.place,
                 "unknown section " + Quoted(section.name) + meant + ", expected one of CiA 306; it is ignored");
        }
    }
}

/// What all lists and sections say tells which objects are safety objects.
void DeviceReader::WarnOfMissing()
{
    for (const auto& [index, place] : device_.missing)
    {
        if (!device_.IsSafetyObject(index))
        {
            Warn(place, index, "is listed, expected a section that describes it");
        }
    }
}

void DeviceReader::FinishEntries()
{
    for (auto& [index, object] : device_.objects)
    {
        const bool is_safety = device_.IsSafetyObject(index);
        WarnOfSubNumber(object);
        for (auto& [sub, entry] : object.entries)
        {
            entry.is_safety = is_safety;
            LeaveOutOfSrdos(entry, device_.warnings);
            // All sub-indices of a compact object share what is said once.
            const bool is_repeated = entry.is_compact && sub > 1U && !entry.parameter_value.IsSet();
            if (!is_repeated)
            {
                WarnOfEntry(entry, device_.warnings);
                WarnOfLimits(entry, device_.node_id, device_.warnings);
            }
        }
    }
}

void DeviceReader::WarnOfSubNumber(const Object& object)
{
    const IniSection& section = *document_.Find(object.section);
    const auto number = ReaderOf(section).NumberAt("SubNumber", kMaxSubNumber);
    const bool differs = number && *number != 0U && *number != object.entries.size();
    if (differs)
    {
        Warn(section.Find("SubNumber")->place, object.index,
             "SubNumber is " + std::to_string(*number) + ", expected " + std::to_string(object.entries.size()) +
                 ", the number of its sub-indices");
    }
}
} // namespace

Device ReadDevice(const IniDocument& document)
{
    return DeviceReader(document).Read();
}

Device ReadDeviceFile(const std::string& path)
{
    return ReadDevice(IniDocument::Parse(path, ReadTextFile(path)));
}
} // namespace counterpoint::cia306
