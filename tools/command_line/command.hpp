// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_COMMAND_HPP
#define TOOLS_COMMAND_LINE_COMMAND_HPP

#include "runtime/console/streams.hpp"

#include <memory>

namespace counterpoint::tools
{
class Options;

using runtime::ExitStatus;
using runtime::Streams;

/// One command of the command line. A command lives in a file NAME_command.cpp of its own with one function
/// MakeNameCommand(), which tools/command_table.hpp declares, and has one row in tools/command_table.cpp; nothing else
/// knows it. `demo` has a folder and a program of its own, so that the first thing that people try is built fast.
class Command
{
  public:
    Command() = default;
    virtual ~Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    /// Adds options and positionals; `options` lives as long as the command.
    virtual void Describe(Options& options) = 0;
    /// Called once, after the options were read. May throw cia306::InputError and runtime::YamlError, which end with
    /// kBadInput.
    [[nodiscard]] virtual ExitStatus Run(const Streams& streams) = 0;
};

/// A command as the command line knows it.
struct CommandRow
{
    const char* name;
    const char* description;
    std::unique_ptr<Command> (*make)();
};
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_COMMAND_HPP
