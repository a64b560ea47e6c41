// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "tools/command_line/options.hpp"
#include "tools/command_table.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <memory>
#include <regex>
#include <string>
#include <variant>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

TEST(CommandLine, BadUsageIsOneLineThatSaysWhatIsExpected)
{
    Verifies(req::SRS_CLI_020);
    Verifies(req::SRS_CLI_001);
    const std::vector<std::vector<std::string>> lines = {
        {},
        {"frobnicate"},
        {"sign"},
        {"sign", "a.dcf", "b.dcf"},
        {"sign", "a.dcf", "--nothing"},
        {"sign", "a.dcf", "--node-id", "0"},
        {"sign", "a.dcf", "--node-id", "128"},
        {"sign", "a.dcf", "--node-id", "one"},
        {"sign", "a.dcf", "--node-id", "-1"},
        {"sign", "a.dcf", "--node-id", ""},
        {"sign", "a.dcf", "--write"},
        {"check", "a.dcf", "--granularity", "7"},
        {"check", "a.dcf", "--granularity", "8x"},
        {"check", "a.dcf", "--verbose"},
        {"sign", "a.dcf", "--node-id", "010"},
        {"check", "a.dcf", "--granularity", "010"},
        {"sign", "a.dcf", "--write", ""},
        {"sign", "a.dcf", "check", "a.dcf"},
    };
    for (const std::vector<std::string>& line : lines)
    {
        const Answer answer = RunCommand(line);
        const std::string name = line.empty() ? "" : line.back();
        EXPECT_EQ(answer.status, 2) << name;
        EXPECT_EQ(answer.out, "") << name;
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        EXPECT_EQ(answer.err.rfind("counterpoint: ", 0U), 0U) << answer.err;
        EXPECT_NE(answer.err.find("expected"), std::string::npos) << answer.err;
        EXPECT_NE(answer.err.find("--help"), std::string::npos) << answer.err;
    }
}

/// What a variable of a shell that is not set leaves of `--replay "$NUMBER"`.
TEST(CommandLine, AnEmptyValueIsRefusedByEachOptionThatTakesAText)
{
    Verifies(req::SRS_CLI_020);
    std::size_t asked = 0U;
    for (const CommandRow& row : CommandTable())
    {
        const std::unique_ptr<Command> command = row.make();
        Options options;
        command->Describe(options);
        for (const Option& option : options.All())
        {
            const std::string name = option.name.substr(option.name.rfind(',') + 1U);
            const bool is_text = std::holds_alternative<std::string*>(option.target) ||
                                 std::holds_alternative<std::vector<std::string>*>(option.target);
            if (name.rfind("--", 0U) != 0U || !is_text)
            {
                continue;
            }
            ++asked;
            const Answer answer = RunCommand({row.name, name, ""});
            EXPECT_EQ(answer.status, 2) << row.name << " " << name;
            EXPECT_NE(answer.err.find(": " + name), std::string::npos) << answer.err;
            EXPECT_NE(answer.err.find("expected"), std::string::npos) << answer.err;
        }
    }
    EXPECT_GT(asked, 50U);
    EXPECT_EQ(RunCommand({"campaign", "plan.yaml", "--replay", ""}).err,
              "counterpoint: --replay: an empty value, expected a text; expected a command line as told by "
              "'counterpoint campaign --help'\n");
}

TEST(CommandLine, AFractionIsToldToBeNone)
{
    Verifies(req::SRS_CLI_020);
    for (const std::string number : {"0.5", "1.5", "2."})
    {
        EXPECT_EQ(RunCommand({"manager", "--can", "can0", "--network", "a.yaml", "--for", number}).err,
                  "counterpoint: --for: " + number +
                      " is no whole number, expected one; expected a command line as told by 'counterpoint manager "
                      "--help'\n");
    }
}

TEST(CommandLine, UnknownCommandIsNamedBesideTheKnownOnes)
{
    Verifies(req::SRS_CLI_020);
    std::string names;
    for (const CommandRow& row : CommandTable())
    {
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    EXPECT_EQ(RunCommand({"frobnicate"}).err, "counterpoint: 'frobnicate' is no command; expected one of " + names +
                                                  " in a command line as told by 'counterpoint --help'\n");
    EXPECT_NE(names.find("demo, simulate"), std::string::npos);
}

TEST(CommandLine, HelpAndVersionHold)
{
    Verifies(req::SRS_CLI_001);
    const Answer help = RunCommand({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    for (const CommandRow& row : CommandTable())
    {
        EXPECT_NE(help.out.find(row.name), std::string::npos) << row.name;
        const Answer command_help = RunCommand({row.name, "--help"});
        EXPECT_EQ(command_help.status, 0) << row.name;
        EXPECT_NE(command_help.out.find("Exit status: 0 "), std::string::npos) << row.name;
    }
}

TEST(CommandLine, VersionIsThatOfTheProjectWithCommitAndDigestOfTheObjects)
{
    Verifies(req::SRS_CLI_024);
    const Answer answer = RunCommand({"--version"});
    EXPECT_EQ(answer.status, 0);
    const std::regex line{"counterpoint 0\\.1\\.0 \\(commit ([0-9a-f]{12}|unknown), objects [0-9a-f]{16}\\)\n"};
    EXPECT_TRUE(std::regex_match(answer.out, line)) << answer.out;
}

TEST(CommandLine, VersionStandsAlone)
{
    Verifies(req::SRS_CLI_492);
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"--version", "x"}, {"--version", "--nothing"}, {"--version", "check"}, {"x", "--version"}})
    {
        const Answer answer = RunCommand(words);
        EXPECT_EQ(answer.status, 2) << words[0] << " " << words[1];
        EXPECT_EQ(answer.out, "") << words[0] << " " << words[1];
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        const std::string& word = (words[0] == "--version") ? words[1] : words[0];
        EXPECT_NE(answer.err.find("'" + word + "'"), std::string::npos) << answer.err;
    }
    EXPECT_EQ(
        RunCommand({"--version", "x"}).err,
        "counterpoint: 'x' beside --version; expected --version alone, or a command line as told by 'counterpoint "
        "--help'\n");
}

TEST(CommandLine, TextOfTheUserIsShownWithoutControlBytes)
{
    Verifies(req::SRS_EDS_019);
    const Answer answer = RunCommand({"sign", "none\n\x1B[31m.dcf"});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err.rfind("none\\x0A\\x1B[31m.dcf: error: ", 0U), 0U) << answer.err;
}

using NodeIdOfAFile = test::CommandTest;

TEST_F(NodeIdOfAFile, IsReadAsThatOfTheOption)
{
    Verifies(req::SRS_MON_730);
    const std::string examples = cia306::test::SourceFolder() + "/examples/emergency_stop/";
    const std::string sensor = examples + "sensor.dcf";
    const std::string recording =
        File("bus.log", "(10.000000) can0 101#0102\n(10.000200) can0 102#FEFD\n(10.025000) can0 101#0102\n");
    const auto with = [&](const std::string& number)
    { return RunCommand({"monitor", recording, "--dcf", sensor + number, examples + "controller.dcf"}); };
    for (const std::string number : {"=1", "=0x1", "=0X01"})
    {
        EXPECT_EQ(with(number).out, with("").out) << number;
        EXPECT_EQ(with(number).err, with("").err) << number;
    }
    EXPECT_NE(with("=0x2").out, with("").out);
    for (const std::string number : {"010", "041", "00", "0", "128", "0x80", "0x0", "009"})
    {
        const Answer answer = with("=" + number);
        EXPECT_EQ(answer.status, 2) << number;
        EXPECT_EQ(answer.err, sensor + ": error: node-ID " + number +
                                  " in --dcf, expected 1 to 127, decimal or hexadecimal after 0x\n");
    }
    // What is no number is the name of a file
    for (const std::string name : {"=x", "=0x", "=0xg", "=0x001", "=1000", "=+5"})
    {
        EXPECT_NE(with(name).err.find("it cannot be opened"), std::string::npos) << name;
    }
}
} // namespace
} // namespace counterpoint::tools
