// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What types, lists and values of a file mean where they are unusual, and what a caller may ask of an entry.
#include "canopen/cia306/file/value_edits.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/number.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
using test::DeviceOf;
using Lines = std::vector<std::string>;

/// The least device that is read without a warning; `more` follows from line 11 on.
std::string FileOf(const std::string& more)
{
    return "[DeviceInfo]\nVendorName=x\n[MandatoryObjects]\nSupportedObjects=1\n1=0x1000\n"
           "[1000]\nParameterName=Device type\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x1\n" +
           more;
}

Lines WarningsOf(const std::string& more)
{
    Lines warnings;
    for (const Finding& finding : DeviceOf(FileOf(more)).warnings)
    {
        const std::string line = FormatFinding("f", finding);
        if (line.find("is in none of the lists") == std::string::npos)
        {
            warnings.push_back(line);
        }
    }
    return warnings;
}

/// A structure of three members at 0040h: UNSIGNED16, one without a value of DataType 0005h, one that is no number.
constexpr const char* kStructure =
    "[0040]\nParameterName=s\nObjectType=0x6\nSubNumber=4\n"
    "[0040sub0]\nParameterName=n\nObjectType=0x7\nDataType=0x0005\nAccessType=ro\nDefaultValue=3\n"
    "[0040sub1]\nParameterName=a\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x0006\n"
    "[0040sub2]\nParameterName=b\nObjectType=0x7\nDataType=0x0005\nAccessType=ro\n"
    "[0040sub3]\nParameterName=c\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x10000\n"
    "[0040sub4]\nParameterName=d\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=many\n";

std::string RecordOf(const std::string& type)
{
    std::string text = "[2000]\nParameterName=r\nObjectType=0x9\nDataType=" + type + "\nSubNumber=6\n";
    for (const char sub : std::string("012345"))
    {
        text += std::string("[2000sub") + sub + "]\nParameterName=x\nObjectType=0x7\nAccessType=rw\n";
    }
    return text;
}

TEST(DeviceTypes, MembersOfARecordHaveTheTypesOfItsStructure)
{
    Verifies(req::SRS_EDS_027);
    const Device device = DeviceOf(FileOf(kStructure + RecordOf("0x0040")));
    const std::uint16_t types[6] = {0x0005U, 0x0006U, 0x0005U, 0U, 0U, 0U};
    for (std::uint8_t sub = 0U; sub < 6U; ++sub)
    {
        ASSERT_NE(device.Find(0x2000U, sub), nullptr);
        EXPECT_EQ(device.Find(0x2000U, sub)->data_type, types[sub]) << int{sub};
    }
    // What is no structure gives none
    const Device other = DeviceOf(FileOf("[0040]\nParameterName=s\nObjectType=0x5\nDataType=0x0007\nAccessType=ro\n"
                                         "DefaultValue=16\n" +
                                         RecordOf("0x0040")));
    EXPECT_EQ(other.Find(0x2000U, 0U)->data_type, 0U);
    EXPECT_EQ(other.Find(0x2000U, 1U)->data_type, 0U);
}

TEST(DeviceTypes, ATypeOfTheFileHasALengthOnlyAsDeftype)
{
    Verifies(req::SRS_EDS_027);
    const auto bits = [](const std::string& type, const std::string& rest)
    {
        const Device device = DeviceOf(FileOf("[0060]\nParameterName=t\nObjectType=" + type + "\n" + rest +
                                              "[2000]\nParameterName=x\nObjectType=0x7\nDataType=0x0060\n"
                                              "AccessType=rw\nDefaultValue=1\n"));
        return int{device.Find(0x2000U, 0U)->type.bits};
    };
    const std::string value = "DataType=0x0007\nAccessType=ro\nDefaultValue=";
    EXPECT_EQ(bits("0x5", value + "12\n"), 12);
    EXPECT_EQ(bits("0x5", value + "64\n"), 64);
    EXPECT_EQ(bits("0x5", value + "65\n"), 0);
    EXPECT_EQ(bits("0x5", value + "0\n"), 0);
    EXPECT_EQ(bits("0x7", value + "12\n"), 0);
    // A DEFTYPE of sub-indices without the first one
    EXPECT_EQ(bits("0x5", "SubNumber=1\n[0060sub1]\nParameterName=y\n" + value + "12\n"), 0);
}

TEST(DeviceTypes, BitsOfOneToEightHaveTheirLength)
{
    Verifies(req::SRS_EDS_027);
    const auto bits = [](const std::string& type)
    {
        const Device device =
            DeviceOf(FileOf("[2000]\nParameterName=x\nObjectType=0x7\nDataType=" + type + "\nAccessType=rw\n"));
        return int{device.Find(0x2000U, 0U)->type.bits};
    };
    // BIT1 and BIT8, and what is beside them
    EXPECT_EQ(bits("0x002F"), 0);
    EXPECT_EQ(bits("0x0030"), 1);
    EXPECT_EQ(bits("0x0037"), 8);
    EXPECT_EQ(bits("0x0038"), 0);
}

TEST(DeviceTypes, ValuesWithoutAnOrderHaveNoLimits)
{
    Verifies(req::SRS_EDS_027);
    const std::string limits = "AccessType=rw\nLowLimit=5\nHighLimit=4\nDefaultValue=3\n";
    EXPECT_EQ(WarningsOf("[2000]\nParameterName=x\nObjectType=0x7\nDataType=0x000C\n" + limits), Lines{});
    EXPECT_EQ(WarningsOf("[0040]\nParameterName=s\nObjectType=0x6\n[2000]\nParameterName=x\nObjectType=0x7\n"
                         "DataType=0x0040\n" +
                         limits),
              Lines{});
    EXPECT_EQ(WarningsOf("[2000]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\n" + limits).size(), 1U);
}

TEST(DeviceTypes, ASuffixIsToldAndAStructureIsNoVariable)
{
    Verifies(req::SRS_EDS_015);
    EXPECT_EQ(
        WarningsOf("[2000]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nDefaultValue=10UL\n"),
        (Lines{"f:16:14: warning: 0x2000:00: DefaultValue: '10UL' is read without its suffix, expected a number "
               "without U or L"}));
    // An inverse object without 0x has six hexadecimal digits
    EXPECT_EQ(test::RefusalOf(FileOf("[2000]\nParameterName=x\nDataType=5\nInvertedSRAD=21000Z\n")),
              "test.dcf:14:14: error: 'InvertedSRAD' is '21000Z', expected index and sub-index of the inverse object "
              "as one number, such as 0x210001");
    EXPECT_EQ(DeviceOf(FileOf("[0040]\nParameterName=s\nObjectType=0x6\n")).Find(0x0040U, 0U), nullptr);
    EXPECT_NE(DeviceOf(FileOf("[0040]\nParameterName=s\nObjectType=0x5\n")).Find(0x0040U, 0U), nullptr);
}

TEST(DeviceTypes, WhatNamesNoSubIndexIsToldAndIgnored)
{
    Verifies(req::SRS_EDS_015);
    const std::string compact = "[2000]\nParameterName=x\nObjectType=0x8\nDataType=0x0005\nAccessType=rw\n"
                                "DefaultValue=1\nCompactSubObj=2\n";
    EXPECT_EQ(WarningsOf(compact + "[2000Value]\nNrOfEntries=1\n1=7\n2=\n"), Lines{});
    EXPECT_EQ(WarningsOf(compact + "[2000Value]\nNrOfEntries=1\nx=7\n"),
              (Lines{"f:20:1: warning: key 'x' in section '2000Value' names no sub-index of the object, expected one; "
                     "it is ignored"}));
    EXPECT_EQ(WarningsOf(compact + "[2001Value]\nNrOfEntries=1\n1=7\n"),
              (Lines{"f:20:1: warning: key '1' in section '2001Value' names no sub-index of the object, expected one; "
                     "it is ignored"}));
    EXPECT_EQ(WarningsOf(compact + "[2000sub123]\nParameterName=x\n").size(), 1U); // At most two digits.
    // A place of a list that is empty is none, and a SubNumber of 0 says nothing
    EXPECT_EQ(WarningsOf("[OptionalObjects]\nSupportedObjects=0\n1=\n"), Lines{});
    EXPECT_EQ(WarningsOf("[2000]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nSubNumber=0\n"),
              Lines{});
}

TEST(DeviceTypes, TheSecondCommissioningSectionIsNamedWhateverItsSpelling)
{
    Verifies(req::SRS_EDS_009);
    EXPECT_EQ(test::RefusalOf("[DeviceCommissioning]\nNodeID=5\n[DeviceComissioning]\nNodeID=5\n[1000]\nDataType=7\n"),
              "test.dcf:3:1: error: the commissioning section stands a second time, expected it once, as in line 1");
    EXPECT_EQ(test::RefusalOf("[DeviceComissioning]\nNodeID=5\n[DeviceCommissioning]\nNodeID=5\n[1000]\nDataType=7\n"),
              "test.dcf:3:1: error: the commissioning section stands a second time, expected it once, as in line 1");
}

TEST(DeviceTypes, WhichPdoMayCarryAnEntry)
{
    Verifies(req::SRS_EDS_001);
    struct Case
    {
        Access access;
        bool is_sent;
        bool is_received;
    };
    const Case cases[] = {{Access::kReadOnly, true, false},        {Access::kConstant, true, false},
                          {Access::kReadWriteInput, true, false},  {Access::kWriteOnly, false, true},
                          {Access::kReadWriteOutput, false, true}, {Access::kReadWrite, true, true}};
    for (const Case& one : cases)
    {
        Entry entry;
        entry.access = one.access;
        EXPECT_FALSE(entry.IsInTpdo());
        EXPECT_FALSE(entry.IsInRpdo());
        entry.is_pdo_mappable = true;
        EXPECT_EQ(entry.IsInTpdo(), one.is_sent) << static_cast<int>(one.access);
        EXPECT_EQ(entry.IsInRpdo(), one.is_received) << static_cast<int>(one.access);
    }
    for (const std::uint64_t bits : {1U, 8U, 16U, 32U, 64U})
    {
        EXPECT_TRUE(IsGranularity(bits)) << bits;
    }
    for (const std::uint64_t bits : {0U, 2U, 24U, 65U})
    {
        EXPECT_FALSE(IsGranularity(bits)) << bits;
    }
}

TEST(DeviceTypes, AValueThatIsUsableAndOneThatIsRequired)
{
    Verifies(req::SRS_EDS_032);
    Entry entry;
    entry.index = 0x2000U;
    entry.sub = 1U;
    entry.data_type = kUnsigned8;
    entry.type = DataTypeOf(kUnsigned8);
    entry.place = Place{7U, 1U};
    const auto refusal = [&entry](const bool is_required)
    {
        try
        {
            (void)(is_required ? RequiredValue("f", entry, std::nullopt)
                               : UsableValue("f", entry, std::nullopt).value_or(Value{}));
        }
        catch (const InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    // None
    EXPECT_FALSE(UsableValue("f", entry, std::nullopt));
    EXPECT_EQ(refusal(true), "f:7:1: error: 0x2000:01: no value, expected a ParameterValue or DefaultValue");
    // One that does not fit
    entry.default_value = Text{"256", Place{9U, 14U}};
    EXPECT_FALSE(UsableValue("f", entry, std::nullopt));
    EXPECT_EQ(refusal(true), "f:9:14: error: 0x2000:01: value '256', expected a number from 0 to 255 (UNSIGNED8)");
    // One that lacks the node-ID is refused by both
    entry.default_value = Text{"$NODEID+1", Place{9U, 14U}};
    const std::string lacks = "f:9:14: error: 0x2000:01: value '$NODEID+1' needs the node-ID and there is none, "
                              "expected --node-id, or NodeID in [DeviceComissioning]";
    EXPECT_EQ(refusal(true), lacks);
    EXPECT_EQ(refusal(false), lacks);
    EXPECT_EQ(UsableValue("f", entry, std::uint8_t{5U})->bits, 6U);
    EXPECT_EQ(RequiredValue("f", entry, std::uint8_t{5U}).bits, 6U);
    // One that fits with this node-ID, though not with each
    entry.default_value.text = "$NODEID+200";
    EXPECT_EQ(UsableValue("f", entry, std::uint8_t{5U})->bits, 205U);
    EXPECT_FALSE(UsableValue("f", entry, std::uint8_t{56U}));
}

TEST(DeviceTypes, DummiesAreThoseOfOneToSeven)
{
    Verifies(req::SRS_EDS_012);
    const auto dummies = [](const std::string& usage)
    {
        std::vector<Finding> problems;
        const Device device = DeviceOf(FileOf("[DummyUsage]\n" + usage));
        return int{ReadDeviceParameters(device, std::nullopt, problems).dummy_mapping};
    };
    EXPECT_EQ(dummies("Dummy0005=1\n"), dummies("Dummy0007=1\n"));
    EXPECT_NE(dummies("Dummy0005=1\n"), dummies("Dummy0008=1\n"));
    EXPECT_EQ(dummies("Dummy0005=0\n"), dummies("Dummy0008=1\n"));
}

TEST(DeviceTypes, TheFirstSafetyObjectIsOneOfThem)
{
    Verifies(req::SRS_EDS_020);
    EXPECT_FALSE(FirstSafetyObject(DeviceOf(FileOf("[2000]\nDataType=5\n"))));
    EXPECT_FALSE(FirstSafetyObject(DeviceOf(FileOf("[OptionalObjects]\nSupportedObjects=1\n1=0x1400\n"))));
    const auto listed = FirstSafetyObject(DeviceOf(FileOf("[OptionalObjects]\nSupportedObjects=1\n1=0x13FF\n")));
    ASSERT_TRUE(listed);
    EXPECT_EQ(listed->first, 0x13FFU);
    EXPECT_EQ(listed->second.line, 13U);
}

TEST(DeviceTypes, WhatSrdosMapAndReceive)
{
    Verifies(req::SRS_EDS_020);
    const test::SrdoText sent{1, "1", "25", "20", "0x101", "0x102", {"0x20000108", "0x20010108"}};
    const test::SrdoText received{2, "2", "50", "20", "0x103", "0x104", {"0x62000108", "0x62010108"}};
    const SafetyConfiguration configuration =
        ExtractSafety(DeviceOf(test::SrdoFileText({sent, received})), std::nullopt);
    Entry entry;
    entry.index = 0x2000U;
    entry.sub = 1U;
    EXPECT_TRUE(configuration.srdos[0].Maps(entry));
    EXPECT_FALSE(configuration.srdos[1].Maps(entry));
    EXPECT_TRUE(configuration.Maps(entry));
    EXPECT_FALSE(configuration.MapsToReceive(entry));
    entry.sub = 2U;
    EXPECT_FALSE(configuration.Maps(entry));
    entry.index = 0x6201U;
    entry.sub = 1U;
    EXPECT_TRUE(configuration.MapsToReceive(entry));
    // An SRDO without its mapping has the place of its own
    std::string text = test::SrdoFileText({sent});
    const std::size_t mapping = text.find("[1381]");
    text.erase(mapping, text.find("[13FF]") - mapping);
    const SafetyConfiguration lone = ExtractSafety(DeviceOf(text), std::nullopt);
    ASSERT_EQ(lone.srdos.size(), 1U);
    ASSERT_FALSE(lone.srdos[0].signature_problems.empty());
    EXPECT_EQ(lone.srdos[0].signature_problems[0].object, "0x1381");
    EXPECT_EQ(lone.srdos[0].signature_problems[0].place.line, 4U);
}

TEST(DeviceTypes, AFieldOfAnObjectThatIsNotThereHasThePlaceOfTheReader)
{
    Verifies(req::SRS_EDS_020);
    const Device device = DeviceOf(FileOf("[1301]\nParameterName=c\nObjectType=0x9\nSubNumber=1\n"
                                          "[1301sub0]\nParameterName=n\nDataType=0x0005\nDefaultValue=6\n"));
    std::vector<Finding> problems;
    EXPECT_FALSE(ReadField(device, 0x1302U, 1U, kUnsigned8, std::nullopt, Place{7U, 3U}, problems).value);
    EXPECT_FALSE(ReadField(device, 0x1301U, 1U, kUnsigned8, std::nullopt, Place{7U, 3U}, problems).value);
    EXPECT_EQ(ReadField(device, 0x1301U, 0U, kUnsigned8, std::nullopt, Place{7U, 3U}, problems).value, 6U);
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].object, "0x1302:01");
    EXPECT_TRUE(problems[0].place == (Place{7U, 3U}));
    EXPECT_EQ(problems[1].object, "0x1301:01");
    EXPECT_TRUE(problems[1].place == (Place{11U, 1U}));
}

TEST(DeviceTypes, AProblemOfNoObjectIsThrownWithoutOne)
{
    Verifies(req::SRS_EDS_024);
    try
    {
        RequireNone("f", {{Severity::kError, {4U, 7U}, "", "a, expected b"}});
        FAIL() << "no refusal";
    }
    catch (const InputError& error)
    {
        EXPECT_STREQ(error.what(), "f:4:7: error: a, expected b");
    }
}

TEST(DeviceTypes, TheNumberOfEntriesFollowsWhatIsNewAlone)
{
    Verifies(req::SRS_EDS_011);
    const std::string compact = "ParameterName=x\nObjectType=0x8\nDataType=0x0005\nAccessType=rw\nDefaultValue=1\n"
                                "CompactSubObj=2\n";
    const std::string text = FileOf("[2000]\n" + compact + "[2001]\n" + compact +
                                    "[2000Value]\nNrOfEntries=1\n1=7\n[2001Value]\nNrOfEntries=1\n1=7\n");
    const IniDocument document = IniDocument::Parse("f", text);
    const Device device = ReadDevice(document);
    const auto counts = [&](const std::vector<ValueEdit>& edits)
    {
        const IniDocument edited = WithParameterValues(document, device, edits);
        return edited.Find("2000Value")->Find("NrOfEntries")->value +
               edited.Find("2001Value")->Find("NrOfEntries")->value;
    };
    EXPECT_EQ(counts({{device.Find(0x2000U, 1U), "8"}}), "11");
    EXPECT_EQ(counts({{device.Find(0x2000U, 2U), "8"}}), "21");
    EXPECT_EQ(counts({{device.Find(0x2000U, 2U), "8"}, {device.Find(0x2001U, 1U), "9"}}), "21");
    EXPECT_EQ(counts({{device.Find(0x2000U, 2U), "8"}, {device.Find(0x2001U, 2U), "9"}}), "22");
}

TEST(DeviceTypes, TypedNumbersHaveNoOctalForm)
{
    Verifies(req::SRS_NODE_003);
    EXPECT_EQ(ParseTyped("10", 127U), 10U);
    EXPECT_EQ(ParseTyped("0x10", 127U), 16U);
    EXPECT_EQ(ParseTyped("0X10", 127U), 16U);
    EXPECT_EQ(ParseTyped("0", 127U), 0U);
    EXPECT_EQ(ParseTyped("010", 127U), std::nullopt);
    EXPECT_EQ(ParseTyped("128", 127U), std::nullopt);
    EXPECT_EQ(ParseTyped("", 127U), std::nullopt);
}

} // namespace
} // namespace counterpoint::cia306
