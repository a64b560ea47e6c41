// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/simulator.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_SIMULATOR_HPP
#define VERIFICATION_TRACE_IDS_SIMULATOR_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_DEMO_001{"SRS_DEMO_001"};
inline constexpr RequirementId SRS_DEMO_002{"SRS_DEMO_002"};
inline constexpr RequirementId SRS_DEMO_003{"SRS_DEMO_003"};
inline constexpr RequirementId SRS_DEMO_004{"SRS_DEMO_004"};
inline constexpr RequirementId SRS_DEMO_005{"SRS_DEMO_005"};
inline constexpr RequirementId SRS_DEMO_006{"SRS_DEMO_006"};
inline constexpr RequirementId SRS_SIM_001{"SRS_SIM_001"};
inline constexpr RequirementId SRS_SIM_002{"SRS_SIM_002"};
inline constexpr RequirementId SRS_SIM_003{"SRS_SIM_003"};
inline constexpr RequirementId SRS_SIM_004{"SRS_SIM_004"};
inline constexpr RequirementId SRS_SIM_005{"SRS_SIM_005"};
inline constexpr RequirementId SRS_SIM_006{"SRS_SIM_006"};
inline constexpr RequirementId SRS_SIM_007{"SRS_SIM_007"};
inline constexpr RequirementId SRS_SIM_008{"SRS_SIM_008"};
inline constexpr RequirementId SRS_SIM_009{"SRS_SIM_009"};
inline constexpr RequirementId SRS_SIM_010{"SRS_SIM_010"};
inline constexpr RequirementId SRS_SIM_011{"SRS_SIM_011"};
inline constexpr RequirementId SRS_SIM_012{"SRS_SIM_012"};
inline constexpr RequirementId SRS_SIM_013{"SRS_SIM_013"};
inline constexpr RequirementId SRS_SIM_014{"SRS_SIM_014"};
inline constexpr RequirementId SRS_SIM_015{"SRS_SIM_015"};
inline constexpr RequirementId SRS_SIM_016{"SRS_SIM_016"};
inline constexpr RequirementId SRS_SIM_017{"SRS_SIM_017"};
inline constexpr RequirementId SRS_SIM_020{"SRS_SIM_020"};
inline constexpr RequirementId SRS_SIM_021{"SRS_SIM_021"};
inline constexpr RequirementId SRS_SIM_022{"SRS_SIM_022"};
inline constexpr RequirementId SRS_SIM_023{"SRS_SIM_023"};
inline constexpr RequirementId SRS_SIM_024{"SRS_SIM_024"};
inline constexpr RequirementId SRS_SIM_025{"SRS_SIM_025"};
inline constexpr RequirementId SRS_SIM_026{"SRS_SIM_026"};
inline constexpr RequirementId SRS_SIM_027{"SRS_SIM_027"};
inline constexpr RequirementId SRS_SIM_028{"SRS_SIM_028"};
inline constexpr RequirementId SRS_SIM_029{"SRS_SIM_029"};
inline constexpr RequirementId SRS_SIM_030{"SRS_SIM_030"};
inline constexpr RequirementId SRS_SIM_031{"SRS_SIM_031"};
inline constexpr RequirementId SRS_SIM_032{"SRS_SIM_032"};
inline constexpr RequirementId SRS_SIM_033{"SRS_SIM_033"};
inline constexpr RequirementId SRS_SIM_034{"SRS_SIM_034"};
inline constexpr RequirementId SRS_SIM_035{"SRS_SIM_035"};
inline constexpr RequirementId SRS_SIM_036{"SRS_SIM_036"};
inline constexpr RequirementId SRS_SIM_037{"SRS_SIM_037"};
inline constexpr RequirementId SRS_SIM_038{"SRS_SIM_038"};
inline constexpr RequirementId SRS_SIM_040{"SRS_SIM_040"};
inline constexpr RequirementId SRS_SIM_041{"SRS_SIM_041"};
inline constexpr RequirementId SRS_SIM_042{"SRS_SIM_042"};
inline constexpr RequirementId SRS_SIM_043{"SRS_SIM_043"};
inline constexpr RequirementId SRS_SIM_044{"SRS_SIM_044"};
inline constexpr RequirementId SRS_SIM_045{"SRS_SIM_045"};
inline constexpr RequirementId SRS_SIM_046{"SRS_SIM_046"};
inline constexpr RequirementId SRS_SIM_047{"SRS_SIM_047"};
inline constexpr RequirementId SRS_SIM_048{"SRS_SIM_048"};
inline constexpr RequirementId SRS_SIM_049{"SRS_SIM_049"};
inline constexpr RequirementId SRS_SIM_050{"SRS_SIM_050"};
inline constexpr RequirementId SRS_SIM_051{"SRS_SIM_051"};
inline constexpr RequirementId SRS_SIM_052{"SRS_SIM_052"};
inline constexpr RequirementId SRS_SIM_053{"SRS_SIM_053"};
inline constexpr RequirementId SRS_SIM_054{"SRS_SIM_054"};
inline constexpr RequirementId SRS_SIM_055{"SRS_SIM_055"};
inline constexpr RequirementId SRS_SIM_056{"SRS_SIM_056"};
inline constexpr RequirementId SRS_SIM_057{"SRS_SIM_057"};
inline constexpr RequirementId SRS_SIM_058{"SRS_SIM_058"};
inline constexpr RequirementId SRS_SIM_059{"SRS_SIM_059"};
inline constexpr RequirementId SRS_SIM_060{"SRS_SIM_060"};
inline constexpr RequirementId SRS_SIM_061{"SRS_SIM_061"};
inline constexpr RequirementId SRS_SIM_062{"SRS_SIM_062"};
inline constexpr RequirementId SRS_SIM_063{"SRS_SIM_063"};
inline constexpr RequirementId SRS_SIM_064{"SRS_SIM_064"};
inline constexpr RequirementId SRS_SIM_065{"SRS_SIM_065"};
inline constexpr RequirementId SRS_SIM_066{"SRS_SIM_066"};
inline constexpr RequirementId SRS_SIM_067{"SRS_SIM_067"};
inline constexpr RequirementId SRS_SIM_068{"SRS_SIM_068"};
inline constexpr RequirementId SRS_SIM_069{"SRS_SIM_069"};
inline constexpr RequirementId SRS_SIM_070{"SRS_SIM_070"};
inline constexpr RequirementId SRS_SIM_071{"SRS_SIM_071"};
inline constexpr RequirementId SRS_SIM_072{"SRS_SIM_072"};
inline constexpr RequirementId SRS_SIM_073{"SRS_SIM_073"};
inline constexpr RequirementId SRS_SIM_074{"SRS_SIM_074"};
inline constexpr RequirementId SRS_SIM_075{"SRS_SIM_075"};
inline constexpr RequirementId SRS_SIM_080{"SRS_SIM_080"};
inline constexpr RequirementId SRS_SIM_081{"SRS_SIM_081"};
inline constexpr RequirementId SRS_SIM_082{"SRS_SIM_082"};
inline constexpr RequirementId SRS_SIM_083{"SRS_SIM_083"};
inline constexpr RequirementId SRS_SIM_170{"SRS_SIM_170"};
inline constexpr RequirementId SRS_SIM_210{"SRS_SIM_210"};
inline constexpr RequirementId SRS_SIM_211{"SRS_SIM_211"};
inline constexpr RequirementId SRS_SIM_212{"SRS_SIM_212"};
inline constexpr RequirementId SRS_SIM_213{"SRS_SIM_213"};
inline constexpr RequirementId SRS_SIM_214{"SRS_SIM_214"};
inline constexpr RequirementId SRS_SIM_215{"SRS_SIM_215"};
inline constexpr RequirementId SRS_SIM_216{"SRS_SIM_216"};
inline constexpr RequirementId SRS_SIM_217{"SRS_SIM_217"};
inline constexpr RequirementId SRS_SIM_340{"SRS_SIM_340"};
inline constexpr RequirementId SRS_SIM_350{"SRS_SIM_350"};
inline constexpr RequirementId SRS_SIM_400{"SRS_SIM_400"};
inline constexpr RequirementId SRS_SIM_480{"SRS_SIM_480"};
inline constexpr RequirementId SRS_SIM_490{"SRS_SIM_490"};
inline constexpr RequirementId SRS_SIM_491{"SRS_SIM_491"};
inline constexpr RequirementId SRS_SIM_585{"SRS_SIM_585"};
inline constexpr RequirementId SRS_SIM_586{"SRS_SIM_586"};
inline constexpr RequirementId SRS_SIM_660{"SRS_SIM_660"};
inline constexpr RequirementId SRS_SIM_661{"SRS_SIM_661"};
inline constexpr RequirementId SRS_SIM_710{"SRS_SIM_710"};
inline constexpr RequirementId SRS_SIM_711{"SRS_SIM_711"};
} // namespace counterpoint::req

#endif
