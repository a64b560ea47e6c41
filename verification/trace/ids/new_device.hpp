// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/new_device.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_NEW_DEVICE_HPP
#define VERIFICATION_TRACE_IDS_NEW_DEVICE_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_NEW_001{"SRS_NEW_001"};
inline constexpr RequirementId SRS_NEW_002{"SRS_NEW_002"};
inline constexpr RequirementId SRS_NEW_003{"SRS_NEW_003"};
inline constexpr RequirementId SRS_NEW_004{"SRS_NEW_004"};
inline constexpr RequirementId SRS_NEW_005{"SRS_NEW_005"};
inline constexpr RequirementId SRS_NEW_006{"SRS_NEW_006"};
inline constexpr RequirementId SRS_NEW_010{"SRS_NEW_010"};
inline constexpr RequirementId SRS_NEW_011{"SRS_NEW_011"};
inline constexpr RequirementId SRS_NEW_012{"SRS_NEW_012"};
inline constexpr RequirementId SRS_NEW_013{"SRS_NEW_013"};
inline constexpr RequirementId SRS_NEW_014{"SRS_NEW_014"};
inline constexpr RequirementId SRS_NEW_015{"SRS_NEW_015"};
inline constexpr RequirementId SRS_NEW_016{"SRS_NEW_016"};
inline constexpr RequirementId SRS_NEW_150{"SRS_NEW_150"};
inline constexpr RequirementId SRS_NEW_151{"SRS_NEW_151"};
inline constexpr RequirementId SRS_NEW_152{"SRS_NEW_152"};
inline constexpr RequirementId SRS_NEW_490{"SRS_NEW_490"};
inline constexpr RequirementId SRS_NEW_730{"SRS_NEW_730"};
inline constexpr RequirementId SRS_NEW_731{"SRS_NEW_731"};
} // namespace counterpoint::req

#endif
