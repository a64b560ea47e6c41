// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_YAML_OPTIONAL_VALUES_HPP
#define RUNTIME_YAML_OPTIONAL_VALUES_HPP

#include "runtime/yaml/map.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace counterpoint::runtime
{
inline constexpr Word<bool> kTruthWords[] = {{"true", true}, {"false", false}};

/// What a part holds: a number, or a number that may be missing.
template <typename Part> struct Held
{
    using Type = Part;
};
template <typename Number> struct Held<std::optional<Number>>
{
    using Type = Number;
};

/// Sets `part` to what `read` makes of a value of the map, if it is there.
template <typename Part, typename Read>
void TakePart(const std::string& file, const YamlMap& map, const char* key, Part& part, const Read& read)
{
    if (const auto value = map.Find(key))
    {
        part = read(file, *value);
    }
}

/// Sets `part` to a number of the map, if it is there; it must be within `lowest` and `highest`.
template <typename Part>
void TakeNumber(const YamlMap& map, const char* key, Part& part, const std::uint64_t lowest,
                const std::uint64_t highest = std::numeric_limits<typename Held<Part>::Type>::max())
{
    if (const auto value = map.Find(key))
    {
        part = static_cast<typename Held<Part>::Type>(value->Number({lowest, highest}));
    }
}

/// Sets `part` to a time of the map, if it is there, in whole units of `unit` nanoseconds.
template <typename Part>
void TakeTime(const YamlMap& map, const char* key, Part& part, const runtime::Nanoseconds unit, const char* unit_name,
              const char* wrong = "a time that its object cannot hold")
{
    using Number = typename Held<Part>::Type;
    if (const auto value = map.Find(key))
    {
        const runtime::Nanoseconds time = value->Duration();
        constexpr auto kMost = std::numeric_limits<Number>::max();
        if (time % unit != 0 || static_cast<std::uint64_t>(time / unit) > kMost)
        {
            value->Refuse(wrong, "whole " + std::string(unit_name) + ", at most " + std::to_string(kMost));
        }
        part = static_cast<Number>(time / unit);
    }
}

/// Sets `part` to a time of the map, if it is there, in whole milliseconds.
template <typename Number> void TakeMs(const YamlMap& map, const char* key, std::optional<Number>& part)
{
    TakeTime(map, key, part, runtime::kNanosecondsPerMillisecond, "milliseconds");
}

/// Sets `part` to the meaning of a word of the map, if it is there.
template <typename Part, typename Meaning, std::size_t kCount>
void TakeWord(const YamlMap& map, const char* key, Part& part, const runtime::Word<Meaning> (&words)[kCount])
{
    if (const auto value = map.Find(key))
    {
        part = value->Choice(words);
    }
}

} // namespace counterpoint::runtime

#endif // RUNTIME_YAML_OPTIONAL_VALUES_HPP
