// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/peer.hpp"

#include "hal/host/live/bus.hpp"

#include <cerrno>
#include <cstring>
#include <netdb.h>
#include <poll.h>
#include <string>

namespace counterpoint::host
{
namespace
{

/// 0, or the errno of a connection that was begun.
int OutcomeOf(const int socket, const std::uint64_t until_ns)
{
    pollfd wait{socket, POLLOUT, 0};
    if (::poll(&wait, 1U, MillisecondsUntil(until_ns)) <= 0)
    {
        return ETIMEDOUT;
    }
    int failure = 0;
    socklen_t bytes = sizeof(failure);
    static_cast<void>(::getsockopt(socket, SOL_SOCKET, SO_ERROR, &failure, &bytes));
    return failure;
}

} // namespace

SocketcandPeer::SocketcandPeer(const LiveAddress& address) : address_{address}
{
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const int problem = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wanted, &found);
    if (problem != 0)
    {
        throw LiveBusError("bus '" + address.text + "': host '" + address.host + "': " + ::gai_strerror(problem) +
                           ", expected the name or address of a machine");
    }
    for (const addrinfo* each = found; each != nullptr; each = each->ai_next)
    {
        Place place{};
        std::memcpy(&place.address, each->ai_addr, each->ai_addrlen);
        place.bytes = each->ai_addrlen;
        places_.push_back(place);
    }
    ::freeaddrinfo(found);
}

LiveFile SocketcandPeer::Connect(const std::uint64_t until_ns)
{
    int failure = EHOSTUNREACH;
    for (std::size_t tried = 0U; tried < places_.size(); ++tried)
    {
        LiveFile socket = BeginConnect();
        failure = (socket.Get() < 0) ? errno : OutcomeOf(socket.Get(), until_ns);
        if (failure == 0)
        {
            return socket;
        }
        TryOther();
    }
    throw LiveBusError("bus '" + address_.text + "': " + std::strerror(failure) + ", expected a socketcand server at " +
                       address_.host + " port " + std::to_string(address_.port));
}

LiveFile SocketcandPeer::BeginConnect() const
{
    const Place& place = places_.at(chosen_);
    const auto* const address = reinterpret_cast<const sockaddr*>(&place.address);
    LiveFile socket{::socket(address->sa_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    const bool is_begun =
        (socket.Get() >= 0) && ((::connect(socket.Get(), address, place.bytes) == 0) || (errno == EINPROGRESS));
    return is_begun ? std::move(socket) : LiveFile{-1};
}

void SocketcandPeer::TryOther()
{
    chosen_ = (chosen_ + 1U) % places_.size();
}

} // namespace counterpoint::host
