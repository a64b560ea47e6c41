// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Safety configurations that few files have: mappings of what is not there, SRDOs that are off, values with the
// node-ID.
#include "canopen/generate/generate.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::generate
{
namespace
{
using cia306::test::FileText;

GeneratedCode Code(const std::string& text)
{
    const cia306::Device device = cia306::test::DeviceOf(text);
    return Generate(device, text, {"a_device", device.node_id});
}

std::string RefusalOf(const std::string& text)
{
    try
    {
        static_cast<void>(Code(text));
    }
    catch (const cia306::InputError& error)
    {
        return error.what();
    }
    return "";
}

bool Has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// The text with `to` in place of the first `from` behind the head of a section.
std::string InSection(std::string text, const std::string& section, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from, text.find("[" + section + "]\n"));
    EXPECT_NE(place, std::string::npos) << section << " has no " << from;
    return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

/// digest.dcf: SRDO 2 is a consumer of 2200h:01, SRDO 5 a producer of 2400h:01, both with their inverse objects.
std::string MappedBySrdo5(const std::string& direction)
{
    std::string text = InSection(FileText("digest"), "1385sub1", "0x24000140", "0x22000120");
    text = InSection(text, "1385sub2", "0x25000140", "0x23000120");
    return InSection(text, "1305sub1", "ParameterValue=1", "ParameterValue=" + direction);
}

TEST(StaticMappingOfAFile, NamesVariablesOfTheFile)
{
    Verifies(req::SRS_GEN_351);
    // Given a static mapping whose last entry names an object behind all others
    EXPECT_EQ(RefusalOf(InSection(FileText("static"), "1383sub6", "0x24100308", "0x99990108")),
              "test.dcf:401:14: error: the static mapping names 0x9999:01, expected an object of the file with "
              "SRDOMapping=1 and a length of 1 to 64 bits");
    // One between others
    EXPECT_EQ(RefusalOf(InSection(FileText("static"), "1383sub6", "0x24100308", "0x23500108")),
              "test.dcf:401:14: error: the static mapping names 0x2350:01, expected an object of the file with "
              "SRDOMapping=1 and a length of 1 to 64 bits");
    // And one that is there and no variable of the kernel
    EXPECT_EQ(RefusalOf(InSection(FileText("static"), "2410sub3", "SRDOMapping=1", "SRDOMapping=0")),
              "test.dcf:401:14: error: the static mapping names 0x2410:03, expected an object of the file with "
              "SRDOMapping=1 and a length of 1 to 64 bits");
    EXPECT_EQ(RefusalOf(FileText("static")), "");
}

TEST(VariablesOfAFile, AreAtMost1024)
{
    Verifies(req::SRS_GEN_352);
    // Given the 22 variables of the file, and 1002 more
    std::string text = FileText("static");
    for (int number = 0; number < 1002; ++number)
    {
        text += "\n[" + cia306::test::HexIndex(0x3000 + number) +
                "]\nParameterName=V\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=0\nSRDOMapping=1\n";
    }
    EXPECT_EQ(Code(text).variable_count, 1024U);
    // With one more the file is refused
    text += "\n[4000]\nParameterName=V\nObjectType=0x7\nDataType=5\nAccessType=ro\nDefaultValue=0\nSRDOMapping=1\n";
    EXPECT_EQ(RefusalOf(text), "test.dcf: error: 1025 objects with SRDOMapping=1, expected at most 1024");
}

TEST(VariablesOfAFile, AreNumbersWhoseAccessIsTold)
{
    Verifies(req::SRS_GEN_009);
    // A constant is one that the application writes
    const std::string constant =
        Code(InSection(FileText("digest"), "2400sub1", "AccessType=ro", "AccessType=const")).source;
    EXPECT_TRUE(Has(constant, "{0x2400U, 0x01U, 64U, counterpoint::MapAccess::kProducer,"));
    // Without an access it is an entry of the table that can be read
    const std::string untold = Code(InSection(FileText("digest"), "2400sub1", "AccessType=ro", "")).source;
    EXPECT_FALSE(Has(untold, "{0x2400U, 0x01U, 64U, counterpoint::MapAccess::"));
    EXPECT_TRUE(Has(untold, "{0x2400U, 0x01U, DataType::kUnsigned64, Access::kReadOnly"));
    // So is a string
    const std::string string = Code(FileText("digest") + "\n[2800]\nParameterName=Word\nObjectType=0x7\nDataType=9\n"
                                                         "AccessType=rw\nDefaultValue=a\nSRDOMapping=1\n")
                                   .source;
    EXPECT_TRUE(Has(string, "{0x2800U, 0x00U, DataType::kVisibleString, Access::kReadWrite"));
    EXPECT_FALSE(Has(string, "{0x2800U, 0x00U, 0U, counterpoint::MapAccess::"));
}

TEST(SafeValues, AreOfPairsWhoseObjectsAreThere)
{
    Verifies(req::SRS_GEN_020);
    const std::string checked = "GetIn1(counterpoint::SrdoMask released)";
    EXPECT_TRUE(Has(Code(FileText("digest")).header, checked));
    EXPECT_FALSE(Has(Code(InSection(FileText("digest"), "1382sub2", "0x23000120", "0x99990120")).header, checked));
    EXPECT_FALSE(Has(Code(InSection(FileText("digest"), "1382sub1", "0x22000120", "0x99990120")).header, checked));
}

TEST(SafeValues, HaveNoPartBehindTheirLastBit)
{
    Verifies(req::SRS_GEN_020);
    // Given the variable as the only one of its mapping, it has the lowest bits
    const std::string first = "GetIn1Unchecked() : static_cast<std::uint32_t>(";
    EXPECT_TRUE(Has(Code(FileText("digest")).source, first + "2712847316U);"));
    // Behind 64 other bits it has none of them, and reads 0
    std::string text = InSection(FileText("digest"), "1382sub0", "ParameterValue=2", "ParameterValue=4");
    text = InSection(text, "1382sub1", "0x22000120", "0x24000140");
    text = InSection(text, "1382sub2", "0x23000120", "0x25000140");
    text += "\n" + cia306::test::VariableText("1382sub3", "0x0007", "0x22000120") +
            cia306::test::VariableText("1382sub4", "0x0007", "0x23000120");
    EXPECT_TRUE(Has(Code(text).source, first + "0U);"));
}

// 5F02h:02 is A1B2C3D4h, the low half of 5F02h:05 is 55667788h.
TEST(SafeValues, AreThoseOfTheSrdoThatIsOn)
{
    Verifies(req::SRS_GEN_020);
    const std::string of_2 = "GetIn1Unchecked() : static_cast<std::uint32_t>(2712847316U);";
    const std::string of_5 = "GetIn1Unchecked() : static_cast<std::uint32_t>(1432778632U);";
    // Given SRDO 2 as a consumer, and SRDO 5 with the same mapping, off
    EXPECT_TRUE(Has(Code(MappedBySrdo5("0")).source, of_2));
    // Given SRDO 2 off and SRDO 5 as a consumer
    const std::string off = InSection(MappedBySrdo5("2"), "1302sub1", "ParameterValue=2", "ParameterValue=0");
    EXPECT_TRUE(Has(Code(off).source, of_5));
    EXPECT_TRUE(Has(Code(off).source, "((released >> kSrdo5Slot) & 1U) != 0U;"));
    // Given both off, the first has it
    const std::string both = InSection(MappedBySrdo5("0"), "1302sub1", "ParameterValue=2", "ParameterValue=0");
    EXPECT_TRUE(Has(Code(both).source, of_2));
}

TEST(GlobalFailSafeCommand, IsConfiguredWhereTheDeviceHasIt)
{
    Verifies(req::SRS_GEN_011);
    // Given 1300h, with 5F00h:0E that tells it is there, and with 0, that it is not
    const std::string there = Code(FileText("digest")).source;
    EXPECT_TRUE(Has(there, "{{0x1300U, 0x00U}, 1U, 0x01U},"));
    EXPECT_TRUE(Has(there, "counterpoint::GfcUse::kPresent, // gfc"));
    const std::string removed =
        Code(InSection(FileText("digest"), "5F00subE", "ParameterValue=90", "ParameterValue=0")).source;
    EXPECT_FALSE(Has(removed, "{{0x1300U, 0x00U}"));
    EXPECT_TRUE(Has(removed, "counterpoint::GfcUse::kRemoved, // gfc"));
}

TEST(AnotherNodeId, HasSignaturesOfTheSrdosThatFollowIt)
{
    Verifies(req::SRS_GEN_016);
    // Given SRDO 3 of two, whose COB-IDs follow from the node-ID, 7
    std::string text = InSection(FileText("static"), "1303sub5", "0x179", "$NODEID+0x172");
    text = InSection(text, "1303sub6", "0x17A", "$NODEID+0x173");
    // Then it has a table of signatures, that of node 7 is the file's, and SRDO 1 has none
    const std::string source = Code(text).source;
    EXPECT_FALSE(Has(source, "kSignatures1["));
    const std::string head = "kSignatures3[]{\n    ";
    const std::size_t table = source.find(head);
    ASSERT_NE(table, std::string::npos);
    const std::size_t of_one = 9U; // "0x4B9CU, "
    EXPECT_EQ(source.substr(table + head.size() + 6U * of_one, of_one), "0x4B9CU, ");
    // Given a wrong signature, then it stays for each node-ID, and the COB-IDs follow all the same
    const std::string wrong = Code(InSection(text, "13FFsub3", "0x4B9C", "0x4B9D")).source;
    EXPECT_FALSE(Has(wrong, "kSignatures3"));
    EXPECT_TRUE(Has(wrong, "0x00000172U, nullptr},\n"));
    EXPECT_TRUE(Has(wrong, "0x00000173U, nullptr},\n"));
}

TEST(AnotherNodeId, MayHaveNoValue)
{
    Verifies(req::SRS_GEN_730);
    const auto warnings = [](const std::string& text)
    {
        std::vector<std::string> lines;
        for (const cia306::Finding& finding : Code(text).warnings)
        {
            lines.push_back(cia306::FormatFinding("f", finding));
        }
        return lines;
    };
    const auto with = [](const std::string& section, const std::string& from, const std::string& to)
    { return InSection(FileText("static"), section, "ParameterValue=" + from, "ParameterValue=" + to); };
    const std::string end = ", expected a sum that its type holds; Configure refuses them";
    // Given an SRVT of 8 bits and an SCT of 16, then from the node-ID on at which the sum is too great
    EXPECT_EQ(warnings(with("1303sub3", "20", "$NODEID+200")),
              (std::vector<std::string>{"f:173:16: warning: 0x1303:03: no value with node-IDs 56 to 127" + end}));
    EXPECT_EQ(warnings(with("1301sub2", "50", "$NODEID+65409")),
              (std::vector<std::string>{"f:98:16: warning: 0x1301:02: no value with node-IDs 127 to 127" + end}));
    // One that fits with each says nothing, and 1300h has its place, too
    EXPECT_EQ(warnings(with("1301sub2", "50", "$NODEID+65408")), std::vector<std::string>{});
    EXPECT_EQ(warnings(with("1300", "1", "$NODEID+240")),
              (std::vector<std::string>{"f:67:16: warning: 0x1300:00: no value with node-IDs 16 to 127" + end}));
    EXPECT_EQ(warnings(FileText("static")), std::vector<std::string>{});
    // Then the signature for such a node-ID is none
    const auto document = cia306::IniDocument::Parse("f", with("1303sub3", "20", "$NODEID+129"));
    const std::string source =
        Code(cia306::WithSignatures(document, cia306::ReadDevice(document), std::uint8_t{7U}).Text()).source;
    const std::string table = source.substr(source.find("kSignatures3[]{"));
    const std::string nodes = table.substr(0U, table.find("};"));
    EXPECT_EQ(nodes.substr(nodes.size() - 10U), " 0x0000U,\n");
    EXPECT_EQ(nodes.find("0x0000U"), nodes.size() - 9U);
}

TEST(AnotherNodeId, HasTheSameMappings)
{
    Verifies(req::SRS_GEN_350);
    const std::string of_node_1 = InSection(FileText("digest"), "DeviceComissioning", "NodeID=127", "NodeID=1");
    const std::string refusal = "test.dcf:219:16: error: the mapping of SRDO 2 has another number of entries with "
                                "another node-ID, expected as many for each node-ID";
    // Given a number of entries that is 2 for node 1, 3 for node 2
    EXPECT_EQ(RefusalOf(InSection(of_node_1, "1382sub0", "ParameterValue=2", "ParameterValue=$NODEID+1")), refusal);
    // Given an entry that has no value for node 2
    EXPECT_EQ(RefusalOf(InSection(of_node_1, "1382sub2", "0x23000120", "$NODEID+0xFFFFFFFE")), refusal);
    // Given one that has a value for nodes 1 and 2 alone, then that is told elsewhere
    EXPECT_EQ(RefusalOf(InSection(of_node_1, "1382sub2", "0x23000120", "$NODEID+0xFFFFFFFD")), "");
    // Given one that has a value for each, which is no good idea either, then it follows
    const std::string follows = Code(InSection(of_node_1, "1382sub2", "0x23000120", "$NODEID+0x2300011F")).source;
    EXPECT_TRUE(Has(follows, "0x2300011FU, nullptr},\n"));
}

TEST(AnotherNodeId, LeavesDeviceParametersAsTheyAre)
{
    Verifies(req::SRS_GEN_353);
    // Given the safe value A1B2C3D4h for node 127
    const std::string source =
        Code(InSection(FileText("digest"), "5F02sub2", "0xA1B2C3D4", "$NODEID+0xA1B2C355")).source;
    // Then it is a constant of the dictionary and of the device, and nothing writes it for another node
    EXPECT_TRUE(Has(source, "    0xD4U, 0xC3U, 0xB2U, 0xA1U, 0x00U, 0x00U, 0x00U, 0x00U, // 5F02h:02\n"));
    EXPECT_TRUE(Has(source, "{0xA1B2C3D4U, 0x00000000U}"));
    EXPECT_FALSE(Has(source, "FollowNodeId"));
    // Given a value of each of 5F00h to 5F05h for node 1, then each is that constant
    struct Row
    {
        const char* section;
        const char* from;
        const char* to;
        const char* constant;
    };
    const Row rows[] = {{"5F00sub1", "=2000", "=$NODEID+1999", "    0xD0U, 0x07U, 0x00U, 0x00U, // 5F00h:01\n"},
                        {"5F01sub2", "0x5A", "$NODEID+0x59", "    0x5AU, // 5F01h:02\n"},
                        {"5F02sub2", "0xA1B2C3D4", "$NODEID+0xA1B2C3D3",
                         "    0xD4U, 0xC3U, 0xB2U, 0xA1U, 0x00U, 0x00U, 0x00U, 0x00U, // 5F02h:02\n"},
                        {"5F03sub5", "=0x1", "=$NODEID", "    0x01U, // 5F03h:05\n"},
                        {"5F04", "0x5F9AFA3D", "$NODEID+0x5F9AFA3C", "    0x3DU, 0xFAU, 0x9AU, 0x5FU, // 5F04h:00\n"},
                        {"5F05sub2", "0x3C", "$NODEID+0x3B", "    0x3CU, // 5F05h:02\n"}};
    const std::string of_node_1 = InSection(FileText("digest"), "DeviceComissioning", "NodeID=127", "NodeID=1");
    for (const Row& row : rows)
    {
        const std::string each = Code(InSection(of_node_1, row.section, row.from, row.to)).source;
        EXPECT_TRUE(Has(each, row.constant)) << row.section;
        EXPECT_FALSE(Has(each, "FollowNodeId")) << row.section;
    }
}
} // namespace
} // namespace counterpoint::generate
