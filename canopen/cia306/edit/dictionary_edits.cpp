// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/dictionary_edits.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint16_t kFirstManufacturerIndex = 0x2000U;
constexpr std::uint16_t kLastManufacturerIndex = 0x5FFFU;
constexpr std::uint64_t kMostListed = 0xFFFFU;

std::string HexDigits(const std::uint64_t value, const int digits)
{
    return Hex(value, digits).substr(2U);
}

SectionKeys KeysOf(const NewEntry& entry)
{
    SectionKeys keys{{"ParameterName", entry.name},
                     {"ObjectType", "0x7"},
                     {"DataType", Hex(entry.data_type, 4)},
                     {"AccessType", entry.access},
                     {"DefaultValue", entry.default_value}};
    if (!entry.parameter_value.empty())
    {
        keys.emplace_back("ParameterValue", entry.parameter_value);
    }
    keys.emplace_back("PDOMapping", "0");
    keys.insert(keys.end(), entry.more.begin(), entry.more.end());
    return keys;
}

std::string ListOf(const std::uint16_t index)
{
    const bool is_manufacturers = index >= kFirstManufacturerIndex && index <= kLastManufacturerIndex;
    return is_manufacturers ? "ManufacturerObjects" : "OptionalObjects";
}

/// The places that a list has, and the greatest number of one.
struct Places
{
    std::uint64_t count{0U};
    std::uint64_t last{0U};
};

Places PlacesOf(const IniSection* const list)
{
    Places places;
    if (list == nullptr)
    {
        return places;
    }
    for (const IniKey& key : list->keys)
    {
        const auto place = ParseDigits(key.name, 10);
        places.count += place ? 1U : 0U;
        places.last = std::max(places.last, place.value_or(0U));
    }
    return places;
}
} // namespace

std::string SectionOf(const std::uint16_t index)
{
    return HexDigits(index, 4);
}

std::string SectionOf(const std::uint16_t index, const std::uint8_t sub)
{
    return SectionOf(index) + "sub" + HexDigits(sub, 1);
}

std::vector<std::pair<std::string, SectionKeys>> SectionsOf(const NewObject& object)
{
    const std::string section = SectionOf(object.index);
    if (object.type == ObjectType::kVar)
    {
        return {{section, KeysOf(object.entries.front())}};
    }
    std::vector<NewEntry> entries = object.entries;
    const bool has_count = !entries.empty() && entries.front().sub == 0U;
    if (!has_count)
    {
        const unsigned highest = entries.empty() ? 0U : entries.back().sub;
        entries.insert(entries.begin(),
                       {0U, "Highest sub-index supported", kUnsigned8, "const", std::to_string(highest)});
    }
    std::vector<std::pair<std::string, SectionKeys>> sections;
    sections.push_back({section,
                        {{"ParameterName", object.name},
                         {"ObjectType", Hex(static_cast<std::uint8_t>(object.type), 1)},
                         {"SubNumber", std::to_string(entries.size())}}});
    for (const NewEntry& entry : entries)
    {
        sections.emplace_back(SectionOf(object.index, entry.sub), KeysOf(entry));
    }
    return sections;
}

std::vector<std::string> SectionsIn(const IniDocument& document, const Object& object)
{
    std::set<std::string> names{object.section};
    for (const auto& [sub, entry] : object.entries)
    {
        static_cast<void>(sub);
        names.insert(entry.section);
    }
    for (const char* const part : {"Name", "Value", "Denotation", "ObjectLinks"})
    {
        const IniSection* const section = document.Find(SectionOf(object.index) + part);
        names.insert(section == nullptr ? object.section : section->name);
    }
    std::vector<std::string> present;
    std::copy_if(names.begin(), names.end(), std::back_inserter(present),
                 [&document](const std::string& name) { return document.Find(name) != nullptr; });
    return present;
}

DictionaryEdits::DictionaryEdits(const IniDocument& document, const Device& device) noexcept
    : document_(document), device_(device)
{
}

bool DictionaryEdits::IsFree(const std::uint16_t index) const
{
    const bool is_added = std::find(added_.begin(), added_.end(), index) != added_.end();
    return !is_added && device_.Find(index) == nullptr && device_.missing.count(index) == 0U;
}

/// The section of the object that stands last in the file.
std::string DictionaryEdits::LastSectionOf(const Object& object) const
{
    std::string last = object.section;
    for (const std::string& name : SectionsIn(document_, object))
    {
        const bool is_later = document_.Find(name)->place.line > document_.Find(last)->place.line;
        last = is_later ? name : last;
    }
    return last;
}

/// The section behind which a new object stands: that of the object before it, else the last one before all objects.
std::string DictionaryEdits::PlaceOf(const std::uint16_t index) const
{
    const auto next = device_.objects.lower_bound(index);
    if (next != device_.objects.begin())
    {
        return LastSectionOf(std::prev(next)->second);
    }
    // There is a next one: a device has an object.
    const std::vector<IniSection>& sections = document_.Sections();
    const auto found = std::find_if(sections.begin(), sections.end(), [&next](const IniSection& section)
                                    { return section.name == next->second.section; });
    return (found == sections.begin()) ? found->name : std::prev(found)->name;
}

void DictionaryEdits::Add(const NewObject& object)
{
    for (const auto& [name, keys] : SectionsOf(object))
    {
        sections_[object.index].push_back({PlaceOf(object.index), name, keys});
    }
    added_.push_back(object.index);
}

void DictionaryEdits::Ensure(const std::uint16_t index, const std::string& name, const NewEntry& entry)
{
    const Object* const array = device_.Find(index);
    if (array == nullptr)
    {
        Add({index, name, ObjectType::kArray, {entry}});
    }
    else if (array->entries.count(entry.sub) == 0U)
    {
        AddSub(*array, entry);
    }
}

void DictionaryEdits::AddSub(const Object& array, const NewEntry& entry)
{
    const std::string highest = std::to_string(static_cast<unsigned>(entry.sub));
    const bool is_compact = std::any_of(array.entries.begin(), array.entries.end(),
                                        [](const auto& present) { return present.second.is_compact; });
    if (is_compact)
    {
        Set(array.section, "CompactSubObj", highest);
        return;
    }
    sections_[array.index].push_back({LastSectionOf(array), SectionOf(array.index, entry.sub), KeysOf(entry)});
    const IniSection& head = *document_.Find(array.section);
    if (head.Find("SubNumber") != nullptr)
    {
        Set(array.section, "SubNumber", std::to_string(array.entries.size() + 1U));
    }
    const Entry* const count = device_.Find(array.index, 0U);
    if (count == nullptr)
    {
        return;
    }
    const ValueResult present = ConfiguredValue(*count, std::nullopt);
    const bool is_below = present.value && present.value->bits < entry.sub;
    if (is_below)
    {
        Set(count->section, "DefaultValue", highest);
    }
    if (is_below && count->parameter_value.IsSet())
    {
        Set(count->section, "ParameterValue", highest);
    }
}

void DictionaryEdits::Set(const std::string& section, const std::string& key, const std::string& value)
{
    keys_.push_back({section, key, value, ""});
}

void DictionaryEdits::AddToLists(std::vector<KeyEdit>& keys, std::vector<SectionEdit>& sections) const
{
    for (const std::string name : {"OptionalObjects", "ManufacturerObjects"})
    {
        const IniSection* const list = document_.Find(name);
        Places places = PlacesOf(list);
        SectionKeys lines;
        for (const std::uint16_t index : added_)
        {
            if (ListOf(index) == name)
            {
                ++places.count;
                ++places.last;
                lines.emplace_back(std::to_string(places.last), Hex(index, 4));
            }
        }
        if (lines.empty())
        {
            continue;
        }
        lines.insert(lines.begin(), {"SupportedObjects", std::to_string(std::min(places.count, kMostListed))});
        if (list == nullptr)
        {
            sections.push_back({PlaceOf(0U), name, lines});
            continue;
        }
        for (const auto& [key, value] : lines)
        {
            keys.push_back({name, key, value, ""});
        }
    }
}

IniDocument DictionaryEdits::Apply() const
{
    std::vector<KeyEdit> keys = keys_;
    std::vector<SectionEdit> sections;
    AddToLists(keys, sections);
    for (const auto& [index, edits] : sections_)
    {
        static_cast<void>(index);
        sections.insert(sections.end(), edits.begin(), edits.end());
    }
    return document_.With(keys, sections);
}
} // namespace counterpoint::cia306
