// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_FAILOVER_RECORD_HPP
#define VERIFICATION_ELECTIONS_FAILOVER_RECORD_HPP

#include "verification/elections/series.hpp"

#include <string>
#include <vector>

namespace counterpoint::elections
{

/// A series of failovers and what it is of.
struct FailoverSeries
{
    std::string name;
    Tally tally;
};

/// @brief Writes what the evidence draws: JSON with the histogram, the times by what was computed, and whether
/// SRS_FLY_026 holds. False: the file cannot be written.
[[nodiscard]] bool WriteFailovers(const std::string& path, const std::vector<FailoverSeries>& all);

} // namespace counterpoint::elections

#endif
