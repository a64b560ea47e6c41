// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/vm/probe_checks.hpp"

#include "hal/host/live/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace counterpoint::vm
{
namespace
{

constexpr std::uint64_t kMillisecondNs = 1'000'000U;

using host::LiveBus;
using host::LiveFrame;
using host::SendResult;

void WaitFor(const LiveBus& bus, const int milliseconds)
{
    pollfd wait{bus.Descriptor(), POLLIN, 0};
    static_cast<void>(::poll(&wait, 1U, milliseconds));
}

/// The other process of an exchange: answers each frame of 100h by one of 101h with the same data.
[[noreturn]] void AnswerAll(const std::string& name)
{
    const auto bus = host::OpenLiveBus(name);
    // Says that it listens: before, a frame would be lost.
    static_cast<void>(bus->Send(Frame(0x1FFU, {})));
    while (true)
    {
        LiveFrame frame;
        while (bus->Receive(frame))
        {
            if (frame.identifier == 0x100U)
            {
                frame.identifier = 0x101U;
                static_cast<void>(bus->Send(frame));
            }
        }
        WaitFor(*bus, 1000);
    }
}

void ExchangeFrames(LiveBus& bus)
{
    constexpr std::uint32_t kCount = 200U;
    std::vector<std::uint64_t> trips;
    for (std::uint32_t n = 0U; n < kCount; ++n)
    {
        const auto low = static_cast<std::uint8_t>(n);
        const std::uint64_t before_ns = host::LiveNow();
        Expect(bus.Send(Frame(0x100U, {low, 0xA5U})) == SendResult::kSent, "frame " + std::to_string(n) + " taken");
        const LiveFrame own = Next(bus, "own frame " + std::to_string(n));
        Expect(own.own && (own.identifier == 0x100U) && (own.data[0] == low), "own frame first, unchanged");
        const LiveFrame answer = Next(bus, "answer " + std::to_string(n));
        Expect(!answer.own && (answer.identifier == 0x101U) && (answer.data[0] == low) && (answer.length_bytes == 2U),
               "answer of the other process, unchanged");
        Expect((before_ns <= own.time_ns) && (own.time_ns <= answer.time_ns) && (answer.time_ns <= host::LiveNow()),
               "stamps between sending and now, in order");
        trips.push_back(answer.time_ns - own.time_ns);
    }
    std::sort(trips.begin(), trips.end());
    std::cout << "note: " << kCount << " exchanges; median " << trips[kCount / 2U] / 1000U
              << " us from own frame to answer by the kernel's stamps\n";
}

void SendRaw(const std::string& interface, const can_frame& frame)
{
    const int file = ::socket(PF_CAN, SOCK_RAW, CAN_RAW);
    sockaddr_can own{};
    own.can_family = AF_CAN;
    own.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
    const bool is_sent = (::bind(file, reinterpret_cast<const sockaddr*>(&own), sizeof(own)) == 0) &&
                         (::write(file, &frame, sizeof(frame)) == static_cast<ssize_t>(sizeof(frame)));
    static_cast<void>(::close(file));
    Expect(is_sent, "an error frame put on " + interface);
}

} // namespace

void Expect(const bool holds, const std::string& expected)
{
    if (!holds)
    {
        throw Failure("expected: " + expected);
    }
}

LiveFrame Frame(const std::uint32_t identifier, const std::vector<std::uint8_t>& data)
{
    LiveFrame frame;
    frame.identifier = identifier;
    frame.length_bytes = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data);
    return frame;
}

LiveFrame Next(LiveBus& bus, const std::string& expected)
{
    const std::uint64_t start_ns = host::LiveNow();
    LiveFrame frame;
    while (host::LiveNow() - start_ns < 10'000U * kMillisecondNs)
    {
        if (bus.Receive(frame))
        {
            return frame;
        }
        WaitFor(bus, 100);
    }
    throw Failure("expected: " + expected + ", within ten seconds");
}

void ServeUntil(LiveBus& bus, const std::function<bool()>& is_done, const std::string& expected)
{
    const std::uint64_t start_ns = host::LiveNow();
    LiveFrame frame;
    while (true)
    {
        while (bus.Receive(frame))
        {
        }
        if (is_done())
        {
            return;
        }
        Expect(host::LiveNow() - start_ns < 10'000U * kMillisecondNs, expected);
        // As long as the patience here: what happens next has to wake the descriptor by itself.
        WaitFor(bus, 10'000);
    }
}

std::vector<LiveFrame> Serve(LiveBus& bus, const std::uint32_t milliseconds)
{
    const std::uint64_t start_ns = host::LiveNow();
    std::vector<LiveFrame> frames;
    LiveFrame frame;
    while (host::LiveNow() - start_ns < milliseconds * kMillisecondNs)
    {
        while (bus.Receive(frame))
        {
            frames.push_back(frame);
        }
        WaitFor(bus, 10);
    }
    return frames;
}

void Shell(const std::string& command)
{
    const std::string whole = ". /lib.sh; " + command;
    std::cout.flush();
    Expect(std::system(whole.c_str()) == 0, "success of: " + command);
}

/// Two processes, one bus each: every frame is confirmed, answered, and has a stamp in the right order.
void CheckExchange(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    const pid_t child = ::fork();
    if (child == 0)
    {
        AnswerAll(buses[1]);
    }
    try
    {
        Expect(Next(*bus, "the other process").identifier == 0x1FFU, "the other process listens");
        ExchangeFrames(*bus);
    }
    catch (const Failure&)
    {
        static_cast<void>(::kill(child, SIGKILL));
        throw;
    }
    static_cast<void>(::kill(child, SIGKILL));
    static_cast<void>(::waitpid(child, nullptr, 0));
}

/// Two sockets on one interface: own is set for the sender only, also for remote and extended frames.
void CheckOwn(const Names& buses)
{
    const auto sender = host::OpenLiveBus(buses[0]);
    const auto other = host::OpenLiveBus(buses[0]);
    LiveFrame remote = Frame(0x701U, {});
    remote.remote = true;
    remote.length_bytes = 1U;
    LiveFrame extended = Frame(0x1ABC'DEF0U, {1U, 2U, 3U});
    extended.extended = true;
    for (const LiveFrame& frame : {Frame(0x181U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}), remote, extended})
    {
        Expect(sender->Send(frame) == SendResult::kSent, "frame taken");
        for (LiveBus* const bus : {sender.get(), other.get()})
        {
            const LiveFrame got = Next(*bus, "the frame");
            Expect(got.own == (bus == sender.get()), "own with the sender only");
            Expect((got.identifier == frame.identifier) && (got.remote == frame.remote) &&
                       (got.extended == frame.extended) && (got.length_bytes == frame.length_bytes),
                   "the frame as it was");
        }
    }
}

/// Filters of the kernel: identifier, mask and width.
void CheckFilters(const Names& buses)
{
    host::LiveOptions options;
    options.filters = {{0x580U, 0x780U, false}, {0x42U, 0x1FFF'FFFFU, true}};
    const auto bus = host::OpenLiveBus(buses[0], options);
    const auto sender = host::OpenLiveBus(buses[0]);
    LiveFrame extended = Frame(0x42U, {2U});
    extended.extended = true;
    LiveFrame wrong_width = Frame(0x581U, {9U});
    wrong_width.extended = true;
    for (const LiveFrame& frame :
         {Frame(0x57FU, {9U}), Frame(0x5FFU, {1U}), Frame(0x600U, {9U}), Frame(0x42U, {9U}), wrong_width, extended})
    {
        Expect(sender->Send(frame) == SendResult::kSent, "frame taken");
    }
    const std::vector<LiveFrame> got = Serve(*bus, 200U);
    Expect((got.size() == 2U) && (got[0].data[0] == 1U) && (got[1].data[0] == 2U), "5FFh and extended 42h, only these");
}

/// A receiver that reads nothing while 4000 frames are sent: what it has is in order, and what it lost is counted.
void CheckLostFrames(const Names& buses)
{
    constexpr std::uint32_t kCount = 4'000U;
    const auto slow = host::OpenLiveBus(buses[0]);
    const auto sender = host::OpenLiveBus(buses[0]);
    LiveFrame frame;
    for (std::uint32_t n = 0U; n < kCount; ++n)
    {
        const LiveFrame sent = Frame(0x10U, {static_cast<std::uint8_t>(n >> 8U), static_cast<std::uint8_t>(n)});
        Expect(sender->Send(sent) == SendResult::kSent, "frame taken");
        while (sender->Receive(frame))
        {
        }
    }
    std::uint32_t got = 0U;
    std::uint32_t last = 0U;
    while (slow->Receive(frame))
    {
        const std::uint32_t number = (std::uint32_t{frame.data[0]} << 8U) | frame.data[1];
        Expect((got == 0U) || (number > last), "frames in order");
        last = number;
        ++got;
    }
    // The kernel tells the count with the next frame.
    Expect(sender->Send(Frame(0x11U, {})) == SendResult::kSent, "frame taken");
    Expect(Next(*slow, "the last frame").identifier == 0x11U, "the last frame");
    std::cout << "note: " << got << " of " << kCount << " frames received, " << slow->Health().lost_frames << " lost\n";
    Expect(got + slow->Health().lost_frames == kCount, "received and lost are all");
}

/// What is no CAN interface cannot be opened, and a sentence says so.
void CheckAbsent(const Names& buses)
{
    for (const std::string& name : buses)
    {
        std::string text;
        try
        {
            static_cast<void>(host::OpenLiveBus(name));
        }
        catch (const host::LiveBusError& problem)
        {
            text = problem.what();
        }
        Expect(text == "bus '" + name + "': No such device, expected a CAN interface '" + name + "'",
               "a refusal of " + name + ", not '" + text + "'");
    }
}

/// Error frames, put on a virtual interface by another socket, drive state, counters and counts.
void CheckErrorFrames(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    can_frame raw{};
    raw.can_id = CAN_ERR_FLAG | CAN_ERR_CRTL | CAN_ERR_CNT;
    raw.can_dlc = CAN_ERR_DLC;
    raw.data[1] = CAN_ERR_CRTL_TX_PASSIVE;
    raw.data[6] = 130U;
    SendRaw(buses[0], raw);
    const LiveFrame passive = Next(*bus, "the error frame");
    Expect(passive.error &&
               (host::DescribeErrorFrame(passive) == "error passive (transmitter); 130 transmit, 0 receive errors"),
           "its words, not '" + host::DescribeErrorFrame(passive) + "'");
    Expect((bus->Health().state == host::BusState::kPassive) && (bus->Health().transmit_errors == 130U), "passive");
    raw.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
    SendRaw(buses[0], raw);
    Expect(Next(*bus, "the error frame").error && (bus->Health().state == host::BusState::kBusOff), "bus-off");
    Expect(bus->Send(Frame(1U, {})) == SendResult::kBusOff, "Send tells bus-off");
    raw.can_id = CAN_ERR_FLAG | CAN_ERR_RESTARTED;
    SendRaw(buses[0], raw);
    Expect(Next(*bus, "the error frame").error && (bus->Health().state == host::BusState::kActive), "active again");
    Expect(bus->Send(Frame(1U, {})) == SendResult::kSent, "frames go out again");
    Expect((bus->Health().bus_offs == 1U) && (bus->Health().restarts == 1U) && (bus->Health().error_frames == 3U),
           "counted");
}

/// Plain frames by the first interface, inverted ones by the second, of one process: each is confirmed where it was
/// sent, seen at the other, and the stamps of both interfaces are in the order of sending.
void CheckTwoInterfaces(const Names& buses)
{
    const auto plain = host::OpenLiveBus(buses[0]);
    const auto inverse = host::OpenLiveBus(buses[1]);
    for (std::uint8_t n = 0U; n < 100U; ++n)
    {
        Expect(plain->Send(Frame(0x101U, {n})) == SendResult::kSent, "plain frame taken");
        const LiveFrame own_plain = Next(*plain, "own plain frame");
        const LiveFrame seen_plain = Next(*inverse, "plain frame at the other interface");
        const auto inverted = static_cast<std::uint8_t>(~n);
        Expect(inverse->Send(Frame(0x102U, {inverted})) == SendResult::kSent, "inverse frame taken");
        const LiveFrame own_inverse = Next(*inverse, "own inverse frame");
        const LiveFrame seen_inverse = Next(*plain, "inverse frame at the other interface");
        Expect(own_plain.own && !seen_plain.own && own_inverse.own && !seen_inverse.own, "own where it was sent");
        Expect((own_plain.data[0] == n) && (seen_plain.data[0] == n) && (own_inverse.data[0] == inverted) &&
                   (seen_inverse.data[0] == inverted),
               "data as they were");
        Expect((own_plain.time_ns < own_inverse.time_ns) && (seen_plain.time_ns < seen_inverse.time_ns) &&
                   (own_plain.time_ns < seen_inverse.time_ns),
               "stamps in the order of the bus over both interfaces");
    }
}

} // namespace counterpoint::vm
