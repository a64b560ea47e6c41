// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_COLUMN_HPP
#define CANOPEN_CIA306_TEXT_COLUMN_HPP

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/utf16.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace counterpoint::cia306
{
/// @brief How many characters a text has; a byte that is no UTF-8 is one.
[[nodiscard]] inline std::size_t CharactersOf(const std::string_view text)
{
    std::size_t count = 0U;
    for (std::size_t at = 0U; at < text.size(); ++count)
    {
        at += std::max<std::size_t>(LengthOfUtf8(text, at), 1U);
    }
    return count;
}

/// @brief As many characters of a text as there is room for, Printable, and spaces behind them up to `width`. No
/// character is cut in two, and a byte that is no UTF-8 becomes a question mark. [SRS_MGR_751]
[[nodiscard]] inline std::string Column(const std::string_view text, const std::size_t width)
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

#endif // CANOPEN_CIA306_TEXT_COLUMN_HPP
