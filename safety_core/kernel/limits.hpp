// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_LIMITS_HPP
#define SAFETY_CORE_KERNEL_LIMITS_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/result.hpp"

#include <cstdint>

namespace counterpoint
{

/// @brief Longest time between two cycles: a call that late is no fault. What has to be done within an interval is
/// divided by it.
[[nodiscard]] inline std::uint32_t LateCycleUs(const DeviceConfig& config) noexcept
{
    return config.cycle_us + config.cycle_tolerance_us;
}

/// Classes of faults for which a limit can be computed. [SRS_LIM_001, SRS_LIM_210,
/// SRS_LIM_211, SRS_LIM_212]
enum class FaultClass : std::uint8_t
{
    kInvalid = 0U,
    kBus = 1U,           ///< Loss, delay, anything on the bus: from the last good normal frame.
    kBusNextNormal = 2U, ///< The same where the next normal frame still came, by the SRDO's detection.
    kWrongFrame = 3U,    ///< A frame that is wrong in itself: from its arrival.
    kChannel = 4U,       ///< One channel stuck, skipped, wrong data.
    kConfiguration = 5U, ///< Configuration, memory, table: the copy of one channel, or a sealed word.
    kSupervisor = 6U,    ///< Comparator, flow monitor, permits.
    kClock = 7U,         ///< Clock, cycle.
    kCrossLink = 8U,     ///< Loss of the other CPU, its link: by the limit that takes a LinkTime.
    /// What both channels read from one place: device description, constants; with a channel a CPU the copy of either.
    /// Where the self test's CRC runs over it, it is kConfiguration: SelfTest::Start made sure of the interval.
    kSharedSource = 9U,
};

/// Times of the SRDO concerned, from its objects, and how it finds a missing inverse frame. Milliseconds.
struct SrdoTimes
{
    std::uint16_t sct_ms{0U};
    std::uint8_t srvt_ms{0U};
    SrvtDetection detection{SrvtDetection::kEarly};
};

/// Greatest age of what the other CPU said; a device with one CPU has none. For a clock of the other CPU that drifts
/// the link's clock interval is added to it (SRS_LNK_012).
struct LinkTime
{
    std::uint32_t timeout_us;
};

/// `us` is the greatest value unless `result` is kSuccessful: a class that has no limit has no short one.
struct Limit
{
    std::uint32_t us;
    Result result; ///< kNotExist: no such class, none by these times, or more than 32 bits hold.
};

/// @brief Greatest time from the first effect of a fault to the safe output, in microseconds: the class's own part, a
/// cycle as late as it may be, what the counters may drift apart meanwhile, and the output time. [SRS_LIM_001,
/// SRS_LIM_002]
[[nodiscard]] Limit ComputeLimit(const DeviceConfig& config, const SrdoTimes& times, FaultClass fault) noexcept;
/// @brief The same for FaultClass::kCrossLink. [SRS_LNK_009]
[[nodiscard]] Limit ComputeLimit(const DeviceConfig& config, const LinkTime& link) noexcept;

} // namespace counterpoint

#endif
