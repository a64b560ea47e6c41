// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_WATCHDOG_HPP
#define HAL_HOST_WATCHDOG_HPP

#include "hal/api/watchdog.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "hal/host/virtual/bit_rate.hpp"
#include "hal/host/virtual/bus.hpp"

#include <cstdint>

namespace counterpoint::host
{

/// A watchdog chip: runs on bus time, whatever the kernel's clocks do. Tripped until Start. [SRS_HAL_013]
class HostWatchdog final : public hal::Watchdog
{
  public:
    /// @brief Tripped until Start. `bus` outlives this.
    explicit HostWatchdog(const VirtualBus& bus);

    /// @brief Power-on of the device: supervision from now on, this instant counting as the answer before.
    void Start(const hal::WatchdogWindow& window);
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    /// @brief Whether it has not tripped, at the present time of the bus.
    [[nodiscard]] bool IsAlive();
    /// @brief When it trips if no answer comes; kNever if it has tripped already.
    [[nodiscard]] BusTime TripsAt();
    /// @brief How often it was started; an output that was opened under an earlier start stays closed.
    [[nodiscard]] std::uint32_t Starts() const
    {
        return starts_;
    }

  private:
    const VirtualBus& bus_;
    hal::WatchdogTimer timer_{};
    hal::WatchdogWindow window_{0U, 0U};
    BusTime answered_us_{0};
    std::uint32_t starts_{0U};
};

} // namespace counterpoint::host

#endif
