// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// A party that always says that all is well is no fault as long as all is well. It takes a second fault that this party
// should have found to show who finds it instead; and what nobody finds then.
#include "tests/integration/scenario_run.hpp"
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

class BlindPartyAndFault : public ::testing::TestWithParam<BlindParty>
{
};

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

class BlindGuard : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BlindGuard, LeavesACopyThatMattersToTheComparison)
{
    Verifies(req::SRS_SIM_033);
    // When SCT of one channel becomes 34 ms, nobody rechecks it, and a pair is lost
    const auto run =
        RunChain(std::string("faults:\n  - {fault: always_good, name: good, node: actuator, part: guard, ") +
                 "at: 400 ms}\n  - {fault: bit_flip, name: flip, node: actuator, part: " + GetParam() +
                 R"(, at: 450 ms, config: {srdo: 1, field: sct}, bit: 4}
  - {fault: loss, name: lost, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 2}}
expect:
  - {that: safe_within, node: actuator, srdo: 1, fault: lost}
  - {that: detected_by, node: actuator, fault: lost, by: )" +
                 GetParam() + "}\n");
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(EachChannel, BlindGuard, ::testing::Values("channel_a", "channel_b"));

class HiddenByTheGuard : public ::testing::TestWithParam<const char*>
{
};

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
class LinkOfTheChain : public ::testing::TestWithParam<const char*>
{
};

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
} // namespace
} // namespace counterpoint::simulator
