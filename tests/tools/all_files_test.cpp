// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "runtime/node/trial.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <regex>
#include <set>
#include <string>
#include <vector>

// What check lets pass, every command takes: for every device file of the tests and examples, for the real ones in
// COUNTERPOINT_DEVICE_FOLDER, and for odd ones.
namespace counterpoint::tools
{
namespace
{
using test::RunCommand;

void AddDeviceFiles(const std::filesystem::path& folder, std::set<std::string>& files)
{
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        const std::string kind = entry.path().extension().string();
        if (kind == ".eds" || kind == ".dcf")
        {
            files.insert(entry.path().string());
        }
    }
}

std::set<std::string> AllDeviceFiles()
{
    std::set<std::string> files;
    AddDeviceFiles(cia306::test::SourceFolder() + "/tests", files);
    AddDeviceFiles(cia306::test::SourceFolder() + "/examples", files);
    const char* const real = std::getenv("COUNTERPOINT_DEVICE_FOLDER");
    std::cout << (real == nullptr ? "no COUNTERPOINT_DEVICE_FOLDER with real files\n" : "with real files\n");
    if (real != nullptr)
    {
        AddDeviceFiles(real, files);
    }
    return files;
}

class AllFilesTest : public test::CommandTest
{
  protected:
    /// Which commands refuse the file although check ends with 0; nothing else is said of a file that check refuses.
    [[nodiscard]] std::string RefusedBy(const std::string& file) const
    {
        const bool can_be_read = RunCommand({"check", file}).status != 2;
        const std::vector<std::string> node = can_be_read ? NodeOf(file) : std::vector<std::string>{};
        if (RunCommand(With({"check", file}, node)).status != 0)
        {
            return can_be_read && RunCommand({"check", file}).status == 0 ? "check with a node-ID" : "";
        }
        const cia306::Device device = cia306::ReadDeviceFile(file);
        const std::optional<std::uint8_t> id = node.empty() ? device.node_id : std::optional<std::uint8_t>(5U);
        std::string refused;
        const auto add = [&refused](const bool is_refused, const char* const name)
        { refused += is_refused ? std::string(name) + " " : ""; };
        add(RunCommand(With({"sign", file}, node)).status != 0, "sign");
        add(RunCommand(With({"sign", file, "--write", Path("signed.dcf")}, node)).status != 0, "sign --write");
        add(RunCommand(With({"generate", file, "--output", Path("code"), "--namespace", "one"}, node)).status != 0,
            "generate");
        const std::vector<cia306::Finding> found = runtime::TryDevice(device, id);
        add(std::any_of(found.begin(), found.end(),
                        [](const cia306::Finding& finding) { return finding.severity == cia306::Severity::kError; }),
            "node");
        const bool has_srdo = !cia306::ExtractSafety(device, id).srdos.empty();
        const std::string setup = node.empty() ? "" : ", node_id: 5";
        const std::string scenario =
            File("one.yaml", "title: one\nduration: 100 ms\nnodes:\n  device: {dcf: " + file + setup + "}\n");
        add(has_srdo && RunCommand({"simulate", scenario, "--quiet"}).status != 0, "simulate");
        const std::string log = File("one.log", "(1.000000) can0 701#05\n");
        add(RunCommand({"monitor", log, "--frames", "--dcf", node.empty() ? file : file + "=5"}).status == 2,
            "monitor");
        return refused;
    }

  private:
    /// The option for a file without node-ID.
    [[nodiscard]] static std::vector<std::string> NodeOf(const std::string& file)
    {
        return cia306::ReadDeviceFile(file).node_id ? std::vector<std::string>{}
                                                    : std::vector<std::string>{"--node-id", "5"};
    }
    [[nodiscard]] static std::vector<std::string> With(std::vector<std::string> words,
                                                       const std::vector<std::string>& more)
    {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

TEST_F(AllFilesTest, WhatCheckLetsPassEveryCommandTakes)
{
    Verifies(req::SRS_CLI_030);
    const std::set<std::string> files = AllDeviceFiles();
    EXPECT_GE(files.size(), 25U);
    int passed = 0;
    for (const std::string& file : files)
    {
        EXPECT_EQ(RefusedBy(file), "") << file;
        passed += RunCommand({"check", file}).status == 0 ? 1 : 0;
    }
    EXPECT_GE(passed, 15);
}

/// The text with every match of the pattern replaced.
std::string Replaced(const std::string& text, const std::string& pattern, const std::string& by)
{
    return std::regex_replace(text, std::regex(pattern), by);
}

TEST_F(AllFilesTest, OddFilesAreTakenByAllOfThem)
{
    Verifies(req::SRS_CLI_030);
    Verifies(req::SRS_EDS_035);
    const std::string sensor = cia306::test::ExampleText("sensor");
    const std::string plain =
        cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf") + "\n[3000]\n";
    const std::vector<std::string> texts{
        Replaced(sensor, "\n", "\r\n"),
        "\xEF\xBB\xBF" + sensor,
        Replaced(sensor, "=", "\t=\t"),
        Replaced(sensor, "((DataType|AccessType|ParameterValue|SubNumber|ObjectType)=[^\n]*)\n", "$1 # why\n"),
        Replaced(sensor, "(\\[[^\n]*\\])\n", "$1 ; what\n"),
        Replaced(sensor, "ParameterName=[^\n]*\n", ""),
        Replaced(sensor, "SubNumber=[^\n]*\n", ""),
        Replaced(sensor, "ObjectType=[^\n]*\n", ""),
        Replaced(sensor, "0x66596575", "0"),
        plain + "ParameterName=\nObjectType=\nDataType=7\nAccessType=rw\nDefaultValue=\nLowLimit=\nHighLimit=\n",
        plain + "ObjectType=2\nAccessType=rw\nDefaultValue=xx;#\n",
        plain + "DataType=9\nAccessType=rww\nDefaultValue=\"a # b\" ; c\nPDOMapping=1\n",
        plain + "DataType=8 ; REAL32\nAccessType=rww\nDefaultValue=1e3#thousand\nPDOMapping=1 # yes\n",
        plain + "DataType=5\nAccessType=rw\nLowLimit=9 # above\nHighLimit=3 ; below\nDefaultValue=200\n",
        plain + "ParameterName=\"*/ \\\" %s // \?\?/\nDataType=5\nAccessType=rw\n",
        plain + "ObjectType=8\nDataType=6\nAccessType=rw\nCompactSubObj=254 # all\nDefaultValue=1 ; one\n[3000Value]\n"
                "NrOfEntries=1\n254=0xFFFF # last\n",
        plain + "ParameterName=const without a value\nDataType=6\nAccessType=const\n",
        plain + "DataType=6\nAccessType=wo\nPDOMapping=1\nDefaultValue=$NODEID ; own\n",
        plain + "ObjectType=8\nSubNumber=2\n[3000sub0]\nDataType=5\nAccessType=ro\nDefaultValue=255\n[3000subFF]\n"
                "DataType=5\nAccessType=rw\nDefaultValue=1\n",
        Replaced(plain, "NodeID=5", "NodeID=127 # last") + "DataType=7\nAccessType=ro\nDefaultValue=$NODEID+0x180\n",
    };
    for (const std::string& text : texts)
    {
        const std::string file = File("odd.dcf", text);
        EXPECT_EQ(RunCommand({"check", file}).status, 0) << text;
        EXPECT_EQ(RefusedBy(file), "") << text;
    }
}

TEST_F(AllFilesTest, ASecondControllerIsTakenByAllOfThem)
{
    Verifies(req::SRS_CLI_030);
    // Given normal and inverse frames on either controller
    for (const std::string normal : {"1", "2"})
    {
        for (const std::string inverse : {"1", "2"})
        {
            const std::string text = cia306::test::WithValues(
                cia306::test::ExampleText("sensor"),
                {{"5F00subF", "ParameterValue", normal}, {"5F00sub10", "ParameterValue", inverse}});
            const std::string file = File("ports.dcf", cia306::test::SignedAgain(text, std::nullopt));
            EXPECT_EQ(RunCommand({"check", file}).status, 0) << normal << inverse;
            EXPECT_EQ(RefusedBy(file), "") << normal << inverse;
        }
    }
}

TEST_F(AllFilesTest, SelfTestsThatDoNotFitAreLeftOutAsTheWarningAsks)
{
    Verifies(req::SRS_CLI_030);
    // Given an interval of 60 ms, which check warns of
    const std::string text =
        cia306::test::WithValues(cia306::test::ExampleText("sensor"), {{"5F00sub4", "ParameterValue", "60"}});
    const std::string file = File("interval.dcf", cia306::test::SignedAgain(text, std::nullopt));
    EXPECT_EQ(RunCommand({"check", file}).status, 0);
    // Then simulate alone needs the option that the warning names, and has enough with it
    EXPECT_EQ(RefusedBy(file), "simulate ");
    const std::string scenario =
        File("two.yaml", "title: two\nduration: 100 ms\nnodes:\n  device: {dcf: interval.dcf, self_tests: false}\n");
    EXPECT_EQ(RunCommand({"simulate", scenario, "--quiet"}).status, 0);
}
} // namespace
} // namespace counterpoint::tools
