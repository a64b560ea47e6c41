// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <string>
#include <sys/resource.h>

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using test::Answer;
using test::RunCommand;

class GenerateCommandTest : public test::CommandTest
{
  protected:
    [[nodiscard]] static std::string Example()
    {
        return cia306::test::SourceFolder() + "/examples/emergency_stop/sensor.dcf";
    }
    [[nodiscard]] std::size_t FilesIn(const std::string& folder) const
    {
        const auto files = std::filesystem::directory_iterator(Path(folder));
        return static_cast<std::size_t>(std::distance(begin(files), end(files)));
    }
};

TEST_F(GenerateCommandTest, WritesTwoFilesIntoANewFolder)
{
    Verifies(req::SRS_GEN_001);
    const Answer answer = RunCommand({"generate", Example(), "--output", Path("out"), "--namespace", "a::sensor"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(answer.err, "");
    EXPECT_EQ(answer.out, Path("out/object_dictionary.hpp") + "\n" + Path("out/object_dictionary.cpp") +
                              "\n38 entries, 4 variables of 1 SRDOs, 33 bytes of memory, 66 bytes of constants\n");
    EXPECT_EQ(FilesIn("out"), 2U);
    const std::string header = cia306::ReadTextFile(Path("out/object_dictionary.hpp"));
    EXPECT_NE(header.find("namespace a::sensor\n"), std::string::npos);
    EXPECT_EQ(header.find(cia306::test::SourceFolder()), std::string::npos);
}

TEST_F(GenerateCommandTest, NeitherFileIsReplacedWhereOneOfThemHasNoRoom)
{
    Verifies(req::SRS_GEN_170);
    // Given the two files of a sensor, and a system that takes no more of a file than its header needs
    ASSERT_EQ(RunCommand({"generate", Example(), "--output", Path("out"), "--namespace", "sensor"}).status, 0);
    const std::string header = cia306::ReadTextFile(Path("out/object_dictionary.hpp"));
    const std::string source = cia306::ReadTextFile(Path("out/object_dictionary.cpp"));
    ASSERT_LT(header.size() + 1000U, source.size());
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{source.size() - 1U, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    // When the same is generated under another name
    const Answer answer = RunCommand({"generate", Example(), "--output", Path("out"), "--namespace", "newer_sensor"});
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    (void)std::signal(SIGXFSZ, handler);
    // Then it is refused, and the two that were there still belong together
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err, Path("out/object_dictionary.cpp") +
                              ": error: it cannot be written (File too large), expected a file system with room\n");
    EXPECT_EQ(cia306::ReadTextFile(Path("out/object_dictionary.hpp")), header);
    EXPECT_EQ(cia306::ReadTextFile(Path("out/object_dictionary.cpp")), source);
    EXPECT_EQ(FilesIn("out"), 2U);
}

TEST_F(GenerateCommandTest, WithoutAFolderItWritesIntoTheWorkingOne)
{
    Verifies(req::SRS_GEN_001);
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::create_directory(Path("here"));
    std::filesystem::current_path(Path("here"));
    const Answer answer = RunCommand({"generate", Example()});
    std::filesystem::current_path(before);
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(FilesIn("here"), 2U);
    // And neither of them has a path
    for (const char* name : {"object_dictionary.hpp", "object_dictionary.cpp"})
    {
        EXPECT_EQ(cia306::ReadTextFile(Path("here/") + name).find(cia306::test::SourceFolder()), std::string::npos);
    }
}

TEST_F(GenerateCommandTest, TheSameCallWritesTheSameBytes)
{
    Verifies(req::SRS_GEN_001);
    ASSERT_EQ(RunCommand({"generate", Example(), "--output", Path("one")}).status, 0);
    ASSERT_EQ(RunCommand({"generate", Example(), "--output", Path("two")}).status, 0);
    for (const char* name : {"object_dictionary.hpp", "object_dictionary.cpp"})
    {
        EXPECT_EQ(cia306::ReadTextFile(Path("one/") + name), cia306::ReadTextFile(Path("two/") + name));
    }
}

TEST_F(GenerateCommandTest, AnErrorOfTheCheckWritesNothing)
{
    Verifies(req::SRS_GEN_002);
    const std::string file =
        File("bad.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xB631", "ParameterValue=0xB632"}}));
    const Answer answer = RunCommand({"generate", file, "--output", Path("out")});
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.out, "");
    EXPECT_NE(answer.err.find(":331:16: error: 0x13FF:01: signature 0xB632 of SRDO 1, expected 0xB631"),
              std::string::npos);
    EXPECT_NE(answer.err.find(": error: nothing is written, expected a file without errors, or --force\n"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(Path("out")));
    // With --force it is told, and written
    const Answer forced = RunCommand({"generate", file, "--output", Path("out"), "--force"});
    EXPECT_EQ(forced.status, 0);
    EXPECT_NE(forced.err.find(":331:16: error:"), std::string::npos);
    EXPECT_EQ(FilesIn("out"), 2U);
}

// What node refuses is an error of the check, too: here a multiplexed PDO
TEST_F(GenerateCommandTest, WhatTheDeviceRefusesIsAnErrorToo)
{
    Verifies(req::SRS_GEN_002);
    const std::string file =
        File("device.dcf", "[DeviceInfo]\nVendorName=x\n[DeviceComissioning]\nNodeID=5\n"
                           "[1800]\nObjectType=9\n[1800sub0]\nDataType=5\nAccessType=const\nDefaultValue=2\n"
                           "[1800sub1]\nDataType=7\nAccessType=rw\nDefaultValue=0x185\n"
                           "[1800sub2]\nDataType=5\nAccessType=rw\nDefaultValue=254\n"
                           "[1A00]\nObjectType=9\n[1A00sub0]\nDataType=5\nAccessType=rw\nDefaultValue=254\n"
                           "[1A00sub1]\nDataType=7\nAccessType=rw\nDefaultValue=0x20000008\n");
    const std::string error = ":24:14: error: 0x1A00:00 = 254, a multiplexed PDO, which is not built, expected a count";
    EXPECT_EQ(RunCommand({"check", file}).status, 1);
    const Answer answer = RunCommand({"generate", file, "--output", Path("out")});
    EXPECT_EQ(answer.status, 1);
    EXPECT_NE(answer.err.find(error), std::string::npos) << answer.err;
    EXPECT_FALSE(std::filesystem::exists(Path("out")));
    const Answer forced = RunCommand({"generate", file, "--output", Path("out"), "--force"});
    EXPECT_EQ(forced.status, 0) << forced.err;
    EXPECT_NE(forced.err.find(error), std::string::npos) << forced.err;
    EXPECT_EQ(FilesIn("out"), 2U);
}

// A value that a service refuses, a length that it has not, and what only generated code does without
TEST_F(GenerateCommandTest, TellsWhatTheCheckTellsAndEachOnce)
{
    Verifies(req::SRS_GEN_002);
    const std::string file = File("device.dcf", "[DeviceInfo]\nVendorName=x\n[DeviceComissioning]\nNodeID=5\n"
                                                "[1005]\nDataType=7\nAccessType=rw\nDefaultValue=0x20000080\n"
                                                "[1017]\nDataType=7\nAccessType=rw\nDefaultValue=100\n"
                                                "[2000]\nDataType=5\nAccessType=rw\nDefaultValue=9\nHighLimit=8\n");
    const Answer checked = RunCommand({"check", file});
    EXPECT_EQ(checked.status, 0);
    EXPECT_NE(checked.out.find(":8:14: warning: 0x1005:00: the device refuses this value"), std::string::npos);
    EXPECT_NE(checked.out.find(":10:10: warning: 0x1017:00: data type of 32 bit"), std::string::npos);
    EXPECT_NE(checked.out.find(":16:14: warning: 0x2000:00: value '9', expected at most the HighLimit '8'"),
              std::string::npos);
    const Answer answer = RunCommand({"generate", file, "--output", Path("out")});
    EXPECT_EQ(answer.status, 0);
    EXPECT_EQ(answer.err, checked.out);
}

TEST_F(GenerateCommandTest, BadInputIsOneLineAndNoFile)
{
    Verifies(req::SRS_GEN_003);
    const std::string formula = File("f.eds", "[FileInfo]\n\n[1014]\nParameterName=EMCY\nDataType=7\nAccessType=rw\n"
                                              "DefaultValue=$NODEID+0x80\n");
    const Answer lacking = RunCommand({"generate", formula, "--output", Path("out")});
    EXPECT_EQ(lacking.status, 2);
    EXPECT_EQ(lacking.err, formula +
                               ":7:14: error: 0x1014:00: value '$NODEID+0x80' needs the node-ID and there is none, "
                               "expected --node-id, or NodeID in [DeviceComissioning]\n");
    EXPECT_FALSE(std::filesystem::exists(Path("out")));
    EXPECT_EQ(RunCommand({"generate", formula, "--output", Path("out"), "--node-id", "3"}).status, 0);
    const Answer taken = RunCommand({"generate", Example(), "--namespace", "class", "--output", Path("none")});
    EXPECT_EQ(taken.status, 2);
    EXPECT_EQ(taken.err.find("counterpoint: --namespace: 'class' is taken, expected another name of a namespace"), 0U);
    EXPECT_FALSE(std::filesystem::exists(Path("none")));
    const Answer deep = RunCommand({"generate", Example(), "--output", Path("no/such")});
    EXPECT_EQ(deep.status, 2);
    EXPECT_EQ(deep.err, Path("no/such") + ": error: it is no folder and cannot be made (No such file or directory), "
                                          "expected a folder, or a name in one\n");
    EXPECT_EQ(RunCommand({"generate", Example(), "--output", Example()}).status, 2);
    const Answer unread = RunCommand({"generate", Path("none.dcf"), "--output", Path("none")});
    EXPECT_EQ(unread.status, 2);
    EXPECT_EQ(unread.err, Path("none.dcf") + ": error: it cannot be opened (No such file or directory), expected a "
                                             "readable EDS or DCF file\n");
    EXPECT_FALSE(std::filesystem::exists(Path("none")));
}

TEST_F(GenerateCommandTest, AValueOfASafetyObjectThatCannotBeStoredIsRefusedWithForceToo)
{
    Verifies(req::SRS_GEN_003);
    const auto generated = [this](const std::string& from, const std::string& to, const bool is_forced)
    {
        const std::string file = File("value.dcf", Changed(ExampleText("sensor"), {{from, to}}));
        std::vector<std::string> words{"generate", file, "--output", Path("none")};
        if (is_forced)
        {
            words.emplace_back("--force");
        }
        return RunCommand(words);
    };
    // Given an SCT of more than 16 bits
    const Answer answer = generated("ParameterValue=25\n", "ParameterValue=70000\n", true);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err, Path("value.dcf") + ":215:16: error: 0x1301:02: value '70000', expected a number from 0 to "
                                              "65535 (UNSIGNED16)\n");
    EXPECT_FALSE(std::filesystem::exists(Path("none")));
    // One of an object that an SRDO maps is an error of the check
    const Answer mapped = generated("DefaultValue=0x00\nPDOMapping=0\nSRDOMapping=1\nInvertedSRAD=0x210001",
                                    "DefaultValue=300\nPDOMapping=0\nSRDOMapping=1\nInvertedSRAD=0x210001", false);
    EXPECT_EQ(mapped.status, 1);
    EXPECT_NE(mapped.err.find(
                  "value.dcf:352:14: error: 0x2000:01: value '300', expected a number from 0 to 255 (UNSIGNED8)\n"),
              std::string::npos)
        << mapped.err;
    EXPECT_FALSE(std::filesystem::exists(Path("none")));
}

// Given files of the names of the output that somebody else made, the input among them, then none is touched; an older
// output and an empty file are replaced.
TEST_F(GenerateCommandTest, ReplacesNothingButItsOwn)
{
    Verifies(req::SRS_GEN_018);
    const std::string device = cia306::ReadTextFile(Example());
    const std::string input = File("object_dictionary.hpp", device);
    const Answer own = RunCommand({"generate", input, "--output", Path("")});
    EXPECT_EQ(own.status, 2);
    EXPECT_EQ(own.err, input + ": error: it is there and was not made by 'counterpoint generate', expected another "
                               "--output, or that you remove it\n");
    EXPECT_EQ(cia306::ReadTextFile(input), device);
    EXPECT_FALSE(std::filesystem::exists(Path("object_dictionary.cpp")));
    static_cast<void>(File("object_dictionary.hpp", ""));
    const std::string source = File("object_dictionary.cpp", "int main() {}\n");
    EXPECT_EQ(RunCommand({"generate", Example(), "--output", Path(""), "--force"}).status, 2);
    EXPECT_EQ(cia306::ReadTextFile(input), "");
    EXPECT_EQ(cia306::ReadTextFile(source), "int main() {}\n");
    static_cast<void>(File("object_dictionary.cpp", ""));
    EXPECT_EQ(RunCommand({"generate", Example(), "--output", Path("")}).status, 0);
    const std::string made = cia306::ReadTextFile(source);
    EXPECT_NE(made, "");
    // What it made is replaced, whatever else stands in it
    static_cast<void>(File("object_dictionary.cpp", made + "// an older version\n"));
    EXPECT_EQ(RunCommand({"generate", Example(), "--output", Path("")}).status, 0);
    EXPECT_EQ(cia306::ReadTextFile(source), made);
}

TEST_F(GenerateCommandTest, AnswersAsJson)
{
    Verifies(req::SRS_GEN_015);
    const Answer answer = RunCommand({"generate", Example(), "--output", Path("out"), "--json"});
    EXPECT_EQ(answer.status, 0);
    const auto document = nlohmann::json::parse(answer.out);
    EXPECT_EQ(document["holds"], true);
    EXPECT_EQ(document["written"],
              nlohmann::json::array({Path("out/object_dictionary.hpp"), Path("out/object_dictionary.cpp")}));
    EXPECT_EQ(document["entries"], 38);
    EXPECT_EQ(document["variables"], 4);
    EXPECT_EQ(document["srdos"], 1);
    EXPECT_EQ(document["memory_bytes"], 33);
    EXPECT_EQ(document["findings"].size(), 0U);
    const std::string bad =
        File("bad.dcf", Changed(ExampleText("sensor"), {{"ParameterValue=0xB631", "ParameterValue=0xB632"}}));
    const auto refusal = nlohmann::json::parse(RunCommand({"generate", bad, "--json"}).out);
    EXPECT_EQ(refusal["holds"], false);
    EXPECT_EQ(refusal["written"].size(), 0U);
    EXPECT_EQ(refusal["findings"].size(), 2U);
    EXPECT_EQ(nlohmann::json::parse(RunCommand({"generate", "--json", Path("none.dcf")}).out)["error"]["line"], 0);
}
} // namespace
} // namespace counterpoint::tools
