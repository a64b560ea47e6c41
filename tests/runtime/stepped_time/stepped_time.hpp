// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_STEPPED_TIME_STEPPED_TIME_HPP
#define TESTS_RUNTIME_STEPPED_TIME_STEPPED_TIME_HPP

#include "tests/runtime/stepped_time/page.hpp"

#include <cstdint>
#include <string>
#include <sys/types.h>
#include <vector>

namespace counterpoint::tools::test
{
/// The time of a test and of the processes that it starts. It stands still while any of them works, and goes straight
/// to the next instant that somebody waits for when all of them wait: what a test sees does not depend on how much else
/// the machine does. A stopped process (SIGSTOP) is left behind, as it is in real time.
///
/// "All wait" is seen in /proc: every thread of theirs, every other one of the test, and those of the kernel that bring
/// frames which it could not bring at once, sleeps and went to sleep no further time between two looks.
class SteppedTime
{
  public:
    static SteppedTime& Get();
    SteppedTime(const SteppedTime&) = delete;
    SteppedTime& operator=(const SteppedTime&) = delete;

    [[nodiscard]] std::uint64_t NowNs() const
    {
        return now_ns_;
    }
    /// @brief The share of a process that is about to be started.
    struct Share
    {
        TimePage* page;
        int page_file;
        int event_file;
    };
    [[nodiscard]] Share Open() const;
    /// @brief In the new process, before its program: the program will live in this time.
    static void Enter(const Share& share);
    void Join(pid_t process, const Share& share);
    void Leave(pid_t process);
    /// @brief Whether `file` can be read before `until_ns`; -1: only waits. Ends the test after minutes in which time
    /// could not go on.
    bool Wait(int file, std::uint64_t until_ns);
    void Sleep(std::uint64_t ns)
    {
        static_cast<void>(Wait(-1, now_ns_ + ns));
    }

  private:
    struct Process
    {
        pid_t id;
        Share share;
    };
    /// State and count of voluntary switches of all threads, one after the other; empty: one of them works.
    using Look = std::vector<std::uint64_t>;

    SteppedTime();
    ~SteppedTime() = default;
    [[nodiscard]] Look LookAtAll() const;
    [[nodiscard]] static bool AddThreadsOf(const std::string& process, Look& look);
    /// @brief The kernel's threads for what it puts off, as folders of /proc; none where they cannot be seen.
    [[nodiscard]] static std::vector<std::string> ThreadsOfTheKernel();
    void GoOn(std::uint64_t until_ns);

    std::uint64_t now_ns_;
    std::vector<std::string> kernel_{ThreadsOfTheKernel()};
    std::vector<Process> processes_{};
};
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_STEPPED_TIME_STEPPED_TIME_HPP
