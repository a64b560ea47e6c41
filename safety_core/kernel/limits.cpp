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

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

// The part of the limit that is the fault class's own; kNone where there is none.
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
    case FaultClass::kSharedSource:
        return 2U * config.diagnostic_interval_us; // A change behind the walk's place shows at the end of the next one.
    case FaultClass::kWrongFrame:
        return 0U;
    case FaultClass::kCrossLink:
    case FaultClass::kInvalid:
        return kNone;
    }
    return kNone;
}

// Own part and cycle are counted by the counters. One that is slow by the tolerance counts no less than interval -
// tolerance in an interval of the other one: it adds the tolerance for each of these that begins. A sum that 32 bits do
// not hold is none, and so is one with kNone in it.
Limit WholeOf(const DeviceConfig& config, const std::uint32_t own_us) noexcept
{
    const std::uint32_t late_us = LateCycleUs(config);
    const std::uint32_t counted_us = (own_us < (kNone - late_us)) ? (own_us + late_us) : kNone;
    const bool is_interval = config.clock_interval_us > config.clock_tolerance_us;
    const std::uint32_t least_us = config.clock_interval_us - config.clock_tolerance_us;
    const std::uint32_t whole = is_interval ? (counted_us / least_us) : 0U;
    const std::uint64_t drift_us = (std::uint64_t{whole} + 1U) * config.clock_tolerance_us;
    const std::uint64_t sum_us = drift_us + counted_us + config.output_time_us;
    return (sum_us < kNone) ? Limit{static_cast<std::uint32_t>(sum_us), Result::kSuccessful}
                            : Limit{kNone, Result::kNotExist};
}

} // namespace

Limit ComputeLimit(const DeviceConfig& config, const SrdoTimes& times, const FaultClass fault) noexcept
{
    return WholeOf(config, OwnPart(config, times, fault));
}

Limit ComputeLimit(const DeviceConfig& config, const LinkTime& link) noexcept
{
    return WholeOf(config, link.timeout_us);
}

} // namespace counterpoint
