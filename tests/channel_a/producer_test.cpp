// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel A takes for the confirmation of a pair, by the stamps of both frames, what its inverse frame is, and
// which refresh waits.
#include "tests/channel_a/device.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace counterpoint::channel_a_test
{
namespace
{

constexpr std::uint32_t kBeforeTheWrapUs = 0xFFFFF000U; // 4096 us before the counter wraps: within SRVT.

// t        `kBeforeTheWrapUs`     + stamp
//          cycle, prepared        normal frame confirmed
Confirmation ConfirmedAfter(Device& device, std::uint32_t stamp_us)
{
    device.clock_us = kBeforeTheWrapUs - kCycleUs - kCycleUs;
    device.Start();
    static_cast<void>(device.Cycle());
    device.request = kProducerBit;
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
    return device.channel.OnConfirm(Device::FrameOf(0x101U, 8U, 0U, false), Instant{kBeforeTheWrapUs + stamp_us});
}

class ChannelAProducer : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        // The objects hold what FrameOf makes of 0.
        for (std::uint8_t place = 0U; place < 8U; ++place)
        {
            fenced->device.words[4U + (place / 4U)][place % 4U] = place;
        }
    }

    std::unique_ptr<FencedDevice> fenced = std::make_unique<FencedDevice>();
};

TEST_F(ChannelAProducer, TakesTheNormalFrameOnSrvtOverAWrap)
{
    Verifies(req::SRS_PROD_008);
    Verifies(req::SRS_TIME_001);
    Device& device = fenced->device;
    const Confirmation confirmation = ConfirmedAfter(device, 20000U);
    EXPECT_EQ(confirmation.slot, kProducerSlot);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNormal);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 0U);
    // The inverse frame has SRVT from the stamp of the normal one
    const CanFrame inverse = Device::FrameOf(0x102U, 8U, 0U, true);
    EXPECT_EQ(device.channel.OnConfirm(inverse, Instant{kBeforeTheWrapUs + 40000U}).step, ConfirmStep::kPair);
}

TEST_F(ChannelAProducer, GivesUpANormalFrameAMicrosecondAfterSrvtOverAWrap)
{
    Verifies(req::SRS_PROD_008);
    Verifies(req::SRS_PROD_007);
    Device& device = fenced->device;
    const Confirmation confirmation = ConfirmedAfter(device, 20001U);
    EXPECT_EQ(confirmation.slot, kNoSlot);
    EXPECT_EQ(confirmation.step, ConfirmStep::kNone);
    const SrdoView view = device.channel.View(kProducerSlot);
    EXPECT_EQ(view.first_cause, SrdoCause::kNoConfirmation);
    EXPECT_EQ(view.error_count, 1U);
    // and its inverse frame confirms nothing
    const CanFrame inverse = Device::FrameOf(0x102U, 8U, 0U, true);
    EXPECT_EQ(device.channel.OnConfirm(inverse, Instant{kBeforeTheWrapUs + 20002U}).step, ConfirmStep::kNone);
    EXPECT_EQ(device.channel.View(kProducerSlot).ordinal, 0U);
}

// Two SRDO objects of four bytes, 00h to 07h, confirmed as far as the normal frame.
void AwaitTheInverse(Device& device)
{
    device.clock_us = 0U;
    device.Start();
    static_cast<void>(device.Cycle());
    static_cast<void>(device.Cycle());
    ASSERT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
    const CanFrame normal = Device::FrameOf(0x101U, 8U, 0U, false);
    ASSERT_EQ(device.channel.OnConfirm(normal, Instant{device.clock_us}).step, ConfirmStep::kNormal);
}

bool IsEmpty(const CanFrame& frame)
{
    static constexpr std::uint8_t kZeros[8] = {};
    return (frame.identifier == 0U) && (frame.kind == FrameKind::kInvalid) && (frame.port == CanPortId::kInvalid) &&
           (frame.length_bytes == 0U) && (std::memcmp(frame.data, kZeros, sizeof(kZeros)) == 0);
}

TEST_F(ChannelAProducer, HasTheInverseFrameWhileItIsAwaited)
{
    Verifies(req::SRS_PROD_006);
    Device& device = fenced->device;
    device.config.inverse_port = CanPortId::kSecond;
    // Given a pair in flight, whose normal frame has not been confirmed
    device.Start();
    static_cast<void>(device.Cycle());
    static_cast<void>(device.Cycle());
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    ASSERT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    // When it is confirmed
    const CanFrame normal = Device::FrameOf(0x101U, 8U, 0U, false);
    ASSERT_EQ(device.channel.OnConfirm(normal, Instant{device.clock_us}).step, ConfirmStep::kNormal);
    // Then the inverse frame is there as often as it is asked for, whatever the objects hold meanwhile
    device.words[4][0] = 0x55U;
    const channel_a::Channel& asked = device.channel;
    for (std::uint32_t time = 0U; time < 3U; ++time)
    {
        const CanFrame inverse = asked.InverseFrame(kProducerSlot);
        static constexpr std::uint8_t kInverted[8] = {0xFFU, 0xFEU, 0xFDU, 0xFCU, 0xFBU, 0xFAU, 0xF9U, 0xF8U};
        EXPECT_EQ(inverse.identifier, 0x102U);
        EXPECT_EQ(inverse.kind, FrameKind::kData);
        EXPECT_EQ(inverse.port, CanPortId::kSecond);
        EXPECT_EQ(inverse.length_bytes, 8U);
        EXPECT_EQ(std::memcmp(inverse.data, kInverted, sizeof(kInverted)), 0);
    }
    // and no more once the pair is sent
    const CanFrame inverse = Device::FrameOf(0x102U, 8U, 0U, true);
    ASSERT_EQ(device.channel.OnConfirm(inverse, Instant{device.clock_us}).step, ConfirmStep::kPair);
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kConsumerSlot)));
}

TEST_F(ChannelAProducer, InvertsEveryBitOfTheLastByteAndNoneBehindIt)
{
    Verifies(req::SRS_PROD_005);
    Verifies(req::SRS_PROD_006);
    static constexpr std::uint32_t kNineBits[2] = {0x22300109U, 0x22310109U};
    Device& device = fenced->device;
    // Given an object of nine bits, 1A5h, whose last byte holds seven other bits
    device.bits[4][0] = 0xA5U;
    device.bits[4][1] = 0xABU;
    device.Start();
    device.Map(kProducerSlot, kNineBits, 2U);
    ASSERT_EQ(device.Sign(kProducerSlot).fault, ConfigFault::kNone);
    static_cast<void>(device.Cycle());
    static_cast<void>(device.Cycle());
    const PreparedPair pair = device.channel.Prepare(kProducerSlot);
    static constexpr std::uint8_t kNormal[8] = {0xA5U, 0x01U, 0U, 0U, 0U, 0U, 0U, 0U};
    ASSERT_EQ(pair.normal.length_bytes, 2U);
    EXPECT_EQ(std::memcmp(pair.normal.data, kNormal, sizeof(kNormal)), 0);
    ASSERT_EQ(device.channel.OnConfirm(pair.normal, Instant{device.clock_us}).step, ConfirmStep::kNormal);
    // Then the bits above the mapped ones are 1 in the inverse frame, and the bytes behind it 0
    static constexpr std::uint8_t kInverse[8] = {0x5AU, 0xFEU, 0U, 0U, 0U, 0U, 0U, 0U};
    const CanFrame inverse = device.channel.InverseFrame(kProducerSlot);
    EXPECT_EQ(inverse.length_bytes, 2U);
    EXPECT_EQ(std::memcmp(inverse.data, kInverse, sizeof(kInverse)), 0);
    EXPECT_EQ(device.channel.OnConfirm(inverse, Instant{device.clock_us}).step, ConfirmStep::kPair);
}

TEST_F(ChannelAProducer, HasNoInverseFrameOfAPairThatIsOver)
{
    Verifies(req::SRS_PROD_006);
    Verifies(req::SRS_PROD_009);
    Verifies(req::SRS_PROD_011);
    Device& device = fenced->device;
    // After another echo than what was sent
    AwaitTheInverse(device);
    static_cast<void>(device.channel.OnConfirm(Device::FrameOf(0x102U, 8U, 1U, true), Instant{device.clock_us}));
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    // after what the kernel says of the transmission
    AwaitTheInverse(device);
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kNotInverse});
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    // a microsecond after SRVT, not on it
    AwaitTheInverse(device);
    static_cast<void>(device.Cycle(20000U));
    EXPECT_FALSE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    static_cast<void>(device.Cycle(1U));
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
    // and when OPERATIONAL is left
    AwaitTheInverse(device);
    device.nmt = NmtState::kPreOperational;
    static_cast<void>(device.Cycle());
    EXPECT_TRUE(IsEmpty(device.channel.InverseFrame(kProducerSlot)));
}

TEST_F(ChannelAProducer, KeepsTheCauseOfAFaultThatTheEdgeCameWith)
{
    Verifies(req::SRS_REL_005);
    Verifies(req::SRS_PROD_009);
    Device& device = fenced->device;
    // Given a level of 0, then a first 1, when the pair is given up and the same call sees the edge
    AwaitTheInverse(device);
    device.acknowledge = kProducerBit;
    static_cast<void>(device.Cycle());
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kBusOff});
    EXPECT_EQ(device.Cycle().signalled, kProducerBit);
    // Then the edge is forgotten
    EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kBusOff);
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kBusOff);
    // and the next one acknowledges
    for (const SrdoMask input : {SrdoMask{0U}, SrdoMask{0U}, kProducerBit, kProducerBit})
    {
        EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kBusOff);
        device.acknowledge = input;
        static_cast<void>(device.Cycle());
    }
    EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kNone);
}

TEST_F(ChannelAProducer, KeepsItsPhaseWhereItStandsAndIsAcknowledgedAtOnce)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_REL_005);
    Device& device = fenced->device;
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    Release(device);
    static_cast<void>(device.channel.Prepare(kProducerSlot));
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kTransmitQueue});
    // Given the first refresh at 1.5 ms, when the phase stands still in the very cycle that sees the edge
    device.acknowledge = kProducerBit;
    static_cast<void>(device.Cycle());
    device.stand = kProducerBit;
    static_cast<void>(device.Cycle());
    device.stand = 0U;
    // Then the next refresh is due 51 ms after the first one
    EXPECT_EQ(device.Cycle(48000U).due, 0U);
    EXPECT_EQ(device.Cycle(500U).due, kProducerBit);
}

TEST_F(ChannelAProducer, HasTheRefreshTimeThatIsStored)
{
    Verifies(req::SRS_PROD_002);
    Verifies(req::SRS_CFG_003);
    Device& device = fenced->device;
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    Release(device);
    static_cast<void>(device.channel.Prepare(kProducerSlot));
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kTransmitQueue});
    for (std::uint32_t time = 0U; time < 4U; ++time)
    {
        static_cast<void>(device.Cycle());
    }
    // Given 6 ms of which nothing is to be told, when a refresh time of 10 ms is stored
    device.Store(kProducerSlot, ConfigField::kSct, 10U);
    // Then the refresh behind that of 1.5 ms is due at 11.5 ms
    EXPECT_EQ(device.Cycle(5499U).due, 0U);
    EXPECT_EQ(device.Cycle(1U).due, kProducerBit);
}

// The call at an instant.
CycleOutcome CycleAt(Device& device, std::uint32_t instant_us)
{
    return device.Cycle(instant_us - device.clock_us);
}

// A producer that is called, whose first refresh fell due at 1.5 ms; the call at 2 ms.
CycleOutcome CallAtTwoMilliseconds(Device& device, std::uint32_t refresh_ms)
{
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    device.clock_us = 0U;
    device.Start();
    device.Store(kProducerSlot, ConfigField::kSct, refresh_ms);
    EXPECT_EQ(device.Sign(kProducerSlot).fault, ConfigFault::kNone);
    EXPECT_EQ(device.Cycle().refresh, 0U);
    return device.Cycle();
}

void Prepare(Device& device)
{
    ASSERT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
}

ConfirmStep Confirm(Device& device, bool is_inverse)
{
    const std::uint32_t identifier = is_inverse ? 0x102U : 0x101U;
    return device.channel.OnConfirm(Device::FrameOf(identifier, 8U, 0U, is_inverse), Instant{device.clock_us}).step;
}

void SendPair(Device& device)
{
    Prepare(device);
    ASSERT_EQ(Confirm(device, false), ConfirmStep::kNormal);
    ASSERT_EQ(Confirm(device, true), ConfirmStep::kPair);
}

// The first refresh is sent; a pair that was asked for is on its way from 51 ms on, when the refresh of 51.5 ms comes.
void AskBeforeTheRefresh(Device& device)
{
    static_cast<void>(CallAtTwoMilliseconds(device, 50U));
    SendPair(device);
    device.request = kProducerBit;
    const CycleOutcome asked = CycleAt(device, 51000U);
    device.request = 0U;
    EXPECT_EQ(asked.due, kProducerBit);
    EXPECT_EQ(asked.refresh, 0U);
    Prepare(device);
}

TEST_F(ChannelAProducer, TellsTheRefreshUntilItIsPrepared)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_004);
    Device& device = fenced->device;
    // Given a refresh that nobody prepares yet
    EXPECT_EQ(CallAtTwoMilliseconds(device, 50U).refresh, kProducerBit);
    const CycleOutcome waiting = CycleAt(device, 3000U);
    EXPECT_EQ(waiting.refresh, kProducerBit);
    EXPECT_EQ(waiting.due, kProducerBit);
    // When its pair is sent, then it waits no more
    Prepare(device);
    EXPECT_EQ(CycleAt(device, 4000U).refresh, 0U);
    ASSERT_EQ(Confirm(device, false), ConfirmStep::kNormal);
    ASSERT_EQ(Confirm(device, true), ConfirmStep::kPair);
    // until the next one falls due
    const CycleOutcome before = CycleAt(device, 51499U);
    EXPECT_EQ(before.refresh, 0U);
    EXPECT_EQ(before.due, 0U);
    const CycleOutcome next = CycleAt(device, 51500U);
    EXPECT_EQ(next.refresh, kProducerBit);
    EXPECT_EQ(next.due, kProducerBit);
}

TEST_F(ChannelAProducer, KeepsARefreshInFlightUntilThePairIsSent)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_004);
    Verifies(req::SRS_PROD_010);
    Device& device = fenced->device;
    AskBeforeTheRefresh(device);
    EXPECT_EQ(CycleAt(device, 51499U).refresh, 0U);
    // When the refresh falls due with the normal frame on its way, then it is no fault, and waits
    const CycleOutcome fallen = CycleAt(device, 51500U);
    EXPECT_EQ(fallen.refresh, kProducerBit);
    EXPECT_EQ(fallen.due, 0U);
    EXPECT_EQ(fallen.signalled, 0U);
    ASSERT_EQ(Confirm(device, false), ConfirmStep::kNormal);
    const CycleOutcome waiting = CycleAt(device, 52000U);
    EXPECT_EQ(waiting.refresh, kProducerBit);
    EXPECT_EQ(waiting.due, 0U);
    // and is due once the pair was sent
    ASSERT_EQ(Confirm(device, true), ConfirmStep::kPair);
    const CycleOutcome due = CycleAt(device, 53000U);
    EXPECT_EQ(due.refresh, kProducerBit);
    EXPECT_EQ(due.due, kProducerBit);
    SendPair(device);
    EXPECT_EQ(CycleAt(device, 54000U).due, 0U);
    // The next one keeps its phase
    EXPECT_EQ(CycleAt(device, 101499U).due, 0U);
    EXPECT_EQ(CycleAt(device, 101500U).due, kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 0U);
    EXPECT_EQ(device.channel.View(kProducerSlot).ordinal, 3U);
}

TEST_F(ChannelAProducer, KeepsARefreshInFlightUntilThePairIsGivenUp)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_009);
    Verifies(req::SRS_PROD_010);
    Device& device = fenced->device;
    // By what the kernel says of the transmission
    AskBeforeTheRefresh(device);
    EXPECT_EQ(CycleAt(device, 51500U).due, 0U);
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kBusOff});
    const CycleOutcome told = CycleAt(device, 52000U);
    EXPECT_EQ(told.refresh, kProducerBit);
    EXPECT_EQ(told.due, kProducerBit);
    // by another echo
    AskBeforeTheRefresh(device);
    EXPECT_EQ(CycleAt(device, 51500U).due, 0U);
    EXPECT_EQ(device.channel.OnConfirm(Device::FrameOf(0x101U, 8U, 1U, false), Instant{51500U}).step,
              ConfirmStep::kNone);
    EXPECT_EQ(CycleAt(device, 52000U).due, kProducerBit);
    // a microsecond after SRVT, not on it
    AskBeforeTheRefresh(device);
    EXPECT_EQ(CycleAt(device, 71000U).due, 0U);
    const CycleOutcome late = CycleAt(device, 71001U);
    EXPECT_EQ(late.refresh, kProducerBit);
    EXPECT_EQ(late.due, kProducerBit);
    // and where the call that gives it up is the one in which the refresh falls due
    AskBeforeTheRefresh(device);
    const CycleOutcome both = CycleAt(device, 71001U);
    EXPECT_EQ(both.refresh, kProducerBit);
    EXPECT_EQ(both.due, kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kNoConfirmation);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 1U);
}

TEST_F(ChannelAProducer, MissesTheRefreshBehindOneThatWaits)
{
    Verifies(req::SRS_PROD_010);
    Verifies(req::SRS_PROD_013);
    static constexpr std::uint32_t kBitOfMissed = std::uint32_t{1U}
                                                  << static_cast<std::uint32_t>(SrdoCause::kRefreshMissed);
    Device& device = fenced->device;
    // Given a pair that is on its way for longer than the refresh time, from 20 ms on
    static_cast<void>(CallAtTwoMilliseconds(device, 25U));
    SendPair(device);
    device.request = kProducerBit;
    EXPECT_EQ(CycleAt(device, 20000U).due, kProducerBit);
    device.request = 0U;
    Prepare(device);
    EXPECT_EQ(CycleAt(device, 26500U).refresh, kProducerBit);
    EXPECT_EQ(CycleAt(device, 40000U).signalled & kProducerBit, 0U);
    ASSERT_EQ(Confirm(device, false), ConfirmStep::kNormal);
    EXPECT_EQ(CycleAt(device, 51499U).signalled & kProducerBit, 0U);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 0U);
    // When the second refresh falls due, then it is missed, once, and the pair goes on
    const CycleOutcome missed = CycleAt(device, 51500U);
    EXPECT_EQ(missed.signalled & kProducerBit, kProducerBit);
    EXPECT_EQ(missed.refresh, kProducerBit);
    EXPECT_EQ(missed.due, 0U);
    EXPECT_EQ(device.channel.View(kProducerSlot).signals, kBitOfMissed);
    EXPECT_EQ(CycleAt(device, 52000U).signalled & kProducerBit, 0U);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 1U);
    ASSERT_EQ(Confirm(device, true), ConfirmStep::kPair);
    // The one that waits is due until the next one in phase is missed, too
    EXPECT_EQ(CycleAt(device, 53000U).due, kProducerBit);
    EXPECT_EQ(CycleAt(device, 76499U).signalled & kProducerBit, 0U);
    const CycleOutcome next = CycleAt(device, 76500U);
    EXPECT_EQ(next.signalled & kProducerBit, kProducerBit);
    EXPECT_EQ(next.due, kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 2U);
    // and the one behind that is none of those that were missed
    SendPair(device);
    EXPECT_EQ(CycleAt(device, 101499U).refresh, 0U);
    EXPECT_EQ(CycleAt(device, 101500U).refresh, kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).error_count, 2U);
}

TEST_F(ChannelAProducer, UsesUpRequestAndRefreshByOnePair)
{
    Verifies(req::SRS_PROD_005);
    Verifies(req::SRS_PROD_013);
    Device& device = fenced->device;
    // Given a request and a refresh that came while a pair was on its way
    AskBeforeTheRefresh(device);
    device.request = kProducerBit;
    EXPECT_EQ(CycleAt(device, 51500U).due, 0U);
    device.request = 0U;
    // A Prepare that has no effect uses up none of them
    EXPECT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kNotProducer);
    EXPECT_EQ(CycleAt(device, 52000U).refresh, kProducerBit);
    ASSERT_EQ(Confirm(device, false), ConfirmStep::kNormal);
    ASSERT_EQ(Confirm(device, true), ConfirmStep::kPair);
    const CycleOutcome both = CycleAt(device, 53000U);
    EXPECT_EQ(both.refresh, kProducerBit);
    EXPECT_EQ(both.due, kProducerBit);
    // One that is kReady uses up both
    SendPair(device);
    const CycleOutcome none = CycleAt(device, 54000U);
    EXPECT_EQ(none.refresh, 0U);
    EXPECT_EQ(none.due, 0U);
}

TEST_F(ChannelAProducer, UsesUpTheRefreshOfNoOtherProducer)
{
    Verifies(req::SRS_PROD_005);
    Verifies(req::SRS_PROD_013);
    Device& device = fenced->device;
    // Given a second producer that is called, in the other slot
    device.setups[kConsumerSlot].form = ProducerForm::kProviderCalled;
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    device.Start();
    device.Configure(kConsumerSlot, kDirectionProducer, 0x111U, kSent);
    static_cast<void>(device.Cycle());
    EXPECT_EQ(device.Cycle().refresh, kConsumerBit | kProducerBit);
    // When one is prepared, then the refresh of the other one goes on waiting
    Prepare(device);
    const CycleOutcome outcome = device.Cycle();
    EXPECT_EQ(outcome.refresh, kConsumerBit);
    EXPECT_EQ(outcome.due, kConsumerBit);
}

TEST_F(ChannelAProducer, StandsWhileARefreshWaitsInFlight)
{
    Verifies(req::SRS_PROD_012);
    Verifies(req::SRS_PROD_013);
    Device& device = fenced->device;
    AskBeforeTheRefresh(device);
    EXPECT_EQ(CycleAt(device, 51500U).refresh, kProducerBit);
    // When the phase stands for half a millisecond
    device.stand = kProducerBit;
    EXPECT_EQ(CycleAt(device, 52000U).refresh, kProducerBit);
    device.stand = 0U;
    device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kBusOff});
    EXPECT_EQ(CycleAt(device, 53000U).due, kProducerBit);
    SendPair(device);
    // Then so much later the next one falls due
    EXPECT_EQ(CycleAt(device, 101999U).refresh, 0U);
    EXPECT_EQ(CycleAt(device, 102000U).refresh, kProducerBit);
}

TEST_F(ChannelAProducer, HasNoRefreshOutsideOperational)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_011);
    Device& device = fenced->device;
    // Given a refresh that waits for a pair in flight, then one that is due, when OPERATIONAL is left
    for (std::uint32_t time = 0U; time < 2U; ++time)
    {
        device.nmt = NmtState::kOperational;
        AskBeforeTheRefresh(device);
        EXPECT_EQ(CycleAt(device, 51500U).refresh, kProducerBit);
        if (time == 1U)
        {
            device.channel.OnTransmitFault(kProducerSlot, TransmitFault{SrdoCause::kBusOff});
            EXPECT_EQ(CycleAt(device, 51600U).due, kProducerBit);
        }
        device.nmt = NmtState::kPreOperational;
        const CycleOutcome left = CycleAt(device, 52000U);
        EXPECT_EQ(left.refresh, 0U);
        EXPECT_EQ(left.due, 0U);
        EXPECT_EQ(CycleAt(device, 200000U).refresh, 0U);
        // Then it starts anew with OPERATIONAL
        device.nmt = NmtState::kOperational;
        EXPECT_EQ(CycleAt(device, 300000U).refresh, 0U);
        EXPECT_EQ(CycleAt(device, 300499U).refresh, 0U);
        const CycleOutcome first = CycleAt(device, 300500U);
        EXPECT_EQ(first.refresh, kProducerBit);
        EXPECT_EQ(first.due, kProducerBit);
        EXPECT_EQ(first.signalled & kProducerBit, 0U);
    }
    // and a configuration that is not valid is left, too
    device.Store(kNoSlot, ConfigField::kConfigurationValid, 0U);
    EXPECT_EQ(CycleAt(device, 301000U).refresh, 0U);
}

TEST_F(ChannelAProducer, HasNoRefreshWhereTheApplicationSends)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_PROD_010);
    Device& device = fenced->device;
    device.config.cycle_tolerance_us = 500U;
    device.Start();
    static_cast<void>(device.Cycle());
    // Given a request that waits
    device.request = kProducerBit;
    const CycleOutcome asked = device.Cycle();
    device.request = 0U;
    EXPECT_EQ(asked.due, kProducerBit);
    EXPECT_EQ(asked.refresh, 0U);
    SendPair(device);
    // When nothing is sent for 50 ms and a late cycle, from 2 ms on
    EXPECT_EQ(CycleAt(device, 53500U).signalled & kProducerBit, 0U);
    const CycleOutcome silent = CycleAt(device, 53501U);
    EXPECT_EQ(silent.signalled & kProducerBit, kProducerBit);
    EXPECT_EQ(device.channel.View(kProducerSlot).first_cause, SrdoCause::kRefreshMissed);
    // Then no refresh waits
    EXPECT_EQ(silent.refresh, 0U);
    EXPECT_EQ(silent.due, 0U);
    EXPECT_EQ(CycleAt(device, 54000U).refresh, 0U);
}

TEST_F(ChannelAProducer, HasNoRefreshOnceItsRecordIsCorrupted)
{
    Verifies(req::SRS_PROD_013);
    Verifies(req::SRS_CONS_024);
    Device& device = fenced->device;
    ASSERT_EQ(CallAtTwoMilliseconds(device, 50U).refresh, kProducerBit);
    // When a grant is not beside its complement any more
    channel_a::Bytes& beside = fenced->fence.storage.records[kProducerSlot].grants.complements;
    std::uint8_t& length = beside.at[static_cast<std::size_t>(channel_a::Grant::kLength)];
    length = static_cast<std::uint8_t>(length ^ 1U);
    // Then the call that finds it has no refresh of it, nor has one after it
    const CycleOutcome found = CycleAt(device, 3000U);
    EXPECT_EQ(found.faulted, kProducerBit);
    EXPECT_EQ(found.refresh, 0U);
    EXPECT_EQ(found.due, 0U);
    EXPECT_EQ(CycleAt(device, 60000U).refresh, 0U);
}

} // namespace
} // namespace counterpoint::channel_a_test
