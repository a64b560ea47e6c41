// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_DRAWN_HPP
#define VERIFICATION_CAMPAIGN_DRAWN_HPP

#include <cstdint>

namespace counterpoint::campaign
{
/// @brief A number that looks drawn, of seed and number alone (SplitMix64).
[[nodiscard]] constexpr std::uint64_t Drawn(const std::uint64_t seed, const std::uint64_t number) noexcept
{
    std::uint64_t state = seed + (number + 1U) * 0x9E3779B97F4A7C15U;
    state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9U;
    state = (state ^ (state >> 27U)) * 0x94D049BB133111EBU;
    return state ^ (state >> 31U);
}
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_DRAWN_HPP
