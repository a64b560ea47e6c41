// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_HTML_HPP
#define VERIFICATION_CAMPAIGN_HTML_HPP

#include <string>
#include <vector>

/// What pages of the campaign are written of: one file each, nothing fetched, readable on a phone.
namespace counterpoint::campaign::html
{
[[nodiscard]] std::string Escaped(const std::string& text);
/// @brief From the first line to the heading.
[[nodiscard]] std::string Head(const std::string& title);
/// @brief A row of a table. Its cells are HTML.
[[nodiscard]] std::string Row(const std::vector<std::string>& cells, const char* css_class = "");
/// @brief Begin of a table that is moved sideways where it is too wide, with its head.
[[nodiscard]] std::string Table(const std::vector<std::string>& heads, const char* css_class = "");
/// @brief Its end.
constexpr const char* kTableEnd = "</table></div>\n";
} // namespace counterpoint::campaign::html

#endif // VERIFICATION_CAMPAIGN_HTML_HPP
