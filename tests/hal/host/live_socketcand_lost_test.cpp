// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A socketcand server that ends and comes back.
#include "tests/hal/host/live_rig.hpp"
#include "tests/hal/host/live_server_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

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
