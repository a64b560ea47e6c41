// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/limits.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/crosslink.hpp"

namespace counterpoint
{
namespace
{

// Given a running device, when the cross link is told to be lost, then the device fault is kCrossLink, once and for
// all.
TEST_F(Rig, LostCrossLinkIsADeviceFault)
{
    Verifies(req::SRS_LNK_006);
    Operate();
    kernel.OnCrossLinkFault();
    Cycle();
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kCrossLink);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_EQ(Open(), 0U);
    ASSERT_EQ(application.faults.size(), 1U);
    EXPECT_EQ(application.faults[0], DeviceFault::kCrossLink);
}

// Given cycle 1 ms with 0.5 ms of tolerance, output 2 ms and a link time-out of 40 ms, then the limit is 43.5 ms;
// without the time-out there is none.
TEST(ComputedLimit, CrossLinkAddsItsTimeout)
{
    Verifies(req::SRS_LNK_009);
    DeviceConfig config{};
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.output_time_us = 2000U;
    EXPECT_EQ(ComputeLimit(config, LinkTime{40000U}).us, 43500U);
    EXPECT_EQ(ComputeLimit(config, SrdoTimes{50U, 20U}, FaultClass::kCrossLink).result, Result::kNotExist);
}

} // namespace
} // namespace counterpoint
