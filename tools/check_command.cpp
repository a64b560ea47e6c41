// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/json_text.hpp"
#include "tools/command_table.hpp"
#include "tools/device_findings.hpp"
#include "tools/device_options.hpp"

#include <ostream>
#include <vector>

namespace counterpoint::tools
{
namespace
{
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
        const std::vector<cia306::Finding> findings = FindingsOf(device, text, check_options);
        const std::size_t errors = ErrorsIn(findings);
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
