// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/udp_bus.hpp"

#include "hal/host/live/stamp.hpp"
#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <random>
#include <sys/socket.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

// A datagram: "CPB1", sender (8 bytes), flags, length, identifier (4 bytes), data; numbers most significant byte first.
constexpr std::uint8_t kMagic[]{'C', 'P', 'B', '1'};
constexpr std::size_t kSenderAt = 4U;
constexpr std::size_t kFlagsAt = 12U;
constexpr std::size_t kLengthAt = 13U;
constexpr std::size_t kIdentifierAt = 14U;
constexpr std::size_t kDataAt = 18U;
constexpr std::uint8_t kExtendedFlag = 1U;
constexpr std::uint8_t kRemoteFlag = 2U;
constexpr std::uint8_t kFdFlag = 4U;
constexpr std::uint8_t kAllFlags = 7U;
/// How soon to ask a full system again.
constexpr std::uint64_t kRetryNs = 1'000'000U;
constexpr std::uint64_t kSecondNs = 1'000'000'000U;
constexpr int kReceiveBytes = 4 * 1024 * 1024;

void Store(std::uint8_t* const at, const std::size_t bytes, const std::uint64_t value)
{
    for (std::size_t n = 0U; n < bytes; ++n)
    {
        at[n] = static_cast<std::uint8_t>(value >> (8U * (bytes - 1U - n)));
    }
}

std::uint64_t Load(const std::uint8_t* const at, const std::size_t bytes)
{
    std::uint64_t value = 0U;
    for (std::size_t n = 0U; n < bytes; ++n)
    {
        value = (value << 8U) | at[n];
    }
    return value;
}

std::size_t DataBytes(const LiveFrame& frame)
{
    return frame.remote ? 0U : frame.length_bytes;
}

std::uint64_t RandomSender()
{
    std::random_device source;
    return (std::uint64_t{source()} << 32U) ^ source() ^ (static_cast<std::uint64_t>(::getpid()) << 16U);
}

sockaddr_in GroupOf(const LiveAddress& address)
{
    sockaddr_in group{};
    group.sin_family = AF_INET;
    group.sin_port = htons(address.port);
    static_cast<void>(::inet_pton(AF_INET, address.host.c_str(), &group.sin_addr));
    return group;
}

} // namespace

LiveUdpBus::LiveUdpBus(const LiveAddress& address, const LiveOptions& options)
    : OpenedBus{address, options, BusState::kActive},
      socket_{::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)}, sender_{RandomSender()}
{
    Join();
    RequestStamps(socket_.Get());
    poll_.Add(socket_.Get());
}

void LiveUdpBus::Join()
{
    const int on = 1;
    const int no_hops = 0; // Never leaves this machine.
    const sockaddr_in group = GroupOf(address_);
    ip_mreqn membership{};
    membership.imr_multiaddr = group.sin_addr;
    membership.imr_address.s_addr = htonl(INADDR_LOOPBACK);
    const int file = socket_.Get();
    const bool is_open = (file >= 0) && (::setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on)) == 0) &&
                         (::bind(file, reinterpret_cast<const sockaddr*>(&group), sizeof(group)) == 0) &&
                         (::setsockopt(file, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof(membership)) == 0) &&
                         (::setsockopt(file, IPPROTO_IP, IP_MULTICAST_IF, &membership, sizeof(membership)) == 0) &&
                         (::setsockopt(file, IPPROTO_IP, IP_MULTICAST_TTL, &no_hops, sizeof(no_hops)) == 0) &&
                         (::setsockopt(file, IPPROTO_IP, IP_MULTICAST_LOOP, &on, sizeof(on)) == 0);
    if (!is_open)
    {
        throw LiveBusError("bus '" + address_.text + "': " + std::strerror(errno) +
                           ", expected to join the group on the loopback interface");
    }
    static_cast<void>(::setsockopt(file, SOL_SOCKET, SO_RCVBUF, &kReceiveBytes, sizeof(kReceiveBytes)));
}

SendResult LiveUdpBus::Send(const LiveFrame& frame)
{
    const bool has_pace = address_.bits_per_second != 0U;
    if (!IsSendable(frame) || (has_pace && frame.fd))
    {
        return SendResult::kRefused;
    }
    SendWaiting();
    if (queue_.empty() && (LiveNow() >= free_at_ns_) && Transmit(frame))
    {
        return SendResult::kSent;
    }
    if (IsFull())
    {
        return SendResult::kQueueFull;
    }
    queue_.push_back(frame);
    PlanWake();
    return SendResult::kSent;
}

bool LiveUdpBus::Transmit(const LiveFrame& frame)
{
    std::uint8_t bytes[kDataAt + kLiveDataBytes]{};
    std::copy(std::begin(kMagic), std::end(kMagic), bytes);
    Store(bytes + kSenderAt, 8U, sender_);
    bytes[kFlagsAt] = static_cast<std::uint8_t>((frame.extended ? kExtendedFlag : 0U) |
                                                (frame.remote ? kRemoteFlag : 0U) | (frame.fd ? kFdFlag : 0U));
    bytes[kLengthAt] = frame.length_bytes;
    Store(bytes + kIdentifierAt, 4U, frame.identifier);
    std::copy_n(frame.data, DataBytes(frame), bytes + kDataAt);
    const sockaddr_in group = GroupOf(address_);
    const std::size_t count = kDataAt + DataBytes(frame);
    const ssize_t sent =
        ::sendto(socket_.Get(), bytes, count, 0, reinterpret_cast<const sockaddr*>(&group), sizeof(group));
    const bool is_sent = sent == static_cast<ssize_t>(count);
    if (is_sent)
    {
        Occupy(frame, LiveNow());
    }
    return is_sent;
}

void LiveUdpBus::SendWaiting()
{
    while (!queue_.empty() && (LiveNow() >= free_at_ns_) && Transmit(queue_.front()))
    {
        queue_.pop_front();
    }
    PlanWake();
}

void LiveUdpBus::PlanWake()
{
    const bool has_pace = address_.bits_per_second != 0U;
    poll_.WakeAt(queue_.empty() ? 0U : std::max(free_at_ns_, LiveNow() + (has_pace ? 0U : kRetryNs)));
}

void LiveUdpBus::Occupy(const LiveFrame& frame, const std::uint64_t from_ns)
{
    if ((address_.bits_per_second != 0U) && !frame.fd)
    {
        const std::uint64_t bits = MeasureFrame(ToCanFrame(frame, CanPortId::kFirst)).WithIntermission();
        free_at_ns_ = std::max(free_at_ns_, from_ns) + ((bits * kSecondNs) / address_.bits_per_second);
    }
}

bool LiveUdpBus::Unpack(const std::uint8_t* const bytes, const std::size_t count, LiveFrame& frame) const
{
    const bool is_ours =
        (count >= kDataAt) && std::equal(std::begin(kMagic), std::end(kMagic), bytes) && (bytes[kFlagsAt] <= kAllFlags);
    if (!is_ours)
    {
        return false;
    }
    frame = LiveFrame{};
    frame.own = Load(bytes + kSenderAt, 8U) == sender_;
    frame.extended = (bytes[kFlagsAt] & kExtendedFlag) != 0U;
    frame.remote = (bytes[kFlagsAt] & kRemoteFlag) != 0U;
    frame.fd = (bytes[kFlagsAt] & kFdFlag) != 0U;
    frame.length_bytes = bytes[kLengthAt];
    frame.identifier = static_cast<std::uint32_t>(Load(bytes + kIdentifierAt, 4U));
    const bool is_whole = IsSendable(frame) && (count == kDataAt + DataBytes(frame));
    if (is_whole)
    {
        std::copy_n(bytes + kDataAt, DataBytes(frame), frame.data);
    }
    return is_whole;
}

bool LiveUdpBus::Receive(LiveFrame& frame)
{
    SendWaiting();
    for (;;)
    {
        // One byte more than the longest frame, so that a longer datagram is seen to be too long.
        std::uint8_t bytes[kDataAt + kLiveDataBytes + 1U]{};
        const LiveArrival arrival = ReadStamped(socket_.Get(), bytes, sizeof(bytes));
        if (arrival.count < 0)
        {
            return false;
        }
        health_.lost_frames = std::max(health_.lost_frames, arrival.dropped);
        if (!Unpack(bytes, static_cast<std::size_t>(arrival.count), frame))
        {
            NoteMalformed("a datagram of " + std::to_string(arrival.count) + " bytes, expected a frame of this bus");
            continue;
        }
        frame.time_ns = arrival.time_ns;
        if (!frame.own)
        {
            Occupy(frame, frame.time_ns);
        }
        if (Passes(options_.filters, frame))
        {
            return true;
        }
    }
}

} // namespace counterpoint::host
