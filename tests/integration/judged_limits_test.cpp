// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the simulator tells of limits: by the times and the detection of the device, counted from what the table of
// limits names, and only where it was this fault that closed the output.
#include "tests/integration/changed_devices.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
/// A scenario that extends none, recorded.
std::unique_ptr<Run> RunOf(const std::string& text)
{
    auto run = std::make_unique<Run>(TextFile(text), std::nullopt, std::nullopt, true);
    run->Simulate(nullptr);
    return run;
}

const Measurement& MeasurementOf(const Run& run)
{
    return *run.Verdicts().front().measurement;
}

constexpr Nanoseconds kUs = kNanosecondsPerMicrosecond;

// The limit of SCT 50 ms, SRVT 20 ms, cycle 1 ms, 0.5 ms late, clocks 0.5 ms apart, output 1 ms.
TEST(JudgedLimit, FollowsTheDetectionOfTheDevice)
{
    Verifies(req::SRS_SIM_031);
    Verifies(req::SRS_LIM_210);
    const std::string lost =
        "faults:\n  - {fault: loss, frames: {identifier: 0x104, receiver: actuator, from: 500 ms, count: 1000}}\n"
        "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n";
    const auto early = RunChainOf({{"actuator", {{"5F05sub1", "0x00"}}}}, lost);
    EXPECT_EQ(Failures(*early), "");
    EXPECT_EQ(MeasurementOf(*early).limit, 73000 * kUs);
    // Late: SRVT is in no limit
    const auto late = RunChainOf({{"actuator", {{"5F05sub1", "0x3C"}}}}, lost);
    EXPECT_EQ(Failures(*late), "");
    EXPECT_EQ(MeasurementOf(*late).limit, 53000 * kUs);
    // and another word than that of late detection is early
    const auto other = RunChainOf({{"actuator", {{"5F05sub1", "0x3D"}}}}, lost);
    EXPECT_EQ(MeasurementOf(*other).limit, 73000 * kUs);
}

// Late detection, one inverse frame lost: SCT is over with the next pair, which is complete before the cycle that
// closes, and released no more. What counts is the pair before the lost one, 50 ms earlier.
TEST(JudgedLimit, DoesNotCountFromAPairThatWasNotReleased)
{
    Verifies(req::SRS_SIM_214);
    const auto run =
        RunChainOf({{"actuator", {{"5F05sub1", "0x3C"}}}},
                   "faults:\n  - {fault: loss, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}}\n"
                   "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    EXPECT_EQ(Failures(*run), "");
    EXPECT_EQ(MeasurementOf(*run).limit, 53000 * kUs);
    // SCT 50 ms, up to a cycle of 1 ms, output 1 ms
    EXPECT_GE(MeasurementOf(*run).elapsed, 51000 * kUs);
    EXPECT_LE(MeasurementOf(*run).elapsed, 52500 * kUs);
}

TEST(JudgedLimit, ThatIsNoneHoldsForNobody)
{
    Verifies(req::SRS_SIM_217);
    const auto run = RunChainOf({{"actuator", {{"5F00sub6", "99999"}}}},
                                "faults:\n  - {fault: loss, frames: {receiver: actuator, from: 500 ms, count: 1000}}\n"
                                "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    ASSERT_FALSE(run->Holds());
    EXPECT_NE(run->Verdicts().front().wanted.find("safe within a limit, where its times give none"), std::string::npos)
        << run->Verdicts().front().wanted;
}

// A corrupted normal frame is shown by its inverse frame, 1 ms later here, whoever chooses it and however: by SRDO and
// side, by identifiers, by receiver, by sender, by all of them.
TEST(JudgedLimit, OfACorruptedNormalFrameCountsFromTheInverseFrame)
{
    Verifies(req::SRS_SIM_213);
    const std::string spread =
        "  - {fault: store_and_forward, frames: {identifier: 0x104, receiver: actuator, count: 1000}, by: 4 ms}\n";
    for (const char* const choice :
         {"srdo: {node: actuator, srdo: 1, which: normal}, ", "srdo: {node: actuator, srdo: 1}, ",
          "srdo: {node: controller, srdo: 2, which: normal}, ", "identifier: 0x103, ", "identifier: [0x103, 0x104], ",
          "", "sender: controller, "})
    {
        const auto run =
            RunChainOf({}, std::string("faults:\n  - {fault: corruption, name: bits, bits: [0], frames: {") + choice +
                               "receiver: actuator, from: 511.5 ms}}\n" + spread +
                               "expect:\n  - {that: safe_within, node: actuator, srdo: 1, fault: bits}\n");
        EXPECT_EQ(Failures(*run), "") << choice;
        EXPECT_EQ(MeasurementOf(*run).limit, 3000 * kUs) << choice;
        EXPECT_GE(MeasurementOf(*run).reference, MeasurementOf(*run).effect + 4000 * kUs) << choice;
    }
    // A frame of another length is shown by itself, and so is a wrong inverse frame
    for (const char* const hit : {"identifier: 0x103, from: 500 ms}, length: 1}", "identifier: 0x104, from: 500 ms}, "
                                                                                  "bits: [15]}"})
    {
        const auto run = RunChainOf({}, std::string("faults:\n  - {fault: corruption, frames: {receiver: actuator, ") +
                                            hit + "\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
        EXPECT_EQ(Failures(*run), "") << hit;
        EXPECT_EQ(MeasurementOf(*run).reference, MeasurementOf(*run).effect) << hit;
    }
}

// SCT 50 ms, SRVT 45 ms, refresh 25 ms: what silences the bus behind a normal frame is found by SRVT, 70 ms after the
// last good one; SCT would have been over at 50 ms.
TEST(JudgedLimit, OfAFaultOfTheBusHasSrvtInItWhereTheNextNormalFrameCame)
{
    Verifies(req::SRS_SIM_215);
    const Values slow{{"1301sub3", "45"}};
    for (const char* const fault :
         {"fault: loss, frames: {identifier: [0x103, 0x104], receiver: actuator, from: 500 ms, "
          "first: 2, count: 1000}",
          "fault: loss, frames: {srdo: {node: actuator, srdo: 1}, receiver: actuator, first: "
          "42, count: 1000}",
          "fault: loss, frames: {receiver: actuator, sender: controller, from: 500 ms, first: "
          "2, count: 1000}"})
    {
        const auto run =
            RunChainOf({{"actuator", slow}}, std::string("faults:\n  - {") + fault +
                                                 "}\nexpect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
        EXPECT_EQ(Failures(*run), "") << fault;
        EXPECT_EQ(MeasurementOf(*run).limit, 98000 * kUs) << fault;
        EXPECT_EQ(MeasurementOf(*run).fault_class, FaultClass::kBusNextNormal) << fault;
    }
    // Without it SCT holds alone
    const auto run = RunChainOf({{"actuator", slow}},
                                "faults:\n  - {fault: loss, frames: {receiver: actuator, from: 500 ms, count: 1000}}\n"
                                "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    EXPECT_EQ(Failures(*run), "");
    EXPECT_EQ(MeasurementOf(*run).limit, 53000 * kUs);
}

// Frames that the actuator does not consume are lost: that closes nothing. 10 ms later others are, which does.
TEST(JudgedLimit, IsNotKeptByAnOutputThatAnotherFaultCloses)
{
    Verifies(req::SRS_SIM_068);
    const std::string harmless =
        "faults:\n  - {fault: loss, name: harmless, frames: {identifier: 0x101, receiver: actuator, from: 500 ms}}\n"
        "  - {fault: loss, name: deadly, frames: {identifier: [0x103, 0x104], receiver: actuator, from: 510 ms, count: "
        "1000}}\n";
    const auto run = RunChainOf({}, harmless + "expect:\n  - {that: safe_within, node: actuator, srdo: 1, fault: "
                                               "harmless}\n  - {that: safe_within, node: actuator, srdo: 1, fault: "
                                               "deadly}\n");
    ASSERT_EQ(run->Verdicts().size(), 2U);
    EXPECT_FALSE(run->Verdicts()[0].holds);
    EXPECT_NE(run->Verdicts()[0].seen.find("by another fault ('deadly')"), std::string::npos)
        << run->Verdicts()[0].seen;
    EXPECT_TRUE(run->Verdicts()[0].measurement->is_of_another);
    EXPECT_FALSE(run->Verdicts()[0].measurement->Holds());
    EXPECT_TRUE(run->Verdicts()[1].holds) << run->Verdicts()[1].seen;
}

// A normal frame is wrong, which alone is answered in time; its inverse frame never leaves, which SRVT answers later.
TEST(JudgedLimit, TellsEachOtherFaultThatHadAnEffectBefore)
{
    Verifies(req::SRS_SIM_068);
    // Given a lost frame, another one behind it, what closes the output, and what comes when it is closed
    const auto run = RunChainOf(
        {},
        "faults:\n  - {fault: loss, name: first, frames: {identifier: 0x101, receiver: actuator, from: 500 ms}}\n"
        "  - {fault: loss, name: second, frames: {identifier: 0x102, receiver: actuator, from: 500 ms}}\n"
        "  - {fault: loss, name: deadly, frames: {identifier: [0x103, 0x104], receiver: actuator, from: 510 ms, count: "
        "1000}}\n"
        "  - {fault: loss, name: behind, frames: {identifier: 0x101, receiver: actuator, from: 700 ms}}\n"
        "expect:\n  - {that: safe_within, node: actuator, srdo: 1, fault: first}\n");
    // Then those before the end are named, but for the fault itself
    EXPECT_FALSE(run->Verdicts()[0].holds);
    EXPECT_NE(run->Verdicts()[0].seen.find(" by another fault ('second', 'deadly')"), std::string::npos)
        << run->Verdicts()[0].seen;
}

TEST(JudgedLimit, OfAFaultThatIsAnsweredLateBecauseOfAnotherTellsTheOther)
{
    Verifies(req::SRS_SIM_068);
    const std::string wrong = "faults:\n  - {fault: corruption, name: wrong, bits: [6], frames: {identifier: 0x103, "
                              "receiver: actuator, from: 500 ms}}\n";
    const std::string away = "  - {fault: swallowed, name: away, frames: {identifier: 0x104, from: 500 ms}}\n";
    const std::string expect = "expect:\n  - {that: safe_within, node: actuator, srdo: 1, fault: wrong}\n";
    EXPECT_EQ(Failures(*RunChainOf({}, wrong + expect)), "");
    const auto run = RunChainOf({}, wrong + away + expect);
    EXPECT_FALSE(run->Verdicts()[0].holds);
    EXPECT_NE(run->Verdicts()[0].seen.find(" by another fault ('away')"), std::string::npos) << run->Verdicts()[0].seen;
    EXPECT_TRUE(run->Verdicts()[0].measurement->is_of_another);
}

// Two that each close it at the same instant are both answered in time.
TEST(JudgedLimit, IsKeptForEachOfTwoFaultsThatCloseTheOutputAlone)
{
    Verifies(req::SRS_SIM_068);
    const auto run = RunChainOf(
        {},
        "faults:\n  - {fault: loss, name: one, frames: {identifier: [0x103, 0x104], receiver: actuator, from: 500 ms, "
        "count: 1000}}\n"
        "  - {fault: loss, name: two, frames: {receiver: actuator, from: 500 ms, count: 1000}}\n"
        "expect:\n  - {that: safe_within, node: actuator, srdo: 1, fault: one}\n"
        "  - {that: safe_within, node: actuator, srdo: 1, fault: two}\n");
    EXPECT_EQ(Failures(*run), "");
}

// An inverse frame that comes 200 us later disturbs nobody; 30 ms later one is lost, which SRVT finds.
TEST(Detection, IsNotCreditedToAFaultThatNobodyNoticed)
{
    Verifies(req::SRS_SIM_073);
    Verifies(req::SRS_SIM_340);
    const std::string faults =
        "faults:\n  - {fault: delay, name: harmless, by: 200 us, frames: {identifier: 0x104, receiver: actuator, from: "
        "500 ms}}\n  - {fault: loss, name: real, frames: {identifier: 0x104, receiver: actuator, from: 530 ms}}\n";
    const auto run = RunChainOf({}, faults + "expect:\n"
                                             "  - {that: detected_by, node: actuator, fault: harmless, by: nobody}\n"
                                             "  - {that: detected_by, node: actuator, fault: real, by: channels}\n"
                                             "  - {that: detected_by, node: actuator, fault: harmless, by: channels}\n"
                                             "  - {that: safe_within, node: actuator, srdo: 1, fault: harmless}\n");
    ASSERT_EQ(run->Verdicts().size(), 4U);
    EXPECT_TRUE(run->Verdicts()[0].holds) << run->Verdicts()[0].seen;
    EXPECT_EQ(run->Verdicts()[0].seen.rfind("nobody; channels (srvt) at ", 0U), 0U) << run->Verdicts()[0].seen;
    EXPECT_NE(run->Verdicts()[0].seen.find(" found another fault ('real')"), std::string::npos)
        << run->Verdicts()[0].seen;
    EXPECT_TRUE(run->Verdicts()[1].holds) << run->Verdicts()[1].seen;
    EXPECT_EQ(run->Verdicts()[1].seen, "channels (srvt)");
    EXPECT_FALSE(run->Verdicts()[2].holds) << run->Verdicts()[2].seen;
    ASSERT_TRUE(run->Verdicts()[3].measurement);
    EXPECT_EQ(run->Verdicts()[3].measurement->detection.party, Party::kNobody);
}

// Behind one that was found another is found by itself; and each of two that bring the same at one instant is found.
TEST(Detection, IsThatOfEachOfSeveralFaults)
{
    Verifies(req::SRS_SIM_073);
    const std::string expect = "expect:\n  - {that: detected_by, node: actuator, fault: one, by: channels}\n"
                               "  - {that: detected_by, node: actuator, fault: two, by: channels}\n";
    for (const char* const second : {"from: 600 ms", "from: 500 ms, count: 2"})
    {
        const auto run = RunChainOf(
            {}, std::string("faults:\n"
                            "  - {fault: loss, name: one, frames: {identifier: 0x104, receiver: actuator, from: 500 "
                            "ms}}\n  - {fault: loss, name: two, frames: {identifier: 0x104, receiver: actuator, ") +
                    second + "}}\n" + expect);
        EXPECT_EQ(Failures(*run), "") << second;
    }
}

// Two frames of one SRDO are wrong in two ways, and a frame is wrong while a clock jumps: found in one cycle each.
TEST(Detection, TellsEachOfWhatOneCycleNoticed)
{
    Verifies(req::SRS_SIM_073);
    Verifies(req::SRS_SIM_340);
    const auto frames = RunChain(
        "faults:\n"
        "  - {fault: corruption, name: one, frames: {identifier: 0x103, receiver: actuator, from: 500 ms}, "
        "length: 1}\n"
        "  - {fault: insertion, name: two, at: 511.7 ms, identifier: 0x104, data: [1, 1], receiver: actuator}\n"
        "expect:\n"
        "  - {that: detected_by, node: actuator, fault: one, by: channels}\n"
        "  - {that: detected_by, node: actuator, fault: two, by: channels}\n");
    EXPECT_EQ(Failures(*frames), "");
    EXPECT_EQ(frames->Verdicts()[0].seen, "channels (length)");
    EXPECT_EQ(
        frames->Verdicts()[1].seen.rfind("channels (inverse_first); channels (length) at 511.807 ms found another "
                                         "fault ('one')",
                                         0U),
        0U)
        << frames->Verdicts()[1].seen;
    const auto clock = RunChainOf(
        {}, "faults:\n"
            "  - {fault: corruption, name: one, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}, "
            "bits: [0]}\n"
            "  - {fault: clock, name: two, node: actuator, counter: a, jump: 30 ms, at: 511.2 ms}\n"
            "expect:\n"
            "  - {that: detected_by, node: actuator, fault: one, by: channels}\n"
            "  - {that: detected_by, node: actuator, fault: two, by: clock_supervisor}\n");
    EXPECT_EQ(Failures(*clock), "");
}

// A clock within its tolerance, which nobody notices, lets the cycles fall elsewhere; a comparator that is blind for
// less than its test interval leaves a frozen channel to the flow monitor.
TEST(Detection, ThatAFaultOnlyShiftsIsAnothers)
{
    Verifies(req::SRS_SIM_068);
    Verifies(req::SRS_SIM_073);
    const auto clock = RunChain(
        "faults:\n"
        "  - {fault: clock, name: slow, node: actuator, counter: both, ppm: 45000, at: 480 ms, until: 560 ms}\n"
        "  - {fault: loss, name: lost, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}}\n"
        "expect:\n"
        "  - {that: detected_by, fault: slow, node: actuator, by: nobody}\n"
        "  - {that: safe_within, fault: slow, node: actuator, srdo: 1}\n"
        "  - {that: detected_by, fault: lost, node: actuator, by: channels}\n"
        "  - {that: safe_within, fault: lost, node: actuator, srdo: 1}\n");
    EXPECT_TRUE(clock->Verdicts()[0].holds) << clock->Verdicts()[0].seen;
    EXPECT_FALSE(clock->Verdicts()[1].holds) << clock->Verdicts()[1].seen;
    EXPECT_NE(clock->Verdicts()[1].seen.find(" by another fault ('lost')"), std::string::npos);
    EXPECT_TRUE(clock->Verdicts()[2].holds) << clock->Verdicts()[2].seen;
    EXPECT_TRUE(clock->Verdicts()[3].holds) << clock->Verdicts()[3].seen;
    const auto blind =
        RunChain("duration: 1500 ms\nfaults:\n"
                 "  - {fault: always_good, name: blind, node: actuator, part: comparator, at: 400 ms, until: 600 ms}\n"
                 "  - {fault: frozen, name: frozen, node: actuator, part: channel_a, at: 500 ms}\n"
                 "expect:\n"
                 "  - {that: detected_by, fault: blind, node: actuator, by: nobody}\n"
                 "  - {that: detected_by, fault: frozen, node: actuator, by: flow_monitor}\n");
    EXPECT_EQ(Failures(*blind), "");
}

// Six pairs are lost at each CPU. Either loss alone is found sooner, by the CPU that gets no frames, than both.
TEST(JudgedLimit, IsKeptForEachOfTwoFaultsThatDelayEachOther)
{
    Verifies(req::SRS_SIM_068);
    const std::string chain = std::string(COUNTERPOINT_SOURCE_FOLDER) + "/examples/two_cpus/chain.yaml";
    const auto run = RunOf("extends: " + chain +
                           "\nfaults:\n"
                           "  - {fault: loss, name: one, frames: {identifier: [0x103, 0x104], receiver: actuator.a, "
                           "from: 500 ms, count: 6}}\n"
                           "  - {fault: loss, name: two, frames: {identifier: [0x103, 0x104], receiver: actuator.b, "
                           "from: 500 ms, count: 6}}\n"
                           "expect:\n"
                           "  - {that: safe_within, fault: one, node: actuator, srdo: 1}\n"
                           "  - {that: safe_within, fault: two, node: actuator, srdo: 1}\n");
    EXPECT_EQ(Failures(*run), "");
}

// An inverse frame that comes behind the next normal one, 25 ms later: it stays away from the instant on at which it
// should have come, as one that is late by so much.
TEST(JudgedLimit, OfAFrameOutOfOrderCountsFromWhereItStaysAway)
{
    Verifies(req::SRS_SIM_213);
    const auto run_with = [](const char* const detection, const std::string& fault)
    {
        return RunChainOf({{"actuator", {{"5F05sub1", detection}}}},
                          "faults:\n  - {" + fault +
                              ", frames: {identifier: 0x104, receiver: actuator, from: 500 ms}}\n"
                              "expect:\n  - {that: safe_within, node: actuator, srdo: 1}\n");
    };
    for (const char* const detection : {"0x00", "0x3C"}) // Early, late.
    {
        const auto late = run_with(detection, "fault: delay, by: 24.6 ms");
        const auto wrong_order = run_with(detection, "fault: wrong_sequence");
        EXPECT_EQ(Failures(*wrong_order), "") << detection;
        EXPECT_EQ(MeasurementOf(*wrong_order).effect, MeasurementOf(*late).effect) << detection;
        EXPECT_EQ(MeasurementOf(*wrong_order).limit, MeasurementOf(*late).limit) << detection;
    }
}

// Of two frames on neighbouring places the first one is held back and the second one lost: the first still comes, so
// that its pair is late for want of the inverse frame (SRVT 20 ms), not both of them (SCT 25 ms).
TEST(JudgedLimit, AFrameThatIsHeldBackComesAlthoughTheNextOneIsLost)
{
    Verifies(req::SRS_SIM_213);
    const std::string held = "  - {name: held, fault: wrong_sequence, frames: {identifier: 0x103, receiver: actuator, "
                             "from: 500 ms}}\n";
    const std::string lost =
        "  - {name: lost, fault: loss, frames: {identifier: 0x104, receiver: actuator, from: 500 ms}}\n";
    const std::string expect =
        "expect:\n  - {that: safe_within, fault: lost, node: actuator, srdo: 1, limit: bus_next_normal}\n";
    const auto one = RunChainOf({}, "faults:\n" + lost + expect);
    const auto both = RunChainOf({}, "faults:\n" + held + lost + expect);
    EXPECT_GT(MeasurementOf(*one).closed, 0);
    EXPECT_EQ(MeasurementOf(*both).closed, MeasurementOf(*one).closed);
}

// The sensor's application sends: refresh 25 ms, cycle 1 ms. Whenever the button changes, no frame that ends more than
// a cycle and a frame later has the old value.
TEST(SentByTheApplication, HasTheNewValueAtOnce)
{
    Verifies(req::SRS_SIM_069);
    for (int place = 0; place < 25; place += 3)
    {
        const std::string dcf = DeviceWith("sensor", {{"5F03sub1", "0x00"}});
        const std::string at = std::to_string(500 + place) + ".3 ms";
        const auto run =
            RunOf("duration: 600 ms\nnodes:\n  sensor: {dcf: " + dcf + "}\n  actuator: {dcf: " + Examples() +
                  "actuator.dcf}\ninputs:\n"
                  "  - {at: 20 ms, node: sensor, object: 0x2000:01, value: 1}\n"
                  "  - {at: " +
                  at + ", node: sensor, object: 0x2000:01, value: 0}\n");
        const Nanoseconds changed = (500 + place) * kNanosecondsPerMillisecond + 300 * kUs;
        Nanoseconds told = -1;
        for (const FrameEntry& frame : run->Record().Frames())
        {
            const bool is_after = frame.frame.identifier == 0x101U && frame.start >= changed;
            if (is_after)
            {
                EXPECT_EQ(frame.frame.data[0], 0U) << at;
                told = (told < 0) ? frame.end : told;
            }
        }
        EXPECT_GE(told, changed) << at;
        EXPECT_LE(told, changed + 3 * kNanosecondsPerMillisecond) << at;
    }
}

// A provider is asked at each refresh, 25 ms apart: a frame that begins behind the change has the new value, also where
// the input changed in the very cycle before.
TEST(SentByTheProvider, HasTheInputAsItIsWhenItIsAsked)
{
    Verifies(req::SRS_SIM_072);
    const std::string dcf = DeviceWith("sensor", {{"5F03sub1", "0x01"}});
    std::size_t told = 0U;
    for (int place = 0; place < 25; ++place)
    {
        const auto run =
            RunOf("duration: 560 ms\nnodes:\n  sensor: {dcf: " + dcf + "}\n  actuator: {dcf: " + Examples() +
                  "actuator.dcf}\ninputs:\n"
                  "  - {at: 20 ms, node: sensor, object: 0x2000:01, value: 1}\n"
                  "  - {at: " +
                  std::to_string(500 + place) + ".3 ms, node: sensor, object: 0x2000:01, value: 0}\n");
        const Nanoseconds changed = (500 + place) * kNanosecondsPerMillisecond + 300 * kUs;
        for (const FrameEntry& frame : run->Record().Frames())
        {
            const bool is_after = frame.frame.identifier == 0x101U && frame.start >= changed;
            told += is_after ? 1U : 0U;
            EXPECT_EQ(is_after ? frame.frame.data[0] : 0U, 0U) << place;
        }
    }
    EXPECT_GE(told, 25U);
}

/// A section with one value of a DCF.
std::string Entry(const std::string& section, const char* const type, const std::string& value,
                  const std::string& more = "PDOMapping=0\n")
{
    return "\n[" + section + "]\nParameterName=" + section + "\nObjectType=0x7\nDataType=" + type +
           "\nAccessType=" + ((more == "PDOMapping=0\n") ? "rw" : "ro") + "\nDefaultValue=" + value +
           "\nParameterValue=" + value + "\n" + more;
}

std::string RecordOf(const std::string& index, const unsigned entries)
{
    return "\n[" + index + "]\nParameterName=" + index + "\nObjectType=0x9\nSubNumber=" + std::to_string(entries + 1U) +
           "\n" + Entry(index + "sub0", "0x0005", std::to_string(entries));
}

std::string Hexadecimal(const unsigned number)
{
    std::ostringstream text;
    text << std::hex << std::uppercase << number;
    return text.str();
}

/// Another value of a key in a section.
void Set(std::string& text, const std::string& section, const std::string& key, const std::string& value)
{
    const std::size_t begin = text.find("\n" + key + "=", text.find("[" + section + "]")) + key.size() + 2U;
    text.replace(begin, text.find('\n', begin) - begin, value);
}

/// One more object in a list of objects, which has `known` of them.
void List(std::string& text, const std::string& section, const unsigned known, const std::string& index)
{
    const std::string number = std::to_string(known + 1U);
    Set(text, section, "SupportedObjects", number + "\n" + number + "=0x" + index);
}

/// The sensor with `count` SRDOs, all producers with a refresh time of 25 ms.
std::string SensorWith(const unsigned count)
{
    std::string text = TextOf(Examples() + "sensor.dcf");
    std::string sections;
    for (unsigned number = 2U; number <= count; ++number)
    {
        const std::string communication = Hexadecimal(0x1300U + number);
        const std::string mapping = Hexadecimal(0x1380U + number);
        const std::string normal = Hexadecimal(0x4000U + number);
        const std::string inverse = Hexadecimal(0x4100U + number);
        const unsigned known = 8U + 2U * (number - 2U); // Both lists have eight at first.
        List(text, "OptionalObjects", known, communication);
        List(text, "OptionalObjects", known + 1U, mapping);
        List(text, "ManufacturerObjects", known, normal);
        List(text, "ManufacturerObjects", known + 1U, inverse);
        const std::string sub = Hexadecimal(number);
        sections += RecordOf(communication, 6U) + Entry(communication + "sub1", "0x0005", "1") +
                    Entry(communication + "sub2", "0x0006", "25") + Entry(communication + "sub3", "0x0005", "20") +
                    Entry(communication + "sub4", "0x0005", "254") +
                    Entry(communication + "sub5", "0x0007", std::to_string(0xFFU + (2U * number))) +
                    Entry(communication + "sub6", "0x0007", std::to_string(0x100U + (2U * number))) +
                    RecordOf(mapping, 2U) + Entry(mapping + "sub1", "0x0007", "0x" + normal + "0008") +
                    Entry(mapping + "sub2", "0x0007", "0x" + inverse + "0008") +
                    Entry(normal, "0x0005", "0", "SRDOMapping=1\nInvertedSRAD=0x" + inverse + "00\n") +
                    Entry(inverse, "0x0005", "0xFF", "SRDOMapping=1\n") +
                    Entry("13FFsub" + sub, "0x0006", "0", "PDOMapping=0\n") + Entry("5F03sub" + sub, "0x0005", "1");
    }
    for (const char* const array : {"13FF", "5F03"})
    {
        Set(text, array, "SubNumber", std::to_string(count + 1U));
        Set(text, std::string(array) + "sub0", "DefaultValue", std::to_string(count));
    }
    const cia306::IniDocument document = cia306::IniDocument::Parse("sensor", text + sections);
    const cia306::Device device = cia306::ReadDevice(document);
    return TextFile(cia306::WithSignatures(document, device, device.node_id).Text(), ".many.dcf");
}

/// A device that consumes both SRDOs of such a sensor.
std::string ConsumerOfTwo()
{
    std::string text = TextOf(SensorWith(2U));
    for (const char* const index : {"1301", "1302"})
    {
        Set(text, std::string(index) + "sub1", "ParameterValue", "2");
        Set(text, std::string(index) + "sub2", "ParameterValue", "50");
    }
    for (const char* const variable : {"2000sub1", "2000sub2", "2100sub1", "2100sub2", "4002", "4102"})
    {
        Set(text, variable, "AccessType", "rw");
    }
    Set(text, "DeviceComissioning", "NodeID", "9");
    const cia306::IniDocument document = cia306::IniDocument::Parse("consumer", text);
    const cia306::Device device = cia306::ReadDevice(document);
    return TextFile(cia306::WithSignatures(document, device, device.node_id).Text(), ".consumer.dcf");
}

// In one cycle SRDO 1 has a frame of another length and SRDO 2 one with a wrong bit, or the other way round; or both
// the same.
TEST(Detection, IsThatOfEachSrdo)
{
    Verifies(req::SRS_SIM_073);
    Verifies(req::SRS_SIM_340);
    const std::string consumer = ConsumerOfTwo();
    const std::string devices = "duration: 700 ms\nnodes:\n  sensor: {dcf: " + SensorWith(2U) +
                                "}\n  consumer: {dcf: " + consumer +
                                "}\nacknowledge:\n  - {at: 100 ms, node: consumer, srdo: 1}\n"
                                "  - {at: 100 ms, node: consumer, srdo: 2}\n";
    const std::string expect = "expect:\n  - {that: detected_by, fault: one, node: consumer, by: channels}\n"
                               "  - {that: safe_within, fault: one, node: consumer, srdo: 1}\n"
                               "  - {that: detected_by, fault: two, node: consumer, by: channels}\n"
                               "  - {that: safe_within, fault: two, node: consumer, srdo: 2}\n";
    for (const auto& [one, two] : {std::pair("length: 3", "bits: [0]"), std::pair("bits: [0]", "length: 3"),
                                   std::pair("bits: [0]", "bits: [0]")})
    {
        const auto run = RunOf(devices +
                               "faults:\n"
                               "  - {fault: corruption, name: one, frames: {identifier: 0x102, receiver: consumer, "
                               "from: 500 ms}, " +
                               one +
                               "}\n"
                               "  - {fault: corruption, name: two, frames: {identifier: 0x104, receiver: consumer, "
                               "from: 500 ms}, " +
                               two + "}\n" + expect);
        EXPECT_EQ(Failures(*run), "") << one;
    }
}

// All SRDOs of a device begin at one instant and have one refresh time: they are due in one cycle, again and again.
TEST(ManyProducers, AllDueInOneCycleAreSent)
{
    Verifies(req::SRS_SIM_070);
    for (const unsigned count : {16U, 17U, 24U, 40U})
    {
        const auto run = RunOf("duration: 600 ms\nbitrate: 1000000\nnodes:\n  sensor: {dcf: " + SensorWith(count) +
                               ", self_tests: false}\n  actuator: {dcf: " + Examples() +
                               "actuator.dcf}\nexpect:\n  - {that: no_fault, node: sensor}\n");
        EXPECT_EQ(Failures(*run), "") << count;
        std::size_t last = 0U; // Frames of the last SRDO.
        for (const FrameEntry& frame : run->Record().Frames())
        {
            last += (frame.frame.identifier == 0x100U + 2U * count) ? 1U : 0U;
        }
        EXPECT_GE(last, 20U) << count;
    }
}
} // namespace
} // namespace counterpoint::simulator
