// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What is strange in a DCF is told by each command that reads it, not by those alone that are asked for it.
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/monitor.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class FileWarnings : public test::CommandTest
{
  protected:
    /// A sensor with a mistyped key in line 127, beside the value that stays in force.
    [[nodiscard]] std::string Sensor() const
    {
        std::string text = cia306::test::ExampleText("sensor");
        const std::string value = "ParameterValue=100\n";
        text.insert(text.find(value) + value.size(), "ParamterValue=60\n");
        return File("sensor.dcf", text);
    }
    [[nodiscard]] std::string Warning() const
    {
        return Path("sensor.dcf") + ":127:1: warning: unknown key 'ParamterValue' (did you mean 'ParameterValue'?)";
    }
};

// Given a DCF with a mistyped key, when a command reads it, then it says so, once, whatever else it does.
TEST_F(FileWarnings, EachCommandTellsThem)
{
    Verifies(req::SRS_EDS_038);
    const std::string dcf = Sensor();
    const std::string scenario =
        File("s.yaml", "duration: 10 ms\nnodes:\n  a: {dcf: sensor.dcf}\n  b: {dcf: sensor.dcf, node_id: 2}\n");
    const std::string network = File("n.yaml", "manager: {node: 5}\nslaves:\n  - {node: 1, dcf: sensor.dcf}\n");
    const std::string log = File("bus.log", "(1.000000) can0 701#05\n");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"check", dcf},
                                               {"sign", dcf},
                                               {"generate", dcf, "--output", Path("code")},
                                               {"srdo", "list", dcf},
                                               {"node", "--dcf", dcf, "--can", "no bus"},
                                               {"simulate", scenario, "--quiet"},
                                               {"simulate", scenario, "--sweep", "seed=1:2:1"},
                                               {"monitor", log, "--dcf", dcf},
                                               {"manager", "--check", network, network}})
    {
        const Answer answer = RunCommand(arguments);
        const std::string all = answer.out + answer.err;
        const std::size_t first = all.find(Warning());
        EXPECT_NE(first, std::string::npos) << arguments.front() << ": " << all;
        EXPECT_EQ(all.find(Warning(), first + 1U), std::string::npos) << arguments.front() << ": " << all;
    }
    const Answer list = RunCommand({"srdo", "list", dcf, "--json"});
    EXPECT_EQ(nlohmann::json::parse(list.out)["warnings"].size(), 1U) << list.out;
}

/// Every command that takes a device from this file as a process of its own would; `network` and `scenario` name it.
class Limits : public test::CommandTest
{
  protected:
    [[nodiscard]] std::vector<std::vector<std::string>> Commands(const std::string& dcf, const std::string& bus) const
    {
        const std::string scenario =
            File("s.yaml", "duration: 10 ms\nnodes:\n  a: {dcf: limits.dcf}\n  b: {dcf: limits.dcf, node_id: 2}\n");
        const std::string network = File("n.yaml", "manager: {node: 5}\nslaves:\n  - {node: 1, dcf: limits.dcf}\n");
        const std::string log = File("bus.log", "(1.000000) can0 701#05\n");
        return {{"check", dcf},
                {"sign", dcf},
                {"generate", dcf, "--output", Path("code"), "--namespace", "one"},
                {"node", "--dcf", dcf, "--can", bus},
                {"simulate", scenario, "--quiet"},
                {"monitor", log, "--dcf", dcf},
                {"manager", "--check", network, network}};
    }
    /// The sensor with further keys in a section.
    [[nodiscard]] std::string Sensor(const std::string& section, const std::string& keys) const
    {
        return File("limits.dcf", cia306::test::Changed(cia306::test::ExampleText("sensor"),
                                                        {{"[" + section + "]\n", "[" + section + "]\n" + keys}}));
    }
};

// Given a safety object outside its limits, when a command takes the file, then it is refused with one message.
TEST_F(Limits, EachCommandRefusesASafetyObjectOutsideThem)
{
    Verifies(req::SRS_EDS_045);
    for (const auto& [keys, text] : std::vector<std::pair<std::string, std::string>>{
             {"HighLimit=24\n", "0x1301:02: value '25', expected at most the HighLimit '24'"},
             {"LowLimit=26\n", "0x1301:02: value '25', expected at least the LowLimit '26'"},
             {"LowLimit=low\n", "0x1301:02: limit: value 'low', expected a number from 0 to 65535 (UNSIGNED16), or "
                                "$NODEID+number"}})
    {
        for (const std::vector<std::string>& arguments : Commands(Sensor("1301sub2", keys), "udp:239.74.163.2:43113"))
        {
            const Answer answer = RunCommand(arguments);
            const std::string all = answer.out + answer.err;
            if (arguments.front() == "sign") // It signs what check refuses, and says so.
            {
                const Answer copy = RunCommand({"sign", arguments[1], "--write", Path("signed.dcf")});
                EXPECT_EQ(copy.status, 0) << copy.err;
                EXPECT_EQ(copy.err, Path("signed.dcf") + ": warning: check finds errors: 2, expected none\n");
                continue;
            }
            EXPECT_NE(all.find(text), std::string::npos) << arguments.front() << ": " << all;
            const bool is_judged = arguments.front() == "check" || arguments.front() == "generate";
            EXPECT_EQ(answer.status, is_judged ? 1 : 2) << arguments.front() << ": " << all;
        }
    }
}

// Given another integer outside its limits, when a command reads the file, then it is told, and the file is taken.
TEST_F(Limits, EachCommandTellsAnotherIntegerOutsideThem)
{
    Verifies(req::SRS_EDS_045);
    const std::string dcf = Sensor("1017", "LowLimit=200\n");
    const std::string warning =
        "limits.dcf:127:16: warning: 0x1017:00: value '100', expected at least the LowLimit '200'";
    for (const std::vector<std::string>& arguments : Commands(dcf, "no bus"))
    {
        const Answer answer = RunCommand(arguments);
        const std::string all = answer.out + answer.err;
        EXPECT_NE(all.find(warning), std::string::npos) << arguments.front() << ": " << all;
    }
    EXPECT_EQ(RunCommand({"check", dcf}).status, 0);
}

// Given a file in which check finds errors, when monitor watches an SRDO of it, then it says so once, and judges it.
TEST_F(FileWarnings, MonitorTellsWhatCheckFinds)
{
    Verifies(req::SRS_MON_490);
    using cia306::test::SignedAgain;
    using cia306::test::WithValues;
    const std::string log = File("bus.log", "(1.000000) can0 101#0102\n(1.000200) can0 102#FEFD\n");
    const auto told = [this, &log](const std::string& text, const std::string& node)
    {
        const Answer answer = RunCommand({"monitor", log, "--dcf", File("s.dcf", text) + node});
        EXPECT_EQ(answer.status, 0) << answer.err;
        return answer.err;
    };
    const std::string sensor = cia306::test::ExampleText("sensor");
    const std::string finds = "of which a device may make something else; the first: ";
    EXPECT_EQ(told(SignedAgain(WithValues(sensor, {{"5F00subA", "ParameterValue", "0"}}), std::nullopt), ""),
              Path("s.dcf") + ":498:16: warning: 0x5F00:0A: 'counterpoint check' finds 2 errors in this file, " +
                  finds + "granularity of 0 bit, expected 1, 8, 16, 32 or 64 bit\n");
    // 13FEh only repeats that there are errors
    EXPECT_NE(told(WithValues(sensor, {{"13FFsub1", "ParameterValue", "0xB632"}}), "").find("signature 0xB632"),
              std::string::npos);
    // None where check finds none, and none of the digest of another node-ID
    EXPECT_EQ(told(sensor, ""), "");
    EXPECT_EQ(told(sensor, "=90"), "");
    const std::string other_digest = WithValues(sensor, {{"5F04", "ParameterValue", "0x00000001"}});
    EXPECT_NE(told(other_digest, "").find("the first: device digest 0x00000001"), std::string::npos);
    EXPECT_EQ(told(other_digest, "=90"), "");
}

// Given two senders of one pair in the files, and both streams in one, then that is told before a violation is.
TEST_F(FileWarnings, ContradictionsAreToldBeforeAnythingIsJudged)
{
    Verifies(req::SRS_MON_020);
    const std::string sensor = cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    const std::string controller = cia306::test::SourceFolder() + "/examples/emergency_stop/controller.dcf";
    const std::string other = File("other.dcf", cia306::test::ExampleText("sensor")) + "=90";
    const std::string log = File("bus.log", "(1.000000) can0 101#0102\n(1.000200) can0 102#FEFC\n");
    std::ostringstream all;
    const ExitStatus status =
        RunCommandLine({"monitor", log, "--dcf", sensor, controller, other}, CommandTable(), {all, all});
    EXPECT_EQ(static_cast<int>(status), 1);
    const std::size_t warned = all.str().find(": warning: 0x1301:01: sends 0x101 and 0x102, which Sensor SRDO 1 sends");
    const std::size_t judged = all.str().find(" not inverse: ");
    ASSERT_NE(warned, std::string::npos) << all.str();
    ASSERT_NE(judged, std::string::npos) << all.str();
    EXPECT_LT(warned, judged);
}
} // namespace
} // namespace counterpoint::tools
