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

// A plain device of one record; what is told besides is left out
std::vector<std::string> ToldOf(const std::string& text, const std::string& about)
{
    std::vector<std::string> told;
    for (const std::string& finding : test::FindingsOf("[DeviceInfo]\nLSS_Supported=1\n" + text, {}))
    {
        if (finding.find(about) != std::string::npos)
        {
            told.push_back(finding);
        }
    }
    return told;
}

TEST(CheckObjects, WhatEveryDeviceHas)
{
    Verifies(req::SRS_CLI_038);
    const std::string expected = ", expected 0x1000, 0x1001 and 0x1018, which every device has";
    const std::string list = "[MandatoryObjects]\nSupportedObjects=0\n";
    const auto variable = [](const std::string& index)
    { return "[" + index + "]\nDataType=7\nAccessType=ro\nDefaultValue=0\n"; };
    EXPECT_EQ(ToldOf(list + variable("1000") + variable("1001") + variable("1018"), "without"),
              std::vector<std::string>{});
    EXPECT_EQ(ToldOf(list + variable("1001") + variable("1018"), "without"),
              std::vector<std::string>{"warning: [MandatoryObjects] without 0x1000" + expected});
    EXPECT_EQ(ToldOf(list + variable("2000"), "without"),
              std::vector<std::string>{"warning: [MandatoryObjects] without 0x1000 0x1001 0x1018" + expected});
    // One that a list names has its own warning, and without the list each object has one.
    EXPECT_EQ(
        ToldOf("[MandatoryObjects]\nSupportedObjects=1\n1=0x1018\n" + variable("1000"), "0x10"),
        (std::vector<std::string>{"warning: [MandatoryObjects] without 0x1001" + expected,
                                  "warning: 0x1018: is listed, expected a section that describes it",
                                  "warning: 0x1000: is in none of the lists [MandatoryObjects], [OptionalObjects], "
                                  "[ManufacturerObjects]"}));
    EXPECT_EQ(ToldOf(variable("2000"), "without"), std::vector<std::string>{});
}

TEST(CheckObjects, SubIndexZeroIsTheHighest)
{
    Verifies(req::SRS_CLI_039);
    const auto record = [](const std::string& index, const std::string& access, const std::string& count)
    {
        const std::string element = "]\nDataType=5\nAccessType=";
        return "[" + index + "]\nObjectType=9\nSubNumber=4\n[" + index + "sub0" + element + access +
               "\nDefaultValue=" + count + "\n[" + index + "sub1" + element + "rw\nDefaultValue=1\n[" + index + "subA" +
               element + "rw\nDefaultValue=1\n[" + index + "subFF" + element + "ro\nDefaultValue=1\n";
    };
    const std::string expected = ", expected 10, the highest one that the file describes";
    EXPECT_EQ(ToldOf(record("2000", "const", "10"), "highest"), std::vector<std::string>{});
    EXPECT_EQ(ToldOf(record("2000", "const", "9"), "highest"),
              std::vector<std::string>{"warning: 0x2000:00: highest sub-index 9" + expected});
    EXPECT_EQ(ToldOf(record("9FFF", "ro", "11"), "highest"),
              std::vector<std::string>{"warning: 0x9FFF:00: highest sub-index 11" + expected});
    // A list that grows may be shorter, never longer; 1FFFh has services of its own.
    EXPECT_EQ(ToldOf(record("2000", "rw", "1"), "highest"), std::vector<std::string>{});
    EXPECT_EQ(ToldOf(record("2000", "rw", "11"), "highest"),
              std::vector<std::string>{"warning: 0x2000:00: highest sub-index 11" + expected});
    EXPECT_EQ(ToldOf(record("1FFF", "const", "9"), "highest"), std::vector<std::string>{});
    EXPECT_EQ(ToldOf(record("2000", "const", ""), "highest"), std::vector<std::string>{});
}

TEST(CheckObjects, AccessRightsThatTheKernelDoesNotFollow)
{
    Verifies(req::SRS_CLI_040);
    const std::string told = " the device lets clients read and write it all the same, expected AccessType=rw";
    const std::string access = "AccessType";
    const std::vector<CheckRow> rows = {
        {{{"1300", access, "const"}}, {"warning: 0x1300:00:" + told}},
        {{{"1301sub1", access, "ro"}, {"1301sub3", access, "wo"}},
         {"warning: 0x1301:01:" + told, "warning: 0x1301:03:" + told}},
        {{{"1301sub2", access, "const"}, {"1301sub5", access, "ro"}},
         {"warning: 0x1301:02:" + told, "warning: 0x1301:05:" + told}},
        {{{"1301sub6", access, "const"}}, {"warning: 0x1301:06:" + told}},
        {{{"13FFsub1", access, "ro"}}, {"warning: 0x13FF:01:" + told}},
        // Constants of the kernel.
        {{{"1301sub0", access, "ro"}, {"1301sub4", access, "ro"}, {"13FFsub0", access, "ro"}}, {}},
    };
    test::ExpectRows("sensor", rows, {});
}

// The first and the last SRDO and signature, and what lies beside them.
TEST(CheckObjects, AccessRightsOfTheLastSrdoAsOfTheFirst)
{
    Verifies(req::SRS_CLI_040);
    const auto told = [](const std::string& index, const std::string& sub)
    {
        const std::string element = "]\nDataType=5\nAccessType=const\nDefaultValue=0\n";
        const std::string text = "[" + index + "]\nObjectType=9\nSubNumber=2\n[" + index + "sub0" + element + "[" +
                                 index + "sub" + sub + element;
        return ToldOf(text, "the device lets clients read and write it all the same").size();
    };
    for (const std::string index : {"1301", "1302", "133F", "1340"})
    {
        for (const std::string sub : {"1", "2", "3", "5", "6"})
        {
            EXPECT_EQ(told(index, sub), 1U) << index << ":" << sub;
        }
        EXPECT_EQ(told(index, "4"), 0U) << index;
        EXPECT_EQ(told(index, "7"), 0U) << index;
    }
    for (const std::string sub : {"1", "2", "3F", "40"})
    {
        EXPECT_EQ(told("13FF", sub), 1U) << sub;
    }
    EXPECT_EQ(told("13FF", "41"), 0U);
    EXPECT_EQ(told("1341", "1"), 0U);
}
} // namespace
} // namespace counterpoint::cia306
