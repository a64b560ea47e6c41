// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_YAML_VALUE_HPP
#define RUNTIME_YAML_VALUE_HPP

#include "runtime/yaml/document.hpp"

#include "safety_core/kernel/object_access.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Simulated time since the start of the run. The bus and the world run on it; nodes have counters of their own.
using Nanoseconds = std::int64_t;
constexpr Nanoseconds kNanosecondsPerMicrosecond = 1000;
constexpr Nanoseconds kNanosecondsPerMillisecond = 1000000;
constexpr Nanoseconds kNanosecondsPerSecond = 1000000000;
constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();

/// What came from one file: places in messages need the file.
struct Source
{
    std::string file;
    Place place;
};

struct Range
{
    std::uint64_t lowest{0U};
    std::uint64_t highest{0U};
};

/// A word of a scenario and what it stands for.
template <typename Meaning> struct Word
{
    const char* text;
    Meaning meaning;
};

/// Longest time that a scenario may name.
constexpr Nanoseconds kLongestTime = 10000000 * kNanosecondsPerSecond;

/// What stands there, for a message.
[[nodiscard]] std::string WhatIs(const YamlNode& node);

/// A value of the scenario with the file it stands in. All readers throw YamlError with the place of the value.
class YamlValue
{
  public:
    YamlValue(const std::string& file, const YamlNode& node) noexcept;

    [[nodiscard]] const YamlNode& Node() const noexcept;
    [[nodiscard]] Source Where() const;
    [[nodiscard]] const std::string& FileName() const noexcept;
    [[noreturn]] void Refuse(const std::string& wrong, const std::string& expected) const;
    [[nodiscard]] std::vector<YamlValue> Items(const std::string& expected) const;
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
} // namespace counterpoint::runtime

#endif // RUNTIME_YAML_VALUE_HPP
