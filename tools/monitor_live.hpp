// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_MONITOR_LIVE_HPP
#define TOOLS_MONITOR_LIVE_HPP

#include "canopen/monitor/recording.hpp"
#include "tools/command_line/command.hpp"

#include <functional>
#include <string>

namespace counterpoint::tools
{
/// What WatchLiveBus calls: each is set.
struct LiveWatcher
{
    std::function<void(const monitor::LogFrame&)> take;
    std::function<void(monitor::Time)> advance; ///< No frame came until then.
    std::function<void()> interrupt;            ///< The bus is down: what is on it is not seen.
};

/// Hands over every frame of the bus, and the time where none comes, until Ctrl-C or `seconds` have passed (0: no end),
/// also when the bus goes down and comes back. Throws InputError for an address that cannot be opened. [SRS_MON_001,
/// SRS_MON_018]
void WatchLiveBus(const std::string& address, int seconds, const Streams& streams, const LiveWatcher& watcher);
} // namespace counterpoint::tools

#endif // TOOLS_MONITOR_LIVE_HPP
