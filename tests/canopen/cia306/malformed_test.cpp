// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{

using test::RefusalOf;

struct Row
{
    std::string text;
    std::string refusal;
};

constexpr const char* kObject = "[1000]\nDataType=7\nAccessType=ro\n";

TEST(Malformed, LinesAreRefusedWithTheirNumberAndWhatWasExpected)
{
    Verifies(req::SRS_EDS_016);
    const Row rows[] = {
        {"hello\n",
         "test.dcf:1:1: error: 'hello' is no line of an EDS, expected [section], key=value or a comment that "
         "begins with ';'"},
        {"[A]\nk=v\n\ngarbage here\n", "test.dcf:4:1: error: 'garbage here' is no line of an EDS, expected [section], "
                                       "key=value or a comment that begins with ';'"},
        {"k=v\n[A]\n", "test.dcf:1:1: error: key 'k' before the first section, expected a section such as [FileInfo] "
                       "before it"},
        {"[A]\n[1000\nk=v\n", "test.dcf:2:1: error: section '[1000' is not closed, expected ']' at its end"},
        {"[A] x\n", "test.dcf:1:5: error: text 'x' after the section name, expected nothing after ']'"},
        {"[]\n", "test.dcf:1:1: error: section name '', expected a name such as [DeviceInfo] or [1000sub0]"},
        {"[[A]\n", "test.dcf:1:1: error: section name '[A', expected a name such as [DeviceInfo] or [1000sub0]"},
        {"[A]\n=5\n", "test.dcf:2:1: error: a value without a key, expected key=value"},
        {"[A]\nk=1\n[B]\n[a]\n",
         "test.dcf:4:1: error: section 'a' stands a second time, expected it once, as in line 1"},
        {"[A]\nk=1\nK=2\n", "test.dcf:3:1: error: key 'K' stands a second time in section 'A', expected it once, as in "
                            "line 2"},
        {std::string("[A]\nk=\0\n", 8U), "test.dcf:2:3: error: control byte 0x00, expected 8-bit text"},
        {"[A]\nk=\x1B[0m\n", "test.dcf:2:3: error: control byte 0x1B, expected 8-bit text"},
        {"[A]\rk=v\n", "test.dcf:1:4: error: control byte 0x0D, expected lines that end in LF or CR LF"},
        {"\x7F"
         "ELF",
         "test.dcf:1:1: error: control byte 0x7F, expected 8-bit text"},
        {"\xFF\xFE[\0", "test.dcf:1:1: error: the text is UTF-16, expected 8-bit text (ASCII, Latin-1 or UTF-8)"},
        {"", "test.dcf:1:1: error: the file describes no object, expected sections such as [1000]"},
        {"[DeviceInfo]\n\n", "test.dcf:2:1: error: the file describes no object, expected sections such as [1000]"},
    };
    for (const Row& row : rows)
    {
        EXPECT_EQ(RefusalOf(row.text), row.refusal) << row.text;
    }
}

TEST(Malformed, StructureIsRefusedWithLineAndWhatWasExpected)
{
    Verifies(req::SRS_EDS_009);
    Verifies(req::SRS_EDS_016);
    const Row rows[] = {
        {"[1000]\nDataType=seven\n", "test.dcf:2:10: error: 'DataType' is 'seven', expected a number from 0 to 65535"},
        {"[1000]\nDataType=0x10000\n",
         "test.dcf:2:10: error: 'DataType' is '0x10000', expected a number from 0 to 65535"},
        {"[1000]\nObjectType=3\n",
         "test.dcf:2:12: error: 'ObjectType' is '3', expected 0x2 (DOMAIN), 0x5, 0x6, 0x7 (VAR), "
         "0x8 (ARRAY) or 0x9 (RECORD)"},
        {"[1000]\nObjectType=10\n", "test.dcf:2:12: error: 'ObjectType' is '10', expected a number from 0 to 9"},
        {"[1000]\nAccessType=read\n",
         "test.dcf:2:12: error: 'AccessType' is 'read', expected ro, wo, rw, rwr, rww or const"},
        {"[1000]\nPDOMapping=2\n", "test.dcf:2:12: error: 'PDOMapping' is '2', expected a number from 0 to 1"},
        {"[1000]\nSRDOMapping=yes\n", "test.dcf:2:13: error: 'SRDOMapping' is 'yes', expected a number from 0 to 1"},
        {"[1000]\nInvertedSRAD=0x1000000\n", "test.dcf:2:14: error: 'InvertedSRAD' is '0x1000000', expected index and "
                                             "sub-index of the inverse object as one number, such as 0x210001"},
        {"[1000]\nSubNumber=257\n", "test.dcf:2:11: error: 'SubNumber' is '257', expected a number from 0 to 256"},
        {"[1000]\nCompactSubObj=255\n",
         "test.dcf:2:15: error: 'CompactSubObj' is '255', expected a number from 0 to 254"},
        {"[1000]\nSubNumber=-1\n", "test.dcf:2:11: error: 'SubNumber' is '-1', expected a number from 0 to 256"},
        {"[1018sub1]\nDataType=7\n", "test.dcf:1:1: error: section '1018sub1' belongs to no object, expected a section "
                                     "[1018]"},
        {"[1018]\nSubNumber=2\n[1018sub1]\nDataType=7\n[1018sub01]\nDataType=7\n",
         "test.dcf:5:1: error: sub-index 0x1018:01 is described a second time, expected it once, as in line 3"},
        {"[1381]\nDataType=7\nCompactSubObj=2\n[1381Value]\n1=1\n0x1=2\n",
         "test.dcf:6:5: error: 0x1381:01 has a second value, expected it once, as in line 5"},
        {std::string("[DeviceComissioning]\nNodeID=128\n") + kObject,
         "test.dcf:2:8: error: 'NodeID' is '128', expected a node-ID from 1 to 127, or 255 for none"},
        {std::string("[DeviceComissioning]\nNodeID=254\n") + kObject,
         "test.dcf:2:8: error: 'NodeID' is '254', expected a node-ID from 1 to 127, or 255 for none"},
        {std::string("[DeviceComissioning]\nNodeID=256\n") + kObject,
         "test.dcf:2:8: error: 'NodeID' is '256', expected a number from 0 to 255"},
        {std::string("[DeviceComissioning]\nNodeID=one\n") + kObject,
         "test.dcf:2:8: error: 'NodeID' is 'one', expected a number from 0 to 255"},
        {std::string("[DeviceComissioning]\nNodeID=1\n[DeviceCommissioning]\nNodeID=2\n") + kObject,
         "test.dcf:3:1: error: the commissioning section stands a second time, expected it once, as in line 1"},
        {std::string("[DeviceInfo]\nCANopenSafetySupported=2\n") + kObject,
         "test.dcf:2:24: error: 'CANopenSafetySupported' is '2', expected a number from 0 to 1"},
        {std::string("[OptionalObjects]\nSupportedObjects=1\n1=0x10000\n") + kObject,
         "test.dcf:3:3: error: '1' is '0x10000', expected a number from 0 to 65535"},
        {std::string("[OptionalObjects]\nSupportedObjects=many\n") + kObject,
         "test.dcf:2:18: error: 'SupportedObjects' is 'many', expected a number from 0 to 65535"},
        {std::string("[DummyUsage]\nDummy0005=2\n") + kObject,
         "test.dcf:2:11: error: 'Dummy0005' is '2', expected a number from 0 to 1"},
    };
    for (const Row& row : rows)
    {
        EXPECT_EQ(RefusalOf(row.text), row.refusal) << row.text;
    }
}

TEST(Malformed, TheNearMissOfEachIsRead)
{
    Verifies(req::SRS_EDS_016);
    const std::string texts[] = {
        std::string("[DeviceComissioning]\nNodeID=127\n") + kObject,
        "[1000]\nDataType=0xFFFF\n",
        "[1000]\nInvertedSRAD=0xFFFFFF\n",
        "[1000]\nSubNumber=256\n",
        "[1000]\nCompactSubObj=254\nDataType=7\n",
        "[1018]\nSubNumber=2\n[1018sub1]\nDataType=7\n[1018sub10]\nDataType=7\n",
        "[A]\nk=\t\xE4\n[1000]\n",
    };
    for (const std::string& text : texts)
    {
        EXPECT_EQ(RefusalOf(text), "") << text;
    }
}

TEST(Malformed, TooManyLinesAreRefused)
{
    Verifies(req::SRS_EDS_018);
    const std::string object = "[1000]\n";
    EXPECT_EQ(RefusalOf(object + std::string(399999U, '\n')), "");
    EXPECT_EQ(RefusalOf(object + std::string(400000U, '\n')),
              "test.dcf:400001:1: error: there is a line more, expected at most 400000 lines");
}

TEST(Malformed, TooLongALineIsRefused)
{
    Verifies(req::SRS_EDS_018);
    EXPECT_EQ(RefusalOf("[1000]\n;" + std::string(65533U, 'x') + "\n"), "");
    EXPECT_EQ(RefusalOf("[1000]\n;" + std::string(65534U, 'x') + "\n"),
              "test.dcf:2:1: error: the line has more than 65535 bytes, expected shorter lines (CiA 306: 255)");
    // A binary file seldom has lines; what is wrong with it is the byte.
    EXPECT_EQ(RefusalOf(std::string(70000U, '\0')), "test.dcf:1:1: error: control byte 0x00, expected 8-bit text");
}

TEST(Malformed, TooManySubIndicesAreRefused)
{
    Verifies(req::SRS_EDS_018);
    std::string text;
    for (int index = 0x2000; index < 0x2400; ++index)
    {
        text += "[" + test::HexIndex(index) + "]\nDataType=7\nCompactSubObj=254\n";
    }
    EXPECT_EQ(RefusalOf(text), "test.dcf:2353:1: error: there is a sub-index more, expected at most 200000");
    // 784 of them, with 255 sub-indices each, are 199920
    EXPECT_EQ(RefusalOf(text.substr(0U, text.find("[2310]"))), "");
}

TEST(Malformed, EveryTruncationOfAnExampleIsReadOrRefusedByOneLine)
{
    Verifies(req::SRS_EDS_025);
    const std::string text = test::ExampleText("sensor");
    std::size_t read = 0U;
    std::size_t refused = 0U;
    for (std::size_t length = 0U; length <= text.size(); length += 7U)
    {
        const std::string refusal = RefusalOf(text.substr(0U, length));
        const bool is_read = refusal.empty();
        read += is_read ? 1U : 0U;
        refused += is_read ? 0U : 1U;
        EXPECT_EQ(refusal.find('\n'), std::string::npos);
        EXPECT_TRUE(is_read || refusal.rfind("test.dcf:", 0U) == 0U) << refusal;
        EXPECT_TRUE(is_read || refusal.find(", expected ") != std::string::npos) << refusal;
    }
    EXPECT_GT(read, 100U);
    EXPECT_GT(refused, 100U);
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

/// The first error of the check that is no consequence of 13FEh.
std::string FirstError(const std::string& text)
{
    for (const Finding& finding : CheckDevice(test::DeviceOf(text), {}))
    {
        if (finding.severity == Severity::kError && finding.object != "0x13FE:00")
        {
            return FormatFinding("test.dcf", finding);
        }
    }
    return "";
}

/// A file of tests/canopen/cia306/data, what is changed in it, more text behind it, and the answer.
struct FileRow
{
    std::string file;
    std::string from;
    std::string to;
    std::string more;
    std::string answer;
};

std::string TextOf(const FileRow& row)
{
    const std::string text = test::FileText(row.file);
    return (row.from.empty() ? text : test::Changed(text, {{row.from, row.to}})) + row.more;
}

TEST(MalformedWide, WhatCannotBeSignedIsRefusedByOneLine)
{
    Verifies(req::SRS_EDS_016);
    Verifies(req::SRS_EDS_024);
    Verifies(req::SRS_CLI_021);
    const FileRow rows[] = {
        {"bits", "ParameterValue=128\n", "ParameterValue=129\n", "",
         "test.dcf:257:16: error: 0x1381:00: 129 mapping entries, expected at most 128"},
        {"bits", "ParameterValue=128\n", "ParameterValue=129\n",
         "\n[1381sub81]\nDataType=7\nAccessType=rw\nDefaultValue=0x60200101\n",
         "test.dcf:257:16: error: 0x1381:00: 129 mapping entries, expected at most 128"},
        {"static", "DefaultValue=16\n", "DefaultValue=130\n", "",
         "test.dcf:212:14: error: 0x1381:00: 130 mapping entries, expected at most 128"},
        {"static", "DefaultValue=16\n", "DefaultValue=18\n", "",
         "test.dcf:202:1: error: 0x1381:11: is missing, expected an object of type UNSIGNED32"},
        {"static", "DefaultValue=16\n", "DefaultValue=256\n", "",
         "test.dcf:212:14: error: 0x1381:00: value '256', expected a number from 0 to 255 (UNSIGNED8)"},
        {"bits", "", "", "\n[1381SUB80]\nDataType=7\n",
         "test.dcf:2739:1: error: section '1381SUB80' stands a second time, expected it once, as in line 1403"},
        {"bits", "ParameterValue=0x60200101\n", "ParameterValue=0x6020:01\n", "",
         "test.dcf:266:16: error: 0x1381:01: value '0x6020:01', expected a number from 0 to 4294967295 (UNSIGNED32), "
         "or "
         "$NODEID+number"},
        {"bits", "ParameterValue=0x60200101\n", "ParameterValue=0x160200101\n", "",
         "test.dcf:266:16: error: 0x1381:01: value '0x160200101', expected a number from 0 to 4294967295 (UNSIGNED32)"},
        {"bits", "DataType=0x0041\n\n[2100sub0]", "DataType=door\n\n[2100sub0]", "",
         "test.dcf:1524:10: error: 'DataType' is 'door', expected a number from 0 to 65535"},
        {"dummies", "Dummy0003=1", "Dummy0003=2", "",
         "test.dcf:26:11: error: 'Dummy0003' is '2', expected a number from 0 to 1"},
        {"digest", "digest\nObjectType=0x7\nDataType=0x0007", "digest\nObjectType=0x7\nDataType=0x0006", "",
         "test.dcf:675:10: error: 0x5F04:00: DataType is 0x0006 (UNSIGNED16), expected 0x0007 (UNSIGNED32)"},
        {"digest", "digest\nObjectType=0x7\n", "digest\nObjectType=0x8\n", "",
         "test.dcf:672:1: error: 0x5F04:00: is missing, expected an object of type UNSIGNED32"},
        {"digest", "0x5F9AFA3D", "-1", "",
         "test.dcf:678:16: error: 0x5F04:00: value '-1', expected a number from 0 to 4294967295 (UNSIGNED32), or "
         "$NODEID+number"},
        {"digest", "ParameterValue=2000\n", "ParameterValue=4294967296\n", "",
         "test.dcf:441:16: error: 0x5F00:01: value '4294967296', expected a number from 0 to 4294967295 (UNSIGNED32)"},
    };
    for (const FileRow& row : rows)
    {
        EXPECT_EQ(RefusalOfSigning(TextOf(row)), row.answer) << row.file << " " << row.to;
    }
}

TEST(MalformedWide, TheCheckNamesTheLine)
{
    Verifies(req::SRS_CLI_009);
    Verifies(req::SRS_CLI_012);
    Verifies(req::SRS_CLI_015);
    const FileRow rows[] = {
        {"bits", "ParameterValue=128\n", "ParameterValue=130\n", "",
         "test.dcf:257:16: error: 0x1381:00: 130 mapping entries, expected at most 128"},
        {"dummies", "ParameterValue=0x00020008\nPDOMapping=0\n\n[1381sub6]",
         "ParameterValue=0x00020007\nPDOMapping=0\n\n[1381sub6]", "",
         "test.dcf:256:16: error: 0x1381:05: length of 7 bit, expected 8 bit of the dummy object"},
        {"bits", "ParameterValue=0x60204001", "ParameterValue=0x60204041", "",
         "test.dcf:257:16: error: 0x1381:00: 128 bit of normal data, expected at most 64 bit"},
        {"static", "DefaultValue=16\n", "DefaultValue=130\n", "",
         "test.dcf:212:14: error: 0x1381:00: 130 mapping entries, expected at most 128"},
        {"digest", "digest\nObjectType=0x7\n", "digest\nObjectType=0x8\n", "",
         "test.dcf:672:1: error: 0x5F04:00: is missing, expected an object of type UNSIGNED32"},
    };
    for (const FileRow& row : rows)
    {
        EXPECT_EQ(FirstError(TextOf(row)), row.answer) << row.file << " " << row.to;
    }
}

TEST(MalformedWide, ACompactMappingIsNotTakenForAStaticOne)
{
    Verifies(req::SRS_EDS_029);
    Verifies(req::SRS_CLI_023);
    // Given a compact mapping, whose sub-index 0 is ro by itself, with entries that can be written
    const std::string text = test::FileText("compact");
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
        const std::string text = test::FileText(name);
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
