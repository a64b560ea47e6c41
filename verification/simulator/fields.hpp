// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_FIELDS_HPP
#define VERIFICATION_SIMULATOR_FIELDS_HPP

#include "verification/simulator/scenario.hpp"
#include "verification/simulator/schema.hpp"
#include "verification/simulator/yaml_document.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
/// Longest time that a scenario may name.
constexpr Nanoseconds kLongestTime = 10000000 * kNanosecondsPerSecond;

/// What stands there, for a message.
[[nodiscard]] std::string WhatIs(const YamlNode& node);

/// A value of the scenario with the file it stands in. All readers throw ScenarioError with the place of the value.
class ScenarioValue
{
  public:
    ScenarioValue(const std::string& file, const YamlNode& node) noexcept;

    [[nodiscard]] const YamlNode& Node() const noexcept;
    [[nodiscard]] Source Where() const;
    [[nodiscard]] const std::string& FileName() const noexcept;
    [[noreturn]] void Refuse(const std::string& wrong, const std::string& expected) const;
    [[nodiscard]] std::vector<ScenarioValue> Items(const std::string& expected) const;
    /// @brief One line of text.
    [[nodiscard]] std::string Text(const std::string& expected) const;
    /// @brief Text that may have several lines.
    [[nodiscard]] std::string Paragraph(const std::string& expected) const;
    /// @brief Decimal, or hexadecimal after 0x.
    [[nodiscard]] std::uint64_t Number(const Range& range) const;
    /// @brief A number with a unit: 10 ms, 2.5 s, 100 us; at most 10^7 s.
    [[nodiscard]] Nanoseconds Duration() const;
    /// @brief A duration above 0.
    [[nodiscard]] Nanoseconds Lasting() const;
    /// @brief A duration, or a negative one.
    [[nodiscard]] Nanoseconds SignedDuration() const;
    /// @brief A number whose range the schema has checked.
    [[nodiscard]] std::uint32_t Checked() const;
    /// @brief Whole parts per million, at most 10^6 either way.
    [[nodiscard]] std::int32_t PartsPerMillion() const;
    /// @brief 0x2000:01; the sub-index is hexadecimal, too.
    [[nodiscard]] ObjectAddress Object() const;

    template <typename Meaning, std::size_t kCount>
    [[nodiscard]] Meaning Choice(const Word<Meaning> (&words)[kCount]) const
    {
        std::string expected;
        const std::string text = Text("one word");
        for (const Word<Meaning>& word : words)
        {
            if (text == word.text)
            {
                return word.meaning;
            }
            expected += (expected.empty() ? "" : ", ") + std::string(word.text);
        }
        Refuse(Shown(text), "one of " + expected);
    }

  private:
    const std::string* file_;
    const YamlNode* node_;
};

/// The keys of one map. Every value that is found was checked against the schema. Remembers which keys were asked for,
/// so that Close can refuse the others.
class Fields
{
  public:
    /// @brief `section` names what the schema says of this map.
    Fields(const ScenarioValue& value, const char* section);

    /// @brief From here on the keys of another section are known, too.
    void Extend(const char* section);
    /// @brief The value, else the schema's default, else nothing.
    [[nodiscard]] std::optional<ScenarioValue> Find(const std::string& key);
    [[nodiscard]] ScenarioValue Require(const std::string& key);
    [[nodiscard]] const ScenarioValue& Value() const noexcept;
    /// @brief All keys with their values, in the order of the file.
    [[nodiscard]] std::vector<std::pair<ScenarioValue, ScenarioValue>> All();
    /// @brief Throws for the first key that is unknown, or that nobody asked for.
    void Close() const;

  private:
    [[nodiscard]] const KeySpec* SpecOf(const std::string& key) const;

    ScenarioValue value_;
    std::vector<const SectionSpec*> sections_; ///< The last one names the map in messages.
    std::vector<std::string> known_;
};
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_FIELDS_HPP
