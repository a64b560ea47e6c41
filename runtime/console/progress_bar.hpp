// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_PROGRESS_BAR_HPP
#define RUNTIME_CONSOLE_PROGRESS_BAR_HPP

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

namespace counterpoint::runtime
{
/// Shows a bar on the terminal for work that takes longer than two seconds. Shows nothing when the stream is no
/// terminal. [SRS_SIM_350]
class ProgressBar
{
  public:
    /// @brief What tells the time.
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// @brief Begins now. `err` outlives the bar.
    ProgressBar(std::ostream& err, std::string title, Clock now = std::chrono::steady_clock::now);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// @brief `part`, from 0 to 1, is done.
    void Show(double part);

  private:
    std::ostream& err_;
    std::string title_;
    Clock now_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_;
    bool is_terminal_;
    bool is_shown_{false};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_PROGRESS_BAR_HPP
