// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_PERMIT_TEST_HPP
#define SAFETY_CORE_SELFTEST_PERMIT_TEST_HPP

#include "hal/api/safety_output.hpp"
#include "safety_core/selftest/slice.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

/// Shows the output sets of permits: one that is right and must be accepted, all others wrong, old or missing and must
/// be refused. Nothing opens or closes by it: the challenges used are even, and no output ever issues an even one.
/// [SRS_STS_030]
class PermitTest
{
  public:
    /// One right set; a wrong, an old and a missing permit of each of three parties.
    static constexpr std::uint32_t kSlicesAPass = 10U;

    /// @brief Begins the first pass.
    void Restart() noexcept;
    /// @brief Shows the next set. kFailed: the output judged it wrongly, or cannot be probed. O(1)
    [[nodiscard]] SliceResult Slice(const hal::SafetyOutput& output) noexcept;
    /// @brief Slices done since Restart, modular.
    [[nodiscard]] std::uint32_t Done() const noexcept
    {
        return done_;
    }

  private:
    std::uint32_t challenge_{0U};
    std::uint32_t done_{0U};
    std::uint8_t variant_{0U};
};

} // namespace counterpoint::selftest

#endif
