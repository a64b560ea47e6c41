// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/crosslink.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_CROSSLINK_HPP
#define VERIFICATION_TRACE_IDS_CROSSLINK_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_LNK_001{"SRS_LNK_001"};
inline constexpr RequirementId SRS_LNK_002{"SRS_LNK_002"};
inline constexpr RequirementId SRS_LNK_003{"SRS_LNK_003"};
inline constexpr RequirementId SRS_LNK_004{"SRS_LNK_004"};
inline constexpr RequirementId SRS_LNK_005{"SRS_LNK_005"};
inline constexpr RequirementId SRS_LNK_006{"SRS_LNK_006"};
inline constexpr RequirementId SRS_LNK_007{"SRS_LNK_007"};
inline constexpr RequirementId SRS_LNK_008{"SRS_LNK_008"};
inline constexpr RequirementId SRS_LNK_009{"SRS_LNK_009"};
inline constexpr RequirementId SRS_LNK_010{"SRS_LNK_010"};
inline constexpr RequirementId SRS_LNK_011{"SRS_LNK_011"};
inline constexpr RequirementId SRS_LNK_012{"SRS_LNK_012"};
inline constexpr RequirementId SRS_LNK_020{"SRS_LNK_020"};
inline constexpr RequirementId SRS_LNK_021{"SRS_LNK_021"};
inline constexpr RequirementId SRS_LNK_022{"SRS_LNK_022"};
inline constexpr RequirementId SRS_LNK_210{"SRS_LNK_210"};
inline constexpr RequirementId SRS_LNK_211{"SRS_LNK_211"};
inline constexpr RequirementId SRS_LNK_212{"SRS_LNK_212"};
inline constexpr RequirementId SRS_TWO_001{"SRS_TWO_001"};
inline constexpr RequirementId SRS_TWO_002{"SRS_TWO_002"};
inline constexpr RequirementId SRS_TWO_003{"SRS_TWO_003"};
inline constexpr RequirementId SRS_TWO_004{"SRS_TWO_004"};
inline constexpr RequirementId SRS_TWO_005{"SRS_TWO_005"};
inline constexpr RequirementId SRS_TWO_006{"SRS_TWO_006"};
inline constexpr RequirementId SRS_TWO_007{"SRS_TWO_007"};
inline constexpr RequirementId SRS_TWO_008{"SRS_TWO_008"};
inline constexpr RequirementId SRS_TWO_009{"SRS_TWO_009"};
inline constexpr RequirementId SRS_TWO_010{"SRS_TWO_010"};
inline constexpr RequirementId SRS_TWO_011{"SRS_TWO_011"};
inline constexpr RequirementId SRS_TWO_012{"SRS_TWO_012"};
inline constexpr RequirementId SRS_TWO_013{"SRS_TWO_013"};
inline constexpr RequirementId SRS_TWO_014{"SRS_TWO_014"};
inline constexpr RequirementId SRS_TWO_015{"SRS_TWO_015"};
inline constexpr RequirementId SRS_TWO_016{"SRS_TWO_016"};
inline constexpr RequirementId SRS_TWO_017{"SRS_TWO_017"};
inline constexpr RequirementId SRS_TWO_018{"SRS_TWO_018"};
inline constexpr RequirementId SRS_TWO_019{"SRS_TWO_019"};
inline constexpr RequirementId SRS_TWO_150{"SRS_TWO_150"};
inline constexpr RequirementId SRS_TWO_151{"SRS_TWO_151"};
inline constexpr RequirementId SRS_TWO_210{"SRS_TWO_210"};
inline constexpr RequirementId SRS_TWO_211{"SRS_TWO_211"};
inline constexpr RequirementId SRS_TWO_212{"SRS_TWO_212"};
inline constexpr RequirementId SRS_TWO_213{"SRS_TWO_213"};
inline constexpr RequirementId SRS_TWO_214{"SRS_TWO_214"};
inline constexpr RequirementId SRS_TWO_215{"SRS_TWO_215"};
inline constexpr RequirementId SRS_TWO_216{"SRS_TWO_216"};
inline constexpr RequirementId SRS_TWO_217{"SRS_TWO_217"};
} // namespace counterpoint::req

#endif
