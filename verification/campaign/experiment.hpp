// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_EXPERIMENT_HPP
#define VERIFICATION_CAMPAIGN_EXPERIMENT_HPP

#include "verification/campaign/device.hpp"
#include "verification/campaign/plan.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::campaign
{
/// A bit of the device's memory.
struct Bit
{
    std::size_t place{0U};  ///< In Device::Places().
    std::size_t offset{0U}; ///< In the region.
    std::uint8_t bit{0U};
};

constexpr std::size_t kNoCpu = ~std::size_t{0U};

/// One fault: where, when and how.
struct Experiment
{
    Part part{Part::kKernel};
    FaultKind kind{FaultKind::kFlip};
    std::size_t place{0U};  ///< In Device::Places().
    std::size_t offset{0U}; ///< In the region.
    std::uint8_t bit{0U};
    std::size_t cycle{0U}; ///< The first one that can be otherwise.
    Phase phase{Phase::kBeforeFrames};
    Bit second{};              ///< Of Part::kBothChannels, in channel B.
    std::size_t subject{0U};   ///< What is not memory: the frame, pair, call, step, counter or input.
    std::uint32_t variant{0U}; ///< How much, how long, which: by the kind.
    std::size_t cpu{kNoCpu};   ///< Of two, the one of which a call, step, command or cycle is hit. [SRS_CMG_130]
};

/// @brief Whether a part is bits of memory.
[[nodiscard]] constexpr bool IsMemory(const Part part) noexcept
{
    return static_cast<std::size_t>(part) < kMemoryPartCount || part == Part::kBothChannels;
}

/// @brief Whether a bit of memory is forced again at each phase.
[[nodiscard]] constexpr bool IsStuck(const FaultKind kind) noexcept
{
    return kind == FaultKind::kStuckAt0 || kind == FaultKind::kStuckAt1;
}

/// @brief Whether each of two CPUs has these of its own, and a plan of two tries those of each.
[[nodiscard]] constexpr bool IsOfEachCpu(const Part part) noexcept
{
    return part == Part::kKernelCalls || part == Part::kSteps || part == Part::kCycle || part == Part::kCommands;
}
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_EXPERIMENT_HPP
