// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_WATCHDOG_TIMER_HPP
#define HAL_API_WATCHDOG_TIMER_HPP

#include "hal/api/watchdog.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::hal
{

/// Window of a watchdog after the answer before: an answer counts from `opens_us` to `ends_us`, both included.
struct WatchdogWindow
{
    std::uint32_t opens_us;
    std::uint32_t ends_us;
};

/// The rule of a windowed question-and-answer watchdog, for ports that have to play one (host) and as the model of the
/// ones in hardware. Zero-filled memory is tripped. [SRS_HAL_005, SRS_HAL_009]
class WatchdogTimer
{
  public:
    /// @brief Starts the supervision at `now`, which counts as the answer before; the only way out of the tripped
    /// state.
    void Start(const WatchdogWindow& window, Instant now) noexcept;
    /// @brief The question that the next answer must fit.
    [[nodiscard]] WatchdogQuestion Question() const noexcept;
    /// @brief A right answer within the window begins the next window at `now`, with another question. Any other answer
    /// trips the watchdog.
    void Answer(const WatchdogAnswer& answer, Instant now) noexcept;
    /// @brief Trips when the end of the window has passed at `now`. Call before looking at IsAlive, and at least once
    /// in 2^31 us.
    void Examine(Instant now) noexcept;
    /// @brief False: tripped, or never started.
    [[nodiscard]] bool IsAlive() const noexcept;

  private:
    WatchdogWindow window_{0U, 0U};
    Instant answered_{0U};
    std::uint32_t question_{0U};
    std::uint32_t alive_{0U};
};

} // namespace counterpoint::hal

#endif
