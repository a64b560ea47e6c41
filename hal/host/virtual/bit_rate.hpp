// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_BIT_RATE_HPP
#define HAL_HOST_VIRTUAL_BIT_RATE_HPP

#include <cstdint>
#include <limits>
#include <optional>

namespace counterpoint::host
{

/// Time of the simulated world in nanoseconds; 0 is its beginning. Never wraps (292 years).
using BusTime = std::int64_t;

constexpr BusTime kNever = std::numeric_limits<BusTime>::max();
constexpr BusTime kMicrosecond = 1'000;
constexpr BusTime kMillisecond = 1'000'000;
constexpr BusTime kSecond = 1'000'000'000;

/// The rates of CiA 301 and 100 kbit/s, as bits per second: at each of them a bit is a whole number of nanoseconds.
/// [SRS_BUS_002]
enum class BitRate : std::uint32_t
{
    k10k = 10'000U,
    k20k = 20'000U,
    k50k = 50'000U,
    k100k = 100'000U,
    k125k = 125'000U,
    k250k = 250'000U,
    k500k = 500'000U,
    k800k = 800'000U,
    k1M = 1'000'000U,
};

/// @brief The rate of so many bits per second, if it is one of BitRate.
[[nodiscard]] std::optional<BitRate> BitRateFrom(std::uint32_t bits_per_second);

/// @brief Duration of one bit.
[[nodiscard]] constexpr BusTime BitTime(const BitRate rate)
{
    return kSecond / static_cast<BusTime>(rate);
}

} // namespace counterpoint::host

#endif
