// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/number.hpp"

#include "canopen/cia306/text/ini_document.hpp"

#include <array>
#include <charconv>
#include <system_error>

namespace counterpoint::cia306
{
namespace
{
/// Of text in lower case.
bool HasHexPrefix(const std::string_view lower)
{
    return lower.substr(0U, 2U) == "0x";
}

/// The suffixes of C's integers, in lower case.
std::string_view WithoutSuffix(const std::string_view lower)
{
    constexpr std::array<std::string_view, 7U> suffixes{"ull", "llu", "ul", "lu", "ll", "u", "l"};
    for (const std::string_view suffix : suffixes)
    {
        const bool is_longer = lower.size() > suffix.size();
        if (is_longer && lower.substr(lower.size() - suffix.size()) == suffix)
        {
            return lower.substr(0U, lower.size() - suffix.size());
        }
    }
    return lower;
}
} // namespace

std::optional<std::uint64_t> ParseDigits(const std::string_view text, const int base)
{
    std::uint64_t value = 0U;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, base);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

std::optional<Number> ParseNumber(const std::string_view text)
{
    Number number;
    const std::string lower = Lower(text);
    std::string_view digits = WithoutSuffix(lower);
    number.has_suffix = digits.size() != text.size();
    const bool has_sign = !digits.empty() && (digits.front() == '-' || digits.front() == '+');
    const bool has_minus = has_sign && digits.front() == '-';
    digits.remove_prefix(has_sign ? 1U : 0U);
    number.is_hexadecimal = HasHexPrefix(digits);
    const bool is_octal = !number.is_hexadecimal && digits.size() > 1U && digits.front() == '0';
    const int base = number.is_hexadecimal ? 16 : (is_octal ? 8 : 10);
    const auto value = ParseDigits(number.is_hexadecimal ? digits.substr(2U) : digits, base);
    if (!value)
    {
        return std::nullopt;
    }
    number.magnitude = *value;
    number.is_negative = has_minus && *value != 0U;
    return number;
}

std::optional<std::uint64_t> ParseUnsigned(const std::string_view text, const std::uint64_t max)
{
    const auto number = ParseNumber(text);
    const bool is_plain = number && !number->is_negative && !number->has_suffix;
    const bool fits = is_plain && number->magnitude <= max;
    return fits ? std::optional(number->magnitude) : std::nullopt;
}

std::optional<std::uint64_t> ParseTyped(const std::string_view text, const std::uint64_t max)
{
    const bool is_octal = text.size() > 1U && text[0] == '0' && text[1] != 'x' && text[1] != 'X';
    return is_octal ? std::nullopt : ParseUnsigned(text, max);
}

std::optional<Formula> ParseFormula(const std::string_view text)
{
    constexpr std::string_view name = "$nodeid";
    const std::string lower = Lower(text);
    if (lower.find('$') == std::string::npos)
    {
        const auto number = ParseNumber(text);
        return number ? std::optional(Formula{false, *number}) : std::nullopt;
    }
    const std::size_t plus = lower.find('+');
    const std::string_view first = Trimmed(std::string_view(lower).substr(0U, plus));
    if (plus == std::string::npos)
    {
        return first == name ? std::optional(Formula{true, Number{}}) : std::nullopt;
    }
    const std::string_view second = Trimmed(std::string_view(lower).substr(plus + 1U));
    const bool is_first = first == name;
    const bool is_second = second == name;
    const auto number = ParseNumber(is_first ? second : first);
    const bool is_sum = is_first != is_second && number && !number->is_negative;
    return is_sum ? std::optional(Formula{true, *number}) : std::nullopt;
}
} // namespace counterpoint::cia306
