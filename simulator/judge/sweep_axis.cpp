// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/sweep.hpp"
#include "simulator/scenario/parts.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

// What a sweep varies, and how it gets into the scenario. [SRS_SIM_050]
namespace counterpoint::simulator
{
namespace
{
constexpr const char* kForm = "NAME=FROM:TO:STEP such as faults.loss.at=500ms:510ms:250us";

[[noreturn]] void Refuse(const std::string& wrong, const std::string& expected)
{
    throw YamlError("--sweep", {}, wrong, expected);
}

/// A plain number, or a time in nanoseconds.
struct Quantity
{
    std::int64_t value{0};
    bool is_time{false};
    bool is_hexadecimal{false};
};

Quantity ParseQuantity(const std::string& text)
{
    const bool is_negative = !text.empty() && text[0] == '-';
    const std::string magnitude = text.substr(is_negative ? 1U : 0U);
    const std::optional<std::uint64_t> number = runtime::ParseUnsigned(magnitude);
    if (number && *number <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    {
        const auto value = static_cast<std::int64_t>(*number);
        return {is_negative ? -value : value, false, runtime::IsHexadecimal(magnitude)};
    }
    const runtime::YamlNode node{runtime::YamlKind::kScalar, false, {}, magnitude, {}};
    const std::string place = "--sweep"; // Outlives the value below.
    const Nanoseconds time = YamlValue(place, node).Duration();
    return {is_negative ? -time : time, true, false};
}

std::vector<std::string> Split(const std::string& text, const char separator)
{
    std::vector<std::string> parts(1U);
    for (const char character : text)
    {
        if (character == separator)
        {
            parts.emplace_back();
        }
        else
        {
            parts.back() += character;
        }
    }
    return parts;
}

std::optional<std::size_t> Index(const std::string& text)
{
    std::size_t number = 0U;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole ? std::optional<std::size_t>(number) : std::nullopt;
}

/// The value of a key of a map; nullptr if it is not there.
runtime::YamlNode* ValueOf(runtime::YamlNode& map, const std::string& key)
{
    return const_cast<runtime::YamlNode*>(MemberOf(map, key));
}

runtime::YamlNode* Added(runtime::YamlNode& map, const std::string& key)
{
    runtime::YamlNode name;
    name.kind = runtime::YamlKind::kScalar;
    name.scalar = key;
    name.place = map.place;
    runtime::YamlNode value = name;
    value.scalar.clear();
    map.items.push_back(name);
    map.items.push_back(value);
    return &map.items.back();
}

bool IsCalled(runtime::YamlNode& item, const std::string& name)
{
    const runtime::YamlNode* const own = ValueOf(item, "name");
    const runtime::YamlNode* const kind = ValueOf(item, "fault");
    return (own != nullptr && own->scalar == name) || (own == nullptr && kind != nullptr && kind->scalar == name);
}

/// An item of a list: by its number, or by its name.
runtime::YamlNode* ItemOf(const std::vector<runtime::YamlNode*>& items, const std::string& segment)
{
    const std::optional<std::size_t> index = Index(segment);
    if (index)
    {
        return (*index < items.size()) ? items[*index] : nullptr;
    }
    const auto found = std::find_if(items.begin(), items.end(),
                                    [&segment](runtime::YamlNode* const item) { return IsCalled(*item, segment); });
    return (found == items.end()) ? nullptr : *found;
}

std::vector<runtime::YamlNode*> ItemsOf(runtime::YamlNode& list)
{
    std::vector<runtime::YamlNode*> items;
    for (runtime::YamlNode& item : list.items)
    {
        items.push_back(&item);
    }
    return items;
}

/// What the first two segments lead to: lists of both files count as one, maps are looked through.
runtime::YamlNode* SecondLevel(std::vector<ScenarioDocument>& documents, const std::string& key,
                               const std::string& segment)
{
    std::vector<runtime::YamlNode*> items;
    runtime::YamlNode* found = nullptr;
    for (ScenarioDocument& document : documents)
    {
        runtime::YamlNode* const value = ValueOf(document.root, key);
        if (value != nullptr && value->kind == runtime::YamlKind::kSequence)
        {
            const std::vector<runtime::YamlNode*> more = ItemsOf(*value);
            items.insert(items.end(), more.begin(), more.end());
        }
        else if (value != nullptr)
        {
            runtime::YamlNode* const member = ValueOf(*value, segment);
            found = (member != nullptr) ? member : found;
        }
    }
    return items.empty() ? found : ItemOf(items, segment);
}

runtime::YamlNode* FirstLevel(std::vector<ScenarioDocument>& documents, const std::string& key)
{
    for (auto document = documents.rbegin(); document != documents.rend(); ++document)
    {
        runtime::YamlNode* const value = ValueOf(document->root, key);
        if (value != nullptr)
        {
            return value;
        }
    }
    return Added(documents.back().root, key); // Refused by the reader if there is no such key.
}
} // namespace

std::string SweepAxis::Text(const std::size_t place) const
{
    const std::int64_t value = values[place];
    if (!is_time)
    {
        const bool is_shown_so = is_hexadecimal && value >= 0;
        return is_shown_so ? cia306::Hex(static_cast<std::uint64_t>(value), 1) : std::to_string(value);
    }
    const std::int64_t magnitude = (value < 0) ? -value : value;
    std::string fraction =
        std::to_string(kNanosecondsPerMillisecond + magnitude % kNanosecondsPerMillisecond).substr(1U);
    fraction.erase(fraction.find_last_not_of('0') + 1U);
    return ((value < 0) ? "-" : "") + std::to_string(magnitude / kNanosecondsPerMillisecond) +
           (fraction.empty() ? "" : "." + fraction) + " ms";
}

SweepAxis ParseSweepAxis(const std::string& text)
{
    const std::size_t equals = text.find('=');
    const std::vector<std::string> parts = Split((equals == std::string::npos) ? "" : text.substr(equals + 1U), ':');
    if (equals == std::string::npos || equals == 0U || parts.size() != 3U)
    {
        Refuse(runtime::Shown(text), kForm);
    }
    const Quantity from = ParseQuantity(parts[0U]);
    const Quantity to = ParseQuantity(parts[1U]);
    const Quantity step = ParseQuantity(parts[2U]);
    if (from.is_time != to.is_time || from.is_time != step.is_time)
    {
        Refuse(runtime::Shown(text), "three times with units, or three whole numbers");
    }
    constexpr std::int64_t kFarthest = 1000000000000000000;
    const bool is_bounded = from.value >= -kFarthest && to.value <= kFarthest && step.value <= kFarthest;
    if (!is_bounded || step.value <= 0 || to.value < from.value)
    {
        Refuse(runtime::Shown(text), "FROM not above TO, a STEP above 0, and nothing beyond 10^18 (times: 10^9 s)");
    }
    if ((to.value - from.value) / step.value >= static_cast<std::int64_t>(kMostSweepRuns))
    {
        Refuse(runtime::Shown(text) + " with more than " + std::to_string(kMostSweepRuns) + " runs", "a larger STEP");
    }
    SweepAxis axis{text.substr(0U, equals), from.is_time, from.is_hexadecimal, {}};
    for (std::int64_t value = from.value; value <= to.value; value += step.value)
    {
        axis.values.push_back(value);
    }
    return axis;
}

void SetByPath(std::vector<ScenarioDocument>& documents, const std::string& path, const std::string& value)
{
    const std::vector<std::string> segments = Split(path, '.');
    if (segments[0U] == "extends")
    {
        Refuse("path " + runtime::Shown(path) + ", which is read before the sweep",
               "the path of a value of the scenario");
    }
    if (documents.back().root.kind != runtime::YamlKind::kMap)
    {
        return; // Refused by the reader.
    }
    runtime::YamlNode* node = (segments.size() == 1U) ? FirstLevel(documents, segments[0U])
                                                      : SecondLevel(documents, segments[0U], segments[1U]);
    for (std::size_t depth = 2U; node != nullptr && depth < segments.size(); ++depth)
    {
        runtime::YamlNode* next = (node->kind == runtime::YamlKind::kSequence) ? ItemOf(ItemsOf(*node), segments[depth])
                                                                               : ValueOf(*node, segments[depth]);
        const bool may_be_new = node->kind == runtime::YamlKind::kMap && depth + 1U == segments.size();
        next = (next == nullptr && may_be_new) ? Added(*node, segments[depth]) : next;
        node = next;
    }
    if (node == nullptr)
    {
        Refuse("path " + runtime::Shown(path), "keys, names or numbers from 0 that lead to a value of the scenario");
    }
    if (node->kind == runtime::YamlKind::kMap || node->kind == runtime::YamlKind::kSequence)
    {
        Refuse("path " + runtime::Shown(path) + ", which is no single value", "the path of a single value");
    }
    node->kind = runtime::YamlKind::kScalar;
    node->scalar = value;
}
} // namespace counterpoint::simulator
