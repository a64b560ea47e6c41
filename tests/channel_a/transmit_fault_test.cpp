// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What the kernel says of a transmission, and which of it gives up a pair of channel A.
#include "tests/channel_a/device.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

namespace counterpoint::channel_a_test
{
namespace
{

struct Fault
{
    SrdoCause cause;
    std::uint32_t signal;
};

constexpr Fault kFaults[] = {
    {SrdoCause::kNotInverse, 0x0010U},
    {SrdoCause::kTransmitQueue, 0x2000U},
    {SrdoCause::kBusOff, 0x4000U},
    {SrdoCause::kNoConfirmation, 0x8000U},
};

constexpr bool kHalves[] = {false, true};

class ChannelATransmitFault : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        // The objects hold what FrameOf makes of 0.
        for (std::uint8_t place = 0U; place < 8U; ++place)
        {
            device.words[4U + (place / 4U)][place % 4U] = place;
        }
    }

    // In OPERATIONAL, where the producer may send.
    void Start()
    {
        device.clock_us = 0U;
        device.Start();
        static_cast<void>(device.Cycle());
        static_cast<void>(device.Cycle());
    }

    ConfirmStep Confirm(bool is_inverse)
    {
        const std::uint32_t identifier = is_inverse ? 0x102U : 0x101U;
        return device.channel.OnConfirm(Device::FrameOf(identifier, 8U, 0U, is_inverse), Instant{device.clock_us}).step;
    }

    // A pair of which the normal frame, or the inverse one, is awaited.
    void Await(bool is_inverse)
    {
        ASSERT_EQ(device.channel.Prepare(kProducerSlot).status, PrepareStatus::kReady);
        if (is_inverse)
        {
            ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
        }
    }

    void Say(SrdoCause cause, SlotIndex slot = kProducerSlot)
    {
        device.channel.OnTransmitFault(slot, TransmitFault{cause});
    }

    [[nodiscard]] SrdoView View() const
    {
        return device.channel.View(kProducerSlot);
    }

    std::unique_ptr<FencedDevice> fenced = std::make_unique<FencedDevice>();
    Device& device = fenced->device;
};

TEST_F(ChannelATransmitFault, GivesUpThePairWhicheverFrameIsAwaited)
{
    Verifies(req::SRS_PROD_009);
    Verifies(req::SRS_CONS_021);
    for (const Fault& fault : kFaults)
    {
        for (const bool is_inverse : kHalves)
        {
            SCOPED_TRACE(fault.signal + (is_inverse ? 1U : 0U));
            // Given a pair in flight
            Start();
            Await(is_inverse);
            // When the kernel says the fault, then its cause is kept and counted
            Say(fault.cause);
            EXPECT_EQ(View().first_cause, fault.cause);
            EXPECT_EQ(View().error_count, 1U);
            EXPECT_EQ(View().state, SrdoState::kProducer);
            // and the pair is over
            EXPECT_EQ(device.channel.InverseFrame(kProducerSlot).kind, FrameKind::kInvalid);
            EXPECT_EQ(Confirm(is_inverse), ConfirmStep::kNone);
            EXPECT_EQ(View().ordinal, 0U);
            // and the next call signals it, and it alone
            EXPECT_EQ(device.Cycle().signalled & kProducerBit, kProducerBit);
            EXPECT_EQ(View().signals, fault.signal);
            // and the next pair can be sent
            Await(true);
            EXPECT_EQ(Confirm(true), ConfirmStep::kPair);
            EXPECT_EQ(View().error_count, 1U);
        }
    }
}

TEST_F(ChannelATransmitFault, HasNoEffectWithoutAPairInFlight)
{
    Verifies(req::SRS_PROD_009);
    for (const Fault& fault : kFaults)
    {
        SCOPED_TRACE(fault.signal);
        // Given a producer that has sent nothing, one whose pair is sent, and a consumer
        Start();
        Say(fault.cause);
        Await(true);
        ASSERT_EQ(Confirm(true), ConfirmStep::kPair);
        Say(fault.cause);
        Say(fault.cause, kConsumerSlot);
        // Then nothing is kept, counted or signalled
        EXPECT_EQ(View().first_cause, SrdoCause::kNone);
        EXPECT_EQ(View().error_count, 0U);
        EXPECT_EQ(device.channel.View(kConsumerSlot).error_count, 0U);
        EXPECT_EQ(device.Cycle().signalled, 0U);
        EXPECT_EQ(View().signals, 0U);
        // and a pair is given up once
        Await(false);
        Say(fault.cause);
        Say(fault.cause);
        EXPECT_EQ(View().error_count, 1U);
    }
}

TEST_F(ChannelATransmitFault, HasNoEffectWithAnotherCause)
{
    Verifies(req::SRS_PROD_009);
    for (std::uint32_t code = 0U; code <= 0xFFU; ++code)
    {
        if ((code == 4U) || ((code >= 13U) && (code <= 15U)))
        {
            continue;
        }
        SCOPED_TRACE(code);
        const SrdoCause other = static_cast<SrdoCause>(code);
        // When it is said of a pair before each of its frames is confirmed
        Start();
        Await(false);
        Say(other);
        ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
        Say(other);
        // Then the pair is sent
        EXPECT_EQ(Confirm(true), ConfirmStep::kPair);
        EXPECT_EQ(View().ordinal, 1U);
        EXPECT_EQ(View().first_cause, SrdoCause::kNone);
        EXPECT_EQ(View().error_count, 0U);
    }
}

// At the very limit of SRVT the other channel has given the pair up; the refresh that waits behind it is due in both.
TEST_F(ChannelATransmitFault, OfALateConfirmationLetsTheRefreshBeDueThatWaits)
{
    Verifies(req::SRS_PROD_009);
    Verifies(req::SRS_PROD_013);
    // Given a pair on its way from 51 ms on, the refresh of 51.5 ms behind it, and a normal frame confirmed on SRVT
    device.setups[kProducerSlot].form = ProducerForm::kProviderCalled;
    Start();
    Await(true);
    ASSERT_EQ(Confirm(true), ConfirmStep::kPair);
    static_cast<void>(device.Cycle(49000U));
    Await(false);
    const CycleOutcome waiting = device.Cycle(20000U);
    EXPECT_EQ(waiting.refresh, kProducerBit);
    EXPECT_EQ(waiting.due, 0U);
    ASSERT_EQ(Confirm(false), ConfirmStep::kNormal);
    // When the other channel found it late
    Say(SrdoCause::kNoConfirmation);
    // Then the refresh is due in the next call, not 20 ms later
    const CycleOutcome next = device.Cycle(1U);
    EXPECT_EQ(next.refresh, kProducerBit);
    EXPECT_EQ(next.due, kProducerBit);
    EXPECT_EQ(View().signals, 0x8000U);
}

} // namespace
} // namespace counterpoint::channel_a_test
