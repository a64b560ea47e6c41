// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_OUTPUT_FILES_HPP
#define RUNTIME_CONSOLE_OUTPUT_FILES_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The files that a command reads, and those that it will write: no output may be the same as another one or as a file
/// that is read. Ask before the work begins, so that long work does not end without its files.
class OutputFiles
{
  public:
    /// @brief The command reads this file; empty: none.
    void Read(const std::string& file);
    /// @brief The command will write this file; empty: none. Throws runtime::YamlError for a file that was named
    /// before, cia306::InputError for one that cannot be written.
    void Write(const std::string& option, const std::string& file);

  private:
    std::vector<std::filesystem::path> taken_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_OUTPUT_FILES_HPP
