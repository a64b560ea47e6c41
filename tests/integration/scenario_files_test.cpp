// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
/// All in these folders.
std::vector<std::string> ScenariosIn(const std::vector<std::string>& folders)
{
    std::vector<std::string> files;
    for (const std::string& folder : folders)
    {
        for (const auto& entry : std::filesystem::directory_iterator(folder))
        {
            if (entry.path().extension() == ".yaml")
            {
                files.push_back(entry.path().string());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Those of the demonstration, and others on its chain.
std::vector<std::string> ShippedScenarios()
{
    return ScenariosIn({Examples(), Scenarios() + "emergency_stop"});
}

/// Of what devices find about themselves and about their other CPU.
std::vector<std::string> MoreScenarios()
{
    return ScenariosIn({Examples() + "../two_cpus", Scenarios() + "two_cpus", Scenarios() + "self_tests"});
}

using ShippedScenario = ::testing::TestWithParam<std::string>;

TEST_P(ShippedScenario, HoldsInEveryExpectation)
{
    Verifies(req::SRS_DEMO_001);
    Verifies(req::SRS_SIM_030);
    Verifies(req::SRS_SIM_053);
    Verifies(req::SRS_SIM_057);
    // Given a scenario; when it runs (a soak run in short)
    simulator::Run run(GetParam(), std::nullopt, std::nullopt, false);
    run.Simulate(nullptr);
    // Then what it expects comes; the chain that others extend expects nothing
    EXPECT_EQ(GetParam() == Examples() + "chain.yaml" ? std::string() : Failures(run), "");
}

TEST(Expectations, EachKindHoldsOrNotAndTellsWhatWasSeen)
{
    Verifies(req::SRS_SIM_030);
    // Given three pairs that are lost from 500 ms on, and each expectation once as it is and once otherwise
    const auto run = RunChain(R"(
faults:
  - {fault: loss, name: lost, frames: {sender: controller, receiver: actuator, from: 500 ms, count: 6}}
expect:
  - {that: released, node: actuator, srdo: 1, at: 499 ms}
  - {that: released, node: actuator, srdo: 1, at: 560 ms}
  - {that: safe, node: actuator, srdo: 1, at: 560 ms}
  - {that: safe, node: actuator, srdo: 1, at: 499 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 1, at: 499 ms}
  - {that: value, node: actuator, object: 0x2200:01, is: 0, at: 499 ms}
  - {that: cause, node: actuator, srdo: 1, is: sct}
  - {that: cause, node: actuator, srdo: 1, is: srvt}
  - {that: device_fault, node: actuator, is: none}
  - {that: device_fault, node: actuator, is: clock}
  - {that: detected_by, node: actuator, by: channels}
  - {that: detected_by, node: actuator, by: comparator}
  - {that: safe_within, node: actuator, srdo: 1}
  - {that: no_fault}
)");
    std::string told;
    for (const ExpectationVerdict& verdict : run->Verdicts())
    {
        told += std::string(verdict.holds ? "holds " : "FAILS ") + verdict.wanted + ": " + verdict.seen + "\n";
    }
    EXPECT_EQ(told, "holds actuator SRDO 1 released at 499 ms: released\n"
                    "FAILS actuator SRDO 1 released at 560 ms: safe\n"
                    "holds actuator SRDO 1 safe at 560 ms: safe\n"
                    "FAILS actuator SRDO 1 safe at 499 ms: released\n"
                    "holds actuator 0x2200:01 is 1 at 499 ms: 1\n"
                    "FAILS actuator 0x2200:01 is 0 at 499 ms: 1\n"
                    "holds actuator SRDO 1 cause sct: sct\n"
                    "FAILS actuator SRDO 1 cause srvt: sct\n"
                    "holds actuator device fault none: none\n"
                    "FAILS actuator device fault clock: none\n"
                    "holds detected at actuator by channels: channels (sct)\n"
                    "FAILS detected at actuator by comparator: channels (sct)\n"
                    "holds actuator SRDO 1 safe within 53 ms after 'lost' (limit: bus): 51.192 ms\n"
                    "FAILS no fault: actuator sct at 536.807 ms\n");
}

std::string NameOf(const ::testing::TestParamInfo<std::string>& info)
{
    const std::string file = std::filesystem::path(info.param).filename().string();
    return "file_" + file.substr(0U, file.find('.'));
}

INSTANTIATE_TEST_SUITE_P(EmergencyStop, ShippedScenario, ::testing::ValuesIn(ShippedScenarios()), NameOf);
INSTANTIATE_TEST_SUITE_P(SelfTestsAndTwoCpus, ShippedScenario, ::testing::ValuesIn(MoreScenarios()), NameOf);

TEST(ShippedScenarios, CoverEveryClassOfTheDemonstration)
{
    Verifies(req::SRS_DEMO_001);
    // Given the numbered scenarios
    std::set<FaultKind> kinds;
    std::set<Part> parts;
    std::size_t with_fault = 0U;
    for (const std::string& file : ShippedScenarios())
    {
        const simulator::Run run(file, std::nullopt, std::nullopt, false);
        with_fault += run.Setting().faults.empty() ? 0U : 1U;
        for (const FaultSetup& fault : run.Setting().faults)
        {
            kinds.insert(fault.kind);
            parts.insert(fault.part);
        }
    }
    // Then all classes are there
    EXPECT_GE(with_fault, 14U);
    for (const FaultKind kind : std::initializer_list<FaultKind>{
             FrameFault::kCorruption, FrameFault::kRepetition, FrameFault::kWrongSequence, FrameFault::kLoss,
             FrameFault::kDelay, ForeignFault::kInsertion, ForeignFault::kMasquerade, FrameFault::kAddressing,
             NodeFault::kBitFlip, PartFault::kHung, PartFault::kFrozen, PartFault::kNotCalled, PartFault::kAlwaysGood,
             NodeFault::kClock, NodeFault::kNotInverse})
    {
        EXPECT_EQ(kinds.count(kind), 1U) << Name(kind);
    }
    for (const Part part : {Part::kChannelA, Part::kChannelB, Part::kComparator, Part::kFlowMonitor, Part::kGuard})
    {
        EXPECT_EQ(parts.count(part), 1U) << static_cast<int>(part);
    }
}
} // namespace
} // namespace counterpoint::simulator
