// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_COMMAND_HPP
#define VERIFICATION_CAMPAIGN_COMMAND_HPP

#include "tools/command_line/command.hpp"

#include <memory>

namespace counterpoint::campaign
{
/// @brief `counterpoint campaign`: runs a plan, or joins results. [SRS_CMG_004, SRS_CMG_008, SRS_CMG_010]
[[nodiscard]] std::unique_ptr<tools::Command> MakeCampaign();
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_COMMAND_HPP
