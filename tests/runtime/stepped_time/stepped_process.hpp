// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_STEPPED_TIME_STEPPED_PROCESS_HPP
#define TESTS_RUNTIME_STEPPED_TIME_STEPPED_PROCESS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace counterpoint::tools::test
{
/// @brief The time of the test and its processes, which stands still while one of them works.
[[nodiscard]] std::uint64_t NowNs();
void SleepMs(int ms);

/// A program as a process of its own in the time of the test. Killed at the end if it still runs.
class SteppedProcess
{
  public:
    /// `errors`: file of its error output; without one it is the test's.
    explicit SteppedProcess(std::vector<std::string> words, const std::string& errors = "");
    ~SteppedProcess();
    SteppedProcess(const SteppedProcess&) = delete;
    SteppedProcess& operator=(const SteppedProcess&) = delete;

    void Type(const std::string& order);
    void Signal(int number) const;
    [[nodiscard]] pid_t Process() const
    {
        return process_;
    }
    /// @brief What it wrote, as soon as there is something; nothing until then, or it has closed its output.
    [[nodiscard]] std::optional<std::string> Read(std::uint64_t until_ns);
    /// @brief All that it writes until it closes its output.
    [[nodiscard]] std::string ReadAll();
    /// @brief Waits for its end: exit status; 128 + signal.
    int End();

  private:
    pid_t process_{-1};
    int input_{-1};
    int output_{-1};
};
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_STEPPED_TIME_STEPPED_PROCESS_HPP
