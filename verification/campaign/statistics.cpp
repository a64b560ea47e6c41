// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace counterpoint::campaign
{
namespace
{
constexpr int kHalvings = 60;

/// Probability of at most `hits` of `count` where each comes with `share`, between 0 and 1.
double AtMost(const std::uint64_t hits, const std::uint64_t count, const double share)
{
    const auto all = static_cast<double>(count);
    double sum = 0.0;
    for (std::uint64_t hit = 0U; hit <= hits; ++hit)
    {
        const auto each = static_cast<double>(hit);
        const double choices = std::lgamma(all + 1.0) - std::lgamma(each + 1.0) - std::lgamma(all - each + 1.0);
        sum += std::exp(choices + each * std::log(share) + (all - each) * std::log1p(-share));
    }
    return sum;
}
} // namespace

double UpperBound(const std::uint64_t hits, const std::uint64_t count, const double confidence)
{
    if (hits >= count)
    {
        return 1.0;
    }
    double low = static_cast<double>(hits) / static_cast<double>(count);
    double high = 1.0;
    for (int halving = 0; halving < kHalvings; ++halving)
    {
        const double middle = (low + high) / 2.0;
        if (middle < 1.0 && AtMost(hits, count, middle) > 1.0 - confidence)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    return high;
}

std::uint32_t Quantile(const std::vector<std::uint32_t>& sorted, const double part)
{
    if (sorted.empty())
    {
        return 0U;
    }
    const double rank = std::ceil(part * static_cast<double>(sorted.size()));
    const auto place = static_cast<std::size_t>(std::max(rank, 1.0)) - 1U;
    return sorted[std::min(place, sorted.size() - 1U)];
}
} // namespace counterpoint::campaign
