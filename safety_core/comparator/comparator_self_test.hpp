// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_COMPARATOR_COMPARATOR_SELF_TEST_HPP
#define SAFETY_CORE_COMPARATOR_COMPARATOR_SELF_TEST_HPP

#include "safety_core/comparator/comparator.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/contract/limits.hpp"

#include <cstdint>

namespace counterpoint
{

/// Finds a comparator that is blind: by two voices, and two frames, that differ in one bit of one member alone, another
/// member in each cycle of a round, another bit in each round. [SRS_CMP_009, SRS_CMP_012, SRS_CMP_210,
/// SRS_CMP_211]
///
/// t    0                     test interval
///      |------ wait ------|0 1 2 ... 14|      The first wait counts from the first cycle, each other one from the
///      first
///                         |------ wait ------|0 1 2 ... 14|     test before it: however late the calls are,
///                         |<---- test interval ----->|          no member waits for longer than the interval.
class ComparatorSelfTest
{
  public:
    /// @brief How long a round takes with every call as late as allowed: Kernel::Start refuses a shorter interval.
    [[nodiscard]] static std::uint32_t LongestRoundUs(const DeviceConfig& config) noexcept
    {
        return kComparatorTests * (config.cycle_us + config.cycle_tolerance_us);
    }
    /// @brief Begins with a wait. Kernel::Start has made sure that a round fits into the test interval.
    void Restart(const DeviceConfig& config) noexcept
    {
        wait_us_ = config.test_interval_us - LongestRoundUs(config);
        is_timed_ = false;
        number_ = kComparatorTests;
        slots_ = config.srdo_count;
    }
    /// @brief Once a cycle: whether a test has to be run now. The time counts from the first call on.
    [[nodiscard]] bool TakeTurn(Instant now) noexcept;
    /// @brief One test. kComparator if the difference was not seen, else kNone. The comparator stays as it was.
    [[nodiscard]] DeviceFault Run(const Comparator& comparator, const Comparison& comparison) noexcept;

  private:
    std::uint32_t wait_us_{}; ///< From the begin of a round to that of the next one.
    std::uint32_t number_{};  ///< Of the next test; those of a round are done from kComparatorTests on.
    Instant begun_{};         ///< Begin of the round, or of the first wait.
    bool is_timed_{};         ///< `begun_` is set.
    std::uint8_t round_{};    ///< Modular: which bit is turned round.
    SlotIndex slot_{kNoSlot}; ///< The one that is turned round; the first follows kNoSlot.
    std::uint8_t slots_{};    ///< Number of those that exist.
};

} // namespace counterpoint

#endif
