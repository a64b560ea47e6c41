// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Campaigns of networks with managers.
#include "verification/campaign/campaign_rig.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "verification/campaign/managed/memory.hpp"
#include "verification/campaign/managed/space.hpp"
#include "verification/campaign/managed/stage.hpp"
#include "verification/campaign/managed/watch.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

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
    /// That what stands in `first` and `second` is refused as results of `plan`, and kept.
    void ExpectOthersAreRefused(const std::string& plan, const std::string& first, const std::string& second,
                                const std::string& why) const
    {
        const std::string before = cia306::ReadTextFile(Path(first));
        const tools::test::Answer on = Campaign({plan, "--jobs", "1", "--shard", "1/2", "--out", Path(first)});
        EXPECT_EQ(on.status, 2);
        EXPECT_EQ(on.err.find(Path(first) + ": error: results of another " + why), 0U) << on.err;
        const tools::test::Answer joined = Campaign({"merge", plan, Path(first), Path(second)});
        EXPECT_EQ(joined.status, 2);
        EXPECT_EQ(joined.err.find(Path(first) + ": error: results of another " + why), 0U) << joined.err;
        EXPECT_EQ(cia306::ReadTextFile(Path(first)), before);
    }
};

TEST_F(ManagedTest, OutcomesAreTheSameForAnyNumberOfProcessesAndShards)
{
    Verifies(req::SRS_CMG_070);
    Verifies(req::SRS_CMG_159);
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
    // And another seed draws others
    const std::string other =
        NetworkPlan("other.yaml", "until: 60 ms\nparts: [sdo]\nkinds: [lost]\nsample: 6\nseed: 2\n");
    static_cast<void>(Campaign({other, "--jobs", "1", "--csv", Path("other.csv")}));
    EXPECT_NE(cia306::ReadTextFile(Path("other.csv")), whole);
    // whose results are not those of this plan, for one that goes on and for one that joins
    ExpectOthersAreRefused(other, "first", "second", "plan");
    // nor those of another run without fault: the same plan, whose scenario is another one now
    const std::string of_a_copy =
        File("copy_plan.yaml", "title: A test\nnetwork: " + Path("copy.yaml") +
                                   "\nuntil: 60 ms\nparts: [sdo]\nkinds: [lost]\nsample: 6\n");
    const std::string extends = "extends: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/managed.yaml\n";
    static_cast<void>(File("copy.yaml", extends));
    for (const char* const shard : {"1/2", "2/2"})
    {
        const std::string out = Path((shard[0] == '1') ? "first_of_copy" : "second_of_copy");
        EXPECT_EQ(Campaign({of_a_copy, "--jobs", "1", "--shard", shard, "--out", out}).status, 0);
    }
    static_cast<void>(
        File("copy.yaml", extends + "inputs: [{at: 21 ms, node: sensor, object: 0x2000:01, value: 0}]\n"));
    ExpectOthersAreRefused(of_a_copy, "first_of_copy", "second_of_copy", "device");
    // And a file in which some are missing is gone on with
    std::string results = cia306::ReadTextFile(Path("first"));
    ASSERT_EQ(results.size(), 72U);
    results.replace(56U, 8U, std::string(8U, '\0'));
    const std::string cut = File("cut", results);
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "1/2", "--out", cut}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(cut), cia306::ReadTextFile(Path("first")));
}

TEST_F(ManagedTest, PlansThatCannotBeUsedAreRefusedAtTheirPlace)
{
    Verifies(req::SRS_CMG_214);
    Verifies(req::SRS_CMG_159);
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
    static_cast<void>(File("faulty.yaml", "extends: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/managed.yaml\n"
                                          "faults: [{fault: unplugged, node: sensor, at: 1 s}]\n"));
    EXPECT_NE(said("title: A test\nnetwork: " + Path("faulty.yaml") + "\n")
                  .find("bad.yaml:2:10: error: a scenario with faults, expected one without faults of its own"),
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

/// Faults of one kind of what is there in 200 us, with the one frame 101#0101.
struct Kind
{
    const char* part;
    const char* kind;
    std::uint64_t faults;
};

TEST_F(ManagedTest, FaultsOfEachKindAreAsManyAsThereAreWays)
{
    Verifies(req::SRS_CMG_071);
    Verifies(req::SRS_CMG_156);
    Verifies(req::SRS_CMG_157);
    Verifies(req::SRS_CMG_158);
    // Given 4 steps of 50 us, three devices and a manager, and one frame of two bytes for everybody and for each of the
    // three that receive it; later by up to 10 ms, which are 200 steps
    for (const Kind& each : {
             Kind{"srdo", "lost", 4U * 6U}, // 1 to 4 in a row, all of its identifier, all of the bus.
             Kind{"srdo", "repeated", 4U * 200U},
             Kind{"srdo", "delayed", 4U * 200U},
             Kind{"srdo", "inserted", 4U * 200U},
             Kind{"srdo", "wrong_order", 4U * 4U},
             Kind{"srdo", "corrupted", 4U * 16U},
             Kind{"srdo", "wrong_byte", 4U * 2U * 255U},
             Kind{"srdo", "wrong_length", 4U * 8U},
             Kind{"srdo", "wrong_identifier", 4U * (11U + 14U + 1U)}, // Bits, identifiers of the run, a remote frame.
             Kind{"slaves", "restarted", 4U * 3U * 12U},              // For 1, 2, 4, ..., 2048 ms.
             Kind{"slaves", "pulled", 4U * 3U},
             Kind{"slaves", "exchanged", 4U * 3U},
             Kind{"managers", "killed", 4U},
             Kind{"managers", "back", 4U * 12U},
             Kind{"managers", "off_bus", 4U * 12U},
             // Four SRDOs of 14 + 17 bytes and a signature of 2, three devices with 1300h, 13FEh and 13FFh:00
             Kind{"writes", "foreign", 4U * 8U * 141U},
             Kind{"writes", "stored", 4U * 8U * 141U},
         })
    {
        const std::string plan =
            NetworkPlan("plan.yaml", "from: 283 ms\nuntil: 283200 us\nreach: 10 ms\nsample: 1\nparts: [" +
                                         std::string(each.part) + "]\nkinds: [" + each.kind + "]\n");
        const tools::test::Answer answer = Campaign({plan, "--json", Path("report.json")});
        EXPECT_EQ(answer.err, "") << each.kind;
        const auto report = nlohmann::json::parse(cia306::ReadTextFile(Path("report.json")));
        ASSERT_EQ(report.at("strata").size(), 1U);
        EXPECT_EQ(report.at("strata").at(0).at("part"), each.part);
        EXPECT_EQ(report.at("strata").at(0).at("kind"), each.kind);
        EXPECT_EQ(report.at("strata").at(0).at("faults"), each.faults) << each.kind;
    }
}

TEST_F(ManagedTest, WhoToldIsCountedAndWhoDidNotIsIdle)
{
    Verifies(req::SRS_CMG_074);
    Verifies(req::SRS_CMG_346);
    Verifies(req::SRS_CMG_347);
    // Given three safety slaves, each of which restarts, and a teller that has no reason to tell anything
    const std::string plan =
        NetworkPlan("plan.yaml", "from: 200 ms\nuntil: 400 ms\nparts: [slaves]\n"
                                 "kinds: [restarted]\nsample: 6\ndetectors: [boot_up, election]\n");
    const tools::test::Answer answer =
        Campaign({plan, "--json", Path("report.json"), "--html", Path("page.html"), "--csv", Path("report.csv")});
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
    // and each form has part, kind and outcomes, with the bound of none of six at 99 %: 1 - 0.01 ^ (1 / 6)
    EXPECT_EQ(report.at("strata").at(0).at("part"), "slaves");
    EXPECT_EQ(report.at("strata").at(0).at("kind"), "restarted");
    EXPECT_EQ(report.at("confidence_percent"), 99U);
    EXPECT_NEAR(report.at("strata").at(0).at("silent_at_most").get<double>(), 0.53584, 0.000005);
    EXPECT_NE(answer.out.find("\nslaves            restarted "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find(" 53.5841 % "), std::string::npos) << answer.out;
    const std::string page = cia306::ReadTextFile(Path("page.html"));
    EXPECT_NE(page.find("<td>slaves</td><td>restarted</td>"), std::string::npos);
    EXPECT_NE(page.find("53.5841 %"), std::string::npos);
    const std::string rows = cia306::ReadTextFile(Path("report.csv"));
    EXPECT_NE(rows.find(",slaves,restarted,"), std::string::npos) << rows;
    EXPECT_NE(rows.find(",detected,boot_up,"), std::string::npos) << rows;
}

TEST_F(ManagedTest, AKnownPlaceAtWhichNothingIsFoundIsTold)
{
    Verifies(req::SRS_CMG_347);
    for (const bool are_all_tried : {true, false})
    {
        // Given a place that is called known, and faults that are all told; when all of them are tried, or some
        const std::string plan = NetworkPlan(
            "plan.yaml", std::string("from: 200 ms\nuntil: 200100 us\nparts: [slaves]\nkinds: [pulled]\n") +
                             (are_all_tried ? "" : "sample: 3\n") + "known: [{place: slave, reason: a test}]\n");
        const tools::test::Answer answer = Campaign({plan});
        // Then the campaign does not hold where all were
        EXPECT_EQ(answer.status, are_all_tried ? 1 : 0) << answer.out << answer.err;
        EXPECT_EQ(answer.out.find("\nstale: nothing was found at slave, which the plan calls known\n") !=
                      std::string::npos,
                  are_all_tried)
            << answer.out;
    }
}

TEST_F(ManagedTest, AKnownPlaceAtWhichSomethingIsFoundIsNotTold)
{
    Verifies(req::SRS_CMG_347);
    // Given all faults of one stop for a slave with another configuration, of which two are silent, and their place
    const std::string plan = File(
        "plan.yaml", "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/wrong.yaml\n"
                     "from: 304950 us\nuntil: 305050 us\nparts: [nmt]\nkinds: [lost]\ndetectors: [status]\n"
                     "known: [{place: \"nmt lost 000#0221 at 305.000 ms, all of its identifier\", reason: why}]\n");
    const tools::test::Answer answer = Campaign({plan, "--json", Path("report.json")});
    // Then the campaign holds: that place is needed, and the teller that is named told something
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_EQ(answer.out.find("\nstale: "), std::string::npos) << answer.out;
    EXPECT_EQ(answer.out.find("\nidle: "), std::string::npos) << answer.out;
    const auto report = nlohmann::json::parse(cia306::ReadTextFile(Path("report.json")));
    EXPECT_EQ(report.at("strata").at(0).at("injected"), 24U);
    EXPECT_EQ(report.at("strata").at(0).at("silent"), 2U);
    EXPECT_EQ(report.at("holds"), true);
}

TEST_F(ManagedTest, OneExperimentIsToldStepByStep)
{
    Verifies(req::SRS_CMG_076);
    const std::string plan = NetworkPlan("plan.yaml", "from: 200 ms\nuntil: 400 ms\nparts: [slaves]\n"
                                                      "kinds: [restarted]\nsample: 3\n");
    const tools::test::Answer answer = Campaign({plan, "--replay", "1", "--html", Path("page.html")});
    EXPECT_EQ(answer.status, 0) << answer.err;
    for (const char* const line : {"    225.950 ms  FAULT: slaves restarted node 2 at 225.950 ms, for 128.000 ms\n",
                                   "    256.810 ms  told by device: device 2: SRDO 1: sct\n",
                                   "    392.000 ms  manager 127 sends 000#0102  (not then without the fault)\n",
                                   "\noutcome: detected, told by device, after 30.860 ms\n"})
    {
        EXPECT_NE(answer.out.find(line), std::string::npos) << line << answer.out;
    }
    EXPECT_NE(cia306::ReadTextFile(Path("page.html")).find("FAULT: slaves restarted"), std::string::npos);
    const tools::test::Answer none = Campaign({plan, "--replay", "3"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("expected the number of an experiment, 0 to 2"), std::string::npos) << none.err;
}

TEST_F(ManagedTest, FramesAroundAFaultOfAFrameAreShown)
{
    Verifies(req::SRS_CMG_076);
    const std::string plan =
        NetworkPlan("plan.yaml", "from: 200 ms\nuntil: 400 ms\nparts: [srdo]\nkinds: [lost]\nsample: 3\n");
    const tools::test::Answer answer = Campaign({plan, "--replay", "1"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    // Then the pair that is hit is there, as it is without the fault, and what the manager sends later is not
    EXPECT_NE(
        answer.out.find("    283.124 ms  node 1 sends 101#0101\n    283.124 ms  FAULT: srdo lost 101#0101 at "
                        "283.124 ms, all of the bus from then on, manager 127 alone\n    283.258 ms  node 1 sends "
                        "102#FEFE\n"),
        std::string::npos)
        << answer.out;
    EXPECT_NE(answer.out.find("    408.000 ms  manager 127 sends 000#8101  (not then without the fault)\n"),
              std::string::npos)
        << answer.out;
}

TEST_F(ManagedTest, WhatIsSilentIsShownWithWhatIsWrongAndStatus1)
{
    Verifies(req::SRS_CMG_076);
    // Given a program whose gate stays open when a safety slave restarts
    const std::string folder = COUNTERPOINT_SOURCE_FOLDER "/verification/campaign/planted/";
    const std::string line = std::string(COUNTERPOINT_PLANTED) + "/counterpoint_campaign_gate_stays_open campaign " +
                             folder + "managed_restart.yaml --replay 0 > " + Path("out");
    const int status = std::system(line.c_str());
    const std::string told = cia306::ReadTextFile(Path("out"));
    EXPECT_EQ(WEXITSTATUS(status), 1) << told;
    EXPECT_NE(told.find("WRONG: a safety slave was started before its verification had succeeded\n"), std::string::npos)
        << told;
    EXPECT_NE(told.find("\noutcome: silent"), std::string::npos) << told;
}

TEST_F(ManagedTest, BitsOfAManagersMemoryAreHitByMember)
{
    Verifies(req::SRS_CMG_080);
    Verifies(req::SRS_CMG_211);
    Verifies(req::SRS_CMG_082);
    Verifies(req::SRS_CMG_348);
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

TEST_F(ManagedTest, FirstWordOfAMemberNamesAllThatHaveIt)
{
    Verifies(req::SRS_CMG_211);
    // Given each bit of 50 us, of one expectation, and of all
    const auto faults = [this](const std::string& members)
    {
        const std::string plan = NetworkPlan("plan.yaml", "from: 20 ms\nuntil: 20050 us\nparts: [memory]\nsample: 1\n"
                                                          "members: [" +
                                                              members + "]\n");
        static_cast<void>(Campaign({plan, "--json", Path("report.json")}));
        const auto report = nlohmann::json::parse(cia306::ReadTextFile(Path("report.json")));
        return report.at("strata").at(0).at("faults").get<std::uint64_t>();
    };
    const std::uint64_t of_each = faults("expectation 1") + faults("expectation 2") + faults("expectation 33");
    EXPECT_GT(of_each, 0U);
    EXPECT_EQ(faults("expectation"), of_each); // Not those of expectation_count.
}

TEST_F(ManagedTest, MembersAreAllThatAManagerDecidesBy)
{
    Verifies(req::SRS_CMG_080);
    const auto members = [this](const std::string& scenario)
    {
        managed::Stage stage(managed::ReadManagedPlan(File(
            "plan.yaml", "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/" + scenario)));
        stage.World().RunUntil(20'000'000);
        std::set<std::string> names;
        for (const managed::ManagerPlace& place : managed::PlacesOf(*stage.Managers().front()))
        {
            EXPECT_GT(place.size, 0U) << place.name;
            names.insert(place.name);
        }
        return names;
    };
    // Given a manager of three safety slaves, and one that may be elected
    const std::set<std::string> all = members("managed.yaml\n");
    const std::set<std::string> elected = members("flying.yaml\n");
    // Then expectations, setup, concise DCFs, node table, gate, queue, connections, start-up and election are hit
    for (const char* const name :
         {"network", "expectation 1", "expectation 2", "expectation 33", "expectation_count 33", "slave 33",
          "concise_dcf 33", "record 33", "watched 33", "table", "gate_told 33", "gate", "safety", "commands", "nmt",
          "lanes", "sdo", "boot 33", "cia302"})
    {
        EXPECT_EQ(all.count(name), 1U) << name;
    }
    EXPECT_EQ(elected.count("flying"), 1U);
    EXPECT_EQ(elected.count("flying_times"), 1U);
}

// The range of the program and its libraries in the memory of this process, as the system tells it.
bool IsInTheProgram(const std::uint64_t word)
{
    std::ifstream ranges("/proc/self/maps");
    bool is_in = false;
    for (std::string line; std::getline(ranges, line);)
    {
        const std::size_t dash = line.find('-');
        is_in = is_in || ((line.find(" /") != std::string::npos) && (std::stoull(line, nullptr, 16) <= word) &&
                          (word < std::stoull(line.substr(dash + 1U), nullptr, 16)));
    }
    return is_in;
}

TEST_F(ManagedTest, AFlipChangesItsBitAloneAndNoAddress)
{
    Verifies(req::SRS_CMG_210);
    managed::Stage stage(managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n")));
    stage.World().RunUntil(20'000'000);
    simulator::SimulatedManager& manager = *stage.Managers().front();
    int addresses = 0;
    int values = 0;
    // Given each word of the manager's role, which refers to its parts and knows functions of the program
    for (const managed::ManagerPlace& place : managed::PlacesOf(manager))
    {
        for (std::uint32_t byte = 0U; (place.name == "role") && (byte + 8U <= place.size); byte += 8U)
        {
            ASSERT_EQ(reinterpret_cast<std::uintptr_t>(place.bytes + byte) % 8U, 0U);
            std::uint64_t before = 0U;
            std::memcpy(&before, place.bytes + byte, 8U);
            // When bit 3 of its first byte is hit
            managed::FlipIn(manager, "role", byte, 3U);
            std::uint64_t behind = 0U;
            std::memcpy(&behind, place.bytes + byte, 8U);
            // Then an address stays, and of anything else this bit changes
            if (IsInTheProgram(before))
            {
                ++addresses;
                EXPECT_EQ(behind, before) << byte;
            }
            else if ((before >> 40U) == 0U)
            {
                ++values;
                EXPECT_EQ(behind, before ^ 8U) << byte;
            }
            else
            {
                // On the heap.
            }
            std::memcpy(place.bytes + byte, &before, 8U);
        }
    }
    EXPECT_GT(addresses, 0);
    EXPECT_GT(values, 0);
}

TEST_F(ManagedTest, ProgramOfAManagerThatEndsIsThatManagersEndAlone)
{
    Verifies(req::SRS_CMG_212);
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
    // 3600 steps of 50 us: stands still, 13 rates faster and slower, 20 times both ways
    std::vector<std::uint64_t> faults;
    for (const auto& stratum : report.at("strata"))
    {
        faults.push_back(stratum.at("faults").get<std::uint64_t>());
        EXPECT_EQ(stratum.at("injected"), 4U);
        EXPECT_EQ(stratum.at("silent"), 0U);
    }
    EXPECT_EQ(faults, (std::vector<std::uint64_t>{3600U, 3600U * 13U, 3600U * 13U, 3600U * 40U}));
    // A clock that stands still sends no heartbeat any more, and never goes unnoticed
    EXPECT_EQ(report.at("strata").at(0).at("kind"), "stopped");
    EXPECT_EQ(report.at("strata").at(0).at("masked"), 0U);
    const std::string rows = cia306::ReadTextFile(Path("rows.csv"));
    EXPECT_NE(rows.find("clocks stopped manager 127 at "), std::string::npos) << rows;
    EXPECT_NE(rows.find(" ppm\""), std::string::npos) << rows;
    EXPECT_NE(rows.find(" us\""), std::string::npos) << rows;
}

TEST_F(ManagedTest, ClockOfAManagerIsWrongByEachRateAndJump)
{
    Verifies(req::SRS_CMG_081);
    const auto of = [](const managed::Fault fault, const std::uint32_t variant)
    {
        managed::Trial trial;
        trial.target = managed::Target::kClocks;
        trial.fault = fault;
        trial.variant = variant;
        return managed::Space::ClockFaultOf(trial);
    };
    EXPECT_EQ(of(managed::Fault::kStopped, 0U).rate_ppm, -1000000);
    // 100 ppm to 90 %
    EXPECT_EQ(of(managed::Fault::kFast, 0U).rate_ppm, 100);
    EXPECT_EQ(of(managed::Fault::kFast, 12U).rate_ppm, 900000);
    EXPECT_EQ(of(managed::Fault::kSlow, 0U).rate_ppm, -100);
    EXPECT_EQ(of(managed::Fault::kSlow, 12U).rate_ppm, -900000);
    // 50 us to half of 2^32, both ways
    EXPECT_EQ(of(managed::Fault::kJump, 0U).jump_us, 50);
    EXPECT_EQ(of(managed::Fault::kJump, 1U).jump_us, -50);
    EXPECT_EQ(of(managed::Fault::kJump, 38U).jump_us, 2147483647);
    EXPECT_EQ(of(managed::Fault::kJump, 39U).jump_us, -2147483647);
}

TEST_F(ManagedTest, ClockOfAManagerIsThatOfItsCyclesAndNotOfWhatItTells)
{
    Verifies(req::SRS_CMG_081);
    constexpr std::int64_t kMs = 1'000'000;
    struct Case
    {
        simulator::ManagerClockFault fault;
        std::int64_t cycle;
    };
    // Given a clock that is 90 % fast, 50 % slow, stands still, or jumps by 10 s, from 20 ms on
    const Case cases[] = {{{20 * kMs, 900000, 0}, 526315},
                          {{20 * kMs, -500000, 0}, 2 * kMs},
                          {{20 * kMs, -1000000, 0}, kMs},
                          {{20 * kMs, 0, 10000 * kMs}, kMs}};
    for (const Case& one : cases)
    {
        managed::Stage stage(managed::ReadManagedPlan(NetworkPlan("plan.yaml", "until: 60 ms\n")));
        stage.World().RunUntil(20 * kMs);
        simulator::SimulatedManager& manager = *stage.Managers().front();
        manager.Disturb(one.fault);
        const std::size_t before = manager.Events().size();
        // When it runs on until its start-up tells of lost slaves
        stage.World().RunUntil(3000 * kMs);
        ASSERT_GT(manager.Events().size(), before) << one.fault.rate_ppm;
        // Then what it tells has the time of the simulation
        std::uint64_t last_us = 20000U;
        for (std::size_t event = before; event < manager.Events().size(); ++event)
        {
            EXPECT_GE(manager.Events()[event].at_us, last_us) << one.fault.rate_ppm;
            last_us = manager.Events()[event].at_us;
        }
        EXPECT_LE(last_us, 3000000U);
        // And its cycles are as long as its oscillator makes them
        std::set<std::int64_t> cycles;
        std::int64_t next = manager.NextEvent();
        for (int cycle = 0; cycle < 20; ++cycle)
        {
            stage.World().RunUntil(next);
            cycles.insert(manager.NextEvent() - next);
            next = manager.NextEvent();
        }
        EXPECT_EQ(cycles.count(one.cycle), 1U) << one.fault.rate_ppm;
    }
}

TEST_F(ManagedTest, MembersThatAreNotThereAreRefused)
{
    Verifies(req::SRS_CMG_211);
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
    // Given objects that change without a message shortly before their device is started, at 55 ms
    const std::string plan = NetworkPlan("plan.yaml", "from: 50 ms\nuntil: 55 ms\nparts: [writes]\nkinds: [stored]\n"
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
