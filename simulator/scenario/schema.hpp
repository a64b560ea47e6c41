// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_SCHEMA_HPP
#define SIMULATOR_SCENARIO_SCHEMA_HPP

#include "simulator/scenario/values.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
/// What the value of a key must look like.
enum class ValueType : std::uint8_t
{
    kText = 1U,
    kParagraph,
    kNode,       ///< The name of a node.
    kNodeId,     ///< The same, or a node-ID.
    kNumber,     ///< Within the range.
    kNumbers,    ///< List of numbers, each within the range.
    kOneOrMore,  ///< A number or a list of them.
    kDuration,   ///< A time with its unit.
    kLasting,    ///< A time above 0.
    kSignedTime, ///< A time, or a negative one.
    kPpm,
    kObject,
    kObjects,
    kWord,
    kWordOrList,
    kMap,       ///< `section` says of what.
    kMaps,      ///< List of such maps.
    kNamedMaps, ///< Name to such a map.
};

using WordList = std::string (*)();
class Fields;
struct Scenario;
struct FaultSetup;
/// Takes the value of a key of a fault. Throws YamlError.
using FaultKeyReader = void(Fields& fields, const char* key, const Scenario& scenario, FaultSetup& fault);

/// What the value of a key looks like. Most types need nothing more; the functions below make the others.
struct Shape
{
    constexpr Shape(const ValueType type_ = ValueType::kText, const Range& range_ = {}, const WordList words_ = nullptr,
                    const char* const section_ = nullptr)
        : type(type_), range(range_), words(words_), section(section_)
    {
    }

    ValueType type;
    Range range;
    WordList words;
    const char* section; ///< Of maps; fault kinds and expectations extend it.
};

/// One key. The reader checks every value against this row, and --explain and docs/scenario.md are written from it.
/// [SRS_SIM_047]
struct KeySpec
{
    const char* key;
    Shape shape;
    const char* fallback; ///< Default; kNeeded: none, must be there; kOptional: may be left out.
    const char* example;
    const char* meaning;
    FaultKeyReader* read{nullptr}; ///< Of faults: see fault_kinds.hpp.
};
inline constexpr char kNeeded[] = "needed"; // One array for the whole program: it is told by its place.
inline constexpr const char* kOptional = nullptr;

/// A map of the format. Fault kinds, events and expectations have a section each, with the keys of `parent` before
/// their own.
struct SectionSpec
{
    const char* name;
    const char* title;
    const char* parent; ///< nullptr: none.
    const char* meaning;
    std::vector<KeySpec> keys;
};

/// All sections, in the order in which people read them.
[[nodiscard]] const std::vector<SectionSpec>& Schema();
/// The section of that name; it exists, as the caller knows.
[[nodiscard]] const SectionSpec& SectionNamed(const std::string& name);
/// The keys of a section with those of its parent, in order.
[[nodiscard]] std::vector<const KeySpec*> KeysOf(const SectionSpec& section);

/// "a, b, c" for a table of words.
template <const auto& kTable> [[nodiscard]] std::string WordsOf()
{
    std::string words;
    for (const auto& word : kTable)
    {
        words += (words.empty() ? "" : ", ") + std::string(word.text);
    }
    return words;
}

// Shapes that say more than their type.
constexpr Shape Number(const Range& range)
{
    return {ValueType::kNumber, range};
}
constexpr Shape Numbers(const Range& range)
{
    return {ValueType::kNumbers, range};
}
constexpr Shape Map(const char* const section)
{
    return {ValueType::kMap, {}, nullptr, section};
}
constexpr Shape Maps(const char* const section)
{
    return {ValueType::kMaps, {}, nullptr, section};
}
/// One word of a table.
template <const auto& kTable> constexpr Shape OneOf()
{
    return {ValueType::kWord, {}, &WordsOf<kTable>};
}
/// One word of a table, or a list of them.
template <const auto& kTable> constexpr Shape SomeOf()
{
    return {ValueType::kWordOrList, {}, &WordsOf<kTable>};
}

// Sections without a parent, and of expectations.
[[nodiscard]] SectionSpec Section(const char* name, const char* title, const char* meaning, std::vector<KeySpec> keys);
[[nodiscard]] SectionSpec Expected(const char* name, const char* meaning, std::vector<KeySpec> keys);

// Keys that mean the same in many sections.
inline constexpr KeySpec kNodeKey{"node", ValueType::kNode, kNeeded, "actuator", "which node"};
inline constexpr KeySpec kAtKey{"at", ValueType::kDuration, kNeeded, "500 ms", "when"};

/// What a value looks like, in words: "number from 1 to 64".
[[nodiscard]] std::string TypeText(const KeySpec& key);
/// @brief The description for a terminal: of everything for an empty name, else of each section and key of that name;
/// sections of events are also found without "events.". An empty answer: there is no such name.
[[nodiscard]] std::string ExplainText(const std::string& name);
/// @brief Every name that ExplainText knows.
[[nodiscard]] std::vector<std::string> ExplainedNames();
/// @brief The reference part of docs/scenario.md.
[[nodiscard]] std::string ExplainMarkdown();

// Parts of the table. schema.cpp joins them.
extern const std::vector<SectionSpec> kWorldSections;
extern const std::vector<SectionSpec> kExpectationSections;
extern const std::vector<SectionSpec> kNetworkSections;
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_SCHEMA_HPP
