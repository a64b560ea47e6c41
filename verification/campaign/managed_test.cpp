// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Campaigns of networks with managers.
#include "verification/campaign/campaign_rig.hpp"

#include "canopen/cia306/text/text_file.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace counterpoint::campaign::test
{
namespace
{
class ManagedTest : public CampaignTest
{
  protected:
    /// A plan for the network of the examples, with more lines.
    [[nodiscard]] std::string NetworkPlan(const std::string& name, const std::string& more) const
    {
        return File(name,
                    "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/managed.yaml\n" + more);
    }
};

TEST_F(ManagedTest, OutcomesAreTheSameForAnyNumberOfProcessesAndShards)
{
    Verifies(req::SRS_CMG_070);
    Verifies(req::SRS_CMG_071);
    Verifies(req::SRS_CMG_075);
    // Given six lost frames of the start of three safety slaves
    const std::string plan = NetworkPlan("plan.yaml", "until: 60 ms\nparts: [sdo]\nkinds: [lost]\nsample: 6\n");
    const tools::test::Answer one = Campaign({plan, "--jobs", "1", "--csv", Path("one.csv")});
    EXPECT_EQ(one.status, 0) << one.out << one.err;
    const std::string whole = cia306::ReadTextFile(Path("one.csv"));
    EXPECT_NE(whole.find("\n5,sdo,lost,"), std::string::npos) << whole;
    // When three processes try them, or two shards
    EXPECT_EQ(Campaign({plan, "--jobs", "3", "--csv", Path("three.csv")}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(Path("three.csv")), whole);
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "1/2", "--out", Path("first")}).status, 0);
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "2/2", "--out", Path("second")}).status, 0);
    // Then their outcomes are the same bytes
    EXPECT_EQ(Campaign({"merge", plan, Path("first"), Path("second"), "--csv", Path("merged.csv")}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(Path("merged.csv")), whole);
    // And a file in which some are missing is gone on with
    std::string results = cia306::ReadTextFile(Path("first"));
    ASSERT_EQ(results.size(), 56U);
    results.replace(40U, 8U, std::string(8U, '\0'));
    const std::string cut = File("cut", results);
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "1/2", "--out", cut}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(cut), cia306::ReadTextFile(Path("first")));
}

TEST_F(ManagedTest, PlansThatCannotBeUsedAreRefusedAtTheirPlace)
{
    Verifies(req::SRS_CMG_070);
    Verifies(req::SRS_CMG_071);
    const auto said = [this](const std::string& text)
    {
        const tools::test::Answer answer = Campaign({File("bad.yaml", text)});
        EXPECT_EQ(answer.status, 2) << answer.out;
        return answer.err;
    };
    const std::string head = "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/";
    EXPECT_NE(said(head + "at_work.yaml\n")
                  .find("bad.yaml:2:10: error: a scenario without managers, expected one with "
                        "managers"),
              std::string::npos);
    EXPECT_NE(said(head + "nobody.yaml\n").find("bad.yaml:2:10: error: there is no file '"), std::string::npos);
    EXPECT_NE(said(head + "managed.yaml\nuntil: 60 ms\nparts: [sdo, election]\n")
                  .find("bad.yaml:4:14: error: a part of which nothing is there between 'from' and 'until'"),
              std::string::npos);
    EXPECT_NE(said(head + "managed.yaml\nparts: [sdo]\nkinds: [lost, killed]\n")
                  .find("bad.yaml:4:15: error: a kind that none of the parts has"),
              std::string::npos);
    EXPECT_NE(
        said(head + "managed.yaml\nuntil: 5 s\n").find("bad.yaml:2:10: error: a scenario that ends before 'until'"),
        std::string::npos);
    EXPECT_NE(said(head + "managed.yaml\nparts: []\n").find("bad.yaml:3:8: error: an empty list"), std::string::npos);
    EXPECT_NE(said(head + "managed.yaml\nreach: 70 us\n").find("bad.yaml:3:8: error: a time that is no multiple"),
              std::string::npos);
}

TEST_F(ManagedTest, WhoToldIsCountedAndWhoDidNotIsIdle)
{
    Verifies(req::SRS_CMG_074);
    // Given three safety slaves, each of which restarts, and a teller that has no reason to tell anything
    const std::string plan =
        NetworkPlan("plan.yaml", "from: 200 ms\nuntil: 400 ms\nparts: [slaves]\n"
                                 "kinds: [restarted]\nsample: 6\ndetectors: [boot_up, election]\n");
    const tools::test::Answer answer = Campaign({plan, "--json", Path("report.json"), "--html", Path("page.html")});
    // Then the campaign does not hold, for this reason alone
    EXPECT_EQ(answer.status, 1) << answer.out;
    EXPECT_NE(answer.out.find("\nidle: election told nothing; the plan expects it to\n"), std::string::npos);
    EXPECT_EQ(answer.out.find("\nidle: boot_up"), std::string::npos);
    EXPECT_EQ(answer.out.find("\nsilent: "), std::string::npos);
    const auto report = nlohmann::json::parse(cia306::ReadTextFile(Path("report.json")));
    EXPECT_EQ(report.at("holds"), false);
    EXPECT_EQ(report.at("strata").size(), 1U);
    EXPECT_EQ(report.at("strata").at(0).at("injected"), 6U);
    EXPECT_EQ(report.at("strata").at(0).at("detected"), 6U);
    EXPECT_EQ(report.at("strata").at(0).at("silent"), 0U);
    EXPECT_NE(cia306::ReadTextFile(Path("page.html")).find("Told first by"), std::string::npos);
}

TEST_F(ManagedTest, OneExperimentIsToldStepByStep)
{
    Verifies(req::SRS_CMG_076);
    const std::string plan = NetworkPlan("plan.yaml", "from: 200 ms\nuntil: 400 ms\nparts: [slaves]\n"
                                                      "kinds: [restarted]\nsample: 3\n");
    const tools::test::Answer answer = Campaign({plan, "--replay", "1", "--html", Path("page.html")});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_NE(answer.out.find("FAULT: slaves restarted node 2 at "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("told by "), std::string::npos);
    EXPECT_NE(answer.out.find("\noutcome: detected, told by "), std::string::npos);
    EXPECT_NE(cia306::ReadTextFile(Path("page.html")).find("FAULT: slaves restarted"), std::string::npos);
    const tools::test::Answer none = Campaign({plan, "--replay", "3"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("expected the number of an experiment, 0 to 2"), std::string::npos) << none.err;
}

TEST_F(ManagedTest, BitsOfAManagersMemoryAreHitByMember)
{
    Verifies(req::SRS_CMG_080);
    Verifies(req::SRS_CMG_082);
    // Given two members of the manager's memory, while it reads and starts three safety slaves
    const std::string plan = NetworkPlan("plan.yaml", "until: 60 ms\nparts: [memory]\nmembers: [expectation 33, gate]\n"
                                                      "sample: 40\n");
    const tools::test::Answer one = Campaign({plan, "--jobs", "2", "--csv", Path("one.csv")});
    // Then these are hit and no other one, and none is dangerous
    EXPECT_EQ(one.status, 0) << one.out << one.err;
    const std::string whole = cia306::ReadTextFile(Path("one.csv"));
    EXPECT_NE(whole.find(",memory,flip,\"memory flip manager 127 expectation 33 at "), std::string::npos) << whole;
    EXPECT_NE(whole.find("flip manager 127 gate at "), std::string::npos) << whole;
    EXPECT_EQ(whole.find("manager 127 expectation 1 at "), std::string::npos) << whole;
    // And shards of other processes, whose addresses are others, find the same
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "1/2", "--out", Path("first")}).status, 0);
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "2/2", "--out", Path("second")}).status, 0);
    EXPECT_EQ(Campaign({"merge", plan, Path("first"), Path("second"), "--csv", Path("merged.csv")}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(Path("merged.csv")), whole);
}

TEST_F(ManagedTest, ProgramOfAManagerThatEndsIsThatManagersEndAlone)
{
    Verifies(req::SRS_CMG_080);
    // Given the role of a manager, which leads to a flying master that is not there
    const std::string plan = NetworkPlan("plan.yaml", "until: 60 ms\nparts: [memory]\nmembers: [role]\nsample: 120\n"
                                                      "detectors: [exception]\n");
    const tools::test::Answer answer = Campaign({plan});
    // Then some bits end its program, which is told, and nothing is dangerous
    EXPECT_EQ(answer.status, 0) << answer.out;
    EXPECT_EQ(answer.out.find("the program ended"), std::string::npos) << answer.out;
}

TEST_F(ManagedTest, ClockOfAManagerEndangersNobody)
{
    Verifies(req::SRS_CMG_081);
    Verifies(req::SRS_CMG_082);
    const std::string plan = NetworkPlan("plan.yaml", "from: 20 ms\nuntil: 200 ms\nparts: [clocks]\nsample: 4\n");
    const tools::test::Answer answer = Campaign({plan, "--json", Path("report.json"), "--csv", Path("rows.csv")});
    EXPECT_EQ(answer.status, 0) << answer.out;
    const auto report = nlohmann::json::parse(cia306::ReadTextFile(Path("report.json")));
    ASSERT_EQ(report.at("strata").size(), 4U);
    for (const auto& stratum : report.at("strata"))
    {
        EXPECT_EQ(stratum.at("injected"), 4U);
        EXPECT_EQ(stratum.at("silent"), 0U);
    }
    // A clock that stands still sends no heartbeat any more, and never goes unnoticed
    EXPECT_EQ(report.at("strata").at(0).at("kind"), "stopped");
    EXPECT_EQ(report.at("strata").at(0).at("masked"), 0U);
    const std::string rows = cia306::ReadTextFile(Path("rows.csv"));
    EXPECT_NE(rows.find("clocks stopped manager 127 at "), std::string::npos) << rows;
    EXPECT_NE(rows.find(" ppm\""), std::string::npos) << rows;
    EXPECT_NE(rows.find(" us\""), std::string::npos) << rows;
}

TEST_F(ManagedTest, MembersThatAreNotThereAreRefused)
{
    Verifies(req::SRS_CMG_080);
    const auto said = [this](const std::string& more)
    {
        const tools::test::Answer answer =
            Campaign({NetworkPlan("bad.yaml", "until: 60 ms\nparts: [memory]\n" + more)});
        EXPECT_EQ(answer.status, 2) << answer.out;
        return answer.err;
    };
    EXPECT_NE(said("members: [nobody]\n").find("bad.yaml:5:11: error: no member of a manager's memory that is hit"),
              std::string::npos);
    EXPECT_NE(said("members: [gate, gate]\n").find("bad.yaml:5:17: error: a member that is there already"),
              std::string::npos);
    EXPECT_NE(said("members: []\n").find("bad.yaml:5:10: error: an empty list"), std::string::npos);
}

TEST_F(ManagedTest, ConfigurationThatChangesBehindItsReadingIsListed)
{
    Verifies(req::SRS_CMG_073);
    // Given objects that change without a message shortly before their device is started, at 30 ms
    const std::string plan = NetworkPlan("plan.yaml", "from: 48 ms\nuntil: 53 ms\nparts: [writes]\nkinds: [stored]\n"
                                                      "sample: 300\n");
    const tools::test::Answer answer = Campaign({plan});
    EXPECT_EQ(answer.status, 0) << answer.out;
    EXPECT_NE(answer.out.find("a safety configuration changed without a message, behind its last reading"),
              std::string::npos)
        << answer.out;
    EXPECT_EQ(answer.out.find("\nsilent: "), std::string::npos) << answer.out;
}
} // namespace
} // namespace counterpoint::campaign::test
