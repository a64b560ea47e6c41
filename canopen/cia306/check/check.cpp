// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/check.hpp"

#include "canopen/cia306/check/rules.hpp"

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

std::vector<Finding> CheckDevice(const Device& device, const CheckOptions& options)
{
    const std::optional<std::uint8_t> node_id = options.node_id ? options.node_id : device.node_id;
    const SafetyConfiguration configuration = ExtractSafety(device, node_id);
    std::vector<Finding> parameter_problems;
    const DeviceParameters parameters = ReadDeviceParameters(device, node_id, parameter_problems);
    const CheckContext context{device, configuration, parameters, node_id,
                               options.granularity_bits.value_or(parameters.granularity_bits)};
    Findings findings;
    findings.Add(device.warnings);
    findings.Add(configuration.missing);
    findings.Add(configuration.problems);
    findings.Add(parameter_problems);
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        findings.Add(srdo.signature_problems);
        findings.Add(srdo.other_problems);
        CheckCommunication(context, srdo, findings);
        CheckMapping(context, srdo, findings);
        CheckStaticMapping(context, srdo, findings);
    }
    CheckIdentifiers(configuration, findings);
    CheckParameters(context, findings);
    CheckDigest(context, findings);
    CheckObjects(context, findings);
    return findings.Sorted();
}
} // namespace counterpoint::cia306
