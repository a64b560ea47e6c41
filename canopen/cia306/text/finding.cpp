// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/finding.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

namespace counterpoint::cia306
{
std::vector<Finding> SortedByLine(std::vector<Finding> findings)
{
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& left, const Finding& right) { return left.place.line < right.place.line; });
    return findings;
}

std::vector<Finding> WithoutRepeated(std::vector<Finding> findings)
{
    const auto is_equal = [](const Finding& left, const Finding& right)
    {
        return left.place.line == right.place.line && left.place.column == right.place.column &&
               left.object == right.object && left.text == right.text;
    };
    findings.erase(std::unique(findings.begin(), findings.end(), is_equal), findings.end());
    return findings;
}

std::string FormatFinding(const std::string& file, const Finding& finding)
{
    const std::string severity = finding.severity == Severity::kError ? "error" : "warning";
    const std::string object = finding.object.empty() ? "" : finding.object + ": ";
    return PlaceText(file, finding.place) + ": " + severity + ": " + object + finding.text;
}
} // namespace counterpoint::cia306
