// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/findings.hpp"

#include <utility>

namespace counterpoint::cia306
{
void Findings::Error(const std::size_t line, const std::string& object, const std::string& wrong,
                     const std::string& expected)
{
    Add(Finding{Severity::kError, line, object, wrong + ", expected " + expected});
}

void Findings::Warning(const std::size_t line, const std::string& object, const std::string& wrong,
                       const std::string& expected)
{
    Add(Finding{Severity::kWarning, line, object, wrong + ", expected " + expected});
}

void Findings::Add(const std::vector<Finding>& findings)
{
    for (const Finding& finding : findings)
    {
        Add(finding);
    }
}

void Findings::Add(Finding finding)
{
    if (finding.severity == Severity::kError)
    {
        error_places_.emplace(finding.line, finding.object);
    }
    findings_.push_back(std::move(finding));
}

bool Findings::HasError() const
{
    return !error_places_.empty();
}

bool Findings::HasErrorAt(const std::size_t line, const std::string& object) const
{
    return error_places_.count({line, object}) != 0U;
}

std::vector<Finding> Findings::Sorted() const
{
    return SortedByLine(findings_);
}
} // namespace counterpoint::cia306
