// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_YAML_VALUE_HPP
#define RUNTIME_YAML_VALUE_HPP

#include "canopen/cia306/text/nearest_word.hpp"
#include "runtime/yaml/document.hpp"

#include "safety_core/kernel/object_access.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::runtime
{
/// Time since the start of a run. In the simulator the bus and the world run on it; nodes have counters of their own.
using Nanoseconds = std::int64_t;
constexpr Nanoseconds kNanosecondsPerMicrosecond = 1000;
constexpr Nanoseconds kNanosecondsPerMillisecond = 1000000;
constexpr Nanoseconds kNanosecondsPerSecond = 1000000000;
constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();

/// File and place that something came from, for messages.
struct Source
{
    std::string file;
    Place place;
};

/// Least and greatest value that are allowed.
struct Range
{
    std::uint64_t lowest{0U};
    std::uint64_t highest{0U};
};

/// A word of a file and what it stands for.
template <typename Meaning> struct Word
{
    const char* text;
    Meaning meaning;
};

/// Longest time that a scenario may name.
constexpr Nanoseconds kLongestTime = 10000000 * kNanosecondsPerSecond;

/// Whether a number begins with 0x.
[[nodiscard]] bool IsHexadecimal(std::string_view text) noexcept;

/// A number of a file or command line: decimal, or hexadecimal after 0x; nothing: it is none, or above 2^64 - 1.
[[nodiscard]] std::optional<std::uint64_t> ParseUnsigned(std::string_view text);

/// What stands at a node, in words, for a message.
[[nodiscard]] std::string WhatIs(const YamlNode& node);

/// A value of a YAML file, with the file in which it stands. All reading functions throw YamlError with the place of
/// the value.
class YamlValue
{
  public:
    /// @brief Both outlive it.
    YamlValue(const std::string& file, const YamlNode& node) noexcept;

    /// @brief The node of the document.
    [[nodiscard]] const YamlNode& Node() const noexcept;
    /// @brief File and place.
    [[nodiscard]] Source Where() const;
    /// @brief The file.
    [[nodiscard]] const std::string& FileName() const noexcept;
    /// @brief Throws YamlError for this value.
    [[noreturn]] void Refuse(const std::string& wrong, const std::string& expected) const;
    /// @brief The items of a list.
    [[nodiscard]] std::vector<YamlValue> Items(const std::string& expected) const;
    /// @brief Text of one line. `expected` says what is expected, for the message.
    [[nodiscard]] std::string Text(const std::string& expected) const;
    /// @brief Text of one line or several.
    [[nodiscard]] std::string Paragraph(const std::string& expected) const;
    /// @brief A number within the range: decimal, or hexadecimal after 0x.
    [[nodiscard]] std::uint64_t Number(const Range& range) const;
    /// @brief A time with its unit: 10 ms, 2.5 s, 100 us; at most 10^7 s.
    [[nodiscard]] Nanoseconds Duration() const;
    /// @brief A time above 0.
    [[nodiscard]] Nanoseconds Lasting() const;
    /// @brief A time, which may be negative.
    [[nodiscard]] Nanoseconds SignedDuration() const;
    /// @brief A number whose range the schema has checked already.
    [[nodiscard]] std::uint32_t Checked() const;
    /// @brief Whole parts per million, from -10^6 to 10^6.
    [[nodiscard]] std::int32_t PartsPerMillion() const;
    /// @brief An object: 0x2000:01, both parts hexadecimal.
    [[nodiscard]] ObjectAddress Object() const;

    /// @brief One of the words of a table.
    template <typename Meaning, std::size_t kCount>
    [[nodiscard]] Meaning Choice(const Word<Meaning> (&words)[kCount]) const
    {
        std::string expected;
        std::vector<std::string> known;
        const std::string text = Text("one word");
        for (const Word<Meaning>& word : words)
        {
            if (text == word.text)
            {
                return word.meaning;
            }
            expected += (expected.empty() ? "" : ", ") + std::string(word.text);
            known.emplace_back(word.text);
        }
        Refuse(Shown(text) + cia306::DidYouMean(text, known), "one of " + expected);
    }

  private:
    const std::string* file_;
    const YamlNode* node_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_YAML_VALUE_HPP
