// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// generate_case FILE FOLDER NAMESPACE [NODE_ID]: what `counterpoint generate` does, for the build of these tests alone.
#include "canopen/generate/generate.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/text_file.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

int main(const int count, const char* const* const arguments)
{
    using namespace counterpoint;
    if (count < 4)
    {
        static_cast<void>(std::fputs("usage: generate_case FILE FOLDER NAMESPACE [NODE_ID]\n", stderr));
        return 2;
    }
    try
    {
        const std::string file = arguments[1];
        const std::filesystem::path folder = arguments[2];
        const std::string text = cia306::ReadTextFile(file);
        const cia306::Device device = cia306::ReadDevice(cia306::IniDocument::Parse(file, text));
        const auto node_id = count > 4 ? static_cast<std::uint8_t>(std::stoul(arguments[4])) : device.node_id;
        const generate::GeneratedCode code = generate::Generate(device, text, {arguments[3], node_id});
        std::filesystem::create_directories(folder);
        cia306::WriteTextFile((folder / generate::kHeaderName).string(), code.header);
        cia306::WriteTextFile((folder / generate::kSourceName).string(), code.source);
    }
    catch (const std::exception& error)
    {
        static_cast<void>(std::fprintf(stderr, "%s\n", error.what()));
        return 2;
    }
    return 0;
}
