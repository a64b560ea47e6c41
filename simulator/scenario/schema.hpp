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

/// One key. The reader checks every value against this row, and --explain and docs/scenario.md are written from it.
/// [SRS_SIM_047]
struct KeySpec
{
    const char* key;
    ValueType type;
    Range range;
    std::string (*words)(); ///< Of kWord, kWordOrList.
    const char* section;    ///< Of maps; fault kinds and expectations extend it.
    const char* fallback;   ///< Default; kNeeded: none, must be there; nullptr: may be left out.
    const char* example;
    const char* meaning;
};
inline constexpr char kNeeded[] = "needed"; // One array for the whole program: it is told by its place.

/// A map of the format. Fault kinds and expectations have a section each, with the keys of `parents` before their own.
struct SectionSpec
{
    const char* name;
    const char* title;
    std::vector<const char*> parents;
    std::vector<KeySpec> keys;
    const char* meaning;
};

/// All sections, in the order in which people read them.
[[nodiscard]] const std::vector<SectionSpec>& Schema();
/// The section of that name; it exists, as the caller knows.
[[nodiscard]] const SectionSpec& SectionNamed(const std::string& name);
/// The keys of a section with those of its parents, in order.
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

/// What a value looks like, in words: "number from 1 to 64".
[[nodiscard]] std::string TypeText(const KeySpec& key);
/// @brief The description for a terminal: of everything for an empty name, else of each section and key of that name;
/// sections of events are also found without "events.". An empty answer: there is no such name.
[[nodiscard]] std::string ExplainText(const std::string& name);
/// @brief The reference part of docs/scenario.md.
[[nodiscard]] std::string ExplainMarkdown();

// Parts of the table. schema.cpp joins them.
[[nodiscard]] std::vector<SectionSpec> WorldSections();
[[nodiscard]] std::vector<SectionSpec> FrameFaultSections();
[[nodiscard]] std::vector<SectionSpec> NodeFaultSections();
[[nodiscard]] std::vector<SectionSpec> LinkFaultSections();
[[nodiscard]] std::vector<SectionSpec> ExpectationSections();
[[nodiscard]] std::vector<SectionSpec> NetworkSections();
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_SCHEMA_HPP
