// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/output_files.hpp"

#include "canopen/cia306/text/text_file.hpp"
#include "runtime/yaml/document.hpp"

#include <algorithm>
#include <system_error>

namespace counterpoint::runtime
{
namespace
{
/// The same for every spelling of one path, and for every link to it, also where nothing is there yet; what cannot be
/// followed is refused where it is opened.
std::filesystem::path OneNameOf(const std::string& file)
{
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(cia306::TargetOf(file));
    const std::filesystem::path name = std::filesystem::weakly_canonical(absolute, error);
    return error ? absolute : name;
}
} // namespace

void OutputFiles::Read(const std::string& file)
{
    if (!file.empty())
    {
        taken_.push_back(OneNameOf(file));
    }
}

void OutputFiles::Write(const std::string& option, const std::string& file)
{
    if (!file.empty())
    {
        const std::filesystem::path path = OneNameOf(file);
        if (std::find(taken_.begin(), taken_.end(), path) != taken_.end())
        {
            throw runtime::YamlError(option, {}, runtime::Shown(file) + ", which is named already or read by the run",
                                     "a file of its own for each output");
        }
        taken_.push_back(path);
        cia306::RequireWritable(file);
    }
}
} // namespace counterpoint::runtime
