// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Runs every item once. Under callgrind (--collect-atstart=no) each item leaves a dump with its label.
#include "verification/bench/items.hpp"
#include "verification/bench/self_tests.hpp"

#include <cstdio>

int main()
{
    using counterpoint::bench::BenchResult;
    BenchResult result = counterpoint::bench::RunItems();
    if (result == BenchResult::kDone)
    {
        result = counterpoint::bench::RunFullLoad();
    }
    if (result == BenchResult::kDone)
    {
        result = counterpoint::bench::MeasureSelfTests();
    }
    std::printf("bench: %s\n", counterpoint::bench::NameOf(result));
    return (result == BenchResult::kDone) ? 0 : 1;
}
