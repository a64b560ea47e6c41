// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_COMPLETION_HPP
#define TOOLS_COMMAND_LINE_COMPLETION_HPP

#include "tools/command_line/command.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// The shells that know how to complete a command line.
[[nodiscard]] std::vector<std::string> CompletedShells();
/// A script for one of CompletedShells(): it completes the commands of `table`, their options, the values of those that
/// take few, and names of files elsewhere; an empty text for another shell. [SRS_EASE_003]
[[nodiscard]] std::string CompletionScript(const std::string& shell, const std::vector<CommandRow>& table);
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_COMPLETION_HPP
