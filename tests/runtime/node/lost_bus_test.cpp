// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device whose bus is that of a server, which ends and is started again.
#include "tests/hal/host/live_server_rig.hpp"
#include "tests/runtime/node/process.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <memory>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace counterpoint::tools::test
{
namespace
{
/// More than the release of a pair takes, less than a person would wait.
constexpr int kQuietMs = 700;

// Given an actuator behind a server, and an output that a person released, when the server ends, then the output
// closes; when the server is there again, the device takes part again without having been restarted, and neither that
// nor a start opens the output, only a person does.
TEST(NodeLostBusTest, ALostServerThatComesBackOpensNothing)
{
    Verifies(req::SRS_LIVE_058);
    Verifies(req::SRS_NODE_020);
    auto server = std::make_unique<host::RunningServer>(OwnBus());
    const std::uint16_t port = server->Port();
    const auto controller = StartNode("emergency_stop/controller.dcf", {});
    const auto actuator = StartNode("emergency_stop/actuator.dcf", {}, server->Address("can0"));
    controller->Type("nmt start");
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kQuietMs));
    actuator->Type("ack 1");
    ASSERT_TRUE(actuator->Tells(Event("output", "open", true), 2000));
    server.reset();
    EXPECT_FALSE(actuator->WaitFor(Event("output", "open", false)).event.is_null());
    actuator->Type("ack 1");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kQuietMs));
    server = std::make_unique<host::RunningServer>(OwnBus(), port);
    EXPECT_FALSE(actuator->WaitFor(Event("bus", "state", "active")).event.is_null());
    const auto is_down = Event("bus", "state", "down");
    const auto& told = actuator->Lines();
    EXPECT_TRUE(
        std::any_of(told.begin(), told.end(), [&is_down](const NodeLine& line) { return is_down(line.event); }));
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kQuietMs));
    actuator->Type("state");
    EXPECT_EQ(actuator->WaitFor("state").event["device_fault"], "none");
    actuator->Type("ack 1");
    EXPECT_TRUE(actuator->Tells(Event("output", "open", true), 2000));
    actuator->Type("quit");
    EXPECT_EQ(actuator->End(), 0);
    controller->Type("quit");
    EXPECT_EQ(controller->End(), 0);
}

/// Lets real time pass in which the time of the processes stands still, as on a machine that has much else to do.
void LetTheMachineBeSlow()
{
    pollfd nothing{-1, POLLIN, 0};
    EXPECT_EQ(::poll(&nothing, 1U, 2500), 0);
}

// Given a machine on which the processes are seconds behind real time, when the server ends and is there again, then a
// device waits for the next connection by its own time, and takes part again.
TEST(NodeLostBusTest, ASlowMachineChangesNothing)
{
    Verifies(req::SRS_LIVE_058);
    auto server = std::make_unique<host::RunningServer>(OwnBus());
    const std::uint16_t port = server->Port();
    const auto actuator = StartNode("emergency_stop/actuator.dcf", {}, server->Address("can0"));
    LetTheMachineBeSlow();
    server.reset();
    EXPECT_FALSE(actuator->WaitFor(Event("bus", "state", "down")).event.is_null());
    const std::uint64_t lost_ns = NowNs();
    EXPECT_FALSE(actuator->Tells(Event("bus", "state", "active"), kQuietMs));
    EXPECT_GE(NowNs() - lost_ns, static_cast<std::uint64_t>(kQuietMs) * 1000000U);
    server = std::make_unique<host::RunningServer>(OwnBus(), port);
    EXPECT_FALSE(actuator->WaitFor(Event("bus", "state", "active")).event.is_null());
    actuator->Type("quit");
    EXPECT_EQ(actuator->End(), 0);
}

/// Stands between clients and a server on this machine, and can hold what both say.
class Relay
{
  public:
    explicit Relay(const std::uint16_t to) : to_(to)
    {
        sockaddr_in own = Loopback(0U);
        socklen_t bytes = sizeof(own);
        EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
        EXPECT_EQ(::listen(listener_, 8), 0);
        EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&own), &bytes), 0);
        address_ = "socketcand:127.0.0.1:" + std::to_string(ntohs(own.sin_port)) + "/can0";
        thread_ = std::thread([this] { Run(); });
    }
    ~Relay()
    {
        is_ending_ = true;
        thread_.join();
        for (const int end : ends_)
        {
            static_cast<void>(::close(end));
        }
        static_cast<void>(::close(listener_));
    }
    Relay(const Relay&) = delete;
    Relay& operator=(const Relay&) = delete;
    [[nodiscard]] const std::string& Address() const
    {
        return address_;
    }
    /// It holds, or carries, when this returns.
    void Hold(const bool is_held)
    {
        is_held_ = is_held;
        while (is_holding_ != is_held)
        {
            std::this_thread::yield();
        }
    }

  private:
    static sockaddr_in Loopback(const std::uint16_t port)
    {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_port = htons(port);
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return place;
    }
    void Run()
    {
        while (!is_ending_)
        {
            std::vector<pollfd> waits{{listener_, POLLIN, 0}};
            is_holding_ = is_held_.load();
            for (const int end : is_holding_ ? std::vector<int>{} : ends_)
            {
                waits.push_back({end, POLLIN, 0});
            }
            static_cast<void>(::poll(waits.data(), waits.size(), 10));
            if (waits[0].revents != 0)
            {
                const sockaddr_in server = Loopback(to_);
                ends_.push_back(::accept(listener_, nullptr, nullptr));
                ends_.push_back(::socket(AF_INET, SOCK_STREAM, 0));
                static_cast<void>(::connect(ends_.back(), reinterpret_cast<const sockaddr*>(&server), sizeof(server)));
            }
            for (std::size_t i = 1U; i < waits.size(); ++i)
            {
                std::array<char, 4096U> bytes{};
                const ssize_t count =
                    (waits[i].revents != 0) ? ::recv(waits[i].fd, bytes.data(), bytes.size(), MSG_DONTWAIT) : 0;
                const int other = ends_[(i - 1U) ^ 1U];
                static_cast<void>(
                    (count > 0) ? ::send(other, bytes.data(), static_cast<std::size_t>(count), MSG_NOSIGNAL) : 0);
            }
        }
    }

    std::uint16_t to_;
    int listener_{::socket(AF_INET, SOCK_STREAM, 0)};
    std::string address_;
    std::vector<int> ends_; ///< Client and server, one pair behind the other.
    std::atomic<bool> is_held_{false};
    std::atomic<bool> is_holding_{false};
    std::atomic<bool> is_ending_{false};
    std::thread thread_;
};

// Given an actuator whose connection to the bus stands still for seconds, then what was held is left aside and told,
// and the node said at its start that no limit holds there.
TEST(NodeLostBusTest, WhatAConnectionHeldIsNoFreshValue)
{
    Verifies(req::SRS_NODE_031);
    const host::RunningServer server(OwnBus());
    Relay relay(server.Port());
    const auto controller = StartNode("emergency_stop/controller.dcf", {});
    const auto actuator = StartNode("emergency_stop/actuator.dcf", {}, relay.Address());
    const std::string warning = "warning: a connection to a server may hold frames: on " + relay.Address() +
                                " no told limit holds. SRDOs that may be older than 100 ms are left aside";
    const auto& lines = actuator->Lines();
    const auto is_warning = Event("warning", "text", warning);
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [&is_warning](const NodeLine& line) { return is_warning(line.event); }));
    relay.Hold(true);
    controller->Type("nmt start");
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), 3000));
    // A person acknowledges while nothing comes; then all of it comes at once
    actuator->Type("ack 1");
    relay.Hold(false);
    const NodeLine told = actuator->WaitFor("stale_frames");
    ASSERT_FALSE(told.event.is_null());
    EXPECT_GT(told.event["count"], 0);
    actuator->Type("quit");
    EXPECT_EQ(actuator->End(), 0);
    controller->Type("quit");
    EXPECT_EQ(controller->End(), 0);
}
} // namespace
} // namespace counterpoint::tools::test
