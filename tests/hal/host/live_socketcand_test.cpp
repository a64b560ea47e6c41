// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Server and client of the socketcand protocol, over loopback and a UDP bus.
#include "hal/host/live/socketcand/link.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "tests/hal/host/live_server_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace counterpoint::host
{
namespace
{

std::string Group(const std::string& option)
{
    return "udp:239.74.163.10:" + std::to_string(20'000 + (::getpid() % 40'000)) + option;
}

/// A connection that says and hears plain text.
class PlainClient
{
  public:
    explicit PlainClient(const std::uint16_t port) : socket_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        sockaddr_in server{};
        server.sin_family = AF_INET;
        server.sin_port = htons(port);
        server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&server), sizeof(server)), 0);
        const timeval patience{300, 0};
        static_cast<void>(::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience)));
        static_cast<void>(::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience)));
    }
    ~PlainClient()
    {
        static_cast<void>(::close(socket_));
    }
    PlainClient(const PlainClient&) = delete;
    PlainClient& operator=(const PlainClient&) = delete;
    void Say(const std::string& text) const
    {
        EXPECT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }
    /// The next element; empty: the connection ended, or nothing came.
    [[nodiscard]] std::string Hear() const
    {
        std::string text;
        char letter = '\0';
        while ((text.empty() || (text.back() != '>')) && (::recv(socket_, &letter, 1U, 0) == 1))
        {
            text += letter;
        }
        return text;
    }

  private:
    int socket_;
};

/// A server by others, whose bus has an error when the test says so. Whoever opens it first goes again.
class FailingWire
{
  public:
    FailingWire() : listener_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t bytes = sizeof(own);
        EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
        EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
        EXPECT_EQ(::listen(listener_, 2), 0);
        port_ = ntohs(own.sin_port);
        thread_ = std::thread{[this]
                              {
                                  for (int& connection : connections_)
                                  {
                                      connection = ::accept(listener_, nullptr, nullptr);
                                      Say(connection, "< hi >< ok >< ok >< error unknown command >");
                                  }
                              }};
    }
    ~FailingWire()
    {
        for (const int connection : connections_)
        {
            static_cast<void>(::close(connection));
        }
        static_cast<void>(::close(listener_));
    }
    FailingWire(const FailingWire&) = delete;
    FailingWire& operator=(const FailingWire&) = delete;
    [[nodiscard]] std::string Address() const
    {
        return "socketcand:127.0.0.1:" + std::to_string(port_) + "/can0";
    }
    void Fail() const
    {
        thread_.join();
        Say(connections_[1], "< error 040 1.0 >");
    }

  private:
    static void Say(const int connection, const std::string& text)
    {
        EXPECT_EQ(::send(connection, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }

    int listener_;
    std::uint16_t port_{0U};
    std::array<int, 2> connections_{-1, -1};
    mutable std::thread thread_;
};

class Socketcand : public ::testing::Test
{
  protected:
    RunningServer server{Group("")};
};

// Given more connections than there are places, all silent, then whoever comes next is served, and who has opened a bus
// keeps his place.
TEST_F(Socketcand, SilentConnectionsCloseTheBusToNobody)
{
    Verifies(req::SRS_LIVE_061);
    const auto first = OpenLiveBus(server.Address("can0"));
    std::vector<std::unique_ptr<PlainClient>> silent;
    for (std::size_t i = 0U; i < kSocketcandClients + 4U; ++i)
    {
        silent.push_back(std::make_unique<PlainClient>(server.Port()));
        EXPECT_EQ(silent.back()->Hear(), "< hi >");
    }
    const auto last = OpenLiveBus(server.Address("can0"));
    ASSERT_EQ(last->Send(Live(0x123U, {1U})), SendResult::kSent);
    EXPECT_EQ(Wait(*first)->identifier, 0x123U);
}

// Given a process without a descriptor left, then an open ends that connection, and all others go on.
TEST_F(Socketcand, AnOpenWithoutADescriptorEndsThatConnectionAlone)
{
    Verifies(req::SRS_LIVE_061);
    const auto bus = OpenLiveBus(server.Address("can0"));
    const PlainClient client(server.Port());
    EXPECT_EQ(client.Hear(), "< hi >");
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none{3U, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    client.Say("< open can0 >");
    const std::string answer = client.Hear();
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(answer.substr(0U, 8U), "< error ");
    EXPECT_EQ(client.Hear(), "");
    const auto next = OpenLiveBus(server.Address("can0"));
    ASSERT_EQ(next->Send(Live(0x124U, {1U})), SendResult::kSent);
    EXPECT_EQ(Wait(*bus)->identifier, 0x124U);
}

// Given a process that may have fewer descriptors than its connections would need with a bus each, then whoever comes
// next is served.
TEST_F(Socketcand, ConnectionsWithoutABusCountForTheirOwnDescriptorsAlone)
{
    Verifies(req::SRS_LIVE_061);
    const int of_caller = ::open("/dev/null", O_RDONLY);
    const int of_server = ::open("/dev/null", O_RDONLY);
    std::vector<std::unique_ptr<PlainClient>> silent;
    for (std::size_t i = 0U; i < kSocketcandClients - 4U; ++i)
    {
        silent.push_back(std::make_unique<PlainClient>(server.Port()));
        EXPECT_EQ(silent.back()->Hear(), "< hi >");
    }
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit few{kSocketcandClients, before.rlim_max};
    ASSERT_LT(of_server, static_cast<int>(kSocketcandClients));
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
    silent.back()->Say("< echo >"); // What the server waits for from now on, it asks for under the new limit.
    EXPECT_EQ(silent.back()->Hear(), "< echo >");
    ::close(of_caller);
    ::close(of_server);
    const PlainClient last(server.Port());
    const std::string answer = last.Hear();
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(answer, "< hi >");
}

// Given a client and a member of the bus behind the server, then frames of every kind go both ways unchanged, and those
// of the client come back to it as own.
TEST_F(Socketcand, CarriesBothWays)
{
    Verifies(req::SRS_LIVE_051);
    Verifies(req::SRS_LIVE_052);
    Verifies(req::SRS_LIVE_053);
    const auto client = OpenLiveBus(server.Address("can0"));
    const auto member = OpenLiveBus(Group(""));
    LiveFrame extended = Live(0x1ABC'DEF0U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U});
    extended.extended = true;
    LiveFrame remote = Live(0x701U, {});
    remote.remote = true;
    remote.length_bytes = 5U;
    for (const LiveFrame& sent : {Live(0x123U, {0xA5U}), extended, remote, Live(0U, {})})
    {
        for (const bool is_client : {true, false})
        {
            LiveBus& from = is_client ? *client : *member;
            ASSERT_EQ(from.Send(sent), SendResult::kSent);
            for (LiveBus* const bus : {client.get(), member.get()})
            {
                const std::optional<LiveFrame> got = Wait(*bus);
                ASSERT_TRUE(got);
                EXPECT_EQ(got->own, bus == &from);
                EXPECT_EQ(got->identifier, sent.identifier);
                EXPECT_EQ(got->extended, sent.extended);
                EXPECT_EQ(got->remote, sent.remote);
                EXPECT_EQ(got->length_bytes, sent.length_bytes);
                EXPECT_TRUE(std::equal(std::begin(got->data), std::end(got->data), std::begin(sent.data)));
                EXPECT_LE(got->time_ns, LiveNow());
            }
        }
    }
    EXPECT_EQ(client->Health().state, BusState::kActive);
    EXPECT_EQ(client->Name(), server.Address("can0"));
    EXPECT_FALSE(client->Restart());
    LiveFrame flexible = Live(1U, {});
    flexible.fd = true;
    EXPECT_EQ(client->Send(flexible), SendResult::kRefused);
}

// Given two clients, then each is a sender of its own: a frame of one is no own frame of the other.
TEST_F(Socketcand, ServesSeveralClients)
{
    Verifies(req::SRS_LIVE_053);
    const auto one = OpenLiveBus(server.Address("can0"));
    const auto other = OpenLiveBus(server.Address("can0"));
    ASSERT_EQ(one->Send(Live(0x42U, {1U})), SendResult::kSent);
    EXPECT_TRUE(Wait(*one)->own);
    EXPECT_FALSE(Wait(*other)->own);
    EXPECT_EQ(server.Counts().clients, 2U);
}

// Given a program by others, which says only what the protocol's text has, then the answers are those of the protocol
// and its own frames are not told.
TEST_F(Socketcand, TalksAsTheProtocolSays)
{
    Verifies(req::SRS_LIVE_053);
    const auto member = OpenLiveBus(Group(""));
    const PlainClient client(server.Port());
    EXPECT_EQ(client.Hear(), "< hi >");
    client.Say("< open can0 >< rawmode >");
    EXPECT_EQ(client.Hear(), "< ok >");
    EXPECT_EQ(client.Hear(), "< ok >");
    client.Say("< send 123 2 1 f1 >< echo >");
    EXPECT_EQ(client.Hear(), "< echo >");
    const std::optional<LiveFrame> frame = Wait(*member);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->identifier, 0x123U);
    EXPECT_EQ(frame->data[1], 0xF1U);
    ASSERT_EQ(member->Send(Live(0x7FFU, {0x11U, 0x22U})), SendResult::kSent);
    const std::string told = client.Hear();
    EXPECT_EQ(told.substr(0U, 12U), "< frame 7FF ");
    EXPECT_EQ(told.substr(told.size() - 7U), " 1122 >");
    client.Say("< bcmmode >");
    EXPECT_EQ(client.Hear(), "< ok >");
    ASSERT_EQ(member->Send(Live(0x7FEU, {})), SendResult::kSent);
    client.Say("< echo >");
    EXPECT_EQ(client.Hear(), "< echo >");
}

// Given orders that are malformed or not due, then each is answered by a sentence and the connection goes on.
TEST_F(Socketcand, TakesRemoteFramesAndTellsThem)
{
    Verifies(req::SRS_LIVE_053);
    const auto member = OpenLiveBus(Group(""));
    const PlainClient client(server.Port());
    EXPECT_EQ(client.Hear(), "< hi >");
    client.Say("< open can0 >< rawmode >< sendrtr 123 4 >< echo >");
    EXPECT_EQ(client.Hear(), "< ok >");
    EXPECT_EQ(client.Hear(), "< ok >");
    EXPECT_EQ(client.Hear(), "< echo >");
    const std::optional<LiveFrame> frame = Wait(*member);
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->remote);
    EXPECT_EQ(frame->identifier, 0x123U);
    EXPECT_EQ(frame->length_bytes, 4U);
    LiveFrame remote = Live(0x701U, {});
    remote.remote = true;
    remote.length_bytes = 1U;
    ASSERT_EQ(member->Send(remote), SendResult::kSent);
    const std::string told = client.Hear();
    EXPECT_EQ(told.substr(0U, 10U), "< rtr 701 ");
    EXPECT_EQ(told.substr(told.size() - 4U), " 1 >");
}

// Given a server with two buses, then a client of each hears what is on its own one alone.
TEST(SocketcandServerTest, OffersSeveralBuses)
{
    Verifies(req::SRS_LIVE_053);
    const std::string second = "udp:239.74.163.11:" + std::to_string(20'000 + (::getpid() % 40'000));
    const RunningServer server{std::vector<ServedBus>{{"can0", Group("")}, {"can1", second}}};
    const auto one = OpenLiveBus(server.Address("can0"));
    const auto two = OpenLiveBus(server.Address("can1"));
    const auto of_one = OpenLiveBus(Group(""));
    const auto of_two = OpenLiveBus(second);
    ASSERT_EQ(of_one->Send(Live(0x11U, {})), SendResult::kSent);
    ASSERT_EQ(of_two->Send(Live(0x22U, {})), SendResult::kSent);
    EXPECT_EQ(Wait(*one)->identifier, 0x11U);
    EXPECT_EQ(Wait(*two)->identifier, 0x22U);
    LiveFrame none;
    EXPECT_FALSE(one->Receive(none));
    EXPECT_FALSE(two->Receive(none));
}

// Given a bus behind the server on which the wire has an error, then a client in raw mode is told its classes.
TEST(SocketcandServerTest, TellsErrorClassesInRawMode)
{
    Verifies(req::SRS_LIVE_053);
    const FailingWire wire;
    const RunningServer server{wire.Address()};
    const PlainClient client(server.Port());
    EXPECT_EQ(client.Hear(), "< hi >");
    client.Say("< open can0 >< rawmode >");
    EXPECT_EQ(client.Hear(), "< ok >");
    EXPECT_EQ(client.Hear(), "< ok >");
    wire.Fail();
    EXPECT_EQ(client.Hear().substr(0U, 12U), "< error 040 ");
}

TEST_F(Socketcand, AnswersWhatIsWrong)
{
    Verifies(req::SRS_LIVE_050);
    Verifies(req::SRS_LIVE_053);
    const PlainClient client(server.Port());
    EXPECT_EQ(client.Hear(), "< hi >");
    client.Say("< send 123 0 >");
    EXPECT_EQ(client.Hear(), "< error no bus is open, expected open first >");
    client.Say("< open can0 >< ownmode >< open can0 >< send 123 2 1 >\x01\x02< echo >");
    EXPECT_EQ(client.Hear(), "< ok >");
    const std::string not_now =
        "< error not now, expected rawmode, bcmmode, send, sendrtr, echo, or ownmode in raw mode >";
    EXPECT_EQ(client.Hear(), not_now);
    EXPECT_EQ(client.Hear(), not_now);
    EXPECT_EQ(client.Hear(), "< error send: count of data bytes '1', expected 2 as the length says >");
    EXPECT_EQ(client.Hear(), "< error '?"
                             "?' outside of angle brackets, expected an element >");
    EXPECT_EQ(client.Hear(), "< echo >");
}

// Given a bus that is not served, and one that cannot be opened, then the server says so and ends the connection.
TEST_F(Socketcand, RefusesABusThatIsNotThere)
{
    Verifies(req::SRS_LIVE_051);
    Verifies(req::SRS_LIVE_053);
    const PlainClient client(server.Port());
    EXPECT_EQ(client.Hear(), "< hi >");
    client.Say("< open can9 >");
    EXPECT_EQ(client.Hear(), "< error no bus of that name, expected can0 >");
    EXPECT_EQ(client.Hear(), "");
    EXPECT_EQ(ProblemOf([this] { static_cast<void>(OpenLiveBus(server.Address("can9"))); }),
              "bus '" + server.Address("can9") + "': the server says: no bus of that name, expected can0");
}

// Given a slow bus behind the server, when a client sends 300 frames at once, then all arrive in order.
TEST(SocketcandServerTest, HoldsFramesForAFullBus)
{
    Verifies(req::SRS_LIVE_054);
    const RunningServer server{Group("?bitrate=1000000")};
    const auto member = OpenLiveBus(Group(""));
    const PlainClient client(server.Port());
    std::string orders = "< open can0 >";
    for (int n = 0; n < 300; ++n)
    {
        orders += "< send 100 2 " + std::to_string(n / 100) + " " + std::to_string(n % 100) + " >";
    }
    client.Say(orders);
    for (int n = 0; n < 300; ++n)
    {
        const std::optional<LiveFrame> frame = Wait(*member);
        ASSERT_TRUE(frame) << n;
        // The numbers were read as hexadecimal ones.
        ASSERT_EQ(frame->data[0], n / 100);
        ASSERT_EQ(frame->data[1], (((n % 100) / 10) * 16) + (n % 10));
    }
}

// Given a client that never reads, when more than 1 MiB waits for it, then it is disconnected and the server goes on.
TEST(SocketcandServerTest, DisconnectsWhoDoesNotRead)
{
    Verifies(req::SRS_LIVE_054);
    const RunningServer server{Group("")};
    const auto member = OpenLiveBus(Group(""));
    const PlainClient client(server.Port());
    client.Say("< open can0 >< rawmode >");
    const std::uint64_t start_ns = LiveNow();
    LiveFrame own;
    std::uint64_t frames = 0U;
    while ((server.Counts().too_slow == 0U) && (LiveNow() - start_ns < 600'000'000'000U))
    {
        static_cast<void>(member->Send(Live(0x100U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U})));
        static_cast<void>(member->Receive(own));
        ++frames;
    }
    EXPECT_EQ(server.Counts().too_slow, 1U);
    // "< frame 100 SECONDS.MICROSECONDS 0102030405060708 >" and less than 50 bytes of text behind them: not before
    EXPECT_GE(frames * 64U, 1024U * 1024U);
    EXPECT_TRUE(OpenLiveBus(server.Address("can0")));
}

// Given a port that is in use, then the server says so.
TEST(SocketcandServerTest, RefusesAPortInUse)
{
    Verifies(req::SRS_LIVE_053);
    const RunningServer server{Group("")};
    const std::string port = std::to_string(server.Port());
    EXPECT_EQ(ProblemOf([&server] { static_cast<void>(SocketcandServer("127.0.0.1", server.Port(), {})); }),
              "socketcand server at 127.0.0.1 port " + port +
                  ": Address already in use, expected a free port of this "
                  "machine");
}

// Given a connection on which both ends talk, after which the system acknowledges late, when an end reads, then at
// once.
TEST(SocketcandLinkTest, AcknowledgesWhatItReadsAtOnce)
{
    Verifies(req::SRS_LIVE_330);
    const LiveFile listener{::socket(AF_INET, SOCK_STREAM, 0)};
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t bytes = sizeof(place);
    ASSERT_EQ(::bind(listener.Get(), reinterpret_cast<const sockaddr*>(&place), bytes), 0);
    ASSERT_EQ(::listen(listener.Get(), 1), 0);
    ASSERT_EQ(::getsockname(listener.Get(), reinterpret_cast<sockaddr*>(&place), &bytes), 0);
    const PlainClient client{ntohs(place.sin_port)};
    LiveFile accepted{::accept(listener.Get(), nullptr, nullptr)};
    const LiveFile watched{::dup(accepted.Get())};
    SocketcandLink link{std::move(accepted)};
    for (int turn = 0; turn < 8; ++turn)
    {
        client.Say("< echo >");
        while (!link.Next())
        {
            link.Read();
        }
        int is_quick = 0;
        socklen_t length = sizeof(is_quick);
        ASSERT_EQ(::getsockopt(watched.Get(), IPPROTO_TCP, TCP_QUICKACK, &is_quick, &length), 0);
        EXPECT_EQ(is_quick, 1) << turn;
        link.Say(SocketcandWord::kEcho);
    }
}

} // namespace
} // namespace counterpoint::host
