// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_COMPARATOR_COMPARATOR_SELF_TEST_HPP
#define SAFETY_CORE_COMPARATOR_COMPARATOR_SELF_TEST_HPP

#include "safety_core/comparator/comparator.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstdint>

namespace counterpoint
{

/// Finds a comparator that always says yes: by a difference that it must see, another one each time. [SRS_CMP_009]
class ComparatorSelfTest
{
  public:
    /// @brief A test in every test interval, the first one after one interval. Kernel::Start made sure that the
    /// interval holds at least one cycle.
    void Restart(const DeviceConfig& config) noexcept;
    /// @brief Once a cycle: whether the next test has to be run now.
    [[nodiscard]] bool TakeTurn() noexcept
    {
        --cycles_to_test_;
        if (cycles_to_test_ != 0U)
        {
            return false;
        }
        cycles_to_test_ = test_cycles_;
        return true;
    }
    /// @brief The difference is put into `outcome_b`, which is that of the comparison, and taken out again.
    /// kComparator if it was not seen, else kNone.
    [[nodiscard]] DeviceFault Run(Comparator& comparator, const Comparison& comparison,
                                  CycleOutcome& outcome_b) noexcept;

  private:
    std::uint32_t test_cycles_{};
    std::uint32_t cycles_to_test_{};
    std::uint8_t number_{}; ///< Of the last difference.
};

} // namespace counterpoint

#endif
