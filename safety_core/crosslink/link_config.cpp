// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/link_config.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLongestIntervalUs = 0x20000000U;
constexpr std::uint32_t kTimeoutsOfInterval = 4U;
constexpr std::uint32_t kCyclesOfRoundTrip = 3U;
constexpr std::uint32_t kCyclesOfDiscrepancy = 2U;

} // namespace

LinkConfigFault CheckLinkConfig(const DeviceConfig& device, const LinkConfig& link) noexcept
{
    LinkConfigFault fault = LinkConfigFault::kNone;
    const bool is_tolerance = (link.clock_tolerance_us != 0U) && (link.clock_tolerance_us <= (link.timeout_us / 2U));
    const bool is_interval = (link.timeout_us <= (link.clock_interval_us / kTimeoutsOfInterval)) &&
                             (link.clock_interval_us <= kLongestIntervalUs);
    // The last one that is found is the one that is given: in reverse order.
    if (device.discrepancy_us < (kCyclesOfDiscrepancy * device.cycle_us))
    {
        fault = LinkConfigFault::kDiscrepancy;
    }
    if (link.stamp_tolerance_us >= link.timeout_us)
    {
        fault = LinkConfigFault::kStampTolerance;
    }
    if (!(is_tolerance && is_interval))
    {
        fault = LinkConfigFault::kClock;
    }
    if (link.timeout_us < (kCyclesOfRoundTrip * device.cycle_us))
    {
        fault = LinkConfigFault::kTimeout;
    }
    if ((link.role != PeerRole::kA) && (link.role != PeerRole::kB))
    {
        fault = LinkConfigFault::kRole;
    }
    return fault;
}

} // namespace counterpoint
