// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <ostream>
#include <string>

namespace counterpoint::simulator
{
namespace
{
/// One party that fails in one way, at one of several moments of the cycle and of the refresh.
struct LonelyFailure
{
    const char* part;
    const char* fault; ///< Kind and what belongs to it.
    const char* at;
};

void PrintTo(const LonelyFailure& failure, std::ostream* const out)
{
    *out << failure.part << " " << failure.fault << " at " << failure.at;
}

class SingleParty : public ::testing::TestWithParam<LonelyFailure>
{
};

TEST_P(SingleParty, FailsAndTheOutputIsSafeWithinTheComputedLimit)
{
    Verifies(req::SRS_SIM_026);
    Verifies(req::SRS_SIM_021);
    Verifies(req::SRS_SIM_022);
    Verifies(req::SRS_SIM_025);
    Verifies(req::SRS_SIM_031);
    Verifies(req::SRS_LIM_001);
    // Given the released chain; when one party of the actuator fails
    const std::string part = GetParam().part;
    const auto run = RunChain("duration: 3 s\nfaults:\n  - {fault: " + std::string(GetParam().fault) +
                              ", node: actuator, part: " + part + ", at: " + GetParam().at + "}\n" + R"(
expect:
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: safe, node: actuator, srdo: 1, at: 2999 ms}
)");
    // Then the output stage closes within the limit and stays closed
    EXPECT_EQ(Failures(*run), "");
}

constexpr LonelyFailure kFailures[] = {
    {"channel_a", "skipped", "500 ms"},
    {"channel_a", "skipped", "511.7 ms"},
    {"channel_a", "skipped, count: 1", "500.3 ms"},
    {"channel_a", "doubled, count: 1", "500.3 ms"},
    {"channel_a", "frozen", "500 ms"},
    {"channel_a", "frozen", "511.65 ms"},
    {"channel_a", "hung", "500 ms"},
    {"channel_a", "hung", "511.9 ms"},
    {"channel_a", "skipped, call: OnFrame", "500 ms"},
    {"channel_a", "skipped, call: OnFrame", "503.1 ms"},
    {"channel_a", "doubled, call: OnFrame", "500 ms"},
    {"channel_b", "skipped", "500 ms"},
    {"channel_b", "skipped", "511.7 ms"},
    {"channel_b", "skipped, count: 1", "500.3 ms"},
    {"channel_b", "doubled, count: 1", "500.3 ms"},
    {"channel_b", "frozen", "500 ms"},
    {"channel_b", "frozen", "511.65 ms"},
    {"channel_b", "hung", "500 ms"},
    {"channel_b", "hung", "511.9 ms"},
    {"channel_b", "skipped, call: OnFrame", "500 ms"},
    {"channel_b", "skipped, call: OnFrame", "503.1 ms"},
    {"channel_b", "doubled, call: OnFrame", "500 ms"},
    {"comparator", "not_called", "500 ms"},
    {"comparator", "not_called", "511.7 ms"},
    {"comparator", "frozen", "500 ms"},
    {"comparator", "frozen", "511.7 ms"},
    {"comparator", "always_good", "500 ms"},
    {"comparator", "always_good", "1000.1 ms"},
    {"comparator", "hung", "500 ms"},
    {"flow_monitor", "not_called", "500 ms"},
    {"flow_monitor", "frozen", "500 ms"},
    {"flow_monitor", "hung", "500 ms"},
    {"flow_monitor", "frozen", "733.3 ms"},
    {"guard", "not_called", "500 ms"},
    {"guard", "frozen", "500 ms"},
    {"guard", "frozen", "733.3 ms"},
    {"guard", "hung", "500 ms"},
};

INSTANTIATE_TEST_SUITE_P(EachPartyEachWay, SingleParty, ::testing::ValuesIn(kFailures));
} // namespace
} // namespace counterpoint::simulator
