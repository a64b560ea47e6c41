// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/column.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/utf16.hpp"

#include <algorithm>

namespace counterpoint::cia306
{
std::size_t CharactersOf(const std::string_view text)
{
    std::size_t count = 0U;
    for (std::size_t at = 0U; at < text.size(); ++count)
    {
        at += std::max<std::size_t>(LengthOfUtf8(text, at), 1U);
    }
    return count;
}

std::string Column(const std::string_view text, const std::size_t width)
{
    std::string shown;
    std::size_t used = 0U;
    bool has_room = true;
    for (std::size_t at = 0U; has_room && at < text.size();)
    {
        const std::size_t length = LengthOfUtf8(text, at);
        const std::string piece = (length == 0U) ? "?" : Printable(text.substr(at, length));
        const std::size_t room = CharactersOf(piece); // More than one where it is escaped.
        has_room = used + room <= width;
        shown += has_room ? piece : "";
        used += has_room ? room : 0U;
        at += std::max<std::size_t>(length, 1U);
    }
    return shown + std::string(width - used, ' ');
}
} // namespace counterpoint::cia306
