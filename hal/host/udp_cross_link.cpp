// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/udp_cross_link.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

sockaddr_in LoopbackOf(const std::uint16_t port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

} // namespace

UdpSocket::UdpSocket(const UdpPorts& ports)
    : socket_{::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)}, peer_{ports.peer}
{
    const sockaddr_in own = LoopbackOf(ports.own);
    if ((socket_ < 0) || (::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof(own)) != 0))
    {
        const std::string reason = std::strerror(errno);
        if (socket_ >= 0)
        {
            static_cast<void>(::close(socket_));
        }
        throw std::runtime_error("UDP port " + std::to_string(ports.own) + " on 127.0.0.1: " + reason +
                                 ", expected a free port");
    }
}

UdpSocket::~UdpSocket()
{
    static_cast<void>(::close(socket_));
}

bool UdpSocket::Send(const void* const bytes, const std::size_t count) noexcept
{
    const sockaddr_in peer = LoopbackOf(peer_);
    const ssize_t sent = ::sendto(socket_, bytes, count, 0, reinterpret_cast<const sockaddr*>(&peer), sizeof(peer));
    return sent == static_cast<ssize_t>(count);
}

std::size_t UdpSocket::Receive(void* const bytes, const std::size_t room) noexcept
{
    const ssize_t got = ::recv(socket_, bytes, room, 0);
    return (got > 0) ? static_cast<std::size_t>(got) : 0U;
}

hal::LinkStatus UdpCrossLink::Send(const hal::LinkFrame& frame) noexcept
{
    const bool fits = (frame.length != 0U) && (frame.length <= hal::kLinkFrameBytes);
    return (fits && socket_.Send(frame.bytes, frame.length)) ? hal::LinkStatus::kDone : hal::LinkStatus::kNothing;
}

hal::LinkStatus UdpCrossLink::Receive(hal::LinkFrame& frame) noexcept
{
    const std::size_t count = socket_.Receive(frame.bytes, hal::kLinkFrameBytes);
    frame.length = static_cast<std::uint16_t>(count);
    return (count != 0U) ? hal::LinkStatus::kDone : hal::LinkStatus::kNothing;
}

} // namespace counterpoint::host
