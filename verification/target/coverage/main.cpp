// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The suite of cases and the devices of the bench, instrumented: what they reach on the target has to be what they
// reach on the host. [SRS_FW_010]
#include "verification/bench/items.hpp"
#include "verification/bench/self_tests.hpp"
#include "verification/target/conformance/suite.hpp"
#include "verification/target/coverage/profile.hpp"
#include "verification/target/target.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

extern "C" std::uint32_t TargetMain() noexcept
{
    using counterpoint::bench::BenchResult;
    constexpr std::uint32_t kSequences = 2000U;
    const std::uint32_t status = counterpoint::target::RunSuite(kSequences);
    const BenchResult items = counterpoint::bench::RunItems();
    const BenchResult self_tests = counterpoint::bench::MeasureSelfTests();
    const bool is_written = counterpoint::target::WriteProfile(counterpoint::target::Argument());
    const bool is_good =
        (status == 0U) && (items == BenchResult::kDone) && (self_tests == BenchResult::kDone) && is_written;
    counterpoint::target::Write(is_good ? "coverage: done\n" : "FAILURE: coverage\n");
    return is_good ? 0U : 1U;
}
