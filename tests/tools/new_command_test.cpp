// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "tests/tools/command_run.hpp"
#include "tools/new_answers.hpp"
#include "verification/trace/ids/new_device.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <variant>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using test::Answer;
using test::RunCommand;

class NewCommandTest : public test::CommandTest
{
  protected:
    /// Nobody sits at the standard input, wherever the test runs.
    NewCommandTest()
    {
        const int nothing = ::open("/dev/null", O_RDONLY);
        EXPECT_EQ(::dup2(nothing, STDIN_FILENO), STDIN_FILENO);
        ::close(nothing);
    }

    /// counterpoint new with these options, into a file of that name.
    [[nodiscard]] Answer New(const std::string& name, std::vector<std::string> options) const
    {
        options.insert(options.begin(), {"new", "-o", Path(name)});
        return RunCommand(options);
    }
    [[nodiscard]] cia306::Device DeviceOf(const std::string& name) const
    {
        return cia306::ReadDeviceFile(Path(name));
    }
    [[nodiscard]] bool Exists(const std::string& name) const
    {
        return std::filesystem::exists(Path(name));
    }
};

std::string ValueOf(const cia306::Device& device, const std::uint16_t index, const std::uint8_t sub)
{
    const cia306::Entry* const entry = device.Find(index, sub);
    return entry == nullptr ? "no entry" : entry->Configured().text;
}

TEST_F(NewCommandTest, ProducerIsWrittenSignedAndValid)
{
    Verifies(req::SRS_NEW_001);
    Verifies(req::SRS_NEW_003);
    // Given a node-ID and one SRDO of two objects of 8 bits
    const Answer answer = New("sensor.dcf", {"--node-id", "5", "--produce", "2x8", "--name", "Light curtain"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(answer.out, Path("sensor.dcf") +
                              ": node-ID 5, signed, valid\n"
                              "SRDO 1 sends 0x109 and 0x10A, refresh time 25 ms, SRVT 20 ms, signature 0x4C04\n"
                              "  0x2000:01 and 0x2100:01  8 bit  Sent data 1.1\n"
                              "  0x2000:02 and 0x2100:02  8 bit  Sent data 1.2\n");
    // Then the file has what the configuration procedure would write; 4C04h was computed by hand over
    // 01 19 00 14 09 01 00 00 0A 01 00 00 04 01 08 01 00 20 02 08 01 00 21 03 08 02 00 20 04 08 02 00 21.
    const cia306::Device device = DeviceOf("sensor.dcf");
    EXPECT_EQ(device.node_id, 5U);
    EXPECT_EQ(ValueOf(device, 0x1301U, 1U), "1");
    EXPECT_EQ(ValueOf(device, 0x1301U, 4U), "254");
    EXPECT_EQ(ValueOf(device, 0x1301U, 5U), "0x00000109");
    EXPECT_EQ(ValueOf(device, 0x1381U, 0U), "4");
    EXPECT_EQ(ValueOf(device, 0x1381U, 4U), "0x21000208");
    EXPECT_EQ(ValueOf(device, 0x13FEU, 0U), "0xA5");
    EXPECT_EQ(ValueOf(device, 0x13FFU, 0U), "1");
    EXPECT_EQ(ValueOf(device, 0x13FFU, 1U), "0x4C04");
    EXPECT_EQ(ValueOf(device, 0x5F03U, 1U), "0x01");
    EXPECT_EQ(device.Find(0x2000U, 2U)->inverted_srad, 0x210002U);
    // and check finds nothing, sign the same signature and the digest of 5F04h.
    const Answer check = RunCommand({"check", Path("sensor.dcf")});
    EXPECT_EQ(check.status, 0);
    EXPECT_EQ(check.out, "");
    EXPECT_EQ(RunCommand({"sign", Path("sensor.dcf")}).out,
              "0x13FF:01 = 0x4C04\n0x5F04:00 = " + ValueOf(device, 0x5F04U, 0U) + "\n");
}

TEST_F(NewCommandTest, ControllerHasWhatItsOptionsSay)
{
    Verifies(req::SRS_NEW_001);
    Verifies(req::SRS_NEW_004);
    const Answer answer = New("c.dcf", {"--role",         "controller",  "--node-id",     "7",
                                        "--produce",      "Speed=i16,8", "--consume",     "2x8@node5",
                                        "--consume",      "64@0x17F",    "--gfc",         "on",
                                        "--detection",    "late",        "--release",     "automatic",
                                        "--refresh",      "30",          "--sct",         "60",
                                        "--srvt",         "10",          "--bit-rate",    "250",
                                        "--vendor-id",    "0x12345678",  "--vendor-name", "Example & Co",
                                        "--product-code", "99"});
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(answer.out, Path("c.dcf") +
                              ": node-ID 7, signed, valid\n"
                              "SRDO 1 sends 0x10D and 0x10E, refresh time 30 ms, SRVT 10 ms, signature 0x4548\n"
                              "  0x2000:01 and 0x2100:01  16 bit  Speed\n"
                              "  0x2000:02 and 0x2100:02  8 bit  Sent data 1.2\n"
                              "SRDO 2 receives 0x109 and 0x10A, SCT 60 ms, SRVT 10 ms, signature 0xDB07\n"
                              "  0x2200:01 and 0x2300:01  8 bit  Received data 2.1\n"
                              "  0x2200:02 and 0x2300:02  8 bit  Received data 2.2\n"
                              "SRDO 3 receives 0x17F and 0x180, SCT 60 ms, SRVT 10 ms, signature 0x3DFA\n"
                              "  0x2201:01 and 0x2301:01  64 bit  Received data 3.1\n");
    const cia306::Device device = DeviceOf("c.dcf");
    EXPECT_EQ(ValueOf(device, 0x1018U, 1U), "0x12345678");
    EXPECT_EQ(ValueOf(device, 0x1018U, 2U), "0x00000063");
    EXPECT_EQ(ValueOf(device, 0x1300U, 0U), "1");
    EXPECT_EQ(ValueOf(device, 0x5F01U, 1U), "0x00");
    EXPECT_EQ(ValueOf(device, 0x5F01U, 2U), "0x5A");
    EXPECT_EQ(ValueOf(device, 0x5F05U, 1U), "0x00");
    EXPECT_EQ(ValueOf(device, 0x5F05U, 3U), "0x3C");
    const std::string text = cia306::ReadTextFile(Path("c.dcf"));
    EXPECT_NE(text.find("BaudRate_250=1\nBaudRate_500=0\n"), std::string::npos);
    EXPECT_NE(text.find("[OptionalObjects]\nSupportedObjects=12\n1=0x1014\n2=0x1015\n3=0x1017\n4=0x1300\n5=0x1301\n"
                        "6=0x1302\n7=0x1303\n8=0x1381\n9=0x1382\n10=0x1383\n11=0x13FE\n12=0x13FF\n"),
              std::string::npos);
    EXPECT_EQ(RunCommand({"check", Path("c.dcf")}).out, "");
}

TEST_F(NewCommandTest, PairRunsAndReleasesDataInSimulate)
{
    Verifies(req::SRS_NEW_001);
    // Given a producer and a consumer of its SRDO
    ASSERT_EQ(New("sensor.dcf", {"--node-id", "5", "--produce", "2x8", "--name", "Sensor"}).status, 0);
    ASSERT_EQ(New("drive.dcf", {"--node-id", "33", "--consume", "2x8@node5", "--name", "Drive"}).status, 0);
    // When both run, and a person acknowledges
    const std::string scenario = File(
        "pair.yaml", "title: Pair\nbitrate: 500000\nduration: 600 ms\nnodes:\n  sensor: {dcf: sensor.dcf}\n"
                     "  drive: {dcf: drive.dcf}\ninputs:\n  - {at: 20 ms, node: sensor, object: 0x2000:02, value: 7}\n"
                     "acknowledge:\n  - {at: 150 ms, node: drive, srdo: 1, pulse: 50 ms}\nexpect:\n"
                     "  - {that: safe, node: drive, srdo: 1, at: 149 ms}\n"
                     "  - {that: released, node: drive, srdo: 1, at: 250 ms}\n"
                     "  - {that: value, node: drive, object: 0x2200:02, is: 7, at: 550 ms}\n"
                     "  - {that: no_fault}\n");
    // Then the consumer is safe before and releases the data behind it.
    const Answer answer = RunCommand({"simulate", scenario, "--quiet", "--candump", Path("pair.log")});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    // and the monitor sees the SRDO of the two files without a violation.
    const Answer seen = RunCommand({"monitor", Path("pair.log"), "--dcf", Path("sensor.dcf"), Path("drive.dcf")});
    EXPECT_EQ(seen.status, 0) << seen.err;
    EXPECT_NE(seen.out.find("Sensor SRDO 1 -> Drive SRDO 1 (109h, 10Ah): 24 pairs, 0 violations\n"), std::string::npos)
        << seen.out;
    // Near miss: without the acknowledge nothing is released.
    const std::string silent = File("silent.yaml", "title: Pair\nbitrate: 500000\nduration: 600 ms\nnodes:\n"
                                                   "  sensor: {dcf: sensor.dcf}\n  drive: {dcf: drive.dcf}\nexpect:\n"
                                                   "  - {that: released, node: drive, srdo: 1, at: 550 ms}\n");
    EXPECT_EQ(RunCommand({"simulate", silent, "--quiet"}).status, 1);
}

TEST_F(NewCommandTest, EveryLengthIsTakenByGenerate)
{
    Verifies(req::SRS_NEW_003);
    ASSERT_EQ(
        New("all.dcf", {"--node-id", "64", "--produce", "8,i16,u32@0x101", "--produce", "24,40@0x103", "--produce",
                        "i24,i32,i8@0x105", "--consume", "48@0x107", "--consume", "i56@0x109", "--consume", "i64@0x10B",
                        "--consume", "8x8@0x10D", "--consume", "i40,Two words=2xu8@0x10F"})
            .status,
        0);
    const Answer answer = RunCommand({"generate", Path("all.dcf"), "--output", Path(""), "--namespace", "all"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.err, "");
    const cia306::Device device = DeviceOf("all.dcf");
    EXPECT_EQ(device.Find(0x2000U, 2U)->data_type, 0x0003U);
    EXPECT_EQ(device.Find(0x2001U, 1U)->data_type, 0x0016U);
    EXPECT_EQ(ValueOf(device, 0x2101U, 1U), "0xFFFFFF");
    EXPECT_EQ(ValueOf(device, 0x2102U, 1U), "-1");
    EXPECT_EQ(device.Find(0x2204U, 3U)->name, "Two words 2");
}

TEST_F(NewCommandTest, SixtyFourSrdosFit)
{
    Verifies(req::SRS_NEW_004);
#ifdef COUNTERPOINT_SANITIZED
    GTEST_SKIP() << "a sanitized program is so large that its self tests do not fit into the diagnostic interval";
#endif
    std::vector<std::string> options{"--node-id", "100"};
    for (int cob_id = 0x101; cob_id <= 0x17F; cob_id += 2)
    {
        options.insert(options.end(), {"--produce", "8@" + std::to_string(cob_id)});
    }
    EXPECT_EQ(New("many.dcf", options).status, 0);
    EXPECT_EQ(ValueOf(DeviceOf("many.dcf"), 0x1340U, 6U), "0x00000180");
    const Answer full = RunCommand({"srdo", "add", Path("many.dcf"), "--consume", "8@0x101"});
    EXPECT_EQ(full.err, Path("many.dcf") + ": error: all 64 SRDOs are there, expected a file with a free number\n");
    options.insert(options.end(), {"--consume", "8@0x101"});
    const Answer more = New("more.dcf", options);
    EXPECT_EQ(more.status, 2);
    EXPECT_EQ(more.err, "counterpoint: 65 SRDOs by --produce and --consume, expected at most 64\n");
}

TEST_F(NewCommandTest, DefaultCobIdIsThatOfThePreDefinedConnectionSetOnly)
{
    Verifies(req::SRS_NEW_004);
    struct Row
    {
        std::string node_id;
        std::string option;
        std::string cob_id; ///< Empty: there is none.
    };
    for (const Row& row : std::vector<Row>{{"1", "--produce", "0x00000101"},
                                           {"32", "--produce", "0x0000013F"},
                                           {"33", "--produce", ""},
                                           {"32", "--consume", ""},
                                           {"33", "--consume", "0x00000141"},
                                           {"64", "--consume", "0x0000017F"},
                                           {"65", "--consume", ""}})
    {
        const Answer answer = New("d.dcf", {"--force", "--node-id", row.node_id, row.option, "16"});
        EXPECT_EQ(answer.status, row.cob_id.empty() ? 2 : 0) << row.node_id;
        if (row.cob_id.empty())
        {
            EXPECT_EQ(answer.err, "counterpoint: " + row.option +
                                      " '16': SRDO 1 has no default COB-ID, expected one behind @, such as 16@0x109 or "
                                      "16@node5\n");
            continue;
        }
        EXPECT_EQ(ValueOf(DeviceOf("d.dcf"), 0x1301U, 5U), row.cob_id);
    }
    // Only SRDO 1 has one.
    EXPECT_EQ(New("two.dcf", {"--node-id", "5", "--produce", "8", "--produce", "8"}).err,
              "counterpoint: --produce '8': SRDO 2 has no default COB-ID, expected one behind @, such as 8@0x109 or "
              "8@node5\n");
}

TEST_F(NewCommandTest, WhatIsMissingOrDoesNotFitNamesTheOption)
{
    Verifies(req::SRS_NEW_002);
    struct Row
    {
        std::vector<std::string> options;
        std::string err;
    };
    const std::string role = "--role is missing, expected: producer, consumer, or controller (both)";
    for (const Row& row : std::vector<Row>{
             {{"--produce", "8"}, "--node-id is missing, expected: Node-ID, 1 to 127"},
             {{"--node-id", "5"}, role},
             {{"--role", "producer", "--node-id", "5"},
              "--produce is missing, expected: Objects of an SRDO that it sends, such as 2x8 or Speed=i16,8"},
             {{"--role", "controller", "--node-id", "5", "--produce", "8"},
              "--consume is missing, expected: Objects of an SRDO that it receives, such as 2x8 or Speed=i16,8"},
             {{"--role", "producer", "--node-id", "5", "--consume", "8"},
              "--consume does not fit --role producer, expected --role controller"},
             {{"--node-id", "5", "--produce", "8", "--sct", "50"},
              "--sct, --detection and --release fit no SRDO that is sent, expected --refresh"},
             {{"--node-id", "5", "--consume", "8@0x101", "--refresh", "50"},
              "--refresh fits no SRDO that is received, expected --sct"}})
    {
        const Answer answer = New("x.dcf", row.options);
        EXPECT_EQ(answer.status, 2) << row.err;
        EXPECT_EQ(answer.err, "counterpoint: " + row.err + "\n");
    }
    EXPECT_FALSE(Exists("x.dcf"));
}

TEST_F(NewCommandTest, WrongValuesAreRefusedWithWhatWasExpected)
{
    Verifies(req::SRS_NEW_002);
    Verifies(req::SRS_NEW_003);
    const std::string form =
        ", expected [NAME=][COUNTx]LENGTH such as 2x8, i16 or Speed=32, or INDEX:SUB of an object of "
        "the file, such as 0x6004:00";
    for (const auto& [option, value, problem] : std::vector<std::array<std::string, 3U>>{
             {"--node-id", "0", "'0', expected a number from 1 to 127"},
             {"--node-id", "128", "'128', expected a number from 1 to 127"},
             {"--node-id", "010", "'010', expected a number from 1 to 127"},
             {"--produce", "", "''" + form},
             {"--produce", "12", "'12'" + form},
             {"--produce", "0x8", "'0x8'" + form},
             {"--produce", "9x8", "'9x8'" + form},
             {"--produce", "8,,8", "''" + form},
             {"--produce", "A;B=8", "'A;B=8'" + form},
             {"--produce", "2x32,8", "'2x32,8' has 72 bits in 3 objects, expected at most 64 bits"},
             {"--produce", "8@0x102", "COB-ID '0x102', expected an odd one from 0x101 to 0x17F, or node1 to node64"},
             {"--produce", "8@0x181", "COB-ID '0x181', expected an odd one from 0x101 to 0x17F, or node1 to node64"},
             {"--produce", "8@node65", "COB-ID 'node65', expected an odd one from 0x101 to 0x17F, or node1 to node64"},
             {"--produce", "0x2000:01", "'0x2000:01' names an object, expected lengths such as 2x8"},
             {"--role", "slave", "'slave', expected producer, consumer or controller"},
             {"--bit-rate", "100", "'100', expected 10, 20, 50, 125, 250, 500, 800 or 1000"},
             {"--gfc", "1", "'1', expected on or off"},
             {"--detection", "soon", "'soon', expected early or late"},
             {"--release", "no", "'no', expected interlock or automatic"},
             {"--sct", "65536", "'65536', expected a number from 1 to 65535"},
             {"--srvt", "256", "'256', expected a number from 1 to 255"},
             {"--name", "[x\n", "'[x\\x0A', expected 1 to 60 characters of ASCII"}})
    {
        const Answer answer = New("x.dcf", {option, value});
        EXPECT_EQ(answer.status, 2) << value;
        EXPECT_EQ(answer.err, "counterpoint: " + option + ": " + problem +
                                  "; expected a command line as told by 'counterpoint new --help'\n");
    }
    EXPECT_FALSE(Exists("x.dcf"));
}

TEST_F(NewCommandTest, WhatCheckWouldFindIsToldAndNothingIsWritten)
{
    Verifies(req::SRS_NEW_005);
    const Answer warned = New("x.dcf", {"--node-id", "5", "--produce", "8", "--refresh", "20"});
    EXPECT_EQ(warned.status, 2);
    EXPECT_EQ(warned.err, Path("x.dcf") + ": error: 0x1301:03: SRVT 20 ms, expected less than the "
                                          "refresh time of 20 ms (a warning of check); nothing was written\n");
    const Answer twice = New("x.dcf", {"--node-id", "5", "--produce", "8", "--consume", "8@node5"});
    EXPECT_EQ(twice.status, 2);
    EXPECT_EQ(twice.err, Path("x.dcf") + ": error: 0x1302:05: COB-ID 0x109 is in use by SRDO 1, "
                                         "expected an identifier of its own; nothing was written\n");
    EXPECT_FALSE(Exists("x.dcf"));
    EXPECT_EQ(New("x.dcf", {"--node-id", "5", "--produce", "8", "--refresh", "21"}).status, 0);
}

TEST_F(NewCommandTest, NothingIsOverwrittenWithoutForce)
{
    Verifies(req::SRS_NEW_006);
    const std::string path = File("old.dcf", "work of weeks\n");
    const Answer refused = New("old.dcf", {"--node-id", "5", "--produce", "8"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err, path + ": error: the file is there already, expected the name of a new one, or --force\n");
    EXPECT_EQ(cia306::ReadTextFile(path), "work of weeks\n");
    // A link that leads nowhere is there, too.
    std::filesystem::create_symlink(Path("nowhere.dcf"), Path("link.dcf"));
    EXPECT_EQ(New("link.dcf", {"--node-id", "5", "--produce", "8"}).status, 2);
    EXPECT_FALSE(Exists("nowhere.dcf"));
    // So is a folder.
    std::filesystem::create_directory(Path("folder.dcf"));
    EXPECT_EQ(New("folder.dcf", {"--node-id", "5", "--produce", "8"}).status, 2);
    EXPECT_TRUE(std::filesystem::is_directory(Path("folder.dcf")));
    EXPECT_EQ(New("old.dcf", {"--force", "--node-id", "5", "--produce", "8"}).status, 0);
    EXPECT_EQ(DeviceOf("old.dcf").node_id, 5U);
}

/// What is asked, and the file that follows from the answers.
TEST(NewAnswersTest, PersonIsAskedForWhatNoOptionSays)
{
    Verifies(req::SRS_NEW_002);
    // Given a person who types a wrong node-ID and a wrong COB-ID first, and Enter where the default is right
    std::istringstream typed("controller\n200\n12\n\n2x8\n\n16\n\n0x104\nnode5\n\n\n30\nlate\n\n\n\n\n\n\n");
    std::ostringstream asked;
    Questions questions(&typed, asked);
    NewAnswers answers;
    // When the answers are completed
    answers.Complete(questions);
    // Then each question stands there with its default, a wrong answer is told,
    EXPECT_EQ(asked.str(),
              "producer, consumer, or controller (both): Node-ID, 1 to 127:   '200', expected a number from 1 to 127\n"
              "Node-ID, 1 to 127: Name of the device [Safety device]: "
              "Objects of an SRDO that it sends, such as 2x8 or Speed=i16,8: "
              "Objects of one more that it sends, Enter for none: "
              "Objects of an SRDO that it receives, such as 2x8 or Speed=i16,8: "
              "Objects of one more that it receives, Enter for none: "
              "COB-ID of the normal data of SRDO 2 (16), odd, 0x101 to 0x17F; nodeN: what node N sends by default: "
              "  '0x104', expected an odd number from 0x101 to 0x17F, or node1 to node64\n"
              "COB-ID of the normal data of SRDO 2 (16), odd, 0x101 to 0x17F; nodeN: what node N sends by default: "
              "Refresh time of what it sends [ms] [25]: SCT of what it receives [ms] [50]: SRVT [ms] [20]: "
              "SRVT detection, early or late [early]: Release, interlock or automatic [interlock]: "
              "Global fail-safe command, on or off [off]: Bit rate [kbit/s] [500]: Name of the vendor [Unknown]: "
              "Vendor-ID [0]: Product code [0]: ");
    // and the device is the one that was described.
    const cia306::DevicePlan plan = answers.Plan();
    EXPECT_EQ(plan.node_id, 12U);
    EXPECT_EQ(plan.name, "Safety device");
    ASSERT_EQ(plan.srdos.size(), 2U);
    EXPECT_EQ(plan.srdos[0].cob_id, 0x117U);
    EXPECT_EQ(plan.srdos[0].pairs.size(), 2U);
    EXPECT_EQ(plan.srdos[1].cob_id, 0x109U);
    EXPECT_EQ(plan.srdos[1].srvt_ms, 30U);
    EXPECT_TRUE(plan.srdos[1].is_late);
}

// What is sent and received is told: the role that follows from it is the default
TEST(NewAnswersTest, RoleThatFollowsFromTheOptionsIsTheDefault)
{
    Verifies(req::SRS_NEW_002);
    const auto asked = [](const std::vector<std::string>& given)
    {
        NewAnswers answers;
        Options options;
        answers.Describe(options);
        for (Option& option : options.All())
        {
            if (std::find(given.begin(), given.end(), option.name) != given.end())
            {
                std::get<std::vector<std::string>*>(option.target)->push_back("8");
            }
        }
        std::istringstream typed("\n\n");
        std::ostringstream text;
        Questions questions(&typed, text);
        EXPECT_THROW(answers.Complete(questions), std::runtime_error); // The input ends at a later question.
        return text.str().substr(0U, text.str().find(": "));
    };
    const std::string question = "producer, consumer, or controller (both)";
    EXPECT_EQ(asked({"--produce"}), question + " [producer]");
    EXPECT_EQ(asked({"--consume"}), question + " [consumer]");
    EXPECT_EQ(asked({"--produce", "--consume"}), question + " [controller]");
    EXPECT_EQ(asked({}), question);
}

TEST(NewAnswersTest, EndOfTheInputIsNoAnswer)
{
    Verifies(req::SRS_NEW_002);
    std::istringstream typed("producer\n");
    std::ostringstream asked;
    Questions questions(&typed, asked);
    NewAnswers answers;
    try
    {
        answers.Complete(questions);
        FAIL() << "expected a refusal";
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_STREQ(error.what(), "--node-id is missing, expected: Node-ID, 1 to 127");
    }
}
} // namespace
} // namespace counterpoint::tools
