// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The socketcand server before a CAN interface, and both ends of the connection when the system refuses something. The
// server is served by the test, between what the client does.
#include "hal/host/live/address.hpp"
#include "hal/host/live/error.hpp"
#include "hal/host/live/socketcand/server.hpp"
#include "tests/hal/host/fake_can_kernel.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <gtest/gtest.h>
#include <linux/can/error.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

sockaddr_in PlaceOf(const std::uint16_t port)
{
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return place;
}

/// A connection to the server, in plain text.
class Caller
{
  public:
    explicit Caller(SocketcandServer& server) : server_{server}, socket_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        const sockaddr_in place = PlaceOf(server.Port());
        EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof(place)), 0);
    }
    ~Caller()
    {
        static_cast<void>(::close(socket_));
    }
    Caller(const Caller&) = delete;
    Caller& operator=(const Caller&) = delete;
    void Say(const std::string& text) const
    {
        EXPECT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
    }
    /// The next element, while the server is served; empty: the connection ended, or nothing came in so many turns.
    [[nodiscard]] std::string Hear(const int turns = 200)
    {
        std::string text;
        for (int turn = 0; turn < turns; ++turn)
        {
            char letter = '\0';
            ssize_t got = ::recv(socket_, &letter, 1U, MSG_DONTWAIT);
            while ((got == 1) && (letter != '>'))
            {
                text += letter;
                got = ::recv(socket_, &letter, 1U, MSG_DONTWAIT);
            }
            if (got == 1)
            {
                return text + ">";
            }
            if (got == 0)
            {
                return "";
            }
            server_.Serve(1);
        }
        return "";
    }
    /// Whether the server has ended the connection.
    [[nodiscard]] bool HasEnded() const
    {
        char letter = '\0';
        return ::recv(socket_, &letter, 1U, MSG_DONTWAIT | MSG_PEEK) == 0;
    }

  private:
    SocketcandServer& server_;
    int socket_;
};

class ServedInterface : public ::testing::Test
{
  protected:
    ServedInterface()
    {
        kernel.interfaces["can0"].state = std::uint8_t{0U};
    }
    /// Raw mode is entered: three answers.
    static void Open(Caller& caller)
    {
        caller.Say("< open can0 >< rawmode >");
        EXPECT_EQ(caller.Hear(), "< hi >");
        EXPECT_EQ(caller.Hear(), "< ok >");
        EXPECT_EQ(caller.Hear(), "< ok >");
    }

    FakeCanKernel kernel;
    SocketcandServer server{"127.0.0.1", 0U, {{"can0", "can0"}, {"other", "can0"}}};
};

TEST_F(ServedInterface, TellsWhyAFrameIsNotSent)
{
    Verifies(req::SRS_LIVE_053);
    Caller caller{server};
    Open(caller);
    kernel.send_failures = {EINVAL};
    caller.Say("< send 123 0 >");
    EXPECT_EQ(caller.Hear(), "< error send: the bus refuses the frame >");
    kernel.interfaces["can0"].state = std::uint8_t{3U};
    kernel.TellNews();
    caller.Say("< send 123 0 >");
    EXPECT_EQ(caller.Hear(), "< error send: bus-off >");
    kernel.interfaces["can0"].is_up = false;
    kernel.TellNews();
    caller.Say("< send 123 0 >");
    EXPECT_EQ(caller.Hear(), "< error send: the bus is down >");
    EXPECT_EQ(server.Counts().to_bus, 0U);
}

TEST_F(ServedInterface, TellsErrorClassesAndNoFlexibleDataRate)
{
    Verifies(req::SRS_LIVE_053);
    Caller caller{server};
    Open(caller);
    canfd_frame frame{};
    frame.can_id = 0x101U;
    frame.len = 12U;
    kernel.Arrive(frame, false, CANFD_MTU);
    frame.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
    frame.len = 8U;
    kernel.Arrive(frame);
    frame.can_id = 0x102U;
    frame.len = 1U;
    kernel.Arrive(frame);
    EXPECT_EQ(caller.Hear().substr(0U, 12U), "< error 040 ");
    EXPECT_EQ(caller.Hear().substr(0U, 12U), "< frame 102 ");
}

TEST_F(ServedInterface, HoldsAFrameUntilTheInterfaceTakesIt)
{
    Verifies(req::SRS_LIVE_054);
    Caller caller{server};
    Open(caller);
    kernel.interfaces["can0"].is_carrying = false;
    kernel.TellNews();
    std::string orders;
    for (int n = 0; n < 66; ++n)
    {
        orders += "< send " + std::to_string(100 + n) + " 0 >";
    }
    // Given 64 that wait in the bus, and one that is held: nothing behind it is obeyed
    caller.Say(orders + "< echo >");
    EXPECT_EQ(caller.Hear(20), "");
    kernel.interfaces["can0"].is_carrying = true;
    kernel.TellNews();
    EXPECT_EQ(caller.Hear(), "< echo >");
    for (int turn = 0; (turn < 200) && (kernel.sent.size() < 66U); ++turn)
    {
        server.Serve(1);
    }
    ASSERT_EQ(kernel.sent.size(), 66U);
    EXPECT_EQ(kernel.sent[65].can_id, 0x165U);
}

TEST_F(ServedInterface, NamesAllBusesAndEndsWhenThatIsSaid)
{
    Verifies(req::SRS_LIVE_053);
    Caller caller{server};
    EXPECT_EQ(caller.Hear(), "< hi >");
    caller.Say("< open can9 >");
    {
        // Given a connection that takes nothing for a while
        const FailingCall send{SystemCall::kSend, EAGAIN};
        for (int turn = 0; turn < 5; ++turn)
        {
            server.Serve(1);
        }
        EXPECT_EQ(server.Counts().clients, 1U);
    }
    EXPECT_EQ(caller.Hear(), "< error no bus of that name, expected can0 or other >");
    EXPECT_EQ(caller.Hear(), "");
    EXPECT_EQ(server.Counts().clients, 0U);
}

TEST_F(ServedInterface, TakesAsManyConnectionsAtATimeAsThereArePlaces)
{
    Verifies(req::SRS_LIVE_061);
    // Given as many connections as places that come at once, then all have one, and each opens a bus
    std::vector<std::unique_ptr<Caller>> callers;
    for (std::size_t n = 0U; n < kSocketcandClients; ++n)
    {
        callers.push_back(std::make_unique<Caller>(server));
    }
    server.Serve(0);
    EXPECT_EQ(server.Counts().clients, kSocketcandClients);
    for (const auto& caller : callers)
    {
        Open(*caller);
    }
    // When there is one more, then it is the one without a place
    Caller late{server};
    EXPECT_EQ(late.Hear(), "");
    EXPECT_TRUE(late.HasEnded());
    EXPECT_EQ(server.Counts().clients, kSocketcandClients);
    callers.front()->Say("< echo >");
    EXPECT_EQ(callers.front()->Hear(), "< echo >");
}

TEST_F(ServedInterface, LeavesABusToItsClientWhereNoDescriptorIsLeft)
{
    Verifies(req::SRS_LIVE_061);
    for (const int failure : {EMFILE, ENFILE})
    {
        Caller caller{server};
        Open(caller);
        {
            const FailingCall accept{SystemCall::kAccept, failure, 0, 1};
            const Caller late{server};
            server.Serve(100);
            EXPECT_EQ(server.Counts().clients, 1U);
            server.Serve(1); // The next turn leaves the door closed,
            server.Serve(1); // the one behind it opens it.
            server.Serve(1);
            EXPECT_EQ(server.Counts().clients, 2U);
        }
        caller.Say("< echo >");
        EXPECT_EQ(caller.Hear(), "< echo >");
        while (server.Counts().clients > 1U)
        {
            server.Serve(1);
        }
    }
}

TEST(SocketcandServerSystemTest, SaysWhereItCannotListen)
{
    Verifies(req::SRS_LIVE_053);
    const auto problem = [](const std::string& host)
    { return ProblemOf([&host] { static_cast<void>(SocketcandServer(host, 29'536U, {})); }); };
    EXPECT_EQ(problem("::g"),
              "socketcand server at ::g port 29536: Name or service not known, expected an address of this "
              "machine");
    const FailingCall listen{SystemCall::kListen, EADDRINUSE};
    EXPECT_EQ(problem("127.0.0.1"),
              "socketcand server at 127.0.0.1 port 29536: Address already in use, expected a free port "
              "of this machine");
}

/// A server by others, of which the test says what it says: at once when somebody connects, or later.
class SayingServer
{
  public:
    explicit SayingServer(const std::string& text) : listener_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        sockaddr_in own = PlaceOf(0U);
        socklen_t bytes = sizeof(own);
        EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
        EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
        EXPECT_EQ(::listen(listener_, 1), 0);
        address = "socketcand:127.0.0.1:" + std::to_string(ntohs(own.sin_port)) + "/can0";
        thread_ = std::thread{[this, text]
                              {
                                  connection_ = ::accept(listener_, nullptr, nullptr);
                                  Say(text);
                                  if (text.empty())
                                  {
                                      Close();
                                  }
                              }};
    }
    ~SayingServer()
    {
        Settle();
        Close();
        static_cast<void>(::close(listener_));
    }
    SayingServer(const SayingServer&) = delete;
    SayingServer& operator=(const SayingServer&) = delete;
    void Settle()
    {
        if (thread_.joinable())
        {
            thread_.join();
        }
    }
    void Say(const std::string& text) const
    {
        static_cast<void>(::send(connection_, text.data(), text.size(), MSG_NOSIGNAL));
    }
    void Close()
    {
        if (connection_ >= 0)
        {
            static_cast<void>(::close(connection_));
            connection_ = -1;
        }
    }
    /// Takes the next connection and says the text.
    void Take(const std::string& text)
    {
        Settle();
        Close();
        connection_ = ::accept(listener_, nullptr, nullptr);
        Say(text);
    }

    std::string address;

  private:
    int listener_;
    int connection_{-1};
    std::thread thread_;
};

const std::string kGreeting = "< hi >< ok >< ok >< ok >"; ///< Of a server that tells own frames.

std::string OpeningProblem(const std::string& address)
{
    const std::string start = "bus '" + address + "': ";
    const std::string problem = ProblemOf([&address] { static_cast<void>(OpenLiveBus(address)); });
    return (problem.compare(0U, start.size(), start) == 0) ? problem.substr(start.size()) : problem;
}

TEST(SocketcandPeerSystemTest, SaysWhatKeepsItFromConnecting)
{
    Verifies(req::SRS_LIVE_051);
    EXPECT_EQ(OpeningProblem("socketcand:999.1.1.1.1:5/can0"),
              "host '999.1.1.1.1': Name or service not known, expected the name or address of a machine");
    const std::string address = "socketcand:127.0.0.1:29537/can0";
    const std::string end = ", expected a socketcand server at 127.0.0.1 port 29537";
    {
        const FailingCall socket{SystemCall::kSocket, EMFILE};
        EXPECT_EQ(OpeningProblem(address), "Too many open files" + end);
    }
    {
        const FailingCall connect{SystemCall::kConnect, ENETUNREACH};
        EXPECT_EQ(OpeningProblem(address), "Network is unreachable" + end);
    }
    // A connection that is not made in time
    SayingServer server{kGreeting};
    {
        const FailingCall poll{SystemCall::kPoll, EINTR, 0, 1};
        const PollWatch watch;
        const std::string problem = OpeningProblem(server.address);
        EXPECT_EQ(problem.substr(0U, problem.find(',')), "Connection timed out");
        ASSERT_EQ(watch.Waits().size(), 1U);
        EXPECT_LE(watch.Waits().front(), 3001); // The millisecond that has begun counts.
    }
}

TEST(SocketcandPeerSystemTest, ConnectsWhereTheSystemNeedsNoTimeForIt)
{
    Verifies(req::SRS_LIVE_051);
    SayingServer server{kGreeting};
    const FailingCall connect{SystemCall::kConnect, 0};
    EXPECT_EQ(OpenLiveBus(server.address)->Health().state, BusState::kActive);
}

TEST(SocketcandGreetingSystemTest, SaysHowTheServerAnswers)
{
    Verifies(req::SRS_LIVE_051);
    {
        SayingServer server{"< echo >"};
        EXPECT_EQ(OpeningProblem(server.address), "the server's answer is another than expected of socketcand");
    }
    {
        SayingServer server{"< nonsense >"};
        EXPECT_EQ(
            OpeningProblem(server.address),
            "the server's answer is another than expected of socketcand: unknown command 'nonsense', expected open, "
            "rawmode, bcmmode, ownmode, send, sendrtr or echo");
    }
    SayingServer server{""};
    EXPECT_EQ(OpeningProblem(server.address), "the server ended the connection, expected its answer");
}

// A wait ends at 3 s of the call, however often the server answered: what is left of them is waited for.
TEST(SocketcandGreetingSystemTest, GivesConnectionAndAllAnswersThreeSecondsTogether)
{
    Verifies(req::SRS_LIVE_051);
    // Given a server that answers twice, 200 ms behind each other, and then no more
    SayingServer server{"< hi >"};
    std::thread later{[&server]
                      {
                          server.Settle();
                          for (int answer = 0; answer < 2; ++answer)
                          {
                              static_cast<void>(::poll(nullptr, 0U, 200));
                              server.Say("< ok >");
                          }
                      }};
    const PollWatch watch;
    const std::string problem = OpeningProblem(server.address);
    later.join();
    EXPECT_EQ(problem, "the server did not answer ownmode within 3 s, expected the socketcand protocol");
    const std::vector<int>& waits = watch.Waits();
    ASSERT_FALSE(waits.empty());
    EXPECT_LE(*std::max_element(waits.begin(), waits.end()), 3001);
    // For the connection, hi and two answers longer than what is left behind the second one
    EXPECT_LE(std::count_if(waits.begin(), waits.end(), [](const int wait) { return wait > 2601; }), 4);
}

/// Receives until nothing comes, so often that what was said is heard; at most minutes.
bool Until(LiveBus& bus, const std::function<bool()>& holds)
{
    const std::uint64_t start_ns = LiveNow();
    LiveFrame frame;
    while (!holds() && (LiveNow() - start_ns < 300'000'000'000U))
    {
        while (bus.Receive(frame))
        {
        }
        pollfd wait{bus.Descriptor(), POLLIN, 0};
        static_cast<void>(::poll(&wait, 1U, 10));
    }
    return holds();
}

TEST(SocketcandBusSystemTest, LearnsWhyTheServerDidNotSend)
{
    Verifies(req::SRS_LIVE_022);
    Verifies(req::SRS_LIVE_051);
    SayingServer server{kGreeting};
    const auto bus = OpenLiveBus(server.address);
    const auto says = [&](const std::string& text, const std::uint32_t dropped)
    {
        server.Say(text);
        return Until(*bus, [&] { return bus->Health().dropped_frames == dropped; });
    };
    EXPECT_TRUE(says("< error send: bus-off >", 1U));
    EXPECT_EQ(bus->Health().state, BusState::kBusOff);
    EXPECT_TRUE(says("< error send: the bus is down >", 2U));
    EXPECT_EQ(bus->Health().state, BusState::kDown);
    // A frame is a bus that works; a refusal says nothing of the bus, and no text but that of an order to send counts
    server.Say("< frame 001 1.0 AA >");
    EXPECT_EQ(Wait(*bus)->identifier, 1U);
    EXPECT_TRUE(says("< error not now >< ok >< echo >< error send: the bus refuses the frame >", 3U));
    EXPECT_EQ(bus->Health().state, BusState::kActive);
    EXPECT_EQ(bus->Health().malformed, 0U);
    // The controller behind it was restarted
    server.Say("< error 100 1.0 >");
    EXPECT_TRUE(Wait(*bus)->error);
    EXPECT_EQ(bus->Health().restarts, 1U);
}

TEST(SocketcandBusSystemTest, GivesOnlyWhatPassesItsFilters)
{
    Verifies(req::SRS_LIVE_014);
    SayingServer server{kGreeting};
    LiveOptions options;
    options.filters = {{0x100U, 0x7FFU, false}};
    const auto bus = OpenLiveBus(server.address, options);
    server.Say("< frame 0FF 1.0 AA >< frame 100 1.0 BB >");
    EXPECT_EQ(Wait(*bus)->identifier, 0x100U);
}

TEST(SocketcandBusSystemTest, TakesNoMoreThanItsQueueAndNoFrameThatIsNone)
{
    Verifies(req::SRS_LIVE_004);
    SayingServer server{kGreeting};
    const auto bus = OpenLiveBus(server.address);
    EXPECT_EQ(bus->Send(Live(0x800U, {})), SendResult::kRefused);
    // Given a connection that takes nothing: text of 4096 bytes, and 64 frames behind it
    const FailingCall send{SystemCall::kSend, EAGAIN};
    SendResult result = SendResult::kSent;
    std::uint32_t taken = 0U;
    while ((result == SendResult::kSent) && (taken < 100'000U))
    {
        result = bus->Send(Live(0x1U, {}));
        taken += (result == SendResult::kSent) ? 1U : 0U;
    }
    EXPECT_EQ(result, SendResult::kQueueFull);
    EXPECT_EQ(bus->Health().waiting, 64U);
}

TEST(SocketcandBusSystemTest, SeesALossWhileItSends)
{
    Verifies(req::SRS_LIVE_055);
    // Given a server that tells own frames, one that does not, and questions besides
    for (const std::string& greeting : {kGreeting, std::string{"< hi >< ok >< ok >< error unknown command >"}})
    {
        SayingServer server{greeting};
        LiveOptions options;
        options.reconnect_after_ms = 0U;
        const auto bus = OpenLiveBus(server.address, options);
        const FailingCall send{SystemCall::kSend, EPIPE};
        EXPECT_EQ(bus->Send(Live(0x1U, {})), SendResult::kDown);
        EXPECT_EQ(bus->Health().state, BusState::kDown);
    }
    for (const std::uint32_t oldest_ms : {0U, 1000U})
    {
        SayingServer server{kGreeting};
        LiveOptions options;
        options.reconnect_after_ms = 0U;
        options.oldest_ms = oldest_ms;
        const auto bus = OpenLiveBus(server.address, options);
        // An interruption is none
        {
            const FailingCall send{SystemCall::kSend, EINTR, 0, 1};
            EXPECT_EQ(bus->Send(Live(0x1U, {})), SendResult::kSent);
        }
        const FailingCall send{SystemCall::kSend, EPIPE};
        EXPECT_EQ(bus->Send(Live(0x2U, {})), SendResult::kDown);
        EXPECT_EQ(bus->Health().state, BusState::kDown);
        EXPECT_EQ(bus->Send(Live(0x3U, {})), SendResult::kDown);
    }
}

TEST(SocketcandBusSystemTest, TriesAgainWhatCannotBeConnectedOrIsRefused)
{
    Verifies(req::SRS_LIVE_058);
    SayingServer server{kGreeting};
    LiveOptions options;
    options.reconnect_after_ms = 5U;
    const auto bus = OpenLiveBus(server.address, options);
    server.Settle();
    server.Close();
    // Given no way to the server for three attempts
    {
        const FailingCall connect{SystemCall::kConnect, ENETUNREACH, 0, 3};
        ASSERT_TRUE(Until(*bus, [&bus] { return bus->Health().state == BusState::kDown; }));
        LiveFrame none;
        const std::uint64_t start_ns = LiveNow();
        while (LiveNow() - start_ns < 100'000'000U)
        {
            EXPECT_FALSE(bus->Receive(none));
        }
    }
    // Then a server that refuses, and one that is as expected
    server.Take("< error out of order >");
    EXPECT_FALSE(Until(*bus, [start_ns = LiveNow()] { return LiveNow() - start_ns > 50'000'000U; }) &&
                 (bus->Health().state == BusState::kActive));
    server.Take(kGreeting);
    EXPECT_TRUE(Until(*bus, [&bus] { return bus->Health().state == BusState::kActive; }));
    EXPECT_EQ(bus->Health().reconnects, 1U);
}

TEST(SocketcandBusSystemTest, GivesUpAGreetingThatIsNotOverWithinThreeSeconds)
{
    Verifies(req::SRS_LIVE_058);
    SayingServer server{kGreeting};
    LiveOptions options;
    options.reconnect_after_ms = 5U;
    const auto bus = OpenLiveBus(server.address, options);
    server.Settle();
    server.Close();
    const std::uint64_t start_ns = LiveNow();
    // Given a server that takes the connection and greets by half
    std::thread half{[&server] { server.Take("< hi >"); }};
    ASSERT_TRUE(Until(*bus, [start_ns] { return LiveNow() - start_ns > 3'200'000'000U; }));
    half.join();
    EXPECT_EQ(bus->Health().reconnects, 0U);
    // When the next one is greeted in full
    server.Take(kGreeting);
    EXPECT_TRUE(Until(*bus, [&bus] { return bus->Health().state == BusState::kActive; }));
    EXPECT_EQ(bus->Health().reconnects, 1U);
}

} // namespace
} // namespace counterpoint::host
