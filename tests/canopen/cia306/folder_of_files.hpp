// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA306_FOLDER_OF_FILES_HPP
#define TESTS_CANOPEN_CIA306_FOLDER_OF_FILES_HPP

#include "canopen/cia306/text/text_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>

namespace counterpoint::cia306::test
{
/// Files in a folder that each process has for itself, and that is gone behind the test.
class FolderTest : public ::testing::Test
{
  protected:
    FolderTest() : folder_(std::filesystem::temp_directory_path() / ("tools_test_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(folder_);
    }
    ~FolderTest() override
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
        WriteTextFile(Path(name), text);
        return Path(name);
    }

  private:
    std::filesystem::path folder_;
};
} // namespace counterpoint::cia306::test

#endif // TESTS_CANOPEN_CIA306_FOLDER_OF_FILES_HPP
