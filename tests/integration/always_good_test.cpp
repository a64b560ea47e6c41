// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A party that always says that all is well is no fault as long as all is well. It takes a second fault that this party
// should have found to show who finds it instead; and what nobody finds then.
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <ostream>
#include <string>

namespace counterpoint::simulator
{
namespace
{

/// The party that always says good, and the fault that it should have found.
struct BlindParty
{
    const char* part;
    const char* fault;
    const char* by;
};

void PrintTo(const BlindParty& blind, std::ostream* const out)
{
    *out << blind.part << " always good, then " << blind.fault << ", found by " << blind.by;
}

using BlindPartyAndFault = ::testing::TestWithParam<BlindParty>;

TEST_P(BlindPartyAndFault, IsFoundByAnotherPartyWithinTheLimitOfTheFault)
{
    Verifies(req::SRS_SIM_033);
    Verifies(req::SRS_SIM_031);
    // Given the released chain with a party that always says good from 400 ms on; when it should have found this
    const auto run = RunChain(
        std::string("duration: 3 s\nfaults:\n  - {fault: always_good, name: good, node: actuator, ") +
        "part: " + GetParam().part + ", at: 400 ms}\n  - {name: second, fault: " + GetParam().fault + "}\n" + R"(
expect:
  - {that: safe_within, node: actuator, srdo: 1, fault: second}
  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}
  - {that: detected_by, node: actuator, fault: second, by: )" +
        GetParam().by + "}\n");
    // Then somebody else does, in time
    EXPECT_EQ(Failures(*run), "");
}

constexpr BlindParty kBlindParties[] = {
    // A channel: the other one.
    {"channel_a", "loss, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 1000}", "channel_b"},
    {"channel_b", "loss, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 1000}", "channel_a"},
    {"channel_a", "corruption, frames: {identifier: 0x104, from: 500 ms, count: 1000}, bits: [0]", "channel_b"},
    {"channel_b", "corruption, frames: {identifier: 0x104, from: 500 ms, count: 1000}, bits: [0]", "channel_a"},
    // The comparator: marks of the flow, permits, or the deliberate difference.
    {"comparator", "skipped, node: actuator, part: channel_a, at: 500 ms, count: 1", "flow_monitor"},
    {"comparator", "skipped, node: actuator, part: channel_b, at: 500 ms, count: 1", "flow_monitor"},
    {"comparator", "frozen, node: actuator, part: channel_a, at: 500 ms", "flow_monitor"},
    {"comparator", "frozen, node: actuator, part: channel_b, at: 500 ms", "flow_monitor"},
    // The flow monitor: whoever needs the answer of the call that was left out.
    {"flow_monitor", "skipped, node: actuator, part: channel_a, at: 500 ms, count: 1", "comparator"},
    {"flow_monitor", "skipped, node: actuator, part: channel_b, at: 500 ms, count: 1", "comparator"},
    {"flow_monitor", "frozen, node: actuator, part: channel_a, at: 500 ms", "comparator"},
    {"flow_monitor", "frozen, node: actuator, part: channel_b, at: 500 ms", "comparator"},
    {"flow_monitor", "not_called, node: actuator, part: comparator, at: 500 ms", "kernel"},
    {"flow_monitor", "frozen, node: actuator, part: comparator, at: 500 ms", "kernel"},
    {"flow_monitor", "not_called, node: actuator, part: guard, at: 500 ms", "channels"},
    {"flow_monitor", "frozen, node: actuator, part: guard, at: 500 ms", "channels"},
};
INSTANTIATE_TEST_SUITE_P(EachParty, BlindPartyAndFault, ::testing::ValuesIn(kBlindParties));

/// Whose copy of SCT is flipped, and who finds a lost pair.
struct FlippedCopy
{
    const char* part;
    const char* by;
};

class BlindGuard : public ::testing::TestWithParam<FlippedCopy>
{
};

TEST_P(BlindGuard, LeavesACopyThatMattersToTheComparison)
{
    Verifies(req::SRS_SIM_033);
    // When SCT of one channel becomes 34 ms, nobody rechecks it, and a pair is lost: channel A judges by its copy and
    // is early, channel B by what it took when OPERATIONAL was entered
    const auto run =
        RunChain(std::string("faults:\n  - {fault: always_good, name: good, node: actuator, part: guard, ") +
                 "at: 400 ms}\n  - {fault: bit_flip, name: flip, node: actuator, part: " + GetParam().part +
                 R"(, at: 450 ms, config: {srdo: 1, field: sct}, bit: 4}
  - {fault: loss, name: lost, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 2}}
expect:
  - {that: safe_within, node: actuator, srdo: 1, fault: lost}
  - {that: detected_by, node: actuator, fault: lost, by: )" +
                 GetParam().by + "}\n");
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(EachChannel, BlindGuard,
                         ::testing::Values(FlippedCopy{"channel_a", "channel_a"},
                                           FlippedCopy{"channel_b", "channels"}));

using HiddenByTheGuard = ::testing::TestWithParam<const char*>;

TEST_P(HiddenByTheGuard, IsFoundByNobody)
{
    Verifies(req::SRS_SIM_033);
    // When something changes that is of no effect as long as pairs come, or changes both channels alike, and the guard
    // does not look, in a device without self tests
    const auto run = RunChainWithoutSelfTests(
        std::string("duration: 3 s\nfaults:\n  - {fault: always_good, name: good, node: actuator, "
                    "part: guard, at: 400 ms}\n  - {name: hidden, optional: true, fault: ") +
        GetParam() + R"(}
expect:
  - {that: released, node: actuator, srdo: 1, at: 2999 ms}
  - {that: device_fault, node: actuator, is: none}
)");
    // Then nobody can tell: a listed limit
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(
    EachChange, HiddenByTheGuard,
    ::testing::Values("bit_flip, node: actuator, part: safe_value, at: 500 ms, offset: 0, bit: 0",
                      "bit_flip, node: actuator, part: channel_a, at: 500 ms, config: {srdo: 1, field: sct}, bit: 4",
                      "bit_flip, node: actuator, part: channel_b, at: 500 ms, config: {srdo: 1, field: sct}, bit: 4"));

TEST(BlindComparator, IsFoundByItsTestWithoutAnyOtherFault)
{
    Verifies(req::SRS_SIM_022);
    Verifies(req::SRS_SIM_031);
    const auto run = RunChain(R"(
duration: 3 s
faults:
  - {fault: always_good, node: actuator, part: comparator, at: 500 ms}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: device_fault, node: actuator, is: comparator}
  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}
)");
    EXPECT_EQ(Failures(*run), "");
}

/// A link of the chain that is no part of the kernel, and what happens to it.
using LinkOfTheChain = ::testing::TestWithParam<const char*>;

TEST_P(LinkOfTheChain, FailsAndTheOutputIsSafeWithinTheComputedLimit)
{
    Verifies(req::SRS_SIM_029);
    Verifies(req::SRS_SIM_031);
    Verifies(req::SRS_SIM_032);
    Verifies(req::SRS_SIM_034);
    const auto run =
        RunChain(std::string("duration: 3 s\nfaults:\n  - {node: actuator, at: 500 ms, fault: ") + GetParam() + R"(}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}
)");
    EXPECT_EQ(Failures(*run), "");
}

// Not given, frozen, wrong: permits, watchdog, challenge and question, clocks.
INSTANTIATE_TEST_SUITE_P(EachWay, LinkOfTheChain,
                         ::testing::Values("permit, party: a, how: missing", "permit, party: a, how: old",
                                           "permit, party: a, how: wrong", "permit, party: b, how: missing",
                                           "permit, party: b, how: old", "permit, party: b, how: wrong",
                                           "permit, party: kernel, how: missing", "permit, party: kernel, how: old",
                                           "permit, party: kernel, how: wrong", "watchdog, how: not_served",
                                           "watchdog, how: served_twice", "watchdog, how: wrong_answer",
                                           "watchdog, how: old_answer", "frozen_input, input: challenge",
                                           "frozen_input, input: question", "clock, counter: a, ppm: -1000000",
                                           "clock, counter: b, ppm: -1000000", "clock, counter: a, ppm: 100000",
                                           "clock, counter: b, ppm: 100000", "clock, counter: a, ppm: -100000",
                                           "clock, counter: b, ppm: -100000"));

TEST(BothCountersStopped, IsFoundByNobody)
{
    Verifies(req::SRS_SIM_023);
    // When both counters stand still at once while the cycles go on: the counters are compared with each other only
    const auto run = RunChain(R"(
faults:
  - {fault: clock, node: actuator, counter: both, ppm: -1000000, at: 500 ms}
expect:
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
  - {that: device_fault, node: actuator, is: none}
)");
    // Then nobody can tell: a listed limit, two counters must not have one cause of failure
    EXPECT_EQ(Failures(*run), "");
}

/// With this party that always says good from 400 ms on, and this at 500 ms.
std::string ScenarioOf(const BlindParty& blind)
{
    return std::string(
               "duration: 3 s\nfaults:\n  - {fault: always_good, optional: true, name: good, node: actuator, ") +
           "at: 400 ms, part: " + blind.part +
           "}\n  - {name: second, node: actuator, at: 500 ms, fault: " + blind.fault +
           "}\nexpect:\n  - {that: detected_by, node: actuator, fault: second, by: " + blind.by + "}\n";
}

using BlindAndFound = ::testing::TestWithParam<BlindParty>;

TEST_P(BlindAndFound, SomebodyElseFindsItWithinTheLimit)
{
    Verifies(req::SRS_SIM_054);
    Verifies(req::SRS_SIM_033);
    Verifies(req::SRS_SIM_031);
    const auto run =
        RunChain(ScenarioOf(GetParam()) + "  - {that: safe_within, node: actuator, srdo: 1, fault: second}\n"
                                          "  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}\n");
    EXPECT_EQ(Failures(*run), "");
}

constexpr BlindParty kFound[] = {
    // A channel that says good beside a guard that gives no token or an old one: the other channel says so.
    {"channel_a", "frozen, part: guard", "channels"},
    {"channel_b", "frozen, part: guard", "channels"},
    {"channel_a", "not_called, part: guard", "channels"},
    {"channel_b", "not_called, part: guard", "channels"},
    {"channel_a", "hung, part: guard", "watchdog"},
    {"channel_b", "hung, part: guard", "watchdog"},
    // A channel that says good with a changed copy of its own: the guard has both give the signature.
    {"channel_a", "bit_flip, part: channel_a, config: {srdo: 1, field: sct}, bit: 4", "guard"},
    {"channel_b", "bit_flip, part: channel_b, config: {srdo: 1, field: sct}, bit: 4", "guard"},
    // A watchdog that never trips: whatever takes the permits away.
    {"watchdog", "standstill", "output_gate"},
    {"watchdog", "hung, part: flow_monitor", "output_gate"},
    {"watchdog", "hung, part: channel_a", "output_gate"},
    {"watchdog", "hung, part: self_test", "output_gate"},
    {"watchdog", "skipped, part: channel_a, count: 1", "comparator"},
    {"watchdog", "frozen, part: channel_b", "comparator"},
    {"watchdog", "not_called, part: comparator", "kernel"},
    {"watchdog", "frozen, part: self_test", "flow_monitor"},
    // A flow monitor that says good beside a self test that is not called: the kernel hears that no part is sound.
    {"flow_monitor", "not_called, part: self_test", "self_test"},
    // A self test that finds nothing beside a pointer to nowhere: the exception stops the node.
    {"self_test", "bit_flip, part: table_pointer, offset: 0", "watchdog"},
    {"self_test", "bit_flip, part: table_pointer, offset: 24", "watchdog"},
    // And beside what the digest holds: the guard.
    {"self_test", "bit_flip, part: constants, offset: 32", "channels"},
    {"self_test", "bit_flip, part: safe_value, offset: 0", "guard"},
};
INSTANTIATE_TEST_SUITE_P(EachPair, BlindAndFound, ::testing::ValuesIn(kFound));

using BlindAndHidden = ::testing::TestWithParam<BlindParty>;

TEST_P(BlindAndHidden, NobodyFindsItAndTheOutputStaysOpen)
{
    Verifies(req::SRS_SIM_054);
    Verifies(req::SRS_SIM_033);
    const auto run = RunChain(ScenarioOf(GetParam()) + "  - {that: released, node: actuator, srdo: 1, at: 2999 ms}\n"
                                                       "  - {that: device_fault, node: actuator, is: none}\n");
    EXPECT_EQ(Failures(*run), "");
}

constexpr BlindParty kHidden[] = {
    // The watchdog alone reads the answer of the flow monitor.
    {"watchdog", "frozen, part: flow_monitor", "nobody"},
    {"watchdog", "not_called, part: flow_monitor", "nobody"},
    {"watchdog", "watchdog, how: not_served", "nobody"},
    {"watchdog", "frozen_input, input: question", "nobody"},
    // The flow monitor alone notices that the self test repeats itself.
    {"flow_monitor", "frozen, part: self_test", "nobody"},
    // The self test alone reads the program and the guard words.
    {"self_test", "bit_flip, part: program, offset: 1000", "nobody"},
    {"self_test", "bit_flip, part: stack_guard, offset: 0", "nobody"},
};
INSTANTIATE_TEST_SUITE_P(EachPair, BlindAndHidden, ::testing::ValuesIn(kHidden));

TEST(WatchdogThatNeverTrips, IsFoundByNobodyAndHidesNothingAlone)
{
    Verifies(req::SRS_SIM_054);
    const auto run = RunChain("duration: 3 s\nfaults:\n"
                              "  - {fault: always_good, node: actuator, part: watchdog, at: 400 ms}\nexpect:\n"
                              "  - {that: released, node: actuator, srdo: 1, at: 2999 ms}\n  - {that: no_fault}\n");
    // Then a whole device never asks it to do what it cannot: a start-up test of the hardware has to
    EXPECT_EQ(Failures(*run), "fault 'always_good' happens: never happened\n");
}

/// One party that fails in one way, at one of several moments of the cycle and of the refresh.
struct LonelyFailure
{
    const char* part;
    const char* fault; ///< Kind and what belongs to it.
    const char* at;
};

void PrintTo(const LonelyFailure& failure, std::ostream* const out)
{
    *out << failure.part << " " << failure.fault << " at " << failure.at;
}

using SingleParty = ::testing::TestWithParam<LonelyFailure>;

TEST_P(SingleParty, FailsAndTheOutputIsSafeWithinTheComputedLimit)
{
    Verifies(req::SRS_SIM_026);
    Verifies(req::SRS_SIM_021);
    Verifies(req::SRS_SIM_022);
    Verifies(req::SRS_SIM_025);
    Verifies(req::SRS_SIM_031);
    Verifies(req::SRS_LIM_001);
    // Given the released chain; when one party of the actuator fails
    const std::string part = GetParam().part;
    const auto run = RunChain("duration: 3 s\nfaults:\n  - {fault: " + std::string(GetParam().fault) +
                              ", node: actuator, part: " + part + ", at: " + GetParam().at + "}\n" + R"(
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}
)");
    // Then the output stage closes within the limit and stays closed
    EXPECT_EQ(Failures(*run), "");
}

constexpr LonelyFailure kFailures[] = {
    {"channel_a", "skipped", "500 ms"},
    {"channel_a", "skipped", "511.7 ms"},
    {"channel_a", "skipped, count: 1", "500.3 ms"},
    {"channel_a", "doubled, count: 1", "500.3 ms"},
    {"channel_a", "frozen", "500 ms"},
    {"channel_a", "frozen", "511.65 ms"},
    {"channel_a", "hung", "500 ms"},
    {"channel_a", "hung", "511.9 ms"},
    {"channel_a", "skipped, call: OnFrame", "500 ms"},
    {"channel_a", "skipped, call: OnFrame", "503.1 ms"},
    {"channel_a", "doubled, call: OnFrame", "500 ms"},
    {"channel_b", "skipped", "500 ms"},
    {"channel_b", "skipped", "511.7 ms"},
    {"channel_b", "skipped, count: 1", "500.3 ms"},
    {"channel_b", "doubled, count: 1", "500.3 ms"},
    {"channel_b", "frozen", "500 ms"},
    {"channel_b", "frozen", "511.65 ms"},
    {"channel_b", "hung", "500 ms"},
    {"channel_b", "hung", "511.9 ms"},
    {"channel_b", "skipped, call: OnFrame", "500 ms"},
    {"channel_b", "skipped, call: OnFrame", "503.1 ms"},
    {"channel_b", "doubled, call: OnFrame", "500 ms"},
    {"comparator", "not_called", "500 ms"},
    {"comparator", "not_called", "511.7 ms"},
    {"comparator", "frozen", "500 ms"},
    {"comparator", "frozen", "511.7 ms"},
    {"comparator", "always_good", "500 ms"},
    {"comparator", "always_good", "1000.1 ms"},
    {"comparator", "hung", "500 ms"},
    {"flow_monitor", "not_called", "500 ms"},
    {"flow_monitor", "frozen", "500 ms"},
    {"flow_monitor", "hung", "500 ms"},
    {"flow_monitor", "frozen", "733.3 ms"},
    {"guard", "not_called", "500 ms"},
    {"guard", "frozen", "500 ms"},
    {"guard", "frozen", "733.3 ms"},
    {"guard", "hung", "500 ms"},
};

INSTANTIATE_TEST_SUITE_P(EachPartyEachWay, SingleParty, ::testing::ValuesIn(kFailures));
} // namespace
} // namespace counterpoint::simulator
