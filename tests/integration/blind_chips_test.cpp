// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Two parties at once, of which one always says good: the rows of 'who detects whom' with a watchdog that never trips,
// a self test or flow monitor that finds nothing, and an always good channel beside a broken guard. Where nobody finds
// it, the test shows exactly that.
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <ostream>
#include <string>

namespace counterpoint::simulator
{
namespace
{
/// Who always says good from 400 ms on, and what goes wrong at 500 ms.
struct Blind
{
    const char* part;
    const char* fault;
    const char* by;
};

void PrintTo(const Blind& blind, std::ostream* const out)
{
    *out << blind.part << " always good, then " << blind.fault << ", found by " << blind.by;
}

std::string ScenarioOf(const Blind& blind)
{
    return std::string(
               "duration: 3 s\nfaults:\n  - {fault: always_good, optional: true, name: good, node: actuator, ") +
           "at: 400 ms, part: " + blind.part +
           "}\n  - {name: second, node: actuator, at: 500 ms, fault: " + blind.fault +
           "}\nexpect:\n  - {that: detected_by, node: actuator, fault: second, by: " + blind.by + "}\n";
}

class BlindAndFound : public ::testing::TestWithParam<Blind>
{
};

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

constexpr Blind kFound[] = {
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

class BlindAndHidden : public ::testing::TestWithParam<Blind>
{
};

TEST_P(BlindAndHidden, NobodyFindsItAndTheOutputStaysOpen)
{
    Verifies(req::SRS_SIM_054);
    Verifies(req::SRS_SIM_033);
    const auto run = RunChain(ScenarioOf(GetParam()) + "  - {that: released, node: actuator, srdo: 1, at: 2999 ms}\n"
                                                       "  - {that: device_fault, node: actuator, is: none}\n");
    EXPECT_EQ(Failures(*run), "");
}

constexpr Blind kHidden[] = {
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
} // namespace
} // namespace counterpoint::simulator
