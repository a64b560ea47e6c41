// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_METER_HPP
#define VERIFICATION_BENCH_METER_HPP

#include <cstdint>

/// Counts executed instructions between Begin and End. One implementation a platform: callgrind on the host, the cycle
/// counter of the emulated processor on the target.
namespace counterpoint::bench
{

/// What a sum of instructions belongs to.
struct MeterLabel
{
    const char* item;
    std::uint32_t srdo_count;
    std::uint32_t repetitions;
};

/// @brief Forgets what was counted.
void MeterReset() noexcept;
void MeterBegin() noexcept;
void MeterEnd() noexcept;
/// @brief Hands the sum since MeterReset out, under a label.
void MeterReport(const MeterLabel& label) noexcept;

} // namespace counterpoint::bench

#endif
