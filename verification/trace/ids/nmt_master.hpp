// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/nmt_master.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_NMT_MASTER_HPP
#define VERIFICATION_TRACE_IDS_NMT_MASTER_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_BOOT_001{"SRS_BOOT_001"};
inline constexpr RequirementId SRS_BOOT_002{"SRS_BOOT_002"};
inline constexpr RequirementId SRS_BOOT_003{"SRS_BOOT_003"};
inline constexpr RequirementId SRS_BOOT_004{"SRS_BOOT_004"};
inline constexpr RequirementId SRS_BOOT_005{"SRS_BOOT_005"};
inline constexpr RequirementId SRS_BOOT_006{"SRS_BOOT_006"};
inline constexpr RequirementId SRS_BOOT_007{"SRS_BOOT_007"};
inline constexpr RequirementId SRS_BOOT_008{"SRS_BOOT_008"};
inline constexpr RequirementId SRS_BOOT_009{"SRS_BOOT_009"};
inline constexpr RequirementId SRS_BOOT_010{"SRS_BOOT_010"};
inline constexpr RequirementId SRS_BOOT_011{"SRS_BOOT_011"};
inline constexpr RequirementId SRS_BOOT_012{"SRS_BOOT_012"};
inline constexpr RequirementId SRS_BOOT_013{"SRS_BOOT_013"};
inline constexpr RequirementId SRS_BOOT_014{"SRS_BOOT_014"};
inline constexpr RequirementId SRS_BOOT_015{"SRS_BOOT_015"};
inline constexpr RequirementId SRS_BOOT_016{"SRS_BOOT_016"};
inline constexpr RequirementId SRS_BOOT_017{"SRS_BOOT_017"};
inline constexpr RequirementId SRS_BOOT_018{"SRS_BOOT_018"};
inline constexpr RequirementId SRS_BOOT_019{"SRS_BOOT_019"};
inline constexpr RequirementId SRS_BOOT_020{"SRS_BOOT_020"};
inline constexpr RequirementId SRS_BOOT_021{"SRS_BOOT_021"};
inline constexpr RequirementId SRS_BOOT_022{"SRS_BOOT_022"};
inline constexpr RequirementId SRS_BOOT_023{"SRS_BOOT_023"};
inline constexpr RequirementId SRS_BOOT_024{"SRS_BOOT_024"};
inline constexpr RequirementId SRS_BOOT_025{"SRS_BOOT_025"};
inline constexpr RequirementId SRS_BOOT_026{"SRS_BOOT_026"};
inline constexpr RequirementId SRS_BOOT_030{"SRS_BOOT_030"};
inline constexpr RequirementId SRS_BOOT_031{"SRS_BOOT_031"};
inline constexpr RequirementId SRS_BOOT_032{"SRS_BOOT_032"};
inline constexpr RequirementId SRS_BOOT_033{"SRS_BOOT_033"};
inline constexpr RequirementId SRS_BOOT_230{"SRS_BOOT_230"};
inline constexpr RequirementId SRS_BOOT_340{"SRS_BOOT_340"};
inline constexpr RequirementId SRS_BOOT_341{"SRS_BOOT_341"};
inline constexpr RequirementId SRS_BOOT_342{"SRS_BOOT_342"};
inline constexpr RequirementId SRS_BOOT_343{"SRS_BOOT_343"};
inline constexpr RequirementId SRS_BOOT_470{"SRS_BOOT_470"};
inline constexpr RequirementId SRS_BOOT_471{"SRS_BOOT_471"};
inline constexpr RequirementId SRS_BOOT_480{"SRS_BOOT_480"};
inline constexpr RequirementId SRS_BOOT_520{"SRS_BOOT_520"};
inline constexpr RequirementId SRS_BOOT_770{"SRS_BOOT_770"};
inline constexpr RequirementId SRS_BOOT_800{"SRS_BOOT_800"};
inline constexpr RequirementId SRS_BOOT_820{"SRS_BOOT_820"};
inline constexpr RequirementId SRS_BOOT_821{"SRS_BOOT_821"};
inline constexpr RequirementId SRS_NMM_001{"SRS_NMM_001"};
inline constexpr RequirementId SRS_NMM_002{"SRS_NMM_002"};
inline constexpr RequirementId SRS_NMM_003{"SRS_NMM_003"};
inline constexpr RequirementId SRS_NMM_004{"SRS_NMM_004"};
inline constexpr RequirementId SRS_NMM_005{"SRS_NMM_005"};
inline constexpr RequirementId SRS_NMM_006{"SRS_NMM_006"};
inline constexpr RequirementId SRS_NMM_007{"SRS_NMM_007"};
inline constexpr RequirementId SRS_NMM_008{"SRS_NMM_008"};
inline constexpr RequirementId SRS_NMM_009{"SRS_NMM_009"};
inline constexpr RequirementId SRS_NMM_010{"SRS_NMM_010"};
inline constexpr RequirementId SRS_NMM_020{"SRS_NMM_020"};
inline constexpr RequirementId SRS_NMM_021{"SRS_NMM_021"};
inline constexpr RequirementId SRS_NMM_022{"SRS_NMM_022"};
inline constexpr RequirementId SRS_NMM_023{"SRS_NMM_023"};
inline constexpr RequirementId SRS_NMM_024{"SRS_NMM_024"};
inline constexpr RequirementId SRS_NMM_025{"SRS_NMM_025"};
inline constexpr RequirementId SRS_NMM_026{"SRS_NMM_026"};
inline constexpr RequirementId SRS_NMM_030{"SRS_NMM_030"};
inline constexpr RequirementId SRS_NMM_031{"SRS_NMM_031"};
inline constexpr RequirementId SRS_NMM_032{"SRS_NMM_032"};
inline constexpr RequirementId SRS_NMM_120{"SRS_NMM_120"};
inline constexpr RequirementId SRS_NMM_121{"SRS_NMM_121"};
inline constexpr RequirementId SRS_NMM_122{"SRS_NMM_122"};
inline constexpr RequirementId SRS_NMM_150{"SRS_NMM_150"};
inline constexpr RequirementId SRS_NMM_151{"SRS_NMM_151"};
inline constexpr RequirementId SRS_NMM_152{"SRS_NMM_152"};
inline constexpr RequirementId SRS_NMM_153{"SRS_NMM_153"};
inline constexpr RequirementId SRS_NMM_210{"SRS_NMM_210"};
inline constexpr RequirementId SRS_NMM_211{"SRS_NMM_211"};
inline constexpr RequirementId SRS_NMM_212{"SRS_NMM_212"};
inline constexpr RequirementId SRS_NMM_213{"SRS_NMM_213"};
inline constexpr RequirementId SRS_NMM_214{"SRS_NMM_214"};
inline constexpr RequirementId SRS_NMM_215{"SRS_NMM_215"};
inline constexpr RequirementId SRS_NMM_230{"SRS_NMM_230"};
inline constexpr RequirementId SRS_NMM_520{"SRS_NMM_520"};
inline constexpr RequirementId SRS_NMM_521{"SRS_NMM_521"};
inline constexpr RequirementId SRS_NMM_770{"SRS_NMM_770"};
inline constexpr RequirementId SRS_NMM_771{"SRS_NMM_771"};
} // namespace counterpoint::req

#endif
