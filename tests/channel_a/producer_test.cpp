// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What channel A takes for the confirmation of a pair, by the stamps of both frames.
#include "tests/channel_a/device.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

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

} // namespace
} // namespace counterpoint::channel_a_test
