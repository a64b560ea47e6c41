// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

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
    const std::vector<CheckRow> rows = {
        {{{"13FE", kValue, "0"}}, {"warning: 0x13FE:00: 0x00: the SRDOs stay off, expected 0xA5 to set them going"}},
        {{{"13FE", kValue, "0x5A"}}, {"warning: 0x13FE:00: 0x5A: the SRDOs stay off, expected 0xA5 to set them going"}},
        {{{"13FE", "AccessType", "ro"}},
         {"warning: 0x13FE:00: the flag cannot be set and cleared, expected AccessType=rw"}},
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
        {{{"5F00sub9", kValue, "0x100000000"}},
         {"error: 0x5F00:09: value '0x100000000', expected a number from 0 to 4294967295 (UNSIGNED32)"}},
    };
    test::ExpectRows("controller", rows, {});
}

TEST(CheckObjects, ADeviceWithoutSrdo)
{
    Verifies(req::SRS_CLI_017);
    const std::string object = "[1000]\nDataType=7\nAccessType=ro\n[MandatoryObjects]\nSupportedObjects=1\n1=0x1000\n";
    EXPECT_EQ(
        test::FindingsOf("[DeviceInfo]\n" + object, {}),
        Lines{"warning: no SRDO, nothing of CANopen Safety is checked, expected communication parameters at 0x1301 "
              "to 0x1340"});
    EXPECT_EQ(test::FindingsOf("[DeviceInfo]\nCANopenSafetySupported=1\n" + object, {}),
              Lines{"error: CANopenSafetySupported is 1 and there is no SRDO, expected communication parameters at "
                    "0x1301 to 0x1340"});
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
        EXPECT_GE(finding.line, last);
        last = finding.line;
        objects.push_back(finding.object);
    }
    EXPECT_EQ(objects, (Lines{"0x1300:00", "0x1301:04", "0x1301:05", "0x1381:04", "0x1381:04", "0x13FE:00", "0x13FF:01",
                              "0x5F03:01", "0x5F04:00"}));
}
} // namespace
} // namespace counterpoint::cia306
