// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/man_page.hpp"

#include "tools/command_line/described.hpp"
#include "version/version.hpp"

#include <sstream>

namespace counterpoint::tools
{
namespace
{
/// Text as roff shows it: a hyphen stays one, and no line is taken for a request.
std::string Roff(const std::string& text)
{
    std::string roff;
    for (const char letter : text)
    {
        const bool is_first = roff.empty() || roff.back() == '\n';
        if (is_first && (letter == '.' || letter == '\''))
        {
            roff += "\\&";
        }
        roff += (letter == '\\') ? std::string("\\e") : (letter == '-') ? std::string("\\-") : std::string(1U, letter);
    }
    return roff;
}

/// FILE [--node-id N] ...
std::string Synopsis(const Options& options)
{
    std::string text;
    for (const Option& option : options.All())
    {
        const std::string value = ValueName(option);
        const std::string name =
            "\\fB" + Roff(option.name) + "\\fR" + (value.empty() ? "" : " \\fI" + Roff(value) + "\\fR");
        text += option.is_required ? " " + name : " [" + name + "]";
    }
    return text;
}

/// What it is, its range, its values.
std::string WhatItIs(const Option& option)
{
    std::string text = option.description;
    if (option.range)
    {
        text += "; " + std::to_string(option.range->first) + " to " + std::to_string(option.range->second);
    }
    const std::vector<std::string> values = ValuesOf(option);
    for (const std::string& value : values)
    {
        text += (&value == &values.front() ? "; one of " : ", ") + value;
    }
    if (!option.excluded.empty())
    {
        text += "; not beside " + option.excluded;
    }
    if (!option.needed.empty())
    {
        text += "; only with " + option.needed;
    }
    return text;
}

void WriteCommand(const DescribedCommand& command, std::ostream& out)
{
    out << ".SS \"" << kProgram << " " << command.name << "\"\n"
        << Roff(command.description) << ".\n.PP\n\\fB" << kProgram << " " << command.name << "\\fR"
        << Synopsis(*command.options) << "\n";
    for (const Option& option : command.options->All())
    {
        const std::string value = ValueName(option);
        out << ".TP\n\\fB" << Roff(option.name) << "\\fR" << (value.empty() ? "" : " \\fI" + Roff(value) + "\\fR")
            << "\n"
            << Roff(WhatItIs(option)) << ".\n";
    }
    const std::string& footer = command.options->FooterText();
    if (!footer.empty())
    {
        out << ".PP\n.nf\n" << Roff(footer) << "\n.fi\n";
    }
}
} // namespace

std::string ManPage(const std::vector<CommandRow>& table)
{
    std::ostringstream out;
    const std::string version = CounterpointVersion;
    out << ".\\\" Made by 'counterpoint man'.\n.TH COUNTERPOINT 1 \"\" \""
        << Roff(version.substr(0U, version.find(" ("))) << "\" \"User Commands\"\n.SH NAME\n"
        << kProgram << " \\- CANopen Safety (EN 50325\\-5) tools\n.SH SYNOPSIS\n.B " << kProgram
        << "\nCOMMAND [OPTION ...]\n";
    for (const CommonOption& option : kCommonOptions)
    {
        out << ".br\n.B " << kProgram << (option.is_of_commands ? "\n[COMMAND] " : "\n") << "\\fB" << Roff(option.name)
            << "\\fR\n";
    }
    out << ".SH COMMANDS\n";
    for (const CommandRow& row : table)
    {
        WriteCommand(Described(row), out);
    }
    out << ".SH EXIT STATUS\n.TP\n0\nWhat was asked holds.\n.TP\n1\nIt does not.\n.TP\n2\nBad input or bad usage.\n"
           ".SH ENVIRONMENT\n.TP\nNO_COLOR\nWhere it is set and not empty nothing is coloured, also not on a "
           "terminal.\n";
    return out.str();
}
} // namespace counterpoint::tools
