// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a campaign writes: the file of results, and the rows of the CSV file.
#include "verification/campaign/campaign_rig.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "version/version.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <utility>

namespace counterpoint::campaign::test
{
namespace
{
using ResultsTest = CampaignTest;

TEST_F(ResultsTest, FileInWhichABitIsWrongIsRefused)
{
    Verifies(req::SRS_CMG_008);
    // Given a file of four outcomes, one of which is not tried yet
    const ResultsOf of{0x123456789ABCDEF0U, 8U, {2U, 2U}};
    {
        Results results(Path("whole"), of);
        results.Put(0U, {Class::kDetected, Detector::kSelfTest, 3U, kMarkLate, 1234U});
        results.Put(1U, {Class::kExposed, Detector::kNobody, 0U, 0U, 0xFFFFFFFFU});
        results.Put(3U, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
    }
    const Results again(Path("whole"), of);
    EXPECT_EQ(again.At(0U).result, Class::kDetected);
    EXPECT_EQ(again.At(0U).detector, Detector::kSelfTest);
    EXPECT_EQ(again.At(1U).us, 0xFFFFFFFFU);
    EXPECT_EQ(again.OpenCount(), 1U);
    const std::string whole = cia306::ReadTextFile(Path("whole"));
    ASSERT_EQ(whole.size(), 80U);
    // When any bit of it is wrong, then it is neither gone on with nor joined
    Results all("", {of.plan, of.total, {1U, 1U}});
    all.Merge(Path("whole"));
    for (std::size_t bit = 0U; bit < whole.size() * 8U; ++bit)
    {
        std::string damaged = whole;
        damaged[bit / 8U] = static_cast<char>(damaged[bit / 8U] ^ (1 << (bit % 8U)));
        const std::string file = File("damaged", damaged);
        EXPECT_THROW(Results(file, of), runtime::YamlError) << bit;
        EXPECT_THROW(all.Merge(file), runtime::YamlError) << bit;
    }
}

TEST_F(ResultsTest, FileOfAnotherProgramIsRefused)
{
    Verifies(req::SRS_CMG_501);
    // Given results of a plan, and the same program with other objects
    const std::string plan = PlanFile("plan.yaml", "actuator", "at: [500 ms]\nparts: [latch]\nsample: 1\n");
    EXPECT_EQ(Campaign({plan, "--jobs", "1", "--out", Path("first")}).status, 0);
    const std::string before = cia306::ReadTextFile(Path("first"));
    std::ostringstream content;
    content << std::ifstream(COUNTERPOINT_CAMPAIGN, std::ios::binary).rdbuf();
    std::string program = content.str();
    const std::string version = CounterpointVersion;
    const std::size_t place = program.find(version);
    ASSERT_NE(place, std::string::npos);
    char& digit = program[place + version.size() - 2U];
    digit = (digit == '0') ? '1' : '0';
    const std::string other = File("other", program);
    ASSERT_EQ(chmod(other.c_str(), S_IRUSR | S_IXUSR), 0);
    // When it goes on with them, or joins them, then they are refused and kept
    const auto said = [this, &other](const std::string& arguments)
    {
        const std::string command = other + " campaign " + arguments + " > /dev/null 2> " + Path("err");
        const int status = std::system(command.c_str());
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 2) << arguments;
        return cia306::ReadTextFile(Path("err"));
    };
    const std::string refused = Path("first") + ": error: results of another program, expected results of this "
                                                "program, by its version, commit and objects\n";
    EXPECT_EQ(said(plan + " --jobs 1 --out " + Path("first")), refused);
    EXPECT_EQ(said("merge " + plan + " " + Path("first")), refused);
    EXPECT_EQ(cia306::ReadTextFile(Path("first")), before);
}

// Another commit, and other objects.
TEST_F(ResultsTest, DigestIsOfTheWholeVersion)
{
    Verifies(req::SRS_CMG_501);
    const std::uint64_t here = OfProgram(1U, "counterpoint 0.1.0 (commit 0123456789ab, objects 0123456789abcdef)");
    EXPECT_EQ(here, OfProgram(1U, "counterpoint 0.1.0 (commit 0123456789ab, objects 0123456789abcdef)"));
    EXPECT_NE(here, OfProgram(2U, "counterpoint 0.1.0 (commit 0123456789ab, objects 0123456789abcdef)"));
    EXPECT_NE(here, OfProgram(1U, "counterpoint 0.2.0 (commit 0123456789ab, objects 0123456789abcdef)"));
    EXPECT_NE(here, OfProgram(1U, "counterpoint 0.1.0 (commit 1123456789ab, objects 0123456789abcdef)"));
    EXPECT_NE(here, OfProgram(1U, "counterpoint 0.1.0 (commit 0123456789ab, objects 1123456789abcdef)"));
}

TEST_F(ResultsTest, AFileWithNothingInItBeginsAndIsTold)
{
    Verifies(req::SRS_CMG_330);
    const ResultsOf of{0x123456789ABCDEF0U, 8U, {2U, 2U}};
    const auto told = [&of](const std::string& file)
    {
        const Results results(file, of);
        EXPECT_EQ(results.OpenCount(), 4U);
        std::ostringstream err;
        TellEmpty(results, "out", err);
        return err.str();
    };
    const std::string warning =
        "out: warning: there is nothing in it, expected results to go on with; all experiments are tried\n";
    // Given an empty file, or one of as many zeros as results would be
    EXPECT_EQ(told(File("empty", "")), warning);
    EXPECT_EQ(told(File("zeros", std::string(80U, '\0'))), warning);
    // Then it is a file of results, as one that was not there
    EXPECT_EQ(told(Path("empty")), "");
    EXPECT_EQ(told(Path("new")), "");
    EXPECT_EQ(Results::Read(Path("zeros")).total, 8U);
}

TEST_F(ResultsTest, OutcomesWithoutAHeaderAreRefused)
{
    Verifies(req::SRS_CMG_330);
    // Given outcomes of some plan, whose header is 0
    const ResultsOf of{0x123456789ABCDEF0U, 8U, {2U, 2U}};
    {
        Results results(Path("whole"), of);
        results.Put(3U, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
    }
    std::string text = cia306::ReadTextFile(Path("whole"));
    ASSERT_EQ(text.size(), 80U);
    text.replace(0U, 48U, std::string(48U, '\0'));
    const std::string file = File("headless", text);
    // Then they are no results of this one, and stay as they are
    EXPECT_THROW(Results(file, of), runtime::YamlError);
    EXPECT_EQ(cia306::ReadTextFile(file), text);
}

TEST_F(ResultsTest, TheTitleOfAReportSaysSomething)
{
    Verifies(req::SRS_CMG_004);
    const std::string rest = "scenario: at_work.yaml\ndevice: actuator\nat: [500 ms]\n";
    for (const std::string title : {"\"\"", "\"  \""})
    {
        const tools::test::Answer answer = Campaign({File("plan.yaml", "title: " + title + "\n" + rest)});
        EXPECT_EQ(answer.status, 2);
        EXPECT_NE(answer.err.find(":1:8: error: an empty title, expected what the report is called"), std::string::npos)
            << answer.err;
    }
}

/// Fields of each row but the first, by the heads of the first one, read as RFC 4180 has it.
std::vector<std::map<std::string, std::string>> RowsOf(const std::string& csv)
{
    std::vector<std::vector<std::string>> rows(1U, std::vector<std::string>(1U));
    bool is_quoted = false;
    for (const char character : csv)
    {
        if (character == '"')
        {
            is_quoted = !is_quoted;
        }
        else if (character == ',' && !is_quoted)
        {
            rows.back().emplace_back();
        }
        else if (character == '\n' && !is_quoted)
        {
            rows.emplace_back(1U);
        }
        else
        {
            rows.back().back() += character;
        }
    }
    std::vector<std::map<std::string, std::string>> by_heads;
    for (std::size_t row = 1U; row + 1U < rows.size(); ++row)
    {
        EXPECT_EQ(rows[row].size(), rows[0U].size()) << row;
        by_heads.emplace_back();
        for (std::size_t field = 0U; field < std::min(rows[row].size(), rows[0U].size()); ++field)
        {
            by_heads.back()[rows[0U][field]] = rows[row][field];
        }
    }
    return by_heads;
}

TEST_F(ResultsTest, RowsOfTheCsvFileHaveAFieldForEachHead)
{
    Verifies(req::SRS_CMG_340);
    const std::string plan =
        PlanFile("plan.yaml", "actuator",
                 "at: [540 ms]\ncycles: 50\nreach: 3 ms\nparts: [bus]\nkinds: [lost, pair_forged]\nsample: 20\n");
    static_cast<void>(Campaign({plan, "--csv", Path("rows.csv")}));
    const auto rows = RowsOf(cia306::ReadTextFile(Path("rows.csv")));
    EXPECT_EQ(rows.size(), 40U);
    // A reason with a comma is one field
    const auto listed =
        std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.at("class") == "listed"; });
    ASSERT_NE(listed, rows.end());
    EXPECT_EQ(listed->at("reason"), "open by a complete valid pair that nobody sent, or that is too old");
    EXPECT_EQ(listed->at("detector"), "nobody");
    EXPECT_EQ(listed->at("late"), "0");
}

TEST_F(ResultsTest, KnownPlaceIsAMemberAByteOrABitOfItAndNoPartOfAName)
{
    Verifies(req::SRS_CMG_046);
    // Given bit 5 of a byte of the comparator silent, and a plan that knows of a place
    const auto holds = [this](const std::string& place)
    {
        const Session session(PlanFile("plan.yaml", "actuator",
                                       "at: [500 ms]\nparts: [comparator]\nmembers: [comparator.verdict+8]\nphases: "
                                       "[permits]\nkinds: [flip]\nknown:\n  - {place: " +
                                           place + ", reason: march}\n"));
        Results results("", session.Identity(Shard{}));
        for (std::uint64_t index = 0U; index < 8U; ++index)
        {
            results.Put(index, Outcome{Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
        }
        results.Put(5U, Outcome{Class::kSilent, Detector::kNobody, 1U, 0U, 0U});
        return Summarise(session.Parts(), results).Holds();
    };
    // Then
    EXPECT_TRUE(holds("comparator.verdict+8.5"));
    EXPECT_TRUE(holds("comparator.verdict+8"));
    EXPECT_TRUE(holds("comparator.verdict"));
    EXPECT_FALSE(holds("comparator.verdict+8.4"));
    EXPECT_FALSE(holds("comparator.ver"));
    // A part is no place: it would answer for all of its members; nor is half of a byte's name
    EXPECT_THROW(holds("comparator"), runtime::YamlError);
    EXPECT_THROW(holds("comparator.verdict+"), runtime::YamlError);
}

TEST_F(ResultsTest, BitOfTheLatchThatSticksHasTheLimitOfTheTestOfMemory)
{
    Verifies(req::SRS_CMG_007);
    // Given a campaign of the latch of a device with a cycle of 1 ms and a diagnostic interval of 1 s
    const Session session(PlanFile("plan.yaml", "actuator",
                                   "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\n"
                                   "kinds: [flip, stuck_at_0, stuck_at_1, intermittent]\n"));
    const Limits& limits = session.Parts().limits;
    // Then a bit that changes is judged by that of a wrong channel: seen in its cycle
    EXPECT_EQ(limits.Of(Part::kLatch, FaultKind::kFlip), 8000U);
    EXPECT_EQ(limits.Of(Part::kLatch, FaultKind::kIntermittent), 8000U);
    // And one that sticks, maybe at what it is, by that of the memory test
    EXPECT_EQ(limits.Of(Part::kLatch, FaultKind::kStuckAt0), 1008000U);
    EXPECT_EQ(limits.Of(Part::kLatch, FaultKind::kStuckAt1), 1008000U);
    // And other parts have one limit for all kinds
    EXPECT_EQ(limits.Of(Part::kComparator, FaultKind::kFlip), limits.Of(Part::kComparator, FaultKind::kStuckAt0));
}

TEST_F(ResultsTest, WhereNothingWasFoundNoTimeIsTold)
{
    Verifies(req::SRS_CMG_010);
    // Given 8 faults that had no effect
    const Session session(
        PlanFile("plan.yaml", "actuator",
                 "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n"));
    Results results("", session.Identity(Shard{}));
    for (std::uint64_t index = 0U; index < 8U; ++index)
    {
        results.Put(index, Outcome{Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
    }
    const Summary summary = Summarise(session.Parts(), results);
    // Then the tables have no times, and the limit
    const std::string text = TextReport(session.Parts(), summary);
    EXPECT_NE(text.find("latch         flip                    -          -          -      8.000          0\n"),
              std::string::npos)
        << text;
    EXPECT_NE(HtmlReport(session.Parts(), summary)
                  .find("<td>flip</td><td>0</td><td>-</td><td>-</td><td>-</td><td>8.000</td><td>0</td>"),
              std::string::npos);
    // A time of 0 is one that was found at once
    results.Put(5U, Outcome{Class::kDetected, Detector::kLatch, 0U, 0U, 0U});
    const std::string found = TextReport(session.Parts(), Summarise(session.Parts(), results));
    EXPECT_NE(found.find("latch         flip                0.000      0.000      0.000      8.000          0\n"),
              std::string::npos)
        << found;
}

/// Two faults of each of 8 bits.
constexpr const char* kLatch =
    "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip, intermittent]\n";

/// What became of number 5 of eight flips, lines of the plan, and what the report of it says.
struct Reported
{
    Outcome fifth;
    std::string lines;
    int status;
    std::string told;
};

TEST_F(ResultsTest, ExitStatus1TellsEachOfFiveThingsByItself)
{
    Verifies(req::SRS_CMG_341);
    const Reported rows[] = {
        {{Class::kDetected, Detector::kLatch, 0U, 0U, 1000U}, "", 0, "verdict: holds"},
        {{Class::kSilent, Detector::kNobody, 1U, 0U, 2000U}, "", 1, "silent: experiment 5: latch+0.5"},
        {{Class::kExposed, Detector::kSelfTest, 0U, 0U, 2000U}, "", 1, "exposed: experiment 5: latch+0.5"},
        {{Class::kDetected, Detector::kLatch, 0U, kMarkLate, 1009000U}, "", 1, "late: experiment 5: latch+0.5"},
        {{Class::kOpen, Detector::kNobody, 0U, 0U, 0U}, "", 1, "verdict: does not hold"},
        {{Class::kDetected, Detector::kLatch, 0U, 0U, 1000U},
         "detectors: [clocks]\n",
         1,
         "idle: clocks found nothing"}};
    int number = 0;
    for (const Reported& row : rows)
    {
        // Given a file of outcomes, of which all but number 5 were detected in time
        const std::string plan = PlanFile(
            "plan.yaml", "actuator",
            "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip]\n" + row.lines);
        const std::string file = Path("results" + std::to_string(number));
        ++number;
        {
            const Session session(plan);
            Results results(file, session.Identity(Shard{}));
            for (std::uint64_t index = 0U; index < 8U; ++index)
            {
                results.Put(index, Outcome{Class::kDetected, Detector::kLatch, 0U, 0U, 1000U});
            }
            results.Put(5U, row.fifth);
        }
        // When it is reported, then the exit status and a line say what is so
        const tools::test::Answer answer = Campaign({"merge", plan, file});
        EXPECT_EQ(answer.status, row.status) << row.told << "\n" << answer.out << answer.err;
        EXPECT_NE(answer.out.find(row.told), std::string::npos) << row.told << "\n" << answer.out;
    }
}

TEST_F(ResultsTest, InjectedAreThoseThatWereTried)
{
    Verifies(req::SRS_CMG_010);
    Verifies(req::SRS_CMG_341);
    // Given the first of three shards of 8 flips and 8 intermittent faults: numbers 0, 3, 6 and 9, 12, 15
    const Session session(PlanFile("plan.yaml", "actuator", kLatch));
    ASSERT_EQ(session.Faults().Size(), 16U);
    Results shard("", session.Identity({1U, 3U}));
    ASSERT_EQ(shard.Size(), 6U);
    for (std::uint64_t index = 0U; index < 6U; ++index)
    {
        shard.Put(index, {Class::kDetected, Detector::kLatch, 0U, 0U, 1000U});
    }
    // When it is reported
    const Summary summary = Summarise(session.Parts(), shard);
    const auto report = nlohmann::json::parse(JsonText(session.Parts(), summary));
    // Then 3 of each kind were injected, and none of the shard is open
    EXPECT_EQ(report.at("strata").at(0).at("faults"), 8U);
    EXPECT_EQ(report.at("strata").at(0).at("injected"), 3U);
    EXPECT_EQ(report.at("strata").at(1).at("injected"), 3U);
    EXPECT_EQ(report.at("open"), 0U);
    EXPECT_NE(TextReport(session.Parts(), summary).find("latch         flip                    3          0"),
              std::string::npos)
        << TextReport(session.Parts(), summary);
    EXPECT_NE(HtmlReport(session.Parts(), summary).find("<td>3</td><td>0</td><td>0</td><td>8</td>"), std::string::npos);
    // When one of them was not tried, then it is not injected, but open
    Results some("", session.Identity({1U, 3U}));
    some.Put(0U, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
    const auto part = nlohmann::json::parse(JsonText(session.Parts(), Summarise(session.Parts(), some)));
    EXPECT_EQ(part.at("strata").at(0).at("injected"), 1U);
    EXPECT_EQ(part.at("strata").at(0).at("open"), 2U);
    EXPECT_EQ(part.at("open"), 5U);
}

TEST_F(ResultsTest, EachClassIsCountedAndTheBoundIsOfThoseThatHadAnEffect)
{
    Verifies(req::SRS_CMG_010);
    // Given a fault of each class, and two that were detected
    const Session session(PlanFile("plan.yaml", "actuator", kLatch));
    Results results("", session.Identity(Shard{}));
    const Outcome outcomes[] = {{Class::kMasked, Detector::kNobody, 0U, 0U, 0U},
                                {Class::kBenign, Detector::kNobody, 0U, 0U, 0U},
                                {Class::kDetected, Detector::kLatch, 0U, 0U, 1000U},
                                {Class::kDetected, Detector::kGuard, 0U, 0U, 3000U},
                                {Class::kSafeOther, Detector::kException, 0U, 0U, 2000U},
                                {Class::kListed, Detector::kNobody, 0U, 0U, 0U},
                                {Class::kSilent, Detector::kNobody, 1U, 0U, 0U},
                                {Class::kExposed, Detector::kSelfTest, 0U, 0U, 400000U}};
    std::uint64_t number = 0U;
    for (const Outcome& outcome : outcomes)
    {
        results.Put(number, outcome);
        ++number;
    }
    const Summary summary = Summarise(session.Parts(), results);
    // Then of the 5 that had an effect 1 is silent, whose share p is at most that of (1 - p)^5 + 5 p (1 - p)^4 = 1 %,
    // and the times are those of what was detected or safe by others
    const auto stratum = nlohmann::json::parse(JsonText(session.Parts(), summary)).at("strata").at(0);
    for (const auto& [key, count] : {std::pair("injected", 8U),
                                     {"masked", 1U},
                                     {"benign", 1U},
                                     {"effective", 5U},
                                     {"detected", 2U},
                                     {"safe_other", 1U},
                                     {"listed", 1U},
                                     {"exposed", 1U},
                                     {"silent", 1U},
                                     {"median_us", 2000U},
                                     {"p999_us", 3000U},
                                     {"worst_us", 3000U},
                                     {"limit_us", 8000U},
                                     {"least_limit_us", 8000U}})
    {
        EXPECT_EQ(stratum.at(key), count) << key;
    }
    EXPECT_NEAR(stratum.at("silent_at_most").get<double>(), 0.777928, 0.000005);
    EXPECT_EQ(stratum.at("found_by").dump(), "{\"exception\":1,\"guard\":1,\"latch\":1}");
    const std::string text = TextReport(session.Parts(), summary);
    for (const char* const row :
         {"latch         flip                    8          1          1          5          2          1          1"
          "          1          1  77.7928 %\n",
          "latch         flip                2.000      3.000      3.000      8.000          0\n",
          "found first by: guard 1 latch 1 exception 1\n"})
    {
        EXPECT_NE(text.find(row), std::string::npos) << row << text;
    }
    const std::string page = HtmlReport(session.Parts(), summary);
    EXPECT_NE(
        page.find("<td>latch</td><td>flip</td><td>5</td><td>1</td><td>77.7928 %</td><td>1</td><td>2</td><td>1</td>"
                  "<td>1</td><td>8</td><td>1</td><td>1</td><td>8</td>"),
        std::string::npos)
        << page;
}

TEST_F(ResultsTest, PartAndKindAreTwoWords)
{
    Verifies(req::SRS_CMG_010);
    const tools::test::Answer answer =
        Campaign({PlanFile("plan.yaml", "actuator", "at: [500 ms]\nparts: [both_channels]\nsample: 1\n")});
    EXPECT_NE(answer.out.find("both_channels flip "), std::string::npos) << answer.out;
}

/// A plan in a folder of its own, with a copy of all that it reads.
class OutputTest : public CampaignTest
{
  protected:
    OutputTest()
    {
        for (const char* const folder : {"campaigns", "emergency_stop"})
        {
            std::filesystem::copy(std::string(COUNTERPOINT_SOURCE_FOLDER "/examples/") + folder, Path(folder),
                                  std::filesystem::copy_options::recursive);
        }
        plan_ = File("campaigns/plan.yaml",
                     std::string("title: A test\nscenario: at_work.yaml\ndevice: actuator\n") + kLatch);
        tried_ = Campaign({plan_, "--jobs", "1", "--out", Path("results")});
    }
    std::string plan_;
    tools::test::Answer tried_;
};

TEST_F(OutputTest, IsNoFileThatTheRunReadsOrWritesBesides)
{
    Verifies(req::SRS_CMG_049);
    ASSERT_EQ(tried_.status, 0) << tried_.err << tried_.out;
    // Given the plan, its results, its scenario, what that extends, and a DCF
    for (const std::string& file : {plan_, Path("results"), Path("campaigns/at_work.yaml"),
                                    Path("emergency_stop/chain.yaml"), Path("emergency_stop/sensor.dcf")})
    {
        const std::string before = cia306::ReadTextFile(file);
        // When it is to be the output of a campaign, a merge or a replay
        for (const std::vector<std::string>& order :
             {std::vector<std::string>{plan_, "--out", Path("results"), "--csv"},
              {plan_, "--out", Path("results"), "--json"},
              {plan_, "--out", Path("results"), "--html"},
              {"merge", plan_, Path("results"), "--json"}})
        {
            std::vector<std::string> arguments = order;
            arguments.push_back(file);
            const tools::test::Answer answer = Campaign(arguments);
            // Then it is refused, and is as it was
            EXPECT_EQ(answer.status, 2) << file;
            EXPECT_NE(answer.err.find(order.back() + ": error: "), std::string::npos) << answer.err;
            EXPECT_NE(answer.err.find("expected a file of its own for each output"), std::string::npos) << answer.err;
            EXPECT_TRUE(answer.out.empty()) << answer.out;
            EXPECT_EQ(cia306::ReadTextFile(file), before) << file;
        }
    }
    EXPECT_EQ(Campaign({plan_, "--replay", "1", "--html", Path("emergency_stop/sensor.dcf")}).status, 2);
    EXPECT_EQ(Campaign({plan_, "--csv", Path("same"), "--json", Path("same")}).status, 2);
    // And any other one is written
    EXPECT_EQ(Campaign({plan_, "--out", Path("results"), "--csv", Path("rows.csv"), "--json", Path("all.json")}).status,
              0);
    EXPECT_TRUE(std::filesystem::exists(Path("rows.csv")));
}

TEST_F(OutputTest, OptionsWithoutAnEffectAreRefused)
{
    Verifies(req::SRS_CMG_048);
    for (const auto& [option, value] : {std::pair("--out", Path("new")),
                                        {"--csv", Path("new")},
                                        {"--json", Path("new")},
                                        {"--shard", "2/3"},
                                        {"--jobs", "2"}})
    {
        const tools::test::Answer answer = Campaign({plan_, "--replay", "1", option, value});
        EXPECT_EQ(answer.status, 2) << option;
        EXPECT_NE(answer.err.find(option), std::string::npos) << answer.err;
        EXPECT_FALSE(std::filesystem::exists(Path("new"))) << option;
    }
    for (const auto& [option, value] : {std::pair("--replay", "1"), {"--shard", "2/3"}, {"--jobs", "2"}})
    {
        const tools::test::Answer answer =
            Campaign({"merge", plan_, Path("results"), option, value, "--html", Path("new")});
        EXPECT_EQ(answer.status, 2) << option;
        EXPECT_NE(answer.err.find(std::string(option) + ": error: beside merge"), std::string::npos) << answer.err;
        EXPECT_FALSE(std::filesystem::exists(Path("new"))) << option;
    }
    // And the program beside the command is told of a replay alone
    const std::string line = std::string(COUNTERPOINT_PROGRAM) + " campaign " + plan_ + " --replay 1 > " + Path("text");
    EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 0);
    EXPECT_NE(cia306::ReadTextFile(Path("text")).find("outcome: "), std::string::npos);
}
} // namespace
} // namespace counterpoint::campaign::test
