// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Generated from docs/requirements/channel_b.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_IDS_CHANNEL_B_HPP
#define VERIFICATION_TRACE_IDS_CHANNEL_B_HPP

#include "verification/trace/requirement_id.hpp"

namespace counterpoint::req
{
inline constexpr RequirementId SRS_CHB_190{"SRS_CHB_190"};
inline constexpr RequirementId SRS_CHB_191{"SRS_CHB_191"};
inline constexpr RequirementId SRS_CHB_192{"SRS_CHB_192"};
} // namespace counterpoint::req

#endif
