// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/cia301.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_CIA301_HPP
#define VERIFICATION_TRACE_IDS_CIA301_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_EMCY_001{"SRS_EMCY_001"};
inline constexpr RequirementId SRS_EMCY_002{"SRS_EMCY_002"};
inline constexpr RequirementId SRS_EMCY_003{"SRS_EMCY_003"};
inline constexpr RequirementId SRS_EMCY_004{"SRS_EMCY_004"};
inline constexpr RequirementId SRS_EMCY_005{"SRS_EMCY_005"};
inline constexpr RequirementId SRS_EMCY_006{"SRS_EMCY_006"};
inline constexpr RequirementId SRS_EMCY_007{"SRS_EMCY_007"};
inline constexpr RequirementId SRS_EMCY_008{"SRS_EMCY_008"};
inline constexpr RequirementId SRS_EMCY_009{"SRS_EMCY_009"};
inline constexpr RequirementId SRS_EMCY_010{"SRS_EMCY_010"};
inline constexpr RequirementId SRS_EMCY_150{"SRS_EMCY_150"};
inline constexpr RequirementId SRS_ERR_001{"SRS_ERR_001"};
inline constexpr RequirementId SRS_ERR_002{"SRS_ERR_002"};
inline constexpr RequirementId SRS_ERR_003{"SRS_ERR_003"};
inline constexpr RequirementId SRS_GRD_001{"SRS_GRD_001"};
inline constexpr RequirementId SRS_GRD_002{"SRS_GRD_002"};
inline constexpr RequirementId SRS_GRD_010{"SRS_GRD_010"};
inline constexpr RequirementId SRS_GRD_011{"SRS_GRD_011"};
inline constexpr RequirementId SRS_GRD_012{"SRS_GRD_012"};
inline constexpr RequirementId SRS_HB_001{"SRS_HB_001"};
inline constexpr RequirementId SRS_HB_002{"SRS_HB_002"};
inline constexpr RequirementId SRS_HB_003{"SRS_HB_003"};
inline constexpr RequirementId SRS_HB_004{"SRS_HB_004"};
inline constexpr RequirementId SRS_HB_005{"SRS_HB_005"};
inline constexpr RequirementId SRS_HB_006{"SRS_HB_006"};
inline constexpr RequirementId SRS_NMT_001{"SRS_NMT_001"};
inline constexpr RequirementId SRS_NMT_002{"SRS_NMT_002"};
inline constexpr RequirementId SRS_NMT_003{"SRS_NMT_003"};
inline constexpr RequirementId SRS_NMT_004{"SRS_NMT_004"};
inline constexpr RequirementId SRS_NMT_005{"SRS_NMT_005"};
inline constexpr RequirementId SRS_NMT_006{"SRS_NMT_006"};
inline constexpr RequirementId SRS_NMT_007{"SRS_NMT_007"};
inline constexpr RequirementId SRS_NMT_008{"SRS_NMT_008"};
inline constexpr RequirementId SRS_NMT_009{"SRS_NMT_009"};
inline constexpr RequirementId SRS_NMT_010{"SRS_NMT_010"};
inline constexpr RequirementId SRS_OBD_001{"SRS_OBD_001"};
inline constexpr RequirementId SRS_OBD_002{"SRS_OBD_002"};
inline constexpr RequirementId SRS_OBD_003{"SRS_OBD_003"};
inline constexpr RequirementId SRS_OBD_004{"SRS_OBD_004"};
inline constexpr RequirementId SRS_OBD_005{"SRS_OBD_005"};
inline constexpr RequirementId SRS_OBD_006{"SRS_OBD_006"};
inline constexpr RequirementId SRS_OBD_007{"SRS_OBD_007"};
inline constexpr RequirementId SRS_OBD_008{"SRS_OBD_008"};
inline constexpr RequirementId SRS_OBD_009{"SRS_OBD_009"};
inline constexpr RequirementId SRS_OBD_010{"SRS_OBD_010"};
inline constexpr RequirementId SRS_OBD_011{"SRS_OBD_011"};
inline constexpr RequirementId SRS_OBD_012{"SRS_OBD_012"};
inline constexpr RequirementId SRS_OBD_013{"SRS_OBD_013"};
inline constexpr RequirementId SRS_OBD_014{"SRS_OBD_014"};
inline constexpr RequirementId SRS_OBD_015{"SRS_OBD_015"};
inline constexpr RequirementId SRS_OBD_016{"SRS_OBD_016"};
inline constexpr RequirementId SRS_OBD_017{"SRS_OBD_017"};
inline constexpr RequirementId SRS_OBD_340{"SRS_OBD_340"};
inline constexpr RequirementId SRS_OBD_530{"SRS_OBD_530"};
inline constexpr RequirementId SRS_SDC_001{"SRS_SDC_001"};
inline constexpr RequirementId SRS_SDC_002{"SRS_SDC_002"};
inline constexpr RequirementId SRS_SDC_003{"SRS_SDC_003"};
inline constexpr RequirementId SRS_SDC_004{"SRS_SDC_004"};
inline constexpr RequirementId SRS_SDC_005{"SRS_SDC_005"};
inline constexpr RequirementId SRS_SDC_006{"SRS_SDC_006"};
inline constexpr RequirementId SRS_SDC_007{"SRS_SDC_007"};
inline constexpr RequirementId SRS_SDC_008{"SRS_SDC_008"};
inline constexpr RequirementId SRS_SDC_009{"SRS_SDC_009"};
inline constexpr RequirementId SRS_SDC_010{"SRS_SDC_010"};
inline constexpr RequirementId SRS_SDC_011{"SRS_SDC_011"};
inline constexpr RequirementId SRS_SDC_012{"SRS_SDC_012"};
inline constexpr RequirementId SRS_SDC_210{"SRS_SDC_210"};
inline constexpr RequirementId SRS_SDC_450{"SRS_SDC_450"};
inline constexpr RequirementId SRS_SDO_001{"SRS_SDO_001"};
inline constexpr RequirementId SRS_SDO_002{"SRS_SDO_002"};
inline constexpr RequirementId SRS_SDO_003{"SRS_SDO_003"};
inline constexpr RequirementId SRS_SDO_004{"SRS_SDO_004"};
inline constexpr RequirementId SRS_SDO_005{"SRS_SDO_005"};
inline constexpr RequirementId SRS_SDO_006{"SRS_SDO_006"};
inline constexpr RequirementId SRS_SDO_007{"SRS_SDO_007"};
inline constexpr RequirementId SRS_SDO_008{"SRS_SDO_008"};
inline constexpr RequirementId SRS_SDO_009{"SRS_SDO_009"};
inline constexpr RequirementId SRS_SDO_010{"SRS_SDO_010"};
inline constexpr RequirementId SRS_SDO_011{"SRS_SDO_011"};
inline constexpr RequirementId SRS_SDO_012{"SRS_SDO_012"};
inline constexpr RequirementId SRS_SDO_013{"SRS_SDO_013"};
inline constexpr RequirementId SRS_SDO_014{"SRS_SDO_014"};
inline constexpr RequirementId SRS_SDO_015{"SRS_SDO_015"};
inline constexpr RequirementId SRS_SDO_016{"SRS_SDO_016"};
inline constexpr RequirementId SRS_SDO_017{"SRS_SDO_017"};
inline constexpr RequirementId SRS_SDO_018{"SRS_SDO_018"};
inline constexpr RequirementId SRS_SDO_019{"SRS_SDO_019"};
inline constexpr RequirementId SRS_SDO_150{"SRS_SDO_150"};
inline constexpr RequirementId SRS_SDO_151{"SRS_SDO_151"};
inline constexpr RequirementId SRS_SDO_152{"SRS_SDO_152"};
inline constexpr RequirementId SRS_SDO_160{"SRS_SDO_160"};
} // namespace counterpoint::req

#endif
