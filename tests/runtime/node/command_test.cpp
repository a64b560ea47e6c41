// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <string>
#include <vector>

// Options of `counterpoint node`.
namespace counterpoint::tools
{
namespace
{
using NodeCommandTest = test::CommandTest;

TEST_F(NodeCommandTest, BadInputIsOneLineAndStatus2)
{
    Verifies(req::SRS_NODE_009);
    const std::string sensor = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/sensor.dcf";
    std::string text = cia306::ReadTextFile(sensor);
    text.erase(text.find("NodeID="), std::string("NodeID=1\n").size());
    const std::string unnamed = File("unnamed.dcf", text);
    const std::string bus = "udp:239.74.163.2:43117";
    const std::vector<std::vector<std::string>> calls{
        {"--dcf", sensor},
        {"--can", bus},
        {"--can", "udp:1.2.3.4:5", "--dcf", sensor},
        {"--can", "no_such_can7", "--dcf", sensor},
        {"--can", bus, "--dcf", Path("missing.dcf")},
        {"--can", bus, "--dcf", unnamed},
        {"--can", bus, "--can2", "", "--dcf", sensor},
        {"--can", "udp:\n\x1B[31m", "--dcf", sensor},
        {"--can", bus, "--dcf", sensor, "--node-id", "128"},
        {"--can", bus, "--dcf", sensor, "--cycle-us", "99"},
        {"--can", bus, "--dcf", sensor, "--cycle-us", "25001"},
        {"--can", bus, "--dcf", sensor, "--script", Path("missing.yaml")},
        {"--can", bus, "--dcf", sensor, "--script",
         File("rule.yaml", "logic: [{set: 0x2200:01, op: copy, from: [0x2000:01]}]")},
    };
    for (const std::vector<std::string>& call : calls)
    {
        std::vector<std::string> words{"node", "--no-input"};
        words.insert(words.end(), call.begin(), call.end());
        const test::Answer answer = test::RunCommand(words);
        EXPECT_EQ(answer.status, 2) << call.back();
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        EXPECT_NE(answer.err.find("expected"), std::string::npos) << answer.err;
        EXPECT_EQ(answer.out, "");
    }
}

// Given a time with which no kernel starts, then the file is refused before anything else, as check tells it; node told
// of its start, and the bus had a device that never came.
TEST_F(NodeCommandTest, ATimeThatTheKernelRefusesIsBadInput)
{
    Verifies(req::SRS_NODE_009);
    Verifies(req::SRS_NODE_711);
    const std::string sensor = cia306::test::ExampleText("sensor");
    struct Row
    {
        const char* section;
        const char* value;
        const char* wrong;
    };
    for (const Row& row :
         {Row{"5F00sub7", "5999",
              "0x5F00:07: clock tolerance interval of 5999 us, expected at least 6000 us, 4 cycles with their "
              "tolerance"},
          Row{"5F00sub5", "22",
              "0x5F00:05: test interval of 22 ms, expected at least 22500 us, 15 cycles with their tolerance"},
          Row{"5F00sub4", "2",
              "0x5F00:04: diagnostic interval of 2 ms, expected at least 3000 us, 2 cycles with their tolerance for "
              "each SRDO"}})
    {
        std::string text = cia306::test::WithValues(sensor, {{row.section, "ParameterValue", row.value}});
        const std::size_t place = text.find("ParameterValue=", text.find("[" + std::string(row.section) + "]"));
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n') + 1;
        const std::string file = File("time.dcf", text);
        const std::string told = file + ":" + std::to_string(line) + ":16: error: " + row.wrong + "\n";
        const test::Answer node = test::RunCommand(
            {"node", "--no-input", "--no-self-tests", "--can", "udp:239.74.163.2:43117", "--dcf", file});
        EXPECT_EQ(node.status, 2);
        EXPECT_EQ(node.err, told);
        EXPECT_EQ(node.out, "");
        const test::Answer simulated = test::RunCommand(
            {"simulate",
             File("s.yaml", "title: x\nduration: 10 ms\nnodes: {1: {dcf: time.dcf, self_tests: false}}\n")});
        EXPECT_EQ(simulated.status, 2);
        EXPECT_EQ(simulated.err, told);
        EXPECT_NE(test::RunCommand({"check", file}).out.find(told), std::string::npos) << row.section;
    }
}

TEST_F(NodeCommandTest, AFileWithTwoControllersNeedsBoth)
{
    Verifies(req::SRS_NODE_014);
    Verifies(req::SRS_NODE_017);
    const std::string plain = std::string(COUNTERPOINT_SOURCE) + "/tests/runtime/data/plain.dcf";
    const std::string bus = "udp:239.74.163.2:43119";
    std::string text = cia306::ReadTextFile(plain);
    const std::size_t count = text.find("DefaultValue=1", text.find("[1A00sub0]"));
    text.replace(count, std::string("DefaultValue=1").size(), "DefaultValue=254");
    const std::string mpdo = File("mpdo.dcf", text);
    const test::Answer refused = test::RunCommand({"node", "--no-input", "--can", bus, "--dcf", mpdo});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("0x1A00:00 = 254, a multiplexed PDO, which is not built, expected"), std::string::npos)
        << refused.err;
    std::string two = cia306::test::ExampleText("sensor");
    const std::size_t port = two.find("ParameterValue=", two.find("[5F00sub10]"));
    two.replace(port, two.find('\n', port) - port, "ParameterValue=2");
    const std::string quit = File("quit.yaml", "steps: [{at: 0 s, do: quit}]");
    const test::Answer one =
        test::RunCommand({"node", "--no-input", "--can", bus, "--script", quit, "--dcf", File("two.dcf", two)});
    EXPECT_EQ(one.status, 2);
    EXPECT_NE(one.err.find("expected --can2 for the second one"), std::string::npos) << one.err;
    const test::Answer none =
        test::RunCommand({"node", "--no-input", "--can", bus, "--can2", "no_such_can7", "--dcf", plain});
    EXPECT_EQ(none.status, 2);
}

// The intervals of the file are counted in its own cycles, whatever the cycle of the command line.
TEST_F(NodeCommandTest, ACycleOfTheFileThatIsNoneIsRefusedBesideOneOfTheCommandLine)
{
    Verifies(req::SRS_NODE_490);
    for (const auto& [section, value] : {std::pair("[5F00sub1]", "0"), std::pair("[5F00sub2]", "1001")})
    {
        std::string text = cia306::test::ExampleText("sensor");
        const std::size_t place = text.find("ParameterValue=", text.find(section));
        text.replace(place, text.find('\n', place) - place, std::string("ParameterValue=") + value);
        const std::string file = File("cycle.dcf", text);
        const test::Answer answer = test::RunCommand(
            {"node", "--no-input", "--can", "udp:239.74.163.2:43119", "--dcf", file, "--cycle-us", "5000"});
        EXPECT_EQ(answer.status, 2);
        EXPECT_EQ(answer.err,
                  file + ((value == std::string("0"))
                              ? ":417:16: error: 0x5F00:01: cycle time 0 us, expected 100 us to 1000000 us\n"
                              : ":426:16: error: 0x5F00:02: cycle tolerance of 1001 us, expected at most the cycle "
                                "time of 1000 us\n"));
    }
}

TEST(NodeDomainOption, HasARange)
{
    Verifies(req::SRS_NODE_040);
    for (const char* const bytes : {"0", "16777217", "-1", "8k"})
    {
        const auto answer =
            test::RunCommand({"node", "--can", "udp:239.74.163.2:43113", "--dcf", "none.dcf", "--domain-bytes", bytes});
        EXPECT_EQ(answer.status, 2) << bytes;
        EXPECT_NE(answer.err.find("--domain-bytes"), std::string::npos) << answer.err;
    }
    const std::string help = test::RunCommand({"node", "--help"}).out;
    EXPECT_NE(help.find("--domain-bytes INT:INT in [1 - 16777216]=8192"), std::string::npos) << help;
}
} // namespace
} // namespace counterpoint::tools
