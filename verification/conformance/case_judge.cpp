// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/case_judge.hpp"

namespace counterpoint::conformance
{

void CaseJudge::Begin(const char* case_name, std::uint32_t origin) noexcept
{
    case_name_ = case_name;
    origin_ = origin;
    step_ = 0U;
    failed_ = false;
}

void CaseJudge::Expect(const char* field, std::uint64_t expected, std::uint64_t got) noexcept
{
    if (expected != got)
    {
        failed_ = true;
        reporter_.OnFailure(Failure{case_name_, field, expected, got, step_, origin_});
    }
}

} // namespace counterpoint::conformance
