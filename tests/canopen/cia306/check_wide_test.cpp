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
using Lines = std::vector<std::string>;
using test::Set;

constexpr const char* kValue = "ParameterValue";

std::string FileText(const std::string& name)
{
    return ReadTextFile(test::SourceFolder() + "/tests/canopen/cia306/data/" + name + ".dcf");
}

/// What the check finds in a file with these values, signed again, but for the line about 13FEh.
Lines Find(const std::string& text, const std::vector<Set>& values)
{
    Lines lines;
    for (const std::string& line :
         test::FindingsOf(test::SignedAgain(test::WithValues(text, values), std::nullopt), {}))
    {
        if (line.find("0xA5 marks a configuration with errors") == std::string::npos)
        {
            lines.push_back(line);
        }
    }
    return lines;
}

TEST(CheckStatic, WhatWouldBeWrittenIsFound)
{
    Verifies(req::SRS_CLI_023);
    const std::string text = FileText("static");
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
    EXPECT_EQ(Find(FileText("static"), {{"1381sub0", "AccessType", "rw"}}),
              Lines{"warning: 0x1381: 16 of 17 sub-indices are const or ro, expected all of them (static mapping) or "
                    "none"});
    // Those that sub-index 0 does not count are not asked
    EXPECT_EQ(Find(FileText("static"), {{"1383sub0", "DefaultValue", "4"}, {"1383sub6", "AccessType", "rw"}}), Lines{});
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
    EXPECT_EQ(Find(FileText("static"), bits),
              (Lines{"error: 0x1383:05: length of 1 bit in a static mapping, expected a multiple of 8 bit",
                     "error: 0x1383:06: length of 1 bit in a static mapping, expected a multiple of 8 bit"}));
    EXPECT_EQ(Find(FileText("static"), {{"DummyUsage", "Dummy0005", "1"},
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
    const std::string text = FileText("dummies");
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
    EXPECT_EQ(Find(FileText("digest"), dummies), Lines{});
    std::vector<Set> refused = dummies;
    refused.push_back({"5F00subC", kValue, "0"});
    EXPECT_EQ(Find(FileText("digest"), refused),
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
    Lines findings = Find(test::Changed(FileText("static"), {{"[1000]\n", "[5F00]\nObjectType=9\nSubNumber=1\n"
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
    EXPECT_EQ(find({{"5F00sub1", kValue, "1000001"}, {"1302sub2", kValue, "1001"}}),
              Lines{"error: 0x5F00:01: cycle time 1000001 us, expected 100 us to 1000000 us"});
    EXPECT_EQ(find({{"5F00sub2", kValue, "1000"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub2", kValue, "1001"}}),
              Lines{"error: 0x5F00:02: cycle tolerance of 1001 us, expected at most the cycle time of 1000 us"});
    EXPECT_EQ(find({{"5F00sub3", kValue, "0x3FFFFFFF"}}), Lines{});
    EXPECT_EQ(find({{"5F00sub3", kValue, "0x40000000"}}),
              Lines{"error: 0x5F00:03: discrepancy time of 1073741824 us, expected at most 1073741823 us"});
    EXPECT_EQ(find({{"5F00sub4", kValue, "4"}}), Lines{});
    EXPECT_EQ(
        find({{"5F00sub4", kValue, "3"}}),
        Lines{"error: 0x5F00:04: diagnostic interval of 3 ms, expected at least 4000 us, 2 cycles for each SRDO"});
    EXPECT_EQ(find({{"5F00sub4", kValue, "1073742"}}),
              Lines{"error: 0x5F00:04: interval of 1073742 ms, expected at most 1073741 ms"});
    EXPECT_EQ(find({{"5F00sub5", kValue, "0"}}),
              Lines{"error: 0x5F00:05: test interval of 0 ms, expected at least the cycle time of 1000 us"});
    EXPECT_EQ(find({{"5F00sub5", kValue, "1"}}), Lines{});
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
    EXPECT_EQ(find("5F00subA", "4").back(), "error: 0x5F00:0A: granularity of 4 bit, expected 1, 8, 16, 32 or 64 bit");
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

TEST(CheckParameters, GapsBetweenSrdoNumbers)
{
    Verifies(req::SRS_CLI_018);
    EXPECT_EQ(Find(FileText("digest"), {{"5F00subD", kValue, "0"}}),
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
