// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/limits.hpp"

namespace counterpoint
{
namespace
{

std::uint32_t Microseconds(const std::uint32_t milliseconds) noexcept
{
    return milliseconds * kMicrosecondsPerMillisecond;
}

// The part of the limit that is the fault class's own.
std::uint32_t OwnPart(const DeviceConfig& config, const SrdoTimes& times, const FaultClass fault) noexcept
{
    switch (fault)
    {
    case FaultClass::kBus:
        return Microseconds(times.sct_ms);
    case FaultClass::kBusNextNormal:
        return Microseconds(times.sct_ms) +
               ((times.detection == SrvtDetection::kLate) ? 0U : Microseconds(times.srvt_ms));
    case FaultClass::kChannel:
        return config.discrepancy_us;
    case FaultClass::kConfiguration:
        return config.diagnostic_interval_us;
    case FaultClass::kSupervisor:
        return config.test_interval_us;
    case FaultClass::kClock:
        return config.clock_interval_us;
    case FaultClass::kWrongFrame:
    case FaultClass::kCrossLink:
    case FaultClass::kInvalid:
        return 0U;
    }
    return 0U;
}

} // namespace

Limit ComputeLimit(const DeviceConfig& config, const SrdoTimes& times, const FaultClass fault) noexcept
{
    return Limit{OwnPart(config, times, fault) + config.cycle_us + config.output_time_us};
}

Limit ComputeLimit(const DeviceConfig& config, const LinkTime& link) noexcept
{
    return Limit{link.timeout_us + config.cycle_us + config.output_time_us};
}

} // namespace counterpoint
