// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/file_warnings.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/finding.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <set>

namespace counterpoint::tools
{

void TellFileWarnings(const std::vector<std::string>& files, std::ostream& err)
{
    std::set<std::string> told;
    for (const std::string& file : files)
    {
        if (!told.insert(file).second)
        {
            continue;
        }
        try
        {
            for (const cia306::Finding& warning : cia306::ReadDeviceFile(file).warnings)
            {
                err << cia306::FormatFinding(file, warning) << "\n";
            }
        }
        catch (const cia306::InputError&)
        {
        }
    }
}

} // namespace counterpoint::tools
