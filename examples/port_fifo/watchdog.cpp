// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "watchdog.hpp"

#include "registers.hpp"

namespace port_fifo
{

counterpoint::hal::WatchdogQuestion Watchdog::Question() noexcept
{
    return counterpoint::hal::WatchdogQuestion{ReadRegister(kWatchdogQuestion)};
}

void Watchdog::Answer(const counterpoint::hal::WatchdogAnswer& answer) noexcept
{
    WriteRegister(kWatchdogAnswer, answer.value);
}

} // namespace port_fifo
