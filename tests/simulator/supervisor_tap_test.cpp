// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/flow_faults.hpp"
#include "simulator/faults/part_faults.hpp"
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
    const std::uint64_t compared = PartFaults::Asked(Part::kComparator);
    const std::uint64_t marked = PartFaults::Asked(Part::kFlowMonitor);
    const std::uint64_t guarded = PartFaults::Asked(Part::kGuard);
    // When three nodes run 100 cycles of 1 ms each, recorded, so that the taps are in use
    simulator::Run run(TextFile("extends: " + Examples() + "chain.yaml\nduration: 100 ms\n"), std::nullopt,
                       std::nullopt, true);
    run.Simulate(nullptr);
    // Then each cycle came to the taps: one comparison, one token, Begin, eleven marks and End
    const std::uint64_t cycles = PartFaults::Asked(Part::kGuard) - guarded;
    EXPECT_GE(cycles, 296U);
    EXPECT_LE(cycles, 300U);
    EXPECT_EQ(PartFaults::Asked(Part::kComparator) - compared, cycles);
    EXPECT_EQ(PartFaults::Asked(Part::kFlowMonitor) - marked, 13U * cycles);
}

TEST(SupervisorTap, NodesThatNobodyLooksIntoHaveNone)
{
    Verifies(req::SRS_SIM_022);
    const std::uint64_t compared = PartFaults::Asked(Part::kComparator);
    const std::uint64_t marked = PartFaults::Asked(Part::kFlowMonitor);
    const std::uint64_t guarded = PartFaults::Asked(Part::kGuard);
    // When the same nodes run without fault, expectation and record
    simulator::Run run(TextFile("extends: " + Examples() + "chain.yaml\nduration: 100 ms\n"), std::nullopt,
                       std::nullopt, false);
    run.Simulate(nullptr);
    // Then every call went straight through
    EXPECT_EQ(PartFaults::Asked(Part::kComparator), compared);
    EXPECT_EQ(PartFaults::Asked(Part::kFlowMonitor), marked);
    EXPECT_EQ(PartFaults::Asked(Part::kGuard), guarded);
}

/// A flow monitor behind its faults.
class FlowFaultsTest : public ::testing::Test
{
  protected:
    /// One cycle of eleven marks with right evidence.
    std::uint32_t AnswerTo(const std::uint32_t question)
    {
        flow.Begin();
        for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
        {
            flow.Mark(static_cast<FlowStep>(step), {5U, 5U});
        }
        return flow.End({question}).value;
    }
    void Break(const PartFault kind)
    {
        FaultSetup fault;
        fault.kind = kind;
        fault.part = Part::kFlowMonitor;
        faults.SetNow(42);
        faults.Begin(fault, 3U);
    }

    PartFaults faults{};
    FlowFaults flow{faults};
};

TEST_F(FlowFaultsTest, WithoutAFaultTheAnswerIsTheRightOne)
{
    Verifies(req::SRS_SIM_022);
    // (5EC0DE27h + question) * 01000193h
    EXPECT_EQ(AnswerTo(1U), (0x5EC0DE27U + 1U) * 0x01000193U);
    EXPECT_EQ(flow.Finding(), DeviceFault::kNone);
    EXPECT_TRUE(faults.TakeEffects().empty());
}

TEST_F(FlowFaultsTest, FrozenOneRepeatsItsAnswer)
{
    Verifies(req::SRS_SIM_022);
    const std::uint32_t first = AnswerTo(1U);
    Break(PartFault::kFrozen);
    // Then another question gets the same answer, and the first effect is known
    EXPECT_EQ(AnswerTo(2U), first);
    const auto effects = faults.TakeEffects();
    ASSERT_EQ(effects.size(), 1U);
    EXPECT_EQ(effects[0].first, 3U);
    EXPECT_EQ(effects[0].second, 42);
}

TEST_F(FlowFaultsTest, OneThatIsNotCalledAnswersZero)
{
    Verifies(req::SRS_SIM_022);
    ASSERT_NE(AnswerTo(1U), 0U);
    Break(PartFault::kNotCalled);
    EXPECT_EQ(AnswerTo(2U), 0U);
    EXPECT_EQ(faults.TakeEffects().size(), 1U);
}

TEST_F(FlowFaultsTest, AlwaysGoodOneAnswersRightWithoutAMark)
{
    Verifies(req::SRS_SIM_033);
    Break(PartFault::kAlwaysGood);
    flow.Begin();
    EXPECT_EQ(flow.End({2U}).value, (0x5EC0DE27U + 2U) * 0x01000193U);
    EXPECT_EQ(faults.TakeEffects().size(), 1U);
}
} // namespace
} // namespace counterpoint::simulator
