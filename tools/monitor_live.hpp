// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_MONITOR_LIVE_HPP
#define TOOLS_MONITOR_LIVE_HPP

#include "canopen/monitor/recording.hpp"
#include "tools/command.hpp"

#include <functional>
#include <string>

namespace counterpoint::tools
{
/// Hands over every frame of the bus, and the time where none comes, until Ctrl-C or `seconds` have passed (0: no end).
/// Throws InputError for an address that cannot be opened. [SRS-MON-001]
void WatchLiveBus(const std::string& address, int seconds, const Streams& streams,
                  const std::function<void(const monitor::LogFrame&)>& take,
                  const std::function<void(monitor::Time)>& advance);
} // namespace counterpoint::tools

#endif // TOOLS_MONITOR_LIVE_HPP
