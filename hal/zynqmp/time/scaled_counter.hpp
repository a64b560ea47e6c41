// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_TIME_SCALED_COUNTER_HPP
#define HAL_ZYNQMP_TIME_SCALED_COUNTER_HPP

#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// How often a counter of the hardware counts, and how many bits of it are used.
struct CounterRate
{
    std::uint32_t hertz; ///< More than 1 000 000, at most 2 000 000 000.
    std::uint32_t bits;  ///< 16 to 32.
};

/// Makes microseconds, modular over 32 bits, of the readings of a counter that counts at any rate and rolls over. Reads
/// must come before it has rolled over once more. [SRS_ZYN_055]
class ScaledCounter
{
  public:
    /// @brief From here on: `raw` is 0 us.
    void Start(const CounterRate& rate, std::uint32_t raw) noexcept;
    /// @brief The moment that belongs to a reading.
    [[nodiscard]] Instant Take(std::uint32_t raw) noexcept;
    /// @brief The counter begins at 0 again, with no time passed.
    void SetBack() noexcept
    {
        last_ = 0U;
    }

  private:
    std::uint64_t microseconds_{0U};    ///< In units of 2^-32 us; its upper half is the moment.
    std::uint32_t rest_{0U};            ///< In units of 2^-64 us: what is less than one of `microseconds_`.
    std::uint32_t each_count_{0U};      ///< What a count adds to `microseconds_`, at most 1 us less one unit.
    std::uint32_t each_count_rest_{0U}; ///< What it adds to `rest_`: without it a clock would drift by some 100 ppb.
    std::uint32_t last_{0U};
    std::uint32_t mask_{0U};
};

} // namespace counterpoint::zynqmp

#endif
