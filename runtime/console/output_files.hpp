// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_OUTPUT_FILES_HPP
#define RUNTIME_CONSOLE_OUTPUT_FILES_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The files that a command reads and those that it is about to write: no output may replace another or what is read.
/// Asked before the work: what takes long shall not end without its files, and no output stays alone.
class OutputFiles
{
  public:
    /// @brief The command reads it; empty: nothing.
    void Read(const std::string& file);
    /// @brief The command will write it; empty: nothing. Throws runtime::YamlError for a file that is named
    /// already, cia306::InputError for one that cannot be written.
    void Write(const std::string& option, const std::string& file);

  private:
    std::vector<std::filesystem::path> taken_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_OUTPUT_FILES_HPP
