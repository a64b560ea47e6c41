// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/srdo_rig.hpp"
#include "verification/trace/ids/new_device.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using test::Answer;
using test::CommunicationText;
using test::Counted;
using test::LastText;
using test::MappingText;
using test::ObjectsText;
using test::PlaceText;
using test::RunCommand;

using SrdoCommandTest = test::SrdoRig;

TEST_F(SrdoCommandTest, AddingChangesNothingButWhatBelongsToTheSrdo)
{
    Verifies(req::SRS_NEW_010);
    Verifies(req::SRS_NEW_011);
    Verifies(req::SRS_NEW_151);
    Verifies(req::SRS_NEW_152);
    // Given the sensor with SRDO 1, a comment and a signature in lower case
    const std::string before =
        Changed(ExampleText("sensor"), {{"[5F00]\n", "; of this maker\n[5F00]\n"}, {"0xB631", "0xb631"}});
    // When SRDO 2 is added
    const Answer answer = Add(before, {"--consume", "8@0x111"});
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, "SRDO 1 sends 0x101 and 0x102, refresh time 25 ms, SRVT 20 ms, signature 0xB631\n"
                          "  0x2000:01 and 0x2100:01  8 bit  Button 1\n  0x2000:02 and 0x2100:02  8 bit  Button 2\n"
                          "SRDO 2 receives 0x111 and 0x112, SCT 50 ms, SRVT 20 ms, signature 0xE070\n"
                          "  0x2200:01 and 0x2300:01  8 bit  Received data 2.1\n");
    // Then every line but these is as it was; E070h was computed by hand over
    // 02 32 00 14 11 01 00 00 12 01 00 00 02 01 08 01 00 22 02 08 01 00 23.
    EXPECT_EQ(
        Written(),
        Changed(before,
                {{"SupportedObjects=8\n1=0x1014", "SupportedObjects=10\n1=0x1014"},
                 {"8=0x13FF\n", "8=0x13FF\n9=0x1302\n10=0x1382\n"},
                 {"SupportedObjects=8\n1=0x2000", "SupportedObjects=10\n1=0x2000"},
                 {"8=0x5F05\n", "8=0x5F05\n9=0x2200\n10=0x2300\n"},
                 {"[1381]\n", CommunicationText() + "[1381]\n"},
                 {"[13FE]\n", MappingText() + "[13FE]\n"},
                 Counted("13FF", "Safety configuration signature"),
                 {"[2000]\n", PlaceText("13FFsub2", "Signature of SRDO 2", "0x0006", "0x0000", "0xE070") + "[2000]\n"},
                 {"; of this maker\n", ObjectsText() + "; of this maker\n"},
                 Counted("5F01", "Release policy"),
                 {"[5F02]\n", PlaceText("5F01sub2", "Release policy of SRDO 2", "0x0005", "0x00", "0x00") + "[5F02]\n"},
                 Counted("5F02", "Safe value"),
                 {"[5F03]\n",
                  PlaceText("5F02sub2", "Safe value of SRDO 2", "0x001B", "0x0000000000000000", "0x0000000000000000") +
                      "[5F03]\n"},
                 Counted("5F03", "Producer form"),
                 {"[5F04]\n", PlaceText("5F03sub2", "Producer form of SRDO 2", "0x0005", "0x00", "0x00") + "[5F04]\n"},
                 {"ParameterValue=0x66596575", "ParameterValue=0xF93CA8D8"},
                 Counted("5F05", "SRVT detection")}) +
            "\n" + LastText().substr(0U, LastText().size() - 1U));
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out, "");
}

TEST_F(SrdoCommandTest, SrdoHasWhatItsOptionsSay)
{
    Verifies(req::SRS_NEW_151);
    const Answer answer =
        Add(ExampleText("actuator"), {"--consume", "Gate=16,8@0x121", "--number", "2", "--sct", "80", "--srvt", "30",
                                      "--detection", "late", "--release", "automatic", "--safe-value", "0x00FFFF"});
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(Value(0x1302U, 2U), "80");
    EXPECT_EQ(Value(0x1302U, 3U), "30");
    EXPECT_EQ(Value(0x1302U, 5U), "0x00000121");
    EXPECT_EQ(Value(0x1382U, 1U), "0x22010110");
    EXPECT_EQ(Value(0x1382U, 4U), "0x23010208");
    EXPECT_EQ(Value(0x5F01U, 2U), "0x5A");
    EXPECT_EQ(Value(0x5F02U, 2U), "0x000000000000FFFF");
    EXPECT_EQ(Value(0x5F05U, 2U), "0x3C");
    EXPECT_EQ(Device().Find(0x2201U, 1U)->name, "Gate");
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out, "");
}

TEST_F(SrdoCommandTest, NumberIsTheOneThatIsGivenOrTheFirstFreeOne)
{
    Verifies(req::SRS_NEW_010);
    // Given the controller with SRDO 1, which receives objects of 2200h, and SRDO 2, which sends objects of 2000h
    // and may have gaps between SRDO numbers
    const std::string gaps =
        "Gaps between SRDO numbers (0x99: searched)\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\n"
        "DefaultValue=0x00\nParameterValue=";
    const std::string file = File("gaps.dcf", Changed(ExampleText("controller"), {{gaps + "0x00", gaps + "0x99"}}));
    ASSERT_EQ(RunCommand({"sign", file, "--write", file}).status, 0);
    const std::string controller = cia306::ReadTextFile(file);
    ASSERT_EQ(Add(controller, {"--consume", "8@0x121"}).err, "");
    EXPECT_EQ(Value(0x1303U, 1U), "2");
    EXPECT_EQ(Value(0x1383U, 1U), "0x22010108");
    EXPECT_EQ(Value(0x1383U, 2U), "0x23010108");
    // When number 5 is asked for, then 3 and 4 stay free,
    ASSERT_EQ(Add(controller, {"--produce", "8@0x121", "--number", "5"}).err, "");
    EXPECT_EQ(Value(0x1305U, 1U), "1");
    EXPECT_EQ(Value(0x1385U, 1U), "0x20010108");
    EXPECT_EQ(Value(0x1385U, 2U), "0x21010108");
    EXPECT_EQ(Value(0x1303U, 1U), "no entry");
    // and the next one is 3
    ASSERT_EQ(RunCommand({"srdo", "add", Path("d.dcf"), "--produce", "8@0x131"}).err, "");
    EXPECT_EQ(Value(0x1303U, 5U), "0x00000131");
    EXPECT_EQ(Value(0x1383U, 1U), "0x20020108");
}

TEST_F(SrdoCommandTest, MappingGetsMoreRoomOnlyWhereItNeedsIt)
{
    Verifies(req::SRS_NEW_151);
    // Given a device with room for 4 entries of each SRDO
    const std::string room = "[5F00subB]\nParameterName=Mapping entries of an SRDO\nObjectType=0x7\nDataType=0x0005\n"
                             "AccessType=rw\nDefaultValue=16\nParameterValue=";
    const std::string small =
        Changed(cia306::test::WithoutDigest(ExampleText("sensor")), {{room + "16\n", room + "4\n"}});
    // When an SRDO has six entries, then a room of four becomes six,
    ASSERT_EQ(Add(small, {"--consume", "8,8,8@0x111"}).err, "");
    EXPECT_EQ(Value(0x5F00U, 0x0BU), "0x06");
    // when it has four, it stays
    ASSERT_EQ(Add(small, {"--consume", "8,8@0x111"}).err, "");
    EXPECT_EQ(Value(0x5F00U, 0x0BU), "4");
}

TEST_F(SrdoCommandTest, PlainDeviceBecomesASafetyDevice)
{
    Verifies(req::SRS_NEW_150);
    Verifies(req::SRS_NEW_151);
    Verifies(req::SRS_NEW_152);
    // Given a file without any safety object, with lines that end in CR LF and a list that is not there
    const std::string before = "[FileInfo]\r\nFileName=p.eds\r\n\r\n[DeviceInfo]\r\nVendorName=v\r\n\r\n"
                               "[DeviceComissioning]\r\nNodeID=6\r\n\r\n[MandatoryObjects]\r\nSupportedObjects=1\r\n"
                               "1=0x1000\r\n\r\n[1000]\r\nParameterName=Device type\r\nObjectType=0x7\r\n"
                               "DataType=0x0007\r\nAccessType=ro\r\nDefaultValue=0\r\nPDOMapping=0";
    // When it gets an SRDO that it sends
    const Answer answer = Add(before, {"--produce", "8"});
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(answer.out, "SRDO 1 sends 0x10B and 0x10C, refresh time 25 ms, SRVT 20 ms, signature 0xD5D1\n"
                          "  0x2000:01 and 0x2100:01  8 bit  Sent data 1.1\n");
    // Then it has what belongs to one, and check finds nothing of it.
    EXPECT_EQ(Value(0x1300U, 0U), "0");
    EXPECT_EQ(Value(0x13FEU, 0U), "0xA5");
    EXPECT_EQ(Value(0x13FFU, 1U), "0xD5D1");
    EXPECT_EQ(Value(0x5F03U, 1U), "0x01");
    EXPECT_EQ(Value(0x5F01U, 1U), "no entry");
    // zlib.crc32 of 06 08 00 99 5A 01 01, the times of 5F00h by default, 00, and 01 00 01 00 FE with eight bytes 0.
    EXPECT_EQ(Value(0x5F04U, 0U), "0xCE8C2BF2");
    const std::string text = Written();
    EXPECT_NE(text.find("\r\nCANopenSafetySupported=1\r\n"), std::string::npos);
    EXPECT_NE(text.find("\r\n[OptionalObjects]\r\nSupportedObjects=5\r\n1=0x1301\r\n2=0x1381\r\n3=0x1300\r\n"),
              std::string::npos);
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out,
              Path("d.dcf") + ":11:1: warning: [MandatoryObjects] without 0x1001 0x1018, expected 0x1000, 0x1001 and "
                              "0x1018, which every device has\n");
}

TEST_F(SrdoCommandTest, GfcParameterIsNotAddedWhereTheFileSaysWhetherTheGfcIsUsed)
{
    Verifies(req::SRS_NEW_150);
    // Given the sensor without 1300h and without the GFC
    const std::string gfc = "[5F00subE]\nParameterName=Global fail-safe command (0x5A: present)\nObjectType=0x7\n"
                            "DataType=0x0005\nAccessType=rw\nDefaultValue=0x5A\nParameterValue=";
    const std::string without = Changed(cia306::test::WithoutDigest(ExampleText("sensor")),
                                        {{gfc + "0x5A", gfc + "0x00"}, {"4=0x1300", "4=0x2800"}, {"[1300]", "[2800]"}});
    ASSERT_EQ(Add(without, {"--consume", "8@0x111"}).err, "");
    EXPECT_EQ(Value(0x1300U, 0U), "no entry");
    EXPECT_EQ(Value(0x1302U, 1U), "2");
}

TEST_F(SrdoCommandTest, DigestComesWithTheNodeIdThatItNeeds)
{
    Verifies(req::SRS_NEW_150);
    Verifies(req::SRS_NEW_152);
    // Given a file with SRDO 1 but neither digest nor node-ID, when it gets SRDO 2
    const std::string before = Changed(cia306::test::WithoutDigest(ExampleText("sensor")), {{"NodeID=1\n", ""}});
    EXPECT_EQ(Add(before, {"--consume", "8@0x111"}).err, "");
    // Then there is no digest, and check says so,
    EXPECT_EQ(Value(0x5F04U, 0U), "no entry");
    EXPECT_NE(RunCommand({"check", Path("d.dcf")}).out.find("warning: 0x5F04:00: is missing"), std::string::npos);
    // with a node-ID there is the one of the sensor that had a digest before.
    EXPECT_EQ(Add(before, {"--consume", "8@0x111", "--node-id", "1"}).err, "");
    EXPECT_EQ(Value(0x5F04U, 0U), "0xF93CA8D8");
    EXPECT_EQ(RunCommand({"check", Path("d.dcf"), "--node-id", "1"}).out, "");
}

TEST_F(SrdoCommandTest, CompactArraysAreLengthened)
{
    Verifies(req::SRS_NEW_011);
    // Given signatures in a compact array
    const std::string sensor = ExampleText("sensor");
    const std::size_t first = sensor.find("[13FF]\n");
    const std::string before = sensor.substr(0U, first) +
                               "[13FF]\nParameterName=Signatures\nObjectType=0x8\nDataType=0x0006\nAccessType=rw\n"
                               "CompactSubObj=1\n\n[13FFValue]\nNrOfEntries=1\n1=0xB631\n\n" +
                               sensor.substr(sensor.find("[2000]\n"));
    const Answer answer = Add(before, {"--consume", "8@0x111"});
    EXPECT_EQ(answer.err, "");
    const std::string text = Written();
    EXPECT_NE(text.find("CompactSubObj=2\n\n[13FFValue]\nNrOfEntries=2\n1=0xB631\n2=0xE070\n\n[2000]"),
              std::string::npos);
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out, "");
}

TEST_F(SrdoCommandTest, ObjectOfTheFileGoesWithItsInverseObject)
{
    Verifies(req::SRS_NEW_013);
    // The one that InvertedSRAD names,
    const Answer known = Add(ExampleText("sensor"), {"--produce", "0x2000:02@0x113"});
    EXPECT_EQ(known.err, "");
    EXPECT_EQ(Value(0x1382U, 1U), "0x20000208");
    EXPECT_EQ(Value(0x1382U, 2U), "0x21000208");
    // the one that is named beside a new object,
    const Answer named = Add(Changed(ExampleText("sensor"), {{"InvertedSRAD=0x210002\n", ""}}),
                             {"--produce", "Count=8,0x2000:02/0x2100:02@0x113"});
    EXPECT_EQ(named.err, "");
    EXPECT_EQ(Value(0x1382U, 1U), "0x20010108");
    EXPECT_EQ(Value(0x1382U, 3U), "0x20000208");
    EXPECT_EQ(Value(0x1382U, 4U), "0x21000208");
    // and else a new one, which its InvertedSRAD names then.
    const std::string speed = "[3000]\nParameterName=Speed\nObjectType=0x7\nDataType=0x0003\nAccessType=ro\n"
                              "DefaultValue=0\nPDOMapping=0\n\n[5F00]\n";
    const Answer fresh =
        Add(Changed(ExampleText("sensor"), {{"[5F00]\n", speed},
                                            {"8=0x5F05\n", "8=0x5F05\n9=0x3000\n"},
                                            {"SupportedObjects=8\n1=0x2000", "SupportedObjects=9\n1=0x2000"}}),
            {"--produce", "0x3000:00@0x113"});
    EXPECT_EQ(fresh.err, "");
    EXPECT_EQ(Value(0x1382U, 1U), "0x30000010");
    EXPECT_EQ(Value(0x1382U, 2U), "0x20010010");
    EXPECT_EQ(Device().Find(0x3000U, 0U)->inverted_srad, 0x200100U);
    EXPECT_EQ(Device().Find(0x2001U, 0U)->name, "Speed, inverse");
    EXPECT_EQ(Value(0x2001U, 0U), "-1");
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out, "");
}

TEST_F(SrdoCommandTest, InverseDataIsNotSentAsData)
{
    Verifies(req::SRS_NEW_730);
    const std::string sensor = ExampleText("sensor");
    for (const std::string option : {"--produce", "--consume"})
    {
        for (const std::string mapping : {"0x2100:02@0x113", "0x2100:02/0x2000:02@0x113"})
        {
            const Answer answer = Add(sensor, {option, mapping});
            EXPECT_EQ(answer.status, 2) << mapping;
            EXPECT_EQ(answer.err, Path("d.dcf") +
                                      ":365:14: error: 0x2100:02 is the InvertedSRAD of 0x2000:02, expected "
                                      "normal data, such as 0x2000:02\n");
            EXPECT_EQ(Written(), sensor);
        }
    }
}

TEST_F(SrdoCommandTest, AnotherNodeThanThatOfTheFileIsTold)
{
    Verifies(req::SRS_NEW_731);
    // Given a file of node 1 without a digest, which would be that of node 1
    const std::string plain = cia306::test::WithoutDigest(ExampleText("sensor"));
    const std::string told = ": warning: NodeID is 1, expected 9, the node-ID that the file is signed for\n";
    const Answer added = Add(plain, {"--produce", "8@0x113", "--node-id", "9"});
    EXPECT_EQ(added.status, 0);
    EXPECT_NE(added.err.find(told), std::string::npos) << added.err;
    const Answer removed = RunCommand({"srdo", "remove", Path("d.dcf"), "--number", "2", "--node-id", "9", "--json"});
    EXPECT_EQ(removed.status, 0);
    const auto warnings = nlohmann::json::parse(removed.out)["warnings"];
    EXPECT_TRUE(std::any_of(
        warnings.begin(), warnings.end(), [](const nlohmann::json& warning)
        { return warning["message"] == "NodeID is 1, expected 9, the node-ID that the file is signed for"; }));
    // With that of the file, and to look at it, nothing is told
    EXPECT_EQ(Add(plain, {"--produce", "8@0x113", "--node-id", "1"}).err, "");
    EXPECT_EQ(RunCommand({"srdo", "list", Path("d.dcf"), "--node-id", "9"}).err, "");
}

// A pair that is not inverse from the start on is never sent, whatever the application does not touch
TEST_F(SrdoCommandTest, NewInverseObjectBeginsWithTheInverseValue)
{
    Verifies(req::SRS_NEW_013);
    struct Row
    {
        std::string type;
        std::string values;
        std::string default_value;
        std::string configured;
    };
    for (const Row& row : std::vector<Row>{
             {"0x0005", "", "0xFF", "0xFF"},
             {"0x0005", "DefaultValue=5\n", "0xFA", "0xFA"},
             {"0x0005", "DefaultValue=5\nParameterValue=0x0F\n", "0xFA", "0xF0"},
             {"0x0006", "ParameterValue=100\n", "0xFFFF", "0xFF9B"},
             {"0x0006", "DefaultValue=$NODEID+0x10\n", "0xFFEE", "0xFFEE"},
             {"0x0003", "DefaultValue=-1\n", "0", "0"},
             {"0x0003", "DefaultValue=100\n", "-101", "-101"},
             {"0x0003", "DefaultValue=-32768\n", "32767", "32767"},
             {"0x0015", "DefaultValue=0\n", "-1", "-1"},
             {"0x0015", "DefaultValue=0x7FFFFFFFFFFFFFFF\n", "-9223372036854775808", "-9223372036854775808"},
             {"0x001B", "DefaultValue=1\n", "0xFFFFFFFFFFFFFFFE", "0xFFFFFFFFFFFFFFFE"},
             {"0x0008", "DefaultValue=1\n", "0xC07FFFFF", "0xC07FFFFF"}})
    {
        const std::string object = "[3000]\nParameterName=Speed\nObjectType=0x7\nDataType=" + row.type +
                                   "\nAccessType=ro\n" + row.values + "PDOMapping=0\n\n[5F00]\n";
        const Answer answer =
            Add(Changed(ExampleText("sensor"), {{"[5F00]\n", object},
                                                {"8=0x5F05\n", "8=0x5F05\n9=0x3000\n"},
                                                {"SupportedObjects=8\n1=0x2000", "SupportedObjects=9\n1=0x2000"}}),
                {"--produce", "0x3000:00@0x113"});
        EXPECT_EQ(answer.status, 0) << answer.err;
        const cia306::Device device = Device();
        const cia306::Entry* const inverse = device.Find(0x2001U, 0U);
        ASSERT_NE(inverse, nullptr);
        EXPECT_EQ(inverse->default_value.text, row.default_value) << row.type << row.values;
        EXPECT_EQ(inverse->Configured().text, row.configured) << row.type << row.values;
        EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out.find("error"), std::string::npos);
    }
}

// The kernel has the object then, and the heartbeat none
TEST_F(SrdoCommandTest, ObjectOfAServiceThatIsMappedIsTold)
{
    Verifies(req::SRS_NODE_044);
    Verifies(req::SRS_NEW_016);
    const std::string end = ": a variable of SRDOs, so that the kernel has it and the service of this object works "
                            "without it, expected SRDOMapping=0 and another object in the mapping\n";
    const Answer answer = Add(ExampleText("sensor"), {"--produce", "0x1017:00@0x113"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.err, Path("d.dcf") + ":123:1: warning: 0x1017:00" + end);
    EXPECT_EQ(RunCommand({"check", Path("d.dcf")}).out, answer.err);
    // The flag alone makes it one
    const auto marked = [this, &end](const std::string& object)
    {
        const std::string text = Changed(ExampleText("sensor"), {{object, object + "SRDOMapping=1\n"}});
        return RunCommand({"check", File("d.dcf", text)}).out.find(end) != std::string::npos;
    };
    EXPECT_TRUE(marked("[1017]\n"));
    EXPECT_TRUE(marked("[1001]\n"));
    // No service works with these
    EXPECT_FALSE(marked("[1000]\n"));
    EXPECT_FALSE(marked("[1018sub1]\n"));
    EXPECT_FALSE(marked("[2000sub1]\nParameterName=Button 1\n"));
}

TEST_F(SrdoCommandTest, RefusalLeavesTheFileAsItWas)
{
    Verifies(req::SRS_NEW_012);
    struct Row
    {
        std::string text;
        std::vector<std::string> options;
        std::string err; ///< Behind the name of the file.
    };
    const std::string sensor = ExampleText("sensor");
    for (const Row& row : std::vector<Row>{
             {Changed(sensor, {{"0xB631", "0xB632"}}),
              {"--consume", "8@0x111"},
              ":331:16: error: 0x13FF:01: signature 0xB632 of SRDO 1, expected 0xB631, computed from its parameters"},
             {sensor,
              {"--consume", "8@0x111", "--number", "1"},
              ":185:1: error: SRDO 1 is there already, expected a number that is free"},
             {sensor,
              {"--consume", "8@0x101"},
              ": error: 0x1302:05: COB-ID 0x101 is in use by SRDO 1, expected an identifier of its own; nothing was "
              "written"},
             {sensor,
              {"--consume", "8@0x111", "--number", "3"},
              ": error: 0x1303: SRDO 3 in a device without gaps, expected SRDO 2 before it, or 0x99 in 0x5F00:0D; "
              "nothing was written"},
             {sensor,
              {"--consume", "0x2222:01@0x111"},
              ": error: 0x2222:01 is not in the file, expected an object that it describes, or a length such as 8 "
              "for a "
              "new one"},
             {sensor,
              {"--consume", "0x2000:01@0x111"},
              ": error: 0x1382:01: mapped object 0x2000:01 has the wrong AccessType (line 462), expected rw, wo or "
              "rww to "
              "be received; nothing was written"}})
    {
        const Answer answer = Add(row.text, row.options);
        EXPECT_EQ(answer.status, 2) << row.err;
        EXPECT_EQ(answer.err, Path("d.dcf") + row.err + "\n");
        EXPECT_EQ(Written(), row.text);
    }
}

TEST_F(SrdoCommandTest, ObjectThatCannotBeMappedIsRefused)
{
    Verifies(req::SRS_NEW_012);
    const std::string plain = "[DeviceInfo]\nVendorName=v\n\n[DeviceComissioning]\nNodeID=6\n\n[ManufacturerObjects]\n"
                              "SupportedObjects=2\n1=0x3000\n2=0x3001\n\n[3000]\nParameterName=Name\nObjectType=0x7\n"
                              "DataType=0x0009\nAccessType=ro\n\n[3001]\nParameterName=Values\nObjectType=0x8\n"
                              "DataType=0x0005\nAccessType=ro\nCompactSubObj=3\n";
    EXPECT_EQ(Add(plain, {"--produce", "0x3000:00"}).err,
              Path("d.dcf") + ":12:1: error: 0x3000:00 is of VISIBLE_STRING, expected a data type of 1 to 64 bits\n");
    EXPECT_EQ(Add(plain, {"--produce", "0x3001:02"}).err,
              Path("d.dcf") +
                  ":18:1: error: 0x3001:02 of a compact object has no inverse object, expected one that is named "
                  "behind it, such as 0x3001:02/0x2100:01\n");
    EXPECT_EQ(Written(), plain);
}

TEST_F(SrdoCommandTest, UsageThatDoesNotFitIsRefused)
{
    Verifies(req::SRS_NEW_002);
    Verifies(req::SRS_NEW_014);
    const std::string sensor = ExampleText("sensor");
    EXPECT_EQ(Add(sensor, {}).err,
              "counterpoint: --produce or --consume is missing, expected the mapping of the SRDO\n");
    EXPECT_EQ(Add(sensor, {"--consume", "8"}).err,
              "counterpoint: --consume '8': SRDO 2 has no default COB-ID, expected one behind @, such as 8@0x109 or "
              "8@node5\n");
    // As in a file, 2000 is hexadecimal for many; it is no number that may be guessed.
    EXPECT_EQ(Add(sensor, {"--produce", "2000:02@0x113"}).err,
              "counterpoint: --produce: '2000:02', expected [NAME=][COUNTx]LENGTH such as 2x8, i16 or Speed=32, or "
              "INDEX:SUB of an object of the file, such as 0x6004:00; expected a command line as told by 'counterpoint "
              "srdo --help'\n");
    EXPECT_EQ(Add(sensor, {"--produce", "0x2000:02/8448:02@0x113"}).status, 2);
    EXPECT_EQ(Add(sensor, {"--consume", "8@0x111", "--refresh", "5"}).err,
              "counterpoint: --refresh fits no SRDO that is received, expected --sct\n");
    EXPECT_EQ(Add(sensor, {"--produce", "8@0x111", "--safe-value", "5"}).err,
              "counterpoint: --safe-value fits no SRDO that is sent, expected --consume\n");
    EXPECT_EQ(RunCommand({"srdo", "list", Path("d.dcf"), "--number", "2"}).err,
              "counterpoint: --number does not fit srdo list, expected srdo add or remove\n");
    EXPECT_EQ(RunCommand({"srdo", "list", Path("d.dcf"), "-o", "x"}).err,
              "counterpoint: --output does not fit srdo list, expected srdo add or remove\n");
    EXPECT_EQ(RunCommand({"srdo", "drop", Path("d.dcf")}).err,
              "counterpoint: ACTION: 'drop', expected add, remove or list; expected a command line as told by "
              "'counterpoint srdo "
              "--help'\n");
    EXPECT_EQ(RunCommand({"srdo", "remove", Path("d.dcf")}).err,
              "counterpoint: --number is missing, expected that of the SRDO, 1 to 64\n");
    EXPECT_EQ(RunCommand({"srdo", "remove", Path("d.dcf"), "--number", "1", "--sct", "9"}).err,
              "counterpoint: --sct does not fit srdo remove, expected srdo add\n");
    EXPECT_EQ(Written(), sensor);
}

TEST_F(SrdoCommandTest, WarningsThatTheChangeBringsAreTold)
{
    Verifies(req::SRS_NEW_016);
    // Given a device with a warning of its own
    const std::string text =
        Changed(ExampleText("sensor"), {{"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}});
    EXPECT_NE(RunCommand({"check", File("d.dcf", text)}).out, "");
    // When an SRDO is added whose SRVT is no less than its refresh time
    const Answer added = Add(text, {"--produce", "8@0x111", "--refresh", "10"});
    // Then that is told, with the line of the file that was written
    EXPECT_EQ(added.status, 0);
    EXPECT_NE(added.err.find("warning: 0x1302:03: SRVT 20 ms, expected less than the refresh time of 10 ms\n"),
              std::string::npos);
    EXPECT_EQ(added.err.find("CANopenSafetySupported"), std::string::npos);
    EXPECT_NE(RunCommand({"check", Path("d.dcf")}).out.find(added.err), std::string::npos);
    // and as a document
    const Answer json = Add(text, {"--produce", "8@0x111", "--refresh", "10", "--json"});
    const auto document = nlohmann::json::parse(json.out);
    ASSERT_EQ(document.at("warnings").size(), 1U);
    EXPECT_EQ(document.at("warnings").at(0).at("object"), "0x1302:03");
    // and one that is right brings none
    EXPECT_EQ(Add(text, {"--produce", "8@0x111"}).err, "");
}

TEST_F(SrdoCommandTest, CopyIsWrittenInsteadOfTheFile)
{
    Verifies(req::SRS_NEW_010);
    const std::string sensor = ExampleText("sensor");
    EXPECT_EQ(Add(sensor, {"--consume", "8@0x111", "-o", Path("copy.dcf")}).status, 0);
    EXPECT_EQ(Written(), sensor);
    EXPECT_EQ(RunCommand({"check", Path("copy.dcf")}).out, "");
}

TEST_F(SrdoCommandTest, ListTellsTheSrdosOfAFile)
{
    Verifies(req::SRS_NEW_014);
    const Answer answer = RunCommand({"srdo", "list", File("d.dcf", ExampleText("controller"))});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, "SRDO 1 receives 0x101 and 0x102, SCT 50 ms, SRVT 20 ms, signature 0xE3BF\n"
                          "  0x2200:01 and 0x2300:01  8 bit  Button 1\n  0x2200:02 and 0x2300:02  8 bit  Button 2\n"
                          "SRDO 2 sends 0x103 and 0x104, refresh time 25 ms, SRVT 20 ms, signature 0xCA45\n"
                          "  0x2000:01 and 0x2100:01  8 bit  Command\n  0x2000:02 and 0x2100:02  8 bit  Mode\n");
    // What cannot be read is a question mark.
    const Answer broken = RunCommand(
        {"srdo", "list",
         File("b.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0x20000108", "ParameterValue=0x2000010g"},
                                                       {"ParameterValue=0x00000101", "ParameterValue=-"},
                                                       {"ParameterValue=0xB631", "ParameterValue=much"}}))});
    EXPECT_EQ(broken.status, 0);
    EXPECT_EQ(broken.out, "SRDO 1 sends ? and 0x102, refresh time 25 ms, SRVT 20 ms, signature ?\n"
                          "  ? and 0x2100:01  8 bit  Button 1, inverse\n  0x2000:02 and 0x2100:02  8 bit  Button 2\n");
    const Answer json = RunCommand({"srdo", "list", "--json", File("s.dcf", ExampleText("sensor"))});
    const auto document = nlohmann::json::parse(json.out);
    EXPECT_EQ(document.at("format"), "counterpoint-srdo-1");
    EXPECT_EQ(document.at("file"), Path("s.dcf"));
    EXPECT_EQ(document.at("srdos").at(0).at("direction"), "sends");
    EXPECT_EQ(document.at("srdos").at(0).at("cob_id_2"), 0x102);
    EXPECT_EQ(document.at("srdos").at(0).at("signature"), 0xB631);
    EXPECT_EQ(document.at("srdos").at(0).at("mapping").at(3).dump(),
              R"({"bits":8,"inverse":true,"name":"Button 2, inverse","object":"0x2100:02"})");
}

TEST_F(SrdoCommandTest, ListTellsWhatCannotBeRead)
{
    Verifies(req::SRS_NEW_490);
    // Given a sensor with an SCT of -50, and without its direction
    const std::string sct =
        File("sct.dcf", cia306::test::WithValues(ExampleText("sensor"), {{"1301sub2", "ParameterValue", "-50"}}));
    const Answer answer = RunCommand({"srdo", "list", sct});
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.out.find("refresh time ? ms"), std::string::npos) << answer.out;
    EXPECT_NE(answer.err.find(": warning: 0x1301:02: value '-50', expected a number from 0 to 65535 (UNSIGNED16)"),
              std::string::npos)
        << answer.err;
    EXPECT_EQ(answer.err.rfind(sct + ":", 0U), 0U) << answer.err;
    const auto json = nlohmann::json::parse(RunCommand({"srdo", "list", "--json", sct}).out);
    EXPECT_TRUE(json["srdos"][0]["sct_ms"].is_null());
    EXPECT_EQ(json["warnings"][0]["object"], "0x1301:02");
    EXPECT_EQ(json["warnings"][0]["severity"], "warning");
    // When the direction is missing, then nobody takes the SRDO for one that is off
    const std::string none = File("none.dcf", Changed(ExampleText("sensor"), {{"[1301sub1]", "[Gone]"}}));
    const Answer direction = RunCommand({"srdo", "list", none});
    EXPECT_EQ(direction.out.rfind("SRDO 1 ? ", 0U), 0U) << direction.out;
    EXPECT_NE(direction.err.find(": warning: 0x1301:01: is missing, expected an object of type UNSIGNED8\n"),
              std::string::npos)
        << direction.err;
    EXPECT_TRUE(
        nlohmann::json::parse(RunCommand({"srdo", "list", "--json", none}).out)["srdos"][0]["direction"].is_null());
    // and one of 0 is off, one of 3 none that there is
    const auto of = [this](const std::string& value)
    {
        return RunCommand({"srdo", "list",
                           File("d.dcf", cia306::test::WithValues(ExampleText("sensor"),
                                                                  {{"1301sub1", "ParameterValue", value}}))})
            .out;
    };
    EXPECT_EQ(of("0").rfind("SRDO 1 off ", 0U), 0U) << of("0");
    EXPECT_EQ(of("3").rfind("SRDO 1 ? ", 0U), 0U) << of("3");
}
} // namespace
} // namespace counterpoint::tools
