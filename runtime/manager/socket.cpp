// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/socket.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "hal/host/live/bus.hpp"
#include "runtime/manager/order.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::size_t kMostClients = 8U;
constexpr std::size_t kReadBytes = 1024U;
constexpr std::size_t kLinesOfTurn = 4U; ///< Of a client: the network comes in between.
static_assert(EAGAIN == EWOULDBLOCK, "Linux has one number for both");
static_assert(kReadBytes <= kLongestManagerOrder, "what a reading has behind a line end is never an endless line");

sockaddr_un AddressOf(const std::string& path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof(address.sun_path))
    {
        throw cia306::InputError(path, {},
                                 {"a socket name of " + std::to_string(path.size()) + " bytes",
                                  "less than " + std::to_string(sizeof(address.sun_path))});
    }
    std::copy(path.begin(), path.end(), address.sun_path);
    return address;
}

/// Bound and listening; -1 and errno otherwise. Nobody but the owner may write to it before the mode is set.
int Listen(const sockaddr_un& address, const mode_t mode)
{
    const int file = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const auto* const general = reinterpret_cast<const sockaddr*>(&address);
    const bool is_bound = file >= 0 && ::fchmod(file, kOwnerOnly) == 0 && ::bind(file, general, sizeof(address)) == 0 &&
                          ::chmod(address.sun_path, mode) == 0 && ::listen(file, 4) == 0;
    if (file >= 0 && !is_bound)
    {
        const int reason = errno;
        ::close(file);
        errno = reason;
    }
    return is_bound ? file : -1;
}

/// What a manager left behind that did not end by itself; never another kind of file.
bool IsSocket(const std::string& path)
{
    struct stat status = {};
    return ::lstat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode);
}

/// Whether somebody listens there; also who is too busy to answer, or answers others only.
bool IsServed(const sockaddr_un& address)
{
    const host::LiveFile file(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    const bool is_refused = ::connect(file.Get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0;
    return !is_refused || (errno != ECONNREFUSED && errno != ENOENT);
}
} // namespace

ManagerSocket::ManagerSocket(std::string path, const mode_t mode, const std::uint64_t patience_ns)
    : patience_ns_(patience_ns), path_(std::move(path)), listener_(-1)
{
    const sockaddr_un address = AddressOf(path_);
    int file = Listen(address, mode);
    int reason = errno;
    if (file < 0 && reason == EADDRINUSE && IsSocket(path_) && !IsServed(address))
    {
        ::unlink(path_.c_str());
        file = Listen(address, mode);
        reason = errno;
    }
    if (file < 0)
    {
        throw cia306::InputError(path_, {},
                                 {std::string("no socket can be made here (") + std::strerror(reason) + ")",
                                  "a path in a folder that can be written, that nobody serves"});
    }
    listener_ = host::LiveFile(file);
    static_cast<void>(::lstat(path_.c_str(), &made_));
}

ManagerSocket::~ManagerSocket()
{
    struct stat there = {};
    const bool is_own =
        ::lstat(path_.c_str(), &there) == 0 && there.st_dev == made_.st_dev && there.st_ino == made_.st_ino;
    if (is_own)
    {
        ::unlink(path_.c_str());
    }
}

void ManagerSocket::AddTo(std::vector<pollfd>& places) const
{
    places.push_back({listener_.Get(), POLLIN, 0});
    for (const Client& client : clients_)
    {
        // What waits is taken with the next cycle, before more is read.
        const bool has_line = client.typed.find('\n') != std::string::npos;
        const short input = (has_line || client.is_ended) ? short{0} : short{POLLIN};
        places.push_back({client.file.Get(), client.unsent.empty() ? input : short{POLLOUT}, 0});
    }
}

void ManagerSocket::Serve(const std::function<std::string(const std::string&)>& answer,
                          const std::function<std::string(const std::string&)>& cut)
{
    ++turn_;
    Accept();
    for (Client& client : clients_)
    {
        Send(client);
        TakeLines(client, answer);
        TakeRest(client, cut);
        const bool is_done = client.is_ended && client.unsent.empty();
        client.is_over = client.is_over || is_done;
    }
    clients_.erase(
        std::remove_if(clients_.begin(), clients_.end(), [](const Client& client) { return client.is_over; }),
        clients_.end());
}

/// A few, and none behind an answer that waits.
void ManagerSocket::TakeLines(Client& client, const std::function<std::string(const std::string&)>& answer)
{
    std::size_t end = client.typed.find('\n');
    if (end == std::string::npos && client.unsent.empty() && !client.is_ended)
    {
        Read(client);
        end = client.typed.find('\n');
    }
    for (std::size_t lines = 0U; end != std::string::npos && client.unsent.empty() && lines < kLinesOfTurn; ++lines)
    {
        client.unsent = answer(client.typed.substr(0U, end));
        client.taken_ns = host::LiveNow();
        client.typed.erase(0U, end + 1U);
        Send(client);
        end = client.typed.find('\n');
    }
    // So much comes by a reading of this turn alone, which no answer held up.
    const bool is_endless = end == std::string::npos && client.typed.size() > kLongestManagerOrder;
    if (is_endless)
    {
        client.unsent = answer(client.typed); // Which says that it is too long.
        client.taken_ns = host::LiveNow();
        client.typed.clear();
        client.is_ended = true;
        Send(client);
    }
}

/// Behind its last whole line: the end is read only when no line and no answer waits. [SRS_MGR_471]
void ManagerSocket::TakeRest(Client& client, const std::function<std::string(const std::string&)>& cut) const
{
    if (client.is_ended && !client.typed.empty())
    {
        client.unsent = cut ? cut(client.typed) : "";
        client.taken_ns = host::LiveNow();
        client.typed.clear();
        Send(client);
    }
}

void ManagerSocket::Accept()
{
    const int file = ::accept4(listener_.Get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (file < 0)
    {
        return; // Nobody calls.
    }
    if (clients_.size() >= kMostClients)
    {
        clients_.erase(std::min_element(clients_.begin(), clients_.end(), [](const Client& left, const Client& right)
                                        { return left.heard < right.heard; }));
    }
    clients_.push_back({host::LiveFile(file), {}, {}, 0U, false, false, turn_});
}

void ManagerSocket::Read(Client& client)
{
    std::array<char, kReadBytes> bytes{};
    const ssize_t count = ::recv(client.file.Get(), bytes.data(), bytes.size(), 0);
    const bool is_nothing = count < 0 && errno == EAGAIN; // What does not wait is not interrupted.
    client.is_ended = count == 0;
    client.is_over = count < 0 && !is_nothing;
    client.heard = (count > 0) ? turn_ : client.heard;
    client.typed.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
}

/// As much of its answer as it has room for. [SRS_MGR_160]
void ManagerSocket::Send(Client& client) const
{
    if (client.unsent.empty())
    {
        return;
    }
    const ssize_t sent = ::send(client.file.Get(), client.unsent.data(), client.unsent.size(), MSG_NOSIGNAL);
    const bool is_full = sent < 0 && errno == EAGAIN;
    const std::uint64_t now_ns = host::LiveNow();
    if (sent > 0)
    {
        client.unsent.erase(0U, static_cast<std::size_t>(sent));
        client.taken_ns = now_ns;
    }
    const bool is_deaf = is_full && now_ns - client.taken_ns >= patience_ns_;
    client.is_over = is_deaf || (sent < 0 && !is_full);
}
} // namespace counterpoint::runtime
