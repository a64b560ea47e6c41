// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live_socketcand_bus.hpp"

#include "hal/host/live_error.hpp"

#include <cerrno>
#include <cstring>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kMillisecondNs = 1'000'000U;
/// For connecting and greeting together.
constexpr std::uint64_t kPatienceNs = 3'000U * kMillisecondNs;
constexpr std::uint64_t kRetryNs = kMillisecondNs;
/// What may wait as text before frames wait as frames.
constexpr std::size_t kTextBytes = 4096U;

int RestOf(const std::uint64_t until_ns)
{
    const std::uint64_t now_ns = LiveNow();
    return (now_ns < until_ns) ? static_cast<int>((until_ns - now_ns) / kMillisecondNs) + 1 : 0;
}

/// 0, or the errno of a connection that was begun.
int OutcomeOf(const int socket, const std::uint64_t until_ns)
{
    pollfd wait{socket, POLLOUT, 0};
    if (::poll(&wait, 1U, RestOf(until_ns)) <= 0)
    {
        return ETIMEDOUT;
    }
    int failure = 0;
    socklen_t bytes = sizeof(failure);
    static_cast<void>(::getsockopt(socket, SOL_SOCKET, SO_ERROR, &failure, &bytes));
    return failure;
}

LiveFile Connect(const LiveAddress& address, const std::uint64_t until_ns)
{
    addrinfo wanted{};
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const int problem = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wanted, &found);
    if (problem != 0)
    {
        throw LiveBusError("bus '" + address.text + "': host '" + address.host + "': " + ::gai_strerror(problem) +
                           ", expected the name or address of a host");
    }
    int failure = EHOSTUNREACH;
    LiveFile result{-1};
    for (const addrinfo* each = found; (each != nullptr) && (result.Get() < 0); each = each->ai_next)
    {
        LiveFile socket{::socket(each->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
        const bool is_done = ::connect(socket.Get(), each->ai_addr, each->ai_addrlen) == 0;
        failure = is_done ? 0 : errno;
        failure = (failure == EINPROGRESS) ? OutcomeOf(socket.Get(), until_ns) : failure;
        if (failure == 0)
        {
            result = std::move(socket);
        }
    }
    ::freeaddrinfo(found);
    if (result.Get() < 0)
    {
        throw LiveBusError("bus '" + address.text + "': " + std::strerror(failure) +
                           ", expected a socketcand server at " + address.host + " port " +
                           std::to_string(address.port));
    }
    return result;
}

SocketcandMessage MessageOf(const SocketcandWord word)
{
    SocketcandMessage message;
    message.word = word;
    return message;
}

} // namespace

LiveSocketcandBus::LiveSocketcandBus(const LiveAddress& address, const LiveOptions& options)
    : address_{address}, options_{options}, link_{Connect(address, LiveNow() + kPatienceNs)}
{
    Greet();
    poll_.Add(link_.Descriptor());
    if (!early_.empty())
    {
        poll_.WakeAt(LiveNow());
    }
}

void LiveSocketcandBus::Refuse(const std::string& what) const
{
    throw LiveBusError("bus '" + address_.text + "': " + what);
}

SocketcandMessage LiveSocketcandBus::Await(const std::uint64_t until_ns)
{
    while (true)
    {
        if (const std::optional<SocketcandMessage> message = link_.Next())
        {
            return *message;
        }
        if (link_.IsLost())
        {
            Refuse("the server ended the connection, expected its answer");
        }
        pollfd wait{link_.Descriptor(), POLLIN, 0};
        if (::poll(&wait, 1U, RestOf(until_ns)) <= 0)
        {
            Refuse("the server said nothing for 3 s, expected the socketcand protocol");
        }
        link_.Read();
    }
}

void LiveSocketcandBus::Demand(const SocketcandMessage& order, const SocketcandWord answer,
                               const std::uint64_t until_ns)
{
    if (order.word != SocketcandWord::kInvalid)
    {
        link_.Say(order);
    }
    const SocketcandMessage message = Await(until_ns);
    if (message.word == SocketcandWord::kErrorText)
    {
        Refuse("the server says: " + message.text);
    }
    if (message.word != answer)
    {
        Refuse("the server's answer is another than expected of socketcand" +
               (message.problem.empty() ? std::string{} : (": " + message.problem)));
    }
}

void LiveSocketcandBus::Greet()
{
    const std::uint64_t until_ns = LiveNow() + kPatienceNs;
    Demand(MessageOf(SocketcandWord::kInvalid), SocketcandWord::kHi, until_ns);
    SocketcandMessage open = MessageOf(SocketcandWord::kOpen);
    open.text = address_.interface;
    Demand(open, SocketcandWord::kOk, until_ns);
    Demand(MessageOf(SocketcandWord::kRawMode), SocketcandWord::kOk, until_ns);
    // From here on frames may come between.
    link_.Say(SocketcandWord::kOwnMode);
    SocketcandMessage message = Await(until_ns);
    while ((message.word != SocketcandWord::kOk) && (message.word != SocketcandWord::kErrorText))
    {
        early_.push_back(message);
        message = Await(until_ns);
    }
    has_own_ = message.word == SocketcandWord::kOk;
}

SendResult LiveSocketcandBus::Send(const LiveFrame& frame)
{
    if (!IsSendable(frame) || frame.fd)
    {
        return SendResult::kRefused;
    }
    SendWaiting();
    if (is_lost_)
    {
        return SendResult::kDown;
    }
    if (queue_.IsFull())
    {
        return SendResult::kQueueFull;
    }
    queue_.Push(frame);
    SendWaiting();
    return is_lost_ ? SendResult::kDown : SendResult::kSent;
}

void LiveSocketcandBus::Hand(const LiveFrame& frame)
{
    SocketcandMessage message = MessageOf(frame.remote ? SocketcandWord::kSendRemote : SocketcandWord::kSend);
    message.frame = frame;
    link_.Say(message);
    if (!has_own_)
    {
        unconfirmed_.push_back(frame);
        link_.Say(SocketcandWord::kEcho);
    }
}

void LiveSocketcandBus::SendWaiting()
{
    link_.Flush();
    while (!queue_.IsEmpty() && (link_.WaitingBytes() < kTextBytes) && !link_.IsLost())
    {
        Hand(queue_.First());
        queue_.DropFirst();
    }
    NoteLoss();
    if (queue_.IsEmpty() && (link_.WaitingBytes() == 0U))
    {
        poll_.WakeNever();
    }
    else
    {
        poll_.WakeAt(LiveNow() + kRetryNs);
    }
}

void LiveSocketcandBus::NoteLoss()
{
    if (link_.IsLost() && !is_lost_)
    {
        is_lost_ = true;
        state_ = BusState::kDown;
        counts_.dropped_frames += queue_.Clear();
    }
}

bool LiveSocketcandBus::Receive(LiveFrame& frame)
{
    if (!is_lost_)
    {
        SendWaiting();
    }
    bool has_read = false;
    while (true)
    {
        std::optional<SocketcandMessage> message;
        if (!early_.empty())
        {
            message = early_.front();
            early_.pop_front();
        }
        else
        {
            message = link_.Next();
        }
        if (message && Take(*message, frame) && Passes(options_.filters, frame))
        {
            return true;
        }
        if (!message && has_read)
        {
            NoteLoss();
            return false;
        }
        if (!message)
        {
            link_.Read();
            has_read = true;
        }
    }
}

/// Whether the message gives a frame.
bool LiveSocketcandBus::Take(const SocketcandMessage& message, LiveFrame& frame)
{
    const bool is_echo = (message.word == SocketcandWord::kEcho) && !unconfirmed_.empty();
    const bool is_frame = message.frame.error || (message.word == SocketcandWord::kFrame) ||
                          (message.word == SocketcandWord::kRemote) || (message.word == SocketcandWord::kOwnFrame) ||
                          (message.word == SocketcandWord::kOwnRemote);
    if (is_echo)
    {
        frame = unconfirmed_.front();
        frame.own = true;
        unconfirmed_.pop_front();
    }
    else if (is_frame)
    {
        frame = message.frame;
    }
    else
    {
        counts_.malformed += message.problem.empty() ? 0U : 1U;
        LearnText(message.text);
        return false;
    }
    frame.time_ns = LiveNow();
    const ErrorNews news = ReadErrorFrame(frame);
    counts_.error_frames += frame.error ? 1U : 0U;
    counts_.bus_offs += news.is_bus_off ? 1U : 0U;
    counts_.restarts += news.is_restart ? 1U : 0U;
    // A frame that came is a bus that works, whatever was said before.
    state_ = frame.error ? news.state.value_or(state_) : BusState::kActive;
    return true;
}

/// Our server tells in words what became of a frame that it could not send.
void LiveSocketcandBus::LearnText(const std::string& text)
{
    if (text.compare(0U, 5U, "send:") != 0)
    {
        return;
    }
    ++counts_.dropped_frames;
    if (text.find("bus-off") != std::string::npos)
    {
        state_ = BusState::kBusOff;
    }
    else if (text.find("down") != std::string::npos)
    {
        state_ = BusState::kDown;
    }
}

int LiveSocketcandBus::Descriptor() const
{
    return poll_.Descriptor();
}

BusHealth LiveSocketcandBus::Health() const
{
    BusHealth health = counts_;
    health.state = state_;
    health.waiting = queue_.Count();
    return health;
}

std::string LiveSocketcandBus::Name() const
{
    return address_.text;
}

bool LiveSocketcandBus::Restart()
{
    return false; // The server's owner does that.
}

} // namespace counterpoint::host
