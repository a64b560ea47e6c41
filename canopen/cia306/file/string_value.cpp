// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/string_value.hpp"

#include "canopen/cia306/text/number.hpp"
#include "canopen/cia306/text/utf16.hpp"

#include <algorithm>
#include <optional>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint16_t kOctetString = 0x000AU;
constexpr std::uint16_t kUnicodeString = 0x000BU;

bool IsBlank(const char letter)
{
    return letter == ' ' || letter == '\t';
}

/// Pairs of hexadecimal digits, one at least, or nothing.
std::optional<std::vector<std::uint8_t>> OctetsOf(std::string digits)
{
    digits.erase(std::remove_if(digits.begin(), digits.end(), IsBlank), digits.end());
    std::vector<std::uint8_t> octets;
    for (std::size_t place = 0U; place < digits.size(); place += 2U)
    {
        const auto octet = ParseDigits(digits.substr(place, 2U), 16);
        if (!octet || place + 1U == digits.size())
        {
            return std::nullopt;
        }
        octets.push_back(static_cast<std::uint8_t>(*octet));
    }
    return octets.empty() ? std::nullopt : std::optional(octets);
}
} // namespace

std::vector<std::uint8_t> BytesOfText(const std::uint16_t data_type, const std::string& text)
{
    if (data_type == kUnicodeString)
    {
        return Utf16Of(text);
    }
    const auto octets = data_type == kOctetString ? OctetsOf(text) : std::nullopt;
    return octets.value_or(std::vector<std::uint8_t>(text.begin(), text.end()));
}
} // namespace counterpoint::cia306
