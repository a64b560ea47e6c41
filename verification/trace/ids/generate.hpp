// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/generate.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_GENERATE_HPP
#define VERIFICATION_TRACE_IDS_GENERATE_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_GEN_001{"SRS_GEN_001"};
inline constexpr RequirementId SRS_GEN_002{"SRS_GEN_002"};
inline constexpr RequirementId SRS_GEN_003{"SRS_GEN_003"};
inline constexpr RequirementId SRS_GEN_004{"SRS_GEN_004"};
inline constexpr RequirementId SRS_GEN_005{"SRS_GEN_005"};
inline constexpr RequirementId SRS_GEN_006{"SRS_GEN_006"};
inline constexpr RequirementId SRS_GEN_007{"SRS_GEN_007"};
inline constexpr RequirementId SRS_GEN_008{"SRS_GEN_008"};
inline constexpr RequirementId SRS_GEN_009{"SRS_GEN_009"};
inline constexpr RequirementId SRS_GEN_010{"SRS_GEN_010"};
inline constexpr RequirementId SRS_GEN_011{"SRS_GEN_011"};
inline constexpr RequirementId SRS_GEN_012{"SRS_GEN_012"};
inline constexpr RequirementId SRS_GEN_013{"SRS_GEN_013"};
inline constexpr RequirementId SRS_GEN_014{"SRS_GEN_014"};
inline constexpr RequirementId SRS_GEN_015{"SRS_GEN_015"};
inline constexpr RequirementId SRS_GEN_016{"SRS_GEN_016"};
inline constexpr RequirementId SRS_GEN_017{"SRS_GEN_017"};
inline constexpr RequirementId SRS_GEN_018{"SRS_GEN_018"};
inline constexpr RequirementId SRS_GEN_019{"SRS_GEN_019"};
inline constexpr RequirementId SRS_GEN_020{"SRS_GEN_020"};
inline constexpr RequirementId SRS_GEN_027{"SRS_GEN_027"};
inline constexpr RequirementId SRS_GEN_150{"SRS_GEN_150"};
inline constexpr RequirementId SRS_GEN_170{"SRS_GEN_170"};
inline constexpr RequirementId SRS_GEN_330{"SRS_GEN_330"};
inline constexpr RequirementId SRS_GEN_331{"SRS_GEN_331"};
inline constexpr RequirementId SRS_GEN_340{"SRS_GEN_340"};
inline constexpr RequirementId SRS_GEN_341{"SRS_GEN_341"};
inline constexpr RequirementId SRS_GEN_342{"SRS_GEN_342"};
inline constexpr RequirementId SRS_GEN_343{"SRS_GEN_343"};
inline constexpr RequirementId SRS_GEN_350{"SRS_GEN_350"};
inline constexpr RequirementId SRS_GEN_351{"SRS_GEN_351"};
inline constexpr RequirementId SRS_GEN_352{"SRS_GEN_352"};
inline constexpr RequirementId SRS_GEN_353{"SRS_GEN_353"};
inline constexpr RequirementId SRS_GEN_354{"SRS_GEN_354"};
inline constexpr RequirementId SRS_GEN_490{"SRS_GEN_490"};
inline constexpr RequirementId SRS_GEN_660{"SRS_GEN_660"};
inline constexpr RequirementId SRS_GEN_730{"SRS_GEN_730"};
} // namespace counterpoint::req

#endif
