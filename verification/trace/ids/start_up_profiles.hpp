// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/start_up_profiles.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_START_UP_PROFILES_HPP
#define VERIFICATION_TRACE_IDS_START_UP_PROFILES_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_ELM_001{"SRS_ELM_001"};
inline constexpr RequirementId SRS_ELM_002{"SRS_ELM_002"};
inline constexpr RequirementId SRS_ELM_003{"SRS_ELM_003"};
inline constexpr RequirementId SRS_ELM_004{"SRS_ELM_004"};
inline constexpr RequirementId SRS_ELM_005{"SRS_ELM_005"};
inline constexpr RequirementId SRS_ELM_006{"SRS_ELM_006"};
inline constexpr RequirementId SRS_ELM_007{"SRS_ELM_007"};
inline constexpr RequirementId SRS_ELM_008{"SRS_ELM_008"};
inline constexpr RequirementId SRS_ELM_010{"SRS_ELM_010"};
inline constexpr RequirementId SRS_ELM_011{"SRS_ELM_011"};
inline constexpr RequirementId SRS_ELM_012{"SRS_ELM_012"};
inline constexpr RequirementId SRS_ELM_013{"SRS_ELM_013"};
inline constexpr RequirementId SRS_ELM_014{"SRS_ELM_014"};
inline constexpr RequirementId SRS_ELM_015{"SRS_ELM_015"};
inline constexpr RequirementId SRS_ELM_016{"SRS_ELM_016"};
inline constexpr RequirementId SRS_ELM_017{"SRS_ELM_017"};
inline constexpr RequirementId SRS_ELM_018{"SRS_ELM_018"};
inline constexpr RequirementId SRS_ELM_019{"SRS_ELM_019"};
inline constexpr RequirementId SRS_ELM_020{"SRS_ELM_020"};
inline constexpr RequirementId SRS_ELM_021{"SRS_ELM_021"};
inline constexpr RequirementId SRS_ELM_022{"SRS_ELM_022"};
inline constexpr RequirementId SRS_ELM_023{"SRS_ELM_023"};
inline constexpr RequirementId SRS_ELM_024{"SRS_ELM_024"};
inline constexpr RequirementId SRS_ELM_025{"SRS_ELM_025"};
inline constexpr RequirementId SRS_ELM_026{"SRS_ELM_026"};
inline constexpr RequirementId SRS_ELM_027{"SRS_ELM_027"};
inline constexpr RequirementId SRS_ELM_028{"SRS_ELM_028"};
inline constexpr RequirementId SRS_ELM_029{"SRS_ELM_029"};
inline constexpr RequirementId SRS_ELM_030{"SRS_ELM_030"};
inline constexpr RequirementId SRS_ELM_031{"SRS_ELM_031"};
inline constexpr RequirementId SRS_ELM_032{"SRS_ELM_032"};
inline constexpr RequirementId SRS_ELM_033{"SRS_ELM_033"};
inline constexpr RequirementId SRS_ELM_034{"SRS_ELM_034"};
inline constexpr RequirementId SRS_ELM_035{"SRS_ELM_035"};
inline constexpr RequirementId SRS_ELM_036{"SRS_ELM_036"};
inline constexpr RequirementId SRS_ELM_037{"SRS_ELM_037"};
inline constexpr RequirementId SRS_ELM_038{"SRS_ELM_038"};
inline constexpr RequirementId SRS_ELM_039{"SRS_ELM_039"};
inline constexpr RequirementId SRS_ELM_040{"SRS_ELM_040"};
inline constexpr RequirementId SRS_ELM_041{"SRS_ELM_041"};
inline constexpr RequirementId SRS_ELM_042{"SRS_ELM_042"};
inline constexpr RequirementId SRS_ELM_043{"SRS_ELM_043"};
inline constexpr RequirementId SRS_ELM_044{"SRS_ELM_044"};
inline constexpr RequirementId SRS_ELM_045{"SRS_ELM_045"};
inline constexpr RequirementId SRS_ELM_046{"SRS_ELM_046"};
inline constexpr RequirementId SRS_ELM_047{"SRS_ELM_047"};
inline constexpr RequirementId SRS_ELM_048{"SRS_ELM_048"};
inline constexpr RequirementId SRS_ELM_049{"SRS_ELM_049"};
inline constexpr RequirementId SRS_ELM_050{"SRS_ELM_050"};
inline constexpr RequirementId SRS_ELM_051{"SRS_ELM_051"};
inline constexpr RequirementId SRS_ELM_052{"SRS_ELM_052"};
inline constexpr RequirementId SRS_ELM_060{"SRS_ELM_060"};
inline constexpr RequirementId SRS_ELM_150{"SRS_ELM_150"};
inline constexpr RequirementId SRS_ELM_151{"SRS_ELM_151"};
inline constexpr RequirementId SRS_ELM_210{"SRS_ELM_210"};
inline constexpr RequirementId SRS_ELM_211{"SRS_ELM_211"};
inline constexpr RequirementId SRS_ELM_212{"SRS_ELM_212"};
inline constexpr RequirementId SRS_ELM_213{"SRS_ELM_213"};
inline constexpr RequirementId SRS_ELM_214{"SRS_ELM_214"};
inline constexpr RequirementId SRS_ELM_215{"SRS_ELM_215"};
inline constexpr RequirementId SRS_ELM_230{"SRS_ELM_230"};
inline constexpr RequirementId SRS_ELM_480{"SRS_ELM_480"};
inline constexpr RequirementId SRS_ELM_520{"SRS_ELM_520"};
inline constexpr RequirementId SRS_ELM_585{"SRS_ELM_585"};
inline constexpr RequirementId SRS_ELM_586{"SRS_ELM_586"};
inline constexpr RequirementId SRS_ELM_670{"SRS_ELM_670"};
inline constexpr RequirementId SRS_ELM_770{"SRS_ELM_770"};
inline constexpr RequirementId SRS_ELM_771{"SRS_ELM_771"};
inline constexpr RequirementId SRS_ELM_800{"SRS_ELM_800"};
inline constexpr RequirementId SRS_ELM_820{"SRS_ELM_820"};
inline constexpr RequirementId SRS_PLC_001{"SRS_PLC_001"};
inline constexpr RequirementId SRS_PLC_002{"SRS_PLC_002"};
inline constexpr RequirementId SRS_PLC_003{"SRS_PLC_003"};
inline constexpr RequirementId SRS_PLC_004{"SRS_PLC_004"};
inline constexpr RequirementId SRS_PLC_005{"SRS_PLC_005"};
inline constexpr RequirementId SRS_PLC_006{"SRS_PLC_006"};
inline constexpr RequirementId SRS_PLC_007{"SRS_PLC_007"};
inline constexpr RequirementId SRS_PLC_008{"SRS_PLC_008"};
inline constexpr RequirementId SRS_PLC_009{"SRS_PLC_009"};
inline constexpr RequirementId SRS_PLC_010{"SRS_PLC_010"};
inline constexpr RequirementId SRS_PLC_011{"SRS_PLC_011"};
inline constexpr RequirementId SRS_PLC_012{"SRS_PLC_012"};
inline constexpr RequirementId SRS_PLC_013{"SRS_PLC_013"};
inline constexpr RequirementId SRS_PLC_014{"SRS_PLC_014"};
inline constexpr RequirementId SRS_PLC_015{"SRS_PLC_015"};
inline constexpr RequirementId SRS_PLC_016{"SRS_PLC_016"};
inline constexpr RequirementId SRS_PLC_017{"SRS_PLC_017"};
inline constexpr RequirementId SRS_PLC_018{"SRS_PLC_018"};
inline constexpr RequirementId SRS_PLC_019{"SRS_PLC_019"};
inline constexpr RequirementId SRS_PLC_020{"SRS_PLC_020"};
inline constexpr RequirementId SRS_PLC_021{"SRS_PLC_021"};
inline constexpr RequirementId SRS_PLC_022{"SRS_PLC_022"};
inline constexpr RequirementId SRS_PLC_030{"SRS_PLC_030"};
inline constexpr RequirementId SRS_PLC_031{"SRS_PLC_031"};
inline constexpr RequirementId SRS_PLC_150{"SRS_PLC_150"};
inline constexpr RequirementId SRS_PLC_151{"SRS_PLC_151"};
inline constexpr RequirementId SRS_PLC_470{"SRS_PLC_470"};
inline constexpr RequirementId SRS_PLC_480{"SRS_PLC_480"};
inline constexpr RequirementId SRS_PLC_585{"SRS_PLC_585"};
inline constexpr RequirementId SRS_PLC_586{"SRS_PLC_586"};
inline constexpr RequirementId SRS_PLC_587{"SRS_PLC_587"};
inline constexpr RequirementId SRS_PLC_800{"SRS_PLC_800"};
inline constexpr RequirementId SRS_PLC_801{"SRS_PLC_801"};
inline constexpr RequirementId SRS_PLC_802{"SRS_PLC_802"};
inline constexpr RequirementId SRS_PLC_820{"SRS_PLC_820"};
inline constexpr RequirementId SRS_PLC_821{"SRS_PLC_821"};
} // namespace counterpoint::req

#endif
