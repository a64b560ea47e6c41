// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <ostream>
#include <string>

namespace counterpoint::simulator
{
namespace
{
/// A fault at the actuator's SRDO 1, and what the actuator says about it.
struct FaultCase
{
    const char* name;
    const char* fault;
    const char* expected; ///< More expectations.
};

void PrintTo(const FaultCase& fault, std::ostream* const out)
{
    *out << fault.name;
}

using FaultOfTheBus = ::testing::TestWithParam<FaultCase>;

TEST_P(FaultOfTheBus, EndsInTheSafeStateWithinTheLimitAndWithItsCause)
{
    Verifies(req::SRS_SIM_020);
    Verifies(req::SRS_SIM_031);
    Verifies(req::SRS_LIM_001);
    // Given the released chain; when the fault comes at 500 ms
    const auto run = RunChain(std::string("faults:\n  - {") + GetParam().fault + "}\nexpect:\n" + GetParam().expected);
    // Then the cause is named and the output is safe in time
    EXPECT_EQ(Failures(*run), "");
}

constexpr const char* kWithin = "  - {that: safe_within, node: actuator, srdo: 1}\n";
constexpr FaultCase kBusFaults[] = {
    {"short frame", "fault: corruption, frames: {identifier: 0x103, receiver: actuator, from: 500 ms}, length: 1",
     "  - {that: cause, node: actuator, srdo: 1, is: length}\n  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"long frame", "fault: corruption, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}, length: 8",
     "  - {that: cause, node: actuator, srdo: 1, is: length}\n  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"bit of the inverse",
     "fault: corruption, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}, bits: [15]",
     "  - {that: cause, node: actuator, srdo: 1, is: not_inverse}\n  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"inverse twice", "fault: repetition, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}",
     "  - {that: cause, node: actuator, srdo: 1, is: inverse_first}\n  - {that: safe_within, node: actuator, srdo: "
     "1}\n"},
    {"normal again after 3 ms",
     "fault: repetition, frames: {identifier: 0x103, receiver: actuator, from: 500 ms}, after: 3 ms",
     "  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"delay of the inverse past SRVT",
     "fault: delay, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}, by: 21 ms",
     "  - {that: cause, node: actuator, srdo: 1, is: srvt}\n  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"foreign normal frame", "fault: insertion, at: 510 ms, receiver: actuator, identifier: 0x103, data: [0, 0]",
     "  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"masquerade with a normal frame", "fault: masquerade, at: 507 ms, node: sensor, identifier: 0x103, data: [1, 1]",
     "  - {that: safe_within, node: actuator, srdo: 1}\n"},
    {"every frame of the chain lost", "fault: loss, frames: {from: 500 ms, count: 1000}",
     "  - {that: safe_within, node: actuator, srdo: 1}\n"},
};

INSTANTIATE_TEST_SUITE_P(EachClass, FaultOfTheBus, ::testing::ValuesIn(kBusFaults));

TEST(FaultOfTheBusBelowTheLimits, LetsThePairBe)
{
    Verifies(req::SRS_SIM_020);
    Verifies(req::SRS_TIME_004);
    // When inverse frames come 19 ms late (SRVT 20 ms), and a remote frame has the identifier of the command
    const auto run = RunChain(R"(
faults:
  - {fault: delay, name: late, frames: {identifier: 0x104, receiver: actuator, from: 500 ms, count: 4}, by: 19 ms}
  - {fault: insertion, name: remote, at: 503 ms, identifier: 0x104, kind: remote}
expect:
  - {that: released, node: actuator, srdo: 1, at: 999 ms}
  - {that: no_fault}
)");
    // Then nothing is wrong
    EXPECT_EQ(Failures(*run), "");
}

TEST(FaultByChance, HitsByProbabilityAndSeed)
{
    Verifies(req::SRS_SIM_003);
    Verifies(req::SRS_SIM_020);
    // Given half of the frames lost by chance
    const std::string text =
        "faults:\n  - {fault: loss, frames: {receiver: actuator, count: 1000, probability_ppm: 500000}}\n";
    const auto first = RunChain(text + "seed: 7\n", true);
    const auto again = RunChain(text + "seed: 7\n", true);
    const auto other = RunChain(text + "seed: 8\n", true);
    const auto lost = [](const simulator::Run& run)
    {
        std::vector<Nanoseconds> times;
        for (const Event& event : run.Record().Events())
        {
            if (event.kind == EventKind::kFrameChanged)
            {
                times.push_back(event.at);
            }
        }
        return times;
    };
    // Then the seed decides which
    EXPECT_EQ(lost(*first), lost(*again));
    EXPECT_NE(lost(*first), lost(*other));
    EXPECT_GT(lost(*first).size(), 50U);
    EXPECT_LT(lost(*first).size(), 110U);
}

TEST(FaultOfTime, EarlyCycleIsFoundByTheWatchdog)
{
    Verifies(req::SRS_SIM_023);
    // When a cycle comes 0.7 ms early, before the watchdog's window opens
    const auto run = RunChain(R"(
faults:
  - {fault: cycle, node: actuator, early: 700 us, at: 500 ms}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: detected_by, node: actuator, by: watchdog}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(FaultOfTime, LateCycleIsFoundByTheWatchdog)
{
    Verifies(req::SRS_SIM_023);
    // When a cycle comes 5 ms late, behind the watchdog's window
    const auto run = RunChain(R"(
faults:
  - {fault: cycle, node: actuator, late: 5 ms, at: 500 ms}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: detected_by, node: actuator, by: watchdog}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(FaultOfTime, FastAndStoppedCountersAreFoundByTheOtherOne)
{
    Verifies(req::SRS_SIM_023);
    for (const char* const ppm : {"20000", "-1000000"})
    {
        for (const char* const counter : {"a", "b"})
        {
            const auto run = RunChain(std::string("faults:\n  - {fault: clock, node: actuator, counter: ") + counter +
                                      ", ppm: " + ppm + R"(, at: 500 ms}
expect:
  - {that: device_fault, node: actuator, is: clock}
  - {that: safe_within, node: actuator, srdo: 1}
)");
            EXPECT_EQ(Failures(*run), "") << counter << " " << ppm;
        }
    }
}

TEST(FaultOfTime, SlowCounterIsFoundByTheOtherOne)
{
    Verifies(req::SRS_SIM_023);
    // When counter A runs 2 % slow
    const auto run = RunChain(R"(
faults:
  - {fault: clock, node: actuator, counter: a, ppm: -20000, at: 500 ms}
expect:
  - {that: device_fault, node: actuator, is: clock}
  - {that: safe_within, node: actuator, srdo: 1}
)");
    EXPECT_EQ(Failures(*run), "");
}

TEST(FaultOfTheApplication, NotInverseStaysInTheDevice)
{
    Verifies(req::SRS_SIM_024);
    Verifies(req::SRS_PROD_005);
    // When the application's inverse is wrong from 500 ms on
    const auto run = RunChain(R"(
faults:
  - {fault: not_inverse, node: sensor, object: 0x2000:02, bits: [3], at: 500 ms}
expect:
  - {that: cause, node: sensor, srdo: 1, is: not_inverse}
  - {that: safe_within, node: controller, srdo: 1}
)",
                              true);
    EXPECT_EQ(Failures(*run), "");
    // Then no frame with the identifiers of the sensor is on the bus afterwards
    for (const FrameEntry& frame : run->Record().Frames())
    {
        const bool is_of_sensor = frame.frame.identifier == 0x101U || frame.frame.identifier == 0x102U;
        EXPECT_FALSE(is_of_sensor && frame.start > 502 * kNanosecondsPerMillisecond) << frame.start;
    }
}

struct FlipCase
{
    const char* part;
    const char* field;
    int bit;
};

using FlippedConfiguration = ::testing::TestWithParam<FlipCase>;

TEST_P(FlippedConfiguration, IsFoundWithinTheDiagnosticInterval)
{
    Verifies(req::SRS_SIM_021);
    Verifies(req::SRS_CFG_048);
    // When one bit of a configuration value flips in one channel
    const auto run = RunChain(std::string("duration: 2500 ms\nfaults:\n  - {fault: bit_flip, node: actuator, part: ") +
                              GetParam().part + ", at: 500.2 ms, config: {srdo: 1, " + GetParam().field +
                              "}, bit: " + std::to_string(GetParam().bit) + "}\n" +
                              "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    EXPECT_EQ(Failures(*run), "");
}

constexpr FlipCase kFlips[] = {
    {"channel_a", "field: sct", 5},
    {"channel_b", "field: sct", 5},
    {"channel_a", "field: srvt", 2},
    {"channel_b", "field: srvt", 2},
    {"channel_a", "field: cob_id_1", 1},
    {"channel_b", "field: cob_id_1", 1},
    {"channel_a", "field: cob_id_2", 3},
    {"channel_b", "field: cob_id_2", 3},
    {"channel_a", "field: direction", 1},
    {"channel_b", "field: direction", 1},
    {"channel_a", "field: signature", 9},
    {"channel_b", "field: signature", 9},
    {"channel_a", "field: map_entry, entry: 2", 8},
    {"channel_b", "field: map_entry, entry: 2", 8},
    {"channel_a", "field: map_count", 1},
    {"channel_b", "field: map_count", 1},
};

INSTANTIATE_TEST_SUITE_P(EachValue, FlippedConfiguration, ::testing::ValuesIn(kFlips));

TEST(FlippedBit, AnywhereInAChannelNeverLetsTheActuatorMoveAgainstTheButton)
{
    Verifies(req::SRS_SIM_021);
    Verifies(req::SRS_CONS_024);
    // Given a flipped bit at a place that the seed chooses, and a button that is pressed 100 ms later
    const std::string text = R"(
duration: 1000 ms
faults:
  - {fault: bit_flip, name: a, node: actuator, part: channel_a, at: 500 ms}
inputs:
  - {at: 600 ms, node: sensor, object: 0x2000:01, value: 0}
expect:
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 999 ms}
seed: )";
    for (int seed = 1; seed <= 60; ++seed)
    {
        for (const char* const part : {"channel_a", "channel_b"})
        {
            std::string changed = text;
            changed.replace(changed.find("part: channel_a"), 15U, std::string("part: ") + part);
            const auto run = RunChain(changed + std::to_string(seed) + "\n");
            // Then the actuator is off in the end, whatever the bit was
            EXPECT_EQ(Failures(*run), "") << "seed " << seed << " " << part;
        }
    }
}
} // namespace
} // namespace counterpoint::simulator
