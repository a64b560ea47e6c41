// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_RUN_HPP
#define TOOLS_COMMAND_LINE_RUN_HPP

#include "tools/command_line/command.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// Runs one command line, without the program's name, of a program with the commands of `table`. Never throws for bad
/// usage or bad input: that is one line on `err` and ExitStatus::kBadInput. [SRS_CLI_001, SRS_CLI_020]
[[nodiscard]] ExitStatus RunCommandLine(const std::vector<std::string>& arguments, const std::vector<CommandRow>& table,
                                        const Streams& streams);
/// The same for a program's arguments and its streams; the answer is its exit status.
[[nodiscard]] int RunProgram(int count, const char* const* arguments, const std::vector<CommandRow>& table);
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_RUN_HPP
