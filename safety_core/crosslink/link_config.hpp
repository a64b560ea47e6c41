// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_LINK_CONFIG_HPP
#define SAFETY_CORE_CROSSLINK_LINK_CONFIG_HPP

#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/device_fault.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint
{

/// Which channel this CPU runs.
enum class PeerRole : std::uint8_t
{
    kInvalid = 0U,
    kA = 0xA5U, ///< Leads: sends the normal frames.
    kB = 0x5BU, ///< Follows: sends the inverse frames.
};

/// What a CPU must know about the link to the other one. Times in microseconds.
struct LinkConfig
{
    PeerRole role;
    std::uint32_t timeout_us;         ///< Greatest age of the newest echo. >= 3 cycles.
    std::uint32_t clock_tolerance_us; ///< Greatest difference of the clocks' progress within clock_interval_us; half of
                                      ///< it, less two time-outs' share, holds the drift and the link's jitter in half
                                      ///< the interval.
    std::uint32_t clock_interval_us;  ///< Within it, a time-out and a cycle a drift above the tolerance is found.
    std::uint32_t stamp_tolerance_us; ///< By how much the stamps of one frame on the bus may differ on the two CPUs.
};

/// First reason why a LinkConfig cannot be used. [SRS_LNK_008]
enum class LinkConfigFault : std::uint8_t
{
    kInvalid = 0U,
    kRole = 1U,
    kTimeout = 2U,
    kClock = 3U,
    kStampTolerance = 4U,
    kDiscrepancy = 5U,
    kNone = 0x5AU,
};

/// @brief Whether `link` fits the device. A link time-out must besides hold the link's delays and losses, see decision
/// 0005; only who knows the wire can check that. [SRS_LNK_008]
[[nodiscard]] LinkConfigFault CheckLinkConfig(const DeviceConfig& device, const LinkConfig& link) noexcept;

/// Why the voice of the peer no longer counts.
enum class LinkFinding : std::uint8_t
{
    kInvalid = 0U,
    kTimeout = 1U,  ///< Nothing fresh for longer than the time-out.
    kClock = 2U,    ///< The clocks drift apart.
    kFlow = 3U,     ///< The peer's program flow was not the one laid down.
    kPeerSafe = 4U, ///< The peer is in its device safe state.
    kNone = 0x5AU,
};

} // namespace counterpoint

#endif
