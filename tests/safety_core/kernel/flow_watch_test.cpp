// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The calls of the flow monitor in the real kernel, and what a cycle with one wrong mark leads to.
#include "tests/safety_core/kernel/flow_tap.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>
#include <string>
#include <tuple>
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
class GivenFlow : protected FlowTapHolder, public Rig
{
  protected:
    GivenFlow() : Rig{nullptr, &flow}
    {
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

/// What is wrong, and with the mark of which step.
using SpoiledMark = std::tuple<MarkFault, std::uint8_t>;

class GivenFlowSpoiled : public GivenFlow, public ::testing::WithParamInterface<SpoiledMark>
{
};

TEST_P(GivenFlowSpoiled, IsAWrongAnswerAndADeviceFaultInTheSameCycle)
{
    Verifies(req::SRS_KRN_039);
    // Given a released pair
    Operate();
    ReceivePair();
    Cycles(2U);
    ASSERT_EQ(Open(), 1U);
    ASSERT_TRUE(WatchdogAlive());
    ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // When one mark of one cycle is wrong
    flow.fault = std::get<MarkFault>(GetParam());
    flow.at = static_cast<FlowStep>(std::get<std::uint8_t>(GetParam()));
    Cycle();
    flow.fault = MarkFault::kNone;
    // Then the answer is wrong, and it is the device fault; from the next cycle on no output is open
    EXPECT_FALSE(WatchdogAlive());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kFlow);
    EXPECT_EQ(application.faults, std::vector<DeviceFault>{DeviceFault::kFlow});
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

std::string NameOf(const ::testing::TestParamInfo<SpoiledMark>& info)
{
    return "Step" + std::to_string(std::get<std::uint8_t>(info.param));
}

INSTANTIATE_TEST_SUITE_P(LeftOut, GivenFlowSpoiled,
                         ::testing::Combine(::testing::Values(MarkFault::kLeftOut),
                                            ::testing::Range<std::uint8_t>(1U, 12U)),
                         NameOf);
INSTANTIATE_TEST_SUITE_P(Doubled, GivenFlowSpoiled,
                         ::testing::Combine(::testing::Values(MarkFault::kDoubled),
                                            ::testing::Range<std::uint8_t>(1U, 12U)),
                         NameOf);
// Step n with step n + 1.
INSTANTIATE_TEST_SUITE_P(Swapped, GivenFlowSpoiled,
                         ::testing::Combine(::testing::Values(MarkFault::kSwapped),
                                            ::testing::Range<std::uint8_t>(1U, 11U)),
                         NameOf);
INSTANTIATE_TEST_SUITE_P(OtherEvidence, GivenFlowSpoiled,
                         ::testing::Combine(::testing::Values(MarkFault::kOtherEvidence),
                                            ::testing::Range<std::uint8_t>(1U, 12U)),
                         NameOf);

} // namespace
} // namespace counterpoint
