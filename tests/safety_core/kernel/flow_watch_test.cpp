// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The calls of the flow monitor in the real kernel, and what a cycle with one wrong mark leads to.
#include "tests/safety_core/kernel/comparator_test_hooks.hpp"
#include "tests/safety_core/kernel/mark_tap.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint
{
namespace
{

/// The parts name no watch.
class OwnFlow : public Rig
{
};

/// They name a tap.
class GivenFlow : protected MarkTapHolder, public Rig
{
  protected:
    GivenFlow() : Rig{nullptr, &flow}
    {
    }
    /// The mark of this step in the present cycle.
    FlowEvidence Of(const FlowStep step) const
    {
        return flow.evidences.at(static_cast<std::size_t>(step) - 1U);
    }
    void Has(const FlowStep step, const std::uint32_t observed, const std::uint32_t expected) const
    {
        EXPECT_EQ(Of(step).observed, observed) << static_cast<std::uint32_t>(step);
        EXPECT_EQ(Of(step).expected, expected) << static_cast<std::uint32_t>(step);
    }
};

TEST_F(OwnFlow, AnswersTheWatchdogCycleByCycle)
{
    Verifies(req::SRS_KRN_039);
    Operate();
    ReceivePair();
    Cycles(20U);
    EXPECT_TRUE(WatchdogAlive());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(Open(), 1U);
    // And the mark of a cycle that comes while a frame is not yet with both channels has other evidence
    b.on_frame = [this]() { Cycle(); };
    Receive(0x700U, {1U});
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow);
    EXPECT_FALSE(WatchdogAlive());
}

TEST_F(GivenFlow, IsCalledForEveryStepOfACycleInItsOrder)
{
    Verifies(req::SRS_KRN_002);
    Verifies(req::SRS_KRN_039);
    // Given a kernel that was started, and no cycle yet
    Configure();
    EXPECT_EQ(flow.begun, 0U);
    EXPECT_EQ(flow.asked, 0U);
    // When 20 cycles run
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(20U);
    // Then each began, ended and asked for the finding once, and the last one had these marks
    EXPECT_EQ(flow.begun, 20U);
    EXPECT_EQ(flow.ended, 20U);
    EXPECT_EQ(flow.asked, 20U);
    EXPECT_EQ(flow.steps,
              (std::vector<FlowStep>{FlowStep::kSelfTest, FlowStep::kClocks, FlowStep::kGuard, FlowStep::kChannelA,
                                     FlowStep::kChannelB, FlowStep::kComparison, FlowStep::kDemotion,
                                     FlowStep::kProduction, FlowStep::kCommit, FlowStep::kEvents, FlowStep::kPermits}));
    EXPECT_TRUE(WatchdogAlive());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// Calls of A and B, demotions, frames handed over, commits, events, slots of the permit when each step is marked.
TEST_F(GivenFlow, StepsTakeEffectInTheirOrder)
{
    Verifies(req::SRS_KRN_002);
    Operate();
    // Given a pair to be released, a producer that is due, and a fault of slot 2 in channel A alone
    ReceivePair();
    std::array<std::uint32_t, 2> calls{};
    std::uint32_t commits = 0U;
    a.on_outcome = [&calls](CycleOutcome& outcome)
    {
        ++calls[0];
        outcome.new_fault = 4U;
    };
    b.on_outcome = [&calls](CycleOutcome&) { ++calls[1]; };
    a.on_committed = [&commits]() { ++commits; };
    b.on_committed = a.on_committed;
    using Effects = std::array<std::uint32_t, 7>;
    std::vector<Effects> seen;
    flow.on_step = [this, &calls, &commits, &seen](FlowStep)
    {
        EXPECT_EQ(flow.ended, 1U); // The answer to the watchdog is the last of all.
        seen.push_back(Effects{calls[0], calls[1], static_cast<std::uint32_t>(a.demotions + b.demotions),
                               static_cast<std::uint32_t>(ports.sent.size()), commits,
                               static_cast<std::uint32_t>(application.events.size()),
                               static_cast<std::uint32_t>(output.last.kernel.mask)});
    };
    Cycle();
    flow.on_step = nullptr;
    EXPECT_EQ(flow.ended, 2U);
    EXPECT_EQ(seen, (std::vector<Effects>{{0U, 0U, 0U, 0U, 0U, 0U, 0U},
                                          {0U, 0U, 0U, 0U, 0U, 0U, 0U},
                                          {0U, 0U, 0U, 0U, 0U, 0U, 0U},
                                          {1U, 0U, 0U, 0U, 0U, 0U, 0U},
                                          {1U, 1U, 0U, 0U, 0U, 0U, 0U},
                                          {1U, 1U, 0U, 0U, 0U, 0U, 0U},
                                          {1U, 1U, 2U, 0U, 0U, 0U, 0U},
                                          {1U, 1U, 2U, 1U, 0U, 0U, 0U},
                                          {1U, 1U, 2U, 1U, 2U, 0U, 0U},
                                          {1U, 1U, 2U, 1U, 2U, 1U, 0U},
                                          {1U, 1U, 2U, 1U, 2U, 1U, 1U}}));
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(GivenFlow, IsGivenWhatEachStepProducedAndWhatItMust)
{
    Verifies(req::SRS_FLOW_001);
    Verifies(req::SRS_CMP_001);
    // Given cycle 2 with cycle numbers of the channels, and one SRDO more in B's counts, that are not right
    Operate();
    a.on_outcome = [](CycleOutcome& outcome) { outcome.cycle = 7U; };
    b.on_outcome = [](CycleOutcome& outcome)
    {
        outcome.cycle = 9U;
        ++outcome.is_tx;
    };
    Cycle();
    Has(FlowStep::kChannelA, 7U, 2U);
    Has(FlowStep::kChannelB, 9U, 2U);
    Has(FlowStep::kEvents, 4U, 3U);
    // outside of OPERATIONAL all three are passed over at once
    b.on_outcome = [](CycleOutcome& outcome) { outcome.not_operational = 2U; };
    kernel.SetNmtState(NmtState::kPreOperational);
    Cycle();
    Has(FlowStep::kEvents, 6U, 3U);
    // and a comparator that was not called gives no challenge back
    comparator_calls = ComparatorCalls::kNotCalled;
    Cycle();
    comparator_calls = ComparatorCalls::kReal;
    EXPECT_EQ(Of(FlowStep::kComparison).observed, 0U);
    EXPECT_NE(Of(FlowStep::kComparison).expected, 0U);
}

TEST_F(GivenFlow, IsGivenTheMarkOfAFrameOnItsWay)
{
    Verifies(req::SRS_KRN_034);
    // Given frames from 0 on, of which 001h is the GFC
    for (const std::uint32_t identifier : {0x000U, 0x001U, 0x700U})
    {
        Operate();
        b.on_frame = [this]() { Cycle(); };
        Receive(identifier, {});
        b.on_frame = nullptr;
        Has(FlowStep::kClocks, identifier + 1U, 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow);
    }
}

/// What is wrong with the mark of a step, and the last step of which it can be wrong.
struct SpoiledMark
{
    MarkFault fault;
    std::uint8_t last;
};

class GivenFlowSpoiled : public GivenFlow, public ::testing::WithParamInterface<SpoiledMark>
{
};

TEST_P(GivenFlowSpoiled, IsAWrongAnswerAndADeviceFaultInTheSameCycle)
{
    Verifies(req::SRS_KRN_229);
    for (std::uint8_t step = 1U; step <= GetParam().last; ++step)
    {
        // Given a released pair
        now_us += 2000U;
        watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
        application.faults.clear();
        Operate();
        ReceivePair();
        Cycles(2U);
        ASSERT_EQ(Open(), 1U);
        ASSERT_TRUE(WatchdogAlive());
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        // When one mark of one cycle is wrong
        flow.fault = GetParam().fault;
        flow.at = static_cast<FlowStep>(step);
        Cycle();
        flow.fault = MarkFault::kNone;
        // Then the answer is wrong, and it is the device fault; from the next cycle on no output is open
        EXPECT_FALSE(WatchdogAlive()) << "step " << static_cast<int>(step);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow) << "step " << static_cast<int>(step);
        EXPECT_EQ(application.faults, std::vector<DeviceFault>{DeviceFault::kFlow});
        Cycle();
        EXPECT_EQ(Open(), 0U) << "step " << static_cast<int>(step);
    }
}

// Of two that are swapped, the second one is the last one.
INSTANTIATE_TEST_SUITE_P(EachStep, GivenFlowSpoiled,
                         ::testing::Values(SpoiledMark{MarkFault::kLeftOut, 11U}, SpoiledMark{MarkFault::kDoubled, 11U},
                                           SpoiledMark{MarkFault::kSwapped, 10U},
                                           SpoiledMark{MarkFault::kOtherEvidence, 11U}));

} // namespace
} // namespace counterpoint
