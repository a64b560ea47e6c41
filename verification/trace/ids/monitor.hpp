// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/monitor.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_MONITOR_HPP
#define VERIFICATION_TRACE_IDS_MONITOR_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_MON_001{"SRS_MON_001"};
inline constexpr RequirementId SRS_MON_002{"SRS_MON_002"};
inline constexpr RequirementId SRS_MON_003{"SRS_MON_003"};
inline constexpr RequirementId SRS_MON_004{"SRS_MON_004"};
inline constexpr RequirementId SRS_MON_005{"SRS_MON_005"};
inline constexpr RequirementId SRS_MON_006{"SRS_MON_006"};
inline constexpr RequirementId SRS_MON_007{"SRS_MON_007"};
inline constexpr RequirementId SRS_MON_008{"SRS_MON_008"};
inline constexpr RequirementId SRS_MON_009{"SRS_MON_009"};
inline constexpr RequirementId SRS_MON_010{"SRS_MON_010"};
inline constexpr RequirementId SRS_MON_011{"SRS_MON_011"};
inline constexpr RequirementId SRS_MON_012{"SRS_MON_012"};
inline constexpr RequirementId SRS_MON_013{"SRS_MON_013"};
inline constexpr RequirementId SRS_MON_014{"SRS_MON_014"};
inline constexpr RequirementId SRS_MON_015{"SRS_MON_015"};
inline constexpr RequirementId SRS_MON_016{"SRS_MON_016"};
inline constexpr RequirementId SRS_MON_017{"SRS_MON_017"};
inline constexpr RequirementId SRS_MON_018{"SRS_MON_018"};
inline constexpr RequirementId SRS_MON_019{"SRS_MON_019"};
inline constexpr RequirementId SRS_MON_020{"SRS_MON_020"};
inline constexpr RequirementId SRS_MON_021{"SRS_MON_021"};
inline constexpr RequirementId SRS_MON_025{"SRS_MON_025"};
inline constexpr RequirementId SRS_MON_030{"SRS_MON_030"};
inline constexpr RequirementId SRS_MON_040{"SRS_MON_040"};
inline constexpr RequirementId SRS_MON_041{"SRS_MON_041"};
inline constexpr RequirementId SRS_MON_042{"SRS_MON_042"};
inline constexpr RequirementId SRS_MON_043{"SRS_MON_043"};
inline constexpr RequirementId SRS_MON_044{"SRS_MON_044"};
inline constexpr RequirementId SRS_MON_045{"SRS_MON_045"};
inline constexpr RequirementId SRS_MON_120{"SRS_MON_120"};
inline constexpr RequirementId SRS_MON_170{"SRS_MON_170"};
inline constexpr RequirementId SRS_MON_240{"SRS_MON_240"};
inline constexpr RequirementId SRS_MON_241{"SRS_MON_241"};
inline constexpr RequirementId SRS_MON_330{"SRS_MON_330"};
inline constexpr RequirementId SRS_MON_331{"SRS_MON_331"};
inline constexpr RequirementId SRS_MON_332{"SRS_MON_332"};
inline constexpr RequirementId SRS_MON_340{"SRS_MON_340"};
inline constexpr RequirementId SRS_MON_341{"SRS_MON_341"};
inline constexpr RequirementId SRS_MON_400{"SRS_MON_400"};
inline constexpr RequirementId SRS_MON_401{"SRS_MON_401"};
inline constexpr RequirementId SRS_MON_490{"SRS_MON_490"};
inline constexpr RequirementId SRS_MON_530{"SRS_MON_530"};
inline constexpr RequirementId SRS_MON_531{"SRS_MON_531"};
inline constexpr RequirementId SRS_MON_580{"SRS_MON_580"};
inline constexpr RequirementId SRS_MON_581{"SRS_MON_581"};
inline constexpr RequirementId SRS_MON_710{"SRS_MON_710"};
inline constexpr RequirementId SRS_MON_711{"SRS_MON_711"};
inline constexpr RequirementId SRS_MON_730{"SRS_MON_730"};
} // namespace counterpoint::req

#endif
