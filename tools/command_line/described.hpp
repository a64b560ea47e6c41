// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_DESCRIBED_HPP
#define TOOLS_COMMAND_LINE_DESCRIBED_HPP

#include "tools/command_line/command.hpp"
#include "tools/command_line/options.hpp"

#include <memory>
#include <string>
#include <vector>

namespace counterpoint::tools
{
constexpr const char* kProgram = "counterpoint";
constexpr const char* kExitStatus = "Exit status: 0 what was asked holds, 1 it does not, 2 bad input or bad usage.";

/// A command with the options that it takes, for who reads a command line and for who writes about it.
struct DescribedCommand
{
    std::string name;
    std::string description;
    std::unique_ptr<Command> command;
    std::unique_ptr<Options> options;
};

[[nodiscard]] DescribedCommand Described(const CommandRow& row);

/// Options that every command takes besides its own, and those of the program itself.
struct CommonOption
{
    const char* name;
    const char* description;
    bool is_of_commands; ///< Of commands, too.
};
inline constexpr CommonOption kCommonOptions[] = {{"--help", "Print this help message and exit", true},
                                                  {"--version", "Display program version information and exit", false}};

/// Whether it is an argument that is told by its place instead of a name.
[[nodiscard]] bool IsPositional(const Option& option);
/// Whether a value follows it.
[[nodiscard]] bool TakesValue(const Option& option);
/// What stands for its value in a text about it: "N" for a number; empty for a flag and a positional.
[[nodiscard]] std::string ValueName(const Option& option);
/// The only values that it takes; empty where there are more than can be listed.
[[nodiscard]] std::vector<std::string> ValuesOf(const Option& option);
/// Whether its value may be the name of a file.
[[nodiscard]] bool TakesFile(const Option& option);
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_DESCRIBED_HPP
