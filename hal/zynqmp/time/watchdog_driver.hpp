// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_TIME_WATCHDOG_DRIVER_HPP
#define HAL_ZYNQMP_TIME_WATCHDOG_DRIVER_HPP

#include "hal/api/watchdog.hpp"
#include "hal/zynqmp/chip/registers.hpp"

namespace counterpoint::zynqmp
{

/// The watchdog as the board drives it: that of the controller, or one outside of it.
class WatchdogDriver : public hal::Watchdog
{
  public:
    /// @brief Starts it; this counts as the answer before.
    [[nodiscard]] virtual Outcome Start() noexcept = 0;
    /// @brief Once a cycle: set up as it was, and not tripped.
    [[nodiscard]] virtual Outcome Examine() noexcept = 0;

    WatchdogDriver(const WatchdogDriver&) = delete;
    WatchdogDriver(WatchdogDriver&&) = delete;
    WatchdogDriver& operator=(const WatchdogDriver&) = delete;
    WatchdogDriver& operator=(WatchdogDriver&&) = delete;

  protected:
    WatchdogDriver() noexcept = default;
    ~WatchdogDriver() noexcept = default;
};

} // namespace counterpoint::zynqmp

#endif
