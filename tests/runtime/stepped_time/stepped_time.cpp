// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/stepped_time/stepped_time.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace counterpoint::tools::test
{
namespace
{
constexpr std::uint64_t kNsPerSecond = 1000000000U;
/// Real time in which the processes must come to wait.
constexpr std::uint64_t kPatienceNs = 300U * kNsPerSecond;

std::uint64_t RealNs()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<std::uint64_t>(time.tv_sec) * kNsPerSecond + static_cast<std::uint64_t>(time.tv_nsec);
}

bool IsReady(const int file, const long wait_ns)
{
    pollfd place{file, POLLIN, 0};
    const timespec time{0, wait_ns};
    return ::ppoll(&place, 1U, &time, nullptr) > 0;
}

/// What a file of /proc says; empty: it is gone.
std::string TextOf(const std::string& path)
{
    std::array<char, 4096U> text{};
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const ssize_t count = (file < 0) ? 0 : ::read(file, text.data(), text.size());
    static_cast<void>((file < 0) ? 0 : ::close(file));
    return std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
}

std::string After(const std::string& text, const std::string& key)
{
    const std::size_t place = text.find(key);
    return (place == std::string::npos) ? std::string() : text.substr(place + key.size());
}

/// 'S': sleeps; 'T': stopped; 'Z': ended.
char StateOf(const std::string& status)
{
    const std::string state = After(status, "\nState:\t");
    return state.empty() ? 'Z' : state.front();
}
} // namespace

SteppedTime& SteppedTime::Get()
{
    static SteppedTime time;
    return time;
}

SteppedTime::SteppedTime() : now_ns_(RealNs())
{
    // It lets the processes go on: not behind whatever else the machine does, where that is allowed.
    sched_param priority{};
    priority.sched_priority = 1;
    static_cast<void>(::sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &priority));
}

SteppedTime::Share SteppedTime::Open() const
{
    const int file = ::memfd_create("stepped_time", 0U);
    const int event = ::eventfd(0U, EFD_NONBLOCK);
    if (file < 0 || event < 0 || ::ftruncate(file, sizeof(TimePage)) != 0)
    {
        std::abort();
    }
    void* const memory = ::mmap(nullptr, sizeof(TimePage), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED)
    {
        std::abort();
    }
    auto* const page = static_cast<TimePage*>(memory);
    page->now_ns = now_ns_;
    return {page, file, event};
}

void SteppedTime::Enter(const Share& share)
{
    const std::string files = std::to_string(share.page_file) + " " + std::to_string(share.event_file);
    static_cast<void>(::setenv(kTimeVariable, files.c_str(), 1));
    static_cast<void>(::setenv("LD_PRELOAD", COUNTERPOINT_STEPPED_TIME_LIBRARY, 1));
}

void SteppedTime::Join(const pid_t process, const Share& share)
{
    static_cast<void>(::fcntl(share.page_file, F_SETFD, FD_CLOEXEC));
    static_cast<void>(::fcntl(share.event_file, F_SETFD, FD_CLOEXEC));
    processes_.push_back({process, share});
}

void SteppedTime::Leave(const pid_t process)
{
    const auto place = std::find_if(processes_.begin(), processes_.end(),
                                    [process](const Process& each) { return each.id == process; });
    if (place != processes_.end())
    {
        static_cast<void>(::munmap(place->share.page, sizeof(TimePage)));
        static_cast<void>(::close(place->share.page_file));
        static_cast<void>(::close(place->share.event_file));
        processes_.erase(place);
    }
}

bool SteppedTime::Wait(const int file, const std::uint64_t until_ns)
{
    constexpr long kSoonNs = 20000;
    std::uint64_t since_ns = RealNs();
    bool is_ready = IsReady(file, 0);
    while (!is_ready && now_ns_ < until_ns)
    {
        const Look first = LookAtAll();
        if (!first.empty() && first == LookAtAll())
        {
            is_ready = IsReady(file, 0); // All that they wrote is there now.
            if (!is_ready)
            {
                GoOn(until_ns);
                since_ns = RealNs();
            }
        }
        else
        {
            is_ready = IsReady(file, kSoonNs);
        }
        if (RealNs() - since_ns > kPatienceNs)
        {
            std::fprintf(stderr, "a process of the test has worked for %u s without waiting\n",
                         static_cast<unsigned>(kPatienceNs / kNsPerSecond));
            std::abort();
        }
    }
    return is_ready;
}

SteppedTime::Look SteppedTime::LookAtAll() const
{
    Look look{0U};
    for (const Process& process : processes_)
    {
        const std::string path = "/proc/" + std::to_string(process.id);
        const char state = StateOf(TextOf(path + "/status"));
        const bool is_there = state != 'T' && state != 'Z';
        if (is_there && (process.share.page->wake_ns == TimePage::kRuns || !AddThreadsOf(path, look)))
        {
            return {};
        }
    }
    for (const std::string& thread : kernel_)
    {
        if (!AddThreadsOf(thread, look))
        {
            return {};
        }
    }
    return AddThreadsOf("/proc/self", look) ? look : Look{};
}

std::vector<std::string> SteppedTime::ThreadsOfTheKernel()
{
    std::vector<std::string> found;
    DIR* const folder = ::opendir("/proc");
    for (const dirent* entry = (folder == nullptr) ? nullptr : ::readdir(folder); entry != nullptr;
         entry = ::readdir(folder))
    {
        const std::string path = std::string("/proc/") + entry->d_name;
        if (std::strtoul(entry->d_name, nullptr, 10) != 0U && TextOf(path + "/comm").rfind("ksoftirqd/", 0U) == 0U)
        {
            found.push_back(path);
        }
    }
    static_cast<void>((folder == nullptr) ? 0 : ::closedir(folder));
    return found;
}

bool SteppedTime::AddThreadsOf(const std::string& process, Look& look)
{
    const std::string own = (process == "/proc/self") ? std::to_string(::gettid()) : "";
    DIR* const folder = ::opendir((process + "/task").c_str());
    bool sleeps = folder != nullptr;
    for (const dirent* entry = sleeps ? ::readdir(folder) : nullptr; sleeps && entry != nullptr;
         entry = ::readdir(folder))
    {
        if (entry->d_name[0] != '.' && own != entry->d_name)
        {
            const std::string status = TextOf(process + "/task/" + entry->d_name + "/status");
            sleeps = StateOf(status) == 'S';
            look.push_back(std::strtoull(After(status, "\nvoluntary_ctxt_switches:\t").c_str(), nullptr, 10));
        }
    }
    static_cast<void>((folder == nullptr) ? 0 : ::closedir(folder));
    return sleeps;
}

void SteppedTime::GoOn(const std::uint64_t until_ns)
{
    std::uint64_t next_ns = until_ns;
    for (const Process& process : processes_)
    {
        const std::uint64_t wake_ns = process.share.page->wake_ns;
        // A stopped one waits for an instant that has passed.
        next_ns = (wake_ns > now_ns_) ? std::min(next_ns, wake_ns) : next_ns;
    }
    now_ns_ = next_ns;
    for (const Process& process : processes_)
    {
        process.share.page->now_ns = now_ns_;
    }
    for (const Process& process : processes_)
    {
        const std::uint64_t once = 1U;
        if (process.share.page->wake_ns <= now_ns_)
        {
            static_cast<void>(::write(process.share.event_file, &once, sizeof(once)) < 0);
        }
    }
}
} // namespace counterpoint::tools::test
