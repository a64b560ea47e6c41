// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/managed/crew.hpp"

#include "verification/campaign/trap.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace counterpoint::campaign::managed
{
namespace
{
constexpr std::uint64_t kPortion = 16U;
constexpr std::size_t kMostJobs = 1024U;
constexpr std::chrono::milliseconds kPause{50};
constexpr rlim_t kMostSeconds = 120U; ///< Of a processor, for one experiment: it does not end.
constexpr rlim_t kMoreSeconds = 5U;   ///< Behind them the system would end it as somebody outside does.
constexpr int kMostTries = 3;

/// The copy of this process, which ends with its parent; 0: this is it.
[[nodiscard]] pid_t Copy()
{
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0)
    {
        throw std::runtime_error("no further process");
    }
    if (child == 0)
    {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
        {
            _exit(0);
        }
    }
    return child;
}
} // namespace

struct Crew::Board
{
    std::uint64_t next;
    std::uint64_t done;
};

Crew::Crew(Course& begin, const Space& space, const Reference& reference, Results& results, const std::uint32_t jobs)
    : course_(begin), space_(space), reference_(reference), results_(results),
      children_(std::min<std::size_t>(jobs, kMostJobs), 0)
{
    void* const place = mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED)
    {
        throw std::runtime_error("no memory to be shared");
    }
    board_ = static_cast<Board*>(place);
    board_->done = results.Size() - results.OpenCount();
    std::vector<std::pair<Nanoseconds, std::uint64_t>> instants;
    for (std::uint64_t index = 0U; index < results.Size(); ++index)
    {
        if (results.At(index).result == Class::kOpen)
        {
            instants.emplace_back(space.At(results.NumberAt(index)).at, index);
        }
    }
    std::sort(instants.begin(), instants.end());
    for (const auto& [at, index] : instants)
    {
        order_.push_back(index);
    }
}

Crew::~Crew()
{
    for (const pid_t child : children_)
    {
        if (child > 0)
        {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }
    munmap(board_, sizeof(Board));
}

void Crew::Work(const std::function<void(std::uint64_t)>& progress)
{
    // What a process had taken when it died is left for the next round.
    while (results_.OpenCount() != 0U)
    {
        board_->next = 0U;
        for (std::size_t job = 0U; job < children_.size(); ++job)
        {
            Begin(job);
        }
        for (bool is_busy = true; is_busy;)
        {
            std::this_thread::sleep_for(kPause);
            for (pid_t& child : children_)
            {
                child = (child > 0 && waitpid(child, nullptr, WNOHANG) == child) ? 0 : child;
            }
            results_.RequireThere();
            is_busy = std::any_of(children_.begin(), children_.end(), [](const pid_t child) { return child > 0; });
            progress(__atomic_load_n(&board_->done, __ATOMIC_RELAXED));
        }
    }
}

void Crew::Begin(const std::size_t job)
{
    const pid_t child = Copy();
    if (child == 0)
    {
        Toil();
        _exit(0);
    }
    children_[job] = child;
}

void Crew::Toil()
{
    for (;;)
    {
        const std::uint64_t begin = __atomic_fetch_add(&board_->next, kPortion, __ATOMIC_RELAXED);
        const std::uint64_t end = std::min<std::uint64_t>(begin + kPortion, order_.size());
        if (begin >= order_.size())
        {
            return;
        }
        for (std::uint64_t place = begin; place < end; ++place)
        {
            if (results_.At(order_[place]).result == Class::kOpen)
            {
                TryApart(order_[place]);
                __atomic_fetch_add(&board_->done, std::uint64_t{1U}, __ATOMIC_RELAXED);
            }
        }
    }
}

/// A copy that ends before it has put its outcome was ended by the fault. Where it seems to be somebody outside it is
/// tried again: a fault may make its program so big that the system ends it, each time. [SRS_CMG_171]
void Crew::TryApart(const std::uint64_t index)
{
    const Trial trial = space_.At(results_.NumberAt(index));
    course_.AdvanceTo(trial.at);
    bool is_again = true;
    for (int attempt = 0; attempt < kMostTries && is_again; ++attempt)
    {
        const pid_t child = Copy();
        if (child == 0)
        {
            const rlimit limit{kMostSeconds, kMostSeconds + kMoreSeconds};
            setrlimit(RLIMIT_CPU, &limit);
            results_.Put(index, course_.Try(trial, space_, reference_));
            _exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        const bool is_open = results_.At(index).result == Class::kOpen;
        is_again = is_open && IsEndFromOutside(status) && WTERMSIG(status) != SIGXCPU;
    }
    if (results_.At(index).result == Class::kOpen)
    {
        Outcome outcome{};
        outcome.result = Class::kSilent;
        outcome.detail = static_cast<std::uint8_t>(Wrong::kCrash);
        results_.Put(index, outcome);
    }
}
} // namespace counterpoint::campaign::managed
