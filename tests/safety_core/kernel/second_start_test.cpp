// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Nothing of the time before is left over when a kernel is started again.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class SecondStart : public Rig
{
  public:
    /// Configures and operates anew, at the present time.
    void StartAgain()
    {
        watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
        application.errors.clear();
        application.events.clear();
        application.flow.clear();
        a.requests = 0U;
        ports.sent.clear();
        Operate();
    }
    void RunsWell()
    {
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_EQ(kernel.DeviceState().count, 0U);
        EXPECT_EQ(Open(), 0U);
        EXPECT_TRUE(CausesOf(0x1301U).empty());
        ReceivePair();
        Cycle();
        EXPECT_EQ(Open(), 1U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        EXPECT_TRUE(WatchdogAlive());
    }
};

TEST_F(SecondStart, ForgetsWhatWasAskedFor)
{
    Verifies(req::SRS_KRN_025);
    // Given a request, a GFC that nothing followed, one that was received, and lost frames, all not yet looked at
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Receive(0x001U, {}, 10U);
    kernel.OnOverflow();
    // When the kernel is started again and runs for longer than the GFC had to be followed, then none of it shows
    StartAgain();
    RunsWell();
    Cycles(24U);
    EXPECT_EQ(a.requests, 0U);
    EXPECT_EQ(application.gfcs, 0);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    EXPECT_TRUE(CausesOf(0x1301U).empty());
}

TEST_F(SecondStart, ForgetsDemotionsStatusAndErrors)
{
    Verifies(req::SRS_KRN_025);
    Operate();
    b.on_outcome = [](CycleOutcome& outcome) { outcome.new_fault = 1U; };
    Cycles(3U);
    b.on_outcome = nullptr;
    EXPECT_EQ(kernel.DemotionCount(), 3U);
    ASSERT_EQ(kernel.SetStatus(CommunicationIndex{0x1304U}, StatusByte{0x90U}), Result::kSuccessful);
    Receive(0x101U, {0x12U}, 100U); // Wrong length
    Cycle();
    EXPECT_NE(kernel.GetState(CommunicationIndex{0x1301U}).error_count, 0U);
    StartAgain();
    EXPECT_EQ(kernel.DemotionCount(), 0U);
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1304U}).status.value, 0x30U);
    EXPECT_EQ(kernel.GetStatus(CommunicationIndex{0x1301U}).status.value, 0x30U);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).error_count, 0U);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kNone);
    RunsWell();
}

TEST_F(SecondStart, ForgetsTheDeviceFaultAndTellsTheNextOne)
{
    Verifies(req::SRS_KRN_003);
    Verifies(req::SRS_KRN_025);
    Verifies(req::SRS_KRN_342);
    Operate();
    kernel.DemandSafeState();
    kernel.DemandSafeState();
    Cycle();
    EXPECT_EQ(application.faults, std::vector<DeviceFault>{DeviceFault::kApplication});
    StartAgain();
    RunsWell();
    a.skip_cycle = true;
    Cycle();
    EXPECT_EQ(application.faults, (std::vector<DeviceFault>{DeviceFault::kApplication, DeviceFault::kDisagreement}));
    EXPECT_EQ(kernel.DeviceState().count, 2U); // The channels differ, and the flow is another one.
}

TEST_F(SecondStart, ForgetsTheTimesOfBothCounters)
{
    Verifies(req::SRS_KRN_025);
    Verifies(req::SRS_CLK_001);
    Verifies(req::SRS_CLK_002);
    // Given two counters that run together
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    // When the kernel is started again seconds later, by counters that meanwhile stand 3 s apart, then it is no late
    // call, no drift, and no frame out of order
    constexpr std::uint32_t kApartUs = 3000000U;
    now_us += 7000000U;
    Configure();
    kernel.SetNmtState(NmtState::kOperational);
    for (std::uint32_t cycle = 0U; cycle < 150U; ++cycle)
    {
        now_us += 1000U;
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us - kApartUs}}, 0U, 0U});
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << cycle;
    }
    // And an earlier time than before is none either
    now_us = 1000U;
    Configure();
    for (std::uint32_t cycle = 0U; cycle < 150U; ++cycle)
    {
        Cycle();
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << cycle;
    }
}

TEST_F(SecondStart, ForgetsWhatTheChannelsDifferedIn)
{
    Verifies(req::SRS_CMP_007);
    Verifies(req::SRS_KRN_025);
    // Given a pair that one channel alone has, 4 of 5 ms old
    Operate();
    b.drop_frames = true;
    ReceivePair();
    Cycles(4U);
    ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    b.drop_frames = false;
    // When the kernel is started again, then nothing matched in its first cycle, and a new difference has 5 ms of its
    // own
    StartAgain();
    EXPECT_EQ(kernel.LastVerdict().newly_matched, 0U);
    b.drop_frames = true;
    ReceivePair();
    Cycles(5U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kUnmatched);
}

TEST_F(SecondStart, ForgetsTheConfiguration)
{
    Verifies(req::SRS_KRN_025);
    Verifies(req::SRS_CFG_002);
    Operate();
    ASSERT_EQ(Read(0x13FEU, 0U), 0xA5U);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(Read(0x1301U, 1U), 0U);
    EXPECT_EQ(Read(0x1303U, 1U), 0U);
    EXPECT_EQ(Read(0x1381U, 0U), 0U);
    EXPECT_EQ(Read(0x1383U, 0U), 0U);
    EXPECT_EQ(Read(0x13FFU, 1U), 0U);
    EXPECT_EQ(Read(0x13FFU, 3U), 0U);
    // Not OPERATIONAL any more: what that state forbids is allowed, and no SRDO is sent
    EXPECT_EQ(Write(0x1301U, 2U, 60U, 2U), AbortCode::kNone);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kNmtError);
    const std::size_t sent = ports.sent.size();
    Cycles(60U);
    EXPECT_EQ(ports.sent.size(), sent);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(SecondStart, ForgetsAPairThatWasBeingSent)
{
    Verifies(req::SRS_KRN_214);
    Verifies(req::SRS_KRN_025);
    // Given a normal frame on its way
    Operate();
    while (ports.sent.empty())
    {
        Cycle();
    }
    ASSERT_EQ(ports.sent.back().identifier, 0x103U);
    const CanFrame normal = ports.sent.back();
    // When it is confirmed after the next start, then no inverse frame follows and nothing is told
    StartAgain();
    ports.sent.clear();
    now_us += 100U;
    kernel.OnConfirm(StampedFrame{normal, InstantPair{{now_us}, {now_us}}});
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_TRUE(application.events.empty());
}

TEST_F(SecondStart, ForgetsWhatThatFlowAndHandshakeWereAskedFor)
{
    Verifies(req::SRS_KRN_025);
    Verifies(req::SRS_KRN_022);
    Verifies(req::SRS_FLOW_342);
    Verifies(req::SRS_KRN_344);
    // Given a kernel with flow events, and a handshake that the application owes an answer to
    handshake = StatusHandshake::kRequired;
    Operate();
    ReceivePair();
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    ASSERT_FALSE(CausesOf(0x1301U).empty());
    EXPECT_FALSE(application.flow.empty());
    // When it is started again without both, then neither is asked for
    handshake = StatusHandshake::kOff;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    application.flow.clear();
    Cycles(5U);
    EXPECT_TRUE(application.flow.empty());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    // And with the handshake again, the debt of before is forgotten
    handshake = StatusHandshake::kRequired;
    StartAgain();
    Cycles(5U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

} // namespace
} // namespace counterpoint
