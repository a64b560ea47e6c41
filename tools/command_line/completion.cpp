// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/completion.hpp"

#include "tools/command_line/described.hpp"

#include <sstream>

namespace counterpoint::tools
{
namespace
{
constexpr const char* kMadeBy = " completion of counterpoint, made by 'counterpoint completion ";

/// Each of `letters` behind a backslash.
std::string Escaped(const std::string& text, const std::string& letters)
{
    std::string escaped;
    for (const char letter : text)
    {
        escaped += (letters.find(letter) == std::string::npos ? "" : "\\") + std::string(1U, letter);
    }
    return escaped;
}

/// In single quotes, for any of the shells; fish alone takes \' in them.
std::string ShellQuoted(const std::string& text)
{
    std::string quoted;
    for (const char letter : text)
    {
        quoted += (letter == '\'') ? std::string("'\\''") : std::string(1U, letter);
    }
    return "'" + quoted + "'";
}

std::string Joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

/// The names of an option: of "-o,--output" both.
std::vector<std::string> NamesOf(const Option& option)
{
    std::vector<std::string> names;
    std::istringstream in(option.name);
    for (std::string name; std::getline(in, name, ',');)
    {
        names.push_back(name);
    }
    return names;
}

/// All names of options of a command, and those of every command.
std::vector<std::string> NamesOf(const Options& options)
{
    std::vector<std::string> names;
    for (const Option& option : options.All())
    {
        if (!IsPositional(option))
        {
            const std::vector<std::string> own = NamesOf(option);
            names.insert(names.end(), own.begin(), own.end());
        }
    }
    for (const CommonOption& option : kCommonOptions)
    {
        if (option.is_of_commands)
        {
            names.emplace_back(option.name);
        }
    }
    return names;
}

/// What a word is completed to behind an option with a value, or where a positional stands. An answer without words
/// leaves it to the shell, which knows names of files.
void WriteBashValues(const std::string& pattern, const Option& option, std::ostream& out)
{
    if (TakesFile(option))
    {
        return;
    }
    out << "        " << ShellQuoted(pattern) << ") words=" << ShellQuoted(Joined(ValuesOf(option)))
        << "; no_file=1 ;;\n";
}

void WriteBash(const std::vector<DescribedCommand>& commands, std::ostream& out)
{
    std::vector<std::string> first;
    for (const DescribedCommand& command : commands)
    {
        first.push_back(command.name);
    }
    for (const CommonOption& option : kCommonOptions)
    {
        first.emplace_back(option.name);
    }
    out << "_counterpoint()\n{\n"
           "    local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
           "    local command=\"${COMP_WORDS[1]}\" options='' words='' no_file=''\n"
           "    case \"$command\" in\n";
    for (const DescribedCommand& command : commands)
    {
        out << "        " << command.name << ") options=" << ShellQuoted(Joined(NamesOf(*command.options))) << " ;;\n";
    }
    out << "    esac\n    case \"$command $before\" in\n";
    for (const DescribedCommand& command : commands)
    {
        for (const Option& option : command.options->All())
        {
            if (!IsPositional(option) && TakesValue(option))
            {
                for (const std::string& name : NamesOf(option))
                {
                    WriteBashValues(command.name + " " + name, option, out);
                }
            }
            else if (IsPositional(option))
            {
                WriteBashValues(command.name + " " + command.name, option, out);
            }
        }
    }
    out << "    esac\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n        words="
        << ShellQuoted(Joined(first))
        << "; no_file=1\n    elif [ -z \"$no_file\" ] && [ \"${word#-}\" != \"$word\" ]; then\n"
           "        words=\"$options\"\n    fi\n"
           "    if [ -n \"$no_file\" ]; then compopt +o default 2>/dev/null; fi\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}\n"
           "complete -o default -F _counterpoint counterpoint\n";
}

/// How zsh gets at the value of an option.
std::string ZshAction(const Option& option)
{
    const std::vector<std::string> values = ValuesOf(option);
    if (!values.empty())
    {
        return "(" + Joined(values) + ")";
    }
    return TakesFile(option) ? "_files" : "";
}

/// All but the last of the positionals are one word each: zsh knows one rest of a line.
void WriteZshPositionals(const Options& options, std::ostream& out)
{
    std::vector<const Option*> positionals;
    for (const Option& option : options.All())
    {
        if (IsPositional(option))
        {
            positionals.push_back(&option);
        }
    }
    for (std::size_t place = 1U; place <= positionals.size(); ++place)
    {
        const Option& option = *positionals[place - 1U];
        const std::string where = (place == positionals.size()) ? "*" : std::to_string(place);
        out << " \\\n                " << ShellQuoted(where + ":" + option.name + ":" + ZshAction(option));
    }
}

void WriteZshOption(const Option& option, std::ostream& out)
{
    const std::string description = Escaped(option.description, "[]:\\");
    if (IsPositional(option))
    {
        return;
    }
    const std::string value =
        TakesValue(option) ? ":" + Escaped(ValueName(option), ":\\") + ":" + ZshAction(option) : "";
    const std::string optional = option.if_alone ? ":" : ""; // Two colons: the value may be missing.
    for (const std::string& name : NamesOf(option))
    {
        out << " \\\n                " << ShellQuoted("*" + name + "[" + description + "]" + optional + value);
    }
}

void WriteZsh(const std::vector<DescribedCommand>& commands, std::ostream& out)
{
    out << "_counterpoint()\n{\n    local -a commands\n    commands=(\n";
    for (const DescribedCommand& command : commands)
    {
        out << "        " << ShellQuoted(command.name + ":" + Escaped(command.description, ":\\")) << "\n";
    }
    out << "    )\n    if (( CURRENT == 2 )); then\n        _describe command commands\n";
    for (const CommonOption& option : kCommonOptions)
    {
        out << "        compadd -- " << option.name << "\n";
    }
    out << "        return\n    fi\n    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n"
           "    case $command in\n";
    for (const DescribedCommand& command : commands)
    {
        out << "        " << command.name << ")\n            _arguments";
        for (const Option& option : command.options->All())
        {
            WriteZshOption(option, out);
        }
        WriteZshPositionals(*command.options, out);
        for (const CommonOption& option : kCommonOptions)
        {
            if (option.is_of_commands)
            {
                out << " \\\n                "
                    << ShellQuoted(std::string(option.name) + "[" + option.description + "]");
            }
        }
        out << " ;;\n";
    }
    // As a file that zsh loads by itself it is the function's body first; `source` gives no words to complete.
    out << "    esac\n}\n"
           "if [ \"$funcstack[1]\" = _counterpoint ]; then _counterpoint \"$@\"; else compdef _counterpoint "
           "counterpoint; fi\n";
}

void WriteFishOption(const std::string& when, const Option& option, std::ostream& out)
{
    const std::string values = Joined(ValuesOf(option));
    out << "complete -c counterpoint -n " << when;
    if (!IsPositional(option))
    {
        for (const std::string& name : NamesOf(option))
        {
            const bool is_long = name.rfind("--", 0U) == 0U;
            out << (is_long ? " -l " : " -s ") << name.substr(is_long ? 2U : 1U);
        }
        out << (TakesValue(option) ? (TakesFile(option) ? " -r -F" : " -x") : "");
    }
    if (!values.empty())
    {
        out << (IsPositional(option) ? " -f" : "") << " -a '" << values << "'";
    }
    if (IsPositional(option) && TakesFile(option))
    {
        out << " -F";
    }
    out << " -d '" << Escaped(option.description, "'\\") << "'\n";
}

void WriteFish(const std::vector<DescribedCommand>& commands, std::ostream& out)
{
    out << "complete -c counterpoint -f\n";
    for (const DescribedCommand& command : commands)
    {
        out << "complete -c counterpoint -n __fish_use_subcommand -a " << command.name << " -d '"
            << Escaped(command.description, "'\\") << "'\n";
    }
    for (const CommonOption& option : kCommonOptions)
    {
        out << "complete -c counterpoint" << (option.is_of_commands ? "" : " -n __fish_use_subcommand") << " -l "
            << std::string(option.name).substr(2U) << " -d '" << Escaped(option.description, "'\\") << "'\n";
    }
    for (const DescribedCommand& command : commands)
    {
        for (const Option& option : command.options->All())
        {
            WriteFishOption("'__fish_seen_subcommand_from " + command.name + "'", option, out);
        }
    }
}

struct ShellRow
{
    const char* name;
    const char* first_line; ///< Before the comment.
    void (*write)(const std::vector<DescribedCommand>& commands, std::ostream& out);
};

constexpr ShellRow kShells[] = {
    {"bash", "", &WriteBash}, {"zsh", "#compdef counterpoint\n", &WriteZsh}, {"fish", "", &WriteFish}};
} // namespace

std::vector<std::string> CompletedShells()
{
    std::vector<std::string> names;
    for (const ShellRow& row : kShells)
    {
        names.emplace_back(row.name);
    }
    return names;
}

std::string CompletionScript(const std::string& shell, const std::vector<CommandRow>& table)
{
    std::vector<DescribedCommand> commands;
    for (const CommandRow& row : table)
    {
        commands.push_back(Described(row));
    }
    std::ostringstream out;
    for (const ShellRow& row : kShells)
    {
        if (shell == row.name)
        {
            out << row.first_line << "# " << row.name << kMadeBy << row.name << "'\n";
            row.write(commands, out);
        }
    }
    return out.str();
}
} // namespace counterpoint::tools
