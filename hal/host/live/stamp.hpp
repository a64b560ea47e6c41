// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_STAMP_HPP
#define HAL_HOST_LIVE_STAMP_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <sys/socket.h>

namespace counterpoint::host
{

/// A datagram as the system handed it over: its length, its time, and what was lost before it.
struct LiveArrival
{
    std::ptrdiff_t count{-1};      ///< Bytes; below 0: nothing came, `failure` says why.
    int failure{0};                ///< errno.
    int flags{0};                  ///< MSG_CONFIRM, MSG_TRUNC and the like.
    std::uint64_t time_ns{0U};     ///< CLOCK_MONOTONIC.
    std::uint64_t hardware_ns{0U}; ///< Stamp of the controller, in its own time; 0: its driver gives none.
    std::uint32_t dropped{0U};     ///< Datagrams dropped by the system since the socket was opened; 0: not told.
};

/// @brief Asks the system for stamps (nanoseconds, of the hardware too) and counts of dropped datagrams with each
/// datagram.
void RequestStamps(int socket);
/// @brief Reads one datagram without blocking.
[[nodiscard]] LiveArrival ReadStamped(int socket, void* bytes, std::size_t room);
/// @brief Takes what the system says of a datagram that was read at `arrival.time_ns`. [SRS_LIVE_002, SRS_LIVE_057]
void ReadStamps(msghdr& message, LiveArrival& arrival);
/// @brief A stamp of the wall clock as one of the monotonic clock: what counts is its age, `wall_now_ns - stamp_ns`. An
/// age below 0 or above ten seconds is one of a clock that was set meanwhile, and gives `monotonic_now_ns`.
/// [SRS_LIVE_002]
[[nodiscard]] std::uint64_t MonotonicStamp(std::uint64_t stamp_ns, std::uint64_t wall_now_ns,
                                           std::uint64_t monotonic_now_ns);

/// The wall clock, read between two readings of the monotonic clock.
struct ClockReading
{
    std::uint64_t before_ns;
    std::uint64_t wall_ns;
    std::uint64_t after_ns;
};
using ClockReadings = std::array<ClockReading, 3U>;

/// @brief The reading that took least time. A process may be interrupted between the two clocks, and stamps would be
/// wrong by as much. [SRS_LIVE_002]
[[nodiscard]] ClockReading Quickest(const ClockReadings& readings);

} // namespace counterpoint::host

#endif
