// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class Starting : public Rig
{
  public:
    StartResult Start()
    {
        return kernel.Start(config, FlowCallback::kOff);
    }
};

TEST_F(Starting, GoodDeviceStarts)
{
    Verifies(req::SRS_KRN_001);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
    EXPECT_EQ(Start(), StartResult::kStarted);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(Starting, SrdoCountIsOneToSixtyFour)
{
    Verifies(req::SRS_KRN_001);
    config.srdo_count = 0U;
    EXPECT_EQ(Start(), StartResult::kSrdoCount);
    config.srdo_count = 65U;
    EXPECT_EQ(Start(), StartResult::kSrdoCount);
}

TEST_F(Starting, SrdoNumbersAscendWithinOneToSixtyFour)
{
    Verifies(req::SRS_KRN_001);
    setups[0].number = 0U;
    EXPECT_EQ(Start(), StartResult::kSrdoNumbers);
    setups[0].number = 3U;
    EXPECT_EQ(Start(), StartResult::kSrdoNumbers);
    setups[0].number = 1U;
    setups[2].number = 65U;
    EXPECT_EQ(Start(), StartResult::kSrdoNumbers);
    setups[2].number = 64U;
    EXPECT_EQ(Start(), StartResult::kStarted);
}

TEST_F(Starting, GapsAreRefusedOrSearched)
{
    Verifies(req::SRS_KRN_018);
    // Given SRDO 1, 3 and 4
    config.gaps = NumberGaps::kRefused;
    EXPECT_EQ(Start(), StartResult::kSrdoNumbers);
    setups[0].number = 2U;
    EXPECT_EQ(Start(), StartResult::kSrdoNumbers);
    // When there are 1, 2 and 3
    setups[0].number = 1U;
    setups[1].number = 2U;
    setups[2].number = 3U;
    EXPECT_EQ(Start(), StartResult::kStarted);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1302U}).result, Result::kSuccessful);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1303U}).result, Result::kSuccessful);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1304U}).result, Result::kNotExist);
    EXPECT_EQ(Read(0x13FFU, 0U), 3U);
    // Then an object and a call of its SRDO mean the same one
    EXPECT_EQ(Write(0x1303U, 2U, 77U, 2U), AbortCode::kNone);
    EXPECT_EQ(kernel.GetParameters(CommunicationIndex{0x1303U}).refresh_ms, 77U);
    EXPECT_EQ(Write(0x1304U, 2U, 77U, 2U), AbortCode::kObjectUnknown);
    // And a search finds the same
    config.gaps = NumberGaps::kSearched;
    EXPECT_EQ(Start(), StartResult::kStarted);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1303U}).result, Result::kSuccessful);
    EXPECT_EQ(kernel.GetState(CommunicationIndex{0x1304U}).result, Result::kNotExist);
}

TEST_F(Starting, DeviceMustFitIntoBothChannels)
{
    Verifies(req::SRS_KRN_020);
    const auto with_room = [this](ChannelRoom room_a, ChannelRoom room_b)
    {
        a.room_slots = room_a.slots;
        a.room_entries = room_a.map_entries;
        b.room_slots = room_b.slots;
        b.room_entries = room_b.map_entries;
        return Start();
    };
    // Given three SRDOs and 16 map entries
    EXPECT_EQ(with_room({3U, 16U}, {3U, 16U}), StartResult::kStarted);
    EXPECT_EQ(with_room({2U, 16U}, {3U, 16U}), StartResult::kStorage);
    EXPECT_EQ(with_room({3U, 16U}, {2U, 16U}), StartResult::kStorage);
    EXPECT_EQ(with_room({3U, 14U}, {3U, 16U}), StartResult::kStorage);
    EXPECT_EQ(with_room({3U, 16U}, {3U, 14U}), StartResult::kStorage);
    config.map_entries = 15U;
    EXPECT_EQ(with_room({3U, 16U}, {3U, 16U}), StartResult::kStorage);
}

TEST_F(Starting, NodeIdIsOneToOneHundredTwentySeven)
{
    Verifies(req::SRS_KRN_001);
    config.node_id = 0U;
    EXPECT_EQ(Start(), StartResult::kNodeId);
    config.node_id = 128U;
    EXPECT_EQ(Start(), StartResult::kNodeId);
    for (const std::uint8_t node : std::initializer_list<std::uint8_t>{1, 127})
    {
        config.node_id = node;
        EXPECT_EQ(Start(), StartResult::kStarted) << static_cast<int>(node);
    }
}

TEST_F(Starting, GranularityIsOneEightSixteenThirtyTwoOrSixtyFour)
{
    Verifies(req::SRS_KRN_001);
    for (const std::uint8_t bits : std::initializer_list<std::uint8_t>{0, 2, 4, 7, 12, 24, 128, 255})
    {
        config.granularity_bits = bits;
        EXPECT_EQ(Start(), StartResult::kGranularity) << static_cast<int>(bits);
    }
    for (const std::uint8_t bits : std::initializer_list<std::uint8_t>{1, 8, 16, 32, 64})
    {
        config.granularity_bits = bits;
        EXPECT_EQ(Start(), StartResult::kStarted) << static_cast<int>(bits);
    }
}

TEST_F(Starting, PortsAreFirstOrSecond)
{
    Verifies(req::SRS_KRN_001);
    config.normal_port = CanPortId::kInvalid;
    EXPECT_EQ(Start(), StartResult::kPorts);
    config.normal_port = CanPortId::kSecond;
    EXPECT_EQ(Start(), StartResult::kStarted);
    config.inverse_port = static_cast<CanPortId>(3U);
    EXPECT_EQ(Start(), StartResult::kPorts);
}

TEST_F(Starting, ObjectsAscendHaveALengthAndAPlace)
{
    Verifies(req::SRS_KRN_001);
    for (const std::uint8_t bits : std::initializer_list<std::uint8_t>{0, 65, 72, 255})
    {
        objects[1].length_bits = bits;
        EXPECT_EQ(Start(), StartResult::kObjects) << static_cast<int>(bits);
    }
    for (const std::uint8_t bits : std::initializer_list<std::uint8_t>{1, 7, 12, 64})
    {
        objects[1].length_bits = bits;
        EXPECT_EQ(Start(), StartResult::kStarted) << static_cast<int>(bits);
    }
    objects[1].length_bits = 16U;
    objects[1].place = nullptr;
    EXPECT_EQ(Start(), StartResult::kObjects);
    objects[1].place = tx_inverse.data();
    objects[1].index = 0x2000U;
    EXPECT_EQ(Start(), StartResult::kObjects);
    objects[1].index = 0x2100U;
    config.object_count = 1025U;
    EXPECT_EQ(Start(), StartResult::kObjects);
    config.object_count = 0U;
    EXPECT_EQ(Start(), StartResult::kStarted);
}

TEST_F(Starting, EachTimeHasItsRange)
{
    Verifies(req::SRS_KRN_001);
    const DeviceConfig good = config;
    const auto refused = [this, &good](const auto& spoil)
    {
        config = good;
        spoil(config);
        EXPECT_EQ(Start(), StartResult::kTiming);
    };
    refused([](DeviceConfig& c) { c.cycle_us = 99U; });
    refused(
        [](DeviceConfig& c)
        {
            c.cycle_us = 1000001U;
            c.diagnostic_interval_us = 0x3FFFFFFFU;
            c.test_interval_us = 0x3FFFFFFFU;
        });
    refused([](DeviceConfig& c) { c.cycle_tolerance_us = 1001U; });
    refused([](DeviceConfig& c) { c.clock_interval_us = 5999U; });
    refused([](DeviceConfig& c) { c.discrepancy_us = 0x40000000U; });
    refused([](DeviceConfig& c) { c.diagnostic_interval_us = 8999U; });
    refused([](DeviceConfig& c) { c.test_interval_us = 22499U; });
    config = good;
    config.diagnostic_interval_us = 9000U; // Two cycles of 1.5 ms for each SRDO.
    config.test_interval_us = 22500U;      // 15 cycles of 1.5 ms.
    EXPECT_EQ(Start(), StartResult::kStarted);
}

TEST_F(Starting, HardwareThatCannotGuaranteeIsRefused)
{
    Verifies(req::SRS_KRN_001);
    Verifies(req::SRS_HAL_002);
    ports.guarantees.bus_order = hal::Guarantee::kAbsent;
    EXPECT_EQ(Start(), StartResult::kBusOrder);
    ports.guarantees.bus_order = hal::Guarantee::kGiven;
    ports.guarantees.stamps = hal::Guarantee::kInvalid;
    EXPECT_EQ(Start(), StartResult::kStamps);
    ports.guarantees.stamps = hal::Guarantee::kGiven;
    ports.guarantees.confirmations = hal::Guarantee::kAbsent;
    EXPECT_EQ(Start(), StartResult::kConfirmations);
}

TEST_F(Starting, StoppedKernelGivesNoPermitAndRefusesEverything)
{
    Verifies(req::SRS_KRN_025);
    Verifies(req::SRS_KRN_030);
    // Given a released and open output
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    // When the kernel is stopped, then the output is closed without another cycle
    kernel.Stop();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
    ReceivePair();
    kernel.OnConfirm(StampedFrame{});
    kernel.OnOverflow();
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    EXPECT_EQ(Open(), 0U);
    const CommunicationIndex first{0x1301U};
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kDeviceState);
    EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x1300U, 0U}).abort, AbortCode::kDeviceState);
    EXPECT_EQ(kernel.Send(first), Result::kDeviceFault);
    EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault);
    EXPECT_EQ(kernel.Sign(first).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.GetState(first).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.GetStatus(first).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.SetStatus(first, StatusByte{0U}), Result::kDeviceFault);
    EXPECT_EQ(kernel.GetParameters(first).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.GetMapped(first, MappedEntry{1U}).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DefineStaticFields(first, StaticFields{nullptr, nullptr}), Result::kDeviceFault);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().Header().result, Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().ReadItem(0U).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().ReadItem(1U).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().LoadItem(0U, 0U), Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().LoadItem(1U, 0U), Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().Load(ImageHeader{}), Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kDeviceFault);
    // And a new start begins anew
    watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
    Operate();
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
}

TEST_F(Starting, RefusedStartStopsARunningKernel)
{
    Verifies(req::SRS_KRN_025);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    config.srdo_count = 0U;
    EXPECT_EQ(Start(), StartResult::kSrdoCount);
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1303U}), Result::kDeviceFault);
}

TEST_F(Starting, NothingRunsBeforeStartOrAfterARefusedStart)
{
    Verifies(req::SRS_KRN_001);
    // Given a kernel that never started, when everything is tried
    const auto nothing_runs = [this]()
    {
        kernel.SetNmtState(NmtState::kOperational);
        ReceivePair();
        kernel.OnConfirm(StampedFrame{});
        Cycle();
        EXPECT_EQ(Write(0x1300U, 0U, 1U, 1U), AbortCode::kDeviceState);
        EXPECT_EQ(kernel.ReadObject(ObjectAddress{0x1300U, 0U}).abort, AbortCode::kDeviceState);
        EXPECT_EQ(kernel.CheckConfiguration().result, Result::kDeviceFault);
        EXPECT_EQ(output.last.kernel.response, 0U);
        EXPECT_EQ(Open(), 0U);
    };
    nothing_runs();
    Verifies(req::SRS_KRN_030);
    EXPECT_EQ(kernel.Send(CommunicationIndex{0x1301U}), Result::kDeviceFault);
    EXPECT_EQ(kernel.Sign(CommunicationIndex{0x1301U}).result, Result::kDeviceFault);
    // And the same after a start that was refused
    config.srdo_count = 0U;
    ASSERT_EQ(Start(), StartResult::kSrdoCount);
    nothing_runs();
}

} // namespace
} // namespace counterpoint
