// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_LIMITS_HPP
#define SAFETY_CORE_KERNEL_LIMITS_HPP

#include "safety_core/contract/configuration.hpp"

#include <cstdint>

namespace counterpoint
{

/// Classes of faults for which a limit can be computed. [SRS_LIM_001]
enum class FaultClass : std::uint8_t
{
    kInvalid = 0U,
    kBus = 1U,           ///< Loss, delay, anything on the bus: from the last good normal frame.
    kBusNextNormal = 2U, ///< The same where the next normal frame still came, by the SRDO's detection.
    kWrongFrame = 3U,    ///< A frame that is wrong in itself: from its arrival.
    kChannel = 4U,       ///< One channel stuck, skipped, wrong data.
    kConfiguration = 5U, ///< Configuration, memory, table.
    kSupervisor = 6U,    ///< Comparator, flow monitor, permits.
    kClock = 7U,         ///< Clock, cycle.
    kCrossLink = 8U,     ///< Loss of the other CPU, its link, its clock: by the limit that takes a LinkTime.
};

/// Times of the SRDO concerned, from its objects, and how it finds a missing inverse frame. Milliseconds.
struct SrdoTimes
{
    std::uint16_t sct_ms{0U};
    std::uint8_t srvt_ms{0U};
    SrvtDetection detection{SrvtDetection::kEarly};
};

/// Greatest age of what the other CPU said; a device with one CPU has none.
struct LinkTime
{
    std::uint32_t timeout_us;
};

struct Limit
{
    std::uint32_t us;
};

/// @brief Greatest time from the first effect of a fault to the safe output, in microseconds. [SRS_LIM_001]
[[nodiscard]] Limit ComputeLimit(const DeviceConfig& config, const SrdoTimes& times, FaultClass fault) noexcept;
/// @brief The same for FaultClass::kCrossLink. [SRS_LNK_009]
[[nodiscard]] Limit ComputeLimit(const DeviceConfig& config, const LinkTime& link) noexcept;

} // namespace counterpoint

#endif
