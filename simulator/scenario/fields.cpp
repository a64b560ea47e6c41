// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/fields.hpp"

#include <algorithm>
#include <map>
#include <set>

// The keys of a map against the schema. [SRS_SIM_010, SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
/// Defaults of the schema as values.
const runtime::YamlNode& FallbackOf(const KeySpec& spec)
{
    thread_local std::map<std::string, runtime::YamlNode> nodes;
    const runtime::YamlNode node{runtime::YamlKind::kScalar, false, {}, spec.fallback, {}};
    return nodes.try_emplace(spec.fallback, node).first->second;
}

void RequireWord(const KeySpec& spec, const YamlValue& value)
{
    const std::string words = spec.shape.words();
    const std::string text = value.Text("one of " + words);
    const std::vector<std::string> known = WordsIn(words);
    if (std::find(known.begin(), known.end(), text) == known.end())
    {
        value.Refuse(runtime::Shown(text) + cia306::DidYouMean(text, known), "one of " + words);
    }
}

void RequireNumbers(const KeySpec& spec, const YamlValue& value)
{
    const std::string expected = "a list of numbers from " + std::to_string(spec.shape.range.lowest) + " to " +
                                 std::to_string(spec.shape.range.highest);
    for (const YamlValue& item : value.Items(expected))
    {
        static_cast<void>(item.Number(spec.shape.range));
    }
}

void RequireList(const KeySpec& spec, const YamlValue& value)
{
    const bool is_list = value.Node().kind == runtime::YamlKind::kSequence;
    if (spec.shape.type == ValueType::kOneOrMore)
    {
        is_list ? RequireNumbers(spec, value) : static_cast<void>(value.Number(spec.shape.range));
    }
    else if (spec.shape.type == ValueType::kNumbers)
    {
        RequireNumbers(spec, value);
    }
    else if (!is_list && spec.shape.type == ValueType::kWordOrList)
    {
        RequireWord(spec, value);
    }
    else
    {
        for (const YamlValue& item : value.Items("a list"))
        {
            (spec.shape.type == ValueType::kObjects) ? static_cast<void>(item.Object()) : RequireWord(spec, item);
        }
    }
}

/// Refuses what the schema does not allow. The answer is the value of a number or a time. Maps and lists of maps are
/// looked at where their own keys are read.
std::uint64_t Fitting(const KeySpec& spec, const YamlValue& value)
{
    switch (spec.shape.type)
    {
    case ValueType::kText:
    case ValueType::kNode:
    case ValueType::kNodeId:
        static_cast<void>(value.Text("a text"));
        break;
    case ValueType::kParagraph:
        static_cast<void>(value.Paragraph("a text"));
        break;
    case ValueType::kNumber:
        return value.Number(spec.shape.range);
    case ValueType::kDuration:
        return static_cast<std::uint64_t>(value.Duration());
    case ValueType::kLasting:
        return static_cast<std::uint64_t>(value.Lasting());
    case ValueType::kSignedTime:
        return static_cast<std::uint64_t>(value.SignedDuration());
    case ValueType::kPpm:
        return static_cast<std::uint64_t>(value.PartsPerMillion());
    case ValueType::kObject:
        static_cast<void>(value.Object());
        break;
    case ValueType::kWord:
        RequireWord(spec, value);
        break;
    case ValueType::kNumbers:
    case ValueType::kOneOrMore:
    case ValueType::kObjects:
    case ValueType::kWordOrList:
        RequireList(spec, value);
        break;
    case ValueType::kMap:
    case ValueType::kMaps:
    case ValueType::kNamedMaps:
        break;
    }
    return 0U;
}
} // namespace

std::vector<std::string> WordsIn(const std::string& list)
{
    std::vector<std::string> words;
    for (std::size_t begin = 0U; begin < list.size();)
    {
        const std::size_t end = std::min(list.find(", ", begin), list.size());
        words.push_back(list.substr(begin, end - begin));
        begin = end + 2U;
    }
    return words;
}

std::vector<YamlValue> ItemsOf(const YamlValue& value)
{
    const bool is_list = value.Node().kind == runtime::YamlKind::kSequence;
    return is_list ? value.Items("a list") : std::vector<YamlValue>{value};
}

Fields::Fields(const YamlValue& value, const char* const section) : value_(value)
{
    Extend(section);
    const runtime::YamlNode& node = value_.Node();
    if (node.kind != runtime::YamlKind::kMap)
    {
        value_.Refuse(runtime::WhatIs(node), "a map with the keys of " + std::string(sections_.back()->title));
    }
    std::set<std::string> seen;
    for (std::size_t member = 0U; member < node.items.size(); member += 2U)
    {
        const runtime::YamlNode& key = node.items[member];
        if (key.kind != runtime::YamlKind::kScalar)
        {
            throw YamlError(value_.FileName(), key.place, runtime::WhatIs(key) + " as key", "a word");
        }
        if (!seen.insert(key.scalar).second)
        {
            throw YamlError(value_.FileName(), key.place, "key " + runtime::Shown(key.scalar) + " twice",
                            "each key once");
        }
    }
}

void Fields::Extend(const char* const section)
{
    sections_.push_back(&SectionNamed(section));
}

const KeySpec* Fields::SpecOf(const std::string& key) const
{
    for (const SectionSpec* const section : sections_)
    {
        for (const KeySpec* const spec : KeysOf(*section))
        {
            if (key == spec->key)
            {
                return spec;
            }
        }
    }
    return nullptr;
}

std::optional<YamlValue> Fields::Find(const std::string& key)
{
    known_.push_back(key);
    const KeySpec* const spec = SpecOf(key);
    if (spec == nullptr)
    {
        return std::nullopt; // Not of this map; if it is there, Close refuses it.
    }
    const runtime::YamlNode& node = value_.Node();
    for (std::size_t member = 0U; member < node.items.size(); member += 2U)
    {
        if (node.items[member].scalar == key)
        {
            const YamlValue found(value_.FileName(), node.items[member + 1U]);
            static_cast<void>(Fitting(*spec, found));
            return found;
        }
    }
    if (spec->fallback == kNeeded)
    {
        RefuseWithout(key);
    }
    return (spec->fallback == nullptr) ? std::nullopt
                                       : std::optional<YamlValue>(YamlValue(value_.FileName(), FallbackOf(*spec)));
}

/// A key that is there and nobody knows may be a slip of the one that is missing. [SRS_EASE_001]
void Fields::RefuseWithout(const std::string& key) const
{
    const runtime::YamlNode& node = value_.Node();
    const std::string title = sections_.back()->title;
    for (std::size_t member = 0U; member < node.items.size(); member += 2U)
    {
        const runtime::YamlNode& other = node.items[member];
        const std::string meant = SpecOf(other.scalar) == nullptr ? cia306::DidYouMean(other.scalar, {key}) : "";
        if (!meant.empty())
        {
            throw YamlError(value_.FileName(), other.place,
                            "unknown key " + runtime::Shown(other.scalar) + meant + " in " + title,
                            "key '" + key + "'");
        }
    }
    value_.Refuse(title + " without key '" + key + "'", "that key");
}

YamlValue Fields::Require(const std::string& key)
{
    const std::optional<YamlValue> found = Find(key);
    if (!found)
    {
        RefuseWithout(key);
    }
    return *found;
}

bool Fields::Into(const std::string& key, std::string& target)
{
    const std::optional<YamlValue> found = Find(key);
    target = found ? found->Node().scalar : target;
    return found.has_value();
}

bool Fields::Into(const std::string& key, ObjectAddress& target)
{
    const std::optional<YamlValue> found = Find(key);
    target = found ? found->Object() : target;
    return found.has_value();
}

std::uint64_t Fields::Quantity(const std::string& key, const YamlValue& value) const
{
    return Fitting(*SpecOf(key), value);
}

std::optional<Fields> Fields::Map(const std::string& key)
{
    const std::optional<YamlValue> found = Find(key);
    return found ? std::optional<Fields>(Fields(*found, SectionOf(key))) : std::nullopt;
}

const char* Fields::SectionOf(const std::string& key) const
{
    return SpecOf(key)->shape.section;
}

std::vector<std::pair<YamlValue, YamlValue>> Fields::All()
{
    const runtime::YamlNode& node = value_.Node();
    std::vector<std::pair<YamlValue, YamlValue>> all;
    for (std::size_t member = 0U; member < node.items.size(); member += 2U)
    {
        all.emplace_back(YamlValue(value_.FileName(), node.items[member]),
                         YamlValue(value_.FileName(), node.items[member + 1U]));
    }
    return all;
}

void Fields::Close() const
{
    const runtime::YamlNode& node = value_.Node();
    std::string expected;
    std::vector<std::string> known;
    for (const KeySpec* const spec : KeysOf(*sections_.back()))
    {
        if (std::find(known.begin(), known.end(), spec->key) == known.end())
        {
            expected += (expected.empty() ? "" : ", ") + std::string(spec->key);
            known.emplace_back(spec->key);
        }
    }
    for (std::size_t member = 0U; member < node.items.size(); member += 2U)
    {
        const runtime::YamlNode& key = node.items[member];
        const std::string title = sections_.back()->title;
        if (SpecOf(key.scalar) == nullptr)
        {
            throw YamlError(value_.FileName(), key.place,
                            "unknown key " + runtime::Shown(key.scalar) + cia306::DidYouMean(key.scalar, known) +
                                " in " + title,
                            "one of " + expected);
        }
        if (std::find(known_.begin(), known_.end(), key.scalar) == known_.end())
        {
            throw YamlError(value_.FileName(), key.place,
                            "key " + runtime::Shown(key.scalar) + " without an effect in this " +
                                title.substr(title.find(' ') + 1U),
                            "only keys that fit its others");
        }
    }
}
} // namespace counterpoint::simulator
