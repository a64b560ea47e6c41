// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_CAMPAIGN_ORDER_HPP
#define TOOLS_CAMPAIGN_ORDER_HPP

#include "tools/command_line/options.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
/// What `counterpoint campaign` is asked for. The program that does it is one of its own, which is no part of the
/// product; both read their command line by this.
struct CampaignOrder
{
    std::vector<std::string> files; ///< PLAN, or merge PLAN RESULTS ...
    std::string out;
    std::string html;
    std::string csv;
    std::string json;
    std::string replay; ///< Number of an experiment; empty: none.
    std::string shard{"1/1"};
    int jobs{0}; ///< 0: one for each processor.
};

/// @brief Adds the options of the command. `order` lives as long as they do.
void DescribeCampaign(Options& options, CampaignOrder& order);
/// @brief The same order as a command line: its arguments behind `campaign`, without what is the default.
[[nodiscard]] std::vector<std::string> ArgumentsOf(const CampaignOrder& order);
} // namespace counterpoint::tools

#endif // TOOLS_CAMPAIGN_ORDER_HPP
