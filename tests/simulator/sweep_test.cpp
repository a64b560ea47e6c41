// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/sweep.hpp"
#include "tests/integration/scenario_run.hpp"
#include "tools/command_line/run.hpp"
#include "tools/command_table.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
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

std::string LostPairs()
{
    return simulator::Scenarios() + "emergency_stop/01_loss_of_pairs.yaml";
}

TEST(Sweep, RunsEveryValueAndPrintsATable)
{
    Verifies(req::SRS_SIM_050);
    // Given the loss of three pairs, begun at 500, 505 and 510 ms
    const Answer answer =
        Tool({"simulate", LostPairs(), "--sweep", "faults.three pairs lost.frames.from=500ms:510ms:5ms"});
    EXPECT_EQ(answer.status, ExitStatus::kHolds) << answer.out << answer.err;
    // Then each has a row, and the last line names the worst
    EXPECT_NE(answer.out.find("\n500 ms  "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("\n505 ms  "), std::string::npos);
    EXPECT_NE(answer.out.find("\n510 ms  "), std::string::npos);
    EXPECT_NE(answer.out.find("channels     sct    25.191 ms  51.192 ms   52 ms  holds\n"), std::string::npos);
    EXPECT_NE(answer.out.find("3 of 3 runs hold; nearest to its limit: 51.192 ms of 52 ms at 500 ms\n"),
              std::string::npos);
    // And the same bytes again
    EXPECT_EQ(Tool({"simulate", LostPairs(), "--sweep", "faults.three pairs lost.frames.from=500ms:510ms:5ms"}).out,
              answer.out);
}

TEST(Sweep, EndsWithOneWhenARunFails)
{
    Verifies(req::SRS_SIM_050);
    // When one frame alone is lost, the output stays open
    const Answer answer = Tool({"simulate", LostPairs(), "--sweep", "faults.0.frames.count=1:6:5", "--quiet"});
    EXPECT_EQ(answer.status, ExitStatus::kDoesNotHold);
    EXPECT_NE(answer.out.find("1 of 2 runs hold"), std::string::npos) << answer.out;
}

TEST(Sweep, TakesEveryCombinationAndAddsKeys)
{
    Verifies(req::SRS_SIM_050);
    Verifies(req::SRS_SIM_051);
    const std::string base = ::testing::TempDir() + "counterpoint_sweep";
    // Given drifts of counter B and two beginnings; `optional` texts and nodes of the extended file are reached as well
    const Answer answer =
        Tool({"simulate", LostPairs(), "--quiet", "--sweep", "nodes.actuator.counter_b.ppm=-100:100:100", "--sweep",
              "faults.0.frames.from=500ms:500.5ms:250us", "--sweep", "seed=3:3:1", "--json", base + ".json", "--html",
              base + ".html"});
    EXPECT_EQ(answer.status, ExitStatus::kHolds) << answer.out << answer.err;
    EXPECT_EQ(answer.out, "");
    const nlohmann::json json = nlohmann::json::parse(Content(base + ".json"));
    EXPECT_EQ(json["format"], "counterpoint-sweep-1");
    ASSERT_EQ(json["runs"].size(), 9U);
    EXPECT_EQ(json["runs"][0]["values"]["nodes.actuator.counter_b.ppm"], -100);
    EXPECT_EQ(json["runs"][8]["values"]["faults.0.frames.from"], "500.5 ms");
    EXPECT_EQ(json["runs"][4]["limit_ns"], 52000000);
    EXPECT_EQ(json["runs"][4]["detected_by"], "channels");
    // And the page has a point for each, the limit, and no address to load from
    const std::string page = Content(base + ".html");
    std::size_t points = 0U;
    for (std::size_t place = page.find("<circle"); place != std::string::npos; place = page.find("<circle", place + 1U))
    {
        ++points;
    }
    EXPECT_EQ(points, 9U);
    EXPECT_NE(page.find("stroke=\"var(--faulted)\""), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos);
}

TEST(Sweep, RefusesWhatCannotBeSwept)
{
    Verifies(req::SRS_SIM_050);
    struct Refusal
    {
        const char* sweep;
        const char* message;
    };
    for (const Refusal& refusal : std::vector<Refusal>{
             {"duration", "--sweep: 'duration', expected NAME=FROM:TO:STEP"},
             {"duration=1s:2s", "--sweep: 'duration=1s:2s', expected NAME=FROM:TO:STEP"},
             {"duration=2s:1s:1s", "--sweep: 'duration=2s:1s:1s', expected FROM not above TO, a STEP above 0"},
             {"duration=1s:2s:0s", "--sweep: 'duration=1s:2s:0s', expected FROM not above TO, a STEP above 0"},
             {"seed=1:2:9223372036854775807", "--sweep: 'seed=1:2:9223372036854775807', expected FROM not above TO, a "
                                              "STEP above 0, and nothing beyond"},
             {"extends=1:2:1",
              "--sweep: path 'extends', which is read before the sweep, expected the path of a value of the scenario"},
             {"duration=1s:2:1s",
              "--sweep: 'duration=1s:2:1s', expected three times with units, or three whole numbers"},
             {"duration=1s:x:1s", "--sweep: 'x', expected a time with its unit"},
             {"duration=1s:100000s:1us",
              "--sweep: 'duration=1s:100000s:1us' with more than 20000 runs, expected a larger STEP"},
             {"faults.7.at=1:2:1", "--sweep: path 'faults.7.at', expected keys, names or numbers from 0"},
             {"faults.none.at=1:2:1", "--sweep: path 'faults.none.at', expected keys, names or numbers from 0"},
             {"faults.0.frames=1:2:1",
              "--sweep: path 'faults.0.frames', which is no single value, expected the path of a single"}})
    {
        const Answer answer = Tool({"simulate", LostPairs(), "--sweep", refusal.sweep});
        EXPECT_EQ(answer.status, ExitStatus::kBadInput) << refusal.sweep;
        EXPECT_EQ(answer.err.substr(0U, std::string(refusal.message).size()), refusal.message);
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    }
    // A key that does not exist is refused as in the file
    const Answer unknown = Tool({"simulate", LostPairs(), "--sweep", "faults.0.by=1ms:2ms:1ms"});
    EXPECT_EQ(unknown.status, ExitStatus::kBadInput);
    EXPECT_NE(unknown.err.find("unknown key 'by' in a fault"), std::string::npos) << unknown.err;
    // Too many combinations
    const Answer many = Tool({"simulate", LostPairs(), "--sweep", "seed=1:200:1", "--sweep", "duration=1s:1200s:1s"});
    EXPECT_EQ(many.err, "--sweep: more than 20000 runs, expected larger steps\n");
}
} // namespace
} // namespace counterpoint::tools
