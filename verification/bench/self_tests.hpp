// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_SELF_TESTS_HPP
#define VERIFICATION_BENCH_SELF_TESTS_HPP

#include "verification/bench/items.hpp"

namespace counterpoint::bench
{

/// @brief Measures a cycle of the self tests in the default slicing, by the kind of its slice. [SRS_STS_064]
[[nodiscard]] BenchResult MeasureSelfTests() noexcept;

} // namespace counterpoint::bench

#endif
