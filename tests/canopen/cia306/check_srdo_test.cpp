// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{

using Lines = std::vector<std::string>;
using test::CheckRow;
using test::Set;

constexpr const char* kValue = "ParameterValue";

TEST(CheckSrdo, TheExamplesHaveNoFinding)
{
    Verifies(req::SRS_CLI_019);
    for (const char* name : {"sensor", "controller", "actuator"})
    {
        EXPECT_EQ(test::FindingsOf(test::ExampleText(name), {}), std::vector<std::string>{}) << name;
    }
}

TEST(CheckSrdo, DirectionTypeAndNumberOfParameters)
{
    Verifies(req::SRS_CLI_010);
    const std::vector<CheckRow> rows = {
        {{{"1302sub1", kValue, "3"}},
         {"error: 0x1302:01: direction 3, expected 0 (off), 1 (producer) or 2 (consumer)"}},
        {{{"1302sub4", kValue, "253"}}, {"error: 0x1302:04: transmission type 253, expected 254"}},
        {{{"1302sub4", kValue, "0"}}, {"error: 0x1302:04: transmission type 0, expected 254"}},
        {{{"1302sub4", kValue, "255"}},
         {"error: 0x1302:04: transmission type 255, expected 254; devices with 255 exist, this kernel refuses it"}},
        {{{"1302sub4", kValue, "0xFE"}}, {}},
        {{{"1302sub0", kValue, "5"}}, {"error: 0x1302:00: highest sub-index 5, expected 6"}},
        {{{"1302sub0", kValue, "7"}}, {"error: 0x1302:00: highest sub-index 7, expected 6"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, CobIds)
{
    Verifies(req::SRS_CLI_010);
    const std::vector<CheckRow> rows = {
        {{{"1302sub5", kValue, "0x80000103"}},
         {"error: 0x1302:05: COB-ID 0x80000103 has reserved bits set, expected bits 11 to 31 to be 0"}},
        {{{"1302sub6", kValue, "0x904"}},
         {"error: 0x1302:06: COB-ID 0x904 has reserved bits set, expected bits 11 to 31 to be 0"}},
        {{{"1302sub5", kValue, "0x0FF"}, {"1302sub6", kValue, "0x100"}},
         {"error: 0x1302:05: COB-ID 0x0FF, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x100, expected a COB-ID from 0x101 to 0x180"}},
        {{{"1302sub5", kValue, "0x17F"}, {"1302sub6", kValue, "0x180"}}, {}},
        {{{"1302sub5", kValue, "0x181"}, {"1302sub6", kValue, "0x182"}},
         {"error: 0x1302:05: COB-ID 0x181, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x182, expected a COB-ID from 0x101 to 0x180"}},
        {{{"1302sub5", kValue, "0x104"}, {"1302sub6", kValue, "0x105"}},
         {"error: 0x1302:05: COB-ID 0x104 is even, expected an odd one for normal data",
          "error: 0x1302:06: COB-ID 0x105 is odd, expected an even one for inverse data"}},
        {{{"1302sub6", kValue, "0x106"}}, {"error: 0x1302:06: COB-ID 2 0x106, expected 0x104 (COB-ID 1 + 1)"}},
        {{{"1302sub5", kValue, "0x105"}}, {"error: 0x1302:06: COB-ID 2 0x104, expected 0x106 (COB-ID 1 + 1)"}},
        {{{"1302sub5", kValue, "0x105"}, {"1302sub6", kValue, "0x106"}}, {}},
        {{{"1302sub5", kValue, "0"}, {"1302sub6", kValue, "0"}},
         {"error: 0x1302:05: COB-ID 0x000, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x000, expected a COB-ID from 0x101 to 0x180"}},
        {{{"1302sub5", kValue, "0"}, {"1302sub6", kValue, "0"}, {"1302sub1", kValue, "0"}}, {}},
        {{{"1302sub5", kValue, "0x90"}, {"1302sub6", kValue, "0x91"}, {"1302sub1", kValue, "0"}},
         {"error: 0x1302:05: COB-ID 0x090, expected a COB-ID from 0x101 to 0x180",
          "error: 0x1302:06: COB-ID 0x091, expected a COB-ID from 0x101 to 0x180"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, IdentifiersInUse)
{
    Verifies(req::SRS_CLI_010);
    const std::vector<CheckRow> rows = {
        {{{"1302sub5", kValue, "0x101"}, {"1302sub6", kValue, "0x102"}},
         {"error: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, expected an identifier of its own",
          "error: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, expected an identifier of its own"}},
        {{{"1302sub6", kValue, "0x102"}},
         {"error: 0x1302:06: COB-ID 2 0x102, expected 0x104 (COB-ID 1 + 1)",
          "error: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, expected an identifier of its own"}},
        {{{"1302sub5", kValue, "0x101"}, {"1302sub6", kValue, "0x102"}, {"1302sub1", kValue, "0"}},
         {"warning: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, one is off, expected an identifier of its own",
          "warning: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, one is off, expected an identifier of its own"}},
        {{{"1302sub5", kValue, "0x101"},
          {"1302sub6", kValue, "0x102"},
          {"1302sub1", kValue, "0"},
          {"1301sub1", kValue, "0"}},
         {"warning: 0x1301:01: no SRDO is on: the device sends and receives none, and 'counterpoint monitor' watches "
          "none, expected 1 (producer) or 2 (consumer) in the direction of one",
          "warning: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, both are off, expected an identifier of its own",
          "warning: 0x1302:06: COB-ID 0x102 is in use by SRDO 1, both are off, expected an identifier of its own"}},
    };
    test::ExpectRows("controller", rows, {});
}

// What the kernel takes while SRDO 2 is off; each but the last is an error of an SRDO that is on
TEST(CheckSrdo, OfAnSrdoThatIsOffWhatTheDeviceTakesIsAWarning)
{
    Verifies(req::SRS_CLI_031);
    const Set off{"1302sub1", kValue, "0"};
    const std::vector<CheckRow> rows = {
        {{off, {"1302sub0", kValue, "5"}}, {"warning: 0x1302:00: highest sub-index 5, expected 6"}},
        {{off, {"1382sub3", kValue, "0x20000108"}, {"1382sub4", kValue, "0x21000108"}},
         {"warning: 0x1382:03: object 0x2000:01 is mapped twice, expected another object than in sub-index 1",
          "warning: 0x1382:04: object 0x2100:01 is mapped twice, expected another object than in sub-index 2"}},
        {{off, {"1382sub2", kValue, "0x21000208"}, {"1382sub4", kValue, "0x21000108"}},
         {"warning: 0x1382:02: inverse entry 0x2100:02, expected 0x2100:01, the InvertedSRAD of 0x2000:01 (line 486)",
          "warning: 0x1382:04: inverse entry 0x2100:01, expected 0x2100:02, the InvertedSRAD of 0x2000:02 (line 496)"}},
        {{off, {"1382sub1", kValue, "0x00050008"}, {"1382sub2", kValue, "0x00060010"}},
         {"warning: 0x1382:02: inverse entry of 16 bit, expected 8 bit as the normal entry before it"}},
        {{off, {"1382sub0", kValue, "3"}},
         {"error: 0x1382:00: 3 mapping entries, expected an even number: one normal and one inverse entry a pair"}},
    };
    test::ExpectRows("controller", rows, {});
    // Given a granularity that the lengths of SRDO 1, which is on, and of SRDO 2, which is off, are no multiples of
    const std::string wrong = ": length of 8 bit, expected a multiple of 16 bit (granularity)";
    EXPECT_EQ(test::FindingsOfChange("controller", {{off, {"5F00subA", kValue, "16"}}, {}}, {}),
              (Lines{"error: 0x1381:01" + wrong, "error: 0x1381:02" + wrong, "error: 0x1381:03" + wrong,
                     "error: 0x1381:04" + wrong, "warning: 0x1382:01" + wrong, "warning: 0x1382:02" + wrong,
                     "warning: 0x1382:03" + wrong, "warning: 0x1382:04" + wrong}));
}

TEST(CheckSrdo, AnObjectIsReceivedByOneSrdoAlone)
{
    Verifies(req::SRS_CLI_032);
    const std::vector<Set> both_received{{"1302sub1", kValue, "2"},
                                         {"1382sub0", kValue, "2"},
                                         {"1382sub1", kValue, "0x22000108"},
                                         {"1382sub2", kValue, "0x23000108"}};
    std::vector<Set> one_off = both_received;
    one_off[0].value = "0";
    std::vector<Set> received_and_sent = both_received;
    received_and_sent[0].value = "1";
    const std::vector<Set> both_sent{{"1301sub1", kValue, "1"},
                                     {"1381sub0", kValue, "2"},
                                     {"1381sub1", kValue, "0x20000108"},
                                     {"1381sub2", kValue, "0x21000108"}};
    const std::vector<Set> both_dummies{{"1302sub1", kValue, "2"},          {"1382sub0", kValue, "2"},
                                        {"1382sub1", kValue, "0x00050008"}, {"1382sub2", kValue, "0x00050008"},
                                        {"1381sub3", kValue, "0x00050008"}, {"1381sub4", kValue, "0x00050008"}};
    const std::string shared_normal = "error: 0x1382:01: object 0x2200:01 is in the mapping of SRDO 1 too, and one of "
                                      "the two receives, expected an object of its own";
    const std::string shared_inverse = "error: 0x1382:02: object 0x2300:01 is in the mapping of SRDO 1 too, and one of "
                                       "the two receives, expected an object of its own";
    test::ExpectRows(
        "controller",
        {{both_received, {shared_normal, shared_inverse}}, {one_off, {}}, {both_sent, {}}, {both_dummies, {}}}, {});
    const std::vector<std::string> found = test::FindingsOfChange("controller", {received_and_sent, {}}, {});
    EXPECT_EQ(found.at(1), shared_normal);
    EXPECT_EQ(found.at(3), shared_inverse);
}

TEST(CheckSrdo, AMappedObjectHasAValueOfItsType)
{
    Verifies(req::SRS_CLI_034);
    test::ExpectRows(
        "controller",
        {{{{"2000sub1", kValue, "256"}},
          {"warning: 0x2000:01: ParameterValue: value '256', expected a number from 0 to 255 (UNSIGNED8)",
           "error: 0x2000:01: value '256', expected a number from 0 to 255 (UNSIGNED8)"}},
         {{{"2100sub1", kValue, "-1"}},
          {"warning: 0x2100:01: ParameterValue: value '-1', expected a number from 0 to 255 (UNSIGNED8), or "
           "$NODEID+number",
           "error: 0x2100:01: value '-1', expected a number from 0 to 255 (UNSIGNED8), or $NODEID+number"}},
         {{{"2000sub1", kValue, "0xFF"}}, {}}},
        {});
}

TEST(CheckSrdo, TimesOfAConsumer)
{
    Verifies(req::SRS_CLI_011);
    const std::vector<CheckRow> rows = {
        {{{"1301sub3", kValue, "0"}}, {"error: 0x1301:03: SRVT 0 ms of a consumer, expected 1 ms or more"}},
        {{{"1301sub3", kValue, "1"}}, {}},
        {{{"1301sub3", kValue, "49"}}, {}},
        {{{"1301sub3", kValue, "50"}}, {"error: 0x1301:03: SRVT 50 ms, expected less than the SCT of 50 ms"}},
        {{{"1301sub2", kValue, "2"}, {"1301sub3", kValue, "1"}}, {}},
        {{{"1301sub2", kValue, "65535"}, {"1301sub3", kValue, "255"}}, {}},
        {{{"1301sub2", kValue, "0"}}, {"error: 0x1301:03: SRVT 20 ms, expected less than the SCT of 0 ms"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, AnSctBelowALateCycleIsWarnedOf)
{
    Verifies(req::SRS_EDS_660);
    const std::vector<CheckRow> rows = {
        // Cycle 1501 us, tolerance 500 us: 1 us more than the SCT of 2 ms
        {{{"1301sub2", kValue, "2"}, {"1301sub3", kValue, "1"}, {"5F00sub1", kValue, "1501"}},
         {"warning: 0x1301:02: SCT 2 ms: it may expire between two calls, and is found by the later one, "
          "expected at least a cycle with its tolerance, 2001 us"}},
        // The limit itself
        {{{"1301sub2", kValue, "2"}, {"1301sub3", kValue, "1"}, {"5F00sub1", kValue, "1500"}}, {}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, TimesOfAProducer)
{
    Verifies(req::SRS_CLI_011);
    const std::vector<CheckRow> rows = {
        {{{"1302sub2", kValue, "1"}, {"1302sub3", kValue, "1"}},
         {"warning: 0x1302:02: refresh time 1 ms: late calls put refreshes off, and nothing tells it, expected at "
          "least a "
          "cycle with its tolerance, 1500 us",
          "warning: 0x1302:03: SRVT 1 ms, expected less than the refresh time of 1 ms"}},
        {{{"1302sub2", kValue, "1"}, {"1302sub3", kValue, "1"}, {"5F00sub1", kValue, "1001"}},
         {"error: 0x1302:02: refresh time 1 ms, expected at least one cycle of 1001 us (0x5F00:01)",
          "warning: 0x1302:03: SRVT 1 ms, expected less than the refresh time of 1 ms"}},
        {{{"1302sub2", kValue, "0"}, {"1302sub3", kValue, "1"}},
         {"error: 0x1302:02: refresh time 0 ms, expected at least one cycle of 1000 us (0x5F00:01)",
          "warning: 0x1302:03: SRVT 1 ms, expected less than the refresh time of 0 ms"}},
        {{{"1302sub3", kValue, "24"}}, {}},
        {{{"1302sub3", kValue, "25"}},
         {"warning: 0x1302:03: SRVT 25 ms, expected less than the refresh time of 25 ms"}},
        {{{"1302sub3", kValue, "0"}},
         {"warning: 0x1302:03: SRVT 0 ms of a producer: no confirmation comes in time, expected 1 ms or more"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, ARefreshTimeBelowALateCycleIsWarnedOf)
{
    Verifies(req::SRS_EDS_039);
    const std::string put_off =
        "warning: 0x1302:02: refresh time 2 ms: late calls put refreshes off, and nothing tells it, "
        "expected at least a cycle with its tolerance, 2001 us";
    const std::vector<CheckRow> rows = {
        // Cycle 1001 us, tolerance 1000 us; refresh time 2 ms, by provider: 1 us less than may pass between two calls
        {{{"1302sub2", kValue, "2"},
          {"1302sub3", kValue, "1"},
          {"5F00sub1", kValue, "1001"},
          {"5F00sub2", kValue, "1000"},
          {"5F03sub2", kValue, "1"}},
         {put_off}},
        // The limit itself
        {{{"1302sub2", kValue, "2"},
          {"1302sub3", kValue, "1"},
          {"5F00sub1", kValue, "1000"},
          {"5F00sub2", kValue, "1000"},
          {"5F03sub2", kValue, "1"}},
         {}},
        // The application sends: then the time between its pairs is watched
        {{{"1302sub2", kValue, "2"},
          {"1302sub3", kValue, "1"},
          {"5F00sub1", kValue, "1001"},
          {"5F00sub2", kValue, "1000"},
          {"5F03sub2", kValue, "0"}},
         {}},
        {{{"1302sub1", kValue, "0"},
          {"1302sub2", kValue, "2"},
          {"1302sub3", kValue, "1"},
          {"5F00sub1", kValue, "1001"},
          {"5F00sub2", kValue, "1000"},
          {"5F03sub2", kValue, "1"}},
         {}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, AnSrdoThatIsOffHasNoTimingRule)
{
    Verifies(req::SRS_CLI_011);
    const std::vector<CheckRow> rows = {
        {{{"1301sub1", kValue, "0"}, {"1301sub2", kValue, "0"}, {"1301sub3", kValue, "0"}}, {}},
        {{{"1301sub1", kValue, "0"}, {"1301sub2", kValue, "5"}, {"1301sub3", kValue, "9"}}, {}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckSrdo, CommunicationParametersAloneAndNoGfcParameter)
{
    Verifies(req::SRS_CLI_017);
    // Given a consumer without mapping parameters, in a file without 1300h and without 5F00h, which would tell of GFC
    std::string text = test::SrdoFileText({{1, "2", "50", "20", "0x101", "0x102", {"0x20000108", "0x21000108"}}});
    for (std::size_t at = text.find("[1381"); at != std::string::npos; at = text.find("[1381"))
    {
        text.replace(at, 5U, "[2FF1");
    }
    const Lines found = test::FindingsOf(text, {});
    for (const std::string line :
         {"error: 0x1381: SRDO 1 has no mapping parameters, expected a section [1381]",
          "warning: 0x1300: the GFC parameter is missing, expected an object of type UNSIGNED8",
          "warning: [DeviceInfo] does not announce CANopen Safety, expected CANopenSafetySupported=1"})
    {
        EXPECT_EQ(std::count(found.begin(), found.end(), line), 1) << line;
    }
}

TEST(CheckSrdo, DefaultCobIdsOfTheFirstSrdo)
{
    Verifies(req::SRS_CLI_017);
    CheckOptions options;
    options.node_id = std::uint8_t{3U};
    const std::vector<CheckRow> rows = {
        {{{"1301sub5", "DefaultValue", "0x105"}, {"1301sub6", "DefaultValue", "$NODEID+0x103"}}, {}},
        {{{"1301sub5", "DefaultValue", "0x103"}},
         {"warning: 0x1301:05: default COB-ID 0x103, expected 0x105 for node-ID 3 (pre-defined connection set)",
          "warning: 0x1301:06: default COB-ID 0x104, expected 0x106 for node-ID 3 (pre-defined connection set)"}},
    };
    test::ExpectRows("controller", rows, options);
    options.node_id = std::uint8_t{64U};
    const std::vector<CheckRow> last = {
        {{{"1301sub5", "DefaultValue", "0x17F"}, {"1301sub6", "DefaultValue", "0x180"}}, {}}};
    test::ExpectRows("controller", last, options);
    options.node_id = std::uint8_t{65U};
    const std::vector<CheckRow> none = {
        {{{"1301sub5", "DefaultValue", "0x101"}, {"1301sub5", kValue, ""}},
         {"warning: 0x1301:05: default COB-ID with node-ID 65, expected a ParameterValue: there is no default COB-ID "
          "above node-ID 64"}}};
    test::ExpectRows("controller", none, options);
}

/// What the check finds in a file with these values, signed again, but for the line about 13FEh.
Lines Find(const std::string& text, const std::vector<Set>& values)
{
    Lines lines;
    for (const std::string& line :
         test::FindingsOf(test::SignedAgain(test::WithValues(text, values), std::nullopt), {}))
    {
        if (!test::IsFollower(line))
        {
            lines.push_back(line);
        }
    }
    return lines;
}

TEST(CheckStatic, WhatWouldBeWrittenIsFound)
{
    Verifies(req::SRS_CLI_023);
    const std::string text = test::FileText("static");
    EXPECT_EQ(Find(text, {{"1381sub1", kValue, "0x22000208"}}).at(0),
              "error: 0x1381:01: ParameterValue '0x22000208' for an entry that is const, expected its DefaultValue "
              "'0x22000108': nothing can be written there");
    EXPECT_EQ(Find(text, {{"1381sub0", kValue, "14"}}),
              Lines{"error: 0x1381:00: ParameterValue '14' for an entry that is const, expected its DefaultValue '16': "
                    "nothing can be written there"});
    // The value that it has is written in vain
    EXPECT_EQ(Find(text, {{"1381sub1", kValue, "570425608"}}),
              Lines{"warning: 0x1381:01: ParameterValue '570425608' for an entry that is const, expected none: nothing "
                    "can be written there"});
    EXPECT_EQ(Find(text, {{"1381sub10", kValue, "0x23000808"}, {"1381sub10", "AccessType", "ro"}}),
              Lines{"warning: 0x1381:10: ParameterValue '0x23000808' for an entry that is ro, expected none: nothing "
                    "can be written there"});
    EXPECT_EQ(Find(text, {{"1381sub10", kValue, "0x23000808"}, {"1381sub10", "DefaultValue", ""}}),
              Lines{"error: 0x1381:10: ParameterValue '0x23000808' for an entry that is const, expected a "
                    "DefaultValue, which nobody writes"});
}

TEST(CheckStatic, EntriesOfBothKindsAreAWarning)
{
    Verifies(req::SRS_CLI_023);
    EXPECT_EQ(Find(test::FileText("static"), {{"1381sub0", "AccessType", "rw"}}),
              Lines{"warning: 0x1381: 16 of 17 sub-indices are const or ro, expected all of them (static mapping) or "
                    "none"});
    // Those that sub-index 0 does not count are not asked
    EXPECT_EQ(Find(test::FileText("static"), {{"1383sub0", "DefaultValue", "4"}, {"1383sub6", "AccessType", "rw"}}),
              Lines{});
}

TEST(CheckStatic, OfAnSrdoThatIsOffLengthsAreAWarning)
{
    Verifies(req::SRS_CLI_031);
    // Given a static mapping of one bit
    EXPECT_EQ(Find(test::FileText("static"), {{"DeviceInfo", "Granularity", "1"},
                                              {"1303sub1", kValue, "0"},
                                              {"2400sub3", "DataType", "1"},
                                              {"2410sub3", "DataType", "1"},
                                              {"1383sub5", "DefaultValue", "0x24000301"},
                                              {"1383sub6", "DefaultValue", "0x24100301"}}),
              (Lines{"warning: 0x1383:05: length of 1 bit in a static mapping, expected a multiple of 8 bit",
                     "warning: 0x1383:06: length of 1 bit in a static mapping, expected a multiple of 8 bit"}));
}

TEST(CheckStatic, LengthsAreWholeBytesAndThereIsNoDummy)
{
    Verifies(req::SRS_CLI_023);
    // Given static entries of one bit, which a dynamic mapping might have
    const std::vector<Set> bits{{"DeviceInfo", "Granularity", "1"},
                                {"2400sub3", "DataType", "1"},
                                {"2410sub3", "DataType", "1"},
                                {"1383sub5", "DefaultValue", "0x24000301"},
                                {"1383sub6", "DefaultValue", "0x24100301"}};
    EXPECT_EQ(Find(test::FileText("static"), bits),
              (Lines{"error: 0x1383:05: length of 1 bit in a static mapping, expected a multiple of 8 bit",
                     "error: 0x1383:06: length of 1 bit in a static mapping, expected a multiple of 8 bit"}));
    EXPECT_EQ(Find(test::FileText("static"), {{"DummyUsage", "Dummy0005", "1"},
                                              {"1381sub1", "DefaultValue", "0x00050008"},
                                              {"1381sub2", "DefaultValue", "0x00050008"}}),
              (Lines{"error: 0x1381:01: dummy object 0x0005:00 in a static mapping, expected an object of the "
                     "application",
                     "error: 0x1381:02: dummy object 0x0005:00 in a static mapping, expected an object of the "
                     "application"}));
}

TEST(CheckDummies, EveryTypeHasItsLength)
{
    Verifies(req::SRS_CLI_015);
    const std::string text = test::FileText("dummies");
    EXPECT_EQ(Find(text, {{"1381sub1", kValue, "0x00010008"}, {"1381sub2", kValue, "0x00010008"}}).at(0),
              "error: 0x1381:00: 71 bit of normal data, expected at most 64 bit");
    EXPECT_EQ(Find(text, {{"13C0sub1", kValue, "0x00050010"}, {"13C0sub2", kValue, "0x00050010"}}).at(2),
              "error: 0x13C0:01: length of 16 bit, expected 8 bit of the dummy object");
    EXPECT_EQ(Find(text, {{"1381subB", kValue, "0x00040018"}, {"1381subC", kValue, "0x00040018"}}),
              (Lines{"error: 0x1381:0B: length of 24 bit, expected 32 bit of the dummy object",
                     "error: 0x1381:0C: length of 24 bit, expected 32 bit of the dummy object"}));
    // REAL32 has 32 bits too, and is none of the types that may stand for an object
    EXPECT_EQ(Find(text, {{"DummyUsage", "Dummy0008", "1"},
                          {"1381subB", kValue, "0x00080020"},
                          {"1381subC", kValue, "0x00080020"}}),
              (Lines{"error: 0x1381:0B: dummy object 0x0008:00 is not mappable, expected a data type 0x0001 to 0x0007 "
                     "that [DummyUsage] allows, with sub-index 0",
                     "error: 0x1381:0C: dummy object 0x0008:00 is not mappable, expected a data type 0x0001 to 0x0007 "
                     "that [DummyUsage] allows, with sub-index 0"}));
    EXPECT_EQ(Find(text, {{"13C0sub8", kValue, "0x00050008"}, {"2200sub3", "InvertedSRAD", ""}}),
              Lines{"error: 0x13C0:08: dummy object on one side of the pair only, expected normal and inverse data to "
                    "be stored both or not at all"});
}

TEST(CheckDummies, TheDeviceHasToAllowThem)
{
    Verifies(req::SRS_CLI_015);
    const std::vector<Set> dummies{{"1382sub1", kValue, "0x00070020"}, {"1382sub2", kValue, "0x00070020"}};
    EXPECT_EQ(Find(test::FileText("digest"), dummies), Lines{});
    std::vector<Set> refused = dummies;
    refused.push_back({"5F00subC", kValue, "0"});
    EXPECT_EQ(Find(test::FileText("digest"), refused),
              (Lines{"error: 0x1382:01: dummy object 0x0007:00 in a device without dummy mapping, expected 0x66 in "
                     "0x5F00:0C",
                     "error: 0x1382:02: dummy object 0x0007:00 in a device without dummy mapping, expected 0x66 in "
                     "0x5F00:0C"}));
}

TEST(CheckParameters, RoomForMappingEntries)
{
    Verifies(req::SRS_CLI_012);
    const std::vector<Set> four{{"5F00subB", kValue, "2"}};
    EXPECT_EQ(Find(test::ExampleText("sensor"), four),
              Lines{"error: 0x1381:00: 4 mapping entries, expected at most 2, for which 0x5F00:0B gives room"});
    EXPECT_EQ(Find(test::ExampleText("sensor"), {{"5F00subB", kValue, "4"}}), Lines{});
    // A static mapping takes no room
    Lines findings =
        Find(test::Changed(test::FileText("static"), {{"[1000]\n", "[5F00]\nObjectType=9\nSubNumber=1\n"
                                                                   "[5F00subB]\nDataType=5\nAccessType=rw\n"
                                                                   "DefaultValue=0\n\n[1000]\n"}}),
             {});
    EXPECT_EQ(findings, Lines{"warning: 0x5F00: is in none of the lists [MandatoryObjects], [OptionalObjects], "
                              "[ManufacturerObjects]"});
}

TEST(CheckParameters, Times)
{
    Verifies(req::SRS_CLI_018);
    const auto find = [](const std::vector<Set>& values) { return Find(test::ExampleText("controller"), values); };
    EXPECT_EQ(find({{"5F00sub1", kValue, "99"}, {"5F00sub2", kValue, "0"}}),
              Lines{"error: 0x5F00:01: cycle time 99 us, expected 100 us to 1000000 us"});
    EXPECT_EQ(find({{"5F00sub1", kValue, "1000001"}, {"1301sub2", kValue, "1001"}, {"1302sub2", kValue, "1001"}}),
              Lines{"error: 0x5F00:01: cycle time 1000001 us, expected 100 us to 1000000 us"});
    EXPECT_EQ(find({{"5F00sub2", kValue, "1000"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub2", kValue, "1001"}}),
              Lines{"error: 0x5F00:02: cycle tolerance of 1001 us, expected at most the cycle time of 1000 us"});
    EXPECT_EQ(find({{"5F00sub3", kValue, "0x3FFFFFFF"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub3", kValue, "0x40000000"}}),
              Lines{"error: 0x5F00:03: discrepancy time of 1073741824 us, expected at most 1073741823 us"});
    EXPECT_EQ(find({{"5F00sub4", kValue, "6"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub4", kValue, "5"}}), Lines{"error: 0x5F00:04: diagnostic interval of 5 ms, expected at "
                                                       "least 6000 us, 2 cycles with their tolerance for each SRDO"});
    EXPECT_EQ(find({{"5F00sub4", kValue, "1073742"}}),
              Lines{"error: 0x5F00:04: interval of 1073742 ms, expected at most 1073741 ms"});
    EXPECT_EQ(
        find({{"5F00sub5", kValue, "22"}}),
        Lines{"error: 0x5F00:05: test interval of 22 ms, expected at least 22500 us, 15 cycles with their tolerance"});
    EXPECT_EQ(find({{"5F00sub5", kValue, "23"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub7", kValue, "6000"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub7", kValue, "5999"}}),
              Lines{"error: 0x5F00:07: clock tolerance interval of 5999 us, expected "
                    "at least 6000 us, 4 cycles with their tolerance"});
    EXPECT_EQ(find({{"5F00sub6", kValue, "99999"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub6", kValue, "100000"}}),
              Lines{"error: 0x5F00:06: clock tolerance of 100000 us, expected less than its interval of 100000 us "
                    "(0x5F00:07)"});
    EXPECT_EQ(find({{"5F00sub7", kValue, "0x40000000"}}),
              Lines{"error: 0x5F00:07: clock tolerance interval of 1073741824 us, expected at most 1073741823 us"});
    EXPECT_EQ(find({{"5F00sub8", kValue, "0x40000000"}}),
              Lines{"error: 0x5F00:08: output time of 1073741824 us, expected at most 1073741823 us"});
    EXPECT_EQ(find({{"5F00sub9", kValue, "0x40000000"}}),
              Lines{"error: 0x5F00:09: acknowledge window of 1073741824 us, expected at most 1073741823 us"});
}

TEST(CheckParameters, Form)
{
    Verifies(req::SRS_CLI_018);
    const auto find = [](const std::string& section, const std::string& value)
    { return Find(test::ExampleText("actuator"), {{section, kValue, value}}); };
    EXPECT_EQ(find("5F00subA", "1"), Lines{});
    EXPECT_EQ(find("5F00subB", "17"),
              Lines{"error: 0x5F00:0B: room for 17 mapping entries, expected an even number from 0 to 128"});
    EXPECT_EQ(find("5F00subB", "130"),
              Lines{"error: 0x5F00:0B: room for 130 mapping entries, expected an even number from 0 to 128"});
    EXPECT_EQ(find("5F00subB", "128"), Lines{});
    EXPECT_EQ(find("5F00subC", "0x01"), Lines{"error: 0x5F00:0C: dummy mapping 0x01, expected 0x00 or 0x66"});
    EXPECT_EQ(find("5F00subC", "0x00"), Lines{});
    EXPECT_EQ(find("5F00subD", "0x66"),
              Lines{"error: 0x5F00:0D: gaps between SRDO numbers 0x66, expected 0x00 or 0x99"});
    EXPECT_EQ(find("5F00subD", "0x99"), Lines{});
    EXPECT_EQ(find("5F00subE", "1"),
              (Lines{"error: 0x5F00:0E: use of the GFC 0x01, expected 0x00 or 0x5A",
                     "error: 0x5F00:0E: the GFC is removed and there is 0x1300, expected 0x5A, or no object 0x1300"}));
    EXPECT_EQ(find("5F00subF", "0"), Lines{"error: 0x5F00:0F: controller 0 of the normal frames, expected 1 or 2"});
    EXPECT_EQ(find("5F00subF", "2"), Lines{});
    EXPECT_EQ(find("5F00sub10", "3"), Lines{"error: 0x5F00:10: controller 3 of the inverse frames, expected 1 or 2"});
    EXPECT_EQ(find("5F05sub1", "0x3D"),
              Lines{"warning: 0x5F05:01: SRVT detection 0x3D is taken for the early one, expected 0x00 (early) or 0x3C "
                    "(late)"});
    EXPECT_EQ(find("5F05sub1", "0x3C"), Lines{});
    EXPECT_EQ(find("5F05sub1", "0x100").at(0),
              "error: 0x5F05:01: value '0x100', expected a number from 0 to 255 (UNSIGNED8)");
}

TEST(CheckParameters, AGranularityThatIsNone)
{
    Verifies(req::SRS_CLI_490);
    Verifies(req::SRS_CLI_018);
    // When 5F00h:0A has a value that is none, then it alone is told, and no length is compared with it
    for (const std::string value : {"0", "2", "4", "7", "128", "255"})
    {
        EXPECT_EQ(Find(test::ExampleText("actuator"), {{"5F00subA", kValue, value}}),
                  Lines{"error: 0x5F00:0A: granularity of " + value + " bit, expected 1, 8, 16, 32 or 64 bit"});
    }
    // and with 13FEh = A5h that flag
    EXPECT_EQ(
        test::FindingsOf(
            test::SignedAgain(test::WithValues(test::ExampleText("sensor"), {{"5F00subA", kValue, "0"}}), std::nullopt),
            {}),
        (Lines{"error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until all of them "
               "are repaired",
               "error: 0x5F00:0A: granularity of 0 bit, expected 1, 8, 16, 32 or 64 bit"}));
}

TEST(CheckParameters, GapsBetweenSrdoNumbers)
{
    Verifies(req::SRS_CLI_018);
    EXPECT_EQ(Find(test::FileText("digest"), {{"5F00subD", kValue, "0"}}),
              Lines{"error: 0x1302: SRDO 2 in a device without gaps, expected SRDO 1 before it, or 0x99 in 0x5F00:0D"});
    EXPECT_EQ(Find(test::ExampleText("controller"), {{"5F00subD", kValue, "0"}}), Lines{});
}

TEST(CheckParameters, GfcThatIsRemoved)
{
    Verifies(req::SRS_CLI_018);
    const std::string without =
        test::Changed(test::ExampleText("sensor"), {{"[1300]\n", "[2FFF]\n"}, {"=0x1300\n", "=0x2FFF\n"}});
    EXPECT_EQ(Find(without, {{"5F00subE", kValue, "0"}}), Lines{});
    EXPECT_EQ(Find(without, {}),
              Lines{"error: 0x5F00:0E: the GFC is used and there is no 0x1300, expected 0x00, or the object 0x1300"});
}
} // namespace
} // namespace counterpoint::cia306
