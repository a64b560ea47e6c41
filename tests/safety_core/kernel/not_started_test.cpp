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
    EXPECT_EQ(guard.Valid(), 0xA5U);
    EXPECT_EQ(&guard.Config(), &config);
    // When it starts anew, nothing is declared; when it stops, nor is it, and there is no device
    guard.Restart(config);
    EXPECT_EQ(guard.Valid(), 0U);
    ASSERT_EQ(guard.Declare(), Result::kSuccessful);
    guard.Stop();
    EXPECT_EQ(guard.Valid(), 0U);
    EXPECT_EQ(&guard.Config(), &kNoDevice);
}

TEST_F(NotStarted, EveryCallSaysSoWhateverItNames)
{
    Verifies(req::SRS_KRN_030);
    const StaticFields fields{rx_normal.data(), rx_inverse.data()};
    // Given a kernel that was never started, one that was stopped, and one whose start was refused
    for (std::uint32_t round = 0U; round < 3U; ++round)
    {
        // Then an SRDO that the device has, and such as it has not, are the same
        for (const std::uint16_t value : std::initializer_list<std::uint16_t>{0U, 0x1301U, 0x1302U, 0x1341U, 0xFFFFU})
        {
            const CommunicationIndex index{value};
            EXPECT_EQ(kernel.Send(index), Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.Sign(index).result, Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.GetState(index).result, Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.GetStatus(index).result, Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.SetStatus(index, StatusByte{0x30U}), Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.GetParameters(index).result, Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.GetMapped(index, MappedEntry{1U}).result, Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.GetMapped(index, MappedEntry{200U}).result, Result::kDeviceFault) << value;
            EXPECT_EQ(kernel.DefineStaticFields(index, fields), Result::kDeviceFault) << value;
        }
        for (const std::uint32_t number : std::initializer_list<std::uint32_t>{0U, 72U, 73U, 0xFFFFFFFFU})
        {
            EXPECT_EQ(kernel.Image().ReadItem(number).result, Result::kDeviceFault) << number;
            EXPECT_EQ(kernel.Image().LoadItem(number, 0U), Result::kDeviceFault) << number;
        }
        EXPECT_EQ(kernel.Image().Header().result, Result::kDeviceFault);
        EXPECT_EQ(kernel.Image().Load(ImageHeader{}), Result::kDeviceFault);
        EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kDeviceFault);
        EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault);
        EXPECT_EQ(kernel.CheckConfiguration().result, Result::kDeviceFault);
        EXPECT_EQ(kernel.Digest().result, Result::kDeviceFault);
        for (const std::uint16_t index :
             std::initializer_list<std::uint16_t>{0x1300U, 0x1301U, 0x1342U, 0x13FEU, 0x2000U})
        {
            EXPECT_EQ(kernel.ReadObject(ObjectAddress{index, 1U}).abort, AbortCode::kDeviceState) << index;
            EXPECT_EQ(Write(index, 1U, 0U, 1U), AbortCode::kDeviceState) << index;
            EXPECT_EQ(Write(index, 0U, 0U, 4U), AbortCode::kDeviceState) << index;
        }
        if (round == 0U)
        {
            Configure();
            kernel.Stop();
        }
        else
        {
            config.srdo_count = 0U;
            ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kSrdoCount);
        }
    }
}

} // namespace
} // namespace counterpoint
