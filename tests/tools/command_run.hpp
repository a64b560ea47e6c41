// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_TOOLS_COMMAND_RUN_HPP
#define TESTS_TOOLS_COMMAND_RUN_HPP

#include "canopen/cia306/text/text_file.hpp"
#include "tools/command_line/run.hpp"
#include "tools/command_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <unistd.h>
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

class CommandTest : public ::testing::Test
{
  protected:
    CommandTest() : folder_(std::filesystem::temp_directory_path() / ("tools_test_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(folder_);
    }
    ~CommandTest() override
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    [[nodiscard]] std::string Path(const std::string& name) const
    {
        return (folder_ / name).string();
    }
    /// Path of a new file with this text.
    [[nodiscard]] std::string File(const std::string& name, const std::string& text) const
    {
        cia306::WriteTextFile(Path(name), text);
        return Path(name);
    }

  private:
    std::filesystem::path folder_;
};
} // namespace counterpoint::tools::test

#endif // TESTS_TOOLS_COMMAND_RUN_HPP
