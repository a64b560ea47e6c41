// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a file of results belongs to, what may stand in it, and what becomes of one that somebody else cuts.
#include "verification/campaign/campaign_rig.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "verification/campaign/crew.hpp"
#include "verification/campaign/managed/report.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

namespace counterpoint::campaign::test
{
namespace
{
constexpr const char* kLatch =
    "at: [500 ms]\nparts: [latch]\nmembers: [latch+0]\nphases: [permits]\nkinds: [flip, intermittent]\n";
constexpr const char* kActuator = "emergency_stop/actuator.dcf";
constexpr const char* kOther = ": error: results of another device: its scenario, a DCF or its limits are others, "
                               "expected results of the scenario and the DCFs of this plan as they are now\n";

/// A folder with a copy of all that a plan reads.
class KeptTest : public CampaignTest
{
  protected:
    KeptTest()
    {
        for (const char* const folder : {"campaigns", "emergency_stop", "networks"})
        {
            std::filesystem::copy(std::string(COUNTERPOINT_SOURCE_FOLDER "/examples/") + folder, Path(folder),
                                  std::filesystem::copy_options::recursive);
        }
        plan_ = File("campaigns/plan.yaml",
                     std::string("title: A test\nscenario: at_work.yaml\ndevice: actuator\n") + kLatch);
    }
    /// Puts `to` in place of `from` behind `mark` in a file.
    void Change(const std::string& name, const std::string& mark, const std::string& from, const std::string& to) const
    {
        std::string text = cia306::ReadTextFile(Path(name));
        const std::size_t place = text.find(from, text.find(mark));
        ASSERT_NE(place, std::string::npos) << name;
        static_cast<void>(File(name, text.replace(place, from.size(), to)));
    }
    /// Gives a DCF the signatures of what it has now.
    void Sign(const std::string& name) const
    {
        const std::string line =
            std::string(COUNTERPOINT_PROGRAM) + " sign " + Path(name) + " --write " + Path("signed") + " > /dev/null";
        ASSERT_EQ(std::system(line.c_str()), 0) << name;
        std::filesystem::rename(Path("signed"), Path(name));
    }
    /// That `change` makes the results of this plan those of another device, for one that goes on and for one that
    /// joins.
    void ExpectRefused(const std::string& plan, const std::string& what, const std::function<void()>& change) const
    {
        const std::string first = Path("first");
        const std::string second = Path("second");
        std::filesystem::remove(first);
        std::filesystem::remove(second);
        EXPECT_EQ(Campaign({plan, "--jobs", "1", "--shard", "1/2", "--out", first}).status, 0) << what;
        const std::string before = cia306::ReadTextFile(first);
        change();
        static_cast<void>(Campaign({plan, "--jobs", "1", "--shard", "2/2", "--out", second}));
        for (const std::vector<std::string>& order :
             {std::vector<std::string>{plan, "--jobs", "1", "--shard", "1/2", "--out", first},
              {"merge", plan, second, first}})
        {
            const tools::test::Answer answer = Campaign(order);
            EXPECT_EQ(answer.status, 2) << what << answer.out;
            EXPECT_EQ(answer.err, first + kOther) << what;
        }
        EXPECT_EQ(cia306::ReadTextFile(first), before) << what;
    }

    std::string plan_;
};

TEST_F(KeptTest, ResultsBelongToTheBytesOfScenarioAndDcfs)
{
    Verifies(req::SRS_CMG_800);
    Verifies(req::SRS_CMG_801);
    // Given results of a device that then has another diagnostic interval, SCT, safe value, late detection,
    const std::pair<const char*, std::pair<const char*, const char*>> changes[] = {
        {"[5F00sub4]", {"ParameterValue=1000", "ParameterValue=1300"}},
        {"[1301sub2]", {"ParameterValue=50", "ParameterValue=60"}},
        {"[5F02sub1]", {"ParameterValue=0x0000000000000000", "ParameterValue=0x0000000000000001"}},
        {"[5F05sub1]", {"ParameterValue=0x00", "ParameterValue=0x3C"}}};
    for (const auto& [mark, change] : changes)
    {
        const auto& [from, to] = change;
        ExpectRefused(plan_, mark,
                      [this, mark = mark, from = from, to = to]()
                      {
                          Change(kActuator, mark, from, to);
                          Sign(kActuator);
                      });
    }
    // a word of another device of the chain, or of a scenario that this one extends
    ExpectRefused(plan_, "other DCF", [this]() { Change("emergency_stop/sensor.dcf", "", "[", "; changed\n["); });
    ExpectRefused(plan_, "extended scenario",
                  [this]() { Change("emergency_stop/chain.yaml", "", "title: ", "# changed\ntitle: "); });
}

TEST_F(KeptTest, WhereFilesLieDoesNotMatter)
{
    Verifies(req::SRS_CMG_800);
    const std::uint64_t here = Session(plan_).Identity(Shard{}).setting;
    std::filesystem::create_directory(Path("elsewhere"));
    for (const char* const folder : {"campaigns", "emergency_stop"})
    {
        std::filesystem::rename(Path(folder), Path(std::string("elsewhere/") + folder));
    }
    EXPECT_EQ(Session(Path("elsewhere/campaigns/plan.yaml")).Identity(Shard{}).setting, here);
    // But which of two files has which bytes does, and where one ends
    EXPECT_NE(WithFiles(kNoDigest, {File("1", "ab"), File("2", "c")}),
              WithFiles(kNoDigest, {File("3", "a"), File("4", "bc")}));
}

TEST_F(KeptTest, ResultsOfANetworkBelongToTheFilesThatItsNetworkFileNames)
{
    Verifies(req::SRS_CMG_800);
    Verifies(req::SRS_CMG_805);
    const std::string plan =
        File("campaigns/network_plan.yaml", "title: A test\nnetwork: managed.yaml\nuntil: 60 ms\nparts: [sdo]\nkinds: "
                                            "[lost]\nsample: 6\n");
    ExpectRefused(plan, "network", [this]() { Change("networks/chain.yaml", "", "\n", "\n# changed\n"); });
    ExpectRefused(plan, "DCF", [this]() { Change("emergency_stop/sensor.dcf", "", "[", "; changed\n["); });
    // And none of them is an output: this DCF is named by the network file alone
    const std::string dcf = Path("networks/alone.dcf");
    std::filesystem::copy_file(Path("emergency_stop/sensor.dcf"), dcf);
    Change("networks/chain.yaml", "", "../emergency_stop/sensor.dcf", "alone.dcf");
    const std::string before = cia306::ReadTextFile(dcf);
    const tools::test::Answer answer = Campaign({plan, "--jobs", "1", "--json", dcf});
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.err.find("expected a file of its own for each output"), std::string::npos) << answer.err;
    EXPECT_EQ(cia306::ReadTextFile(dcf), before);
}

TEST_F(KeptTest, WhatResultsBelongToIsSaid)
{
    Verifies(req::SRS_CMG_801);
    const ResultsOf of{1U, 8U, {2U, 2U}, 3U, 4U, nullptr};
    static_cast<void>(Results(Path("results"), of));
    const auto said = [this](const ResultsOf& other)
    {
        try
        {
            static_cast<void>(Results(Path("results"), other));
        }
        catch (const runtime::YamlError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string head = Path("results") + ": error: ";
    EXPECT_EQ(said(of), "");
    EXPECT_EQ(said({9U, 8U, {2U, 2U}, 3U, 4U, nullptr}),
              head + "results of another plan, expected results of the text of this plan");
    EXPECT_EQ(said({1U, 8U, {2U, 2U}, 9U, 4U, nullptr}) + "\n", Path("results") + kOther);
    EXPECT_EQ(said({1U, 8U, {2U, 2U}, 9U, 9U, nullptr}),
              head +
                  "results of another program, expected results of this program, by its version, commit and objects");
    EXPECT_EQ(said({1U, 8U, {1U, 2U}, 3U, 4U, nullptr}), head + "results of shard 2/2, expected those of shard 1/2");
    EXPECT_EQ(said({1U, 9U, {2U, 2U}, 3U, 4U, nullptr}),
              head + "results of a campaign of 8 experiments, expected one of 9");
    // Those of an earlier program, whose format was another one
    static_cast<void>(File("results", "CPCAMP3" + std::string(57U, '\0')));
    EXPECT_EQ(said(of), head + "results of format 3, of an earlier program, expected results of format 4: they are to "
                               "be made anew, in another file");
}

/// What of an outcome a file may not have, and how it is told.
struct Unknown
{
    Outcome outcome;
    std::string told;
};

TEST_F(KeptTest, OutcomesThatNoCampaignWritesAreRefusedByTheirRow)
{
    Verifies(req::SRS_CMG_802);
    const auto detector = [](const unsigned number) { return static_cast<Detector>(number); };
    const Unknown rows[] = {
        {{Class::kDetected, detector(31U), 0U, 0U, 1000U}, "detector 31, expected 0 to 16"},
        {{Class::kSilent, Detector::kNobody, 7U, 0U, 1000U}, "reason 7, expected 0 to 6"},
        {{Class::kDetected, Detector::kChannels, 200U, 0U, 1000U}, "reason 200, expected a cause of an SRDO"},
        {{Class::kDetected, Detector::kGuard, 200U, 0U, 1000U}, "reason 200, expected a device fault"},
        {{Class::kDetected, Detector::kGuard, 3U, 16U, 1000U}, "marks 16, expected bits 0 to 3 alone"},
        {{Class::kExposed, Detector::kGuard, 3U, 32U, 1000U}, "marks 32, expected bits 0 to 4 alone"},
        {{Class::kOpen, Detector::kGuard, 3U, 0U, 1000U},
         "a fault that was not tried and has an outcome, expected none"}};
    const ResultsOf of = Session(plan_).Identity({2U, 2U});
    for (const Unknown& row : rows)
    {
        // Given a file whose checks are right, of which row 3 is one that no report knows
        const std::string file = Path("results");
        std::filesystem::remove(file);
        Results(file, of).Put(2U, row.outcome);
        // When it is gone on with or joined, then file, row and what was expected are said
        const std::string told = file + ": error: row 3, experiment 5: " + row.told + "\n";
        for (const std::vector<std::string>& order :
             {std::vector<std::string>{plan_, "--jobs", "1", "--shard", "2/2", "--out", file}, {"merge", plan_, file}})
        {
            const tools::test::Answer answer = Campaign(order);
            EXPECT_EQ(answer.status, 2) << row.told;
            EXPECT_EQ(answer.err, told);
        }
    }
    // And so of a network
    EXPECT_EQ(managed::StrangeIn({Class::kDetected, detector(12U), 0U, 0U, 0U}).wrong, "detector 12");
    EXPECT_EQ(managed::StrangeIn({Class::kSilent, Detector::kNobody, 12U, 0U, 0U}).wrong, "reason 12");
    EXPECT_EQ(managed::StrangeIn({Class::kListed, Detector::kNobody, 7U, 0U, 0U}).expected, "0 to 6");
    EXPECT_EQ(managed::StrangeIn({Class::kListed, Detector::kNobody, 6U, 0U, 0U}).wrong, "");
}

TEST_F(KeptTest, EveryOutcomeThatACampaignWritesIsGoneOnWithAndJoined)
{
    Verifies(req::SRS_CMG_820);
    const ResultsOf of = Session(plan_).Identity({2U, 2U});
    // Given a file with a row of each kind, old values that were sent among them
    const Outcome rows[] = {{Class::kExposed, Detector::kGuard, 3U, kMarkOldPair, 1000U},
                            {Class::kExposed, Detector::kGuard, 3U, kMarkOldPair | kMarkLate, 1000U},
                            {Class::kDetected, Detector::kChannels, 1U, kMarkSaidByA | kMarkSaidByB, 1000U},
                            {Class::kDetected, Detector::kGuard, 3U, kMarkLatent, 1000U},
                            {Class::kSilent, Detector::kNobody, 6U, 0U, 1000U}};
    for (const Outcome& row : rows)
    {
        const std::string file = Path("results");
        std::filesystem::remove(file);
        Results(file, of).Put(2U, row);
        // When the campaign goes on with it, then it is taken
        const tools::test::Answer on = Campaign({plan_, "--jobs", "1", "--shard", "2/2", "--out", file});
        EXPECT_NE(on.status, 2) << on.err;
        // And the rows that it wrote are joined with those of the other half
        const std::string other = Path("other");
        std::filesystem::remove(other);
        EXPECT_NE(Campaign({plan_, "--jobs", "1", "--shard", "1/2", "--out", other}).status, 2);
        const tools::test::Answer joined = Campaign({"merge", plan_, other, file});
        EXPECT_NE(joined.status, 2) << joined.err;
    }
}

TEST_F(KeptTest, FileOfResultsThatIsCutEndsTheCampaignWithItsName)
{
    Verifies(req::SRS_CMG_803);
    const std::string wrong = ": error: it was cut or overwritten by somebody else while outcomes were written, "
                              "expected a file that this campaign alone writes; ";
    const auto said = [](const std::function<void()>& look)
    {
        try
        {
            look();
        }
        catch (const runtime::YamlError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string file = Path("results");
    for (const std::uintmax_t length : {0U, 20U, 50U, 79U})
    {
        // Given a file of four outcomes of which somebody cuts the end
        std::filesystem::remove(file);
        Results results(file, {1U, 4U, {}});
        results.Put(0U, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
        EXPECT_EQ(said([&results]() { results.RequireKept(); }), "");
        std::filesystem::resize_file(file, length);
        // Then that is told, and what was tried is known
        EXPECT_EQ(said([&results]() { results.RequireThere(); }), file + wrong + "what was in it is lost") << length;
        EXPECT_EQ(results.At(0U).result, Class::kMasked);
        // Also where outcomes that are written behind the cut make it as long as it was
        results.Put(3U, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
        EXPECT_EQ(said([&results]() { results.RequireKept(); }).find(file + wrong),
                  (length == 79U) ? std::string::npos : 0U)
            << length;
    }
}

TEST_F(KeptTest, CampaignWhoseFileIsCutEndsWithStatus2)
{
    Verifies(req::SRS_CMG_803);
    // Given a campaign of a device and one of a network that are at work
    Session session(plan_);
    Results results(Path("results"), session.Identity(Shard{}));
    Crew crew(session.Runs(), session.Faults(), results, 1U);
    // When somebody cuts the file, then the campaign ends, and no outcome is one by that
    const auto work = [this, &crew]()
    { crew.Work([this](std::uint64_t /*done*/) { std::filesystem::resize_file(Path("results"), 10U); }); };
    EXPECT_THROW(
        {
            work();
            results.RequireKept();
        },
        runtime::YamlError);
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        EXPECT_NE(results.At(index).detector, Detector::kException) << index;
    }
}

TEST_F(KeptTest, RowsAndSurvivorsAreWrittenOneByOne)
{
    Verifies(req::SRS_CMG_804);
    // Given a campaign in which nothing was found
    Session session(File("campaigns/many.yaml",
                         "title: A test\nscenario: at_work.yaml\ndevice: actuator\nat: [500 ms]\n"
                         "parts: [channel_a]\nkinds: [flip]\nsample: 3000\n"));
    ASSERT_EQ(session.Faults().Size(), 3000U);
    Results results("", session.Identity(Shard{}));
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        results.Put(index, {Class::kSilent, Detector::kNobody, 1U, 0U, 1000U});
    }
    const Summary summary = Summarise(session.Parts(), results);
    std::size_t pieces = 0U;
    std::size_t longest = 0U;
    std::string text;
    const auto take = [&](const std::string_view piece)
    {
        ++pieces;
        longest = std::max(longest, piece.size());
        text += piece;
    };
    // Then no piece of a file has more than one of them
    CsvReport(session.Parts(), results, take);
    EXPECT_EQ(pieces, 3001U);
    EXPECT_LT(longest, 200U);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3001);
    text.clear();
    pieces = 0U;
    JsonReport(session.Parts(), summary, take);
    EXPECT_GT(pieces, 3000U);
    EXPECT_LT(longest, 100000U); // All but the survivors: no more for more experiments.
    // And together they are one document, indented as such
    const auto report = nlohmann::ordered_json::parse(text);
    EXPECT_EQ(report.at("survivors").size(), 3000U);
    EXPECT_EQ(report.dump(2) + "\n", text);
    // Also where there is none
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        results.Put(index, {Class::kMasked, Detector::kNobody, 0U, 0U, 0U});
    }
    const std::string none = JsonText(session.Parts(), Summarise(session.Parts(), results));
    EXPECT_EQ(nlohmann::ordered_json::parse(none).dump(2) + "\n", none);
}
} // namespace
} // namespace counterpoint::campaign::test
