// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <ostream>
#include <set>
#include <string>

namespace counterpoint::simulator
{
namespace
{
/// A fault at or before the actuator's SRDO 1, and who says what about it.
struct KindCase
{
    const char* name;
    const char* fault;
    const char* by;
    const char* more; ///< Another expectation, or "".
};

void PrintTo(const KindCase& kind, std::ostream* const out)
{
    *out << kind.name;
}

std::string ScenarioOf(const KindCase& kind)
{
    return std::string("faults:\n  - {") + kind.fault +
           "}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n" +
           "  - {that: detected_by, node: actuator, by: " + kind.by + "}\n" + kind.more;
}

using FaultOfControllers = ::testing::TestWithParam<KindCase>;

TEST_P(FaultOfControllers, EndsInTheSafeStateWithinTheLimit)
{
    Verifies(req::SRS_SIM_027);
    Verifies(req::SRS_SIM_031);
    // Given the released chain; when the fault comes at 500 ms; then the named party sees it and the output is safe in
    // time
    EXPECT_EQ(Failures(*RunChain(ScenarioOf(GetParam()))), "");
}

constexpr KindCase kControllerFaults[] = {
    {"bus-off", "fault: bus_off, node: controller, at: 500 ms, until: 600 ms", "channels",
     "  - {that: cause, node: controller, srdo: 2, is: bus_off}\n"},
    {"unplugged", "fault: unplugged, node: controller, at: 500 ms, until: 600 ms", "channels",
     "  - {that: cause, node: actuator, srdo: 1, is: sct}\n"},
    {"babbling", "fault: babbling, at: 500 ms, identifier: 0x002", "channels",
     "  - {that: cause, node: actuator, srdo: 1, is: sct}\n"},
    {"babbling with a name that is taken", "fault: babbling, at: 500 ms, identifier: 0x103, data: [1]", "channels",
     "  - {that: cause, node: actuator, srdo: 1, is: length}\n"},
    {"transmit queue full", "fault: queue_full, frames: {identifier: 0x103, from: 500 ms, count: 100}", "channels",
     "  - {that: cause, node: controller, srdo: 2, is: transmit_queue}\n"},
    {"inverse frame swallowed", "fault: swallowed, frames: {identifier: 0x104, from: 500 ms}", "channels",
     "  - {that: cause, node: controller, srdo: 2, is: no_confirmation}\n"},
    {"no confirmation", "fault: confirmation, frames: {identifier: 0x103, from: 500 ms, count: 100}", "channels",
     "  - {that: cause, node: controller, srdo: 2, is: no_confirmation}\n"},
    {"late confirmation",
     "fault: confirmation, how: late, by: 30 ms, frames: {identifier: 0x103, from: 500 ms, count: 100}", "channels",
     "  - {that: cause, node: controller, srdo: 2, is: no_confirmation}\n"},
    {"wrong confirmation",
     "fault: confirmation, how: wrong, bits: [0], frames: {identifier: 0x103, from: 500 ms, count: 100}", "channels",
     "  - {that: cause, node: controller, srdo: 2, is: wrong_echo}\n"},
    {"destroyed on the wire", "fault: wire_error, frames: {identifier: 0x103, from: 500 ms, count: 1000}", "channels",
     "  - {that: cause, node: actuator, srdo: 1, is: sct}\n"},
    {"reception queue overflows", "fault: queue_overflow, node: actuator, at: 500 ms", "channels",
     "  - {that: cause, node: actuator, srdo: 1, is: queue_overflow}\n"},
    {"kept beyond SCT",
     "fault: store_and_forward, by: 60 ms, gap: 1 ms, frames: {receiver: actuator, from: 500 ms, count: 1000}",
     "channels", "  - {that: cause, node: actuator, srdo: 1, is: sct}\n"},
    {"duplicate of a normal frame", "fault: duplicate, frames: {identifier: 0x103, from: 500 ms}, after: 3 ms",
     "channels", ""},
    {"duplicate of an inverse frame", "fault: duplicate, frames: {identifier: 0x104, from: 500 ms}, after: 3 ms",
     "channels", "  - {that: cause, node: actuator, srdo: 1, is: inverse_first}\n"},
};
INSTANTIATE_TEST_SUITE_P(EachKind, FaultOfControllers, ::testing::ValuesIn(kControllerFaults));

using FaultOfAPartOrInput = ::testing::TestWithParam<KindCase>;

TEST_P(FaultOfAPartOrInput, EndsInTheSafeStateWithinTheLimit)
{
    Verifies(req::SRS_SIM_029);
    Verifies(req::SRS_SIM_032);
    Verifies(req::SRS_SIM_033);
    Verifies(req::SRS_SIM_034);
    EXPECT_EQ(Failures(*RunChain(ScenarioOf(GetParam()))), "");
}

constexpr KindCase kPartFaults[] = {
    {"counter A jumps forward", "fault: clock, node: actuator, counter: a, jump: 10 ms, at: 500 ms", "clock_supervisor",
     "  - {that: device_fault, node: actuator, is: clock}\n"},
    {"counter A jumps back", "fault: clock, node: actuator, counter: a, jump: -10 ms, at: 500 ms", "clock_supervisor",
     ""},
    {"counter B jumps forward", "fault: clock, node: actuator, counter: b, jump: 10 ms, at: 500 ms", "clock_supervisor",
     "  - {that: device_fault, node: actuator, is: clock}\n"},
    {"counter B jumps back", "fault: clock, node: actuator, counter: b, jump: -10 ms, at: 500 ms", "clock_supervisor",
     ""},
    {"both counters jump back", "fault: clock, node: actuator, counter: both, jump: -3 ms, at: 500 ms",
     "clock_supervisor", ""},
    {"both counters jump forward", "fault: clock, node: actuator, counter: both, jump: 3 ms, at: 500 ms",
     "clock_supervisor", ""},
    {"challenge frozen", "fault: frozen_input, input: challenge, node: actuator, at: 500 ms", "output_gate", ""},
    {"question frozen", "fault: frozen_input, input: question, node: actuator, at: 500 ms", "watchdog", ""},
    {"permit of A wrong", "fault: permit, party: a, how: wrong, node: actuator, at: 500 ms", "output_gate", ""},
    {"permit of B old", "fault: permit, party: b, how: old, node: actuator, at: 500 ms", "output_gate", ""},
    {"permit of the kernel missing", "fault: permit, party: kernel, node: actuator, at: 500 ms", "output_gate", ""},
    {"watchdog not served", "fault: watchdog, node: actuator, at: 500 ms", "watchdog", ""},
    {"watchdog served twice", "fault: watchdog, how: served_twice, node: actuator, at: 500 ms", "watchdog", ""},
    {"wrong answer", "fault: watchdog, how: wrong_answer, node: actuator, at: 500 ms", "watchdog", ""},
    {"old answer", "fault: watchdog, how: old_answer, node: actuator, at: 500 ms", "watchdog", ""},
    {"channel A not called", "fault: not_called, part: channel_a, node: actuator, at: 500 ms", "comparator", ""},
    {"channel B not called", "fault: not_called, part: channel_b, node: actuator, at: 500 ms", "comparator", ""},
};
INSTANTIATE_TEST_SUITE_P(EachKind, FaultOfAPartOrInput, ::testing::ValuesIn(kPartFaults));

TEST(StoreAndForward, WithinSctIsNotSeen)
{
    Verifies(req::SRS_SIM_027);
    // When every frame is kept for 20 ms and let go in order
    const auto run = RunChain(R"(
faults:
  - {fault: store_and_forward, frames: {receiver: actuator, from: 500 ms, count: 1000}, by: 20 ms, gap: 100 us}
expect:
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
  - {that: detected_by, node: actuator, by: nobody}
  - {that: no_fault}
)");
    // Then nothing can tell: a listed limit
    EXPECT_EQ(Failures(*run), "");
}

using AlwaysGood = ::testing::TestWithParam<const char*>;

TEST_P(AlwaysGood, ChannelDoesNotKeepTheOutputOn)
{
    Verifies(req::SRS_SIM_033);
    Verifies(req::SRS_SIM_038);
    // Given a channel that says that nothing is wrong; when three pairs are lost
    const auto run = RunChain(std::string("faults:\n  - {fault: always_good, name: good, node: actuator, part: ") +
                              GetParam() + ", at: 400 ms}\n" + R"(
  - {fault: loss, name: lost, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 6}}
expect:
  - {that: safe_within, node: actuator, srdo: 1, fault: lost}
  - {that: safe, node: actuator, srdo: 1, at: 560 ms}
)");
    // Then the other one closes the output in time
    EXPECT_EQ(Failures(*run), "");
}
INSTANTIATE_TEST_SUITE_P(EachChannel, AlwaysGood, ::testing::Values("channel_a", "channel_b"));

TEST(FaultWithoutEffect, HasItWhenSomethingDiffersAndNotBefore)
{
    Verifies(req::SRS_SIM_038);
    // Given a channel that says from 400 ms on that nothing is wrong, which differs once three pairs are lost
    const auto good = RunChain(R"(
faults:
  - {fault: always_good, node: actuator, part: channel_a, at: 400 ms}
  - {fault: loss, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 6}}
)");
    EXPECT_GE(good->Record().EffectOf(1U), 500'000'000);
    EXPECT_GE(good->Record().EffectOf(0U), 530'000'000);
    EXPECT_LE(good->Record().EffectOf(0U), 560'000'000);
    // Given a frame that comes behind the begin of its fault
    const auto lost = RunChain("faults:\n  - {fault: loss, frames: {identifier: 0x104, from: 480 ms, first: 3}}\n");
    EXPECT_GE(lost->Record().EffectOf(0U), 520'000'000);
}

TEST(FaultWithoutEffect, NeverHappensWhereCounterAndBitAreAsTheyWould)
{
    Verifies(req::SRS_SIM_038);
    const auto failures = [](const std::string& keys)
    { return Failures(*RunChain("faults:\n  - {node: actuator, at: 500 ms, " + keys + "}\n")); };
    // Given a counter that runs at the drift which it has, and one that does not
    EXPECT_EQ(failures("fault: clock, counter: a, ppm: 5"), "fault 'clock' happens: never happened\n");
    EXPECT_EQ(failures("fault: clock, counter: a, ppm: 6"), "no expectations");
    EXPECT_EQ(failures("fault: clock, counter: both, ppm: 5"), "no expectations"); // B has 25 ppm.
    // Given a bit of what is never written and whose march nobody runs, then it has one level, and not the other one
    const auto stuck = [](const std::string& level)
    {
        return Failures(*RunChainWithoutSelfTests("faults:\n  - {fault: stuck_bit, node: actuator, at: 500 ms, "
                                                  "part: kernel, offset: 0, bit: 0, level: " +
                                                  level + "}\n"));
    };
    const std::string never = "fault 'stuck_bit' happens: never happened\n";
    const std::string has_0 = stuck("0");
    EXPECT_TRUE(has_0 == never || has_0 == "no expectations") << has_0;
    EXPECT_EQ(stuck("1"), (has_0 == never) ? "no expectations" : never);
}

TEST(AlwaysGoodAlone, NeverHappensAsLongAsNothingIsHidden)
{
    Verifies(req::SRS_SIM_038);
    const auto run = RunChain("faults:\n  - {fault: always_good, node: actuator, part: channel_a, at: 400 ms}\n");
    EXPECT_EQ(Failures(*run), "fault 'always_good' happens: never happened\n");
}

TEST(FaultWithoutEffect, NeverHappensWhereFrameAndCallsAreAsTheyWould)
{
    Verifies(req::SRS_SIM_038);
    // Given a frame that is given the length which it has, one that nobody sends, and a channel that stands still
    // between two cycles; and beside each what differs
    struct Row
    {
        const char* kind;
        const char* without;
        const char* with;
    };
    for (const Row& row : {Row{"corruption", "frames: {identifier: 0x104, receiver: actuator, from: 500 ms}, length: 2",
                               "frames: {identifier: 0x104, receiver: actuator, from: 500 ms}, length: 1"},
                           Row{"loss", "frames: {identifier: 0x7A0}", "frames: {identifier: 0x104}"},
                           Row{"frozen", "node: actuator, part: channel_a, at: 500 ms, until: 500100 us",
                               "node: actuator, part: channel_a, at: 500 ms, until: 502 ms"}})
    {
        const std::string fault = std::string("faults:\n  - {fault: ") + row.kind + ", ";
        EXPECT_EQ(Failures(*RunChain(fault + row.without + "}\n")),
                  std::string("fault '") + row.kind + "' happens: never happened\n");
        EXPECT_EQ(Failures(*RunChain(fault + row.with + "}\n")), "no expectations") << row.kind;
    }
}

TEST(AlwaysGoodFlowMonitor, LeavesASkippedChannelToTheComparator)
{
    Verifies(req::SRS_SIM_033);
    const auto run = RunChain(R"(
faults:
  - {fault: always_good, name: good, node: actuator, part: flow_monitor, at: 400 ms}
  - {fault: skipped, name: once, node: actuator, part: channel_a, at: 500 ms, count: 1}
expect:
  - {that: safe_within, node: actuator, srdo: 1, fault: once}
  - {that: detected_by, node: actuator, by: comparator, fault: once}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(AlwaysGoodGuard, LeavesAWrongConfigurationToTheComparison)
{
    Verifies(req::SRS_SIM_033);
    // When SCT of channel A becomes 34 ms, nobody rechecks it any more, and a pair is lost
    const auto run = RunChain(R"(
faults:
  - {fault: always_good, name: good, node: actuator, part: guard, at: 400 ms}
  - {fault: bit_flip, name: flip, node: actuator, part: channel_a, at: 450 ms, config: {srdo: 1, field: sct}, bit: 4}
  - {fault: loss, name: lost, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 2}}
expect:
  - {that: safe_within, node: actuator, srdo: 1, fault: lost}
  - {that: detected_by, node: actuator, fault: lost, by: channel_a}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(FrozenAcknowledge, ReleasesNothing)
{
    Verifies(req::SRS_SIM_032);
    // When the acknowledge inputs, or one of them, stay 0 before anybody acknowledges
    for (const char* const input : {"acknowledge", "acknowledge_a", "acknowledge_b"})
    {
        const auto run =
            RunChain(std::string("faults:\n  - {fault: frozen_input, node: actuator, at: 100 ms, input: ") + input +
                     "}\nexpect:\n  - {that: safe, node: actuator, srdo: 1, at: 990 ms}\n");
        EXPECT_EQ(Failures(*run), "") << input;
    }
}

TEST(FrozenApplication, IsNotSeenByTheKernel)
{
    Verifies(req::SRS_SIM_032);
    // When the sensor's objects stay as they are while a button is pressed: the application's own responsibility
    const auto run = RunChain(R"(
faults:
  - {fault: frozen_input, input: application, node: sensor, at: 500 ms}
inputs:
  - {at: 600 ms, node: sensor, object: 0x2000:01, value: 0}
expect:
  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 990 ms}
  - {that: no_fault}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(IntermittentFault, ComesAndGoes)
{
    Verifies(req::SRS_SIM_028);
    // When the controller is bus-off for 3 ms every 20 ms, and frames are lost for 60 ms every 100 ms
    const auto bus_off =
        RunChain("faults:\n  - {fault: bus_off, node: controller, at: 500 ms, until: 800 ms, on: 3 ms, off: 17 ms}\n");
    std::size_t begun = 0U;
    for (const Event& event : bus_off->Record().Events())
    {
        begun += event.kind == EventKind::kFault ? 1U : 0U;
    }
    EXPECT_EQ(begun, 15U);
    const auto lost = RunChain(R"(
faults:
  - {fault: loss, frames: {receiver: actuator, from: 500 ms, on: 60 ms, off: 40 ms, count: 1000}}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
)",
                               true);
    EXPECT_EQ(Failures(*lost), "");
    std::set<Nanoseconds> periods;
    for (const Event& event : lost->Record().Events())
    {
        const Nanoseconds behind = event.at - 500 * kNanosecondsPerMillisecond;
        const Nanoseconds phase = behind % (100 * kNanosecondsPerMillisecond);
        if (event.kind == EventKind::kFrameChanged)
        {
            EXPECT_LT(phase, 60 * kNanosecondsPerMillisecond) << event.at;
            periods.insert(behind / (100 * kNanosecondsPerMillisecond));
        }
    }
    EXPECT_EQ(periods, (std::set<Nanoseconds>{0, 1, 2, 3, 4}));
}

TEST(ChoiceOfFrames, EveryThirdFromTheSecond)
{
    Verifies(req::SRS_SIM_020);
    // When of the six frames of the sensor from 500 ms on the 2nd and 5th are lost
    const auto run = RunChain(
        "faults:\n  - {fault: loss, frames: {srdo: {node: sensor, srdo: 1}, receiver: controller, from: 500 ms, "
        "first: 2, every: 3, count: 2}}\n",
        true);
    std::vector<std::uint64_t> identifiers;
    for (const Event& event : run->Record().Events())
    {
        if (event.kind == EventKind::kFrameChanged)
        {
            identifiers.push_back(event.value);
        }
    }
    EXPECT_EQ(identifiers, (std::vector<std::uint64_t>{0x102U, 0x101U}));
}

TEST(DroppedCopies, AreToldWithTheirNumber)
{
    Verifies(req::SRS_SIM_017);
    const auto run = RunChain(R"(
faults:
  - {fault: repetition, name: one, times: 15, frames: {identifier: 0x103, receiver: actuator, from: 500 ms}}
  - {fault: repetition, name: two, times: 4, optional: true, frames: {identifier: 0x103, receiver: actuator, from: 500 ms}}
)");
    ASSERT_EQ(run->Findings().size(), 1U);
    EXPECT_NE(run->Findings().front().find(
                  ":5:5: warning: 4 copies of 'two' dropped, expected at most 16 receptions of one frame"),
              std::string::npos);
}
} // namespace
} // namespace counterpoint::simulator
