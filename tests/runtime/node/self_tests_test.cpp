// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"
#include "tests/tools/echo_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

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

// Cycle 10 ms, late above 20 ms, diagnostic interval 10 s: 500 cycles at the most until all was tested.
TEST(NodeSelfTestsTest, AChangedTableIsFoundWithinTheDiagnosticInterval)
{
    Verifies(req::SRS_NODE_013);
    std::ostringstream out;
    runtime::NodeReport report{out, runtime::ReportForm::kText, 0U};
    runtime::NodePorts ports{std::make_unique<EchoBus>(false, 0U), std::make_unique<EchoBus>(false, 0U)};
    runtime::NodeSettings settings;
    settings.dcf = std::string(COUNTERPOINT_SOURCE) + "/examples/emergency_stop/actuator.dcf";
    settings.cycle_us = 10000U;
    runtime::NodeDevice device{settings, ports, report};
    std::uint64_t now_ns = 1000U * kNsPerMs;
    const auto now = [&now_ns]
    {
        const Instant instant{static_cast<std::uint32_t>(now_ns / 1000U)};
        return InstantPair{instant, instant};
    };
    ASSERT_TRUE(device.PowerOn(now(), now_ns));
    static_cast<void>(device.TakeRestart(now_ns));
    const auto cycle = [&]
    {
        now_ns += 10U * kNsPerMs;
        device.Cycle(now(), now_ns);
        return device.Assembly().Core().DeviceState().fault;
    };
    // Given two intervals without a fault
    for (int count = 0; count < 1000; ++count)
    {
        ASSERT_EQ(cycle(), DeviceFault::kNone) << count;
    }
    // When a bit of the table of mappable objects flips, of an object that no SRDO maps
    auto& object = const_cast<MappableObject&>(device.Model().Objects().back());
    object.sub = static_cast<std::uint8_t>(object.sub ^ 0x80U);
    int cycles = 1;
    while (cycles <= 500 && cycle() == DeviceFault::kNone)
    {
        ++cycles;
    }
    EXPECT_LE(cycles, 500);
    EXPECT_EQ(device.Assembly().Core().DeviceState().fault, DeviceFault::kSelfTest);
    static_cast<void>(report.Finish());
    EXPECT_NE(out.str().find("self test failed: constants\n"), std::string::npos) << out.str();
}
} // namespace
} // namespace counterpoint::tools::test
