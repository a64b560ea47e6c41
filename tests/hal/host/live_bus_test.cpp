// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/bus.hpp"

#include "hal/host/live/address.hpp"
#include "hal/host/live/stamp.hpp"
#include "tests/hal/host/live_rig.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstring>
#include <ctime>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace counterpoint::host
{
namespace
{

TEST(LiveAddressTest, ReadsTheFourForms)
{
    Verifies(req::SRS_LIVE_001);
    EXPECT_EQ(ParseLiveAddress("can0").interface, "can0");
    EXPECT_EQ(ParseLiveAddress("socketcan:vcan1").kind, LiveKind::kSocketCan);
    EXPECT_EQ(ParseLiveAddress("socketcan:vcan1").interface, "vcan1");
    const LiveAddress remote = ParseLiveAddress("socketcand:localhost:29536/can0");
    EXPECT_EQ(remote.kind, LiveKind::kSocketcand);
    EXPECT_EQ(remote.host, "localhost");
    EXPECT_EQ(remote.port, 29'536U);
    EXPECT_EQ(remote.interface, "can0");
    const LiveAddress udp = ParseLiveAddress("udp:239.74.163.2:43113?bitrate=125000");
    EXPECT_EQ(udp.kind, LiveKind::kUdp);
    EXPECT_EQ(udp.host, "239.74.163.2");
    EXPECT_EQ(udp.port, 43'113U);
    EXPECT_EQ(udp.bits_per_second, 125'000U);
}

TEST(LiveAddressTest, SaysWhatIsWrong)
{
    Verifies(req::SRS_LIVE_001);
    const auto problem = [](const std::string& text)
    { return ProblemOf([&text] { static_cast<void>(ParseLiveAddress(text)); }); };
    const std::string name = ", expected a name of 1 to 15 characters such as can0";
    EXPECT_EQ(problem(""), "bus '': interface ''" + name);
    EXPECT_EQ(problem("can0\n\x1B[31m"),
              "control character in column 5 of a bus, expected printable text such as can0");
    EXPECT_EQ(problem("can\x7F"), "control character in column 4 of a bus, expected printable text such as can0");
    EXPECT_EQ(problem("a/b"), "bus 'a/b': interface 'a/b'" + name);
    EXPECT_EQ(problem("socketcan:sixteen_letters_"),
              "bus 'socketcan:sixteen_letters_': interface 'sixteen_letters_'" + name);
    EXPECT_EQ(problem("tcp:x"), "bus 'tcp:x': kind 'tcp', expected can0, socketcan:can0, socketcand:HOST:PORT/can0 or "
                                "udp:239.74.163.2:43113");
    EXPECT_EQ(problem("socketcand:h:1"), "bus 'socketcand:h:1': no bus, expected socketcand:HOST:PORT/BUS");
    EXPECT_EQ(problem("socketcand:h/c"),
              "bus 'socketcand:h/c': no host and port in 'h', expected HOST:PORT, an IPv6 address in brackets");
    EXPECT_EQ(problem("socketcand:::1:5/c"),
              "bus 'socketcand:::1:5/c': no host and port in '::1:5', expected HOST:PORT, an IPv6 address in brackets");
    EXPECT_EQ(problem("socketcand:h:0/c"), "bus 'socketcand:h:0/c': port '0', expected a number from 1 to 65535");
    EXPECT_EQ(problem("socketcand:h:65536/c"),
              "bus 'socketcand:h:65536/c': port '65536', expected a number from 1 to 65535");
    EXPECT_EQ(problem("socketcand:h:1x/c"), "bus 'socketcand:h:1x/c': port '1x', expected a number from 1 to 65535");
    EXPECT_EQ(problem("socketcand:h:/c"), "bus 'socketcand:h:/c': port '', expected a number from 1 to 65535");
    EXPECT_EQ(
        problem("socketcand:[::1:5/c"),
        "bus 'socketcand:[::1:5/c': no host and port in '[::1:5', expected HOST:PORT, an IPv6 address in brackets");
    for (const std::string text : {".", "..", "a b", "can\xC3\xA4", "socketcan:a:b"})
    {
        const std::string interface = text.substr(text.compare(0U, 10U, "socketcan:") == 0 ? 10U : 0U);
        EXPECT_EQ(problem(text), "bus '" + text + "': interface '" + interface + "'" + name);
    }
    EXPECT_EQ(problem("udp:host:5"),
              "bus 'udp:host:5': group 'host', expected an IPv4 multicast group such as 239.74.163.2");
    EXPECT_EQ(problem("udp:10.0.0.1:5"),
              "bus 'udp:10.0.0.1:5': group '10.0.0.1', expected an IPv4 multicast group such as 239.74.163.2");
    EXPECT_EQ(problem("udp:239.0.0.1:5?rate=1"), "bus 'udp:239.0.0.1:5?rate=1': option 'rate=1', expected bitrate=N");
    EXPECT_EQ(problem("udp:239.0.0.1:5?bitrate=9"),
              "bus 'udp:239.0.0.1:5?bitrate=9': bit rate '9', expected 10000, 20000, 50000, 100000, 125000, 250000, "
              "500000, 800000 or 1000000");
}

// Given a stamp 5 ms old by the wall clock, then it is 5 ms old by the monotonic clock; one from the future, or older
// than 10 s, is now.
TEST(LiveStampTest, TakesTheAgeOfAStamp)
{
    Verifies(req::SRS_LIVE_002);
    constexpr std::uint64_t kWall = 1'700'000'000'000'000'000U;
    EXPECT_EQ(MonotonicStamp(kWall - 5'000'000U, kWall, 60'000'000'000U), 59'995'000'000U);
    EXPECT_EQ(MonotonicStamp(kWall, kWall, 60'000'000'000U), 60'000'000'000U);
    EXPECT_EQ(MonotonicStamp(kWall + 1U, kWall, 60'000'000'000U), 60'000'000'000U);
    EXPECT_EQ(MonotonicStamp(kWall - 10'000'000'000U, kWall, 60'000'000'000U), 50'000'000'000U);
    EXPECT_EQ(MonotonicStamp(kWall - 10'000'000'001U, kWall, 60'000'000'000U), 60'000'000'000U);
    EXPECT_EQ(MonotonicStamp(kWall - 2'000U, kWall, 1'000U), 1'000U);
}

// Given a reader that was interrupted 3 ms between two clocks, and between two others, then the reading without
// interruption counts.
TEST(LiveStampTest, AnInterruptedReaderLooksAgain)
{
    Verifies(req::SRS_LIVE_002);
    const ClockReading quick{20'000U, 900U, 20'090U};
    const ClockReading slow{10'000U, 800U, 3'010'000U};
    const ClockReading slower{30'000U, 700U, 7'030'000U};
    EXPECT_EQ(Quickest({quick, slow, slower}).wall_ns, 900U);
    EXPECT_EQ(Quickest({slow, quick, slower}).wall_ns, 900U);
    EXPECT_EQ(Quickest({slower, slow, quick}).wall_ns, 900U);
    EXPECT_EQ(Quickest({slower, slow, slow}).wall_ns, 800U);
}

/// One message of control, as the system puts it behind what was received.
template <typename Value> LiveArrival StampedBy(const int level, const int type, const Value& value)
{
    alignas(cmsghdr) std::array<std::uint8_t, CMSG_SPACE(sizeof(Value))> control{};
    cmsghdr head{};
    head.cmsg_len = CMSG_LEN(sizeof(Value));
    head.cmsg_level = level;
    head.cmsg_type = type;
    std::memcpy(control.data(), &head, sizeof(head));
    std::memcpy(control.data() + CMSG_LEN(0), &value, sizeof(value));
    msghdr message{};
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    LiveArrival arrival;
    arrival.time_ns = 5U;
    ReadStamps(message, arrival);
    return arrival;
}

// Given what a system says beside a frame, then its own count of losses is taken, and what is something else is not.
TEST(LiveStampTest, TakesWhatItKnowsAndNothingElse)
{
    Verifies(req::SRS_LIVE_002);
    Verifies(req::SRS_LIVE_027);
    const std::uint32_t number = 7U;
    EXPECT_EQ(StampedBy(SOL_SOCKET, SO_RXQ_OVFL, number).dropped, 7U);
    EXPECT_EQ(StampedBy(IPPROTO_IP, SO_RXQ_OVFL, number).dropped, 0U);
    EXPECT_EQ(StampedBy(SOL_SOCKET, SCM_RIGHTS, number).dropped, 0U);
    // Without any message of control, the time of reading stays
    msghdr message{};
    LiveArrival arrival;
    arrival.time_ns = 5U;
    ReadStamps(message, arrival);
    EXPECT_EQ(arrival.time_ns, 5U);
    EXPECT_EQ(arrival.dropped, 0U);
}

// Given what the kernel says of a frame that came 2 s ago by the wall clock, then that is its time by the monotonic
// one.
TEST(LiveStampTest, TakesTheStampOfTheKernel)
{
    Verifies(req::SRS_LIVE_002);
    constexpr std::uint64_t kSecondNs = 1'000'000'000U;
    const auto seconds_ago = [](const std::time_t seconds)
    {
        timespec wall{};
        EXPECT_EQ(::clock_gettime(CLOCK_REALTIME, &wall), 0);
        wall.tv_sec -= seconds;
        return wall;
    };
    bool is_quick = false;
    while (!is_quick) // A reading that was interrupted tells nothing.
    {
        const std::uint64_t before_ns = LiveNow();
        const timespec stamp = seconds_ago(2);
        const std::uint64_t time_ns = StampedBy(SOL_SOCKET, SO_TIMESTAMPNS, stamp).time_ns;
        is_quick = (LiveNow() - before_ns) < (kSecondNs / 10U);
        EXPECT_TRUE(!is_quick || (time_ns >= before_ns - (2U * kSecondNs) - (kSecondNs / 10U)));
        EXPECT_TRUE(!is_quick || (time_ns <= before_ns - (2U * kSecondNs) + (kSecondNs / 10U)));
    }
}

TEST(LiveFrameTest, OnlyLengthsOfFlexibleDataRateAreSentWithIt)
{
    Verifies(req::SRS_LIVE_015);
    LiveFrame frame = Live(1U, {});
    frame.fd = true;
    for (const std::uint8_t length : std::initializer_list<std::uint8_t>{8U, 12U, 16U, 20U, 24U, 32U, 48U, 64U})
    {
        frame.length_bytes = length;
        EXPECT_TRUE(IsSendable(frame)) << int{length};
    }
    for (const std::uint8_t length : std::initializer_list<std::uint8_t>{9U, 13U, 63U, 65U})
    {
        frame.length_bytes = length;
        EXPECT_FALSE(IsSendable(frame)) << int{length};
    }
}

TEST(LiveTimeTest, WhatIsOverIsNotWaitedFor)
{
    Verifies(req::SRS_LIVE_005);
    EXPECT_EQ(MillisecondsUntil(LiveNow()), 0);
    EXPECT_GT(MillisecondsUntil(LiveNow() + 3'000'000'000U), 1'000);
}

// Given every kind of frame of the kernel, then it is the same after a way through the live form.
TEST(LiveFrameTest, ConvertsToTheKernelsFrameAndBack)
{
    Verifies(req::SRS_LIVE_015);
    for (const FrameKind kind : {FrameKind::kData, FrameKind::kRemote, FrameKind::kExtended, FrameKind::kExtendedRemote,
                                 FrameKind::kFlexibleDataRate})
    {
        const CanFrame frame{0x123U, kind, CanPortId::kSecond, 3U, {1U, 2U, 3U}};
        const CanFrame back = ToCanFrame(FromCanFrame(frame), CanPortId::kSecond);
        EXPECT_EQ(back.identifier, 0x123U);
        EXPECT_EQ(back.kind, kind);
        EXPECT_EQ(back.port, CanPortId::kSecond);
        EXPECT_EQ(back.length_bytes, 3U);
        EXPECT_EQ(back.data[2], 3U);
    }
    LiveFrame error;
    error.error = true;
    EXPECT_EQ(ToCanFrame(error, CanPortId::kFirst).kind, FrameKind::kInvalid);
    LiveFrame flexible;
    flexible.fd = true;
    flexible.length_bytes = 64U;
    EXPECT_EQ(ToCanFrame(flexible, CanPortId::kFirst).length_bytes, 64U);
}

} // namespace
} // namespace counterpoint::host
