// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_HPP
#define TOOLS_COMMAND_HPP

#include "runtime/console/streams.hpp"

#include <cstdint>
#include <iosfwd>
#include <memory>

namespace CLI
{
class App;
}

namespace counterpoint::tools
{
using runtime::ExitStatus;
using runtime::Streams;

/// One command of the command line. A command lives in its own pair of files NAME_command.hpp, NAME_command.cpp with
/// one function MakeNameCommand(), and has one row in command_table.cpp; nothing else knows it.
class Command
{
  public:
    Command() = default;
    virtual ~Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    /// Adds options and positionals; `app` is the subcommand and lives as long as the command.
    virtual void Describe(CLI::App& app) = 0;
    /// Called once, after the options were read. May throw cia306::InputError, which ends with kBadInput.
    [[nodiscard]] virtual ExitStatus Run(const Streams& streams) = 0;
};

using CommandMaker = std::unique_ptr<Command> (*)();
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_HPP
