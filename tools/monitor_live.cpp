// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/monitor_live.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "hal/host/live/bus.hpp"

#include <algorithm>
#include <csignal>
#include <ostream>
#include <poll.h>

namespace counterpoint::tools
{
namespace
{
using monitor::LogFrame;
using monitor::Time;

constexpr int kPollMs = 10; ///< An expired limit is told so late at most.
/// A frame may be stamped before the poll that found none: so old a time has no frame to come.
constexpr Time kSettled = 20 * monitor::kMillisecond;

volatile std::sig_atomic_t is_interrupted = 0;

void OnInterrupt(int /*signal*/)
{
    is_interrupted = 1;
}

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
/// Told once each time.
bool TellState(const std::string& address, const bool was_down, const host::BusState state, const Streams& streams)
{
    const bool is_down = state == host::BusState::kDown;
    if (is_down != was_down)
    {
        streams.err << "counterpoint monitor: " << cia306::Printable(address)
                    << (is_down ? " went down; nothing is judged until it is back" : " is back") << "\n";
        streams.err.flush();
    }
    return is_down;
}

std::unique_ptr<host::LiveBus> Open(const std::string& address)
{
    try
    {
        return host::OpenLiveBus(address);
    }
    catch (const host::LiveBusError& error)
    {
        throw cia306::InputError(address, 0U, {error.what(), ""});
    }
}
} // namespace

void WatchLiveBus(const std::string& address, const int seconds, const Streams& streams, const LiveWatcher& watcher)
{
    const std::unique_ptr<host::LiveBus> bus = Open(address);
    is_interrupted = 0;
    const auto before_int = std::signal(SIGINT, &OnInterrupt);
    const auto before_term = std::signal(SIGTERM, &OnInterrupt);
    const Time begin = static_cast<Time>(host::LiveNow());
    Time last = begin;
    bool is_down = false;
    bool is_over = false;
    while (!is_over)
    {
        pollfd descriptor{bus->Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&descriptor, 1U, kPollMs));
        host::LiveFrame live;
        while (bus->Receive(live))
        {
            LogFrame frame = FrameOf(live);
            frame.time = std::max(frame.time, last); // Stamps of two threads of the system may change places.
            last = frame.time;
            watcher.take(frame);
        }
        const Time now = static_cast<Time>(host::LiveNow());
        is_down = TellState(address, is_down, bus->Health().state, streams);
        if (is_down)
        {
            watcher.interrupt();
        }
        else
        {
            last = std::max(last, now - kSettled);
            watcher.advance(last);
        }
        streams.out.flush();
        is_over = is_interrupted != 0 || (seconds != 0 && now - begin >= seconds * monitor::kSecond);
    }
    if (const std::uint32_t lost = bus->Health().lost_frames; lost != 0U)
    {
        streams.err << "counterpoint monitor: " << lost << " frames were lost on this machine\n";
    }
    static_cast<void>(std::signal(SIGINT, before_int));
    static_cast<void>(std::signal(SIGTERM, before_term));
}
} // namespace counterpoint::tools
