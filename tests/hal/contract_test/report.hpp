// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_CONTRACT_TEST_REPORT_HPP
#define TESTS_HAL_CONTRACT_TEST_REPORT_HPP

#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::hal::contract
{

/// @brief The lines of a report that have this text in them.
[[nodiscard]] inline std::vector<std::string> LinesWith(const std::string& report, const std::string& text)
{
    std::vector<std::string> found;
    std::istringstream lines{report};
    for (std::string line; std::getline(lines, line);)
    {
        if (line.find(text) != std::string::npos)
        {
            found.push_back(line);
        }
    }
    return found;
}

/// @brief `part: check` of each broken line, in order.
[[nodiscard]] inline std::vector<std::string> NamesOfBroken(const std::string& report)
{
    std::vector<std::string> names;
    for (const std::string& line : LinesWith(report, ": broken: "))
    {
        names.push_back(line.substr(0U, line.find(": broken: ")));
    }
    return names;
}

} // namespace counterpoint::hal::contract

#endif
