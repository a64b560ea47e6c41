// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using test::Answer;
using test::RunCommand;

using CheckCommandTest = test::CommandTest;

TEST_F(CheckCommandTest, TheExamplesPassSilently)
{
    Verifies(req::SRS_CLI_019);
    for (const char* name : {"sensor", "controller", "actuator"})
    {
        const Answer answer =
            RunCommand({"check", cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf"});
        EXPECT_EQ(answer.status, 0) << name;
        EXPECT_EQ(answer.out, "") << name;
        EXPECT_EQ(answer.err, "") << name;
    }
}

TEST_F(CheckCommandTest, PrintsEveryFindingAndEndsWith1WhenOneIsAnError)
{
    Verifies(req::SRS_CLI_009);
    const std::string file =
        File("bad.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xB631", "ParameterValue=0xB632"},
                                                        {"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}}));
    const Answer answer = RunCommand({"check", file});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.out,
              file +
                  ":17: warning: [DeviceInfo] does not announce CANopen Safety, expected CANopenSafetySupported=1\n" +
                  file +
                  ":309: error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until all "
                  "of them are repaired\n" +
                  file +
                  ":331: error: 0x13FF:01: signature 0xB632 of SRDO 1, expected 0xB631, computed from its "
                  "parameters\n");
    EXPECT_EQ(answer.err, "");
}

TEST_F(CheckCommandTest, EndsWith0WhenThereAreOnlyWarnings)
{
    Verifies(req::SRS_CLI_009);
    const std::string file =
        File("w.dcf", Changed(ExampleText("sensor"), {{"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}}));
    const Answer answer = RunCommand({"check", file});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, file + ":17: warning: [DeviceInfo] does not announce CANopen Safety, expected "
                                 "CANopenSafetySupported=1\n");
}

TEST_F(CheckCommandTest, EndsWith2WhenTheFileCannotBeRead)
{
    Verifies(req::SRS_CLI_001);
    Verifies(req::SRS_CLI_009);
    const Answer missing = RunCommand({"check", Path("none.dcf")});
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.out, "");
    EXPECT_EQ(missing.err, Path("none.dcf") + ":0: error: it cannot be opened (No such file or directory), expected a "
                                              "readable EDS or DCF file\n");
    const std::string file = File("cut.dcf", ExampleText("sensor").substr(0U, 3018U));
    const Answer cut = RunCommand({"check", file});
    EXPECT_EQ(cut.status, 2);
    EXPECT_EQ(cut.err, file + ":195: error: 'DefaultValu' is no line of an EDS, expected [section], key=value or a "
                              "comment that begins with ';'\n");
}

TEST_F(CheckCommandTest, GranularityAndNodeIdAreOptions)
{
    Verifies(req::SRS_CLI_012);
    Verifies(req::SRS_CLI_007);
    const std::string file = cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    EXPECT_EQ(RunCommand({"check", file, "--granularity", "1"}).status, 0);
    EXPECT_EQ(RunCommand({"check", file, "--granularity", "8"}).status, 0);
    EXPECT_EQ(RunCommand({"check", file, "--granularity", "16"}).status, 1);
    EXPECT_EQ(RunCommand({"check", file, "--granularity", "4"}).status, 2);
    // The defaults of the file are those of node 1.
    EXPECT_EQ(RunCommand({"check", file, "--node-id", "1"}).out, "");
    EXPECT_NE(RunCommand({"check", file, "--node-id", "2"}).out.find("expected 0x103 for node-ID 2"),
              std::string::npos);
}

TEST_F(CheckCommandTest, ADigestThatIsNotTheComputedOneIsNamed)
{
    Verifies(req::SRS_CLI_022);
    const std::string file =
        File("bad.dcf", Changed(ExampleText("actuator"), {{"ParameterValue=0x046FFAB7", "ParameterValue=0x046FFAB8"}}));
    const Answer answer = RunCommand({"check", file});
    EXPECT_EQ(answer.status, 1);
    EXPECT_NE(answer.out.find(file + ":627: error: 0x5F04:00: device digest 0x046FFAB8, expected 0x046FFAB7, computed "
                                     "from the device's parameters\n"),
              std::string::npos);
    const std::string none =
        File("none.dcf", Changed(ExampleText("actuator"), {{"ParameterValue=0x046FFAB7", "ParameterValue=0"}}));
    EXPECT_EQ(RunCommand({"check", none}).out, "");
}

TEST_F(CheckCommandTest, AnswersAsJson)
{
    Verifies(req::SRS_CLI_008);
    const std::string file =
        File("bad.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xB631", "ParameterValue=1"}}));
    const Answer answer = RunCommand({"check", "--json", file});
    EXPECT_EQ(answer.status, 1);
    const auto document = nlohmann::json::parse(answer.out);
    EXPECT_EQ(document["holds"], false);
    EXPECT_EQ(document["errors"], 2);
    EXPECT_EQ(document["warnings"], 0);
    ASSERT_EQ(document["findings"].size(), 2U);
    EXPECT_EQ(document["findings"][1]["severity"], "error");
    EXPECT_EQ(document["findings"][1]["line"], 331);
    EXPECT_EQ(document["findings"][1]["object"], "0x13FF:01");
    EXPECT_EQ(document["findings"][1]["message"],
              "signature 0x0001 of SRDO 1, expected 0xB631, computed from its parameters");
    EXPECT_EQ(nlohmann::json::parse(RunCommand({"check", "--json", Path("none.dcf")}).out)["error"]["line"], 0);
}
} // namespace
} // namespace counterpoint::tools
