// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_STATISTICS_HPP
#define VERIFICATION_CAMPAIGN_STATISTICS_HPP

#include <cstdint>
#include <vector>

namespace counterpoint::campaign
{
/// @brief Greatest share, from 0 to 1, that is compatible with `hits` out of `count`: Clopper-Pearson, one-sided, with
/// `confidence` from 0 to 1. 1 where nothing was counted. [SRS_CMG_010]
[[nodiscard]] double UpperBound(std::uint64_t hits, std::uint64_t count, double confidence);
/// @brief The least value that at least this part of the sorted values does not exceed; 0 of none.
[[nodiscard]] std::uint32_t Quantile(const std::vector<std::uint32_t>& sorted, double part);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_STATISTICS_HPP
