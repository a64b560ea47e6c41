// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "tools/command_line/described.hpp"
#include "tools/command_line/painter.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <pty.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::CommandTest;
using test::RunCommand;

/// What a shell command prints, without the last line end; "failed" where it is not there or says that it failed.
std::string Printed(const std::string& command)
{
    FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr)
    {
        return "failed";
    }
    std::string text;
    std::array<char, 4096U> block{};
    for (std::size_t count = block.size(); count == block.size();)
    {
        count = std::fread(block.data(), 1U, block.size(), pipe);
        text.append(block.data(), count);
    }
    while (!text.empty() && text.back() == '\n')
    {
        text.pop_back();
    }
    return (::pclose(pipe) == 0) ? text : "failed: " + text;
}

bool Has(const std::string& program)
{
    return Printed("command -v " + program).rfind("failed", 0U) != 0U;
}

TEST(Slip, NearestCommandAndOptionAreNamed)
{
    Verifies(req::SRS_EASE_001);
    EXPECT_EQ(RunCommand({"chekc", "a.dcf"}).err.substr(0U, 62U),
              "counterpoint: 'chekc' is no command (did you mean 'check'?); e");
    EXPECT_EQ(RunCommand({"--verison"}).err.substr(0U, 72U),
              "counterpoint: '--verison' is no option (did you mean '--version'?); expe");
    EXPECT_EQ(RunCommand({"sign", "a.dcf", "--nodeid", "3"}).err,
              "counterpoint: '--nodeid' is no option (did you mean '--node-id'?); expected a command line as told by "
              "'counterpoint sign --help'\n");
    EXPECT_EQ(RunCommand({"sign", "a.dcf", "--node_id=3"}).err,
              "counterpoint: '--node_id' is no option (did you mean '--node-id'?); expected a command line as told by "
              "'counterpoint sign --help'\n");
    EXPECT_EQ(RunCommand({"check", "a.dcf", "--verbose"}).err,
              "counterpoint: '--verbose' is no option; expected a command line as told by 'counterpoint check "
              "--help'\n");
}

TEST(Slip, AWordWithOneHyphenIsNamed)
{
    Verifies(req::SRS_CLI_732);
    EXPECT_EQ(
        RunCommand({"check", "-x.dcf"}).err,
        "counterpoint: '-x.dcf' is no option (a file of this name is './-x.dcf'); expected a command line as told "
        "by 'counterpoint check --help'\n");
    EXPECT_EQ(RunCommand({"check", "a.dcf", "-x"}).err,
              "counterpoint: '-x' is no option (a file of this name is './-x'); expected a command line as told by "
              "'counterpoint check --help'\n");
    EXPECT_EQ(RunCommand({"check", "a.dcf", "-"}).err,
              "counterpoint: The following argument was not expected: -; expected a command line as told by "
              "'counterpoint check --help'\n");
}

class SlipInAFile : public CommandTest
{
};

TEST_F(SlipInAFile, NearestKeyAndWordAreNamed)
{
    Verifies(req::SRS_EASE_001);
    const std::string scenario = File("a.yaml", "titel: none\n");
    EXPECT_EQ(
        RunCommand({"simulate", scenario})
            .err.rfind(scenario +
                           ":1:1: error: unknown key 'titel' (did you mean 'title'?) in a scenario, expected one of ",
                       0U),
        0U);
    const std::string network = File("b.yaml", "manager: {node: 127}\nslaves: [{node: 1, naem: x}]\n");
    EXPECT_EQ(
        RunCommand({"manager", "--can", "none", "--network", network})
            .err.rfind(network + ":2:20: error: unknown key 'naem' (did you mean 'name'?), expected node, name", 0U),
        0U);
    const std::string profile = File("c.yaml", "manager: {node: 127, profile: el6571}\nslaves: [{node: 1}]\n");
    EXPECT_EQ(RunCommand({"manager", "--can", "none", "--network", profile})
                  .err.rfind(profile + ":1:31: error: 'el6571' (did you mean 'el6751'?), expected one of cia302", 0U),
              0U);
    const std::string far_away = File("d.yaml", "colour: red\n");
    EXPECT_EQ(
        RunCommand({"simulate", far_away}).err.rfind(far_away + ":1:1: error: unknown key 'colour' in a scenario", 0U),
        0U);
}

// Words of a scenario: of a table, kinds of faults, names that the file itself gives; and a slip in a key that is
// needed.
TEST_F(SlipInAFile, NearestWordOfAScenarioIsNamed)
{
    Verifies(req::SRS_EASE_001);
    const std::string chain = cia306::test::SourceFolder() + "/examples/emergency_stop/chain.yaml";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"faults: [{fault: los, frames: {identifier: 0x103}}]", "'los' (did you mean 'loss'?), expected one of "},
        {"expect: [{that: safe_witin, node: actuator, srdo: 1}]",
         "'safe_witin' (did you mean 'safe_within'?), expected one of "},
        {"expect: [{that: safe, node: actutor, srdo: 1, at: 5 ms}]",
         "node 'actutor' (did you mean 'actuator'?), expected one of "},
        {"faults: [{fault: loss, name: first, frames: {identifier: 0x103}}]\n"
         "expect: [{that: safe_within, fault: fisrt, node: actuator, srdo: 1}]",
         "fault 'fisrt' (did you mean 'first'?), expected one of "},
        {"inputs: [{at: 30 ms, nod: sensor, object: 0x2000:01, value: 1}]",
         "unknown key 'nod' (did you mean 'node'?) in an input, expected key 'node'"},
        {"inputs: [{at: 30 ms, object: 0x2000:01, value: 1}]", "an input without key 'node', expected that key"},
        {"faults: [{fault: explosion}]", "'explosion', expected one of "},
    };
    for (const auto& [text, told] : cases)
    {
        const std::string file = File("a.yaml", "extends: " + chain + "\n" + text + "\n");
        const std::string error = RunCommand({"simulate", file, "--quiet"}).err;
        EXPECT_NE(error.find(": error: " + told), std::string::npos) << error;
    }
}

/// What a shell command writes to a terminal, without carriage returns.
std::string OnTerminal(const std::string& command)
{
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0)
    {
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        ::_exit(127);
    }
    std::string text;
    char letter = 0;
    while (child > 0 && ::read(terminal, &letter, 1U) == 1) // Ends with an error when the other side is closed.
    {
        text += (letter == '\r') ? "" : std::string(1U, letter);
    }
    static_cast<void>(::waitpid(child, nullptr, 0));
    static_cast<void>(::close(terminal));
    return text;
}

/// Whether a program writes these words to a terminal; it is ended then.
bool IsShownOnTerminal(const std::string& command, const std::string& words)
{
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0)
    {
        ::execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
        ::_exit(127);
    }
    std::string text;
    char letter = 0;
    while (child > 0 && text.find(words) == std::string::npos && ::read(terminal, &letter, 1U) == 1)
    {
        text += letter;
    }
    static_cast<void>(::kill(child, SIGKILL));
    static_cast<void>(::waitpid(child, nullptr, 0));
    static_cast<void>(::close(terminal));
    return text.find(words) != std::string::npos;
}

const std::string kProgramFile = COUNTERPOINT_PROGRAM;
const std::string kColours = "TERM=xterm NO_COLOR= ";

TEST(Progress, OfASimulationAndOfASweepIsShown)
{
    Verifies(req::SRS_SIM_350);
    // Given a simulation of eleven days, and a sweep of 20000 runs: each takes far longer than two seconds
    const std::string command =
        kProgramFile + " simulate " + cia306::test::SourceFolder() + "/examples/emergency_stop/chain.yaml --quiet ";
    EXPECT_TRUE(IsShownOnTerminal(command + "--until '1000000 s'",
                                  "simulating [........................................] 0 %"));
    EXPECT_TRUE(IsShownOnTerminal(command + "--sweep seed=0:19999:1", "sweeping ["));
    // Where its error output is no terminal, nothing is
    EXPECT_FALSE(IsShownOnTerminal("timeout -s KILL 4 " + command + "--until '1000000 s' 2>&1 | cat", "simulating"));
}

TEST(Colours, WordsStandAlone)
{
    Verifies(req::SRS_EASE_002);
    EXPECT_EQ(Painted("a:1: error: b"), "a:1: \033[31merror:\033[0m b");
    EXPECT_EQ(Painted("a:1: warning: b"), "a:1: \033[33mwarning:\033[0m b");
    EXPECT_EQ(Painted("NMT operational"), "NMT \033[32moperational\033[0m");
    EXPECT_EQ(Painted("pre-operational, srdo_error, terror: unreleased"),
              "pre-operational, srdo_error, terror: unreleased");
    EXPECT_EQ(Painted("SRDO 1 faulted\n"), "SRDO 1 \033[31mfaulted\033[0m\n");
    EXPECT_EQ(Painted(""), "");
}

TEST(Colours, AreOnATerminalAlone)
{
    Verifies(req::SRS_EASE_002);
    const std::string command = kProgramFile + " check nobody.dcf";
    const std::string coloured = OnTerminal(kColours + command);
    EXPECT_NE(coloured.find("nobody.dcf: \033[31merror:\033[0m "), std::string::npos) << coloured;
    // A pipe, a file; each output by itself.
    EXPECT_EQ(Printed(kColours + command + " || true").find('\033'), std::string::npos);
    EXPECT_EQ(OnTerminal(kColours + command + " 2>&1 | cat").find('\033'), std::string::npos);
    const std::string half = OnTerminal(kColours + command + " --json | cat");
    EXPECT_NE(half.find("\033[31merror:\033[0m"), std::string::npos) << half;
    EXPECT_NE(half.find("\"error\": {\n"), std::string::npos) << half;
}

TEST(Colours, NobodyGetsThemWhoWantsOrKnowsNone)
{
    Verifies(req::SRS_EASE_002);
    const std::string command = kProgramFile + " check nobody.dcf";
    const std::string plain = OnTerminal("TERM=xterm NO_COLOR=1 " + command);
    EXPECT_NE(plain.find("nobody.dcf: error: "), std::string::npos) << plain;
    EXPECT_EQ(plain.find('\033'), std::string::npos);
    EXPECT_EQ(OnTerminal("NO_COLOR= TERM=dumb " + command).find('\033'), std::string::npos);
    EXPECT_EQ(OnTerminal("NO_COLOR= TERM= " + command).find('\033'), std::string::npos);
    EXPECT_EQ(OnTerminal("NO_COLOR= env -u TERM " + command).find('\033'), std::string::npos);
}

TEST(Colours, OutputThatCannotBeWrittenIsStillTold)
{
    Verifies(req::SRS_EASE_002);
    const std::string text = OnTerminal(kColours + kProgramFile + " man >/dev/full; echo status $?");
    EXPECT_NE(text.find("status 2"), std::string::npos) << text;
}

using FileThatMayNotGrow = CommandTest;

TEST_F(FileThatMayNotGrow, IsToldAndLeavesNothing)
{
    Verifies(req::SRS_EASE_008);
    const auto limited = [](const std::string& arguments)
    { return Printed("(ulimit -f 0; " + kProgramFile + " " + arguments + "; echo status $?)"); };
    const std::string dcf = cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    EXPECT_EQ(limited("sign " + dcf + " --write " + Path("copy.dcf")),
              Path("copy.dcf") +
                  ": error: it cannot be written (File too large), expected a file system with room\nstatus 2");
    EXPECT_EQ(limited("node --can udp:239.74.163.2:43184 --dcf " + dcf + " --store " + Path("store")),
              Path("store") + ": error: the store cannot be written, expected a regular file with room\nstatus 2");
    EXPECT_TRUE(std::filesystem::is_empty(Path("")));
    EXPECT_EQ(limited("man >" + Path("page")),
              "counterpoint: the answer cannot be written, expected an open output\nstatus 2");
}

// The log of a node that runs is full: it goes on, and says so at its end.
TEST_F(FileThatMayNotGrow, EndsNoRunningCommand)
{
    Verifies(req::SRS_EASE_008);
    // One block of the limit is 512 bytes
    const std::string script =
        File("run.sh", "cd " + Path("") + "\nmkfifo orders\nulimit -f 1\n" + kProgramFile +
                           " node --can udp:239.74.163.2:43185 --dcf " + cia306::test::SourceFolder() +
                           "/examples/emergency_stop/sensor.dcf <orders >log 2>problem &\n"
                           "node=$!\n"
                           "exec 3>orders\n"
                           "turns=0\n"
                           "while [ $(stat -c %s log) -lt 512 ] && [ $turns -lt 3000 ]; do\n"
                           "  echo state >&3; sleep 0.1; turns=$((turns + 1))\n"
                           "done\n"
                           "echo state >&3\n"
                           "sleep 0.3\n"
                           "kill -0 $node && echo runs\n"
                           "echo quit >&3\n"
                           "wait $node\n"
                           "echo status $?\n"
                           "stat -c %s log\n"
                           "cat problem\n");
    EXPECT_EQ(Printed("sh " + script), "runs\nstatus 2\n512\ncounterpoint: the answer cannot be written, expected an "
                                       "open output");
}

class Completion : public CommandTest
{
  protected:
    /// What bash offers for the last of `words`, a blank between the offers.
    [[nodiscard]] std::string Offers(const std::vector<std::string>& words) const
    {
        std::string line;
        for (const std::string& word : words)
        {
            line += " '" + word + "'";
        }
        const std::string script = File("offers.bash", RunCommand({"completion", "bash"}).out + "COMP_WORDS=(" + line +
                                                           ")\nCOMP_CWORD=" + std::to_string(words.size() - 1U) +
                                                           "\n_counterpoint\necho \"${COMPREPLY[*]}\"\n");
        return Printed("bash --norc " + script);
    }
};

TEST_F(Completion, BashOffersCommandsOptionsAndValues)
{
    Verifies(req::SRS_EASE_003);
    if (!Has("bash"))
    {
        GTEST_SKIP() << "no bash";
    }
    EXPECT_EQ(Offers({"counterpoint", "si"}), "simulate sign");
    EXPECT_EQ(Offers({"counterpoint", "--v"}), "--version");
    EXPECT_EQ(Offers({"counterpoint", "sign", "--"}), "--node-id --json --write --verbose --help");
    EXPECT_EQ(Offers({"counterpoint", "sign", "a.dcf", "--ver"}), "--verbose");
    EXPECT_EQ(Offers({"counterpoint", "check", "--granularity", ""}), "1 8 16 32 64");
    EXPECT_EQ(Offers({"counterpoint", "check", "--granularity", "1"}), "1 16");
    EXPECT_EQ(Offers({"counterpoint", "completion", ""}), "bash zsh fish");
    EXPECT_EQ(Offers({"counterpoint", "srdo", ""}), "add remove list");
    EXPECT_EQ(Offers({"counterpoint", "srdo", "add", ""}), ""); // A file.
    EXPECT_EQ(Offers({"counterpoint", "new", "--role", "con"}), "consumer controller");
    EXPECT_EQ(Offers({"counterpoint", "new", "--detection", ""}), "early late");
    EXPECT_EQ(Offers({"counterpoint", "srdo", "--release", "a"}), "automatic");
    EXPECT_EQ(Offers({"counterpoint", "new", "--gfc", ""}), "on off");
    EXPECT_EQ(Offers({"counterpoint", "simulate", "--profile", ""}), "cia302 el6751 plc_designer");
    EXPECT_EQ(Offers({"counterpoint", "new", "--bit-rate", "1"}), "10 125 1000");
    EXPECT_EQ(Offers({"counterpoint", "sign", "--node-id", ""}), ""); // A number.
    EXPECT_EQ(Offers({"counterpoint", "sign", "exam"}), "");          // A file: left to the shell.
    EXPECT_EQ(Offers({"counterpoint", "new", "--o"}), "--output");
    EXPECT_EQ(Offers({"counterpoint", "srdo", "add", "-o"}), "-o");
    EXPECT_EQ(Offers({"counterpoint", "frobnicate", "--"}), "");
}

TEST_F(Completion, NamesOfFilesAreLeftToBashAndNumbersToNobody)
{
    Verifies(req::SRS_EASE_003);
    const std::string script = RunCommand({"completion", "bash"}).out;
    EXPECT_NE(script.find("complete -o default -F _counterpoint counterpoint\n"), std::string::npos);
    EXPECT_NE(script.find("'sign --node-id') words=''; no_file=1 ;;\n"), std::string::npos);
    for (const char* const number : {"new --node-id", "new --vendor-id", "new --refresh", "srdo --safe-value",
                                     "simulate "
                                     "--seed"})
    {
        EXPECT_NE(script.find("'" + std::string(number) + "') words=''; no_file=1 ;;\n"), std::string::npos) << number;
    }
    EXPECT_EQ(script.find("'sign --write')"), std::string::npos);
    EXPECT_NE(script.find("if [ -n \"$no_file\" ]; then compopt +o default"), std::string::npos);
}

TEST_F(Completion, EachNameOfAnOptionIsAWordOfItsOwn)
{
    Verifies(req::SRS_EASE_003);
    for (const char* const shell : {"bash", "zsh", "fish"})
    {
        EXPECT_EQ(RunCommand({"completion", shell}).out.find("-o,--output"), std::string::npos) << shell;
    }
    const std::string zsh = RunCommand({"completion", "zsh"}).out;
    EXPECT_NE(zsh.find("'*-o[The DCF to write]:FILE:_files'"), std::string::npos);
    EXPECT_NE(zsh.find("'*--output[The DCF to write]:FILE:_files'"), std::string::npos);
    EXPECT_NE(RunCommand({"completion", "fish"}).out.find(" -s o -l output -r -F -d 'The DCF to write'\n"),
              std::string::npos);
}

// Two of them are an error: nothing of the command would be completed.
TEST_F(Completion, ZshHasOneRestOfALine)
{
    Verifies(req::SRS_EASE_003);
    const std::string script = RunCommand({"completion", "zsh"}).out;
    EXPECT_NE(script.find("'1:ACTION:(add remove list)'"), std::string::npos);
    EXPECT_NE(script.find("'*:FILE:_files'"), std::string::npos);
    EXPECT_EQ(script.find("'*:ACTION:"), std::string::npos);
}

TEST_F(Completion, EachScriptHasEveryCommandAndEveryOption)
{
    Verifies(req::SRS_EASE_003);
    for (const std::string shell : {"bash", "zsh", "fish"})
    {
        const Answer answer = RunCommand({"completion", shell});
        EXPECT_EQ(answer.status, 0);
        for (const CommandRow& row : CommandTable())
        {
            EXPECT_NE(answer.out.find(row.name), std::string::npos) << shell << " " << row.name;
            const DescribedCommand described = Described(row);
            for (const Option& option : described.options->All())
            {
                const std::string full = option.name.substr(option.name.rfind(',') + 1U);
                const std::string name = (shell == "fish" && !IsPositional(option)) ? " -l " + full.substr(2U)
                                         : IsPositional(option)                     ? std::string()
                                                                                    : full;
                EXPECT_NE(answer.out.find(name), std::string::npos) << shell << " " << row.name << " " << option.name;
            }
        }
    }
    EXPECT_EQ(RunCommand({"completion", "csh"}).status, 2);
    EXPECT_EQ(RunCommand({"completion"}).status, 2);
}

TEST_F(Completion, ScriptsAreReadByTheirShells)
{
    Verifies(req::SRS_EASE_003);
    for (const std::string shell : {"bash", "zsh", "fish"})
    {
        if (Has(shell))
        {
            EXPECT_EQ(Printed(shell + " -n " + File(shell, RunCommand({"completion", shell}).out)), "") << shell;
        }
    }
}

TEST_F(Completion, TextsOfTheTablesCannotBreakTheScripts)
{
    Verifies(req::SRS_EASE_003);
    // From the table: "Start-up profile of the managers: one of the scenario's 'profiles'" and "Run once: ... [KEY]".
    const std::string zsh = RunCommand({"completion", "zsh"}).out;
    EXPECT_NE(
        zsh.find("'*--profile[Start-up profile of the managers\\: one of the scenario'\\''s '\\''profiles'\\'']:TEXT:"
                 "(cia302 el6751 plc_designer)'"),
        std::string::npos);
    EXPECT_EQ(zsh.rfind("#compdef counterpoint\n", 0U), 0U);
    const std::string fish = RunCommand({"completion", "fish"}).out;
    EXPECT_NE(fish.find(" -l profile -x -a 'cia302 el6751 plc_designer' -d 'Start-up profile of the managers: one of "
                        "the scenario\\'s "
                        "\\'profiles\\''\n"),
              std::string::npos);
}

TEST(ManualPage, NamesEachCommandAndItsOptionsWithTheirConditions)
{
    Verifies(req::SRS_EASE_004);
    const Answer answer = RunCommand({"man"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.err, "");
    EXPECT_NE(answer.out.find("\n.TH COUNTERPOINT 1 "), std::string::npos);
    for (const CommandRow& row : CommandTable())
    {
        EXPECT_NE(answer.out.find("\n.SS \"counterpoint " + std::string(row.name) + "\"\n"), std::string::npos);
    }
    EXPECT_NE(answer.out.find("\n.TP\n\\fB\\-\\-node\\-id\\fR \\fIN\\fR\n"
                              "Node\\-ID for $NODEID (default: the one in the file); 1 to 127.\n"),
              std::string::npos);
    EXPECT_NE(answer.out.find("; one of 1, 8, 16, 32, 64.\n"), std::string::npos);
    EXPECT_NE(answer.out.find("\nList the scenarios and end; not beside \\-\\-html.\n"), std::string::npos);
    EXPECT_NE(answer.out.find("; 1 to 1000000; only with \\-\\-can.\n"), std::string::npos);
    EXPECT_NE(answer.out.find("\n.SH EXIT STATUS\n.TP\n0\nWhat was asked holds.\n.TP\n1\nIt does not.\n.TP\n2\nBad "
                              "input or bad usage.\n"),
              std::string::npos);
    EXPECT_EQ(RunCommand({"man"}).out, answer.out);
}

/// Hyphens as roff has them.
std::string Hyphened(const std::string& text)
{
    std::string roff;
    for (const char letter : text)
    {
        roff += (letter == '-') ? std::string("\\-") : std::string(1U, letter);
    }
    return roff;
}

TEST(ManualPage, HasEachOptionOfEachCommandWithItsRangeValuesAndConditions)
{
    Verifies(req::SRS_EASE_004);
    const std::string page = RunCommand({"man"}).out;
    for (const CommandRow& row : CommandTable())
    {
        const std::size_t begin = page.find("\n.SS \"counterpoint " + std::string(row.name) + "\"\n");
        const std::string section = page.substr(begin, page.find("\n.S", begin + 1U) - begin);
        const DescribedCommand described = Described(row);
        for (const Option& option : described.options->All())
        {
            const std::size_t place = section.find("\n.TP\n\\fB" + Hyphened(option.name) + "\\fR");
            ASSERT_NE(place, std::string::npos) << row.name << " " << option.name;
            const std::string text = section.substr(place, section.find("\n.TP\n", place + 1U) - place);
            std::vector<std::string> wanted = ValuesOf(option);
            if (option.range)
            {
                wanted.push_back(std::to_string(option.range->first) + " to " + std::to_string(option.range->second));
            }
            for (const auto& [condition, other] :
                 {std::pair("; not beside ", option.excluded), std::pair("; only with ", option.needed)})
            {
                wanted.push_back(other.empty() ? other : condition + other);
            }
            for (const std::string& each : wanted)
            {
                EXPECT_NE(text.find(Hyphened(each)), std::string::npos) << option.name << ": " << each << "\n" << text;
            }
        }
    }
}

class ManualPageFile : public CommandTest
{
};

TEST_F(ManualPageFile, GroffHasNoWarning)
{
    Verifies(req::SRS_EASE_004);
    if (!Has("groff"))
    {
        GTEST_SKIP() << "no groff";
    }
    EXPECT_EQ(Printed("groff -man -Tascii -ww " + File("counterpoint.1", RunCommand({"man"}).out) + " >/dev/null"), "");
}
} // namespace
} // namespace counterpoint::tools
