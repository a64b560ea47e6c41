// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "rtos_host.hpp"

#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

namespace rtos
{
namespace
{

constexpr std::uint64_t kTickUs = 1000U;
constexpr std::uint64_t kStepUs = 10U;

/// Ends a task in the middle of its endless loop.
struct TaskEnds
{
};

/// Each task has a thread of its own, but only the one that holds the baton runs: the order is the scheduler's alone.
struct Task
{
    TaskSetup setup{};
    std::uint64_t wakes_us{0U};
    std::uint32_t interrupts{0U};
    std::uint32_t preemptions{0U};
    std::thread thread{};
};

struct Scheduler
{
    std::mutex mutex{};
    std::condition_variable handed{};
    std::list<Task> tasks{};
    Task* running{nullptr}; ///< Null: the scheduler itself.
    bool is_ending{false};
    std::uint64_t now_us{0U};
    void (*interrupt)(std::uint64_t now_us){nullptr};
};

Scheduler& The()
{
    static Scheduler scheduler;
    return scheduler;
}

/// Lets the other side run, and comes back when it has ended its turn.
void Hand(Task* const to, Task* const back)
{
    Scheduler& all = The();
    std::unique_lock<std::mutex> lock{all.mutex};
    all.running = to;
    all.handed.notify_all();
    all.handed.wait(lock, [&] { return all.running == back; });
}

void Pass(const std::uint64_t us)
{
    The().now_us += us;
    if (The().interrupt != nullptr)
    {
        The().interrupt(The().now_us);
    }
}

Task* HighestReady()
{
    Task* highest = nullptr;
    for (Task& task : The().tasks)
    {
        const bool is_ready = task.wakes_us <= The().now_us;
        if (is_ready && ((highest == nullptr) || (task.setup.priority > highest->setup.priority)))
        {
            highest = &task;
        }
    }
    return highest;
}

void Yield(Task& self)
{
    Hand(nullptr, &self);
    if (The().is_ending)
    {
        throw TaskEnds{};
    }
}

void RunTask(Task& self)
{
    {
        std::unique_lock<std::mutex> lock{The().mutex};
        The().handed.wait(lock, [&] { return The().running == &self; });
    }
    try
    {
        if (!The().is_ending)
        {
            self.setup.entry(self.setup.argument);
        }
    }
    catch (const TaskEnds& /*end*/)
    {
    }
    std::lock_guard<std::mutex> lock{The().mutex};
    The().running = nullptr;
    The().handed.notify_all();
}

} // namespace

void CreateTask(const TaskSetup& setup)
{
    Task& task = The().tasks.emplace_back();
    task.setup = setup;
    task.thread = std::thread{[&task] { RunTask(task); }};
}

Tick TickCount()
{
    return static_cast<Tick>(The().now_us / kTickUs);
}

bool DelayUntil(Tick& last, const Tick period)
{
    Task& self = *The().running;
    last += period;
    const std::uint64_t wakes_us = last * kTickUs;
    const bool is_in_time = wakes_us > The().now_us;
    self.wakes_us = wakes_us;
    Yield(self);
    return is_in_time;
}

// No time goes by between both here, so no interrupt comes.
void EnterCritical()
{
}

void ExitCritical()
{
}

namespace host
{

void SetInterrupt(void (*const interrupt)(std::uint64_t now_us))
{
    The().interrupt = interrupt;
}

void Work(const std::uint32_t us)
{
    Task& self = *The().running;
    for (std::uint64_t done = 0U; done < us; done += kStepUs)
    {
        Pass(kStepUs);
        const Task* const next = HighestReady();
        if ((next != &self) && (next->setup.priority > self.setup.priority))
        {
            ++self.preemptions;
            Yield(self);
        }
    }
}

void Run(const std::uint64_t until_us)
{
    while (The().now_us < until_us)
    {
        Task* const next = HighestReady();
        if (next != nullptr)
        {
            Hand(next, nullptr);
        }
        else
        {
            Pass(kStepUs);
        }
    }
    The().is_ending = true;
    for (Task& task : The().tasks)
    {
        Hand(&task, nullptr);
        task.thread.join();
    }
}

void NoteInterrupt()
{
    if (The().running != nullptr)
    {
        ++The().running->interrupts;
    }
}

std::uint32_t InterruptsIn(const Priority priority)
{
    std::uint32_t count = 0U;
    for (const Task& task : The().tasks)
    {
        count += (task.setup.priority == priority) ? task.interrupts : 0U;
    }
    return count;
}

std::uint32_t PreemptionsOf(const Priority priority)
{
    std::uint32_t count = 0U;
    for (const Task& task : The().tasks)
    {
        count += (task.setup.priority == priority) ? task.preemptions : 0U;
    }
    return count;
}

} // namespace host
} // namespace rtos
