// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The client of the socketcand protocol, whose server leaves answers out, gives too many, sends instead of answering,
// or tells that the bus was away for a moment.
#include "hal/host/live/error.hpp"
#include "hal/host/live/socketcand/greeting.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

#include <atomic>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kLongestWaitNs = 300'000'000'000U;
/// It knows no ownmode.
constexpr const char* kForeignGreeting = "< hi >< ok >< ok >< error unknown command >";

/// A server of which the test says what it says. It greets its first client by itself.
class ToldServer
{
  public:
    ToldServer() : listener_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t bytes = sizeof(own);
        EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
        EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
        EXPECT_EQ(::listen(listener_, 1), 0);
        address_ = "socketcand:127.0.0.1:" + std::to_string(ntohs(own.sin_port)) + "/can0";
    }
    ~ToldServer()
    {
        Close();
        static_cast<void>(::close(listener_));
    }
    ToldServer(const ToldServer&) = delete;
    ToldServer& operator=(const ToldServer&) = delete;
    [[nodiscard]] const std::string& Address() const
    {
        return address_;
    }
    [[nodiscard]] std::unique_ptr<LiveBus> Open(const LiveOptions& options = {})
    {
        std::thread greeter{[this]
                            {
                                Accept();
                                Say(kForeignGreeting);
                            }};
        std::unique_ptr<LiveBus> bus = OpenLiveBus(address_, options);
        greeter.join();
        return bus;
    }
    /// The next client in the place of the one before.
    void Accept()
    {
        Close();
        connection_ = ::accept(listener_, nullptr, nullptr);
        heard_.clear();
    }
    bool Say(const std::string& text) const
    {
        return ::send(connection_, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
    }
    /// Until the client has asked for another echo; it gives no frame meanwhile.
    void AwaitEcho(LiveBus& bus)
    {
        const std::uint64_t start_ns = LiveNow();
        std::size_t at = std::string::npos;
        while (at == std::string::npos)
        {
            LiveFrame frame;
            ASSERT_FALSE(bus.Receive(frame));
            ASSERT_LT(LiveNow() - start_ns, kLongestWaitNs);
            char text[256];
            const ssize_t length = ::recv(connection_, text, sizeof(text), MSG_DONTWAIT);
            heard_.append(text, (length > 0) ? static_cast<std::size_t>(length) : 0U);
            at = heard_.find("echo");
        }
        heard_.erase(0U, at + 4U);
    }
    /// What the client has said until now is taken.
    void Read() const
    {
        char text[4096];
        while (::recv(connection_, text, sizeof(text), MSG_DONTWAIT) > 0)
        {
        }
    }
    /// Whether the client asks for another echo in that time; it gives no frame meanwhile.
    [[nodiscard]] bool HearsEcho(LiveBus& bus, const std::uint64_t duration_ns)
    {
        const std::uint64_t start_ns = LiveNow();
        while (LiveNow() - start_ns < duration_ns)
        {
            LiveFrame frame;
            EXPECT_FALSE(bus.Receive(frame));
        }
        char text[256];
        const ssize_t length = ::recv(connection_, text, sizeof(text), MSG_DONTWAIT);
        heard_.append(text, (length > 0) ? static_cast<std::size_t>(length) : 0U);
        return heard_.find("echo") != std::string::npos;
    }
    void Close()
    {
        if (connection_ >= 0)
        {
            static_cast<void>(::close(connection_));
            connection_ = -1;
        }
    }

  private:
    int listener_;
    int connection_{-1};
    std::string heard_;
    std::string address_;
};

/// Serves the bus as an owner does until it has that state; false: it had not within minutes.
bool ComesTo(LiveBus& bus, const BusState state)
{
    const std::uint64_t start_ns = LiveNow();
    LiveFrame frame;
    while ((bus.Health().state != state) && (LiveNow() - start_ns < kLongestWaitNs))
    {
        pollfd wait{bus.Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&wait, 1U, 5));
        static_cast<void>(bus.Receive(frame));
    }
    return bus.Health().state == state;
}

LiveOptions OptionsThatAsk(const std::uint32_t oldest_ms, const std::uint32_t answer_ms)
{
    LiveOptions options;
    options.reconnect_after_ms = 20U;
    options.oldest_ms = oldest_ms;
    options.answer_ms = answer_ms;
    return options;
}

constexpr std::uint32_t kAnHourMs = 3'600'000U;

// Given a bus that is off and works again within one reading, so that its state never shows it, then each absence
// counts, and once, by whatever it was told.
TEST(SocketcandGapTest, EachAbsenceCountsHoweverShort)
{
    Verifies(req::SRS_LIVE_580);
    ToldServer server;
    const auto bus = server.Open();
    // The digits of the identifier are hexadecimal on the wire.
    const auto absences_behind = [&](const std::string& text, const std::uint32_t identifier)
    {
        EXPECT_TRUE(server.Say(text + "< frame " + std::to_string(identifier) + " 1.0 AA >"));
        std::optional<LiveFrame> frame = Wait(*bus);
        while (frame && frame->error)
        {
            frame = Wait(*bus);
        }
        EXPECT_TRUE(frame && frame->identifier == 0x100U + (identifier - 100U));
        EXPECT_EQ(bus->Health().state, BusState::kActive);
        return bus->Health().absences;
    };
    EXPECT_EQ(absences_behind("", 100U), 0U);
    EXPECT_EQ(bus->Health().absence, BusState::kInvalid);
    EXPECT_EQ(absences_behind("< error 040 1.0 >", 101U), 1U);
    EXPECT_EQ(bus->Health().absence, BusState::kBusOff);
    // Told twice, and its end
    EXPECT_EQ(absences_behind("< error 040 1.0 >< error 040 1.0 >< error 100 1.0 >", 102U), 2U);
    // The end alone: its begin was not heard
    EXPECT_EQ(absences_behind("< error 100 1.0 >", 103U), 3U);
    // Another error is none
    EXPECT_EQ(absences_behind("< error 008 1.0 >", 104U), 3U);
    // By the answer to an order to send; what goes down while it is off is away once
    EXPECT_EQ(absences_behind("< error send: bus-off >", 105U), 4U);
    EXPECT_EQ(absences_behind("< error send: bus-off >< error send: the bus is down >", 106U), 5U);
    EXPECT_EQ(bus->Health().absence, BusState::kDown);
    EXPECT_EQ(bus->Health().bus_offs, 3U);
    // And a connection that is lost
    server.Close();
    ASSERT_TRUE(ComesTo(*bus, BusState::kDown));
    EXPECT_EQ(bus->Health().absences, 6U);
}

// Given a question that has no answer, then the connection is a lost one at its time, and on the next one frames pass
// behind an answer.
TEST(SocketcandGapTest, AnAnswerThatDoesNotComeLeadsToANewConnection)
{
    Verifies(req::SRS_LIVE_581);
    ToldServer server;
    const auto bus = server.Open(OptionsThatAsk(kAnHourMs, 50U));
    ASSERT_NO_FATAL_FAILURE(server.AwaitEcho(*bus));
    ASSERT_TRUE(ComesTo(*bus, BusState::kDown));
    EXPECT_EQ(bus->Health().absence, BusState::kDown);
    EXPECT_EQ(bus->Health().reconnects, 0U);
    // What is said on the old connection is heard by nobody
    static_cast<void>(server.Say("< echo >< frame 001 1.0 AA >"));
    std::thread greeter{[&server]
                        {
                            server.Accept();
                            EXPECT_TRUE(server.Say(std::string{kForeignGreeting} + "< frame 002 1.0 BB >"));
                        }};
    const std::optional<LiveFrame> frame = Wait(*bus);
    greeter.join();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->identifier, 2U);
    EXPECT_EQ(bus->Health().reconnects, 1U);
}

// Given a question without an answer, then what comes meanwhile stays aside, and nothing ends before its time.
TEST(SocketcandGapTest, WhileAnAnswerIsAwaitedFramesStayAside)
{
    Verifies(req::SRS_LIVE_059);
    Verifies(req::SRS_LIVE_581);
    ToldServer server;
    const auto bus = server.Open(OptionsThatAsk(1U, kAnHourMs));
    ASSERT_NO_FATAL_FAILURE(server.AwaitEcho(*bus));
    const std::uint64_t start_ns = LiveNow();
    while (LiveNow() - start_ns < 10'000'000U)
    {
    }
    ASSERT_TRUE(server.Say("< frame 001 1.0 AA >"));
    LiveFrame frame;
    while (bus->Health().stale_frames == 0U)
    {
        ASSERT_FALSE(bus->Receive(frame));
    }
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().absences, 0U);
    // An error frame passes
    ASSERT_TRUE(server.Say("< error 008 1.0 >"));
    const std::optional<LiveFrame> error = Wait(*bus);
    ASSERT_TRUE(error);
    EXPECT_TRUE(error->error);
    EXPECT_EQ(bus->Health().stale_frames, 1U);
}

// Given a server that answers each question at once, then five of them take four times 20 ms; one without an answer is
// the only one, and without a greatest age none is asked.
TEST(SocketcandGapTest, OneQuestionAtATimeIsAskedEvery20Ms)
{
    Verifies(req::SRS_LIVE_059);
    ToldServer server;
    const auto bus = server.Open(OptionsThatAsk(kAnHourMs, kAnHourMs));
    ASSERT_NO_FATAL_FAILURE(server.AwaitEcho(*bus));
    const std::uint64_t start_ns = LiveNow();
    for (int question = 0; question < 4; ++question)
    {
        ASSERT_TRUE(server.Say("< echo >"));
        ASSERT_NO_FATAL_FAILURE(server.AwaitEcho(*bus));
    }
    EXPECT_GE(LiveNow() - start_ns, 3U * 20'000'000U); // The first one may have been asked before the begin.
    EXPECT_FALSE(server.HearsEcho(*bus, 100'000'000U));
    ToldServer other;
    LiveOptions without;
    const auto silent = other.Open(without);
    EXPECT_FALSE(other.HearsEcho(*silent, 100'000'000U));
    // What holds where nothing else is said
    EXPECT_EQ(without.oldest_ms, 0U);
    EXPECT_EQ(without.reconnect_after_ms, 500U);
    EXPECT_EQ(without.answer_ms, 5000U);
}

// Given two answers to one question, then the connection is a lost one: the second could count for a later question.
TEST(SocketcandGapTest, AnAnswerToNoQuestionLeadsToANewConnection)
{
    Verifies(req::SRS_LIVE_581);
    ToldServer server;
    const auto bus = server.Open(OptionsThatAsk(kAnHourMs, kAnHourMs));
    ASSERT_NO_FATAL_FAILURE(server.AwaitEcho(*bus));
    ASSERT_TRUE(server.Say("< echo >< echo >< frame 001 1.0 AA >"));
    ASSERT_TRUE(ComesTo(*bus, BusState::kDown));
    EXPECT_EQ(bus->Health().absences, 1U);
    LiveFrame frame;
    EXPECT_FALSE(bus->Receive(frame));
}

// Given a server that gives no echo, then 4096 frames wait for theirs and 64 in the queue; with an echo one more goes.
TEST(SocketcandGapTest, FramesWithoutEchoWaitInTheQueueInTheEnd)
{
    Verifies(req::SRS_LIVE_660);
    ToldServer server;
    const auto bus = server.Open();
    LiveFrame frame;
    frame.identifier = 0x181U;
    frame.length_bytes = 1U;
    // Each look reads what the connection holds: the server is not what they wait for
    const auto send = [&]
    {
        server.Read();
        return bus->Send(frame);
    };
    for (int sent = 0; sent < 4096; ++sent)
    {
        ASSERT_EQ(send(), SendResult::kSent) << sent;
        while (bus->Health().waiting != 0U)
        {
            server.Read();
            LiveFrame none;
            ASSERT_FALSE(bus->Receive(none));
        }
    }
    for (int waiting = 0; waiting < 64; ++waiting)
    {
        ASSERT_EQ(send(), SendResult::kSent) << waiting;
    }
    EXPECT_EQ(bus->Health().waiting, 64U);
    EXPECT_EQ(send(), SendResult::kQueueFull);
    ASSERT_TRUE(server.Say("< echo >"));
    const std::optional<LiveFrame> own = Wait(*bus);
    ASSERT_TRUE(own);
    EXPECT_TRUE(own->own);
    EXPECT_EQ(own->identifier, 0x181U);
    EXPECT_EQ(send(), SendResult::kSent);
    EXPECT_EQ(bus->Health().waiting, 64U);
    EXPECT_EQ(send(), SendResult::kQueueFull);
}

// Given a server that sends frames again and again, and no answer to the last order, then the client gives up in its
// time, and says which answer it waited for.
TEST(SocketcandGapTest, AServerThatSendsInsteadOfAnsweringIsGivenUp)
{
    Verifies(req::SRS_LIVE_051);
    Verifies(req::SRS_LIVE_582);
    ToldServer server;
    std::thread sender{[&server]
                       {
                           server.Accept();
                           bool is_there = server.Say("< hi >< ok >< ok >");
                           while (is_there)
                           {
                               is_there = server.Say("< frame 723 1.0 05 >");
                               static_cast<void>(::poll(nullptr, 0U, 50));
                           }
                       }};
    const std::uint64_t start_ns = LiveNow();
    const std::string problem = ProblemOf([&] { static_cast<void>(OpenLiveBus(server.Address())); });
    EXPECT_EQ(problem, "bus '" + server.Address() +
                           "': the server did not answer ownmode within 3 s, expected the socketcand protocol");
    EXPECT_GE(LiveNow() - start_ns, 3'000'000'000U);
    sender.join();
}

/// Both ends of a connection.
struct SocketPair
{
    SocketPair()
    {
        EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, files), 0);
    }
    int files[2]{-1, -1};
};

/// What a greeting makes of what a server says.
struct Greeted
{
    void Say(const std::string& text)
    {
        EXPECT_EQ(::send(ends.files[1], text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
        link.Read();
        greeting.GoOn(link);
    }

    SocketPair ends{};
    SocketcandLink link{LiveFile{ends.files[0]}};
    LiveFile server{ends.files[1]};
    SocketcandGreeting greeting{"can0"};
};

TEST(SocketcandGapTest, AGreetingNamesTheAnswerThatItAwaits)
{
    Verifies(req::SRS_LIVE_582);
    Greeted client;
    EXPECT_EQ(client.greeting.Awaited(), "say hi");
    client.Say("< hi >");
    EXPECT_EQ(client.greeting.Awaited(), "answer open");
    client.Say("< ok >");
    EXPECT_EQ(client.greeting.Awaited(), "answer rawmode");
    client.Say("< ok >");
    EXPECT_EQ(client.greeting.Awaited(), "answer ownmode");
    client.Say("< ok >");
    EXPECT_TRUE(client.greeting.IsOver());
}

// Given a server that floods instead of answering, then 65535 messages are kept, and with one more it is refused.
TEST(SocketcandGapTest, AGreetingKeepsNoMoreThanABusCarriesInItsTime)
{
    Verifies(req::SRS_LIVE_582);
    Greeted client;
    client.Say("< hi >< ok >< ok >");
    std::string text;
    for (int i = 0; i < 255; ++i)
    {
        text += "< frame 723 1.0 05 >";
    }
    for (int turn = 0; turn < 257; ++turn)
    {
        client.Say(text);
    }
    EXPECT_EQ(client.greeting.Early().size(), 65535U);
    EXPECT_EQ(client.greeting.Problem(), "");
    client.Say("< frame 723 1.0 05 >");
    EXPECT_EQ(client.greeting.Problem(),
              "the server did not answer ownmode, but sent 65536 messages of the bus, more than one carries in 3 s");
    EXPECT_FALSE(client.greeting.IsOver());
}

// Given malformed elements, then the last one is told in words; before it nothing is.
TEST(SocketcandGapTest, WhatIsMalformedIsToldInWords)
{
    Verifies(req::SRS_LIVE_583);
    ToldServer server;
    const auto bus = server.Open();
    EXPECT_EQ(bus->Problem(), "");
    ASSERT_TRUE(server.Say("< frame 103 zz 0101 >< frame 1G4 1.0 FE >< frame 001 1.0 AA >"));
    ASSERT_TRUE(Wait(*bus));
    EXPECT_EQ(bus->Health().malformed, 2U);
    EXPECT_EQ(bus->Problem(),
              "frame: identifier '1G4', expected 1 to 3 hexadecimal digits up to 7FF, or 8 up to 1FFFFFFF");
    // An answer that is none of an error is nothing malformed
    ASSERT_TRUE(server.Say("< ok >< frame 001 1.0 AA >"));
    ASSERT_TRUE(Wait(*bus));
    EXPECT_EQ(bus->Health().malformed, 2U);
    // On a bus of this machine a datagram
    const std::string group = "239.74.163.12";
    const int port = 20'000 + (::getpid() % 40'000);
    const auto udp = OpenLiveBus("udp:" + group + ":" + std::to_string(port));
    EXPECT_EQ(udp->Problem(), "");
    const int sender = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(port));
    place.sin_addr.s_addr = ::inet_addr(group.c_str());
    const in_addr loopback{htonl(INADDR_LOOPBACK)};
    static_cast<void>(::setsockopt(sender, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof(loopback)));
    ASSERT_EQ(::sendto(sender, "abc", 3U, 0, reinterpret_cast<const sockaddr*>(&place), sizeof(place)), 3);
    static_cast<void>(::close(sender));
    const std::uint64_t start_ns = LiveNow();
    LiveFrame frame;
    while ((udp->Health().malformed == 0U) && (LiveNow() - start_ns < kLongestWaitNs))
    {
        EXPECT_FALSE(udp->Receive(frame));
    }
    EXPECT_EQ(udp->Problem(), "a datagram of 3 bytes, expected a frame of this bus");
}

} // namespace
} // namespace counterpoint::host
