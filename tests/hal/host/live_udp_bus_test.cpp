// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/host/live_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::host
{
namespace
{

/// A port of its own for each process, so that test programs may run side by side.
std::string Group(const std::string& option)
{
    return "udp:239.74.163.9:" + std::to_string(20'000 + (::getpid() % 40'000)) + option;
}

class UdpBus : public ::testing::Test
{
  protected:
    std::unique_ptr<LiveBus> one{OpenLiveBus(Group(""))};
    std::unique_ptr<LiveBus> other{OpenLiveBus(Group(""))};
};

// Given two members, when one sends, then both have the frame, unchanged, with a stamp between sending and now; own is
// set for the sender only.
TEST_F(UdpBus, CarriesToAllAndConfirmsToTheSender)
{
    Verifies(req::SRS_LIVE_002);
    Verifies(req::SRS_LIVE_003);
    Verifies(req::SRS_LIVE_010);
    const std::uint64_t before_ns = LiveNow();
    ASSERT_EQ(one->Send(Live(0x101U, {0x12U, 0x34U})), SendResult::kSent);
    for (LiveBus* const bus : {one.get(), other.get()})
    {
        const std::optional<LiveFrame> frame = Wait(*bus);
        ASSERT_TRUE(frame);
        EXPECT_EQ(frame->identifier, 0x101U);
        EXPECT_EQ(frame->length_bytes, 2U);
        EXPECT_EQ(frame->data[0], 0x12U);
        EXPECT_EQ(frame->data[1], 0x34U);
        EXPECT_EQ(frame->own, bus == one.get());
        EXPECT_FALSE(frame->extended || frame->remote || frame->fd || frame->error);
        EXPECT_GE(frame->time_ns, before_ns);
        EXPECT_LE(frame->time_ns, LiveNow());
    }
}

// Given frames of every kind, then each arrives as what it was.
TEST_F(UdpBus, KeepsTheKind)
{
    Verifies(req::SRS_LIVE_010);
    LiveFrame extended = Live(0x1FFF'FFFFU, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U});
    extended.extended = true;
    LiveFrame remote;
    remote.identifier = 0x7FFU;
    remote.length_bytes = 8U;
    remote.remote = true;
    LiveFrame flexible = Live(0U, {});
    flexible.fd = true;
    flexible.length_bytes = 64U;
    flexible.data[63] = 0xA5U;
    for (const LiveFrame& sent : {extended, remote, flexible})
    {
        ASSERT_EQ(one->Send(sent), SendResult::kSent);
        const std::optional<LiveFrame> got = Wait(*other);
        ASSERT_TRUE(got);
        EXPECT_EQ(got->identifier, sent.identifier);
        EXPECT_EQ(got->length_bytes, sent.length_bytes);
        EXPECT_EQ(got->extended, sent.extended);
        EXPECT_EQ(got->remote, sent.remote);
        EXPECT_EQ(got->fd, sent.fd);
        EXPECT_TRUE(std::equal(std::begin(got->data), std::end(got->data), std::begin(sent.data)));
    }
}

// Given another process on the group, when it sends, then its frame is here.
TEST_F(UdpBus, ReachesAnotherProcess)
{
    Verifies(req::SRS_LIVE_010);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0)
    {
        const auto bus = OpenLiveBus(one->Name());
        ::_exit((bus->Send(Live(0x77U, {9U})) == SendResult::kSent) ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    const std::optional<LiveFrame> frame = Wait(*one);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->identifier, 0x77U);
    EXPECT_FALSE(frame->own);
}

// Given what is no frame, then Send refuses it and nothing is on the bus.
TEST_F(UdpBus, RefusesWhatIsNoFrame)
{
    Verifies(req::SRS_LIVE_004);
    LiveFrame wide = Live(0x800U, {});
    LiveFrame longer = Live(1U, {});
    longer.length_bytes = 9U;
    LiveFrame error = Live(1U, {});
    error.error = true;
    LiveFrame remote_fd = Live(1U, {});
    remote_fd.remote = true;
    remote_fd.fd = true;
    for (const LiveFrame& frame : {wide, longer, error, remote_fd})
    {
        EXPECT_EQ(one->Send(frame), SendResult::kRefused);
    }
    LiveFrame none;
    EXPECT_FALSE(other->Receive(none));
    EXPECT_FALSE(one->Restart());
}

// Given datagrams of a stranger (short, another magic, flags unknown, a length that does not match), then they are
// counted and the good one behind them arrives.
TEST_F(UdpBus, DatagramsStayOnTheMachine)
{
    Verifies(req::SRS_LIVE_010);
    // Given the sockets of two buses, then each sends by the loopback interface, over no hop
    int sockets = 0;
    for (int file = 0; file < 256; ++file)
    {
        int type = 0;
        socklen_t bytes = sizeof(type);
        in_addr interface{};
        socklen_t length = sizeof(interface);
        const bool is_datagram = (::getsockopt(file, SOL_SOCKET, SO_TYPE, &type, &bytes) == 0) && (type == SOCK_DGRAM);
        if (!is_datagram || (::getsockopt(file, IPPROTO_IP, IP_MULTICAST_IF, &interface, &length) != 0))
        {
            continue;
        }
        ++sockets;
        EXPECT_EQ(ntohl(interface.s_addr), INADDR_LOOPBACK);
        int hops = -1;
        bytes = sizeof(hops);
        EXPECT_EQ(::getsockopt(file, IPPROTO_IP, IP_MULTICAST_TTL, &hops, &bytes), 0);
        EXPECT_EQ(hops, 0);
    }
    EXPECT_GE(sockets, 2);
}

TEST_F(UdpBus, DropsStrangeDatagrams)
{
    Verifies(req::SRS_LIVE_011);
    const std::vector<std::string> strange{
        "",
        "CPB1",
        std::string("CPB2\0\0\0\0\0\0\0\0\0\0\0\0\0\1", 18U),
        std::string("CPB1\0\0\0\0\0\0\0\0\x08\0\0\0\0\1", 18U),
        std::string("CPB1\0\0\0\0\0\0\0\0\0\1\0\0\0\1", 18U),
        std::string("CPB1\0\0\0\0\0\0\0\0\0\0\0\0\x08\0", 18U),
        std::string(200U, 'C'),
    };
    const int file = ::socket(AF_INET, SOCK_DGRAM, 0);
    const std::string name = one->Name();
    sockaddr_in group{};
    group.sin_family = AF_INET;
    group.sin_port = htons(static_cast<std::uint16_t>(std::stoi(name.substr(name.rfind(':') + 1U))));
    group.sin_addr.s_addr = ::inet_addr("239.74.163.9");
    in_addr loopback{};
    loopback.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(::setsockopt(file, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof(loopback)), 0);
    for (const std::string& text : strange)
    {
        ASSERT_EQ(::sendto(file, text.data(), text.size(), 0, reinterpret_cast<sockaddr*>(&group), sizeof(group)),
                  static_cast<ssize_t>(text.size()));
    }
    static_cast<void>(::close(file));
    ASSERT_EQ(other->Send(Live(0x42U, {})), SendResult::kSent);
    const std::optional<LiveFrame> frame = Wait(*one);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->identifier, 0x42U);
    EXPECT_EQ(one->Health().malformed, 7U);
}

// Given a receiver that reads nothing while 20000 frames are sent, then what it gets then is in order and what the
// system dropped is counted, together all.
TEST_F(UdpBus, CountsWhatWasLost)
{
    Verifies(req::SRS_LIVE_012);
    constexpr std::uint32_t kSent = 20'000U;
    for (std::uint32_t n = 0U; n < kSent; ++n)
    {
        LiveFrame frame = Live(0x10U, {0U, 0U});
        frame.data[0] = static_cast<std::uint8_t>(n >> 8U);
        frame.data[1] = static_cast<std::uint8_t>(n);
        ASSERT_EQ(one->Send(frame), SendResult::kSent);
    }
    std::uint32_t got = 0U;
    LiveFrame frame;
    std::uint32_t last = 0U;
    bool is_ordered = true;
    while (other->Receive(frame))
    {
        const std::uint32_t number = (std::uint32_t{frame.data[0]} << 8U) | frame.data[1];
        is_ordered = is_ordered && ((got == 0U) || (number > last));
        last = number;
        ++got;
    }
    EXPECT_TRUE(is_ordered);
    // The count of losses comes with the next datagram.
    ASSERT_EQ(one->Send(Live(0x11U, {})), SendResult::kSent);
    ASSERT_TRUE(Wait(*other));
    EXPECT_EQ(got + other->Health().lost_frames, kSent);
}

// Given 125 kbit/s and frames of 8 bytes (0x55: 111 bits with the intermission), when 10 are sent at once, then the
// last one is not sent before 9 * 888 us have passed, and all arrive in order.
TEST(UdpBusPace, SpreadsFramesOverTime)
{
    Verifies(req::SRS_LIVE_004);
    Verifies(req::SRS_LIVE_013);
    const auto sender = OpenLiveBus(Group("?bitrate=125000"));
    const auto receiver = OpenLiveBus(Group(""));
    const std::uint64_t start_ns = LiveNow();
    for (std::uint8_t n = 0U; n < 10U; ++n)
    {
        ASSERT_EQ(sender->Send(Live(0x155U, {0x55U, 0x55U, 0x55U, 0x55U, 0x55U, 0x55U, 0x55U, n})), SendResult::kSent);
    }
    EXPECT_LE(sender->Health().waiting, 9U);
    LiveFrame last;
    for (std::uint8_t n = 0U; n < 10U; ++n)
    {
        const std::optional<LiveFrame> own = Wait(*sender);
        ASSERT_TRUE(own);
        EXPECT_TRUE(own->own);
        EXPECT_EQ(own->data[7], n);
        last = *own;
    }
    EXPECT_GE(last.time_ns - start_ns, 9U * 888'000U);
    EXPECT_EQ(sender->Health().waiting, 0U);
    EXPECT_EQ(receiver->Health().state, BusState::kActive);
}

// Given ten frames of somebody who keeps no pace, when they were seen, then an own one waits as long as they would
// take.
TEST(UdpBusPace, WaitsForTheFramesOfOthersToo)
{
    Verifies(req::SRS_LIVE_013);
    const auto paced = OpenLiveBus(Group("?bitrate=125000"));
    const auto free = OpenLiveBus(Group(""));
    const std::uint64_t start_ns = LiveNow();
    for (std::uint8_t n = 0U; n < 10U; ++n)
    {
        ASSERT_EQ(free->Send(Live(0x155U, {0x55U, 0x55U, 0x55U, 0x55U, 0x55U, 0x55U, 0x55U, n})), SendResult::kSent);
    }
    for (std::uint8_t n = 0U; n < 10U; ++n)
    {
        ASSERT_TRUE(Wait(*paced));
    }
    ASSERT_EQ(paced->Send(Live(0x156U, {})), SendResult::kSent);
    const std::optional<LiveFrame> own = Wait(*paced);
    ASSERT_TRUE(own);
    EXPECT_TRUE(own->own);
    EXPECT_GE(own->time_ns - start_ns, 10U * 888'000U);
}

// Given a bus with a pace, which is one of classical frames, then one with flexible data rate is refused there, and
// takes no time there when others send it.
TEST(UdpBusPace, KnowsNoFlexibleDataRate)
{
    Verifies(req::SRS_LIVE_013);
    const auto paced = OpenLiveBus(Group("?bitrate=10000"));
    const auto free = OpenLiveBus(Group(""));
    LiveFrame flexible = Live(1U, {});
    flexible.fd = true;
    EXPECT_EQ(paced->Send(flexible), SendResult::kRefused);
    ASSERT_EQ(free->Send(flexible), SendResult::kSent);
    EXPECT_TRUE(Wait(*paced)->fd);
    ASSERT_EQ(paced->Send(Live(2U, {})), SendResult::kSent);
    EXPECT_EQ(paced->Health().waiting, 0U);
}

// Given a slow bus, when more than 64 frames wait, then the next is refused and nothing of what was taken is lost.
TEST(UdpBusPace, RefusesWhenItsQueueIsFull)
{
    Verifies(req::SRS_LIVE_004);
    Verifies(req::SRS_LIVE_005);
    const auto bus = OpenLiveBus(Group("?bitrate=100000"));
    std::uint8_t taken = 0U;
    SendResult last = SendResult::kSent;
    while ((taken < 250U) && (last == SendResult::kSent))
    {
        last = bus->Send(Live(0x1U, {taken}));
        taken = static_cast<std::uint8_t>(taken + ((last == SendResult::kSent) ? 1U : 0U));
    }
    EXPECT_EQ(last, SendResult::kQueueFull);
    EXPECT_GE(taken, 65U);
    EXPECT_EQ(bus->Health().waiting, 64U);
    for (std::uint8_t n = 0U; n < taken; ++n)
    {
        const std::optional<LiveFrame> frame = Wait(*bus);
        ASSERT_TRUE(frame);
        EXPECT_EQ(frame->data[0], n);
    }
}

// Given filters for 0x100 to 0x10F and one extended identifier, then only these pass.
TEST(UdpBusFilter, PassesWhatMatches)
{
    Verifies(req::SRS_LIVE_014);
    LiveOptions options;
    options.filters = {{0x100U, 0x7F0U, false}, {0x100U, 0x1FFF'FFFFU, true}};
    const auto bus = OpenLiveBus(Group(""), options);
    const auto sender = OpenLiveBus(Group(""));
    LiveFrame extended = Live(0x100U, {1U});
    extended.extended = true;
    LiveFrame other_extended = Live(0x101U, {2U});
    other_extended.extended = true;
    for (const LiveFrame& frame : {Live(0x0FFU, {}), Live(0x10FU, {3U}), Live(0x110U, {}), other_extended, extended})
    {
        ASSERT_EQ(sender->Send(frame), SendResult::kSent);
    }
    EXPECT_EQ(Wait(*bus)->data[0], 3U);
    EXPECT_EQ(Wait(*bus)->data[0], 1U);
    LiveFrame none;
    EXPECT_FALSE(bus->Receive(none));
}

TEST(UdpBusFilter, ErrorFramesAlwaysPass)
{
    Verifies(req::SRS_LIVE_014);
    const std::vector<IdentifierFilter> filters{{0x100U, 0x7FFU, false}};
    LiveFrame error = Live(0x040U, {});
    EXPECT_FALSE(Passes(filters, error));
    error.error = true;
    EXPECT_TRUE(Passes(filters, error));
    EXPECT_TRUE(Passes(filters, Live(0x100U, {})));
    EXPECT_TRUE(Passes({}, Live(0x040U, {})));
}

} // namespace
} // namespace counterpoint::host
