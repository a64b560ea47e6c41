// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_HPP
#define TOOLS_COMMAND_LINE_HPP

#include "tools/command.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// Runs one command line without the program's name. Never throws for bad usage or bad input: that is one line on
/// `err` and ExitStatus::kBadInput. [SRS_CLI_001, SRS_CLI_020]
[[nodiscard]] ExitStatus RunCommandLine(const std::vector<std::string>& arguments, const Streams& streams);
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_HPP
