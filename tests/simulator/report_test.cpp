// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/time_text.hpp"
#include "runtime/yaml/document.hpp"
#include "simulator/report/reports.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
constexpr const char* kLoss = R"(
title: a <b> & "c"
faults:
  - {fault: loss, name: "</script>", frames: {identifier: 0x104, receiver: actuator, from: 500 ms}}
  - {fault: bit_flip, name: chance, node: controller, part: channel_b, at: 700 ms}
expect:
  - {that: safe_within, fault: "</script>", node: actuator, srdo: 1}
  - {that: released, node: actuator, srdo: 1, at: 990 ms}
)";

std::string TimeLineOf(const simulator::Run& run)
{
    std::ostringstream out;
    WriteTimeLine(run, FrameLines::kAll, out);
    WriteVerdicts(run, out);
    return out.str();
}

TEST(Reports, AreTheSameBytesForTheSameScenarioAndSeed)
{
    Verifies(req::SRS_SIM_003);
    const auto first = RunChain(kLoss, true);
    const auto second = RunChain(kLoss, true);
    EXPECT_EQ(TimeLineOf(*first), TimeLineOf(*second));
    EXPECT_EQ(JsonReport(*first), JsonReport(*second));
    EXPECT_EQ(CandumpReport(*first), CandumpReport(*second));
    EXPECT_EQ(HtmlReport("x", {first.get()}), HtmlReport("x", {second.get()}));
}

TEST(Reports, TimeLineShowsWhoSawWhat)
{
    Verifies(req::SRS_SIM_040);
    const auto run = RunChain(kLoss, true);
    const std::string text = TimeLineOf(*run);
    for (const char* const line :
         {"frame 0x103 [2] 01 01  from controller", "FAULT: </script>", "SRDO 1 channel A: faulted",
          "SRDO 1 channel B: faulted", "SRDO 1 channel A reports srvt", "comparator: agreed SRDO none",
          "three permits for SRDO none", "SRDO 1 OUTPUT SAFE", "application told: srvt", "SRDO 1 0x2200:01 = 0",
          "acknowledge 1", "NMT operational", "input 0x2000:01 = 1",
          "  holds   actuator SRDO 1 safe within 73 ms after '</script>' (limit: bus_next_normal): ",
          "  FAILED  actuator SRDO 1 released at 990 ms: safe", "1 of 2 expectations hold"})
    {
        EXPECT_NE(text.find(line), std::string::npos) << line;
    }
}

/// What the lines of this place tell behind `about`, in their order.
std::vector<std::string> ToldOf(const std::string& text, const std::string& place, const std::string& about)
{
    std::vector<std::string> told;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t at = line.find(about);
        if (line.find(" ms  " + place + " ") != std::string::npos && at != std::string::npos)
        {
            told.push_back(line.substr(at + about.size()));
        }
    }
    return told;
}

TEST(Reports, TimeLineIsInOrderOfTimeAndShowsEachChange)
{
    Verifies(req::SRS_SIM_040);
    using Told = std::vector<std::string>;
    // Given a frame that the actuator loses, and later a channel of the sensor that stands still
    const auto run = RunChain(R"(
faults:
  - {fault: loss, name: lost, frames: {identifier: 0x104, receiver: actuator, from: 500 ms, count: 1}}
  - {fault: frozen, name: frozen, node: sensor, part: channel_a, at: 700 ms}
)",
                              true);
    const std::string text = TimeLineOf(*run);
    // Then no line is of an earlier time than the one before it, frames of the bus among them
    std::istringstream lines(text);
    double last_ms = 0.0;
    std::size_t count = 0U;
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t unit = line.find(" ms  ");
        const double at_ms = (unit == 12U) ? std::stod(line.substr(0U, unit)) : last_ms;
        EXPECT_GE(at_ms, last_ms) << line;
        last_ms = at_ms;
        count += (unit == 12U) ? 1U : 0U;
    }
    EXPECT_GT(count, 150U);
    // And each change is there: views of both channels, verdicts, permits, outputs, faults, causes, device faults
    EXPECT_EQ(ToldOf(text, "actuator", "channel A: "), (Told{"off", "waiting", "released", "faulted"}));
    EXPECT_EQ(ToldOf(text, "actuator", "channel B: "), (Told{"off", "waiting", "released", "faulted"}));
    EXPECT_EQ(ToldOf(text, "actuator", "comparator: agreed "),
              (Told{"SRDO none, matched 1", "SRDO 1, matched 1", "SRDO none, matched 1"}));
    EXPECT_EQ(ToldOf(text, "actuator", "three permits for SRDO "), (Told{"1", "none"}));
    EXPECT_EQ(ToldOf(text, "actuator", "OUTPUT "), (Told{"RELEASED", "SAFE"}));
    EXPECT_EQ(ToldOf(text, "actuator", "FAULT: "), Told{"lost"});
    EXPECT_EQ(ToldOf(text, "sensor", "FAULT: "), Told{"frozen"});
    EXPECT_EQ(ToldOf(text, "actuator", "channel A reports "), Told{"srvt"});
    EXPECT_EQ(ToldOf(text, "actuator", "channel B reports "), Told{"srvt"});
    EXPECT_EQ(ToldOf(text, "sensor", "DEVICE SAFE STATE: "), Told{"disagreement"});
    EXPECT_EQ(ToldOf(text, "actuator", "DEVICE SAFE STATE: "), Told{});
}

TEST(Reports, VerdictTellsEachCauseThatWasSeen)
{
    Verifies(req::SRS_SIM_030);
    // Given an actuator that waits for its first pair past SCT, and later loses its producer
    const auto run = RunChain(R"(
faults:
  - {fault: loss, name: late, frames: {identifier: [0x103, 0x104], receiver: actuator, until: 120 ms, count: 100}}
  - {fault: unplugged, node: controller, at: 500 ms}
expect:
  - {that: cause, node: actuator, srdo: 1, is: sct}
)",
                              true);
    // Then the second cause is told beside the first one, whose name ends like it
    EXPECT_NE(TimeLineOf(*run).find("  holds   actuator SRDO 1 cause sct: waiting_past_sct, sct\n"), std::string::npos)
        << TimeLineOf(*run);
}

TEST(Reports, AcknowledgeThatSeveralPressEndsWithTheLastOne)
{
    Verifies(req::SRS_SIM_170);
    // Given an input that is pressed from 150 to 200 ms, and by somebody else from 180 to 680 ms
    const auto run = RunChain(R"(
acknowledge:
  - {at: 180 ms, node: actuator, srdo: 1, pulse: 500 ms}
  - {at: 600 ms, node: actuator, srdo: 1, pulse: 50 ms}
  - {at: 800 ms, node: actuator, srdo: 1, pulse: 50 ms}
faults:
  - {fault: loss, frames: {identifier: 0x104, receiver: actuator, from: 400 ms}}
expect:
  - {that: safe, node: actuator, srdo: 1, at: 790 ms}
  - {that: released, node: actuator, srdo: 1, at: 900 ms}
)",
                              true);
    // Then it is 1 until the last one lets go; a press within that is no edge, and releases nothing
    const std::string text = TimeLineOf(*run);
    EXPECT_TRUE(run->Holds()) << text;
    std::string levels;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t place = line.find("  actuator     SRDO 1 acknowledge ");
        levels += (place == std::string::npos) ? "" : line.substr(0U, place) + line.substr(line.size() - 2U) + "\n";
    }
    EXPECT_EQ(levels, "     150.000 ms 1\n     680.000 ms 0\n     800.000 ms 1\n     850.000 ms 0\n");
    // And one that lasts no time is refused
    EXPECT_THROW(
        static_cast<void>(RunChain("acknowledge: [{at: 200 ms, node: actuator, srdo: 1, pulse: 0 ms}]\n", true)),
        runtime::YamlError);
}

// Given an instant between two microseconds, then every place tells the same one: the one that has passed.
TEST(Reports, AnInstantHasOneNumber)
{
    Verifies(req::SRS_SIM_083);
    for (const auto& [time, text, column] :
         std::vector<std::tuple<Nanoseconds, std::string, std::string>>{{562343951, "562.343 ms", "     562.343 ms"},
                                                                        {999999, "0.999 ms", "       0.999 ms"},
                                                                        {560000400, "560 ms", "     560.000 ms"},
                                                                        {-1500000, "-1.5 ms", "      -1.500 ms"},
                                                                        {-999, "0 ms", "       0.000 ms"},
                                                                        {-20000, "-0.02 ms", "      -0.020 ms"}})
    {
        EXPECT_EQ(MillisecondsText(time), text);
        EXPECT_EQ(runtime::MillisecondsColumn(time, 12U), column);
    }
    EXPECT_EQ(runtime::MillisecondsColumn(1234567890123456, 3U), "1234567890.123 ms");
    // On the time line, too
    const auto run = RunChain(kLoss, true);
    const std::string line = "\n" + TimeLineOf(*run);
    std::size_t behind_the_half = 0U;
    for (const Event& event : run->Record().Events())
    {
        const bool is_told = event.kind != EventKind::kReception; // That is the frame itself.
        behind_the_half += (is_told && event.at % 1000 >= 500) ? 1U : 0U;
        EXPECT_TRUE(!is_told || line.find("\n" + runtime::MillisecondsColumn(event.at, 12U)) != std::string::npos)
            << event.at;
    }
    EXPECT_GE(behind_the_half, 10U);
}

std::size_t CountOf(const std::string& text, const std::string& part)
{
    std::size_t count = 0U;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1U))
    {
        ++count;
    }
    return count;
}

std::string TimeLineWith(const std::string& faults, const FrameLines lines)
{
    const auto run = RunChain("faults:\n" + faults, true);
    std::ostringstream out;
    WriteTimeLine(*run, lines, out);
    return out.str();
}

TEST(Reports, TimeLineTellsOnceWhatAFaultDoesByTheThousand)
{
    Verifies(req::SRS_SIM_071);
    // A babbling controller: one line for the bus and for each node that hears it, and another one where it begins anew
    const std::string babbling = "  - {fault: babbling, at: 500 ms, until: 700 ms, identifier: 0x002, data: [0x55]}\n"
                                 "  - {fault: babbling, name: again, at: 800 ms, until: 900 ms, identifier: 0x002}\n";
    const std::string text = TimeLineWith(babbling, FrameLines::kCounted);
    EXPECT_EQ(CountOf(text, "frame 0x002 inserted: babbling"), 3U) << text;
    EXPECT_EQ(CountOf(text, "frame 0x002 inserted: again"), 3U) << text;
    EXPECT_EQ(CountOf(text, " times until 700."), 4U) << text;
    EXPECT_LT(CountOf(text, "\n"), 300U);
    EXPECT_GT(CountOf(TimeLineWith(babbling, FrameLines::kAll), "frame 0x002 inserted: "), 3000U);
    // Frames that are further apart are lines of their own; the fault alters them
    const std::string changed = TimeLineWith(
        "  - {fault: corruption, bits: [0], frames: {identifier: 0x104, receiver: actuator, from: 500 ms, count: 4}}\n",
        FrameLines::kCounted);
    EXPECT_EQ(CountOf(changed, "frame 0x104 changed: corruption"), 4U) << changed;
    // Frames that nobody acknowledges are sent again and again
    const std::string alone = TimeLineWith(
        "  - {fault: wire_error, frames: {identifier: 0x103, from: 500 ms, count: 9}}\n", FrameLines::kCounted);
    EXPECT_EQ(CountOf(alone, "destroyed on the wire (9 times until "), 1U) << alone;
    for (const char* const fault : {"insertion, at: 510 ms, receiver: actuator, identifier: 0x103, data: [0, 0]",
                                    "masquerade, at: 507 ms, node: sensor, identifier: 0x103, data: [1, 1]",
                                    "duplicate, frames: {identifier: 0x103, from: 500 ms}"})
    {
        const std::string own =
            TimeLineWith("  - {name: own, fault: " + std::string(fault) + "}\n", FrameLines::kCounted);
        EXPECT_EQ(CountOf(own, "0x103 changed"), 0U) << own;
    }
}

TEST(Reports, JsonHoldsRecordingMeasurementAndVerdicts)
{
    Verifies(req::SRS_SIM_041);
    Verifies(req::SRS_SIM_031);
    const auto run = RunChain(kLoss, true);
    const nlohmann::json json = nlohmann::json::parse(JsonReport(*run));
    EXPECT_EQ(json["format"], "counterpoint-simulation-1");
    EXPECT_EQ(json["holds"], false);
    EXPECT_EQ(json["nodes"][2]["name"], "actuator");
    EXPECT_EQ(json["nodes"][2]["srdos"][0]["cob_id_1"], 0x103);
    const nlohmann::json& measurement = json["expectations"][0]["measurement"];
    // SCT 50 ms + SRVT 20 ms + cycle 1 ms, 0.5 ms late + counters 0.5 ms apart + output 1 ms
    EXPECT_EQ(measurement["limit_ns"], 73000000);
    EXPECT_EQ(measurement["holds"], true);
    EXPECT_EQ(measurement["detected_by"], "channels");
    EXPECT_EQ(measurement["detection_cause"], "srvt");
    // The last good pair was one refresh time (25 ms) before the lost one, then SRVT 20 ms and up to a cycle, then
    // output 1 ms
    EXPECT_GE(measurement["elapsed_ns"], 45000000);
    EXPECT_LE(measurement["elapsed_ns"], 47500000);
    // Four a refresh time of 25 ms; the bit flipped by chance may silence the controller from 700 ms on.
    EXPECT_GT(json["frames"].size(), 100U);
    EXPECT_GT(json["events"].size(), 100U);
}

TEST(Reports, CandumpHasOneLineForEachFrameOfTheBus)
{
    Verifies(req::SRS_SIM_042);
    const auto run = RunChain("duration: 40 ms\n", true);
    const std::string text = CandumpReport(*run);
    // Sensor: node 1, first pair 0.5 ms after OPERATIONAL at 10 ms, buttons not let go yet
    EXPECT_EQ(text.substr(0U, 15U), "(0000000000.011") << text.substr(0U, 60U);
    EXPECT_NE(text.find(") can0 101#0000\n"), std::string::npos) << text;
    EXPECT_NE(text.find(") can0 102#FFFF\n"), std::string::npos) << text;
    EXPECT_NE(text.find(") can0 101#0101\n"), std::string::npos) << text;
    EXPECT_EQ(run->Record().Frames().size(), static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
}

// Given a controller of others that repeats one frame, a frame that comes to one receiver past the bus, and a
// controller of others that never pauses, then the log has what was on the bus.
TEST(Reports, CandumpHasTheFramesOfControllersThatAreNoNodes)
{
    Verifies(req::SRS_SIM_042);
    constexpr const char* kFaults = R"(
faults:
  - {fault: duplicate, name: d, frames: {identifier: 0x104, from: 300 ms}, after: 2 ms}
  - {fault: insertion, name: i, at: 350 ms, identifier: 0x7AA, receiver: actuator, optional: true}
  - {fault: babbling, name: b, at: 380 ms, until: 390 ms, identifier: 0x001}
)";
    const auto run = RunChain(std::string("duration: 400 ms\n") + kFaults, true);
    const std::string text = CandumpReport(*run);
    const auto count = [&run](const std::uint32_t identifier, const bool is_of_node)
    {
        const auto& frames = run->Record().Frames();
        return std::count_if(frames.begin(), frames.end(),
                             [identifier, is_of_node](const FrameEntry& entry)
                             {
                                 return entry.frame.identifier == identifier &&
                                        (entry.sender != kNoNode) == is_of_node &&
                                        entry.fate == host::FrameFate::kComplete;
                             });
    };
    const auto lines = [&text](const std::string& head)
    {
        std::ptrdiff_t found = 0;
        for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, at + 1U))
        {
            ++found;
        }
        return found;
    };
    EXPECT_EQ(count(0x104U, false), 1);
    EXPECT_EQ(lines(" can0 104#"), count(0x104U, true) + 1);
    EXPECT_GT(count(0x001U, false), 10);
    EXPECT_EQ(lines(" can0 001#"), count(0x001U, false));
    EXPECT_EQ(count(0x7AAU, false), 1);
    EXPECT_EQ(lines(" can0 7AA#"), 0);
}

TEST(Reports, PageNeedsNoNetworkAndNothingEndsItsScript)
{
    Verifies(req::SRS_SIM_043);
    const auto run = RunChain(kLoss, true);
    const std::string page = HtmlReport("a <b> & \"c\"", {run.get()});
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
    EXPECT_EQ(page.find("{{"), std::string::npos);
    EXPECT_NE(page.find("<h1>a &lt;b&gt; &amp; &quot;c&quot;</h1>"), std::string::npos);
    // The two script elements of the page and no other
    std::size_t ends = 0U;
    for (std::size_t at = page.find("</script>"); at != std::string::npos; at = page.find("</script>", at + 1U))
    {
        ++ends;
    }
    EXPECT_EQ(ends, 2U);
}

// What the page draws it draws by its script from the run in its data element.
TEST(Reports, PageHoldsWhatItsDiagramShows)
{
    Verifies(req::SRS_SIM_043);
    const auto run = RunChain(kLoss, true);
    const std::string page = HtmlReport("a", {run.get()});
    // Given the data of the page
    const std::string begin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t data = page.find(begin);
    ASSERT_NE(data, std::string::npos);
    const std::size_t first = data + begin.size();
    const nlohmann::json json = nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
    const nlohmann::json& shown = json["runs"][0];
    // Then frames, time limits, and faults with their detection and limit are in it
    EXPECT_GT(shown["frames"].size(), 100U);
    EXPECT_EQ(shown["nodes"][2]["srdos"][0]["sct_ms"], 50);
    EXPECT_EQ(shown["nodes"][2]["srdos"][0]["srvt_ms"], 20);
    EXPECT_EQ(shown["faults"][1]["name"], "chance");
    EXPECT_EQ(shown["expectations"][0]["measurement"]["detected_by"], "channels");
    EXPECT_EQ(shown["expectations"][0]["measurement"]["limit_ns"], 73000000);
    EXPECT_TRUE(shown["expectations"][0]["measurement"].contains("detected_ns"));
    // and what both channels, the comparator, the permits and the output were
    for (const char* const kind : {"view_a", "view_b", "verdict", "permits", "output", "fault"})
    {
        EXPECT_TRUE(std::any_of(shown["events"].begin(), shown["events"].end(),
                                [kind](const nlohmann::json& event) { return event["kind"] == kind; }))
            << kind;
    }
    // and the script has a row for each of them
    for (const char* const row : {" channel ", " comparator", " permits", " output", "Limit "})
    {
        EXPECT_NE(page.find(row), std::string::npos) << row;
    }
}
} // namespace
} // namespace counterpoint::simulator
