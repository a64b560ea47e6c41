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
std::string FileText(const std::string& name)
{
    return ReadTextFile(test::SourceFolder() + "/tests/canopen/cia306/data/" + name + ".dcf");
}

/// The one line with which signing is refused.
std::string RefusalOfSigning(const std::string& text)
{
    try
    {
        const IniDocument document = IniDocument::Parse("test.dcf", text);
        const Device device = ReadDevice(document);
        (void)WithSignatures(document, device, device.node_id);
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

/// The first line of the check that is no consequence of 13FEh.
std::string FirstFinding(const std::string& text)
{
    for (const Finding& finding : CheckDevice(test::DeviceOf(text), {}))
    {
        if (finding.object != "0x13FE:00")
        {
            return FormatFinding("test.dcf", finding);
        }
    }
    return "";
}

/// A file of tests/canopen/cia306/data, what is changed in it, more text behind it, and the answer.
struct Row
{
    std::string file;
    std::string from;
    std::string to;
    std::string more;
    std::string answer;
};

std::string TextOf(const Row& row)
{
    const std::string text = FileText(row.file);
    return (row.from.empty() ? text : test::Changed(text, {{row.from, row.to}})) + row.more;
}

TEST(MalformedWide, WhatCannotBeSignedIsRefusedByOneLine)
{
    Verifies(req::SRS_EDS_016);
    Verifies(req::SRS_EDS_024);
    Verifies(req::SRS_CLI_021);
    const Row rows[] = {
        {"bits", "ParameterValue=128\n", "ParameterValue=129\n", "",
         "test.dcf:257: error: 0x1381:00: 129 mapping entries, expected at most 128"},
        {"bits", "ParameterValue=128\n", "ParameterValue=129\n",
         "\n[1381sub81]\nDataType=7\nAccessType=rw\nDefaultValue=0x60200101\n",
         "test.dcf:257: error: 0x1381:00: 129 mapping entries, expected at most 128"},
        {"static", "DefaultValue=16\n", "DefaultValue=130\n", "",
         "test.dcf:212: error: 0x1381:00: 130 mapping entries, expected at most 128"},
        {"static", "DefaultValue=16\n", "DefaultValue=18\n", "",
         "test.dcf:202: error: 0x1381:11: is missing, expected an object of type UNSIGNED32"},
        {"static", "DefaultValue=16\n", "DefaultValue=256\n", "",
         "test.dcf:212: error: 0x1381:00: value '256', expected a number from 0 to 255 (UNSIGNED8)"},
        {"bits", "", "", "\n[1381SUB80]\nDataType=7\n",
         "test.dcf:2710: error: section '1381SUB80' stands a second time, expected it once, as in line 1403"},
        {"bits", "ParameterValue=0x60200101\n", "ParameterValue=0x6020:01\n", "",
         "test.dcf:266: error: 0x1381:01: value '0x6020:01', expected a number from 0 to 4294967295 (UNSIGNED32), or "
         "$NODEID+number"},
        {"bits", "ParameterValue=0x60200101\n", "ParameterValue=0x160200101\n", "",
         "test.dcf:266: error: 0x1381:01: value '0x160200101', expected a number from 0 to 4294967295 (UNSIGNED32)"},
        {"bits", "DataType=0x0041\n\n[2100sub0]", "DataType=door\n\n[2100sub0]", "",
         "test.dcf:1524: error: 'DataType' is 'door', expected a number from 0 to 65535"},
        {"dummies", "Dummy0003=1", "Dummy0003=2", "",
         "test.dcf:26: error: 'Dummy0003' is '2', expected a number from 0 to 1"},
        {"digest", "digest\nObjectType=0x7\nDataType=0x0007", "digest\nObjectType=0x7\nDataType=0x0006", "",
         "test.dcf:672: error: 0x5F04:00: DataType is 0x0006 (UNSIGNED16), expected 0x0007 (UNSIGNED32)"},
        {"digest", "digest\nObjectType=0x7\n", "digest\nObjectType=0x8\n", "",
         "test.dcf:672: error: 0x5F04:00: is missing, expected an object of type UNSIGNED32"},
        {"digest", "0x5F9AFA3D", "-1", "",
         "test.dcf:678: error: 0x5F04:00: value '-1', expected a number from 0 to 4294967295 (UNSIGNED32), or "
         "$NODEID+number"},
        {"digest", "ParameterValue=2000\n", "ParameterValue=4294967296\n", "",
         "test.dcf:441: error: 0x5F00:01: value '4294967296', expected a number from 0 to 4294967295 (UNSIGNED32)"},
    };
    for (const Row& row : rows)
    {
        EXPECT_EQ(RefusalOfSigning(TextOf(row)), row.answer) << row.file << " " << row.to;
    }
}

TEST(MalformedWide, TheCheckNamesTheLine)
{
    Verifies(req::SRS_CLI_009);
    Verifies(req::SRS_CLI_012);
    Verifies(req::SRS_CLI_015);
    const Row rows[] = {
        {"bits", "ParameterValue=128\n", "ParameterValue=130\n", "",
         "test.dcf:257: error: 0x1381:00: 130 mapping entries, expected at most 128"},
        {"dummies", "ParameterValue=0x00020008\nPDOMapping=0\n\n[1381sub6]",
         "ParameterValue=0x00020007\nPDOMapping=0\n\n[1381sub6]", "",
         "test.dcf:256: error: 0x1381:05: length of 7 bit, expected 8 bit of the dummy object"},
        {"bits", "ParameterValue=0x60204001", "ParameterValue=0x60204041", "",
         "test.dcf:257: error: 0x1381:00: 128 bit of normal data, expected at most 64 bit"},
        {"static", "DefaultValue=16\n", "DefaultValue=130\n", "",
         "test.dcf:212: error: 0x1381:00: 130 mapping entries, expected at most 128"},
        {"digest", "digest\nObjectType=0x7\n", "digest\nObjectType=0x8\n", "",
         "test.dcf:672: error: 0x5F04:00: is missing, expected an object of type UNSIGNED32"},
    };
    for (const Row& row : rows)
    {
        EXPECT_EQ(FirstFinding(TextOf(row)), row.answer) << row.file << " " << row.to;
    }
}

TEST(MalformedWide, ACompactMappingIsNotTakenForAStaticOne)
{
    Verifies(req::SRS_EDS_029);
    Verifies(req::SRS_CLI_023);
    // Given a compact mapping, whose sub-index 0 is ro by itself, with entries that can be written
    const std::string text = FileText("compact");
    const Device device = test::DeviceOf(text);
    for (const SrdoConfiguration& srdo : ExtractSafety(device, device.node_id).srdos)
    {
        EXPECT_FALSE(srdo.is_static);
    }
    for (const std::string& line : test::FindingsOf(text, {}))
    {
        EXPECT_EQ(line.find("const or ro"), std::string::npos) << line;
    }
}

TEST(MalformedWide, EveryTruncationIsReadOrRefusedByOneLine)
{
    Verifies(req::SRS_EDS_025);
    for (const char* name : {"digest", "dummies", "static"})
    {
        const std::string text = FileText(name);
        for (std::size_t length = 0U; length <= text.size(); length += 97U)
        {
            const std::string refusal = RefusalOfSigning(text.substr(0U, length));
            EXPECT_EQ(refusal.find('\n'), std::string::npos);
            EXPECT_TRUE(refusal.empty() || refusal.rfind("test.dcf:", 0U) == 0U) << refusal;
        }
    }
}
} // namespace
} // namespace counterpoint::cia306
