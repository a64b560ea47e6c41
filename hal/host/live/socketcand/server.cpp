// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/server.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <exception>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <utility>

namespace counterpoint::host
{
namespace
{

constexpr std::size_t kGreatestBacklogBytes = 1024U * 1024U;
/// How soon a frame for a full bus is offered again.
constexpr int kRetryMs = 1;

/// The wall clock at a moment of the monotonic one, in microseconds: what the protocol's stamps are.
std::uint64_t WallMicroseconds(const std::uint64_t monotonic_ns)
{
    timespec now{};
    static_cast<void>(::clock_gettime(CLOCK_REALTIME, &now));
    const std::uint64_t wall_ns =
        (static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000U) + static_cast<std::uint64_t>(now.tv_nsec);
    return (wall_ns - (LiveNow() - monotonic_ns)) / 1'000U;
}

/// Why a frame was not taken by a bus whose queue has room.
std::string ReasonOf(const SendResult result)
{
    if (result == SendResult::kBusOff)
    {
        return "bus-off";
    }
    return (result == SendResult::kDown) ? "the bus is down" : "the bus refuses the frame";
}

LiveFile Listen(const std::string& host, const std::uint16_t port)
{
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_PASSIVE;
    addrinfo* found = nullptr;
    const std::string name = "socketcand server at " + host + " port " + std::to_string(port) + ": ";
    const int problem = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
    if (problem != 0)
    {
        throw LiveBusError(name + ::gai_strerror(problem) + ", expected an address of this machine");
    }
    LiveFile listener{::socket(found->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    const int on = 1;
    static_cast<void>(::setsockopt(listener.Get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on)));
    const bool is_open = (::bind(listener.Get(), found->ai_addr, found->ai_addrlen) == 0) &&
                         (::listen(listener.Get(), static_cast<int>(kSocketcandClients)) == 0);
    const int failure = errno;
    ::freeaddrinfo(found);
    if (!is_open)
    {
        throw LiveBusError(name + std::strerror(failure) + ", expected a free port of this machine");
    }
    return listener;
}

} // namespace

SocketcandClient::SocketcandClient(LiveFile socket, const std::vector<ServedBus>& buses, ServerCounts& counts)
    : link_{std::move(socket)}, buses_{buses}, counts_{counts}
{
    Say(SocketcandWord::kHi);
}

pollfd SocketcandClient::Connection() const
{
    const int in = (held_ || is_ending_) ? 0 : POLLIN;
    const int out = (link_.WaitingBytes() != 0U) ? POLLOUT : 0;
    return {link_.Descriptor(), static_cast<short>(in | out), 0};
}

pollfd SocketcandClient::Bus() const
{
    return {bus_->Descriptor(), POLLIN, 0};
}

void SocketcandClient::Say(const SocketcandWord word)
{
    link_.Say(word);
}

void SocketcandClient::SayError(const std::string& text)
{
    SocketcandMessage message;
    message.word = SocketcandWord::kErrorText;
    message.text = text.substr(0U, kSocketcandErrorTextBytes);
    link_.Say(message);
}

bool SocketcandClient::Serve()
{
    link_.Flush();
    if (held_)
    {
        const LiveFrame frame = *std::exchange(held_, std::nullopt);
        Transmit(frame);
    }
    if (!held_ && !is_ending_)
    {
        link_.Read();
    }
    while (!held_ && !is_ending_)
    {
        const std::optional<SocketcandMessage> message = link_.Next();
        if (!message)
        {
            break;
        }
        Obey(*message);
    }
    LiveFrame frame;
    while (bus_ && bus_->Receive(frame))
    {
        Tell(frame);
    }
    if (link_.WaitingBytes() > kGreatestBacklogBytes)
    {
        ++counts_.too_slow;
        link_.Close();
    }
    return !link_.IsLost() && !(is_ending_ && (link_.WaitingBytes() == 0U));
}

void SocketcandClient::Obey(const SocketcandMessage& message)
{
    const bool is_frame = (message.word == SocketcandWord::kSend) || (message.word == SocketcandWord::kSendRemote);
    if (!message.problem.empty())
    {
        ++counts_.malformed;
        SayError(message.problem);
    }
    else if (message.word == SocketcandWord::kEcho)
    {
        Say(SocketcandWord::kEcho);
    }
    else if ((message.word == SocketcandWord::kOpen) && !bus_)
    {
        Open(message.text);
    }
    else if (!bus_)
    {
        SayError("no bus is open, expected open first");
    }
    else if (is_frame)
    {
        Transmit(message.frame);
    }
    else if ((message.word == SocketcandWord::kRawMode) || (message.word == SocketcandWord::kBcmMode))
    {
        is_raw_ = message.word == SocketcandWord::kRawMode;
        Say(SocketcandWord::kOk);
    }
    else if ((message.word == SocketcandWord::kOwnMode) && is_raw_)
    {
        tells_own_ = true;
        Say(SocketcandWord::kOk);
    }
    else
    {
        SayError("not now, expected rawmode, bcmmode, send, sendrtr, echo, or ownmode in raw mode");
    }
}

void SocketcandClient::Open(const std::string& name)
{
    const auto is_named = [&name](const ServedBus& bus) { return bus.name == name; };
    const auto found = std::find_if(buses_.begin(), buses_.end(), is_named);
    if (found == buses_.end())
    {
        std::string names;
        for (const ServedBus& bus : buses_)
        {
            names += (names.empty() ? "" : " or ") + bus.name;
        }
        SayError("no bus of that name, expected " + names);
        is_ending_ = true;
        return;
    }
    try
    {
        bus_ = OpenLiveBus(found->address);
        Say(SocketcandWord::kOk);
    }
    catch (const std::exception& problem) // No descriptor left among them: that client goes, the others stay.
    {
        SayError(problem.what());
        is_ending_ = true;
    }
}

void SocketcandClient::Transmit(const LiveFrame& frame)
{
    const SendResult result = bus_->Send(frame);
    if (result == SendResult::kQueueFull)
    {
        held_ = frame;
    }
    else if (result == SendResult::kSent)
    {
        ++counts_.to_bus;
    }
    else
    {
        SayError("send: " + ReasonOf(result));
    }
}

void SocketcandClient::Tell(const LiveFrame& frame)
{
    const bool is_told = is_raw_ && !frame.fd && (!frame.own || tells_own_);
    if (!is_told)
    {
        return;
    }
    SocketcandMessage message;
    message.frame = frame;
    message.stamp_us = WallMicroseconds(frame.time_ns);
    if (frame.error)
    {
        message.word = SocketcandWord::kErrorFrame;
    }
    else if (frame.own)
    {
        message.word = frame.remote ? SocketcandWord::kOwnRemote : SocketcandWord::kOwnFrame;
    }
    else
    {
        message.word = frame.remote ? SocketcandWord::kRemote : SocketcandWord::kFrame;
    }
    counts_.from_bus += frame.own ? 0U : 1U;
    link_.Say(message);
}

SocketcandServer::SocketcandServer(const std::string& host, const std::uint16_t port, std::vector<ServedBus> buses)
    : buses_{std::move(buses)}, listener_{Listen(host, port)}
{
    for (const ServedBus& bus : buses_)
    {
        static_cast<void>(OpenLiveBus(bus.address)); // Rather fail here than at the first client.
    }
}

std::uint16_t SocketcandServer::Port() const
{
    sockaddr_storage own{};
    socklen_t bytes = sizeof(own);
    static_cast<void>(::getsockname(listener_.Get(), reinterpret_cast<sockaddr*>(&own), &bytes));
    // The port stands at the same place in both families.
    return ntohs(reinterpret_cast<const sockaddr_in*>(&own)->sin_port);
}

void SocketcandServer::Accept()
{
    // As many a turn as there are places: who calls without an end does not keep the others from being served.
    for (std::size_t i = 0U; i < kSocketcandClients; ++i)
    {
        LiveFile socket{::accept4(listener_.Get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
        const bool is_refused = (socket.Get() < 0) && ((errno == EMFILE) || (errno == ENFILE));
        if (is_refused)
        {
            is_full_ = !MakeRoom();
            return;
        }
        if (socket.Get() < 0)
        {
            return;
        }
        if ((clients_.size() < kSocketcandClients) || MakeRoom())
        {
            ++counts_.accepted;
            clients_.push_back(std::make_unique<SocketcandClient>(std::move(socket), buses_, counts_));
        }
    }
}

/// Disconnects the oldest client that has opened no bus. False: there is none.
bool SocketcandServer::MakeRoom()
{
    const auto is_idle = [](const std::unique_ptr<SocketcandClient>& client) { return !client->HasBus(); };
    const auto found = std::find_if(clients_.begin(), clients_.end(), is_idle);
    const bool is_found = found != clients_.end();
    if (is_found)
    {
        clients_.erase(found);
    }
    return is_found;
}

void SocketcandServer::Serve(const int milliseconds)
{
    std::vector<pollfd> waits{{is_full_ ? -1 : listener_.Get(), POLLIN, 0}};
    is_full_ = false;
    int patience_ms = milliseconds;
    for (const auto& client : clients_)
    {
        waits.push_back(client->Connection());
        if (client->HasBus()) // The system refuses to wait for more places than it would give descriptors.
        {
            waits.push_back(client->Bus());
        }
        patience_ms = client->HoldsFrame() ? std::min(patience_ms, kRetryMs) : patience_ms;
    }
    static_cast<void>(::poll(waits.data(), waits.size(), patience_ms));
    const auto has_ended = [](const std::unique_ptr<SocketcandClient>& client) { return !client->Serve(); };
    clients_.erase(std::remove_if(clients_.begin(), clients_.end(), has_ended), clients_.end());
    if ((waits[0].revents & POLLIN) != 0)
    {
        Accept();
    }
    counts_.clients = static_cast<std::uint32_t>(clients_.size());
}

} // namespace counterpoint::host
