// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"

#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
using test::DeviceOf;

/// The least device that has a DeviceInfo and a list, so that it is read without a warning; `more` follows.
std::string Text(const std::string& more)
{
    return "[DeviceInfo]\nVendorName=x\n[MandatoryObjects]\nSupportedObjects=1\n1=0x1000\n"
           "[1000]\nParameterName=Device type\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x1\n" +
           more;
}

std::vector<std::string> WarningsOf(const std::string& text)
{
    std::vector<std::string> warnings;
    for (const Finding& finding : DeviceOf(text).warnings)
    {
        warnings.push_back(FormatFinding("f", finding));
    }
    return warnings;
}

TEST(DeviceReader, ReadsAVariableWithEverything)
{
    Verifies(req::SRS_EDS_001);
    Verifies(req::SRS_EDS_013);
    const Device device = DeviceOf(Text("[2000]\nParameterName=Speed\nObjectType=0x7\nDataType=0x0003\nAccessType=RWR\n"
                                        "LowLimit=-10\nHighLimit=10\nDefaultValue=1\nParameterValue=2\nPDOMapping=1\n"
                                        "SRDOMapping=0\nInvertedSRAD=0x21000A\n"));
    const Entry* const entry = device.Find(0x2000U, 0U);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->name, "Speed");
    EXPECT_EQ(entry->data_type, 0x0003U);
    EXPECT_EQ(entry->access, Access::kReadWriteInput);
    EXPECT_EQ(entry->low_limit.text, "-10");
    EXPECT_EQ(entry->high_limit.place.line, 17U);
    EXPECT_EQ(entry->default_value.text, "1");
    EXPECT_EQ(entry->default_value.place.line, 18U);
    EXPECT_EQ(entry->parameter_value.text, "2");
    EXPECT_TRUE(entry->is_pdo_mappable);
    EXPECT_EQ(entry->is_srdo_mappable, false);
    EXPECT_EQ(entry->inverted_srad, 0x21000AU);
    EXPECT_EQ(entry->inverted_srad_place.line, 22U);
    EXPECT_EQ(entry->place.line, 11U);
    // and of a sub-index
    const Device record =
        DeviceOf(Text("[2000]\nObjectType=0x8\nSubNumber=2\n[2000sub0]\nDataType=5\nAccessType=ro\n"
                      "[2000sub1]\nDataType=5\nAccessType=ro\nSRDOMapping=1\nInvertedSRAD=0x210002\n"));
    EXPECT_EQ(record.Find(0x2000U, 1U)->is_srdo_mappable, true);
    EXPECT_EQ(record.Find(0x2000U, 1U)->inverted_srad, 0x210002U);
    EXPECT_EQ(record.Find(0x2000U, 0U)->is_srdo_mappable, std::nullopt);
    EXPECT_EQ(record.Find(0x2000U, 0U)->inverted_srad, std::nullopt);
}

TEST(DeviceReader, ReadsEachAccessObjectTypeAndTheLineOfEachValue)
{
    Verifies(req::SRS_EDS_001);
    const std::pair<const char*, Access> accesses[] = {
        {"ro", Access::kReadOnly},        {"wo", Access::kWriteOnly},        {"rw", Access::kReadWrite},
        {"rwr", Access::kReadWriteInput}, {"rww", Access::kReadWriteOutput}, {"const", Access::kConstant}};
    for (const auto& [word, access] : accesses)
    {
        const Device device =
            DeviceOf(Text("[2000]\nObjectType=7\nDataType=5\nAccessType=" + std::string(word) + "\nPDOMapping=0\n"));
        EXPECT_EQ(device.Find(0x2000U, 0U)->access, access) << word;
        EXPECT_FALSE(device.Find(0x2000U, 0U)->is_pdo_mappable) << word;
    }
    const std::pair<const char*, ObjectType> types[] = {{"2", ObjectType::kDomain},    {"5", ObjectType::kDeftype},
                                                        {"6", ObjectType::kDefstruct}, {"7", ObjectType::kVar},
                                                        {"8", ObjectType::kArray},     {"9", ObjectType::kRecord}};
    for (const auto& [word, type] : types)
    {
        const Device device = DeviceOf(
            Text("[2000]\nParameterName=Some\nObjectType=" + std::string(word) + "\nDataType=5\nAccessType=ro\n"));
        ASSERT_NE(device.Find(0x2000U), nullptr) << word;
        EXPECT_EQ(device.Find(0x2000U)->type, type) << word;
        EXPECT_EQ(device.Find(0x2000U)->name, "Some") << word;
        EXPECT_EQ(device.Find(0x2000U)->place.line, 11U) << word;
    }
    // Given a sub-index with all of it, then each has its line
    const Device record =
        DeviceOf(Text("[2000]\nParameterName=Record\nObjectType=9\nSubNumber=1\n[2000sub7]\nParameterName=Part\n"
                      "DataType=6\nAccessType=rww\nLowLimit=2\nHighLimit=8\nDefaultValue=3\nParameterValue=4\n"
                      "PDOMapping=1\nSRDOMapping=1\n"));
    const Entry* const part = record.Find(0x2000U, 7U);
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->name, "Part");
    EXPECT_EQ(part->data_type, 6U);
    EXPECT_EQ(part->place.line, 15U);
    EXPECT_EQ(part->type_place.line, 17U);
    EXPECT_EQ(part->access_place.line, 18U);
    EXPECT_EQ(part->low_limit.text, "2");
    EXPECT_EQ(part->low_limit.place.line, 19U);
    EXPECT_EQ(part->high_limit.text, "8");
    EXPECT_EQ(part->high_limit.place.line, 20U);
    EXPECT_EQ(part->default_value.text, "3");
    EXPECT_EQ(part->default_value.place.line, 21U);
    EXPECT_EQ(part->parameter_value.text, "4");
    EXPECT_EQ(part->parameter_value.place.line, 22U);
    EXPECT_TRUE(part->is_pdo_mappable);
    EXPECT_EQ(part->is_srdo_mappable, true);
}

TEST(DeviceReader, ReadsTheLowestAndTheHighestIndex)
{
    Verifies(req::SRS_EDS_001);
    const Device device = DeviceOf(Text("[0000]\nObjectType=7\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
                                        "[FFFF]\nObjectType=7\nDataType=6\nAccessType=rw\nLowLimit=2\n"
                                        "ParameterValue=3\n"));
    ASSERT_NE(device.Find(0x0000U, 0U), nullptr);
    EXPECT_EQ(device.Find(0x0000U, 0U)->default_value.text, "1");
    ASSERT_NE(device.Find(0xFFFFU), nullptr);
    EXPECT_EQ(device.Find(0xFFFFU)->type, ObjectType::kVar);
    ASSERT_NE(device.Find(0xFFFFU, 0U), nullptr);
    EXPECT_EQ(device.Find(0xFFFFU, 0U)->low_limit.place.line, 20U);
    EXPECT_EQ(device.Find(0xFFFFU, 0U)->parameter_value.place.line, 21U);
}

TEST(DeviceReader, ReadsSubIndicesAsHexadecimal)
{
    Verifies(req::SRS_EDS_001);
    const Device device =
        DeviceOf(Text("[2000]\nObjectType=9\nSubNumber=3\n[2000sub0]\nDataType=5\nAccessType=const\n"
                      "[2000Sub10]\nDataType=5\nAccessType=rw\n[2000subFE]\nDataType=5\nAccessType=wo\n"));
    EXPECT_EQ(device.Find(0x2000U)->type, ObjectType::kRecord);
    ASSERT_NE(device.Find(0x2000U, 0x10U), nullptr);
    EXPECT_EQ(device.Find(0x2000U, 0xFEU)->access, Access::kWriteOnly);
    EXPECT_EQ(device.Find(0x2000U, 10U), nullptr);
    EXPECT_EQ(device.Find(0x2001U, 0U), nullptr);
}

TEST(DeviceReader, ParameterValueComesBeforeDefaultValueAndEmptyIsNone)
{
    Verifies(req::SRS_EDS_010);
    const Device device = DeviceOf(Text("[2000]\nDataType=5\nAccessType=rw\nDefaultValue=1\nParameterValue=2\n"
                                        "[2001]\nDataType=5\nAccessType=rw\nDefaultValue=1\nParameterValue=\n"
                                        "[2002]\nDataType=5\nAccessType=rw\nDefaultValue=\n"));
    EXPECT_EQ(ConfiguredValue(*device.Find(0x2000U, 0U), std::nullopt).value->bits, 2U);
    EXPECT_EQ(ConfiguredValue(*device.Find(0x2001U, 0U), std::nullopt).value->bits, 1U);
    const ValueResult none = ConfiguredValue(*device.Find(0x2002U, 0U), std::nullopt);
    EXPECT_FALSE(none.value);
    EXPECT_EQ(none.problem.expected, "a ParameterValue or DefaultValue");
}

TEST(DeviceReader, ExpandsACompactObject)
{
    Verifies(req::SRS_EDS_011);
    const Device device = DeviceOf(Text("[1381]\nParameterName=Map\nObjectType=8\nDataType=7\nAccessType=rw\n"
                                        "DefaultValue=0x5\nCompactSubObj=3\n[1381Name]\nNrOfEntries=1\n2=Second\n"
                                        "[1381Value]\nNrOfEntries=2\n0=2\n3=0x20000108\n"));
    ASSERT_EQ(device.Find(0x1381U)->entries.size(), 4U);
    EXPECT_EQ(device.Find(0x1381U, 0U)->data_type, 0x0005U);
    EXPECT_EQ(device.Find(0x1381U, 0U)->default_value.text, "3");
    EXPECT_EQ(device.Find(0x1381U, 0U)->Configured().text, "2");
    EXPECT_EQ(device.Find(0x1381U, 1U)->name, "Map1");
    EXPECT_EQ(device.Find(0x1381U, 1U)->Configured().text, "0x5");
    EXPECT_EQ(device.Find(0x1381U, 2U)->name, "Second");
    EXPECT_EQ(device.Find(0x1381U, 3U)->Configured().text, "0x20000108");
    EXPECT_EQ(device.Find(0x1381U, 3U)->Configured().place.line, 24U);
    EXPECT_EQ(device.Find(0x1381U, 3U)->data_type, 0x0007U);
}

TEST(DeviceReader, ASectionOfItsOwnRefinesACompactSubIndex)
{
    Verifies(req::SRS_EDS_011);
    const Device device =
        DeviceOf(Text("[2000]\nObjectType=8\nDataType=7\nAccessType=rw\nPDOMapping=1\nCompactSubObj=2\n"
                      "[2000sub2]\nDataType=6\nAccessType=ro\nDefaultValue=9\n"));
    EXPECT_EQ(device.Find(0x2000U, 1U)->data_type, 0x0007U);
    EXPECT_EQ(device.Find(0x2000U, 2U)->data_type, 0x0006U);
    EXPECT_EQ(device.Find(0x2000U, 2U)->Configured().text, "9");
    // What has no section has access and mapping flag of the object
    EXPECT_EQ(device.Find(0x2000U, 1U)->access, Access::kReadWrite);
    EXPECT_TRUE(device.Find(0x2000U, 1U)->is_pdo_mappable);
    EXPECT_EQ(device.Find(0x2000U, 2U)->access, Access::kReadOnly);
}

TEST(DeviceReader, ReadsTheNodeIdOfBothSpellings)
{
    Verifies(req::SRS_EDS_009);
    EXPECT_EQ(DeviceOf(Text("[DeviceComissioning]\nNodeID=1\n")).node_id, 1U);
    EXPECT_EQ(DeviceOf(Text("[DeviceComissioning]\nNodeID=0x10\n")).node_id, 16U);
    EXPECT_EQ(DeviceOf(Text("[DeviceComissioning]\nNodeID=127\n")).node_id, 127U);
    EXPECT_EQ(DeviceOf(Text("[DeviceCommissioning]\nNodeID=1\n")).node_id, 1U);
    EXPECT_EQ(DeviceOf(Text("[DeviceCommissioning]\nNODEID=127\n")).node_id, 127U);
    EXPECT_EQ(
        WarningsOf(Text("[DeviceCommissioning]\nNodeID=1\n")),
        std::vector<std::string>{"f:11:1: warning: section [DeviceCommissioning], expected [DeviceComissioning] as "
                                 "CiA 306 writes it"});
    EXPECT_EQ(DeviceOf(Text("[DeviceComissioning]\nNodeID=\n")).node_id, std::nullopt);
    EXPECT_EQ(DeviceOf(Text("")).node_id, std::nullopt);
}

TEST(DeviceReader, TellsKeysThatAreASlipAwayFromKnownOnes)
{
    Verifies(req::SRS_EDS_037);
    // Given an object and a sub-index with a slip in a key, in any case, and a key of a manufacturer
    EXPECT_EQ(WarningsOf(Text("[2000]\nObjectType=9\nSubNumber=1\nSubNumbers=1\n[2000sub0]\nDataType=5\nAccessType=ro\n"
                              "DefaultValue=1\nPARAMTERVALUE=2\nUnit=3\nobjflags=0\n[ManufacturerObjects]\n"
                              "SupportedObjects=1\n1=0x2000\n")),
              (std::vector<std::string>{"f:14:1: warning: unknown key 'SubNumbers' (did you mean 'SubNumber'?) in "
                                        "section '2000', expected one of CiA 306; it is ignored",
                                        "f:19:1: warning: unknown key 'PARAMTERVALUE' (did you mean 'ParameterValue'?) "
                                        "in section '2000sub0', expected one of CiA 306; it is ignored"}));
    // and slips around the objects
    EXPECT_EQ(WarningsOf(test::Changed(Text("[DeviceComissioning]\nNode_ID=1\n"), {{"VendorName=x", "Granularty=1"}})),
              (std::vector<std::string>{"f:2:1: warning: unknown key 'Granularty' (did you mean 'Granularity'?) in "
                                        "section 'DeviceInfo', expected one of CiA 306; it is ignored",
                                        "f:12:1: warning: unknown key 'Node_ID' (did you mean 'NodeID'?) in section "
                                        "'DeviceComissioning', expected one of CiA 306; it is ignored"}));
}

TEST(DeviceReader, TellsOfPdosThatNoSectionDescribes)
{
    Verifies(req::SRS_EDS_150);
    for (const std::string value : {"3", "0x1F", "yes"})
    {
        EXPECT_EQ(WarningsOf(test::Changed(Text(""), {{"VendorName=x", "CompactPDO=" + value}})),
                  (std::vector<std::string>{"f:2:12: warning: CompactPDO is '" + value +
                                            "', expected 0 and a section for each PDO object; those without one are "
                                            "left out"}));
    }
    for (const std::string value : {"0", "0x00", "", "0 ; none"})
    {
        const std::vector<std::string> warnings =
            WarningsOf(test::Changed(Text(""), {{"VendorName=x", "CompactPDO=" + value}}));
        EXPECT_TRUE(warnings.empty() || warnings[0].find("CompactPDO") == std::string::npos) << warnings[0];
    }
}

TEST(DeviceReader, TellsSectionsThatAreASlipAwayFromKnownOnes)
{
    Verifies(req::SRS_EDS_037);
    EXPECT_EQ(WarningsOf(Text("[OptionalObject]\nSupportedObjects=0\n[DeviceComissionning]\nNodeID=1\n"
                              "[dummyusage]\n[Comments]\nLines=0\n[M1ModuleInfo]\n")),
              (std::vector<std::string>{"f:11:1: warning: unknown section 'OptionalObject' (did you mean "
                                        "'OptionalObjects'?), expected one of CiA 306; it is ignored",
                                        "f:13:1: warning: unknown section 'DeviceComissionning' (did you mean "
                                        "'DeviceComissioning'?), expected one of CiA 306; it is ignored"}));
}

TEST(DeviceReader, NodeId255And0MeanNone)
{
    Verifies(req::SRS_EDS_009);
    EXPECT_EQ(DeviceOf(Text("[DeviceComissioning]\nNodeID=255\n")).node_id, std::nullopt);
    EXPECT_EQ(
        WarningsOf(Text("[DeviceComissioning]\nNodeID=255\n")),
        std::vector<std::string>{"f:12:8: warning: NodeID is '255', expected 1 to 127; the device has no node-ID"});
    EXPECT_EQ(DeviceOf(Text("[DeviceComissioning]\nNodeID=0\n")).node_id, std::nullopt);
    EXPECT_EQ(WarningsOf(Text("[DeviceComissioning]\nNodeID=0\n")),
              std::vector<std::string>{"f:12:8: warning: NodeID is '0', expected 1 to 127; the device has no node-ID"});
}

TEST(DeviceReader, ReadsDummyUsageAndTheSafetyFlag)
{
    Verifies(req::SRS_EDS_012);
    const Device device = DeviceOf(Text("[DummyUsage]\nDummy0001=0\ndummy0005=1\nDummy001B=1\n"));
    EXPECT_EQ(device.dummies, (std::set<std::uint16_t>{0x0005U, 0x001BU}));
    EXPECT_EQ(device.is_safety_supported, std::nullopt);
    const std::string yes = test::Changed(Text(""), {{"VendorName=x", "CANopenSafetySupported=1"}});
    const std::string no = test::Changed(Text(""), {{"VendorName=x", "CANopenSafetySupported=0x0"}});
    EXPECT_EQ(DeviceOf(yes).is_safety_supported, true);
    EXPECT_EQ(DeviceOf(no).is_safety_supported, false);
}

TEST(DeviceReader, NoSrdoMapsAnObjectOfTheKernel)
{
    Verifies(req::SRS_EDS_555);
    for (const auto& [index, is_of_kernel] :
         {std::pair(0x12FFU, false), {0x1300U, true}, {0x13FFU, true}, {0x1400U, false}})
    {
        std::ostringstream name;
        name << std::hex << std::uppercase << index;
        for (const auto& [keys, is_mappable] :
             {std::pair("SRDOMapping=1\n", true), {"PDOMapping=1\n", true}, {"SRDOMapping=0\nPDOMapping=1\n", false}})
        {
            // Given an object that is mappable or not
            const std::string text = Text("[" + name.str() + "]\nParameterName=x\nDataType=5\nAccessType=rw\n" + keys);
            const Device device = DeviceOf(text);
            const Entry& entry = *device.Find(static_cast<std::uint16_t>(index), 0U);
            // Then one of 1300h to 13FFh is not, and a warning says so
            EXPECT_EQ(entry.is_srdo_mappable.value_or(entry.is_pdo_mappable), is_mappable && !is_of_kernel) << text;
            const std::vector<std::string> warnings = WarningsOf(text);
            const std::string told = "f:11:1: warning: 0x" + name.str() +
                                     ":00: it is mappable by SRDOMapping or PDOMapping, expected 0 for 0x1300 to "
                                     "0x13FF; no SRDO can map it";
            EXPECT_EQ(std::count(warnings.begin(), warnings.end(), told), (is_of_kernel && is_mappable) ? 1 : 0)
                << text;
        }
    }
}

TEST(DeviceReader, NoSrdoAndNoRpdoMapsASafetyParameter)
{
    Verifies(req::SRS_EDS_730);
    for (const auto& [index, is_parameter] :
         {std::pair("5EFF", false), {"5F00", true}, {"5F02", true}, {"5F05", true}, {"5F06", false}})
    {
        for (const std::string support : {"0", "1"})
        {
            for (const std::string keys : {"SRDOMapping=1\nPDOMapping=1\n", "PDOMapping=1\n"})
            {
                // Given an object that is mappable, of a device with CANopen Safety and of one without
                const std::string text = test::Changed(
                    Text("[" + std::string(index) + "]\nParameterName=x\nDataType=5\nAccessType=rw\n" + keys),
                    {{"VendorName=x\n", "VendorName=x\nCANopenSafetySupported=" + support + "\n"}});
                const Device device = DeviceOf(text);
                const Entry& entry = *device.Find(static_cast<std::uint16_t>(std::stoul(index, nullptr, 16)), 0U);
                const bool is_left_out = is_parameter && support == "1";
                // Then a safety parameter is none, a warning says so, and a TPDO may send it all the same
                EXPECT_EQ(entry.is_srdo_mappable.value_or(entry.is_pdo_mappable), !is_left_out) << text;
                EXPECT_EQ(entry.IsInRpdo(), !is_left_out) << text;
                EXPECT_TRUE(entry.IsInTpdo()) << text;
                const std::vector<std::string> warnings = WarningsOf(text);
                const std::string told = "f:12:1: warning: 0x" + std::string(index) +
                                         ":00: it is mappable by SRDOMapping or PDOMapping, expected 0 for 0x5F00 to "
                                         "0x5F05; no SRDO can map it";
                EXPECT_EQ(std::count(warnings.begin(), warnings.end(), told), is_left_out ? 1 : 0) << text;
            }
        }
    }
    // Of a compact object it is told once
    const std::string compact = Text("[5F02]\nParameterName=x\nObjectType=8\nDataType=0x001B\nAccessType=rw\n"
                                     "CompactSubObj=3\nPDOMapping=1\n[1300]\nParameterName=x\nDataType=5\n"
                                     "AccessType=rw\nPDOMapping=0\n");
    const std::vector<std::string> warnings = WarningsOf(compact);
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), [](const std::string& warning)
                            { return warning.find("no SRDO can map it") != std::string::npos; }),
              1);
    EXPECT_EQ(DeviceOf(compact).Find(0x5F02U, 3U)->is_srdo_mappable, false);
}

TEST(DeviceReader, ReadsInvertedSradWithoutPrefixAsHexadecimalAndWarns)
{
    Verifies(req::SRS_EDS_013);
    const std::string text = test::Changed(Text(""), {{"DefaultValue=0x1", "SRDOMapping=1\nInvertedSRAD=210001"}});
    const Device device = DeviceOf(text);
    EXPECT_EQ(device.Find(0x1000U, 0U)->inverted_srad, 0x210001U);
    EXPECT_EQ(device.Find(0x1000U, 0U)->is_srdo_mappable, true);
    EXPECT_EQ(WarningsOf(text),
              std::vector<std::string>{"f:11:14: warning: 0x1000:00: InvertedSRAD without 0x is read as hexadecimal, "
                                       "expected 0x210001"});
}

TEST(DeviceReader, WarnsOfWhatRealFilesHaveWrong)
{
    Verifies(req::SRS_EDS_015);
    struct Row
    {
        const char* more;
        const char* warning;
    };
    const Row rows[] = {
        {"[2000]\nDataType=5\nAccessType=rw\n", "f:11:1: warning: 0x2000: is in none of the lists [MandatoryObjects], "
                                                "[OptionalObjects], [ManufacturerObjects]"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n",
         "f:13:3: warning: 0x2000: is listed, expected a section that describes it"},
        {"[OptionalObjects]\nSupportedObjects=1\n",
         "f:11:1: warning: section 'OptionalObjects' lists 0 objects, expected SupportedObjects of that number"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nAccessType=rw\n",
         "f:14:1: warning: 0x2000:00: no DataType, expected one; its values are not checked"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nDataType=0x40\nAccessType=rw\n",
         "f:15:10: warning: 0x2000:00: DataType 0x0040 is unknown, expected 0x0001 to 0x001B, or an object "
         "there that describes it; its values are not checked"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nDataType=5\n",
         "f:14:1: warning: 0x2000:00: no AccessType, expected ro, wo, rw, rwr, rww or const"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nDataType=5\nAccessType=rw\nDefaultValue=256\n",
         "f:17:14: warning: 0x2000:00: DefaultValue: value '256', expected a number from 0 to 255 (UNSIGNED8)"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nObjectType=8\nSubNumber=2\n[2000sub0]\nDataType=5\n"
         "AccessType=ro\n",
         "f:16:11: warning: 0x2000: SubNumber is 2, expected 1, the number of its sub-indices"},
        {"[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n[2000]\nDataType=5\nAccessType=ro\n[2000sub0]\nDataType=5\n"
         "AccessType=ro\n",
         "f:14:1: warning: 0x2000 has sub-indices, expected SubNumber, or an ObjectType of 0x8 or 0x9"},
        {"[1000subZ]\nk=v\n", "f:11:1: warning: section '1000subZ' is no object, expected a form such as [1018], "
                              "[1018sub1] or [1018Value]; it is ignored"},
        {"[0x1001]\nk=v\n",
         "f:11:1: warning: section '0x1001' is no object, expected a form such as [1018], [1018sub1] "
         "or [1018Value]; it is ignored"},
        {"[1000Value]\n7=1\n", "f:12:1: warning: key '7' in section '1000Value' names no sub-index of the object, "
                               "expected one; it is ignored"},
        {"[DummyUsage]\nDumm5=1\n",
         "f:12:1: warning: key 'Dumm5' in [DummyUsage], expected Dummy and four digits; it is ignored"},
    };
    EXPECT_TRUE(WarningsOf(Text("")).empty());
    for (const Row& row : rows)
    {
        EXPECT_EQ(WarningsOf(Text(row.more)), std::vector<std::string>{row.warning}) << row.more;
    }
}

TEST(DeviceReader, WarnsOfListsThatContradictEachOther)
{
    Verifies(req::SRS_EDS_038);
    const std::string object = "[1000]\nParameterName=Device type\nDataType=0x0007\nAccessType=ro\nDefaultValue=1\n";
    const std::string info = "[DeviceInfo]\nVendorName=x\n";
    EXPECT_EQ(WarningsOf(info + "[OptionalObjects]\nSupportedObjects=1\n1=0x1000\n" + object),
              std::vector<std::string>{
                  "f:1:1: warning: no section [MandatoryObjects], expected one that lists 0x1000, 0x1001 and 0x1018"});
    EXPECT_EQ(WarningsOf(Text("[OptionalObjects]\nSupportedObjects=1\n1=0x1000\n")),
              std::vector<std::string>{"f:13:3: warning: 0x1000: is listed a second time, in [OptionalObjects], "
                                       "expected it once, as in line 5"});
    EXPECT_EQ(WarningsOf(info + "[MandatoryObjects]\nSupportedObjects=2\n1=0x1000\n2=4096\n" + object),
              std::vector<std::string>{"f:6:3: warning: 0x1000: is listed a second time, in [MandatoryObjects], "
                                       "expected it once, as in line 5"});
}

TEST(DeviceReader, WarnsOfALowLimitAboveTheHighLimit)
{
    Verifies(req::SRS_EDS_038);
    const auto warnings = [](const std::string& type, const std::string& low, const std::string& high)
    {
        return WarningsOf(Text("[DeviceComissioning]\nNodeID=5\n[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n"
                               "[2000]\nAccessType=rw\nDataType=" +
                               type + "\nLowLimit=" + low + "\nHighLimit=" + high + "\n"));
    };
    EXPECT_EQ(warnings("5", "0x20", "0x10"),
              std::vector<std::string>{"f:19:10: warning: 0x2000:00: LowLimit '0x20', expected at most the HighLimit "
                                       "'0x10' of line 20"});
    EXPECT_EQ(warnings("7", "$NODEID+2", "6").size(), 1U); // 7 and 6.
    EXPECT_EQ(warnings("2", "1", "-1").size(), 1U);
    EXPECT_EQ(warnings("2", "0", "0xFF").size(), 1U); // An INTEGER8: -1.
    EXPECT_EQ(warnings("8", "-1.5", "-2.5").size(), 1U);
    EXPECT_EQ(warnings("8", "0.5", "-0.5").size(), 1U);
    for (const auto& [type, low, high] : std::vector<std::array<std::string, 3U>>{{"5", "16", "16"},
                                                                                  {"7", "$NODEID+1", "6"},
                                                                                  {"2", "-128", "127"},
                                                                                  {"8", "-2.5", "-1.5"},
                                                                                  {"8", "-0.5", "0.5"},
                                                                                  {"9", "b", "a"}})
    {
        EXPECT_TRUE(warnings(type, low, high).empty()) << type << " " << low << " " << high;
    }
}

TEST(DeviceReader, KeepsUnknownSectionsAndKeysSilently)
{
    Verifies(req::SRS_EDS_004);
    const std::string text =
        Text("[SupportedModules]\nNrOfEntries=0\n[Vendor tool]\nodd key=1\n[1000Denotation]\n1=x\n");
    EXPECT_TRUE(WarningsOf(text).empty());
    EXPECT_EQ(IniDocument::Parse("f", text).Text(), text);
}

TEST(DeviceReader, AnObjectOfTypeDomainHasThatDataType)
{
    Verifies(req::SRS_EDS_014);
    const Device device =
        DeviceOf(Text("[2000]\nObjectType=0x2\nDataType=0x0007\nAccessType=rw\nDefaultValue=a.bin\n"));
    EXPECT_EQ(device.Find(0x2000U, 0U)->data_type, 0x000FU);
    EXPECT_EQ(device.warnings.size(), 1U); // It is not listed; its value is not judged.
}

TEST(DeviceReader, LeavesOutCommentsBehindNumbersAndWordsAndTellsThem)
{
    Verifies(req::SRS_EDS_035);
    const Device device = test::DeviceOf("[DeviceInfo]\nVendorName=A; B # C\nGranularity=8 ; bit\nLSS_Supported=1#yes\n"
                                         "[DeviceComissioning]\nNodeID=\t5 # five\nNodeName=x # y\n"
                                         "[2000]\nParameterName=Speed # 1; rpm\nDataType=0x0007 ; U32\n"
                                         "AccessType=rw # both\nDefaultValue=5;five\nLowLimit= ; none\n"
                                         "HighLimit=$NODEID+0x10 # own\nPDOMapping=1\t# yes\nInvertedSRAD=210001 ;s\n");
    const Entry& entry = *device.Find(0x2000U, 0U);
    EXPECT_EQ(device.node_id, 5U);
    EXPECT_EQ(device.granularity_bits, 8U);
    EXPECT_TRUE(device.is_lss_supported);
    EXPECT_EQ(entry.name, "Speed # 1; rpm");
    EXPECT_EQ(entry.data_type, 7U);
    EXPECT_EQ(entry.access, Access::kReadWrite);
    EXPECT_EQ(entry.default_value.text, "5");
    EXPECT_FALSE(entry.low_limit.IsSet());
    EXPECT_EQ(entry.high_limit.text, "$NODEID+0x10");
    EXPECT_TRUE(entry.is_pdo_mappable);
    EXPECT_EQ(entry.inverted_srad, 0x210001U);
    std::vector<std::string> places;
    for (const Finding& finding : device.warnings)
    {
        const std::size_t comment = finding.text.find("a comment ");
        if (comment != std::string::npos)
        {
            places.push_back(std::to_string(finding.place.line) + ":" + std::to_string(finding.place.column) + " " +
                             finding.text.substr(10U, finding.text.find(" behind") - 10U));
        }
    }
    EXPECT_EQ(places, (std::vector<std::string>{"3:15 '; bit'", "4:16 '#yes'", "6:11 '# five'", "10:17 '; U32'",
                                                "11:15 '# both'", "12:15 ';five'", "13:11 '; none'", "14:24 '# own'",
                                                "15:14 '# yes'", "16:21 ';s'"}));
}

TEST(DeviceReader, KeepsWhatMayBePartOfAText)
{
    Verifies(req::SRS_EDS_035);
    const auto text_of = [](const std::string& type, const std::string& value)
    {
        const Device device =
            test::DeviceOf("[2000]\nDataType=" + type + "\nAccessType=ro\nDefaultValue=" + value + "\n");
        return device.Find(0x2000U, 0U)->Configured().text;
    };
    EXPECT_EQ(text_of("9", "\"a;b\" # c"), "\"a;b\" # c");
    EXPECT_EQ(text_of("0xA", "01 02 ; 03"), "01 02 ; 03");
    EXPECT_EQ(text_of("0xB", "# 1"), "# 1");
    EXPECT_EQ(text_of("0xF", "a#b"), "a#b");
    EXPECT_EQ(text_of("0x40", "1 # who knows"), "1 # who knows");
    EXPECT_EQ(text_of("8", "1.5 # fits"), "1.5");
    // Names of compact sub-indices, and their values
    const Device compact =
        test::DeviceOf("[2000]\nObjectType=8\nDataType=5\nAccessType=rw\nCompactSubObj=2 ; two\n"
                       "[2000Name]\nNrOfEntries=1\n1=One # 1\n[2000Value]\nNrOfEntries=1\n2=9 # nine\n");
    EXPECT_EQ(compact.Find(0x2000U, 1U)->name, "One # 1");
    EXPECT_EQ(compact.Find(0x2000U, 2U)->Configured().text, "9");
}
} // namespace
} // namespace counterpoint::cia306
