// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/crew.hpp"

#include "verification/campaign/trap.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::campaign
{
namespace
{
constexpr std::uint64_t kPortion = 256U;
constexpr std::size_t kMostJobs = 1024U;
constexpr std::chrono::milliseconds kPause{50};
constexpr std::uint32_t kMostKills = 3U;
} // namespace

struct Crew::Board
{
    /// Indices of experiments; none where both are equal.
    struct Range
    {
        std::uint64_t begin;
        std::uint64_t end;
    };

    std::uint64_t next;
    std::uint64_t done;
    std::array<std::uint64_t, kMostJobs> current; ///< Of each process: index of the running experiment, plus 1.
    std::array<Range, kMostJobs> portion;         ///< Of each: what it tries now, and has not put.
    std::array<Range, kMostJobs> alone;           ///< Of each: what is tried by one process an experiment.
};

Crew::Crew(Runner& runner, const Space& space, Results& results, const std::uint32_t jobs)
    : runner_(runner), space_(space), results_(results), children_(std::min<std::size_t>(jobs, kMostJobs), 0)
{
    void* const place = mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED)
    {
        throw std::runtime_error("no memory to be shared");
    }
    board_ = static_cast<Board*>(place);
    board_->done = results.Size() - results.OpenCount();
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
    RequireSameAgain();
    // What a process had taken when it was killed is left for the next round.
    while (results_.OpenCount() != 0U)
    {
        board_->next = 0U;
        for (std::uint32_t job = 0U; job < children_.size(); ++job)
        {
            Begin(job);
        }
        for (bool is_busy = true; is_busy;)
        {
            std::this_thread::sleep_for(kPause);
            int status = 0;
            for (pid_t ended = waitpid(-1, &status, WNOHANG); ended > 0; ended = waitpid(-1, &status, WNOHANG))
            {
                Bury(ended, status);
            }
            results_.RequireThere();
            is_busy = std::any_of(children_.begin(), children_.end(), [](const pid_t child) { return child > 0; });
            progress(__atomic_load_n(&board_->done, __ATOMIC_RELAXED));
        }
    }
}

/// Where it is not, no outcome means anything. [SRS_CMG_500]
void Crew::RequireSameAgain()
{
    const Trap trap;
    if (!runner_.IsSound())
    {
        throw NotWell("the run without fault does not come out the same when it is run again");
    }
}

void Crew::Begin(const std::uint32_t job)
{
    board_->current[job] = 0U;
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0)
    {
        throw std::runtime_error("no further process");
    }
    if (child == 0)
    {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() == parent)
        {
            Toil(job);
        }
        _exit(0);
    }
    children_[job] = child;
}

void Crew::Toil(const std::uint32_t job)
{
    const Trap trap;
    if (board_->alone[job].begin != board_->alone[job].end)
    {
        const std::uint64_t index = board_->alone[job].begin;
        Put(index, Try(job, index));
        return;
    }
    for (;;)
    {
        const std::uint64_t begin = __atomic_fetch_add(&board_->next, kPortion, __ATOMIC_RELAXED);
        const std::uint64_t end = std::min(begin + kPortion, results_.Size());
        if (begin >= results_.Size())
        {
            return;
        }
        board_->portion[job] = {begin, end};
        if (!TryPortion(job, begin, end))
        {
            return;
        }
        board_->portion[job] = {};
    }
}

/// Nothing is put before the process has turned out to be sound: an experiment before may have spoilt it. [SRS_CMG_500]
bool Crew::TryPortion(const std::uint32_t job, const std::uint64_t begin, const std::uint64_t end)
{
    std::array<Outcome, kPortion> outcomes{};
    for (std::uint64_t index = NextOpen(begin, end); index < end; index = NextOpen(index + 1U, end))
    {
        outcomes.at(index - begin) = Try(job, index);
    }
    if (!runner_.IsSound())
    {
        return false;
    }
    for (std::uint64_t index = NextOpen(begin, end); index < end; index = NextOpen(index + 1U, end))
    {
        Put(index, outcomes.at(index - begin));
    }
    return true;
}

Outcome Crew::Try(const std::uint32_t job, const std::uint64_t index)
{
    __atomic_store_n(&board_->current[job], index + 1U, __ATOMIC_RELEASE);
    const Outcome outcome = runner_.Run(space_.At(results_.NumberAt(index)));
    __atomic_store_n(&board_->current[job], std::uint64_t{0U}, __ATOMIC_RELEASE);
    return outcome;
}

void Crew::Put(const std::uint64_t index, const Outcome& outcome)
{
    results_.Put(index, outcome);
    __atomic_fetch_add(&board_->done, std::uint64_t{1U}, __ATOMIC_RELAXED);
}

/// The first one from `begin` on that has no outcome, or `end`.
std::uint64_t Crew::NextOpen(const std::uint64_t begin, const std::uint64_t end) const
{
    std::uint64_t index = begin;
    while (index < end && results_.At(index).result != Class::kOpen)
    {
        ++index;
    }
    return index;
}

void Crew::Bury(const pid_t child, const int status)
{
    const auto place = std::find(children_.begin(), children_.end(), child);
    if (place == children_.end())
    {
        return;
    }
    const auto job = static_cast<std::uint32_t>(place - children_.begin());
    *place = 0;
    const std::uint64_t current = __atomic_load_n(&board_->current[job], __ATOMIC_ACQUIRE);
    const bool was_alone = board_->alone[job].begin != board_->alone[job].end;
    if (current != 0U && IsEndFromOutside(status))
    {
        CountKill(current - 1U, status);
    }
    else if (current != 0U && was_alone)
    {
        // It was ended by its experiment: on a device, an exception.
        Put(current - 1U, Outcome{Class::kSafeOther, Detector::kException, 0U, 0U, runner_.ExceptionUs()});
    }
    else
    {
        // It put what it tried, or its portion is tried one by one.
    }
    if (HasMore(job, status))
    {
        Begin(job);
    }
}

/// What a process leaves that was ended from outside is open, as nobody knows what would have come: the next round has
/// it. A portion behind which a process ended otherwise, or was not sound, is tried by one process an experiment.
/// [SRS_CMG_170, SRS_CMG_500]
bool Crew::HasMore(const std::uint32_t job, const int status)
{
    Board::Range& portion = board_->portion[job];
    Board::Range& alone = board_->alone[job];
    const bool is_from_outside = IsEndFromOutside(status);
    const bool has_left = portion.begin != portion.end;
    if (has_left && !is_from_outside)
    {
        alone = portion;
    }
    portion = {};
    alone.begin = NextOpen(alone.begin, alone.end);
    return is_from_outside || has_left || alone.begin != alone.end;
}

/// The experiment is open, and comes again: at once where it is tried alone, else in the next round.
void Crew::CountKill(const std::uint64_t index, const int status)
{
    if (++kills_[index] == kMostKills)
    {
        throw std::runtime_error(
            "experiment " + std::to_string(results_.NumberAt(index)) + ": its process was ended " +
            std::to_string(kMostKills) + " times from outside (signal " + std::to_string(WTERMSIG(status)) +
            "), expected that it may run until its end; what was tried stays in the file of --out");
    }
}
} // namespace counterpoint::campaign
