// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "canopen/generate/generate.hpp"
#include "runtime/console/json_text.hpp"
#include "runtime/node/trial.hpp"
#include "tools/command_table.hpp"
#include "tools/device_options.hpp"

#include <algorithm>
#include <ostream>
#include <utility>
#include <vector>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint8_t kAnyNode = 127U;

std::size_t CountOf(const std::vector<cia306::Finding>& findings, const cia306::Severity severity)
{
    return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(),
                                                  [severity](const cia306::Finding& finding)
                                                  { return finding.severity == severity; }));
}

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
        return {{cia306::Severity::kError, error.Line(), "", error.Message()}};
    }
}

/// What the commands that use the file say of it; a file without node-ID is tried with any. [SRS_CLI_030]
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
                                         { return finding.line == other.line && finding.object == other.object; });
        if (!is_told || other.severity == cia306::Severity::kError)
        {
            findings.push_back(other);
        }
    }
    findings = cia306::SortedByLine(std::move(findings));
}

class CheckCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options_.Describe(options);
        options
            .Add("--granularity", &granularity_,
                 "Bits that mapped lengths have to be multiples of (default: the ones in the file, else 8)")
            .OneOf({1, 8, 16, 32, 64});
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        return RunOnDevice(options_, streams, [&] { return Check(streams); });
    }

  private:
    [[nodiscard]] ExitStatus Check(const Streams& streams) const
    {
        const std::string text = cia306::ReadTextFile(options_.file);
        const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse(options_.file, text));
        cia306::CheckOptions check_options;
        check_options.node_id = options_.NodeId(device);
        if (granularity_ != 0)
        {
            check_options.granularity_bits = static_cast<std::uint8_t>(granularity_);
        }
        std::vector<cia306::Finding> findings = cia306::CheckDevice(device, check_options);
        if (CountOf(findings, cia306::Severity::kError) == 0U)
        {
            AddOthers(findings, TryCommands(device, text, check_options.node_id));
        }
        const std::size_t errors = CountOf(findings, cia306::Severity::kError);
        if (options_.is_json)
        {
            PrintJson(findings, errors, streams.out);
        }
        else
        {
            for (const cia306::Finding& finding : findings)
            {
                streams.out << cia306::FormatFinding(options_.file, finding) << "\n";
            }
        }
        return errors == 0U ? ExitStatus::kHolds : ExitStatus::kDoesNotHold;
    }

    void PrintJson(const std::vector<cia306::Finding>& findings, const std::size_t errors, std::ostream& out) const
    {
        nlohmann::ordered_json answer{{"format", "counterpoint-check-1"},
                                      {"file", options_.file},
                                      {"holds", errors == 0U},
                                      {"errors", errors},
                                      {"warnings", findings.size() - errors},
                                      {"findings", ToJson(findings)}};
        out << runtime::JsonText(answer);
    }

    DeviceOptions options_;
    int granularity_{0}; ///< 0: not given.
};
} // namespace

std::unique_ptr<Command> MakeCheckCommand()
{
    return std::make_unique<CheckCommand>();
}
} // namespace counterpoint::tools
