// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>

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
        {"hello\n", "test.dcf:1: error: 'hello' is no line of an EDS, expected [section], key=value or a comment that "
                    "begins with ';'"},
        {"[A]\nk=v\n\ngarbage here\n", "test.dcf:4: error: 'garbage here' is no line of an EDS, expected [section], "
                                       "key=value or a comment that begins with ';'"},
        {"k=v\n[A]\n", "test.dcf:1: error: key 'k' before the first section, expected a section such as [FileInfo] "
                       "before it"},
        {"[A]\n[1000\nk=v\n", "test.dcf:2: error: section '[1000' is not closed, expected ']' at its end"},
        {"[A] ; x\n", "test.dcf:1: error: text ' ; x' after the section name, expected nothing after ']'"},
        {"[]\n", "test.dcf:1: error: section name '', expected a name such as [DeviceInfo] or [1000sub0]"},
        {"[[A]\n", "test.dcf:1: error: section name '[A', expected a name such as [DeviceInfo] or [1000sub0]"},
        {"[A]\n=5\n", "test.dcf:2: error: a value without a key, expected key=value"},
        {"[A]\nk=1\n[B]\n[a]\n", "test.dcf:4: error: section 'a' stands a second time, expected it once, as in line 1"},
        {"[A]\nk=1\nK=2\n", "test.dcf:3: error: key 'K' stands a second time in section 'A', expected it once, as in "
                            "line 2"},
        {std::string("[A]\nk=\0\n", 8U), "test.dcf:2: error: control byte 0x00 in column 3, expected 8-bit text"},
        {"[A]\nk=\x1B[0m\n", "test.dcf:2: error: control byte 0x1B in column 3, expected 8-bit text"},
        {"[A]\rk=v\n", "test.dcf:1: error: control byte 0x0D in column 4, expected lines that end in LF or CR LF"},
        {"\x7F"
         "ELF",
         "test.dcf:1: error: control byte 0x7F in column 1, expected 8-bit text"},
        {"\xFF\xFE[\0", "test.dcf:1: error: the text is UTF-16, expected 8-bit text (ASCII, Latin-1 or UTF-8)"},
        {"", "test.dcf:1: error: the file describes no object, expected sections such as [1000]"},
        {"[DeviceInfo]\n\n", "test.dcf:2: error: the file describes no object, expected sections such as [1000]"},
    };
    for (const Row& row : rows)
    {
        EXPECT_EQ(RefusalOf(row.text), row.refusal) << row.text;
    }
}

TEST(Malformed, StructureIsRefusedWithLineAndWhatWasExpected)
{
    Verifies(req::SRS_EDS_016);
    const Row rows[] = {
        {"[1000]\nDataType=seven\n", "test.dcf:2: error: 'DataType' is 'seven', expected a number from 0 to 65535"},
        {"[1000]\nDataType=0x10000\n", "test.dcf:2: error: 'DataType' is '0x10000', expected a number from 0 to 65535"},
        {"[1000]\nObjectType=3\n",
         "test.dcf:2: error: 'ObjectType' is '3', expected 0x2 (DOMAIN), 0x5, 0x6, 0x7 (VAR), "
         "0x8 (ARRAY) or 0x9 (RECORD)"},
        {"[1000]\nObjectType=10\n", "test.dcf:2: error: 'ObjectType' is '10', expected a number from 0 to 9"},
        {"[1000]\nAccessType=read\n",
         "test.dcf:2: error: 'AccessType' is 'read', expected ro, wo, rw, rwr, rww or const"},
        {"[1000]\nPDOMapping=2\n", "test.dcf:2: error: 'PDOMapping' is '2', expected a number from 0 to 1"},
        {"[1000]\nSRDOMapping=yes\n", "test.dcf:2: error: 'SRDOMapping' is 'yes', expected a number from 0 to 1"},
        {"[1000]\nInvertedSRAD=0x1000000\n", "test.dcf:2: error: 'InvertedSRAD' is '0x1000000', expected index and "
                                             "sub-index of the inverse object as one number, such as 0x210001"},
        {"[1000]\nSubNumber=257\n", "test.dcf:2: error: 'SubNumber' is '257', expected a number from 0 to 256"},
        {"[1000]\nCompactSubObj=255\n", "test.dcf:2: error: 'CompactSubObj' is '255', expected a number from 0 to 254"},
        {"[1000]\nSubNumber=-1\n", "test.dcf:2: error: 'SubNumber' is '-1', expected a number from 0 to 256"},
        {"[1018sub1]\nDataType=7\n", "test.dcf:1: error: section '1018sub1' belongs to no object, expected a section "
                                     "[1018]"},
        {"[1018]\nSubNumber=2\n[1018sub1]\nDataType=7\n[1018sub01]\nDataType=7\n",
         "test.dcf:5: error: sub-index 0x1018:01 is described a second time, expected it once, as in line 3"},
        {"[1381]\nDataType=7\nCompactSubObj=2\n[1381Value]\n1=1\n0x1=2\n",
         "test.dcf:6: error: 0x1381:01 has a second value, expected it once, as in line 5"},
        {std::string("[DeviceComissioning]\nNodeID=128\n") + kObject,
         "test.dcf:2: error: 'NodeID' is '128', expected a node-ID from 1 to 127, or 255 for none"},
        {std::string("[DeviceComissioning]\nNodeID=256\n") + kObject,
         "test.dcf:2: error: 'NodeID' is '256', expected a number from 0 to 255"},
        {std::string("[DeviceComissioning]\nNodeID=one\n") + kObject,
         "test.dcf:2: error: 'NodeID' is 'one', expected a number from 0 to 255"},
        {std::string("[DeviceComissioning]\nNodeID=1\n[DeviceCommissioning]\nNodeID=2\n") + kObject,
         "test.dcf:3: error: the commissioning section stands a second time, expected it once, as in line 1"},
        {std::string("[DeviceInfo]\nCANopenSafetySupported=2\n") + kObject,
         "test.dcf:2: error: 'CANopenSafetySupported' is '2', expected a number from 0 to 1"},
        {std::string("[OptionalObjects]\nSupportedObjects=1\n1=0x10000\n") + kObject,
         "test.dcf:3: error: '1' is '0x10000', expected a number from 0 to 65535"},
        {std::string("[OptionalObjects]\nSupportedObjects=many\n") + kObject,
         "test.dcf:2: error: 'SupportedObjects' is 'many', expected a number from 0 to 65535"},
        {std::string("[DummyUsage]\nDummy0005=2\n") + kObject,
         "test.dcf:2: error: 'Dummy0005' is '2', expected a number from 0 to 1"},
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
              "test.dcf:400001: error: there is a line more, expected at most 400000 lines");
}

TEST(Malformed, TooLongALineIsRefused)
{
    Verifies(req::SRS_EDS_018);
    EXPECT_EQ(RefusalOf("[1000]\n;" + std::string(65533U, 'x') + "\n"), "");
    EXPECT_EQ(RefusalOf("[1000]\n;" + std::string(65534U, 'x') + "\n"),
              "test.dcf:2: error: the line has more than 65535 bytes, expected shorter lines (CiA 306: 255)");
    // A binary file seldom has lines; what is wrong with it is the byte.
    EXPECT_EQ(RefusalOf(std::string(70000U, '\0')),
              "test.dcf:1: error: control byte 0x00 in column 1, expected 8-bit text");
}

TEST(Malformed, TooManySubIndicesAreRefused)
{
    Verifies(req::SRS_EDS_018);
    std::string text;
    for (int index = 0x2000; index < 0x2400; ++index)
    {
        text += "[" + test::HexIndex(index) + "]\nDataType=7\nCompactSubObj=254\n";
    }
    EXPECT_EQ(RefusalOf(text), "test.dcf:2353: error: there is a sub-index more, expected at most 200000");
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
} // namespace
} // namespace counterpoint::cia306
