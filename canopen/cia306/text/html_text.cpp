// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/html_text.hpp"

#include "canopen/cia306/text/utf16.hpp"

namespace counterpoint::cia306
{
namespace
{
/// Empty: it stands for itself.
std::string_view EntityOf(const char character)
{
    switch (character)
    {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    default:
        return "";
    }
}
} // namespace

std::string HtmlText(const std::string_view text)
{
    std::string escaped;
    for (std::size_t at = 0U; at < text.size();)
    {
        const std::size_t length = LengthOfUtf8(text, at);
        const std::string_view character = (length == 0U) ? "?" : text.substr(at, length);
        const std::string_view entity = EntityOf(character.front());
        escaped += entity.empty() ? character : entity;
        at += (length == 0U) ? 1U : length;
    }
    return escaped;
}
} // namespace counterpoint::cia306
