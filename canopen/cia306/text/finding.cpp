// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/finding.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <map>
#include <utility>

namespace counterpoint::cia306
{
std::vector<Finding> SortedByLine(std::vector<Finding> findings)
{
    std::multimap<std::size_t, Finding> by_line; // Equal lines stay in the order of insertion.
    for (Finding& finding : findings)
    {
        const std::size_t line = finding.line;
        by_line.emplace(line, std::move(finding));
    }
    std::vector<Finding> sorted;
    for (auto& [line, finding] : by_line)
    {
        sorted.push_back(std::move(finding));
    }
    return sorted;
}

std::string FormatFinding(const std::string& file, const Finding& finding)
{
    const std::string severity = finding.severity == Severity::kError ? "error" : "warning";
    const std::string object = finding.object.empty() ? "" : finding.object + ": ";
    return Printable(file) + ":" + std::to_string(finding.line) + ": " + severity + ": " + object + finding.text;
}
} // namespace counterpoint::cia306
