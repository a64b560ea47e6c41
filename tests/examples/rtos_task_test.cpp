// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The device in a task: what it prints, twice, and what comes of a task above it.
#include "tests/hal/contract_test/program.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint
{
namespace
{

using hal::contract::ProgramRun;
using hal::contract::RunProgram;

TEST(RtosTask, ReleasesAndProducesBesideATaskThatTakesAllTheTime)
{
    Verifies(req::SRS_HAL_036);
    const ProgramRun run = RunProgram(RTOS_TASK, "");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.text, " 11 ms: SRDO 1 waiting, output off\n"
                        "101 ms: SRDO 1 released, output on\n"
                        "326 ms: SRDO 1 faulted, output off\n"
                        "451 ms: SRDO 1 released, output on\n"
                        "safety task: 499 cycles, 0 late, 69 interrupts in it\n"
                        "safety task preempted by another task: 0 times\n"
                        "other task: 70 rounds, preempted 500 times, 1 interrupts in it\n"
                        "watchdog alive\n"
                        "device running, pairs received by the other node: 20\n");
    EXPECT_EQ(RunProgram(RTOS_TASK, "").text, run.text);
}

TEST(RtosTask, TaskAboveItEndsInTheSafeState)
{
    Verifies(req::SRS_HAL_036);
    const ProgramRun run = RunProgram(RTOS_TASK, "above");
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.text, " 11 ms: SRDO 1 waiting, output off\n"
                        " 23 ms: SRDO 1 faulted, output off\n"
                        "safety task: 499 cycles, 96 late, 27 interrupts in it\n"
                        "safety task preempted by another task: 0 times\n"
                        "higher task: 24 rounds, preempted 0 times, 4 interrupts in it\n"
                        "watchdog tripped\n"
                        "device in its safe state, pairs received by the other node: 1\n");
}

} // namespace
} // namespace counterpoint
