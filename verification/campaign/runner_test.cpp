// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What becomes of single faults, and what the judge calls wrong.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/variants.hpp"

#include "simulator/journal/journal.hpp"

#include <csignal>
#include <utility>

namespace counterpoint::campaign::test
{
namespace
{
constexpr const char* kSmall = "at: [500 ms]\nsample: 10\n";
constexpr std::uint32_t kDiagnosticLimitUs = 1008000U; // 1000 ms, a late cycle, the drift of two counters, the output.

using RunnerTest = CampaignTest;

TEST_F(RunnerTest, DeviceWithoutFaultOpensAndClosesWithTheSimulatedOne)
{
    Verifies(req::SRS_CMG_002);
    // Given the recording of the actuator
    Session session(PlanFile("plan.yaml", "actuator", kSmall));
    // When it has run without a fault
    std::vector<Nanoseconds> opened;
    for (std::size_t cycle = 1U; cycle < 2000U; ++cycle)
    {
        if (session.Runs().OpenWithoutFault(cycle) != session.Runs().OpenWithoutFault(cycle - 1U))
        {
            opened.push_back(session.Scenario().Record().cycles[cycle].at);
        }
    }
    // Then its output opened where the simulated one did, by the acknowledge at 150 ms
    std::vector<Nanoseconds> simulated;
    for (const simulator::Event& event : session.Scenario().Simulated().Record().Events())
    {
        if (event.kind == simulator::EventKind::kOutput && event.node == session.Scenario().Node())
        {
            simulated.push_back(event.at);
        }
    }
    EXPECT_EQ(opened, simulated);
    EXPECT_EQ(opened, std::vector<Nanoseconds>{151809245});
}

TEST_F(RunnerTest, SameFaultHasTheSameOutcomeWhateverWasTriedBefore)
{
    Verifies(req::SRS_CMG_001);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\nsample: 25\n"));
    // Given the outcomes in ascending order
    std::vector<Outcome> first;
    for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
    {
        first.push_back(session.Runs().Run(session.Faults().At(number)));
    }
    // When each is tried again in descending order
    std::uint64_t differences = 0U;
    for (std::uint64_t number = session.Faults().Size(); number-- > 0U;)
    {
        const Outcome again = session.Runs().Run(session.Faults().At(number));
        const Outcome& before = first[number];
        const bool is_same = again.result == before.result && again.detector == before.detector &&
                             again.detail == before.detail && again.us == before.us;
        differences += is_same ? 0U : 1U;
    }
    // Then nothing differs
    EXPECT_EQ(first.size(), 1000U); // 10 parts, 4 kinds
    EXPECT_EQ(differences, 0U);
}

struct Known
{
    const char* member;
    std::size_t byte;
    Class result;
    Detector detector;
    std::uint32_t longest_us;
};

class KnownFaults : public CampaignTest, public ::testing::WithParamInterface<Known>
{
};

TEST_P(KnownFaults, AreFoundByTheirMechanismInTime)
{
    Verifies(req::SRS_CMG_006);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", kSmall));
    // When bit 4 of the byte flips behind the frames of cycle 499
    const Outcome outcome = session.Runs().Run(FaultIn(session, GetParam().member, GetParam().byte, 4U));
    // Then
    EXPECT_EQ(outcome.result, GetParam().result);
    EXPECT_EQ(outcome.detector, GetParam().detector) << WordOf(outcome.detector);
    EXPECT_LE(outcome.us, GetParam().longest_us);
}

INSTANTIATE_TEST_SUITE_P(
    Members, KnownFaults,
    ::testing::Values(Known{"latch", 0U, Class::kDetected, Detector::kLatch, 1000U},
                      Known{"kernel.seal", 0U, Class::kDetected, Detector::kSeal,
                            2000U}, // No permit: the gate's own time.
                      Known{"kernel.run", 8U, Class::kDetected, Detector::kFlowMonitor, 1000U}, // Frames that came.
                      Known{"kernel.run", 4U, Class::kDetected, Detector::kComparator, 1000U},  // Number of the cycle.
                      Known{"channel_a.entries", 0U, Class::kDetected, Detector::kComparator, kDiagnosticLimitUs},
                      Known{"kernel.config", 5U, Class::kDetected, Detector::kSeal, 2000U},
                      Known{"config", 5U, Class::kSafeOther, Detector::kException, kDiagnosticLimitUs},
                      Known{"variables", 0U, Class::kSafeOther, Detector::kPairCheck, 1000U}));

TEST_F(RunnerTest, FaultThatIsUndoneIsMasked)
{
    Verifies(req::SRS_CMG_006);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", kSmall));
    // When the flow signature of the cycle before flips, which Begin writes anew
    Experiment fault = FaultIn(session, "flow_monitor", 8U, 0U);
    const Outcome outcome = session.Runs().Run(fault);
    // Then the device is as without it
    EXPECT_EQ(outcome.result, Class::kMasked);
    // When a bit is stuck at what it is anyway, it is never otherwise
    fault = FaultIn(session, "channel_a.object", 200U, 7U);
    fault.kind = FaultKind::kStuckAt0;
    EXPECT_EQ(session.Runs().Run(fault).result, Class::kMasked);
}

TEST_F(RunnerTest, LimitsAreThoseOfTheConfiguration)
{
    Verifies(req::SRS_CMG_007);
    const Session session(PlanFile("plan.yaml", "actuator", kSmall));
    const Limits& limits = session.Parts().limits;
    EXPECT_EQ(limits.us[static_cast<std::size_t>(Part::kChannelA)], kDiagnosticLimitUs);
    EXPECT_EQ(limits.us[static_cast<std::size_t>(Part::kTables)], 2013000U); // Two passes, of which one is under way.
}

TEST_F(RunnerTest, ExceptionAndEndlessRunAreBroughtBack)
{
    Verifies(req::SRS_CMG_009);
    Verifies(req::SRS_CMG_150);
    const Trap trap;
    EXPECT_EQ(Trap::Run([]() { raise(SIGSEGV); }), Return::kException);
    EXPECT_EQ(Trap::Run([]() { raise(SIGILL); }), Return::kException);
    volatile bool goes_on = true;
    EXPECT_EQ(Trap::Run(
                  [&goes_on]()
                  {
                      while (goes_on)
                      {
                      }
                  }),
              Return::kNever);
    EXPECT_EQ(Trap::Run([]() {}), Return::kEnded);
}

/// Does in its first cycle what a changed pointer or bound does.
class Wild final : public CycleWatcher
{
  public:
    explicit Wild(const bool is_endless) : is_endless_(is_endless)
    {
    }
    void OnCycle(const std::size_t /*cycle*/, const Sight& /*sight*/) override
    {
        while (is_endless_)
        {
        }
        raise(SIGSEGV);
    }

  private:
    volatile bool is_endless_;
};

TEST_F(RunnerTest, WhatEndsByAnExceptionOrNotAtAllIsSafeByItAndTheNextFaultIsTried)
{
    Verifies(req::SRS_CMG_009);
    Verifies(req::SRS_CMG_150);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", kSmall));
    const Experiment fault = FaultIn(session, "latch", 0U, 4U);
    for (const bool is_endless : {false, true})
    {
        // When the run ends by a signal of the processor, or does not end, in its first cycle of 1 ms
        Wild wild(is_endless);
        session.Runs().Follow(&wild);
        const Outcome ended = session.Runs().Run(fault);
        // Then it is safe by that: 999 us are left of the cycle, and one more comes that is as late as it may be
        EXPECT_EQ(ended.result, Class::kSafeOther);
        EXPECT_EQ(ended.detector, is_endless ? Detector::kTime : Detector::kException) << WordOf(ended.detector);
        EXPECT_EQ(ended.us, 2499U);
        // and the next fault is tried as if nothing had been
        session.Runs().Follow(nullptr);
        const Outcome next = session.Runs().Run(fault);
        EXPECT_EQ(next.result, Class::kDetected);
        EXPECT_EQ(next.detector, Detector::kLatch);
    }
}

TEST_F(RunnerTest, DeviceLiesAtOneAddress)
{
    Verifies(req::SRS_CMG_001);
    // Given a plan that is read twice, then the memory of its device lies where it did
    const std::string plan = PlanFile("plan.yaml", "actuator", kSmall);
    const auto address = [&plan]()
    {
        Session session(plan);
        return session.Runs().Subject().Memory().Bytes();
    };
    const std::uint8_t* const first = address();
    EXPECT_EQ(address(), first);
}

/// A device without faults, a cycle at a time, with what the judge says of it.
class JudgeTest : public CampaignTest
{
  protected:
    struct Bench
    {
        explicit Bench(const std::string& plan_file)
            : plan(ReadPlan(plan_file)), scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node)),
              region(1U << 20U), device(region, scenario.Model(), scenario.Record(), OutputKind::kGate),
              judge(scenario.Record(), scenario.Model(), device)
        {
        }
        Sight RunTo(const std::size_t end)
        {
            Sight sight;
            for (; next < end; ++next)
            {
                device.Cycle(next);
                sight = judge.Look(next, memory);
            }
            return sight;
        }
        Plan plan;
        RecordedScenario scenario;
        Region region;
        Device device;
        Judge judge;
        JudgeMemory memory{};
        std::size_t next{0U};
    };
};

TEST_F(JudgeTest, OpenOutputNeedsDataOfTheBusAndLeave)
{
    Verifies(req::SRS_CMG_005);
    // Given the actuator at work, with 1 and 1
    Bench bench(PlanFile("plan.yaml", "actuator", kSmall));
    const Sight sight = bench.RunTo(400U);
    EXPECT_EQ(sight.open, 1U);
    EXPECT_EQ(sight.wrong, Wrong::kNothing);
    const FlatPair& pair = bench.device.Pairs().front();
    JudgeMemory memory = bench.memory;
    // When one variable alone changes, then the application refuses the pair
    WriteVariable(pair.normal, {0x80U});
    EXPECT_EQ(bench.judge.Look(399U, memory).not_inverse, 1U);
    // When both do, then it is open with data that no pair of the bus had
    WriteVariable(pair.inverse, {0x7FU});
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kData);
    // and with the old ones again nothing is wrong,
    WriteVariable(pair.normal, {1U});
    WriteVariable(pair.inverse, {0xFEU});
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kNothing);
    // but without an acknowledge, or behind an error or a device fault.
    memory.armed = 0U;
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kNoLeave);
    memory.stopped = 1U;
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kRestart);
    memory.armed = 1U;
    memory.fault_cycles = 2U;
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kRestart);
}

TEST_F(JudgeTest, OutputThatWasClosedNeedsAnAcknowledgeWhoeverToldOfIt)
{
    Verifies(req::SRS_CMG_250);
    // Given the actuator before its first release, which was open in the cycle before
    Bench bench(PlanFile("plan.yaml", "actuator", kSmall));
    EXPECT_EQ(bench.RunTo(60U).open, 0U);
    bench.memory.opened = 1U;
    // When it is closed and nobody is told of an error, then it is known as closed
    EXPECT_EQ(bench.RunTo(61U).wrong, Wrong::kNothing);
    EXPECT_EQ(bench.memory.closed, 1U);
    EXPECT_EQ(bench.memory.erred, 0U);
    // until the acknowledge behind it
    EXPECT_EQ(bench.RunTo(400U).open, 1U);
    EXPECT_EQ(bench.memory.closed, 0U);
    JudgeMemory memory = bench.memory;
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kNothing);
    // Without one, an open output is a restart.
    memory.closed = 1U;
    EXPECT_EQ(bench.judge.Look(399U, memory).wrong, Wrong::kRestart);
}

TEST_F(JudgeTest, WriteIntoTheApplicationsMemoryTellsNoFault)
{
    Verifies(req::SRS_CMG_410);
    // Given the sensor at work, whose application was told nothing
    Bench bench(PlanFile("plan.yaml", "sensor", kSmall));
    EXPECT_EQ(bench.RunTo(400U).wrong, Wrong::kNothing);
    auto& application = const_cast<FlatApplication&>(bench.device.Application());
    // Of the next 60 cycles, in which two pairs are sent
    const auto is_wrong = [&bench](const Wrong wrong)
    {
        bool is_seen = false;
        for (std::size_t end = bench.next + 60U; bench.next < end;)
        {
            is_seen = (bench.RunTo(bench.next + 1U).wrong == wrong) || is_seen;
        }
        return is_seen;
    };
    for (std::size_t copy = 0U; copy < 3U; ++copy)
    {
        // When somebody writes a device fault and an error of SRDO 1 over one of its copies
        application.copies.at(copy).device_fault = DeviceFault::kOutput;
        application.copies.at(copy).faulted = 1U;
        // then nothing was told, and the frames that are sent are right
        EXPECT_EQ(application.Now().device_fault, DeviceFault::kNone) << copy;
        EXPECT_FALSE(is_wrong(Wrong::kRestart)) << copy;
        EXPECT_EQ(bench.memory.fault_cycles, 0U) << copy;
        EXPECT_EQ(bench.memory.told, 0U) << copy;
        application.copies.at(copy) = Told{};
    }
    // When the kernel tells one, then the next pair is one behind a device fault.
    application.OnDeviceFault({DeviceFault::kOutput, 0U, 1U});
    EXPECT_TRUE(is_wrong(Wrong::kRestart));
    EXPECT_NE(bench.memory.fault_cycles, 0U);
}

TEST_F(JudgeTest, SentFrameNeedsAnIdentifierOfTheDeviceAndDataOfTheApplication)
{
    Verifies(req::SRS_CMG_005);
    // Given the sensor at work, which sends by 101h and 102h
    Bench bench(PlanFile("plan.yaml", "sensor", kSmall));
    EXPECT_EQ(bench.RunTo(400U).wrong, Wrong::kNothing);
    auto& ports = const_cast<FlatPorts&>(bench.device.Ports());
    const auto send = [&ports](const std::uint32_t identifier, const std::uint8_t byte_0, const std::uint8_t byte_1)
    {
        return ports.Transmit({identifier, FrameKind::kData, CanPortId::kFirst, 2U, {byte_0, byte_1}}) ==
               hal::TransmitStatus::kAccepted;
    };
    // When it sends what nobody pressed, but not inverse, then the receivers find it
    ASSERT_TRUE(send(0x101U, 0x55U, 0x01U) && send(0x102U, 0xFFU, 0xFEU));
    EXPECT_EQ(bench.judge.Look(399U, bench.memory).wrong, Wrong::kNothing);
    // When it is a valid pair, then nobody does
    ASSERT_TRUE(send(0x101U, 0x55U, 0x01U) && send(0x102U, 0xAAU, 0xFEU));
    EXPECT_EQ(bench.judge.Look(399U, bench.memory).wrong, Wrong::kSentPair);
    // When it sends under an identifier of the controller
    ASSERT_TRUE(send(0x103U, 0x01U, 0x01U));
    EXPECT_EQ(bench.judge.Look(399U, bench.memory).wrong, Wrong::kIdentifier);
}

TEST_F(JudgeTest, PairThatDoesNotComeAndFrameThatNobodyCanUseAreSeen)
{
    Verifies(req::SRS_CMG_060);
    // Given the sensor at work: a pair each 25 ms, a cycle as late as may be of 1.5 ms, two frames of 0.27 ms
    Bench bench(PlanFile("plan.yaml", "sensor", kSmall));
    const Sight sight = bench.RunTo(400U);
    EXPECT_FALSE(sight.is_overdue);
    EXPECT_FALSE(sight.is_bad_frame);
    const Nanoseconds now = bench.scenario.Record().cycles[399U].at;
    // When the last pair was complete 27.04 ms ago, then nothing is overdue; with 0.01 ms more it is
    bench.memory.pair_at.fill(now - 27040000);
    EXPECT_FALSE(bench.judge.Look(399U, bench.memory).is_overdue);
    bench.memory.pair_at.fill(now - 27050000);
    EXPECT_TRUE(bench.judge.Look(399U, bench.memory).is_overdue);
    // When it sends a normal frame with what nobody pressed
    auto& ports = const_cast<FlatPorts&>(bench.device.Ports());
    ASSERT_EQ(ports.Transmit({0x101U, FrameKind::kData, CanPortId::kFirst, 2U, {0x55U, 0x01U}}),
              hal::TransmitStatus::kAccepted);
    EXPECT_TRUE(bench.judge.Look(399U, bench.memory).is_bad_frame);
    // or an inverse one that does not fit
    ASSERT_EQ(ports.Transmit({0x102U, FrameKind::kData, CanPortId::kFirst, 2U, {0xFFU, 0xFEU}}),
              hal::TransmitStatus::kAccepted);
    EXPECT_TRUE(bench.judge.Look(399U, bench.memory).is_bad_frame);
}

TEST_F(JudgeTest, LateIsCountedFromWhatTheDeviceDoesAndOfTestsFromTheFirstWrongByte)
{
    Verifies(req::SRS_CMG_060);
    Verifies(req::SRS_CMG_154);
    const Trap trap;
    Bench bench(PlanFile("plan.yaml", "actuator", kSmall));
    // Given limits of nothing for the kernel and 5 ms for tables and channel A
    Limits limits = LimitsOf(bench.scenario.Model(), bench.device.Config());
    limits.us[static_cast<std::size_t>(Part::kKernel)] = 0U;
    limits.us[static_cast<std::size_t>(Part::kTables)] = 5000U;
    limits.us[static_cast<std::size_t>(Part::kChannelA)] = 5000U;
    const Space space(bench.plan, bench.scenario.Record(), bench.device, HorizonOf(limits, bench.device.Config()));
    Runner runner(bench.device, bench.judge, bench.scenario.Record(), space, limits);
    const auto run = [&bench, &runner](const std::string& member, const std::size_t byte, const std::uint8_t bit)
    {
        const std::vector<Place>& places = bench.device.Places();
        const auto found =
            std::find_if(places.begin(), places.end(), [&member](const Place& place) { return place.name == member; });
        return runner.Run({found->part, FaultKind::kFlip, static_cast<std::size_t>(found - places.begin()),
                           found->offset + byte, bit, 499U, Phase::kAfterFrames});
    };
    // When the number of frames that came flips, then the device fault is told in this cycle: above nothing
    const Outcome at_once = run("kernel.run", 8U, 4U);
    EXPECT_EQ(at_once.result, Class::kDetected);
    EXPECT_TRUE(IsLate(at_once));
    // When a bit of what channel A keeps flips, and the channels compare it later: nothing is done until then, never
    // late
    std::uint64_t still = 0U;
    for (std::size_t byte = 0U; byte < 128U; ++byte)
    {
        const Outcome outcome = run("channel_a.records", byte, 4U);
        const bool is_later = outcome.result == Class::kDetected && outcome.us > 400000U &&
                              outcome.detail == static_cast<std::uint8_t>(DeviceFault::kDisagreement);
        still += is_later ? 1U : 0U;
        EXPECT_FALSE(is_later && IsLate(outcome)) << byte;
    }
    EXPECT_GT(still, 0U);
    // When a word of a table does, nothing is done either, but the guard's interval counts from the first wrong byte
    const Outcome by_guard = run("config", offsetof(DeviceConfig, test_interval_us), 0U);
    EXPECT_EQ(by_guard.result, Class::kDetected);
    EXPECT_EQ(by_guard.detector, Detector::kGuard) << WordOf(by_guard.detector);
    EXPECT_TRUE(IsLate(by_guard)) << by_guard.us;
}

// t [ms]        536        537                550                    553
// sensor        normal     late call begins   another value sensed   the call comes, inverse: SRVT is 20 ms
TEST_F(JudgeTest, WhatIsNoMemoryIsLateFromTheFirstByteThatDiffers)
{
    Verifies(req::SRS_CMG_153);
    const Trap trap;
    Bench bench(PlanFile("plan.yaml", "actuator", kSmall));
    // Given a limit of 5 ms, and counter A faster at each of ten rates: the device does nothing else until it is found
    Limits limits = LimitsOf(bench.scenario.Model(), bench.device.Config());
    limits.us[static_cast<std::size_t>(Part::kCounters)] = 5000U;
    const Space space(bench.plan, bench.scenario.Record(), bench.device, HorizonOf(limits, bench.device.Config()));
    Runner runner(bench.device, bench.judge, bench.scenario.Record(), space, limits);
    std::uint64_t late = 0U;
    for (std::uint32_t variant = 0U; variant < 10U; ++variant)
    {
        Experiment fast;
        fast.part = Part::kCounters;
        fast.kind = FaultKind::kFast;
        fast.cycle = 499U;
        fast.variant = variant;
        const Outcome outcome = runner.Run(fast);
        // Then what is found behind the limit is late, and what is found within it is not
        const bool is_found = outcome.result == Class::kDetected && outcome.detector == Detector::kClocks;
        EXPECT_EQ(IsLate(outcome), is_found && outcome.us > 6000U) << variant << " " << outcome.us;
        late += IsLate(outcome) ? 1U : 0U;
    }
    EXPECT_GT(late, 0U);
    EXPECT_LT(late, 10U);
}

TEST_F(JudgeTest, TestOfTheComparatorThatIsHitItselfIsLateFromWhatTheDeviceDoes)
{
    Verifies(req::SRS_CMG_154);
    const Trap trap;
    Bench bench(PlanFile("plan.yaml", "actuator", kSmall));
    Limits limits = LimitsOf(bench.scenario.Model(), bench.device.Config());
    limits.us[static_cast<std::size_t>(Part::kComparator)] = 5000U;
    const Space space(bench.plan, bench.scenario.Record(), bench.device, HorizonOf(limits, bench.device.Config()));
    Runner runner(bench.device, bench.judge, bench.scenario.Record(), space, limits);
    const std::vector<Place>& places = bench.device.Places();
    const auto found = std::find_if(places.begin(), places.end(),
                                    [](const Place& place) { return place.name == "comparator.self_test"; });
    ASSERT_NE(found, places.end());
    // Given each bit of the comparator's own test that flips
    std::uint64_t still = 0U;
    for (std::size_t bit = 0U; bit < 8U * found->size; ++bit)
    {
        const Outcome outcome =
            runner.Run({found->part, FaultKind::kFlip, static_cast<std::size_t>(found - places.begin()),
                        found->offset + (bit / 8U), static_cast<std::uint8_t>(bit % 8U), 499U, Phase::kAfterFrames});
        const bool is_by_test = outcome.result == Class::kDetected && outcome.us > 5000U &&
                                outcome.detail == static_cast<std::uint8_t>(DeviceFault::kComparator);
        still += is_by_test ? 1U : 0U;
        // Then one that the test finds in a later round is not late
        EXPECT_FALSE(is_by_test && IsLate(outcome)) << bit;
    }
    EXPECT_GT(still, 0U);
}

TEST_F(RunnerTest, PairThatALateCallCompletesIsJudgedByItsNormalFrame)
{
    Verifies(req::SRS_CMG_005);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "sensor", "at: [500 ms]\ncycles: 50\nparts: [cycle]\nreach: 20 ms\n"));
    Experiment late;
    late.part = Part::kCycle;
    late.kind = FaultKind::kLate;
    late.cycle = 536U;
    late.variant = 319U; // 16.00 ms
    EXPECT_EQ(session.Runs().Run(late).result, Class::kDetected);
}

TEST_F(RunnerTest, CallThatAnswersAsItWouldHaveLiesStill)
{
    Verifies(req::SRS_CMG_060);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "sensor", "at: [500 ms]\ncycles: 50\nparts: [a_calls]\n"));
    // Given that the inverse frame is not asked for any more: the one before is the right one until 550 ms
    Experiment skipped;
    skipped.part = Part::kCallsOfA;
    skipped.kind = FaultKind::kSkipped;
    skipped.cycle = 499U;
    skipped.subject = static_cast<std::size_t>(ChannelCall::kInverseFrame) * kTurns;
    skipped.variant = kAlways;
    // Then it is found with the first one that is not
    const Outcome outcome = session.Runs().Run(skipped);
    EXPECT_EQ(outcome.result, Class::kDetected);
    EXPECT_EQ(outcome.detector, Detector::kComparator);
    EXPECT_EQ(outcome.us, 62998U);
    EXPECT_FALSE(IsLate(outcome));
}

TEST_F(RunnerTest, DeviceThatCannotBeRecordedIsRefusedAtItsName)
{
    Verifies(req::SRS_CMG_213);
    const std::string plan = PlanFile("plan.yaml", "controller", kSmall);
    const tools::test::Answer answer = Campaign({plan});
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.err.find(plan + ":3:9: error: a device with logic"), std::string::npos) << answer.err;
    const std::string chain =
        "extends: " COUNTERPOINT_SOURCE_FOLDER "/examples/emergency_stop/chain.yaml\nduration: 4 s\n";
    for (const auto& [more, message] :
         {std::pair("faults: [{fault: unplugged, node: sensor, at: 1 s}]\n",
                    "a scenario with faults, managers or actions, expected "),
          {"power: [{node: actuator, at: 1 s, off: 100 ms}]\n", "a device with logic or power cycles, expected "}})
    {
        const std::string faulty =
            File("faulty_plan.yaml", "title: A test\nscenario: " + File("faulty.yaml", chain + more) +
                                         "\ndevice: actuator\n" + std::string(kSmall));
        const tools::test::Answer told = Campaign({faulty});
        EXPECT_EQ(told.status, 2);
        EXPECT_NE(told.err.find(faulty + ":3:9: error: " + message), std::string::npos) << told.err;
    }
}

TEST_F(RunnerTest, DeviceWithoutFaultClosesWithTheSimulatedOne)
{
    Verifies(req::SRS_CMG_002);
    // Given the recording of an actuator that is stopped and started by commands
    Session session(File("plan.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                      "/examples/campaigns/commanded.yaml\ndevice: actuator\n" +
                                          std::string(kSmall)));
    // When it has run without a fault, then its output opened and closed where the simulated one did
    std::vector<Nanoseconds> changed;
    const auto& cycles = session.Scenario().Record().cycles;
    for (std::size_t cycle = 1U; cycle < 2000U; ++cycle)
    {
        if (session.Runs().OpenWithoutFault(cycle) != session.Runs().OpenWithoutFault(cycle - 1U))
        {
            changed.push_back(cycles[cycle].at);
        }
    }
    std::vector<Nanoseconds> simulated;
    for (const simulator::Event& event : session.Scenario().Simulated().Record().Events())
    {
        if (event.kind == simulator::EventKind::kOutput && event.node == session.Scenario().Node())
        {
            simulated.push_back(event.at);
        }
    }
    EXPECT_GE(changed.size(), 2U);
    EXPECT_EQ(changed, simulated);
}
} // namespace
} // namespace counterpoint::campaign::test
