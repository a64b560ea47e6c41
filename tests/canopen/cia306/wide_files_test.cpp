// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Signatures and digests in this file and in the files it reads were computed by Python: binascii.crc_hqx(bytes, 0) is
// the CRC-16 of 13FFh, zlib.crc32(bytes) the CRC-32 of 5F04h.
#include "canopen/cia306/safety/digest.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
namespace
{

using Lines = std::vector<std::string>;

SafetyConfiguration SafetyOf(const Device& device)
{
    return ExtractSafety(device, device.node_id);
}

std::vector<std::uint16_t> SignaturesOf(const std::string& name)
{
    const Device device = test::DeviceOf(test::FileText(name));
    std::vector<std::uint16_t> signatures;
    for (const SrdoConfiguration& srdo : SafetyOf(device).srdos)
    {
        EXPECT_TRUE(srdo.signature_problems.empty());
        signatures.push_back(SignatureOf(srdo));
    }
    return signatures;
}

DigestRecord DigestOfText(const std::string& text)
{
    const Device device = test::DeviceOf(text);
    return ExtractDigest(device, SafetyOf(device), device.node_id);
}

TEST(WideFiles, EachIsSoundAsItStands)
{
    Verifies(req::SRS_CLI_012);
    Verifies(req::SRS_CLI_013);
    Verifies(req::SRS_EDS_028);
    // Given files with 128 entries of one bit, static mappings, dummies of every length, every device parameter
    // Then the check without options finds nothing in them, but that three of them have no digest
    const Lines no_digest{"warning: 0x5F04:00: is missing; a wrong device parameter, 0x1300 included, is not found, "
                          "expected an object of type UNSIGNED32 with the device digest"};
    for (const char* name : {"bits", "static", "dummies"})
    {
        EXPECT_EQ(test::FindingsOf(test::FileText(name), {}), no_digest) << name;
    }
    EXPECT_EQ(test::FindingsOf(test::FileText("digest"), {}), Lines{});
}

/// Whether somebody who checks the text is told that it cannot be right.
bool IsRefused(const std::string& text)
{
    try
    {
        const std::vector<Finding> findings = CheckDevice(test::DeviceOf(text), {});
        return std::any_of(findings.begin(), findings.end(),
                           [](const Finding& finding) { return finding.severity == Severity::kError; });
    }
    catch (const InputError&)
    {
        return true;
    }
}

TEST(WideFiles, EveryCutBeforeTheLastSafetyObjectIsRefused)
{
    Verifies(req::SRS_EDS_031);
    // Given a shipped device's file, whose last object is 5F05h
    const std::string text = ReadTextFile(test::SourceFolder() + "/examples/actuator/actuator.dcf");
    const std::size_t last_object = text.find("[5F05]");
    ASSERT_NE(last_object, std::string::npos);
    EXPECT_FALSE(IsRefused(text));
    // When it ends behind any of the lines before that object
    std::size_t accepted = 0U;
    std::size_t cuts = 0U;
    for (std::size_t end = text.find('\n'); end < last_object; end = text.find('\n', end + 1U))
    {
        ++cuts;
        accepted += IsRefused(text.substr(0U, end + 1U)) ? 0U : 1U;
    }
    // Then each of the cuts is an error but those before the objects are listed
    const std::size_t lists = text.find("[OptionalObjects]");
    const auto lines_before_lists = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(lists), '\n');
    EXPECT_GT(cuts, 600U);
    EXPECT_LE(accepted, static_cast<std::size_t>(lines_before_lists)) << cuts << " cuts";
}

TEST(WideFiles, SignaturesAreThoseOfAnIndependentComputation)
{
    Verifies(req::SRS_EDS_021);
    Verifies(req::SRS_EDS_022);
    EXPECT_EQ(SignaturesOf("bits"), (std::vector<std::uint16_t>{0xCB64U, 0xE463U}));
    EXPECT_EQ(SignaturesOf("static"), (std::vector<std::uint16_t>{0x37B3U, 0x4B9CU}));
    EXPECT_EQ(SignaturesOf("dummies"), (std::vector<std::uint16_t>{0x5780U, 0xB329U}));
    EXPECT_EQ(SignaturesOf("digest"), (std::vector<std::uint16_t>{0xED1FU, 0xA0ADU}));
}

TEST(WideFiles, AllOf128EntriesAreSigned)
{
    Verifies(req::SRS_EDS_020);
    const SafetyConfiguration safety = SafetyOf(test::DeviceOf(test::FileText("bits")));
    ASSERT_EQ(safety.srdos.size(), 2U);
    EXPECT_EQ(safety.srdos[0].mapping.size(), 128U);
    EXPECT_EQ(safety.srdos[0].mapping[127].raw, 0x61204001U);
    const std::vector<std::uint8_t> bytes = CanonicalBytes(safety.srdos[0]);
    ASSERT_EQ(bytes.size(), 653U);
    EXPECT_EQ(bytes[12], 0x80U);
    EXPECT_EQ(HexBytes({bytes.end() - 10, bytes.end()}), "7F 01 40 20 60 80 01 40 20 61");
}

TEST(WideFiles, TypesOfAnyLengthComeFromTheFile)
{
    Verifies(req::SRS_EDS_027);
    // Given a record whose DEFSTRUCT names BOOLEAN, a DEFTYPE of 3 bits and UNSIGNED8, and sub-indices without a type
    const Device device = test::DeviceOf(test::FileText("bits"));
    EXPECT_EQ(device.Find(0x2100U, 0U)->type.bits, 8U);
    EXPECT_EQ(device.Find(0x2100U, 1U)->type.bits, 1U);
    EXPECT_EQ(device.Find(0x2100U, 2U)->type.bits, 3U);
    EXPECT_EQ(device.Find(0x2100U, 2U)->data_type, 0x0040U);
    EXPECT_EQ(device.Find(0x2100U, 3U)->type.bits, 8U);
    // And BIT6 at 0035h
    EXPECT_EQ(test::DeviceOf(test::FileText("dummies")).Find(0x2200U, 2U)->type.bits, 6U);
    EXPECT_TRUE(device.warnings.empty());
    // A DEFTYPE of 0 or 65 bits, or without a value, says nothing
    for (const char* value : {"0", "65", "", "x"})
    {
        const std::string text =
            test::Changed(test::FileText("bits"),
                          {{"ObjectType=0x5\nDataType=0x0007\nAccessType=ro\nDefaultValue=3",
                            std::string("ObjectType=0x5\nDataType=0x0007\nAccessType=ro\nDefaultValue=") + value}});
        EXPECT_EQ(test::DeviceOf(text).Find(0x2100U, 2U)->type.bits, 0U) << value;
    }
    const std::string longest =
        test::Changed(test::FileText("bits"), {{"ObjectType=0x5\nDataType=0x0007\nAccessType=ro\nDefaultValue=3",
                                                "ObjectType=0x5\nDataType=0x0007\nAccessType=ro\nDefaultValue=64"}});
    EXPECT_EQ(test::DeviceOf(longest).Find(0x2100U, 2U)->type.bits, 64U);
    // A member of the structure without a value has its type as DataType; a member that is not there has none
    const std::string member = "ObjectType=0x7\nDataType=0x0006\nAccessType=ro\nDefaultValue=0x0040\n";
    const Device other = test::DeviceOf(
        test::Changed(test::FileText("bits"), {{member, "ObjectType=0x7\nDataType=0x0016\nAccessType=ro\n"}}));
    EXPECT_EQ(other.Find(0x2100U, 2U)->type.bits, 24U);
    const Device without = test::DeviceOf(test::Changed(test::FileText("bits"), {{"[0041sub2]\n", "[0041sub4]\n"}}));
    EXPECT_EQ(without.Find(0x2100U, 2U)->type.bits, 0U);
    // A variable whose type is the structure itself cannot be mapped
    const Device record = test::DeviceOf("[0041]\nObjectType=6\nSubNumber=1\n[2000]\nDataType=0x0041\nAccessType=ro\n");
    EXPECT_EQ(record.Find(0x2000U, 0U)->type.kind, DataKind::kStructure);
    EXPECT_EQ(record.Find(0x2000U, 0U)->type.bits, 0U);
}

TEST(WideFiles, AMappedLengthIsComparedWithTheTypeOfTheFile)
{
    Verifies(req::SRS_CLI_013);
    const auto find = [](const std::string& from, const std::string& to)
    {
        Lines lines;
        for (const std::string& line :
             test::FindingsOf(test::SignedAgain(test::Changed(test::FileText("bits"), {{from, to}}), std::nullopt), {}))
        {
            if (!test::IsFollower(line))
            {
                lines.push_back(line);
            }
        }
        return lines;
    };
    EXPECT_EQ(find("ParameterValue=0x21000203", "ParameterValue=0x21000204"),
              (Lines{"error: 0x1382:03: length of 4 bit, expected 3 bit, the length of 0x2100:02 (DEFTYPE)",
                     "error: 0x1382:04: inverse entry of 3 bit, expected 4 bit as the normal entry before it"}));
    EXPECT_EQ(find("ParameterValue=0x21100101", "ParameterValue=0x21100108"),
              (Lines{"error: 0x1382:02: length of 8 bit, expected 1 bit, the length of 0x2110:01 (BOOLEAN)",
                     "error: 0x1382:02: inverse entry of 8 bit, expected 1 bit as the normal entry before it"}));
    EXPECT_EQ(find("ParameterValue=0x60204001", "ParameterValue=0x60204000"),
              (Lines{"error: 0x1381:7F: length of 0 bit, expected a multiple of 1 bit (granularity)",
                     "error: 0x1381:7F: length of 0 bit, expected 1 bit, the length of 0x6020:40 (BOOLEAN)",
                     "error: 0x1381:80: inverse entry of 1 bit, expected 0 bit as the normal entry before it"}));
}

TEST(WideFiles, GranularityIsThatOfTheFile)
{
    Verifies(req::SRS_EDS_028);
    const auto granularity = [](const std::string& value)
    {
        const Device device =
            test::DeviceOf(test::Changed(test::FileText("bits"), {{"Granularity=1\n", "Granularity=" + value + "\n"}}));
        std::vector<Finding> problems;
        return ReadDeviceParameters(device, device.node_id, problems).granularity_bits;
    };
    EXPECT_EQ(granularity("1"), 1U);
    EXPECT_EQ(granularity("0x40"), 64U);
    EXPECT_EQ(granularity("0"), 8U);
    EXPECT_EQ(granularity(""), 8U);
    EXPECT_EQ(granularity("24"), 8U);
    const auto warnings = [](const std::string& value)
    {
        return test::DeviceOf(
                   test::Changed(test::FileText("bits"), {{"Granularity=1\n", "Granularity=" + value + "\n"}}))
            .warnings;
    };
    EXPECT_TRUE(warnings("0").empty());
    ASSERT_EQ(warnings("24").size(), 1U);
    EXPECT_EQ(warnings("24")[0].text, "Granularity is '24', expected 1, 8, 16, 32 or 64; it is ignored");
    EXPECT_EQ(warnings("24")[0].place.line, 15U);
    EXPECT_EQ(warnings("fine").size(), 1U);
    // The object tells before the key
    const Device device = test::DeviceOf(
        test::Changed(test::FileText("digest"), {{"DefaultValue=0\nParameterValue=1\nPDOMapping=0\n\n[5F00subB]",
                                                  "DefaultValue=0\nParameterValue=32\nPDOMapping=0\n\n[5F00subB]"}}));
    std::vector<Finding> problems;
    EXPECT_EQ(ReadDeviceParameters(device, device.node_id, problems).granularity_bits, 32U);
}

TEST(WideFiles, AStaticMappingIsOneThatNobodyCanWrite)
{
    Verifies(req::SRS_EDS_029);
    EXPECT_TRUE(SafetyOf(test::DeviceOf(test::FileText("static"))).srdos[0].is_static);
    EXPECT_TRUE(SafetyOf(test::DeviceOf(test::FileText("static"))).srdos[1].is_static);
    EXPECT_FALSE(SafetyOf(test::DeviceOf(test::FileText("bits"))).srdos[0].is_static);
    const std::string last = "AccessType=const\nDefaultValue=0x24100308";
    const std::string text = test::FileText("static");
    EXPECT_TRUE(SafetyOf(test::DeviceOf(test::Changed(text, {{last, "AccessType=ro\nDefaultValue=0x24100308"}})))
                    .srdos[1]
                    .is_static);
    EXPECT_FALSE(SafetyOf(test::DeviceOf(test::Changed(text, {{last, "AccessType=rw\nDefaultValue=0x24100308"}})))
                     .srdos[1]
                     .is_static);
    // Nor is one whose number of entries can be written
    const std::string count = "Number of mapped objects\nObjectType=0x7\nDataType=0x0005\nAccessType=";
    EXPECT_FALSE(SafetyOf(test::DeviceOf(test::Changed(
                              text, {{count + "const\nDefaultValue=6\n", count + "rw\nDefaultValue=6\n"}})))
                     .srdos[1]
                     .is_static);
}

TEST(WideFiles, TheEntriesThatAreCountedMakeAMappingStatic)
{
    Verifies(req::SRS_EDS_029);
    const std::string text = test::FileText("static");
    const auto is_static = [&text](const std::vector<test::Change>& changes)
    { return SafetyOf(test::DeviceOf(test::Changed(text, changes))).srdos[1].is_static; };
    const std::string count = "Number of mapped objects\nObjectType=0x7\nDataType=0x0005\nAccessType=";
    const std::string first = "\nDefaultValue=0x24000110";
    const std::string last = "\nDefaultValue=0x24100308";
    // Given six entries, of which one, the first or the last, is neither const nor ro
    for (const char* const access : {"rw", "wo", "rww", "rwr"})
    {
        EXPECT_FALSE(is_static({{"AccessType=const" + first, std::string("AccessType=") + access + first}})) << access;
        EXPECT_FALSE(is_static({{"AccessType=const" + last, std::string("AccessType=") + access + last}})) << access;
    }
    // Given an own one that is not counted any more, then it does not matter
    const std::string six = "const\nDefaultValue=6\n";
    EXPECT_TRUE(is_static(
        {{count + six, count + "const\nDefaultValue=4\n"}, {"AccessType=const" + last, "AccessType=rw" + last}}));
    // Sub-index 0 may be ro, too; with none counted there is nothing that could be static
    EXPECT_TRUE(is_static({{count + six, count + "ro\nDefaultValue=6\n"}}));
    EXPECT_FALSE(is_static({{count + six, count + "const\nDefaultValue=0\n"}}));
}

TEST(WideFiles, TheDigestIsThatOfAnIndependentComputation)
{
    Verifies(req::SRS_EDS_030);
    // Given a file in which every parameter is another than its default
    const DigestRecord record = DigestOfText(test::FileText("digest"));
    EXPECT_TRUE(record.is_present);
    EXPECT_TRUE(record.problems.empty());
    // Then the bytes are those of SRS_CFG_034
    EXPECT_EQ(HexBytes(BytesOf(record.fields)),
              "7F 01 66 99 5A 01 02 D0 07 00 00 EE 02 00 00 28 23 00 00 C0 27 09 00 50 D4 12 00 E8 E5 04 00 4D 00 00 "
              "00 40 E2 01 00 E1 10 00 00 01 02 5A 00 3C FE D4 C3 B2 A1 00 00 00 00 05 00 01 00 FE 88 77 66 55 44 33 "
              "22 11");
    EXPECT_EQ(DigestOf(record.fields), 0x5F9AFA3DU);
    EXPECT_TRUE(record.stored.Is(0x5F9AFA3DU));
    // And the examples have theirs
    EXPECT_EQ(DigestOf(DigestOfText(test::ExampleText("actuator")).fields), 0x046FFAB7U);
}

TEST(WideFiles, WhatGrantsNothingCountsAsZeroInTheDigest)
{
    Verifies(req::SRS_EDS_030);
    const auto byte = [](const std::string& section, const std::string& value, const std::size_t place)
    {
        const DigestRecord record =
            DigestOfText(test::WithValues(test::FileText("digest"), {{section, "ParameterValue", value}}));
        return BytesOf(record.fields).at(place);
    };
    EXPECT_EQ(byte("5F00subC", "0x67", 2U), 0x00U);
    EXPECT_EQ(byte("5F00subD", "0x9A", 3U), 0x00U);
    EXPECT_EQ(byte("5F00subE", "0x01", 4U), 0x00U);
    EXPECT_EQ(byte("5F01sub2", "0x5B", 45U), 0x00U);
    EXPECT_EQ(byte("5F03sub5", "0x02", 59U), 0x00U);
    EXPECT_EQ(byte("5F05sub2", "0x3D", 47U), 0x00U);
}

TEST(WideFiles, AFileWithoutTheObjectOrWithoutAnSrdoHasNoDigest)
{
    Verifies(req::SRS_EDS_030);
    EXPECT_FALSE(DigestOfText(test::FileText("bits")).is_present);
    EXPECT_FALSE(DigestOfText("[5F04]\nDataType=7\nAccessType=rw\nDefaultValue=1\n").is_present);
}

TEST(WideFiles, WhatKeepsTheDigestFromBeingComputedIsReported)
{
    Verifies(req::SRS_EDS_030);
    const auto problem = [](const std::vector<test::Change>& changes)
    {
        const DigestRecord record = DigestOfText(test::Changed(test::FileText("digest"), changes));
        EXPECT_TRUE(record.fields.empty());
        return record.problems.empty() ? std::string() : FormatFinding("f", record.problems.front());
    };
    EXPECT_EQ(
        problem({{"NodeID=127\n", "NodeID=255\n"}}),
        "f:678:16: error: 0x5F04:00: the digest needs the node-ID and there is none, expected --node-id, or NodeID "
        "in [DeviceComissioning]");
    EXPECT_EQ(problem({{"ParameterValue=1234\n", "ParameterValue=1073742\n"}}),
              "f:468:16: error: 0x5F00:04: interval of 1073742 ms, expected at most 1073741 ms");
    EXPECT_EQ(problem({{"ParameterValue=0x5F9AFA3D", "ParameterValue=0x15F9AFA3D"}}),
              "f:678:16: error: 0x5F04:00: value '0x15F9AFA3D', expected a number from 0 to 4294967295 (UNSIGNED32)");
    EXPECT_EQ(
        problem({{"ParameterValue=0x3C\n", "ParameterValue=late\n"}}),
        "f:700:16: error: 0x5F05:02: value 'late', expected a number from 0 to 255 (UNSIGNED8), or $NODEID+number");
}

TEST(WideFiles, TheDigestIsWrittenWithTheSignatures)
{
    Verifies(req::SRS_CLI_021);
    const std::string without = test::Changed(test::FileText("digest"), {{"ParameterValue=0x5F9AFA3D\n", ""}});
    EXPECT_EQ(test::SignedAgain(without, std::nullopt), test::FileText("digest"));
    EXPECT_EQ(test::SignedAgain(test::FileText("digest"), std::nullopt), test::FileText("digest"));
}

TEST(WideFiles, ADigestThatIsNotTheComputedOneIsFound)
{
    Verifies(req::SRS_CLI_022);
    const std::string text = test::FileText("digest");
    const auto find = [&text](const std::vector<test::Change>& changes)
    { return test::FindingsOf(test::Changed(text, changes), {}); };
    const std::string valid = "error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until "
                              "all of them are repaired";
    EXPECT_EQ(find({{"ParameterValue=0x5F9AFA3D", "ParameterValue=0x5F9AFA3E"}}),
              (Lines{valid, "error: 0x5F04:00: device digest 0x5F9AFA3E, expected 0x5F9AFA3D, computed from the "
                            "device's parameters"}));
    const Lines none{"warning: 0x5F04:00: no device digest; a wrong device parameter, 0x1300 included, is not found, "
                     "expected the one that 'counterpoint sign' computes"};
    EXPECT_EQ(find({{"ParameterValue=0x5F9AFA3D", "ParameterValue=0"}}), none);
    EXPECT_EQ(find({{"ParameterValue=0x5F9AFA3D\n", ""}}), none);
    // SRVT detection of SRDO 2: early instead of late
    EXPECT_EQ(find({{"ParameterValue=0x3C\n", "ParameterValue=0\n"}}).size(), 2U);
    EXPECT_EQ(find({{"NodeID=127\n", "NodeID=255\n"}}).back(),
              "error: 0x5F04:00: the digest needs the node-ID and there is none, expected --node-id, or NodeID in "
              "[DeviceComissioning]");
}

/// The collection of real files stands beside the source tree, where it is; else the look-alikes of the tests are read.
std::vector<std::string> DeviceFiles(const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    if (std::filesystem::is_directory(folder))
    {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        {
            const std::string kind = entry.path().extension().string();
            const bool is_device_file = kind == ".eds" || kind == ".dcf";
            if (is_device_file)
            {
                files.push_back(entry.path().string());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> AllDeviceFiles()
{
    std::vector<std::string> files = DeviceFiles(test::SourceFolder() + "/examples");
    for (const char* const folder : {"/tests/canopen/cia306/data", "/tests/runtime", "/tests/simulator"})
    {
        const std::vector<std::string> more = DeviceFiles(test::SourceFolder() + folder);
        files.insert(files.end(), more.begin(), more.end());
    }
    const char* const folder = std::getenv("COUNTERPOINT_DEVICE_FOLDER");
    const std::vector<std::string> real = (folder == nullptr) ? std::vector<std::string>{} : DeviceFiles(folder);
    std::cout << (real.empty() ? "no COUNTERPOINT_DEVICE_FOLDER with real files: only look-alikes are read\n"
                               : std::to_string(real.size()) + " real files are read besides the look-alikes\n");
    files.insert(files.end(), real.begin(), real.end());
    return files;
}

TEST(RealFiles, EveryOneIsReadAndWrittenBackByteByByte)
{
    Verifies(req::SRS_EDS_025);
    Verifies(req::SRS_EDS_026);
    Verifies(req::SRS_EDS_004);
    const std::vector<std::string> files = AllDeviceFiles();
    EXPECT_GE(files.size(), 22U);
    for (const std::string& file : files)
    {
        const std::string text = ReadTextFile(file);
        const IniDocument document = IniDocument::Parse(file, text);
        EXPECT_EQ(document.Text(), text) << file;
        const Device device = ReadDevice(document);
        EXPECT_GE(device.objects.size(), 3U) << file;
        // What was written is read as the same device
        const Device again = ReadDevice(IniDocument::Parse(file, document.Text()));
        EXPECT_EQ(again.node_id, device.node_id) << file;
        EXPECT_EQ(again.warnings.size(), device.warnings.size()) << file;
        EXPECT_TRUE(std::equal(device.objects.begin(), device.objects.end(), again.objects.begin(), again.objects.end(),
                               [](const auto& one, const auto& other)
                               {
                                   return one.first == other.first && one.second.name == other.second.name &&
                                          std::equal(one.second.entries.begin(), one.second.entries.end(),
                                                     other.second.entries.begin(), other.second.entries.end(),
                                                     [](const auto& first, const auto& second)
                                                     {
                                                         return first.first == second.first &&
                                                                first.second.data_type == second.second.data_type &&
                                                                first.second.access == second.second.access &&
                                                                first.second.Configured().text ==
                                                                    second.second.Configured().text;
                                                     });
                               }))
            << file;
        EXPECT_NE(device.Find(0x1000U, 0U), nullptr) << file;
    }
}

TEST(RealFiles, ThoseOfTheFolderThatIsNamedAreAmongThem)
{
    Verifies(req::SRS_EDS_026);
    const char* const before = std::getenv("COUNTERPOINT_DEVICE_FOLDER");
    const std::string kept = (before == nullptr) ? "" : before;
    const std::string named = test::SourceFolder() + "/tests/canopen/cia306/fuzz_seeds";
    ASSERT_EQ(::setenv("COUNTERPOINT_DEVICE_FOLDER", named.c_str(), 1), 0);
    const std::vector<std::string> with = AllDeviceFiles();
    ASSERT_EQ(::unsetenv("COUNTERPOINT_DEVICE_FOLDER"), 0);
    const std::vector<std::string> without = AllDeviceFiles();
    if (before != nullptr)
    {
        ASSERT_EQ(::setenv("COUNTERPOINT_DEVICE_FOLDER", kept.c_str(), 1), 0);
    }
    ASSERT_EQ(with.size(), without.size() + 2U);
    EXPECT_EQ(with.back().rfind(named, 0U), 0U);
}

TEST(RealFiles, ALookAlikeWithEverythingUnusualIsReadAsMeant)
{
    Verifies(req::SRS_EDS_026);
    const Device device = ReadDeviceFile(test::SourceFolder() + "/tests/canopen/cia306/data/unusual.dcf");
    EXPECT_EQ(device.node_id, 5U);
    EXPECT_EQ(device.Find(0x1018U, 4U)->Configured().text, "0x00000004");
    EXPECT_EQ(device.Find(0x1600U, 1U)->Configured().text, "0x20000120");
    EXPECT_EQ(device.Find(0x1028U)->entries.size(), 128U);
    EXPECT_EQ(device.Find(0x1028U, 3U)->Configured().text, "0x00000083");
    EXPECT_EQ(ConfiguredValue(*device.Find(0x1800U, 1U), device.node_id).value->bits, 0x185U);
    EXPECT_EQ(ConfiguredValue(*device.Find(0x1801U, 1U), device.node_id).value->bits, 0x285U);
    EXPECT_EQ(device.Find(0x3000U, 0U)->data_type, 0x000FU);
    EXPECT_EQ(device.Find(0x3001U, 0U)->data_type, 0x0040U);
    EXPECT_EQ(device.Find(0x3002U, 0U)->name, "Temperature [\xB0"
                                              "C]");
    EXPECT_EQ(device.warnings.size(), 6U);
}
} // namespace
} // namespace counterpoint::cia306
