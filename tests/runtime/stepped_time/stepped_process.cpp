// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/stepped_time/stepped_process.hpp"

#include "tests/runtime/stepped_time/stepped_time.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::tools::test
{
std::uint64_t NowNs()
{
    return SteppedTime::Get().NowNs();
}

void SleepMs(const int ms)
{
    constexpr std::uint64_t kNsPerMs = 1000000U;
    SteppedTime::Get().Sleep(static_cast<std::uint64_t>(ms) * kNsPerMs);
}

SteppedProcess::SteppedProcess(std::vector<std::string> words, const std::string& errors)
{
    std::vector<char*> pointers;
    for (std::string& word : words)
    {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    std::array<int, 2U> in{};
    std::array<int, 2U> out{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0)
    {
        std::abort();
    }
    const SteppedTime::Share share = SteppedTime::Get().Open();
    process_ = ::fork();
    if (process_ == 0)
    {
        SteppedTime::Enter(share);
        ::dup2(in[0], STDIN_FILENO);
        ::dup2(out[1], STDOUT_FILENO);
        const int file = errors.empty() ? STDERR_FILENO : ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(file, STDERR_FILENO);
        ::execv(pointers.front(), pointers.data());
        ::_exit(127);
    }
    SteppedTime::Get().Join(process_, share);
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
}

SteppedProcess::~SteppedProcess()
{
    if (process_ > 0)
    {
        Signal(SIGKILL);
        Signal(SIGCONT);
        static_cast<void>(End());
    }
    ::close(input_);
    ::close(output_);
}

void SteppedProcess::Type(const std::string& order)
{
    const std::string line = order + "\n";
    if (::write(input_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    {
        std::abort();
    }
}

void SteppedProcess::Signal(const int number) const
{
    ::kill(process_, number);
}

std::optional<std::string> SteppedProcess::Read(const std::uint64_t until_ns)
{
    std::array<char, 4096U> bytes{};
    const ssize_t count = SteppedTime::Get().Wait(output_, until_ns) ? ::read(output_, bytes.data(), bytes.size()) : 0;
    return (count > 0) ? std::optional(std::string(bytes.data(), static_cast<std::size_t>(count))) : std::nullopt;
}

std::string SteppedProcess::ReadAll()
{
    std::string all;
    while (const std::optional<std::string> some = Read(std::numeric_limits<std::uint64_t>::max()))
    {
        all += *some;
    }
    return all;
}

int SteppedProcess::End()
{
    int status = 0;
    ::waitpid(process_, &status, 0);
    SteppedTime::Get().Leave(process_);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
} // namespace counterpoint::tools::test
