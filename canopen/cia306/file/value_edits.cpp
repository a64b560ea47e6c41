// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/value_edits.hpp"

#include <map>
#include <set>
#include <utility>

namespace counterpoint::cia306
{
namespace
{
/// Values of a compact object stand in a section such as [13FFValue] that may have to be made first.
struct Edits
{
    std::vector<KeyEdit> keys;
    std::map<std::string, SectionEdit> sections; ///< By name.
};

void AddEdit(Edits& edits, const IniDocument& document, const Device& device, const ValueEdit& edit)
{
    const Entry& entry = *edit.entry;
    if (!entry.is_compact)
    {
        edits.keys.push_back({entry.section, "ParameterValue", edit.value, "DefaultValue"});
        return;
    }
    const std::string key = std::to_string(entry.sub);
    const IniSection* const values = document.Find(entry.section);
    if (values == nullptr)
    {
        SectionEdit& section = edits.sections[entry.section];
        section.after_section = device.Find(entry.index)->section;
        section.name = entry.section;
        section.keys.emplace_back(key, edit.value);
        return;
    }
    // The key may be written with another base; then that line is the one to change.
    std::string present = key;
    for (const IniKey& candidate : values->keys)
    {
        present = candidate.place == entry.parameter_value.place ? candidate.name : present;
    }
    edits.keys.push_back({entry.section, present, edit.value, ""});
}

/// NrOfEntries tells how many of the sub-indices have a value.
void AddEntryCount(Edits& edits, const IniDocument& document, const std::string& section)
{
    const IniSection* const values = document.Find(section);
    const IniKey* const count = values == nullptr ? nullptr : values->Find("NrOfEntries");
    if (count == nullptr)
    {
        return;
    }
    std::size_t entries = values->keys.size() - 1U;
    for (const KeyEdit& edit : edits.keys)
    {
        const bool is_new = edit.section == section && values->Find(edit.key) == nullptr;
        entries += is_new ? 1U : 0U;
    }
    if (std::to_string(entries) != count->value)
    {
        edits.keys.push_back({section, "NrOfEntries", std::to_string(entries), ""});
    }
}
} // namespace

IniDocument WithParameterValues(const IniDocument& document, const Device& device, const std::vector<ValueEdit>& values)
{
    Edits edits;
    std::set<std::string> compact; // Sections of values, once each.
    for (const ValueEdit& edit : values)
    {
        AddEdit(edits, document, device, edit);
        if (edit.entry->is_compact)
        {
            compact.insert(edit.entry->section);
        }
    }
    for (const std::string& section : compact)
    {
        AddEntryCount(edits, document, section);
    }
    std::vector<SectionEdit> sections;
    for (auto& [name, section] : edits.sections)
    {
        static_cast<void>(name);
        section.keys.insert(section.keys.begin(), {"NrOfEntries", std::to_string(section.keys.size())});
        sections.push_back(std::move(section));
    }
    return document.With(edits.keys, sections);
}
} // namespace counterpoint::cia306
