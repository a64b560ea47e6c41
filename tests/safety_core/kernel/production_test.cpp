// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"

namespace counterpoint
{
namespace
{

/// Node-ID 2: the first transmission comes 1 ms after entering OPERATIONAL.
class Production : public Rig
{
};

// t [ms]  6 (OPERATIONAL)   7            7.1              7.2
// bus                       N handed     N confirmed,     I confirmed
//                           over         I handed over
TEST_F(Production, NormalFrameFirstThenInverseAfterItsConfirmation)
{
    Verifies(req::SRS_KRN_014);
    Verifies(req::SRS_KRN_012);
    Verifies(req::SRS_PROD_006);
    Operate();
    EXPECT_TRUE(ports.sent.empty());
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(application.refreshed, std::vector<std::uint16_t>{0x1303U});
    EXPECT_EQ(ports.sent[0].identifier, 0x103U);
    EXPECT_EQ(ports.sent[0].length_bytes, 2U);
    EXPECT_EQ(ports.sent[0].data[0], 0x12U);
    EXPECT_EQ(ports.sent[0].data[1], 0x34U);
    ConfirmLast();
    ASSERT_EQ(ports.sent.size(), 2U);
    EXPECT_EQ(ports.sent[1].identifier, 0x104U);
    EXPECT_EQ(ports.sent[1].data[0], 0xEDU);
    EXPECT_EQ(ports.sent[1].data[1], 0xCBU);
    EXPECT_TRUE(application.events.empty());
    ConfirmLast();
    EXPECT_EQ(application.events, std::vector<std::uint16_t>{0x1303U});
}

TEST_F(Production, SecondPairIsAnEventAndCountedInTheFlow)
{
    Verifies(req::SRS_KRN_006);
    Verifies(req::SRS_FLOW_004);
    Operate();
    Cycle();
    ConfirmLast();
    ConfirmLast();
    application.flow.clear();
    Cycle();
    EXPECT_EQ(application.flow.back(), std::make_pair(FlowEvent::kSrdoTransmitted, std::uint8_t{1U}));
    Cycles(24U);
    ConfirmLast();
    ConfirmLast();
    EXPECT_EQ(application.events.size(), 2U);
}

TEST_F(Production, ProviderThatSkipsSendsNothingUntilItIsReady)
{
    Verifies(req::SRS_KRN_012);
    Operate();
    application.refresh = RefreshAnswer::kSkip;
    Cycles(3U);
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(application.refreshed.size(), 3U);
    application.refresh = RefreshAnswer::kReady;
    Cycle();
    EXPECT_EQ(ports.sent.size(), 1U);
}

// t [ms]  7               7.1            27.1
// bus     N handed over   N confirmed    SRVT expired without an inverse frame
TEST_F(Production, ChannelThatHandsOutNoFrameIsMissedAsNoConfirmation)
{
    Verifies(req::SRS_KRN_014);
    Verifies(req::SRS_PROD_008);
    Operate();
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    b.withhold_frames = true;
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    Cycles(22U);
    EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kNoConfirmation});
}

TEST_F(Production, DeviceFaultAfterTheNormalFrameKeepsTheInverseFrameBack)
{
    Verifies(req::SRS_KRN_004);
    Operate();
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    kernel.DemandSafeState();
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(Production, InverseFrameConfirmedWithOtherDataIsNotSent)
{
    Verifies(req::SRS_KRN_006);
    Verifies(req::SRS_PROD_007);
    Operate();
    Cycle();
    ConfirmLast();
    ASSERT_EQ(ports.sent.size(), 2U);
    // Given an echo of the inverse frame with one flipped bit
    CanFrame echo = ports.sent[1];
    echo.data[0] = 0xECU;
    now_us += 100U;
    kernel.OnConfirm(StampedFrame{echo, InstantPair{{now_us}, {now_us}}});
    // Then no pair was sent, and the cause is told
    EXPECT_TRUE(application.events.empty());
    Cycle();
    EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kWrongEcho});
}

// Counter A 100 ppm ahead of counter B, for 200 s of refresh every 25 ms
TEST_F(Production, CountersThatDriftApartKeepOnePhase)
{
    Verifies(req::SRS_KRN_017);
    Verifies(req::SRS_PROD_012);
    config.clock_tolerance_us = 500U;
    Operate();
    const std::uint32_t start_us = now_us;
    std::uint32_t drift_us = 0U;
    for (std::uint32_t cycle = 1U; cycle <= 200000U; ++cycle)
    {
        now_us = start_us + (cycle * 1000U);
        drift_us = cycle / 10U;
        kernel.Cycle(CycleCall{InstantPair{{now_us + drift_us}, {now_us}}, 0U, 0U});
        if (!ports.sent.empty())
        {
            const CanFrame frame = ports.sent.back();
            ports.sent.pop_back();
            kernel.OnConfirm(StampedFrame{frame, InstantPair{{now_us + drift_us}, {now_us}}});
        }
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << "cycle " << cycle;
    }
    // Then the refresh has followed the slower counter: 8000 pairs, no cause, and only A had to wait
    EXPECT_EQ(application.events.size(), 8000U);
    EXPECT_TRUE(CausesOf(0x1303U).empty());
    EXPECT_GT(a.holds, 0);
    EXPECT_EQ(b.holds, 0);
    // And the other way round B waits for A
    const int holds_of_a = a.holds;
    for (std::uint32_t cycle = 1U; cycle <= 50000U; ++cycle)
    {
        now_us += 1000U;
        drift_us -= ((cycle % 10U) == 0U) ? 1U : 0U;
        kernel.Cycle(CycleCall{InstantPair{{now_us + drift_us}, {now_us}}, 0U, 0U});
        if (!ports.sent.empty())
        {
            const CanFrame frame = ports.sent.back();
            ports.sent.pop_back();
            kernel.OnConfirm(StampedFrame{frame, InstantPair{{now_us + drift_us}, {now_us}}});
        }
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << "cycle " << cycle;
    }
    EXPECT_GT(b.holds, 0);
    EXPECT_EQ(a.holds, holds_of_a);
}

TEST_F(Production, ObjectsThatAreNotInverseSendNothingAndAreTold)
{
    Verifies(req::SRS_PROD_005);
    Operate();
    tx_inverse[1] = 0xCAU;
    Cycles(2U);
    EXPECT_TRUE(ports.sent.empty());
    ASSERT_EQ(application.errors.size(), 1U);
    EXPECT_EQ(application.errors[0].first, 0x1303U);
    EXPECT_EQ(application.errors[0].second, SrdoCause::kNotInverse);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Production, UnequalPreparedPairsAreADisagreementAndNothingLeaves)
{
    Verifies(req::SRS_CMP_010);
    Operate();
    b.prepare_flip = 1U;
    Cycle();
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
    EXPECT_EQ(kernel.DeviceState().slot, 1U);
}

TEST_F(Production, FullQueueAndBusOffAreCausesOfTheirOwn)
{
    Verifies(req::SRS_KRN_014);
    Operate();
    ports.answer = hal::TransmitStatus::kQueueFull;
    Cycles(2U);
    ASSERT_EQ(application.errors.size(), 1U);
    EXPECT_EQ(application.errors[0].second, SrdoCause::kTransmitQueue);
    ports.answer = hal::TransmitStatus::kBusOff;
    Cycles(25U);
    ASSERT_EQ(application.errors.size(), 2U);
    EXPECT_EQ(application.errors[1].second, SrdoCause::kBusOff);
}

TEST_F(Production, ChannelBThatSawNoConfirmationSendsNoInverse)
{
    Verifies(req::SRS_KRN_014);
    Verifies(req::SRS_PROD_008);
    Operate();
    b.drop_confirms = true;
    Cycle();
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    Cycles(25U);
    ASSERT_FALSE(application.errors.empty());
    EXPECT_EQ(application.errors[0].second, SrdoCause::kNoConfirmation);
}

TEST_F(Production, ForeignConfirmationHasNoEffect)
{
    Verifies(req::SRS_KRN_014);
    Operate();
    Cycle();
    now_us += 10U;
    kernel.OnConfirm(
        StampedFrame{CanFrame{0x180U, FrameKind::kData, CanPortId::kFirst, 0U, {}}, InstantPair{{now_us}, {now_us}}});
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(Production, DeviceSafeStateKeepsTheInverseFrameBack)
{
    Verifies(req::SRS_KRN_004);
    Operate();
    Cycle();
    kernel.DemandSafeState();
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(Production, SendReturnsTheReferencesCodes)
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

TEST_F(Production, SendToAllWithoutAProducerDoesNotExist)
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

TEST_F(Production, ApplicationSendsWhenItWants)
{
    Verifies(req::SRS_KRN_011);
    Verifies(req::SRS_PROD_003);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    Cycles(3U);
    EXPECT_TRUE(ports.sent.empty());
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_TRUE(application.refreshed.empty());
}

TEST_F(Production, GfcIsSentOnlyIfSupportedAndOperational)
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
    EXPECT_EQ(ports.sent[0].length_bytes, 0U);
}

TEST_F(Production, GfcThatIsFollowedByAnSrdoIsComplete)
{
    Verifies(req::SRS_KRN_013);
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
    Cycles(40U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
}

// t [ms]   10 GFC                      35 (limit)   36
TEST_F(Production, GfcWithoutAnSrdoWithinTheShortestRefreshTimeIsAnErrorOnce)
{
    Verifies(req::SRS_KRN_013);
    setups[1].form = ProducerForm::kApplicationSends;
    Operate();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

TEST_F(Production, ShortestRefreshTimeOfSeveralProducersCounts)
{
    Verifies(req::SRS_KRN_013);
    setups[1].form = ProducerForm::kApplicationSends;
    Configure();
    const auto make_producer = [this](std::uint16_t number, std::uint32_t cob_id)
    {
        const std::uint16_t communication = static_cast<std::uint16_t>(0x1300U + number);
        const std::uint16_t mapping = static_cast<std::uint16_t>(0x1380U + number);
        ASSERT_EQ(Write(communication, 1U, 0U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 2U, 50U, 2U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 5U, cob_id, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 6U, cob_id + 1U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 0U, 0U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 1U, 0x20000110U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 2U, 0x21000110U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(mapping, 0U, 2U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(communication, 1U, 1U, 1U), AbortCode::kNone);
        const SignReply reply = kernel.Sign(CommunicationIndex{communication});
        ASSERT_EQ(Write(0x13FFU, static_cast<std::uint8_t>(number), reply.signature, 2U), AbortCode::kNone);
    };
    // Given producers of 50, 25 and 50 ms
    make_producer(1U, 0x101U);
    make_producer(4U, 0x107U);
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(25U);
    EXPECT_EQ(application.gfcs_not_followed, 0);
    Cycle();
    EXPECT_EQ(application.gfcs_not_followed, 1);
}

} // namespace
} // namespace counterpoint
