// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/campaign.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_CAMPAIGN_HPP
#define VERIFICATION_TRACE_IDS_CAMPAIGN_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_CMG_001{"SRS_CMG_001"};
inline constexpr RequirementId SRS_CMG_002{"SRS_CMG_002"};
inline constexpr RequirementId SRS_CMG_003{"SRS_CMG_003"};
inline constexpr RequirementId SRS_CMG_004{"SRS_CMG_004"};
inline constexpr RequirementId SRS_CMG_005{"SRS_CMG_005"};
inline constexpr RequirementId SRS_CMG_006{"SRS_CMG_006"};
inline constexpr RequirementId SRS_CMG_007{"SRS_CMG_007"};
inline constexpr RequirementId SRS_CMG_008{"SRS_CMG_008"};
inline constexpr RequirementId SRS_CMG_009{"SRS_CMG_009"};
inline constexpr RequirementId SRS_CMG_010{"SRS_CMG_010"};
inline constexpr RequirementId SRS_CMG_011{"SRS_CMG_011"};
inline constexpr RequirementId SRS_CMG_012{"SRS_CMG_012"};
inline constexpr RequirementId SRS_CMG_013{"SRS_CMG_013"};
inline constexpr RequirementId SRS_CMG_020{"SRS_CMG_020"};
inline constexpr RequirementId SRS_CMG_021{"SRS_CMG_021"};
inline constexpr RequirementId SRS_CMG_022{"SRS_CMG_022"};
inline constexpr RequirementId SRS_CMG_023{"SRS_CMG_023"};
inline constexpr RequirementId SRS_CMG_024{"SRS_CMG_024"};
inline constexpr RequirementId SRS_CMG_025{"SRS_CMG_025"};
inline constexpr RequirementId SRS_CMG_026{"SRS_CMG_026"};
inline constexpr RequirementId SRS_CMG_027{"SRS_CMG_027"};
inline constexpr RequirementId SRS_CMG_028{"SRS_CMG_028"};
inline constexpr RequirementId SRS_CMG_029{"SRS_CMG_029"};
inline constexpr RequirementId SRS_CMG_040{"SRS_CMG_040"};
inline constexpr RequirementId SRS_CMG_041{"SRS_CMG_041"};
inline constexpr RequirementId SRS_CMG_042{"SRS_CMG_042"};
inline constexpr RequirementId SRS_CMG_043{"SRS_CMG_043"};
inline constexpr RequirementId SRS_CMG_044{"SRS_CMG_044"};
inline constexpr RequirementId SRS_CMG_045{"SRS_CMG_045"};
inline constexpr RequirementId SRS_CMG_046{"SRS_CMG_046"};
inline constexpr RequirementId SRS_CMG_047{"SRS_CMG_047"};
inline constexpr RequirementId SRS_CMG_048{"SRS_CMG_048"};
inline constexpr RequirementId SRS_CMG_049{"SRS_CMG_049"};
inline constexpr RequirementId SRS_CMG_060{"SRS_CMG_060"};
inline constexpr RequirementId SRS_CMG_061{"SRS_CMG_061"};
inline constexpr RequirementId SRS_CMG_062{"SRS_CMG_062"};
inline constexpr RequirementId SRS_CMG_063{"SRS_CMG_063"};
inline constexpr RequirementId SRS_CMG_064{"SRS_CMG_064"};
inline constexpr RequirementId SRS_CMG_070{"SRS_CMG_070"};
inline constexpr RequirementId SRS_CMG_071{"SRS_CMG_071"};
inline constexpr RequirementId SRS_CMG_072{"SRS_CMG_072"};
inline constexpr RequirementId SRS_CMG_073{"SRS_CMG_073"};
inline constexpr RequirementId SRS_CMG_074{"SRS_CMG_074"};
inline constexpr RequirementId SRS_CMG_075{"SRS_CMG_075"};
inline constexpr RequirementId SRS_CMG_076{"SRS_CMG_076"};
inline constexpr RequirementId SRS_CMG_077{"SRS_CMG_077"};
inline constexpr RequirementId SRS_CMG_080{"SRS_CMG_080"};
inline constexpr RequirementId SRS_CMG_081{"SRS_CMG_081"};
inline constexpr RequirementId SRS_CMG_082{"SRS_CMG_082"};
inline constexpr RequirementId SRS_CMG_083{"SRS_CMG_083"};
inline constexpr RequirementId SRS_CMG_120{"SRS_CMG_120"};
inline constexpr RequirementId SRS_CMG_130{"SRS_CMG_130"};
inline constexpr RequirementId SRS_CMG_131{"SRS_CMG_131"};
inline constexpr RequirementId SRS_CMG_132{"SRS_CMG_132"};
inline constexpr RequirementId SRS_CMG_150{"SRS_CMG_150"};
inline constexpr RequirementId SRS_CMG_151{"SRS_CMG_151"};
inline constexpr RequirementId SRS_CMG_152{"SRS_CMG_152"};
inline constexpr RequirementId SRS_CMG_153{"SRS_CMG_153"};
inline constexpr RequirementId SRS_CMG_154{"SRS_CMG_154"};
inline constexpr RequirementId SRS_CMG_155{"SRS_CMG_155"};
inline constexpr RequirementId SRS_CMG_156{"SRS_CMG_156"};
inline constexpr RequirementId SRS_CMG_157{"SRS_CMG_157"};
inline constexpr RequirementId SRS_CMG_158{"SRS_CMG_158"};
inline constexpr RequirementId SRS_CMG_159{"SRS_CMG_159"};
inline constexpr RequirementId SRS_CMG_170{"SRS_CMG_170"};
inline constexpr RequirementId SRS_CMG_171{"SRS_CMG_171"};
inline constexpr RequirementId SRS_CMG_172{"SRS_CMG_172"};
inline constexpr RequirementId SRS_CMG_173{"SRS_CMG_173"};
inline constexpr RequirementId SRS_CMG_210{"SRS_CMG_210"};
inline constexpr RequirementId SRS_CMG_211{"SRS_CMG_211"};
inline constexpr RequirementId SRS_CMG_212{"SRS_CMG_212"};
inline constexpr RequirementId SRS_CMG_213{"SRS_CMG_213"};
inline constexpr RequirementId SRS_CMG_214{"SRS_CMG_214"};
inline constexpr RequirementId SRS_CMG_215{"SRS_CMG_215"};
inline constexpr RequirementId SRS_CMG_216{"SRS_CMG_216"};
inline constexpr RequirementId SRS_CMG_217{"SRS_CMG_217"};
inline constexpr RequirementId SRS_CMG_218{"SRS_CMG_218"};
inline constexpr RequirementId SRS_CMG_219{"SRS_CMG_219"};
inline constexpr RequirementId SRS_CMG_220{"SRS_CMG_220"};
inline constexpr RequirementId SRS_CMG_221{"SRS_CMG_221"};
inline constexpr RequirementId SRS_CMG_250{"SRS_CMG_250"};
inline constexpr RequirementId SRS_CMG_330{"SRS_CMG_330"};
inline constexpr RequirementId SRS_CMG_340{"SRS_CMG_340"};
inline constexpr RequirementId SRS_CMG_341{"SRS_CMG_341"};
inline constexpr RequirementId SRS_CMG_342{"SRS_CMG_342"};
inline constexpr RequirementId SRS_CMG_343{"SRS_CMG_343"};
inline constexpr RequirementId SRS_CMG_344{"SRS_CMG_344"};
inline constexpr RequirementId SRS_CMG_345{"SRS_CMG_345"};
inline constexpr RequirementId SRS_CMG_346{"SRS_CMG_346"};
inline constexpr RequirementId SRS_CMG_347{"SRS_CMG_347"};
inline constexpr RequirementId SRS_CMG_348{"SRS_CMG_348"};
inline constexpr RequirementId SRS_CMG_349{"SRS_CMG_349"};
inline constexpr RequirementId SRS_CMG_410{"SRS_CMG_410"};
inline constexpr RequirementId SRS_CMG_500{"SRS_CMG_500"};
inline constexpr RequirementId SRS_CMG_501{"SRS_CMG_501"};
inline constexpr RequirementId SRS_CMG_540{"SRS_CMG_540"};
inline constexpr RequirementId SRS_CMG_541{"SRS_CMG_541"};
inline constexpr RequirementId SRS_CMG_560{"SRS_CMG_560"};
inline constexpr RequirementId SRS_CMG_561{"SRS_CMG_561"};
inline constexpr RequirementId SRS_CMG_800{"SRS_CMG_800"};
inline constexpr RequirementId SRS_CMG_801{"SRS_CMG_801"};
inline constexpr RequirementId SRS_CMG_802{"SRS_CMG_802"};
inline constexpr RequirementId SRS_CMG_803{"SRS_CMG_803"};
inline constexpr RequirementId SRS_CMG_804{"SRS_CMG_804"};
inline constexpr RequirementId SRS_CMG_805{"SRS_CMG_805"};
} // namespace counterpoint::req

#endif
