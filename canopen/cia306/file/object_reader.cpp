// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/object_reader.hpp"

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/entry_reader.hpp"
#include "canopen/cia306/text/number.hpp"

#include <utility>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kMaxCompactSubs = 254U;
constexpr std::uint64_t kMaxSubNumber = 256U;
constexpr std::size_t kIndexDigits = 4U;
constexpr std::size_t kMaxSubDigits = 2U;

/// The keys of an object or sub-index that CiA 306 knows.
const std::vector<std::string>& KeysOfObjects()
{
    static const std::vector<std::string> keys{
        "ParameterName", "ObjectType", "DataType",   "AccessType",  "DefaultValue", "ParameterValue",
        "LowLimit",      "HighLimit",  "PDOMapping", "SRDOMapping", "InvertedSRAD", "SubNumber",
        "CompactSubObj", "ObjFlags",   "Denotation", "UploadFile",  "DownloadFile"};
    return keys;
}

/// Takes the name of a section apart. Never fails: a name that is not one of an object has kind kOther or kMisspelt.
SectionName ParseSectionName(const std::string_view name)
{
    const std::string lower = Lower(name);
    const std::string_view text = lower;
    const std::string_view index = text.substr(0U, kIndexDigits);
    const auto number = ParseDigits(index, 16);
    if (index.size() != kIndexDigits || !number)
    {
        const bool is_prefixed = index.substr(0U, 2U) == "0x";
        return {is_prefixed ? SectionKind::kMisspelt : SectionKind::kOther, 0U, 0U};
    }
    SectionName result;
    result.index = static_cast<std::uint16_t>(*number);
    const std::string_view rest = text.substr(kIndexDigits);
    const std::string_view sub = rest.substr(0U, 3U) == "sub" ? rest.substr(3U) : std::string_view();
    const auto sub_number = sub.size() <= kMaxSubDigits ? ParseDigits(sub, 16) : std::nullopt;
    result.kind = SectionKind::kMisspelt;
    if (rest.empty())
    {
        result.kind = SectionKind::kObject;
    }
    else if (sub_number)
    {
        result.kind = SectionKind::kSub;
        result.sub = static_cast<std::uint8_t>(*sub_number);
    }
    else if (rest == "name")
    {
        result.kind = SectionKind::kNames;
    }
    else if (rest == "value")
    {
        result.kind = SectionKind::kValues;
    }
    else if (rest == "denotation" || rest == "objectlinks")
    {
        result.kind = SectionKind::kObjectPart;
    }
    return result;
}
} // namespace

ObjectReader::ObjectReader(const IniDocument& document, Device& device) noexcept
    : document_(&document), device_(&device)
{
}

void ObjectReader::Read()
{
    ForEach(SectionKind::kObject, &ObjectReader::ReadObject);
    ForEach(SectionKind::kSub, &ObjectReader::ReadSub);
    ForEach(SectionKind::kNames, &ObjectReader::ReadNames);
    ForEach(SectionKind::kValues, &ObjectReader::ReadValues);
    ForEach(SectionKind::kMisspelt, &ObjectReader::WarnOfName);
}

void ObjectReader::ForEach(const SectionKind kind, const Pass pass)
{
    for (const IniSection& section : document_->Sections())
    {
        const SectionName name = ParseSectionName(section.name);
        if (name.kind == kind)
        {
            (this->*pass)(section, name);
        }
    }
}

void ObjectReader::Warn(const Place place, const std::string& text)
{
    device_->warnings.push_back({Severity::kWarning, place, "", text});
}

void ObjectReader::AddEntry(Object& object, Entry entry, const Place place)
{
    ++entry_count_;
    entry.is_download_refused = entry.is_download_refused || object.is_download_refused;
    if (entry_count_ > kMaxEntries)
    {
        throw InputError(device_->file, place, {"there is a sub-index more", "at most " + std::to_string(kMaxEntries)});
    }
    const std::uint8_t sub = entry.sub;
    object.entries[sub] = std::move(entry);
}

void ObjectReader::ReadObject(const IniSection& section, const SectionName& name)
{
    const SectionReader reader(device_->file, section, device_->warnings);
    reader.WarnOfSlips(KeysOfObjects());
    Object object;
    object.index = name.index;
    object.place = section.place;
    object.section = section.name;
    object.name = reader.TextAt("ParameterName").text;
    object.type = reader.ObjectTypeAt("ObjectType");
    object.data_type = static_cast<std::uint16_t>(reader.NumberAt("DataType", 0xFFFFU).value_or(0U));
    const auto compact = reader.NumberAt("CompactSubObj", kMaxCompactSubs).value_or(0U);
    const auto sub_number = reader.NumberAt("SubNumber", kMaxSubNumber).value_or(0U);
    const bool has_subs = sub_number != 0U || object.type == ObjectType::kArray || object.type == ObjectType::kRecord ||
                          object.type == ObjectType::kDefstruct;
    object.is_download_refused = has_subs && (compact == 0U) && reader.IsDownloadRefused();
    if (compact != 0U)
    {
        AddCompactEntries(section, object, static_cast<std::uint8_t>(compact));
    }
    else if (!has_subs)
    {
        AddEntry(object, reader.ReadEntry(name.index, 0U), section.place);
    }
    device_->objects.emplace(name.index, std::move(object));
}

void ObjectReader::AddCompactEntries(const IniSection& section, Object& object, const std::uint8_t count)
{
    Entry entry = SectionReader(device_->file, section, device_->warnings).ReadEntry(object.index, 0U);
    entry.is_compact = true;
    entry.parameter_value = Text{};
    entry.section = section.name + "Value";
    Entry number = entry;
    number.name = "NrOfObjects";
    number.data_type = kUnsigned8;
    number.type_place = section.place;
    number.access_place = section.place;
    number.access = Access::kReadOnly;
    number.is_pdo_mappable = false;
    number.is_srdo_mappable = std::nullopt;
    number.inverted_srad = std::nullopt;
    number.low_limit = Text{};
    number.high_limit = Text{};
    number.default_value = Text{std::to_string(count), section.Find("CompactSubObj")->place};
    AddEntry(object, std::move(number), section.place);
    for (std::uint32_t sub = 1U; sub <= count; ++sub)
    {
        entry.sub = static_cast<std::uint8_t>(sub);
        entry.name = object.name + std::to_string(sub);
        AddEntry(object, entry, section.place);
    }
}

void ObjectReader::ReadSub(const IniSection& section, const SectionName& name)
{
    const auto found = device_->objects.find(name.index);
    if (found == device_->objects.end())
    {
        throw InputError(device_->file, section.place,
                         {"section " + Quoted(section.name) + " belongs to no object",
                          "a section [" + Hex(name.index, 4).substr(2U) + "]"});
    }
    Object& object = found->second;
    const auto before = object.entries.find(name.sub);
    const bool is_variable = before != object.entries.end() && before->second.section == object.section;
    const bool is_second = before != object.entries.end() && !is_variable && !before->second.is_compact;
    if (is_second)
    {
        throw InputError(device_->file, section.place,
                         {"sub-index " + ObjectName(name.index, name.sub) + " is described a second time",
                          "it once, as in line " + std::to_string(before->second.place.line)});
    }
    DropVariable(object);
    const SectionReader reader(device_->file, section, device_->warnings);
    reader.WarnOfSlips(KeysOfObjects());
    AddEntry(object, reader.ReadEntry(name.index, name.sub), section.place);
}

/// An object without SubNumber and type was taken for a variable until its first sub-index came.
void ObjectReader::DropVariable(Object& object)
{
    const auto variable = object.entries.find(0U);
    const bool has_variable = variable != object.entries.end() && variable->second.section == object.section;
    if (has_variable)
    {
        Warn(object.place,
             Hex(object.index, 4) + " has sub-indices, expected SubNumber, or an ObjectType of 0x8 or 0x9");
        object.entries.erase(variable);
    }
}

/// The entry of a key such as "3" of a section [1018Name] or [1018Value]; nothing for NrOfEntries and what fits
/// nowhere.
Entry* ObjectReader::CompactEntry(const IniSection& section, const IniKey& key, const std::uint16_t index)
{
    if (Lower(key.name) == "nrofentries")
    {
        return nullptr;
    }
    const auto sub = ParseUnsigned(key.name, 0xFFU);
    const auto object = device_->objects.find(index);
    const bool is_known =
        sub && object != device_->objects.end() && object->second.entries.count(static_cast<std::uint8_t>(*sub)) != 0U;
    if (!is_known)
    {
        Warn(key.name_place, "key " + Quoted(key.name) + " in section " + Quoted(section.name) +
                                 " names no sub-index of the object, expected one; it is ignored");
        return nullptr;
    }
    return &object->second.entries[static_cast<std::uint8_t>(*sub)];
}

void ObjectReader::ReadNames(const IniSection& section, const SectionName& name)
{
    for (const IniKey& key : section.keys)
    {
        Entry* const entry = CompactEntry(section, key, name.index);
        if (entry != nullptr)
        {
            entry->name = key.value;
        }
    }
}

void ObjectReader::ReadValues(const IniSection& section, const SectionName& name)
{
    for (const IniKey& key : section.keys)
    {
        Entry* const entry = CompactEntry(section, key, name.index);
        if (entry == nullptr || key.value.empty())
        {
            continue;
        }
        if (entry->parameter_value.IsSet())
        {
            throw InputError(device_->file, key.place,
                             {ObjectName(name.index, entry->sub) + " has a second value",
                              "it once, as in line " + std::to_string(entry->parameter_value.place.line)});
        }
        entry->parameter_value = Text{key.value, key.place};
    }
}

void ObjectReader::WarnOfName(const IniSection& section, const SectionName& /*name*/)
{
    Warn(section.place, "section " + Quoted(section.name) +
                            " is no object, expected a form such as [1018], [1018sub1] or [1018Value]; it is ignored");
}
} // namespace counterpoint::cia306
