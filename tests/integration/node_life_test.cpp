// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <string>

namespace counterpoint::simulator
{
namespace
{
TEST(PowerCycle, ClosesTheOutputUntilSomebodyAcknowledges)
{
    Verifies(req::SRS_SIM_037);
    // When the actuator loses its supply for 100 ms
    const auto run = RunChain(R"(
power:
  - {at: 500 ms, node: actuator, off: 100 ms, start_after: 10 ms}
acknowledge:
  - {at: 800 ms, node: actuator, srdo: 1}
expect:
  - {that: released, node: actuator, srdo: 1, at: 499 ms}
  - {that: safe, node: actuator, srdo: 1, at: 500 ms}
  - {that: safe, node: actuator, srdo: 1, at: 799 ms}
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
  - {that: no_fault}
)");
    // Then it starts again with its interlock, and nobody has seen a fault
    EXPECT_EQ(Failures(*run), "");
}

TEST(PowerCycle, OfTheSensorIsALossForTheController)
{
    Verifies(req::SRS_SIM_037);
    const auto run = RunChain(R"(
power:
  - {at: 500 ms, node: sensor, off: 100 ms}
expect:
  - {that: cause, node: controller, srdo: 1, is: sct}
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 600 ms}
  - {that: safe, node: controller, srdo: 1, at: 990 ms}
)");
    // Then without a start the sensor stays pre-operational
    EXPECT_EQ(Failures(*run), "");
}

TEST(PowerCycle, EndsACallThatHangs)
{
    Verifies(req::SRS_SIM_037);
    const auto run = RunChain(R"(
faults:
  - {fault: hung, node: actuator, part: channel_b, at: 400 ms}
power:
  - {at: 500 ms, node: actuator, off: 10 ms, start_after: 10 ms}
acknowledge:
  - {at: 800 ms, node: actuator, srdo: 1}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: safe, node: actuator, srdo: 1, at: 799 ms}
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
)");
    // Then the device starts as after any power cycle, and its output stays closed until somebody acknowledges
    EXPECT_EQ(Failures(*run), "");
}

TEST(NmtCommand, IsFollowed)
{
    Verifies(req::SRS_SIM_037);
    const auto run = RunChain(R"(
nmt:
  - {at: 400 ms, node: actuator, command: stop}
  - {at: 450 ms, node: actuator, command: start}
  - {at: 600 ms, node: all, command: enter_pre_operational}
  - {at: 620 ms, node: all, command: start}
  - {at: 700 ms, node: actuator, command: reset_communication, start_after: 10 ms}
  - {at: 800 ms, node: actuator, command: reset_node, start_after: 10 ms}
acknowledge:
  - {at: 500 ms, node: actuator, srdo: 1}
  - {at: 900 ms, node: actuator, srdo: 1}
expect:
  - {that: safe, node: actuator, srdo: 1, at: 405 ms}
  - {that: safe, node: actuator, srdo: 1, at: 499 ms}
  - {that: released, node: actuator, srdo: 1, at: 590 ms}
  - {that: safe, node: actuator, srdo: 1, at: 605 ms}
  - {that: safe, node: actuator, srdo: 1, at: 705 ms}
  - {that: safe, node: actuator, srdo: 1, at: 899 ms}
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
  - {that: device_fault, node: actuator, is: none}
)");
    EXPECT_EQ(Failures(*run), "");
}

/// The chain with a second controller for the inverse frames of each node.
std::string TwoControllers(const std::string& more)
{
    const std::string folder = Examples();
    return "duration: 1000 ms\nnodes:\n  sensor: {dcf: " + folder + "sensor.dcf, controllers: 2, phase: 130 us}\n" +
           "  controller: {dcf: " + folder + "controller.dcf, controllers: 2, phase: 470 us}\n" +
           "  actuator: {dcf: " + folder + "actuator.dcf, controllers: 2, phase: 810 us}\n" + R"(
inputs:
  - {at: 20 ms, node: sensor, object: 0x2000:01, value: 1}
  - {at: 20 ms, node: sensor, object: 0x2000:02, value: 1}
logic:
  - {node: controller, set: 0x2000:01, op: and, from: [0x2200:01, 0x2200:02]}
  - {node: controller, set: 0x2000:02, op: or, from: [0x2200:01, 0x2200:02]}
acknowledge:
  - {at: 150 ms, node: actuator, srdo: 1}
)" + more;
}

std::string FailuresOf(const std::string& scenario)
{
    simulator::Run run(TextFile(scenario), std::nullopt, std::nullopt, false);
    run.Simulate(nullptr);
    return Failures(run);
}

TEST(TwoControllers, CarryNormalAndInverseFrames)
{
    Verifies(req::SRS_SIM_036);
    EXPECT_EQ(FailuresOf(TwoControllers("expect:\n  - {that: released, node: actuator, srdo: 1, at: 990 ms}\n"
                                        "  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 990 ms}\n"
                                        "  - {that: no_fault}\n")),
              "");
}

TEST(TwoControllers, FailOneByOne)
{
    Verifies(req::SRS_SIM_036);
    // When only the inverse frames' controller of the sender, or of the receiver, is gone: the normal frame comes alone
    for (const char* const fault : {"bus_off, node: controller, controller: 2, at: 500 ms",
                                    "unplugged, node: actuator, controller: 2, at: 500 ms",
                                    "loss, frames: {receiver: actuator, controller: 2, from: 500 ms, count: 1000}"})
    {
        EXPECT_EQ(FailuresOf(TwoControllers(
                      std::string("faults:\n  - {fault: ") + fault +
                      "}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1, limit: bus_next_normal}\n" +
                      "  - {that: cause, node: actuator, srdo: 1, is: srvt}\n")),
                  "")
            << fault;
    }
}

struct MemoryCase
{
    const char* place;
    const char* device_fault;
};

using FlippedMemory = ::testing::TestWithParam<MemoryCase>;

TEST_P(FlippedMemory, IsFound)
{
    Verifies(req::SRS_SIM_035);
    // When one bit flips there, in devices without self tests, which may find it first
    const auto run = RunChainWithoutSelfTests(
        std::string("duration: 2500 ms\nfaults:\n  - {fault: bit_flip, node: actuator, at: 500.2 ms, part: ") +
        GetParam().place + "}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n" +
        "  - {that: device_fault, node: actuator, is: " + GetParam().device_fault + "}\n");
    EXPECT_EQ(Failures(*run), "");
}

constexpr MemoryCase kFound[] = {
    {"latch, offset: 0, bit: 0", "latch_corrupted"}, {"latch, offset: 7, bit: 7", "latch_corrupted"},
    {"guard, offset: 0, bit: 3", "guard"},           {"objects, offset: 0, bit: 0", "configuration"},
    {"kernel, offset: 24, bit: 0", "disagreement"},
};
INSTANTIATE_TEST_SUITE_P(EachPlace, FlippedMemory, ::testing::ValuesIn(kFound));

TEST(FlippedMemoryAnywhere, NeverLetsTheActuatorMoveAgainstTheButton)
{
    Verifies(req::SRS_SIM_035);
    // Given a bit of each part that the seed chooses, and a button that is pressed 100 ms later
    for (const char* const part : {"kernel", "latch", "comparator", "flow_monitor", "guard", "clocks", "setup",
                                   "safe_value", "objects", "variables"})
    {
        for (int seed = 1; seed <= 20; ++seed)
        {
            const auto run = RunChain(std::string("faults:\n  - {fault: bit_flip, node: actuator, at: 500 ms, part: ") +
                                      part + R"(}
inputs:
  - {at: 600 ms, node: sensor, object: 0x2000:01, value: 0}
expect:
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 999 ms}
seed: )" + std::to_string(seed) + "\n");
            EXPECT_EQ(Failures(*run), "") << part << " seed " << seed;
        }
    }
}

TEST(FlippedMemoryAnywhere, InTheRecordOfARunningLatchChangesNothing)
{
    Verifies(req::SRS_SIM_035);
    const auto run = RunChain(R"(
faults:
  - {fault: bit_flip, node: actuator, part: latch, offset: 8, bit: 0, at: 500 ms}
expect:
  - {that: device_fault, node: actuator, is: none}
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(CutOff, IsToldWithItsPlace)
{
    Verifies(req::SRS_SIM_016);
    // Given a run that is shorter than what the extended scenario and its own file want
    const std::string file = TextFile("extends: " + Examples() + "chain.yaml\ninputs:\n" +
                                      "  - {at: 600 ms, node: sensor, object: 0x2000:01, value: 0}\n");
    simulator::Run run(file, std::nullopt, 100 * kNanosecondsPerMillisecond, false);
    run.Simulate(nullptr);
    // Then both are told, and the scenario's own file may not do so by itself
    ASSERT_EQ(run.Findings().size(), 2U);
    EXPECT_EQ(
        run.Findings()[0U],
        file + ":3:5: warning: input at 600 ms does not happen, expected a time before the end of the run at 100 ms");
    EXPECT_NE(run.Findings()[1U].find("chain.yaml:24:5: warning: acknowledge at 150 ms does not happen"),
              std::string::npos);
}

TEST(CutOff, IsToldOfEachThingThatHappensNoMore)
{
    Verifies(req::SRS_SIM_016);
    // Given a scenario of 1 s with one of each at 900 ms, and one that extends it and ends after 500 ms
    const std::string longer = TextFile("duration: 1 s\nnodes:\n  sensor: {dcf: " + Examples() +
                                            "sensor.dcf}\n  actuator: {dcf: " + Examples() + R"(actuator.dcf}
inputs: [{at: 900 ms, node: sensor, object: 0x2000:01, value: 1}]
acknowledge: [{at: 900 ms, node: actuator, srdo: 1}]
nmt: [{at: 900 ms, node: actuator, command: stop}]
power: [{at: 900 ms, node: actuator, off: 10 ms}]
gfc: [{at: 900 ms, node: sensor}]
faults: [{fault: unplugged, name: gone, node: sensor, at: 900 ms}]
)",
                                        ".longer.yaml");
    simulator::Run run(TextFile("extends: " + longer + "\nduration: 500 ms\n"), std::nullopt, std::nullopt, false);
    run.Simulate(nullptr);
    // Then each is told with its place, and nothing is refused
    std::string told;
    for (const std::string& finding : run.Findings())
    {
        EXPECT_EQ(finding.rfind(longer + ":", 0U), 0U) << finding;
        told += finding.substr(std::min(finding.size(), longer.size())) + "\n";
    }
    for (const char* const line :
         {":5:10: warning: input at 900 ms does not happen", ":6:15: warning: acknowledge at 900 ms does not happen",
          ":7:7: warning: NMT event at 900 ms does not happen", ":8:9: warning: power cycle at 900 ms does not happen",
          ":9:7: warning: GFC event at 900 ms does not happen",
          ":10:10: warning: fault 'gone' at 900 ms does not happen"})
    {
        EXPECT_NE(told.find(line), std::string::npos) << line << "\n" << told;
    }
}
} // namespace
} // namespace counterpoint::simulator
