// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_SLICE_HPP
#define SAFETY_CORE_SELFTEST_SLICE_HPP

#include "hal/api/memory_access.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

/// What one slice of a test came to. Everything but kContinues and kPassed is a failure.
enum class SliceResult : std::uint8_t
{
    kInvalid = 0U,
    kContinues = 0x35U, ///< Nothing found; more slices follow in this pass.
    kPassed = 0x69U,    ///< Nothing found, and the pass is complete.
    kFailed = 1U,
};

/// Spans of memory in their order; the array outlives the test.
struct SpanList
{
    const hal::MemorySpan* spans;
    std::uint8_t count;
};

} // namespace counterpoint::selftest

#endif
