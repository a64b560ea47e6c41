// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_PROGRESS_BAR_HPP
#define RUNTIME_CONSOLE_PROGRESS_BAR_HPP

#include <chrono>
#include <iosfwd>
#include <string>

namespace counterpoint::runtime
{
/// A bar on the terminal for what takes longer than two seconds; silent when the errors do not go to a terminal.
class ProgressBar
{
  public:
    ProgressBar(std::ostream& err, std::string title);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// @brief `part` of 0 to 1 is done.
    void Show(double part);

  private:
    std::ostream& err_;
    std::string title_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_;
    bool is_terminal_;
    bool is_shown_{false};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_PROGRESS_BAR_HPP
