// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/emergency/consumer.hpp"
#include "canopen/cia301/sdo/client_port.hpp"
#include "canopen/cia301/time/time_stamp.hpp"
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/node.hpp"

// Services that not every device has, in a device.
namespace counterpoint::device
{
namespace
{

using cia301::SdoClientState;

/// The rig's device with TIME, an emergency consumer for two nodes, an SDO client of node 5 and a second server.
class DeviceFurtherTest : public DeviceRig, public cia301::TimeListener, public cia301::EmergencyListener
{
  public:
    DeviceFurtherTest()
    {
        services.further = {list.data(), 4U};
    }
    void OnTime(const cia301::TimeOfDay& told, Instant) noexcept override
    {
        days = told.days;
    }
    void OnEmergency(const cia301::ReceivedEmergency& told) noexcept override
    {
        code = told.code;
    }
    static void Put(cia301::NumberHook& hook, std::uint16_t index, std::uint8_t sub, std::uint32_t value)
    {
        const auto byte = [value](unsigned place) { return static_cast<std::uint8_t>(value >> (8U * place)); };
        const std::array<std::uint8_t, 4> bytes{byte(0U), byte(1U), byte(2U), byte(3U)};
        EXPECT_EQ(hook.OnWrite({index, sub}, {bytes.data(), 4U}), cia301::SdoAbort::kNone);
    }
    void Configure()
    {
        Put(time, 0x1012U, 0U, 0xC0000100U);
        Put(listener, 0x1028U, 2U, 0x82U);
        Put(client, 0x1280U, 1U, 0x605U);
        Put(client, 0x1280U, 2U, 0x585U);
        Put(client, 0x1280U, 3U, 5U);
        Put(second, 0x1201U, 1U, 0x680U);
        Put(second, 0x1201U, 2U, 0x6A0U);
    }
    void Ask()
    {
        EXPECT_TRUE(
            client.Client().StartUpload({0x1000U, 0U}, {room.data(), 8U}, cia301::SdoMode::kNormal, Instant{now_us}));
        Cycle();
    }

    std::uint16_t days{0U};
    std::uint16_t code{0U};
    std::array<std::uint32_t, 2> sources{};
    std::array<std::uint8_t, 8> room{};
    std::array<std::uint8_t, 8> second_buffer{};
    cia301::SdoServer second_server{{dictionary, {second_buffer.data(), 8U}, 1000000U, 64U}};
    cia301::TimeStamp time{services.outbox, *this};
    cia301::EmergencyConsumer listener{{sources.data(), 2U}, *this};
    cia301::SdoClientPort client{{services.outbox, 0U, 50000U, 64U}};
    cia301::SdoServerPort second{second_server, services.outbox, cia301::SdoServerNumber{1U}};
    std::array<cia301::BusService*, 4> list{&time, &listener, &client, &second};
};

TEST_F(DeviceFurtherTest, TimeAndEmergenciesOfOthersAreHeard)
{
    Verifies(req::SRS_DEV_020);
    Start();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0x34U, 0x12U});
    Frame(0x82U, {0x10U, 0x42U, 9U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(days, 0U); // off at first
    EXPECT_EQ(code, 0U);
    Configure();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0x34U, 0x12U});
    Frame(0x82U, {0x10U, 0x42U, 9U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(days, 0x1234U);
    EXPECT_EQ(code, 0x4210U);
    EXPECT_TRUE(time.Send({7U, 8U}, {device.State(), Instant{now_us}}));
    Cycle();
    EXPECT_EQ(Sent(0x100U), (std::vector<Octets>{{7U, 0U, 0U, 0U, 8U, 0U}}));
    // Reset communication: off again
    Command(130U);
    Cycle();
    Frame(0x100U, {1U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(days, 0x1234U);
}

TEST_F(DeviceFurtherTest, AClientAndASecondServerShareTheBusWithTheFirst)
{
    Verifies(req::SRS_DEV_020);
    Start();
    Frame(0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_TRUE(Sent(0x6A0U).empty());
    Configure();
    Forget();
    Frame(0x680U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(Sent(0x6A0U), (std::vector<Octets>{{0x43U, 0x00U, 0x10U, 0U, 0x44U, 0x33U, 0x22U, 0x11U}}));
    Ask();
    EXPECT_EQ(Sent(0x605U), (std::vector<Octets>{{0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U}}));
    EXPECT_EQ(Upload(0x1000U, 0U), 0x11223344U);
    Frame(0x586U, {0x43U, 0x00U, 0x10U, 0U, 9U, 9U, 9U, 9U}); // another server's
    Frame(0x585U, {0x43U, 0x00U, 0x10U, 0U, 1U, 2U, 3U, 4U});
    Cycle();
    EXPECT_EQ(client.Client().State(), SdoClientState::kDone);
    EXPECT_EQ(room[0], 1U);
    // In STOPPED a transfer ends
    Ask();
    Command(2U);
    Cycle();
    EXPECT_EQ(client.Client().Outcome().abort, cia301::SdoAbort::kDeviceState);
}

/// What a plain device has behind its own table.
class NoObjects final : public cia301::ForeignObjects
{
  public:
    ObjectReading Read(const ObjectAddress& /*address*/) noexcept override
    {
        return {AbortCode::kObjectUnknown, {}};
    }
    AbortCode Write(const ObjectAddress& /*address*/, const ObjectData& /*data*/) noexcept override
    {
        return AbortCode::kObjectUnknown;
    }
};

TEST_F(DeviceFurtherTest, APlainDeviceMissesNoSafetyConfiguration)
{
    Verifies(req::SRS_DEV_021);
    is_configured = false;
    NoObjects none{};
    cia301::Dictionary plain{cia301::EntryTable{entries.data(), 12U}, none};
    Device other{DeviceParts{core, watch, plain, services, *this, FrameRoom{safety_frames.data(), 8U},
                             FrameRoom{service_frames.data(), 16U}, 3U}};
    ASSERT_EQ(other.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    StampedFrame start{};
    start.frame = CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 2U}};
    other.OnFrame(start);
    other.Serve(Instant{now_us});
    EXPECT_EQ(other.State(), cia301::NodeState::kOperational);
    EXPECT_EQ(emergency.Register(), 0U);
    // Given one with 13FEh, it does
    services.dictionary = &dictionary;
    Run();
    EXPECT_EQ(emergency.Register(), 0x81U);
}

} // namespace
} // namespace counterpoint::device
