// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// SRDOs that are put into a device file and taken out of it; by the command line: tests/tools.
#include "canopen/cia306/edit/srdo_edit.hpp"

#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/edit/dictionary_edits.hpp"
#include "canopen/cia306/edit/mapping_text.hpp"
#include "canopen/cia306/edit/new_device.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/new_device.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{
using test::Changed;

/// A device file with one SRDO that is sent, of two bytes.
DevicePlan PlanOf(const std::vector<std::string>& sent, const std::vector<std::string>& received)
{
    DevicePlan plan;
    plan.file_name = "device.dcf";
    plan.node_id = 3U;
    plan.name = "Device";
    plan.vendor_name = "Vendor";
    plan.vendor_id = 0x2AU;
    plan.product_code = 7U;
    plan.created = 1'700'000'000;
    std::uint8_t number = 1U;
    for (const std::vector<std::string>* const mappings : {&sent, &received})
    {
        for (const std::string& text : *mappings)
        {
            SrdoPlan srdo;
            srdo.number = number;
            srdo.is_producer = (mappings == &sent);
            srdo.cob_id = 0x101U + (2U * number);
            srdo.pairs = ParseMapping(text).pairs;
            plan.srdos.push_back(srdo);
            ++number;
        }
    }
    return plan;
}

SrdoPlan SrdoOf(const std::uint8_t number, const bool is_producer, const std::string& mapping)
{
    SrdoPlan plan;
    plan.number = number;
    plan.is_producer = is_producer;
    plan.cob_id = 0x151U;
    plan.pairs = ParseMapping(mapping).pairs;
    return plan;
}

IniDocument Parsed(const std::string& text)
{
    return IniDocument::Parse("test.dcf", text);
}

/// The value that an object is configured to have, as the file spells it; "-": there is no such object.
std::string ValueOf(const IniDocument& document, const std::uint16_t index, const std::uint8_t sub)
{
    const Device device = ReadDevice(document);
    const Entry* const entry = device.Find(index, sub);
    if (entry == nullptr)
    {
        return "-";
    }
    return entry->parameter_value.IsSet() ? entry->parameter_value.text : entry->default_value.text;
}

std::string KeyOf(const IniDocument& document, const std::string& section, const std::string& key)
{
    const IniSection* const found = document.Find(section);
    const IniKey* const value = (found == nullptr) ? nullptr : found->Find(key);
    return (value == nullptr) ? "-" : value->value;
}

std::string RefusalOf(const std::function<void()>& act)
{
    try
    {
        act();
    }
    catch (const InputError& error)
    {
        return error.Message();
    }
    return "";
}

std::string RefusalOfAdding(const IniDocument& document, const SrdoPlan& plan,
                            const std::optional<std::uint8_t> node_id = std::uint8_t{3U})
{
    return RefusalOf([&] { static_cast<void>(WithSrdo(document, plan, node_id)); });
}

/// A plain device without anything of CANopen Safety: 2000h of 16 bits, 2001h an array, 2002h a string.
std::string PlainText()
{
    return "[DeviceInfo]\nVendorName=test\n\n[OptionalObjects]\nSupportedObjects=1\n1=0x1018\n\n"
           "[ManufacturerObjects]\nSupportedObjects=1\n7=0x2000\n\n"
           "[2000]\nParameterName=Speed\nObjectType=0x7\nDataType=0x0003\nAccessType=rw\nDefaultValue=-2\n"
           "ParameterValue=5\nPDOMapping=0\n\n"
           "[2001]\nParameterName=Values\nObjectType=0x8\nDataType=0x0005\nAccessType=rw\nDefaultValue=0\n"
           "CompactSubObj=3\n\n"
           "[2002]\nParameterName=Name\nObjectType=0x7\nDataType=0x0009\nAccessType=rw\nDefaultValue=x\n\n"
           "[2003]\nParameterName=Node\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nDefaultValue=$NODEID+1\n\n"
           "[2004]\nParameterName=Nothing\nObjectType=0x7\nDataType=0x0002\nAccessType=rw\nDefaultValue=\n\n";
}

TEST(NewDevice, HasWhatItsPlanSays)
{
    Verifies(req::SRS_NEW_001);
    DevicePlan plan = PlanOf({"2x8"}, {"16"});
    plan.is_gfc_on = true;
    plan.bit_rate_kbit = 250U;
    const IniDocument document = NewDevice("device.dcf", plan);
    EXPECT_EQ(KeyOf(document, "FileInfo", "CreationDate"), "11-14-2023");
    EXPECT_EQ(KeyOf(document, "FileInfo", "CreationTime"), "10:13PM");
    EXPECT_EQ(KeyOf(document, "DeviceInfo", "BaudRate_250"), "1");
    EXPECT_EQ(KeyOf(document, "DeviceInfo", "BaudRate_500"), "0");
    EXPECT_EQ(KeyOf(document, "DeviceComissioning", "NodeID"), "3");
    EXPECT_EQ(ValueOf(document, 0x1018U, 1U), "0x0000002A");
    EXPECT_EQ(ValueOf(document, 0x1300U, 0U), "1");
    EXPECT_EQ(ValueOf(document, 0x1301U, 1U), "1");
    EXPECT_EQ(ValueOf(document, 0x1302U, 1U), "2");
    EXPECT_EQ(ValueOf(document, 0x1301U, 5U), "0x00000103");
    EXPECT_EQ(ValueOf(document, 0x1301U, 6U), "0x00000104");
    EXPECT_EQ(ValueOf(document, 0x1381U, 0U), "4");
    EXPECT_EQ(ValueOf(document, 0x1381U, 1U), "0x20000108");
    EXPECT_EQ(ValueOf(document, 0x1381U, 2U), "0x21000108");
    EXPECT_EQ(ValueOf(document, 0x1382U, 1U), "0x22000110");
    EXPECT_EQ(ValueOf(document, 0x2100U, 2U), "0xFF"); // The inverse of 0.
    EXPECT_EQ(ValueOf(document, 0x13FEU, 0U), "0xA5");
    EXPECT_EQ(ValueOf(document, 0x5F03U, 1U), "0x01");
    EXPECT_EQ(KeyOf(document, "MandatoryObjects", "SupportedObjects"), "3");
    EXPECT_EQ(KeyOf(document, "ManufacturerObjects", "1"), "0x2000");
    // Without the GFC, and nothing that check would find
    plan.is_gfc_on = false;
    const IniDocument quiet = NewDevice("device.dcf", plan);
    EXPECT_EQ(ValueOf(quiet, 0x1300U, 0U), "0");
    EXPECT_TRUE(CheckDevice(ReadDevice(quiet), {std::nullopt, std::nullopt}).empty());
}

TEST(SrdoEdit, AConsumerHasTheValuesThatAreNotTheDefault)
{
    Verifies(req::SRS_NEW_010);
    const IniDocument device = NewDevice("device.dcf", PlanOf({"8"}, {}));
    SrdoPlan plan = SrdoOf(2U, false, "i16,8");
    plan.is_automatic = true;
    plan.is_late = true;
    plan.safe_value = 0x55U;
    const IniDocument document = WithSrdo(device, plan, std::uint8_t{3U});
    EXPECT_EQ(ValueOf(document, 0x5F01U, 2U), "0x5A");
    EXPECT_EQ(ValueOf(document, 0x5F02U, 2U), "0x0000000000000055");
    EXPECT_EQ(ValueOf(document, 0x5F05U, 2U), "0x3C");
    EXPECT_EQ(ValueOf(document, 0x2300U, 1U), "-1"); // Of a signed object, all bits.
    EXPECT_EQ(ValueOf(document, 0x13FEU, 0U), "0xA5");
    EXPECT_NE(ValueOf(document, 0x13FFU, 2U), "0x0000");
    EXPECT_EQ(KeyOf(document, "2200sub1", "InvertedSRAD"), "0x230001");
    EXPECT_EQ(FreeSrdoNumber(ReadDevice(document)), 3U);
}

TEST(SrdoEdit, APlainDeviceGetsAllThatSafetyNeeds)
{
    Verifies(req::SRS_NEW_010);
    Verifies(req::SRS_NEW_011);
    const IniDocument plain = Parsed(PlainText());
    // Given no node-ID, then there is no digest and no default of the COB-IDs
    const IniDocument document = WithSrdo(plain, SrdoOf(1U, true, "8"), std::nullopt);
    EXPECT_EQ(KeyOf(document, "DeviceInfo", "CANopenSafetySupported"), "1");
    EXPECT_EQ(ValueOf(document, 0x5F04U, 0U), "-");
    EXPECT_EQ(KeyOf(document, "1301sub5", "DefaultValue"), "0x00000000");
    EXPECT_EQ(ValueOf(document, 0x1300U, 0U), "0");
    EXPECT_EQ(ValueOf(document, 0x5F03U, 1U), "0x01");
    EXPECT_EQ(ValueOf(document, 0x5F01U, 1U), "-"); // Each SRDO has its default.
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "SupportedObjects"), "6");
    // What the file has stands where it stood
    EXPECT_EQ(KeyOf(document, "ManufacturerObjects", "7"), "0x2000");
    EXPECT_EQ(KeyOf(document, "ManufacturerObjects", "8"), "0x2005");
    // With one, there is
    const IniDocument told = WithSrdo(plain, SrdoOf(1U, true, "8"), std::uint8_t{3U});
    EXPECT_NE(ValueOf(told, 0x5F04U, 0U), "-");
    EXPECT_EQ(KeyOf(told, "1301sub5", "DefaultValue"), "0x00000105");
    EXPECT_EQ(KeyOf(told, "1301sub6", "DefaultValue"), "0x00000106");
}

TEST(SrdoEdit, ObjectsOfTheFileGoWithTheirInverse)
{
    Verifies(req::SRS_NEW_013);
    const IniDocument plain = Parsed(PlainText());
    const IniDocument document =
        WithSrdo(plain, SrdoOf(2U, false, "0x2000:00,8,0x2003:00,0x2004:00,0x2001:01/0x2001:02"), std::uint8_t{3U});
    // -2 and 5 of 16 bits, node-ID 3 + 1 of 8, nothing of a signed byte
    EXPECT_EQ(KeyOf(document, "2000", "InvertedSRAD"), "0x220100");
    EXPECT_EQ(KeyOf(document, "2201", "DefaultValue"), "1");
    EXPECT_EQ(KeyOf(document, "2201", "ParameterValue"), "-6");
    EXPECT_EQ(KeyOf(document, "2202", "DefaultValue"), "0xFB");
    EXPECT_EQ(KeyOf(document, "2203", "DefaultValue"), "-1");
    EXPECT_EQ(KeyOf(document, "2201", "AccessType"), "rww");
    EXPECT_EQ(ValueOf(document, 0x1382U, 1U), "0x20000010");
    EXPECT_EQ(ValueOf(document, 0x1382U, 3U), "0x22000108"); // The new one between them.
    EXPECT_EQ(ValueOf(document, 0x1382U, 9U), "0x20010108");
    EXPECT_EQ(ValueOf(document, 0x1382U, 10U), "0x20010208");
    // A second SRDO takes the inverse object that is named there by now
    const IniDocument again = WithSrdo(document, SrdoOf(3U, true, "0x2000:00"), std::uint8_t{3U});
    EXPECT_EQ(ValueOf(again, 0x1383U, 2U), "0x22010010");
}

TEST(SrdoEdit, InverseDataIsNoNormalData)
{
    Verifies(req::SRS_NEW_730);
    // Given 2100h:01, sent as the inverse of 2000h:01
    const IniDocument document = NewDevice("device.dcf", PlanOf({"8"}, {}));
    ASSERT_EQ(KeyOf(document, "2000sub1", "InvertedSRAD"), "0x210001");
    for (const bool is_producer : {true, false})
    {
        for (const std::string mapping : {"0x2100:01", "0x2100:01/0x2000:01", "8,0x2100:01"})
        {
            EXPECT_EQ(RefusalOfAdding(document, SrdoOf(2U, is_producer, mapping)),
                      "0x2100:01 is the InvertedSRAD of 0x2000:01, expected normal data, such as 0x2000:01")
                << mapping;
        }
        EXPECT_EQ(RefusalOfAdding(document, SrdoOf(2U, is_producer, "0x2000:01")), "");
    }
}

TEST(SrdoEdit, ASafetyObjectIsNoData)
{
    Verifies(req::SRS_NEW_730);
    const IniDocument document = NewDevice("device.dcf", PlanOf({"8"}, {}));
    for (const std::string object : {"0x1300:00", "0x13FF:01", "0x5F00:01", "0x5F04:00", "0x5F05:01"})
    {
        EXPECT_EQ(RefusalOfAdding(document, SrdoOf(2U, true, object)),
                  object + " is a safety object of the device, expected an object of the application");
        EXPECT_EQ(RefusalOfAdding(document, SrdoOf(2U, false, object + "/0x2100:01")),
                  object + " is a safety object of the device, expected an object of the application");
    }
    // Of a device that is going to have one, too
    const IniDocument plain = Parsed(PlainText() + test::VariableText("5F04", "0x0007", "0"));
    EXPECT_EQ(RefusalOfAdding(plain, SrdoOf(1U, true, "0x5F04:00")),
              "0x5F04:00 is a safety object of the device, expected an object of the application");
    EXPECT_EQ(
        RefusalOfAdding(Parsed(PlainText() + test::VariableText("5F06", "0x0007", "0")), SrdoOf(1U, true, "0x5F06:00")),
        "");
    EXPECT_EQ(
        RefusalOfAdding(Parsed(PlainText() + test::VariableText("12FF", "0x0007", "0")), SrdoOf(1U, true, "0x12FF:00")),
        "");
}

TEST(SrdoEdit, WhatCannotBeMappedIsRefused)
{
    Verifies(req::SRS_NEW_012);
    const IniDocument plain = Parsed(PlainText());
    EXPECT_EQ(
        RefusalOfAdding(plain, SrdoOf(1U, true, "0x2009:00")),
        "0x2009:00 is not in the file, expected an object that it describes, or a length such as 8 for a new one");
    EXPECT_EQ(RefusalOfAdding(plain, SrdoOf(1U, true, "0x2002:00")).substr(0U, 16U), "0x2002:00 is of ");
    EXPECT_EQ(RefusalOfAdding(plain, SrdoOf(1U, true, "0x2001:01")),
              "0x2001:01 of a compact object has no inverse object, expected one that is named behind it, such as "
              "0x2001:01/0x2100:01");
    const IniDocument once = WithSrdo(plain, SrdoOf(2U, true, "8"), std::uint8_t{3U});
    EXPECT_EQ(RefusalOfAdding(once, SrdoOf(2U, true, "8")), "SRDO 2 is there already, expected a number that is free");
    // Also where the file lists it only, or has its mapping alone
    for (const std::string listed : {"0x1301", "0x1381"})
    {
        const IniDocument missing = Parsed(Changed(PlainText(), {{"1=0x1018", "1=" + listed}}));
        EXPECT_EQ(RefusalOfAdding(missing, SrdoOf(1U, true, "8")),
                  "SRDO 1 is there already, expected a number that is free");
        EXPECT_EQ(FreeSrdoNumber(ReadDevice(missing)), 2U);
    }
}

TEST(SrdoEdit, ManufacturersObjectsCanBeUsedUp)
{
    Verifies(req::SRS_NEW_012);
    // Given a file that lists every index from 2000h to 5DFFh
    std::string list = "[ManufacturerObjects]\nSupportedObjects=15872\n";
    for (int index = 0x2000; index <= 0x5DFF; ++index)
    {
        list += std::to_string(index - 0x1FFF) + "=0x" + test::HexIndex(index) + "\n";
    }
    const IniDocument full =
        Parsed("[DeviceInfo]\nVendorName=test\n\n" + list + "\n" + test::VariableText("1000", "0x0007", "0"));
    EXPECT_EQ(RefusalOfAdding(full, SrdoOf(1U, true, "8")),
              "no index is free for a new object, expected one from 0x2000 to 0x5DFF");
}

TEST(SrdoEdit, ArraysAreLengthenedAsTheyAreWritten)
{
    Verifies(req::SRS_NEW_011);
    // Given 13FFh with SubNumber and sub-index 0, a compact 5F02h, 5F01h without a sub-index 0, a 5F00h with little
    // room
    std::string text = PlainText();
    text += "[13FF]\nParameterName=s\nObjectType=0x8\nSubNumber=2\n\n" + test::VariableText("13FFsub0", "0x0005", "1") +
            test::VariableText("13FFsub1", "0x0006", "0");
    text += "[5F00]\nParameterName=p\nObjectType=0x9\nSubNumber=2\n\n" +
            test::VariableText("5F00sub0", "0x0005", "11") + test::VariableText("5F00subB", "0x0005", "2");
    text += "[5F01]\nParameterName=r\nObjectType=0x8\n\n" + test::VariableText("5F01sub1", "0x0005", "0");
    text += "[5F02]\nParameterName=v\nObjectType=0x8\nDataType=0x001B\nAccessType=rw\nDefaultValue=0\n"
            "CompactSubObj=1\n\n";
    SrdoPlan plan = SrdoOf(2U, false, "2x8");
    plan.is_automatic = true;
    plan.safe_value = 1U;
    const IniDocument document = WithSrdo(Parsed(text), plan, std::nullopt);
    EXPECT_EQ(KeyOf(document, "13FF", "SubNumber"), "3");
    EXPECT_EQ(KeyOf(document, "13FFsub0", "DefaultValue"), "2");
    EXPECT_EQ(KeyOf(document, "5F01", "SubNumber"), "-");
    EXPECT_EQ(ValueOf(document, 0x5F01U, 2U), "0x5A");
    EXPECT_EQ(KeyOf(document, "5F02", "CompactSubObj"), "2");
    EXPECT_EQ(ValueOf(document, 0x5F00U, 0x0BU), "0x04"); // Two pairs.
    // One whose sub-index 0 has a value of its own, and one that has the place already
    const std::string counted =
        Changed(text, {{"[13FFsub0]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nDefaultValue=1\n",
                        "[13FFsub0]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nDefaultValue=1\n"
                        "ParameterValue=1\n"}});
    const IniDocument with_count = WithSrdo(Parsed(counted), plan, std::nullopt);
    EXPECT_EQ(KeyOf(with_count, "13FFsub0", "ParameterValue"), "2");
    const IniDocument first = WithSrdo(Parsed(text), SrdoOf(1U, false, "8"), std::nullopt);
    EXPECT_EQ(KeyOf(first, "13FF", "SubNumber"), "2");
    EXPECT_EQ(KeyOf(first, "13FFsub0", "DefaultValue"), "1");
}

TEST(SrdoEdit, ANewObjectStandsBehindTheOneBeforeIt)
{
    Verifies(req::SRS_NEW_011);
    // Given a file without lists, whose only object stands behind other sections
    const IniDocument bare = Parsed("[FileInfo]\nFileName=x\n\n[Comments]\nLines=0\n\n" +
                                    test::VariableText("1500", "0x0005", "0") + "[1500Name]\nNrOfEntries=0\n\n");
    const IniDocument document = WithSrdo(bare, SrdoOf(1U, true, "8"), std::nullopt);
    std::vector<std::string> sections;
    for (const IniSection& section : document.Sections())
    {
        sections.push_back(section.name);
    }
    const std::string text = document.Text();
    EXPECT_LT(text.find("[Comments]"), text.find("[1300]"));
    EXPECT_LT(text.find("[1300]"), text.find("[1301]"));
    EXPECT_LT(text.find("[1381sub2]"), text.find("[1500]"));
    EXPECT_LT(text.find("[1500Name]"), text.find("[2000]"));
    EXPECT_LT(text.find("[2000sub1]"), text.find("[2100]"));
    EXPECT_EQ(KeyOf(document, "ManufacturerObjects", "SupportedObjects"), "3"); // 2000h, 2100h and 5F03h.
    EXPECT_EQ(document.Find("DeviceInfo"), nullptr);
}

TEST(SrdoEdit, NewObjectsStandBehindTheFirstSectionWhereThatIsAnObject)
{
    Verifies(req::SRS_NEW_011);
    const IniDocument first = Parsed(test::VariableText("1500", "0x0005", "0") + "[DeviceInfo]\nVendorName=test\n");
    const std::string text = WithSrdo(first, SrdoOf(1U, true, "8"), std::nullopt).Text();
    EXPECT_LT(text.find("[1500]"), text.find("[1300]"));
    EXPECT_LT(text.find("[1381sub2]"), text.find("[DeviceInfo]"));
}

TEST(SrdoEdit, WhatIsThereAlreadyIsKept)
{
    Verifies(req::SRS_NEW_010);
    Verifies(req::SRS_NEW_011);
    // Given 13FFh with all its places, 13FEh that is not valid, a device that says in 5F00h whether it has the GFC
    const std::string common =
        test::VariableText("13FE", "0x0005", "0") + "[5F00]\nParameterName=p\nObjectType=0x9\n\n" +
        test::VariableText("5F00sub0", "0x0005", "14") + test::VariableText("5F00subE", "0x0005", "0");
    const std::string text = "[DeviceInfo]\nVendorName=test\nCANopenSafetySupported=1\n\n" + common +
                             test::VariableText("2100", "0x0005", "0") + "[13FF]\nParameterName=s\nObjectType=0x8\n\n" +
                             test::VariableText("13FFsub0", "0x0005", "64");
    const std::string invalid = Changed(text, {{"[13FE]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\n",
                                                "[13FE]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\n"
                                                "ParameterValue=0x00\n"}});
    const IniDocument document = WithSrdo(Parsed(invalid), SrdoOf(1U, true, "Speed=16"), std::nullopt);
    EXPECT_EQ(ValueOf(document, 0x13FEU, 0U), "0xA5");
    EXPECT_EQ(document.Find("1300"), nullptr);
    EXPECT_EQ(KeyOf(document, "13FFsub0", "DefaultValue"), "64");
    EXPECT_EQ(KeyOf(document, "13FFsub0", "ParameterValue"), "-");
    // 2000h is free, and 2100h behind it is not
    EXPECT_EQ(document.Find("2000"), nullptr);
    EXPECT_EQ(KeyOf(document, "2001sub1", "ParameterName"), "Speed");
    EXPECT_EQ(KeyOf(document, "2101sub1", "ParameterName"), "Speed, inverse");
    // A value that only a node-ID would give is none that counts
    const std::string unknown =
        Changed(invalid, {{"ParameterValue=0x00", "ParameterValue=$NODEID"},
                          {"AccessType=rw\nDefaultValue=64", "AccessType=rw\nDefaultValue=$NODEID"}});
    const IniDocument set = WithSrdo(Parsed(unknown), SrdoOf(1U, true, "8"), std::nullopt);
    EXPECT_EQ(ValueOf(set, 0x13FEU, 0U), "0xA5");
    EXPECT_EQ(KeyOf(set, "13FFsub0", "DefaultValue"), "$NODEID");
}

TEST(SrdoEdit, AnObjectThatIsSentGetsAnInverseThatIsReadOnly)
{
    Verifies(req::SRS_NEW_013);
    const IniDocument document = WithSrdo(Parsed(PlainText()), SrdoOf(1U, true, "0x2000:00"), std::nullopt);
    EXPECT_EQ(KeyOf(document, "2005", "AccessType"), "ro");
    EXPECT_EQ(KeyOf(document, "2000", "InvertedSRAD"), "0x200500");
}

TEST(SrdoEdit, NumbersCanBeUsedUp)
{
    Verifies(req::SRS_NEW_010);
    std::string list = "[OptionalObjects]\nSupportedObjects=64\n";
    for (int number = 1; number <= 64; ++number)
    {
        list += std::to_string(number) + "=0x" + test::HexIndex(0x1300 + number) + "\n";
    }
    const std::string head = "[DeviceInfo]\nVendorName=test\n\n" + test::VariableText("1000", "0x0007", "0");
    EXPECT_FALSE(FreeSrdoNumber(test::DeviceOf(head + list)));
    EXPECT_EQ(FreeSrdoNumber(test::DeviceOf(head + Changed(list, {{"64=0x1340", "64=0x1018"}}))), 64U);
    // A mapping alone takes its number, too
    EXPECT_EQ(FreeSrdoNumber(test::DeviceOf(head + test::VariableText("1381", "0x0005", "0"))), 2U);
}

TEST(DictionaryEditsTest, AnObjectIsListedWhereItsIndexBelongs)
{
    Verifies(req::SRS_NEW_011);
    const IniDocument plain = Parsed(PlainText());
    const Device device = ReadDevice(plain);
    DictionaryEdits edits(plain, device);
    edits.Add({0x6000U, "", ObjectType::kVar, {{0U, "Profile", kUnsigned8, "rw", "0"}}});
    EXPECT_FALSE(edits.IsFree(0x6000U));
    const IniDocument document = edits.Apply();
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "2"), "0x6000");
    EXPECT_EQ(KeyOf(document, "ManufacturerObjects", "SupportedObjects"), "1");
    EXPECT_EQ(ValueOf(document, 0x6000U, 0U), "0");
}

TEST(SrdoRemoval, AnSrdoWithoutItsMappingIsLeftOutToo)
{
    Verifies(req::SRS_NEW_015);
    const std::string text =
        test::SrdoFileText({{1, "1", "50", "20", "0x101", "0x102", {}}, {2, "1", "50", "20", "0x103", "0x104", {}}});
    const std::string without = text.substr(0U, text.find("[1381]")) + text.substr(text.find("[1302]"));
    const IniDocument document = WithoutSrdo(Parsed(without), 1U, std::nullopt);
    EXPECT_EQ(document.Find("1301"), nullptr);
    EXPECT_NE(document.Find("1302"), nullptr);
}

TEST(SrdoRemoval, IsTheReverseButForObjectsAndPlaces)
{
    Verifies(req::SRS_NEW_015);
    const IniDocument two = NewDevice("device.dcf", PlanOf({"8", "16"}, {"8"}));
    ASSERT_EQ(ValueOf(two, 0x5F03U, 2U), "0x01");
    const IniDocument document = WithoutSrdo(two, 2U, std::uint8_t{3U});
    EXPECT_EQ(document.Find("1302"), nullptr);
    EXPECT_EQ(document.Find("1382sub1"), nullptr);
    EXPECT_EQ(ValueOf(document, 0x13FFU, 2U), "0x0000");
    EXPECT_EQ(ValueOf(document, 0x5F03U, 2U), "0x00");
    EXPECT_EQ(ValueOf(document, 0x2001U, 1U), "0"); // What was mapped stays.
    EXPECT_NE(ValueOf(document, 0x13FFU, 3U), "0x0000");
    EXPECT_EQ(std::stoi(KeyOf(two, "OptionalObjects", "SupportedObjects")) - 2,
              std::stoi(KeyOf(document, "OptionalObjects", "SupportedObjects")));
    EXPECT_TRUE(CheckDevice(ReadDevice(document), {std::nullopt, std::nullopt}).empty());
}

TEST(SrdoRemoval, EachValueThatIsNotZeroIsSetToZero)
{
    Verifies(req::SRS_NEW_015);
    // Given a consumer with an automatic release, late detection and a safe value
    SrdoPlan plan = SrdoOf(2U, false, "i16,8");
    plan.is_automatic = true;
    plan.is_late = true;
    plan.safe_value = 0x55U;
    const IniDocument two = WithSrdo(NewDevice("device.dcf", PlanOf({"8"}, {})), plan, std::uint8_t{3U});
    const IniDocument document = WithoutSrdo(two, 2U, std::uint8_t{3U});
    EXPECT_EQ(ValueOf(document, 0x13FFU, 2U), "0x0000");
    EXPECT_EQ(ValueOf(document, 0x5F01U, 2U), "0x00");
    EXPECT_EQ(ValueOf(document, 0x5F02U, 2U), "0x0000000000000000");
    EXPECT_EQ(ValueOf(document, 0x5F05U, 2U), "0x00");
    EXPECT_TRUE(CheckDevice(ReadDevice(document), {std::nullopt, std::nullopt}).empty());
}

TEST(SrdoRemoval, WhatMustStayIsRefused)
{
    Verifies(req::SRS_NEW_015);
    const IniDocument one = NewDevice("device.dcf", PlanOf({"8"}, {}));
    EXPECT_EQ(RefusalOf([&one] { static_cast<void>(WithoutSrdo(one, 2U, std::uint8_t{3U})); }),
              "there is no SRDO 2, expected one that the file has (srdo list)");
    EXPECT_EQ(RefusalOf([&one] { static_cast<void>(WithoutSrdo(one, 1U, std::uint8_t{3U})); }),
              "SRDO 1 is the only one, expected another one that stays: a safety device needs one");
}

TEST(SrdoRemoval, ListsAreShortenedAsTheyAreWritten)
{
    Verifies(req::SRS_NEW_015);
    // Given lists that name the SRDOs in between, one with a comment behind it, a key that is no place, and a file
    // without two of the lists
    const std::string text =
        "[OptionalObjects]\nSupportedObjects=4\n1=0x1301\n2=0x1302\n3=0x1381 ; "
        "mapping\n4=0x1018\n5=0x1382\nNote=y\n\n" +
        test::SrdoFileText({{1, "1", "50", "20", "0x101", "0x102", {}}, {2, "1", "50", "20", "0x103", "0x104", {}}});
    const IniDocument document = WithoutSrdo(Parsed(text), 1U, std::nullopt);
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "SupportedObjects"), "3");
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "1"), "0x1302");
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "2"), "0x1018");
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "3"), "0x1382 ; mapping"); // The rest of the line.
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "4"), "-");
    EXPECT_EQ(KeyOf(document, "OptionalObjects", "Note"), "y");
    EXPECT_EQ(document.Find("1301"), nullptr);
    EXPECT_NE(document.Find("1302"), nullptr);
}
} // namespace
} // namespace counterpoint::cia306
