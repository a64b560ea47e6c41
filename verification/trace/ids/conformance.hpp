// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/conformance.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_CONFORMANCE_HPP
#define VERIFICATION_TRACE_IDS_CONFORMANCE_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_CNF_001{"SRS_CNF_001"};
inline constexpr RequirementId SRS_CNF_002{"SRS_CNF_002"};
inline constexpr RequirementId SRS_CNF_003{"SRS_CNF_003"};
inline constexpr RequirementId SRS_CNF_004{"SRS_CNF_004"};
inline constexpr RequirementId SRS_CNF_005{"SRS_CNF_005"};
inline constexpr RequirementId SRS_CNF_006{"SRS_CNF_006"};
inline constexpr RequirementId SRS_CNF_007{"SRS_CNF_007"};
inline constexpr RequirementId SRS_CNF_010{"SRS_CNF_010"};
inline constexpr RequirementId SRS_CNF_011{"SRS_CNF_011"};
inline constexpr RequirementId SRS_CNF_012{"SRS_CNF_012"};
inline constexpr RequirementId SRS_CNF_013{"SRS_CNF_013"};
inline constexpr RequirementId SRS_CNF_020{"SRS_CNF_020"};
inline constexpr RequirementId SRS_CNF_021{"SRS_CNF_021"};
inline constexpr RequirementId SRS_CNF_022{"SRS_CNF_022"};
inline constexpr RequirementId SRS_CNF_023{"SRS_CNF_023"};
inline constexpr RequirementId SRS_CNF_024{"SRS_CNF_024"};
inline constexpr RequirementId SRS_CNF_030{"SRS_CNF_030"};
inline constexpr RequirementId SRS_CNF_340{"SRS_CNF_340"};
inline constexpr RequirementId SRS_CNF_360{"SRS_CNF_360"};
} // namespace counterpoint::req

#endif
