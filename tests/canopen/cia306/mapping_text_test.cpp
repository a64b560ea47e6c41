// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/mapping_text.hpp"

#include "verification/trace/ids/new_device.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
const std::string kForm = ", expected [NAME=][COUNTx]LENGTH such as 2x8, i16 or Speed=32, or INDEX:SUB of an object of "
                          "the file, such as 0x6004:00";

/// What is wrong with a mapping; empty: nothing.
std::string ProblemOf(const std::string& text)
{
    const Problem problem = ParseMapping(text).problem;
    return problem.wrong.empty() ? "" : problem.wrong + ", expected " + problem.expected;
}

/// "NAME:TYPE" of each pair.
std::vector<std::string> PairsOf(const std::string& text)
{
    std::vector<std::string> pairs;
    for (const PlannedPair& pair : ParseMapping(text).pairs)
    {
        pairs.push_back(pair.name + ":" + std::to_string(pair.data_type));
    }
    return pairs;
}

using Lines = std::vector<std::string>;

TEST(MappingText, NewObjectsOfAllLengths)
{
    Verifies(req::SRS_NEW_003);
    // The types of CiA 301: UNSIGNED8 is 5, INTEGER16 is 3
    EXPECT_EQ(PairsOf("8"), (Lines{":5"}));
    EXPECT_EQ(PairsOf("u8,i16"), (Lines{":5", ":3"}));
    EXPECT_EQ(PairsOf(" 2x8 , Speed = i32 "), (Lines{":5", ":5", "Speed:4"}));
    EXPECT_EQ(PairsOf("A b-c_1=2x16"), (Lines{"A b-c_1 1:6", "A b-c_1 2:6"}));
    EXPECT_EQ(PairsOf("24"), (Lines{":22"}));
    EXPECT_EQ(PairsOf("64"), (Lines{":27"}));
    EXPECT_EQ(PairsOf("i64"), (Lines{":21"}));
}

TEST(MappingText, ObjectsOfTheFile)
{
    Verifies(req::SRS_NEW_003);
    const MappingText one = ParseMapping("0x6004:01,0x2000:0A/0x2100:FE");
    ASSERT_EQ(one.pairs.size(), 2U);
    EXPECT_EQ(one.pairs[0].normal->index, 0x6004U);
    EXPECT_EQ(one.pairs[0].normal->sub, 1U);
    EXPECT_FALSE(one.pairs[0].inverse);
    EXPECT_EQ(one.pairs[1].normal->sub, 0x0AU);
    EXPECT_EQ(one.pairs[1].inverse->index, 0x2100U);
    EXPECT_EQ(one.pairs[1].inverse->sub, 0xFEU);
}

TEST(MappingText, WhatIsNoneIsRefusedWithWhatWasExpected)
{
    Verifies(req::SRS_NEW_003);
    for (const std::string text : {"",
                                   "9",
                                   "i9",
                                   "0x8",
                                   "9x8",
                                   "x8",
                                   "2x",
                                   "u",
                                   "=8",
                                   "S\xC3\xA4=8",
                                   "Speed:8",
                                   "6004:01",
                                   "0x6004:FF",
                                   "0x6004:",
                                   "0x10000:01",
                                   "0x6004:01/",
                                   "0x6004:01/2100:01",
                                   "a/0x2100:01:00",
                                   "66",
                                   "ab+c=8",
                                   "a{=8"})
    {
        const std::string shown = (text == "S\xC3\xA4=8") ? "'S\\xC3\\xA4=8'" : "'" + text + "'";
        EXPECT_EQ(ProblemOf(text), shown + kForm) << text;
    }
    EXPECT_EQ(ProblemOf(std::string(61U, 'n') + "=8").empty(), false);
    EXPECT_EQ(ProblemOf(std::string(60U, 'n') + "=8"), "");
    EXPECT_EQ(ProblemOf("8,"), "''" + kForm);
}

TEST(MappingText, MoreThanOneFrameCarriesIsRefused)
{
    Verifies(req::SRS_NEW_003);
    EXPECT_EQ(ProblemOf("8x8"), "");
    EXPECT_EQ(ProblemOf("8x8,8"), "'8x8,8' has 72 bits in 9 objects, expected at most 64 bits");
    std::string many = "0x6000:01";
    for (int i = 1; i < 64; ++i)
    {
        many += ",0x6000:01";
    }
    EXPECT_EQ(ProblemOf(many), "");
    const std::string problem = ProblemOf(many + ",0x6000:01");
    EXPECT_NE(problem.find(" has 0 bits in 65 objects, expected at most 64 bits"), std::string::npos) << problem;
}

TEST(MappingText, ACobIdMayFollow)
{
    Verifies(req::SRS_NEW_004);
    EXPECT_FALSE(ParseMapping("8").cob_id);
    EXPECT_EQ(ParseMapping("8@0x101").cob_id, 0x101U);
    EXPECT_EQ(ParseMapping("8 @ node64").cob_id, 0x17FU);
    EXPECT_EQ(ProblemOf("8@0x102"), "COB-ID '0x102', expected an odd one from 0x101 to 0x17F, or node1 to node64");
    EXPECT_EQ(ParseCobId("0x17F"), 0x17FU);
    EXPECT_EQ(ParseCobId("node1"), 0x101U);
    for (const std::string text : {"0xFF", "0x180", "0x181", "node0", "node65", "nodex", "x", ""})
    {
        EXPECT_FALSE(ParseCobId(text)) << text;
    }
}

TEST(MappingText, DefaultsAreThoseOfThePreDefinedConnectionSet)
{
    Verifies(req::SRS_NEW_004);
    EXPECT_EQ(DefaultCobId(1U, true, 1U), 0x101U);
    EXPECT_EQ(DefaultCobId(1U, true, 32U), 0x13FU);
    EXPECT_FALSE(DefaultCobId(1U, true, 33U));
    EXPECT_FALSE(DefaultCobId(1U, false, 32U));
    EXPECT_EQ(DefaultCobId(1U, false, 33U), 0x141U);
    EXPECT_EQ(DefaultCobId(1U, false, 64U), 0x17FU);
    EXPECT_FALSE(DefaultCobId(1U, false, 65U));
    EXPECT_FALSE(DefaultCobId(2U, true, 1U));
    EXPECT_FALSE(DefaultCobId(1U, true, 0U));
}
} // namespace
} // namespace counterpoint::cia306
