// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "tools/command_table.hpp"
#include "version/version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <ostream>

namespace counterpoint::tools
{
namespace
{
constexpr const char* kProgram = "counterpoint";
constexpr const char* kExitStatus = "Exit status: 0 what was asked holds, 1 it does not, 2 bad input or bad usage.";

/// One line, whatever the library or the system says.
std::string OneLine(std::string text)
{
    while (!text.empty() && text.back() == '\n')
    {
        text.pop_back();
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return cia306::Printable(text);
}

std::string CommandNames()
{
    std::string names;
    for (const CommandRow& row : CommandTable())
    {
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    return names;
}

ExitStatus Usage(const CLI::App& app, const CLI::ParseError& error, const Streams& streams)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    {
        (void)app.exit(error, streams.out, streams.err); // Help and version.
        return ExitStatus::kHolds;
    }
    std::string help = std::string(kProgram);
    for (const CLI::App* command : app.get_subcommands())
    {
        help += " " + command->get_name();
    }
    const std::vector<std::string> unknown = app.remaining();
    const bool has_command = !app.get_subcommands().empty();
    std::string wrong = OneLine(error.what());
    if (!has_command && !unknown.empty())
    {
        wrong = cia306::Quoted(unknown.front()) + " is no command";
    }
    streams.err << kProgram << ": " << wrong << "; expected "
                << (has_command ? "" : "one of " + CommandNames() + " in ") << "a command line as told by '" << help
                << " --help'\n";
    return ExitStatus::kBadInput;
}
} // namespace

ExitStatus RunCommandLine(const std::vector<std::string>& arguments, const Streams& streams)
{
    CLI::App app("Counterpoint: CANopen Safety (EN 50325-5) tools", kProgram);
    app.set_version_flag("--version", CounterpointVersion);
    app.require_subcommand(1);
    app.footer(std::string(kExitStatus) + "\n'counterpoint COMMAND --help' tells the options of a command.");
    std::vector<std::pair<CLI::App*, std::unique_ptr<Command>>> commands;
    for (const CommandRow& row : CommandTable())
    {
        CLI::App* const subcommand = app.add_subcommand(row.name, row.description);
        commands.emplace_back(subcommand, row.make());
        subcommand->footer(std::string()); // Not that of the program.
        commands.back().second->Describe(*subcommand);
        const std::string more = subcommand->get_footer();
        subcommand->footer(more + (more.empty() ? "" : "\n") + kExitStatus);
    }
    try
    {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 takes them last first.
        for (const auto& [subcommand, command] : commands)
        {
            if (subcommand->parsed())
            {
                return command->Run(streams);
            }
        }
    }
    catch (const CLI::ParseError& error)
    {
        return Usage(app, error, streams);
    }
    catch (const cia306::InputError& error)
    {
        streams.err << error.what() << "\n";
    }
    catch (const std::exception& error)
    {
        streams.err << kProgram << ": " << OneLine(error.what()) << "\n";
    }
    return ExitStatus::kBadInput;
}
} // namespace counterpoint::tools
