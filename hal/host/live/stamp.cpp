// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/stamp.hpp"

#include "hal/host/live/bus.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <linux/net_tstamp.h>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kSecondNs = 1'000'000'000U;
constexpr std::uint64_t kOldestNs = 10U * kSecondNs;

std::uint64_t NanosecondsOf(const timespec& time)
{
    return (static_cast<std::uint64_t>(time.tv_sec) * kSecondNs) + static_cast<std::uint64_t>(time.tv_nsec);
}

std::uint64_t WallNow()
{
    timespec now{};
    static_cast<void>(::clock_gettime(CLOCK_REALTIME, &now));
    return NanosecondsOf(now);
}

ClockReading ReadClocks()
{
    ClockReadings readings{};
    for (ClockReading& reading : readings)
    {
        reading = ClockReading{LiveNow(), WallNow(), 0U};
        reading.after_ns = LiveNow();
    }
    return Quickest(readings);
}

} // namespace

void RequestStamps(const int socket)
{
    // Without them a frame has the time of its reading: later, but no less monotonic.
    const int on = 1;
    static_cast<void>(::setsockopt(socket, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof(on)));
    const int hardware = SOF_TIMESTAMPING_RX_HARDWARE | SOF_TIMESTAMPING_RAW_HARDWARE;
    static_cast<void>(::setsockopt(socket, SOL_SOCKET, SO_TIMESTAMPING, &hardware, sizeof(hardware)));
    static_cast<void>(::setsockopt(socket, SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof(on)));
}

void ReadStamps(msghdr& message, LiveArrival& arrival)
{
    for (cmsghdr* item = CMSG_FIRSTHDR(&message); item != nullptr; item = CMSG_NXTHDR(&message, item))
    {
        if (item->cmsg_level != SOL_SOCKET)
        {
            continue;
        }
        if (item->cmsg_type == SO_TIMESTAMPNS)
        {
            timespec stamp{};
            std::memcpy(&stamp, CMSG_DATA(item), sizeof(stamp));
            const ClockReading now = ReadClocks();
            const std::uint64_t middle_ns = now.before_ns + ((now.after_ns - now.before_ns) / 2U);
            arrival.time_ns = MonotonicStamp(NanosecondsOf(stamp), now.wall_ns, middle_ns);
        }
        else if (item->cmsg_type == SO_TIMESTAMPING)
        {
            std::array<timespec, 3U> stamps{}; // System, one that nobody fills in any more, hardware.
            std::memcpy(stamps.data(), CMSG_DATA(item), sizeof(stamps));
            arrival.hardware_ns = NanosecondsOf(stamps[2U]);
        }
        else if (item->cmsg_type == SO_RXQ_OVFL)
        {
            std::memcpy(&arrival.dropped, CMSG_DATA(item), sizeof(arrival.dropped));
        }
    }
}

LiveArrival ReadStamped(const int socket, void* const bytes, const std::size_t room)
{
    alignas(cmsghdr) char control[256]{};
    iovec part{bytes, room};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1U;
    message.msg_control = control;
    message.msg_controllen = sizeof(control);
    LiveArrival arrival;
    arrival.count = ::recvmsg(socket, &message, MSG_DONTWAIT);
    if (arrival.count < 0)
    {
        arrival.failure = errno;
        return arrival;
    }
    arrival.flags = message.msg_flags;
    arrival.time_ns = LiveNow();
    ReadStamps(message, arrival);
    return arrival;
}

ClockReading Quickest(const ClockReadings& readings)
{
    return *std::min_element(readings.begin(), readings.end(), [](const ClockReading& one, const ClockReading& other)
                             { return (one.after_ns - one.before_ns) < (other.after_ns - other.before_ns); });
}

std::uint64_t MonotonicStamp(const std::uint64_t stamp_ns, const std::uint64_t wall_now_ns,
                             const std::uint64_t monotonic_now_ns)
{
    const std::uint64_t age_ns = wall_now_ns - stamp_ns;
    const bool is_usable = (stamp_ns <= wall_now_ns) && (age_ns <= kOldestNs) && (age_ns <= monotonic_now_ns);
    return is_usable ? (monotonic_now_ns - age_ns) : monotonic_now_ns;
}

} // namespace counterpoint::host
