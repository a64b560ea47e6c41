// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a campaign writes: the file of results, and the rows of the CSV file.
#include "verification/campaign/campaign_rig.hpp"

#include <algorithm>
#include <map>

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
    ASSERT_EQ(whole.size(), 64U);
    // When any bit of it is wrong, then it is neither gone on with nor joined
    Results all("", {of.digest, of.total, {1U, 1U}});
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
    Verifies(req::SRS_CMG_010);
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
} // namespace
} // namespace counterpoint::campaign::test
