// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// NMT commands and the GFC: recorded, told to the kernel with a fault, and judged.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/variants.hpp"
#include "verification/trace/ids/simulator.hpp"

#include <map>
#include <set>

namespace counterpoint::campaign::test
{
namespace
{
class CommandsTest : public CampaignTest
{
  protected:
    /// A plan on the scenario with commands.
    [[nodiscard]] std::string CommandPlan(const std::string& device, const std::string& more) const
    {
        return File("commands.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                     "/examples/campaigns/commanded.yaml\ndevice: " +
                                         device + "\n" + more);
    }
    /// A plan on this scenario.
    [[nodiscard]] std::string PlanOn(const std::string& scenario) const
    {
        const std::string file = File("scenario.yaml", "extends: " COUNTERPOINT_SOURCE_FOLDER
                                                       "/examples/emergency_stop/chain.yaml\ntitle: A test\n" +
                                                           scenario);
        return File("plan.yaml", "title: A test\nscenario: " + file + "\ndevice: actuator\nat: [200 ms]\n");
    }
    /// How many faults of a plan have each kind and class.
    [[nodiscard]] static std::map<std::string, std::uint64_t> Tried(const std::string& plan)
    {
        const Trap trap;
        Session session(plan);
        std::map<std::string, std::uint64_t> counts;
        for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
        {
            const Experiment fault = session.Faults().At(number);
            ++counts[std::string(WordOf(fault.kind)) + " " + WordOf(session.Runs().Run(fault).result)];
        }
        return counts;
    }
};
using Counts = std::map<std::string, std::uint64_t>;

TEST_F(CommandsTest, DeviceOpensAndClosesWithTheSimulatedOne)
{
    Verifies(req::SRS_CMG_029);
    // Given an actuator that is stopped at 700.3 ms, gets a GFC at 1100 ms and is made PRE-OPERATIONAL at 1200.3 ms
    Session session(CommandPlan("actuator", "at: [500 ms]\nsample: 1\ncycles: 900\n"));
    std::vector<Nanoseconds> opened;
    for (std::size_t cycle = 1U; cycle < 1600U; ++cycle)
    {
        if (session.Runs().OpenWithoutFault(cycle) != session.Runs().OpenWithoutFault(cycle - 1U))
        {
            opened.push_back(session.Scenario().Record().cycles[cycle].at);
        }
    }
    // Then without a fault its output opens and closes where the simulated one does
    std::vector<Nanoseconds> simulated;
    for (const simulator::Event& event : session.Scenario().Simulated().Record().Events())
    {
        if (event.kind == simulator::EventKind::kOutput && event.node == session.Scenario().Node())
        {
            simulated.push_back(event.at);
        }
    }
    EXPECT_EQ(opened, simulated);
    EXPECT_EQ(opened.size(), 7U); // Open four times, closed three times.
}

TEST_F(CommandsTest, FaultsAreEachCommandOfTheCyclesInEachWay)
{
    Verifies(req::SRS_CMG_029);
    // Given 20 cycles, in the 11th of which the device is stopped
    const Session session(CommandPlan("actuator", "at: [690 ms]\ncycles: 20\nparts: [commands]\n"));
    std::set<std::string> told;
    for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
    {
        const Experiment fault = session.Faults().At(number);
        told.insert(std::string(WordOf(fault.kind)) + ": " + PlaceText(session.Parts(), fault));
    }
    // Then one stop is left out, told again and late by each number of cycles, each other command is told instead, and
    // each in each cycle
    EXPECT_EQ(session.Faults().Size(), 1U + 50U + 50U + 13U + 20U * 5U);
    for (const char* const each :
         {"skipped: command stopped in cycle 699", "doubled: command stopped in cycle 699 by 0 cycles",
          "late: command stopped in cycle 699 by 50 cycles",
          "wrong_command: command stopped in cycle 699 as operational",
          "wrong_command: command stopped in cycle 699 as gfc",
          "wrong_command: command stopped in cycle 699 as state 69", "inserted: command initialising",
          "inserted: command gfc"})
    {
        EXPECT_EQ(told.count(each), 1U) << each;
    }
}

TEST_F(CommandsTest, StopThatDoesNotComeIsSilentAndAStopThatNobodyGaveIsNoDetection)
{
    Verifies(req::SRS_CMG_029);
    Verifies(req::SRS_CMG_342);
    // Given an open output when the stop comes
    const Counts counts = Tried(CommandPlan("actuator", "at: [690 ms]\ncycles: 20\nparts: [commands]\n"));
    // Then it is silent where the stop does not come, comes late, or as OPERATIONAL or GFC; another state closes as it
    // does. Before the stop each other state closes, behind it OPERATIONAL alone is dangerous: 50 ms later somebody
    // acknowledges.
    const Counts expected{{"skipped silent", 1U},       {"doubled masked", 50U},      {"late silent", 50U},
                          {"inserted benign", 40U},     {"inserted masked", 50U},     {"inserted silent", 10U},
                          {"wrong_command silent", 2U}, {"wrong_command masked", 11U}};
    EXPECT_EQ(counts, expected);
}

TEST_F(CommandsTest, CommandsOfASenderOfTheGfcAreNotDangerous)
{
    Verifies(req::SRS_CMG_342);
    // Given the sensor, which sends the GFC at 1100 ms
    const Counts counts = Tried(CommandPlan("sensor", "at: [1095 ms]\ncycles: 10\nparts: [commands]\nkinds: [skipped, "
                                                      "doubled, late]\n"));
    for (const auto& [what, count] : counts)
    {
        EXPECT_EQ(what.find("silent"), std::string::npos) << what << " " << count;
    }
    EXPECT_GT(counts.size(), 0U);
}

TEST_F(CommandsTest, ScenarioThatIsNotThereIsToldAtItsName)
{
    Verifies(req::SRS_SIM_081);
    const std::string plan =
        File("plan.yaml", "title: A test\nscenario: nobody.yaml\ndevice: actuator\nat: [200 ms]\n");
    const tools::test::Answer answer = Campaign({plan});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err.rfind(plan + ":2:11: error: there is no file '", 0U), 0U) << answer.err;
}

TEST_F(CommandsTest, DeviceThatACommandResetsIsRefused)
{
    Verifies(req::SRS_CMG_343);
    for (const char* const command : {"reset_node", "reset_communication"})
    {
        const std::string plan = PlanOn("nmt:\n  - {at: 300 ms, node: all, command: " + std::string(command) + "}\n");
        const tools::test::Answer answer = Campaign({plan});
        EXPECT_EQ(answer.status, 2);
        EXPECT_NE(answer.err.find(plan + ":3:9: error: a device that an NMT command resets"), std::string::npos)
            << answer.err;
    }
}

TEST_F(CommandsTest, OutputThatIsOpenBehindAGfcIsWrongUntilAnAcknowledge)
{
    Verifies(req::SRS_CMG_342);
    // Given the judge of the actuator, which gets a GFC in cycle 1100, and which is acknowledged in cycle 1151
    const Plan plan = ReadPlan(CommandPlan("actuator", "at: [500 ms]\n"));
    const RecordedScenario scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node));
    Region region(1U << 20U);
    Device device(region, scenario.Model(), scenario.Record(), OutputKind::kGate);
    Judge judge(scenario.Record(), scenario.Model(), device);
    JudgeMemory memory;
    std::map<std::size_t, SrdoMask> stopped;
    for (std::size_t cycle = 0U; cycle < 1200U; ++cycle)
    {
        device.Cycle(cycle);
        EXPECT_EQ(judge.Look(cycle, memory).wrong, Wrong::kNothing) << cycle;
        stopped[cycle] = memory.stopped;
    }
    EXPECT_EQ(stopped[1098U], 0U);
    EXPECT_EQ(stopped[1100U], 1U);
    EXPECT_EQ(stopped[1148U], 1U);
    EXPECT_EQ(stopped[1151U], 0U);
}
} // namespace
} // namespace counterpoint::campaign::test
