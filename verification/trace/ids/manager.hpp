// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/manager.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_MANAGER_HPP
#define VERIFICATION_TRACE_IDS_MANAGER_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_MGR_001{"SRS_MGR_001"};
inline constexpr RequirementId SRS_MGR_002{"SRS_MGR_002"};
inline constexpr RequirementId SRS_MGR_003{"SRS_MGR_003"};
inline constexpr RequirementId SRS_MGR_004{"SRS_MGR_004"};
inline constexpr RequirementId SRS_MGR_005{"SRS_MGR_005"};
inline constexpr RequirementId SRS_MGR_006{"SRS_MGR_006"};
inline constexpr RequirementId SRS_MGR_007{"SRS_MGR_007"};
inline constexpr RequirementId SRS_MGR_008{"SRS_MGR_008"};
inline constexpr RequirementId SRS_MGR_009{"SRS_MGR_009"};
inline constexpr RequirementId SRS_MGR_010{"SRS_MGR_010"};
inline constexpr RequirementId SRS_MGR_011{"SRS_MGR_011"};
inline constexpr RequirementId SRS_MGR_012{"SRS_MGR_012"};
inline constexpr RequirementId SRS_MGR_013{"SRS_MGR_013"};
inline constexpr RequirementId SRS_MGR_014{"SRS_MGR_014"};
inline constexpr RequirementId SRS_MGR_015{"SRS_MGR_015"};
inline constexpr RequirementId SRS_MGR_016{"SRS_MGR_016"};
inline constexpr RequirementId SRS_MGR_020{"SRS_MGR_020"};
inline constexpr RequirementId SRS_MGR_021{"SRS_MGR_021"};
inline constexpr RequirementId SRS_MGR_022{"SRS_MGR_022"};
inline constexpr RequirementId SRS_MGR_023{"SRS_MGR_023"};
inline constexpr RequirementId SRS_MGR_024{"SRS_MGR_024"};
inline constexpr RequirementId SRS_MGR_025{"SRS_MGR_025"};
inline constexpr RequirementId SRS_MGR_026{"SRS_MGR_026"};
inline constexpr RequirementId SRS_MGR_061{"SRS_MGR_061"};
inline constexpr RequirementId SRS_MGR_080{"SRS_MGR_080"};
inline constexpr RequirementId SRS_MGR_081{"SRS_MGR_081"};
inline constexpr RequirementId SRS_MGR_082{"SRS_MGR_082"};
inline constexpr RequirementId SRS_MGR_083{"SRS_MGR_083"};
inline constexpr RequirementId SRS_MGR_120{"SRS_MGR_120"};
inline constexpr RequirementId SRS_MGR_121{"SRS_MGR_121"};
inline constexpr RequirementId SRS_MGR_122{"SRS_MGR_122"};
inline constexpr RequirementId SRS_MGR_123{"SRS_MGR_123"};
inline constexpr RequirementId SRS_MGR_124{"SRS_MGR_124"};
inline constexpr RequirementId SRS_MGR_125{"SRS_MGR_125"};
inline constexpr RequirementId SRS_MGR_126{"SRS_MGR_126"};
inline constexpr RequirementId SRS_MGR_127{"SRS_MGR_127"};
inline constexpr RequirementId SRS_MGR_128{"SRS_MGR_128"};
inline constexpr RequirementId SRS_MGR_129{"SRS_MGR_129"};
inline constexpr RequirementId SRS_MGR_130{"SRS_MGR_130"};
inline constexpr RequirementId SRS_MGR_131{"SRS_MGR_131"};
inline constexpr RequirementId SRS_MGR_132{"SRS_MGR_132"};
inline constexpr RequirementId SRS_MGR_133{"SRS_MGR_133"};
inline constexpr RequirementId SRS_MGR_134{"SRS_MGR_134"};
inline constexpr RequirementId SRS_MGR_135{"SRS_MGR_135"};
inline constexpr RequirementId SRS_MGR_136{"SRS_MGR_136"};
inline constexpr RequirementId SRS_MGR_137{"SRS_MGR_137"};
inline constexpr RequirementId SRS_MGR_138{"SRS_MGR_138"};
inline constexpr RequirementId SRS_MGR_139{"SRS_MGR_139"};
inline constexpr RequirementId SRS_MGR_140{"SRS_MGR_140"};
inline constexpr RequirementId SRS_MGR_141{"SRS_MGR_141"};
inline constexpr RequirementId SRS_MGR_142{"SRS_MGR_142"};
inline constexpr RequirementId SRS_MGR_150{"SRS_MGR_150"};
inline constexpr RequirementId SRS_MGR_151{"SRS_MGR_151"};
inline constexpr RequirementId SRS_MGR_152{"SRS_MGR_152"};
inline constexpr RequirementId SRS_MGR_153{"SRS_MGR_153"};
inline constexpr RequirementId SRS_MGR_154{"SRS_MGR_154"};
inline constexpr RequirementId SRS_MGR_155{"SRS_MGR_155"};
inline constexpr RequirementId SRS_MGR_156{"SRS_MGR_156"};
inline constexpr RequirementId SRS_MGR_157{"SRS_MGR_157"};
inline constexpr RequirementId SRS_MGR_158{"SRS_MGR_158"};
inline constexpr RequirementId SRS_MGR_159{"SRS_MGR_159"};
inline constexpr RequirementId SRS_MGR_160{"SRS_MGR_160"};
inline constexpr RequirementId SRS_MGR_161{"SRS_MGR_161"};
inline constexpr RequirementId SRS_MGR_210{"SRS_MGR_210"};
inline constexpr RequirementId SRS_MGR_211{"SRS_MGR_211"};
inline constexpr RequirementId SRS_MGR_212{"SRS_MGR_212"};
inline constexpr RequirementId SRS_NET_001{"SRS_NET_001"};
inline constexpr RequirementId SRS_NET_002{"SRS_NET_002"};
inline constexpr RequirementId SRS_NET_003{"SRS_NET_003"};
inline constexpr RequirementId SRS_NET_004{"SRS_NET_004"};
inline constexpr RequirementId SRS_NET_005{"SRS_NET_005"};
inline constexpr RequirementId SRS_NET_006{"SRS_NET_006"};
inline constexpr RequirementId SRS_NET_060{"SRS_NET_060"};
inline constexpr RequirementId SRS_NET_061{"SRS_NET_061"};
inline constexpr RequirementId SRS_NET_150{"SRS_NET_150"};
inline constexpr RequirementId SRS_NET_151{"SRS_NET_151"};
inline constexpr RequirementId SRS_NET_152{"SRS_NET_152"};
inline constexpr RequirementId SRS_NET_153{"SRS_NET_153"};
inline constexpr RequirementId SRS_NET_154{"SRS_NET_154"};
inline constexpr RequirementId SRS_SFS_001{"SRS_SFS_001"};
inline constexpr RequirementId SRS_SFS_002{"SRS_SFS_002"};
inline constexpr RequirementId SRS_SFS_003{"SRS_SFS_003"};
inline constexpr RequirementId SRS_SFS_004{"SRS_SFS_004"};
inline constexpr RequirementId SRS_SFS_005{"SRS_SFS_005"};
inline constexpr RequirementId SRS_SFS_006{"SRS_SFS_006"};
inline constexpr RequirementId SRS_SFS_007{"SRS_SFS_007"};
inline constexpr RequirementId SRS_SFS_008{"SRS_SFS_008"};
inline constexpr RequirementId SRS_SFS_009{"SRS_SFS_009"};
inline constexpr RequirementId SRS_SFS_010{"SRS_SFS_010"};
inline constexpr RequirementId SRS_SFS_011{"SRS_SFS_011"};
inline constexpr RequirementId SRS_SFS_120{"SRS_SFS_120"};
inline constexpr RequirementId SRS_SFS_121{"SRS_SFS_121"};
inline constexpr RequirementId SRS_SFS_150{"SRS_SFS_150"};
inline constexpr RequirementId SRS_SFS_151{"SRS_SFS_151"};
inline constexpr RequirementId SRS_SFS_152{"SRS_SFS_152"};
inline constexpr RequirementId SRS_SFS_153{"SRS_SFS_153"};
inline constexpr RequirementId SRS_SFS_154{"SRS_SFS_154"};
} // namespace counterpoint::req

#endif
