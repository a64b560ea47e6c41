// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Feeds arbitrary text to everything that a device file passes: read, extract, check, sign, write, read again.
// A refusal (InputError) is a right answer; everything else that goes wrong ends the process. [SRS_EDS_025]
#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace
{
using namespace counterpoint::cia306;

void Require(const bool holds)
{
    if (!holds)
    {
        std::abort();
    }
}

bool IsSame(const Entry& left, const Entry& right)
{
    const bool has_same_values =
        left.default_value.text == right.default_value.text && left.parameter_value.text == right.parameter_value.text;
    return has_same_values && left.name == right.name && left.data_type == right.data_type &&
           left.access == right.access && left.place == right.place && left.inverted_srad == right.inverted_srad;
}

void RequireSame(const Device& left, const Device& right)
{
    Require(left.objects.size() == right.objects.size() && left.node_id == right.node_id);
    Require(left.warnings.size() == right.warnings.size());
    for (const auto& [index, object] : left.objects)
    {
        const Object* const other = right.Find(index);
        Require(other != nullptr && other->entries.size() == object.entries.size());
        for (const auto& [sub, entry] : object.entries)
        {
            Require(IsSame(entry, other->entries.at(sub)));
        }
    }
}

void Sign(const IniDocument& document, const Device& device, const std::uint8_t node_id)
{
    try
    {
        const IniDocument once = WithSignatures(document, device, node_id);
        // Signing a signed file changes nothing.
        Require(WithSignatures(once, ReadDevice(once), node_id).Text() == once.Text());
    }
    catch (const InputError& error)
    {
        Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
}

void Run(const std::string_view text)
{
    const IniDocument document = IniDocument::Parse("fuzz.dcf", text);
    Require(document.Text() == text);
    const Device device = ReadDevice(document);
    RequireSame(device, ReadDevice(IniDocument::Parse("fuzz.dcf", document.Text())));
    for (const std::uint8_t granularity : {std::uint8_t{1U}, std::uint8_t{8U}})
    {
        for (const Finding& finding : CheckDevice(device, {std::uint8_t{5U}, granularity}))
        {
            Require(FormatFinding("fuzz.dcf", finding).find('\n') == std::string::npos);
        }
    }
    for (const SrdoConfiguration& srdo : ExtractSafety(device, std::nullopt).srdos)
    {
        const bool is_complete = srdo.signature_problems.empty();
        Require(!is_complete || CanonicalBytes(srdo).size() == 13U + 5U * srdo.mapping.size());
    }
    Sign(document, device, 5U);
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size)
{
    try
    {
        Run(std::string_view(reinterpret_cast<const char*>(data), size));
    }
    catch (const InputError& error)
    {
        Require(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
    return 0;
}
