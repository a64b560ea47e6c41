// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/kernel.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_KERNEL_HPP
#define VERIFICATION_TRACE_IDS_KERNEL_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_CFG_040{"SRS_CFG_040"};
inline constexpr RequirementId SRS_CFG_041{"SRS_CFG_041"};
inline constexpr RequirementId SRS_CFG_042{"SRS_CFG_042"};
inline constexpr RequirementId SRS_CFG_043{"SRS_CFG_043"};
inline constexpr RequirementId SRS_CFG_044{"SRS_CFG_044"};
inline constexpr RequirementId SRS_CFG_045{"SRS_CFG_045"};
inline constexpr RequirementId SRS_CFG_046{"SRS_CFG_046"};
inline constexpr RequirementId SRS_CFG_047{"SRS_CFG_047"};
inline constexpr RequirementId SRS_CFG_048{"SRS_CFG_048"};
inline constexpr RequirementId SRS_CFG_049{"SRS_CFG_049"};
inline constexpr RequirementId SRS_CFG_050{"SRS_CFG_050"};
inline constexpr RequirementId SRS_CFG_051{"SRS_CFG_051"};
inline constexpr RequirementId SRS_CFG_052{"SRS_CFG_052"};
inline constexpr RequirementId SRS_CFG_053{"SRS_CFG_053"};
inline constexpr RequirementId SRS_CFG_150{"SRS_CFG_150"};
inline constexpr RequirementId SRS_CFG_151{"SRS_CFG_151"};
inline constexpr RequirementId SRS_CLK_001{"SRS_CLK_001"};
inline constexpr RequirementId SRS_CLK_002{"SRS_CLK_002"};
inline constexpr RequirementId SRS_CMP_001{"SRS_CMP_001"};
inline constexpr RequirementId SRS_CMP_002{"SRS_CMP_002"};
inline constexpr RequirementId SRS_CMP_003{"SRS_CMP_003"};
inline constexpr RequirementId SRS_CMP_004{"SRS_CMP_004"};
inline constexpr RequirementId SRS_CMP_005{"SRS_CMP_005"};
inline constexpr RequirementId SRS_CMP_006{"SRS_CMP_006"};
inline constexpr RequirementId SRS_CMP_007{"SRS_CMP_007"};
inline constexpr RequirementId SRS_CMP_008{"SRS_CMP_008"};
inline constexpr RequirementId SRS_CMP_009{"SRS_CMP_009"};
inline constexpr RequirementId SRS_CMP_010{"SRS_CMP_010"};
inline constexpr RequirementId SRS_CMP_011{"SRS_CMP_011"};
inline constexpr RequirementId SRS_CMP_012{"SRS_CMP_012"};
inline constexpr RequirementId SRS_CMP_150{"SRS_CMP_150"};
inline constexpr RequirementId SRS_CMP_250{"SRS_CMP_250"};
inline constexpr RequirementId SRS_CMP_251{"SRS_CMP_251"};
inline constexpr RequirementId SRS_FLOW_001{"SRS_FLOW_001"};
inline constexpr RequirementId SRS_FLOW_002{"SRS_FLOW_002"};
inline constexpr RequirementId SRS_FLOW_003{"SRS_FLOW_003"};
inline constexpr RequirementId SRS_FLOW_004{"SRS_FLOW_004"};
inline constexpr RequirementId SRS_KRN_001{"SRS_KRN_001"};
inline constexpr RequirementId SRS_KRN_002{"SRS_KRN_002"};
inline constexpr RequirementId SRS_KRN_003{"SRS_KRN_003"};
inline constexpr RequirementId SRS_KRN_004{"SRS_KRN_004"};
inline constexpr RequirementId SRS_KRN_005{"SRS_KRN_005"};
inline constexpr RequirementId SRS_KRN_006{"SRS_KRN_006"};
inline constexpr RequirementId SRS_KRN_007{"SRS_KRN_007"};
inline constexpr RequirementId SRS_KRN_008{"SRS_KRN_008"};
inline constexpr RequirementId SRS_KRN_009{"SRS_KRN_009"};
inline constexpr RequirementId SRS_KRN_010{"SRS_KRN_010"};
inline constexpr RequirementId SRS_KRN_011{"SRS_KRN_011"};
inline constexpr RequirementId SRS_KRN_012{"SRS_KRN_012"};
inline constexpr RequirementId SRS_KRN_013{"SRS_KRN_013"};
inline constexpr RequirementId SRS_KRN_014{"SRS_KRN_014"};
inline constexpr RequirementId SRS_KRN_015{"SRS_KRN_015"};
inline constexpr RequirementId SRS_KRN_016{"SRS_KRN_016"};
inline constexpr RequirementId SRS_KRN_017{"SRS_KRN_017"};
inline constexpr RequirementId SRS_KRN_018{"SRS_KRN_018"};
inline constexpr RequirementId SRS_KRN_019{"SRS_KRN_019"};
inline constexpr RequirementId SRS_KRN_020{"SRS_KRN_020"};
inline constexpr RequirementId SRS_KRN_021{"SRS_KRN_021"};
inline constexpr RequirementId SRS_KRN_022{"SRS_KRN_022"};
inline constexpr RequirementId SRS_KRN_023{"SRS_KRN_023"};
inline constexpr RequirementId SRS_KRN_024{"SRS_KRN_024"};
inline constexpr RequirementId SRS_KRN_025{"SRS_KRN_025"};
inline constexpr RequirementId SRS_KRN_026{"SRS_KRN_026"};
inline constexpr RequirementId SRS_KRN_027{"SRS_KRN_027"};
inline constexpr RequirementId SRS_KRN_028{"SRS_KRN_028"};
inline constexpr RequirementId SRS_KRN_029{"SRS_KRN_029"};
inline constexpr RequirementId SRS_KRN_030{"SRS_KRN_030"};
inline constexpr RequirementId SRS_KRN_031{"SRS_KRN_031"};
inline constexpr RequirementId SRS_KRN_032{"SRS_KRN_032"};
inline constexpr RequirementId SRS_KRN_033{"SRS_KRN_033"};
inline constexpr RequirementId SRS_KRN_034{"SRS_KRN_034"};
inline constexpr RequirementId SRS_KRN_035{"SRS_KRN_035"};
inline constexpr RequirementId SRS_KRN_036{"SRS_KRN_036"};
inline constexpr RequirementId SRS_KRN_037{"SRS_KRN_037"};
inline constexpr RequirementId SRS_KRN_038{"SRS_KRN_038"};
inline constexpr RequirementId SRS_KRN_039{"SRS_KRN_039"};
inline constexpr RequirementId SRS_KRN_040{"SRS_KRN_040"};
inline constexpr RequirementId SRS_KRN_041{"SRS_KRN_041"};
inline constexpr RequirementId SRS_KRN_042{"SRS_KRN_042"};
inline constexpr RequirementId SRS_KRN_043{"SRS_KRN_043"};
inline constexpr RequirementId SRS_KRN_044{"SRS_KRN_044"};
inline constexpr RequirementId SRS_KRN_145{"SRS_KRN_145"};
inline constexpr RequirementId SRS_KRN_150{"SRS_KRN_150"};
inline constexpr RequirementId SRS_KRN_151{"SRS_KRN_151"};
inline constexpr RequirementId SRS_KRN_152{"SRS_KRN_152"};
inline constexpr RequirementId SRS_KRN_250{"SRS_KRN_250"};
inline constexpr RequirementId SRS_LIM_001{"SRS_LIM_001"};
inline constexpr RequirementId SRS_LIM_002{"SRS_LIM_002"};
inline constexpr RequirementId SRS_REL_012{"SRS_REL_012"};
} // namespace counterpoint::req

#endif
