// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_RTOS_TASK_RTOS_HOST_HPP
#define EXAMPLES_RTOS_TASK_RTOS_HOST_HPP

#include "rtos.hpp"

#include <cstdint>

/// The stand-in for an RTOS: simulated time, one task at a time, the same order in each run. Time goes by only in Work
/// and while no task is ready; it brings interrupts, and a task of higher priority whose tick has come takes over.
namespace rtos::host
{

/// @brief Called whenever time has gone by, in the place of the interrupts of the board.
void SetInterrupt(void (*interrupt)(std::uint64_t now_us));
/// @brief The running task works for so long; it may be preempted in between.
void Work(std::uint32_t us);
/// @brief Runs the tasks until this moment, then ends them.
void Run(std::uint64_t until_us);
/// @brief For the interrupt: it did something. Counted for the task that was running.
void NoteInterrupt();
[[nodiscard]] std::uint32_t InterruptsIn(Priority priority);
/// @brief How often a task of this priority was preempted by another task.
[[nodiscard]] std::uint32_t PreemptionsOf(Priority priority);

} // namespace rtos::host

#endif
