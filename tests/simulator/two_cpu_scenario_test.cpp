// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/report/reports.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <set>
#include <sstream>
#include <string>

namespace counterpoint::simulator
{
namespace
{
std::string TwoCpuChain()
{
    return Examples() + "../two_cpus/chain.yaml";
}

std::string Refusal(const std::string& file)
{
    try
    {
        const simulator::Run run(file, std::nullopt, std::nullopt, false);
    }
    catch (const YamlError& error)
    {
        return error.what();
    }
    return "";
}

/// What is added to the chain whose actuator has two CPUs, and what the line says behind the file name.
struct BadCase
{
    const char* text;
    const char* message;
};

void PrintTo(const BadCase& bad, std::ostream* const out)
{
    *out << bad.text;
}

using BadTwoCpuScenario = ::testing::TestWithParam<BadCase>;

TEST_P(BadTwoCpuScenario, IsRefusedByOneLineThatNamesThePlace)
{
    Verifies(req::SRS_SIM_056);
    Verifies(req::SRS_SIM_057);
    Verifies(req::SRS_SIM_010);
    const std::string file = TextFile("extends: " + TwoCpuChain() + "\n" + GetParam().text);
    const std::string refusal = Refusal(file);
    EXPECT_EQ(refusal, file + ":" + GetParam().message);
}

constexpr BadCase kBadCases[] = {
    {"faults:\n  - {fault: standstill, node: actuator, at: 500 ms}\n",
     "3:31: error: node 'actuator', which is two CPUs, expected actuator.a or actuator.b"},
    {"faults:\n  - {fault: standstill, node: actuator.c, at: 500 ms}\n",
     "3:31: error: node 'actuator.c' (did you mean 'actuator.a'?), expected one of sensor, controller, actuator.a, "
     "actuator.b"},
    {"faults:\n  - {fault: link_cut, node: sensor, at: 500 ms}\n",
     "3:29: error: node 'sensor', expected a node with 'structure: two_cpu'"},
    {"faults:\n  - {fault: link_cut, node: actuator.a, at: 500 ms}\n",
     "3:29: error: node 'actuator.a', expected a node with 'structure: two_cpu'"},
    {"faults:\n  - {fault: link_cut, node: actuator, sender: c, at: 500 ms}\n",
     "3:47: error: 'c', expected one of a, b, both"},
    {"faults:\n  - {fault: link_corruption, node: actuator, bits: [1504], at: 500 ms}\n",
     "3:53: error: '1504', expected a number from 0 to 1503"},
    {"faults:\n  - {fault: link_corruption, node: actuator, bits: [], at: 500 ms}\n",
     "3:52: error: an empty list, expected one bit or more"},
    {"faults:\n  - {fault: link_insertion, node: actuator, times: 2, at: 500 ms}\n",
     "3:5: error: several messages without key 'every', expected the time between two messages"},
    {"faults:\n  - {fault: link_insertion, node: actuator, back: 2, at: 500 ms}\n",
     "3:45: error: key 'back' without an effect in this fault, expected only keys that fit its others"},
    {"faults:\n  - {fault: frozen, node: actuator.a, part: channel_b, at: 500 ms}\n",
     "3:5: error: channel_b of actuator.a, expected the channel of this CPU, or the other CPU"},
    {"faults:\n  - {fault: clock, node: actuator.b, counter: both, stopped: true, at: 500 ms}\n",
     "3:5: error: counter b of actuator.b, expected counter a: a CPU of two has one"},
    {"faults:\n  - {fault: loss, frames: {identifier: 0x103, receiver: actuator}}\n",
     "3:57: error: node 'actuator', which is two CPUs, expected actuator.a or actuator.b"},
    {"faults:\n  - {fault: loss, frames: {identifier: 0x103}}\nexpect:\n"
     "  - {that: safe_within, node: sensor, srdo: 1, limit: cross_link}\n",
     "5:55: error: cross_link of a node with one CPU, expected another row, or a node with 'structure: two_cpu'"},
    {"faults:\n  - {fault: link_cut, node: actuator, at: 1000 ms}\n",
     "3:5: error: fault 'link_cut' at 1000 ms, not before the end of the run, expected a time below 1000 ms"},
};
INSTANTIATE_TEST_SUITE_P(EachReason, BadTwoCpuScenario, ::testing::ValuesIn(kBadCases));

using BadLink = ::testing::TestWithParam<BadCase>;

TEST_P(BadLink, IsRefusedAtTheNode)
{
    Verifies(req::SRS_SIM_056);
    const std::string file =
        TextFile("duration: 1 s\nnodes:\n  device: {dcf: " + Examples() + "actuator.dcf, " + GetParam().text + "}\n");
    const std::string refusal = Refusal(file);
    EXPECT_EQ(refusal.rfind(file + ":3:", 0U), 0U) << refusal;
    EXPECT_NE(refusal.find(GetParam().message), std::string::npos) << refusal;
}

constexpr BadCase kBadLinks[] = {
    {"structure: three_cpu", "'three_cpu', expected one of one_cpu, two_cpu"},
    {"structure: two_cpu, phase: 1 ms", "key 'phase'"},
    {"structure: two_cpu, counter_a: {ppm: 1}", "key 'counter_a'"},
    {"link: {timeout: 5 ms}", "key 'link'"},
    {"cpu_a: {phase: 5 ms}", "key 'cpu_a'"},
    {"structure: two_cpu, cpu_a: {ppm: 5}", "unknown key 'ppm' in a CPU"},
    {"structure: two_cpu, cpu_b: {counter: {ppm: -1000000}}", "a counter that stands still from the start"},
    {"structure: two_cpu, link: {timeout: 2 ms}", "link time-out, expected 3 cycles of the device or more"},
    {"structure: two_cpu, link: {clock_tolerance: 6 ms}", "clock tolerance or interval of the link, expected"},
    {"structure: two_cpu, link: {clock_interval: 4295 s}",
     "a time of the link of 4295000 ms, expected at most 536000 ms"},
    {"structure: two_cpu, link: {stamp_tolerance: 10 ms}", "stamp tolerance of the link, expected less than"},
    {"structure: two_cpu, link: {delay: 9 ms, jitter: 1 ms}", "delay of the link with its jitter, expected less"},
    {"structure: two_cpu, start_at: 1 ms, cpu_b: {phase: 1 ms}", "start_at not after phase"},
};
INSTANTIATE_TEST_SUITE_P(EachReason, BadLink, ::testing::ValuesIn(kBadLinks));

TEST(TwoCpuReports, ShowTheLinkAndTheMessagesThatAFaultHits)
{
    Verifies(req::SRS_SIM_058);
    Verifies(req::SRS_SIM_003);
    const std::string file = TextFile("extends: " + TwoCpuChain() + R"(
faults:
  - {fault: link_loss, name: gone, node: actuator, sender: b, at: 500 ms, until: 520 ms}
expect:
  - {that: safe_within, node: actuator, srdo: 1}
)");
    std::string first;
    for (int time = 0; time < 2; ++time)
    {
        simulator::Run run(file, std::nullopt, std::nullopt, true);
        run.Simulate(nullptr);
        const std::string text = JsonReport(run);
        EXPECT_TRUE(first.empty() || first == text);
        first = text;
        const std::string page = HtmlReport("Two CPUs", {&run});
        EXPECT_NE(page.find("link to the other CPU"), std::string::npos);
        std::ostringstream out;
        WriteTimeLine(run, FrameLines::kAll, out);
        for (const char* const line :
             {"  actuator.a   link to the other CPU alive\n", "  actuator.b   link to the other CPU alive\n",
              "  actuator.a   link to the other CPU lost", "  actuator.b   link to the other CPU lost",
              "  actuator.a   message of the other CPU: gone\n"})
        {
            EXPECT_NE(out.str().find(line), std::string::npos) << line << out.str();
        }
    }
    const nlohmann::json json = nlohmann::json::parse(first);
    EXPECT_EQ(json["nodes"][2]["name"], "actuator.a");
    EXPECT_EQ(json["nodes"][2]["device"], "actuator");
    EXPECT_EQ(json["nodes"][2]["cpu"], "a");
    EXPECT_EQ(json["nodes"][3]["cpu"], "b");
    EXPECT_TRUE(json["nodes"][0]["cpu"].is_null());
    EXPECT_EQ(json["expectations"][1]["measurement"]["node"], "actuator");
    EXPECT_EQ(json["expectations"][1]["measurement"]["limit_class"], "cross_link");
    // Time-out 10 ms + cycle 1 ms, 0.5 ms late + counters 0.5 ms apart + output 1 ms
    EXPECT_EQ(json["expectations"][1]["measurement"]["limit_ns"], 13000000);
    // Each lost message is told where it does not arrive: one a cycle for 20 ms
    std::size_t hit = 0U;
    std::set<std::string> states;
    for (const nlohmann::json& event : json["events"])
    {
        if (event["kind"] == "link_message")
        {
            ++hit;
            EXPECT_EQ(event["node"], "actuator.a");
            EXPECT_EQ(event["text"], "message of the other CPU: gone");
        }
        if (event["kind"] == "link")
        {
            states.insert(event["node"].get<std::string>() + " " + event["state"].get<std::string>());
        }
    }
    EXPECT_EQ(hit, 20U);
    EXPECT_EQ(states,
              (std::set<std::string>{"actuator.a alive", "actuator.b alive", "actuator.a lost", "actuator.b lost"}));
}

TEST(TwoCpuReports, SeedDecidesWhichMessagesAreLost)
{
    Verifies(req::SRS_SIM_003);
    Verifies(req::SRS_SIM_057);
    const auto lost = [](const std::uint64_t seed)
    {
        const std::string file = TextFile("extends: " + TwoCpuChain() +
                                          "\nfaults:\n  - {fault: link_loss, node: actuator, at: 200 ms, "
                                          "probability_ppm: 50000}\n");
        simulator::Run run(file, seed, std::nullopt, true);
        run.Simulate(nullptr);
        std::string times;
        for (const Event& event : run.Record().Events())
        {
            times += (event.kind == EventKind::kLinkMessage) ? std::to_string(event.at) + " " : "";
        }
        return times;
    };
    EXPECT_EQ(lost(7U), lost(7U));
    EXPECT_NE(lost(7U), lost(8U));
    EXPECT_NE(lost(7U), "");
}
} // namespace
} // namespace counterpoint::simulator
