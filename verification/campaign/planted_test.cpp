// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The programs with a defect: which there are, and that what ships knows nothing of them. What the campaign says of
// each is in campaign_test.cpp.
#include "canopen/cia306/text/text_file.hpp"
#include "verification/trace/ids/campaign.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

namespace counterpoint::campaign::test
{
namespace
{
const std::string kRoot = COUNTERPOINT_SOURCE_FOLDER "/";

nlohmann::json Table(const std::string& name)
{
    return nlohmann::json::parse(cia306::ReadTextFile(kRoot + "verification/campaign/planted/" + name));
}

std::size_t CountOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0U;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    {
        ++count;
    }
    return count;
}

TEST(Planted, EachListedDefectIsAProgram)
{
    Verifies(req::SRS_CMG_040);
    std::set<std::string> programs;
    const nlohmann::json table = Table("expected.json");
    for (const auto& row : table.at("defects"))
    {
        programs.insert(row.at("program").get<std::string>());
    }
    for (const char* const name :
         {"comparator_ignores_byte_0", "comparator_ignores_byte_1", "flow_monitor_off", "flow_monitor_without_order",
          "srvt_check_gone_in_b", "permit_not_tied_to_the_challenge", "used_unprotected", "output_held"})
    {
        EXPECT_EQ(programs.count(name), 1U) << name;
        EXPECT_TRUE(std::filesystem::exists(COUNTERPOINT_PLANTED "/counterpoint_campaign_" + std::string(name)));
    }
}

TEST(Planted, EachDefectOfStateLinkManagerAndSlaveIsAProgramThatIsExpectedToBeFound)
{
    Verifies(req::SRS_CMG_344);
    Verifies(req::SRS_CMG_077);
    Verifies(req::SRS_CMG_083);
    std::map<std::string, std::string> programs;
    const nlohmann::json table = Table("expected.json");
    for (const auto& row : table.at("defects"))
    {
        programs[row.at("program").get<std::string>()] = row.at("plan").get<std::string>();
    }
    for (const auto& [name, plan] : {std::pair("stop_not_taken", "stop.yaml"),
                                     {"gfc_not_taken", "gfc.yaml"},
                                     {"nmt_of_one", "nmt.yaml"},
                                     {"link_age_not_checked", "link_age.yaml"},
                                     {"signatures_not_compared", "managed_signatures.yaml"},
                                     {"gate_stays_open", "managed_restart.yaml"},
                                     {"start_of_all", "managed_restart.yaml"},
                                     {"signature_of_a_slave_not_checked", "managed_written.yaml"}})
    {
        EXPECT_EQ(programs[name], plan) << name;
        EXPECT_TRUE(std::filesystem::exists(COUNTERPOINT_PLANTED "/counterpoint_campaign_" + std::string(name)));
    }
}

TEST(Planted, WhatShipsHasNoSwitchForAnyOfThem)
{
    Verifies(req::SRS_CMG_040);
    std::size_t defects = 0U;
    const nlohmann::json table = Table("defects.json");
    for (const auto& defect : table.at("mutants"))
    {
        const std::string name = defect.at("name");
        const std::string shipped = cia306::ReadTextFile(kRoot + defect.at("file").get<std::string>());
        const std::string find = defect.at("find");
        const std::string replace = defect.at("replace");
        // The one text that is replaced is there, what replaces it is not, and nothing is left to the preprocessor
        EXPECT_EQ(CountOf(shipped, find), defect.at("count").get<std::size_t>()) << name;
        if (find.find(replace) == std::string::npos) // Nothing is only left out.
        {
            EXPECT_EQ(CountOf(shipped, replace), 0U) << name;
        }
        EXPECT_EQ(CountOf(shipped, "\n#if"), 0U) << name;
        EXPECT_EQ(CountOf(shipped, name), 0U) << name;
        ++defects;
    }
    EXPECT_GE(defects, 7U);
    EXPECT_EQ(CountOf(cia306::ReadTextFile(kRoot + "verification/campaign/pins_output.cpp"), "used_unprotected"), 0U);
}
} // namespace
} // namespace counterpoint::campaign::test
