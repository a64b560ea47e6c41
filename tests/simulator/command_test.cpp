// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "tools/command_line/run.hpp"
#include "tools/command_table.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::tools
{
namespace
{
struct Answer
{
    ExitStatus status;
    std::string out;
    std::string err;
};

Answer Tool(const std::vector<std::string>& arguments)
{
    std::ostringstream out;
    std::ostringstream err;
    const ExitStatus status = RunCommandLine(arguments, CommandTable(), {out, err});
    return {status, out.str(), err.str()};
}

std::string Content(const std::string& file)
{
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    return content.str();
}

TEST(SimulateCommand, EndsWithZeroOneOrTwo)
{
    Verifies(req::SRS_SIM_044);
    // All hold
    const Answer good = Tool({"simulate", simulator::Examples() + "00_no_fault.yaml"});
    EXPECT_EQ(good.status, ExitStatus::kHolds) << good.out;
    EXPECT_NE(good.out.find("7 of 7 expectations hold"), std::string::npos);
    // One does not
    const std::string failing =
        simulator::TextFile("extends: " + simulator::Examples() +
                            "chain.yaml\nexpect:\n  - {that: safe, node: actuator, srdo: 1, at: 900 ms}\n");
    const Answer bad = Tool({"simulate", failing, "--quiet"});
    EXPECT_EQ(bad.status, ExitStatus::kDoesNotHold);
    EXPECT_EQ(bad.out,
              "  FAILED  actuator SRDO 1 safe at 900 ms: released  (" + failing + ":3:5)\n0 of 1 expectations hold\n");
    // Bad input: one line
    const Answer lost = Tool({"simulate", "/nonexistent.yaml"});
    EXPECT_EQ(lost.status, ExitStatus::kBadInput);
    EXPECT_EQ(lost.err, "/nonexistent.yaml: no such file, expected a scenario\n");
    EXPECT_EQ(lost.out, "");
    EXPECT_EQ(Tool({"simulate"}).status, ExitStatus::kBadInput);
    EXPECT_EQ(Tool({"simulate", failing, "--seed", "x"}).status, ExitStatus::kBadInput);
    const Answer until = Tool({"simulate", failing, "--until", "20"});
    EXPECT_EQ(until.status, ExitStatus::kBadInput);
    EXPECT_EQ(until.err.substr(0U, 25U), "--until: '20', expected a");
}

TEST(SimulateCommand, WritesAllReportsAndSaysWhereItCannot)
{
    Verifies(req::SRS_SIM_041);
    Verifies(req::SRS_SIM_042);
    Verifies(req::SRS_SIM_043);
    Verifies(req::SRS_SIM_045);
    const std::string base = ::testing::TempDir() + "counterpoint_reports";
    const Answer answer = Tool({"simulate", simulator::Examples() + "02_loss_of_inverse_frame.yaml", "--quiet",
                                "--html", base + ".html", "--json", base + ".json", "--candump", base + ".log"});
    EXPECT_EQ(answer.status, ExitStatus::kHolds) << answer.out << answer.err;
    EXPECT_EQ(Content(base + ".html").substr(0U, 15U), "<!DOCTYPE html>");
    EXPECT_EQ(Content(base + ".json").substr(0U, 1U), "{");
    EXPECT_EQ(Content(base + ".log").substr(0U, 1U), "(");
    const Answer lost = Tool({"simulate", simulator::Examples() + "02_loss_of_inverse_frame.yaml", "--quiet", "--json",
                              "/nonexistent/x.json"});
    EXPECT_EQ(lost.status, ExitStatus::kBadInput);
    EXPECT_NE(lost.err.find("/nonexistent/x.json"), std::string::npos);
}

TEST(SimulateCommand, AnOutputThatCannotBeWrittenIsToldBeforeAnythingElse)
{
    Verifies(req::SRS_SIM_045);
    // Given one output that can be written and one that cannot
    const std::string page = ::testing::TempDir() + "counterpoint_alone.html";
    const Answer answer = Tool({"simulate", simulator::Examples() + "02_loss_of_inverse_frame.yaml", "--html", page,
                                "--json", "/nonexistent/x.json"});
    // Then there is one line, and neither a time line nor the other output
    EXPECT_EQ(answer.status, ExitStatus::kBadInput);
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err, "/nonexistent/x.json:0: error: it cannot be created (No such file or directory), expected a "
                          "path in a writable folder\n");
    EXPECT_FALSE(std::filesystem::exists(page));
    // Then the same of demo
    const Answer demo = Tool({"demo", "--scenarios", simulator::Examples(), "--html", "/dev/null"});
    EXPECT_EQ(demo.status, ExitStatus::kBadInput);
    EXPECT_EQ(demo.out, "");
    EXPECT_EQ(std::count(demo.err.begin(), demo.err.end(), '\n'), 1) << demo.err;
}

TEST(SimulateCommand, NoOutputReplacesWhatTheRunReads)
{
    Verifies(req::SRS_SIM_049);
    const std::string file = simulator::Examples() + "02_loss_of_inverse_frame.yaml";
    for (const char* const name : {"02_loss_of_inverse_frame.yaml", "chain.yaml", "sensor.dcf", "./actuator.dcf"})
    {
        const std::string output = simulator::Examples() + name;
        const std::string before = Content(output);
        for (const std::vector<std::string>& more :
             std::vector<std::vector<std::string>>{{}, {"--sweep", "duration=1s:2s:1s"}})
        {
            std::vector<std::string> arguments{"simulate", file, "--json", output};
            arguments.insert(arguments.end(), more.begin(), more.end());
            const Answer answer = Tool(arguments);
            EXPECT_EQ(answer.status, ExitStatus::kBadInput) << name;
            EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
            EXPECT_NE(answer.err.find("which is named already or read by the run"), std::string::npos) << answer.err;
        }
        EXPECT_EQ(Content(output), before) << name;
    }
}

TEST(SimulateCommand, RefusesOptionsThatWouldBeIgnored)
{
    Verifies(req::SRS_SIM_049);
    const std::string file = simulator::Examples() + "02_loss_of_inverse_frame.yaml";
    const std::string out = ::testing::TempDir() + "counterpoint_same.html";
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"simulate", file, "--html", ""},
             {"simulate", file, "--quiet", "--frames"},
             {"simulate", file, "--explain"},
             {"simulate", "--explain", "--quiet"},
             {"simulate", "--markdown"},
             {"simulate", file, "--sweep", "duration=1s:2s:1s", "--candump", out},
             {"simulate", file, "--sweep", "duration=1s:2s:1s", "--frames"},
             {"simulate", file, "--seed", "18446744073709551616"},
             {"simulate", file, "--seed", "-1"},
             {"simulate", file, "--seed", ""},
             {"simulate", file, "--until", ""},
             {"simulate", file, "--html", out, "--json", out},
             {"simulate", file, "--html", out, "--json", ::testing::TempDir() + "/./counterpoint_same.html"},
             {"simulate", file, "--candump", file},
             {"demo", "--html", ""},
             {"demo", "--scenarios", ""},
             {"demo", "--list", "--html", out}})
    {
        const Answer answer = Tool(arguments);
        EXPECT_EQ(answer.status, ExitStatus::kBadInput) << arguments.back();
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        EXPECT_NE(answer.err.find("expected"), std::string::npos) << answer.err;
    }
    EXPECT_EQ(Tool({"simulate", file, "--quiet", "--seed", "18446744073709551615"}).status, ExitStatus::kHolds);
}

TEST(SimulateCommand, TellsOfAFaultThatNeverHadAnEffect)
{
    Verifies(req::SRS_SIM_015);
    // Given a fault on frames that nobody sends
    const std::string file = simulator::TextFile("extends: " + simulator::Examples() + R"(chain.yaml
faults:
  - {fault: loss, frames: {identifier: 0x7FF}}
expect:
  - {that: detected_by, node: actuator, by: nobody}
  - {that: safe_within, node: actuator, srdo: 1}
)");
    const Answer answer = Tool({"simulate", file, "--quiet"});
    // Then nothing that is expected of it holds, and its place is told
    EXPECT_EQ(answer.status, ExitStatus::kDoesNotHold);
    EXPECT_EQ(answer.err,
              file + ":3:5: fault 'loss' never happened, expected it within the run, or 'optional: true'\n");
    EXPECT_NE(answer.out.find("0 of 3 expectations hold"), std::string::npos) << answer.out;
}

TEST(SimulateCommand, EndsARecordingThatGrowsTooLarge)
{
    Verifies(req::SRS_SIM_048);
    const std::string file =
        simulator::TextFile("extends: " + simulator::Examples() + "chain.yaml\nduration: 2000 s\n");
    const Answer answer = Tool({"simulate", file});
    EXPECT_EQ(answer.status, ExitStatus::kBadInput);
    EXPECT_EQ(answer.err, file + ": more than 500000 frames and events to record, expected a shorter run, or --quiet "
                                 "without output files\n");
    EXPECT_EQ(answer.out, "");
}

TEST(SimulateCommand, SeedAndUntilReplaceThoseOfTheScenario)
{
    Verifies(req::SRS_SIM_003);
    const std::string file = simulator::TextFile(
        "extends: " + simulator::Examples() +
        "chain.yaml\nfaults:\n  - {fault: loss, frames: {receiver: actuator, count: 1000, probability_ppm: 300000}}\n");
    const Answer one = Tool({"simulate", file, "--seed", "5", "--until", "300ms"});
    const Answer again = Tool({"simulate", file, "--seed", "5", "--until", "300ms"});
    const Answer other = Tool({"simulate", file, "--seed", "6", "--until", "300ms"});
    EXPECT_EQ(one.out, again.out);
    EXPECT_NE(one.out, other.out);
    EXPECT_EQ(one.out.find(" 301."), std::string::npos);
}

TEST(SimulateCommand, ExplainsTheFormat)
{
    Verifies(req::SRS_SIM_047);
    // Given everything, a key, a fault kind, and a name that is none
    const Answer all = Tool({"simulate", "--explain"});
    EXPECT_EQ(all.status, ExitStatus::kHolds);
    EXPECT_NE(all.out.find("\n  probability_ppm: number from 1 to 1000000; default 1000000\n"), std::string::npos);
    const Answer key = Tool({"simulate", "--explain", "jump"});
    EXPECT_EQ(
        key.out,
        "in clock:\n  jump: time other than 0, negative: back, at most 1000 s\n      jumps forward, or back, once\n"
        "      e.g. jump: -3 ms\n\n");
    const Answer kind = Tool({"simulate", "--explain", "loss"});
    EXPECT_EQ(kind.out.substr(0U, 56U), "loss\n  The frame does not arrive.\n  fault: one of corrup");
    const Answer empty = Tool({"simulate", "--explain", ""});
    EXPECT_EQ(empty.status, ExitStatus::kBadInput);
    EXPECT_EQ(empty.out, "");
    EXPECT_EQ(empty.err, "counterpoint simulate: --explain '', expected a key or section of the format; without a name "
                         "all of them are told\n");
    const Answer none = Tool({"simulate", "--explain", "losses"});
    EXPECT_EQ(none.status, ExitStatus::kBadInput);
    EXPECT_EQ(none.err, "counterpoint simulate: --explain 'losses', expected a key or section of the format; without a "
                        "name all of them are told\n");
    // And the document has the same reference
    const Answer reference = Tool({"simulate", "--explain", "--markdown"});
    EXPECT_EQ(reference.status, ExitStatus::kHolds);
    const std::string document = Content(std::string(COUNTERPOINT_SOURCE_FOLDER) + "/docs/scenario.md");
    const std::string begin = "<!-- counterpoint simulate --explain --markdown -->\n";
    const std::size_t place = document.find(begin);
    ASSERT_NE(place, std::string::npos);
    EXPECT_EQ(document.substr(place + begin.size()), reference.out);
}

TEST(DemoCommand, ShowsEveryRunWithItsLimitAndWritesThePage)
{
    Verifies(req::SRS_DEMO_001);
    Verifies(req::SRS_DEMO_002);
    Verifies(req::SRS_DEMO_003);
    Verifies(req::SRS_DEMO_004);
    const std::string folder = ::testing::TempDir() + "counterpoint_demo";
    std::filesystem::remove_all(folder);
    const std::clock_t start = std::clock();
    // When the demonstration runs on the shipped scenarios
    const Answer answer = Tool({"demo", "--html", folder});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    // Then every row is in time, the page is there and is named, and nobody had to wait
    EXPECT_EQ(answer.status, ExitStatus::kHolds) << answer.out << answer.err;
    EXPECT_NE(answer.out.find("30 of 30 runs as expected"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("Timing diagrams: " + folder + "/index.html"), std::string::npos) << answer.out;
    EXPECT_TRUE(std::filesystem::exists(folder + "/index.html"));
    EXPECT_LT(seconds, 10.0);
}

TEST(DemoCommand, FailsWhenARunFails)
{
    Verifies(req::SRS_DEMO_002);
    // Given a folder with one scenario whose expectation does not come
    const std::string folder = ::testing::TempDir() + "counterpoint_demo_failing";
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/01_bad.yaml") << "extends: " << simulator::Examples() << R"(chain.yaml
title: Loss that is not noticed
faults:
  - {fault: loss, frames: {identifier: 0x7FF}}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
)";
    const Answer answer = Tool({"demo", "--scenarios", folder, "--html", folder + "/page.html"});
    EXPECT_EQ(answer.status, ExitStatus::kDoesNotHold);
    EXPECT_NE(answer.out.find("the fault never happened"), std::string::npos) << answer.out;
    // and one without scenarios
    const Answer none = Tool({"demo", "--scenarios", "/nonexistent"});
    EXPECT_EQ(none.status, ExitStatus::kBadInput);
    EXPECT_NE(none.err.find("no scenarios"), std::string::npos);
}

TEST(DemoCommand, ListsItsScenarios)
{
    Verifies(req::SRS_DEMO_001);
    const Answer answer = Tool({"demo", "--list"});
    EXPECT_EQ(answer.status, ExitStatus::kHolds);
    EXPECT_NE(answer.out.find("Corruption of one bit"), std::string::npos);
    EXPECT_EQ(answer.out.find("Long run"), std::string::npos);
}
} // namespace
} // namespace counterpoint::tools
