// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/link.hpp"

#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <utility>

namespace counterpoint::host
{
namespace
{

constexpr std::size_t kReadBytes = 16U * 1024U;

static_assert(EAGAIN == EWOULDBLOCK, "Linux has one number for both");

bool IsLater(const int failure)
{
    return (failure == EAGAIN) || (failure == EINTR);
}

} // namespace

SocketcandLink::SocketcandLink(LiveFile socket) : socket_{std::move(socket)}
{
    // A frame goes out when it is there, not when there are more.
    const int on = 1;
    static_cast<void>(::setsockopt(socket_.Get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on)));
}

void SocketcandLink::Say(const SocketcandMessage& message)
{
    waiting_ += WriteSocketcand(message);
    Flush();
}

void SocketcandLink::Say(const SocketcandWord word)
{
    SocketcandMessage message;
    message.word = word;
    Say(message);
}

void SocketcandLink::Flush()
{
    if (waiting_.empty() || IsLost())
    {
        return;
    }
    const ssize_t sent = ::send(socket_.Get(), waiting_.data(), waiting_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0)
    {
        waiting_.erase(0U, static_cast<std::size_t>(sent));
    }
    else if (!IsLater(errno))
    {
        Close();
    }
}

void SocketcandLink::Read()
{
    std::array<char, kReadBytes> bytes{};
    const ssize_t got = IsLost() ? 0 : ::recv(socket_.Get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (got > 0)
    {
        // A partner that waits for the acknowledgement of a frame before it sends the next one (Nagle's rule) would get
        // it 40 ms later otherwise. The system forgets this with what is sent, so that it is said each time.
        // [SRS_LIVE_330]
        const int on = 1;
        static_cast<void>(::setsockopt(socket_.Get(), IPPROTO_TCP, TCP_QUICKACK, &on, sizeof(on)));
        stream_.Feed(bytes.data(), static_cast<std::size_t>(got));
    }
    else if ((got == 0) || !IsLater(errno))
    {
        Close();
    }
}

void SocketcandLink::Close()
{
    socket_ = LiveFile{-1};
    waiting_.clear();
}

} // namespace counterpoint::host
