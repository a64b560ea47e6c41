// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Files that few devices have: values beyond their limits, node-IDs in safety parameters, nothing to store.
#include "canopen/generate/generate.hpp"
#include "canopen/generate/names.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/generate/random_device.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::generate
{
namespace
{
const std::string kHead = "[FileInfo]\n\n";

GeneratedCode Code(const std::string& text, const std::string& name_space = "a_device")
{
    const cia306::Device device = cia306::test::DeviceOf(text);
    return Generate(device, text, {name_space, device.node_id});
}

bool Has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// An entry with further keys.
std::string Entry(const std::string& section, const int type, const std::string& access, const std::string& keys)
{
    return "[" + section + "]\nParameterName=x\nObjectType=7\nDataType=" + std::to_string(type) +
           "\nAccessType=" + access + "\nPDOMapping=0\n" + keys + "\n\n";
}

TEST(GeneratedText, IsKnownByItsFirstLine)
{
    Verifies(req::SRS_GEN_018);
    EXPECT_TRUE(IsGenerated(Code(cia306::test::ExampleText("sensor")).header));
    EXPECT_TRUE(IsGenerated(Code(cia306::test::ExampleText("sensor")).source));
    EXPECT_FALSE(IsGenerated(""));
    EXPECT_FALSE(IsGenerated("// Made by hand"));
    EXPECT_FALSE(IsGenerated("/* Made by `counterpoint generate` from a.dcf"));
}

TEST(GeneratedText, NamesTheFileWithoutItsFolder)
{
    Verifies(req::SRS_GEN_012);
    const std::string text = kHead + Entry("2000", 5, "rw", "DefaultValue=1");
    const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse("/some/where/a.dcf", text));
    EXPECT_TRUE(Has(Generate(device, text, {"a", std::nullopt}).header, "` from a.dcf (CRC-32 0x"));
}

// SRS_STO_008: a bus stores and restores in PRE-OPERATIONAL alone, and writes all else in both states.
TEST(GeneratedText, LetsTheBusStoreInPreOperationalAlone)
{
    Verifies(req::SRS_STO_008);
    const auto row = [](const std::string& index)
    {
        const std::string source = Code(kHead + Entry(index, 7, "rw", "DefaultValue=1")).source;
        const std::size_t begin = source.find("{0x" + index + "U");
        return (begin == std::string::npos) ? "none" : source.substr(begin, source.find('}', begin) - begin);
    };
    EXPECT_TRUE(Has(row("1010"), ", kInPreOperational,")) << row("1010");
    EXPECT_TRUE(Has(row("1011"), ", kInPreOperational,")) << row("1011");
    EXPECT_FALSE(Has(row("2000"), "kInPreOperational")) << row("2000");
    EXPECT_TRUE(Has(row("2000"), ", kInBoth,")) << row("2000");
}

// The guard has the whole name of the namespace in capital letters, a gap as one of '_'.
TEST(GeneratedText, HasAGuardOfItsNamespace)
{
    Verifies(req::SRS_GEN_012);
    const std::string text = kHead + Entry("2000", 5, "rw", "DefaultValue=1");
    EXPECT_TRUE(Has(Code(text, "a_device").header, "#ifndef A_DEVICE_OBJECT_DICTIONARY_HPP\n"));
    EXPECT_TRUE(Has(Code(text, "company::my2::Door").header, "#ifndef COMPANY_MY2_DOOR_OBJECT_DICTIONARY_HPP\n"));
}

// A file without a value of its own begins with the limit that is next to 0; a value beyond its limits is told.
TEST(GeneratedLimits, HoldTheFirstValue)
{
    Verifies(req::SRS_GEN_006);
    Verifies(req::SRS_GEN_340);
    const std::string text = kHead + Entry("2000", 6, "rw", "LowLimit=5\nHighLimit=9") +
                             Entry("2001", 3, "rw", "LowLimit=-9\nHighLimit=-5") +
                             Entry("2002", 6, "rw", "HighLimit=9");
    const std::string source = Code(text).source;
    EXPECT_TRUE(Has(source, "0x05U, 0x00U, // 2000h:00")) << source;
    EXPECT_TRUE(Has(source, "0xFBU, 0xFFU, // 2001h:00"));
    EXPECT_TRUE(Has(source, "0x00U, 0x00U, // 2002h:00"));
    EXPECT_TRUE(Code(text).warnings.empty());
    for (const std::string value : {"4", "10"})
    {
        const GeneratedCode code =
            Code(kHead + Entry("2000", 6, "rw", "LowLimit=5\nHighLimit=9\nDefaultValue=" + value));
        ASSERT_EQ(code.warnings.size(), 1U) << value;
        EXPECT_EQ(code.warnings[0].object, "0x2000:00");
        EXPECT_EQ(code.warnings[0].text, "value '" + value +
                                             "', expected one between LowLimit and HighLimit; it is generated all the "
                                             "same");
    }
}

// A limit that is missing is the end of the range of the type; what is no whole number of bytes has the room of one.
TEST(GeneratedLimits, AreThoseOfTheTypeWhereTheFileHasNone)
{
    Verifies(req::SRS_GEN_005);
    Verifies(req::SRS_GEN_340);
    const auto limits = [](const int type, const std::string& keys)
    {
        const std::string source = Code(kHead + Entry("2000", type, "rw", keys)).source;
        const std::string head = "kLimits[]{\n    ";
        const std::size_t place = source.find(head);
        return (place == std::string::npos)
                   ? ""
                   : source.substr(place + head.size(), source.find('\n', place + head.size()) - place - head.size());
    };
    // Given UNSIGNED16, INTEGER8 and INTEGER64 with one limit
    EXPECT_EQ(limits(6, "LowLimit=5"), "{0x5U, 0xFFFFU}, // 2000h:00");
    EXPECT_EQ(limits(6, "HighLimit=9"), "{0x0U, 0x9U}, // 2000h:00");
    EXPECT_EQ(limits(2, "HighLimit=-5"), "{0xFFFFFFFFFFFFFF80ULL, 0xFFFFFFFFFFFFFFFBULL}, // 2000h:00");
    EXPECT_EQ(limits(2, "LowLimit=-5"), "{0xFFFFFFFFFFFFFFFBULL, 0x7FU}, // 2000h:00");
    EXPECT_EQ(limits(21, "LowLimit=1"), "{0x1U, 0x7FFFFFFFFFFFFFFFULL}, // 2000h:00");
    // Given no limit, then whole bytes have none, and BIT1 and BIT7 have those of their bits
    EXPECT_EQ(limits(6, ""), "");
    EXPECT_EQ(limits(22, ""), "");
    EXPECT_EQ(limits(55, ""), "");
    EXPECT_EQ(limits(48, ""), "{0x0U, 0x1U}, // 2000h:00");
    EXPECT_EQ(limits(54, ""), "{0x0U, 0x7FU}, // 2000h:00");
    // Given elements without a value and without limits that forbid 0, then they begin with it
    EXPECT_TRUE(
        Has(Code(kHead + Entry("2000", 3, "rw", "LowLimit=-9\nHighLimit=9")).source, "0x00U, 0x00U, // 2000h:00"));
    EXPECT_TRUE(Has(Code(kHead + Entry("2000", 6, "rw", "")).source, "0x00U, 0x00U, // 2000h:00"));
}

// A value or limit that its type cannot have is as if the file did not give it.
TEST(GeneratedLimits, AndValuesThatTheTypeCannotHaveAreLeftOut)
{
    Verifies(req::SRS_EDS_032);
    const GeneratedCode code = Code(kHead + Entry("2000", 5, "rw", "HighLimit=256\nDefaultValue=256"));
    EXPECT_TRUE(Has(code.source, "0x00U, // 2000h:00")) << code.source;
    EXPECT_FALSE(Has(code.source, "kLimits[]{\n    {"));
    EXPECT_TRUE(
        Has(Code(kHead + Entry("2000", 5, "rw", "HighLimit=254\nDefaultValue=256")).source, "kLimits[]{\n    {"));
}

// The text of the file is UTF-8.
TEST(GeneratedStorage, HasUnicodeStringsAsUtf16)
{
    Verifies(req::SRS_GEN_340);
    EXPECT_TRUE(Has(Code(kHead + Entry("2000", 11, "const",
                                       "DefaultValue=\xE2\x82\xAC"
                                       "1"))
                        .source,
                    "    0xACU, 0x20U, 0x31U, 0x00U, // 2000h:00\n"));
}

TEST(GeneratedStorage, MayBeEmpty)
{
    Verifies(req::SRS_GEN_006);
    // Given constants alone, then one byte is kept all the same, which no entry has
    const std::string constants = Code(kHead + Entry("2000", 5, "const", "DefaultValue=7")).source;
    EXPECT_TRUE(Has(constants, "std::uint8_t bytes[1U];\n    std::uint32_t lengths[1U];"));
    EXPECT_TRUE(Has(constants, "{\n        0U,\n    },\n    {0U}};"));
    // Given a text without a letter as the only constant, then its bytes are one 0
    const GeneratedCode empty = Code(kHead + Entry("2000", 9, "const", "DefaultValue="));
    EXPECT_EQ(empty.constant_bytes, 0U);
    EXPECT_TRUE(Has(empty.source, "    0U,\n};\n\nconstexpr counterpoint::generated::ConstantValue kConstantValues[]"));
}

// A constant that follows from the node-ID changes with it, and is no constant of the program.
TEST(GeneratedStorage, HasConstantsWithTheNodeId)
{
    Verifies(req::SRS_GEN_016);
    Verifies(req::SRS_GEN_150);
    const std::string text = kHead + "[DeviceComissioning]\nNodeID=5\n\n" +
                             Entry("2000", 7, "const", "DefaultValue=$NODEID+0x200") +
                             Entry("2001", 7, "const", "DefaultValue=0x300");
    const GeneratedCode code = Code(text);
    EXPECT_EQ(code.stored_bytes, 4U);
    EXPECT_EQ(code.constant_bytes, 4U);
    EXPECT_TRUE(Has(code.source, "0x05U, 0x02U, 0x00U, 0x00U, // 2000h:00"));
    EXPECT_TRUE(Has(code.source, "0x00U, 0x03U, 0x00U, 0x00U, // 2001h:00"));
}

// A string whose access the file does not tell is taken for ro, and lies with the constants.
TEST(GeneratedStorage, HasStringsWithoutAnAccessAmongTheConstants)
{
    Verifies(req::SRS_GEN_006);
    const std::string no_access = "[2000]\nParameterName=Word\nObjectType=7\nDataType=9\nDefaultValue=ab\n\n";
    const GeneratedCode untold = Code(kHead + no_access);
    EXPECT_EQ(untold.stored_bytes, 0U);
    EXPECT_EQ(untold.constant_bytes, 2U);
    EXPECT_TRUE(Has(untold.source, "{0x2000U, 0x00U, DataType::kVisibleString, Access::kReadOnly"));
    // and those that are read only
    const GeneratedCode told = Code(kHead + Entry("2000", 9, "ro", "DefaultValue=ab"));
    EXPECT_EQ(told.stored_bytes, 0U);
    EXPECT_EQ(told.constant_bytes, 2U);
    // The near miss: one that can be written has room for 32 bytes
    const GeneratedCode written = Code(kHead + Entry("2000", 9, "rw", "DefaultValue=ab"));
    EXPECT_EQ(written.stored_bytes, 32U);
    EXPECT_EQ(written.constant_bytes, 0U);
}

// Octets are pairs of digits; a digit that is left over makes it a text.
TEST(GeneratedStorage, HasOctetsOfPairsOfDigits)
{
    Verifies(req::SRS_GEN_354);
    const auto source = [](const std::string& value)
    { return Code(kHead + Entry("2000", 10, "const", "DefaultValue=" + value)).source; };
    EXPECT_TRUE(Has(source("A1B2"), "    0xA1U, 0xB2U, // 2000h:00\n"));
    EXPECT_TRUE(Has(source("A1 B2"), "    0xA1U, 0xB2U, // 2000h:00\n"));
    EXPECT_TRUE(Has(source("A1B"), "    0x41U, 0x31U, 0x42U, // 2000h:00\n"));
    EXPECT_TRUE(Has(source("A1 B"), "    0x41U, 0x31U, 0x20U, 0x42U, // 2000h:00\n"));
    EXPECT_TRUE(Has(source("A1G2"), "    0x41U, 0x31U, 0x47U, 0x32U, // 2000h:00\n"));
}

// An object that is NULL is none of the dictionary.
TEST(GeneratedEntries, AreOfObjectsThatAreThere)
{
    Verifies(req::SRS_GEN_013);
    const std::string null = "[2001]\nParameterName=x\nObjectType=0\nDataType=5\nAccessType=rw\nDefaultValue=1\n\n";
    EXPECT_EQ(Code(kHead + Entry("2000", 5, "rw", "DefaultValue=1") + null).entry_count, 1U);
}

std::string StaticText()
{
    return cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/canopen/cia306/data/static.dcf");
}

// COB-IDs of an SRDO that follow from the node-ID are followed, with a signature for each node-ID.
TEST(GeneratedSafety, FollowsTheNodeId)
{
    Verifies(req::SRS_GEN_150);
    EXPECT_FALSE(Has(Code(StaticText()).source, "kNodeSettings[]"));
    std::string text = StaticText();
    const std::string first = "ParameterValue=0x10D";
    const std::string second = "ParameterValue=0x10E";
    text.replace(text.find(first), first.size(), "ParameterValue=$NODEID+0x106");
    text.replace(text.find(second), second.size(), "ParameterValue=0x107+$NODEID");
    const std::string source = Code(text).source;
    EXPECT_TRUE(Has(source, "constexpr counterpoint::generated::NodeSetting kNodeSettings[]{\n"));
    EXPECT_TRUE(Has(source, "kSignatures"));
}

TEST(GeneratedSafety, NeedsANodeId)
{
    Verifies(req::SRS_GEN_003);
    std::string text = cia306::test::ExampleText("sensor");
    text.erase(text.find("NodeID=1\n"), 9U);
    for (std::size_t place = text.find("$NODEID+"); place != std::string::npos; place = text.find("$NODEID+"))
    {
        text.erase(place, 8U);
    }
    try
    {
        static_cast<void>(Code(text));
        FAIL() << "code without a node-ID";
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_EQ(std::string(error.what())
                      .find("test.dcf: error: no node-ID, expected --node-id, or NodeID in "
                            "[DeviceComissioning]"),
                  0U)
            << error.what();
    }
}

TEST(NamesOfRareCharacters, ArePlain)
{
    Verifies(req::SRS_GEN_012);
    EXPECT_EQ(PascalCase("a{b"), "AB");
    EXPECT_EQ(PascalCase("aBC"), "ABc");
    EXPECT_EQ(PascalCase("A B"), "AB");
    EXPECT_EQ(CommentText("?a\x7F"), "?a_");
    EXPECT_EQ(NamespaceOf("door"), "door");
    EXPECT_EQ(NamespaceOf("door-.dcf"), "door");
    EXPECT_EQ(NamespaceOf("a{b"), "a_b");
    // Signatures1 is a word of the generated file, Srdo and SrdoX are not
    std::string text = kHead;
    int index = 0x2000;
    for (const std::string name : {"Signatures1", "Srdo", "SrdoX"})
    {
        text += test::Section(cia306::test::HexIndex(index), name, 5U, "rw", "1");
        ++index;
    }
    const std::string header = Code(text).header;
    EXPECT_TRUE(Has(header, "Signatures1At2000Sub00"));
    EXPECT_FALSE(Has(header, "SrdoAt2001Sub00"));
    EXPECT_FALSE(Has(header, "SrdoXAt2002Sub00"));
}
} // namespace
} // namespace counterpoint::generate
