// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What a kernel that was not started, or was stopped, leaves alone and says.
#include "safety_core/kernel/configuration_guard.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class NotStarted : public Rig
{
  protected:
    /// Everything that comes from the bus, and another Stop; calls of the channels from then on.
    int CallsOfChannels()
    {
        int calls = 0;
        for (Tap* const tap : {&a, &b})
        {
            tap->on_frame = [&calls]() { ++calls; };
            tap->on_confirmed = [&calls](Confirmation&) { ++calls; };
            tap->on_committed = [&calls]() { ++calls; };
        }
        kernel.Stop();
        ReceivePair();
        kernel.OnConfirm(StampedFrame{});
        return calls;
    }
};

TEST_F(NotStarted, CallsNoChannel)
{
    Verifies(req::SRS_KRN_025);
    EXPECT_EQ(CallsOfChannels(), 0);
}

// The objects are the application's again.
TEST_F(NotStarted, CallsNoChannelBehindStop)
{
    Verifies(req::SRS_KRN_025);
    Operate();
    kernel.Stop();
    EXPECT_EQ(CallsOfChannels(), 0);
}

TEST_F(NotStarted, ImageSaysThatNothingIsThere)
{
    Verifies(req::SRS_KRN_030);
    // Given a kernel that was never started, then one that was stopped with a valid configuration
    for (std::uint32_t round = 0U; round < 2U; ++round)
    {
        const HeaderReply reply = kernel.Image().Header();
        EXPECT_EQ(reply.result, Result::kDeviceFault);
        EXPECT_EQ(reply.header.valid, 0U);
        const ItemReply item = kernel.Image().ReadItem(0U);
        EXPECT_EQ(item.result, Result::kDeviceFault);
        EXPECT_EQ(item.value, 0U);
        Configure();
        kernel.Stop();
    }
}

TEST_F(NotStarted, GuardForgetsItsDeviceAndWhatWasDeclared)
{
    Verifies(req::SRS_KRN_025);
    SafeStateLatch latch{};
    latch.Arm();
    ConfigurationGuard guard{a, b, latch};
    EXPECT_EQ(guard.Valid(), 0U);
    // Given channels with a configuration that holds
    Configure();
    guard.Restart(config);
    ASSERT_EQ(guard.Declare(), Result::kSuccessful);
    ASSERT_TRUE(guard.IsValid());
    EXPECT_EQ(&guard.Config(), &config);
    // When it starts anew, nothing is declared; when it stops, nor is it, and there is no device
    guard.Restart(config);
    EXPECT_EQ(guard.Valid(), 0U);
    ASSERT_EQ(guard.Declare(), Result::kSuccessful);
    guard.Stop();
    EXPECT_EQ(guard.Valid(), 0U);
    EXPECT_EQ(&guard.Config(), &kNoDevice);
}

} // namespace
} // namespace counterpoint
