// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/supervisor_tap.hpp"
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::simulator
{
namespace
{
TEST(SupervisorTap, TakesEveryCallOfTheThreeSupervisors)
{
    Verifies(req::SRS_SIM_022);
    // Given the calls so far
    const std::uint64_t compared = SupervisorTap::Intercepted(Part::kComparator);
    const std::uint64_t marked = SupervisorTap::Intercepted(Part::kFlowMonitor);
    const std::uint64_t guarded = SupervisorTap::Intercepted(Part::kGuard);
    // When three nodes run 100 cycles of 1 ms each, recorded, so that the taps are in use
    simulator::Run run(TextFile("extends: " + Examples() + "chain.yaml\nduration: 100 ms\n"), std::nullopt,
                       std::nullopt, true);
    run.Simulate(nullptr);
    // Then each cycle went through the wraps: one comparison, one token, Begin, eleven marks and End
    const std::uint64_t cycles = SupervisorTap::Intercepted(Part::kGuard) - guarded;
    EXPECT_GE(cycles, 296U);
    EXPECT_LE(cycles, 300U);
    EXPECT_EQ(SupervisorTap::Intercepted(Part::kComparator) - compared, cycles);
    EXPECT_EQ(SupervisorTap::Intercepted(Part::kFlowMonitor) - marked, 13U * cycles);
}

TEST(SupervisorTap, GoesStraightThroughWithoutAScope)
{
    Verifies(req::SRS_SIM_022);
    const std::uint64_t before = SupervisorTap::Intercepted(Part::kFlowMonitor);
    // Given a flow monitor that nobody looks into
    FlowMonitor monitor;
    monitor.Begin();
    for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
    {
        monitor.Mark(static_cast<FlowStep>(step), {5U, 5U});
    }
    // Then its answer is the right one: (5EC0DE27h + question) * 01000193h
    EXPECT_EQ(monitor.End({1U}).value, (0x5EC0DE27U + 1U) * 0x01000193U);
    EXPECT_EQ(SupervisorTap::Intercepted(Part::kFlowMonitor), before);
}

TEST(SupervisorTap, FrozenFlowMonitorRepeatsItsAnswer)
{
    Verifies(req::SRS_SIM_022);
    // Given a scope with a frozen flow monitor
    PartFaults faults;
    SupervisorTap tap(faults);
    FlowMonitor monitor;
    const SupervisorTap::Scope scope(&tap);
    monitor.Begin();
    const std::uint32_t first = monitor.End({1U}).value;
    FaultSetup frozen;
    frozen.kind = PartFault::kFrozen;
    frozen.part = Part::kFlowMonitor;
    faults.SetNow(42);
    faults.Begin(frozen, 3U);
    // Then another question gets the same answer, and the first effect is known
    EXPECT_EQ(monitor.End({2U}).value, first);
    const auto effects = faults.TakeEffects();
    ASSERT_EQ(effects.size(), 1U);
    EXPECT_EQ(effects[0].first, 3U);
    EXPECT_EQ(effects[0].second, 42);
}
} // namespace
} // namespace counterpoint::simulator
