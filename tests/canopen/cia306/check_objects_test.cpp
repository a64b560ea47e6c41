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

using test::CheckRow;

constexpr const char* kValue = "ParameterValue";

using Lines = std::vector<std::string>;

TEST(CheckObjects, ASignatureThatIsNotTheComputedOne)
{
    Verifies(req::SRS_CLI_016);
    const std::string text = test::WithValues(test::ExampleText("controller"), {{"13FFsub2", kValue, "0xCA44"}});
    EXPECT_EQ(
        test::FindingsOf(text, {}),
        (Lines{"error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until all of them "
               "are repaired",
               "error: 0x13FF:02: signature 0xCA44 of SRDO 2, expected 0xCA45, computed from its parameters"}));
    // The same without the flag: only the signature.
    const std::string off = test::WithValues(text, {{"13FE", kValue, "0"}});
    EXPECT_EQ(test::FindingsOf(off, {}),
              Lines{"error: 0x13FF:02: signature 0xCA44 of SRDO 2, expected 0xCA45, computed from its parameters"});
}

TEST(CheckObjects, ASignatureIsComparedForAnSrdoThatIsOffToo)
{
    Verifies(req::SRS_CLI_016);
    const std::string text = test::WithValues(test::ExampleText("sensor"), {{"1301sub1", kValue, "0"}});
    EXPECT_EQ(test::FindingsOf(text, {}).back(),
              "error: 0x13FF:01: signature 0xB631 of SRDO 1, expected 0x3BED, computed from its parameters");
}

TEST(CheckObjects, ConfigurationValid)
{
    Verifies(req::SRS_CLI_016);
    Verifies(req::SRS_CLI_040);
    const std::vector<CheckRow> rows = {
        {{{"13FE", kValue, "0"}}, {"warning: 0x13FE:00: 0x00: the SRDOs stay off, expected 0xA5 to set them going"}},
        {{{"13FE", kValue, "0x5A"}}, {"warning: 0x13FE:00: 0x5A: the SRDOs stay off, expected 0xA5 to set them going"}},
        {{{"13FE", "AccessType", "ro"}},
         {"warning: 0x13FE:00: the device lets clients read and write it all the same, expected AccessType=rw"}},
        {{{"13FE", "AccessType", "wo"}},
         {"warning: 0x13FE:00: the device lets clients read and write it all the same, expected AccessType=rw"}},
        {{{"13FE", "AccessType", "const"}},
         {"warning: 0x13FE:00: the device lets clients read and write it all the same, expected AccessType=rw"}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckObjects, MissingObjects)
{
    Verifies(req::SRS_CLI_016);
    Verifies(req::SRS_CLI_017);
    const std::string listed = "is listed, expected a section that describes it";
    const std::vector<CheckRow> rows = {
        {{},
         {"error: 0x13FE: " + listed,
          "error: 0x13FE:00: the configuration valid flag is missing, expected an object of type UNSIGNED8"},
         {{"[13FE]", "[Gone]"}}},
        {{},
         {"error: 0x13FF: " + listed, "error: 0x13FF: the safety configuration signature is missing, expected an array "
                                      "with a sub-index for each SRDO"},
         {{"[13FF]", "[Gone]"}, {"[13FFsub0]", "[Gone0]"}, {"[13FFsub1]", "[Gone1]"}}},
        {{{"13FF", "SubNumber", "1"}},
         {"error: 0x13FF:01: is missing, expected an object of type UNSIGNED16"},
         {{"[13FFsub1]", "[Gone]"}}},
        {{},
         {"error: 0x1300: " + listed,
          "error: 0x5F00:0E: the GFC is used and there is no 0x1300, expected 0x00, or the object 0x1300",
          "error: 0x5F04:00: device digest 0x66596575, expected 0xFB568403, computed from the device's parameters"},
         {{"[1300]", "[Gone]"}}},
        {{},
         {"warning: [DeviceInfo] does not announce CANopen Safety, expected CANopenSafetySupported=1"},
         {{"CANopenSafetySupported=1\n", ""}}},
        {{},
         {"warning: [DeviceInfo] does not announce CANopen Safety, expected CANopenSafetySupported=1"},
         {{"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckObjects, NoDigestWhileAnSrdoIsOn)
{
    Verifies(req::SRS_CLI_022);
    const std::string unbound = "; a wrong device parameter, 0x1300 included, is not found, expected ";
    const std::string none =
        "warning: 0x5F04:00: no device digest" + unbound + "the one that 'counterpoint sign' computes";
    // Given a sensor, signed, whose digest is then 0, without a value, or not there
    const std::string sensor = test::ExampleText("sensor");
    const std::string zero = test::WithValues(sensor, {{"5F04", kValue, "0"}});
    EXPECT_EQ(test::FindingsOf(zero, {}), Lines{none});
    const std::string empty = test::WithValues(sensor, {{"5F04", kValue, ""}, {"5F04", "DefaultValue", ""}});
    EXPECT_EQ(test::FindingsOf(empty, {}), Lines{none});
    EXPECT_EQ(
        test::FindingsOf(test::WithoutDigest(sensor), {}),
        (Lines{"warning: 0x5F04:00: is missing" + unbound + "an object of type UNSIGNED32 with the device digest"}));
    // When its SRDO is off, nothing is bound that is in use
    const std::string off = test::SignedAgain(test::WithValues(zero, {{"1301sub1", kValue, "0"}}), std::nullopt);
    EXPECT_EQ(test::FindingsOf(test::WithValues(off, {{"5F04", kValue, "0"}}), {}),
              Lines{"warning: 0x1301:01: no SRDO is on: the device sends and receives none, and 'counterpoint monitor' "
                    "watches none, expected 1 (producer) or 2 (consumer) in the direction of one"});
    // What is wrong already is told once
    const std::string other = test::WithValues(sensor, {{"5F04", kValue, "-1"}});
    EXPECT_EQ(test::FindingsOf(other, {}).size(), 2U);
    EXPECT_EQ(test::FindingsOf(other, {}).back().substr(0U, 24U), "error: 0x5F04:00: value ");
}

TEST(CheckObjects, NoNodeId)
{
    Verifies(req::SRS_CLI_036);
    const std::string none = "warning: no node-ID, expected NodeID in [DeviceComissioning], --node-id, or "
                             "LSS_Supported=1 in [DeviceInfo]";
    const std::string info = "[DeviceInfo]\nVendorName=x\n";
    const std::string object = "[1000]\nDataType=7\nAccessType=ro\nDefaultValue=0\n";
    const auto has = [&none](const std::string& text, const CheckOptions& options)
    {
        const Lines lines = test::FindingsOf(text, options);
        return std::count(lines.begin(), lines.end(), none);
    };
    EXPECT_EQ(has(info + object, {}), 1);
    EXPECT_EQ(has(object, {}), 1);
    EXPECT_EQ(has(info + object + "[DeviceComissioning]\nNodeID=\n", {}), 1);
    EXPECT_EQ(has(info + object, {9U, {}}), 0);
    EXPECT_EQ(has(info + object + "[DeviceComissioning]\nNodeID=9\n", {}), 0);
    EXPECT_EQ(has(info + "LSS_Supported=1\n" + object, {}), 0);
    // 0 is told by the reader
    const Lines zero = test::FindingsOf(info + object + "[DeviceComissioning]\nNodeID=0\n", {});
    EXPECT_EQ(has(info + object + "[DeviceComissioning]\nNodeID=0\n", {}), 0);
    EXPECT_EQ(zero.back(), "warning: NodeID is '0', expected 1 to 127; the device has no node-ID");
    // and so is 255
    EXPECT_EQ(has(info + object + "[DeviceComissioning]\nNodeID=255\n", {}), 0);
    EXPECT_EQ(test::FindingsOf(info + object + "[DeviceComissioning]\nNodeID=255\n", {}).back(),
              "warning: NodeID is '255', expected 1 to 127; the device has no node-ID");
}

TEST(CheckObjects, SignaturesOfGapsAndTheirNumber)
{
    Verifies(req::SRS_CLI_016);
    const std::vector<CheckRow> rows = {
        {{{"13FFsub0", kValue, "1"}}, {"error: 0x13FF:00: 1 signatures, expected at least 2, the highest SRDO"}},
        {{{"13FFsub0", kValue, "64"}}, {}},
        {{{"13FF", "SubNumber", "4"}},
         {},
         {{"[2000]\n", "[13FFsub3]\nDataType=6\nAccessType=rw\nDefaultValue=0\n\n[2000]\n"}}},
        {{{"13FF", "SubNumber", "4"}},
         {"warning: 0x13FF:03: signature 0x0007 of an SRDO that does not exist, expected 0x0000"},
         {{"[2000]\n", "[13FFsub3]\nDataType=6\nAccessType=rw\nDefaultValue=7\n\n[2000]\n"}}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckObjects, WhatStandsWhereItMustNot)
{
    Verifies(req::SRS_CLI_017);
    const std::string unlisted = "is in none of the lists [MandatoryObjects], [OptionalObjects], [ManufacturerObjects]";
    const auto object = [](const std::string& index)
    { return test::Change{"[1018]\n", "[" + index + "]\nDataType=5\nAccessType=rw\nDefaultValue=0\n\n[1018]\n"}; };
    const std::vector<CheckRow> rows = {
        {{},
         {"warning: 0x1341: " + unlisted, "error: 0x1341: the index is reserved, expected no object here"},
         {object("1341")}},
        {{},
         {"warning: 0x1380: " + unlisted, "error: 0x1380: the index is reserved, expected no object here"},
         {object("1380")}},
        {{},
         {"warning: 0x13C1: " + unlisted, "error: 0x13C1: the index is reserved, expected no object here"},
         {object("13C1")}},
        {{},
         {"warning: 0x13FD: " + unlisted, "error: 0x13FD: the index is reserved, expected no object here"},
         {object("13FD")}},
        {{},
         {"warning: 0x13C0: " + unlisted,
          "error: 0x13C0: mapping parameters without communication parameters, expected a section [1340]"},
         {object("13C0")}},
        {{{"1300", kValue, "2"}, {"1300", "HighLimit", ""}}, {"error: 0x1300:00: GFC parameter 2, expected 0 or 1"}},
        {{{"1300", kValue, "0"}}, {}},
        {{{"1300", "DataType", "6"}},
         {"error: 0x1300:00: DataType is 0x0006 (UNSIGNED16), expected 0x0005 (UNSIGNED8)"}},
        {{{"13FE", kValue, "valid"}},
         {"error: 0x13FE:00: value 'valid', expected a number from 0 to 255 (UNSIGNED8), or $NODEID+number"}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckObjects, SubIndicesBeyondTheLast)
{
    Verifies(req::SRS_CLI_017);
    const auto entry = [](const std::string& section)
    { return test::Change{"[1018]\n", "[" + section + "]\nDataType=5\nAccessType=rw\nDefaultValue=0\n\n[1018]\n"}; };
    const std::vector<CheckRow> rows = {
        {{{"1301", "SubNumber", "8"}},
         {"error: 0x1301:07: sub-index 7 is not defined, expected at most sub-index 6"},
         {entry("1301sub7")}},
        {{{"1381", "SubNumber", "6"}}, {}, {entry("1381sub80")}},
        {{{"1381", "SubNumber", "6"}},
         {"error: 0x1381:81: sub-index 129 is not defined, expected at most sub-index 128"},
         {entry("1381sub81")}},
        {{{"13FF", "SubNumber", "3"}}, {}, {entry("13FFsub40")}},
        {{{"13FF", "SubNumber", "3"}},
         {"error: 0x13FF:41: sub-index 65 is not defined, expected at most sub-index 64"},
         {entry("13FFsub41")}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckObjects, ValuesOutsideTheirLimits)
{
    Verifies(req::SRS_CLI_017);
    const std::vector<CheckRow> rows = {
        {{{"1301sub2", "LowLimit", "25"}, {"1301sub2", "HighLimit", "0x19"}}, {}},
        {{{"1301sub2", "LowLimit", "26"}}, {"error: 0x1301:02: value '25', expected at least the LowLimit '26'"}},
        {{{"1301sub2", "HighLimit", "24"}}, {"error: 0x1301:02: value '25', expected at most the HighLimit '24'"}},
        {{{"1301sub2", "HighLimit", "high"}},
         {"error: 0x1301:02: limit: value 'high', expected a number from 0 to 65535 (UNSIGNED16), or $NODEID+number"}},
        {{{"5F00sub3", "HighLimit", "4999"}},
         {"error: 0x5F00:03: value '5000', expected at most the HighLimit '4999'"}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckObjects, DeviceParameters)
{
    Verifies(req::SRS_CLI_400);
    Verifies(req::SRS_CLI_018);
    const std::string policy =
        " is taken for the restart interlock, expected 0x00 (restart interlock) or 0x5A (automatic)";
    const std::vector<CheckRow> rows = {
        {{{"5F01sub1", kValue, "0x5B"}}, {"warning: 0x5F01:01: release policy 0x5B" + policy}},
        {{{"5F01sub1", kValue, "0xFF"}}, {"warning: 0x5F01:01: release policy 0xFF" + policy}},
        {{{"5F01sub1", kValue, "0"}}, {}},
        {{{"5F03sub1", kValue, "2"}},
         {"warning: 0x5F03:01: producer form 2, expected 0 (the application sends) or 1 (provider)"}},
        {{{"5F02sub1", kValue, "0xFFFF"}}, {}},
        {{{"5F02sub1", kValue, "0x10000"}},
         {"warning: 0x5F02:01: safe value 0x10000, expected no bit above the 16 mapped bits"}},
        {{{"5F00sub1", kValue, "0"}},
         {"error: 0x5F00:01: cycle time 0 us, expected 100 us to 1000000 us",
          "error: 0x5F00:02: cycle tolerance of 500 us, expected at most the cycle time of 0 us"}},
        {{{"5F00sub1", kValue, "100"}, {"5F00sub2", kValue, "100"}}, {}},
        {{{"5F00sub3", kValue, "2999"}},
         {"warning: 0x5F00:03: discrepancy time of 2999 us, expected at least 3000 us, 2 cycles with their tolerance, "
          "or "
          "late cycles may end in the device safe state"}},
        {{{"5F00sub3", kValue, "3000"}}, {}},
        {{{"5F00sub2", kValue, "501"}, {"5F00sub3", kValue, "3001"}},
         {"warning: 0x5F00:03: discrepancy time of 3001 us, expected at least 3002 us, 2 cycles with their tolerance, "
          "or "
          "late cycles may end in the device safe state"}},
        {{{"5F00sub9", kValue, "0x100000000"}},
         {"error: 0x5F00:09: value '0x100000000', expected a number from 0 to 4294967295 (UNSIGNED32)"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckObjects, ADeviceWithoutSrdo)
{
    Verifies(req::SRS_CLI_017);
    const std::string object = "[1000]\nDataType=7\nAccessType=ro\n[OptionalObjects]\nSupportedObjects=1\n1=0x1000\n";
    const std::string unlisted =
        "warning: no section [MandatoryObjects], expected one that lists 0x1000, 0x1001 and 0x1018";
    EXPECT_EQ(
        test::FindingsOf("[DeviceInfo]\n" + object, {9U, {}}),
        (Lines{unlisted,
               "warning: no SRDO, nothing of CANopen Safety is checked, expected communication parameters at 0x1301 "
               "to 0x1340"}));
    EXPECT_EQ(test::FindingsOf("[DeviceInfo]\nCANopenSafetySupported=1\n" + object, {9U, {}}),
              (Lines{unlisted,
                     "error: CANopenSafetySupported is 1 and there is no SRDO, expected communication parameters at "
                     "0x1301 to 0x1340"}));
}

TEST(CheckObjects, ASafetyObjectWithoutSrdoIsAnErrorAtItsLine)
{
    Verifies(req::SRS_CLI_033);
    const std::string device = "[DeviceInfo]\n[1000]\nDataType=7\nAccessType=ro\n";
    for (const std::string index : {"1300", "13FE", "13FF", "13FD"})
    {
        const std::string object = "[" + index + "]\nDataType=5\nAccessType=rw\nDefaultValue=0\n";
        const std::string expected = "error: 0x" + index +
                                     ": a safety object and no SRDO, expected communication parameters at 0x1301 to "
                                     "0x1340";
        const std::vector<std::string> found = test::FindingsOf(device + object, {});
        EXPECT_NE(std::find(found.begin(), found.end(), expected), found.end()) << index;
    }
    const std::string listed = device + "[OptionalObjects]\nSupportedObjects=1\n1=0x1300\n";
    const std::vector<Finding> found = CheckDevice(test::DeviceOf(listed), {});
    const auto error = std::find_if(found.begin(), found.end(), [](const Finding& finding)
                                    { return finding.text.find("a safety object and no SRDO") == 0U; });
    ASSERT_NE(error, found.end());
    EXPECT_EQ(error->place.line, 7U); // Of the list
    for (const std::string index : {"12FF", "1400"})
    {
        const std::string object = "[" + index + "]\nDataType=5\nAccessType=rw\nDefaultValue=0\n";
        for (const std::string& line : test::FindingsOf(device + object, {}))
        {
            EXPECT_EQ(line.find("error"), std::string::npos) << line;
        }
    }
}

TEST(CheckObjects, AllFindingsComeAtOnceInTheOrderOfTheirLines)
{
    Verifies(req::SRS_CLI_009);
    const std::string text = test::WithValues(test::ExampleText("sensor"), {{"1301sub4", kValue, "1"},
                                                                            {"1300", "HighLimit", "0"},
                                                                            {"1301sub5", kValue, "0x102"},
                                                                            {"1381sub4", kValue, "0x99990108"},
                                                                            {"5F03sub1", kValue, "9"}});
    std::size_t last = 0U;
    Lines objects;
    for (const Finding& finding : CheckDevice(test::DeviceOf(text), {}))
    {
        EXPECT_GE(finding.place.line, last);
        last = finding.place.line;
        objects.push_back(finding.object);
    }
    EXPECT_EQ(objects, (Lines{"0x1300:00", "0x1301:04", "0x1301:05", "0x1381:04", "0x1381:04", "0x13FE:00", "0x13FF:01",
                              "0x5F03:01", "0x5F04:00"}));
}

/// The sensor with 18 more objects of 8 bytes, so that totals and counts can be reached: 3000h:01 to 09 and 3100h.
std::string WithWideObjects(const std::string& type)
{
    std::string text = test::ExampleText("sensor");
    for (const char* index : {"3000", "3100"})
    {
        text += "\n[" + std::string(index) + "]\nParameterName=w\nObjectType=0x8\nSubNumber=10\n";
        for (int sub = 0; sub <= 9; ++sub)
        {
            const bool is_count = sub == 0;
            text += "\n[" + std::string(index) + "sub" + std::to_string(sub) +
                    "]\nDataType=" + (is_count ? "0x0005" : type) +
                    "\nAccessType=ro\nDefaultValue=" + (is_count ? "9" : "0") + "\nSRDOMapping=1\n";
        }
    }
    return test::Changed(text,
                         {{"SupportedObjects=8\n1=0x2000", "SupportedObjects=10\n9=0x3000\n10=0x3100\n1=0x2000"}});
}

/// The same with `pairs` pairs of entries of `bits` (two hexadecimal digits).
std::string WithPairs(const std::string& type, const int pairs, const std::string& bits)
{
    std::string text = WithWideObjects(type);
    std::vector<test::Set> values{{"1381sub0", kValue, std::to_string(2 * pairs)},
                                  {"1381", "SubNumber", std::to_string(1 + std::max(4, 2 * pairs))}};
    for (int pair = 1; pair <= pairs; ++pair)
    {
        for (int side = 0; side < 2; ++side)
        {
            const int sub = 2 * pair - 1 + side;
            const std::string section = "1381sub" + Hex(static_cast<std::uint64_t>(sub), 1).substr(2U);
            const std::string value =
                (side == 0 ? "0x3000" : "0x3100") + Hex(static_cast<std::uint64_t>(pair), 2).substr(2U) + bits;
            if (sub > 4)
            {
                text += "\n[" + section + "]\nDataType=0x0007\nAccessType=rw\n";
            }
            values.push_back({section, kValue, value});
        }
    }
    return test::SignedAgain(test::WithValues(text, values), std::nullopt);
}

std::vector<std::string> ErrorsOf(const std::string& text, const std::uint8_t granularity)
{
    CheckOptions options;
    options.granularity_bits = granularity;
    std::vector<std::string> findings;
    for (const std::string& finding : test::FindingsOf(text, options))
    {
        const bool is_follower = finding.find("error: 0x13FE:00: 0xA5") == 0U;
        if (!is_follower)
        {
            findings.push_back(finding);
        }
    }
    return findings;
}

TEST(CheckMapping, NumberOfEntries)
{
    Verifies(req::SRS_CLI_012);
    const std::vector<CheckRow> rows = {
        {{{"1381sub0", kValue, "2"}}, {}},
        {{{"1381sub0", kValue, "3"}},
         {"error: 0x1381:00: 3 mapping entries, expected an even number: one normal and one inverse entry a pair"}},
        {{{"1381sub0", kValue, "0"}}, {"error: 0x1381:00: no mapping entry in an SRDO that is on, expected 2 or more"}},
        {{{"1381sub0", kValue, "0"}, {"1301sub1", kValue, "0"}},
         {"warning: 0x1301:01: no SRDO is on: the device sends and receives none, and 'counterpoint monitor' watches "
          "none, expected 1 (producer) or 2 (consumer) in the direction of one"}},
        {{{"1381sub0", kValue, "130"}}, {"error: 0x1381:00: 130 mapping entries, expected at most 128"}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckMapping, TotalsOf64BitAndTheRoomFor16Entries)
{
    Verifies(req::SRS_CLI_012);
    EXPECT_EQ(ErrorsOf(WithPairs("0x001B", 1, "40"), 8U), std::vector<std::string>{});
    EXPECT_EQ(ErrorsOf(WithPairs("0x0005", 8, "08"), 8U), std::vector<std::string>{});
    EXPECT_EQ(ErrorsOf(WithPairs("0x0005", 9, "08"), 8U),
              (std::vector<std::string>{
                  "error: 0x1381:00: 18 mapping entries, expected at most 16, for which 0x5F00:0B gives room",
                  "error: 0x1381:00: 72 bit of normal data, expected at most 64 bit",
                  "error: 0x1381:00: 72 bit of inverse data, expected at most 64 bit"}));
    EXPECT_EQ(ErrorsOf(WithPairs("0x001B", 2, "40"), 8U),
              (std::vector<std::string>{"error: 0x1381:00: 128 bit of normal data, expected at most 64 bit",
                                        "error: 0x1381:00: 128 bit of inverse data, expected at most 64 bit"}));
}

TEST(CheckMapping, Granularity)
{
    Verifies(req::SRS_CLI_012);
    EXPECT_EQ(ErrorsOf(WithPairs("0x0001", 1, "01"), 1U), std::vector<std::string>{});
    EXPECT_EQ(
        ErrorsOf(WithPairs("0x0001", 1, "01"), 8U),
        (std::vector<std::string>{"error: 0x1381:01: length of 1 bit, expected a multiple of 8 bit (granularity)",
                                  "error: 0x1381:02: length of 1 bit, expected a multiple of 8 bit (granularity)"}));
    EXPECT_EQ(ErrorsOf(WithPairs("0x0007", 1, "20"), 32U), std::vector<std::string>{});
    EXPECT_EQ(ErrorsOf(WithPairs("0x0016", 1, "18"), 8U), std::vector<std::string>{});
    EXPECT_EQ(
        ErrorsOf(WithPairs("0x0016", 1, "18"), 16U),
        (std::vector<std::string>{"error: 0x1381:01: length of 24 bit, expected a multiple of 16 bit (granularity)",
                                  "error: 0x1381:02: length of 24 bit, expected a multiple of 16 bit (granularity)"}));
}

TEST(CheckMapping, WhatAnEntryNames)
{
    Verifies(req::SRS_CLI_013);
    const std::vector<CheckRow> rows = {
        {{{"1381sub1", kValue, "0x2FFF0108"}},
         {"error: 0x1381:01: mapped object 0x2FFF:01 is unknown, expected an object that the file describes"}},
        {{{"1381sub1", kValue, "0x20000308"}},
         {"error: 0x1381:01: mapped object 0x2000:03 is unknown, expected an object that the file describes"}},
        {{{"1381sub1", kValue, "0x00000000"}},
         {"error: 0x1381:01: length of 0 bit, expected a multiple of 8 bit (granularity)",
          "error: 0x1381:01: mapped object 0x0000:00 is unknown, expected an object that the file describes",
          "error: 0x1381:02: inverse entry of 8 bit, expected 0 bit as the normal entry before it"}},
        {{{"2000sub1", "SRDOMapping", "0"}},
         {"error: 0x1381:01: mapped object 0x2000:01 is not mappable (line 347), expected SRDOMapping=1, or "
          "PDOMapping=1 "
          "where there is no SRDOMapping"}},
        {{{"2000sub1", "SRDOMapping", "0"}, {"2000sub1", "PDOMapping", "1"}},
         {"error: 0x1381:01: mapped object 0x2000:01 is not mappable (line 347), expected SRDOMapping=1, or "
          "PDOMapping=1 "
          "where there is no SRDOMapping"}},
        {{{"2000sub1", "SRDOMapping", ""}, {"2000sub1", "PDOMapping", "1"}}, {}},
        {{{"2000sub1", "AccessType", "wo"}},
         {"error: 0x1381:01: mapped object 0x2000:01 has the wrong AccessType (line 351), expected ro, rw, rwr or "
          "const "
          "to be sent"}},
        {{{"2000sub1", "AccessType", "rwr"}}, {}},
        {{{"2000sub1", "AccessType", "rww"}},
         {"error: 0x1381:01: mapped object 0x2000:01 has the wrong AccessType (line 351), expected ro, rw, rwr or "
          "const "
          "to be sent"}},
        {{{"1381sub1", kValue, "0x20000110"}, {"1381sub2", kValue, "0x21000110"}},
         {"error: 0x1381:01: length of 16 bit, expected 8 bit, the length of 0x2000:01 (UNSIGNED8)",
          "error: 0x1381:02: length of 16 bit, expected 8 bit, the length of 0x2100:01 (UNSIGNED8)"}},
        {{{"2000sub1", "DataType", "0x000F"}, {"2000sub1", "InvertedSRAD", ""}},
         {"error: 0x1381:01: mapped object 0x2000:01 is of DOMAIN, expected a data type with a fixed length"}},
        {{{"1381sub1", kValue, "0x13810108"}},
         {"error: 0x1381:01: mapped object 0x1381:01 is not mappable (line 267), expected an object of the "
          "application, not of the safety functions",
          "error: 0x1381:01: length of 8 bit, expected 32 bit, the length of 0x1381:01 (UNSIGNED32)"}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckMapping, AccessOfReceivedObjects)
{
    Verifies(req::SRS_CLI_013);
    const std::string wrong =
        "error: 0x1381:02: mapped object 0x2300:01 has the wrong AccessType (line 384), expected rw, wo or rww to be "
        "received";
    const std::vector<CheckRow> rows = {
        {{{"2300sub1", "AccessType", "rw"}}, {}},       {{{"2300sub1", "AccessType", "wo"}}, {}},
        {{{"2300sub1", "AccessType", "ro"}}, {wrong}},  {{{"2300sub1", "AccessType", "const"}}, {wrong}},
        {{{"2300sub1", "AccessType", "rwr"}}, {wrong}},
    };
    test::ExpectRows("actuator", rows, {});
}

TEST(CheckMapping, NormalAndInverseAreDifferentObjectsOfEqualLength)
{
    Verifies(req::SRS_CLI_014);
    const std::vector<CheckRow> rows = {
        {{{"1381sub2", kValue, "0x20000108"}, {"2000sub1", "InvertedSRAD", ""}},
         {"error: 0x1381:02: object 0x2000:01 is normal and inverse data of SRDO 1, expected another object than in "
          "sub-index 1"}},
        {{{"1381sub4", kValue, "0x20000108"}, {"2000sub2", "InvertedSRAD", ""}},
         {"error: 0x1381:04: inverse entry 0x2000:01 has an InvertedSRAD of its own (line 355), as normal data has, "
          "expected inverse data of 0x2000:02",
          "error: 0x1381:04: object 0x2000:01 is normal and inverse data of SRDO 1, expected another object than in "
          "sub-index 1"}},
        {{{"1381sub3", kValue, "0x20000108"}, {"2000sub1", "InvertedSRAD", ""}},
         {"error: 0x1381:03: object 0x2000:01 is mapped twice, expected another object than in sub-index 1"}},
        {{{"1381sub2", kValue, "0x21000208"}, {"1381sub4", kValue, "0x21000108"}},
         {"error: 0x1381:02: inverse entry 0x2100:02, expected 0x2100:01, the InvertedSRAD of 0x2000:01 (line 355)",
          "error: 0x1381:04: inverse entry 0x2100:01, expected 0x2100:02, the InvertedSRAD of 0x2000:02 (line 365)"}},
        {{{"1381sub2", kValue, "0x21000208"},
          {"1381sub4", kValue, "0x21000108"},
          {"2000sub1", "InvertedSRAD", ""},
          {"2000sub2", "InvertedSRAD", "0"}},
         {}},
        {{{"2000sub1", "DataType", "6"}, {"1381sub1", kValue, "0x20000110"}, {"2000sub1", "InvertedSRAD", ""}},
         {"error: 0x1381:02: inverse entry of 8 bit, expected 16 bit as the normal entry before it"}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckMapping, InvertedSradNamesAnotherObjectOfTheSameType)
{
    Verifies(req::SRS_CLI_014);
    const std::vector<CheckRow> rows = {
        {{{"5F00sub1", "InvertedSRAD", "0x5F0001"}},
         {"error: 0x5F00:01: InvertedSRAD 0x5F00:01 names the object itself, expected another object"}},
        {{{"5F00sub1", "InvertedSRAD", "0x777701"}},
         {"error: 0x5F00:01: InvertedSRAD 0x7777:01 names an unknown object, expected an object that the file "
          "describes"}},
        {{{"5F00sub1", "InvertedSRAD", "0x200001"}},
         {"error: 0x1381:01: normal entry 0x2000:01 is the InvertedSRAD of 0x5F00:01 (line 417) and has one itself "
          "(line 355), expected one of the two",
          "error: 0x5F00:01: InvertedSRAD 0x2000:01 is of UNSIGNED8, expected the same data type, UNSIGNED32"}},
        {{{"5F00sub1", "InvertedSRAD", "0x5F0002"}, {"5F00sub2", "InvertedSRAD", "0x5F0001"}}, {}},
    };
    test::ExpectRows("sensor", rows, {});
}

TEST(CheckMapping, DummyObjects)
{
    Verifies(req::SRS_CLI_015);
    const std::vector<CheckRow> consumer = {
        {{{"1381sub3", kValue, "0x00050008"}, {"1381sub4", kValue, "0x00050008"}}, {}},
        {{{"1381sub4", kValue, "0x00050008"}, {"2200sub2", "InvertedSRAD", ""}},
         {"error: 0x1381:04: dummy object on one side of the pair only, expected normal and inverse data to be "
          "stored "
          "both or not at all"}},
        {{{"1381sub3", kValue, "0x00020008"}, {"1381sub4", kValue, "0x00020008"}},
         {"error: 0x1381:03: dummy object 0x0002:00 is not mappable, expected a data type 0x0001 to 0x0007 that "
          "[DummyUsage] allows, "
          "with sub-index 0",
          "error: 0x1381:04: dummy object 0x0002:00 is not mappable, expected a data type 0x0001 to 0x0007 that "
          "[DummyUsage] allows, "
          "with sub-index 0"}},
        {{{"1381sub3", kValue, "0x00050008"}, {"1381sub4", kValue, "0x00050108"}},
         {"error: 0x1381:04: dummy object 0x0005:01 is not mappable, expected a data type 0x0001 to 0x0007 that "
          "[DummyUsage] allows, "
          "with sub-index 0"}},
        {{{"1381sub3", kValue, "0x00060008"}, {"1381sub4", kValue, "0x00050008"}},
         {"error: 0x1381:03: length of 8 bit, expected 16 bit of the dummy object"}},
    };
    test::ExpectRows("actuator", consumer, {});
    const std::vector<CheckRow> producer = {
        {{{"1381sub3", kValue, "0x00050008"}, {"1381sub4", kValue, "0x00050008"}},
         {"error: 0x1381:03: dummy object 0x0005:00 in a producer, expected an object with data to send",
          "error: 0x1381:04: dummy object 0x0005:00 in a producer, expected an object with data to send"}},
    };
    test::ExpectRows("sensor", producer, {});
}
} // namespace
} // namespace counterpoint::cia306
