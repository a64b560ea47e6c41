// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_RANDOM_HPP
#define VERIFICATION_DIFFERENTIAL_RANDOM_HPP

#include <cstdint>

namespace counterpoint::differential
{

/// PCG-XSH-RR with 64 bits of state: the same numbers on every machine.
class Random
{
  public:
    /// @brief Each (seed, stream) has a sequence of its own.
    void Start(std::uint32_t seed, std::uint32_t stream) noexcept
    {
        state_ = (static_cast<std::uint64_t>(seed) << 32U) ^ (static_cast<std::uint64_t>(stream) * 0x9E3779B97F4A7C15U);
        static_cast<void>(Next());
        static_cast<void>(Next());
    }

    [[nodiscard]] std::uint32_t Next() noexcept
    {
        const std::uint64_t old = state_;
        state_ = (old * 6364136223846793005U) + 1442695040888963407U;
        const std::uint32_t shifted = static_cast<std::uint32_t>((((old >> 18U) ^ old) >> 27U) & 0xFFFFFFFFU);
        const std::uint32_t turn = static_cast<std::uint32_t>(old >> 59U);
        return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
    }

    /// @brief 0 to `count` - 1; `count` is at least 1.
    [[nodiscard]] std::uint32_t Below(std::uint32_t count) noexcept
    {
        return static_cast<std::uint32_t>((static_cast<std::uint64_t>(Next()) * count) >> 32U);
    }

    [[nodiscard]] std::uint32_t Between(std::uint32_t least, std::uint32_t most) noexcept
    {
        return least + Below((most - least) + 1U);
    }

    /// @brief True `permille` times in 1000.
    [[nodiscard]] bool Chance(std::uint32_t permille) noexcept
    {
        return Below(1000U) < permille;
    }

    [[nodiscard]] std::uint64_t Mask() noexcept
    {
        const std::uint64_t high = Next();
        return (high << 32U) | Next();
    }

  private:
    std::uint64_t state_{0U};
};

} // namespace counterpoint::differential

#endif
