// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/flying_master.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_FLYING_MASTER_HPP
#define VERIFICATION_TRACE_IDS_FLYING_MASTER_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_FLY_001{"SRS_FLY_001"};
inline constexpr RequirementId SRS_FLY_002{"SRS_FLY_002"};
inline constexpr RequirementId SRS_FLY_003{"SRS_FLY_003"};
inline constexpr RequirementId SRS_FLY_004{"SRS_FLY_004"};
inline constexpr RequirementId SRS_FLY_005{"SRS_FLY_005"};
inline constexpr RequirementId SRS_FLY_006{"SRS_FLY_006"};
inline constexpr RequirementId SRS_FLY_007{"SRS_FLY_007"};
inline constexpr RequirementId SRS_FLY_008{"SRS_FLY_008"};
inline constexpr RequirementId SRS_FLY_009{"SRS_FLY_009"};
inline constexpr RequirementId SRS_FLY_010{"SRS_FLY_010"};
inline constexpr RequirementId SRS_FLY_011{"SRS_FLY_011"};
inline constexpr RequirementId SRS_FLY_012{"SRS_FLY_012"};
inline constexpr RequirementId SRS_FLY_013{"SRS_FLY_013"};
inline constexpr RequirementId SRS_FLY_014{"SRS_FLY_014"};
inline constexpr RequirementId SRS_FLY_015{"SRS_FLY_015"};
inline constexpr RequirementId SRS_FLY_016{"SRS_FLY_016"};
inline constexpr RequirementId SRS_FLY_017{"SRS_FLY_017"};
inline constexpr RequirementId SRS_FLY_018{"SRS_FLY_018"};
inline constexpr RequirementId SRS_FLY_019{"SRS_FLY_019"};
inline constexpr RequirementId SRS_FLY_020{"SRS_FLY_020"};
inline constexpr RequirementId SRS_FLY_021{"SRS_FLY_021"};
inline constexpr RequirementId SRS_FLY_022{"SRS_FLY_022"};
inline constexpr RequirementId SRS_FLY_023{"SRS_FLY_023"};
inline constexpr RequirementId SRS_FLY_024{"SRS_FLY_024"};
inline constexpr RequirementId SRS_FLY_025{"SRS_FLY_025"};
inline constexpr RequirementId SRS_FLY_026{"SRS_FLY_026"};
inline constexpr RequirementId SRS_FLY_027{"SRS_FLY_027"};
inline constexpr RequirementId SRS_FLY_028{"SRS_FLY_028"};
inline constexpr RequirementId SRS_FLY_029{"SRS_FLY_029"};
inline constexpr RequirementId SRS_FLY_030{"SRS_FLY_030"};
inline constexpr RequirementId SRS_FLY_031{"SRS_FLY_031"};
inline constexpr RequirementId SRS_FLY_150{"SRS_FLY_150"};
inline constexpr RequirementId SRS_FLY_151{"SRS_FLY_151"};
inline constexpr RequirementId SRS_FLY_152{"SRS_FLY_152"};
inline constexpr RequirementId SRS_FLY_153{"SRS_FLY_153"};
inline constexpr RequirementId SRS_FLY_340{"SRS_FLY_340"};
inline constexpr RequirementId SRS_FLY_480{"SRS_FLY_480"};
} // namespace counterpoint::req

#endif
