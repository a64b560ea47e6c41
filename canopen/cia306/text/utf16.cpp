// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/utf16.hpp"

#include <algorithm>
#include <cstddef>

namespace counterpoint::cia306
{
std::size_t LengthOfUtf8(const std::string_view text, const std::size_t at) noexcept
{
    const auto first = static_cast<std::uint8_t>(text[at]);
    const std::size_t length =
        first < 0x80U ? 1U : (first < 0xC2U ? 0U : (first < 0xE0U ? 2U : (first < 0xF0U ? 3U : 4U)));
    bool is_whole = length != 0U && first < 0xF5U && at + length <= text.size();
    for (std::size_t place = 1U; is_whole && place < length; ++place)
    {
        is_whole = (static_cast<std::uint8_t>(text[at + place]) & 0xC0U) == 0x80U;
    }
    return is_whole ? length : 0U;
}

std::vector<std::uint8_t> Utf16Of(const std::string& text)
{
    std::vector<std::uint8_t> bytes;
    const auto append = [&bytes](const std::uint32_t unit)
    {
        bytes.push_back(static_cast<std::uint8_t>(unit & 0xFFU));
        bytes.push_back(static_cast<std::uint8_t>(unit >> 8U));
    };
    for (std::size_t at = 0U; at < text.size();)
    {
        const std::size_t length = LengthOfUtf8(text, at);
        std::uint32_t character = static_cast<std::uint8_t>(text[at]);
        character &= length > 1U ? 0xFFU >> (length + 1U) : 0xFFU;
        for (std::size_t place = 1U; place < length; ++place)
        {
            character = (character << 6U) | (static_cast<std::uint8_t>(text[at + place]) & 0x3FU);
        }
        if (character > 0xFFFFU)
        {
            append(0xD800U + ((character - 0x10000U) >> 10U));
            append(0xDC00U + ((character - 0x10000U) & 0x3FFU));
        }
        else
        {
            append(character);
        }
        at += std::max<std::size_t>(length, 1U);
    }
    return bytes;
}
} // namespace counterpoint::cia306
