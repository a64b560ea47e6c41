// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_RTOS_TASK_RTOS_HPP
#define EXAMPLES_RTOS_TASK_RTOS_HPP

#include <cstdint>

/// All that the device wants of an RTOS. README.md says what to put behind each function; rtos_host.cpp stands in on a
/// host.
namespace rtos
{

/// Milliseconds, modular.
using Tick = std::uint32_t;

/// The greater number runs.
enum class Priority : std::uint8_t
{
    kOther = 1U,  ///< What has no safety requirements.
    kSafety = 9U, ///< The safety task alone has this one.
    kAbove = 10U, ///< For nobody; here to show what comes of it.
};

struct TaskSetup
{
    const char* name;
    Priority priority;
    void (*entry)(void* argument); ///< Never returns.
    void* argument;
};

/// @brief Before the scheduler runs.
void CreateTask(const TaskSetup& setup);

/// @brief The tick of now.
[[nodiscard]] Tick TickCount();
/// @brief Sleeps until `last + period`, and moves `last` there. False: that moment had passed already.
bool DelayUntil(Tick& last, Tick period);

/// @brief Between both, no interrupt of the CAN controller comes. Not nested.
void EnterCritical();
void ExitCritical();

} // namespace rtos

#endif
