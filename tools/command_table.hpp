// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_TABLE_HPP
#define TOOLS_COMMAND_TABLE_HPP

#include "tools/command_line/command.hpp"

#include <vector>

namespace counterpoint::tools
{
/// All commands, in the order of the help.
[[nodiscard]] std::vector<CommandRow> CommandTable();
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_TABLE_HPP
