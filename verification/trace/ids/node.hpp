// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/node.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_NODE_HPP
#define VERIFICATION_TRACE_IDS_NODE_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_DEV_001{"SRS_DEV_001"};
inline constexpr RequirementId SRS_DEV_002{"SRS_DEV_002"};
inline constexpr RequirementId SRS_DEV_003{"SRS_DEV_003"};
inline constexpr RequirementId SRS_DEV_004{"SRS_DEV_004"};
inline constexpr RequirementId SRS_DEV_005{"SRS_DEV_005"};
inline constexpr RequirementId SRS_DEV_006{"SRS_DEV_006"};
inline constexpr RequirementId SRS_DEV_007{"SRS_DEV_007"};
inline constexpr RequirementId SRS_DEV_008{"SRS_DEV_008"};
inline constexpr RequirementId SRS_DEV_009{"SRS_DEV_009"};
inline constexpr RequirementId SRS_DEV_010{"SRS_DEV_010"};
inline constexpr RequirementId SRS_DEV_011{"SRS_DEV_011"};
inline constexpr RequirementId SRS_DEV_012{"SRS_DEV_012"};
inline constexpr RequirementId SRS_DEV_013{"SRS_DEV_013"};
inline constexpr RequirementId SRS_DEV_014{"SRS_DEV_014"};
inline constexpr RequirementId SRS_DEV_015{"SRS_DEV_015"};
inline constexpr RequirementId SRS_DEV_016{"SRS_DEV_016"};
inline constexpr RequirementId SRS_DEV_017{"SRS_DEV_017"};
inline constexpr RequirementId SRS_DEV_018{"SRS_DEV_018"};
inline constexpr RequirementId SRS_DEV_019{"SRS_DEV_019"};
inline constexpr RequirementId SRS_DEV_020{"SRS_DEV_020"};
inline constexpr RequirementId SRS_DEV_021{"SRS_DEV_021"};
inline constexpr RequirementId SRS_DEV_022{"SRS_DEV_022"};
inline constexpr RequirementId SRS_DEV_023{"SRS_DEV_023"};
inline constexpr RequirementId SRS_DEV_024{"SRS_DEV_024"};
inline constexpr RequirementId SRS_DEV_025{"SRS_DEV_025"};
inline constexpr RequirementId SRS_DEV_120{"SRS_DEV_120"};
inline constexpr RequirementId SRS_DEV_150{"SRS_DEV_150"};
inline constexpr RequirementId SRS_DEV_151{"SRS_DEV_151"};
inline constexpr RequirementId SRS_DEV_210{"SRS_DEV_210"};
inline constexpr RequirementId SRS_DEV_211{"SRS_DEV_211"};
inline constexpr RequirementId SRS_DEV_212{"SRS_DEV_212"};
inline constexpr RequirementId SRS_NODE_001{"SRS_NODE_001"};
inline constexpr RequirementId SRS_NODE_002{"SRS_NODE_002"};
inline constexpr RequirementId SRS_NODE_003{"SRS_NODE_003"};
inline constexpr RequirementId SRS_NODE_004{"SRS_NODE_004"};
inline constexpr RequirementId SRS_NODE_005{"SRS_NODE_005"};
inline constexpr RequirementId SRS_NODE_006{"SRS_NODE_006"};
inline constexpr RequirementId SRS_NODE_007{"SRS_NODE_007"};
inline constexpr RequirementId SRS_NODE_008{"SRS_NODE_008"};
inline constexpr RequirementId SRS_NODE_009{"SRS_NODE_009"};
inline constexpr RequirementId SRS_NODE_010{"SRS_NODE_010"};
inline constexpr RequirementId SRS_NODE_011{"SRS_NODE_011"};
inline constexpr RequirementId SRS_NODE_012{"SRS_NODE_012"};
inline constexpr RequirementId SRS_NODE_013{"SRS_NODE_013"};
inline constexpr RequirementId SRS_NODE_014{"SRS_NODE_014"};
inline constexpr RequirementId SRS_NODE_015{"SRS_NODE_015"};
inline constexpr RequirementId SRS_NODE_016{"SRS_NODE_016"};
inline constexpr RequirementId SRS_NODE_017{"SRS_NODE_017"};
inline constexpr RequirementId SRS_NODE_018{"SRS_NODE_018"};
inline constexpr RequirementId SRS_NODE_019{"SRS_NODE_019"};
inline constexpr RequirementId SRS_NODE_020{"SRS_NODE_020"};
inline constexpr RequirementId SRS_NODE_024{"SRS_NODE_024"};
inline constexpr RequirementId SRS_NODE_025{"SRS_NODE_025"};
inline constexpr RequirementId SRS_NODE_030{"SRS_NODE_030"};
inline constexpr RequirementId SRS_NODE_031{"SRS_NODE_031"};
inline constexpr RequirementId SRS_NODE_032{"SRS_NODE_032"};
inline constexpr RequirementId SRS_NODE_037{"SRS_NODE_037"};
inline constexpr RequirementId SRS_NODE_038{"SRS_NODE_038"};
inline constexpr RequirementId SRS_NODE_040{"SRS_NODE_040"};
inline constexpr RequirementId SRS_NODE_041{"SRS_NODE_041"};
inline constexpr RequirementId SRS_NODE_042{"SRS_NODE_042"};
inline constexpr RequirementId SRS_NODE_043{"SRS_NODE_043"};
inline constexpr RequirementId SRS_NODE_044{"SRS_NODE_044"};
inline constexpr RequirementId SRS_NODE_045{"SRS_NODE_045"};
inline constexpr RequirementId SRS_NODE_050{"SRS_NODE_050"};
inline constexpr RequirementId SRS_NODE_051{"SRS_NODE_051"};
inline constexpr RequirementId SRS_NODE_052{"SRS_NODE_052"};
inline constexpr RequirementId SRS_NODE_053{"SRS_NODE_053"};
inline constexpr RequirementId SRS_NODE_054{"SRS_NODE_054"};
inline constexpr RequirementId SRS_NODE_150{"SRS_NODE_150"};
inline constexpr RequirementId SRS_NODE_151{"SRS_NODE_151"};
inline constexpr RequirementId SRS_NODE_152{"SRS_NODE_152"};
inline constexpr RequirementId SRS_NODE_153{"SRS_NODE_153"};
inline constexpr RequirementId SRS_NODE_160{"SRS_NODE_160"};
inline constexpr RequirementId SRS_NODE_161{"SRS_NODE_161"};
inline constexpr RequirementId SRS_NODE_210{"SRS_NODE_210"};
inline constexpr RequirementId SRS_NODE_211{"SRS_NODE_211"};
inline constexpr RequirementId SRS_NODE_212{"SRS_NODE_212"};
inline constexpr RequirementId SRS_NODE_240{"SRS_NODE_240"};
inline constexpr RequirementId SRS_NODE_330{"SRS_NODE_330"};
inline constexpr RequirementId SRS_NODE_331{"SRS_NODE_331"};
inline constexpr RequirementId SRS_NODE_340{"SRS_NODE_340"};
inline constexpr RequirementId SRS_NODE_450{"SRS_NODE_450"};
inline constexpr RequirementId SRS_NODE_470{"SRS_NODE_470"};
inline constexpr RequirementId SRS_NODE_490{"SRS_NODE_490"};
inline constexpr RequirementId SRS_NODE_500{"SRS_NODE_500"};
inline constexpr RequirementId SRS_NODE_530{"SRS_NODE_530"};
inline constexpr RequirementId SRS_NODE_531{"SRS_NODE_531"};
inline constexpr RequirementId SRS_NODE_532{"SRS_NODE_532"};
inline constexpr RequirementId SRS_NODE_550{"SRS_NODE_550"};
inline constexpr RequirementId SRS_NODE_551{"SRS_NODE_551"};
inline constexpr RequirementId SRS_NODE_552{"SRS_NODE_552"};
inline constexpr RequirementId SRS_NODE_580{"SRS_NODE_580"};
inline constexpr RequirementId SRS_NODE_581{"SRS_NODE_581"};
inline constexpr RequirementId SRS_NODE_660{"SRS_NODE_660"};
inline constexpr RequirementId SRS_NODE_710{"SRS_NODE_710"};
inline constexpr RequirementId SRS_NODE_711{"SRS_NODE_711"};
inline constexpr RequirementId SRS_NODE_712{"SRS_NODE_712"};
} // namespace counterpoint::req

#endif
