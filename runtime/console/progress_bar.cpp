// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/progress_bar.hpp"

#include <algorithm>
#include <iostream>
#include <ostream>
#include <unistd.h>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::chrono::milliseconds kPatience{2000};
constexpr std::chrono::milliseconds kPause{100};
constexpr int kWidth = 40;
} // namespace

ProgressBar::ProgressBar(std::ostream& err, std::string title, Clock now)
    : err_(err), title_(std::move(title)), now_(std::move(now)), start_(now_()), last_(start_),
      is_terminal_(&err == &std::cerr && isatty(STDERR_FILENO) == 1)
{
}

ProgressBar::~ProgressBar()
{
    if (is_shown_)
    {
        err_ << "\r\033[K" << std::flush;
    }
}

void ProgressBar::Show(const double part)
{
    const std::chrono::steady_clock::time_point now = now_();
    const bool is_time = now - start_ >= kPatience && now - last_ >= kPause;
    if (!is_terminal_ || !is_time)
    {
        return;
    }
    last_ = now;
    is_shown_ = true;
    const double bounded = std::clamp(part, 0.0, 1.0);
    const auto filled = static_cast<int>(bounded * kWidth);
    err_ << "\r\033[K" << title_ << " [" << std::string(static_cast<std::size_t>(filled), '#')
         << std::string(static_cast<std::size_t>(kWidth - filled), '.') << "] " << static_cast<int>(bounded * 100.0)
         << " %" << std::flush;
}
} // namespace counterpoint::runtime
