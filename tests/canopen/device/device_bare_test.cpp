// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/app_device.hpp"
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/node.hpp"

#include <algorithm>

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;

/// The kernel of the rig in a device without services.
class DeviceBareTest : public DeviceRig
{
  protected:
    BareParts Parts(ServiceSet& set) noexcept
    {
        return BareParts{core, set, *this, FrameRoom{safety_frames.data(), 8U}, 3U};
    }
    void Tell(Device& to, const std::uint32_t identifier, const Octets& bytes)
    {
        StampedFrame frame{};
        frame.frame =
            CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(bytes.size()), {}};
        std::copy(bytes.begin(), bytes.end(), frame.frame.data);
        frame.stamp = {Instant{now_us}, Instant{now_us}};
        to.OnFrame(frame);
        to.Serve(Instant{now_us});
    }

    NoServices none{cia301::NodeId{2U}, &ports};
    Device bare{Parts(none)};
};

TEST_F(DeviceBareTest, FollowsNmtAndSendsNothingButItsBootUp)
{
    Verifies(req::SRS_DEV_022);
    // Given power, then a boot-up message and PRE-OPERATIONAL
    EXPECT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
    EXPECT_EQ(bare.State(), NodeState::kPreOperational);
    // When each command comes, then it is followed
    Tell(bare, 0U, {1U, 0U});
    EXPECT_EQ(bare.State(), NodeState::kOperational);
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kOff);
    bare.Cycle(CycleCall{{Instant{now_us}, Instant{now_us}}, 0U, 0U});
    EXPECT_EQ(core.GetState(CommunicationIndex{0x1301U}).state, SrdoState::kWaiting);
    Tell(bare, 0U, {2U, 2U});
    EXPECT_EQ(bare.State(), NodeState::kStopped);
    Tell(bare, 0U, {128U, 2U});
    Tell(bare, 0U, {1U, 3U}); // Another node's.
    EXPECT_EQ(bare.State(), NodeState::kPreOperational);
    // When SDO, heartbeat and lost frames come, then nothing is sent
    Tell(bare, 0x602U, {0x40U, 0U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Tell(bare, 0x705U, {5U});
    bare.OnLoss();
    bare.OnBus(BusCondition::kOff);
    bare.OnBus(BusCondition::kActive);
    bare.Serve(Instant{now_us});
    bare.OnConfirm(StampedFrame{ports.sent[0], {Instant{now_us}, Instant{now_us}}});
    // nor where a frame is given to the set itself
    none.OnFrame(ports.sent[0], cia301::Moment{bare.State(), Instant{now_us}});
    EXPECT_EQ(ports.sent.size(), 1U);
}

TEST_F(DeviceBareTest, ResetsStartTheKernelAnewAndBootUpAgain)
{
    Verifies(req::SRS_DEV_022);
    Verifies(req::SRS_DEV_003);
    Verifies(req::SRS_DEV_004);
    // Given a device in its safe state
    ASSERT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    core.DemandSafeState();
    // When communication is reset, then the fault stays
    Tell(bare, 0U, {130U, 2U});
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(node_resets, 1);
    // When the node is reset, then the kernel is a new one, and the message is sent for the third time
    Tell(bare, 0U, {129U, 2U});
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kNone);
    EXPECT_EQ(node_resets, 2);
    EXPECT_EQ(communication_resets, 3);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}, {0U}, {0U}}));
}

TEST_F(DeviceBareTest, BootUpWaitsForTheController)
{
    Verifies(req::SRS_DEV_022);
    // Given a controller that takes nothing
    ports.answer = hal::TransmitStatus::kBusOff;
    ASSERT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    bare.Serve(Instant{now_us});
    EXPECT_TRUE(ports.sent.empty());
    // When it takes frames again, then the message goes out, once
    ports.answer = hal::TransmitStatus::kAccepted;
    bare.Serve(Instant{now_us});
    bare.Serve(Instant{now_us});
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
}

TEST_F(DeviceBareTest, WhatTheControllerNeverTakesIsDropped)
{
    Verifies(req::SRS_DEV_022);
    // Given a controller that has no place for the message
    ports.answer = hal::TransmitStatus::kRefused;
    ASSERT_EQ(bare.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    // Then it is not tried again
    ports.answer = hal::TransmitStatus::kAccepted;
    bare.Serve(Instant{now_us});
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(DeviceBareTest, TheOtherCpuSendsForBoth)
{
    Verifies(req::SRS_DEV_022);
    // Given a set without a sender, then the device is up and says nothing
    NoServices silent{cia301::NodeId{2U}, nullptr};
    Device second{Parts(silent)};
    EXPECT_EQ(second.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    second.Serve(Instant{now_us});
    EXPECT_EQ(second.State(), NodeState::kPreOperational);
    EXPECT_TRUE(ports.sent.empty());
}

TEST_F(DeviceBareTest, WithoutANodeIdItStaysInInitialisation)
{
    Verifies(req::SRS_DEV_022);
    // Given no node-ID, nobody gives one: no boot-up message, no state
    for (const std::uint8_t nobody : {std::uint8_t{0U}, std::uint8_t{128U}})
    {
        NoServices unknown{cia301::NodeId{nobody}, &ports};
        Device lost{Parts(unknown)};
        EXPECT_EQ(lost.PowerOn(Instant{now_us}), LoadResult::kLoaded);
        lost.Serve(Instant{now_us});
        EXPECT_EQ(lost.State(), NodeState::kResetCommunication);
    }
    EXPECT_TRUE(ports.sent.empty());
}

/// An application that may be refused.
struct TestedApplication
{
    [[nodiscard]] const DeviceConfig& Describe() const noexcept
    {
        return config;
    }
    [[nodiscard]] static AbortCode Configure(Kernel& /*kernel*/) noexcept
    {
        ++configured;
        return (is_refused || (rig->OnResetCommunication() != LoadResult::kLoaded)) ? AbortCode::kGeneral
                                                                                    : AbortCode::kNone;
    }

    DeviceConfig config;
    static int configured;
    static bool is_refused;
    static DeviceRig* rig; ///< Knows the values.
};
int TestedApplication::configured = 0;
bool TestedApplication::is_refused = false;
DeviceRig* TestedApplication::rig = nullptr;

TEST_F(DeviceBareTest, AnApplicationIsADevice)
{
    Verifies(req::SRS_DEV_022);
    // Given an application that knows its configuration
    TestedApplication tested{config};
    TestedApplication::configured = 0;
    TestedApplication::rig = this;
    tested.config.node_id = 2U;
    AppDevice<TestedApplication, 3U> device_of{core, &ports, tested};
    // When power comes, then it is configured, once, and up
    ASSERT_EQ(device_of.Whole().PowerOn(Instant{now_us}), LoadResult::kLoaded);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
    Tell(device_of.Whole(), 0U, {130U, 0U});
    EXPECT_EQ(TestedApplication::configured, 1);
    Tell(device_of.Whole(), 0U, {129U, 0U});
    EXPECT_EQ(TestedApplication::configured, 2);
    EXPECT_EQ(device_of.Whole().State(), NodeState::kPreOperational);
}

TEST_F(DeviceBareTest, AnApplicationLeavesItsSafeStateByPowerAlone)
{
    Verifies(req::SRS_DEV_022);
    // Given a device in its safe state
    TestedApplication tested{config};
    TestedApplication::rig = this;
    tested.config.node_id = 2U;
    AppDevice<TestedApplication, 3U> device_of{core, &ports, tested};
    ASSERT_EQ(device_of.Whole().PowerOn(Instant{now_us}), LoadResult::kLoaded);
    core.DemandSafeState();
    // When the node is reset, then the fault stays, no boot-up message is sent, and no command leads out
    Tell(device_of.Whole(), 0U, {129U, 0U});
    Tell(device_of.Whole(), 0U, {129U, 0U});
    Tell(device_of.Whole(), 0U, {1U, 0U});
    EXPECT_EQ(core.DeviceState().fault, DeviceFault::kApplication);
    EXPECT_EQ(device_of.Whole().State(), NodeState::kResetApplication);
    EXPECT_EQ(Sent(0x702U), (std::vector<Octets>{{0U}}));
}

TEST_F(DeviceBareTest, AnApplicationThatIsRefusedIsNoDevice)
{
    Verifies(req::SRS_DEV_022);
    // Given an application whose description the kernel refuses, or whose configuration
    TestedApplication tested{config};
    tested.config.node_id = 2U;
    TestedApplication::is_refused = true;
    AppDevice<TestedApplication, 3U> unconfigured{core, &ports, tested};
    EXPECT_EQ(unconfigured.Whole().PowerOn(Instant{now_us}), LoadResult::kFailed);
    TestedApplication::is_refused = false;
    tested.config.srdo_count = 0U;
    AppDevice<TestedApplication, 3U> refused{core, &ports, tested};
    EXPECT_EQ(refused.Whole().PowerOn(Instant{now_us}), LoadResult::kFailed);
    // Then nothing is sent
    EXPECT_TRUE(ports.sent.empty());
}

} // namespace
} // namespace counterpoint::device
