// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <memory>

namespace counterpoint
{
namespace
{

class Cycling : public Rig
{
};

TEST_F(Cycling, GoodPairIsReleasedOnBothSidesAndOpensTheOutput)
{
    Verifies(req::SRS_KRN_002);
    Verifies(req::SRS_KRN_005);
    Verifies(req::SRS_KRN_340);
    Operate();
    // Given the safe value before the first pair
    EXPECT_EQ(NormalOut(), 0x7F01U);
    EXPECT_EQ(InverseOut(), 0x80FEU);
    EXPECT_EQ(Open(), 0U);
    // When a pair arrives and a cycle follows
    ReceivePair();
    Cycle();
    // Then A has written the normal object, B the inverse one, and three permits open the output of slot 0 alone
    EXPECT_EQ(NormalOut(), 0x3412U);
    EXPECT_EQ(InverseOut(), 0xCBEDU);
    EXPECT_EQ(Open(), 1U);
    ASSERT_EQ(application.events.size(), 1U);
    EXPECT_EQ(application.events[0], 0x1301U);
    EXPECT_TRUE(WatchdogAlive());
}

TEST_F(Cycling, PermitOfTheKernelIsTheFormulaOverTheEcho)
{
    Verifies(req::SRS_KRN_005);
    Operate();
    ReceivePair();
    Cycle();
    const std::uint32_t challenge = kernel.LastVerdict().echo;
    EXPECT_EQ(output.last.kernel.mask, 1U);
    EXPECT_EQ(output.last.kernel.response, static_cast<std::uint32_t>((challenge + 1U) * 0xC2B2AE3DU));
}

// SCT 50 ms: pair at 6.1 ms, no further frame
TEST_F(Cycling, MissingPairTakesTheSafeValueAndTellsTheCauseOnce)
{
    Verifies(req::SRS_KRN_006);
    Operate();
    ReceivePair();
    Cycles(50U);
    EXPECT_EQ(Open(), 1U);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(NormalOut(), 0x7F01U);
    EXPECT_EQ(InverseOut(), 0x80FEU);
    Cycles(10U);
    EXPECT_EQ(CausesOf(0x1301U), std::vector<SrdoCause>{SrdoCause::kSct});
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).first_cause, SrdoCause::kSct);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Cycling, EachReleasedPairIsAnEvent)
{
    Verifies(req::SRS_KRN_340);
    Operate();
    for (std::uint32_t pair = 0U; pair < 3U; ++pair)
    {
        ReceivePair();
        Cycle();
        Cycle();
    }
    EXPECT_EQ(application.events.size(), 3U);
}

TEST_F(Cycling, InterlockedReleaseByAcknowledgeIsAnEvent)
{
    Verifies(req::SRS_REL_004);
    Verifies(req::SRS_KRN_340);
    setups[0].policy = ReleasePolicy::kInterlock;
    Operate();
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_TRUE(application.events.empty());
    Cycle();
    Cycle(1U);
    EXPECT_EQ(Open(), 0U);
    Cycle(1U);
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(application.events.size(), 1U);
}

TEST_F(Cycling, OneChannelsAcknowledgeAloneReleasesNothingAndIsDemoted)
{
    Verifies(req::SRS_CMP_008);
    Verifies(req::SRS_CMP_340);
    Verifies(req::SRS_CMP_341);
    config.acknowledge_window_us = 5000U;
    setups[0].policy = ReleasePolicy::kInterlock;
    Operate();
    ReceivePair();
    Cycle();
    for (std::uint32_t cycle = 0U; cycle < 8U; ++cycle)
    {
        now_us += 1000U;
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 1U, 0U});
        EXPECT_EQ(Open(), 0U);
    }
    EXPECT_EQ(kernel.DemotionCount(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kFaulted);
}

TEST_F(Cycling, OverflowMakesEveryConsumerSafe)
{
    Verifies(req::SRS_KRN_009);
    Operate();
    ReceivePair();
    Cycle();
    kernel.OnOverflow();
    Cycle();
    EXPECT_EQ(Open(), 0U);
    ASSERT_EQ(application.errors.size(), 1U);
    EXPECT_EQ(application.errors[0].second, SrdoCause::kQueueOverflow);
    // Both channels were told, in that cycle alone, and neither had to be demoted
    EXPECT_EQ(a.last_input.queue, QueueState::kOverflowed);
    EXPECT_EQ(b.last_input.queue, QueueState::kOverflowed);
    EXPECT_EQ(kernel.DemotionCount(), 0U);
    // and it is over with the next pair
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(a.last_input.queue, QueueState::kIntact);
    EXPECT_EQ(b.last_input.queue, QueueState::kIntact);
}

TEST_F(Cycling, FramesReachBothChannelsUnchangedInTheOrderGiven)
{
    Verifies(req::SRS_KRN_007);
    Operate();
    a.keep_frames = true;
    b.keep_frames = true;
    // Given frames of several kinds and lengths, one with bytes behind its length, by counters 7 us apart
    const CanFrame frames[] = {
        {0x101U, FrameKind::kData, CanPortId::kFirst, 2U, {0x12U, 0x34U, 0x56U, 0U, 0U, 0U, 0U, 0x78U}},
        {0x7FFU, FrameKind::kRemote, CanPortId::kSecond, 8U, {}},
        {0x1FFFFFFFU, FrameKind::kExtended, CanPortId::kSecond, 8U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}},
        {0x101U, FrameKind::kData, CanPortId::kFirst, 0U, {}}};
    std::uint32_t stamp_us = now_us;
    for (const CanFrame& frame : frames)
    {
        stamp_us += 50U;
        kernel.OnFrame(StampedFrame{frame, InstantPair{{stamp_us}, {stamp_us + 7U}}});
    }
    // Then each channel was handed them one by one, each with the stamp of its own counter
    for (const Tap* const tap : {&a, &b})
    {
        ASSERT_EQ(tap->heard.size(), 4U);
        for (std::uint32_t number = 0U; number < 4U; ++number)
        {
            const CanFrame& given = frames[number];
            const auto& [frame, stamp] = tap->heard[number];
            EXPECT_EQ(frame.identifier, given.identifier) << number;
            EXPECT_EQ(frame.kind, given.kind) << number;
            EXPECT_EQ(frame.port, given.port) << number;
            EXPECT_EQ(frame.length_bytes, given.length_bytes) << number;
            EXPECT_TRUE(std::equal(std::begin(frame.data), std::end(frame.data), std::begin(given.data))) << number;
            EXPECT_EQ(stamp.us, 6050U + (50U * number) + ((tap == &a) ? 0U : 7U)) << number;
        }
    }
}

TEST_F(Cycling, FrameGoesToBothChannelsEachWithItsOwnStamp)
{
    Verifies(req::SRS_KRN_007);
    Verifies(req::SRS_TIME_002);
    Operate();
    // Given counters 150 us apart, an inverse frame exactly at SRVT by A's stamps and 1 us late by B's
    Cycle();
    ASSERT_EQ(now_us, 7000U);
    kernel.OnFrame(StampedFrame{CanFrame{0x101U, FrameKind::kData, CanPortId::kFirst, 2U, {0x12U, 0x34U}},
                                InstantPair{{7000U}, {7000U}}});
    for (std::uint32_t cycle = 0U; cycle < 19U; ++cycle)
    {
        Cycle();
    }
    kernel.OnFrame(StampedFrame{CanFrame{0x102U, FrameKind::kData, CanPortId::kFirst, 2U, {0xEDU, 0xCBU}},
                                InstantPair{{27000U}, {27001U}}});
    now_us = 27500U;
    kernel.Cycle(CycleCall{InstantPair{{27500U}, {27500U}}, 0U, 0U});
    // Then B's fault (and the inverse frame that is first for B then) makes the SRDO safe, A is demoted
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DemotionCount(), 1U);
    const StateReply reply = kernel.GetState(CommunicationIndex{0x1301U});
    EXPECT_EQ(reply.state, SrdoState::kFaulted);
    EXPECT_EQ(reply.first_cause, SrdoCause::kSrvt);
    EXPECT_EQ(CausesOf(0x1301U), (std::vector<SrdoCause>{SrdoCause::kSrvt, SrdoCause::kInverseFirst}));
}

TEST_F(Cycling, GfcMakesConsumersSafeAndIsTold)
{
    Verifies(req::SRS_CONS_017);
    Verifies(req::SRS_KRN_341);
    Operate();
    ReceivePair();
    Cycle();
    Receive(0x001U, {}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(application.gfcs, 1);
    // Given 1300h = 0, a length other than 0, or a remote frame, nothing happens
    ReceivePair();
    Cycle();
    Receive(0x001U, {0U}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    CanFrame remote{};
    remote.identifier = 1U;
    remote.kind = FrameKind::kRemote;
    remote.port = CanPortId::kFirst;
    now_us += 100U;
    kernel.OnFrame(StampedFrame{remote, InstantPair{{now_us}, {now_us}}});
    Cycle();
    ASSERT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    Receive(0x001U, {}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(application.gfcs, 1);
}

TEST_F(Cycling, GfcOutsideOperationalOrWithoutConfigurationIsNotTold)
{
    Verifies(req::SRS_KRN_341);
    Configure();
    Cycle();
    Receive(0x001U, {}, 100U);
    Cycle();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    Receive(0x001U, {}, 100U);
    Cycle();
    EXPECT_EQ(application.gfcs, 0);
}

TEST_F(Cycling, GfcCountsByTheStateInWhichItCame)
{
    Verifies(req::SRS_KRN_341);
    // Given one that came before OPERATIONAL was entered
    Configure();
    Cycle();
    Receive(0x001U, {}, 100U);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    EXPECT_EQ(application.gfcs, 0);
    // and one that came before OPERATIONAL was left
    Receive(0x001U, {}, 100U);
    kernel.SetNmtState(NmtState::kPreOperational);
    Cycle();
    EXPECT_EQ(application.gfcs, 1);
    Cycle();
    EXPECT_EQ(application.gfcs, 1);
}

TEST_F(Cycling, LeavingOperationalIsSafeWithItsOwnCause)
{
    Verifies(req::SRS_CONS_019);
    Verifies(req::SRS_KRN_010);
    Operate();
    ReceivePair();
    Cycle();
    kernel.SetNmtState(NmtState::kPreOperational);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(NormalOut(), 0x7F01U);
    ASSERT_EQ(application.errors.size(), 1U);
    EXPECT_EQ(application.errors[0].second, SrdoCause::kNotOperational);
}

TEST_F(Cycling, FlowEventsHaveTheCountsOfTheCycle)
{
    Verifies(req::SRS_FLOW_004);
    Verifies(req::SRS_FLOW_340);
    Verifies(req::SRS_FLOW_341);
    Configure();
    Cycle();
    // Not OPERATIONAL: exactly one event
    ASSERT_EQ(application.flow.size(), 1U);
    EXPECT_EQ(application.flow[0], std::make_pair(FlowEvent::kNotOperational, std::uint16_t{1U}));
    kernel.SetNmtState(NmtState::kOperational);
    application.flow.clear();
    ReceivePair();
    Cycle();
    Cycle();
    // Not yet released: the frames came before SRDOs were active
    application.flow.clear();
    ReceivePair();
    Cycle();
    const std::vector<std::pair<FlowEvent, std::uint16_t>> expected{{FlowEvent::kSctChecked, std::uint16_t{1U}},
                                                                    {FlowEvent::kItIsTx, std::uint16_t{1U}},
                                                                    {FlowEvent::kItIsInvalid, std::uint16_t{1U}},
                                                                    {FlowEvent::kSrdoReceived, std::uint16_t{1U}}};
    EXPECT_EQ(application.flow, expected);
    application.flow.clear();
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    EXPECT_EQ(application.flow.back(), std::make_pair(FlowEvent::kSrdoError, std::uint16_t{1U}));
}

// 64 consumers with four causes each: 256 errors in one cycle
TEST_F(Cycling, FlowEventOfErrorsCountsBeyondAByte)
{
    Verifies(req::SRS_FLOW_340);
    std::array<SrdoSetup, 64> many{};
    for (std::uint8_t slot = 0U; slot < 64U; ++slot)
    {
        many[slot].number = static_cast<std::uint8_t>(slot + 1U);
    }
    config.srdos = many.data();
    config.srdo_count = 64U;
    config.diagnostic_interval_us = 1000000U;
    const auto many_a = std::make_unique<channel_a::StorageFor<64U>>();
    const auto many_b = std::make_unique<channel_b::StorageFor<64U>>();
    channel_a::Channel channel_a{many_a->Handle()};
    channel_b::Channel channel_b{many_b->Handle()};
    Tap tap_a{channel_a};
    Tap tap_b{channel_b};
    Kernel wide{KernelParts{tap_a, tap_b, ports, output, watchdog, application}};
    ASSERT_EQ(wide.Start(config, FlowCallback::kOn), StartResult::kStarted);
    tap_b.on_outcome = [](CycleOutcome& outcome) { outcome.signalled = ~SrdoMask{0U}; };
    tap_b.more_signals = 0x1EU;
    wide.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
    EXPECT_EQ(application.errors.size(), 256U);
    ASSERT_FALSE(application.flow.empty());
    EXPECT_EQ(application.flow.back(), std::make_pair(FlowEvent::kSrdoError, std::uint16_t{256U}));
}

TEST_F(Cycling, OptionRemovesTheCallbackAndNotTheMonitor)
{
    Verifies(req::SRS_FLOW_342);
    Operate();
    kernel.SetNmtState(NmtState::kPreOperational);
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    application.flow.clear();
    now_us += 500U;
    watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
    Cycles(5U);
    EXPECT_TRUE(application.flow.empty());
    EXPECT_TRUE(WatchdogAlive());
    a.skip_cycle = true;
    Cycle();
    EXPECT_FALSE(WatchdogAlive());
}

TEST_F(Cycling, WithoutTheOptionNoEventIsDeliveredOfPairsAndErrorsEither)
{
    Verifies(req::SRS_FLOW_342);
    flow_callback = FlowCallback::kOff;
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    ASSERT_FALSE(application.errors.empty());
    ConfirmLast();
    ConfirmLast();
    Cycle();
    ASSERT_EQ(application.events.size(), 2U);
    EXPECT_TRUE(application.flow.empty());
}

TEST_F(Cycling, OneFlowEventInEachStateOutsideOfOperational)
{
    Verifies(req::SRS_FLOW_004);
    for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped})
    {
        Operate();
        kernel.SetNmtState(state);
        Cycle();
        application.flow.clear();
        Cycles(2U);
        const std::vector<std::pair<FlowEvent, std::uint16_t>> expected{
            {FlowEvent::kNotOperational, std::uint16_t{1U}}, {FlowEvent::kNotOperational, std::uint16_t{1U}}};
        EXPECT_EQ(application.flow, expected);
    }
}

} // namespace
} // namespace counterpoint
