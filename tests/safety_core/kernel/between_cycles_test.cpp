// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What is asked and confirmed between leaving OPERATIONAL and the next cycle.
//
// NMT     OPERATIONAL            PRE-OPERATIONAL [OPERATIONAL]
// cycle   |         released |   GetState: off                 | what the channels say
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class BetweenCycles : public Rig
{
  protected:
    SrdoState StateOf(const std::uint16_t index) const
    {
        return kernel.GetState(CommunicationIndex{index}).state;
    }

    /// SRDO 1 released, nothing of SRDO 3 in flight.
    void Release()
    {
        Operate();
        ReceivePair();
        Cycle();
        ASSERT_EQ(StateOf(0x1301U), SrdoState::kReleased);
        ASSERT_EQ(StateOf(0x1303U), SrdoState::kProducer);
    }

    /// The normal frame of SRDO 3 on its way.
    void Send()
    {
        Operate();
        ASSERT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kSuccessful);
        Cycle();
        ASSERT_EQ(ports.sent.size(), 1U);
        ASSERT_EQ(ports.sent[0].identifier, 0x103U);
    }
};

TEST_F(BetweenCycles, NothingIsReleasedAnyMoreOnceOperationalWasLeft)
{
    Verifies(req::SRS_KRN_043);
    for (const NmtState state : {NmtState::kPreOperational, NmtState::kStopped, NmtState::kInitialising})
    {
        Release();
        // When OPERATIONAL is left, then consumer and producer are off in the same call
        kernel.SetNmtState(state);
        EXPECT_EQ(StateOf(0x1301U), SrdoState::kOff);
        EXPECT_EQ(StateOf(0x1303U), SrdoState::kOff);
        EXPECT_EQ(StateOf(0x1304U), SrdoState::kOff);
        // and in the cycle that tells the channels
        Cycle();
        EXPECT_EQ(StateOf(0x1301U), SrdoState::kOff);
        EXPECT_EQ(StateOf(0x1303U), SrdoState::kOff);
    }
}

TEST_F(BetweenCycles, NorWhereOperationalIsEnteredAgainBeforeTheCycle)
{
    Verifies(req::SRS_KRN_043);
    Release();
    // Given OPERATIONAL left and entered again, then nothing is in use before the channels were told
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(StateOf(0x1301U), SrdoState::kOff);
    EXPECT_EQ(StateOf(0x1303U), SrdoState::kOff);
    // When two cycles have shown it as left for one, then the consumer waits for its first pair
    Cycles(2U);
    EXPECT_EQ(StateOf(0x1301U), SrdoState::kWaiting);
    EXPECT_EQ(StateOf(0x1303U), SrdoState::kProducer);
}

// Channels that both still hold a pair say the same, in the device safe state too.
TEST_F(BetweenCycles, NorInTheDeviceSafeState)
{
    Verifies(req::SRS_KRN_043);
    Release();
    kernel.DemandSafeState();
    ASSERT_EQ(StateOf(0x1301U), SrdoState::kFaulted);
    kernel.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(StateOf(0x1301U), SrdoState::kOff);
    Cycle();
    EXPECT_EQ(StateOf(0x1301U), SrdoState::kOff);
}

TEST_F(BetweenCycles, NorWhateverIsSetSince)
{
    Verifies(req::SRS_KRN_043);
    Release();
    kernel.SetNmtState(NmtState::kPreOperational);
    const auto are_off = [this]()
    {
        for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x1301U, 0x1303U, 0x1304U})
        {
            EXPECT_EQ(StateOf(index), SrdoState::kOff) << index;
        }
    };
    // Given the consumer without a mapping, then as a producer, and the producer as a consumer
    EXPECT_EQ(Write(0x1301U, 1U, 0U, 1U), AbortCode::kNone);
    are_off();
    EXPECT_EQ(Write(0x1381U, 0U, 0U, 1U), AbortCode::kNone);
    are_off();
    EXPECT_EQ(Write(0x1301U, 1U, 1U, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1303U, 1U, 2U, 1U), AbortCode::kNone);
    are_off();
    // and other NMT states
    kernel.SetNmtState(NmtState::kStopped);
    are_off();
    kernel.SetNmtState(NmtState::kOperational);
    are_off();
    Cycle();
    are_off();
}

TEST_F(BetweenCycles, ChannelsThatDifferAreStillFaulted)
{
    Verifies(req::SRS_KRN_152);
    Verifies(req::SRS_KRN_043);
    // Given an inverse frame that channel B alone did not get
    Operate();
    b.drop_frames = true;
    Receive(0x102U, {0xEDU, 0xCBU}, 100U);
    b.drop_frames = false;
    ASSERT_EQ(StateOf(0x1301U), SrdoState::kFaulted);
    // When OPERATIONAL is left, then what differs is told as before
    kernel.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(StateOf(0x1301U), SrdoState::kFaulted);
}

TEST_F(BetweenCycles, AConfirmedNormalFrameIsFollowedByNothing)
{
    Verifies(req::SRS_KRN_044);
    Send();
    kernel.SetNmtState(NmtState::kPreOperational);
    ConfirmLast();
    EXPECT_EQ(ports.sent.size(), 1U);
    EXPECT_TRUE(application.events.empty());
}

TEST_F(BetweenCycles, AConfirmedInverseFrameIsNoEventOfAnSrdoThatReceivesByThen)
{
    Verifies(req::SRS_KRN_044);
    // Given both frames on the bus, the inverse one not confirmed yet
    Send();
    ConfirmLast();
    ASSERT_EQ(ports.sent.size(), 2U);
    // When OPERATIONAL is left, SRDO 3 made a consumer, and the confirmation comes
    kernel.SetNmtState(NmtState::kPreOperational);
    EXPECT_EQ(Write(0x1303U, 1U, 2U, 1U), AbortCode::kNone);
    ConfirmLast();
    // Then nothing was received, and nothing is told
    EXPECT_TRUE(application.events.empty());
    Cycles(3U);
    EXPECT_TRUE(application.events.empty());
    EXPECT_TRUE(CausesOf(0x1303U).empty());
}

TEST_F(BetweenCycles, NorOneThatComesWhenOperationalWasEnteredAgain)
{
    Verifies(req::SRS_KRN_044);
    Send();
    ConfirmLast();
    kernel.SetNmtState(NmtState::kPreOperational);
    kernel.SetNmtState(NmtState::kOperational);
    ConfirmLast();
    EXPECT_TRUE(application.events.empty());
    EXPECT_EQ(ports.sent.size(), 2U);
}

TEST_F(BetweenCycles, AConfirmationInOperationalIsTold)
{
    Verifies(req::SRS_KRN_044);
    Send();
    ConfirmLast();
    ConfirmLast();
    EXPECT_EQ(application.events, std::vector<std::uint16_t>{0x1303U});
}

} // namespace
} // namespace counterpoint
