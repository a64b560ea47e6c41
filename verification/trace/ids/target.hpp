// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/target.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_TARGET_HPP
#define VERIFICATION_TRACE_IDS_TARGET_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_BEN_001{"SRS_BEN_001"};
inline constexpr RequirementId SRS_BEN_002{"SRS_BEN_002"};
inline constexpr RequirementId SRS_BEN_003{"SRS_BEN_003"};
inline constexpr RequirementId SRS_BEN_004{"SRS_BEN_004"};
inline constexpr RequirementId SRS_BEN_005{"SRS_BEN_005"};
inline constexpr RequirementId SRS_BEN_006{"SRS_BEN_006"};
inline constexpr RequirementId SRS_BEN_007{"SRS_BEN_007"};
inline constexpr RequirementId SRS_BEN_008{"SRS_BEN_008"};
inline constexpr RequirementId SRS_BEN_009{"SRS_BEN_009"};
inline constexpr RequirementId SRS_BEN_010{"SRS_BEN_010"};
inline constexpr RequirementId SRS_BEN_011{"SRS_BEN_011"};
inline constexpr RequirementId SRS_BEN_012{"SRS_BEN_012"};
inline constexpr RequirementId SRS_BEN_013{"SRS_BEN_013"};
inline constexpr RequirementId SRS_BEN_014{"SRS_BEN_014"};
inline constexpr RequirementId SRS_BEN_015{"SRS_BEN_015"};
inline constexpr RequirementId SRS_BEN_016{"SRS_BEN_016"};
inline constexpr RequirementId SRS_TGT_001{"SRS_TGT_001"};
inline constexpr RequirementId SRS_TGT_002{"SRS_TGT_002"};
inline constexpr RequirementId SRS_TGT_003{"SRS_TGT_003"};
inline constexpr RequirementId SRS_TGT_004{"SRS_TGT_004"};
inline constexpr RequirementId SRS_TGT_005{"SRS_TGT_005"};
inline constexpr RequirementId SRS_TGT_006{"SRS_TGT_006"};
inline constexpr RequirementId SRS_TGT_007{"SRS_TGT_007"};
inline constexpr RequirementId SRS_TGT_008{"SRS_TGT_008"};
inline constexpr RequirementId SRS_TGT_009{"SRS_TGT_009"};
inline constexpr RequirementId SRS_TGT_010{"SRS_TGT_010"};
inline constexpr RequirementId SRS_TGT_011{"SRS_TGT_011"};
inline constexpr RequirementId SRS_TGT_012{"SRS_TGT_012"};
inline constexpr RequirementId SRS_TGT_230{"SRS_TGT_230"};
} // namespace counterpoint::req

#endif
