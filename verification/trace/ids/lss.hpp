// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/lss.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_LSS_HPP
#define VERIFICATION_TRACE_IDS_LSS_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_LSS_001{"SRS_LSS_001"};
inline constexpr RequirementId SRS_LSS_002{"SRS_LSS_002"};
inline constexpr RequirementId SRS_LSS_003{"SRS_LSS_003"};
inline constexpr RequirementId SRS_LSS_004{"SRS_LSS_004"};
inline constexpr RequirementId SRS_LSS_005{"SRS_LSS_005"};
inline constexpr RequirementId SRS_LSS_006{"SRS_LSS_006"};
inline constexpr RequirementId SRS_LSS_007{"SRS_LSS_007"};
inline constexpr RequirementId SRS_LSS_008{"SRS_LSS_008"};
inline constexpr RequirementId SRS_LSS_009{"SRS_LSS_009"};
inline constexpr RequirementId SRS_LSS_010{"SRS_LSS_010"};
inline constexpr RequirementId SRS_LSS_011{"SRS_LSS_011"};
inline constexpr RequirementId SRS_LSS_012{"SRS_LSS_012"};
inline constexpr RequirementId SRS_LSS_013{"SRS_LSS_013"};
} // namespace counterpoint::req

#endif
