// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Scenarios of safety devices alone with keys that cannot have an effect.
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class VainKeysTest : public test::CommandTest
{
  protected:
    /// The sensor with further keys, the rest of the chain, and further sections from line 7 on.
    [[nodiscard]] Answer AnswerTo(const std::string& sensor, const std::string& sections,
                                  const std::vector<std::string>& options = {})
    {
        const std::string folder = cia306::test::SourceFolder() + "/examples/emergency_stop/";
        std::vector<std::string> words{"simulate", "--quiet"};
        words.insert(words.end(), options.begin(), options.end());
        words.push_back(File("s.yaml", "title: x\nduration: 100 ms\nnodes:\n  sensor: {dcf: " + folder + "sensor.dcf" +
                                           sensor + "}\n  controller: {dcf: " + folder +
                                           "controller.dcf}\n  actuator: {dcf: " + folder + "actuator.dcf}\n" +
                                           sections));
        return RunCommand(words);
    }
    void ExpectRefused(const std::string& sensor, const std::string& sections, const std::string& message)
    {
        const Answer answer = AnswerTo(sensor, sections);
        EXPECT_EQ(answer.status, 2) << sensor << sections;
        EXPECT_EQ(answer.err, Path("s.yaml") + message + "\n") << sensor << sections;
        EXPECT_EQ(answer.out, "") << sensor << sections;
    }
    void ExpectTaken(const std::string& sensor, const std::string& sections,
                     const std::vector<std::string>& options = {}, const std::string& warnings = "")
    {
        const Answer answer = AnswerTo(sensor, sections, options);
        EXPECT_EQ(answer.status, 0) << sensor << sections << answer.out;
        EXPECT_EQ(answer.err, warnings) << sensor << sections;
    }
};

TEST_F(VainKeysTest, AStartComesBeforeTheEndOfTheRun)
{
    Verifies(req::SRS_SIM_710);
    const std::string late = ", not before the end of the run, expected a time below 100 ms";
    ExpectRefused(", start_at: 100 ms", "", ":4:17: error: start of node 'sensor' at 100 ms" + late);
    ExpectRefused(", start_at: 5 s", "", ":4:17: error: start of node 'sensor' at 5000 ms" + late);
    ExpectRefused(", phase: 40 ms, start_at: 110 ms", "", ":4:17: error: start of node 'sensor' at 110 ms" + late);
    ExpectTaken(", start_at: 99 ms", "");
    const std::string reset = "nmt:\n  - {at: 60 ms, node: sensor, command: reset_node, start_after: ";
    ExpectRefused("", reset + "40 ms}\n", ":8:5: error: start after an NMT event at 100 ms" + late);
    ExpectTaken("", reset + "39 ms}\n");
    const std::string power = "power:\n  - {at: 60 ms, node: sensor, off: 10 ms, start_after: ";
    ExpectRefused("", power + "30 ms}\n", ":8:5: error: start after a power cycle at 100 ms" + late);
    ExpectTaken("", power + "29 ms}\n");
    // Who comes back for no start may stay off
    ExpectTaken("", "power:\n  - {at: 60 ms, node: sensor, off: 10 s}\n");
}

TEST_F(VainKeysTest, AStartThatAShorterRunDoesNotReachIsTold)
{
    Verifies(req::SRS_SIM_710);
    const auto told = [this](const std::string& what)
    { return Path("s.yaml") + ":" + what + " does not happen, expected a time before the end of the run at 50 ms\n"; };
    const std::vector<std::string> until{"--until", "50ms"};
    ExpectTaken(", start_at: 50 ms", "", until, told("4:17: warning: start of node 'sensor' at 50 ms"));
    ExpectTaken(", start_at: 49 ms", "", until);
    // The start that nobody named, and one whose reset, supply or power cycle does not come either, are told by nothing
    // more
    ExpectTaken("", "", {"--until", "5ms"});
    ExpectTaken(", phase: 50 ms, start_at: 60 ms", "", until, told("4:17: warning: node 'sensor' at 50 ms"));
    ExpectTaken("", "nmt:\n  - {at: 60 ms, node: sensor, command: reset_node, start_after: 10 ms}\n", until,
                told("8:5: warning: NMT event at 60 ms"));
    ExpectTaken("", "power:\n  - {at: 60 ms, node: sensor, off: 10 ms, start_after: 10 ms}\n", until,
                told("8:5: warning: power cycle at 60 ms"));
}
// Of two rules, or a rule and an input, of one object the last one won without a word.
TEST_F(VainKeysTest, AnObjectHasOneWriter)
{
    Verifies(req::SRS_SIM_711);
    const std::string rule = "logic:\n  - {node: controller, set: 0x2000:01, op: copy, from: [0x2200:01]}\n";
    const std::string wrong = "object 0x2000:01 of node 'controller', which the rule at " + Path("s.yaml") +
                              ":8:5 sets, expected one writer of "
                              "each object";
    ExpectRefused("", rule + "  - {node: controller, set: 0x2000:01, op: not, from: [0x2200:02]}\n",
                  ":9:5: error: a rule for " + wrong);
    ExpectRefused("", rule + "inputs:\n  - {at: 1 ms, node: controller, object: 0x2000:01, value: 3}\n",
                  ":10:5: error: an input of " + wrong);
    ExpectTaken("", rule + "  - {node: controller, set: 0x2000:02, op: not, from: [0x2200:02]}\n" +
                        "inputs:\n  - {at: 1 ms, node: sensor, object: 0x2000:01, value: 3}\n");
}
} // namespace
} // namespace counterpoint::tools
