// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/yaml/value.hpp"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace counterpoint::runtime
{
namespace
{
constexpr std::size_t kDigitsOfDecimal = 15U;
constexpr Nanoseconds kLongestJump = 1000 * kNanosecondsPerSecond; // Fits the counters' difference.

std::optional<std::uint64_t> ParseNumber(const std::string_view text, const int base)
{
    std::uint64_t number = 0U;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole ? std::optional<std::uint64_t>(number) : std::nullopt;
}

/// `text` times 10^`digits` without any rounding: at most `digits` digits behind the point.
std::optional<std::int64_t> ParseDecimal(const std::string_view text, const std::size_t digits)
{
    const bool is_negative = !text.empty() && text[0] == '-';
    const std::string_view plain = text.substr(is_negative ? 1U : 0U);
    const std::size_t point = plain.find('.');
    const std::string_view whole = plain.substr(0U, point);
    const std::string_view fraction = (point == std::string_view::npos) ? "" : plain.substr(point + 1U);
    const bool has_fraction = point == std::string_view::npos || !fraction.empty();
    if (whole.empty() || !has_fraction || fraction.size() > digits || whole.size() + digits > kDigitsOfDecimal + 3U)
    {
        return std::nullopt;
    }
    std::string number(whole);
    number += fraction;
    number.append(digits - fraction.size(), '0');
    const std::optional<std::uint64_t> value = ParseNumber(number, 10);
    if (!value)
    {
        return std::nullopt;
    }
    const auto magnitude = static_cast<std::int64_t>(*value);
    return is_negative ? -magnitude : magnitude;
}

} // namespace

bool IsHexadecimal(const std::string_view text) noexcept
{
    return text.size() > 2U && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
}

std::optional<std::uint64_t> ParseUnsigned(const std::string_view text)
{
    return IsHexadecimal(text) ? ParseNumber(text.substr(2U), 16) : ParseNumber(text, 10);
}

std::string WhatIs(const YamlNode& node)
{
    if (node.kind == YamlKind::kScalar)
    {
        return Shown(node.scalar);
    }
    const char* const list_or_nothing = (node.kind == YamlKind::kSequence) ? "a list" : "nothing";
    return (node.kind == YamlKind::kMap) ? "a map" : list_or_nothing;
}

YamlValue::YamlValue(const std::string& file, const YamlNode& node) noexcept : file_(&file), node_(&node)
{
}

const YamlNode& YamlValue::Node() const noexcept
{
    return *node_;
}

Source YamlValue::Where() const
{
    return {*file_, node_->place};
}

const std::string& YamlValue::FileName() const noexcept
{
    return *file_;
}

void YamlValue::Refuse(const std::string& wrong, const std::string& expected) const
{
    throw YamlError(*file_, node_->place, wrong, expected);
}

std::vector<YamlValue> YamlValue::Items(const std::string& expected) const
{
    if (node_->kind != YamlKind::kSequence)
    {
        Refuse(WhatIs(*node_), expected);
    }
    std::vector<YamlValue> items;
    for (const YamlNode& item : node_->items)
    {
        items.emplace_back(*file_, item);
    }
    return items;
}

std::string YamlValue::Text(const std::string& expected) const
{
    const std::string text = Paragraph(expected);
    if (text.find_first_of("\n\t") != std::string::npos)
    {
        Refuse("text with a line end or tabulator", expected);
    }
    return text;
}

std::string YamlValue::Paragraph(const std::string& expected) const
{
    if (node_->kind != YamlKind::kScalar)
    {
        Refuse(WhatIs(*node_), expected);
    }
    return node_->scalar;
}

std::uint64_t YamlValue::Number(const Range& range) const
{
    const std::string expected =
        "a number from " + std::to_string(range.lowest) + " to " + std::to_string(range.highest);
    const std::string text = Text(expected);
    const std::optional<std::uint64_t> number = ParseUnsigned(text);
    const bool may_be_octal = text.size() > 1U && text[0] == '0' && text.find_first_not_of("0123456789") == text.npos;
    if (may_be_octal)
    {
        Refuse(Shown(text), expected + ", without a zero before it: it may be octal"); // [SRS_NET_061]
    }
    if (!number || *number < range.lowest || *number > range.highest)
    {
        Refuse(Shown(text), expected);
    }
    return *number;
}

Nanoseconds YamlValue::Duration() const
{
    struct Unit
    {
        const char* text;
        std::size_t digits; ///< Powers of ten in nanoseconds.
    };
    constexpr Unit kUnits[] = {{"us", 3U}, {"ms", 6U}, {"s", 9U}};
    const std::string expected = "a time with its unit such as 10 ms, 2.5 s or 100 us, at most 10000000 s";
    const std::string text = Text(expected);
    if (text == "0")
    {
        return 0; // In whatever unit.
    }
    const std::size_t end = text.find_last_of("0123456789.");
    const std::string number = (end == std::string::npos) ? "" : text.substr(0U, end + 1U);
    const std::size_t unit_begin =
        (end == std::string::npos) ? std::string::npos : text.find_first_not_of(' ', end + 1U);
    const std::string unit = (unit_begin == std::string::npos) ? "" : text.substr(unit_begin);
    for (const Unit& known : kUnits)
    {
        const std::optional<std::int64_t> value =
            (unit == known.text) ? ParseDecimal(number, known.digits) : std::nullopt;
        if (value && *value >= 0 && *value <= kLongestTime)
        {
            return *value;
        }
    }
    Refuse(Shown(text), expected);
}

Nanoseconds YamlValue::Lasting() const
{
    const Nanoseconds duration = Duration();
    if (duration == 0)
    {
        Refuse(Shown(node_->scalar), "a time above 0");
    }
    return duration;
}

Nanoseconds YamlValue::SignedDuration() const
{
    const bool is_negative = node_->kind == YamlKind::kScalar && !node_->scalar.empty() && node_->scalar[0] == '-';
    YamlNode magnitude = *node_;
    magnitude.scalar.erase(0U, is_negative ? 1U : 0U);
    const Nanoseconds time = YamlValue(*file_, magnitude).Lasting();
    if (time > kLongestJump)
    {
        Refuse(Shown(node_->scalar), "at most 1000 s either way");
    }
    return is_negative ? -time : time;
}

std::uint32_t YamlValue::Checked() const
{
    return static_cast<std::uint32_t>(Number({0U, 0xFFFFFFFFU}));
}

std::int32_t YamlValue::PartsPerMillion() const
{
    constexpr std::int64_t kMost = 1000000;
    const std::string expected = "whole parts per million from -1000000 to 1000000";
    const std::string text = Text(expected);
    const std::optional<std::int64_t> value = ParseDecimal(text, 0U);
    if (!value || *value < -kMost || *value > kMost)
    {
        Refuse(Shown(text), expected);
    }
    return static_cast<std::int32_t>(*value);
}

ObjectAddress YamlValue::Object() const
{
    const std::string expected = "an object such as 0x2000:01";
    const std::string text = Text(expected);
    const std::size_t colon = text.find(':');
    if (!IsHexadecimal(text) || colon == std::string::npos)
    {
        Refuse(Shown(text), expected);
    }
    const std::optional<std::uint64_t> index = ParseNumber(std::string_view(text).substr(2U, colon - 2U), 16);
    const std::optional<std::uint64_t> sub = ParseNumber(std::string_view(text).substr(colon + 1U), 16);
    if (!index || !sub || *index > 0xFFFFU || *sub > 0xFFU)
    {
        Refuse(Shown(text), expected);
    }
    return {static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)};
}
} // namespace counterpoint::runtime
