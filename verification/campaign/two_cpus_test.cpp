// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device of two CPUs: what it is made of, the link between them, and what becomes of its faults.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/two_cpus.hpp"
#include "verification/campaign/variants.hpp"

#include "simulator/journal/journal.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
/// Time-out of 10 ms, a cycle as late as it may be of 1.5 ms, drift of 0.5 ms, output of 1 ms.
constexpr std::uint32_t kLinkLimitUs = 13000U;

class TwoCpusTest : public CampaignTest
{
  protected:
    /// A plan on the chain whose actuator has two CPUs.
    [[nodiscard]] std::string TwoCpuPlan(const std::string& device, const std::string& more) const
    {
        return File("two_cpus.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                     "/examples/campaigns/two_cpus_at_work.yaml\ndevice: " +
                                         device + "\n" + more);
    }
    [[nodiscard]] static Outcome Try(Session& session, const Part part, const FaultKind kind, const std::size_t subject,
                                     const std::uint32_t variant, const std::size_t cpu = kNoCpu)
    {
        Experiment fault;
        fault.part = part;
        fault.kind = kind;
        fault.cycle = 499U;
        fault.subject = subject;
        fault.variant = variant;
        fault.cpu = cpu;
        if (part == Part::kSteps)
        {
            fault.phase = static_cast<Phase>(static_cast<std::size_t>(Phase::kFirstStep) + 1U + subject);
        }
        return session.Runs().Run(fault);
    }
    /// What was tried, as CSV.
    [[nodiscard]] std::string Tried(const std::string& more) const
    {
        const std::string file = Path("tried.csv");
        EXPECT_EQ(Campaign({TwoCpuPlan("actuator", more), "--jobs", "1", "--csv", file}).status, 0);
        return cia306::ReadTextFile(file);
    }
};

constexpr const char* kSmall = "at: [500 ms]\nsample: 10\n";

TEST_F(TwoCpusTest, OutputsInSeriesOpenWithTheSimulatedOnes)
{
    Verifies(req::SRS_CMG_061);
    Session session(TwoCpuPlan("actuator", kSmall));
    const std::vector<RecordedCycle>& cycles = session.Scenario().Record().cycles;
    // When it runs without a fault
    std::vector<std::size_t> opened;
    for (std::size_t cycle = 1U; cycle < 2000U; ++cycle)
    {
        if (session.Runs().OpenWithoutFault(cycle) != session.Runs().OpenWithoutFault(cycle - 1U))
        {
            opened.push_back(cycle);
        }
    }
    // Then it opens once, in the cycle in which the later one of the simulated CPUs does
    Nanoseconds later = 0;
    for (const simulator::Event& event : session.Scenario().Simulated().Record().Events())
    {
        const bool is_own = event.node == session.Scenario().Node() || event.node == session.Scenario().Node() + 1U;
        later = (event.kind == simulator::EventKind::kOutput && is_own) ? std::max(later, event.at) : later;
    }
    ASSERT_EQ(opened.size(), 1U);
    EXPECT_GT(later, cycles[opened.front() - 1U].at);
    EXPECT_LE(later, cycles[opened.front()].at);
}

TEST_F(TwoCpusTest, OutputThatBothHaveOpenAgainNeedsAnAcknowledge)
{
    Verifies(req::SRS_CMG_250);
    // Given a device that is at work
    const Plan plan = ReadPlan(TwoCpuPlan("actuator", kSmall));
    const RecordedScenario scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node));
    Region region(1U << 20U);
    TwoCpus device(region, scenario, false);
    Judge judge(scenario.Record(), scenario.Model(), device);
    const std::size_t cycles = scenario.Record().cycles.size();
    JudgeMemory memory{};
    std::size_t opened = 0U;
    for (std::size_t cycle = 0U; cycle < cycles && opened == 0U; ++cycle)
    {
        device.Cycle(cycle);
        opened = (judge.Look(cycle, memory).open != 0U) ? cycle : 0U;
    }
    ASSERT_NE(opened, 0U);
    EXPECT_NE(memory.opened, 0U);
    EXPECT_EQ(memory.closed, 0U);
    EXPECT_EQ(judge.Look(opened, memory).wrong, Wrong::kNothing);
    // When it was closed in between, and nobody was told and acknowledged, then that is a restart
    memory.closed = memory.opened;
    EXPECT_EQ(judge.Look(opened, memory).wrong, Wrong::kRestart);
}

TEST_F(TwoCpusTest, OutputsInSeriesAreWrongWhereBothAre)
{
    Verifies(req::SRS_CMG_064);
    // Given a device that is at work
    const Plan plan = ReadPlan(TwoCpuPlan("actuator", kSmall));
    const RecordedScenario scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node));
    Region region(1U << 20U);
    TwoCpus device(region, scenario, false);
    Judge judge(scenario.Record(), scenario.Model(), device);
    JudgeMemory memory{};
    std::size_t opened = 0U;
    for (std::size_t cycle = 0U; cycle < scenario.Record().cycles.size() && opened == 0U; ++cycle)
    {
        device.Cycle(cycle);
        opened = (judge.Look(cycle, memory).open != 0U) ? cycle : 0U;
    }
    ASSERT_NE(opened, 0U);
    ASSERT_FALSE(device.Pairs().empty());
    std::uint8_t& of_a = *device.Pairs().front().normal.place;
    std::uint8_t& of_b = *device.Pairs().front().inverse.place;
    EXPECT_EQ(judge.Look(opened, memory).not_inverse, 0U);
    // When one CPU has data that no pair allows, and the other one has the right ones, then it is not silent
    for (std::uint8_t* const one : {&of_a, &of_b})
    {
        *one ^= 0x40U;
        const Sight sight = judge.Look(opened, memory);
        EXPECT_EQ(sight.wrong, Wrong::kNothing);
        EXPECT_EQ(sight.not_inverse, 1U);
        *one ^= 0x40U;
    }
    // When both let it pass, then it is
    of_a ^= 0x40U;
    of_b ^= 0x40U;
    EXPECT_EQ(judge.Look(opened, memory).wrong, Wrong::kData);
}

TEST_F(TwoCpusTest, DataThatOneCpuHasWrongAreSafeByTheOtherOne)
{
    Verifies(req::SRS_CMG_064);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    for (const char* const member : {"cpu_a.variables", "cpu_b.variables"})
    {
        // Each CPU has variables of both sides, of which it uses its own alone
        std::size_t safe = 0U;
        for (std::size_t byte = 0U; byte < 4U; ++byte)
        {
            const Outcome outcome = session.Runs().Run(FaultIn(session, member, byte, 4U));
            EXPECT_NE(outcome.result, Class::kSilent) << member << byte;
            const bool is_safe = outcome.result == Class::kSafeOther;
            EXPECT_TRUE(!is_safe || outcome.detector == Detector::kPairCheck) << member << WordOf(outcome.detector);
            safe += is_safe ? 1U : 0U;
        }
        EXPECT_EQ(safe, 2U) << member;
    }
}

// Cycle of 1.5 ms at the latest, output of 1 ms, a drift of 0.5 ms in each begun interval of 100 ms; two passes of 1 s
// for a copy of either channel. Of the link time-out of 10 ms and clock interval of 500 ms: 510 + 1.5 + 1 + 6 x 0.5 ms.
TEST_F(TwoCpusTest, LimitsAreThoseOfOneCpuOfACopyAndOfTheLink)
{
    Verifies(req::SRS_CMG_064);
    const Limits of_one = Session(PlanFile("one.yaml", "actuator", kSmall)).Parts().limits;
    const Limits of_two = Session(TwoCpuPlan("actuator", kSmall)).Parts().limits;
    const auto of = [](const Limits& limits, const Part part) { return limits.us[static_cast<std::size_t>(part)]; };
    for (const Part part : {Part::kChannelA, Part::kChannelB, Part::kTables})
    {
        EXPECT_EQ(of(of_two, part), 2013000U) << WordOf(part);
    }
    for (const Part part : {Part::kKernel, Part::kVariables, Part::kCallsOfA, Part::kSteps, Part::kBus})
    {
        EXPECT_GT(of(of_one, part), kLinkLimitUs) << WordOf(part);
        EXPECT_EQ(of(of_two, part), of(of_one, part)) << WordOf(part);
    }
    EXPECT_EQ(of_two.Of(Part::kLink, FaultKind::kLost), kLinkLimitUs);
    EXPECT_EQ(of_two.Of(Part::kCpu, FaultKind::kStopped), kLinkLimitUs);
    EXPECT_EQ(of_two.Of(Part::kCpu, FaultKind::kFast), 515500U);
    EXPECT_EQ(of_two.Of(Part::kCpu, FaultKind::kSlow), 515500U);
    EXPECT_EQ(of(of_two, Part::kCounters), 515500U);
    EXPECT_EQ(of(of_one, Part::kCommands), 1008000U);
    EXPECT_EQ(of(of_two, Part::kCommands), 1008000U);
}

TEST_F(TwoCpusTest, EachCpuHasAKernelAChannelAndItsSideOfTheLink)
{
    Verifies(req::SRS_CMG_061);
    const Session session(TwoCpuPlan("actuator", kSmall));
    std::set<std::string> names;
    for (const Place& place : session.Parts().device.Places())
    {
        EXPECT_TRUE(names.insert(place.name).second) << place.name;
    }
    for (const char* const name :
         {"cpu_a.channel_a.records", "cpu_b.channel_b.data", "cpu_a.kernel.run", "cpu_b.kernel.run", "cpu_a.cross_link",
          "cpu_b.cross_link", "cpu_a.config", "cpu_b.comparator.verdict"})
    {
        EXPECT_EQ(names.count(name), 1U) << name;
    }
    EXPECT_EQ(names.count("cpu_a.channel_b.data"), 0U);
    EXPECT_EQ(names.count("cpu_b.channel_a.records"), 0U);
}

TEST_F(TwoCpusTest, LinkThatIsLostIsFoundInTimeAndSingleMessagesDisturbNobody)
{
    Verifies(req::SRS_CMG_062);
    Verifies(req::SRS_CMG_064);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    EXPECT_EQ(session.Parts().limits.us[static_cast<std::size_t>(Part::kLink)], kLinkLimitUs);
    for (std::size_t way = 0U; way < 2U; ++way)
    {
        // When all messages of one way are lost, the link is, within its limit
        const Outcome lost = Try(session, Part::kLink, FaultKind::kLost, way, 4U);
        EXPECT_EQ(lost.result, Class::kDetected);
        EXPECT_EQ(lost.detector, Detector::kCrossLink) << WordOf(lost.detector);
        EXPECT_GT(lost.us, 9000U);
        EXPECT_LE(lost.us, kLinkLimitUs);
        // When one is, or a bit of it, or it comes again 1 ms later, 50 us late, or behind the next one, nothing is
        // done
        for (const auto& [kind, variant] :
             std::vector<std::pair<FaultKind, std::uint32_t>>{{FaultKind::kLost, 0U},
                                                              {FaultKind::kCorrupted, 100U},
                                                              {FaultKind::kRepeated, 19U},
                                                              {FaultKind::kDelayed, 0U},
                                                              {FaultKind::kWrongOrder, 0U}})
        {
            EXPECT_EQ(Try(session, Part::kLink, kind, way, variant).result, Class::kBenign) << WordOf(kind);
        }
    }
}

TEST_F(TwoCpusTest, CpuThatStopsOrDriftsIsFoundByTheOtherOneInTime)
{
    Verifies(req::SRS_CMG_063);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        for (std::uint32_t variant = 0U; variant < 2U; ++variant)
        {
            const Outcome stopped = Try(session, Part::kCpu, FaultKind::kStopped, cpu, variant);
            EXPECT_EQ(stopped.result, Class::kDetected) << cpu << variant;
            EXPECT_LE(stopped.us, kLinkLimitUs) << cpu << variant;
        }
        // 20 %; a lesser one the CPU that is hit may find first, which counts for nothing.
        const Outcome fast = Try(session, Part::kCpu, FaultKind::kFast, cpu, 10U);
        EXPECT_EQ(fast.result, Class::kDetected);
        EXPECT_FALSE(IsLate(fast));
        const Outcome slow = Try(session, Part::kCpu, FaultKind::kSlow, cpu, 10U);
        EXPECT_EQ(slow.result, Class::kDetected);
        EXPECT_FALSE(IsLate(slow));
        // 100 ppm
        EXPECT_EQ(Try(session, Part::kCpu, FaultKind::kFast, cpu, 0U).result, Class::kBenign);
        EXPECT_EQ(Try(session, Part::kCpu, FaultKind::kSlow, cpu, 0U).result, Class::kBenign);
    }
}

// The other one learns of it by its own time of the link, not by a word of the one that is hit.
TEST_F(TwoCpusTest, WordOfACpuThatIsHitCountsForNothing)
{
    Verifies(req::SRS_CMG_132);
    Verifies(req::SRS_CMG_063);
    // 100 ppm to 90 %
    constexpr std::int64_t kPpm[] = {100,   200,   500,    1000,   2000,   5000,  10000,
                                     20000, 50000, 100000, 200000, 500000, 900000};
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        for (std::uint32_t rate = 0U; rate < 13U; ++rate)
        {
            for (const FaultKind kind : {FaultKind::kFast, FaultKind::kSlow})
            {
                Experiment drift;
                drift.part = Part::kCpu;
                drift.kind = kind;
                drift.subject = cpu;
                drift.variant = rate;
                EXPECT_EQ(std::abs(CounterFaultOf(drift).rate_ppm), kPpm[rate]);
                const Outcome outcome = Try(session, Part::kCpu, kind, cpu, rate);
                EXPECT_NE(outcome.result, Class::kSilent) << WordOf(kind) << cpu << ", rate " << rate;
                EXPECT_FALSE(IsLate(outcome)) << WordOf(kind) << cpu << ", rate " << rate;
            }
        }
    }
}

// There are cycles in which the CPU that is slow has told the application of a fault, and the other one has found none.
TEST_F(TwoCpusTest, OutputOfTheOtherCpuIsNotWrongForAWordOfTheOneThatIsHit)
{
    Verifies(req::SRS_CMG_132);
    Verifies(req::SRS_CMG_063);
    const Plan plan = ReadPlan(TwoCpuPlan("actuator", kSmall));
    const RecordedScenario scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node));
    std::size_t alone = 0U;
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        for (std::uint32_t rate = 0U; rate < 13U; ++rate)
        {
            Region region(1U << 20U);
            TwoCpus device(region, scenario, false);
            Judge judge(scenario.Record(), scenario.Model(), device);
            JudgeMemory memory{};
            // Given a device at work, when one CPU is slow from 500 ms on
            Experiment fault;
            fault.part = Part::kCpu;
            fault.kind = FaultKind::kSlow;
            fault.cycle = 499U;
            fault.subject = cpu;
            fault.variant = rate;
            for (std::size_t cycle = 0U; cycle < 560U; ++cycle)
            {
                if (cycle == fault.cycle)
                {
                    device.Rewind(cycle, &fault, 600U, 1U);
                }
                device.Cycle(cycle);
                const Sight sight = judge.Look(cycle, memory);
                // Then what it alone tells is no finding, and the other one's output, open as before, is not wrong
                if (cycle > fault.cycle && device.Application().Now().device_fault != DeviceFault::kNone &&
                    device.Fault() == DeviceFault::kNone)
                {
                    EXPECT_FALSE(device.IsFaultTold()) << cpu << rate << " " << cycle;
                    EXPECT_EQ(memory.fault_cycles, 0U) << cpu << rate << " " << cycle;
                    EXPECT_EQ(sight.wrong, Wrong::kNothing) << cpu << rate << " " << cycle;
                    alone += (sight.open != 0U) ? 1U : 0U;
                }
            }
        }
    }
    EXPECT_GT(alone, 0U);
}

TEST_F(TwoCpusTest, StepOfOneCpuThatIsDisturbedIsFoundAtOnce)
{
    Verifies(req::SRS_CMG_130);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        for (const FaultKind kind : {FaultKind::kSkipped, FaultKind::kDoubled, FaultKind::kReordered, FaultKind::kLate})
        {
            // Step number 3 with its mark
            const Outcome outcome = Try(session, Part::kSteps, kind, 3U, (kind == FaultKind::kLate) ? 0U : 2U, cpu);
            EXPECT_EQ(outcome.result, Class::kDetected) << WordOf(kind) << cpu;
            // What a step that runs twice takes from a channel twice differs before the flow is looked at
            EXPECT_EQ(outcome.detector, (kind == FaultKind::kDoubled) ? Detector::kComparator : Detector::kFlowMonitor)
                << WordOf(kind) << cpu << WordOf(outcome.detector);
            EXPECT_LE(outcome.us, 1000U) << WordOf(kind) << cpu;
        }
    }
}

TEST_F(TwoCpusTest, CycleOfOneCpuThatDoesNotComeIsFoundInTime)
{
    Verifies(req::SRS_CMG_130);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        // Five cycles in a row, one twice, one 0.05 ms late (nobody minds), and one 2 ms late
        const Outcome skipped = Try(session, Part::kCycle, FaultKind::kSkipped, 0U, 4U, cpu);
        EXPECT_EQ(skipped.result, Class::kDetected) << cpu;
        EXPECT_LE(skipped.us, kLinkLimitUs) << cpu;
        EXPECT_EQ(Try(session, Part::kCycle, FaultKind::kDoubled, 0U, 0U, cpu).result, Class::kDetected) << cpu;
        EXPECT_EQ(Try(session, Part::kCycle, FaultKind::kLate, 0U, 0U, cpu).result, Class::kMasked) << cpu;
        const Outcome late = Try(session, Part::kCycle, FaultKind::kLate, 0U, 39U, cpu);
        EXPECT_EQ(late.result, Class::kDetected) << cpu;
        EXPECT_LE(late.us, kLinkLimitUs) << cpu;
    }
}

// A pair of the controller comes each 25 ms, by its own position among the frames of a cycle: of 25 cycles one has it.
TEST_F(TwoCpusTest, FrameThatOneCpuDoesNotGetIsFound)
{
    Verifies(req::SRS_CMG_130);
    const std::string tried = Tried("at: [500 ms]\ncycles: 25\nparts: [kernel_calls]\nkinds: [skipped]\nsample: all\n");
    for (const std::string cpu : {"cpu_a", "cpu_b"})
    {
        std::size_t once = 0U;
        std::size_t always = 0U;
        std::istringstream lines(tried);
        for (std::string line; std::getline(lines, line);)
        {
            const bool is_found =
                line.find(cpu + " kernel.OnFrame") != std::string::npos && line.find(",detected,") != std::string::npos;
            once += (is_found && line.find(" always") == std::string::npos) ? 1U : 0U;
            always += (is_found && line.find(" always") != std::string::npos) ? 1U : 0U;
        }
        EXPECT_EQ(once, 2U) << cpu; // The normal and the inverse frame
        EXPECT_EQ(always, 50U) << cpu;
    }
}

TEST_F(TwoCpusTest, ChannelOfOneCpuThatIsNotCalledIsFound)
{
    Verifies(req::SRS_CMG_130);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", "at: [500 ms]\nsample: 10\nparts: [a_calls, b_calls]\n"));
    for (const Part part : {Part::kCallsOfA, Part::kCallsOfB})
    {
        // OnCycle left out for ever, with an answer of 0
        const Outcome outcome = Try(session, part, FaultKind::kSkipped, 4U, 3U);
        EXPECT_EQ(outcome.result, Class::kDetected) << WordOf(part);
        EXPECT_FALSE(IsLate(outcome)) << WordOf(part);
    }
}

TEST_F(TwoCpusTest, CommandThatOneCpuIsNotToldIsFoundByBoth)
{
    Verifies(req::SRS_CMG_130);
    const Trap trap;
    Session session(COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/two_cpus_commands.yaml");
    const std::vector<RecordedCommand>& commands = session.Scenario().Record().commands;
    std::size_t stop = 0U;
    while (commands.at(stop).what.nmt != NmtState::kStopped)
    {
        ++stop;
    }
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        Experiment fault;
        fault.part = Part::kCommands;
        fault.kind = FaultKind::kSkipped;
        fault.subject = stop;
        fault.cpu = cpu;
        fault.cycle = session.Parts().device.AsTwoCpus()->CycleOfCommand(stop, cpu).value_or(0U);
        // Of one CPU alone it is silent (commands.yaml); here the other one has stopped, and finds its partner at work
        const Outcome outcome = session.Runs().Run(fault);
        EXPECT_EQ(outcome.result, Class::kDetected) << cpu;
        EXPECT_LE(outcome.us, 7000U) << cpu;
    }
}

// The sensor sends it at 510 ms; its frame lies between others, in the order of the bus.
TEST_F(TwoCpusTest, GfcIsACommandOfCpuAAlone)
{
    Verifies(req::SRS_CMG_130);
    const Trap trap;
    Session session(File("gfc.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                     "/examples/campaigns/two_cpus_sensor_at_work.yaml\ndevice: sensor\nat: [500 ms]\n"
                                     "cycles: 250\nparts: [commands]\nsample: 10\n"));
    const TwoCpus& device = *session.Parts().device.AsTwoCpus();
    const std::vector<RecordedCommand>& commands = session.Scenario().Record().commands;
    std::size_t gfcs = 0U;
    for (std::size_t command = 0U; command < commands.size(); ++command)
    {
        const bool is_gfc = commands[command].what.is_gfc;
        gfcs += is_gfc ? 1U : 0U;
        EXPECT_TRUE(device.CycleOfCommand(command, 0U).has_value()) << command;
        EXPECT_EQ(device.CycleOfCommand(command, 1U).has_value(), !is_gfc) << command;
    }
    EXPECT_EQ(gfcs, 1U);
}

TEST_F(TwoCpusTest, ClockOfOneCpuIsFoundByTheLinkAndInputsAreOfEachPath)
{
    Verifies(req::SRS_CMG_131);
    const Trap trap;
    Session session(TwoCpuPlan("actuator", kSmall));
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        EXPECT_EQ(Try(session, Part::kCounters, FaultKind::kStopped, cpu, 0U).result, Class::kDetected) << cpu;
        // 10 %; 100 ppm; by 10 s
        EXPECT_EQ(Try(session, Part::kCounters, FaultKind::kSlow, cpu, 9U).result, Class::kDetected) << cpu;
        EXPECT_EQ(Try(session, Part::kCounters, FaultKind::kSlow, cpu, 0U).result, Class::kBenign) << cpu;
        EXPECT_EQ(Try(session, Part::kCounters, FaultKind::kFast, cpu, 9U).result, Class::kDetected) << cpu;
        EXPECT_EQ(Try(session, Part::kCounters, FaultKind::kFast, cpu, 0U).result, Class::kBenign) << cpu;
        EXPECT_EQ(Try(session, Part::kCounters, FaultKind::kJump, cpu, 20U).result, Class::kDetected) << cpu;
    }
}

TEST_F(TwoCpusTest, WhatEachCpuHasIsTriedOfEach)
{
    Verifies(req::SRS_CMG_130);
    Verifies(req::SRS_CMG_131);
    const std::string tried =
        Tried("at: [500 ms]\nparts: [steps, kernel_calls, a_calls, b_calls, cycle, counters, inputs]\n"
              "reach: 2 ms\nsample: 40\n");
    for (const char* const text :
         {"cpu_a step ", "cpu_b step ", "cpu_a kernel.OnFrame call ", "cpu_b kernel.OnConfirm call ",
          "channel_a.OnCycle call ", "channel_b.OnCycle call ", "cpu_a cycle by ", "cpu_b cycle by ",
          "cpu_b cycle 1 times", "counter_a", "counter_b", "input 0", "input 1"})
    {
        EXPECT_NE(tried.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(tried.find("both_counters"), std::string::npos);
}

TEST_F(TwoCpusTest, ShardsAndOneProcessGiveTheSameBytes)
{
    Verifies(req::SRS_CMG_008);
    const std::string plan =
        TwoCpuPlan("actuator", "at: [500 ms]\nparts: [cross_link, link, cpu, steps, cycle]\nreach: 5 ms\nsample: 12\n");
    const std::string one = Path("one.csv");
    ASSERT_LE(Campaign({plan, "--jobs", "1", "--csv", one}).status, 1);
    ASSERT_LE(Campaign({plan, "--jobs", "1", "--shard", "1/3", "--out", Path("1.results")}).status, 1);
    ASSERT_LE(Campaign({plan, "--jobs", "2", "--shard", "2/3", "--out", Path("2.results")}).status, 1);
    ASSERT_LE(Campaign({plan, "--jobs", "1", "--shard", "3/3", "--out", Path("3.results")}).status, 1);
    const std::string merged = Path("merged.csv");
    ASSERT_LE(
        Campaign({"merge", plan, Path("1.results"), Path("2.results"), Path("3.results"), "--csv", merged}).status, 1);
    EXPECT_EQ(cia306::ReadTextFile(one), cia306::ReadTextFile(merged));
    EXPECT_NE(cia306::ReadTextFile(one).find("cpu,cpu_a as a whole,stopped"), std::string::npos);
}

TEST_F(TwoCpusTest, PartsThatTheDeviceDoesNotHaveAreRefused)
{
    Verifies(req::SRS_CMG_345);
    const tools::test::Answer both =
        Campaign({TwoCpuPlan("actuator", "at: [500 ms]\nparts: [kernel, both_channels]\n")});
    EXPECT_EQ(both.status, 2);
    EXPECT_NE(both.err.find("two_cpus.yaml:5:17: error: part 'both_channels' of which nothing is hit"),
              std::string::npos)
        << both.err;
    const tools::test::Answer one = Campaign({PlanFile("plan.yaml", "actuator", "at: [500 ms]\nparts: [link]\n")});
    EXPECT_EQ(one.status, 2);
    EXPECT_NE(one.err.find("plan.yaml:5:9: error: part 'link' of which nothing is hit"), std::string::npos) << one.err;
    const tools::test::Answer cpu = Campaign({TwoCpuPlan("actuator.a", kSmall)});
    EXPECT_EQ(cpu.status, 2);
    EXPECT_NE(cpu.err.find("two_cpus.yaml:3:9: error: one CPU of two"), std::string::npos) << cpu.err;
    const tools::test::Answer march = Campaign({TwoCpuPlan("actuator", std::string(kSmall) + "self_test: true\n")});
    EXPECT_EQ(march.status, 2);
    EXPECT_NE(march.err.find("two_cpus.yaml:3:9: error: output: pins or self_test: true with two CPUs"),
              std::string::npos)
        << march.err;
}

TEST_F(TwoCpusTest, LinkWithJitterAndCyclesThatOvertakeEachOtherAreRefused)
{
    Verifies(req::SRS_CMG_345);
    // Given the scenario of the examples, with one thing changed
    const auto refusal = [this](const std::string& from, const std::string& to)
    {
        const std::string examples = COUNTERPOINT_SOURCE_FOLDER "/examples/";
        std::string text = cia306::ReadTextFile(examples + "campaigns/two_cpus_at_work.yaml");
        text.replace(text.find(from), from.size(), to);
        for (std::size_t at = text.find("../"); at != std::string::npos; at = text.find("../"))
        {
            text.replace(at, 3U, examples);
        }
        static_cast<void>(File("scenario.yaml", text));
        const tools::test::Answer answer = Campaign(
            {File("plan.yaml", std::string("title: A test\nscenario: scenario.yaml\ndevice: actuator\n") + kSmall)});
        EXPECT_EQ(answer.status, 2) << answer.out;
        return answer.err;
    };
    EXPECT_NE(refusal("delay: 200 us}", "delay: 200 us, jitter: 50 us}")
                  .find("plan.yaml:3:9: error: one CPU of two, or a cross link with jitter, expected the device of "
                        "both, and a link with a delay alone"),
              std::string::npos);
    // Given cycles of CPU B that are 0.05 % shorter, and 480 us before those of CPU A: after a second they are behind
    const std::string overtakes = refusal("ppm: -20, start_us: 4294900000", "ppm: 500, start_us: 4294900000");
    EXPECT_NE(overtakes.find("counterpoint campaign: error: the cycles of the two CPUs overtake each other in cycle "),
              std::string::npos)
        << overtakes;
    EXPECT_NE(overtakes.find("; expected: phases farther apart, or less drift\n"), std::string::npos) << overtakes;
}
} // namespace
} // namespace counterpoint::campaign::test
