// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Plans, samples, shards, reports, and the planted defects that a campaign has to find.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/statistics.hpp"

#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <sys/wait.h>
#include <thread>

namespace counterpoint::campaign::test
{
namespace
{
constexpr const char* kSmall = "at: [500 ms]\ncycles: 2\nparts: [flow_monitor]\nkinds: [flip]\n";
constexpr const char* kQuick = "at: [500 ms]\ncycles: 2\nparts: [latch, flow_monitor, clocks]\nkinds: [flip]\n";
/// Most of them end in the first cycles, some go on until the end.
constexpr const char* kMixed = "at: [500 ms]\ncycles: 2\nsample: 60\n";

using PlanTest = CampaignTest;
using ShardTest = CampaignTest;
using ReportTest = CampaignTest;

TEST_F(PlanTest, FaultsAreEachBitAtEachPhaseOfEachCycleInEachWay)
{
    Verifies(req::SRS_CMG_003);
    // Given 12 bytes of a latch, 2 cycles, 14 phases, 4 kinds
    const Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\ncycles: 2\nparts: [latch]\n"));
    EXPECT_EQ(session.Faults().Size(), 12U * 8U * 2U * 14U * 4U);
    std::set<std::string> seen;
    std::set<std::string> phases;
    std::set<std::string> kinds;
    for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
    {
        const Experiment fault = session.Faults().At(number);
        phases.insert(WordOf(fault.phase));
        kinds.insert(WordOf(fault.kind));
        seen.insert(PlaceText(session.Parts(), fault) + WordOf(fault.kind) + WordOf(fault.phase) +
                    std::to_string(fault.cycle));
    }
    EXPECT_EQ(seen.size(), session.Faults().Size());
    EXPECT_EQ(seen.count("latch+0.0flipbefore_frames499"), 1U);
    EXPECT_EQ(seen.count("latch+11.7stuck_at_1permits500"), 1U);
    EXPECT_EQ(phases, (std::set<std::string>{"before_frames", "between_frames", "after_frames", "self_test", "clocks",
                                             "guard", "channel_a", "channel_b", "comparison", "demotion", "production",
                                             "commit", "events", "permits"}));
    EXPECT_EQ(kinds, (std::set<std::string>{"flip", "stuck_at_0", "stuck_at_1", "intermittent"}));
}

TEST_F(PlanTest, WordsWithAnAddressOfTheProgramAreLeftOutAndCounted)
{
    Verifies(req::SRS_CMG_003);
    // The tables of virtual functions of flow monitor and both channels
    const std::string plan = PlanFile("plan.yaml", "actuator", "at: [500 ms]\nsample: 1\n");
    EXPECT_EQ(Session(plan).Faults().LeftOut(), 24U);
    EXPECT_NE(Campaign({plan}).out.find("left out: 24 bytes"), std::string::npos);
}

TEST_F(PlanTest, SampleIsDrawnBySeedAlone)
{
    Verifies(req::SRS_CMG_004);
    const auto drawn = [this](const std::string& more)
    {
        const Session session(PlanFile("plan.yaml", "actuator", more));
        std::vector<std::string> faults;
        for (std::uint64_t number = 0U; number < session.Faults().Size(); ++number)
        {
            faults.push_back(PlaceText(session.Parts(), session.Faults().At(number)));
        }
        return faults;
    };
    const std::string plan = "at: [500 ms]\nparts: [guard]\nkinds: [flip]\nsample: 50\n";
    EXPECT_EQ(drawn(plan).size(), 50U);
    EXPECT_EQ(drawn(plan), drawn(plan));
    EXPECT_NE(drawn(plan), drawn(plan + "seed: 2\n"));
}

TEST_F(ShardTest, AnyNumberOfProcessesAndShardsGivesTheSameBytes)
{
    Verifies(req::SRS_CMG_008);
    const std::string plan = PlanFile("plan.yaml", "actuator", kMixed);
    // Given the results of one process
    const tools::test::Answer alone =
        Campaign({plan, "--jobs", "1", "--out", Path("alone"), "--csv", Path("alone.csv")});
    // When three do it, or two shards that are joined
    static_cast<void>(Campaign({plan, "--jobs", "3", "--out", Path("three")}));
    static_cast<void>(Campaign({plan, "--shard", "1/2", "--out", Path("first")}));
    static_cast<void>(Campaign({plan, "--shard", "2/2", "--out", Path("second")}));
    const tools::test::Answer joined =
        Campaign({"merge", plan, Path("second"), Path("first"), "--out", Path("joined"), "--csv", Path("joined.csv")});
    // or five, of which one is given twice
    std::vector<std::string> five{"merge", plan};
    for (const char* const shard : {"1/5", "2/5", "3/5", "4/5", "5/5"})
    {
        five.push_back(Path(std::string("of_five_") + shard[0]));
        static_cast<void>(Campaign({plan, "--shard", shard, "--out", five.back()}));
    }
    five.insert(five.end(), {five.back(), "--out", Path("joined_five")});
    static_cast<void>(Campaign(five));
    EXPECT_EQ(cia306::ReadTextFile(Path("alone")), cia306::ReadTextFile(Path("joined_five")));
    // Then files and report are the same
    EXPECT_EQ(cia306::ReadTextFile(Path("alone")), cia306::ReadTextFile(Path("three")));
    EXPECT_EQ(cia306::ReadTextFile(Path("alone")), cia306::ReadTextFile(Path("joined")));
    EXPECT_EQ(cia306::ReadTextFile(Path("alone.csv")), cia306::ReadTextFile(Path("joined.csv")));
    EXPECT_EQ(alone.out, joined.out);
    // and one shard alone does not hold
    const tools::test::Answer half = Campaign({"merge", plan, Path("first")});
    EXPECT_EQ(half.status, 1);
    EXPECT_NE(half.out.find("open: 1200 experiments were not tried"), std::string::npos) << half.out;
}

TEST_F(ShardTest, CampaignThatWasKilledGoesOnToTheSameBytes)
{
    Verifies(req::SRS_CMG_008);
    const std::string plan = PlanFile("plan.yaml", "actuator", kMixed);
    const tools::test::Answer whole = Campaign({plan, "--jobs", "1", "--out", Path("whole")});
    // Given a campaign that is killed as soon as it has some outcomes
    const pid_t child = fork();
    if (child == 0)
    {
        static_cast<void>(Campaign({plan, "--jobs", "1", "--out", Path("killed")}));
        _exit(0);
    }
    const auto has_some = [this]()
    {
        std::error_code none;
        const std::string bytes =
            std::filesystem::exists(Path("killed"), none) ? cia306::ReadTextFile(Path("killed")) : std::string();
        return bytes.find_first_not_of('\0', 48U) != std::string::npos;
    };
    for (int look = 0; look < 60000 && !has_some(); ++look)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    // When it is begun again
    const tools::test::Answer again = Campaign({plan, "--jobs", "1", "--out", Path("killed")});
    // Then
    EXPECT_EQ(cia306::ReadTextFile(Path("killed")), cia306::ReadTextFile(Path("whole")));
    EXPECT_EQ(again.out, whole.out);
}

TEST_F(ShardTest, ResultsOfSomethingElseAreRefused)
{
    Verifies(req::SRS_CMG_008);
    const std::string plan = PlanFile("plan.yaml", "actuator", kSmall);
    static_cast<void>(Campaign({plan, "--out", Path("results")}));
    const std::string other = PlanFile("other.yaml", "actuator", std::string(kSmall) + "seed: 2\n");
    EXPECT_EQ(Campaign({other, "--out", Path("results")}).status, 2);
    EXPECT_EQ(Campaign({"merge", other, Path("results")}).status, 2);
    EXPECT_EQ(Campaign({"merge", plan, plan}).status, 2);
    EXPECT_EQ(Campaign({plan, "--shard", "3/2"}).status, 2);
}

TEST(Statistics, BoundIsThatOfClopperAndPearson)
{
    Verifies(req::SRS_CMG_010);
    EXPECT_NEAR(UpperBound(0U, 299U, 0.95), 0.0100, 0.0001); // 1 - 0.05^(1/299)
    EXPECT_NEAR(UpperBound(0U, 459U, 0.99), 0.0100, 0.0001);
    EXPECT_NEAR(UpperBound(0U, 2995U, 0.95), 0.0010, 0.00001);
    EXPECT_NEAR(UpperBound(1U, 100U, 0.95), 0.0466, 0.0001);
    EXPECT_EQ(UpperBound(0U, 0U, 0.95), 1.0);
    EXPECT_EQ(UpperBound(7U, 7U, 0.95), 1.0);
    EXPECT_EQ(Quantile({1U, 2U, 3U, 4U}, 0.5), 2U);
    EXPECT_EQ(Quantile({1U, 2U, 3U, 4U}, 0.999), 4U);
}

TEST_F(ReportTest, SilentAndLateFaultsAreNamedAndTheCampaignDoesNotHold)
{
    Verifies(req::SRS_CMG_010);
    Verifies(req::SRS_CMG_007);
    Verifies(req::SRS_CMG_341);
    // Given a campaign of which all was detected in 1 ms, but number 5, which is silent, and number 7, which is late
    Session session(PlanFile("plan.yaml", "actuator",
                             "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n"));
    ASSERT_EQ(session.Faults().Size(), 8U);
    Results results("", session.Identity(Shard{}));
    for (std::uint64_t index = 0U; index < 8U; ++index)
    {
        results.Put(index, Outcome{Class::kDetected, Detector::kLatch, 0U, 0U, 1000U});
    }
    EXPECT_TRUE(Summarise(session.Parts(), results).Holds());
    results.Put(5U, Outcome{Class::kSilent, Detector::kNobody, static_cast<std::uint8_t>(Wrong::kData), 0U, 2000U});
    results.Put(7U, Outcome{Class::kDetected, Detector::kLatch, 0U, 1U, 1009000U});
    // When it is reported
    const Summary summary = Summarise(session.Parts(), results);
    const std::string text = TextReport(session.Parts(), summary);
    const std::string page = HtmlReport(session.Parts(), summary);
    // Then
    EXPECT_FALSE(summary.Holds());
    EXPECT_EQ(summary.tallies.front().Effective(), 8U);
    EXPECT_NE(text.find("silent: experiment 5: latch+0.5, flip, cycle 499, phase permits: nobody, open with data that "
                        "the bus did not bring, 2.000 ms"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("late: experiment 7: latch+0.7"), std::string::npos) << text;
    EXPECT_NE(page.find("<td>latch+0.5</td>"), std::string::npos);
    EXPECT_NE(page.find("name=\"viewport\""), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos); // Nothing is fetched.
    EXPECT_NE(CsvText(session.Parts(), results).find("\n5,latch,latch+0.5,flip,499,permits,silent,nobody,"),
              std::string::npos);
}

TEST_F(ReportTest, CampaignThatHoldsEndsWithStatus0)
{
    Verifies(req::SRS_CMG_341);
    const std::string plan = PlanFile("plan.yaml", "actuator", std::string(kQuick) + "detectors: [latch]\n");
    EXPECT_EQ(Campaign({plan}).status, 2); // The latch detects nothing: it is what is hit.
    const tools::test::Answer answer =
        Campaign({PlanFile("good.yaml", "actuator", std::string(kQuick) + "detectors: [clocks, flow_monitor]\n"),
                  "--html", Path("page.html")});
    EXPECT_EQ(answer.status, 0) << answer.out;
    EXPECT_NE(answer.out.find("verdict: holds"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(Path("page.html")));
}

/// A program with one defect, a plan that the shipped one holds, and what is told of the other.
struct Defect
{
    std::string program;
    std::string plan;
    std::string told;
};

constexpr const char* kPlanted = COUNTERPOINT_SOURCE_FOLDER "/verification/campaign/planted/";

/// The table that ./dev campaign reads, too.
std::vector<Defect> Defects()
{
    std::vector<Defect> defects;
    const auto table = nlohmann::json::parse(cia306::ReadTextFile(std::string(kPlanted) + "expected.json"));
    for (const auto& row : table.at("defects"))
    {
        defects.push_back({row.at("program"), row.at("plan"), row.at("told")});
    }
    return defects;
}

class PlantedDefects : public CampaignTest, public ::testing::WithParamInterface<Defect>
{
  protected:
    [[nodiscard]] tools::test::Answer RunOf(const std::string& program) const
    {
        const std::string line = program + " campaign " + kPlanted + GetParam().plan + " > " + Path("out");
        const int status = std::system(line.c_str());
        return {WEXITSTATUS(status), cia306::ReadTextFile(Path("out")), ""};
    }
};

TEST_P(PlantedDefects, AreNamedByACampaignThatHoldsWithoutThem)
{
    Verifies(req::SRS_CMG_011);
    Verifies(req::SRS_CMG_040);
    Verifies(req::SRS_CMG_043);
    Verifies(req::SRS_CMG_072);
    Verifies(req::SRS_CMG_215);
    Verifies(req::SRS_CMG_221);
    Verifies(req::SRS_CMG_077);
    Verifies(req::SRS_CMG_082);
    Verifies(req::SRS_CMG_083);
    Verifies(req::SRS_CMG_342);
    Verifies(req::SRS_CMG_344);
    const tools::test::Answer sound = RunOf(COUNTERPOINT_CAMPAIGN);
    EXPECT_EQ(sound.status, 0) << sound.out;
    const tools::test::Answer broken =
        RunOf(std::string(COUNTERPOINT_PLANTED) + "/counterpoint_campaign_" + GetParam().program);
    EXPECT_EQ(broken.status, 1) << broken.out;
    EXPECT_NE(broken.out.find(GetParam().told), std::string::npos) << broken.out;
    EXPECT_NE(broken.out.find("verdict: does not hold"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Parts, PlantedDefects, ::testing::ValuesIn(Defects()),
                         [](const auto& parameter) { return parameter.param.program; });

TEST_F(ReportTest, AnyExperimentIsShownAgainAsTimeLineAndPage)
{
    Verifies(req::SRS_CMG_044);
    const std::string plan =
        PlanFile("plan.yaml", "actuator",
                 "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n");
    // When experiment 5 is shown again
    const tools::test::Answer answer = Campaign({plan, "--replay", "5", "--html", Path("page.html")});
    // Then the fault, what it does and the outcome of the CSV file are told
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.out.find("fault      latch+0.5, flip, at permits of cycle 499"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("output     SAFE"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("outcome: detected, by latch"), std::string::npos) << answer.out;
    static_cast<void>(Campaign({plan, "--csv", Path("rows.csv")}));
    EXPECT_NE(cia306::ReadTextFile(Path("rows.csv")).find("\n5,latch,latch+0.5,flip,499,permits,detected,latch,"),
              std::string::npos);
    const std::string page = cia306::ReadTextFile(Path("page.html"));
    EXPECT_NE(page.find("<td>latch+0.5, flip, at permits of cycle 499</td>"), std::string::npos);
    EXPECT_NE(page.find("name=\"viewport\""), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos);
    // and one that there is not is refused
    EXPECT_NE(Campaign({plan, "--replay", "8"}).err.find("'8', expected the number of an experiment, 0 to 7"),
              std::string::npos);
}

TEST_F(ReportTest, ProgramsAreToldClassesTimesMapAndSurvivors)
{
    Verifies(req::SRS_CMG_045);
    // Given 8 faults, of which number 5 is silent, the others detected in 1 ms
    const Session session(
        PlanFile("plan.yaml", "actuator",
                 "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n"));
    Results results("", session.Identity(Shard{}));
    for (std::uint64_t index = 0U; index < 8U; ++index)
    {
        results.Put(index, Outcome{Class::kDetected, Detector::kLatch, 0U, 0U, 1000U});
    }
    results.Put(5U, Outcome{Class::kSilent, Detector::kNobody, static_cast<std::uint8_t>(Wrong::kData), 0U, 2000U});
    // When they are told
    const Summary summary = Summarise(session.Parts(), results);
    const std::string json = JsonText(session.Parts(), summary);
    // Then
    for (const char* const text :
         {"\"format\": \"counterpoint-campaign-1\"", "\"holds\": false", "\"effective\": 8", "\"detected\": 7",
          "\"latch\": 7", "\"median_us\": 1000", "\"up_to_us\": 1000", "\"phase\": \"permits\"", "\"experiment\": 5",
          "\"declared\": \"safety_core/kernel/kernel_context.hpp:27\""})
    {
        EXPECT_NE(json.find(text), std::string::npos) << text << json;
    }
    EXPECT_NE(HtmlReport(session.Parts(), summary).find("<td><b>1</b>/8</td>"), std::string::npos);
}

TEST_F(ReportTest, WrongUntilTheSelfTestFoundItIsToldApartAndDoesNotHold)
{
    Verifies(req::SRS_CMG_151);
    Verifies(req::SRS_CMG_152);
    // Given 8 faults, of which number 5 was open with wrong data for 400 ms, the others detected in 1 ms
    const std::string lines =
        "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\nself_test: true\n";
    const auto told = [this, &lines](const std::string& known)
    {
        const Session session(PlanFile("plan.yaml", "actuator", lines + known));
        Results results("", session.Identity(Shard{}));
        for (std::uint64_t index = 0U; index < 8U; ++index)
        {
            results.Put(index, Outcome{Class::kDetected, Detector::kSelfTest, 0U, 0U, 1000U});
        }
        const auto fault = static_cast<std::uint8_t>(DeviceFault::kSelfTest);
        results.Put(5U, Outcome{Class::kExposed, Detector::kSelfTest, fault, 0U, 400000U});
        const Summary summary = Summarise(session.Parts(), results);
        return std::vector<std::string>{TextReport(session.Parts(), summary), HtmlReport(session.Parts(), summary),
                                        JsonText(session.Parts(), summary), CsvText(session.Parts(), results)};
    };
    // Then each report says so, with the time, and it is not among those that were detected
    const std::vector<std::string> without = told("");
    EXPECT_NE(without[0].find("exposed: experiment 5: latch+0.5, flip, cycle 499, phase permits: self_test, open with "
                              "wrong data until the self test found it, 400.000 ms\n"),
              std::string::npos)
        << without[0];
    EXPECT_NE(without[0].find("found first by: self_test 7\n"), std::string::npos) << without[0];
    EXPECT_NE(without[0].find("verdict: does not hold"), std::string::npos);
    EXPECT_NE(without[1].find("<h2>Exposed: open with wrong data until the self test found it: 1</h2>"),
              std::string::npos);
    EXPECT_NE(without[1].find("<td>400.000</td>"), std::string::npos);
    const auto json = nlohmann::json::parse(without[2]);
    EXPECT_EQ(json.at("holds"), false);
    EXPECT_EQ(json.at("strata").at(0).at("exposed"), 1);
    EXPECT_EQ(json.at("strata").at(0).at("detected"), 7);
    EXPECT_EQ(json.at("strata").at(0).at("worst_us"), 1000);
    EXPECT_EQ(json.at("map").at(0).at("exposed"), 1);
    EXPECT_EQ(json.at("survivors").at(0).at("class"), "exposed");
    EXPECT_EQ(json.at("survivors").at(0).at("us"), 400000);
    EXPECT_NE(without[3].find("\n5,latch,latch+0.5,flip,499,permits,exposed,self_test,open with wrong data until the "
                              "self test found it,400000,0\n"),
              std::string::npos)
        << without[3];
    // and it holds where the plan knows of an exposed fault there, not where it knows of a late one
    const std::string place = "known:\n  - {place: latch+0.5, class: ";
    EXPECT_NE(told(place + "exposed, reason: march}\n")[0].find("verdict: holds"), std::string::npos);
    EXPECT_NE(told(place + "late, reason: march}\n")[0].find("verdict: does not hold"), std::string::npos);
    EXPECT_NE(told(place + "late, reason: march}\n")[0].find("stale: nothing was found at latch+0.5"),
              std::string::npos);
}

TEST_F(ReportTest, FaultsThatLayForLongerThanTheLimitAreToldAsLatent)
{
    Verifies(req::SRS_CMG_155);
    // Given 8 faults that were detected, of which two lay for long and did nothing
    const Session session(
        PlanFile("plan.yaml", "actuator",
                 "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n"));
    Results results("", session.Identity(Shard{}));
    for (std::uint64_t index = 0U; index < 8U; ++index)
    {
        const bool is_latent = index == 2U || index == 5U;
        results.Put(index,
                    Outcome{Class::kDetected, Detector::kLatch, 0U, is_latent ? kMarkLatent : std::uint8_t{0U}, 1000U});
    }
    const Summary summary = Summarise(session.Parts(), results);
    // Then each report says so, and the campaign holds
    const std::string line = "latent: 2 differed elsewhere in memory for longer than the limit, and were found in time "
                             "behind the first thing that the device did otherwise\n";
    EXPECT_NE(TextReport(session.Parts(), summary).find(line), std::string::npos);
    EXPECT_NE(HtmlReport(session.Parts(), summary).find("<p>" + line + "</p>"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(JsonText(session.Parts(), summary)).at("latent"), 2);
    EXPECT_TRUE(summary.Holds());
}

TEST_F(ReportTest, FaultThatIsNoMemoryIsToldByWhatWasHit)
{
    Verifies(req::SRS_CMG_044);
    Verifies(req::SRS_CMG_045);
    Verifies(req::SRS_CMG_046);
    // Given counter A and B each stopped, of which that of B was late
    const std::string lines = "at: [550 ms]\nparts: [counters]\nkinds: [stopped]\n";
    const std::string plan = PlanFile("plan.yaml", "actuator", lines);
    const auto told = [this, &lines](const std::string& known)
    {
        const Session session(PlanFile("plan.yaml", "actuator", lines + known));
        Results results("", session.Identity(Shard{}));
        for (std::uint64_t index = 0U; index < 3U; ++index)
        {
            results.Put(index, Outcome{Class::kDetected, Detector::kClocks, 0U, 0U, 1000U});
        }
        const auto fault = static_cast<std::uint8_t>(DeviceFault::kClock);
        results.Put(1U, Outcome{Class::kDetected, Detector::kClocks, fault, kMarkLate, 150000U});
        const Summary summary = Summarise(session.Parts(), results);
        EXPECT_NE(HtmlReport(session.Parts(), summary).find("<td>counter_b</td>"), std::string::npos);
        return nlohmann::json::parse(JsonText(session.Parts(), summary));
    };
    // Then the map has a row for each, and the late one has a place and no byte
    const auto json = told("");
    EXPECT_EQ(json.at("map").size(), 0U);
    EXPECT_EQ(json.at("subjects").size(), 3U);
    EXPECT_EQ(json.at("subjects").at(1).dump(), "{\"effective\":1,\"exposed\":0,\"injected\":1,\"kind\":\"stopped\","
                                                "\"silent\":0,\"subject\":\"counter_b\"}");
    EXPECT_EQ(json.at("survivors").at(0).at("place"), "counter_b -1000000 ppm");
    EXPECT_EQ(json.at("survivors").at(0).at("member"), "counter_b");
    EXPECT_EQ(json.at("survivors").at(0).at("declared"), "");
    EXPECT_TRUE(json.at("survivors").at(0).at("byte").is_null());
    EXPECT_EQ(json.at("holds"), false);
    EXPECT_EQ(told("known:\n  - {place: counter_b -1000000 ppm, class: late, reason: clocks}\n").at("holds"), true);
    EXPECT_EQ(told("known:\n  - {place: counter_b, reason: clocks}\n").at("holds"), true);
    EXPECT_EQ(told("known:\n  - {place: counter, reason: clocks}\n").at("holds"), false);
    EXPECT_EQ(told("known:\n  - {place: counter_a -1000000 ppm, class: late, reason: clocks}\n").at("holds"), false);
    // and it can be shown again
    const tools::test::Answer answer = Campaign({plan, "--replay", "1", "--html", Path("page.html")});
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.out.find("fault      counter_b -1000000 ppm, stopped, "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("outcome: detected, by clocks"), std::string::npos) << answer.out;
    EXPECT_NE(cia306::ReadTextFile(Path("page.html")).find("<td>counter_b -1000000 ppm, stopped"), std::string::npos);
}

TEST_F(ReportTest, FindingsThatSomebodyAnswersForAreToldAndStaleReasonsFail)
{
    Verifies(req::SRS_CMG_046);
    // Given a plan that knows of bit 5, and one that knows of a byte at which nothing is found
    const std::string lines =
        "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\nknown:\n";
    const auto judged = [this, &lines](const std::string& known, const std::uint64_t silent)
    {
        const Session session(PlanFile("plan.yaml", "actuator", lines + known));
        Results results("", session.Identity(Shard{}));
        for (std::uint64_t index = 0U; index < 8U; ++index)
        {
            results.Put(index, Outcome{Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
        }
        results.Put(silent, Outcome{Class::kSilent, Detector::kNobody, 1U, 0U, 0U});
        return TextReport(session.Parts(), Summarise(session.Parts(), results));
    };
    const std::string bit = "  - {place: latch+0.5, reason: march over live memory}\n";
    // Then bit 5 is told with the reason and the campaign holds, with bit 4 it does not
    EXPECT_NE(judged(bit, 5U).find("(known: march over live memory)"), std::string::npos);
    EXPECT_NE(judged(bit, 5U).find("verdict: holds"), std::string::npos);
    EXPECT_NE(judged(bit, 4U).find("verdict: does not hold"), std::string::npos);
    // nor does it where a reason is needed by nothing
    EXPECT_NE(judged(bit + "  - {place: latch+0.6, reason: march}\n", 5U).find("stale: nothing was found at latch+0.6"),
              std::string::npos);
}

TEST_F(ReportTest, ChannelThatNeverReportedItsCauseByItselfFailsTheCampaign)
{
    Verifies(req::SRS_CMG_041);
    // Given a plan by which channel B has to report SRVT by itself
    const Session session(
        PlanFile("plan.yaml", "actuator",
                 "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n"
                 "voices: [channel_b.srvt]\n"));
    const auto judged = [&session](const SrdoCause cause, const std::uint8_t marks)
    {
        Results results("", session.Identity(Shard{}));
        for (std::uint64_t index = 0U; index < 8U; ++index)
        {
            results.Put(index, Outcome{Class::kDetected, Detector::kLatch, 0U, 0U, 1000U});
        }
        results.Put(3U, Outcome{Class::kDetected, Detector::kChannels, static_cast<std::uint8_t>(cause), marks, 1000U});
        return Summarise(session.Parts(), results);
    };
    // When it did so once, then the campaign holds
    EXPECT_TRUE(judged(SrdoCause::kSrvt, 4U).Holds());
    // When only the other channel did, or it reported another cause, or none by itself, then it does not
    EXPECT_FALSE(judged(SrdoCause::kSrvt, 2U).Holds());
    EXPECT_FALSE(judged(SrdoCause::kSct, 4U).Holds());
    EXPECT_FALSE(judged(SrdoCause::kSrvt, 0U).Holds());
    // and the report says of whom
    EXPECT_NE(TextReport(session.Parts(), judged(SrdoCause::kSct, 4U))
                  .find("idle: channel_b.srvt found nothing; the plan expects it to"),
              std::string::npos);
}
} // namespace
} // namespace counterpoint::campaign::test
