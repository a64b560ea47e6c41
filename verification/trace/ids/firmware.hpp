// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/firmware.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_FIRMWARE_HPP
#define VERIFICATION_TRACE_IDS_FIRMWARE_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_FW_001{"SRS_FW_001"};
inline constexpr RequirementId SRS_FW_002{"SRS_FW_002"};
inline constexpr RequirementId SRS_FW_003{"SRS_FW_003"};
inline constexpr RequirementId SRS_FW_004{"SRS_FW_004"};
inline constexpr RequirementId SRS_FW_005{"SRS_FW_005"};
inline constexpr RequirementId SRS_FW_006{"SRS_FW_006"};
inline constexpr RequirementId SRS_FW_007{"SRS_FW_007"};
inline constexpr RequirementId SRS_FW_008{"SRS_FW_008"};
inline constexpr RequirementId SRS_FW_009{"SRS_FW_009"};
inline constexpr RequirementId SRS_FW_010{"SRS_FW_010"};
inline constexpr RequirementId SRS_FW_011{"SRS_FW_011"};
inline constexpr RequirementId SRS_FW_012{"SRS_FW_012"};
inline constexpr RequirementId SRS_FW_013{"SRS_FW_013"};
inline constexpr RequirementId SRS_FW_014{"SRS_FW_014"};
inline constexpr RequirementId SRS_FW_015{"SRS_FW_015"};
inline constexpr RequirementId SRS_FW_016{"SRS_FW_016"};
inline constexpr RequirementId SRS_FW_017{"SRS_FW_017"};
inline constexpr RequirementId SRS_FW_018{"SRS_FW_018"};
inline constexpr RequirementId SRS_FW_019{"SRS_FW_019"};
inline constexpr RequirementId SRS_FW_020{"SRS_FW_020"};
inline constexpr RequirementId SRS_FW_021{"SRS_FW_021"};
inline constexpr RequirementId SRS_FW_022{"SRS_FW_022"};
} // namespace counterpoint::req

#endif
