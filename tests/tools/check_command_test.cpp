// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/node/trial.hpp"
#include "simulator/world/trial.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

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
    Verifies(req::SRS_CLI_001);
    const std::string file =
        File("bad.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xB631", "ParameterValue=0xB632"},
                                                        {"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}}));
    const Answer answer = RunCommand({"check", file});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.out,
              file +
                  ":17:1: warning: [DeviceInfo] does not announce CANopen Safety, expected CANopenSafetySupported=1\n" +
                  file +
                  ":309:16: error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until all "
                  "of them are repaired\n" +
                  file +
                  ":331:16: error: 0x13FF:01: signature 0xB632 of SRDO 1, expected 0xB631, computed from its "
                  "parameters\n");
    EXPECT_EQ(answer.err, "");
}

TEST_F(CheckCommandTest, EndsWith0WhenThereAreOnlyWarnings)
{
    Verifies(req::SRS_CLI_009);
    Verifies(req::SRS_CLI_001);
    const std::string file =
        File("w.dcf", Changed(ExampleText("sensor"), {{"CANopenSafetySupported=1\n", "CANopenSafetySupported=0\n"}}));
    const Answer answer = RunCommand({"check", file});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.out, file + ":17:1: warning: [DeviceInfo] does not announce CANopen Safety, expected "
                                 "CANopenSafetySupported=1\n");
}

TEST_F(CheckCommandTest, EndsWith2WhenTheFileCannotBeRead)
{
    Verifies(req::SRS_CLI_001);
    Verifies(req::SRS_CLI_009);
    const Answer missing = RunCommand({"check", Path("none.dcf")});
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.out, "");
    EXPECT_EQ(missing.err, Path("none.dcf") + ": error: it cannot be opened (No such file or directory), expected a "
                                              "readable EDS or DCF file\n");
    const std::string file = File("cut.dcf", ExampleText("sensor").substr(0U, 3018U));
    const Answer cut = RunCommand({"check", file});
    EXPECT_EQ(cut.status, 2);
    EXPECT_EQ(cut.err, file + ":195:1: error: 'DefaultValu' is no line of an EDS, expected [section], key=value or a "
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
    EXPECT_NE(answer.out.find(file +
                              ":627:16: error: 0x5F04:00: device digest 0x046FFAB8, expected 0x046FFAB7, computed "
                              "from the device's parameters\n"),
              std::string::npos);
    const std::string none =
        File("none.dcf", Changed(ExampleText("actuator"), {{"ParameterValue=0x046FFAB7", "ParameterValue=0"}}));
    EXPECT_EQ(RunCommand({"check", none}).out,
              none + ":627:16: warning: 0x5F04:00: no device digest; a wrong device parameter, 0x1300 included, is not "
                     "found, expected the one that 'counterpoint sign' computes\n");
    EXPECT_EQ(RunCommand({"check", none}).status, 0);
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
    const auto refusal = nlohmann::json::parse(RunCommand({"check", "--json", Path("none.dcf")}).out)["error"];
    EXPECT_EQ(refusal["file"], Path("none.dcf"));
    EXPECT_EQ(refusal["line"], 0);
    EXPECT_EQ(refusal["column"], 0);
    EXPECT_EQ(refusal["message"],
              "it cannot be opened (No such file or directory), expected a readable EDS or DCF file");
}
/// Statuses of check and generate, and whether node would run with all SRDOs, for a changed file.
struct Taken
{
    int check;
    int generate;
    bool node;
};

class OneReading : public test::CommandTest
{
  protected:
    [[nodiscard]] Taken TakenWith(const std::string& text) const
    {
        const std::string file = File("one.dcf", text);
        const auto is_error = [](const cia306::Finding& finding)
        { return finding.severity == cia306::Severity::kError; };
        const std::vector<cia306::Finding> refused = runtime::TryDevice(cia306::ReadDeviceFile(file), std::nullopt);
        return {RunCommand({"check", file}).status,
                RunCommand({"generate", file, "--output", Path("code"), "--namespace", "one"}).status,
                std::none_of(refused.begin(), refused.end(), is_error)};
    }
    void ExpectAllTake(const std::string& text, const std::string& name) const
    {
        const Taken taken = TakenWith(text);
        EXPECT_EQ(taken.check, 0) << name;
        EXPECT_EQ(taken.generate, 0) << name;
        EXPECT_TRUE(taken.node) << name;
    }
    [[nodiscard]] static std::string PlainText()
    {
        return cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf");
    }
    [[nodiscard]] static std::string WithObject(const std::string& type, const std::string& keys)
    {
        return PlainText() + "\n[2FF0]\nParameterName=x\nObjectType=0x7\nDataType=" + type + "\nAccessType=rw\n" +
               keys + "PDOMapping=1\n";
    }
};

TEST_F(OneReading, WhatCheckOnlyWarnsOfIsTakenByAll)
{
    Verifies(req::SRS_CLI_030);
    Verifies(req::SRS_EDS_032);
    ExpectAllTake(PlainText(), "as it is");
    for (const char* const keys :
         {"LowLimit=-0\nHighLimit=-0\n", "LowLimit=-1\n", "HighLimit=99999999999LL\n", "DefaultValue=abc\n",
          "ParameterValue=0x1FFFFFFFFF\n", "DefaultValue=7u\nLowLimit=0UL\n", "LowLimit=5\nHighLimit=1\n",
          "DefaultValue=9\nHighLimit=3\n", "DefaultValue=$NODEID+$NODEID\n", "LowLimit=low\n"})
    {
        ExpectAllTake(WithObject("0x0007", keys), keys);
        ExpectAllTake(WithObject("0x0003", keys), keys);
    }
    for (const char* const keys :
         {"DefaultValue=0 0\n", "DefaultValue=12, 3\n", "DefaultValue=noon\n", "DefaultValue=0x1\n"})
    {
        ExpectAllTake(WithObject("0x000C", keys), keys);
        ExpectAllTake(WithObject("0x000D", keys), keys);
    }
    ExpectAllTake(WithObject("0x0001", "DefaultValue=true\nLowLimit=no\n"), "BOOLEAN");
    ExpectAllTake(WithObject("0x0008", "DefaultValue=1,5\n"), "REAL32");
}

TEST_F(OneReading, WhatOneRefusesIsAnErrorOfCheck)
{
    Verifies(req::SRS_CLI_030);
    Verifies(req::SRS_CLI_210);
    const std::string safety = ExampleText("controller");
    for (const std::string& text :
         {PlainText() + "\n[1300]\nDataType=5\nAccessType=rw\nDefaultValue=0\n",
          Changed(safety, {{"ParameterValue=0x22000208", "ParameterValue=0x22000108"}}),
          Changed(safety, {{"ParameterValue=0x00000103", "ParameterValue=0x00000101"}}),
          PlainText() + "\n[1A20]\nObjectType=9\nSubNumber=2\n[1A20sub0]\nDataType=5\nAccessType=rw\n"
                        "DefaultValue=254\n[1A20sub1]\nDataType=7\nAccessType=rw\n"
                        "[1820]\nObjectType=9\nSubNumber=2\n[1820sub0]\nDataType=5\nAccessType=ro\n"
                        "DefaultValue=1\n[1820sub1]\nDataType=7\nAccessType=rw\nDefaultValue=0x80000000\n"})
    {
        const Taken taken = TakenWith(text);
        EXPECT_FALSE(taken.node && taken.generate == 0 && taken.check == 0);
        EXPECT_EQ(taken.check, 1);
    }
}

TEST_F(OneReading, ASafetyObjectWithoutSrdoIsRefusedByNode)
{
    Verifies(req::SRS_CLI_033);
    for (const char* const index : {"1300", "13FE"})
    {
        const Taken taken = TakenWith(PlainText() + "\n[" + index + "]\nDataType=5\nAccessType=rw\nDefaultValue=0\n");
        EXPECT_FALSE(taken.node) << index;
        EXPECT_EQ(taken.check, 1) << index;
    }
}

TEST_F(OneReading, AMappedObjectWithAValueThatItsTypeCannotHaveIsRefusedByNodeAndSimulate)
{
    Verifies(req::SRS_CLI_034);
    const Taken taken =
        TakenWith(cia306::test::WithValues(ExampleText("controller"), {{"2000sub1", "ParameterValue", "256"}}));
    EXPECT_FALSE(taken.node);
    EXPECT_EQ(taken.check, 1);
    const Answer simulated =
        RunCommand({"simulate", "--quiet", File("s.yaml", "title: x\nduration: 10 ms\nnodes:\n  a: {dcf: one.dcf}\n")});
    EXPECT_EQ(simulated.status, 2);
    EXPECT_NE(simulated.err.find("error: 0x2000:01: value '256', expected a number from 0 to 255 (UNSIGNED8)"),
              std::string::npos)
        << simulated.err;
}

TEST_F(OneReading, AnSrdoThatIsOffIsTakenAsTheDeviceTakesIt)
{
    Verifies(req::SRS_CLI_030);
    Verifies(req::SRS_CLI_031);
    const std::string off =
        cia306::test::WithValues(ExampleText("controller"), {{"1302sub1", "ParameterValue", "0"},
                                                             {"1302sub5", "ParameterValue", "0x101"},
                                                             {"1302sub6", "ParameterValue", "0x102"},
                                                             {"1382sub3", "ParameterValue", "0x20000108"},
                                                             {"1382sub4", "ParameterValue", "0x21000108"}});
    ExpectAllTake(cia306::test::SignedAgain(off, std::nullopt), "off");
}

TEST_F(OneReading, WhyTheKernelRefusesAStartIsToldByCheckAndSimulate)
{
    Verifies(req::SRS_EASE_007);
    // Given a granularity that there is not
    const std::string file =
        File("slow.dcf", cia306::test::WithValues(ExampleText("sensor"), {{"5F00subA", "ParameterValue", "3"}}));
    const std::string reason = "the kernel refuses this device: granularity (Not 1, 8, 16, 32 or 64)";
    // Then who builds the device for a check is told
    const std::vector<cia306::Finding> told = runtime::TryDevice(cia306::ReadDeviceFile(file), std::nullopt);
    EXPECT_TRUE(std::any_of(told.begin(), told.end(), [&reason](const cia306::Finding& finding)
                            { return finding.text == reason && finding.severity == cia306::Severity::kError; }));
    // and who simulates it
    const Answer simulated = RunCommand(
        {"simulate", File("s.yaml", "title: x\nduration: 1 s\nnodes: {1: {dcf: slow.dcf, self_tests: false}}\n")});
    EXPECT_EQ(simulated.status, 2);
    EXPECT_EQ(simulated.err, file + ": error: " + reason +
                                 ", expected SRDOs, objects and times of 0x5F00 within the ranges of DeviceConfig\n");
}

// check was content with a file that simulate refused.
TEST_F(OneReading, AnIntervalTooShortForTheSelfTestsOfSimulateIsAWarning)
{
    Verifies(req::SRS_CLI_710);
    const auto file = [this](const std::string& interval_ms)
    {
        return File("interval" + interval_ms + ".dcf",
                    cia306::test::SignedAgain(
                        cia306::test::WithValues(ExampleText("sensor"), {{"5F00sub4", "ParameterValue", interval_ms}}),
                        std::nullopt));
    };
    // Given 60 ms, which are 40 cycles that are each as late as allowed
    const std::string misfit = "the self tests do not fit into the diagnostic interval of 40 cycles, expected a longer "
                               "one (0x5F00:04), or ";
    const auto told = simulator::TrySelfTests(file("60"), std::nullopt);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->text, "simulated, " + misfit + "'self_tests: false' for this node");
    EXPECT_EQ(told->severity, cia306::Severity::kWarning);
    const std::string place = cia306::PlaceText(file("60"), told->place);
    const Answer checked = RunCommand({"check", file("60")});
    EXPECT_EQ(checked.status, 0) << checked.out;
    EXPECT_EQ(checked.out.rfind(place + ": warning: ", 0U), 0U) << checked.out;
    EXPECT_NE(checked.out.find(misfit), std::string::npos) << checked.out;
    EXPECT_EQ(std::count(checked.out.begin(), checked.out.end(), '\n'), 1) << checked.out; // Of both programs one.
    const std::string scenario = "title: x\nduration: 10 ms\nnodes: {1: {dcf: interval60.dcf}}\n";
    const Answer simulated = RunCommand({"simulate", File("s.yaml", scenario)});
    EXPECT_EQ(simulated.status, 2);
    EXPECT_EQ(simulated.err, place + ": error: " + misfit + "'self_tests: false' for this node\n");
    // A usual one, and a file that cannot be simulated for another reason, are no such warning
    EXPECT_FALSE(simulator::TrySelfTests(file("1000"), std::nullopt));
    EXPECT_FALSE(simulator::TrySelfTests(File("plain.dcf", PlainText()), std::nullopt));
    EXPECT_FALSE(simulator::TrySelfTests(Path("missing.dcf"), std::nullopt));
}

TEST_F(OneReading, ASafetyParameterIsNoVariableOfAnySrdoOrRpdo)
{
    Verifies(req::SRS_EDS_730);
    // Given 5F01h:01 in the mapping of an SRDO
    const std::string mapped = cia306::test::SignedAgain(
        cia306::test::WithValues(ExampleText("sensor"), {{"1381sub1", "ParameterValue", "0x5F010108"},
                                                         {"5F01sub1", "PDOMapping", "1"},
                                                         {"2000sub1", "InvertedSRAD", ""}}),
        std::nullopt);
    const Taken by_srdo = TakenWith(mapped);
    EXPECT_EQ(by_srdo.check, 1);
    EXPECT_EQ(by_srdo.generate, 1);
    EXPECT_FALSE(by_srdo.node);
    // and 5F00h:03 in that of an RPDO
    std::string text = cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/runtime/data/everything.dcf");
    text =
        cia306::test::WithValues(text, {{"1600sub1", "DefaultValue", "0x5F000320"}, {"5F00sub3", "PDOMapping", "1"}});
    const Answer answer = RunCommand({"check", File("rpdo.dcf", text)});
    EXPECT_NE(answer.out.find("warning: 0x1600:01: "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("warning: 0x5F00:03: it is mappable"), std::string::npos) << answer.out;
}

TEST_F(OneReading, AToleranceThatLeavesNoLimitIsAWarning)
{
    Verifies(req::SRS_CLI_731);
    const auto told = [this](const std::string& tolerance, const std::string& interval)
    {
        const std::string text = cia306::test::SignedAgain(
            cia306::test::WithValues(ExampleText("sensor"), {{"5F00sub6", "ParameterValue", tolerance},
                                                             {"5F00sub7", "ParameterValue", interval}}),
            std::nullopt);
        const Answer answer = RunCommand({"check", File("d.dcf", text)});
        EXPECT_EQ(answer.status, 0) << answer.out;
        return answer.out;
    };
    EXPECT_EQ(told("500", "100000"), "");
    // Given 5999 us in 6000 us, then 1.0015 s of the self tests are 1001501 intervals, and more than 2^32 us
    EXPECT_EQ(told("5999", "6000"),
              Path("d.dcf") + ":462:16: warning: 0x5F00:06: no limit can be computed for some faults with a clock "
                              "tolerance of 5999 us in 6000 us (0x5F00:07), expected a smaller one, or shorter "
                              "intervals in 0x5F00:04 and 0x5F00:05\n");
    EXPECT_EQ(told("3000", "6000"), "");
}

TEST_F(OneReading, WhatSimulateAndMonitorNeedIsAWarning)
{
    Verifies(req::SRS_CLI_212);
    const std::string plain = File("plain.dcf", PlainText());
    EXPECT_NE(RunCommand({"check", plain}).out.find(plain + ":16:1: warning: no SRDO, "), std::string::npos);
    EXPECT_EQ(RunCommand({"check", plain}).status, 0);
    // Then simulate refuses the file, and so does monitor
    EXPECT_EQ(
        RunCommand({"simulate", File("s.yaml", "title: x\nduration: 1 s\nnodes: {5: {dcf: plain.dcf}}\n")}).status, 2);
    const std::string log = File("bus.log", "(0.000000) can0 123#\n");
    EXPECT_EQ(RunCommand({"monitor", log, "--dcf", plain}).status, 2);
    // And that of SRDOs that are not declared valid
    const std::string invalid =
        File("invalid.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xA5", "ParameterValue=0x00"}}));
    EXPECT_EQ(RunCommand({"check", invalid}).out,
              invalid + ":309:16: warning: 0x13FE:00: 0x00: the SRDOs stay off, expected 0xA5 to set them going\n");
    EXPECT_EQ(RunCommand({"monitor", log, "--dcf", invalid}).status, 2);
}

TEST_F(OneReading, AValueThatAServiceRefusesIsAWarningAtItsLine)
{
    Verifies(req::SRS_CLI_211);
    const std::string file = File("one.dcf", WithObject("0x0005", "DefaultValue=300\n"));
    const Answer answer = RunCommand({"check", file});
    EXPECT_EQ(answer.status, 0) << answer.out;
    EXPECT_NE(answer.out.find("warning: 0x2FF0:00: "), std::string::npos) << answer.out;
    // And where a service refuses what its data type has room for: 241 for 1019h
    const std::string sync =
        File("sync.dcf", PlainText() + "\n[1019]\nParameterName=x\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\n"
                                       "DefaultValue=241\nPDOMapping=0\n");
    const Answer of_sync = RunCommand({"check", sync});
    EXPECT_EQ(of_sync.status, 0) << of_sync.out;
    EXPECT_NE(of_sync.out.find(sync + ":568:14: warning: 0x1019:00: the device refuses this value with abort code "
                                      "0x06090030, expected one of the object's range\n"),
              std::string::npos)
        << of_sync.out;
}

TEST_F(OneReading, NodeTellsWhatItLeavesOut)
{
    Verifies(req::SRS_EDS_032);
    const std::string file = File("one.dcf", WithObject("0x0005", "DefaultValue=300\nHighLimit=x\n"));
    std::vector<std::string> lines;
    for (const cia306::Finding& finding : runtime::TryDevice(cia306::ReadDeviceFile(file), std::nullopt))
    {
        lines.push_back(finding.object + ": " + finding.text);
    }
    // The client of this file asks its own second server
    const std::string own = ", too, and the device keeps all, expected an identifier of its own";
    EXPECT_EQ(lines, (std::vector<std::string>{
                         "0x2FF0:00: value '300' is left out, expected a number from 0 to 255 (UNSIGNED8)",
                         "0x2FF0:00: limit: value 'x' is left out, expected a number from 0 to 255 (UNSIGNED8), or "
                         "$NODEID+number",
                         "0x1281:01: COB-ID 0x685 is in use by 0x1201:01" + own,
                         "0x1281:02: COB-ID 0x6A5 is in use by 0x1201:02" + own}));
}

TEST_F(OneReading, ASuffixIsToldAndAValueOfTheStructureHasNone)
{
    Verifies(req::SRS_EDS_033);
    const std::string file = File("one.dcf", WithObject("0x0007", "HighLimit=4294967295UL\n"));
    const std::string told = RunCommand({"check", file}).out;
    EXPECT_NE(told.find(file + ":568:11: warning: 0x2FF0:00: HighLimit: '4294967295UL' is read without its suffix, "
                               "expected a number without U or L"),
              std::string::npos)
        << told;
    const std::string bad = File("bad.dcf", WithObject("0x0007UL", ""));
    EXPECT_EQ(RunCommand({"check", bad}).status, 2);
}

TEST_F(OneReading, AGranularityOrACycleThatIsNoneEndsNoCommand)
{
    Verifies(req::SRS_CLI_490);
    Verifies(req::SRS_NODE_490);
    // Given a granularity of 0
    const std::string file =
        File("g0.dcf", cia306::test::WithValues(ExampleText("sensor"), {{"5F00subA", "ParameterValue", "0"}}));
    const std::string told = "error: 0x5F00:0A: granularity of 0 bit, expected 1, 8, 16, 32 or 64 bit\n";
    const auto tells = [&told](const std::vector<std::string>& words, const int status)
    {
        const Answer answer = RunCommand(words);
        EXPECT_EQ(answer.status, status) << words[0];
        EXPECT_NE((answer.out + answer.err).find(told), std::string::npos) << answer.out << answer.err;
    };
    tells({"check", file}, 1);
    tells({"generate", file, "--output", Path("code")}, 1);
    tells({"srdo", "add", file, "--produce", "8", "--refresh", "25", "--srvt", "20"}, 2);
    tells({"srdo", "remove", file, "--number", "1"}, 2);
    const Answer signing = RunCommand({"sign", file});
    EXPECT_EQ(signing.status, 0);
    EXPECT_NE((signing.out + signing.err).find(file + ": warning: check finds errors: 2, expected none\n"),
              std::string::npos)
        << signing.out << signing.err; // And 13FEh, which is A5h.
    // Given a cycle time of 0, or a tolerance above the cycle time, then simulate names it with its place
    const std::string cycle =
        File("c0.dcf", cia306::test::WithValues(ExampleText("sensor"), {{"5F00sub1", "ParameterValue", "0"},
                                                                        {"5F00sub2", "ParameterValue", "0"}}));
    const Answer simulated =
        RunCommand({"simulate", File("s.yaml", "title: x\nduration: 1 s\nnodes: {1: {dcf: c0.dcf}}\n")});
    EXPECT_EQ(simulated.status, 2);
    EXPECT_NE(simulated.err.find("c0.dcf:417:16: error: 0x5F00:01: cycle time 0 us, expected 100 us to 1000000 us\n"),
              std::string::npos)
        << simulated.err;
    static_cast<void>(
        File("c1.dcf", cia306::test::WithValues(ExampleText("sensor"), {{"5F00sub2", "ParameterValue", "1001"}})));
    const Answer tolerant =
        RunCommand({"simulate", File("t.yaml", "title: x\nduration: 1 s\nnodes: {1: {dcf: c1.dcf}}\n")});
    EXPECT_EQ(tolerant.status, 2);
    EXPECT_NE(tolerant.err.find("c1.dcf:426:16: error: 0x5F00:02: cycle tolerance of 1001 us, expected at most the "
                                "cycle time of 1000 us\n"),
              std::string::npos)
        << tolerant.err;
    // and who builds the device for node
    EXPECT_FALSE(runtime::TryDevice(cia306::ReadDeviceFile(cycle), std::nullopt).empty());
}

TEST_F(OneReading, TheSecondControllerMayHaveTheNormalFrames)
{
    Verifies(req::SRS_SIM_490);
    Verifies(req::SRS_CLI_030);
    // Given normal frames on the second controller, inverse ones there too or on the first
    for (const std::string inverse : {"1", "2"})
    {
        const std::string text = cia306::test::WithValues(
            ExampleText("sensor"), {{"5F00subF", "ParameterValue", "2"}, {"5F00sub10", "ParameterValue", inverse}});
        ExpectAllTake(cia306::test::SignedAgain(text, std::nullopt), "inverse frames on " + inverse);
    }
}

TEST_F(OneReading, TheFlagStandsBesideAnErrorOfTheTrial)
{
    Verifies(req::SRS_CLI_491);
    // Given two variables with more objects than the kernel takes, 1025
    std::string text = ExampleText("sensor");
    for (int number = 0; number < 1025; ++number)
    {
        const std::string index = cia306::Hex(0x3000U + static_cast<unsigned>(number), 4).substr(2U);
        text += "\n[" + index + "]\nDataType=5\nAccessType=ro\nPDOMapping=0\nSRDOMapping=1\n";
    }
    const std::string out = RunCommand({"check", File("many.dcf", text)}).out;
    EXPECT_NE(out.find("error: 1029 mappable objects, expected at most 1024\n"), std::string::npos)
        << out.substr(0, 300);
    EXPECT_NE(out.find("error: 0x13FE:00: 0xA5 marks a configuration with errors as valid, expected 0x00 until all of "
                       "them are repaired\n"),
              std::string::npos);
}
} // namespace
} // namespace counterpoint::tools
