// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_STEPPED_TIME_PAGE_HPP
#define TESTS_RUNTIME_STEPPED_TIME_PAGE_HPP

#include <atomic>
#include <cstdint>

namespace counterpoint::tools::test
{
/// What a test and a process in its stepped time share.
struct TimePage
{
    static constexpr std::uint64_t kRuns = 0U;
    std::atomic<std::uint64_t> now_ns;  ///< Written by the test.
    std::atomic<std::uint64_t> wake_ns; ///< Written by the process: until when it waits; kRuns: it does not.
};

/// "PAGE EVENT", two descriptors that the process inherits: a file with its page, an eventfd that ends its waiting.
/// "alone": there is no test; each waiting takes no time but that of its own clock.
constexpr const char* kTimeVariable = "COUNTERPOINT_STEPPED_TIME";
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_STEPPED_TIME_PAGE_HPP
