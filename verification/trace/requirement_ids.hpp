// Generated from docs/requirements/*.sdoc by verification/trace/generate_ids.py. Do not edit.
#ifndef VERIFICATION_TRACE_REQUIREMENT_IDS_HPP
#define VERIFICATION_TRACE_REQUIREMENT_IDS_HPP

namespace counterpoint::req
{
/// Names one requirement; only this header makes one, so that an unknown or retired identifier does not compile.
struct RequirementId
{
    const char* text;
};

inline constexpr RequirementId SRS_VER_001{"SRS-VER-001"};
inline constexpr RequirementId SRS_VER_002{"SRS-VER-002"};
inline constexpr RequirementId SRS_VER_003{"SRS-VER-003"};
inline constexpr RequirementId SRS_VER_004{"SRS-VER-004"};
inline constexpr RequirementId SRS_VER_005{"SRS-VER-005"};
inline constexpr RequirementId SRS_VER_006{"SRS-VER-006"};
inline constexpr RequirementId SRS_VER_007{"SRS-VER-007"};
inline constexpr RequirementId SRS_VER_008{"SRS-VER-008"};
inline constexpr RequirementId SRS_VER_009{"SRS-VER-009"};
inline constexpr RequirementId SRS_VER_010{"SRS-VER-010"};
inline constexpr RequirementId SRS_VER_011{"SRS-VER-011"};
inline constexpr RequirementId SRS_VER_012{"SRS-VER-012"};
inline constexpr RequirementId SRS_VER_013{"SRS-VER-013"};
inline constexpr RequirementId SRS_VER_014{"SRS-VER-014"};
inline constexpr RequirementId SRS_VER_015{"SRS-VER-015"};
inline constexpr RequirementId SRS_VER_016{"SRS-VER-016"};
}  // namespace counterpoint::req

#endif  // VERIFICATION_TRACE_REQUIREMENT_IDS_HPP
