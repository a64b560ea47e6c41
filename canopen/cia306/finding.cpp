#include "canopen/cia306/finding.hpp"

#include "canopen/cia306/input_error.hpp"

namespace counterpoint::cia306
{
std::string FormatFinding(const std::string& file, const Finding& finding)
{
    const std::string severity = finding.severity == Severity::kError ? "error" : "warning";
    const std::string object = finding.object.empty() ? "" : finding.object + ": ";
    return Printable(file) + ":" + std::to_string(finding.line) + ": " + severity + ": " + object + finding.text;
}
} // namespace counterpoint::cia306
