// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_FIFO_WATCHDOG_HPP
#define EXAMPLES_PORT_FIFO_WATCHDOG_HPP

#include "hal/api/watchdog.hpp"

namespace port_fifo
{

/// A chip with questions of its own.
class Watchdog final : public counterpoint::hal::Watchdog
{
  public:
    [[nodiscard]] counterpoint::hal::WatchdogQuestion Question() noexcept override;
    void Answer(const counterpoint::hal::WatchdogAnswer& answer) noexcept override;
};

} // namespace port_fifo

#endif
