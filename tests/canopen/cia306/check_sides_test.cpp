// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Which side of a mapping an object may stand on.
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia306
{
namespace
{
using test::CheckRow;
constexpr const char* kWritten = "ParameterValue";

TEST(CheckSides, NormalDataStandsNotInThePlaceOfInverseData)
{
    Verifies(req::SRS_CLI_550);
    const test::Set first{"1381sub2", kWritten, "0x20000208"};
    const test::Set count{"1381sub0", kWritten, "2"};
    const test::Set unnamed{"2000sub1", "InvertedSRAD", ""};
    const std::string found = "0x1381:02: inverse entry 0x2000:02 has an InvertedSRAD of its own (line 365), as normal "
                              "data has, expected inverse data of 0x2000:01";
    const std::vector<CheckRow> rows = {
        {{first, count, unnamed}, {"error: " + found}},
        {{first, count, unnamed, {"1301sub1", kWritten, "0"}, {"13FE", kWritten, "0"}},
         {"warning: " + found, "warning: 0x13FE:00: 0x00: the SRDOs stay off, expected 0xA5 to set them going"}},
        // One that names the normal entry makes it inverse data
        {{first, count, unnamed, {"2000sub2", "InvertedSRAD", "0x200001"}},
         {"error: 0x1381:01: normal entry 0x2000:01 is the InvertedSRAD of 0x2000:02 (line 365), expected normal data "
          "here and 0x2000:01 behind it"}},
        // The normal object has the last word on what its inverse is
        {{first, count, {"2000sub1", "InvertedSRAD", "0x200002"}}, {}},
        {{first, count, unnamed, {"2000sub2", "InvertedSRAD", ""}}, {}},
        {{first, count},
         {"error: 0x1381:02: inverse entry 0x2000:02, expected 0x2100:01, the InvertedSRAD of 0x2000:01 "
          "(line 355)"}},
    };
    test::ExpectRows("sensor", rows, {});
}

// Signature and inversion are right of all of them
TEST(CheckSides, InverseDataStandsNotInThePlaceOfNormalData)
{
    Verifies(req::SRS_CLI_014);
    const std::string first = "error: 0x1381:01: normal entry 0x2100:01 is the InvertedSRAD of 0x2000:01 (line 355), "
                              "expected normal data here and 0x2100:01 behind it";
    const std::vector<CheckRow> rows = {
        {{{"1381sub1", kWritten, "0x21000108"}, {"1381sub2", kWritten, "0x20000108"}}, {first}},
        {{{"1381sub1", kWritten, "0x21000108"}, {"1381sub2", kWritten, "0x21000208"}, {"1381sub0", kWritten, "2"}},
         {first}},
        // Without an InvertedSRAD nobody knows
        {{{"1381sub1", kWritten, "0x21000108"}, {"1381sub2", kWritten, "0x20000108"}, {"2000sub1", "InvertedSRAD", ""}},
         {}},
        {{{"1381sub1", kWritten, "0x21000108"},
          {"1381sub2", kWritten, "0x20000108"},
          {"2100sub1", "InvertedSRAD", "0x200001"}},
         {"error: 0x1381:01: normal entry 0x2100:01 is the InvertedSRAD of 0x2000:01 (line 355) and has one itself "
          "(line 386), expected one of the two"}},
        // Each the inverse of the other: nobody knows which one is meant
        {{{"2100sub1", "InvertedSRAD", "0x200001"}},
         {"error: 0x1381:01: normal entry 0x2000:01 is the InvertedSRAD of 0x2100:01 (line 386) and has one itself "
          "(line 355), expected one of the two"}},
        // Of one that the file does not describe, too
        {{{"1381sub1", kWritten, "0x21000308"}, {"1381sub0", kWritten, "2"}, {"2000sub1", "InvertedSRAD", "0x210003"}},
         {"error: 0x1381:01: mapped object 0x2100:03 is unknown, expected an object that the file describes",
          "error: 0x1381:01: normal entry 0x2100:03 is the InvertedSRAD of 0x2000:01 (line 355), expected normal data "
          "here and 0x2100:03 behind it",
          "error: 0x2000:01: InvertedSRAD 0x2100:03 names an unknown object, expected an object that the file "
          "describes"}},
    };
    test::ExpectRows("sensor", rows, {});
    const test::Set off{"1302sub1", kWritten, "0"};
    test::ExpectRows(
        "controller",
        {{{off, {"1382sub1", kWritten, "0x21000108"}, {"1382sub2", kWritten, "0x20000108"}},
          {"warning: 0x1382:01: normal entry 0x2100:01 is the InvertedSRAD of 0x2000:01 (line 486), expected "
           "normal data here and 0x2100:01 behind it"}}},
        {});
}

// Signature and inversion are right of both SRDOs
TEST(CheckSides, AnObjectIsOnOneSideInAllSrdos)
{
    Verifies(req::SRS_CLI_730);
    // Given the pairs of SRDO 1 the other way round in SRDO 2, and no InvertedSRAD
    const std::vector<test::Set> exchanged{{"1382sub1", kWritten, "0x21000108"}, {"1382sub2", kWritten, "0x20000108"},
                                           {"1382sub3", kWritten, "0x21000208"}, {"1382sub4", kWritten, "0x20000208"},
                                           {"1381sub1", kWritten, "0x20000108"}, {"1381sub2", kWritten, "0x21000108"},
                                           {"1381sub3", kWritten, "0x20000208"}, {"1381sub4", kWritten, "0x21000208"},
                                           {"1301sub1", kWritten, "1"},          {"2000sub1", "InvertedSRAD", ""},
                                           {"2000sub2", "InvertedSRAD", ""}};
    const std::vector<std::string> found{
        "error: 0x1382:01: normal entry 0x2100:01 is inverse data of SRDO 1, expected an object of one side",
        "error: 0x1382:02: inverse entry 0x2000:01 is normal data of SRDO 1, expected an object of one side",
        "error: 0x1382:03: normal entry 0x2100:02 is inverse data of SRDO 1, expected an object of one side",
        "error: 0x1382:04: inverse entry 0x2000:02 is normal data of SRDO 1, expected an object of one side"};
    std::vector<std::string> errors;
    for (const std::string& finding : test::FindingsOfChange("controller", {exchanged, {}}, {}))
    {
        if (finding.find("data of SRDO") != std::string::npos)
        {
            errors.push_back(finding);
        }
    }
    EXPECT_EQ(errors, found);
    // One that is off says nothing
    std::vector<test::Set> off = exchanged;
    off.push_back({"1302sub1", kWritten, "0"});
    for (const std::string& finding : test::FindingsOfChange("controller", {off, {}}, {}))
    {
        EXPECT_EQ(finding.find("data of SRDO"), std::string::npos) << finding;
    }
}

TEST(CheckSides, ASafetyParameterIsNoVariable)
{
    Verifies(req::SRS_EDS_730);
    const std::vector<CheckRow> rows = {
        {{{"5F01sub1", "SRDOMapping", "1"}, {"1381sub1", kWritten, "0x5F010108"}, {"1381sub0", kWritten, "2"}},
         {"error: 0x1381:01: mapped object 0x5F01:01 is not mappable (line 568), expected an object of the "
          "application, "
          "not of the safety functions",
          "warning: 0x5F01:01: it is mappable by SRDOMapping or PDOMapping, expected 0 for 0x5F00 to 0x5F05; no SRDO "
          "can map it"}},
    };
    test::ExpectRows("sensor", rows, {});
}

// An entry that cannot be read is no part of a pair
TEST(CheckSides, APairHasTwoEntries)
{
    Verifies(req::SRS_CLI_550);
    const std::vector<CheckRow> rows = {
        {{{"1381sub1", kWritten, "x"}},
         {"error: 0x1381:01: value 'x', expected a number from 0 to 4294967295 (UNSIGNED32), or $NODEID+number"}},
        {{{"1381sub3", kWritten, "x"}},
         {"error: 0x1381:03: value 'x', expected a number from 0 to 4294967295 (UNSIGNED32), or $NODEID+number"}},
    };
    test::ExpectRows("sensor", rows, {});
}
} // namespace
} // namespace counterpoint::cia306
