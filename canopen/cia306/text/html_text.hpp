// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_HTML_TEXT_HPP
#define CANOPEN_CIA306_TEXT_HTML_TEXT_HPP

#include <string>
#include <string_view>

namespace counterpoint::cia306
{
/// Text of files and people as it may stand in a page, also within quotes. A byte that is no UTF-8 becomes a question
/// mark: names of files may hold any.
[[nodiscard]] std::string HtmlText(std::string_view text);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_HTML_TEXT_HPP
