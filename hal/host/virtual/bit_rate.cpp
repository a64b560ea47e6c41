// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bit_rate.hpp"

#include <array>

namespace counterpoint::host
{

std::optional<BitRate> BitRateFrom(const std::uint32_t bits_per_second)
{
    constexpr std::array<BitRate, 9U> kRates{BitRate::k10k,  BitRate::k20k,  BitRate::k50k,
                                             BitRate::k100k, BitRate::k125k, BitRate::k250k,
                                             BitRate::k500k, BitRate::k800k, BitRate::k1M};
    for (const BitRate rate : kRates)
    {
        if (static_cast<std::uint32_t>(rate) == bits_per_second)
        {
            return rate;
        }
    }
    return std::nullopt;
}

} // namespace counterpoint::host
