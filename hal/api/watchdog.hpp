// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_WATCHDOG_HPP
#define HAL_API_WATCHDOG_HPP

#include <cstdint>

namespace counterpoint::hal
{

/// Flow signature of an undisturbed cycle. The kernel never compares with it to decide on the answer.
constexpr std::uint32_t kFlowReference = 0x5EC0DE27U;
/// Right answer: (flow signature + question) * kWatchdogConstant (modulo 2^32), with the signature kFlowReference.
constexpr std::uint32_t kWatchdogConstant = 0x01000193U;

/// The question of a cycle; another one in each cycle.
struct WatchdogQuestion
{
    std::uint32_t value;
};

/// The answer that the flow monitor gives.
struct WatchdogAnswer
{
    std::uint32_t value;
};

/// A windowed question-and-answer watchdog with a cut-off of its own. hal/api/watchdog_timer.hpp has the rule; a port
/// adds the device that enforces it. [SRS_HAL_005]
class Watchdog
{
  public:
    /// @brief The question of this cycle.
    [[nodiscard]] virtual WatchdogQuestion Question() noexcept = 0;
    /// @brief The answer of this cycle; early, late or wrong trips the watchdog.
    virtual void Answer(const WatchdogAnswer& answer) noexcept = 0;

    Watchdog(const Watchdog&) = delete;
    Watchdog(Watchdog&&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;
    Watchdog& operator=(Watchdog&&) = delete;

  protected:
    Watchdog() noexcept = default;
    ~Watchdog() noexcept = default;
};

} // namespace counterpoint::hal

#endif
