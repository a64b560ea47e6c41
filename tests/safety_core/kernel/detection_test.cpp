// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstring>

namespace counterpoint
{
namespace
{

/// Released and open; what follows must close it in the same cycle.
class Detection : public Rig
{
  public:
    void Release()
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(Open(), 1U);
    }

    void IsDeviceSafe(const DeviceFault fault)
    {
        EXPECT_EQ(kernel.DeviceState().fault, fault);
        EXPECT_EQ(Open(), 0U);
        EXPECT_EQ(NormalOut(), 0x7F01U);
        ASSERT_EQ(application.faults.size(), 1U);
        EXPECT_EQ(application.faults[0], fault);
    }
};

TEST_F(Detection, SkippedChannelAIsFoundAtOnce)
{
    Verifies(req::SRS_CMP_002);
    Verifies(req::SRS_KRN_004);
    Release();
    a.skip_cycle = true;
    Cycle();
    IsDeviceSafe(DeviceFault::kDisagreement);
    EXPECT_FALSE(WatchdogAlive());
}

TEST_F(Detection, SkippedChannelBIsFoundAtOnce)
{
    Verifies(req::SRS_CMP_002);
    Release();
    b.skip_cycle = true;
    Cycle();
    IsDeviceSafe(DeviceFault::kDisagreement);
}

TEST_F(Detection, ChannelWithoutFramesIsFoundWithinTheDiscrepancyTime)
{
    Verifies(req::SRS_CMP_007);
    Release();
    b.drop_frames = true;
    ReceivePair();
    Cycles(5U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    Cycle();
    IsDeviceSafe(DeviceFault::kUnmatched);
}

TEST_F(Detection, WrongDataOfAChannelIsFoundAtOnce)
{
    Verifies(req::SRS_CMP_006);
    Release();
    a.data_flip = 0x80U;
    ReceivePair();
    Cycle();
    IsDeviceSafe(DeviceFault::kDisagreement);
}

TEST_F(Detection, WrongPermitOfAChannelClosesTheOutput)
{
    Verifies(req::SRS_REL_010);
    Verifies(req::SRS_HAL_003);
    Release();
    b.permit_flip = 1U;
    Cycle();
    EXPECT_EQ(Open(), 0U);
    b.permit_flip = 0U;
    a.permit_flip = 0x80000000U;
    Cycle();
    EXPECT_EQ(Open(), 0U);
}

TEST_F(Detection, FaultOfOneChannelMakesTheOtherSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_004);
    Verifies(req::SRS_REL_006);
    Verifies(req::SRS_CMP_340);
    Release();
    b.on_outcome = [](CycleOutcome& outcome)
    {
        outcome.released = 0U;
        outcome.faulted = 1U;
        outcome.new_fault = 1U;
    };
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(NormalOut(), 0x7F01U);
    EXPECT_EQ(a.demotions, 1);
    EXPECT_EQ(b.demotions, 1);
    EXPECT_EQ(kernel.DemotionCount(), 1U);
    b.on_outcome = nullptr;
    // Both start again from ordinal 0: the next pair is released
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

// SRDO 1, which is released, and SRDO 3 in the same verdict.
TEST_F(Detection, EverySlotOfTheMaskIsDemotedInBothChannelsAndCounted)
{
    Verifies(req::SRS_CMP_340);
    // Given that channel B alone reports slots 0 and 1 as newly faulted
    Release();
    b.on_outcome = [](CycleOutcome& outcome) { outcome.new_fault = 3U; };
    // When that is compared
    Cycle();
    // Then each channel was called for each of them, in that cycle, and no more once they agree
    EXPECT_EQ(a.demotions, 2);
    EXPECT_EQ(b.demotions, 2);
    EXPECT_EQ(kernel.DemotionCount(), 2U);
    b.on_outcome = nullptr;
    Cycle();
    EXPECT_EQ(kernel.DemotionCount(), 2U);
}

TEST_F(Detection, DemotionsAreCountedUpToTheGreatestValue)
{
    Verifies(req::SRS_CMP_340);
    Operate();
    b.on_outcome = [](CycleOutcome& outcome) { outcome.new_fault = 1U; };
    for (std::uint32_t cycle = 0U; cycle < 65540U; ++cycle)
    {
        Cycle();
    }
    EXPECT_EQ(kernel.DemotionCount(), 65535U);
}

TEST_F(Detection, LateCallIsFoundAndLimitsAreStillExamined)
{
    Verifies(req::SRS_CLK_002);
    Release();
    now_us += 60000U;
    kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
    IsDeviceSafe(DeviceFault::kLateCall);
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kSct});
}

TEST_F(Detection, ClockOfOneChannelIsFound)
{
    Verifies(req::SRS_CLK_001);
    Release();
    now_us += 1000U;
    kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us + 201U}}, 0U, 0U});
    IsDeviceSafe(DeviceFault::kClock);
}

TEST_F(Detection, FrameOutOfOrderIsFound)
{
    Verifies(req::SRS_KRN_008);
    Release();
    kernel.OnFrame(StampedFrame{CanFrame{0x700U, FrameKind::kData, CanPortId::kFirst, 0U, {}},
                                InstantPair{{now_us - 1U}, {now_us - 1U}}});
    Cycle();
    IsDeviceSafe(DeviceFault::kFrameOrder);
}

TEST_F(Detection, ConfirmationOutOfOrderIsFound)
{
    Verifies(req::SRS_KRN_008);
    Release();
    kernel.OnConfirm(StampedFrame{CanFrame{0x700U, FrameKind::kData, CanPortId::kFirst, 0U, {}},
                                  InstantPair{{now_us - 1U}, {now_us}}});
    Cycle();
    IsDeviceSafe(DeviceFault::kFrameOrder);
}

TEST_F(Detection, ApplicationCanDemandTheSafeState)
{
    Verifies(req::SRS_KRN_003);
    Release();
    kernel.DemandSafeState();
    Cycle();
    IsDeviceSafe(DeviceFault::kApplication);
}

TEST_F(Detection, EachFieldOfTheComparatorsTestIsSeenFromOutside)
{
    Verifies(req::SRS_CMP_212);
    // Given the comparator tested without a pause, for all fifteen members and more than one round
    config.test_interval_us = 22500U;
    Release();
    for (std::uint32_t cycle = 0U; cycle < 40U; ++cycle)
    {
        Cycle();
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << "cycle " << cycle;
    }
    EXPECT_EQ(Open(), 1U);
}

TEST_F(Detection, NothingLeavesTheDeviceSafeStateButStart)
{
    Verifies(req::SRS_KRN_003);
    Verifies(req::SRS_KRN_004);
    Verifies(req::SRS_KRN_342);
    Release();
    a.skip_cycle = true;
    Cycle();
    a.skip_cycle = false;
    const std::size_t sent = ports.sent.size();
    for (std::uint32_t cycle = 0U; cycle < 100U; ++cycle)
    {
        ReceivePair();
        Cycle(cycle & 1U);
        EXPECT_EQ(Open(), 0U);
    }
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(ports.sent.size(), sent);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kDeviceFault);
    EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault);
    EXPECT_EQ(application.faults.size(), 1U);
    Release();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Detection, ChannelsGuardAndFlowMonitorGoOnInTheDeviceSafeState)
{
    Verifies(req::SRS_KRN_004);
    Release();
    kernel.DemandSafeState();
    Cycles(10U);
    // Then the channels are called as ever, and tell what they find
    EXPECT_EQ(a.last_input.now.us, now_us);
    EXPECT_EQ(b.last_input.now.us, now_us);
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kInverseFirst});
    EXPECT_TRUE(WatchdogAlive());
    EXPECT_EQ(kernel.DeviceState().count, 1U);
    // the guard finds a copy that has changed within the diagnostic interval
    const ConfigItem changed{ConfigAddress{2U, ConfigField::kSrvt, 0U}, 21U};
    real_a.Store(changed);
    real_b.Store(changed);
    Cycles(30U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(kernel.DeviceState().count, 2U);
    EXPECT_TRUE(WatchdogAlive());
    // and the flow monitor a channel that is left out
    a.skip_cycle = true;
    Cycle();
    EXPECT_FALSE(WatchdogAlive());
}

} // namespace
} // namespace counterpoint
