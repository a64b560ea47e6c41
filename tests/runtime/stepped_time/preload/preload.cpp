// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Loaded before the C library: the process lives in the time of a test. Its monotonic clocks stand still while it
// works; a waiting of its main thread ends with a descriptor or when the test has put the time forward. A timer of a
// descriptor is due by that time, too, never by the machine's.
#include "tests/runtime/stepped_time/page.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <limits>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/timerfd.h>
#include <unistd.h>

namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kNsPerSecond = 1000000000U;
constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kMostFiles = 64U;
constexpr std::size_t kSignalBytes = 8U;
constexpr std::size_t kMostTimers = 16U;

std::uint64_t NsOf(const timespec& time)
{
    return static_cast<std::uint64_t>(time.tv_sec) * kNsPerSecond + static_cast<std::uint64_t>(time.tv_nsec);
}

int RealWait(pollfd* const files, const std::size_t count, const timespec* const time, const sigset_t* const mask)
{
    timespec rest = (time == nullptr) ? timespec{} : *time; // The system writes what is left.
    return static_cast<int>(
        ::syscall(SYS_ppoll, files, count, (time == nullptr) ? nullptr : &rest, mask, kSignalBytes));
}

/// Of one descriptor, which can be read from then on.
struct Timer
{
    int file{-1};
    std::uint64_t due_ns{kNever};
};

/// The process's share of the time; without one everything is real.
class Time
{
  public:
    static Time& Get()
    {
        static Time time;
        return time;
    }
    [[nodiscard]] bool IsStepped() const
    {
        return page_ != nullptr;
    }
    [[nodiscard]] std::uint64_t NowNs() const
    {
        return page_->now_ns.load();
    }
    int Wait(pollfd* files, std::size_t count, std::uint64_t until_ns, const sigset_t* mask);
    /// False: in real time. A thread beside the main one sleeps so, and its test takes it for one that waits.
    bool Sleep(const std::uint64_t ns)
    {
        if (IsStepped() && event_ < 0)
        {
            page_->now_ns += ns;
            return true;
        }
        const bool is_stepped = IsStepped() && ::syscall(SYS_gettid) == ::getpid();
        return is_stepped && Wait(nullptr, 0U, NowNs() + ns, nullptr) >= 0;
    }
    /// Of the main thread. False: no timer, or more of them than there is room for.
    bool SetTimer(int file, std::uint64_t due_ns);

  private:
    Time()
    {
        const char* const text = std::getenv(kTimeVariable);
        if (text != nullptr && std::strcmp(text, "alone") == 0)
        {
            timespec now{};
            static_cast<void>(::syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &now));
            own_.now_ns = NsOf(now);
            page_ = &own_;
        }
        else if (text != nullptr)
        {
            char* rest = nullptr;
            const auto file = static_cast<int>(std::strtol(text, &rest, 10));
            event_ = static_cast<int>(std::strtol(rest, nullptr, 10));
            void* const memory = ::mmap(nullptr, sizeof(TimePage), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
            page_ = (memory == MAP_FAILED) ? nullptr : static_cast<TimePage*>(memory);
        }
        else
        {
            // Real time.
        }
    }

    [[nodiscard]] std::uint64_t NextTimerNs() const;
    void LetTimersRunOut();

    TimePage own_{};
    TimePage* page_{nullptr};
    int event_{-1};
    std::array<Timer, kMostTimers> timers_{};
};

/// The system's own timer holds what it is to show: nothing, or an instant that has passed.
bool SetRealTimer(const int file, const bool has_run_out)
{
    const itimerspec when{{}, {0, has_run_out ? 1L : 0L}};
    const bool is_set = ::syscall(SYS_timerfd_settime, file, TFD_TIMER_ABSTIME, &when, nullptr) == 0;
    pollfd place{file, POLLIN, 0};
    return is_set && (!has_run_out || RealWait(&place, 1U, nullptr, nullptr) == 1);
}

bool Time::SetTimer(const int file, const std::uint64_t due_ns)
{
    const auto of_file = [file](const Timer& each) { return each.file == file; };
    auto place = std::find_if(timers_.begin(), timers_.end(), of_file);
    if (place == timers_.end())
    {
        place = std::find_if(timers_.begin(), timers_.end(), [](const Timer& each) { return each.file < 0; });
    }
    const bool is_set = place != timers_.end() && SetRealTimer(file, false);
    if (is_set)
    {
        *place = {file, due_ns};
        LetTimersRunOut();
    }
    return is_set;
}

std::uint64_t Time::NextTimerNs() const
{
    const auto is_sooner = [](const Timer& a, const Timer& b) { return a.due_ns < b.due_ns; };
    return std::min_element(timers_.begin(), timers_.end(), is_sooner)->due_ns;
}

void Time::LetTimersRunOut()
{
    for (Timer& timer : timers_)
    {
        if (timer.due_ns <= NowNs())
        {
            // Closed meanwhile: nobody waits for it.
            static_cast<void>(SetRealTimer(timer.file, true));
            timer.due_ns = kNever;
        }
    }
}

int Time::Wait(pollfd* const files, const std::size_t count, const std::uint64_t until_ns, const sigset_t* const mask)
{
    const timespec none{};
    std::array<pollfd, kMostFiles> all{};
    if (count + 1U > all.size())
    {
        std::abort();
    }
    std::copy(files, files + count, all.begin());
    all[count] = {event_, POLLIN, 0};
    LetTimersRunOut();
    int ready = RealWait(all.data(), count, &none, mask);
    while (ready == 0 && NowNs() < until_ns)
    {
        const std::uint64_t next_ns = std::min(until_ns, NextTimerNs());
        if (event_ < 0 && next_ns != kNever)
        {
            page_->now_ns = next_ns;
        }
        page_->wake_ns = next_ns;
        ready = RealWait(all.data(), count + 1U, (event_ < 0 && next_ns != kNever) ? &none : nullptr, mask);
        page_->wake_ns = TimePage::kRuns;
        if (ready > 0 && all[count].revents != 0)
        {
            std::uint64_t times = 0U;
            static_cast<void>(::read(event_, &times, sizeof(times)) < 0);
            --ready;
        }
        LetTimersRunOut();
        ready = (ready == 0) ? RealWait(all.data(), count, &none, mask) : ready;
    }
    std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), files);
    return ready;
}
} // namespace
} // namespace counterpoint::tools::test

using counterpoint::tools::test::NsOf;
using counterpoint::tools::test::RealWait;
using counterpoint::tools::test::Time;

extern "C"
{
    int clock_gettime(const clockid_t clock, timespec* const time) noexcept
    {
        if ((clock == CLOCK_MONOTONIC || clock == CLOCK_MONOTONIC_RAW) && Time::Get().IsStepped())
        {
            const std::uint64_t now_ns = Time::Get().NowNs();
            time->tv_sec = static_cast<time_t>(now_ns / counterpoint::tools::test::kNsPerSecond);
            time->tv_nsec = static_cast<long>(now_ns % counterpoint::tools::test::kNsPerSecond);
            return 0;
        }
        return static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
    }

    int ppoll(pollfd* const files, const nfds_t count, const timespec* const time, const sigset_t* const mask)
    {
        if (!Time::Get().IsStepped())
        {
            return RealWait(files, count, time, mask);
        }
        const std::uint64_t until_ns =
            (time == nullptr) ? counterpoint::tools::test::kNever : Time::Get().NowNs() + NsOf(*time);
        return Time::Get().Wait(files, count, until_ns, mask);
    }

    int poll(pollfd* const files, const nfds_t count, const int ms)
    {
        const timespec time{ms / 1000, static_cast<long>(ms % 1000) * 1000000L};
        return ppoll(files, count, (ms < 0) ? nullptr : &time, nullptr);
    }

    int nanosleep(const timespec* const time, timespec* const rest)
    {
        return Time::Get().Sleep(NsOf(*time)) ? 0 : static_cast<int>(::syscall(SYS_nanosleep, time, rest));
    }

    int clock_nanosleep(const clockid_t clock, const int flags, const timespec* const time, timespec* const rest)
    {
        const bool is_relative = (flags & TIMER_ABSTIME) == 0;
        if (is_relative && Time::Get().Sleep(NsOf(*time)))
        {
            return 0;
        }
        return (::syscall(SYS_clock_nanosleep, clock, flags, time, rest) == 0) ? 0 : errno;
    }

    int timerfd_settime(const int file, const int flags, const itimerspec* const when,
                        itimerspec* const before) noexcept
    {
        if (!Time::Get().IsStepped())
        {
            return static_cast<int>(::syscall(SYS_timerfd_settime, file, flags, when, before));
        }
        const std::uint64_t value_ns = NsOf(when->it_value);
        const std::uint64_t since_ns = ((flags & TFD_TIMER_ABSTIME) != 0) ? 0U : Time::Get().NowNs();
        const bool is_on = value_ns != 0U;
        const bool is_plain = NsOf(when->it_interval) == 0U && before == nullptr;
        const std::uint64_t due_ns = is_on ? since_ns + value_ns : counterpoint::tools::test::kNever;
        if (!is_plain || !Time::Get().SetTimer(file, due_ns))
        {
            std::abort(); // Repeated timers, or more of them, are not made here.
        }
        return 0;
    }

    // Stamps of the system are real time; a frame without one has the time of its reading, before which time stood
    // still.
    int setsockopt(const int socket, const int level, const int name, const void* const value,
                   const socklen_t bytes) noexcept
    {
        const bool is_stamp = level == SOL_SOCKET && (name == SO_TIMESTAMPNS || name == SO_TIMESTAMPING);
        return (is_stamp && Time::Get().IsStepped())
                   ? 0
                   : static_cast<int>(::syscall(SYS_setsockopt, socket, level, name, value, bytes));
    }
}
