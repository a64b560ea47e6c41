// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/zynqmp.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_ZYNQMP_HPP
#define VERIFICATION_TRACE_IDS_ZYNQMP_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_ZYN_001{"SRS_ZYN_001"};
inline constexpr RequirementId SRS_ZYN_002{"SRS_ZYN_002"};
inline constexpr RequirementId SRS_ZYN_003{"SRS_ZYN_003"};
inline constexpr RequirementId SRS_ZYN_004{"SRS_ZYN_004"};
inline constexpr RequirementId SRS_ZYN_005{"SRS_ZYN_005"};
inline constexpr RequirementId SRS_ZYN_006{"SRS_ZYN_006"};
inline constexpr RequirementId SRS_ZYN_007{"SRS_ZYN_007"};
inline constexpr RequirementId SRS_ZYN_010{"SRS_ZYN_010"};
inline constexpr RequirementId SRS_ZYN_011{"SRS_ZYN_011"};
inline constexpr RequirementId SRS_ZYN_012{"SRS_ZYN_012"};
inline constexpr RequirementId SRS_ZYN_013{"SRS_ZYN_013"};
inline constexpr RequirementId SRS_ZYN_014{"SRS_ZYN_014"};
inline constexpr RequirementId SRS_ZYN_015{"SRS_ZYN_015"};
inline constexpr RequirementId SRS_ZYN_016{"SRS_ZYN_016"};
inline constexpr RequirementId SRS_ZYN_200{"SRS_ZYN_200"};
inline constexpr RequirementId SRS_ZYN_201{"SRS_ZYN_201"};
inline constexpr RequirementId SRS_ZYN_202{"SRS_ZYN_202"};
} // namespace counterpoint::req

#endif
