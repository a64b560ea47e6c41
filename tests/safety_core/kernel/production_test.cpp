// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/crosslink.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <functional>
#include <string>

namespace counterpoint
{
namespace
{

/// Node-ID 2: the first transmission comes 1 ms after entering OPERATIONAL.
class Production : public Rig
{
  protected:
    /// A cycle with counter A ahead; what it sends is confirmed at once, one frame a cycle.
    void DriftingCycle(std::uint32_t drift_us)
    {
        const InstantPair now{{now_us + drift_us}, {now_us}};
        kernel.Cycle(CycleCall{now, 0U, 0U});
        if (!ports.sent.empty())
        {
            const CanFrame frame = ports.sent.back();
            ports.sent.pop_back();
            kernel.OnConfirm(StampedFrame{frame, now});
        }
    }
};

// t [ms]  6 (OPERATIONAL)   7            7.1              7.2
// bus                       N handed     N confirmed,     I confirmed
//                           over         I handed over
TEST_F(Production, NormalFrameFirstThenInverseAfterItsConfirmation)
{
    Verifies(req::SRS_KRN_213);
    Verifies(req::SRS_KRN_214);
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
    Verifies(req::SRS_KRN_340);
    Verifies(req::SRS_FLOW_340);
    Verifies(req::SRS_FLOW_341);
    Operate();
    Cycle();
    ConfirmLast();
    ConfirmLast();
    application.flow.clear();
    Cycle();
    EXPECT_EQ(application.flow.back(), std::make_pair(FlowEvent::kSrdoTransmitted, std::uint16_t{1U}));
    // And in one cycle alone
    Cycle();
    EXPECT_EQ(application.flow.back().first, FlowEvent::kItIsInvalid);
    Cycles(23U);
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

// t [ms]   7 due    31 asked each millisecond    32 the next refresh
TEST_F(Production, AnyAnswerButReadyPreparesNothingAndIsMissedIfItLasts)
{
    Verifies(req::SRS_KRN_012);
    for (const RefreshAnswer answer : {RefreshAnswer::kSkip, RefreshAnswer::kInvalid, static_cast<RefreshAnswer>(0x68U),
                                       static_cast<RefreshAnswer>(0xFFU)})
    {
        application.errors.clear();
        application.refreshed.clear();
        Operate();
        application.refresh = answer;
        std::uint32_t prepared = 0U;
        const auto count = [&prepared](PreparedPair&) { ++prepared; };
        a.on_prepared = count;
        b.on_prepared = count;
        Cycles(25U);
        EXPECT_EQ(application.refreshed.size(), 25U);
        EXPECT_TRUE(CausesOf(0x1303U).empty());
        EXPECT_EQ(a.last_input.stand | b.last_input.stand, 0U);
        Cycle();
        EXPECT_EQ(CausesOf(0x1303U), std::vector<SrdoCause>{SrdoCause::kRefreshMissed});
        EXPECT_EQ(prepared, 0U);
        EXPECT_TRUE(ports.sent.empty());
        a.on_prepared = nullptr;
        b.on_prepared = nullptr;
    }
}

// t [ms]  7               7.1            27.1
// bus     N handed over   N confirmed    SRVT expired without an inverse frame
TEST_F(Production, ChannelsThatHandOutNoFrameAreMissedAsNoConfirmation)
{
    Verifies(req::SRS_KRN_214);
    Verifies(req::SRS_PROD_008);
    Operate();
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    const auto withhold = [](CanFrame& frame) { frame = CanFrame{}; };
    a.on_inverse = withhold;
    b.on_inverse = withhold;
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
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
    Verifies(req::SRS_KRN_340);
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
        DriftingCycle(drift_us);
        application.flow.clear(); // Of no interest here, and more than a target has room for.
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << "cycle " << cycle;
    }
    // Then the refresh has followed the slower counter: 8000 pairs, no cause, and only A had to wait
    EXPECT_EQ(application.events.size(), 8000U);
    EXPECT_TRUE(CausesOf(0x1303U).empty());
    EXPECT_GT(a.stands, 0);
    EXPECT_EQ(b.stands, 0);
    // And the other way round B waits for A, once A has been told of the last cycle
    now_us += 1000U;
    DriftingCycle(drift_us);
    const int stands_of_a = a.stands;
    for (std::uint32_t cycle = 1U; cycle <= 50000U; ++cycle)
    {
        now_us += 1000U;
        drift_us -= ((cycle % 10U) == 0U) ? 1U : 0U;
        DriftingCycle(drift_us);
        application.flow.clear(); // Of no interest here, and more than a target has room for.
        ASSERT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << "cycle " << cycle;
    }
    EXPECT_GT(b.stands, 0);
    EXPECT_LE(a.stands, stands_of_a + 1); // The mark of the last cycle before may have been told in the next one.
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

/// Each member of what one channel prepared, altered.
struct Altered
{
    const char* member;
    std::function<void(PreparedPair&)> alter;
};

class ProductionAltered : public Production, public ::testing::WithParamInterface<Altered>
{
};

TEST_P(ProductionAltered, UnequalPreparedPairsAreADisagreementAndNothingLeaves)
{
    Verifies(req::SRS_CMP_010);
    Verifies(req::SRS_KRN_014);
    for (Tap* const tap : {&a, &b})
    {
        Operate();
        tap->on_prepared = GetParam().alter;
        Cycle();
        tap->on_prepared = nullptr;
        EXPECT_TRUE(ports.sent.empty());
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        EXPECT_EQ(kernel.DeviceState().slot, 1U);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Members, ProductionAltered,
    ::testing::Values(Altered{"Status", [](PreparedPair& pair) { pair.status = PrepareStatus::kNotProducer; }},
                      Altered{"Identifier", [](PreparedPair& pair) { pair.normal.identifier = 0x104U; }},
                      Altered{"Kind", [](PreparedPair& pair) { pair.normal.kind = FrameKind::kRemote; }},
                      Altered{"Controller", [](PreparedPair& pair) { pair.normal.port = CanPortId::kSecond; }},
                      Altered{"Length", [](PreparedPair& pair) { pair.normal.length_bytes = 1U; }}),
    [](const ::testing::TestParamInfo<Altered>& altered) { return std::string{altered.param.member}; });

TEST_F(Production, PreparedPairsThatDifferInTheirDataAloneAreNotInverse)
{
    Verifies(req::SRS_CMP_010);
    Verifies(req::SRS_KRN_014);
    Operate();
    b.on_prepared = [](PreparedPair& pair) { pair.normal.data[1] = 0x35U; };
    Cycle();
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    const std::vector<SrdoCause> given_up{SrdoCause::kNotInverse};
    EXPECT_EQ(a.transmit_faults, given_up);
    EXPECT_EQ(b.transmit_faults, given_up);
}

TEST_F(Production, FullQueueAndBusOffAreCausesOfTheirOwn)
{
    Verifies(req::SRS_KRN_216);
    Operate();
    ports.answer = hal::TransmitStatus::kQueueFull;
    Cycles(2U);
    ASSERT_EQ(application.errors.size(), 1U);
    EXPECT_EQ(application.errors[0].second, SrdoCause::kTransmitQueue);
    ports.answer = hal::TransmitStatus::kBusOff;
    Cycles(25U);
    const std::vector<SrdoCause> given_up{SrdoCause::kTransmitQueue, SrdoCause::kBusOff};
    EXPECT_EQ(CausesOf(0x1303U), given_up);
    EXPECT_EQ(a.transmit_faults, given_up);
    EXPECT_EQ(b.transmit_faults, given_up);
}

TEST_F(Production, InverseFrameForWhichTheQueueHasNoRoomIsGivenUpInBothChannels)
{
    Verifies(req::SRS_KRN_216);
    Operate();
    Cycle();
    ports.answer = hal::TransmitStatus::kQueueFull;
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(a.transmit_faults, std::vector<SrdoCause>{SrdoCause::kTransmitQueue});
    EXPECT_EQ(b.transmit_faults, std::vector<SrdoCause>{SrdoCause::kTransmitQueue});
}

TEST_F(Production, ChannelBThatSawNoConfirmationSendsNoInverse)
{
    Verifies(req::SRS_KRN_214);
    Verifies(req::SRS_PROD_008);
    Operate();
    b.drop_confirms = true;
    Cycle();
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(b.inverse_frames, 0);
    Cycles(25U);
    ASSERT_FALSE(application.errors.empty());
    EXPECT_EQ(application.errors[0].second, SrdoCause::kNoConfirmation);
}

TEST_F(Production, NormalFrameThatChannelADidNotSeeConfirmedIsFollowedByNoInverse)
{
    Verifies(req::SRS_KRN_214);
    Operate();
    a.drop_confirms = true;
    Cycle();
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(b.inverse_frames, 0);
}

TEST_F(Production, InverseFrameIsAskedOfBothChannels)
{
    Verifies(req::SRS_KRN_214);
    Operate();
    Cycle();
    ConfirmLast();
    ConfirmLast();
    EXPECT_EQ(a.inverse_frames, 1);
    EXPECT_EQ(b.inverse_frames, 1);
    EXPECT_EQ(ports.sent.size(), 2U);
}

/// Each member of the inverse frame of one channel, altered.
struct AlteredInverse
{
    const char* member;
    std::function<void(CanFrame&)> alter;
};

class ProductionInverse : public Production, public ::testing::WithParamInterface<AlteredInverse>
{
};

TEST_P(ProductionInverse, UnequalInverseFramesAreADisagreementAndNothingLeaves)
{
    Verifies(req::SRS_KRN_214);
    Verifies(req::SRS_TWO_019); // Channel A of this kernel is the remote voice on CPU B.
    for (Tap* const tap : {&a, &b})
    {
        ports.sent.clear();
        Operate();
        Cycle();
        ASSERT_EQ(ports.sent.size(), 1U);
        tap->on_inverse = GetParam().alter;
        ConfirmLast();
        tap->on_inverse = nullptr;
        EXPECT_EQ(ports.sent.size(), 1U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
        EXPECT_EQ(kernel.DeviceState().slot, 1U);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Members, ProductionInverse,
    ::testing::Values(AlteredInverse{"Identifier", [](CanFrame& frame) { frame.identifier = 0x106U; }},
                      AlteredInverse{"Kind", [](CanFrame& frame) { frame.kind = FrameKind::kRemote; }},
                      AlteredInverse{"Controller", [](CanFrame& frame) { frame.port = CanPortId::kSecond; }},
                      AlteredInverse{"Length", [](CanFrame& frame) { frame.length_bytes = 1U; }},
                      AlteredInverse{"Data", [](CanFrame& frame) { frame.data[1] = 0xCAU; }},
                      AlteredInverse{"Empty", [](CanFrame& frame) { frame = CanFrame{}; }}),
    [](const ::testing::TestParamInfo<AlteredInverse>& altered) { return std::string{altered.param.member}; });

// t      normal frame handed over   OPERATIONAL left (and entered again)   normal frame confirmed
TEST_F(Production, NoInverseFrameOnceOperationalWasLeft)
{
    Verifies(req::SRS_KRN_215);
    for (const bool is_entered_again : {false, true})
    {
        ports.sent.clear();
        Operate();
        Cycle();
        ASSERT_EQ(ports.sent.size(), 1U);
        kernel.SetNmtState(NmtState::kPreOperational);
        if (is_entered_again)
        {
            kernel.SetNmtState(NmtState::kOperational);
        }
        ConfirmLast();
        EXPECT_EQ(ports.sent.size(), 1U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
        // The pair is over with the next cycle
        Cycle();
        ConfirmLast();
        EXPECT_EQ(ports.sent.size(), 1U);
    }
    EXPECT_EQ(a.inverse_frames + b.inverse_frames, 0);
}

TEST_F(Production, NoInverseFrameWithoutAValidConfiguration)
{
    Verifies(req::SRS_KRN_215);
    Operate();
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    // Left, changed and entered again between two cycles
    kernel.SetNmtState(NmtState::kPreOperational);
    ASSERT_EQ(Write(0x1303U, 2U, 30U, 2U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(a.inverse_frames + b.inverse_frames, 0);
}

// t      k                    k+1                  k+2
// waits  A alone              both                 none
// stand  .                    A                    .
TEST_F(Production, ChannelInWhichAloneTheRefreshWaitsStandsInTheNextCycle)
{
    Verifies(req::SRS_KRN_017);
    Operate();
    // Given that the refresh does not wait in B in one cycle
    b.on_outcome = [](CycleOutcome& outcome) { outcome.refresh = 0U; };
    Cycle();
    EXPECT_EQ(a.stands, 0);
    EXPECT_TRUE(ports.sent.empty());
    // Then A's phase stands in the next one, and not in B or after it
    b.on_outcome = nullptr;
    Cycle();
    EXPECT_EQ(a.stands, 1);
    EXPECT_EQ(ports.sent.size(), 1U);
    Cycles(3U);
    EXPECT_EQ(a.stands, 1);
    EXPECT_EQ(b.stands, 0);
}

// t          k            between    k+1
// due        one alone               .
// latch      runs         safe       safe       the producer stands in both for one reason, in one for two
TEST_F(Production, ProducerThatStandsForTwoReasonsStands)
{
    Verifies(req::SRS_KRN_004);
    Verifies(req::SRS_KRN_017);
    for (const bool is_a : {true, false})
    {
        Operate();
        Tap& behind = is_a ? b : a;
        behind.on_outcome = [](CycleOutcome& outcome) { outcome.refresh = 0U; };
        Cycle();
        behind.on_outcome = nullptr;
        kernel.DemandSafeState();
        Cycle();
        EXPECT_EQ(a.last_input.stand, 2U);
        EXPECT_EQ(b.last_input.stand, 2U);
    }
}

TEST_F(Production, StepsThatTheChannelsDoNotShareAreFollowedByNothing)
{
    Verifies(req::SRS_KRN_214);
    Operate();
    Cycle();
    b.on_confirmed = [](Confirmation& confirmation) { confirmation.step = ConfirmStep::kPair; };
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    // Only beside a channel that says nothing is the pair given up
    EXPECT_TRUE(a.transmit_faults.empty());
    EXPECT_TRUE(b.transmit_faults.empty());
}

TEST_F(Production, ConfirmationOfASlotThatDoesNotExistIsFollowedByNothing)
{
    Verifies(req::SRS_KRN_214);
    Operate();
    Cycle();
    const auto behind_the_last = [](Confirmation& confirmation) { confirmation = {3U, ConfirmStep::kPair}; };
    a.on_confirmed = behind_the_last;
    b.on_confirmed = behind_the_last;
    ConfirmLast();
    EXPECT_TRUE(application.events.empty());
}

TEST_F(Production, ConfirmationsOfDifferentSlotsAreFollowedByNothing)
{
    Verifies(req::SRS_KRN_214);
    Operate();
    Cycle();
    b.on_confirmed = [](Confirmation& confirmation) { confirmation.slot = 0U; };
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(b.inverse_frames, 0);
}

TEST_F(Production, ConfirmationThatIsNoStepIsFollowedByNothing)
{
    Verifies(req::SRS_KRN_214);
    Operate();
    Cycle();
    const auto no_step = [](Confirmation& confirmation) { confirmation.step = static_cast<ConfirmStep>(0x11U); };
    a.on_confirmed = no_step;
    b.on_confirmed = no_step;
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_TRUE(application.events.empty());
}

TEST_F(Production, ForeignConfirmationHasNoEffect)
{
    Verifies(req::SRS_KRN_214);
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
    Verifies(req::SRS_KRN_215);
    Operate();
    Cycle();
    kernel.DemandSafeState();
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(a.inverse_frames + b.inverse_frames, 0);
}

// Both channels say that a normal frame was confirmed, a cycle behind what keeps the inverse one back.
TEST_F(Production, ConfirmationThatNoChannelMayGiveIsFollowedByNoInverseFrame)
{
    Verifies(req::SRS_KRN_215);
    const auto confirmed = [](Confirmation& confirmation) { confirmation = {1U, ConfirmStep::kNormal}; };
    a.on_confirmed = confirmed;
    b.on_confirmed = confirmed;
    for (const NmtState state : {NmtState::kInitialising, NmtState::kPreOperational, NmtState::kStopped})
    {
        ports.sent.clear();
        Operate();
        Cycle();
        kernel.SetNmtState(state);
        Cycle();
        ConfirmLast();
        EXPECT_EQ(ports.sent.size(), 1U);
    }
    // Given OPERATIONAL with a configuration that is not valid
    ASSERT_EQ(Write(0x1303U, 2U, 30U, 2U), AbortCode::kNone);
    kernel.SetNmtState(NmtState::kOperational);
    Cycles(2U);
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(a.inverse_frames + b.inverse_frames, 0);
    // and with one that is
    ports.sent.clear();
    Operate();
    Cycle();
    ConfirmLast();
    EXPECT_EQ(a.inverse_frames, 1);
    EXPECT_EQ(b.inverse_frames, 1);
}

} // namespace
} // namespace counterpoint
