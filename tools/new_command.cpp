// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/new_device.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "tools/command_table.hpp"
#include "tools/device_findings.hpp"
#include "tools/new_answers.hpp"
#include "tools/srdo_report.hpp"

#include <ctime>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <unistd.h>

namespace counterpoint::tools
{
namespace
{
class NewCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options.Add("-o,--output", &output_, "The DCF to write").Required().Type("FILE").Check(ProblemOfFileName);
        answers_.Describe(options);
        options.Add("--force", &is_forced_, "Replace FILE where it is there already");
        options.Footer(
            "MAPPING is LENGTH, COUNTxLENGTH or NAME=LENGTH, several with commas between them, and @COB-ID.\n"
            "LENGTH is 8, 16, 24, 32, 40, 48, 56 or 64 bits, signed after an i. @node5 is the default COB-ID of "
            "node 5:\nnodes 1 to 32 send theirs, 33 to 64 receive it.\nExamples: 8, 2x8,i16, "
            "Speed=i16,Position=i32@0x109\n"
            "At a terminal it asks for what no option says.");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        RequireNew();
        Questions questions(::isatty(STDIN_FILENO) != 0 ? &std::cin : nullptr, streams.err);
        answers_.Complete(questions);
        cia306::DevicePlan plan = answers_.Plan();
        plan.file_name = std::filesystem::path(output_).filename().string();
        plan.created = std::time(nullptr);
        const cia306::IniDocument document = cia306::NewDevice(output_, plan);
        const cia306::Device device = cia306::ReadDevice(document);
        RequireNoFinding(document.Text());
        cia306::WriteTextFile(output_, document.Text());
        streams.out << cia306::Printable(output_) << ": node-ID " << static_cast<unsigned>(plan.node_id)
                    << ", signed, valid\n";
        PrintSrdos(device, cia306::ExtractSafety(device, plan.node_id), streams.out);
        return ExitStatus::kHolds;
    }

  private:
    /// [SRS_NEW_006]
    void RequireNew() const
    {
        std::error_code error;
        const bool is_there =
            std::filesystem::symlink_status(output_, error).type() != std::filesystem::file_type::not_found;
        if (is_there && !is_forced_)
        {
            throw cia306::InputError(output_, {}, {"the file is there already", "the name of a new one, or --force"});
        }
        cia306::RequireWritable(output_);
    }

    /// Answers that do not fit together are told as `check` would tell them of the file. [SRS_NEW_005]
    void RequireNoFinding(const std::string& text) const
    {
        const std::vector<cia306::Finding> findings = FindingsBeforeWriting(text, std::nullopt);
        if (!findings.empty())
        {
            const cia306::Finding* const cause = CauseIn(findings);
            const cia306::Finding& first = cause == nullptr ? findings.front() : *cause;
            const bool is_warning = first.severity == cia306::Severity::kWarning;
            cia306::RequireNone(output_,
                                {{cia306::Severity::kError,
                                  {},
                                  first.object,
                                  first.text + (is_warning ? " (a warning of check)" : "") + "; nothing was written"}});
        }
    }

    std::string output_;
    NewAnswers answers_;
    bool is_forced_{false};
};
} // namespace

std::unique_ptr<Command> MakeNewCommand()
{
    return std::make_unique<NewCommand>();
}
} // namespace counterpoint::tools
