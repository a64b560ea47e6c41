// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/finding.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

namespace counterpoint::cia306
{
std::vector<Finding> SortedByLine(std::vector<Finding> findings)
{
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& left, const Finding& right) { return left.line < right.line; });
    return findings;
}

std::string FormatFinding(const std::string& file, const Finding& finding)
{
    const std::string severity = finding.severity == Severity::kError ? "error" : "warning";
    const std::string object = finding.object.empty() ? "" : finding.object + ": ";
    return Printable(file) + ":" + std::to_string(finding.line) + ": " + severity + ": " + object + finding.text;
}
} // namespace counterpoint::cia306
