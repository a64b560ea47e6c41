// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/verification.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_VERIFICATION_HPP
#define VERIFICATION_TRACE_IDS_VERIFICATION_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_VER_001{"SRS_VER_001"};
inline constexpr RequirementId SRS_VER_002{"SRS_VER_002"};
inline constexpr RequirementId SRS_VER_003{"SRS_VER_003"};
inline constexpr RequirementId SRS_VER_004{"SRS_VER_004"};
inline constexpr RequirementId SRS_VER_005{"SRS_VER_005"};
inline constexpr RequirementId SRS_VER_006{"SRS_VER_006"};
inline constexpr RequirementId SRS_VER_007{"SRS_VER_007"};
inline constexpr RequirementId SRS_VER_008{"SRS_VER_008"};
inline constexpr RequirementId SRS_VER_009{"SRS_VER_009"};
inline constexpr RequirementId SRS_VER_010{"SRS_VER_010"};
inline constexpr RequirementId SRS_VER_011{"SRS_VER_011"};
inline constexpr RequirementId SRS_VER_012{"SRS_VER_012"};
inline constexpr RequirementId SRS_VER_013{"SRS_VER_013"};
inline constexpr RequirementId SRS_VER_014{"SRS_VER_014"};
inline constexpr RequirementId SRS_VER_015{"SRS_VER_015"};
inline constexpr RequirementId SRS_VER_016{"SRS_VER_016"};
inline constexpr RequirementId SRS_VER_017{"SRS_VER_017"};
inline constexpr RequirementId SRS_VER_018{"SRS_VER_018"};
inline constexpr RequirementId SRS_VER_019{"SRS_VER_019"};
inline constexpr RequirementId SRS_VER_020{"SRS_VER_020"};
inline constexpr RequirementId SRS_VER_021{"SRS_VER_021"};
inline constexpr RequirementId SRS_VER_030{"SRS_VER_030"};
inline constexpr RequirementId SRS_VER_031{"SRS_VER_031"};
inline constexpr RequirementId SRS_VER_032{"SRS_VER_032"};
inline constexpr RequirementId SRS_VER_033{"SRS_VER_033"};
inline constexpr RequirementId SRS_VER_037{"SRS_VER_037"};
inline constexpr RequirementId SRS_VER_040{"SRS_VER_040"};
inline constexpr RequirementId SRS_VER_041{"SRS_VER_041"};
inline constexpr RequirementId SRS_VER_042{"SRS_VER_042"};
inline constexpr RequirementId SRS_VER_050{"SRS_VER_050"};
inline constexpr RequirementId SRS_VER_051{"SRS_VER_051"};
inline constexpr RequirementId SRS_VER_060{"SRS_VER_060"};
inline constexpr RequirementId SRS_VER_061{"SRS_VER_061"};
inline constexpr RequirementId SRS_VER_062{"SRS_VER_062"};
inline constexpr RequirementId SRS_VER_070{"SRS_VER_070"};
inline constexpr RequirementId SRS_VER_071{"SRS_VER_071"};
inline constexpr RequirementId SRS_VER_072{"SRS_VER_072"};
inline constexpr RequirementId SRS_VER_073{"SRS_VER_073"};
inline constexpr RequirementId SRS_VER_074{"SRS_VER_074"};
inline constexpr RequirementId SRS_VER_090{"SRS_VER_090"};
inline constexpr RequirementId SRS_VER_091{"SRS_VER_091"};
inline constexpr RequirementId SRS_VER_092{"SRS_VER_092"};
inline constexpr RequirementId SRS_VER_093{"SRS_VER_093"};
inline constexpr RequirementId SRS_VER_094{"SRS_VER_094"};
inline constexpr RequirementId SRS_VER_095{"SRS_VER_095"};
inline constexpr RequirementId SRS_VER_096{"SRS_VER_096"};
inline constexpr RequirementId SRS_VER_110{"SRS_VER_110"};
inline constexpr RequirementId SRS_VER_111{"SRS_VER_111"};
inline constexpr RequirementId SRS_VER_112{"SRS_VER_112"};
inline constexpr RequirementId SRS_VER_113{"SRS_VER_113"};
inline constexpr RequirementId SRS_VER_114{"SRS_VER_114"};
inline constexpr RequirementId SRS_VER_115{"SRS_VER_115"};
inline constexpr RequirementId SRS_VER_116{"SRS_VER_116"};
inline constexpr RequirementId SRS_VER_117{"SRS_VER_117"};
inline constexpr RequirementId SRS_VER_118{"SRS_VER_118"};
inline constexpr RequirementId SRS_VER_119{"SRS_VER_119"};
inline constexpr RequirementId SRS_VER_130{"SRS_VER_130"};
inline constexpr RequirementId SRS_VER_131{"SRS_VER_131"};
inline constexpr RequirementId SRS_VER_132{"SRS_VER_132"};
inline constexpr RequirementId SRS_VER_133{"SRS_VER_133"};
inline constexpr RequirementId SRS_VER_134{"SRS_VER_134"};
inline constexpr RequirementId SRS_VER_135{"SRS_VER_135"};
inline constexpr RequirementId SRS_VER_136{"SRS_VER_136"};
inline constexpr RequirementId SRS_VER_140{"SRS_VER_140"};
inline constexpr RequirementId SRS_VER_141{"SRS_VER_141"};
inline constexpr RequirementId SRS_VER_142{"SRS_VER_142"};
inline constexpr RequirementId SRS_VER_143{"SRS_VER_143"};
inline constexpr RequirementId SRS_VER_144{"SRS_VER_144"};
inline constexpr RequirementId SRS_VER_145{"SRS_VER_145"};
inline constexpr RequirementId SRS_VER_146{"SRS_VER_146"};
inline constexpr RequirementId SRS_VER_147{"SRS_VER_147"};
inline constexpr RequirementId SRS_VER_148{"SRS_VER_148"};
inline constexpr RequirementId SRS_VER_149{"SRS_VER_149"};
inline constexpr RequirementId SRS_VER_160{"SRS_VER_160"};
inline constexpr RequirementId SRS_VER_161{"SRS_VER_161"};
inline constexpr RequirementId SRS_VER_162{"SRS_VER_162"};
inline constexpr RequirementId SRS_VER_163{"SRS_VER_163"};
inline constexpr RequirementId SRS_VER_164{"SRS_VER_164"};
inline constexpr RequirementId SRS_VER_165{"SRS_VER_165"};
inline constexpr RequirementId SRS_VER_170{"SRS_VER_170"};
inline constexpr RequirementId SRS_VER_171{"SRS_VER_171"};
inline constexpr RequirementId SRS_VER_172{"SRS_VER_172"};
inline constexpr RequirementId SRS_VER_173{"SRS_VER_173"};
inline constexpr RequirementId SRS_VER_174{"SRS_VER_174"};
inline constexpr RequirementId SRS_VER_210{"SRS_VER_210"};
inline constexpr RequirementId SRS_VER_211{"SRS_VER_211"};
inline constexpr RequirementId SRS_VER_340{"SRS_VER_340"};
inline constexpr RequirementId SRS_VER_341{"SRS_VER_341"};
inline constexpr RequirementId SRS_VER_342{"SRS_VER_342"};
inline constexpr RequirementId SRS_VER_343{"SRS_VER_343"};
inline constexpr RequirementId SRS_VER_344{"SRS_VER_344"};
inline constexpr RequirementId SRS_VER_345{"SRS_VER_345"};
inline constexpr RequirementId SRS_VER_346{"SRS_VER_346"};
inline constexpr RequirementId SRS_VER_347{"SRS_VER_347"};
} // namespace counterpoint::req

#endif
