// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/reader.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <string>

namespace counterpoint::simulator
{
namespace
{
constexpr const char* kSmall =
    "duration: 1.5 s\n"
    "nodes:\n"
    "  one: {dcf: a.dcf, node_id: 0x7F, phase: 130 us, counter_a: {ppm: -20, start_us: 4294967295}}\n"
    "inputs:\n"
    "  - {at: 2ms, node: one, object: 0x2000:0A, value: 0xFFFFFFFFFFFFFFFF}\n";

void ExpectSmall(const Scenario& scenario)
{
    EXPECT_EQ(scenario.duration, 1500000000);
    ASSERT_EQ(scenario.nodes.size(), 1U);
    EXPECT_EQ(scenario.nodes[0].name, "one");
    EXPECT_EQ(scenario.nodes[0].node_id, 127U);
    EXPECT_EQ(scenario.nodes[0].phase, 130000);
    EXPECT_EQ(scenario.nodes[0].start_at, 10000000);
    EXPECT_EQ(scenario.nodes[0].counter_a.drift_ppm, -20);
    EXPECT_EQ(scenario.nodes[0].counter_a.start_us, 4294967295U);
    ASSERT_EQ(scenario.stimuli.size(), 1U);
    EXPECT_EQ(scenario.stimuli[0].at, 2000000);
    EXPECT_EQ(scenario.stimuli[0].object.index, 0x2000U);
    EXPECT_EQ(scenario.stimuli[0].object.sub, 10U);
    EXPECT_EQ(scenario.stimuli[0].value, 0xFFFFFFFFFFFFFFFFU);
    EXPECT_EQ(scenario.bitrate, 500000U);
    EXPECT_EQ(scenario.seed, 1U);
}

TEST(ScenarioReader, ReadsValuesWithUnitsAndDefaults)
{
    Verifies(req::SRS_SIM_010);
    ExpectSmall(ReadScenario(TextFile(kSmall)));
}

TEST(ScenarioReader, AcceptsCarriageReturnsAndByteOrderMark)
{
    Verifies(req::SRS_SIM_011);
    // Given the same text with CR LF and a byte order mark
    std::string text = "\xEF\xBB\xBF";
    for (const char character : std::string(kSmall))
    {
        text += (character == '\n') ? std::string("\r\n") : std::string(1U, character);
    }
    // Then it means the same
    ExpectSmall(ReadScenario(TextFile(text)));
}

TEST(ScenarioReader, AppendsListsAndReplacesSingleValuesOfWhatItExtends)
{
    Verifies(req::SRS_SIM_013);
    const Scenario base = ReadScenario(Examples() + "chain.yaml");
    // Given a scenario that extends the chain
    const Scenario scenario = ReadScenario(TextFile("extends: " + Examples() + R"(chain.yaml
duration: 7 s
title: mine
inputs:
  - {at: 1 s, node: sensor, object: 0x2000:01, value: 0}
)"));
    // Then the single values are its own and the inputs of both are there, those of the base first
    EXPECT_EQ(scenario.duration, 7000000000);
    EXPECT_EQ(scenario.title, "mine");
    EXPECT_EQ(scenario.bitrate, base.bitrate);
    EXPECT_EQ(scenario.nodes.size(), 3U);
    ASSERT_EQ(scenario.stimuli.size(), base.stimuli.size() + 1U);
    EXPECT_EQ(scenario.stimuli.front().at, base.stimuli.front().at);
    EXPECT_EQ(scenario.stimuli.back().at, 1000000000);
}

TEST(ScenarioReader, ChoosesFramesByEverythingThatItOffers)
{
    Verifies(req::SRS_SIM_020);
    const Scenario scenario = ReadScenario(TextFile("extends: " + Examples() + R"(chain.yaml
faults:
  - fault: corruption
    name: mine
    frames: {identifier: 0x103, sender: controller, receiver: actuator, from: 1 ms, until: 2 ms, first: 3, count: 4,
             probability_ppm: 5}
    bits: [0, 63]
    length: 7
)"));
    ASSERT_EQ(scenario.faults.size(), 1U);
    const FaultSetup& fault = scenario.faults[0];
    EXPECT_EQ(fault.name, "mine");
    EXPECT_EQ(fault.frames.identifiers, std::vector<std::uint32_t>{0x103U});
    EXPECT_EQ(fault.frames.sender, 1U);
    EXPECT_EQ(fault.frames.receiver, 2U);
    EXPECT_EQ(fault.frames.from, 1000000);
    EXPECT_EQ(fault.frames.until, 2000000);
    EXPECT_EQ(fault.frames.first, 3U);
    EXPECT_EQ(fault.frames.count, 4U);
    EXPECT_EQ(fault.frames.probability_ppm, 5U);
    EXPECT_EQ(fault.bits, (std::vector<std::uint8_t>{0U, 63U}));
    EXPECT_EQ(fault.length, 7U);
}
} // namespace
} // namespace counterpoint::simulator
