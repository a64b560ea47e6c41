// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/pdo.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_PDO_HPP
#define VERIFICATION_TRACE_IDS_PDO_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_PDO_001{"SRS_PDO_001"};
inline constexpr RequirementId SRS_PDO_002{"SRS_PDO_002"};
inline constexpr RequirementId SRS_PDO_003{"SRS_PDO_003"};
inline constexpr RequirementId SRS_PDO_004{"SRS_PDO_004"};
inline constexpr RequirementId SRS_PDO_005{"SRS_PDO_005"};
inline constexpr RequirementId SRS_PDO_006{"SRS_PDO_006"};
inline constexpr RequirementId SRS_PDO_007{"SRS_PDO_007"};
inline constexpr RequirementId SRS_PDO_008{"SRS_PDO_008"};
inline constexpr RequirementId SRS_PDO_009{"SRS_PDO_009"};
inline constexpr RequirementId SRS_PDO_010{"SRS_PDO_010"};
inline constexpr RequirementId SRS_PDO_011{"SRS_PDO_011"};
inline constexpr RequirementId SRS_PDO_012{"SRS_PDO_012"};
inline constexpr RequirementId SRS_PDO_013{"SRS_PDO_013"};
inline constexpr RequirementId SRS_PDO_014{"SRS_PDO_014"};
inline constexpr RequirementId SRS_PDO_015{"SRS_PDO_015"};
inline constexpr RequirementId SRS_PDO_016{"SRS_PDO_016"};
inline constexpr RequirementId SRS_PDO_020{"SRS_PDO_020"};
inline constexpr RequirementId SRS_PDO_021{"SRS_PDO_021"};
inline constexpr RequirementId SRS_PDO_022{"SRS_PDO_022"};
inline constexpr RequirementId SRS_PDO_023{"SRS_PDO_023"};
inline constexpr RequirementId SRS_PDO_024{"SRS_PDO_024"};
inline constexpr RequirementId SRS_PDO_150{"SRS_PDO_150"};
inline constexpr RequirementId SRS_SYNC_001{"SRS_SYNC_001"};
inline constexpr RequirementId SRS_SYNC_002{"SRS_SYNC_002"};
inline constexpr RequirementId SRS_SYNC_003{"SRS_SYNC_003"};
inline constexpr RequirementId SRS_SYNC_004{"SRS_SYNC_004"};
inline constexpr RequirementId SRS_SYNC_005{"SRS_SYNC_005"};
inline constexpr RequirementId SRS_SYNC_006{"SRS_SYNC_006"};
inline constexpr RequirementId SRS_TIM_001{"SRS_TIM_001"};
inline constexpr RequirementId SRS_TIM_002{"SRS_TIM_002"};
inline constexpr RequirementId SRS_TIM_003{"SRS_TIM_003"};
inline constexpr RequirementId SRS_TIM_004{"SRS_TIM_004"};
} // namespace counterpoint::req

#endif
