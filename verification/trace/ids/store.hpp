// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/store.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_STORE_HPP
#define VERIFICATION_TRACE_IDS_STORE_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_STO_001{"SRS_STO_001"};
inline constexpr RequirementId SRS_STO_002{"SRS_STO_002"};
inline constexpr RequirementId SRS_STO_003{"SRS_STO_003"};
inline constexpr RequirementId SRS_STO_004{"SRS_STO_004"};
inline constexpr RequirementId SRS_STO_005{"SRS_STO_005"};
inline constexpr RequirementId SRS_STO_006{"SRS_STO_006"};
inline constexpr RequirementId SRS_STO_007{"SRS_STO_007"};
inline constexpr RequirementId SRS_STO_008{"SRS_STO_008"};
inline constexpr RequirementId SRS_STO_010{"SRS_STO_010"};
inline constexpr RequirementId SRS_STO_011{"SRS_STO_011"};
inline constexpr RequirementId SRS_STO_012{"SRS_STO_012"};
inline constexpr RequirementId SRS_STO_013{"SRS_STO_013"};
inline constexpr RequirementId SRS_STO_014{"SRS_STO_014"};
inline constexpr RequirementId SRS_STO_015{"SRS_STO_015"};
inline constexpr RequirementId SRS_STO_016{"SRS_STO_016"};
inline constexpr RequirementId SRS_STO_017{"SRS_STO_017"};
inline constexpr RequirementId SRS_STO_018{"SRS_STO_018"};
inline constexpr RequirementId SRS_STO_019{"SRS_STO_019"};
inline constexpr RequirementId SRS_STO_020{"SRS_STO_020"};
inline constexpr RequirementId SRS_STO_021{"SRS_STO_021"};
inline constexpr RequirementId SRS_STO_210{"SRS_STO_210"};
inline constexpr RequirementId SRS_STO_240{"SRS_STO_240"};
inline constexpr RequirementId SRS_STO_241{"SRS_STO_241"};
inline constexpr RequirementId SRS_STO_450{"SRS_STO_450"};
} // namespace counterpoint::req

#endif
