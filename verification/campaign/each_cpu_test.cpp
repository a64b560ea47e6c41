// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device of two CPUs: what is tried of either of them, and that the other one gets everything as without it.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/two_cpus.hpp"
#include "verification/campaign/variants.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
const std::vector<std::string> kFlowKinds{"skipped", "doubled", "reordered", "late"};

class EachCpuTest : public CampaignTest
{
  protected:
    [[nodiscard]] std::string TwoCpuPlan(const std::string& more) const
    {
        return File("each_cpu.yaml", "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                                     "/examples/campaigns/two_cpus_at_work.yaml\ndevice: actuator\n" +
                                         more);
    }
    /// What was tried, as CSV.
    [[nodiscard]] std::string TriedOf(const std::string& plan) const
    {
        const std::string file = Path("tried.csv");
        EXPECT_EQ(Campaign({plan, "--jobs", "1", "--csv", file}).status, 0);
        return cia306::ReadTextFile(file);
    }
    /// The bytes of all members whose names begin so.
    [[nodiscard]] static std::vector<std::uint8_t> BytesOf(Device& device, const std::string& begin)
    {
        std::vector<std::uint8_t> bytes;
        for (const Place& place : device.Places())
        {
            const std::uint8_t* const first = device.Memory().Bytes() + place.offset;
            if (place.name.rfind(begin, 0U) == 0U)
            {
                bytes.insert(bytes.end(), first, first + place.size);
            }
        }
        EXPECT_FALSE(bytes.empty()) << begin;
        return bytes;
    }
};

TEST_F(EachCpuTest, EachStepCallAndCycleIsTriedInEachWay)
{
    Verifies(req::SRS_CMG_130);
    const std::string tried = TriedOf(TwoCpuPlan("at: [500 ms]\nparts: [steps, kernel_calls, a_calls, b_calls, cycle]\n"
                                                 "reach: 2 ms\nsample: all\n"));
    std::vector<std::string> expected;
    for (const std::string cpu : {"cpu_a", "cpu_b"})
    {
        for (const std::string& kind : kFlowKinds)
        {
            for (const char* const step : {"clocks", "channel_a", "channel_b", "guard", "comparison", "demotion",
                                           "commit", "production", "events"})
            {
                expected.push_back("steps," + cpu + " step " + step + "," + kind + ",");
                expected.push_back("steps," + cpu + " step " + step + " always," + kind + ",");
            }
            if (kind != "reordered") // It has no step behind it.
            {
                expected.push_back("steps," + cpu + " step permits," + kind + ",");
                expected.push_back("steps," + cpu + " step permits always," + kind + ",");
            }
            for (const char* const call : {"kernel.OnFrame", "kernel.OnConfirm"})
            {
                for (const char* const turn : {" call 1", " call 2", " call 3", " call 4", " call 4 always"})
                {
                    expected.push_back("kernel_calls," + cpu + " " + call + turn + "," + kind + ",");
                }
            }
        }
        expected.push_back("cycle," + cpu + " cycle 1 times,skipped,");
        expected.push_back("cycle," + cpu + " cycle 5 times,skipped,");
        expected.push_back("cycle," + cpu + " cycle 1 times,doubled,");
        expected.push_back("cycle," + cpu + " cycle by 0.05 ms,late,");
        expected.push_back("cycle," + cpu + " cycle by 2.00 ms,late,");
        expected.push_back("cycle," + cpu + " cycle by 0.05 ms,early,");
        expected.push_back("cycle," + cpu + " cycle by 0.95 ms,early,");
    }
    for (const std::string& kind : kFlowKinds)
    {
        for (const std::string call : {"OnFrame", "OnConfirm", "OnCycle", "Held", "Demote", "Commit", "Answer",
                                       "Prepare", "InverseFrame", "Load", "Recheck"})
        {
            expected.push_back("a_calls,channel_a." + call + " call 1," + kind + ",");
            expected.push_back("b_calls,channel_b." + call + " call 4 always," + kind + ",");
        }
    }
    for (const std::string& line : expected)
    {
        EXPECT_NE(tried.find("," + line), std::string::npos) << line;
    }
    // A CPU calls its own channel alone
    EXPECT_EQ(tried.find("a_calls,channel_b"), std::string::npos);
    EXPECT_EQ(tried.find("b_calls,channel_a"), std::string::npos);
}

TEST_F(EachCpuTest, EachWrongCommandIsTriedOfOneCpuAtATime)
{
    Verifies(req::SRS_CMG_130);
    const std::string tried = TriedOf(COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/two_cpus_commands.yaml");
    for (const std::string cpu : {"cpu_a", "cpu_b"})
    {
        const std::string begin = ",commands," + cpu + " command ";
        for (const std::string state : {"operational", "pre_operational", "stopped"})
        {
            for (const char* const kind : {"skipped", "doubled", "late", "wrong_command"})
            {
                std::size_t found = 0U;
                for (std::size_t at = tried.find(begin + state + " "); at != std::string::npos;
                     at = tried.find(begin + state + " ", at + 1U))
                {
                    const std::string line = tried.substr(at, tried.find('\n', at) - at);
                    found += (line.find("," + std::string(kind) + ",") != std::string::npos) ? 1U : 0U;
                }
                EXPECT_GT(found, 0U) << cpu << " " << state << " " << kind;
            }
            EXPECT_NE(tried.find(begin + state + ",inserted,"), std::string::npos) << cpu << " " << state;
        }
        EXPECT_NE(tried.find(begin + "gfc,inserted,"), std::string::npos) << cpu;
    }
}

TEST_F(EachCpuTest, TheOtherCpuGetsEverythingAsWithoutTheFault)
{
    Verifies(req::SRS_CMG_130);
    const Plan plan = ReadPlan(TwoCpuPlan("at: [500 ms]\nsample: 10\n"));
    const RecordedScenario scenario(plan.scenario, runtime::YamlValue(plan.file, plan.device_node));
    const std::vector<std::string> channels{"cpu_a.channel_a.", "cpu_b.channel_b."};
    constexpr std::size_t kBegin = 499U;
    constexpr std::size_t kEnd = 530U;
    // Memory of a device has one address: one device after the other
    const auto run = [&scenario, &channels](const Experiment* const fault)
    {
        Region region(1U << 20U);
        TwoCpus device(region, scenario, true);
        std::vector<std::vector<std::vector<std::uint8_t>>> seen;
        for (std::size_t cycle = 0U; cycle < kEnd; ++cycle)
        {
            if (cycle == kBegin)
            {
                device.Rewind(cycle, fault, 600U, 1U);
            }
            device.Cycle(cycle);
            seen.push_back({BytesOf(device, channels[0]), BytesOf(device, channels[1])});
        }
        return seen;
    };
    const auto sound = run(nullptr);
    for (std::size_t cpu = 0U; cpu < 2U; ++cpu)
    {
        // Given that one CPU does not get the normal frame of the SRDO which opens the output
        Experiment fault;
        fault.part = Part::kKernelCalls;
        fault.kind = FaultKind::kSkipped;
        fault.cycle = kBegin;
        fault.subject = (cpu == 0U) ? 2U : 1U; // So many frames come before it.
        fault.variant = kAlways;
        fault.cpu = cpu;
        const auto seen = run(&fault);
        std::size_t cycle = 0U;
        while (cycle < kEnd && seen[cycle][cpu] == sound[cycle][cpu])
        {
            // Then the other one has what it has without that
            EXPECT_EQ(seen[cycle][1U - cpu], sound[cycle][1U - cpu]) << cpu << " " << cycle;
            ++cycle;
        }
        // also where the first one lacks a frame
        ASSERT_LT(cycle, kEnd) << cpu;
        EXPECT_GE(cycle, kBegin) << cpu;
        EXPECT_EQ(seen[cycle][1U - cpu], sound[cycle][1U - cpu]) << cpu << " " << cycle;
    }
}
} // namespace
} // namespace counterpoint::campaign::test
