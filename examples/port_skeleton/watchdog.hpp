// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_WATCHDOG_HPP
#define EXAMPLES_PORT_SKELETON_WATCHDOG_HPP

#include "hal/api/watchdog.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// The watchdog in hardware, or a chip beside the controller.
class Watchdog final : public counterpoint::hal::Watchdog
{
  public:
    /// @brief CONTRACT. Another question in each cycle.
    [[nodiscard]] counterpoint::hal::WatchdogQuestion Question() noexcept override;
    /// @brief CONTRACT. Gives the answer to the hardware as it is: what is written is right only if all 32 bits are, by
    /// arithmetic and never by a comparison that decides to serve. The hardware has a window with both ends and a clock
    /// of its own; early, late or wrong, it takes the outputs away without the program, until a restart.
    /// hal/api/watchdog_timer.hpp has the rule.
    void Answer(const counterpoint::hal::WatchdogAnswer& answer) noexcept override;

    /// @brief Change it to kThere with the body, and not before.
    [[nodiscard]] PartState State() const noexcept;
};

} // namespace port_skeleton

#endif
