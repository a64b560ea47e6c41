// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using Json = nlohmann::ordered_json;
using test::CommandTest;
using test::RunCommand;

const std::string kSource = COUNTERPOINT_SOURCE_FOLDER;
/// The names in them are data, not fields.
const std::set<std::string> kMaps{"services", "causes", "buses", "below_us", "values"};

/// The part of docs/json.md that describes a format; empty where none does.
std::string SectionOf(const std::string& format)
{
    static const std::string text = cia306::ReadTextFile(kSource + "/docs/json.md");
    const std::string link = "| [`" + format + "`](#";
    const std::size_t row = text.find(link);
    if (row == std::string::npos)
    {
        return "";
    }
    std::string title = text.substr(row + link.size(), text.find(')', row) - row - link.size());
    title = (title == "manager-check") ? "manager check" : title;
    const std::size_t begin = text.find("\n## " + title + "\n");
    return (begin == std::string::npos) ? "" : text.substr(begin, text.find("\n## ", begin + 1U) - begin);
}

/// Fields that the document does not name.
std::string UntoldOf(const Json& answer, std::string section)
{
    std::string untold;
    if (answer.is_object() && answer.contains("format"))
    {
        untold += (answer.begin().key() == "format") ? "" : "format is not the first; ";
        section = SectionOf(answer["format"]);
        untold += section.empty() ? "no section for " + answer["format"].get<std::string>() : "";
    }
    for (const auto& [key, value] : answer.items())
    {
        const bool is_told = answer.is_array() || key == "format" || section.find("`" + key + "`") != std::string::npos;
        untold += is_told ? "" : key + " ";
        untold += (value.is_structured() && kMaps.count(key) == 0U) ? UntoldOf(value, section) : "";
    }
    return untold;
}

/// The same of a document, or of lines.
std::string UntoldIn(const std::string& out, const std::string& format, const bool is_lines)
{
    std::istringstream lines(out);
    std::string untold = out.empty() ? "nothing" : "";
    for (std::string line; is_lines && std::getline(lines, line);)
    {
        const Json answer = Json::parse(line);
        untold += (answer.value("format", "") == format) ? "" : "format of " + line;
        untold += UntoldOf(answer, "");
    }
    if (!is_lines && !out.empty())
    {
        const Json answer = Json::parse(out);
        untold += (answer.value("format", "") == format) ? "" : "format of all";
        untold += UntoldOf(answer, "");
    }
    return untold;
}

class JsonAnswer : public CommandTest
{
  protected:
    /// What the program itself answers: node and manager block signals for as long as their process lives.
    [[nodiscard]] std::string ProgramOutput(const std::string& arguments) const
    {
        const std::string command =
            std::string(COUNTERPOINT_PROGRAM) + " " + arguments + " >" + Path("out") + " </dev/null";
        static_cast<void>(std::system(command.c_str()));
        return cia306::ReadTextFile(Path("out"));
    }

    const std::string device_{kSource + "/examples/emergency_stop/actuator.dcf"};
};

TEST_F(JsonAnswer, EachDocumentHasItsFormatAndEachFieldIsDescribed)
{
    Verifies(req::SRS_EASE_005);
    EXPECT_EQ(UntoldIn(RunCommand({"sign", device_, "--json"}).out, "counterpoint-sign-1", false), "");
    EXPECT_EQ(UntoldIn(RunCommand({"sign", device_, "--json", "--verbose", "--write", Path("a.dcf")}).out,
                       "counterpoint-sign-1", false),
              "");
    EXPECT_EQ(UntoldIn(RunCommand({"check", device_, "--json"}).out, "counterpoint-check-1", false), "");
    EXPECT_EQ(
        UntoldIn(RunCommand({"check", device_, "--json", "--granularity", "64"}).out, "counterpoint-check-1", false),
        "");
    EXPECT_EQ(UntoldIn(RunCommand({"generate", device_, "--json", "--output", Path("c")}).out,
                       "counterpoint-generate-1", false),
              "");
    EXPECT_EQ(UntoldIn(RunCommand({"check", Path("none.dcf"), "--json"}).out, "counterpoint-error-1", false), "");
    EXPECT_EQ(UntoldIn(RunCommand({"srdo", "list", device_, "--json"}).out, "counterpoint-srdo-1", false), "");
    EXPECT_EQ(UntoldIn(RunCommand({"srdo", "add", device_, "--consume", "8@0x111", "--json", "-o", Path("b.dcf")}).out,
                       "counterpoint-srdo-1", false),
              "");
    EXPECT_EQ(UntoldIn(RunCommand({"bus", "udp:239.74.163.12:" + std::to_string(20'000 + (::getpid() % 40'000)),
                                   "--listen", "127.0.0.1:0", "--seconds", "1", "--json"})
                           .out,
                       "counterpoint-bus-1", true),
              "");
}

TEST_F(JsonAnswer, RecordingOfASimulationAndWhatTheMonitorSaysOfIt)
{
    Verifies(req::SRS_EASE_005);
    const std::string scenario = kSource + "/examples/emergency_stop/02_loss_of_inverse_frame.yaml";
    ASSERT_NE(
        RunCommand({"simulate", scenario, "--quiet", "--json", Path("run.json"), "--candump", Path("run.log")}).status,
        2);
    EXPECT_EQ(UntoldIn(cia306::ReadTextFile(Path("run.json")), "counterpoint-simulation-1", false), "");
    const std::string examples = kSource + "/examples/emergency_stop/";
    const test::Answer answer = RunCommand({"monitor", Path("run.log"), "--json", "--dcf", examples + "sensor.dcf",
                                            "--dcf", examples + "controller.dcf", "--dcf", examples + "actuator.dcf"});
    ASSERT_NE(answer.status, 2) << answer.err;
    EXPECT_EQ(UntoldIn(answer.out, "counterpoint-monitor-1", false), "");
}

TEST_F(JsonAnswer, DemonstrationTellsLimitAndTimeOfEachRun)
{
    Verifies(req::SRS_DEMO_006);
    Verifies(req::SRS_EASE_005);
    const std::string folder = kSource + "/examples/emergency_stop";
    const test::Answer answer = RunCommand({"demo", "--scenarios", folder, "--html", Path("page.html"), "--json"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(UntoldIn(answer.out, "counterpoint-demo-1", false), "");
    const Json document = Json::parse(answer.out);
    EXPECT_EQ(document["holds"], true);
    EXPECT_EQ(document["page"], Path("page.html"));
    ASSERT_FALSE(document["runs"].empty());
    std::size_t judged = 0U;
    for (const Json& run : document["runs"])
    {
        EXPECT_EQ(run["holds"], true) << run;
        EXPECT_NE(run["title"], "") << run;
        EXPECT_NE(run["scenario"].get<std::string>().find(".yaml"), std::string::npos) << run;
        if (run.contains("limit_ns"))
        {
            ++judged;
            EXPECT_TRUE(run.contains("detection_cause")) << run;
            EXPECT_LE(run["elapsed_ns"].get<std::int64_t>(), run["limit_ns"].get<std::int64_t>()) << run;
            EXPECT_NE(run["detected_by"], "") << run;
        }
    }
    // Of each but the one without a fault
    EXPECT_EQ(judged, document["runs"].size() - 1U);
    // Discrepancy time 5 ms + cycle 1 ms, 0.5 ms late + counters 0.5 ms apart + output 1 ms
    const Json expected{{"title", "Channel A frozen"},
                        {"scenario", folder + "/10_channel_a_frozen.yaml"},
                        {"holds", true},
                        {"limit_ns", 8000000},
                        {"elapsed_ns", 1000000},
                        {"detected_by", "comparator"},
                        {"detection_cause", "disagreement"}};
    EXPECT_NE(std::find(document["runs"].begin(), document["runs"].end(), expected), document["runs"].end())
        << document["runs"];
}

TEST_F(JsonAnswer, EachLineOfNodeAndManagerHasItsFormat)
{
    Verifies(req::SRS_EASE_005);
    const std::string script =
        File("script.yaml", "steps:\n  - {at: 50 ms, do: nmt start}\n  - {at: 200 ms, do: state}\n"
                            "  - {at: 210 ms, do: get 0x1018:01}\n  - {at: 220 ms, do: get 0x7777:01}\n"
                            "  - {at: 300 ms, do: quit}\n");
    const std::string node = ProgramOutput("node --can udp:239.74.163.61:43161 --dcf " + device_ + " --script " +
                                           script + " --json --no-input --no-self-tests");
    EXPECT_EQ(UntoldIn(node, "counterpoint-node-1", true), "") << node;
    EXPECT_NE(node.find("\"event\":\"stopped\""), std::string::npos);
    const std::string manager =
        ProgramOutput("manager --can udp:239.74.163.61:43162 --network " + kSource +
                      "/examples/networks/chain.yaml --for 1 --json --no-input --log " + Path("log"));
    EXPECT_EQ(UntoldIn(manager, "counterpoint-manager-1", true), "") << manager;
    EXPECT_NE(manager.find("\"event\":\"table\""), std::string::npos);
    EXPECT_NE(manager.find("\"heartbeat_age_ms\":null,\"emergency_code\":0,\"emergency_count\":0,"), std::string::npos);
    EXPECT_EQ(UntoldIn(cia306::ReadTextFile(Path("log")), "counterpoint-manager-1", true), "");
}

TEST_F(JsonAnswer, ManagersOfASimulationTellAsInTheirLog)
{
    Verifies(req::SRS_EASE_005);
    const std::string scenario = kSource + "/examples/networks/boot.yaml";
    ASSERT_NE(RunCommand({"simulate", scenario, "--quiet", "--json", Path("run.json")}).status, 2);
    const std::string run = cia306::ReadTextFile(Path("run.json"));
    EXPECT_EQ(UntoldIn(run, "counterpoint-simulation-1", false), "");
    EXPECT_NE(run.find("counterpoint-manager-1"), std::string::npos);
}

TEST_F(JsonAnswer, SweepHasItsFormat)
{
    Verifies(req::SRS_EASE_005);
    const std::string scenario = kSource + "/examples/emergency_stop/00_no_fault.yaml";
    ASSERT_NE(
        RunCommand({"simulate", scenario, "--quiet", "--sweep", "seed=1:2:1", "--json", Path("sweep.json")}).status, 2);
    EXPECT_EQ(UntoldIn(cia306::ReadTextFile(Path("sweep.json")), "counterpoint-sweep-1", false), "");
}
} // namespace
} // namespace counterpoint::tools
