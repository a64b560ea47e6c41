// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_RANDOM_HPP
#define SIMULATOR_FAULTS_RANDOM_HPP

#include <cstdint>

namespace counterpoint::simulator
{
/// Random numbers by SplitMix64: the same seed gives the same numbers on every machine and with every library.
class Random
{
  public:
    explicit Random(const std::uint64_t seed) noexcept : state_(seed)
    {
    }

    /// @brief The next number, of 64 bits.
    [[nodiscard]] std::uint64_t Next() noexcept
    {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t value = state_;
        value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
        value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
        return value ^ (value >> 31U);
    }
    /// @brief From 0 to `end` - 1; `end` is not 0. The bias below 2^-32 does not matter here.
    [[nodiscard]] std::uint32_t Below(const std::uint32_t end) noexcept
    {
        return static_cast<std::uint32_t>(((Next() >> 32U) * end) >> 32U);
    }

  private:
    std::uint64_t state_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_RANDOM_HPP
