// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Steps of the flow and calls of a channel that are disturbed in a device, and who finds that.
#include "verification/campaign/campaign_rig.hpp"
#include "verification/campaign/variants.hpp"

namespace counterpoint::campaign::test
{
namespace
{
using DisturbedTest = CampaignTest;

/// A step of the actuator in cycle 499.
Experiment StepFault(const FaultKind kind, const FlowStep step, const std::uint32_t variant)
{
    Experiment fault;
    fault.part = Part::kSteps;
    fault.kind = kind;
    fault.subject = static_cast<std::size_t>(step) - 2U; // The first step has none before it.
    fault.phase = PhaseOf(step);
    fault.variant = variant;
    fault.cycle = 499U;
    return fault;
}

TEST_F(DisturbedTest, StepThatRunsTwiceFindsWhatItLeft)
{
    Verifies(req::SRS_CMG_028);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\ncycles: 1\nparts: [steps]\nkinds: [doubled]\n"));
    EXPECT_EQ(session.Faults().Size(), 10U * 4U);
    // When channel A's step runs twice in a cycle and its mark is made once, then A has counted a cycle more than B
    const Outcome channel = session.Runs().Run(StepFault(FaultKind::kDoubled, FlowStep::kChannelA, 0U));
    EXPECT_EQ(channel.result, Class::kDetected);
    EXPECT_EQ(channel.detector, Detector::kComparator) << WordOf(channel.detector);
    // and where that is the first cycle of many, the second one is not reached.
    EXPECT_EQ(session.Runs().Run(StepFault(FaultKind::kDoubled, FlowStep::kChannelA, kAlways)).us, channel.us);
    // When the permits are given twice, the second ones answer no challenge that the gate still has: it closes for
    // good, and the kernel makes a device fault of it
    const Outcome permits = session.Runs().Run(StepFault(FaultKind::kDoubled, FlowStep::kPermits, 0U));
    EXPECT_EQ(permits.result, Class::kDetected);
    EXPECT_EQ(permits.detector, Detector::kPermits) << WordOf(permits.detector);
    // When the comparison runs twice, it finds the same; its second mark is one too many
    const Experiment comparison = StepFault(FaultKind::kDoubled, FlowStep::kComparison, 0U);
    EXPECT_EQ(session.Runs().Run(comparison).result, Class::kMasked);
    const Outcome marked = session.Runs().Run(StepFault(FaultKind::kDoubled, FlowStep::kComparison, kNothingLeft));
    EXPECT_EQ(marked.detector, Detector::kFlowMonitor) << WordOf(marked.detector);
}

TEST_F(DisturbedTest, StepThatRunsBehindTheNextOneIsSeenByItsMark)
{
    Verifies(req::SRS_CMG_028);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\ncycles: 1\nparts: [steps]\nkinds: [reordered]\n"));
    EXPECT_EQ(session.Faults().Size(), 9U * 4U);
    // When channel B's step comes before channel A's, then each did what it had to do
    EXPECT_EQ(session.Runs().Run(StepFault(FaultKind::kReordered, FlowStep::kChannelA, 0U)).result, Class::kMasked);
    // and only the marks tell.
    const Outcome marked = session.Runs().Run(StepFault(FaultKind::kReordered, FlowStep::kChannelA, kNothingLeft));
    EXPECT_EQ(marked.result, Class::kDetected);
    EXPECT_EQ(marked.detector, Detector::kFlowMonitor) << WordOf(marked.detector);
    EXPECT_EQ(marked.us, 0U);
}

TEST_F(DisturbedTest, StepWhoseWorkIsTakenBackIsMissedOrItsMarkIs)
{
    Verifies(req::SRS_CMG_560);
    const Trap trap;
    Session session(
        PlanFile("plan.yaml", "actuator", "at: [500 ms]\ncycles: 1\nparts: [steps]\nkinds: [skipped, late]\n"));
    EXPECT_EQ(session.Faults().Size(), 10U * 4U + 10U * 2U);
    // When channel A's step is taken back and its mark stays, then it has counted a cycle less than channel B
    const Outcome unmarked = session.Runs().Run(StepFault(FaultKind::kSkipped, FlowStep::kChannelA, 0U));
    EXPECT_EQ(unmarked.result, Class::kDetected);
    EXPECT_EQ(unmarked.detector, Detector::kComparator) << WordOf(unmarked.detector);
    // When its mark goes as well, then the flow monitor finds that in the same cycle, in the first one of many
    for (const std::uint32_t always : {0U, kAlways})
    {
        const Outcome marked =
            session.Runs().Run(StepFault(FaultKind::kSkipped, FlowStep::kChannelA, kNothingLeft | always));
        EXPECT_EQ(marked.result, Class::kDetected);
        EXPECT_EQ(marked.us, 0U);
    }
    // When what it wrote comes behind the next step, then with its own mark, over that of the next one
    EXPECT_EQ(session.Runs().Run(StepFault(FaultKind::kLate, FlowStep::kChannelA, 0U)).result, Class::kDetected);
    const Outcome late = session.Runs().Run(StepFault(FaultKind::kLate, FlowStep::kChannelB, 0U));
    EXPECT_EQ(late.result, Class::kDetected);
    EXPECT_EQ(late.detector, Detector::kFlowMonitor) << WordOf(late.detector);
}

TEST_F(DisturbedTest, SkippedCallOfAChannelIsTheOneThatIsMeant)
{
    Verifies(req::SRS_CMG_022);
    const Trap trap;
    Session session(PlanFile("plan.yaml", "actuator", "at: [500 ms]\ncycles: 1\nparts: [a_calls]\n"));
    // When channel A's first Answer of a cycle is skipped and answers 0
    Experiment fault;
    fault.part = Part::kCallsOfA;
    fault.kind = FaultKind::kSkipped;
    fault.subject = static_cast<std::size_t>(ChannelCall::kAnswer) * kTurns;
    fault.variant = kNothingLeft;
    fault.cycle = 499U;
    const Outcome outcome = session.Runs().Run(fault);
    // Then its permit lacks what the kernel's has
    EXPECT_EQ(outcome.result, Class::kDetected);
    EXPECT_EQ(outcome.detector, Detector::kComparator) << WordOf(outcome.detector);
    // When its second one is, which does not come, then nothing happens
    fault.subject += 1U;
    EXPECT_EQ(session.Runs().Run(fault).result, Class::kMasked);
}
} // namespace
} // namespace counterpoint::campaign::test
