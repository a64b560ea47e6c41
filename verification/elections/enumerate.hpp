// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_ENUMERATE_HPP
#define VERIFICATION_ELECTIONS_ENUMERATE_HPP

#include "verification/elections/series.hpp"

#include <cstddef>
#include <cstdint>
#include <future>
#include <vector>

namespace counterpoint::elections
{

constexpr std::size_t kLevels = 3U;

[[nodiscard]] constexpr std::size_t PowerOf(const std::size_t base, const std::size_t exponent)
{
    std::size_t power = 1U;
    for (std::size_t i = 0U; i < exponent; ++i)
    {
        power *= base;
    }
    return power;
}

/// @brief Digit `place` of `number` in a system of `base` digits.
[[nodiscard]] constexpr std::size_t Digit(const std::size_t number, const std::size_t base, const std::size_t place)
{
    return (number / PowerOf(base, place)) % base;
}

/// @brief The first `count` digits of `number` as priority levels.
[[nodiscard]] inline std::vector<std::uint8_t> LevelsOf(const std::size_t number, const std::size_t count)
{
    std::vector<std::uint8_t> levels{};
    for (std::size_t i = 0U; i < count; ++i)
    {
        levels.push_back(static_cast<std::uint8_t>(Digit(number, kLevels, i)));
    }
    return levels;
}

/// @brief `lose` for each frame from `first` to `end` - 1, and for each receiver if `losses` asks for it: with two
/// masters there is only one.
template <typename Lose>
void ForEachLoss(const Losses losses, const std::uint32_t first, const std::uint32_t end, const std::size_t count,
                 const Lose& lose)
{
    const std::size_t receivers = ((losses == Losses::kForEachToo) && (count > 2U)) ? count : 0U;
    for (std::uint32_t frame = first; (losses != Losses::kNone) && (frame < end); ++frame)
    {
        lose(Loss{frame, Loss::kEverybody});
        for (std::size_t receiver = 0U; receiver < receivers; ++receiver)
        {
            lose(Loss{frame, receiver});
        }
    }
}

/// @brief Two threads, each with the part of the work that it is told: run_part(part, parts) -> Tally.
template <typename RunPart> [[nodiscard]] Tally InParallel(const RunPart& run_part)
{
    constexpr std::size_t kThreads = 2U;
    auto other = std::async(std::launch::async, [&run_part] { return run_part(std::size_t{1U}, kThreads); });
    Tally tally = run_part(std::size_t{0U}, kThreads);
    tally.Add(other.get());
    return tally;
}

} // namespace counterpoint::elections

#endif
