// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/number.hpp"

#include "canopen/cia306/text/ini_document.hpp"

#include <limits>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint32_t kNoDigit = 99U;

std::uint32_t DigitOf(const char character)
{
    if (character >= '0' && character <= '9')
    {
        return static_cast<std::uint32_t>(character - '0');
    }
    if (character >= 'a' && character <= 'f')
    {
        return static_cast<std::uint32_t>(character - 'a') + 10U;
    }
    if (character >= 'A' && character <= 'F')
    {
        return static_cast<std::uint32_t>(character - 'A') + 10U;
    }
    return kNoDigit;
}

std::optional<std::uint64_t> ParseDigits(const std::string_view text, const std::uint32_t base)
{
    constexpr std::uint64_t max = std::numeric_limits<std::uint64_t>::max();
    if (text.empty())
    {
        return std::nullopt;
    }
    std::uint64_t value = 0U;
    for (const char character : text)
    {
        const std::uint32_t digit = DigitOf(character);
        const bool fits = digit < base && value <= (max - digit) / base;
        if (!fits)
        {
            return std::nullopt;
        }
        value = value * base + digit;
    }
    return value;
}

bool HasHexPrefix(const std::string_view text)
{
    return text.size() >= 2U && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
}
} // namespace

std::optional<Number> ParseNumber(const std::string_view text)
{
    Number number;
    std::string_view digits = text;
    const bool has_sign = !text.empty() && (text.front() == '-' || text.front() == '+');
    if (has_sign)
    {
        number.is_negative = text.front() == '-';
        digits.remove_prefix(1U);
    }
    number.is_hexadecimal = HasHexPrefix(digits);
    const bool is_octal = !number.is_hexadecimal && digits.size() > 1U && digits.front() == '0';
    const std::uint32_t base = number.is_hexadecimal ? 16U : (is_octal ? 8U : 10U);
    const auto value = ParseDigits(number.is_hexadecimal ? digits.substr(2U) : digits, base);
    if (!value)
    {
        return std::nullopt;
    }
    number.magnitude = *value;
    return number;
}

std::optional<std::uint64_t> ParseUnsigned(const std::string_view text, const std::uint64_t max)
{
    const auto number = ParseNumber(text);
    const bool fits = number && !number->is_negative && number->magnitude <= max;
    return fits ? std::optional(number->magnitude) : std::nullopt;
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
