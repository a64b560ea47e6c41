// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/sweep.hpp"
#include "tests/integration/scenario_run.hpp"
#include "tests/tools/command_run.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::tools
{
namespace
{

using test::Answer;
using test::RunCommand;

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
    const Answer good = RunCommand({"simulate", simulator::Examples() + "00_no_fault.yaml"});
    EXPECT_EQ(good.status, 0) << good.out;
    EXPECT_NE(good.out.find("7 of 7 expectations hold"), std::string::npos);
    // One does not
    const std::string failing =
        simulator::TextFile("extends: " + simulator::Examples() +
                            "chain.yaml\nexpect:\n  - {that: safe, node: actuator, srdo: 1, at: 900 ms}\n");
    const Answer bad = RunCommand({"simulate", failing, "--quiet"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.out,
              "  FAILED  actuator SRDO 1 safe at 900 ms: released  (" + failing + ":3:5)\n0 of 1 expectations hold\n");
    // Bad input: one line
    const Answer lost = RunCommand({"simulate", "/nonexistent.yaml"});
    EXPECT_EQ(lost.status, 2);
    EXPECT_EQ(lost.err, "/nonexistent.yaml: error: no such file, expected a YAML file\n");
    EXPECT_EQ(lost.out, "");
    EXPECT_EQ(RunCommand({"simulate"}).status, 2);
    EXPECT_EQ(RunCommand({"simulate", failing, "--seed", "x"}).status, 2);
    const Answer until = RunCommand({"simulate", failing, "--until", "20"});
    EXPECT_EQ(until.status, 2);
    EXPECT_EQ(until.err.substr(0U, 32U), "--until: error: '20', expected a");
}

TEST(SimulateCommand, TellsOfDroppedCopiesOnStandardError)
{
    Verifies(req::SRS_SIM_017);
    const std::string frames = ", frames: {identifier: 0x103, receiver: actuator, from: 500 ms}}\n";
    const std::string file = simulator::TextFile(
        "extends: " + simulator::Examples() + "chain.yaml\nfaults:\n" + "  - {fault: repetition, name: one, times: 15" +
        frames + "  - {fault: repetition, name: two, times: 4, optional: true" + frames);
    const Answer answer = RunCommand({"simulate", "--quiet", file});
    EXPECT_EQ(answer.err.rfind(file + ":4:5: warning: 4 copies of 'two' dropped, expected at most 16 receptions of one "
                                      "frame\n",
                               0U),
              0U)
        << answer.err;
    EXPECT_EQ(answer.out.find("dropped"), std::string::npos) << answer.out;
}

TEST(SimulateCommand, WritesAllReportsAndSaysWhereItCannot)
{
    Verifies(req::SRS_SIM_041);
    Verifies(req::SRS_SIM_042);
    Verifies(req::SRS_SIM_043);
    Verifies(req::SRS_SIM_045);
    const std::string base = ::testing::TempDir() + "counterpoint_reports";
    const Answer answer = RunCommand({"simulate", simulator::Examples() + "02_loss_of_inverse_frame.yaml", "--quiet",
                                      "--html", base + ".html", "--json", base + ".json", "--candump", base + ".log"});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_EQ(Content(base + ".html").substr(0U, 15U), "<!DOCTYPE html>");
    EXPECT_EQ(Content(base + ".json").substr(0U, 1U), "{");
    EXPECT_EQ(Content(base + ".log").substr(0U, 1U), "(");
    const Answer lost = RunCommand({"simulate", simulator::Examples() + "02_loss_of_inverse_frame.yaml", "--quiet",
                                    "--json", "/nonexistent/x.json"});
    EXPECT_EQ(lost.status, 2);
    EXPECT_NE(lost.err.find("/nonexistent/x.json"), std::string::npos);
}

TEST(SimulateCommand, AnOutputThatCannotBeWrittenIsToldBeforeAnythingElse)
{
    Verifies(req::SRS_SIM_045);
    // Given one output that can be written and one that cannot
    const std::string page = ::testing::TempDir() + "counterpoint_alone.html";
    const Answer answer = RunCommand({"simulate", simulator::Examples() + "02_loss_of_inverse_frame.yaml", "--html",
                                      page, "--json", "/nonexistent/x.json"});
    // Then there is one line, and neither a time line nor the other output
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err, "/nonexistent/x.json: error: it cannot be created (No such file or directory), expected a "
                          "path in a writable folder\n");
    EXPECT_FALSE(std::filesystem::exists(page));
    // Then the same of demo
    const Answer demo = RunCommand({"demo", "--scenarios", simulator::Examples(), "--html", "/dev/null"});
    EXPECT_EQ(demo.status, 2);
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
            const Answer answer = RunCommand(arguments);
            EXPECT_EQ(answer.status, 2) << name;
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
             {"simulate", file, "--sweep", "duration=1s:2s:1s", "--until", "1 s"},
             {"simulate", file, "--sweep", "seed=1:6:1", "--seed", "3"},
             {"simulate", file, "--sweep", "seed=1:2:1", "--sweep", "seed=3:4:1"},
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
        const Answer answer = RunCommand(arguments);
        EXPECT_EQ(answer.status, 2) << arguments.back();
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        EXPECT_NE(answer.err.find("expected"), std::string::npos) << answer.err;
    }
    EXPECT_EQ(RunCommand({"simulate", file, "--quiet", "--seed", "18446744073709551615"}).status, 0);
}

TEST(SimulateCommand, TellsOnStandardErrorWhatAShorterRunLeavesOut)
{
    Verifies(req::SRS_SIM_016);
    // Given one of each just before, or at, 500 ms
    const std::string file = simulator::TextFile("duration: 1 s\nnodes:\n  sensor: {dcf: " + simulator::Examples() +
                                                 "sensor.dcf}\n  actuator: {dcf: " + simulator::Examples() +
                                                 R"(actuator.dcf}
inputs: [{at: 500 ms, node: sensor, object: 0x2000:01, value: 1}]
acknowledge: [{at: 500 ms, node: actuator, srdo: 1}]
nmt: [{at: 500 ms, node: actuator, command: stop}]
power: [{at: 500 ms, node: actuator, off: 10 ms}]
gfc: [{at: 500 ms, node: sensor}, {at: 499 ms, node: sensor}]
faults: [{fault: unplugged, name: gone, node: sensor, at: 500 ms}]
)");
    const auto told = [&file](const std::string& what)
    { return file + ":" + what + " at 500 ms does not happen, expected a time before the end of the run at 500 ms\n"; };
    // When --until ends the run there, then each that begins there is told, and what is earlier is not
    const Answer answer = RunCommand({"simulate", file, "--quiet", "--until", "500 ms"});
    for (const char* const what :
         {"5:10: warning: input", "6:15: warning: acknowledge", "7:7: warning: NMT event", "8:9: warning: power cycle",
          "9:7: warning: GFC event", "10:10: warning: fault 'gone'"})
    {
        EXPECT_NE(answer.err.find(told(what)), std::string::npos) << what << "\n" << answer.err;
    }
    EXPECT_EQ(answer.err.find("499 ms"), std::string::npos) << answer.err;
    EXPECT_EQ(RunCommand({"simulate", file, "--quiet", "--until", "501 ms"}).err.find("does not happen"),
              std::string::npos);
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
    const Answer answer = RunCommand({"simulate", file, "--quiet"});
    // Then nothing that is expected of it holds, and its place is told
    EXPECT_EQ(answer.status, 1);
    EXPECT_EQ(answer.err,
              file + ":3:5: warning: fault 'loss' never happened, expected it within the run, or 'optional: true'\n");
    EXPECT_NE(answer.out.find("0 of 3 expectations hold"), std::string::npos) << answer.out;
}

TEST(SimulateCommand, EndsARecordingThatGrowsTooLarge)
{
    Verifies(req::SRS_SIM_048);
    const std::string file =
        simulator::TextFile("extends: " + simulator::Examples() + "chain.yaml\nduration: 2000 s\n");
    const Answer answer = RunCommand({"simulate", file});
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err,
              file + ": error: more than 500000 frames and events to record, expected a shorter run, or --quiet "
                     "without output files\n");
    EXPECT_EQ(answer.out, "");
}

TEST(SimulateCommand, SeedAndUntilReplaceThoseOfTheScenario)
{
    Verifies(req::SRS_SIM_003);
    const std::string file = simulator::TextFile(
        "extends: " + simulator::Examples() +
        "chain.yaml\nfaults:\n  - {fault: loss, frames: {receiver: actuator, count: 1000, probability_ppm: 300000}}\n");
    const Answer one = RunCommand({"simulate", file, "--seed", "5", "--until", "300ms"});
    const Answer again = RunCommand({"simulate", file, "--seed", "5", "--until", "300ms"});
    const Answer other = RunCommand({"simulate", file, "--seed", "6", "--until", "300ms"});
    EXPECT_EQ(one.out, again.out);
    EXPECT_NE(one.out, other.out);
    EXPECT_EQ(one.out.find(" 301."), std::string::npos);
}

TEST(SimulateCommand, ExplainsTheFormat)
{
    Verifies(req::SRS_SIM_047);
    Verifies(req::SRS_MGR_155);
    // Given everything, a key, a fault kind, and a name that is none
    const Answer all = RunCommand({"simulate", "--explain"});
    EXPECT_EQ(all.status, 0);
    for (const char* const word : {"pull", "insert", "reset", "replace", "storm", "duplicate", "babble", "send",
                                   "bus_off", "no_controller", "kill"})
    {
        EXPECT_NE(all.out.find(word), std::string::npos) << word;
    }
    EXPECT_NE(all.out.find("\n  probability_ppm: number from 1 to 1000000; default 1000000\n"), std::string::npos);
    const Answer key = RunCommand({"simulate", "--explain", "jump"});
    EXPECT_EQ(
        key.out,
        "in clock:\n  jump: time other than 0, negative: back, at most 1000 s\n      jumps forward, or back, once\n"
        "      e.g. jump: -3 ms\n\n");
    const Answer kind = RunCommand({"simulate", "--explain", "loss"});
    EXPECT_EQ(kind.out.substr(0U, 56U), "loss\n  The frame does not arrive.\n  fault: one of corrup");
    const Answer empty = RunCommand({"simulate", "--explain", ""});
    EXPECT_EQ(empty.status, 2);
    EXPECT_EQ(empty.out, "");
    EXPECT_EQ(empty.err, "counterpoint simulate: --explain '', expected a key or section of the format; without a name "
                         "all of them are told\n");
    const Answer none = RunCommand({"simulate", "--explain", "losses"});
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err,
              "counterpoint simulate: --explain 'losses' (did you mean 'loss'?), expected a key or section of "
              "the format; without a name all of them are told\n");
    // Of a key and of an event as well, and of nothing near none
    const auto told = [](const std::string& name) { return RunCommand({"simulate", "--explain", name}).err; };
    EXPECT_NE(told("probabilty_ppm").find("'probabilty_ppm' (did you mean 'probability_ppm'?), "), std::string::npos);
    EXPECT_NE(told("replacee").find("'replacee' (did you mean 'replace'?), "), std::string::npos) << told("replacee");
    EXPECT_NE(told("something else").find("'something else', expected "), std::string::npos);
    // And the document has the same reference
    const Answer reference = RunCommand({"simulate", "--explain", "--markdown"});
    EXPECT_EQ(reference.status, 0);
    const std::string document = Content(std::string(COUNTERPOINT_SOURCE_FOLDER) + "/docs/scenario.md");
    const std::string begin = "<!-- counterpoint simulate --explain --markdown -->\n";
    const std::size_t place = document.find(begin);
    ASSERT_NE(place, std::string::npos);
    EXPECT_EQ(document.substr(place + begin.size()), reference.out);
}

TEST(SimulateCommand, ExplainsEachEventAndEachExpectationOfNetworks)
{
    Verifies(req::SRS_MGR_155);
    const std::vector<std::pair<std::string, std::string>> all{
        {"events.pull", "The device disappears."},
        {"events.insert", "A device that was pulled comes back."},
        {"events.reset", "Its supply blinks; nobody commanded it."},
        {"events.replace", "Another device of its kind takes its place, also that of a pulled one."},
        {"events.duplicate", "A second device with its node-ID comes."},
        {"events.emcy_storm", "Emergency messages, one after the other."},
        {"events.babble", "A defective device sends frames of eight zeros."},
        {"events.send", "A frame of somebody else."},
        {"events.bus_off", "The controller of a manager is bus-off."},
        {"events.no_controller", "The controller of a manager does not start."},
        {"events.kill_manager", "It loses its supply for good."},
        {"state", "The state of a node as the manager knows it."},
        {"device", "The state of a device as it is."},
        {"letter", "How the start-up of a slave ended; profile cia302."},
        {"code", "The code of a slave; profiles el6751 and plc_designer."},
        {"gate", "The verification of a safety slave."},
        {"output", "The output of an SRDO that the device consumes."}};
    for (const auto& [name, meaning] : all)
    {
        const Answer answer = RunCommand({"simulate", "--explain", name.substr(name.find('.') + 1U)});
        EXPECT_NE(("\n" + answer.out).find("\n" + name + "\n  " + meaning + "\n"), std::string::npos) << answer.out;
    }
}

TEST(SimulateCommand, AWireErrorBehindTheEndOfTheFrameIsRefused)
{
    Verifies(req::SRS_SIM_074);
    const auto run = [](const std::string& bit)
    {
        const std::string file = simulator::TextFile("extends: " + simulator::Examples() +
                                                     "chain.yaml\nfaults:\n  - {fault: wire_error, bit: " + bit +
                                                     ", frames: {identifier: 0x103, from: 500 ms, count: 1}}\n");
        Answer answer = RunCommand({"simulate", file, "--quiet"});
        const bool is_of_file = answer.err.rfind(file, 0U) == 0U;
        answer.err = is_of_file ? answer.err.substr(file.size()) : answer.err;
        return answer;
    };
    EXPECT_EQ(run("64").status, 0) << run("64").err;
    const Answer refused = run("65");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err,
              ":3:5: error: bit 65 of a frame of 65 bits on the wire, identifier 0x103, expected a bit from "
              "0 to 64, or other 'frames'\n");
}

TEST(DemoCommand, ShowsEveryRunWithItsLimitAndWritesThePage)
{
    Verifies(req::SRS_DEMO_001);
    Verifies(req::SRS_DEMO_002);
    Verifies(req::SRS_DEMO_003);
    const std::string folder = ::testing::TempDir() + "counterpoint_demo";
    std::filesystem::remove_all(folder);
    // When the demonstration runs on the shipped scenarios
    const Answer answer = RunCommand({"demo", "--html", folder});
    // Then every row is in time, and the page is there and is named
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_NE(answer.out.find("30 of 30 runs as expected"), std::string::npos) << answer.out;
    // Who found it, the cause, limit and time, of the frames on the bus, of a channel and of one that ends itself
    for (const char* const row :
         {"Run                                      Limit        Time  Detected by      Cause               Verdict\n",
          "Loss of three pairs                      53 ms   51.192 ms  channels         sct                 in time\n",
          "Channel A frozen                          8 ms        1 ms  comparator       disagreement        in time\n",
          "Channel B hangs                           8 ms      1.5 ms  watchdog         wrong or no answer  in time\n"})
    {
        EXPECT_NE(answer.out.find(std::string("\n") + row), std::string::npos) << row << answer.out;
    }
    EXPECT_NE(answer.out.find("Timing diagrams: " + folder + "/index.html"), std::string::npos) << answer.out;
    const std::string page = Content(folder + "/index.html");
    const std::string data = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(data) + data.size();
    const auto runs = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin)).at("runs");
    EXPECT_EQ(runs.size(), 30U);
    for (const auto& run : runs)
    {
        EXPECT_FALSE(run.at("frames").empty()) << run.at("title");
    }
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
    const Answer answer = RunCommand({"demo", "--scenarios", folder, "--html", folder + "/page.html"});
    EXPECT_EQ(answer.status, 1);
    EXPECT_NE(answer.out.find("the fault never happened"), std::string::npos) << answer.out;
    // and one without scenarios
    const Answer none = RunCommand({"demo", "--scenarios", "/nonexistent"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("no scenarios"), std::string::npos);
}

TEST(DemoCommand, ListsItsScenarios)
{
    Verifies(req::SRS_DEMO_001);
    const Answer answer = RunCommand({"demo", "--list"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.out.find("Corruption of one bit"), std::string::npos);
    EXPECT_EQ(answer.out.find("Long run"), std::string::npos);
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
        RunCommand({"simulate", LostPairs(), "--sweep", "faults.three pairs lost.frames.from=500ms:510ms:5ms"});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    // Then each has a row, and the last line names the worst
    EXPECT_NE(answer.out.find("\n500 ms  "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("\n505 ms  "), std::string::npos);
    EXPECT_NE(answer.out.find("\n510 ms  "), std::string::npos);
    EXPECT_NE(answer.out.find("channels     sct    25.191 ms  51.192 ms   53 ms  holds\n"), std::string::npos);
    EXPECT_NE(answer.out.find("3 of 3 runs hold; nearest to its limit: 51.192 ms of 53 ms at 500 ms\n"),
              std::string::npos);
    // And the same bytes again
    EXPECT_EQ(
        RunCommand({"simulate", LostPairs(), "--sweep", "faults.three pairs lost.frames.from=500ms:510ms:5ms"}).out,
        answer.out);
}

TEST(Sweep, TakesHexadecimalNumbersAsTheScenarioDoes)
{
    Verifies(req::SRS_SIM_050);
    const Answer answer =
        RunCommand({"simulate", LostPairs(), "--quiet", "--sweep", "faults.0.frames.identifier=0x103:0X104:0x1"});
    EXPECT_EQ(answer.err, "");
    EXPECT_NE(answer.out.find("\n0x103  "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("\n0x104  "), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("of 2 runs hold"), std::string::npos) << answer.out;
    // A number without digits is none, nor is one of 64 bits
    for (const char* const wrong : {"seed=0x:0x2:1", "seed=1:0xFFFFFFFFFFFFFFFF:1", "seed=0x1:0x1G:1"})
    {
        EXPECT_EQ(RunCommand({"simulate", LostPairs(), "--sweep", wrong}).status, 2) << wrong;
    }
}

TEST(Sweep, EndsWithOneWhenARunFails)
{
    Verifies(req::SRS_SIM_050);
    // When one frame alone is lost, the output stays open
    const Answer answer = RunCommand({"simulate", LostPairs(), "--sweep", "faults.0.frames.count=1:6:5", "--quiet"});
    EXPECT_EQ(answer.status, 1);
    EXPECT_NE(answer.out.find("1 of 2 runs hold"), std::string::npos) << answer.out;
}

TEST(Sweep, TakesEveryCombinationAndAddsKeys)
{
    Verifies(req::SRS_SIM_050);
    Verifies(req::SRS_SIM_051);
    const std::string base = ::testing::TempDir() + "counterpoint_sweep";
    // Given drifts of counter B and two beginnings; `optional` texts and nodes of the extended file are reached as well
    const Answer answer =
        RunCommand({"simulate", LostPairs(), "--quiet", "--sweep", "nodes.actuator.counter_b.ppm=-100:100:100",
                    "--sweep", "faults.0.frames.from=500ms:500.5ms:250us", "--sweep", "seed=3:3:1", "--json",
                    base + ".json", "--html", base + ".html"});
    EXPECT_EQ(answer.status, 0) << answer.out << answer.err;
    EXPECT_EQ(answer.out, "");
    const nlohmann::json json = nlohmann::json::parse(Content(base + ".json"));
    EXPECT_EQ(json["format"], "counterpoint-sweep-1");
    ASSERT_EQ(json["runs"].size(), 9U);
    EXPECT_EQ(json["runs"][0]["values"]["nodes.actuator.counter_b.ppm"], -100);
    EXPECT_EQ(json["runs"][8]["values"]["faults.0.frames.from"], 500.5); // In the unit of its axis.
    EXPECT_EQ(json["runs"][4]["limit_ns"], 53000000);
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

TEST(Sweep, RefusesAKeyThatIsSetTwice)
{
    Verifies(req::SRS_SIM_050);
    const auto refusal_of = [](const std::vector<std::string>& more)
    {
        std::vector<std::string> arguments{"simulate", LostPairs(), "--sweep"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Answer answer = RunCommand(arguments);
        EXPECT_EQ(answer.status, 2) << answer.err;
        EXPECT_EQ(answer.out, "");
        return answer.err;
    };
    const std::string seed =
        "--sweep: error: seed twice, by '--sweep', '--seed' or '--until', expected each key once\n";
    EXPECT_EQ(refusal_of({"seed=1:2:1", "--sweep", "seed=3:4:1"}), seed);
    EXPECT_EQ(refusal_of({"seed=1:2:1", "--seed", "3"}), seed);
    EXPECT_EQ(refusal_of({"duration=1s:2s:1s", "--until", "1 s"}),
              "--sweep: error: duration twice, by '--sweep', '--seed' or '--until', expected each key once\n");
    // The near miss: another key than that of the option
    EXPECT_EQ(RunCommand({"simulate", LostPairs(), "--quiet", "--sweep", "seed=1:1:1", "--until", "1 s"}).status, 0);
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
             {"duration", "--sweep: error: 'duration', expected NAME=FROM:TO:STEP"},
             {"duration=1s:2s", "--sweep: error: 'duration=1s:2s', expected NAME=FROM:TO:STEP"},
             {"duration=2s:1s:1s", "--sweep: error: 'duration=2s:1s:1s', expected FROM not above TO, a STEP above 0"},
             {"duration=1s:2s:0s", "--sweep: error: 'duration=1s:2s:0s', expected FROM not above TO, a STEP above 0"},
             {"seed=1:2:9223372036854775807",
              "--sweep: error: 'seed=1:2:9223372036854775807', expected FROM not above TO, a "
              "STEP above 0, and nothing beyond"},
             {"extends=1:2:1", "--sweep: error: path 'extends', which is read before the sweep, expected the path of a "
                               "value of the scenario"},
             {"duration=1s:2:1s",
              "--sweep: error: 'duration=1s:2:1s', expected three times with units, or three whole numbers"},
             {"duration=1s:x:1s", "--sweep: error: 'x', expected a time with its unit"},
             {"duration=1s:100000s:1us",
              "--sweep: error: 'duration=1s:100000s:1us' with more than 20000 runs, expected a larger STEP"},
             {"faults.7.at=1:2:1", "--sweep: error: path 'faults.7.at', expected keys, names or numbers from 0"},
             {"faults.none.at=1:2:1", "--sweep: error: path 'faults.none.at', expected keys, names or numbers from 0"},
             {"faults.0.frames=1:2:1",
              "--sweep: error: path 'faults.0.frames', which is no single value, expected the path of a single"}})
    {
        const Answer answer = RunCommand({"simulate", LostPairs(), "--sweep", refusal.sweep});
        EXPECT_EQ(answer.status, 2) << refusal.sweep;
        EXPECT_EQ(answer.err.substr(0U, std::string(refusal.message).size()), refusal.message);
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    }
    // A key that does not exist is refused as in the file
    const Answer unknown = RunCommand({"simulate", LostPairs(), "--sweep", "faults.0.by=1ms:2ms:1ms"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.err.find("unknown key 'by' in a fault"), std::string::npos) << unknown.err;
    // Too many combinations
    const Answer many =
        RunCommand({"simulate", LostPairs(), "--sweep", "seed=1:200:1", "--sweep", "duration=1s:1200s:1s"});
    EXPECT_EQ(many.err, "--sweep: error: more than 20000 runs, expected larger steps\n");
}
} // namespace
} // namespace counterpoint::tools
