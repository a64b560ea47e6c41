// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Which row of the table of limits the simulator takes where the scenario names none.
#include "simulator/world/node/pairs.hpp"
#include "tests/integration/changed_devices.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace counterpoint::simulator
{
namespace
{
constexpr Nanoseconds kUs = kNanosecondsPerMicrosecond;

/// A scenario that extends none.
std::unique_ptr<Run> RunOf(const std::string& text)
{
    auto run = std::make_unique<Run>(TextFile(text), std::nullopt, std::nullopt, false);
    run->Simulate(nullptr);
    return run;
}

const Measurement& MeasurementOf(const Run& run)
{
    return *run.Verdicts().front().measurement;
}

// A copy of a normal frame behind the pair begins a new one: SRVT or the next normal frame ends it, not the copy. One
// that comes with the frame itself is wrong.
TEST(JudgedLimit, OfALateCopyOfANormalFrameIsThatOfAnInsertion)
{
    Verifies(req::SRS_SIM_215);
    const auto run_with = [](const char* const after)
    {
        return RunChain(std::string("faults:\n  - {fault: repetition, after: ") + after +
                        ", frames: {identifier: 0x103, receiver: actuator, from: 500 ms}}\n"
                        "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    };
    const auto late = run_with("3 ms");
    EXPECT_EQ(Failures(*late), "");
    EXPECT_EQ(MeasurementOf(*late).fault_class, FaultClass::kBusNextNormal);
    EXPECT_EQ(MeasurementOf(*late).limit, 73000 * kUs);
    const auto at_once = run_with("0 ms");
    EXPECT_EQ(Failures(*at_once), "");
    EXPECT_EQ(MeasurementOf(*at_once).fault_class, FaultClass::kWrongFrame);
}

// The actuator hears of a fault inside the controller by the bus alone: SCT, cycle and output time.
TEST(JudgedLimit, AtAnotherDeviceIsThatOfTheBus)
{
    Verifies(req::SRS_SIM_216);
    for (const char* const fault :
         {"{fault: bit_flip, node: controller, part: program, at: 700 ms, offset: 5000, bit: 7}",
          "{fault: frozen, node: controller, part: channel_a, at: 700 ms}",
          "{fault: clock, node: controller, counter: a, jump: 30 ms, at: 700 ms}"})
    {
        const auto run = RunChain(std::string("duration: 7 s\nfaults:\n  - ") + fault +
                                  "\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
        EXPECT_EQ(Failures(*run), "") << fault;
        EXPECT_EQ(MeasurementOf(*run).fault_class, FaultClass::kBus) << fault;
        EXPECT_EQ(MeasurementOf(*run).limit, 53000 * kUs) << fault;
    }
}

/// The emergency-stop chain with a controller of two CPUs.
std::string ChainWithTwoCpusInTheMiddle()
{
    const std::string actuator = "  actuator: {dcf: " + Examples() + "actuator.dcf, phase: 810 us}\n";
    return "title: controller of two CPUs\nbitrate: 500000\nduration: 3 s\nnodes:\n  sensor: {dcf: " + Examples() +
           "sensor.dcf, phase: 130 us}\n  controller:\n    dcf: " + Examples() + "controller.dcf\n" + R"(
    structure: two_cpu
    cpu_a: {phase: 470 us, counter: {ppm: 20}}
    cpu_b: {phase: 910 us, counter: {ppm: -20}}
    link: {timeout: 10 ms, delay: 200 us}
)" + actuator +
           R"(
inputs:
  - {at: 20 ms, node: sensor, object: 0x2000:01, value: 1}
  - {at: 20 ms, node: sensor, object: 0x2000:02, value: 1}
logic:
  - {node: controller, set: 0x2000:01, op: and, from: [0x2200:01, 0x2200:02]}
  - {node: controller, set: 0x2000:02, op: or, from: [0x2200:01, 0x2200:02]}
acknowledge:
  - {at: 150 ms, node: actuator, srdo: 1, pulse: 50 ms}
)";
}

// So it is where the two CPUs of the controller lose each other: the actuator has no part in their link.
TEST(JudgedLimit, AtAnotherDeviceThanThatOfALinkIsThatOfTheBus)
{
    Verifies(req::SRS_SIM_216);
    for (const char* const fault : {"{fault: link_cut, node: controller, at: 500 ms}",
                                    "{fault: clock, node: controller.a, counter: a, ppm: 4400, at: 500 ms}"})
    {
        const auto run = RunOf(ChainWithTwoCpusInTheMiddle() + "faults:\n  - " + fault +
                               "\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
        EXPECT_EQ(Failures(*run), "") << fault;
        EXPECT_EQ(MeasurementOf(*run).fault_class, FaultClass::kBus) << fault;
        EXPECT_EQ(MeasurementOf(*run).limit, 53000 * kUs) << fault;
    }
}

// Given refresh 10 ms, SCT 15 ms and SRVT 12 ms, and inverse frames that stay away, then the first normal frame behind
// the last good pair came in time, and what counts is SRVT behind it: the second
// normal frame, 20 ms behind that pair, is the one that closes.
TEST(JudgedLimit, HasSrvtInItAsSoonAsTheFirstNormalFrameCame)
{
    Verifies(req::SRS_SIM_082);
    for (const char* const from : {"500 ms", "507 ms", "1203 ms"})
    {
        const auto run = RunChainOf(
            {{"controller", {{"1302sub2", "10"}, {"1302sub3", "5"}}},
             {"actuator", {{"1301sub2", "15"}, {"1301sub3", "12"}}}},
            std::string(
                "duration: 1300 ms\nfaults:\n  - {fault: confirmation, frames: {identifier: 0x103, count: 3, from: ") +
                from + "}}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
        EXPECT_EQ(Failures(*run), "") << from;
        EXPECT_EQ(MeasurementOf(*run).fault_class, FaultClass::kBusNextNormal) << from;
        EXPECT_EQ(MeasurementOf(*run).limit, 30000 * kUs) << from;
        EXPECT_GT(MeasurementOf(*run).elapsed, 18000 * kUs) << from;
    }
}

// Given normal frames of which the first one behind the last good pair comes too late, then SCT holds alone.
TEST(JudgedLimit, HasNoSrvtInItWhereTheFirstNormalFrameCameTooLate)
{
    Verifies(req::SRS_SIM_082);
    const auto run = RunChainOf({{"controller", {{"1302sub2", "10"}, {"1302sub3", "5"}}},
                                 {"actuator", {{"1301sub2", "15"}, {"1301sub3", "12"}}}},
                                "faults:\n  - {fault: loss, frames: {identifier: [0x103, 0x104], from: 500 ms, "
                                "count: 2}}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    EXPECT_EQ(Failures(*run), "");
    EXPECT_EQ(MeasurementOf(*run).fault_class, FaultClass::kBus);
    EXPECT_EQ(MeasurementOf(*run).limit, 18000 * kUs);
}

TEST(NodePairs, OfWhatCameBehindTheGoodPairTheFirstCounts)
{
    Verifies(req::SRS_SIM_082);
    host::VirtualBus bus(host::BitRate{500000U});
    Journal journal(false);
    const NodePlace place{0U, bus, journal, false, nullptr};
    const runtime::DeviceModel model(Examples() + "actuator.dcf", std::nullopt);
    NodePairs pairs(place, model);
    const auto get = [&](const std::int64_t ms, const std::uint32_t identifier, const std::uint8_t first)
    {
        bus.Advance(ms * kNanosecondsPerMillisecond);
        pairs.OnFrame(CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 2U, {first, 0x00U}});
    };
    // Given a good pair
    bus.Advance(10 * kNanosecondsPerMillisecond);
    pairs.OnFrame(CanFrame{0x103U, FrameKind::kData, CanPortId::kFirst, 2U, {0x01U, 0xFFU}});
    get(11, 0x104U, 0xFEU);
    pairs.OnCycle();
    EXPECT_EQ(pairs.TimesOf(0U).judged_normal, 10 * kNanosecondsPerMillisecond);
    EXPECT_EQ(pairs.TimesOf(0U).behind_judged.next_normal, -1);
    EXPECT_EQ(pairs.TimesOf(0U).behind_judged.wrong_inverse, -1);
    // When two pairs come behind it that are not inverse, and cycles between them
    for (const std::int64_t ms : {20, 30})
    {
        get(ms, 0x103U, 0x01U);
        get(ms + 1, 0x104U, 0x01U);
        pairs.OnCycle();
        // Then the first normal and the first wrong inverse frame are what counts
        const PairTimes& times = pairs.TimesOf(0U);
        EXPECT_EQ(times.last_good_normal, 10 * kNanosecondsPerMillisecond) << ms;
        EXPECT_EQ(times.behind_good.next_normal, 20 * kNanosecondsPerMillisecond) << ms;
        EXPECT_EQ(times.behind_good.wrong_inverse, 21 * kNanosecondsPerMillisecond) << ms;
        EXPECT_EQ(times.behind_judged.next_normal, 20 * kNanosecondsPerMillisecond) << ms;
        EXPECT_EQ(times.behind_judged.wrong_inverse, 21 * kNanosecondsPerMillisecond) << ms;
    }
}
} // namespace
} // namespace counterpoint::simulator
