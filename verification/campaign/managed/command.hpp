// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_MANAGED_COMMAND_HPP
#define VERIFICATION_CAMPAIGN_MANAGED_COMMAND_HPP

#include "tools/campaign/order.hpp"
#include "tools/command_line/command.hpp"
#include "verification/campaign/results.hpp"

#include <string>
#include <vector>

namespace counterpoint::campaign::managed
{
/// @brief Files that a run of this plan reads beside the plan. Throws YamlError.
[[nodiscard]] std::vector<std::string> FilesOf(const std::string& plan);
/// @brief Tries, and reports. Throws YamlError, cia306::InputError, and std::runtime_error.
[[nodiscard]] tools::ExitStatus Try(const tools::CampaignOrder& order, const Shard& shard,
                                    const tools::Streams& streams);
/// @brief Joins results, and reports. [SRS_CMG_075]
[[nodiscard]] tools::ExitStatus Merge(const tools::CampaignOrder& order, const tools::Streams& streams);
/// @brief One experiment again, with its time line. [SRS_CMG_076]
[[nodiscard]] tools::ExitStatus ShowAgain(const tools::CampaignOrder& order, const tools::Streams& streams);
} // namespace counterpoint::campaign::managed

#endif // VERIFICATION_CAMPAIGN_MANAGED_COMMAND_HPP
