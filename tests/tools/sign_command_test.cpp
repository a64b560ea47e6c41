// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using cia306::test::SrdoText;
using test::Answer;
using test::RunCommand;

const char* const kGoldBytes = "0x13FF:01 = 0x4370\n"
                               "    02           0x1301:01  direction 2 (consumer)\n"
                               "    32 00        0x1301:02  SCT 50 ms\n"
                               "    14           0x1301:03  SRVT 20 ms\n"
                               "    11 01 00 00  0x1301:05  COB-ID 1 0x111\n"
                               "    12 01 00 00  0x1301:06  COB-ID 2 0x112\n"
                               "    04           0x1381:00  4 mapping entries\n"
                               "    01           0x1381:01  sub-index 1\n"
                               "    08 01 10 60  0x1381:01  normal data 0x6010:01, 8 bit\n"
                               "    02           0x1381:02  sub-index 2\n"
                               "    08 01 11 60  0x1381:02  inverse data 0x6011:01, 8 bit\n"
                               "    03           0x1381:03  sub-index 3\n"
                               "    08 02 10 60  0x1381:03  normal data 0x6010:02, 8 bit\n"
                               "    04           0x1381:04  sub-index 4\n"
                               "    08 02 11 60  0x1381:04  inverse data 0x6011:02, 8 bit\n"
                               "    33 bytes: 02 32 00 14 11 01 00 00 12 01 00 00 04 01 08 01 10 60 02 08 01 11 60 03 "
                               "08 02 10 60 04 08 02 11 60\n";

class SignCommandTest : public test::CommandTest
{
  protected:
    static std::string GoldFile()
    {
        return cia306::test::SourceFolder() + "/tests/canopen/cia306/data/gold.dcf";
    }
    /// Vector A with its COB-IDs as formulas: for node-ID 1 it is vector A.
    static SrdoText FormulaSrdo()
    {
        return {1, "1", "25", "20", "$NODEID+0x100", "0x101+$NODEID", {"0x20000008", "0x20010008"}};
    }
};

TEST_F(SignCommandTest, GivesThePublishedSignatureOfACertifiedDevice)
{
    Verifies(req::SRS_CLI_003);
    Verifies(req::SRS_CLI_002);
    const Answer answer = RunCommand({"sign", GoldFile()});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, "0x13FF:01 = 0x4370\n");
    EXPECT_EQ(answer.err, GoldFile() +
                              ":77:1: warning: 0x5F04:00: is missing; a wrong device parameter, 0x1300 included, "
                              "is not found, expected an object of type UNSIGNED32 with the device digest\n");
}

TEST_F(SignCommandTest, GivesAllVectors)
{
    Verifies(req::SRS_CLI_003);
    const std::vector<std::string> expected{"0x13FF:01 = 0x4370\n", "0x13FF:01 = 0x4B2D\n", "0x13FF:01 = 0xD999\n",
                                            "0x13FF:01 = 0xB825\n", "0x13FF:01 = 0xCD8A\n", "0x13FF:01 = 0xF2B5\n",
                                            "0x13FF:01 = 0x88E9\n"};
    std::size_t place = 0U;
    for (const cia306::test::Vector& vector : cia306::test::Vectors())
    {
        const Answer answer = RunCommand({"sign", File(vector.name, cia306::test::SrdoFileText({vector.srdo}))});
        EXPECT_EQ(answer.status, 0) << vector.name;
        EXPECT_EQ(answer.out, expected.at(place)) << vector.name;
        ++place;
    }
    EXPECT_EQ(place, 7U);
}

TEST_F(SignCommandTest, PrintsExistingSrdosAndNothingForGaps)
{
    Verifies(req::SRS_CLI_002);
    SrdoText first = cia306::test::Vectors().at(1U).srdo;
    SrdoText off = cia306::test::Vectors().at(6U).srdo;
    SrdoText last = cia306::test::Vectors().at(3U).srdo;
    off.number = 3;
    last.number = 64;
    const Answer answer = RunCommand({"sign", File("gaps.dcf", cia306::test::SrdoFileText({first, off, last}))});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, "0x13FF:01 = 0x4B2D\n0x13FF:03 = 0x88E9\n0x13FF:40 = 0xB825\n");
}

TEST_F(SignCommandTest, AFileWithoutSrdoGivesAWarningAndNoLine)
{
    Verifies(req::SRS_CLI_002);
    const std::string file = File("plain.eds", "[1000]\nDataType=7\nAccessType=ro\n");
    const Answer answer = RunCommand({"sign", file});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, "");
    EXPECT_NE(answer.err.find(file + ":1:1: warning: no SRDO, nothing of CANopen Safety is checked, expected "
                                     "communication parameters at 0x1301 to 0x1340\n"),
              std::string::npos);
}

TEST_F(SignCommandTest, PrintsTheWarningsOfCheck)
{
    Verifies(req::SRS_CLI_037);
    // Given a plain device with node-ID 0, one that lacks 5F04h, and one that does not announce safety
    const std::string sensor = cia306::test::ExampleText("sensor");
    for (const std::string& text :
         {std::string("[1000]\nDataType=7\nAccessType=ro\n[DeviceComissioning]\nNodeID=0\n"),
          cia306::test::WithoutDigest(sensor),
          cia306::test::Changed(sensor, {{"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}})})
    {
        const std::string file = File("in.dcf", text);
        // When it is signed
        const Answer answer = RunCommand({"sign", file, "--write", Path("out.dcf")});
        // Then the warnings are those of check, line by line
        EXPECT_EQ(answer.status, 0);
        EXPECT_NE(answer.err, "");
        EXPECT_EQ(answer.err, RunCommand({"check", Path("out.dcf")}).out);
        // and in the document the same
        const auto document = nlohmann::json::parse(RunCommand({"sign", "--json", Path("out.dcf")}).out);
        const auto checked = nlohmann::json::parse(RunCommand({"check", "--json", Path("out.dcf")}).out);
        EXPECT_EQ(document["warnings"], checked["findings"]);
    }
}

TEST_F(SignCommandTest, TellsThatCheckFindsErrors)
{
    Verifies(req::SRS_CLI_037);
    const std::string file = File(
        "in.dcf", cia306::test::WithValues(cia306::test::ExampleText("sensor"), {{"1301sub1", "ParameterValue", "3"}}));
    const Answer answer = RunCommand({"sign", file, "--write", Path("out.dcf")});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.err, Path("out.dcf") + ": warning: check finds errors: 2, expected none\n");
    // Without a copy it is the same: what counts is what stays when the signatures are right
    EXPECT_EQ(RunCommand({"sign", file}).err, file + ": warning: check finds errors: 2, expected none\n");
    const auto document = nlohmann::json::parse(RunCommand({"sign", file, "--json"}).out);
    ASSERT_EQ(document["warnings"].size(), 1U);
    EXPECT_EQ(document["warnings"][0]["message"], "check finds errors: 2, expected none");
    // And a file whose signatures alone are wrong has none
    const std::string unsigned_file =
        File("unsigned.dcf",
             cia306::test::WithValues(cia306::test::ExampleText("sensor"), {{"13FFsub1", "ParameterValue", "0x0001"}}));
    EXPECT_EQ(RunCommand({"sign", unsigned_file}).err, "");
}

TEST_F(SignCommandTest, TellsThatTheCopyIsForAnotherNode)
{
    Verifies(req::SRS_CLI_037);
    // Given a device with node-ID 1 and a digest
    const std::string file = File("in.dcf", cia306::test::ExampleText("sensor"));
    // When it is signed for another one
    const Answer answer = RunCommand({"sign", file, "--node-id", "9", "--write", Path("out.dcf")});
    // Then the copy holds for that one alone, and the user hears of it
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.err.find("warning: NodeID is 1, expected 9, the node-ID that the file is signed for\n"),
              std::string::npos);
    EXPECT_EQ(RunCommand({"check", Path("out.dcf")}).status, 1);
    EXPECT_EQ(RunCommand({"check", Path("out.dcf"), "--node-id", "9"}).status, 0);
    EXPECT_EQ(RunCommand({"sign", file, "--node-id", "1", "--write", Path("out.dcf")}).err, "");
}

TEST_F(SignCommandTest, RefusesAFileThatWasCut)
{
    Verifies(req::SRS_EDS_031);
    // Given a shipped device's file that ends before its SRDO
    const std::string text = cia306::ReadTextFile(cia306::test::SourceFolder() + "/examples/actuator/actuator.dcf");
    const std::string file = File("cut.dcf", text.substr(0U, text.find("[1301]")));
    // When it is signed
    const Answer answer = RunCommand({"sign", file});
    // Then one line names the first object that is not there
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    const std::string line = file + ":72:3: error: 0x1301: is listed, expected a section that describes it\n";
    EXPECT_EQ(answer.err, line);
    // and so it is when it is to be simulated
    const Answer simulated =
        RunCommand({"simulate", "--quiet", File("s.yaml", "title: x\nduration: 10 ms\nnodes:\n  a: {dcf: cut.dcf}\n")});
    EXPECT_EQ(simulated.status, 2);
    EXPECT_NE(simulated.err.find(line), std::string::npos) << simulated.err;
}

TEST_F(SignCommandTest, VerbosePrintsTheBytesFieldByField)
{
    Verifies(req::SRS_CLI_004);
    const Answer answer = RunCommand({"sign", "--verbose", GoldFile()});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, kGoldBytes);
}

TEST_F(SignCommandTest, TakesTheNodeIdFromTheCommandLineElseFromTheFile)
{
    Verifies(req::SRS_CLI_007);
    Verifies(req::SRS_EDS_008);
    const std::string text = cia306::test::SrdoFileText({FormulaSrdo()});
    const std::string without = File("without.dcf", text);
    const std::string with = File("with.dcf", text + "[DeviceComissioning]\nNodeID=1\n");
    EXPECT_EQ(RunCommand({"sign", without, "--node-id", "1"}).out, "0x13FF:01 = 0x4B2D\n");
    EXPECT_EQ(RunCommand({"sign", with}).out, "0x13FF:01 = 0x4B2D\n");
    // Node-ID 3: 103h and 104h.
    EXPECT_EQ(RunCommand({"sign", with, "--node-id", "3"}).out, RunCommand({"sign", without, "--node-id", "0x3"}).out);
    EXPECT_NE(RunCommand({"sign", with, "--node-id", "3"}).out, "0x13FF:01 = 0x4B2D\n");
    const Answer answer = RunCommand({"sign", without});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err, without +
                              ":54:14: error: 0x1301:05: value '$NODEID+0x100' needs the node-ID and there is none, "
                              "expected --node-id, or NodeID in [DeviceComissioning]\n");
}

TEST_F(SignCommandTest, WritesTheSignaturesAndNothingElse)
{
    Verifies(req::SRS_CLI_005);
    Verifies(req::SRS_CLI_006);
    const std::string text = cia306::test::ExampleText("controller");
    const std::string unsigned_text =
        cia306::test::Changed(text, {{"ParameterValue=0xE3BF", "ParameterValue=0"}, {"ParameterValue=0xCA45\n", ""}});
    const std::string file = File("in.dcf", unsigned_text);
    const Answer answer = RunCommand({"sign", file, "--write", Path("out.dcf")});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, "0x13FF:01 = 0xE3BF\n0x13FF:02 = 0xCA45\n0x5F04:00 = 0x0D6A53FF\n");
    EXPECT_EQ(cia306::ReadTextFile(Path("out.dcf")), text);
    EXPECT_EQ(cia306::ReadTextFile(file), unsigned_text);
    // In place.
    EXPECT_EQ(RunCommand({"sign", file, "--write", file}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(file), text);
}

TEST_F(SignCommandTest, WritesNothingWhenItRefuses)
{
    Verifies(req::SRS_CLI_005);
    Verifies(req::SRS_CLI_006);
    Verifies(req::SRS_CLI_120);
    const std::string file =
        File("in.dcf", cia306::test::Changed(cia306::test::ExampleText("sensor"), {{"[13FFsub1]", "[Gone]"}}));
    const Answer answer = RunCommand({"sign", file, "--write", Path("out.dcf")});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err,
              file + ":312:1: error: 0x13FF:01 is missing, expected an object that takes the signature of SRDO "
                     "1\n");
    EXPECT_FALSE(std::filesystem::exists(Path("out.dcf")));
    const Answer folder = RunCommand({"sign", GoldFile(), "--write", Path("no/out.dcf")});
    EXPECT_EQ(folder.status, 2);
    EXPECT_EQ(folder.out, "");
}

TEST_F(SignCommandTest, VerbosePrintsAll128Entries)
{
    Verifies(req::SRS_CLI_004);
    const Answer answer =
        RunCommand({"sign", "--verbose", cia306::test::SourceFolder() + "/tests/canopen/cia306/data/bits.dcf"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.out.find("    80           0x1381:00  128 mapping entries\n"), std::string::npos);
    EXPECT_NE(answer.out.find("    01 40 20 61  0x1381:80  inverse data 0x6120:40, 1 bit\n"
                              "    653 bytes: 02 64 00 3C 11 01 00 00 12 01 00 00 80 01 01 01 20 60 02 01 01 20 61 "),
              std::string::npos);
    EXPECT_EQ(answer.out.substr(0U, 19U), "0x13FF:01 = 0xCB64\n");
    EXPECT_NE(answer.out.find("\n0x13FF:02 = 0xE463\n"), std::string::npos);
}

TEST_F(SignCommandTest, PrintsTheDigestBehindTheSignatures)
{
    Verifies(req::SRS_EDS_008);
    Verifies(req::SRS_CLI_021);
    const std::string file = cia306::test::SourceFolder() + "/examples/emergency_stop/actuator.dcf";
    EXPECT_EQ(RunCommand({"sign", file}).out, "0x13FF:01 = 0x9FCB\n0x5F04:00 = 0x046FFAB7\n");
    const std::string verbose = RunCommand({"sign", "--verbose", file}).out;
    EXPECT_NE(verbose.find("0x5F04:00 = 0x046FFAB7\n"
                           "    21                      node-ID 33\n"
                           "    08           0x5F00:0A  granularity 8 bit\n"
                           "    66           0x5F00:0C  dummy mapping 0x66\n"),
              std::string::npos);
    EXPECT_NE(verbose.find("    00 00 00 00  0x5F02:01  safe value, bytes 4 to 7\n"
                           "    57 bytes: 21 08 66 00 5A 01 01 E8 03 00 00 "),
              std::string::npos);
    const auto document = nlohmann::json::parse(RunCommand({"sign", "--json", "--verbose", file}).out);
    EXPECT_EQ(document["digest"]["object"], "0x5F04:00");
    EXPECT_EQ(document["digest"]["digest"], "0x046FFAB7");
    EXPECT_EQ(document["digest"]["value"], 74447543);
    EXPECT_EQ(document["digest"]["fields"].size(), 24U);
    // Another node-ID, another digest
    EXPECT_NE(RunCommand({"sign", file, "--node-id", "34"}).out.find("0x5F04:00 = 0x"), std::string::npos);
    EXPECT_EQ(RunCommand({"sign", file, "--node-id", "34"}).out.find("0x046FFAB7"), std::string::npos);
}

TEST_F(SignCommandTest, ADigestThatCannotBeComputedIsRefused)
{
    Verifies(req::SRS_CLI_021);
    const std::string text = cia306::test::ExampleText("actuator");
    const std::string without = File("in.dcf", cia306::test::Changed(text, {{"NodeID=33\n", "NodeID=\n"}}));
    const Answer answer = RunCommand({"sign", without, "--write", Path("out.dcf")});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err, without +
                              ":627:16: error: 0x5F04:00: the digest needs the node-ID and there is none, expected "
                              "--node-id, or NodeID in [DeviceComissioning]\n");
    EXPECT_FALSE(std::filesystem::exists(Path("out.dcf")));
    EXPECT_EQ(RunCommand({"sign", without, "--node-id", "33"}).out, "0x13FF:01 = 0x9FCB\n0x5F04:00 = 0x046FFAB7\n");
}

TEST_F(SignCommandTest, AnswersAsJson)
{
    Verifies(req::SRS_CLI_008);
    const Answer answer = RunCommand({"sign", "--json", "--verbose", GoldFile()});
    EXPECT_EQ(answer.status, 0);
    const auto document = nlohmann::json::parse(answer.out);
    EXPECT_EQ(document["node_id"], 9);
    ASSERT_EQ(document["srdos"].size(), 1U);
    EXPECT_EQ(document["srdos"][0]["srdo"], 1);
    EXPECT_EQ(document["srdos"][0]["object"], "0x13FF:01");
    EXPECT_EQ(document["srdos"][0]["signature"], "0x4370");
    EXPECT_EQ(document["srdos"][0]["value"], 17264);
    EXPECT_EQ(document["srdos"][0]["fields"][1]["bytes"], "32 00");
    EXPECT_EQ(document["srdos"][0]["fields"].size(), 14U);
    const auto brief = nlohmann::json::parse(RunCommand({"sign", "--json", GoldFile()}).out);
    EXPECT_FALSE(brief["srdos"][0].contains("fields"));
}

TEST_F(SignCommandTest, RefusesAsJsonToo)
{
    Verifies(req::SRS_CLI_008);
    const std::string file = File("bad\xE4.dcf", "[1000]\nDataType=\xE4\n");
    const Answer answer = RunCommand({"sign", "--json", file});
    EXPECT_EQ(answer.status, 2);
    const auto document = nlohmann::json::parse(answer.out);
    EXPECT_EQ(document["error"]["line"], 2);
    EXPECT_EQ(document["error"]["column"], 10);
    EXPECT_EQ(document["error"]["message"], "'DataType' is '\\xE4', expected a number from 0 to 65535");
    EXPECT_EQ(answer.err, file + ":2:10: error: 'DataType' is '\\xE4', expected a number from 0 to 65535\n");
}
} // namespace
} // namespace counterpoint::tools
