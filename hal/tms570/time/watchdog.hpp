// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_TIME_WATCHDOG_HPP
#define HAL_TMS570_TIME_WATCHDOG_HPP

#include "hal/api/watchdog.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "hal/tms570/chip/registers.hpp"
#include "hal/tms570/chip/variant.hpp"
#include "hal/tms570/time/rti.hpp"

#include <cstdint>

namespace counterpoint::tms570
{

/// What the hardware makes of a window: never opens before and never ends after what was asked for.
struct WatchdogPlan
{
    Outcome outcome; ///< kFailed: no setting of the hardware lies within the window that was asked for.
    std::uint32_t preload;
    std::uint32_t window;
    hal::WatchdogWindow real;
    Presence
        has_window; ///< Of the variant; without, the hardware finds late and wrong answers only, and always resets.
};

/// @brief Longest period that ends within `wanted`, with the smallest open window that still opens before
/// `latest_open_us`. [SRS_TMS_022]
[[nodiscard]] WatchdogPlan PlanWatchdog(const hal::WatchdogWindow& wanted, RtiClock clock,
                                        std::uint32_t latest_open_us) noexcept;

/// Digital windowed watchdog of the RTI. Whoever answers early, late or wrongly resets the device. Cannot be stopped.
class WindowedWatchdog final : public hal::Watchdog
{
  public:
    /// @brief Starts it; this counts as the answer before. [SRS_TMS_022]
    [[nodiscard]] Outcome Start(const WatchdogPlan& plan) noexcept;
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    /// @brief Writes two keys that are right only if all bits of the answer are. [SRS_TMS_023]
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    /// @brief Once a cycle: set up as it was. A watchdog that is off has failed.
    [[nodiscard]] Outcome Examine() const noexcept;

  private:
    WatchdogPlan plan_{};
    std::uint32_t sequence_{0U};
};

} // namespace counterpoint::tms570

#endif
