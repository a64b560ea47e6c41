// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What is strange in a DCF is told by each command that reads it, not by those alone that are asked for it.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <string>
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
} // namespace
} // namespace counterpoint::tools
