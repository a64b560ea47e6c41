// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/srdo_edit.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/number.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/json_text.hpp"
#include "tools/command_table.hpp"
#include "tools/device_findings.hpp"
#include "tools/device_options.hpp"
#include "tools/srdo_options.hpp"
#include "tools/srdo_report.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace counterpoint::tools
{
namespace
{
/// What only adding takes, what removing takes too, and what both take.
constexpr std::array<const char*, 8U> kOptionsOfAdd{"--produce", "--consume", "--refresh",   "--sct",
                                                    "--srvt",    "--release", "--detection", "--safe-value"};
constexpr std::array<const char*, 2U> kOptionsOfChange{"--number", "-o,--output"};

std::string ProblemOfAction(const std::string& text)
{
    const bool is_action = text == "add" || text == "remove" || text == "list";
    return is_action ? "" : cia306::Quoted(text) + ", expected add, remove or list";
}

std::string ProblemOfImage(const std::string& text)
{
    return cia306::ParseTyped(text, ~std::uint64_t{0U}) ? "" : cia306::Quoted(text) + ", expected a number of 64 bits";
}

class SrdoCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        all_ = &options;
        options
            .Add("ACTION", &action_, "add: FILE gets one SRDO more, signed; remove: one less; list: those that it has")
            .Required()
            .Type("")
            .Words({"add", "remove", "list"})
            .Check(ProblemOfAction);
        device_options_.Describe(options);
        options.Add("--produce", &produced_, "The SRDO is sent: lengths of new objects, or objects of FILE")
            .Type("MAPPING")
            .Check(ProblemOfMapping);
        options.Add("--consume", &consumed_, "The SRDO is received: lengths of new objects, or objects of FILE")
            .Type("MAPPING")
            .Check(ProblemOfMapping)
            .Excludes("--produce");
        options.Add("--number", &number_, "Its number; of one to add the first that is free by default").Range(1, 64);
        srdos_.Describe(options);
        options.Add("--safe-value", &safe_value_, "Safe value, first mapped bit lowest (default: 0)")
            .Type("N")
            .Check(ProblemOfImage);
        options.Add("-o,--output", &output_, "Write a copy of FILE instead of FILE itself")
            .Type("COPY")
            .Check(ProblemOfFileName);
        options.Footer(
            "MAPPING is LENGTH, COUNTxLENGTH, NAME=LENGTH, or INDEX:SUB of an object of FILE, with\n"
            "/INDEX:SUB of its inverse object where FILE does not name it; several with commas between them, "
            "and @COB-ID.\nExamples: 2x8@0x109, Speed=i16@node5, 0x6004:00@0x10B");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        RequireFitting();
        return RunOnDevice(device_options_, streams,
                           [&] { return action_ == "list" ? List(streams) : Change(streams); });
    }

  private:
    template <std::size_t kCount>
    void RefuseAll(const std::array<const char*, kCount>& names, const char* const expected) const
    {
        for (const std::string name : names)
        {
            if (all_->IsGiven(name))
            {
                throw std::runtime_error(name.substr(name.rfind(',') + 1U) + " does not fit srdo " + action_ +
                                         ", expected " + expected);
            }
        }
    }

    /// [SRS_NEW_014]
    void RequireFitting() const
    {
        if (action_ != "add")
        {
            RefuseAll(kOptionsOfAdd, "srdo add");
        }
        if (action_ == "list")
        {
            RefuseAll(kOptionsOfChange, "srdo add or remove");
        }
        if (action_ == "add" && produced_.empty() && consumed_.empty())
        {
            throw std::runtime_error("--produce or --consume is missing, expected the mapping of the SRDO");
        }
        if (!produced_.empty() && all_->IsGiven("--safe-value"))
        {
            throw std::runtime_error("--safe-value fits no SRDO that is sent, expected --consume");
        }
        if (action_ == "remove" && number_ == 0)
        {
            throw std::runtime_error("--number is missing, expected that of the SRDO, 1 to 64");
        }
    }

    /// What cannot be read is told; `check` judges it. [SRS_NEW_490]
    [[nodiscard]] ExitStatus List(const Streams& streams) const
    {
        const cia306::Device device = cia306::ReadDeviceFile(device_options_.file);
        std::vector<cia306::Finding> warnings = device.warnings;
        const auto safety = cia306::ExtractSafety(device, device_options_.NodeId(device));
        for (const cia306::SrdoConfiguration& srdo : safety.srdos)
        {
            warnings.insert(warnings.end(), srdo.signature_problems.begin(), srdo.signature_problems.end());
            warnings.insert(warnings.end(), srdo.other_problems.begin(), srdo.other_problems.end());
        }
        for (cia306::Finding& warning : warnings)
        {
            warning.severity = cia306::Severity::kWarning;
        }
        Print(device, cia306::SortedByLine(std::move(warnings)), streams);
        return ExitStatus::kHolds;
    }

    [[nodiscard]] ExitStatus Change(const Streams& streams)
    {
        const std::string text = cia306::ReadTextFile(device_options_.file);
        const auto document = cia306::IniDocument::Parse(device_options_.file, text);
        const cia306::Device device = cia306::ReadDevice(document);
        const std::optional<std::uint8_t> node_id = device_options_.NodeId(device);
        const std::vector<cia306::Finding> before = FindingsOf(device, text, {node_id, {}});
        if (!cia306::ExtractSafety(device, node_id).srdos.empty())
        {
            RequireNoError(before);
        }
        const cia306::IniDocument changed =
            action_ == "remove" ? cia306::WithoutSrdo(document, static_cast<std::uint8_t>(number_), node_id)
                                : Added(document, device, node_id, streams);
        const std::vector<cia306::Finding> after = FindingsBeforeWriting(changed.Text(), node_id);
        RequireNoErrorAfter(after);
        cia306::WriteTextFile(Result(), changed.Text());
        std::vector<cia306::Finding> warnings = Brought(before, after);
        const cia306::Device written = cia306::ReadDevice(changed);
        const std::optional<cia306::Finding> another = SignedForAnother(written, node_id);
        if (another)
        {
            warnings.push_back(*another);
        }
        Print(written, warnings, streams);
        return ExitStatus::kHolds;
    }

    [[nodiscard]] cia306::IniDocument Added(const cia306::IniDocument& document, const cia306::Device& device,
                                            const std::optional<std::uint8_t> node_id, const Streams& streams)
    {
        Questions nobody(nullptr, streams.err);
        srdos_.Complete(nobody, !produced_.empty(), !consumed_.empty());
        return cia306::WithSrdo(document, Plan(device, node_id), node_id);
    }

    [[nodiscard]] cia306::SrdoPlan Plan(const cia306::Device& device, const std::optional<std::uint8_t> node_id) const
    {
        const std::optional<std::uint8_t> number =
            number_ == 0 ? cia306::FreeSrdoNumber(device) : std::optional(static_cast<std::uint8_t>(number_));
        if (!number)
        {
            throw cia306::InputError(device.file, {}, {"all 64 SRDOs are there", "a file with a free number"});
        }
        const bool is_producer = !produced_.empty();
        cia306::SrdoPlan plan = srdos_.PlanOf(*number, is_producer, is_producer ? produced_ : consumed_, node_id);
        const std::string image = safe_value_.empty() ? "0" : safe_value_;
        plan.safe_value = cia306::ParseTyped(image, ~std::uint64_t{0U}).value();
        return plan;
    }

    void RequireNoError(const std::vector<cia306::Finding>& findings) const
    {
        const cia306::Finding* const cause = CauseIn(findings);
        if (cause != nullptr)
        {
            cia306::RequireNone(device_options_.file, {*cause});
        }
    }

    /// The lines of a text that is not written help nobody. [SRS_NEW_012]
    void RequireNoErrorAfter(std::vector<cia306::Finding> findings) const
    {
        for (cia306::Finding& finding : findings)
        {
            finding.place = {};
            finding.text += "; nothing was written";
        }
        RequireNoError(findings);
    }

    /// The findings of the changed file that those of the file before do not have; lines have moved. [SRS_NEW_016]
    [[nodiscard]] static std::vector<cia306::Finding> Brought(const std::vector<cia306::Finding>& before,
                                                              const std::vector<cia306::Finding>& after)
    {
        std::vector<cia306::Finding> brought;
        std::copy_if(after.begin(), after.end(), std::back_inserter(brought),
                     [&before](const cia306::Finding& finding)
                     {
                         return std::none_of(before.begin(), before.end(), [&finding](const cia306::Finding& old)
                                             { return old.object == finding.object && old.text == finding.text; });
                     });
        return brought;
    }

    /// The file that is written.
    [[nodiscard]] const std::string& Result() const noexcept
    {
        return output_.empty() ? device_options_.file : output_;
    }

    void Print(const cia306::Device& device, const std::vector<cia306::Finding>& warnings, const Streams& streams) const
    {
        const cia306::SafetyConfiguration configuration = cia306::ExtractSafety(device, device_options_.NodeId(device));
        if (!device_options_.is_json)
        {
            PrintSrdos(device, configuration, streams.out);
            for (const cia306::Finding& warning : warnings)
            {
                streams.err << cia306::FormatFinding(Result(), warning) << "\n";
            }
            return;
        }
        nlohmann::ordered_json answer{
            {"format", "counterpoint-srdo-1"}, {"file", Result()}, {"srdos", SrdosToJson(device, configuration)}};
        answer["warnings"] = ToJson(warnings);
        streams.out << runtime::JsonText(answer);
    }

    const Options* all_{nullptr};
    std::string action_;
    DeviceOptions device_options_;
    std::string produced_;
    std::string consumed_;
    int number_{0}; ///< 0: not given.
    SrdoOptions srdos_;
    std::string safe_value_;
    std::string output_;
};
} // namespace

std::unique_ptr<Command> MakeSrdoCommand()
{
    return std::make_unique<SrdoCommand>();
}
} // namespace counterpoint::tools
