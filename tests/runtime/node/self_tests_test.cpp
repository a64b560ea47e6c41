// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/memory.hpp"
#include "runtime/node/device.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>

// The self tests of a node, in a time that the test makes.
namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kNsPerMs = 1000000U;

/// The actuator. Cycle 10 ms, late above 20 ms, diagnostic interval 10 s: 500 cycles at the most until all was tested.
class NodeSelfTestsTest : public ::testing::Test
{
  protected:
    void Make(const bool has_self_tests)
    {
        settings.dcf = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/actuator.dcf";
        settings.cycle_us = 10000U;
        settings.has_self_tests = has_self_tests;
        device = std::make_unique<runtime::NodeDevice>(settings, ports, report);
        device->TellStart("udp:1", now_ns);
        ASSERT_TRUE(device->PowerOn(Now(), now_ns));
        static_cast<void>(device->TakeRestart(now_ns));
    }
    [[nodiscard]] InstantPair Now() const
    {
        const Instant instant{static_cast<std::uint32_t>(now_ns / 1000U)};
        return InstantPair{instant, instant};
    }
    DeviceFault Cycle()
    {
        now_ns += 10U * kNsPerMs;
        device->Cycle(Now(), now_ns);
        static_cast<void>(device->TakeRestart(now_ns));
        return device->Assembly().Core().DeviceState().fault;
    }
    void ExpectNoFault(const int cycles)
    {
        for (int count = 0; count < cycles; ++count)
        {
            ASSERT_EQ(Cycle(), DeviceFault::kNone) << count;
        }
    }
    /// A bit of the table of mappable objects, of an object that no SRDO maps.
    void FlipTable()
    {
        auto& object = const_cast<MappableObject&>(device->Model().Objects().back());
        object.sub = static_cast<std::uint8_t>(object.sub ^ 0x80U);
    }
    std::string Told()
    {
        static_cast<void>(report.Finish());
        return out.str();
    }

    std::uint64_t now_ns{1000U * kNsPerMs};
    std::ostringstream out{};
    runtime::NodeReport report{out, runtime::ReportForm::kText, 0U};
    runtime::NodePorts ports{std::make_unique<EchoBus>(false, 0U), std::make_unique<EchoBus>(false, 0U)};
    runtime::NodeSettings settings{};
    std::unique_ptr<runtime::NodeDevice> device{};
};

TEST_F(NodeSelfTestsTest, AChangedTableIsFoundWithinTheDiagnosticIntervalAndAtEachStart)
{
    Verifies(req::SRS_NODE_013);
    // Given two intervals without a fault
    Make(true);
    ExpectNoFault(1000);
    // When a bit of a table flips
    FlipTable();
    int cycles = 1;
    while (cycles <= 500 && Cycle() == DeviceFault::kNone)
    {
        ++cycles;
    }
    EXPECT_LE(cycles, 500);
    EXPECT_EQ(device->Assembly().Core().DeviceState().fault, DeviceFault::kSelfTest);
    // When it starts anew, then it is found again before anything else is done
    device->OnFrame(FrameOf(0x000U, {129U, 33U}, now_ns), CanPortId::kFirst, Now());
    static_cast<void>(Cycle()); // The reset.
    EXPECT_EQ(Cycle(), DeviceFault::kSelfTest);
    const std::string failed = "self test failed: constants\n";
    const std::string told = Told();
    EXPECT_NE(told.find(failed), std::string::npos) << told;
    EXPECT_NE(told.find(failed), told.rfind(failed)) << told;
}

/// Writes over 512 KiB below its caller.
[[gnu::noinline]] std::uint8_t UseMuchStack()
{
    std::array<volatile std::uint8_t, 512U * 1024U> used;
    for (volatile std::uint8_t& byte : used)
    {
        byte = 0x55U;
    }
    return used[1000U];
}

// The loop may use 256 KiB.
TEST_F(NodeSelfTestsTest, AStackThatGrewTooFarIsFoundInTheNextCycle)
{
    Verifies(req::SRS_NODE_013);
    Make(true);
    ExpectNoFault(10);
    EXPECT_EQ(UseMuchStack(), 0x55U);
    EXPECT_EQ(Cycle(), DeviceFault::kSelfTest);
    EXPECT_NE(Told().find("self test failed: stack guard\n"), std::string::npos) << Told();
}

TEST_F(NodeSelfTestsTest, APartWithAnotherTableOfFunctionsIsFoundInTheNextCycle)
{
    Verifies(req::SRS_NODE_013);
    Make(true);
    ExpectNoFault(10);
    // Given a copy of the table of functions of what the kernel tells
    constexpr std::size_t kWords = 128U;
    constexpr std::size_t kBefore = 4U; // In front of the functions.
    host::HostMemory memory;
    alignas(8) std::array<std::uint32_t, kWords> copy{};
    const hal::Address part = memory.PlaceOf(&device->Assembly().Told());
    const hal::Address table = *reinterpret_cast<const hal::Address*>(part);
    for (std::size_t word = 0U; word < kWords; ++word)
    {
        copy.at(word) = memory.Read(table + (word - kBefore) * hal::kWordBytes);
    }
    // When the object has the copy
    const hal::Address other = memory.PlaceOf(&copy.at(kBefore));
    const std::array<std::uint32_t, 2U> was{memory.Read(part), memory.Read(part + hal::kWordBytes)};
    memory.Write(part, static_cast<std::uint32_t>(other));
    memory.Write(part + hal::kWordBytes, static_cast<std::uint32_t>(other >> 32U));
    EXPECT_EQ(Cycle(), DeviceFault::kSelfTest);
    memory.Write(part, was[0]);
    memory.Write(part + hal::kWordBytes, was[1]);
    EXPECT_NE(Told().find("self test failed: parts\n"), std::string::npos) << Told();
}

TEST_F(NodeSelfTestsTest, TheMemoryOfKernelAndChannelsIsCovered)
{
    Verifies(req::SRS_NODE_013);
    Make(true);
    const DeviceConfig& config = device->Config();
    std::size_t bytes = sizeof(Kernel) / 4U * 4U;
    for (const runtime::Letter letter : {runtime::Letter::kA, runtime::Letter::kB})
    {
        const auto channel = runtime::MakeChannel(letter, runtime::RoomOf(config));
        bytes += channel->Size() / 4U * 4U + channel->VoiceSize() / 4U * 4U;
    }
    EXPECT_NE(
        Told().find(" KiB of program, " + std::to_string(bytes) + " bytes of channels and kernel, every 500 cycles\n"),
        std::string::npos)
        << Told();
}

/// An output that finds the same of all permits.
class BlindOutput final : public hal::SafetyOutput
{
  public:
    explicit BlindOutput(const hal::ProbeAnswer answer) : answer_{answer}
    {
    }
    std::uint32_t Challenge() noexcept override
    {
        return 1U;
    }
    void Drive(const hal::PermitSet& /*permits*/) noexcept override
    {
    }
    hal::ProbeAnswer Probe(const hal::PermitSet& /*permits*/, std::uint32_t /*challenge*/) const noexcept override
    {
        return answer_;
    }

  private:
    hal::ProbeAnswer answer_;
};

TEST_F(NodeSelfTestsTest, AnOutputThatDoesNotTellRightPermitsFromWrongOnesFailsTheStart)
{
    Verifies(req::SRS_NODE_013);
    Make(true);
    const DeviceConfig& config = device->Config();
    for (const hal::ProbeAnswer answer :
         {hal::ProbeAnswer::kAccepted, hal::ProbeAnswer::kRefused, hal::ProbeAnswer::kAbsent})
    {
        const BlindOutput output{answer};
        const auto channel = runtime::MakeChannel(runtime::Letter::kA, runtime::RoomOf(config));
        runtime::NodeSelfTest test{output};
        test.AddChannel(*channel);
        test.AddConstants(config, device->Model());
        ASSERT_TRUE(test.Settle(500U));
        test.Start();
        EXPECT_EQ(test.Failure(), "permits");
        EXPECT_EQ(test.Part().OnCycle().fault, DeviceFault::kSelfTest);
    }
}

TEST_F(NodeSelfTestsTest, WithoutSelfTestsNothingIsFoundAndThatIsTold)
{
    Verifies(req::SRS_NODE_013);
    Make(false);
    EXPECT_EQ(UseMuchStack(), 0x55U);
    ExpectNoFault(100);
    EXPECT_NE(Told().find("self tests: none\n"), std::string::npos) << Told();
    EXPECT_EQ(Told().find("self test failed"), std::string::npos) << Told();
}
} // namespace
} // namespace counterpoint::tools::test
