// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device of two CPUs: what it is made of, the link between them, and what becomes of its faults.
#include "verification/campaign/campaign_rig.hpp"

#include "simulator/journal/journal.hpp"

#include <algorithm>
#include <set>

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
                                     const std::uint32_t variant)
    {
        Experiment fault;
        fault.part = part;
        fault.kind = kind;
        fault.cycle = 499U;
        fault.subject = subject;
        fault.variant = variant;
        return session.Runs().Run(fault);
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
        // When one is, or a bit of it, or it comes again 1 ms later, or behind the next one, nothing is done
        for (const auto& [kind, variant] :
             std::vector<std::pair<FaultKind, std::uint32_t>>{{FaultKind::kLost, 0U},
                                                              {FaultKind::kCorrupted, 100U},
                                                              {FaultKind::kRepeated, 19U},
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
        // 10 %
        const Outcome fast = Try(session, Part::kCpu, FaultKind::kFast, cpu, 9U);
        EXPECT_EQ(fast.result, Class::kDetected);
        EXPECT_FALSE(IsLate(fast));
        // 100 ppm
        EXPECT_EQ(Try(session, Part::kCpu, FaultKind::kFast, cpu, 0U).result, Class::kBenign);
    }
}

TEST_F(TwoCpusTest, ShardsAndOneProcessGiveTheSameBytes)
{
    Verifies(req::SRS_CMG_008);
    const std::string plan =
        TwoCpuPlan("actuator", "at: [500 ms]\nparts: [cross_link, link, cpu]\nreach: 5 ms\nsample: 12\n");
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
    Verifies(req::SRS_CMG_061);
    const tools::test::Answer steps = Campaign({TwoCpuPlan("actuator", "at: [500 ms]\nparts: [kernel, steps]\n")});
    EXPECT_EQ(steps.status, 2);
    EXPECT_NE(steps.err.find("two_cpus.yaml:5:17: error: part 'steps' of which nothing is hit"), std::string::npos)
        << steps.err;
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
} // namespace
} // namespace counterpoint::campaign::test
