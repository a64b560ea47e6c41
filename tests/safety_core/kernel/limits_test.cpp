// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/limits.hpp"

#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint
{
namespace
{

// Cycle 1 ms, output 2 ms, discrepancy 5 ms, diagnostic interval 1 s, test interval 0.5 s, clock interval 0.1 s;
// SRDO with SCT 50 ms and SRVT 20 ms.
TEST(ComputedLimit, EachClassOfFaultHasTheLimitOfTheTable)
{
    Verifies(req::SRS_LIM_001);
    DeviceConfig config{};
    config.cycle_us = 1000U;
    config.cycle_tolerance_us = 500U;
    config.output_time_us = 2000U;
    config.discrepancy_us = 5000U;
    config.diagnostic_interval_us = 1000000U;
    config.test_interval_us = 500000U;
    config.clock_interval_us = 100000U;
    const SrdoTimes times{50U, 20U};
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kBus).us, 53000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kBusNextNormal).us, 73000U);
    EXPECT_EQ(ComputeLimit(config, SrdoTimes{50U, 20U, SrvtDetection::kLate}, FaultClass::kBusNextNormal).us, 53000U);
    EXPECT_EQ(ComputeLimit(config, SrdoTimes{50U, 20U, SrvtDetection::kLate}, FaultClass::kBus).us, 53000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kWrongFrame).us, 3000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kChannel).us, 8000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kConfiguration).us, 1003000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kSupervisor).us, 503000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kClock).us, 103000U);
    EXPECT_EQ(ComputeLimit(config, times, FaultClass::kInvalid).us, 3000U);
    EXPECT_EQ(ComputeLimit(config, times, static_cast<FaultClass>(0xEEU)).us, 3000U);
}

} // namespace
} // namespace counterpoint
