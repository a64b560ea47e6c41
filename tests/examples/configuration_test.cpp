// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/actuator/actuator.hpp"
#include "examples/controller/controller.hpp"
#include "examples/sensor/sensor.hpp"
#include "hal/host/virtual/bus.hpp"
#include "tests/canopen/cia306/check_text.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include "examples/host/bench.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace counterpoint::examples
{
namespace
{
using Lines = std::vector<std::string>;

std::string FileText(const std::string& name)
{
    return cia306::ReadTextFile(std::string{COUNTERPOINT_SOURCE_FOLDER} + "/examples/" + name + "/" + name + ".dcf");
}

/// Value of an object in the text of a DCF.
std::string ParameterValue(const std::string& text, const std::string& section)
{
    const std::string key = "ParameterValue=";
    const std::size_t value = text.find(key, text.find("\n[" + section + "]\n")) + key.size();
    return text.substr(value, text.find('\n', value) - value);
}

/// Both channels of one device, in one CPU.
struct Rig
{
    template <typename Device> void Power(Device& device)
    {
        kernel = std::make_unique<Kernel>(KernelParts{a, b, board.can, board.output, board.watchdog, device});
        start = kernel->Start(device.Describe(), FlowCallback::kOff);
        abort = Device::Configure(*kernel);
    }
    [[nodiscard]] unsigned Signature(const std::uint16_t index) const
    {
        return kernel->Sign(CommunicationIndex{index}).signature;
    }

    host::VirtualBus bus{host::BitRate::k500k};
    Board board{bus, InstantPair{{0U}, {0U}}};
    channel_a::StorageFor<2U> storage_a{};
    channel_b::StorageFor<2U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    std::unique_ptr<Kernel> kernel{};
    StartResult start{StartResult::kInvalid};
    AbortCode abort{AbortCode::kGeneral};
};

TEST(ExampleFiles, CheckFindsNothing)
{
    Verifies(req::SRS_VER_019);
    // Given the files as they are in the tree
    // When they are checked without options
    // Then nothing is found, so that signatures and digest are those of the values in the file
    for (const char* name : {"first_device", "sensor", "actuator", "controller"})
    {
        EXPECT_EQ(cia306::test::FindingsOf(FileText(name), {}), Lines{}) << name;
    }
}

TEST(ExampleFiles, SensorsProgramWritesTheConfigurationOfItsFile)
{
    Verifies(req::SRS_VER_019);
    // Given the program with the digest that it expects
    Rig rig{};
    Sensor device{};
    // When it configures itself
    rig.Power(device);
    // Then both channels accept it, with signature and digest of the file
    EXPECT_EQ(rig.start, StartResult::kStarted);
    EXPECT_EQ(rig.abort, AbortCode::kNone);
    EXPECT_EQ(rig.Signature(0x1301U), 0xB631U);
    EXPECT_EQ(device.Describe().digest, 0xDCD151DEU);
    EXPECT_EQ(ParameterValue(FileText("sensor"), "13FFsub1"), "0xB631");
    EXPECT_EQ(ParameterValue(FileText("sensor"), "5F04"), "0xDCD151DE");
}

TEST(ExampleFiles, ActuatorsProgramWritesTheConfigurationOfItsFile)
{
    Verifies(req::SRS_VER_019);
    // Given the program with the digest that it expects
    Rig rig{};
    Actuator device{};
    // When it configures itself
    rig.Power(device);
    // Then both channels accept it, with signature and digest of the file
    EXPECT_EQ(rig.start, StartResult::kStarted);
    EXPECT_EQ(rig.abort, AbortCode::kNone);
    EXPECT_EQ(rig.Signature(0x1301U), 0x9FCBU);
    EXPECT_EQ(device.Describe().digest, 0xBEE7CE1CU);
    EXPECT_EQ(ParameterValue(FileText("actuator"), "13FFsub1"), "0x9FCB");
    EXPECT_EQ(ParameterValue(FileText("actuator"), "5F04"), "0xBEE7CE1C");
}

TEST(ExampleFiles, ControllersProgramWritesTheConfigurationOfItsFile)
{
    Verifies(req::SRS_VER_019);
    // Given the program with the digest that it expects
    Rig rig{};
    Controller device{PeerRole::kA};
    // When it configures itself
    rig.Power(device);
    // Then both channels accept it, with signature and digest of the file
    EXPECT_EQ(rig.start, StartResult::kStarted);
    EXPECT_EQ(rig.abort, AbortCode::kNone);
    EXPECT_EQ(rig.Signature(0x1301U), 0xB881U);
    EXPECT_EQ(rig.Signature(0x1302U), 0xCA45U);
    EXPECT_EQ(device.Describe().digest, 0x98F6E4B0U);
    EXPECT_EQ(ParameterValue(FileText("controller"), "13FFsub1"), "0xB881");
    EXPECT_EQ(ParameterValue(FileText("controller"), "13FFsub2"), "0xCA45");
    EXPECT_EQ(ParameterValue(FileText("controller"), "5F04"), "0x98F6E4B0");
}

TEST(ExampleFiles, AnotherParameterThanTheFilesIsRefused)
{
    Verifies(req::SRS_VER_019);
    // Given the sensor's program, expecting another digest than its parameters have
    Rig rig{};
    Sensor device{};
    DeviceConfig config = device.Describe();
    config.cycle_tolerance_us = 501U;
    rig.kernel = std::make_unique<Kernel>(
        KernelParts{rig.a, rig.b, rig.board.can, rig.board.output, rig.board.watchdog, device});
    ASSERT_EQ(rig.kernel->Start(config, FlowCallback::kOff), StartResult::kStarted);
    // When it configures itself
    // Then the configuration is not declared valid
    EXPECT_EQ(Sensor::Configure(*rig.kernel), AbortCode::kIncompatible);
}

} // namespace
} // namespace counterpoint::examples
