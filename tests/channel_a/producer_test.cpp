// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel A takes for the confirmation of a pair, by the stamps of both frames, and what its inverse frame is.
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

} // namespace
} // namespace counterpoint::channel_a_test
