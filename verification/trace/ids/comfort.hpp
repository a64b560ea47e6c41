// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/comfort.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_COMFORT_HPP
#define VERIFICATION_TRACE_IDS_COMFORT_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_EASE_001{"SRS_EASE_001"};
inline constexpr RequirementId SRS_EASE_002{"SRS_EASE_002"};
inline constexpr RequirementId SRS_EASE_003{"SRS_EASE_003"};
inline constexpr RequirementId SRS_EASE_004{"SRS_EASE_004"};
inline constexpr RequirementId SRS_EASE_005{"SRS_EASE_005"};
inline constexpr RequirementId SRS_EASE_006{"SRS_EASE_006"};
inline constexpr RequirementId SRS_EASE_007{"SRS_EASE_007"};
inline constexpr RequirementId SRS_EASE_008{"SRS_EASE_008"};
} // namespace counterpoint::req

#endif
