// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/generate.hpp"

#include "canopen/generate/names.hpp"
#include "canopen/generate/text.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <boost/crc.hpp>

namespace counterpoint::generate
{
namespace
{
constexpr std::string_view kOrigin = " Made by `counterpoint generate` from ";

std::string OriginOf(const std::string& path, const std::string_view text)
{
    boost::crc_32_type crc;
    crc.process_bytes(text.data(), text.size());
    const std::size_t folder = path.find_last_of('/');
    const std::string name = folder == std::string::npos ? path : path.substr(folder + 1U);
    return std::string(kOrigin) + CommentText(name) + " (CRC-32 " + cia306::Hex(crc.checksum(), 8) +
           "). Change the file, not this.";
}
} // namespace

bool IsGenerated(const std::string_view text) noexcept
{
    return text.substr(0U, 2U) == "//" && text.substr(2U, kOrigin.size()) == kOrigin;
}

GeneratedCode Generate(const cia306::Device& device, const std::string_view text, const GenerateOptions& options)
{
    GeneratedCode code;
    const Layout layout = LayOut(device, options, code.warnings);
    if (layout.entry_count == 0U)
    {
        throw cia306::InputError(device.file, {}, {"no object for a dictionary", "objects from 0x1000 on"});
    }
    const FileText file{layout, options.name_space, OriginOf(device.file, text), options.node_id};
    code.header = HeaderText(file);
    code.source = SourceText(file);
    code.entry_count = layout.entry_count;
    code.variable_count = layout.variable_count;
    code.srdo_count = layout.safety.Srdos().size();
    code.stored_bytes = layout.stored_bytes;
    code.constant_bytes = layout.constant_bytes;
    return code;
}
} // namespace counterpoint::generate
