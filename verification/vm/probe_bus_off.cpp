// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Checks in which something goes wrong on the way: interface down, full queue, bus-off, adapter gone.
#include "verification/vm/probe_checks.hpp"

#include <iostream>

namespace counterpoint::vm
{
namespace
{

using host::BusState;
using host::LiveBus;
using host::LiveFrame;
using host::SendResult;

std::unique_ptr<LiveBus> OpenTimed(const std::string& name, const std::uint32_t milliseconds)
{
    host::LiveOptions options;
    options.restart = host::RestartPolicy::kTimed;
    options.restart_after_ms = milliseconds;
    return host::OpenLiveBus(name, options);
}

void ServeUntilState(LiveBus& bus, const BusState state, const std::string& expected)
{
    ServeUntil(bus, [&bus, state] { return bus.Health().state == state; }, expected);
}

void ExpectCarries(LiveBus& bus, const std::string& when)
{
    Expect(bus.Send(Frame(0x123U, {0x55U})) == SendResult::kSent, "a frame taken " + when);
    LiveFrame frame = Next(bus, "own frame " + when);
    while (frame.error)
    {
        frame = Next(bus, "own frame " + when);
    }
    Expect(frame.own && (frame.identifier == 0x123U), "own frame " + when);
}

void ExpectBusOff(LiveBus& bus)
{
    Shell("adapter_says busoff");
    ServeUntilState(bus, BusState::kBusOff, "bus-off recognised");
    ServeUntil(bus, [&bus] { return bus.Health().bus_offs == 1U; }, "one bus-off counted");
    Expect(bus.Send(Frame(0x1U, {})) == SendResult::kBusOff, "Send tells bus-off");
}

} // namespace

/// The interface goes down and up while the bus is open.
void CheckDownAndUp(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    ExpectCarries(*bus, "before");
    for (int round = 0; round < 3; ++round)
    {
        Shell("ip link set " + buses[0] + " down");
        ServeUntilState(*bus, BusState::kDown, "down recognised");
        Expect(bus->Send(Frame(0x1U, {})) == SendResult::kDown, "Send tells down");
        Shell("ip link set " + buses[0] + " up");
        ServeUntilState(*bus, BusState::kActive, "up recognised");
        ExpectCarries(*bus, "after down and up");
    }
    // Also when the first thing that notices is Send.
    Shell("ip link set " + buses[0] + " down");
    Expect(bus->Send(Frame(0x1U, {})) == SendResult::kDown, "Send alone tells down");
}

/// The interface is removed and made again under its name.
void CheckRemade(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    ExpectCarries(*bus, "before");
    Shell("ip link del " + buses[0]);
    ServeUntilState(*bus, BusState::kDown, "removal recognised");
    Expect(bus->Send(Frame(0x1U, {})) == SendResult::kDown, "Send tells down");
    Shell("vcan " + buses[0]);
    ServeUntilState(*bus, BusState::kActive, "the new interface recognised");
    ExpectCarries(*bus, "by the new interface");
}

/// No frame leaves the adapter and the queue of the interface is short: what Send took waits, in order, and leaves when
/// the adapter sends again; only then is it confirmed.
void CheckFullQueue(const Names& buses)
{
    Shell("adapter_says hold; ip link set " + buses[0] + " txqueuelen 5");
    const auto bus = host::OpenLiveBus(buses[0]);
    std::uint8_t taken = 0U;
    while ((taken < 200U) && (bus->Send(Frame(0x200U, {taken})) == SendResult::kSent))
    {
        ++taken;
    }
    std::cout << "note: " << int{taken} << " frames taken, " << bus->Health().waiting << " of them wait in the port\n";
    Expect((taken > 64U) && (taken < 200U) && (bus->Health().waiting == 64U), "64 frames in the port, then kQueueFull");
    Expect(bus->Send(Frame(0x200U, {taken})) == SendResult::kQueueFull, "the next one refused");
    Expect(Serve(*bus, 200U).empty(), "nothing confirmed that is not sent");
    Shell("adapter_says release");
    for (std::uint8_t n = 0U; n < taken; ++n)
    {
        const LiveFrame frame = Next(*bus, "own frame " + std::to_string(n) + " of " + std::to_string(taken));
        Expect(frame.own && (frame.data[0] == n),
               "own frame " + std::to_string(n) + " in its place, not " + std::to_string(frame.data[0]));
    }
    Expect((bus->Health().waiting == 0U) && (bus->Health().dropped_frames == 0U), "none lost");
}

/// Policy kManual: bus-off stays until Restart.
void CheckManualRestart(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    ExpectCarries(*bus, "before");
    Expect(!bus->Restart(), "no restart of a bus that is not off");
    ExpectBusOff(*bus);
    static_cast<void>(Serve(*bus, 500U));
    Expect(bus->Health().state == BusState::kBusOff, "bus-off stays");
    Expect(bus->Restart(), "restart done");
    ServeUntilState(*bus, BusState::kActive, "active after the restart");
    ServeUntil(*bus, [&bus] { return bus->Health().restarts == 1U; }, "one restart counted");
    ExpectCarries(*bus, "after the restart");
}

/// Policy kTimed: bus-off ends by itself after 300 ms, not before.
void CheckTimedRestart(const Names& buses)
{
    const auto bus = OpenTimed(buses[0], 300U);
    ExpectCarries(*bus, "before");
    ExpectBusOff(*bus);
    const std::uint64_t off_ns = host::LiveNow();
    ServeUntilState(*bus, BusState::kActive, "active again");
    const std::uint64_t took_ms = (host::LiveNow() - off_ns) / 1'000'000U;
    std::cout << "note: restarted " << took_ms << " ms after bus-off was recognised (300 ms asked)\n";
    Expect((took_ms >= 250U) && (took_ms < 5'000U), "about 300 ms, not " + std::to_string(took_ms));
    ServeUntil(*bus, [&bus] { return bus->Health().restarts == 1U; }, "one restart counted");
    ExpectCarries(*bus, "after the restart");
}

/// The kernel restarts by itself (restart-ms 200): nothing is asked for, and asking is refused.
void CheckKernelRestart(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    ExpectBusOff(*bus);
    Expect(!bus->Restart(), "no restart by request where the kernel does it");
    ServeUntilState(*bus, BusState::kActive, "active again");
    ServeUntil(*bus, [&bus] { return (bus->Health().bus_offs == 1U) && (bus->Health().restarts == 1U); }, "counted");
    ExpectCarries(*bus, "after the kernel's restart");
}

/// A driver without a restart: the interface is taken down and up.
void CheckRestartBySwitch(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    Shell("serial_adapter_says busoff");
    ServeUntilState(*bus, BusState::kBusOff, "bus-off recognised");
    Expect(bus->Restart(), "restart by down and up");
    ServeUntilState(*bus, BusState::kActive, "active after the restart");
    ServeUntil(*bus, [&bus] { return (bus->Health().bus_offs == 1U) && (bus->Health().restarts == 1U); }, "counted");
    ExpectCarries(*bus, "after the restart");
}

/// Warning and passive as the kernel has them, and back; frames from the bus meanwhile.
void CheckStates(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    Expect(bus->Health().state == BusState::kActive, "active at first");
    Shell("adapter_says warning");
    ServeUntilState(*bus, BusState::kWarning, "warning");
    Shell("adapter_says passive");
    ServeUntilState(*bus, BusState::kPassive, "passive");
    Expect(bus->Health().transmit_errors == 128U, "128 transmit errors");
    Shell("adapter_says frame 205 0102030405060708");
    const LiveFrame frame = Next(*bus, "the frame from the bus");
    Expect(!frame.own && (frame.identifier == 0x205U) && (frame.length_bytes == 8U) && (frame.data[7] == 8U),
           "the frame from the bus, unchanged");
    Shell("adapter_says active");
    ServeUntilState(*bus, BusState::kActive, "active again");
}

/// The card is taken out of the machine and put in again; its interface has the name of before.
void CheckUnplugged(const Names& buses)
{
    const auto bus = host::OpenLiveBus(buses[0]);
    ExpectCarries(*bus, "before");
    Shell("card_out " + buses[0]);
    ServeUntilState(*bus, BusState::kDown, "absence recognised");
    Expect(bus->Send(Frame(0x1U, {})) == SendResult::kDown, "Send tells down");
    Shell("cards_in; cards");
    ServeUntilState(*bus, BusState::kActive, "the card recognised");
    ExpectCarries(*bus, "by the card put in again");
}

} // namespace counterpoint::vm
