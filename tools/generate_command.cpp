// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "canopen/generate/generate.hpp"
#include "runtime/console/json_text.hpp"
#include "tools/command_table.hpp"
#include "tools/device_findings.hpp"
#include "tools/device_options.hpp"

#include <filesystem>
#include <ostream>
#include <system_error>
#include <vector>

namespace counterpoint::tools
{
namespace
{
/// Makes the folder where only its last part is missing.
void RequireFolder(const std::string& folder)
{
    std::error_code error;
    const bool is_there = std::filesystem::is_directory(folder, error);
    const bool is_made = is_there || std::filesystem::create_directory(folder, error);
    if (!is_made)
    {
        throw cia306::InputError(folder, {},
                                 {"it is no folder and cannot be made" + (error ? " (" + error.message() + ")" : ""),
                                  "a folder, or a name in one"});
    }
}

/// Nothing but an older output is replaced: not FILE itself, and nobody's own source. [SRS_GEN_018]
void RequireOwnOrNone(const std::string& path)
{
    std::error_code error;
    const bool is_there = std::filesystem::exists(path, error) && std::filesystem::is_regular_file(path, error);
    const std::string text = is_there ? cia306::ReadTextFile(path) : "";
    if (!text.empty() && !generate::IsGenerated(text))
    {
        throw cia306::InputError(
            path, {},
            {"it is there and was not made by 'counterpoint generate'", "another --output, or that you remove it"});
    }
}

class GenerateCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options_.Describe(options);
        options.Add("--output", &folder_, "Folder of object_dictionary.hpp and .cpp (default: this one)")
            .Type("DIR")
            .Check(ProblemOfFileName);
        options.Add("--namespace", &name_space_, "Namespace of the code, a::b too (default: the name of FILE)")
            .Type("NAME")
            .Check(generate::ProblemOfNamespace);
        options.Add("--force", &is_forced_, "Write the files in spite of errors that 'counterpoint check' finds");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        return RunOnDevice(options_, streams, [&] { return Generate(streams); });
    }

  private:
    [[nodiscard]] ExitStatus Generate(const Streams& streams) const
    {
        const std::string text = cia306::ReadTextFile(options_.file);
        const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse(options_.file, text));
        const std::optional<std::uint8_t> node_id = options_.NodeId(device);
        std::vector<cia306::Finding> findings = FindingsOf(device, text, {node_id, std::nullopt});
        const bool is_refused = ErrorsIn(findings) != 0U && !is_forced_;
        generate::GeneratedCode code;
        if (!is_refused)
        {
            const std::string name = name_space_.empty() ? generate::NamespaceOf(options_.file) : name_space_;
            code = generate::Generate(device, text, {name, node_id});
            AddOthers(findings, code.warnings);
            Write(code);
        }
        if (options_.is_json)
        {
            PrintJson(code, findings, is_refused, streams.out);
        }
        else
        {
            for (const cia306::Finding& finding : findings)
            {
                streams.err << cia306::FormatFinding(options_.file, finding) << "\n";
            }
            Print(code, is_refused, streams);
        }
        return is_refused ? ExitStatus::kDoesNotHold : ExitStatus::kHolds;
    }

    [[nodiscard]] std::string PathOf(const char* const name) const
    {
        return folder_.empty() ? std::string(name) : (std::filesystem::path(folder_) / name).string();
    }

    /// Both or none. [SRS_GEN_170]
    void Write(const generate::GeneratedCode& code) const
    {
        if (!folder_.empty())
        {
            RequireFolder(folder_);
        }
        RequireOwnOrNone(PathOf(generate::kHeaderName));
        RequireOwnOrNone(PathOf(generate::kSourceName));
        cia306::WriteTextFiles(
            {{PathOf(generate::kHeaderName), code.header}, {PathOf(generate::kSourceName), code.source}});
    }

    void Print(const generate::GeneratedCode& code, const bool is_refused, const Streams& streams) const
    {
        if (is_refused)
        {
            streams.err << cia306::Printable(options_.file)
                        << ": error: nothing is written, expected a file without errors, or --force\n";
            return;
        }
        streams.out << cia306::Printable(PathOf(generate::kHeaderName)) << "\n"
                    << cia306::Printable(PathOf(generate::kSourceName)) << "\n"
                    << code.entry_count << " entries, " << code.variable_count << " variables of " << code.srdo_count
                    << " SRDOs, " << code.stored_bytes << " bytes of memory, " << code.constant_bytes
                    << " bytes of constants\n";
    }

    void PrintJson(const generate::GeneratedCode& code, const std::vector<cia306::Finding>& findings,
                   const bool is_refused, std::ostream& out) const
    {
        nlohmann::ordered_json answer{
            {"format", "counterpoint-generate-1"}, {"file", options_.file}, {"holds", !is_refused}};
        answer["written"] = nlohmann::ordered_json::array();
        if (!is_refused)
        {
            answer["written"] = {PathOf(generate::kHeaderName), PathOf(generate::kSourceName)};
            answer["entries"] = code.entry_count;
            answer["variables"] = code.variable_count;
            answer["srdos"] = code.srdo_count;
            answer["memory_bytes"] = code.stored_bytes;
            answer["constant_bytes"] = code.constant_bytes;
        }
        answer["findings"] = ToJson(findings);
        out << runtime::JsonText(answer);
    }

    DeviceOptions options_;
    std::string folder_;
    std::string name_space_;
    bool is_forced_{false};
};
} // namespace

std::unique_ptr<Command> MakeGenerateCommand()
{
    return std::make_unique<GenerateCommand>();
}
} // namespace counterpoint::tools
