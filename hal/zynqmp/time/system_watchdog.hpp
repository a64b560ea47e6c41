// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_TIME_SYSTEM_WATCHDOG_HPP
#define HAL_ZYNQMP_TIME_SYSTEM_WATCHDOG_HPP

#include "hal/api/clocks.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "hal/zynqmp/time/watchdog_driver.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

/// What the watchdog is set up for.
struct SystemWatchdogSetup
{
    hal::WatchdogWindow window;
    std::uint32_t clock_khz; ///< Of the watchdog; another one than that of the processor.
};

/// The system watchdog. The hardware knows a last moment only and takes a fixed key: question, answer and the beginning
/// of the window are those of hal::WatchdogTimer, in software, and the key comes out of the answer. [SRS_ZYN_060]
class SystemWatchdog final : public WatchdogDriver
{
  public:
    /// @brief `clocks` outlives this; its counter A is the time of the window.
    explicit SystemWatchdog(hal::Clocks& clocks) noexcept;

    /// @brief Before Start. kFailed: the hardware has no period that ends within the window.
    [[nodiscard]] Outcome Plan(const SystemWatchdogSetup& setup) noexcept;
    [[nodiscard]] Outcome Start() noexcept override;
    [[nodiscard]] Outcome Examine() noexcept override;
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    /// @brief An answer that is early, late or wrong leaves the hardware alone, for ever.
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    /// @brief When the hardware resets after the last right answer.
    [[nodiscard]] std::uint32_t PeriodUs() const noexcept;

  private:
    hal::Clocks& clocks_;
    hal::WatchdogTimer timer_{};
    hal::WatchdogWindow window_{0U, 0U};
    std::uint32_t clock_khz_{0U};
    std::uint32_t steps_{0U};
};

} // namespace counterpoint::zynqmp

#endif
