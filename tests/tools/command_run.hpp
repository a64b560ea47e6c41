// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_TOOLS_COMMAND_RUN_HPP
#define TESTS_TOOLS_COMMAND_RUN_HPP

#include "canopen/cia306/text/text_file.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tools/command_line/run.hpp"
#include "tools/command_table.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

/// Commands in process, on files in a folder of their own.
namespace counterpoint::tools::test
{
struct Answer
{
    int status{0};
    std::string out;
    std::string err;
};

inline Answer RunCommand(const std::vector<std::string>& arguments)
{
    std::ostringstream out;
    std::ostringstream err;
    const ExitStatus status = RunCommandLine(arguments, CommandTable(), {out, err});
    return {static_cast<int>(status), out.str(), err.str()};
}

using CommandTest = cia306::test::FolderTest;
} // namespace counterpoint::tools::test

#endif // TESTS_TOOLS_COMMAND_RUN_HPP
