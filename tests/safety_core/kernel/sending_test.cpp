// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the application asks for: Send and the GFC.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace counterpoint
{
namespace
{

/// Node-ID 2: the first transmission comes 1 ms after entering OPERATIONAL.
class Sending : public Rig
{
  public:
    /// SRDO 1 or 4 as producer, signed; 13FEh is left to the test.
    void MakeProducer(const std::uint16_t number, const std::uint32_t cob_id, const std::uint32_t refresh_ms = 50U)
    {
        const std::uint16_t communication = static_cast<std::uint16_t>(0x1300U + number);
        const std::uint16_t mapping = static_cast<std::uint16_t>(0x1380U + number);
        ASSERT_EQ(Write(communication, 1U, 0U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 2U, refresh_ms, 2U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 5U, cob_id, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 6U, cob_id + 1U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 0U, 0U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 1U, 0x20000110U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 2U, 0x21000110U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 0U, 2U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 1U, 1U, 1U), AbortCode::kNone);
        const SignReply reply = kernel.Sign(CommunicationIndex{communication});
        ASSERT_EQ(Write(0x13FFU, static_cast<std::uint8_t>(number), reply.signature, 2U), AbortCode::kNone);
    }
};

TEST_F(Sending, SendReturnsTheReferencesCodes)
{
    Verifies(req::SRS_KRN_011);
    Configure();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1302U}), Result::kNotExist);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1300U}), Result::kNotExist);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1341U}), Result::kNotExist);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kNmtError);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kNmtError);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1301U}), Result::kRxTxConflict);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1304U}), Result::kInvalid);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kSuccessful);
    kernel.SetNmtState(NmtState::kPreOperational);
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kInvalidConfiguration);
}

TEST_F(Sending, SendToAllWithoutAProducerDoesNotExist)
{
    Verifies(req::SRS_KRN_011);
    Configure();
    ASSERT_EQ(Write(0x1303U, 1U, 0U, 1U), AbortCode::kNone);
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1303U});
    ASSERT_EQ(Write(0x13FFU, 3U, reply.signature, 2U), AbortCode::kNone);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kNotExist);
}

TEST_F(Sending, SendToAllSendsEveryProducerOnce)
{
    Verifies(req::SRS_KRN_011);
    Verifies(req::SRS_KRN_224);
    Verifies(req::SRS_PROD_003);
    setups[1].form = ProducerForm::kApplicationSends;
    Configure();
    MakeProducer(1U, 0x101U);
    MakeProducer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(2U);
    ASSERT_TRUE(ports.sent.empty());
    ASSERT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kSuccessful);
    Cycle();
    ASSERT_EQ(ports.sent.size(), 3U);
    EXPECT_EQ(ports.sent[0].identifier, 0x101U);
    EXPECT_EQ(ports.sent[1].identifier, 0x103U);
    EXPECT_EQ(ports.sent[2].identifier, 0x107U);
    Cycles(3U);
    EXPECT_EQ(ports.sent.size(), 3U);
}

TEST_F(Sending, FlowEventsCountConsumersProducersAndWhatIsOff)
{
    Verifies(req::SRS_FLOW_004);
    Verifies(req::SRS_FLOW_341);
    using Flow = std::vector<std::pair<FlowEvent, std::uint16_t>>;
    // Given a consumer and two producers
    Configure();
    MakeProducer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    application.flow.clear();
    Cycle();
    EXPECT_EQ(application.flow,
              (Flow{{FlowEvent::kSctChecked, std::uint16_t{1U}}, {FlowEvent::kItIsTx, std::uint16_t{2U}}}));
    // When the configuration is not valid, or OPERATIONAL is left, then there is one event of all three
    kernel.SetNmtState(NmtState::kPreOperational);
    ASSERT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    for (const NmtState state : {NmtState::kOperational, NmtState::kPreOperational})
    {
        kernel.SetNmtState(state);
        Cycle();
        application.flow.clear();
        Cycle();
        EXPECT_EQ(application.flow, (Flow{{FlowEvent::kNotOperational, std::uint16_t{1U}}}));
    }
    // Given that the consumer and one producer are off
    ASSERT_EQ(Write(0x1304U, 1U, 0U, 1U), AbortCode::kNone);
    for (const std::uint16_t number : {std::uint16_t{1U}, std::uint16_t{4U}})
    {
        const SignReply reply = kernel.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)});
        ASSERT_EQ(Write(0x13FFU, static_cast<std::uint8_t>(number), reply.signature, 2U), AbortCode::kNone);
    }
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    application.flow.clear();
    Cycle();
    EXPECT_EQ(application.flow,
              (Flow{{FlowEvent::kItIsTx, std::uint16_t{1U}}, {FlowEvent::kItIsInvalid, std::uint16_t{2U}}}));
}

TEST_F(Sending, FlowEventCountsThePairsSentBetweenTwoCycles)
{
    Verifies(req::SRS_FLOW_340);
    setups[1].form = ProducerForm::kApplicationSends;
    Configure();
    MakeProducer(1U, 0x101U);
    MakeProducer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(2U);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kSuccessful);
    Cycle();
    // Given three normal frames, when they and the inverse frames that follow them are confirmed
    for (std::size_t number = 0U; number < 6U; ++number)
    {
        ASSERT_GE(ports.sent.size(), number + 1U);
        now_us += 10U;
        const CanFrame frame = ports.sent[number];
        kernel.OnConfirm(StampedFrame{frame, InstantPair{{now_us}, {now_us}}});
    }
    application.flow.clear();
    Cycle();
    EXPECT_EQ(application.flow.back(), std::make_pair(FlowEvent::kSrdoTransmitted, std::uint16_t{3U}));
}

TEST_F(Sending, ApplicationSendsWhenItWants)
{
    Verifies(req::SRS_KRN_224);
    Verifies(req::SRS_PROD_003);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    Cycles(3U);
    EXPECT_TRUE(ports.sent.empty());
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_TRUE(application.refreshed.empty());
    EXPECT_EQ(a.requests, 2U);
    EXPECT_EQ(b.requests, 2U);
    // It was told once: nothing more is sent
    ConfirmLast();
    ConfirmLast();
    Cycles(3U);
    EXPECT_EQ(ports.sent.size(), 2U);
}

// t   request   OPERATIONAL left   entered   request   cycle outside of it   cycle in it ...
TEST_F(Sending, RequestSinceOperationalWasEnteredAgainIsSentWhateverCyclesSaw)
{
    Verifies(req::SRS_KRN_224);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    Cycles(3U);
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycle();
    EXPECT_EQ(a.requests | b.requests, 0U);
    Cycles(3U);
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(Sending, RequestBeforeOperationalWasLeftIsForgotten)
{
    Verifies(req::SRS_KRN_224);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    Cycles(3U);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(10U);
    EXPECT_TRUE(ports.sent.empty());
}

// Refresh time 25 ms: nothing is sent in the device safe state, and nothing is missed.
TEST_F(Sending, NoRefreshIsMissedInTheDeviceSafeState)
{
    Verifies(req::SRS_KRN_004);
    for (const ProducerForm form : {ProducerForm::kApplicationSends, ProducerForm::kProviderCalled})
    {
        setups[1].form = form;
        Operate();
        kernel.DemandSafeState();
        Cycles(200U);
        EXPECT_TRUE(CausesOf(0x1303U).empty());
        const StateReply reply = kernel.GetState(CommunicationIndex{0x1303U});
        EXPECT_EQ(reply.error_count, 0U);
        EXPECT_EQ(reply.first_cause, SrdoCause::kNone);
        EXPECT_TRUE(ports.sent.empty());
        EXPECT_EQ(a.requests, 0U);
    }
}

// t [us]   safe state, OPERATIONAL   0   999   1000 (first possible)   2499 (falls due; the next one is over)   3999
// ...
TEST_F(Sending, NoRefreshIsMissedInTheDeviceSafeStateHoweverTheCyclesLie)
{
    Verifies(req::SRS_KRN_004);
    Verifies(req::SRS_PROD_012);
    for (const ProducerForm form : {ProducerForm::kApplicationSends, ProducerForm::kProviderCalled})
    {
        setups[1].form = form;
        // Given a refresh time of 1 ms, and cycles of 1 ms with a tolerance of 0.5 ms
        Configure();
        ASSERT_EQ(Write(0x1303U, 1U, 0U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1303U, 2U, 1U, 2U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1303U, 1U, 1U, 1U), AbortCode::kNone);
        const SignReply signature = kernel.Sign(CommunicationIndex{0x1303U});
        ASSERT_EQ(Write(0x13FFU, 3U, signature.signature, 2U), AbortCode::kNone);
        ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
        // When OPERATIONAL is entered in the device safe state
        kernel.DemandSafeState();
        kernel.SetNmtState(NmtState::kOperational);
        Cycle();
        for (std::uint32_t cycle = 0U; cycle < 20U; ++cycle)
        {
            now_us += (cycle == 0U) ? 999U : 1500U;
            kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
        }
        // Then nothing is told, and nothing is sent
        EXPECT_TRUE(CausesOf(0x1303U).empty());
        EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1303U}).error_count, 0U);
        EXPECT_TRUE(ports.sent.empty());
    }
}

TEST_F(Sending, GfcLeavesByTheControllerOfTheNormalFrames)
{
    Verifies(req::SRS_KRN_013);
    config.normal_port = CanPortId::kSecond;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(ports.sent[0].port, CanPortId::kSecond);
}

TEST_F(Sending, GfcIsSentOnlyIfSupportedAndOperational)
{
    Verifies(req::SRS_KRN_013);
    Configure();
    EXPECT_EQ(kernel.SendGfc(), Result::kNmtError);
    kernel.SetNmtState(NmtState::kOperational);
    ASSERT_EQ(Write(0x1300U, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(kernel.SendGfc(), Result::kGfcUnsupported);
    ASSERT_EQ(Write(0x1300U, 0U, 1U, 1U), AbortCode::kNone);
    ports.answer = hal::TransmitStatus::kQueueFull;
    EXPECT_EQ(kernel.SendGfc(), Result::kTransmitFailed);
    ports.answer = hal::TransmitStatus::kAccepted;
    EXPECT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(ports.sent[0].identifier, 0x001U);
    EXPECT_EQ(ports.sent[0].kind, FrameKind::kData);
    EXPECT_EQ(ports.sent[0].length_bytes, 0U);
    EXPECT_EQ(ports.sent[0].port, CanPortId::kFirst);
}

TEST_F(Sending, GfcNeedsAValidConfigurationOutsideTheDeviceSafeState)
{
    Verifies(req::SRS_KRN_013);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    EXPECT_EQ(kernel.SendGfc(), Result::kInvalidConfiguration);
    Operate();
    kernel.DemandSafeState();
    EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault);
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(Sending, NothingIsRequestedInTheDeviceSafeState)
{
    Verifies(req::SRS_KRN_011);
    Operate();
    kernel.DemandSafeState();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kDeviceFault);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kDeviceFault);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1302U}), Result::kNotExist);
}

TEST_F(Sending, GfcThatIsFollowedByAnSrdoIsComplete)
{
    Verifies(req::SRS_KRN_225);
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycles(40U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
}

// t [ms]   10 GFC                      35 (limit)   36
TEST_F(Sending, GfcWithoutAnSrdoWithinTheShortestRefreshTimeIsAnErrorOnce)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

// t [ms]   6 GFC      31 (limit)   32 normal frame
TEST_F(Sending, FrameOfTheFirstCycleBehindTheRefreshTimeStillFollowsTheGfc)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(25U);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycle();
    ASSERT_EQ(ports.sent.size(), 2U);
    EXPECT_EQ(ports.sent[1].identifier, 0x103U);
    Cycles(60U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
}

// t [ms]   6 GFC      7 normal frame refused: bus-off      31 (limit)   32
TEST_F(Sending, FrameThatIsRefusedFollowsNoGfc)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ports.answer = hal::TransmitStatus::kBusOff;
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycles(25U);
    EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kBusOff});
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

// t [ms]   7 normal frame   7 GFC   7.1 confirmed, inverse frame      32 (limit)   33
TEST_F(Sending, SecondHalfOfAnOlderPairFollowsNoGfc)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycle();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(ports.sent.size(), 2U);
    now_us += 100U;
    kernel.OnConfirm(StampedFrame{ports.sent[0], InstantPair{{now_us}, {now_us}}});
    ASSERT_EQ(ports.sent.size(), 3U);
    EXPECT_EQ(ports.sent[2].identifier, 0x104U);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

// t [ms]   6 GFC      26 GFC again      31 (limit of the first)   32
TEST_F(Sending, GfcThatIsSentAgainDoesNotPutTheSrdoOff)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(20U);
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(5U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

// t [ms]   Start, GFC   first cycle   + 24 (limit)   + 25
TEST_F(Sending, GfcBeforeTheFirstCycleCountsFromOneCycleTimeBeforeIt)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    for (const std::uint32_t before_us : {0U, 7000U, 0x80000000U - 8U, 0xFFFFFC18U - 728U})
    {
        Configure();
        kernel.SetNmtState(NmtState::kOperational);
        ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
        application.gfcs_not_followed = 0;
        now_us = before_us;
        Cycles(25U);
        EXPECT_EQ(application.gfcs_not_followed, 0);
        Cycle();
        EXPECT_EQ(application.gfcs_not_followed, 1);
    }
}

TEST_F(Sending, ShortestRefreshTimeOfSeveralProducersCounts)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    Configure();
    // Given producers of 50, 25 and 50 ms
    MakeProducer(1U, 0x101U);
    MakeProducer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

TEST_F(Sending, ShortestRefreshTimeIsFoundByOneMillisecondInAnyPlace)
{
    Verifies(req::SRS_KRN_225);
    setups[1].form = ProducerForm::kApplicationSends;
    struct Times
    {
        std::uint32_t first_ms;
        std::uint32_t last_ms;
        std::uint32_t shortest_ms;
    };
    // Given SRDO 3 with 25 ms between them
    for (const Times& times : {Times{26U, 24U, 24U}, Times{24U, 26U, 24U}, Times{26U, 26U, 25U}, Times{1U, 50U, 1U}})
    {
        Configure();
        MakeProducer(1U, 0x101U, times.first_ms);
        MakeProducer(4U, 0x107U, times.last_ms);
        ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
        kernel.SetNmtState(NmtState::kOperational);
        Cycle();
        ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
        Cycles(times.shortest_ms);
        EXPECT_EQ(application.gfcs_not_followed, 0) << times.first_ms;
        Cycle();
        EXPECT_EQ(application.gfcs_not_followed, 1) << times.first_ms;
        application.gfcs_not_followed = 0;
    }
}

TEST_F(Sending, SecondRequestBeforeTheCycleTakesNothingBack)
{
    Verifies(req::SRS_KRN_224);
    Operate();
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kSuccessful);
    Cycle();
    EXPECT_EQ(a.last_input.request, 2U);
    EXPECT_EQ(b.last_input.request, 2U);
    // Nor does the device safe state, in which the channels are asked for all producers
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    kernel.DemandSafeState();
    Cycle();
    EXPECT_EQ(a.last_input.request, 2U);
    EXPECT_EQ(b.last_input.request, 2U);
}

// What an application may do from within its callbacks.
TEST_F(Sending, CallbacksMaySendAndDemandTheSafeState)
{
    Verifies(req::SRS_KRN_006);
    Verifies(req::SRS_KRN_224);
    Verifies(req::SRS_KRN_340);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    application.on_event = [this](CommunicationIndex)
    { EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful); };
    application.on_error = [this](CommunicationIndex) { EXPECT_EQ(kernel.SendGfc(), Result::kSuccessful); };
    // Given an SRDO sent for each that was received: by the next cycle
    ReceivePair();
    Cycle();
    EXPECT_TRUE(ports.sent.empty());
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(ports.sent[0].identifier, 0x103U);
    // a GFC for an error: at once
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    Cycle();
    ASSERT_EQ(ports.sent.size(), 2U);
    EXPECT_EQ(ports.sent[1].identifier, 0x001U);
    // and the safe state for a pair: its output does not open
    application.on_event = [this](CommunicationIndex) { kernel.DemandSafeState(); };
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kApplication);
}

// Option GFC: on in GfcIsSentOnlyIfSupportedAndOperational and GfcMakesConsumersSafeAndIsTold, off here.
// cycle   OnRefresh of SRDO 3: DemandSafeState   [its frame]   [SRDO 4]
TEST_F(Sending, NothingLeavesOnceAProviderDemandedTheSafeState)
{
    Verifies(req::SRS_KRN_031);
    setups[2].form = ProducerForm::kProviderCalled;
    Configure();
    MakeProducer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    application.on_refresh = [this]() { kernel.DemandSafeState(); };
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(application.refreshed, (std::vector<std::uint16_t>{0x1303U}));
}

// cycle   SRDO 3: the channels prepare different frames   SRDO 4: would be due as well
TEST_F(Sending, NoProducerIsSentBehindADisagreementAboutTheOneBefore)
{
    Verifies(req::SRS_KRN_004);
    setups[1].form = ProducerForm::kApplicationSends;
    Configure();
    MakeProducer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(2U);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0U}), Result::kSuccessful);
    bool is_first = true;
    b.on_prepared = [&is_first](PreparedPair& pair)
    {
        pair.normal.length_bytes = is_first ? 1U : pair.normal.length_bytes;
        is_first = false;
    };
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(Sending, GfcThatIsRemovedIsNoObjectAndIsNeitherSentNorTaken)
{
    Verifies(req::SRS_KRN_019);
    Operate();
    ASSERT_EQ(Read(0x1300U, 0U), 1U);
    config.gfc = GfcUse::kRemoved;
    ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x1300U, 0U}).abort, AbortCode::kObjectUnknown);
    EXPECT_EQ(Write(0x1300U, 0U, 1U, 1U), AbortCode::kObjectUnknown);
    EXPECT_EQ(kernel.SendGfc(), Result::kNotExist);
}

TEST_F(Sending, ReceivedGfcHasNoEffectWhereItIsRemoved)
{
    Verifies(req::SRS_KRN_019);
    config.gfc = GfcUse::kRemoved;
    has_gfc = false;
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    Receive(0x001U, {}, 100U);
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(application.gfcs, 0);
    EXPECT_EQ(kernel.SendGfc(), Result::kNotExist);
}

} // namespace
} // namespace counterpoint
