// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: the refresh that waits. SRVT 20 ms. Times in microseconds since the call that enters OPERATIONAL;
// the first transmission is possible at 500, the counter wraps at 63536.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kEnteredAt = 0xFFFF07D0U;
constexpr std::uint32_t kBusOffBit = 1U << static_cast<std::uint32_t>(SrdoCause::kBusOff);
constexpr std::uint32_t kMissedBit = 1U << static_cast<std::uint32_t>(SrdoCause::kRefreshMissed);
constexpr std::uint32_t kNoConfirmationBit = 1U << static_cast<std::uint32_t>(SrdoCause::kNoConfirmation);
constexpr std::uint32_t kWrongEchoBit = 1U << static_cast<std::uint32_t>(SrdoCause::kWrongEcho);

CycleOutcome At(Rig& rig, std::uint32_t time_us)
{
    return rig.Cycle(kEnteredAt + time_us - rig.Now());
}

void ExpectAt(Rig& rig, std::uint32_t time_us, SrdoMask refresh, SrdoMask due)
{
    const CycleOutcome outcome = At(rig, time_us);
    EXPECT_EQ(outcome.refresh, refresh) << time_us;
    EXPECT_EQ(outcome.due, due) << time_us;
    EXPECT_EQ(outcome.signalled & 2U, 0U) << time_us;
}

/// The one call that reports this of the producer.
void ExpectToldAt(Rig& rig, std::uint32_t time_us, SrdoMask refresh, SrdoMask due, std::uint32_t signals)
{
    const CycleOutcome outcome = At(rig, time_us);
    EXPECT_EQ(outcome.refresh, refresh) << time_us;
    EXPECT_EQ(outcome.due, due) << time_us;
    EXPECT_EQ(outcome.signalled & 2U, 2U) << time_us;
    EXPECT_EQ(rig.Voice().View(1U).signals, signals) << time_us;
}

/// Slot 1 sends each `refresh_ms`, and OPERATIONAL was entered.
std::unique_ptr<Rig> Producing(ProducerForm form, std::uint32_t refresh_ms)
{
    auto rig = std::make_unique<Rig>();
    rig->Setup(1U).form = form;
    rig->Start();
    rig->Store(1U, ConfigField::kSct, refresh_ms);
    EXPECT_EQ(rig->Validated(1U), ConfigFault::kNone);
    EXPECT_EQ(rig->Enter().refresh, 0U);
    EXPECT_EQ(rig->Now(), kEnteredAt);
    return rig;
}

std::unique_ptr<Rig> Provided(std::uint32_t refresh_ms = 25U)
{
    return Producing(ProducerForm::kProviderCalled, refresh_ms);
}

CanFrame Prepared(Rig& rig)
{
    const PreparedPair pair = rig.Voice().Prepare(1U);
    EXPECT_EQ(pair.status, PrepareStatus::kReady);
    return pair.normal;
}

/// Both frames of the pair in flight, 10 us and 20 us from now.
void ConfirmBoth(Rig& rig, const CanFrame& normal)
{
    rig.Confirm(normal);
    rig.Confirm(rig.Voice().InverseFrame(1U));
}

void Send(Rig& rig)
{
    ConfirmBoth(rig, Prepared(rig));
}

/// The refresh at 500 was sent, and a pair that was asked for is in flight since 20000; its normal frame.
CanFrame AskedFor(Rig& rig)
{
    ExpectAt(rig, 500U, 2U, 2U);
    Send(rig);
    rig.Request();
    ExpectAt(rig, 20000U, 0U, 2U);
    return Prepared(rig);
}

TEST(ChannelBRefresh, IsToldFromFallingDueUntilPrepare)
{
    Verifies(req::SRS_PROD_013);
    // Given a provider, then its refresh is told by each call from the one in which it falls due
    const auto rig = Provided();
    ExpectAt(*rig, 499U, 0U, 0U);
    ExpectAt(*rig, 500U, 2U, 2U);
    ExpectAt(*rig, 1500U, 2U, 2U);
    // until it was prepared, confirmed or not,
    const CanFrame normal = Prepared(*rig);
    ExpectAt(*rig, 2500U, 0U, 0U);
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 3500U, 0U, 0U);
    // and the next one as well
    ExpectAt(*rig, 25499U, 0U, 0U);
    ExpectAt(*rig, 25500U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 0U);
}

TEST(ChannelBRefresh, WaitsForAPairUntilItIsSent)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_010);
    // Given a pair in flight, when the refresh falls due, then it is told, and due not before the inverse frame was
    // sent
    const auto rig = Provided();
    const CanFrame normal = AskedFor(*rig);
    ExpectAt(*rig, 25499U, 0U, 0U);
    ExpectAt(*rig, 25500U, 2U, 0U);
    rig->Confirm(normal);
    ExpectAt(*rig, 26000U, 2U, 0U);
    rig->Confirm(rig->Voice().InverseFrame(1U));
    ExpectAt(*rig, 26500U, 2U, 2U);
    // and it is a pair of its own, which shifts no phase and misses nothing
    Send(*rig);
    ExpectAt(*rig, 27000U, 0U, 0U);
    EXPECT_EQ(rig->Voice().View(1U).ordinal, 3U);
    ExpectAt(*rig, 50499U, 0U, 0U);
    ExpectAt(*rig, 50500U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 0U);
    EXPECT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kNone);
}

TEST(ChannelBRefresh, WaitsForAPairUntilItIsGivenUp)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_010);
    // Given a refresh that fell due while a pair was in flight, when that is given up by its transmission
    const auto failed = Provided();
    static_cast<void>(AskedFor(*failed));
    ExpectAt(*failed, 25500U, 2U, 0U);
    failed->Voice().OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
    // then it is due, and nothing but the pair was missed
    ExpectToldAt(*failed, 26000U, 2U, 2U, kBusOffBit);
    // when it is given up by a wrong echo, then so
    const auto wrong = Provided();
    CanFrame echo = AskedFor(*wrong);
    ExpectAt(*wrong, 25500U, 2U, 0U);
    echo.data[0U] = static_cast<std::uint8_t>(echo.data[0U] ^ 1U);
    wrong->Confirm(echo);
    ExpectToldAt(*wrong, 26000U, 2U, 2U, kWrongEchoBit);
    // when no confirmation comes within SRVT, then the call that finds it calls the refresh due
    const auto silent = Provided();
    static_cast<void>(AskedFor(*silent));
    ExpectAt(*silent, 25500U, 2U, 0U);
    ExpectAt(*silent, 40000U, 2U, 0U);
    ExpectToldAt(*silent, 40001U, 2U, 2U, kNoConfirmationBit);
    Send(*silent);
    ExpectAt(*silent, 41000U, 0U, 0U);
    ExpectAt(*silent, 50499U, 0U, 0U);
    ExpectAt(*silent, 50500U, 2U, 2U);
}

TEST(ChannelBRefresh, WaitsForAPairUntilTheOtherChannelFoundItLate)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_009);
    // Given a refresh that waits for a pair whose normal frame is confirmed exactly at SRVT of 20 ms
    const auto rig = Provided();
    const CanFrame normal = AskedFor(*rig);
    ExpectAt(*rig, 25500U, 2U, 0U);
    EXPECT_EQ(rig->Voice().OnConfirm(normal, Instant{kEnteredAt + 40000U}).step, ConfirmStep::kNormal);
    // when the other channel found that late, then the refresh is due in the next call, as in that channel
    rig->Voice().OnTransmitFault(1U, TransmitFault{SrdoCause::kNoConfirmation});
    ExpectToldAt(*rig, 40500U, 2U, 2U, kNoConfirmationBit);
    Send(*rig);
    ExpectAt(*rig, 41000U, 0U, 0U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 1U);
}

TEST(ChannelBRefresh, FallsDueInTheCallThatGivesThePairUp)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_008);
    // Given a pair whose SRVT of 20 ms ends 500 us before a refresh, when one call sees both
    const auto rig = Provided();
    ExpectAt(*rig, 500U, 2U, 2U);
    Send(*rig);
    rig->Request();
    ExpectAt(*rig, 5000U, 0U, 2U);
    static_cast<void>(Prepared(*rig));
    // then the refresh takes place
    ExpectToldAt(*rig, 25500U, 2U, 2U, kNoConfirmationBit);
}

TEST(ChannelBRefresh, FirstOneWaitsForAPairThatWasPreparedEarlier)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_010);
    // Given a pair prepared before the first transmission is possible, when the first refresh falls due
    const auto rig = Provided();
    const CanFrame normal = Prepared(*rig);
    ExpectAt(*rig, 500U, 2U, 0U);
    // then it waits as any other
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 1000U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 0U);
}

TEST(ChannelBRefresh, BehindOneThatWaitsIsMissedWhileAPairIsInFlight)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_013);
    // Given a refresh each 5 ms, and a pair in flight for 15 ms: the first refresh waits
    const auto rig = Provided(5U);
    ExpectAt(*rig, 500U, 2U, 2U);
    const CanFrame normal = Prepared(*rig);
    ExpectAt(*rig, 5500U, 2U, 0U);
    ExpectAt(*rig, 10499U, 2U, 0U);
    // then the second is missed, which is told once,
    ExpectToldAt(*rig, 10500U, 2U, 0U, kMissedBit);
    ExpectAt(*rig, 10501U, 2U, 0U);
    ExpectAt(*rig, 15499U, 2U, 0U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 1U);
    EXPECT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kRefreshMissed);
    // and so is the third; the pair goes on
    ExpectToldAt(*rig, 15500U, 2U, 0U, kMissedBit);
    ConfirmBoth(*rig, normal);
    EXPECT_EQ(rig->Voice().View(1U).ordinal, 1U);
    ExpectAt(*rig, 15600U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 2U);
    // One pair makes up for all of them, and the phase stays.
    Send(*rig);
    ExpectAt(*rig, 20499U, 0U, 0U);
    ExpectAt(*rig, 20500U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 2U);
}

TEST(ChannelBRefresh, BehindOneThatNobodyPreparesIsMissed)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_013);
    // Given a refresh that waits with nothing in flight, when the next one falls due, then that is missed
    const auto rig = Provided();
    ExpectAt(*rig, 500U, 2U, 2U);
    ExpectAt(*rig, 25499U, 2U, 2U);
    ExpectToldAt(*rig, 25500U, 2U, 2U, kMissedBit);
    Send(*rig);
    ExpectAt(*rig, 26000U, 0U, 0U);
    ExpectAt(*rig, 50499U, 0U, 0U);
    ExpectAt(*rig, 50500U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 1U);
}

TEST(ChannelBRefresh, IsUsedUpTogetherWithTheRequest)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_003);
    // Given a request one call before the refresh, when one pair is prepared
    const auto rig = Provided();
    ExpectAt(*rig, 500U, 2U, 2U);
    Send(*rig);
    rig->Request();
    ExpectAt(*rig, 24600U, 0U, 2U);
    ExpectAt(*rig, 25600U, 2U, 2U);
    Send(*rig);
    // then neither waits any more
    ExpectAt(*rig, 26600U, 0U, 0U);
    // and so where both came while a pair was in flight
    rig->Request();
    ExpectAt(*rig, 40000U, 0U, 2U);
    const CanFrame normal = Prepared(*rig);
    rig->Request();
    ExpectAt(*rig, 50500U, 2U, 0U);
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 51500U, 2U, 2U);
    Send(*rig);
    ExpectAt(*rig, 52500U, 0U, 0U);
    EXPECT_EQ(rig->Voice().View(1U).ordinal, 4U);
}

TEST(ChannelBRefresh, IsNotUsedUpByAPrepareThatIsNotReady)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_005);
    // Given a refresh that waits for a pair, when somebody prepares another one
    const auto rig = Provided();
    const CanFrame normal = AskedFor(*rig);
    ExpectAt(*rig, 25500U, 2U, 0U);
    EXPECT_EQ(rig->Voice().Prepare(1U).status, PrepareStatus::kNotProducer);
    // then it goes on waiting
    ExpectAt(*rig, 26000U, 2U, 0U);
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 26500U, 2U, 2U);
}

TEST(ChannelBRefresh, MovesOnByTheTimeItStoodWhileTheOneBeforeWaits)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_013);
    // Given a refresh that waits for a pair, when the phase stands for 1000 us meanwhile
    const auto rig = Provided();
    const CanFrame normal = AskedFor(*rig);
    ExpectAt(*rig, 25500U, 2U, 0U);
    rig->Stand();
    ExpectAt(*rig, 26500U, 2U, 0U);
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 27500U, 2U, 2U);
    Send(*rig);
    // then the next one comes so much later
    ExpectAt(*rig, 51499U, 0U, 0U);
    ExpectAt(*rig, 51500U, 2U, 2U);
}

TEST(ChannelBRefresh, IsOffOutsideOperational)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_011);
    for (const bool is_in_flight : {false, true})
    {
        // Given a refresh that waits, with a pair in flight and without
        const auto rig = Provided();
        static_cast<void>(AskedFor(*rig));
        if (!is_in_flight)
        {
            rig->Voice().OnTransmitFault(1U, TransmitFault{SrdoCause::kTransmitQueue});
        }
        EXPECT_EQ(At(*rig, 25500U).refresh, 2U);
        // when OPERATIONAL is left, then there is none,
        EXPECT_EQ(rig->Leave().refresh, 0U);
        EXPECT_EQ(rig->Cycle(60000U).refresh, 0U);
        // and not before the first transmission is possible again
        EXPECT_EQ(rig->Enter().refresh, 0U);
        EXPECT_EQ(rig->Cycle(499U).refresh, 0U);
        const CycleOutcome outcome = rig->Cycle(1U);
        EXPECT_EQ(outcome.refresh, 2U);
        EXPECT_EQ(outcome.due, 2U);
        // nor behind a Restart
        rig->Start();
        EXPECT_EQ(rig->Enter().refresh, 0U);
    }
}

TEST(ChannelBRefresh, IsNotThatOfTheApplication)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_010);
    // Given an application that sends, when it asks, when its pair is in flight and when it was silent for too long
    const auto rig = Producing(ProducerForm::kApplicationSends, 25U);
    rig->Request();
    ExpectAt(*rig, 500U, 0U, 2U);
    ExpectAt(*rig, 1000U, 0U, 2U);
    const CanFrame normal = Prepared(*rig);
    rig->Request();
    ExpectAt(*rig, 2000U, 0U, 0U);
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 3000U, 0U, 2U);
    Send(*rig);
    // then no refresh is told. Silence: 25 ms, a cycle of 1 ms and its tolerance of 500 us since the call at 3000.
    ExpectAt(*rig, 29500U, 0U, 0U);
    ExpectToldAt(*rig, 29501U, 0U, 0U, kMissedBit);
    ExpectAt(*rig, 30000U, 0U, 0U);
}

TEST(ChannelBRefresh, IsToldOfEachProducerByItself)
{
    Verifies(req::SRS_PROD_013);
    // Given two providers, slot 1 each 25 ms and slot 2 each 50 ms
    const auto rig = std::make_unique<Rig>();
    rig->Setup(1U).form = ProducerForm::kProviderCalled;
    rig->Setup(2U).form = ProducerForm::kProviderCalled;
    rig->SetFree(32U, MapAccess::kProducer);
    rig->Start();
    rig->Store(1U, ConfigField::kSct, 25U);
    ASSERT_EQ(rig->Validated(1U), ConfigFault::kNone);
    rig->Store(2U, ConfigField::kDirection, 1U);
    ASSERT_EQ(rig->Map(2U, {0x63000120U, 0x63010120U}), ConfigFault::kNone);
    EXPECT_EQ(rig->Enter().refresh, 0U);
    ExpectAt(*rig, 500U, 6U, 6U);
    // when one of them is prepared, then the other one goes on waiting
    Send(*rig);
    ExpectAt(*rig, 1000U, 4U, 4U);
    // also with a pair of the first in flight
    rig->Request();
    ExpectAt(*rig, 20000U, 4U, 6U);
    const CanFrame normal = Prepared(*rig);
    ExpectAt(*rig, 25500U, 6U, 4U);
    EXPECT_EQ(rig->Voice().Prepare(2U).status, PrepareStatus::kReady);
    ExpectAt(*rig, 26000U, 2U, 0U);
    ConfirmBoth(*rig, normal);
    ExpectAt(*rig, 26500U, 2U, 2U);
}

TEST(ChannelBRefresh, RequestOfTheCallThatFindsItMissedIsLate)
{
    Verifies(req::SRS_PROD_010);
    // Given an application that may be silent for 26500 us, until 27000, when it asks in the first call behind that
    const auto rig = Producing(ProducerForm::kApplicationSends, 25U);
    ExpectAt(*rig, 500U, 0U, 0U);
    rig->Request();
    // then the refresh is missed, and due,
    ExpectToldAt(*rig, 27001U, 0U, 2U, kMissedBit);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 1U);
    // and the time counts anew from that call
    Send(*rig);
    ExpectAt(*rig, 53501U, 0U, 0U);
    ExpectToldAt(*rig, 53502U, 0U, 0U, kMissedBit);
    // also where the first call that may send is the one
    const auto first = Producing(ProducerForm::kApplicationSends, 25U);
    first->Request();
    ExpectToldAt(*first, 27001U, 0U, 2U, kMissedBit);
}

TEST(ChannelBRefresh, RequestOfAnEarlierCallIsInTime)
{
    Verifies(req::SRS_PROD_010);
    for (const std::uint32_t asked_us : {499U, 27000U})
    {
        // Given a request in the last call before one may send, or in the last in which the silence is in time
        const auto rig = Producing(ProducerForm::kApplicationSends, 25U);
        rig->Request();
        ExpectAt(*rig, asked_us, 0U, (asked_us == 499U) ? 0U : 2U);
        // then nothing is missed while it waits, whether it is made once more or not
        rig->Request();
        ExpectAt(*rig, 27001U, 0U, 2U);
        ExpectAt(*rig, 27002U, 0U, 2U);
        ExpectAt(*rig, 90000U, 0U, 2U);
        EXPECT_EQ(rig->Voice().View(1U).error_count, 0U);
    }
}

TEST(ChannelBRefresh, RequestThatIsLateAndWaitsForAPairIsToldOnce)
{
    Verifies(req::SRS_PROD_010);
    for (const bool is_asked : {true, false})
    {
        // Given an application that may be silent for 6500 us, and a pair in flight since 500
        const auto rig = Producing(ProducerForm::kApplicationSends, 5U);
        rig->Request();
        ExpectAt(*rig, 500U, 0U, 2U);
        const CanFrame normal = Prepared(*rig);
        ExpectAt(*rig, 7000U, 0U, 0U);
        // when the call that finds it silent brings a request, then that is told
        if (is_asked)
        {
            rig->Request();
        }
        ExpectToldAt(*rig, 7001U, 0U, 0U, kMissedBit);
        ExpectAt(*rig, 13501U, 0U, 0U);
        // and the request, which goes on waiting, is no silence; without one there is
        EXPECT_EQ(At(*rig, 13502U).signalled & 2U, is_asked ? 0U : 2U);
        ExpectAt(*rig, 20000U, 0U, 0U);
        EXPECT_EQ(rig->Voice().View(1U).error_count, is_asked ? 1U : 2U);
        ConfirmBoth(*rig, normal);
        EXPECT_EQ(At(*rig, 20500U).due, is_asked ? 2U : 0U);
    }
}

TEST(ChannelBRefresh, SilenceOfTheApplicationMovesOnByTheTimeItStood)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_010);
    // 500 one may send | 27000 the silence is just in time | 28000 stood for 1000 us: until 28000
    const auto rig = Producing(ProducerForm::kApplicationSends, 25U);
    ExpectAt(*rig, 500U, 0U, 0U);
    ExpectAt(*rig, 27000U, 0U, 0U);
    rig->Stand();
    ExpectAt(*rig, 28000U, 0U, 0U);
    ExpectToldAt(*rig, 28001U, 0U, 0U, kMissedBit);
    // It is until 54501 now. When it stands for as long as 71999 us, then nothing is missed, and a request is due
    rig->Stand();
    rig->Request();
    ExpectAt(*rig, 100000U, 0U, 2U);
    Send(*rig);
    // and what runs behind the pair is not moved
    ExpectAt(*rig, 126500U, 0U, 0U);
    ExpectToldAt(*rig, 126501U, 0U, 0U, kMissedBit);
}

TEST(ChannelBRefresh, SilenceOfTheApplicationDoesNotStandBeforeOneMaySend)
{
    Verifies(req::SRS_PROD_012);
    // Given a call before which the initial delay was not over, when it stands, then it is silent from 500 on
    const auto rig = Producing(ProducerForm::kApplicationSends, 25U);
    rig->Stand();
    ExpectAt(*rig, 499U, 0U, 0U);
    rig->Stand();
    ExpectAt(*rig, 600U, 0U, 0U);
    ExpectAt(*rig, 27000U, 0U, 0U);
    ExpectToldAt(*rig, 27001U, 0U, 0U, kMissedBit);
    // nor does it stand in the call that makes it active again
    EXPECT_EQ(rig->Leave().is_tx, 0U);
    rig->Stand();
    EXPECT_EQ(rig->Enter().is_tx, 1U);
    EXPECT_EQ(rig->Cycle(27000U).signalled & 2U, 0U);
    EXPECT_EQ(rig->Cycle(1U).signalled & 2U, 2U);
}

TEST(ChannelBRefresh, IsNotExaminedWhileItStandsHoweverFarBehind)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_013);
    // Given a refresh each 5 ms and no call from 500 to 20500, which examines that of 5500; that of 10500 is next
    const auto rig = Provided(5U);
    ExpectAt(*rig, 500U, 2U, 2U);
    Send(*rig);
    ExpectAt(*rig, 20500U, 2U, 2U);
    Send(*rig);
    // when it stands for 1000 us, then that does not fall due but in the next call
    rig->Stand();
    ExpectAt(*rig, 21500U, 0U, 0U);
    ExpectAt(*rig, 22500U, 2U, 2U);
    // when it stands while that one waits, then it goes on waiting, and the next one is not missed but in the next call
    rig->Stand();
    ExpectAt(*rig, 23500U, 2U, 2U);
    ExpectToldAt(*rig, 24500U, 2U, 2U, kMissedBit);
    // 24500: 17500 was missed | 24600: 22500 is missed | 27500, which is 25500 moved on twice
    ExpectToldAt(*rig, 24600U, 2U, 2U, kMissedBit);
    Send(*rig);
    ExpectAt(*rig, 27499U, 0U, 0U);
    ExpectAt(*rig, 27500U, 2U, 2U);
    EXPECT_EQ(rig->Voice().View(1U).error_count, 2U);
}

TEST(ChannelBRefresh, StandsWithoutTheConfirmation)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_008);
    for (const ProducerForm form : {ProducerForm::kProviderCalled, ProducerForm::kApplicationSends})
    {
        // Given a pair in flight since 500, when its slot stands in the call behind SRVT of 20 ms
        const auto rig = Producing(form, 25U);
        rig->Request();
        EXPECT_EQ(At(*rig, 500U).due, 2U);
        static_cast<void>(Prepared(*rig));
        rig->Stand();
        ExpectAt(*rig, 20500U, 0U, 0U);
        rig->Stand();
        // then the confirmation is missing
        ExpectToldAt(*rig, 20501U, 0U, 0U, kNoConfirmationBit);
    }
}

} // namespace
} // namespace counterpoint
