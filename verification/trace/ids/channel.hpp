// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/channel.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_CHANNEL_HPP
#define VERIFICATION_TRACE_IDS_CHANNEL_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_CFG_002{"SRS_CFG_002"};
inline constexpr RequirementId SRS_CFG_003{"SRS_CFG_003"};
inline constexpr RequirementId SRS_CFG_010{"SRS_CFG_010"};
inline constexpr RequirementId SRS_CFG_020{"SRS_CFG_020"};
inline constexpr RequirementId SRS_CFG_021{"SRS_CFG_021"};
inline constexpr RequirementId SRS_CFG_022{"SRS_CFG_022"};
inline constexpr RequirementId SRS_CFG_023{"SRS_CFG_023"};
inline constexpr RequirementId SRS_CFG_024{"SRS_CFG_024"};
inline constexpr RequirementId SRS_CFG_025{"SRS_CFG_025"};
inline constexpr RequirementId SRS_CFG_026{"SRS_CFG_026"};
inline constexpr RequirementId SRS_CFG_027{"SRS_CFG_027"};
inline constexpr RequirementId SRS_CFG_028{"SRS_CFG_028"};
inline constexpr RequirementId SRS_CFG_029{"SRS_CFG_029"};
inline constexpr RequirementId SRS_CFG_030{"SRS_CFG_030"};
inline constexpr RequirementId SRS_CFG_031{"SRS_CFG_031"};
inline constexpr RequirementId SRS_CFG_032{"SRS_CFG_032"};
inline constexpr RequirementId SRS_CFG_033{"SRS_CFG_033"};
inline constexpr RequirementId SRS_CFG_034{"SRS_CFG_034"};
inline constexpr RequirementId SRS_CFG_036{"SRS_CFG_036"};
inline constexpr RequirementId SRS_CFG_037{"SRS_CFG_037"};
inline constexpr RequirementId SRS_CFG_348{"SRS_CFG_348"};
inline constexpr RequirementId SRS_CONS_001{"SRS_CONS_001"};
inline constexpr RequirementId SRS_CONS_002{"SRS_CONS_002"};
inline constexpr RequirementId SRS_CONS_003{"SRS_CONS_003"};
inline constexpr RequirementId SRS_CONS_004{"SRS_CONS_004"};
inline constexpr RequirementId SRS_CONS_005{"SRS_CONS_005"};
inline constexpr RequirementId SRS_CONS_006{"SRS_CONS_006"};
inline constexpr RequirementId SRS_CONS_007{"SRS_CONS_007"};
inline constexpr RequirementId SRS_CONS_008{"SRS_CONS_008"};
inline constexpr RequirementId SRS_CONS_009{"SRS_CONS_009"};
inline constexpr RequirementId SRS_CONS_010{"SRS_CONS_010"};
inline constexpr RequirementId SRS_CONS_011{"SRS_CONS_011"};
inline constexpr RequirementId SRS_CONS_012{"SRS_CONS_012"};
inline constexpr RequirementId SRS_CONS_013{"SRS_CONS_013"};
inline constexpr RequirementId SRS_CONS_014{"SRS_CONS_014"};
inline constexpr RequirementId SRS_CONS_015{"SRS_CONS_015"};
inline constexpr RequirementId SRS_CONS_016{"SRS_CONS_016"};
inline constexpr RequirementId SRS_CONS_017{"SRS_CONS_017"};
inline constexpr RequirementId SRS_CONS_018{"SRS_CONS_018"};
inline constexpr RequirementId SRS_CONS_019{"SRS_CONS_019"};
inline constexpr RequirementId SRS_CONS_020{"SRS_CONS_020"};
inline constexpr RequirementId SRS_CONS_021{"SRS_CONS_021"};
inline constexpr RequirementId SRS_CONS_022{"SRS_CONS_022"};
inline constexpr RequirementId SRS_CONS_023{"SRS_CONS_023"};
inline constexpr RequirementId SRS_CONS_024{"SRS_CONS_024"};
inline constexpr RequirementId SRS_CONS_025{"SRS_CONS_025"};
inline constexpr RequirementId SRS_PROD_001{"SRS_PROD_001"};
inline constexpr RequirementId SRS_PROD_002{"SRS_PROD_002"};
inline constexpr RequirementId SRS_PROD_003{"SRS_PROD_003"};
inline constexpr RequirementId SRS_PROD_004{"SRS_PROD_004"};
inline constexpr RequirementId SRS_PROD_005{"SRS_PROD_005"};
inline constexpr RequirementId SRS_PROD_006{"SRS_PROD_006"};
inline constexpr RequirementId SRS_PROD_007{"SRS_PROD_007"};
inline constexpr RequirementId SRS_PROD_008{"SRS_PROD_008"};
inline constexpr RequirementId SRS_PROD_009{"SRS_PROD_009"};
inline constexpr RequirementId SRS_PROD_010{"SRS_PROD_010"};
inline constexpr RequirementId SRS_PROD_011{"SRS_PROD_011"};
inline constexpr RequirementId SRS_PROD_012{"SRS_PROD_012"};
inline constexpr RequirementId SRS_PROD_013{"SRS_PROD_013"};
inline constexpr RequirementId SRS_REL_001{"SRS_REL_001"};
inline constexpr RequirementId SRS_REL_002{"SRS_REL_002"};
inline constexpr RequirementId SRS_REL_003{"SRS_REL_003"};
inline constexpr RequirementId SRS_REL_004{"SRS_REL_004"};
inline constexpr RequirementId SRS_REL_005{"SRS_REL_005"};
inline constexpr RequirementId SRS_REL_006{"SRS_REL_006"};
inline constexpr RequirementId SRS_REL_007{"SRS_REL_007"};
inline constexpr RequirementId SRS_REL_008{"SRS_REL_008"};
inline constexpr RequirementId SRS_REL_010{"SRS_REL_010"};
inline constexpr RequirementId SRS_REL_011{"SRS_REL_011"};
inline constexpr RequirementId SRS_REL_340{"SRS_REL_340"};
inline constexpr RequirementId SRS_REL_341{"SRS_REL_341"};
inline constexpr RequirementId SRS_TIME_001{"SRS_TIME_001"};
inline constexpr RequirementId SRS_TIME_002{"SRS_TIME_002"};
inline constexpr RequirementId SRS_TIME_003{"SRS_TIME_003"};
inline constexpr RequirementId SRS_TIME_004{"SRS_TIME_004"};
inline constexpr RequirementId SRS_TIME_005{"SRS_TIME_005"};
inline constexpr RequirementId SRS_TIME_006{"SRS_TIME_006"};
inline constexpr RequirementId SRS_TIME_007{"SRS_TIME_007"};
inline constexpr RequirementId SRS_TIME_008{"SRS_TIME_008"};
inline constexpr RequirementId SRS_TIME_009{"SRS_TIME_009"};
inline constexpr RequirementId SRS_TIME_340{"SRS_TIME_340"};
inline constexpr RequirementId SRS_TIME_341{"SRS_TIME_341"};
} // namespace counterpoint::req

#endif
