// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/selftest.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_SELFTEST_HPP
#define VERIFICATION_TRACE_IDS_SELFTEST_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_STS_001{"SRS_STS_001"};
inline constexpr RequirementId SRS_STS_002{"SRS_STS_002"};
inline constexpr RequirementId SRS_STS_003{"SRS_STS_003"};
inline constexpr RequirementId SRS_STS_010{"SRS_STS_010"};
inline constexpr RequirementId SRS_STS_011{"SRS_STS_011"};
inline constexpr RequirementId SRS_STS_012{"SRS_STS_012"};
inline constexpr RequirementId SRS_STS_013{"SRS_STS_013"};
inline constexpr RequirementId SRS_STS_014{"SRS_STS_014"};
inline constexpr RequirementId SRS_STS_015{"SRS_STS_015"};
inline constexpr RequirementId SRS_STS_020{"SRS_STS_020"};
inline constexpr RequirementId SRS_STS_030{"SRS_STS_030"};
inline constexpr RequirementId SRS_STS_031{"SRS_STS_031"};
inline constexpr RequirementId SRS_STS_040{"SRS_STS_040"};
inline constexpr RequirementId SRS_STS_050{"SRS_STS_050"};
inline constexpr RequirementId SRS_STS_051{"SRS_STS_051"};
inline constexpr RequirementId SRS_STS_052{"SRS_STS_052"};
inline constexpr RequirementId SRS_STS_060{"SRS_STS_060"};
inline constexpr RequirementId SRS_STS_061{"SRS_STS_061"};
inline constexpr RequirementId SRS_STS_062{"SRS_STS_062"};
inline constexpr RequirementId SRS_STS_063{"SRS_STS_063"};
inline constexpr RequirementId SRS_STS_064{"SRS_STS_064"};
inline constexpr RequirementId SRS_STS_210{"SRS_STS_210"};
inline constexpr RequirementId SRS_STS_211{"SRS_STS_211"};
inline constexpr RequirementId SRS_STS_212{"SRS_STS_212"};
inline constexpr RequirementId SRS_STS_213{"SRS_STS_213"};
inline constexpr RequirementId SRS_STS_214{"SRS_STS_214"};
inline constexpr RequirementId SRS_STS_215{"SRS_STS_215"};
} // namespace counterpoint::req

#endif
