// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/digest.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "runtime/console/json_text.hpp"
#include "tools/command_table.hpp"
#include "tools/device_findings.hpp"
#include "tools/device_options.hpp"

#include <algorithm>
#include <ostream>
#include <vector>

namespace counterpoint::tools
{
namespace
{
using cia306::SrdoConfiguration;

/// Bytes of the longest field and its spaces, so that the meanings stand in one column.
constexpr std::size_t kBytesColumn = 11U;
constexpr std::size_t kObjectColumn = 9U;

std::string SignatureName(const SrdoConfiguration& srdo)
{
    return cia306::ObjectName(cia306::kSignatureIndex, srdo.number);
}

void PrintFields(const std::vector<cia306::SignedField>& fields, std::ostream& out)
{
    for (const cia306::SignedField& field : fields)
    {
        std::string bytes = cia306::HexBytes(field.bytes);
        std::string object = field.object;
        bytes.resize(kBytesColumn, ' ');
        object.resize(kObjectColumn, ' ');
        out << "    " << bytes << "  " << object << "  " << field.meaning << "\n";
    }
    const std::vector<std::uint8_t> bytes = cia306::BytesOf(fields);
    out << "    " << bytes.size() << " bytes: " << cia306::HexBytes(bytes) << "\n";
}

void AddFields(const std::vector<cia306::SignedField>& fields, nlohmann::ordered_json& answer)
{
    answer["bytes"] = cia306::HexBytes(cia306::BytesOf(fields));
    answer["fields"] = nlohmann::ordered_json::array();
    for (const cia306::SignedField& field : fields)
    {
        answer["fields"].push_back(
            {{"object", field.object}, {"meaning", field.meaning}, {"bytes", cia306::HexBytes(field.bytes)}});
    }
}

nlohmann::ordered_json ToJson(const SrdoConfiguration& srdo, const bool is_verbose)
{
    const std::uint16_t signature = cia306::SignatureOf(srdo);
    nlohmann::ordered_json answer{{"srdo", srdo.number},
                                  {"object", SignatureName(srdo)},
                                  {"signature", cia306::Hex(signature, 4)},
                                  {"value", signature}};
    if (is_verbose)
    {
        AddFields(cia306::SignedFields(srdo), answer);
    }
    return answer;
}

nlohmann::ordered_json ToJson(const cia306::DigestRecord& digest, const bool is_verbose)
{
    const std::uint32_t value = cia306::DigestOf(digest.fields);
    nlohmann::ordered_json answer{
        {"object", cia306::DigestName()}, {"digest", cia306::Hex(value, 8)}, {"value", value}};
    if (is_verbose)
    {
        AddFields(digest.fields, answer);
    }
    return answer;
}

class SignCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options_.Describe(options);
        options
            .Add("--write", &output_,
                 "Write a copy of FILE with the signatures and the digest as ParameterValue of 13FFh and 5F04h")
            .Type("COPY")
            .Check(ProblemOfFileName);
        options.Add("--verbose", &is_verbose_,
                    "Print the bytes that go into each signature and the digest, field by field");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        return RunOnDevice(options_, streams, [&] { return Sign(streams); });
    }

  private:
    [[nodiscard]] ExitStatus Sign(const Streams& streams) const
    {
        const auto document = cia306::IniDocument::Parse(options_.file, cia306::ReadTextFile(options_.file));
        const cia306::Device device = cia306::ReadDevice(document);
        const std::optional<std::uint8_t> node_id = options_.NodeId(device);
        const cia306::SafetyConfiguration configuration = cia306::ExtractSafety(device, node_id);
        cia306::RequireNone(device.file, configuration.missing);
        for (const SrdoConfiguration& srdo : configuration.srdos)
        {
            cia306::RequireNone(device.file, srdo.signature_problems);
        }
        const cia306::DigestRecord digest = cia306::ExtractDigest(device, configuration, node_id);
        cia306::RequireNone(device.file, digest.problems);
        if (!output_.empty())
        {
            cia306::WriteTextFile(output_, cia306::WithSignatures(document, device, node_id).Text());
        }
        const std::vector<cia306::Finding> warnings = Warnings(node_id);
        if (options_.is_json)
        {
            nlohmann::ordered_json answer = Answer(configuration, digest, node_id);
            answer["warnings"] = tools::ToJson(warnings);
            streams.out << runtime::JsonText(answer);
            return ExitStatus::kHolds;
        }
        Print(configuration, digest, streams.out);
        for (const cia306::Finding& warning : warnings)
        {
            streams.err << cia306::FormatFinding(Result(), warning) << "\n";
        }
        return ExitStatus::kHolds;
    }

    /// The file that holds the signatures: the copy, where one is written.
    [[nodiscard]] const std::string& Result() const noexcept
    {
        return output_.empty() ? options_.file : output_;
    }

    /// What check warns of in that file; its errors are told as one warning. In a file that is yet to be signed the
    /// signatures are wrong: what is counted are those that stay when they are right. [SRS_CLI_037]
    [[nodiscard]] std::vector<cia306::Finding> Warnings(const std::optional<std::uint8_t> node_id) const
    {
        const std::string text = cia306::ReadTextFile(Result());
        const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse(Result(), text));
        std::vector<cia306::Finding> findings = FindingsOf(device, text, {node_id, std::nullopt});
        const std::size_t errors = output_.empty() ? ErrorsOnceSigned(text, device, node_id) : ErrorsIn(findings);
        findings.erase(std::remove_if(findings.begin(), findings.end(), [](const cia306::Finding& finding)
                                      { return finding.severity == cia306::Severity::kError; }),
                       findings.end());
        const std::optional<cia306::Finding> another = SignedForAnother(device, node_id);
        if (another && !output_.empty())
        {
            findings.push_back(*another);
        }
        if (errors != 0U)
        {
            findings.push_back({cia306::Severity::kWarning,
                                {},
                                "",
                                "check finds errors: " + std::to_string(errors) + ", expected none"});
        }
        return findings;
    }

    /// A file that has no place for its signatures is refused by --write in words of its own.
    [[nodiscard]] static std::size_t ErrorsOnceSigned(const std::string& text, const cia306::Device& device,
                                                      const std::optional<std::uint8_t> node_id)
    {
        try
        {
            const auto document = cia306::IniDocument::Parse(device.file, text);
            return ErrorsIn(FindingsBeforeWriting(cia306::WithSignatures(document, device, node_id).Text(), node_id));
        }
        catch (const cia306::InputError&)
        {
            return 0U;
        }
    }

    [[nodiscard]] nlohmann::ordered_json Answer(const cia306::SafetyConfiguration& configuration,
                                                const cia306::DigestRecord& digest,
                                                const std::optional<std::uint8_t> node_id) const
    {
        nlohmann::ordered_json answer{{"format", "counterpoint-sign-1"}, {"file", options_.file}, {"node_id", nullptr}};
        if (node_id)
        {
            answer["node_id"] = *node_id;
        }
        answer["srdos"] = nlohmann::ordered_json::array();
        for (const SrdoConfiguration& srdo : configuration.srdos)
        {
            answer["srdos"].push_back(ToJson(srdo, is_verbose_));
        }
        if (digest.is_present)
        {
            answer["digest"] = ToJson(digest, is_verbose_);
        }
        if (!output_.empty())
        {
            answer["written"] = output_;
        }
        return answer;
    }

    void Print(const cia306::SafetyConfiguration& configuration, const cia306::DigestRecord& digest,
               std::ostream& out) const
    {
        for (const SrdoConfiguration& srdo : configuration.srdos)
        {
            out << SignatureName(srdo) << " = " << cia306::Hex(cia306::SignatureOf(srdo), 4) << "\n";
            if (is_verbose_)
            {
                PrintFields(cia306::SignedFields(srdo), out);
            }
        }
        if (digest.is_present)
        {
            out << cia306::DigestName() << " = " << cia306::Hex(cia306::DigestOf(digest.fields), 8) << "\n";
            if (is_verbose_)
            {
                PrintFields(digest.fields, out);
            }
        }
    }

    DeviceOptions options_;
    std::string output_;
    bool is_verbose_{false};
};
} // namespace

std::unique_ptr<Command> MakeSignCommand()
{
    return std::make_unique<SignCommand>();
}
} // namespace counterpoint::tools
