// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/can_ports.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace counterpoint::host
{
namespace
{

using hal::TransmitStatus;

class Sink final : public FrameSink
{
  public:
    void OnFrame(const StampedFrame& frame) override
    {
        frames.push_back(frame);
        order.push_back(frame.frame.identifier);
    }
    void OnConfirm(const StampedFrame& frame) override
    {
        confirmed.push_back(frame);
        order.push_back(frame.frame.identifier);
    }
    void OnOverflow() override
    {
        ++overflows;
    }

    std::vector<StampedFrame> frames{};
    std::vector<StampedFrame> confirmed{};
    std::vector<std::uint32_t> order{}; ///< Identifiers of both, as they came.
    int overflows{0};
};

/// A device with clocks of its own on a given bus.
struct Device
{
    Device(VirtualBus& bus, const InstantPair& start) : clocks(bus, start), ports(clocks, sink)
    {
    }

    HostClocks clocks;
    Sink sink{};
    HostCanPorts ports;
};

TEST(HostCanPorts, EachDeviceStampsWithItsOwnTwoClocksAtTheEndOfTheFrame)
{
    Verifies(req::SRS_HAL_011);
    // Given a sender and a receiver with different clocks at 1 Mbit/s
    VirtualBus bus(BitRate::k1M);
    Device sender(bus, InstantPair{Instant{0U}, Instant{1'000U}});
    Device receiver(bus, InstantPair{Instant{50'000U}, Instant{0xFFFF'FFF0U}});
    static_cast<void>(sender.ports.ConnectPort(CanPortId::kFirst, bus, 4U));
    static_cast<void>(receiver.ports.ConnectPort(CanPortId::kFirst, bus, 4U));
    // When the frame of 50 bits is sent at 0
    ASSERT_EQ(sender.ports.Transmit(MakeFrame(0U, {})), TransmitStatus::kAccepted);
    bus.Advance((50 * kMicrosecond) - 1);
    EXPECT_TRUE(sender.sink.order.empty());
    EXPECT_TRUE(receiver.sink.order.empty());
    bus.Advance(50 * kMicrosecond);
    // Then both have it at that instant, with their stamps of 50 us later
    ASSERT_EQ(sender.sink.confirmed.size(), 1U);
    EXPECT_EQ(sender.sink.confirmed[0].stamp.a.us, 50U);
    EXPECT_EQ(sender.sink.confirmed[0].stamp.b.us, 1'050U);
    EXPECT_TRUE(sender.sink.frames.empty());
    ASSERT_EQ(receiver.sink.frames.size(), 1U);
    EXPECT_EQ(receiver.sink.frames[0].stamp.a.us, 50'050U);
    EXPECT_EQ(receiver.sink.frames[0].stamp.b.us, 34U);
    EXPECT_TRUE(receiver.sink.confirmed.empty());
}

TEST(HostCanPorts, AllThreeGuaranteesAreGiven)
{
    Verifies(req::SRS_HAL_012);
    // Given ports, when asked, then nothing is missing
    VirtualBus bus(BitRate::k1M);
    Device device(bus, InstantPair{Instant{0U}, Instant{0U}});
    EXPECT_EQ(hal::CheckGuarantees(device.ports.Guarantees()), hal::MissingGuarantee::kNone);
}

TEST(HostCanPorts, FrameForAControllerThatIsNotThereIsRefused)
{
    Verifies(req::SRS_HAL_012);
    // Given a device with its first controller only, when it sends on the second, then that is refused
    VirtualBus bus(BitRate::k1M);
    Device device(bus, InstantPair{Instant{0U}, Instant{0U}});
    static_cast<void>(device.ports.ConnectPort(CanPortId::kFirst, bus, 4U));
    CanFrame frame = MakeFrame(0x101U, {});
    frame.port = CanPortId::kSecond;
    EXPECT_EQ(device.ports.Transmit(frame), TransmitStatus::kRefused);
    EXPECT_EQ(bus.NextEvent(), kNever);
}

TEST(HostCanPorts, QueueFullAndBusOffArePassedOn)
{
    Verifies(req::SRS_HAL_012);
    // Given a device with one mailbox
    VirtualBus bus(BitRate::k1M);
    Device device(bus, InstantPair{Instant{0U}, Instant{0U}});
    const NodeIndex node = device.ports.ConnectPort(CanPortId::kFirst, bus, 1U);
    EXPECT_EQ(device.ports.NodeOf(CanPortId::kFirst), node);
    // When it sends twice, then the second finds it full
    EXPECT_EQ(device.ports.Transmit(MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    EXPECT_EQ(device.ports.Transmit(MakeFrame(0x102U, {})), TransmitStatus::kQueueFull);
    // When the controller is bus-off, then that is the answer
    bus.ForceBusOff(node);
    EXPECT_EQ(device.ports.Transmit(MakeFrame(0x101U, {})), TransmitStatus::kBusOff);
}

TEST(HostCanPorts, TwoControllersOnOneBusHearInBusOrder)
{
    Verifies(req::SRS_HAL_011);
    // Given a device with two controllers on one bus: the first takes odd, the second even identifiers
    VirtualBus bus(BitRate::k1M);
    Device sender(bus, InstantPair{Instant{0U}, Instant{0U}});
    Device receiver(bus, InstantPair{Instant{0U}, Instant{0U}});
    static_cast<void>(sender.ports.ConnectPort(CanPortId::kFirst, bus, 4U));
    static_cast<void>(sender.ports.ConnectPort(CanPortId::kSecond, bus, 4U));
    const NodeIndex first = receiver.ports.ConnectPort(CanPortId::kFirst, bus, 4U);
    const NodeIndex second = receiver.ports.ConnectPort(CanPortId::kSecond, bus, 4U);
    bus.AcceptNone(first);
    bus.AcceptRange(first, 0x101U, 0x101U);
    bus.AcceptNone(second);
    bus.AcceptRange(second, 0x102U, 0x102U);
    // When a pair is sent, each frame by another controller
    CanFrame inverse = MakeFrame(0x102U, {0xFEU});
    inverse.port = CanPortId::kSecond;
    ASSERT_EQ(sender.ports.Transmit(inverse), TransmitStatus::kAccepted);
    ASSERT_EQ(sender.ports.Transmit(MakeFrame(0x101U, {0x01U})), TransmitStatus::kAccepted);
    bus.Advance(kMillisecond);
    // Then the receiver has both in the order of the bus, each from its controller
    ASSERT_EQ(receiver.sink.frames.size(), 2U);
    EXPECT_EQ(receiver.sink.frames[0].frame.identifier, 0x101U);
    EXPECT_EQ(receiver.sink.frames[0].frame.port, CanPortId::kFirst);
    EXPECT_EQ(receiver.sink.frames[1].frame.identifier, 0x102U);
    EXPECT_EQ(receiver.sink.frames[1].frame.port, CanPortId::kSecond);
    EXPECT_LT(receiver.sink.frames[0].stamp.a.us, receiver.sink.frames[1].stamp.a.us);
    // and the sender's confirmations name its controllers
    ASSERT_EQ(sender.sink.confirmed.size(), 2U);
    EXPECT_EQ(sender.sink.confirmed[0].frame.port, CanPortId::kFirst);
    EXPECT_EQ(sender.sink.confirmed[1].frame.port, CanPortId::kSecond);
}

// Identifiers in the order in which they win: 101h of the other one, 102h and 103h own ones, 104h of the other one.
TEST(HostCanPorts, ReceivedAndConfirmedFramesOfBothControllersComeInBusOrder)
{
    Verifies(req::SRS_HAL_011);
    // Given two devices with two controllers each on one bus, and own and foreign frames that take turns on it
    VirtualBus bus(BitRate::k1M);
    Device other(bus, InstantPair{Instant{0U}, Instant{0U}});
    Device device(bus, InstantPair{Instant{0U}, Instant{0U}});
    static_cast<void>(other.ports.ConnectPort(CanPortId::kFirst, bus, 4U));
    const NodeIndex first = device.ports.ConnectPort(CanPortId::kFirst, bus, 4U);
    const NodeIndex second = device.ports.ConnectPort(CanPortId::kSecond, bus, 4U);
    bus.AcceptNone(first);
    bus.AcceptRange(first, 0x101U, 0x101U);
    bus.AcceptNone(second);
    bus.AcceptRange(second, 0x104U, 0x104U);
    CanFrame own_second = MakeFrame(0x103U, {});
    own_second.port = CanPortId::kSecond;
    ASSERT_EQ(device.ports.Transmit(own_second), TransmitStatus::kAccepted);
    ASSERT_EQ(device.ports.Transmit(MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(other.ports.Transmit(MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(other.ports.Transmit(MakeFrame(0x104U, {})), TransmitStatus::kAccepted);
    // When all have been on the bus, then that is the order, whichever controller and whoever sent
    bus.Advance(kMillisecond);
    EXPECT_EQ(device.sink.order, (std::vector<std::uint32_t>{0x101U, 0x102U, 0x103U, 0x104U}));
}

TEST(HostCanPorts, WrongWiringIsAnErrorOfTheCaller)
{
    Verifies(req::SRS_HAL_012);
    // Given a connected first port, when it is connected again, or no port is named, then that is an error
    VirtualBus bus(BitRate::k1M);
    Device device(bus, InstantPair{Instant{0U}, Instant{0U}});
    static_cast<void>(device.ports.ConnectPort(CanPortId::kFirst, bus, 4U));
    EXPECT_THROW(static_cast<void>(device.ports.ConnectPort(CanPortId::kFirst, bus, 4U)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(device.ports.ConnectPort(CanPortId::kInvalid, bus, 4U)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(device.ports.NodeOf(CanPortId::kSecond)), std::invalid_argument);
}

} // namespace
} // namespace counterpoint::host
