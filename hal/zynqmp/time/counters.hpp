// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_TIME_COUNTERS_HPP
#define HAL_ZYNQMP_TIME_COUNTERS_HPP

#include "hal/api/clocks.hpp"
#include "hal/zynqmp/chip/registers.hpp"
#include "hal/zynqmp/time/scaled_counter.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// Clocks of the two counters of time.
struct CountersSetup
{
    RegisterBase timer;          ///< ttc::kTtc0 or another; its first counter.
    std::uint32_t timer_power;   ///< The prescaler divides by 2 to this power, 1 to 16.
    CounterRate timer_rate;      ///< Behind the prescaler.
    std::uint32_t set_back_from; ///< Reading from which on the timer is set back to 0, a count later at most; 0: never,
                                 ///< it rolls over by itself. The emulator's timers do not survive their roll-over.
    CounterRate processor_rate;  ///< Of the processor's cycles.
    std::uint32_t most_apart_us; ///< What one may differ from the other by within `compare_us`.
    std::uint32_t compare_us;
};

/// The two counters of time: a timer in the low-power domain for channel A, the cycles of the processor for channel B.
/// Each has a PLL of its own; both PLLs have one oscillator, so that a wrong oscillator is seen by an outer watchdog
/// only. [SRS_ZYN_054, SRS_ZYN_055, SRS_ZYN_056]
class Counters final : public hal::Clocks
{
  public:
    /// @brief Starts both; read back. kFailed as well when one of them does not advance or is not as fast as it should.
    [[nodiscard]] Outcome Start(const CountersSetup& setup) noexcept;
    /// @brief At least once before either counter has rolled over.
    [[nodiscard]] InstantPair Now() noexcept override;
    /// @brief Once a cycle: set up as they were, and no further apart than they may be. The first failure stays.
    [[nodiscard]] Outcome Examine() noexcept;

  private:
    [[nodiscard]] bool IsSetUp() const noexcept;
    [[nodiscard]] bool AreTogether(const InstantPair& now) const noexcept;

    CountersSetup setup_{};
    ScaledCounter timer_{};
    ScaledCounter processor_{};
    InstantPair compared_{};
    Outcome outcome_{Outcome::kInvalid};
};

} // namespace counterpoint::zynqmp

#endif
