// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/progress_bar.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace counterpoint::runtime
{
namespace
{
using Time = std::chrono::steady_clock::time_point;

/// Tells a time in milliseconds that the test sets.
class SetClock
{
  public:
    void Set(const int ms)
    {
        now_ = Time(std::chrono::milliseconds(ms));
    }
    [[nodiscard]] ProgressBar::Clock Clock() const
    {
        return [this] { return now_; };
    }

  private:
    Time now_{};
};

TEST(ProgressBarTest, IsALineOfATerminalFromTwoSecondsOnThatGoesAtTheEnd)
{
    Verifies(req::SRS_SIM_350);
    // Given a terminal as standard error
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(::grantpt(terminal) + ::unlockpt(terminal), 0);
    const int line = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
    const int before = ::dup(STDERR_FILENO);
    ASSERT_GE(::dup2(line, STDERR_FILENO), 0);
    SetClock clock;
    {
        // When it is shown before two seconds are over, then, and before and after a tenth of a second more
        ProgressBar bar(std::cerr, "sweeping", clock.Clock());
        clock.Set(1999);
        bar.Show(0.1);
        clock.Set(2000);
        bar.Show(0.25);
        clock.Set(2099);
        bar.Show(0.3);
        clock.Set(2100);
        bar.Show(1.5); // No more than everything.
    }
    {
        // And one that ends early
        clock.Set(0);
        ProgressBar quick(std::cerr, "quick", clock.Clock());
        clock.Set(1999);
        quick.Show(1.0);
    }
    ASSERT_GE(::dup2(before, STDERR_FILENO), 0);
    static_cast<void>(::close(line));
    static_cast<void>(::close(before));
    // Then each is a line; nobody has the terminal open, so that reading ends where they end
    std::string text;
    for (char byte = '\0'; ::read(terminal, &byte, 1U) == 1;)
    {
        text += byte;
    }
    static_cast<void>(::close(terminal));
    EXPECT_EQ(text, "\r\033[Ksweeping [##########..............................] 25 %"
                    "\r\033[Ksweeping [########################################] 100 %"
                    "\r\033[K");
}

TEST(ProgressBarTest, IsNothingElsewhere)
{
    Verifies(req::SRS_SIM_350);
    // Given a stream, and a standard error that is a file
    SetClock clock;
    std::ostringstream stream;
    const int file = ::open("/dev/null", O_WRONLY);
    const int before = ::dup(STDERR_FILENO);
    ASSERT_GE(::dup2(file, STDERR_FILENO), 0);
    std::ostringstream errors;
    std::streambuf* const own = std::cerr.rdbuf(errors.rdbuf());
    {
        ProgressBar of_stream(stream, "sweeping", clock.Clock());
        ProgressBar of_file(std::cerr, "sweeping", clock.Clock());
        clock.Set(60000);
        of_stream.Show(0.5);
        of_file.Show(0.5);
    }
    std::cerr.rdbuf(own);
    ASSERT_GE(::dup2(before, STDERR_FILENO), 0);
    static_cast<void>(::close(file));
    static_cast<void>(::close(before));
    EXPECT_EQ(stream.str(), "");
    EXPECT_EQ(errors.str(), "");
}
} // namespace
} // namespace counterpoint::runtime
