// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_ITEMS_HPP
#define VERIFICATION_BENCH_ITEMS_HPP

#include <cstdint>

namespace counterpoint::bench
{

/// What went wrong first; nothing was measured then that counts.
enum class BenchResult : std::uint8_t
{
    kInvalid = 0U,
    kDone = 0x69U,
    kNotStarted = 1U,  ///< A device was refused its configuration.
    kNotReleased = 2U, ///< A consumer that should be released is not, so that a cheap path was measured.
    kNotSent = 3U,
    kCheckFailed = 4U,
    kFaulted = 5U, ///< A device met a fault while it was measured.
};

/// @brief Measures every item for 1, 8 and 64 SRDOs of two objects of 32 bits, and for 64 SRDOs of other mappings, and
/// reports it by MeterReport.
[[nodiscard]] BenchResult RunItems() noexcept;
/// @brief One second of back-to-back pairs at 1 Mbit/s for 64 consumers in a cycle of 1 ms.
[[nodiscard]] BenchResult RunFullLoad() noexcept;
[[nodiscard]] const char* NameOf(BenchResult result) noexcept;

} // namespace counterpoint::bench

#endif
