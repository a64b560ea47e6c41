// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_LIVE_WATCH_HPP
#define TOOLS_LIVE_WATCH_HPP

#include "canopen/monitor/recording.hpp"
#include "canopen/monitor/report.hpp"
#include "hal/host/live/bus.hpp"
#include "runtime/console/streams.hpp"
#include "runtime/console/told_count.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace counterpoint::tools
{
/// What LiveWatch calls: each is set.
struct LiveWatcher
{
    std::function<void(const monitor::LogFrame&)> take;
    std::function<void(monitor::Time)> advance; ///< No frame came until then.
    std::function<void()> interrupt;            ///< The bus was away: what was on it is not seen.
};

/// Hands over every frame of a live bus, and the time where none comes, also behind an absence of the bus, and tells
/// what is missing among them. [SRS_MON_001, SRS_MON_018, SRS_MON_580, SRS_MON_581]
class LiveWatch
{
  public:
    /// @brief Opens the bus. `streams` outlives it. Throws InputError for an address that cannot be opened.
    LiveWatch(const std::string& address, const runtime::Streams& streams, LiveWatcher watcher);

    /// @brief Until Ctrl-C, SIGTERM, or `seconds` have passed (0: no end).
    [[nodiscard]] monitor::Missed Run(int seconds);

  private:
    void TakeFrames();
    void WatchState();
    void TellMissed(std::uint64_t now_ns);
    void Tell(const std::string& text) const;

    std::string address_;
    const runtime::Streams& streams_;
    LiveWatcher watcher_;
    std::unique_ptr<host::LiveBus> bus_;
    monitor::Time last_{0};
    std::uint32_t absences_{0U};
    bool is_away_{false};
    runtime::ToldCount malformed_{};
    runtime::ToldCount lost_{};
};
} // namespace counterpoint::tools

#endif // TOOLS_LIVE_WATCH_HPP
