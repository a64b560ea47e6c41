// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/device_findings.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/generate/generate.hpp"
#include "runtime/node/trial.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint8_t kAnyNode = 127U;

/// What `generate` refuses, without writing anything.
std::vector<cia306::Finding> TryGenerate(const cia306::Device& device, const std::string& text,
                                         const std::uint8_t node_id)
{
    try
    {
        return generate::Generate(device, text, {"checked", node_id}).warnings;
    }
    catch (const cia306::InputError& error)
    {
        return {{cia306::Severity::kError, error.Where(), "", error.Message()}};
    }
}

/// What the commands that use the file say of it; a file without node-ID is tried with any.
std::vector<cia306::Finding> TryCommands(const cia306::Device& device, const std::string& text,
                                         const std::optional<std::uint8_t> node_id)
{
    std::vector<cia306::Finding> findings = runtime::TryDevice(device, node_id);
    const std::vector<cia306::Finding> generated = TryGenerate(device, text, node_id.value_or(kAnyNode));
    findings.insert(findings.end(), generated.begin(), generated.end());
    return findings;
}

/// Adds those of lines and objects of which nothing was found yet.
void AddOthers(std::vector<cia306::Finding>& findings, const std::vector<cia306::Finding>& others)
{
    for (const cia306::Finding& other : others)
    {
        const bool is_told = std::any_of(findings.begin(), findings.end(), [&other](const cia306::Finding& finding)
                                         { return finding.place == other.place && finding.object == other.object; });
        if (!is_told || other.severity == cia306::Severity::kError)
        {
            findings.push_back(other);
        }
    }
    findings = cia306::SortedByLine(std::move(findings));
}
} // namespace

std::vector<cia306::Finding> FindingsOf(const cia306::Device& device, const std::string& text,
                                        const cia306::CheckOptions& options)
{
    std::vector<cia306::Finding> findings = cia306::CheckDevice(device, options);
    if (ErrorsIn(findings) == 0U)
    {
        AddOthers(findings, TryCommands(device, text, options.node_id));
    }
    return findings;
}

std::size_t ErrorsIn(const std::vector<cia306::Finding>& findings)
{
    return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const cia306::Finding& finding)
                                                  { return finding.severity == cia306::Severity::kError; }));
}
} // namespace counterpoint::tools
