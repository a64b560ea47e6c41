// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The tests of the safety rooms on the target, instrumented. [SRS_FW_010]
#include <gtest/gtest.h>

#include "verification/target/coverage/profile.hpp"
#include "verification/target/target.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    const testing::Outcome outcome = testing::RunAllTests();
    const bool is_written = counterpoint::target::WriteProfile(counterpoint::target::Argument());
    counterpoint::target::Write("tests=");
    counterpoint::target::WriteNumber(outcome.tests);
    counterpoint::target::Write(" failures=");
    counterpoint::target::WriteNumber(outcome.failures);
    counterpoint::target::Write(is_written ? "\n" : " no profile\n");
    return ((outcome.failures == 0U) && (outcome.tests != 0U) && is_written) ? 0U : 1U;
}
