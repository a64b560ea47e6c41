// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace counterpoint::campaign
{
namespace
{
constexpr std::chrono::milliseconds kPatience{2000};
constexpr std::chrono::milliseconds kPause{500};
constexpr double kPercent = 100.0;
} // namespace

std::string ProgressText(const std::uint64_t done, const std::uint64_t total, const std::uint64_t at_begin,
                         const double seconds)
{
    const auto all = static_cast<double>(std::max<std::uint64_t>(total, 1U));
    const double rate = (seconds > 0.0) ? static_cast<double>(done - std::min(done, at_begin)) / seconds : 0.0;
    const double left = (rate > 0.0) ? static_cast<double>(total - std::min(total, done)) / rate : 0.0;
    char text[128] = {};
    std::snprintf(text, sizeof(text), "campaign %.1f %%, %.0f experiments a second, %.0f s left",
                  static_cast<double>(done) / all * kPercent, rate, left);
    return text;
}

Progress::Progress(std::ostream& err, const std::uint64_t total, const std::uint64_t at_begin, Clock clock)
    : err_(err), total_(total), at_begin_(at_begin), clock_(std::move(clock)), start_(clock_()), last_(start_),
      is_terminal_(&err == &std::cerr && isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
    if (is_shown_)
    {
        err_ << "\r\033[K" << std::flush;
    }
}

void Progress::Show(const std::uint64_t done)
{
    const auto now = clock_();
    if (!is_terminal_ || now - start_ < kPatience || now - last_ < kPause)
    {
        return;
    }
    last_ = now;
    is_shown_ = true;
    err_ << "\r\033[K" << ProgressText(done, total_, at_begin_, std::chrono::duration<double>(now - start_).count())
         << std::flush;
}
} // namespace counterpoint::campaign
