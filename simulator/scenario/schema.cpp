// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/schema.hpp"

#include "simulator/scenario/fault_kinds.hpp"
#include "simulator/scenario/network_names.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace counterpoint::simulator
{
namespace
{
std::vector<SectionSpec> Joined()
{
    std::vector<SectionSpec> all = kWorldSections;
    for (const FaultSection& section : kFaultSections)
    {
        all.push_back({section.name,
                       section.title,
                       section.parent,
                       section.meaning,
                       {section.keys.begin(), section.keys.begin() + section.count}});
    }
    all.insert(all.end(), kExpectationSections.begin(), kExpectationSections.end());
    all.insert(all.end(), kNetworkSections.begin(), kNetworkSections.end());
    return all;
}

std::string RangeText(const Range& range)
{
    return " from " + std::to_string(range.lowest) + " to " +
           ((range.highest == 0xFFFFFFFFFFFFFFFFU) ? std::string("2^64 - 1") : std::to_string(range.highest));
}

std::string DefaultText(const KeySpec& key)
{
    if (key.fallback == nullptr)
    {
        return "";
    }
    return (key.fallback == kNeeded) ? "needed" : "default " + std::string(key.fallback);
}

std::string Wrapped(const std::string& text, const std::string& indent)
{
    constexpr std::size_t kWidth = 100U;
    std::string lines;
    std::string line;
    std::size_t place = 0U;
    while (place < text.size())
    {
        const std::size_t end = std::min(text.find(' ', place), text.size());
        const std::string word = text.substr(place, end - place);
        if (!line.empty() && indent.size() + line.size() + 1U + word.size() > kWidth)
        {
            lines += indent + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
        place = end + 1U;
    }
    return lines + indent + line + "\n";
}

std::string ExplainedKey(const KeySpec& key)
{
    const std::string fallback = DefaultText(key);
    std::string text =
        "  " + std::string(key.key) + ": " + TypeText(key) + (fallback.empty() ? "" : "; " + fallback) + "\n";
    return Wrapped(text.substr(2U, text.size() - 3U), "  ") + Wrapped(key.meaning, "      ") + "      e.g. " + key.key +
           ": " + key.example + "\n";
}

/// With the keys of its parent, or only with its name.
std::string ExplainedSection(const SectionSpec& section, const bool is_alone)
{
    std::string text = std::string(section.name) + "\n" + Wrapped(section.meaning, "  ");
    text += (is_alone || section.parent == nullptr) ? "" : "  has the keys of " + std::string(section.parent) + "\n";
    for (const KeySpec* const key : KeysOf(section))
    {
        const bool is_own = key >= section.keys.data() && key < section.keys.data() + section.keys.size();
        text += (is_alone || is_own) ? ExplainedKey(*key) : "";
    }
    return text + "\n";
}

std::string Cell(std::string text)
{
    std::replace(text.begin(), text.end(), '|', '/');
    return text;
}
} // namespace

SectionSpec Section(const char* const name, const char* const title, const char* const meaning,
                    std::vector<KeySpec> keys)
{
    return {name, title, nullptr, meaning, std::move(keys)};
}

SectionSpec Expected(const char* const name, const char* const meaning, std::vector<KeySpec> keys)
{
    return {name, "an expectation", "expect", meaning, std::move(keys)};
}

const std::vector<SectionSpec>& Schema()
{
    static const std::vector<SectionSpec> kSections = Joined();
    return kSections;
}

const SectionSpec& SectionNamed(const std::string& name)
{
    return *std::find_if(Schema().begin(), Schema().end(),
                         [&name](const SectionSpec& section) { return name == section.name; });
}

std::vector<const KeySpec*> KeysOf(const SectionSpec& section)
{
    std::vector<const KeySpec*> keys;
    if (section.parent != nullptr)
    {
        keys = KeysOf(SectionNamed(section.parent));
    }
    for (const KeySpec& key : section.keys)
    {
        keys.push_back(&key);
    }
    return keys;
}

std::string TypeText(const KeySpec& key)
{
    switch (key.shape.type)
    {
    case ValueType::kText:
    case ValueType::kParagraph:
        return "text";
    case ValueType::kNode:
        return "name of a node";
    case ValueType::kNodeId:
        return "name or node-ID of a node";
    case ValueType::kNumber:
        return "number" + RangeText(key.shape.range);
    case ValueType::kNumbers:
        return "list of numbers" + RangeText(key.shape.range);
    case ValueType::kOneOrMore:
        return "number or list of numbers" + RangeText(key.shape.range);
    case ValueType::kDuration:
        return "time";
    case ValueType::kLasting:
        return "time above 0";
    case ValueType::kSignedTime:
        return "time other than 0, negative: back, at most 1000 s";
    case ValueType::kPpm:
        return "parts per million from -1000000 to 1000000";
    case ValueType::kObject:
        return "object";
    case ValueType::kObjects:
        return "list of objects";
    case ValueType::kWord:
        return "one of " + key.shape.words();
    case ValueType::kWordOrList:
        return "one or a list of " + key.shape.words();
    case ValueType::kMap:
        return "map, see " + std::string(key.shape.section);
    case ValueType::kMaps:
        return "list of maps, see " + std::string(key.shape.section);
    case ValueType::kNamedMaps:
        return "map of names to maps, see " + std::string(key.shape.section);
    }
    return "";
}

std::string ExplainText(const std::string& name)
{
    std::string text;
    for (const SectionSpec& section : Schema())
    {
        if (name.empty() || name == section.name || kActionPrefix + name == section.name)
        {
            text += ExplainedSection(section, !name.empty());
            continue;
        }
        for (const KeySpec& key : section.keys)
        {
            text += (name == key.key) ? "in " + std::string(section.name) + ":\n" + ExplainedKey(key) + "\n" : "";
        }
    }
    const std::string units =
        "Times have a unit: 100 us, 10 ms, 2.5 s. Objects are written 0x2000:01, both parts hexadecimal. "
        "Numbers are decimal, or hexadecimal after 0x.\n\n";
    return (name.empty() ? units : "") + text;
}

std::vector<std::string> ExplainedNames()
{
    const std::string prefix = kActionPrefix;
    std::vector<std::string> names;
    for (const SectionSpec& section : Schema())
    {
        const std::string name = section.name;
        names.push_back((name.rfind(prefix, 0U) == 0U) ? name.substr(prefix.size()) : name);
        for (const KeySpec& key : section.keys)
        {
            names.emplace_back(key.key);
        }
    }
    return names;
}

std::string ExplainMarkdown()
{
    std::string text;
    for (const SectionSpec& section : Schema())
    {
        text += "### `" + std::string(section.name) + "`\n" + section.meaning;
        text += (section.parent == nullptr) ? "\n" : " Has the keys of `" + std::string(section.parent) + "`.\n";
        text += section.keys.empty() ? "" : "\n| key | value | default | example | meaning |\n|---|---|---|---|---|\n";
        for (const KeySpec& key : section.keys)
        {
            const bool is_needed = key.fallback == kNeeded;
            const std::string fallback = (key.fallback == nullptr) ? "" : key.fallback;
            text += "| `" + std::string(key.key) + "` | " + Cell(TypeText(key)) + " | " +
                    (fallback.empty() ? "" : (is_needed ? "(needed)" : "`" + fallback + "`")) + " | `" +
                    Cell(key.example) + "` | " + Cell(key.meaning) + " |\n";
        }
        text += "\n";
    }
    return text;
}
} // namespace counterpoint::simulator
