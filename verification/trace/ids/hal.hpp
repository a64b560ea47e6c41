// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/hal.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_HAL_HPP
#define VERIFICATION_TRACE_IDS_HAL_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_BUS_001{"SRS_BUS_001"};
inline constexpr RequirementId SRS_BUS_002{"SRS_BUS_002"};
inline constexpr RequirementId SRS_BUS_003{"SRS_BUS_003"};
inline constexpr RequirementId SRS_BUS_004{"SRS_BUS_004"};
inline constexpr RequirementId SRS_BUS_005{"SRS_BUS_005"};
inline constexpr RequirementId SRS_BUS_006{"SRS_BUS_006"};
inline constexpr RequirementId SRS_BUS_007{"SRS_BUS_007"};
inline constexpr RequirementId SRS_BUS_008{"SRS_BUS_008"};
inline constexpr RequirementId SRS_BUS_009{"SRS_BUS_009"};
inline constexpr RequirementId SRS_BUS_010{"SRS_BUS_010"};
inline constexpr RequirementId SRS_BUS_011{"SRS_BUS_011"};
inline constexpr RequirementId SRS_BUS_012{"SRS_BUS_012"};
inline constexpr RequirementId SRS_BUS_013{"SRS_BUS_013"};
inline constexpr RequirementId SRS_BUS_014{"SRS_BUS_014"};
inline constexpr RequirementId SRS_BUS_015{"SRS_BUS_015"};
inline constexpr RequirementId SRS_BUS_016{"SRS_BUS_016"};
inline constexpr RequirementId SRS_BUS_017{"SRS_BUS_017"};
inline constexpr RequirementId SRS_HAL_001{"SRS_HAL_001"};
inline constexpr RequirementId SRS_HAL_002{"SRS_HAL_002"};
inline constexpr RequirementId SRS_HAL_003{"SRS_HAL_003"};
inline constexpr RequirementId SRS_HAL_004{"SRS_HAL_004"};
inline constexpr RequirementId SRS_HAL_005{"SRS_HAL_005"};
inline constexpr RequirementId SRS_HAL_006{"SRS_HAL_006"};
inline constexpr RequirementId SRS_HAL_007{"SRS_HAL_007"};
inline constexpr RequirementId SRS_HAL_008{"SRS_HAL_008"};
inline constexpr RequirementId SRS_HAL_009{"SRS_HAL_009"};
inline constexpr RequirementId SRS_HAL_010{"SRS_HAL_010"};
inline constexpr RequirementId SRS_HAL_011{"SRS_HAL_011"};
inline constexpr RequirementId SRS_HAL_012{"SRS_HAL_012"};
inline constexpr RequirementId SRS_HAL_013{"SRS_HAL_013"};
inline constexpr RequirementId SRS_HAL_014{"SRS_HAL_014"};
inline constexpr RequirementId SRS_HAL_015{"SRS_HAL_015"};
inline constexpr RequirementId SRS_HAL_016{"SRS_HAL_016"};
inline constexpr RequirementId SRS_HAL_030{"SRS_HAL_030"};
inline constexpr RequirementId SRS_HAL_031{"SRS_HAL_031"};
inline constexpr RequirementId SRS_HAL_032{"SRS_HAL_032"};
inline constexpr RequirementId SRS_HAL_033{"SRS_HAL_033"};
inline constexpr RequirementId SRS_HAL_034{"SRS_HAL_034"};
inline constexpr RequirementId SRS_HAL_035{"SRS_HAL_035"};
inline constexpr RequirementId SRS_HAL_036{"SRS_HAL_036"};
inline constexpr RequirementId SRS_HAL_037{"SRS_HAL_037"};
inline constexpr RequirementId SRS_HAL_300{"SRS_HAL_300"};
inline constexpr RequirementId SRS_HAL_301{"SRS_HAL_301"};
inline constexpr RequirementId SRS_HAL_302{"SRS_HAL_302"};
inline constexpr RequirementId SRS_HAL_303{"SRS_HAL_303"};
inline constexpr RequirementId SRS_HAL_340{"SRS_HAL_340"};
inline constexpr RequirementId SRS_HAL_341{"SRS_HAL_341"};
inline constexpr RequirementId SRS_HAL_560{"SRS_HAL_560"};
} // namespace counterpoint::req

#endif
