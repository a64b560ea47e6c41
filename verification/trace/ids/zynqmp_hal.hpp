// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/zynqmp_hal.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_ZYNQMP_HAL_HPP
#define VERIFICATION_TRACE_IDS_ZYNQMP_HAL_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_ZYN_041{"SRS_ZYN_041"};
inline constexpr RequirementId SRS_ZYN_044{"SRS_ZYN_044"};
inline constexpr RequirementId SRS_ZYN_045{"SRS_ZYN_045"};
inline constexpr RequirementId SRS_ZYN_046{"SRS_ZYN_046"};
inline constexpr RequirementId SRS_ZYN_047{"SRS_ZYN_047"};
inline constexpr RequirementId SRS_ZYN_048{"SRS_ZYN_048"};
inline constexpr RequirementId SRS_ZYN_049{"SRS_ZYN_049"};
inline constexpr RequirementId SRS_ZYN_050{"SRS_ZYN_050"};
inline constexpr RequirementId SRS_ZYN_051{"SRS_ZYN_051"};
inline constexpr RequirementId SRS_ZYN_052{"SRS_ZYN_052"};
inline constexpr RequirementId SRS_ZYN_054{"SRS_ZYN_054"};
inline constexpr RequirementId SRS_ZYN_055{"SRS_ZYN_055"};
inline constexpr RequirementId SRS_ZYN_056{"SRS_ZYN_056"};
inline constexpr RequirementId SRS_ZYN_060{"SRS_ZYN_060"};
inline constexpr RequirementId SRS_ZYN_062{"SRS_ZYN_062"};
inline constexpr RequirementId SRS_ZYN_066{"SRS_ZYN_066"};
inline constexpr RequirementId SRS_ZYN_067{"SRS_ZYN_067"};
inline constexpr RequirementId SRS_ZYN_068{"SRS_ZYN_068"};
inline constexpr RequirementId SRS_ZYN_069{"SRS_ZYN_069"};
inline constexpr RequirementId SRS_ZYN_070{"SRS_ZYN_070"};
} // namespace counterpoint::req

#endif
