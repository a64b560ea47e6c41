// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the self tests of a device are for: its program, its tables, its live memory, its stack, its pointers, and the
// gate that takes its permits. In each node of the demonstration.
#include "simulator/report/reports.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/selftest.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
constexpr const char* kNodes[] = {"sensor", "controller", "actuator"};

/// Times of one kind of event at one node from an instant on; -1: there is none.
Nanoseconds FirstOf(const Run& run, const EventKind kind, const std::string& node, const Nanoseconds from)
{
    for (const Event& event : run.Record().Events())
    {
        if (event.kind == kind && event.at >= from && event.node != kNoNode && run.NodeName(event.node) == node)
        {
            return event.at;
        }
    }
    return -1;
}

/// The limit of a fault of memory for the device of that name.
Nanoseconds MemoryLimit(const Run& run, const std::string& node)
{
    NodeIndex index = 0U;
    while (run.NodeName(index) != node)
    {
        ++index;
    }
    return Nanoseconds{ComputeLimit(run.ModelOf(index).Config(), SrdoTimes{}, FaultClass::kConfiguration).us} *
           kNanosecondsPerMicrosecond;
}

/// A flipped bit of what the self tests watch.
struct Flip
{
    const char* place;
    Nanoseconds cycles; ///< Within so many; 0: within the limit of a fault of memory.
    const char* by{"self_test"};
};

void PrintTo(const Flip& flip, std::ostream* const out)
{
    *out << flip.place;
}

using FlippedUnderSelfTests = ::testing::TestWithParam<std::tuple<const char*, Flip>>;

TEST_P(FlippedUnderSelfTests, IsFoundByThemInEachNodeWithinTheLimit)
{
    Verifies(req::SRS_SIM_052);
    Verifies(req::SRS_SIM_053);
    Verifies(req::SRS_STS_003);
    const std::string node = std::get<0>(GetParam());
    const Flip flip = std::get<1>(GetParam());
    // Given the released chain; when a bit flips in one of its nodes
    const auto run =
        RunChain("duration: 2200 ms\nfaults:\n  - {fault: bit_flip, at: 500.95 ms, node: " + node +
                 ", part: " + flip.place + "}\nexpect:\n  - {that: detected_by, node: " + node + ", by: " + flip.by +
                 "}\n  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 2199 ms}\n");
    EXPECT_EQ(Failures(*run), "");
    // Then that node finds it in time, by its self test unless the guard comes first, and no other node has a device
    // fault
    const Nanoseconds effect = FirstOf(*run, EventKind::kFault, node, 0);
    const Nanoseconds found = FirstOf(*run, EventKind::kDeviceFault, node, effect);
    const Nanoseconds most = (flip.cycles == 0) ? MemoryLimit(*run, node) : flip.cycles * kNanosecondsPerMillisecond;
    EXPECT_GE(found, effect);
    EXPECT_LE(found - effect, most);
    for (const char* const other : kNodes)
    {
        EXPECT_TRUE(other == node || FirstOf(*run, EventKind::kDeviceFault, other, 0) < 0) << other;
    }
}

// What digest and mappings hold as well is found by whose turn comes first.
constexpr const char* kOrTheGuard = "[self_test, guard, channels]";
constexpr Flip kFlips[] = {
    {"program, offset: 0, bit: 0", 0},
    {"program, offset: 1000, bit: 7", 0},
    {"program, offset: 2500, bit: 3", 0}, // In the virtual table of channel A.
    {"program, offset: 6000, bit: 4", 0},
    {"program", 0}, // Where the seed has it.
    {"constants, offset: 0, bit: 0", 0, kOrTheGuard},
    {"constants, offset: 35, bit: 6", 0, kOrTheGuard},
    {"setup, offset: 1, bit: 2", 0, kOrTheGuard},
    {"objects, offset: 6, bit: 0", 0, kOrTheGuard},
    {"stack_guard, offset: 0, bit: 0", 1},
    {"stack_guard, offset: 15, bit: 7", 1},
    {"table_pointer, offset: 0, bit: 3", 1},
    {"table_pointer, offset: 8, bit: 4", 1},
    {"table_pointer, offset: 16, bit: 5", 1},
    {"table_pointer, offset: 24, bit: 6", 1},
    {"table_pointer, offset: 36, bit: 7", 1},
};
INSTANTIATE_TEST_SUITE_P(EachNode, FlippedUnderSelfTests,
                         ::testing::Combine(::testing::ValuesIn(kNodes), ::testing::ValuesIn(kFlips)));

using StuckBitOfLiveMemory = ::testing::TestWithParam<std::tuple<const char*, const char*, const char*>>;

TEST_P(StuckBitOfLiveMemory, IsFoundInEachNodeWithinTheLimit)
{
    Verifies(req::SRS_SIM_053);
    Verifies(req::SRS_STS_214);
    const auto [node, part, level] = GetParam();
    const std::string place = std::string("node: ") + node + ", part: " + part + ", level: " + level;
    for (unsigned seed = 1U; seed <= 8U; ++seed)
    {
        // Given the released chain; when a bit of live memory stays at a level
        const auto run = RunChain(
            "duration: 2200 ms\nseed: " + std::to_string(seed) + "\nfaults:\n  - {fault: stuck_bit, at: 500 ms, " +
            place + "}\nexpect:\n  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 2199 ms}\n");
        EXPECT_EQ(Failures(*run), "") << seed;
        // Then the march finds it, or somebody who reads the wrong value does before; in time, counted from its
        // beginning although it may be without an effect for long
        const Nanoseconds begin = 500 * kNanosecondsPerMillisecond;
        const Nanoseconds found = FirstOf(*run, EventKind::kDeviceFault, node, begin);
        EXPECT_GE(found, begin) << seed;
        EXPECT_LE(found - begin, MemoryLimit(*run, node)) << seed;
    }
}
INSTANTIATE_TEST_SUITE_P(EachNodeAndPart, StuckBitOfLiveMemory,
                         ::testing::Combine(::testing::ValuesIn(kNodes),
                                            ::testing::Values("channel_a", "channel_b", "kernel"),
                                            ::testing::Values("0", "1")));

TEST(SelfTests, DisturbNothingForManyRounds)
{
    Verifies(req::SRS_SIM_052);
    Verifies(req::SRS_STS_012);
    const auto run = RunChain("duration: 20 s\nexpect:\n  - {that: no_fault}\n"
                              "  - {that: released, node: actuator, srdo: 1, at: 19990 ms}\n");
    EXPECT_EQ(Failures(*run), "");
}

TEST(SelfTests, FindAtTheSameTimeWhereverMemoryStands)
{
    Verifies(req::SRS_SIM_052);
    Verifies(req::SRS_SIM_003);
    const std::string text = "duration: 2 s\nseed: 9\nfaults:\n"
                             "  - {fault: stuck_bit, name: stuck, node: sensor, part: channel_b, at: 500 ms}\n"
                             "  - {fault: bit_flip, name: flip, node: actuator, part: program, at: 501 ms}\n";
    const std::string first = JsonReport(*RunChain(text, true));
    const std::vector<std::vector<char>> shift(7U, std::vector<char>(12345U)); // The next run stands elsewhere.
    EXPECT_EQ(JsonReport(*RunChain(text, true)), first);
    EXPECT_EQ(shift.size(), 7U);
}

TEST(SelfTests, ChangedProgramIsFoundByTheStartUpTest)
{
    Verifies(req::SRS_SIM_053);
    Verifies(req::SRS_STS_210);
    // Given a bit of the program that flips just before the supply goes; when it comes back
    const auto run = RunChain(R"(
duration: 2 s
power:
  - {at: 501 ms, node: actuator, off: 20 ms, start_after: 10 ms}
acknowledge:
  - {at: 800 ms, node: actuator, srdo: 1}
faults:
  - {fault: bit_flip, node: actuator, part: program, at: 500.95 ms, offset: 5000}
expect:
  - {that: device_fault, node: actuator, is: self_test}
  - {that: safe, node: actuator, srdo: 1, at: 1999 ms}
)");
    // Then nothing is released
    EXPECT_EQ(Failures(*run), "");
    EXPECT_LE(FirstOf(*run, EventKind::kDeviceFault, "actuator", 0), 523 * kNanosecondsPerMillisecond);
}

using WithoutSelfTests = ::testing::TestWithParam<const char*>;

TEST_P(WithoutSelfTests, NobodyFindsIt)
{
    Verifies(req::SRS_SIM_052);
    const auto run = RunChainWithoutSelfTests(
        std::string("duration: 3 s\nfaults:\n  - {node: actuator, at: 500 ms, fault: ") + GetParam() + R"(}
expect:
  - {that: released, node: actuator, srdo: 1, at: 2999 ms}
  - {that: detected_by, node: actuator, by: nobody}
)");
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(EachPlace, WithoutSelfTests,
                         ::testing::Values("bit_flip, part: program, offset: 0",
                                           "bit_flip, part: stack_guard, offset: 0"));

using WildPointer = ::testing::TestWithParam<const char*>;

TEST_P(WildPointer, StopsADeviceWithoutSelfTests)
{
    Verifies(req::SRS_SIM_055);
    const auto run = RunChainWithoutSelfTests(
        std::string("duration: 3 s\nfaults:\n  - {fault: bit_flip, node: actuator, part: table_pointer, at: 500 ms, ") +
        "offset: " + GetParam() + R"(}
expect:
  - {that: safe_within, node: actuator, srdo: 1, limit: supervisor}
  - {that: detected_by, node: actuator, by: watchdog}
  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}
)");
    EXPECT_EQ(Failures(*run), "");
    EXPECT_GE(FirstOf(*run, EventKind::kHung, "actuator", 0), 0);
}
INSTANTIATE_TEST_SUITE_P(EachPart, WildPointer, ::testing::Values("0", "8", "16", "24", "32"));

TEST(WildPointer, AtAnyMomentEndsInTheSafeState)
{
    Verifies(req::SRS_SIM_055);
    Verifies(req::SRS_SIM_012);
    // Given each millisecond of a refresh, that of a cycle in which pairs are sent and frames come among them
    for (unsigned millisecond = 500U; millisecond < 526U; ++millisecond)
    {
        for (const char* const node : kNodes)
        {
            const auto run = RunChain("faults:\n  - {fault: bit_flip, part: table_pointer, offset: 8, bit: 3, node: " +
                                      std::string(node) + ", at: " + std::to_string(millisecond) + R"(.3 ms}
expect:
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 990 ms}
)");
            // Then the self test finds it, or the exception stops the node before
            EXPECT_EQ(Failures(*run), "") << node << " " << millisecond;
        }
    }
}

TEST(WildPointer, OfARunningSystemIsGoneAfterAPowerCycle)
{
    Verifies(req::SRS_SIM_055);
    const auto run = RunChain(R"(
duration: 2 s
power:
  - {at: 600 ms, node: actuator, off: 20 ms, start_after: 10 ms}
acknowledge:
  - {at: 800 ms, node: actuator, srdo: 1}
faults:
  - {fault: bit_flip, node: actuator, part: table_pointer, at: 500 ms, offset: 0}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: released, node: actuator, srdo: 1, at: 1999 ms}
)");
    EXPECT_EQ(Failures(*run), "");
}

using FailingSelfTest = ::testing::TestWithParam<std::tuple<const char*, std::pair<const char*, const char*>>>;

TEST_P(FailingSelfTest, ClosesTheOutputWithinTheLimit)
{
    Verifies(req::SRS_SIM_054);
    Verifies(req::SRS_STS_213);
    const std::string node = std::get<0>(GetParam());
    const auto [kind, by] = std::get<1>(GetParam());
    const auto run = RunChain(std::string("duration: 2 s\nfaults:\n  - {fault: ") + kind +
                              ", part: self_test, at: 500 ms, node: " + node +
                              "}\nexpect:\n  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 1999 ms}\n" +
                              "  - {that: detected_by, node: " + node + ", by: " + by + "}\n");
    EXPECT_EQ(Failures(*run), "");
    const Nanoseconds found = FirstOf(*run, EventKind::kFault, node, 0);
    const EventKind what = (by == std::string("watchdog")) ? EventKind::kWatchdog : EventKind::kDeviceFault;
    EXPECT_LE(FirstOf(*run, what, node, found) - found, 2 * kNanosecondsPerMillisecond);
}
INSTANTIATE_TEST_SUITE_P(EachNodeEachWay, FailingSelfTest,
                         ::testing::Combine(::testing::ValuesIn(kNodes),
                                            ::testing::Values(std::make_pair("frozen", "flow_monitor"),
                                                              std::make_pair("not_called", "self_test"),
                                                              std::make_pair("hung", "watchdog"))));

TEST(OutputGateThatTakesEverything, IsFoundByTheSelfTest)
{
    Verifies(req::SRS_SIM_054);
    Verifies(req::SRS_STS_030);
    const std::string gate = "duration: 3 s\nfaults:\n"
                             "  - {fault: always_good, node: actuator, part: output_gate, at: 500 ms}\nexpect:\n";
    const auto run = RunChain(gate + R"(
  - {that: detected_by, node: actuator, by: self_test}
  - {that: device_fault, node: actuator, is: self_test}
)");
    EXPECT_EQ(Failures(*run), "");
    const Nanoseconds found = FirstOf(*run, EventKind::kDeviceFault, "actuator", 0);
    EXPECT_LE(found - 500 * kNanosecondsPerMillisecond, MemoryLimit(*run, "actuator"));
    // And without one by nobody: it is never asked what it must refuse
    const auto without =
        RunChainWithoutSelfTests(gate + "  - {that: released, node: actuator, srdo: 1, at: 2999 ms}\n");
    EXPECT_EQ(Failures(*without), "fault 'always_good' happens: never happened\n");
}

TEST(SelfTests, ShortDiagnosticIntervalIsRefused)
{
    Verifies(req::SRS_SIM_052);
    // 60 ms are 40 cycles that are each as late as allowed
    std::ostringstream text;
    text << std::ifstream(Examples() + "sensor.dcf").rdbuf();
    std::string dcf = text.str();
    const std::size_t at = dcf.find("ParameterValue=1000", dcf.find("[5F00sub4]"));
    dcf.replace(at, 19U, "ParameterValue=60");
    const std::string file = ::testing::TempDir() + "counterpoint_short_interval.dcf";
    std::ofstream(file, std::ios::binary) << dcf;
    const std::string scenario = TextFile("nodes:\n  sensor: {dcf: " + file + "}\nduration: 1 s\n");
    try
    {
        const simulator::Run run(scenario, std::nullopt, std::nullopt, false);
        FAIL() << "accepted";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_NE(std::string(error.what())
                      .find("the self tests do not fit into the diagnostic interval of 40 cycles, "
                            "expected a longer one (0x5F00:04), or 'self_tests: false'"),
                  std::string::npos)
            << error.what();
    }
}
} // namespace
} // namespace counterpoint::simulator
