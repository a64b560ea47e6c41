// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/eds.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_EDS_HPP
#define VERIFICATION_TRACE_IDS_EDS_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_CLI_001{"SRS_CLI_001"};
inline constexpr RequirementId SRS_CLI_002{"SRS_CLI_002"};
inline constexpr RequirementId SRS_CLI_003{"SRS_CLI_003"};
inline constexpr RequirementId SRS_CLI_004{"SRS_CLI_004"};
inline constexpr RequirementId SRS_CLI_005{"SRS_CLI_005"};
inline constexpr RequirementId SRS_CLI_006{"SRS_CLI_006"};
inline constexpr RequirementId SRS_CLI_007{"SRS_CLI_007"};
inline constexpr RequirementId SRS_CLI_008{"SRS_CLI_008"};
inline constexpr RequirementId SRS_CLI_009{"SRS_CLI_009"};
inline constexpr RequirementId SRS_CLI_010{"SRS_CLI_010"};
inline constexpr RequirementId SRS_CLI_011{"SRS_CLI_011"};
inline constexpr RequirementId SRS_CLI_012{"SRS_CLI_012"};
inline constexpr RequirementId SRS_CLI_013{"SRS_CLI_013"};
inline constexpr RequirementId SRS_CLI_014{"SRS_CLI_014"};
inline constexpr RequirementId SRS_CLI_015{"SRS_CLI_015"};
inline constexpr RequirementId SRS_CLI_016{"SRS_CLI_016"};
inline constexpr RequirementId SRS_CLI_017{"SRS_CLI_017"};
inline constexpr RequirementId SRS_CLI_018{"SRS_CLI_018"};
inline constexpr RequirementId SRS_CLI_019{"SRS_CLI_019"};
inline constexpr RequirementId SRS_CLI_020{"SRS_CLI_020"};
inline constexpr RequirementId SRS_CLI_021{"SRS_CLI_021"};
inline constexpr RequirementId SRS_CLI_022{"SRS_CLI_022"};
inline constexpr RequirementId SRS_CLI_023{"SRS_CLI_023"};
inline constexpr RequirementId SRS_CLI_024{"SRS_CLI_024"};
inline constexpr RequirementId SRS_CLI_030{"SRS_CLI_030"};
inline constexpr RequirementId SRS_CLI_031{"SRS_CLI_031"};
inline constexpr RequirementId SRS_CLI_032{"SRS_CLI_032"};
inline constexpr RequirementId SRS_CLI_033{"SRS_CLI_033"};
inline constexpr RequirementId SRS_CLI_034{"SRS_CLI_034"};
inline constexpr RequirementId SRS_CLI_035{"SRS_CLI_035"};
inline constexpr RequirementId SRS_CLI_036{"SRS_CLI_036"};
inline constexpr RequirementId SRS_CLI_037{"SRS_CLI_037"};
inline constexpr RequirementId SRS_CLI_038{"SRS_CLI_038"};
inline constexpr RequirementId SRS_CLI_039{"SRS_CLI_039"};
inline constexpr RequirementId SRS_CLI_040{"SRS_CLI_040"};
inline constexpr RequirementId SRS_CLI_120{"SRS_CLI_120"};
inline constexpr RequirementId SRS_CLI_170{"SRS_CLI_170"};
inline constexpr RequirementId SRS_CLI_210{"SRS_CLI_210"};
inline constexpr RequirementId SRS_CLI_211{"SRS_CLI_211"};
inline constexpr RequirementId SRS_CLI_212{"SRS_CLI_212"};
inline constexpr RequirementId SRS_CLI_240{"SRS_CLI_240"};
inline constexpr RequirementId SRS_CLI_330{"SRS_CLI_330"};
inline constexpr RequirementId SRS_CLI_350{"SRS_CLI_350"};
inline constexpr RequirementId SRS_CLI_400{"SRS_CLI_400"};
inline constexpr RequirementId SRS_CLI_490{"SRS_CLI_490"};
inline constexpr RequirementId SRS_CLI_491{"SRS_CLI_491"};
inline constexpr RequirementId SRS_CLI_492{"SRS_CLI_492"};
inline constexpr RequirementId SRS_CLI_550{"SRS_CLI_550"};
inline constexpr RequirementId SRS_CLI_650{"SRS_CLI_650"};
inline constexpr RequirementId SRS_CLI_710{"SRS_CLI_710"};
inline constexpr RequirementId SRS_CLI_730{"SRS_CLI_730"};
inline constexpr RequirementId SRS_CLI_731{"SRS_CLI_731"};
inline constexpr RequirementId SRS_CLI_732{"SRS_CLI_732"};
inline constexpr RequirementId SRS_EDS_001{"SRS_EDS_001"};
inline constexpr RequirementId SRS_EDS_002{"SRS_EDS_002"};
inline constexpr RequirementId SRS_EDS_003{"SRS_EDS_003"};
inline constexpr RequirementId SRS_EDS_004{"SRS_EDS_004"};
inline constexpr RequirementId SRS_EDS_005{"SRS_EDS_005"};
inline constexpr RequirementId SRS_EDS_006{"SRS_EDS_006"};
inline constexpr RequirementId SRS_EDS_007{"SRS_EDS_007"};
inline constexpr RequirementId SRS_EDS_008{"SRS_EDS_008"};
inline constexpr RequirementId SRS_EDS_009{"SRS_EDS_009"};
inline constexpr RequirementId SRS_EDS_010{"SRS_EDS_010"};
inline constexpr RequirementId SRS_EDS_011{"SRS_EDS_011"};
inline constexpr RequirementId SRS_EDS_012{"SRS_EDS_012"};
inline constexpr RequirementId SRS_EDS_013{"SRS_EDS_013"};
inline constexpr RequirementId SRS_EDS_014{"SRS_EDS_014"};
inline constexpr RequirementId SRS_EDS_015{"SRS_EDS_015"};
inline constexpr RequirementId SRS_EDS_016{"SRS_EDS_016"};
inline constexpr RequirementId SRS_EDS_017{"SRS_EDS_017"};
inline constexpr RequirementId SRS_EDS_018{"SRS_EDS_018"};
inline constexpr RequirementId SRS_EDS_019{"SRS_EDS_019"};
inline constexpr RequirementId SRS_EDS_020{"SRS_EDS_020"};
inline constexpr RequirementId SRS_EDS_021{"SRS_EDS_021"};
inline constexpr RequirementId SRS_EDS_022{"SRS_EDS_022"};
inline constexpr RequirementId SRS_EDS_023{"SRS_EDS_023"};
inline constexpr RequirementId SRS_EDS_024{"SRS_EDS_024"};
inline constexpr RequirementId SRS_EDS_025{"SRS_EDS_025"};
inline constexpr RequirementId SRS_EDS_026{"SRS_EDS_026"};
inline constexpr RequirementId SRS_EDS_027{"SRS_EDS_027"};
inline constexpr RequirementId SRS_EDS_028{"SRS_EDS_028"};
inline constexpr RequirementId SRS_EDS_029{"SRS_EDS_029"};
inline constexpr RequirementId SRS_EDS_030{"SRS_EDS_030"};
inline constexpr RequirementId SRS_EDS_031{"SRS_EDS_031"};
inline constexpr RequirementId SRS_EDS_032{"SRS_EDS_032"};
inline constexpr RequirementId SRS_EDS_033{"SRS_EDS_033"};
inline constexpr RequirementId SRS_EDS_034{"SRS_EDS_034"};
inline constexpr RequirementId SRS_EDS_035{"SRS_EDS_035"};
inline constexpr RequirementId SRS_EDS_036{"SRS_EDS_036"};
inline constexpr RequirementId SRS_EDS_037{"SRS_EDS_037"};
inline constexpr RequirementId SRS_EDS_038{"SRS_EDS_038"};
inline constexpr RequirementId SRS_EDS_039{"SRS_EDS_039"};
inline constexpr RequirementId SRS_EDS_045{"SRS_EDS_045"};
inline constexpr RequirementId SRS_EDS_150{"SRS_EDS_150"};
inline constexpr RequirementId SRS_EDS_340{"SRS_EDS_340"};
inline constexpr RequirementId SRS_EDS_555{"SRS_EDS_555"};
inline constexpr RequirementId SRS_EDS_660{"SRS_EDS_660"};
inline constexpr RequirementId SRS_EDS_670{"SRS_EDS_670"};
inline constexpr RequirementId SRS_EDS_730{"SRS_EDS_730"};
} // namespace counterpoint::req

#endif
