// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_COLUMN_HPP
#define CANOPEN_CIA306_TEXT_COLUMN_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace counterpoint::cia306
{
/// @brief How many characters a text has; a byte that is no UTF-8 is one.
[[nodiscard]] std::size_t CharactersOf(std::string_view text);

/// @brief As many characters of a text as there is room for, Printable, and spaces behind them up to `width`. No
/// character is cut in two, and a byte that is no UTF-8 becomes a question mark. [SRS_MGR_751]
[[nodiscard]] std::string Column(std::string_view text, std::size_t width);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_COLUMN_HPP
