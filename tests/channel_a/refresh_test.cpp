// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// When channel A finds that the application sends too late, and what a refresh does in a call in which its slot stands.
#include "tests/channel_a/device.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace counterpoint::channel_a_test
{
namespace
{

constexpr std::uint32_t kBitOfMissed = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kRefreshMissed);
constexpr std::uint32_t kBitOfNoConfirmation = std::uint32_t{1U}
                                               << static_cast<std::uint32_t>(SrdoCause::kNoConfirmation);

// A producer of which the time is refresh time + 1 ms + 0.5 ms where the application sends.
class ChannelARefresh : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        device.config.cycle_tolerance_us = 500U;
        // The objects hold what FrameOf makes of 0.
        for (std::uint8_t place = 0U; place < 8U; ++place)
        {
            device.words[4U + (place / 4U)][place % 4U] = place;
        }
    }

    // The call at an instant.
    CycleOutcome CycleAt(std::uint32_t instant_us)
    {
        return device.Cycle(instant_us - device.clock_us);
    }

    // The same with a request, or standing.
    CycleOutcome AskAt(std::uint32_t instant_us)
    {
        device.request = kProducerBit;
        const CycleOutcome outcome = CycleAt(instant_us);
        device.request = 0U;
        return outcome;
    }

    CycleOutcome StandAt(std::uint32_t instant_us)
    {
        device.stand = kProducerBit;
        const CycleOutcome outcome = CycleAt(instant_us);
        device.stand = 0U;
        return outcome;
    }

    // Whether a call finds a refresh missed.
    bool IsMissedAt(std::uint32_t instant_us)
    {
        static_cast<void>(CycleAt(instant_us));
        return IsMissed();
    }

    // By the call before.
    bool IsMissed() const
    {
        return device.channel.View(kProducerSlot).signals == kBitOfMissed;
    }

    std::uint32_t Errors() const
    {
        return device.channel.View(kProducerSlot).error_count;
    }

    void Prepare()
    {
        ASSERT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
    }

    ConfirmStep Confirm(bool is_inverse)
    {
        const std::uint32_t identifier = is_inverse ? 0x102U : 0x101U;
        return device.channel.OnConfirm(Device::FrameOf(identifier, 8U, 0U, is_inverse), Instant{device.clock_us}).step;
    }

    void SendPair()
    {
        Prepare();
        ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
        ASSERT_EQ(Confirm(true), ConfirmStep::kPair);
    }

    // OPERATIONAL from 1 ms on, with the first possible transmission at 1.5 ms; a pair is prepared at 2 ms.
    void PrepareAtTwoMilliseconds(ProducerForm form, std::uint32_t refresh_ms)
    {
        device.setups[kProducerSlot].form = form;
        device.clock_us = 0U;
        device.nmt = NmtState::kOperational;
        device.Start();
        device.Store(kProducerSlot, ConfigField::kSct, refresh_ms);
        ASSERT_EQ(device.Sign(kProducerSlot).fault, ConfigFault::kNone);
        static_cast<void>(device.Cycle());
        ASSERT_EQ(AskAt(2000U).due, kProducerBit);
        Prepare();
    }

    void SendAtTwoMilliseconds(ProducerForm form, std::uint32_t refresh_ms)
    {
        PrepareAtTwoMilliseconds(form, refresh_ms);
        ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
        ASSERT_EQ(Confirm(true), ConfirmStep::kPair);
    }

    std::unique_ptr<FencedDevice> fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
};

// t       2000 | 53500         53501                    105001       105002
//         sent | in time       over: asked for, sent    in time      over
TEST_F(ChannelARefresh, IsMissedThoughTheCallThatFindsItIsAsked)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_003);
    // Given nothing sent for 50 ms and a late cycle
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    EXPECT_FALSE(IsMissedAt(53500U));
    // When the request comes a microsecond later
    const CycleOutcome late = AskAt(53501U);
    // Then the pair is late, and due nevertheless
    EXPECT_TRUE(IsMissed());
    EXPECT_EQ(late.signalled & kProducerBit, kProducerBit);
    EXPECT_EQ(late.due, kProducerBit);
    EXPECT_EQ(late.refresh, 0U);
    SendPair();
    EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kRefreshMissed);
    // and its time counts anew
    EXPECT_FALSE(IsMissedAt(105001U));
    EXPECT_TRUE(IsMissedAt(105002U));
    EXPECT_EQ(Errors(), 2U);
}

// t       2000 | 53500               53501, 60000, 105002
//         sent | asked for           waits
TEST_F(ChannelARefresh, IsNotMissedWhereTheRequestWaitsFromACallBefore)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_004);
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    // Given a request on the refresh time and a late cycle, when nobody prepares it
    EXPECT_EQ(AskAt(53500U).due, kProducerBit);
    // Then it waits without a fault, asked for once more or not
    EXPECT_EQ(CycleAt(53501U).due, kProducerBit);
    EXPECT_EQ(AskAt(60000U).due, kProducerBit);
    EXPECT_EQ(CycleAt(105002U).due, kProducerBit);
    EXPECT_EQ(Errors(), 0U);
    // and the time counts from where it is prepared
    SendPair();
    EXPECT_FALSE(IsMissedAt(156502U));
    EXPECT_TRUE(IsMissedAt(156503U));
}

// t       2000       | 5000            13501             20000
//         prepared   | asked for       over: it waits    pair sent
TEST_F(ChannelARefresh, IsNotMissedWhereTheRequestWaitsForThePairInFlight)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_003);
    PrepareAtTwoMilliseconds(ProducerForm::kApplicationSends, 10U);
    EXPECT_EQ(AskAt(5000U).due, 0U);
    EXPECT_FALSE(IsMissedAt(13501U));
    ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
    ASSERT_EQ(Confirm(true), ConfirmStep::kPair);
    EXPECT_EQ(CycleAt(20000U).due, kProducerBit);
    EXPECT_EQ(Errors(), 0U);
}

// t       2000       | 13501                      25002             26000
//         prepared   | over: asked for, waits     no second fault   pair sent
TEST_F(ChannelARefresh, IsMissedOnceWhereTheLateRequestWaitsForThePairInFlight)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_003);
    PrepareAtTwoMilliseconds(ProducerForm::kApplicationSends, 10U);
    EXPECT_EQ(AskAt(13501U).due, 0U);
    EXPECT_TRUE(IsMissed());
    ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
    EXPECT_EQ(CycleAt(25002U).due, 0U);
    ASSERT_EQ(Confirm(true), ConfirmStep::kPair);
    EXPECT_EQ(CycleAt(26000U).due, kProducerBit);
    EXPECT_EQ(Errors(), 1U);
}

TEST_F(ChannelARefresh, IsMissedWithoutARequestAndBesideThatOfAnother)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_003);
    // Given a slot that is no producer and one that is not there, when they are asked for as the time is over
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    device.request = ~kProducerBit;
    EXPECT_EQ(CycleAt(53501U).due, 0U);
    EXPECT_TRUE(IsMissed());
    device.request = 0U;
    // Then nothing is sent, and the time counts anew from that call
    EXPECT_FALSE(IsMissedAt(105001U));
    EXPECT_TRUE(IsMissedAt(105002U));
}

// t       2000 | 3000      54500      54501
//         sent | stands    in time    over
TEST_F(ChannelARefresh, OfTheApplicationMovesOnWhereItStands)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_010);
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    static_cast<void>(StandAt(3000U));
    EXPECT_FALSE(IsMissedAt(54500U));
    EXPECT_TRUE(IsMissedAt(54501U));
    EXPECT_EQ(Errors(), 1U);
}

// t       2000 | 53000     54000                     54500      54501
//         sent |           over by itself: stands    in time    over
TEST_F(ChannelARefresh, OfTheApplicationIsNotExaminedWhereItStands)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_010);
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    EXPECT_FALSE(IsMissedAt(53000U));
    const CycleOutcome stood = StandAt(54000U);
    EXPECT_EQ(stood.signalled & kProducerBit, 0U);
    EXPECT_EQ(stood.due | stood.refresh, 0U);
    EXPECT_FALSE(IsMissedAt(54500U));
    EXPECT_TRUE(IsMissedAt(54501U));
    EXPECT_EQ(Errors(), 1U);
}

TEST_F(ChannelARefresh, OfTheApplicationIsNotExaminedHoweverFarBehind)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_010);
    // Given 30 ms behind the last pair, when a refresh time of 10 ms is stored and the slot stands
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    EXPECT_FALSE(IsMissedAt(32000U));
    device.Store(kProducerSlot, ConfigField::kSct, 10U);
    static_cast<void>(StandAt(33000U));
    static_cast<void>(StandAt(34000U));
    EXPECT_EQ(Errors(), 0U);
    // Then it is missed by the first call in which it does not stand
    EXPECT_TRUE(IsMissedAt(35000U));
}

TEST_F(ChannelARefresh, StandsWithARequestThatIsNotLate)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_003);
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    EXPECT_FALSE(IsMissedAt(53000U));
    // Given a slot that stands, when it is asked for, then it is due in that same call
    device.request = kProducerBit;
    EXPECT_EQ(StandAt(54000U).due, kProducerBit);
    device.request = 0U;
    // and the request waits when the time is over
    EXPECT_EQ(CycleAt(54501U).due, kProducerBit);
    EXPECT_EQ(StandAt(55000U).due, kProducerBit);
    EXPECT_EQ(Errors(), 0U);
    SendPair();
    EXPECT_FALSE(IsMissedAt(106500U));
    EXPECT_TRUE(IsMissedAt(106501U));
}

// t       2000 | 100000              101000    102000    103000    104000     127500
//         sent | that of 26500       stands    52500     77500     102500     in phase
TEST_F(ChannelARefresh, ThatFarBehindFallsDueBehindTheCallInWhichItStands)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_002);
    SendAtTwoMilliseconds(ProducerForm::kProviderCalled, 25U);
    // Given a late call, behind which more refreshes are due
    EXPECT_EQ(CycleAt(100000U).refresh, kProducerBit);
    SendPair();
    // When the slot stands, then none falls due
    const CycleOutcome stood = StandAt(101000U);
    EXPECT_EQ(stood.refresh, 0U);
    EXPECT_EQ(stood.due, 0U);
    // and all do behind it, one a call
    EXPECT_EQ(CycleAt(102000U).refresh, kProducerBit);
    SendPair();
    EXPECT_EQ(CycleAt(103000U).refresh, kProducerBit);
    SendPair();
    EXPECT_EQ(CycleAt(104000U).refresh, kProducerBit);
    SendPair();
    // Then in phase, a millisecond later than it was
    EXPECT_EQ(CycleAt(127499U).refresh, 0U);
    EXPECT_EQ(CycleAt(127500U).refresh, kProducerBit);
    EXPECT_EQ(Errors(), 0U);
}

// t       2000 | 26500     51400     52400      53400      53499     53500
//         sent | waits               stands     stands               that of 51500 is missed
TEST_F(ChannelARefresh, ThatWaitsIsShownAndMissesNothingWhereItStands)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_013);
    SendAtTwoMilliseconds(ProducerForm::kProviderCalled, 25U);
    EXPECT_EQ(CycleAt(26500U).refresh, kProducerBit);
    EXPECT_FALSE(IsMissedAt(51400U));
    // When it stands for two milliseconds, the next one being due within the first
    for (const std::uint32_t instant_us : {52400U, 53400U})
    {
        const CycleOutcome stood = StandAt(instant_us);
        EXPECT_EQ(stood.refresh, kProducerBit);
        EXPECT_EQ(stood.due, kProducerBit);
        EXPECT_FALSE(IsMissed());
    }
    // Then that one is missed so much later
    EXPECT_FALSE(IsMissedAt(53499U));
    EXPECT_TRUE(IsMissedAt(53500U));
    EXPECT_EQ(Errors(), 1U);
}

TEST_F(ChannelARefresh, ThatIsFarBehindIsNotMissedWhereItStands)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_010);
    SendAtTwoMilliseconds(ProducerForm::kProviderCalled, 25U);
    // Given a refresh that waits, and a late call that leaves more behind
    EXPECT_EQ(CycleAt(200000U).refresh, kProducerBit);
    // When the slot stands, however long, then none of them is missed
    for (std::uint32_t instant_us = 201000U; instant_us <= 300000U; instant_us += 1000U)
    {
        ASSERT_EQ(StandAt(instant_us).due, kProducerBit);
    }
    EXPECT_EQ(Errors(), 0U);
    // and the next call misses one
    EXPECT_TRUE(IsMissedAt(301000U));
    EXPECT_EQ(Errors(), 1U);
}

TEST_F(ChannelARefresh, StandsByTheRefreshTimeThatIsStored)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_CFG_003);
    SendAtTwoMilliseconds(ProducerForm::kProviderCalled, 50U);
    EXPECT_EQ(CycleAt(6000U).due, 0U);
    // Given a refresh time of 10 ms that is stored, when the next call stands
    device.Store(kProducerSlot, ConfigField::kSct, 10U);
    EXPECT_EQ(StandAt(7000U).due, 0U);
    // Then the refresh behind that of 1.5 ms is due at 12.5 ms
    EXPECT_EQ(CycleAt(12499U).due, 0U);
    EXPECT_EQ(CycleAt(12500U).due, kProducerBit);
}

// t       1000          6000                     7000
//         OPERATIONAL   first transmission       the first call in which it may stand
TEST_F(ChannelARefresh, OfTheApplicationDoesNotStandBeforeTheInitialDelayWasOver)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_001);
    device.config.node_id = 10U;
    // Given a slot that stands until the call that may send first, then one call longer
    for (const std::uint32_t last_us : {6000U, 7000U})
    {
        device.clock_us = 0U;
        device.Start();
        for (std::uint32_t instant_us = 1000U; instant_us <= last_us; instant_us += 1000U)
        {
            static_cast<void>(StandAt(instant_us));
        }
        // Then only that call moves its time
        const std::uint32_t over_us = (last_us == 6000U) ? 57501U : 58501U;
        EXPECT_FALSE(IsMissedAt(over_us - 1U)) << last_us;
        EXPECT_TRUE(IsMissedAt(over_us)) << last_us;
    }
}

TEST_F(ChannelARefresh, OfTheApplicationDoesNotStandInTheCallThatMakesItActive)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_011);
    SendAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    device.nmt = NmtState::kPreOperational;
    static_cast<void>(StandAt(10000U));
    // Given OPERATIONAL entered again at 300 ms, when the slot stands in that call
    device.nmt = NmtState::kOperational;
    static_cast<void>(StandAt(300000U));
    // Then its time counts from 300.5 ms
    EXPECT_FALSE(IsMissedAt(352000U));
    EXPECT_TRUE(IsMissedAt(352001U));
}

TEST_F(ChannelARefresh, OfTheApplicationStandsForItsOwnSlotAlone)
{
    Verifies(req::SRS_PROD_012);
    // Given two producers whose application sends, and never does
    device.Start();
    device.Configure(kConsumerSlot, kDirectionProducer, 0x111U, kSent);
    static_cast<void>(device.Cycle());
    static_cast<void>(device.Cycle());
    // When one of them stands for a millisecond, and slots that are not there, while the other one sees an edge
    device.acknowledge = kConsumerBit;
    EXPECT_EQ(CycleAt(2500U).signalled, 0U);
    device.stand = ~kConsumerBit;
    EXPECT_EQ(CycleAt(3500U).signalled, 0U);
    device.stand = 0U;
    // Then the time of the first alone is over later
    EXPECT_EQ(CycleAt(53000U).signalled, 0U);
    EXPECT_EQ(CycleAt(53001U).signalled, kConsumerBit);
    EXPECT_EQ(CycleAt(54000U).signalled, 0U);
    EXPECT_EQ(CycleAt(54001U).signalled, kProducerBit);
}

TEST_F(ChannelARefresh, IsMissedByEachOfTwoThatAreAskedTooLate)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_003);
    // Given two producers whose application sends, and has not within 50 ms and a late cycle from 1.5 ms on
    device.Start();
    device.Configure(kConsumerSlot, kDirectionProducer, 0x111U, kSent);
    static_cast<void>(device.Cycle());
    EXPECT_EQ(CycleAt(53000U).signalled, 0U);
    // When both are asked for, then none is hidden by the request of the other
    device.request = kConsumerBit | kProducerBit;
    const CycleOutcome late = CycleAt(53001U);
    EXPECT_EQ(late.signalled, kConsumerBit | kProducerBit);
    EXPECT_EQ(late.due, kConsumerBit | kProducerBit);
}

TEST_F(ChannelARefresh, StandsWhileTheConfirmationIsExamined)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_008);
    PrepareAtTwoMilliseconds(ProducerForm::kApplicationSends, 50U);
    // Given a pair in flight for more than SRVT, when the slot stands, then it is given up
    EXPECT_EQ(StandAt(22001U).signalled & kProducerBit, kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).signals, kBitOfNoConfirmation);
}

} // namespace
} // namespace counterpoint::channel_a_test
