// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/tms570.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_TMS570_HPP
#define VERIFICATION_TRACE_IDS_TMS570_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_TMS_001{"SRS_TMS_001"};
inline constexpr RequirementId SRS_TMS_002{"SRS_TMS_002"};
inline constexpr RequirementId SRS_TMS_003{"SRS_TMS_003"};
inline constexpr RequirementId SRS_TMS_004{"SRS_TMS_004"};
inline constexpr RequirementId SRS_TMS_010{"SRS_TMS_010"};
inline constexpr RequirementId SRS_TMS_011{"SRS_TMS_011"};
inline constexpr RequirementId SRS_TMS_012{"SRS_TMS_012"};
inline constexpr RequirementId SRS_TMS_013{"SRS_TMS_013"};
inline constexpr RequirementId SRS_TMS_014{"SRS_TMS_014"};
inline constexpr RequirementId SRS_TMS_015{"SRS_TMS_015"};
inline constexpr RequirementId SRS_TMS_016{"SRS_TMS_016"};
inline constexpr RequirementId SRS_TMS_017{"SRS_TMS_017"};
inline constexpr RequirementId SRS_TMS_018{"SRS_TMS_018"};
inline constexpr RequirementId SRS_TMS_019{"SRS_TMS_019"};
inline constexpr RequirementId SRS_TMS_020{"SRS_TMS_020"};
inline constexpr RequirementId SRS_TMS_021{"SRS_TMS_021"};
inline constexpr RequirementId SRS_TMS_022{"SRS_TMS_022"};
inline constexpr RequirementId SRS_TMS_023{"SRS_TMS_023"};
inline constexpr RequirementId SRS_TMS_024{"SRS_TMS_024"};
inline constexpr RequirementId SRS_TMS_025{"SRS_TMS_025"};
inline constexpr RequirementId SRS_TMS_026{"SRS_TMS_026"};
inline constexpr RequirementId SRS_TMS_027{"SRS_TMS_027"};
inline constexpr RequirementId SRS_TMS_028{"SRS_TMS_028"};
inline constexpr RequirementId SRS_TMS_030{"SRS_TMS_030"};
inline constexpr RequirementId SRS_TMS_031{"SRS_TMS_031"};
inline constexpr RequirementId SRS_TMS_032{"SRS_TMS_032"};
inline constexpr RequirementId SRS_TMS_033{"SRS_TMS_033"};
inline constexpr RequirementId SRS_TMS_040{"SRS_TMS_040"};
inline constexpr RequirementId SRS_TMS_041{"SRS_TMS_041"};
inline constexpr RequirementId SRS_TMS_042{"SRS_TMS_042"};
inline constexpr RequirementId SRS_TMS_043{"SRS_TMS_043"};
inline constexpr RequirementId SRS_TMS_044{"SRS_TMS_044"};
inline constexpr RequirementId SRS_TMS_045{"SRS_TMS_045"};
inline constexpr RequirementId SRS_TMS_046{"SRS_TMS_046"};
inline constexpr RequirementId SRS_TMS_047{"SRS_TMS_047"};
inline constexpr RequirementId SRS_TMS_048{"SRS_TMS_048"};
inline constexpr RequirementId SRS_TMS_049{"SRS_TMS_049"};
inline constexpr RequirementId SRS_TMS_050{"SRS_TMS_050"};
inline constexpr RequirementId SRS_TMS_051{"SRS_TMS_051"};
inline constexpr RequirementId SRS_TMS_052{"SRS_TMS_052"};
inline constexpr RequirementId SRS_TMS_060{"SRS_TMS_060"};
inline constexpr RequirementId SRS_TMS_061{"SRS_TMS_061"};
inline constexpr RequirementId SRS_TMS_062{"SRS_TMS_062"};
inline constexpr RequirementId SRS_TMS_070{"SRS_TMS_070"};
inline constexpr RequirementId SRS_TMS_300{"SRS_TMS_300"};
} // namespace counterpoint::req

#endif
