// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/text_file.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
// t [ms]     10            20        150            600
// chain      OPERATIONAL   inputs 1  acknowledge    ...
TEST(Chain, IsReleasedOnlyAfterTheAcknowledge)
{
    Verifies(req::SRS_SIM_001);
    Verifies(req::SRS_SIM_002);
    Verifies(req::SRS_SIM_005);
    // Given the chain with an interlocked actuator, started at 10 ms and acknowledged at 150 ms
    const auto run = RunChain(R"(
expect:
  - {that: safe, node: actuator, srdo: 1, at: 149 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 149 ms}
  - {that: released, node: controller, srdo: 1, at: 40 ms}
  - {that: released, node: actuator, srdo: 1, at: 152 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 152 ms}
  - {that: no_fault}
)");
    // Then the actuator is safe before, released after, and nothing was wrong
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, IsMadeOfTheSourcesOfTheProductEachCompiledOnce)
{
    Verifies(req::SRS_SIM_001);
    // Given what this build has compiled
    const std::string compiled = cia306::ReadTextFile(COUNTERPOINT_COMPILE_COMMANDS);
    std::size_t count = 0U;
    for (const char* const room :
         {"safety_core/kernel", "safety_core/comparator", "channel_a", "channel_b", "hal/host/virtual"})
    {
        const std::filesystem::path folder = std::filesystem::path{COUNTERPOINT_SOURCE_FOLDER} / room;
        for (const auto& entry : std::filesystem::recursive_directory_iterator{folder})
        {
            if (entry.path().extension() != ".cpp")
            {
                continue;
            }
            // Then there is one object of each source, which a simulated node cannot but have
            ++count;
            const std::string line = "\"file\": \"" + entry.path().string() + "\"";
            const std::size_t first = compiled.find(line);
            EXPECT_NE(first, std::string::npos) << line;
            EXPECT_EQ(compiled.find(line, first + 1U), std::string::npos) << line;
        }
    }
    EXPECT_GE(count, 40U);
}

TEST(Chain, ConstantAcknowledgeNeverReleases)
{
    Verifies(req::SRS_REL_005);
    // Given an acknowledge input that is 1 from before the start on
    const auto run = std::make_unique<simulator::Run>(TextFile(R"(
duration: 500 ms
nodes:
  controller: {dcf: )" + Examples() + R"(controller.dcf}
  actuator: {dcf: )" + Examples() + R"(actuator.dcf}
acknowledge:
  - {at: 0 ms, node: actuator, srdo: 1, pulse: 10 s}
expect:
  - {that: safe, node: actuator, srdo: 1, at: 490 ms}
  - {that: no_fault, node: actuator}
)"),
                                                      std::nullopt, std::nullopt, false);
    run->Simulate(nullptr);
    // Then the actuator stays safe without a fault
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, PressedButtonReachesTheActuatorAndTheOtherIsJoinedByOr)
{
    Verifies(req::SRS_SIM_006);
    Verifies(req::SRS_SIM_007);
    // When one of two buttons is pressed (0) at 400 ms: object 1 is AND, object 2 is OR of both
    const auto run = RunChain(R"(
inputs:
  - {at: 400 ms, node: sensor, object: 0x2000:02, value: 0}
expect:
  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 399 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 460 ms}
  - {that: value, node: actuator, object: 0x2200:02, is: 1, at: 460 ms}
  - {that: released, node: actuator, srdo: 1, at: 460 ms}
  - {that: no_fault}
)");
    // Then both arrive, by both paths, and the pair stays valid
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, CopyAndNotAreOfTheNormalAndOfTheInverseObject)
{
    Verifies(req::SRS_SIM_007);
    // Given the chain with a copy of button 1 and every bit of button 2 the other way round
    const auto run = std::make_unique<simulator::Run>(TextFile(R"(
duration: 500 ms
nodes:
  sensor: {dcf: )" + Examples() + R"(sensor.dcf}
  controller: {dcf: )" + Examples() + R"(controller.dcf}
  actuator: {dcf: )" + Examples() + R"(actuator.dcf}
inputs:
  - {at: 20 ms, node: sensor, object: 0x2000:01, value: 1}
  - {at: 20 ms, node: sensor, object: 0x2000:02, value: 1}
logic:
  - {node: controller, set: 0x2000:01, op: copy, from: [0x2200:01]}
  - {node: controller, set: 0x2000:02, op: not, from: [0x2200:02]}
acknowledge:
  - {at: 150 ms, node: actuator, srdo: 1, pulse: 50 ms}
expect:
  - {that: value, node: actuator, object: 0x2200:01, is: 0x01, at: 400 ms}
  - {that: value, node: actuator, object: 0x2200:02, is: 0xFE, at: 400 ms}
  - {that: released, node: actuator, srdo: 1, at: 400 ms}
  - {that: no_fault}
)"),
                                                      std::nullopt, std::nullopt, false);
    run->Simulate(nullptr);
    // Then both arrive; a pair whose inverse object is not that of its normal one would not
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, AutomaticPolicyRecoversByItselfAndInterlockNeedsAPerson)
{
    Verifies(req::SRS_REL_003);
    Verifies(req::SRS_REL_004);
    // When the sensor is lost for 100 ms (controller: automatic) and the controller is lost for 100 ms (actuator:
    // interlock)
    const auto run = RunChain(R"(
faults:
  - {fault: loss, name: sensor lost, frames: {sender: sensor, receiver: controller, from: 300 ms, until: 400 ms, count: 100}}
  - {fault: loss, name: controller lost, frames: {sender: controller, receiver: actuator, from: 300 ms, until: 400 ms, count: 100}}
acknowledge:
  - {at: 700 ms, node: actuator, srdo: 1}
expect:
  - {that: safe, node: controller, srdo: 1, at: 390 ms}
  - {that: released, node: controller, srdo: 1, at: 440 ms}
  - {that: cause, node: controller, srdo: 1, is: sct}
  - {that: safe, node: actuator, srdo: 1, at: 690 ms}
  - {that: released, node: actuator, srdo: 1, at: 702 ms}
  - {that: device_fault, node: actuator, is: none}
)");
    // Then the controller is back at the next pair, the actuator only after its acknowledge
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, LeavingOperationalIsSafeAndReturningDoesNotRelease)
{
    Verifies(req::SRS_CONS_019);
    Verifies(req::SRS_REL_008);
    Verifies(req::SRS_SIM_005);
    // When the actuator goes to PRE-OPERATIONAL at 400 ms and comes back at 500 ms
    const auto run = RunChain(R"(
nmt:
  - {at: 400 ms, node: actuator, state: pre_operational}
  - {at: 500 ms, node: actuator, state: operational}
acknowledge:
  - {at: 800 ms, node: actuator, srdo: 1}
expect:
  - {that: released, node: actuator, srdo: 1, at: 399 ms}
  - {that: safe, node: actuator, srdo: 1, at: 402 ms}
  - {that: cause, node: actuator, srdo: 1, is: not_operational}
  - {that: safe, node: actuator, srdo: 1, at: 790 ms}
  - {that: released, node: actuator, srdo: 1, at: 802 ms}
  - {that: device_fault, node: actuator, is: none}
)");
    // Then the interlock has survived
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, GlobalFailSafeCommandOfAStrangerForcesSafeWhereItIsSupported)
{
    Verifies(req::SRS_CONS_017);
    Verifies(req::SRS_SIM_020);
    // Given a GFC on the bus at 400 ms: 1300h is 1 in the shipped actuator or it is not; the DCF decides
    const auto run = RunChain(R"(
faults:
  - {fault: insertion, name: gfc, at: 400 ms, identifier: 0x001}
expect:
  - {that: device_fault, node: actuator, is: none}
)",
                              true);
    ASSERT_EQ(Failures(*run), "");
    const ObjectReading reading = run->Devices().At(2U).Firmware().Assembly().Core().ReadObject({0x1300U, 0U});
    ASSERT_EQ(reading.abort, AbortCode::kNone);
    bool was_signalled = false;
    for (const Event& event : run->Record().Events())
    {
        const bool is_gfc = event.value == static_cast<std::uint64_t>(SrdoCause::kGfc);
        was_signalled = was_signalled || (event.kind == EventKind::kSignal && event.node == 2U && is_gfc);
    }
    // Then it is safe exactly if it is supported
    EXPECT_EQ(was_signalled, reading.data.bytes[0] == 1U);
}

TEST(Chain, SensorThatStopsLeavesEverybodySafe)
{
    Verifies(req::SRS_SIM_005);
    // When the sensor stops at 400 ms
    const auto run = RunChain(R"(
nmt:
  - {at: 400 ms, node: sensor, state: stopped}
expect:
  - {that: safe, node: controller, srdo: 1, at: 460 ms}
  - {that: cause, node: controller, srdo: 1, is: sct}
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 520 ms}
  - {that: released, node: actuator, srdo: 1, at: 520 ms}
)");
    // Then the controller falls to its safe value and hands that on; the way to the actuator is intact
    EXPECT_EQ(Failures(*run), "");
}

TEST(Chain, RunsWithoutTapsAsWithThem)
{
    Verifies(req::SRS_SIM_003);
    Verifies(req::SRS_SIM_046);
    // Given the same scenario once recorded (channels and supervisors behind taps) and once not
    const std::string text = "inputs:\n  - {at: 400 ms, node: sensor, object: 0x2000:02, value: 0}\n"
                             "expect:\n  - {that: no_fault}\n";
    const auto tapped = RunChain(text, true);
    const auto plain = RunChain(text, false);
    // Then the outputs and values changed at the same instants
    std::string changes_tapped;
    std::string changes_plain;
    for (const Event& event : tapped->Record().Events())
    {
        const bool is_change = event.kind == EventKind::kOutput || event.kind == EventKind::kValue;
        changes_tapped += is_change ? std::to_string(event.at) + "=" + std::to_string(event.value) + " " : "";
    }
    for (const Event& event : plain->Record().Events())
    {
        const bool is_change = event.kind == EventKind::kOutput || event.kind == EventKind::kValue;
        changes_plain += is_change ? std::to_string(event.at) + "=" + std::to_string(event.value) + " " : "";
    }
    EXPECT_EQ(changes_tapped, changes_plain);
    EXPECT_GT(changes_plain.size(), 50U);
    EXPECT_EQ(plain->Record().Frames().size(), 0U);
}

TEST(Chain, NodesHaveCountersAndCyclesOfTheirOwn)
{
    Verifies(req::SRS_SIM_004);
    // Given the chain: the sensor's counters start at 1000 and 70000 us, +20 and -15 ppm; cycles at 130, 470, 810 us
    const auto run = RunChain("duration: 100 ms\n", true);
    // Then power-on is at each node's phase, and what channels say comes a cycle later or whole cycles after that
    std::string phases;
    for (const Event& event : run->Record().Events())
    {
        phases += (event.kind == EventKind::kPowerOn) ? std::to_string(event.at) + " " : "";
    }
    EXPECT_EQ(phases, "130000 470000 810000 ");
    // and counters that are 0.2 % fast make the refresh that they time as much shorter
    const auto fast = RunChain(R"(
faults:
  - {fault: clock, name: a, node: sensor, counter: a, ppm: 2000, at: 20 ms}
  - {fault: clock, name: b, node: sensor, counter: b, ppm: 2000, at: 20 ms}
duration: 1000 ms
)",
                               true);
    const auto thirty_sixth = [](const simulator::Run& chosen)
    {
        std::vector<Nanoseconds> starts;
        for (const FrameEntry& frame : chosen.Record().Frames())
        {
            if (frame.frame.identifier == 0x101U)
            {
                starts.push_back(frame.start);
            }
        }
        return starts.at(35U);
    };
    const auto slow = RunChain("duration: 1000 ms\n", true);
    // 0.2 % of some 860 ms, in whole cycles
    EXPECT_GE(thirty_sixth(*slow) - thirty_sixth(*fast), 1 * kNanosecondsPerMillisecond);
    EXPECT_LE(thirty_sixth(*slow) - thirty_sixth(*fast), 3 * kNanosecondsPerMillisecond);
}

TEST(Chain, FramesTakeTheTimeOfTheirBitsAndTheLowerIdentifierWins)
{
    Verifies(req::SRS_SIM_008);
    // Given two foreign frames that sensor and actuator begin to send at the same instant
    const auto run = RunChain(R"(
duration: 300 ms
faults:
  - {fault: masquerade, name: high, node: sensor, at: 250 ms, identifier: 0x555}
  - {fault: masquerade, name: low, node: actuator, at: 250 ms, identifier: 0x333, data: [0x55]}
)",
                              true);
    std::vector<FrameEntry> frames;
    for (const FrameEntry& frame : run->Record().Frames())
    {
        if (frame.frame.identifier == 0x555U || frame.frame.identifier == 0x333U)
        {
            frames.push_back(frame);
        }
    }
    // Then the lower one is first; without data a frame has 34 bits before and 10 after the stuffed part: 44 and stuff
    // bits, of 2 us each; one data byte more is 8 bits more; the second starts 3 bits of intermission later
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].frame.identifier, 0x333U);
    EXPECT_EQ(frames[0].start, 250 * kNanosecondsPerMillisecond);
    EXPECT_GE(frames[0].end - frames[0].start, 52 * 2000);
    EXPECT_LE(frames[0].end - frames[0].start, 62 * 2000);
    EXPECT_EQ(frames[1].start - frames[0].end, 3 * 2000);
    EXPECT_GE(frames[1].end - frames[1].start, 44 * 2000);
    EXPECT_LE(frames[1].end - frames[1].start, 52 * 2000);
}
} // namespace
} // namespace counterpoint::simulator
