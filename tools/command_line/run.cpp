// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/run.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/nearest_word.hpp"
#include "runtime/yaml/document.hpp"
#include "tools/command_line/described.hpp"
#include "tools/command_line/end_signals.hpp"
#include "tools/command_line/painter.hpp"
#include "version/version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <unistd.h>
#include <variant>

namespace counterpoint::tools
{
namespace
{
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

std::vector<std::string> NamesOf(const std::vector<CommandRow>& table)
{
    std::vector<std::string> names;
    for (const CommandRow& row : table)
    {
        names.emplace_back(row.name);
    }
    return names;
}

std::string Listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
    {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

/// What is wrong with a number that people read otherwise than the library does, such as 010, which would be 8, or that
/// is no whole one.
std::string ProblemOfNumber(const std::string& text)
{
    const std::size_t point = text.find('.');
    if (point != std::string::npos && text.find_first_not_of("0123456789", point + 1U) == std::string::npos)
    {
        return text + " is no whole number, expected one";
    }
    const bool is_hexadecimal = text.size() > 2U && (text[1] == 'x' || text[1] == 'X');
    const bool is_octal = text.size() > 1U && text[0] == '0' && !is_hexadecimal;
    return is_octal ? text + " begins with 0, expected a decimal number, or a hexadecimal one after 0x" : std::string();
}

CLI::Option* Add(CLI::App& app, const Option& option)
{
    if (bool* const* const flag = std::get_if<bool*>(&option.target))
    {
        return app.add_flag(option.name, **flag, option.description);
    }
    if (int* const* const number = std::get_if<int*>(&option.target))
    {
        return app.add_option(option.name, **number, option.description)->check(CLI::Validator(ProblemOfNumber, ""));
    }
    if (std::string* const* const text = std::get_if<std::string*>(&option.target))
    {
        return app.add_option(option.name, **text, option.description);
    }
    return app.add_option(option.name, *std::get<std::vector<std::string>*>(option.target), option.description);
}

void AddChecks(CLI::Option& added, const Option& option)
{
    const bool is_text = std::holds_alternative<std::string*>(option.target) ||
                         std::holds_alternative<std::vector<std::string>*>(option.target);
    const Problem problem = (option.problem == nullptr && is_text) ? &ProblemOfAnyText : option.problem;
    if (problem != nullptr)
    {
        added.check(CLI::Validator(problem, ""));
    }
    if (option.range)
    {
        added.check(CLI::Range(option.range->first, option.range->second));
    }
    if (!option.numbers.empty())
    {
        added.check(CLI::IsMember(option.numbers));
    }
    if (!option.words.empty() && option.problem == nullptr)
    {
        added.check(CLI::IsMember(option.words));
    }
}

void Describe(CLI::App& app, const Option& option)
{
    CLI::Option& added = *Add(app, option);
    AddChecks(added, option);
    if (option.is_required)
    {
        added.required();
    }
    if (option.value_count)
    {
        added.expected(option.value_count->least, option.value_count->most);
    }
    if (option.takes_one_value)
    {
        added.allow_extra_args(false);
    }
    if (option.shows_default)
    {
        added.capture_default_str();
    }
    if (option.if_alone)
    {
        added.default_str(*option.if_alone);
    }
    if (option.type)
    {
        added.type_name(*option.type);
    }
    if (!option.excluded.empty())
    {
        added.excludes(app.get_option(option.excluded));
    }
    if (!option.needed.empty())
    {
        added.needs(app.get_option(option.needed));
    }
}

/// The long one of names such as "-o,--output".
std::string LongName(const std::string& names)
{
    return names.substr(names.rfind(',') + 1U);
}

/// One command, its options and what the library knows of them.
struct Entry
{
    CLI::App* app;
    DescribedCommand described;
};

Entry AddCommand(CLI::App& app, const CommandRow& row)
{
    Entry entry{app.add_subcommand(row.name, row.description), Described(row)};
    for (const Option& option : entry.described.options->All())
    {
        Describe(*entry.app, option);
    }
    const std::string& more = entry.described.options->FooterText();
    entry.app->footer(more + (more.empty() ? "" : "\n") + kExitStatus);
    return entry;
}

ExitStatus Run(const Entry& entry, const Streams& streams)
{
    for (Option& option : entry.described.options->All())
    {
        option.times = entry.app->count(LongName(option.name));
    }
    return entry.described.command->Run(streams);
}

/// The first option among `words` that `app` does not know, with the one that may be meant. [SRS_EASE_001, SRS_CLI_732]
std::string UnknownOption(const CLI::App& app, const std::vector<std::string>& words)
{
    std::vector<std::string> known;
    for (const CLI::Option* const option : app.get_options())
    {
        known.push_back(option->get_name());
    }
    for (const std::string& word : words)
    {
        const std::string name = word.substr(0U, word.find('='));
        if (name.rfind("--", 0U) == 0U && name.size() > 2U)
        {
            return cia306::Quoted(name) + " is no option" + cia306::DidYouMean(name, known);
        }
        if (word.size() > 1U && word[0] == '-' && word[1] != '-')
        {
            return cia306::Quoted(word) + " is no option (a file of this name is " + cia306::Quoted("./" + word) + ")";
        }
    }
    return "";
}

/// What is wrong with a command line without a command.
std::string WithoutCommand(const CLI::App& app, const std::vector<CommandRow>& table)
{
    const std::vector<std::string> unknown = app.remaining();
    if (unknown.empty())
    {
        return "";
    }
    const std::string option = UnknownOption(app, {unknown.front()});
    return option.empty() ? cia306::Quoted(unknown.front()) + " is no command" +
                                cia306::DidYouMean(unknown.front(), NamesOf(table))
                          : option;
}

/// What is wrong with a command line that asks for the version: more stands in it. [SRS_CLI_492]
std::string BesideVersion(const CLI::ParseError& error, const std::vector<std::string>& arguments)
{
    const bool is_version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
    const auto other = std::find_if(arguments.begin(), arguments.end(),
                                    [](const std::string& argument) { return argument != "--version"; });
    return is_version && other != arguments.end()
               ? cia306::Quoted(*other) + " beside --version; expected --version alone, or "
               : "";
}

ExitStatus Usage(const CLI::App& app, const std::vector<CommandRow>& table, const CLI::ParseError& error,
                 const Streams& streams)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
    {
        (void)app.exit(error, streams.out, streams.err); // Help and version.
        return ExitStatus::kHolds;
    }
    const std::vector<CLI::App*> commands = app.get_subcommands();
    std::string help = std::string(kProgram);
    for (const CLI::App* command : commands)
    {
        help += " " + command->get_name();
    }
    const bool has_command = !commands.empty();
    std::string wrong =
        has_command ? UnknownOption(*commands.front(), commands.front()->remaining()) : WithoutCommand(app, table);
    if (wrong.empty())
    {
        wrong = OneLine(error.what());
    }
    streams.err << kProgram << ": " << wrong << "; expected "
                << (has_command ? "" : "one of " + Listed(NamesOf(table)) + " in ") << "a command line as told by '"
                << help << " --help'\n";
    return ExitStatus::kBadInput;
}
} // namespace

ExitStatus RunCommandLine(const std::vector<std::string>& arguments, const std::vector<CommandRow>& table,
                          const Streams& streams)
{
    CLI::App app("Counterpoint: CANopen Safety (EN 50325-5) tools", kProgram);
    app.set_version_flag("--version", CounterpointVersion);
    app.require_subcommand(1);
    app.footer(std::string(kExitStatus) + "\n'counterpoint COMMAND --help' tells the options of a command.");
    std::vector<Entry> entries;
    for (const CommandRow& row : table)
    {
        entries.push_back(AddCommand(app, row));
    }
    try
    {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 takes them last first.
        for (const Entry& entry : entries)
        {
            if (entry.app->parsed())
            {
                return Run(entry, streams);
            }
        }
    }
    catch (const CLI::ParseError& error)
    {
        const std::string beside = BesideVersion(error, arguments);
        if (beside.empty())
        {
            return Usage(app, table, error, streams);
        }
        streams.err << kProgram << ": " << beside << "a command line as told by 'counterpoint --help'\n";
    }
    catch (const cia306::InputError& error)
    {
        streams.err << error.what() << "\n";
    }
    catch (const runtime::YamlError& error)
    {
        streams.err << error.what() << "\n";
    }
    catch (const std::exception& error)
    {
        streams.err << kProgram << ": " << OneLine(error.what()) << "\n";
    }
    return ExitStatus::kBadInput;
}

int RunProgram(const int count, const char* const* const arguments, const std::vector<CommandRow>& table)
{
    std::vector<std::string> words;
    for (int place = 1; place < count; ++place)
    {
        words.emplace_back(arguments[place]);
    }
    LimitWaitForReader();
    // A file that may grow no further is told where it is written; the signal would end the program. [SRS_EASE_008]
    static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
    const Painter out(std::cout, STDOUT_FILENO);
    const Painter err(std::cerr, STDERR_FILENO);
    ExitStatus status = RunCommandLine(words, table, {std::cout, std::cerr});
    std::cout.flush();
    if (!std::cout)
    {
        std::cerr << kProgram << ": the answer cannot be written, expected an open output\n";
        status = ExitStatus::kBadInput;
    }
    return static_cast<int>(status);
}
} // namespace counterpoint::tools
