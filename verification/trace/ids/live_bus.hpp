// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/live_bus.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_LIVE_BUS_HPP
#define VERIFICATION_TRACE_IDS_LIVE_BUS_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_LIVE_001{"SRS_LIVE_001"};
inline constexpr RequirementId SRS_LIVE_002{"SRS_LIVE_002"};
inline constexpr RequirementId SRS_LIVE_003{"SRS_LIVE_003"};
inline constexpr RequirementId SRS_LIVE_004{"SRS_LIVE_004"};
inline constexpr RequirementId SRS_LIVE_005{"SRS_LIVE_005"};
inline constexpr RequirementId SRS_LIVE_010{"SRS_LIVE_010"};
inline constexpr RequirementId SRS_LIVE_011{"SRS_LIVE_011"};
inline constexpr RequirementId SRS_LIVE_012{"SRS_LIVE_012"};
inline constexpr RequirementId SRS_LIVE_013{"SRS_LIVE_013"};
inline constexpr RequirementId SRS_LIVE_014{"SRS_LIVE_014"};
inline constexpr RequirementId SRS_LIVE_015{"SRS_LIVE_015"};
inline constexpr RequirementId SRS_LIVE_020{"SRS_LIVE_020"};
inline constexpr RequirementId SRS_LIVE_021{"SRS_LIVE_021"};
inline constexpr RequirementId SRS_LIVE_022{"SRS_LIVE_022"};
inline constexpr RequirementId SRS_LIVE_023{"SRS_LIVE_023"};
inline constexpr RequirementId SRS_LIVE_024{"SRS_LIVE_024"};
inline constexpr RequirementId SRS_LIVE_025{"SRS_LIVE_025"};
inline constexpr RequirementId SRS_LIVE_026{"SRS_LIVE_026"};
inline constexpr RequirementId SRS_LIVE_027{"SRS_LIVE_027"};
inline constexpr RequirementId SRS_LIVE_040{"SRS_LIVE_040"};
inline constexpr RequirementId SRS_LIVE_050{"SRS_LIVE_050"};
inline constexpr RequirementId SRS_LIVE_051{"SRS_LIVE_051"};
inline constexpr RequirementId SRS_LIVE_052{"SRS_LIVE_052"};
inline constexpr RequirementId SRS_LIVE_053{"SRS_LIVE_053"};
inline constexpr RequirementId SRS_LIVE_054{"SRS_LIVE_054"};
inline constexpr RequirementId SRS_LIVE_055{"SRS_LIVE_055"};
inline constexpr RequirementId SRS_LIVE_056{"SRS_LIVE_056"};
inline constexpr RequirementId SRS_LIVE_057{"SRS_LIVE_057"};
inline constexpr RequirementId SRS_LIVE_058{"SRS_LIVE_058"};
inline constexpr RequirementId SRS_LIVE_059{"SRS_LIVE_059"};
inline constexpr RequirementId SRS_LIVE_061{"SRS_LIVE_061"};
inline constexpr RequirementId SRS_LIVE_330{"SRS_LIVE_330"};
inline constexpr RequirementId SRS_LIVE_580{"SRS_LIVE_580"};
inline constexpr RequirementId SRS_LIVE_581{"SRS_LIVE_581"};
inline constexpr RequirementId SRS_LIVE_582{"SRS_LIVE_582"};
inline constexpr RequirementId SRS_LIVE_583{"SRS_LIVE_583"};
inline constexpr RequirementId SRS_LIVE_584{"SRS_LIVE_584"};
} // namespace counterpoint::req

#endif
