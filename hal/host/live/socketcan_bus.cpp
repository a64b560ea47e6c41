// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcan_bus.hpp"

#include "hal/host/live/error.hpp"
#include "hal/host/live/stamp.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kMillisecondNs = 1'000'000U;
/// How soon to ask a full system again: less than the time of ten frames of 1 Mbit/s.
constexpr std::uint64_t kRetryNs = kMillisecondNs;
constexpr int kReceiveBytes = 4 * 1024 * 1024; // The system gives what it allows.

static_assert(EAGAIN == EWOULDBLOCK, "Linux has one number for both");

bool IsQueueFull(const int failure)
{
    return (failure == ENOBUFS) || (failure == EAGAIN);
}

bool IsGone(const int failure)
{
    return (failure == ENETDOWN) || (failure == ENXIO) || (failure == ENODEV);
}

} // namespace

SocketCanFrame ToSocketCan(const LiveFrame& frame)
{
    SocketCanFrame result{};
    result.bytes = frame.fd ? CANFD_MTU : CAN_MTU;
    result.frame.can_id = frame.identifier | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
    result.frame.len = frame.length_bytes;
    if (!frame.remote)
    {
        std::copy_n(frame.data, std::size_t{frame.length_bytes}, result.frame.data);
    }
    return result;
}

bool FromSocketCan(const canfd_frame& raw, const std::size_t bytes, LiveFrame& frame)
{
    const bool is_flexible = bytes == CANFD_MTU;
    const std::size_t room = is_flexible ? kLiveDataBytes : kClassicalDataBytes;
    if ((!is_flexible && (bytes != CAN_MTU)) || (raw.len > room))
    {
        return false;
    }
    frame = LiveFrame{};
    frame.fd = is_flexible;
    frame.error = (raw.can_id & CAN_ERR_FLAG) != 0U;
    frame.extended = !frame.error && ((raw.can_id & CAN_EFF_FLAG) != 0U);
    frame.remote = !frame.error && ((raw.can_id & CAN_RTR_FLAG) != 0U);
    const bool is_wide = frame.error || frame.extended;
    frame.identifier = raw.can_id & (is_wide ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.length_bytes = raw.len;
    if (!frame.remote)
    {
        std::copy_n(raw.data, std::size_t{raw.len}, frame.data);
    }
    return true;
}

LiveSocketCanBus::LiveSocketCanBus(const LiveAddress& address, const LiveOptions& options)
    : OpenedBus{address, options, BusState::kDown},
      socket_{::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW)}
{
    if (socket_.Get() < 0)
    {
        throw LiveBusError("bus '" + address_.text + "': " + std::strerror(errno) +
                           ", expected a kernel with SocketCAN (modules can and can_raw)");
    }
    Configure();
    if (!Bind())
    {
        throw LiveBusError("bus '" + address_.text + "': " + std::strerror(errno) + ", expected a CAN interface '" +
                           address_.interface + "'");
    }
    poll_.Add(socket_.Get());
    poll_.Add(link_.Descriptor());
    Look();
    PlanWake();
}

void LiveSocketCanBus::Configure()
{
    const int on = 1;
    const can_err_mask_t all_errors = CAN_ERR_MASK;
    const int file = socket_.Get();
    static_cast<void>(::setsockopt(file, SOL_SOCKET, SO_RCVBUF, &kReceiveBytes, sizeof(kReceiveBytes)));
    // An interface of classical CAN refuses frames of CAN FD when they are sent.
    const bool is_set = (::setsockopt(file, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &on, sizeof(on)) == 0) &&
                        (::setsockopt(file, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof(on)) == 0) &&
                        (::setsockopt(file, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &all_errors, sizeof(all_errors)) == 0);
    if (!is_set)
    {
        throw LiveBusError("bus '" + address_.text + "': " + std::strerror(errno) +
                           ", expected a raw socket with own frames and error frames");
    }
    ApplyFilters();
    RequestStamps(file);
}

void LiveSocketCanBus::ApplyFilters()
{
    // Also the one that passes everything has to be set: a socket whose interface was removed has lost its own.
    std::vector<can_filter> filters;
    if (options_.filters.empty())
    {
        filters.push_back({0U, 0U});
    }
    for (const IdentifierFilter& filter : options_.filters)
    {
        // The width is always compared.
        filters.push_back({filter.identifier | (filter.extended ? CAN_EFF_FLAG : 0U), filter.mask | CAN_EFF_FLAG});
    }
    const auto bytes = static_cast<socklen_t>(filters.size() * sizeof(can_filter));
    if (::setsockopt(socket_.Get(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(), bytes) != 0)
    {
        throw LiveBusError("bus '" + address_.text + "': " + std::strerror(errno) + ", expected at most 512 filters");
    }
}

bool LiveSocketCanBus::Bind()
{
    sockaddr_can own{};
    own.can_family = AF_CAN;
    own.can_ifindex = static_cast<int>(::if_nametoindex(address_.interface.c_str()));
    // Index 0 would be every interface at once.
    const bool is_bound =
        (own.can_ifindex != 0) && (::bind(socket_.Get(), reinterpret_cast<const sockaddr*>(&own), sizeof(own)) == 0);
    index_ = is_bound ? own.can_ifindex : 0;
    return is_bound;
}

/// Asks the kernel how the interface is now. Its news and the error frames are told in the order of two queues, so
/// neither is taken for the present state where the kernel can be asked.
void LiveSocketCanBus::Look()
{
    const int found = static_cast<int>(::if_nametoindex(address_.interface.c_str()));
    if ((found != 0) && (found != index_) && Bind())
    {
        ApplyFilters();
    }
    const std::optional<LinkState> link = (found == 0) ? std::nullopt : link_.Ask(found);
    is_carrying_ = link && link->is_carrying;
    if (!link || !link->is_up)
    {
        Enter(BusState::kDown);
        return;
    }
    has_controller_ = link->controller.has_value();
    if (has_controller_)
    {
        health_.transmit_errors = link->transmit_errors;
        health_.receive_errors = link->receive_errors;
        Enter(*link->controller);
    }
    else if (health_.state == BusState::kDown)
    {
        Enter(BusState::kActive);
    }
}

void LiveSocketCanBus::Enter(const BusState state)
{
    if (state == health_.state)
    {
        return;
    }
    SetState(state);
    const bool is_off = state == BusState::kBusOff;
    if (is_off || (state == BusState::kDown))
    {
        health_.dropped_frames += static_cast<std::uint32_t>(queue_.size());
        queue_.clear(); // Too old to be sent when the bus is there again.
    }
    const bool is_timed = is_off && (options_.restart == RestartPolicy::kTimed);
    restart_at_ns_ = is_timed ? (LiveNow() + (options_.restart_after_ms * kMillisecondNs)) : 0U;
}

void LiveSocketCanBus::Learn(const LiveFrame& frame)
{
    const ErrorNews news = ReadErrorFrame(frame);
    ++health_.error_frames;
    health_.bus_offs += news.is_bus_off ? 1U : 0U;
    health_.restarts += news.is_restart ? 1U : 0U;
    health_.lost_frames += news.is_overflow ? 1U : 0U; // At least one. [SRS_LIVE_584]
    if (has_controller_)
    {
        const bool was_away = IsAway(health_.state);
        Look();
        if (news.is_bus_off && !was_away)
        {
            NoteBusOff(); // What the kernel says may be of after the restart.
        }
        return;
    }
    if (news.has_counters)
    {
        health_.transmit_errors = news.transmit_errors;
        health_.receive_errors = news.receive_errors;
    }
    if (news.state && (health_.state != BusState::kDown))
    {
        Enter(*news.state);
    }
}

SendResult LiveSocketCanBus::Send(const LiveFrame& frame)
{
    if (!IsSendable(frame))
    {
        return SendResult::kRefused;
    }
    Service();
    if (health_.state == BusState::kDown)
    {
        return SendResult::kDown;
    }
    if (health_.state == BusState::kBusOff)
    {
        return SendResult::kBusOff;
    }
    if (queue_.empty())
    {
        int failure = Transmit(frame);
        if (IsGone(failure))
        {
            // Also told once after the interface has come back already.
            Look();
            PlanWake();
            failure = (health_.state == BusState::kDown) ? failure : Transmit(frame);
        }
        if (failure == 0)
        {
            return SendResult::kSent;
        }
        if (!IsQueueFull(failure))
        {
            return IsGone(failure) ? SendResult::kDown : SendResult::kRefused;
        }
        retry_at_ns_ = LiveNow() + kRetryNs;
    }
    if (IsFull())
    {
        return SendResult::kQueueFull;
    }
    queue_.push_back(frame);
    PlanWake();
    return SendResult::kSent;
}

int LiveSocketCanBus::Transmit(const LiveFrame& frame)
{
    if (!is_carrying_)
    {
        return ENOBUFS;
    }
    const SocketCanFrame raw = ToSocketCan(frame);
    const ssize_t written = ::send(socket_.Get(), &raw.frame, raw.bytes, MSG_DONTWAIT);
    return (written == static_cast<ssize_t>(raw.bytes)) ? 0 : errno;
}

void LiveSocketCanBus::SendWaiting()
{
    while (!queue_.empty() && (LiveNow() >= retry_at_ns_))
    {
        const int failure = Transmit(queue_.front());
        if (IsQueueFull(failure) || IsGone(failure))
        {
            retry_at_ns_ = LiveNow() + kRetryNs;
            Look(); // A bus that is off refuses frames like a full queue.
            return;
        }
        health_.dropped_frames += (failure == 0) ? 0U : 1U;
        queue_.pop_front();
    }
}

void LiveSocketCanBus::CarryOutPolicy()
{
    if ((restart_at_ns_ != 0U) && (LiveNow() >= restart_at_ns_))
    {
        // Again after the same time where it did not help or is not allowed.
        restart_at_ns_ = LiveNow() + std::max<std::uint64_t>(options_.restart_after_ms, 1U) * kMillisecondNs;
        health_.refused_restarts += Restart() ? 0U : 1U;
    }
}

/// Off the bus nothing waits, so that never both are due.
void LiveSocketCanBus::PlanWake()
{
    poll_.WakeAt(queue_.empty() ? restart_at_ns_ : retry_at_ns_);
}

void LiveSocketCanBus::Service()
{
    if (link_.TakeNews())
    {
        Look();
    }
    CarryOutPolicy();
    SendWaiting();
    PlanWake();
}

bool LiveSocketCanBus::Receive(LiveFrame& frame)
{
    Service();
    for (;;)
    {
        canfd_frame raw{};
        const LiveArrival arrival = ReadStamped(socket_.Get(), &raw, sizeof(raw));
        if (arrival.count < 0)
        {
            if (IsGone(arrival.failure))
            {
                Look(); // Told once; what comes behind it is read by the next round.
                continue;
            }
            PlanWake();
            return false;
        }
        health_.lost_frames += (arrival.dropped > dropped_) ? (arrival.dropped - dropped_) : 0U;
        dropped_ = std::max(dropped_, arrival.dropped);
        if (!FromSocketCan(raw, static_cast<std::size_t>(arrival.count), frame))
        {
            NoteMalformed("a reading of " + std::to_string(arrival.count) +
                          " bytes that is no frame of CAN, expected one of 0 to 8 or 64 bytes");
            continue;
        }
        const bool has_stamp = arrival.hardware_ns != 0U;
        frame.time_ns = has_stamp ? clock_.Map(arrival.hardware_ns, arrival.time_ns) : arrival.time_ns;
        frame.own = (arrival.flags & MSG_CONFIRM) != 0;
        if (frame.error)
        {
            Learn(frame);
            PlanWake();
        }
        return true;
    }
}

bool LiveSocketCanBus::Restart()
{
    if ((health_.state != BusState::kBusOff) || (index_ == 0))
    {
        return false;
    }
    const int refused = link_.Restart(index_);
    const bool needs_switch = (refused == EOPNOTSUPP);
    // A driver without a restart of its own starts anew when its interface does.
    const bool is_done =
        (refused == 0) || (needs_switch && (link_.Switch(index_, false) == 0) && (link_.Switch(index_, true) == 0));
    health_.restarts += (is_done && needs_switch) ? 1U : 0U;
    Look();
    return is_done;
}

} // namespace counterpoint::host
