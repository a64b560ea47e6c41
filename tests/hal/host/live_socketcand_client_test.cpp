// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The client of the socketcand protocol, with servers that the test makes.
#include "hal/host/live/socketcand/server.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "tests/hal/host/live_server_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

#include <atomic>
#include <sys/resource.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

// Given no server, a host that is none, and a server that says nothing of the protocol, then one sentence says so.
TEST(SocketcandClientTest, SaysWhatItCannotReach)
{
    Verifies(req::SRS_LIVE_051);
    const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t bytes = sizeof(own);
    ASSERT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
    ASSERT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
    const std::string port = std::to_string(ntohs(own.sin_port));
    const std::string address = "socketcand:127.0.0.1:" + port + "/can0";
    const auto problem = [&address] { return ProblemOf([&address] { static_cast<void>(OpenLiveBus(address)); }); };
    EXPECT_EQ(problem(),
              "bus '" + address + "': Connection refused, expected a socketcand server at 127.0.0.1 port " + port);
    ASSERT_EQ(::listen(listener, 1), 0);
    const std::uint64_t start_ns = LiveNow();
    EXPECT_EQ(problem(), "bus '" + address + "': the server said nothing for 3 s, expected the socketcand protocol");
    EXPECT_GE(LiveNow() - start_ns, 3'000'000'000U);
    static_cast<void>(::close(listener));
}

/// A server by others, of which the test says what it says. It knows no ownmode.
class ForeignServer
{
  public:
    ForeignServer() : listener_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t bytes = sizeof(own);
        EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
        EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
        EXPECT_EQ(::listen(listener_, 1), 0);
        address_ = "socketcand:127.0.0.1:" + std::to_string(ntohs(own.sin_port)) + "/can0";
        // What a client waits for can be said before it asks.
        thread_ = std::thread{[this]
                              {
                                  connection_ = ::accept(listener_, nullptr, nullptr);
                                  Say("< hi >< ok >< ok >< frame 001 1.0 AA >< error unknown command >");
                              }};
    }
    ~ForeignServer()
    {
        Close();
        static_cast<void>(::close(listener_));
    }
    ForeignServer(const ForeignServer&) = delete;
    ForeignServer& operator=(const ForeignServer&) = delete;
    [[nodiscard]] std::unique_ptr<LiveBus> Open(const LiveOptions& options = {})
    {
        std::unique_ptr<LiveBus> bus = OpenLiveBus(address_, options);
        thread_.join();
        return bus;
    }
    void Say(const std::string& text) const
    {
        static_cast<void>(::send(connection_, text.data(), text.size(), MSG_NOSIGNAL));
    }
    /// Until the client has asked for so many echoes that no earlier call has counted; it gives no frame meanwhile.
    void AwaitEchoes(LiveBus& bus, const std::uint32_t count)
    {
        constexpr const char* kWord = "echo";
        for (std::uint32_t done = 0U; done < count;)
        {
            LiveFrame frame;
            ASSERT_FALSE(bus.Receive(frame));
            ASSERT_NE(bus.Health().state, BusState::kDown);
            char text[256];
            const ssize_t length = ::recv(connection_, text, sizeof(text), MSG_DONTWAIT);
            heard_.append(text, (length > 0) ? static_cast<std::size_t>(length) : 0U);
            const std::size_t at = heard_.find(kWord);
            if (at != std::string::npos)
            {
                heard_.erase(0U, at + std::string{kWord}.size());
                ++done;
            }
        }
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
    std::thread thread_;
};

// Given a server without ownmode, then a frame that came during the greeting is not lost, a sent frame is own when the
// echo behind it is answered and not before, and what is malformed is counted.
TEST(SocketcandClientTest, ConfirmsByEchoWhereTheServerTellsNoOwnFrames)
{
    Verifies(req::SRS_LIVE_003);
    Verifies(req::SRS_LIVE_051);
    Verifies(req::SRS_LIVE_052);
    ForeignServer server;
    const auto bus = server.Open();
    EXPECT_EQ(Wait(*bus)->identifier, 1U);
    ASSERT_EQ(bus->Send(Live(0x123U, {7U})), SendResult::kSent);
    ASSERT_EQ(bus->Send(Live(0x124U, {})), SendResult::kSent);
    server.Say("< frame 002 1.0 >< nonsense >< echo >< error 040 1.0 >");
    EXPECT_EQ(Wait(*bus)->identifier, 2U);
    const std::optional<LiveFrame> own = Wait(*bus);
    ASSERT_TRUE(own);
    EXPECT_TRUE(own->own);
    EXPECT_EQ(own->identifier, 0x123U);
    EXPECT_EQ(own->data[0], 7U);
    const std::optional<LiveFrame> error = Wait(*bus);
    ASSERT_TRUE(error);
    EXPECT_TRUE(error->error);
    EXPECT_EQ(error->identifier, 0x40U);
    EXPECT_EQ(bus->Health().state, BusState::kBusOff);
    EXPECT_EQ(bus->Health().bus_offs, 1U);
    EXPECT_EQ(bus->Health().malformed, 1U);
}

// Given a greatest age, then what comes later than that behind the last answered question is left aside, even where an
// answer to an old question came meanwhile; a frame behind the answer to a new question passes; own frames pass always.
TEST(SocketcandClientTest, LeavesAsideWhatTheConnectionMayHaveHeld)
{
    Verifies(req::SRS_LIVE_059);
    ForeignServer server;
    LiveOptions options;
    options.oldest_ms = 2000U;
    const auto bus = server.Open(options);
    EXPECT_EQ(Wait(*bus)->identifier, 1U);
    LiveFrame frame;
    EXPECT_FALSE(bus->Receive(frame));
    ASSERT_EQ(bus->Send(Live(0x123U, {7U})), SendResult::kSent);
    // That of the frame that was sent, and a question, which have no answer yet
    ASSERT_NO_FATAL_FAILURE(server.AwaitEchoes(*bus, 2U));
    const std::uint64_t start_ns = LiveNow();
    while (LiveNow() - start_ns < 2'100'000'000U)
    {
        pollfd wait{bus->Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&wait, 1U, 50));
        EXPECT_FALSE(bus->Receive(frame));
    }
    server.Say("< frame 002 1.0 >< echo >< echo >< frame 003 1.0 >");
    const std::optional<LiveFrame> own = Wait(*bus);
    ASSERT_TRUE(own);
    EXPECT_TRUE(own->own);
    while (bus->Health().stale_frames < 2U)
    {
        ASSERT_FALSE(bus->Receive(frame));
    }
    server.Say("< echo >< frame 004 1.0 >");
    EXPECT_EQ(Wait(*bus)->identifier, 4U);
    EXPECT_EQ(bus->Health().stale_frames, 2U);
    EXPECT_EQ(bus->Health().malformed, 0U);
}

// Given a connection that delays all that is said on it by more than the greatest age, questions and answers too, then
// no frame of others passes, however often it answers; what comes later than that stays aside, too.
TEST(SocketcandClientTest, LeavesAsideWhatAConnectionThatDelaysEverythingGives)
{
    Verifies(req::SRS_LIVE_059);
    Verifies(req::SRS_NODE_031);
    constexpr std::uint32_t kOldestMs = 200U;
    ForeignServer server;
    LiveOptions options;
    options.oldest_ms = kOldestMs;
    const auto bus = server.Open(options);
    EXPECT_EQ(Wait(*bus)->identifier, 1U);
    LiveFrame frame;
    for (std::uint32_t round = 1U; round <= 3U; ++round)
    {
        // A question is asked, and answered later than the greatest age, with a frame behind the answer
        ASSERT_NO_FATAL_FAILURE(server.AwaitEchoes(*bus, 1U));
        const std::uint64_t start_ns = LiveNow();
        while (LiveNow() - start_ns <= (kOldestMs + 20U) * 1'000'000U)
        {
            pollfd wait{bus->Descriptor(), POLLIN, 0};
            static_cast<void>(::poll(&wait, 1U, 10));
            EXPECT_FALSE(bus->Receive(frame));
        }
        server.Say("< echo >< frame 002 1.0 >");
        while (bus->Health().stale_frames < round)
        {
            ASSERT_FALSE(bus->Receive(frame));
        }
        EXPECT_EQ(bus->Health().stale_frames, round);
    }
}

// Given a connection that ends, then Receive has nothing, Send answers kDown, and Descriptor is quiet afterwards.
TEST(SocketcandClientTest, SeesThatTheConnectionEnds)
{
    Verifies(req::SRS_LIVE_055);
    ForeignServer server;
    const auto bus = server.Open();
    ASSERT_TRUE(Wait(*bus));
    server.Close();
    pollfd wait{bus->Descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&wait, 1U, 10'000), 1);
    LiveFrame none;
    while (bus->Health().state != BusState::kDown)
    {
        ASSERT_FALSE(bus->Receive(none));
    }
    EXPECT_EQ(bus->Send(Live(1U, {})), SendResult::kDown);
    EXPECT_EQ(::poll(&wait, 1U, 0), 0);
}

TEST(SocketcandClientTest, DropsAndCountsWhatWaitedWhenTheConnectionEnds)
{
    Verifies(req::SRS_LIVE_055);
    // Given a server that reads nothing, and five frames that the system did not take any more
    ForeignServer server;
    const auto bus = server.Open();
    for (int i = 0; i < 1'000'000 && bus->Health().waiting < 5U; ++i)
    {
        ASSERT_EQ(bus->Send(Live(1U, {})), SendResult::kSent);
    }
    ASSERT_EQ(bus->Health().waiting, 5U);
    EXPECT_EQ(bus->Health().dropped_frames, 0U);
    // When the connection ends
    server.Close();
    LiveFrame frame;
    while (bus->Health().state != BusState::kDown)
    {
        static_cast<void>(bus->Receive(frame));
    }
    // Then they are dropped and counted
    EXPECT_EQ(bus->Health().waiting, 0U);
    EXPECT_EQ(bus->Health().dropped_frames, 5U);
}

constexpr std::uint64_t kSecondNs = 1'000'000'000U;

std::string Group()
{
    return "udp:239.74.163.11:" + std::to_string(20'000 + (::getpid() % 40'000));
}

LiveOptions After(const std::uint32_t milliseconds)
{
    LiveOptions options;
    options.reconnect_after_ms = milliseconds;
    return options;
}

/// Serves the bus as an owner does until it has that state, at most minutes.
bool Reaches(LiveBus& bus, const BusState state)
{
    const std::uint64_t start_ns = LiveNow();
    LiveFrame frame;
    while ((bus.Health().state != state) && (LiveNow() - start_ns < 300U * kSecondNs))
    {
        pollfd wait{bus.Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&wait, 1U, 100));
        while (bus.Receive(frame))
        {
        }
    }
    return bus.Health().state == state;
}

/// How often this thread gave the processor away because it had to wait.
long Waits()
{
    rusage used{};
    static_cast<void>(::getrusage(RUSAGE_THREAD, &used));
    return used.ru_nvcsw;
}

// Given a server that ends, then the bus is down and takes nothing; when a server is at that place again, frames go
// both ways again, and what was sent before the loss does not come back.
TEST(SocketcandLostTest, OpensTheConnectionAgain)
{
    Verifies(req::SRS_LIVE_055);
    Verifies(req::SRS_LIVE_058);
    auto server = std::make_unique<RunningServer>(Group());
    const std::uint16_t port = server->Port();
    const auto bus = OpenLiveBus(server->Address("can0"), After(50U));
    ASSERT_EQ(bus->Send(Live(0x101U, {1U})), SendResult::kSent);
    ASSERT_EQ(Wait(*bus)->identifier, 0x101U);
    server.reset();
    ASSERT_TRUE(Reaches(*bus, BusState::kDown));
    EXPECT_EQ(bus->Send(Live(0x102U, {2U})), SendResult::kDown);
    server = std::make_unique<RunningServer>(Group(), port);
    ASSERT_TRUE(Reaches(*bus, BusState::kActive));
    EXPECT_EQ(bus->Health().reconnects, 1U);
    const auto member = OpenLiveBus(Group());
    ASSERT_EQ(bus->Send(Live(0x103U, {3U})), SendResult::kSent);
    EXPECT_EQ(Wait(*member)->identifier, 0x103U);
    const std::optional<LiveFrame> own = Wait(*bus);
    ASSERT_TRUE(own);
    EXPECT_EQ(own->identifier, 0x103U);
    EXPECT_TRUE(own->own);
    ASSERT_EQ(member->Send(Live(0x104U, {4U})), SendResult::kSent);
    EXPECT_EQ(Wait(*bus)->identifier, 0x104U);
}

// Given the policy that a lost connection stays lost, then a server that comes back changes nothing.
TEST(SocketcandLostTest, StaysLostByPolicy)
{
    Verifies(req::SRS_LIVE_058);
    auto server = std::make_unique<RunningServer>(Group());
    const std::uint16_t port = server->Port();
    const auto bus = OpenLiveBus(server->Address("can0"), After(0U));
    server.reset();
    ASSERT_TRUE(Reaches(*bus, BusState::kDown));
    server = std::make_unique<RunningServer>(Group(), port);
    pollfd wait{bus->Descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&wait, 1U, 300), 0);
    LiveFrame none;
    EXPECT_FALSE(bus->Receive(none));
    EXPECT_EQ(bus->Health().state, BusState::kDown);
    EXPECT_EQ(bus->Health().reconnects, 0U);
}

// Given something at the place of the server that takes connections and says nothing, or nonsense, then it is given up,
// and a server that is there afterwards is found; no call waits for any of it.
TEST(SocketcandLostTest, GivesUpWhoSaysNothing)
{
    Verifies(req::SRS_LIVE_005);
    Verifies(req::SRS_LIVE_058);
    auto server = std::make_unique<RunningServer>(Group());
    const std::uint16_t port = server->Port();
    const auto bus = OpenLiveBus(server->Address("can0"), After(20U));
    server.reset();
    ASSERT_TRUE(Reaches(*bus, BusState::kDown));
    const int silent = ::socket(AF_INET, SOCK_STREAM, 0);
    const int on = 1;
    static_cast<void>(::setsockopt(silent, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on)));
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(::bind(silent, reinterpret_cast<sockaddr*>(&place), sizeof(place)), 0);
    ASSERT_EQ(::listen(silent, 1), 0);
    const std::uint64_t start_ns = LiveNow();
    long waits = 0;
    LiveFrame none;
    while (LiveNow() - start_ns < kSecondNs)
    {
        const long before = Waits();
        EXPECT_FALSE(bus->Receive(none));
        EXPECT_EQ(bus->Send(Live(1U, {})), SendResult::kDown);
        waits += Waits() - before;
        pollfd wait{bus->Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&wait, 1U, 10));
    }
    EXPECT_EQ(waits, 0);
    static_cast<void>(::close(silent));
    server = std::make_unique<RunningServer>(Group(), port);
    EXPECT_TRUE(Reaches(*bus, BusState::kActive));
}

// Given a server at an address of IPv6, then it is reached by that address in brackets.
TEST(SocketcandLostTest, ReachesAnAddressWithColons)
{
    Verifies(req::SRS_LIVE_001);
    std::unique_ptr<RunningServer> server;
    const std::string problem = ProblemOf([&server] { server = std::make_unique<RunningServer>(Group(), 0U, "::1"); });
    if (!problem.empty())
    {
        EXPECT_NE(problem.find("socketcand server at ::1"), std::string::npos); // A machine without IPv6.
        return;
    }
    const std::string address = server->Address("can0");
    EXPECT_EQ(address.substr(0U, 17U), "socketcand:[::1]:");
    const auto bus = OpenLiveBus(address);
    ASSERT_EQ(bus->Send(Live(0x101U, {1U})), SendResult::kSent);
    EXPECT_EQ(Wait(*bus)->identifier, 0x101U);
}

} // namespace
} // namespace counterpoint::host
