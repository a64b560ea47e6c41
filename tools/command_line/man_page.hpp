// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_MAN_PAGE_HPP
#define TOOLS_COMMAND_LINE_MAN_PAGE_HPP

#include "tools/command_line/command.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// The manual page of the program (roff, section 1) with all commands of `table` and their options. The same program
/// gives the same bytes. [SRS_EASE_004]
[[nodiscard]] std::string ManPage(const std::vector<CommandRow>& table);
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_MAN_PAGE_HPP
