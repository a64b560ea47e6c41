// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/live_watch.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "tools/command_line/end_signals.hpp"

#include <algorithm>
#include <limits>
#include <ostream>
#include <poll.h>
#include <utility>

namespace counterpoint::tools
{
namespace
{
using monitor::LogFrame;
using monitor::Time;

constexpr int kPollMs = 10; ///< An expired limit is told so late at most.
/// A frame may be stamped before the poll that found none: so old a time has no frame to come.
constexpr Time kSettled = 20 * monitor::kMillisecond;

LogFrame FrameOf(const host::LiveFrame& live)
{
    LogFrame frame;
    frame.time = static_cast<Time>(live.time_ns);
    frame.identifier = live.identifier;
    frame.length = live.length_bytes;
    frame.is_extended = live.extended;
    frame.is_remote = live.remote;
    frame.is_fd = live.fd;
    frame.is_error = live.error;
    std::copy(std::begin(live.data), std::end(live.data), frame.data.begin());
    return frame;
}

std::unique_ptr<host::LiveBus> Open(const std::string& address)
{
    try
    {
        return host::OpenLiveBus(address);
    }
    catch (const host::LiveBusError& error)
    {
        throw cia306::InputError(address, {}, {error.what(), ""});
    }
}
} // namespace

LiveWatch::LiveWatch(const std::string& address, const runtime::Streams& streams, LiveWatcher watcher)
    : address_(address), streams_(streams), watcher_(std::move(watcher)), bus_(Open(address))
{
}

void LiveWatch::Tell(const std::string& text) const
{
    streams_.err << "counterpoint monitor: " << cia306::Printable(address_) << " " << text << "\n";
    streams_.err.flush();
}

monitor::Missed LiveWatch::Run(const int seconds)
{
    const EndSignals signals;
    const Time begin = static_cast<Time>(host::LiveNow());
    last_ = begin;
    bool is_over = false;
    while (!is_over)
    {
        pollfd descriptor{bus_->Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&descriptor, 1U, kPollMs));
        TakeFrames();
        const Time now = static_cast<Time>(host::LiveNow());
        if (!is_away_)
        {
            last_ = std::max(last_, now - kSettled);
            watcher_.advance(last_);
        }
        TellMissed(static_cast<std::uint64_t>(now));
        streams_.out.flush();
        is_over = signals.IsAsked() || (seconds != 0 && now - begin >= seconds * monitor::kSecond);
    }
    TellMissed(std::numeric_limits<std::uint64_t>::max()); // What is left.
    const host::BusHealth health = bus_->Health();
    return {health.malformed, health.lost_frames, health.absences};
}

void LiveWatch::TakeFrames()
{
    host::LiveFrame live;
    while (bus_->Receive(live))
    {
        WatchState(); // Before the frame, which may be the first one behind an absence.
        LogFrame frame = FrameOf(live);
        frame.time = std::max(frame.time, last_); // Stamps of two threads of the system may change places.
        last_ = frame.time;
        watcher_.take(frame);
    }
    WatchState();
}

/// Each absence is told once, with its end, also one that is over already. [SRS_MON_018, SRS_MON_580]
void LiveWatch::WatchState()
{
    const host::BusHealth health = bus_->Health();
    const bool is_there = !host::IsAway(health.state);
    const bool was_away = health.absences != absences_ || !is_there;
    absences_ = health.absences;
    if (was_away && !is_away_)
    {
        const bool is_off = (is_there ? health.absence : health.state) == host::BusState::kBusOff;
        Tell(std::string(is_off ? "went bus-off" : "went down") + "; nothing is judged until it is back");
        is_away_ = true;
    }
    if (is_away_)
    {
        watcher_.interrupt();
    }
    if (is_away_ && is_there)
    {
        Tell("is back");
        is_away_ = false;
    }
}

void LiveWatch::TellMissed(const std::uint64_t now_ns)
{
    const host::BusHealth health = bus_->Health();
    static_cast<void>(malformed_.Learn(health.malformed));
    static_cast<void>(lost_.Learn(health.lost_frames));
    if (const std::uint32_t count = malformed_.Due(now_ns))
    {
        Tell("gave what is no frame: " + runtime::MalformedText(count, bus_->Problem()));
    }
    if (const std::uint32_t count = lost_.Due(now_ns))
    {
        Tell("gave " + std::to_string(count) + " frames that were lost on this machine");
    }
}
} // namespace counterpoint::tools
