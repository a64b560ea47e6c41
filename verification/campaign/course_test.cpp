// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Faults that are no bits of memory: frames, calls, steps, cycle, counters, inputs; and what the judge says of them.
#include "safety_core/kernel/safe_state_latch.hpp"
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/variants.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <map>
#include <set>
#include <utility>

namespace counterpoint::campaign::test
{
namespace
{
/// The device of a test in which nobody hears what the comparator finds about itself: the linker leads the calls of
/// SafeStateLatch::Enter here (--wrap), the objects stay as they ship.
bool is_comparator_mute = false;
} // namespace

extern "C"
{
    void __real__ZN12counterpoint14SafeStateLatch5EnterENS_11DeviceFaultEh(SafeStateLatch* self, DeviceFault fault,
                                                                           SlotIndex slot);
    void __wrap__ZN12counterpoint14SafeStateLatch5EnterENS_11DeviceFaultEh(SafeStateLatch* self,
                                                                           const DeviceFault fault,
                                                                           const SlotIndex slot)
    {
        if ((!is_comparator_mute) || (fault != DeviceFault::kComparator))
        {
            __real__ZN12counterpoint14SafeStateLatch5EnterENS_11DeviceFaultEh(self, fault, slot);
        }
    }
}

namespace
{
using CourseTest = CampaignTest;

/// All outcomes of a plan: how many of each class and kind.
struct Counts
{
    std::map<std::string, std::uint64_t> of; ///< "kind class"
    std::uint64_t late{0U};
    std::uint64_t silent{0U}; ///< But for answers to the gate that are wrong once.
};

/// What comes to the gate is old or comes twice: it closes for these cycles, and opens again by itself.
bool IsAnswer(const Experiment& fault)
{
    const bool is_call = (fault.part == Part::kCallsOfA || fault.part == Part::kCallsOfB) &&
                         fault.subject / kTurns == static_cast<std::size_t>(ChannelCall::kAnswer);
    return is_call || (fault.kind == FaultKind::kDoubled && fault.phase == PhaseOf(FlowStep::kPermits));
}

class OutcomeTest : public CampaignTest
{
  protected:
    [[nodiscard]] Counts Tried(const std::string& device, const std::string& lines)
    {
        const Trap trap;
        Session session(PlanFile("plan.yaml", device, lines));
        Counts counts;
        for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
        {
            const Experiment fault = session.Faults().At(number);
            const Outcome outcome = session.Runs().Run(fault);
            ++counts.of[std::string(WordOf(fault.kind)) + " " + WordOf(outcome.result)];
            counts.late += IsLate(outcome) ? 1U : 0U;
            counts.silent += (outcome.result == Class::kSilent && !IsAnswer(fault)) ? 1U : 0U;
        }
        return counts;
    }
};

/// A recording with four frames 1 ms apart and a cycle behind each.
Recording FourFrames()
{
    Recording recording;
    for (std::size_t index = 0U; index < 4U; ++index)
    {
        const Nanoseconds at = 1000000 * static_cast<Nanoseconds>(index + 1U);
        RecordedFrame frame;
        frame.at = at;
        frame.stamped.frame = {(index % 2U == 0U) ? 0x101U : 0x102U,
                               FrameKind::kData,
                               CanPortId::kFirst,
                               1U,
                               {static_cast<std::uint8_t>(0x10U + index)}};
        recording.frames.push_back(frame);
        RecordedCycle cycle;
        cycle.at = at + 100000;
        cycle.frames_end = index + 1U;
        recording.cycles.push_back(cycle);
    }
    recording.pairs = {{0U, 1U}, {2U, 3U}};
    recording.identifiers = {0x101U, 0x102U};
    return recording;
}

/// Time in us, identifier, length and first byte of each frame that comes.
std::string Told(const FaultKind kind, const std::size_t subject, const std::uint32_t variant)
{
    const Recording recording = FourFrames();
    Course course(recording);
    Experiment fault;
    fault.part = Part::kBus;
    fault.kind = kind;
    fault.subject = subject;
    fault.variant = variant;
    course.Disturb(fault, 4U, 1U);
    std::ostringstream text;
    for (std::size_t position = 0U; course.FrameUntil(position, 9000000); ++position)
    {
        const RecordedFrame frame = *course.FrameUntil(position, 9000000);
        text << frame.at / 1000 << ":" << std::hex << frame.stamped.frame.identifier << "/"
             << unsigned{frame.stamped.frame.length_bytes} << "/" << unsigned{frame.stamped.frame.data[0]} << std::dec
             << " ";
    }
    return text.str();
}

TEST(Course, EachErrorOfTheBusIsWhatTheDeviceGets)
{
    Verifies(req::SRS_CMG_020);
    // Given 101h and 102h in turn, when it is undisturbed
    EXPECT_EQ(Told(FaultKind::kLost, 3U, 0U), "1000:101/1/10 2000:102/1/11 3000:101/1/12 ");
    EXPECT_EQ(Told(FaultKind::kLost, 0U, 1U), "3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kLost, 0U, kLosesIdentifier), "2000:102/1/11 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kLost, 1U, kLosesIdentifier + 1U), "1000:101/1/10 ");
    // 50 us later, and 1.05 ms later, behind the next frame
    EXPECT_EQ(Told(FaultKind::kRepeated, 0U, 0U),
              "1000:101/1/10 1050:101/1/10 2000:102/1/11 3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kDelayed, 0U, 20U), "2000:102/1/11 2050:101/1/10 3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kWrongOrder, 0U, 1U), "1000:101/1/12 2000:102/1/11 3000:101/1/10 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kCorrupted, 2U, 7U), "1000:101/1/10 2000:102/1/11 3000:101/1/92 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kWrongLength, 0U, 0U), "1000:101/0/10 2000:102/1/11 3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kWrongLength, 0U, 1U), "1000:101/2/10 2000:102/1/11 3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kWrongIdentifier, 0U, 10U), "1000:501/1/10 2000:102/1/11 3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kWrongIdentifier, 1U, 11U), "1000:101/1/10 2000:101/1/11 3000:101/1/12 4000:102/1/13 ");
    const std::string inserted = Told(FaultKind::kInserted, 0U, 0U);
    EXPECT_EQ(inserted.find("1000:101/1/10 1050:101/1/"), 0U) << inserted;
}

TEST(Course, CompletePairsMoveTogether)
{
    Verifies(req::SRS_CMG_021);
    EXPECT_EQ(Told(FaultKind::kPairRepeated, 0U, 9U),
              "1000:101/1/10 1500:101/1/10 2000:102/1/11 2500:102/1/11 3000:101/1/12 4000:102/1/13 ");
    EXPECT_EQ(Told(FaultKind::kPairDelayed, 0U, 9U), "1500:101/1/10 2500:102/1/11 3000:101/1/12 4000:102/1/13 ");
    const std::string forged = Told(FaultKind::kPairForged, 1U, 0U);
    EXPECT_EQ(forged.find("1000:101/1/10 2000:102/1/11 3000:101/1/12 3050:101/1/"), 0U) << forged;
}

TEST(Course, CallsOfTheCycleMoveInTime)
{
    Verifies(req::SRS_CMG_561);
    // Given cycles at 1.1, 2.1, 3.1 and 4.1 ms, of which the second one is hit
    const Recording recording = FourFrames();
    Course course(recording);
    Experiment fault;
    fault.part = Part::kCycle;
    fault.cycle = 1U;
    const auto told = [&course, &fault](const FaultKind kind, const std::uint32_t variant)
    {
        fault.kind = kind;
        fault.variant = variant;
        course.Disturb(fault, 4U, 1U);
        std::string text;
        for (std::size_t cycle = 0U; cycle < 4U; ++cycle)
        {
            const Calls calls = course.CallsIn(cycle);
            for (std::size_t index = 0U; index < calls.count; ++index)
            {
                text += std::to_string(calls.at.at(index) / 1000) + " ";
            }
        }
        return text;
    };
    EXPECT_EQ(told(FaultKind::kSkipped, 0U), "1100 3100 4100 ");
    EXPECT_EQ(told(FaultKind::kSkipped, 1U), "1100 4100 ");
    EXPECT_EQ(told(FaultKind::kSkipped, 2U), "1100 ");
    EXPECT_EQ(told(FaultKind::kDoubled, 0U), "1100 2100 2100 3100 4100 ");
    EXPECT_EQ(told(FaultKind::kEarly, 1U), "1100 2000 3100 4100 ");
    EXPECT_EQ(told(FaultKind::kLate, 1U), "1100 2200 3100 4100 ");
    EXPECT_EQ(told(FaultKind::kLate, 20U), "1100 3150 4100 "); // The one that was due at 3.1 ms did not come.
}

TEST(Course, CountersStopRunAndJumpEachAndBoth)
{
    Verifies(req::SRS_CMG_023);
    const Recording recording = FourFrames();
    Course course(recording);
    Experiment fault;
    fault.part = Part::kCounters;
    fault.cycle = 1U; // From 1.1 ms on.
    const auto told = [&course, &fault](const FaultKind kind, const std::size_t subject, const std::uint32_t variant)
    {
        fault.kind = kind;
        fault.subject = subject;
        fault.variant = variant;
        course.Disturb(fault, 4U, 1U);
        const InstantPair pair = course.Stamp(3100000);
        return std::to_string(pair.a.us) + " " + std::to_string(pair.b.us);
    };
    EXPECT_EQ(told(FaultKind::kStopped, 0U, 0U), "1100 3100");
    EXPECT_EQ(told(FaultKind::kStopped, 1U, 0U), "3100 1100");
    EXPECT_EQ(told(FaultKind::kStopped, 2U, 0U), "1100 1100");
    EXPECT_EQ(told(FaultKind::kFast, 1U, 9U), "3100 3300");  // 10 %
    EXPECT_EQ(told(FaultKind::kSlow, 0U, 11U), "2100 3100"); // 50 %
    EXPECT_EQ(told(FaultKind::kJump, 0U, 0U), "3150 3100");
    EXPECT_EQ(told(FaultKind::kJump, 0U, 3U), "3000 3100");
    // and nothing is left of it
    course.Clear();
    EXPECT_EQ(course.Stamp(3100000).a.us, 3100U);
}

TEST_F(OutcomeTest, NoErrorOfOneFrameIsSilentOrListed)
{
    Verifies(req::SRS_CMG_020);
    // Given all frames of 50 ms, in which the buttons change, and a grid up to 3 ms
    const Counts counts = Tried("actuator", "at: [540 ms]\ncycles: 50\nreach: 3 ms\nparts: [bus]\n"
                                            "kinds: [lost, repeated, inserted, wrong_order, delayed, corrupted, "
                                            "wrong_length, wrong_identifier]\n");
    // Then each of its errors is found, and nothing is silent, late, or has a limit that is listed
    for (const char* const kind :
         {"lost", "repeated", "inserted", "wrong_order", "delayed", "corrupted", "wrong_length", "wrong_identifier"})
    {
        EXPECT_EQ(counts.of.count(std::string(kind) + " silent"), 0U) << kind;
        EXPECT_EQ(counts.of.count(std::string(kind) + " listed"), 0U) << kind;
        EXPECT_GT(counts.of.at(std::string(kind) + " detected"), 0U) << kind;
    }
    EXPECT_EQ(counts.late, 0U);
}

// One cycle signals several causes: what is told is the one that came first, as the channels keep it.
TEST_F(OutcomeTest, ReasonIsTheFirstCauseOfTheCycle)
{
    Verifies(req::SRS_CMG_006);
    const Trap trap;
    const auto reasons = [this](const char* const kind, const std::uint32_t identifier, const std::uint32_t steps)
    {
        Session session(
            PlanFile("plan.yaml", "actuator",
                     "at: [540 ms]\ncycles: 50\nreach: 20 ms\nparts: [bus]\nkinds: [" + std::string(kind) + "]\n"));
        std::set<SrdoCause> causes;
        for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
        {
            const Experiment fault = session.Faults().At(number);
            const CanFrame& frame = session.Parts().recording.frames[fault.subject].stamped.frame;
            if (frame.identifier == identifier && fault.variant + 1U == steps)
            {
                causes.insert(static_cast<SrdoCause>(session.Runs().Run(fault).detail));
            }
        }
        return causes;
    };
    // A copy 50 us behind the normal frame is the second one; the inverse frame is left over.
    EXPECT_EQ(reasons("repeated", 0x103U, 1U), std::set<SrdoCause>{SrdoCause::kNormalTwice});
    // An inverse frame that is 19.9 ms late comes when SRVT of 20 ms has expired.
    EXPECT_EQ(reasons("delayed", 0x104U, 398U), std::set<SrdoCause>{SrdoCause::kSrvt});
}

TEST_F(OutcomeTest, CompleteForgedPairIsListed)
{
    Verifies(req::SRS_CMG_021);
    const Counts counts = Tried("actuator", "at: [540 ms]\ncycles: 50\nreach: 3 ms\nparts: [bus]\n"
                                            "kinds: [pair_repeated, pair_delayed, pair_forged]\n");
    EXPECT_GT(counts.of.at("pair_forged listed"), 0U);
    EXPECT_EQ(counts.of.count("pair_repeated silent") + counts.of.count("pair_delayed silent") +
                  counts.of.count("pair_forged silent"),
              0U);
}

TEST(BusView, JudgeTellsAPairThatNobodySentFromOneThatIsTooOldAndFromNone)
{
    Verifies(req::SRS_CMG_021);
    // Given pairs of 10h at 1 ms, and of 12h at 3 ms, SCT 50 ms, SRVT 20 ms
    Recording recording = FourFrames();
    recording.frames[1U].stamped.frame.data[0] = 0xEFU;
    recording.frames[3U].stamped.frame.data[0] = 0xEDU;
    runtime::SrdoModel srdo;
    srdo.cob_id_1 = 0x101U;
    srdo.cob_id_2 = 0x102U;
    srdo.times = {50U, 20U, SrvtDetection::kEarly};
    const BusView bus(recording, srdo, 8U);
    const auto leave = [&bus](const Received& received, const Nanoseconds now, const std::uint64_t data)
    { return bus.Allows(received, now, data, 0xFFU, 0); };
    Received received;
    EXPECT_EQ(leave(received, 2000000, 0U), Leave::kNone);
    // When the first one has come
    bus.Take(received, recording.frames[0U]);
    bus.Take(received, recording.frames[1U]);
    EXPECT_EQ(leave(received, 2000000, 0x10U), Leave::kGiven);
    EXPECT_EQ(leave(received, 2000000, 0x11U), Leave::kNone);
    EXPECT_EQ(leave(received, 71000001, 0x10U), Leave::kNone); // 70 ms behind its normal frame.
    // When the second one has come, and then the first one again
    bus.Take(received, recording.frames[2U]);
    bus.Take(received, recording.frames[3U]);
    EXPECT_EQ(leave(received, 4000000, 0x12U), Leave::kGiven);
    RecordedFrame again = recording.frames[0U];
    again.at = 5000000;
    bus.Take(received, again);
    again = recording.frames[1U];
    again.at = 6000000;
    bus.Take(received, again);
    // Then it is a complete pair that nobody sent behind the second one
    EXPECT_EQ(leave(received, 6000000, 0x10U), Leave::kListed);
    EXPECT_EQ(leave(received, 6000001, 0x12U), Leave::kNone);
    // When the second one is 60 ms late, it is a pair that was sent, until it is 70 ms old
    Received late;
    for (RecordedFrame frame : {recording.frames[2U], recording.frames[3U]})
    {
        frame.at += 60000000;
        bus.Take(late, frame);
    }
    EXPECT_EQ(leave(late, 73000000, 0x12U), Leave::kGiven);
    EXPECT_EQ(leave(late, 73000001, 0x12U), Leave::kListed);
}

// With late detection SCT is examined whether or not a normal frame waits for its inverse one.
TEST(BusView, WithLateDetectionAPairIsNoOlderThanSct)
{
    Verifies(req::SRS_CMG_005);
    // Given a pair of 10h at 1 ms, SCT 50 ms, SRVT 20 ms
    Recording recording = FourFrames();
    recording.frames[1U].stamped.frame.data[0] = 0xEFU;
    runtime::SrdoModel srdo;
    srdo.cob_id_1 = 0x101U;
    srdo.cob_id_2 = 0x102U;
    for (const auto& [detection, oldest] : {std::pair(SrvtDetection::kLate, Nanoseconds{51000000}),
                                            std::pair(SrvtDetection::kEarly, Nanoseconds{71000000})})
    {
        srdo.times = {50U, 20U, detection};
        const BusView bus(recording, srdo, 8U);
        Received received;
        bus.Take(received, recording.frames[0U]);
        bus.Take(received, recording.frames[1U]);
        EXPECT_EQ(bus.Allows(received, oldest, 0x10U, 0xFFU, 0), Leave::kGiven);
        EXPECT_EQ(bus.Allows(received, oldest + 1, 0x10U, 0xFFU, 0), Leave::kNone);
    }
}

TEST_F(OutcomeTest, CallsThatDoNotComeAreFoundOrChangeNothing)
{
    Verifies(req::SRS_CMG_022);
    Verifies(req::SRS_CMG_560);
    Verifies(req::SRS_CMG_561);
    const Counts counts = Tried("actuator", "at: [550 ms]\ncycles: 2\nparts: [steps, kernel_calls, a_calls, b_calls, "
                                            "cycle]\nreach: 2 ms\n");
    for (const char* const kind : {"skipped", "doubled", "reordered", "late", "early"})
    {
        EXPECT_GT(counts.of.at(std::string(kind) + " detected"), 0U) << kind;
    }
    EXPECT_EQ(counts.silent, 0U);
    EXPECT_EQ(counts.late, 0U);
}

TEST_F(OutcomeTest, CountersThatPartAreFoundByTheClockSupervision)
{
    Verifies(req::SRS_CMG_023);
    const Counts counts = Tried("actuator", "at: [550 ms]\ncycles: 1\nparts: [counters]\nkinds: [stopped, jump]\n");
    // Either alone is found; both stand still alike, which is no difference
    EXPECT_EQ(counts.of.at("stopped detected"), 2U);
    EXPECT_EQ(counts.of.at("stopped benign"), 1U);
    EXPECT_EQ(counts.of.count("jump silent"), 0U);
    EXPECT_GT(counts.of.at("jump detected"), 0U);
}

TEST_F(OutcomeTest, BitInEachChannelIsFoundOrChangesNothing)
{
    Verifies(req::SRS_CMG_024);
    const Trap trap;
    Session session(
        PlanFile("plan.yaml", "actuator", "at: [550 ms]\ncycles: 1\nparts: [both_channels]\nsample: 200\n"));
    ASSERT_EQ(session.Faults().Size(), 200U);
    std::uint64_t found = 0U;
    for (std::uint64_t number = 0U; number < 200U; ++number)
    {
        const Experiment fault = session.Faults().At(number);
        const std::vector<Place>& places = session.Parts().device.Places();
        EXPECT_EQ(places[fault.place].part, Part::kChannelA);
        EXPECT_EQ(places[fault.second.place].part, Part::kChannelB);
        const Outcome outcome = session.Runs().Run(fault);
        EXPECT_NE(outcome.result, Class::kSilent);
        found += (outcome.result == Class::kDetected) ? 1U : 0U;
    }
    EXPECT_GT(found, 20U);
    // A fault that is of one channel is told by its one place
    const Experiment one = FaultIn(session, "channel_b.data", 0U, 4U);
    EXPECT_EQ(PlaceText(session.Parts(), one), "channel_b.data+0.4");
}

TEST_F(OutcomeTest, InputThatIsStuckOnOneSideIsNoValidPair)
{
    Verifies(req::SRS_CMG_025);
    // Given the sensor's 16 bits on two sides, one of which changes at 550 ms
    const Counts counts = Tried("sensor", "at: [500 ms]\ncycles: 1\nparts: [inputs]\n");
    EXPECT_EQ(counts.of.count("stuck_at_0 silent") + counts.of.count("stuck_at_1 silent"), 0U);
    EXPECT_GT(counts.of.at("stuck_at_0 safe_other") + counts.of.at("stuck_at_1 safe_other"), 0U);
    // and the actuator's acknowledge, which opens nothing by itself
    const Counts acknowledge = Tried("actuator", "at: [500 ms]\ncycles: 1\nparts: [inputs]\n");
    EXPECT_EQ(acknowledge.of.count("stuck_at_1 silent"), 0U);
}

/// A bit of the comparator's verdict that would keep old data at the open output.
class StuckVerdictTest : public OutcomeTest
{
  protected:
    ~StuckVerdictTest() override
    {
        is_comparator_mute = false;
    }
    static constexpr const char* kLines = "at: [500 ms]\ncycles: 1\nphases: [comparison]\nkinds: [stuck_at_0]\n"
                                          "parts: [comparator]\nmembers: [comparator.verdict+8]\n";
};

TEST_F(StuckVerdictTest, IsFoundByTheComparatorsOwnDifferences)
{
    Verifies(req::SRS_CMP_011);
    const Counts counts = Tried("actuator", kLines);
    EXPECT_EQ(counts.of.count("stuck_at_0 silent"), 0U);
    EXPECT_EQ(counts.of.at("stuck_at_0 detected"), 1U);
    EXPECT_EQ(counts.late, 0U);
}

TEST_F(StuckVerdictTest, MarchFindsTheStuckBitThatNobodyCompares)
{
    Verifies(req::SRS_CMG_027);
    Verifies(req::SRS_CMG_151);
    // Given that nobody hears what the comparator finds there
    is_comparator_mute = true;
    const std::string lines = kLines;
    const Counts without = Tried("actuator", lines);
    EXPECT_EQ(without.of.at("stuck_at_0 silent"), 1U);
    // When the device has self tests, the march finds it within the diagnostic interval, and each other bit
    const Counts with = Tried("actuator", lines + "self_test: true\n");
    EXPECT_EQ(with.of.at("stuck_at_0 exposed"), 1U);
    EXPECT_EQ(with.of.at("stuck_at_0 detected"), 7U);
    EXPECT_EQ(with.late, 0U);
}

TEST_F(StuckVerdictTest, WhatIsNotClosedWithinTheLimitIsSilent)
{
    Verifies(req::SRS_CMG_151);
    // Given the same bits in a device with self tests, and a limit of 1 ms
    is_comparator_mute = true;
    const Trap trap;
    const Plan plan = ReadPlan(PlanFile("plan.yaml", "actuator", std::string(kLines) + "self_test: true\n"));
    const RecordedScenario scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node));
    Region region(1U << 20U);
    Device device(region, scenario.Model(), scenario.Record(), OutputKind::kGate, DeviceSetup{{}, false, true});
    Judge judge(scenario.Record(), scenario.Model(), device);
    Limits limits = LimitsOf(scenario.Model(), device.Config());
    limits.us[static_cast<std::size_t>(Part::kComparator)] = 1000U;
    const Space space(plan, scenario.Record(), device, HorizonOf(limits, device.Config()));
    Runner runner(device, judge, scenario.Record(), space, limits);
    // When each is stuck
    std::map<Class, int> classes;
    for (std::uint64_t number = 0U; number < space.Size(); ++number)
    {
        ++classes[runner.Run(space.At(number)).result];
    }
    // Then the one that lets old data out is silent, although the march would find it later
    EXPECT_EQ(classes[Class::kSilent], 1);
    EXPECT_EQ(classes[Class::kExposed], 0);
}

TEST_F(StuckVerdictTest, TimeLineTellsFromWhenOnTheOutputWasWrongUntilItWasFound)
{
    Verifies(req::SRS_CMG_151);
    Verifies(req::SRS_CMG_044);
    // Given the same bit in a device with self tests
    is_comparator_mute = true;
    const std::string plan = PlanFile("plan.yaml", "actuator", std::string(kLines) + "self_test: true\n");
    // When it is shown again
    const tools::test::Answer answer = Campaign({plan, "--replay", "0"});
    // Then what is wrong is told once, then who found it, and it is no experiment that holds
    EXPECT_EQ(answer.status, 1);
    const std::string wrong = "judge      open with data that the bus did not bring";
    const std::size_t told = answer.out.find(wrong);
    const std::size_t found = answer.out.find("kernel     device fault self_test");
    ASSERT_NE(told, std::string::npos) << answer.out;
    EXPECT_EQ(answer.out.find(wrong, told + 1U), std::string::npos) << answer.out;
    EXPECT_LT(told, found);
    EXPECT_NE(answer.out.find("outcome: exposed, by self_test, open with wrong data until the self test found it"),
              std::string::npos)
        << answer.out;
}

TEST_F(CourseTest, NoExperimentFindsWhatAnotherOneLeft)
{
    Verifies(req::SRS_CMG_001);
    const Trap trap;
    // Given a device
    Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\nkinds: [flip]\nsample: 1\n"));
    std::uint8_t* const bytes = session.Runs().Subject().Memory().Bytes();
    const std::size_t size = session.Runs().Subject().Memory().Size();
    // Then all that can be written is brought back
    EXPECT_EQ(size % 4096U, 0U);
    EXPECT_EQ(Trap::Run([bytes, size]() { bytes[size - 1U] = 1U; }), Return::kEnded);
    EXPECT_EQ(Trap::Run([bytes, size]() { bytes[size] = 1U; }), Return::kException);
    EXPECT_EQ(Trap::Run([bytes]() { bytes[(1U << 20U) - 1U] = 1U; }), Return::kException);
}

TEST_F(CourseTest, PlanWithoutAFaultIsRefused)
{
    Verifies(req::SRS_CMG_026);
    const tools::test::Answer none = Campaign(
        {PlanFile("none.yaml", "actuator", "at: [500 ms]\nparts: [pins]\nkinds: [flip]\n")}); // The gate has none.
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("none.yaml:5:9: error: part 'pins' of which nothing is hit"), std::string::npos);
    const std::string apart = PlanFile("apart.yaml", "actuator", "at: [500 ms]\nparts: [bus]\nkinds: [flip]\n");
    const tools::test::Answer strangers = Campaign({apart});
    EXPECT_EQ(strangers.status, 2);
    EXPECT_NE(strangers.err.find("apart.yaml:6:9: error: a kind that none of the parts has"), std::string::npos);
    const auto many = Campaign({PlanFile("many.yaml", "actuator", "at: [500 ms]\nparts: [both_channels]\n")});
    EXPECT_EQ(many.status, 2);
    EXPECT_NE(many.err.find("error: more than 100000000 faults"), std::string::npos) << many.err;
    EXPECT_EQ(Campaign({PlanFile("reach.yaml", "actuator", "at: [500 ms]\nparts: [bus]\nreach: 2 s\n")}).status, 2);
}
} // namespace
} // namespace counterpoint::campaign::test
