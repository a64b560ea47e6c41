// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kAccepted = static_cast<std::uint32_t>(TransmitStatus::kAccepted);
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kMostSeen = 512U;
constexpr std::uint32_t kMostCyclesOff = 1000U;
constexpr const char* kNoCan = "the port has no CAN ports";
constexpr const char* kNoHold = "the bench cannot hold the bus";
constexpr const char* kStatus = "status of Transmit (0x69 accepted)";

[[nodiscard]] std::uint32_t Transmit(const PortUnderTest& port, const CanFrame& frame) noexcept
{
    return static_cast<std::uint32_t>(port.parts.can->Transmit(frame));
}

void ExpectConfirmed(const PortUnderTest& port, Check& check, const CanFrame& frame) noexcept
{
    const PortEvent event = port.bench.next(port.bench.bench);
    check.EqualCode("kind of event (0x5A confirmed)", static_cast<std::uint32_t>(EventKind::kConfirmed),
                    static_cast<std::uint32_t>(event.kind));
    check.EqualCode("identifier", frame.identifier, event.frame.frame.identifier);
    check.EqualCode("frame as it was handed over (1: it is)", 1U, AreEqual(frame, event.frame.frame) ? 1U : 0U);
}

void HoldBus(const PortUnderTest& port, const Hold hold) noexcept
{
    port.bench.hold_bus(port.bench.bench, hold);
}

/// Which numbered frames were accepted, and which confirmed: a bit each.
struct NumberSet
{
    std::uint32_t words[8]; // MISRA D-001
};

/// @brief Adds the number; how often it was in before. A number beyond the set counts as one that was in.
[[nodiscard]] std::uint32_t Add(NumberSet& set, const std::uint32_t number) noexcept
{
    const std::uint32_t word = number / kWordBits;
    if (word >= 8U)
    {
        return 1U;
    }
    const std::uint32_t bit = 1U << (number % kWordBits);
    const bool was_in = (set.words[word] & bit) != 0U;
    set.words[word] |= bit;
    return was_in ? 1U : 0U;
}

/// Takes all confirmations out: each must be of an accepted frame, and the first of it.
[[nodiscard]] std::uint32_t CountConfirmed(const PortUnderTest& port, Check& check, NumberSet& accepted) noexcept
{
    NumberSet confirmed{};
    std::uint32_t count = 0U;
    PortEvent event = port.bench.next(port.bench.bench);
    for (std::uint32_t taken = 0U; (taken < kMostSeen) && (event.kind != EventKind::kNothing); ++taken)
    {
        if (event.kind == EventKind::kConfirmed)
        {
            const std::uint32_t number = NumberOf(event.frame.frame);
            check.Equal("confirmations of a frame that was refused", 1U, Add(accepted, number));
            check.Equal("second confirmations of a frame", 0U, Add(confirmed, number));
            ++count;
        }
        event = port.bench.next(port.bench.bench);
    }
    return count;
}

/// How often the frame of this number was confirmed; that no other one was, nor received by the other node.
[[nodiscard]] std::uint32_t CountOf(const PortUnderTest& port, const std::uint32_t number, Check& check) noexcept
{
    std::uint32_t count = 0U;
    PortEvent event = port.bench.next(port.bench.bench);
    for (std::uint32_t taken = 0U; (taken < kMostSeen) && (event.kind != EventKind::kNothing); ++taken)
    {
        const bool is_it = NumberOf(event.frame.frame) == number;
        const bool is_confirmed = event.kind == EventKind::kConfirmed;
        check.Equal("confirmations of frames of before", 0U, (is_confirmed && !is_it) ? 1U : 0U);
        count += (is_confirmed && is_it) ? 1U : 0U;
        event = port.bench.next(port.bench.bench);
    }
    CanFrame seen{};
    for (std::uint32_t taken = 0U;
         (taken < kMostSeen) && (port.bench.peer_take != nullptr) && port.bench.peer_take(port.bench.bench, seen);
         ++taken)
    {
        check.Equal("number of a frame that the other node received", number, NumberOf(seen));
    }
    return count;
}

/// @brief What the other node has received so far is of no interest.
void ForgetSeen(const PortUnderTest& port) noexcept
{
    CanFrame seen{};
    for (std::uint32_t taken = 0U;
         (taken < kMostSeen) && (port.bench.peer_take != nullptr) && port.bench.peer_take(port.bench.bench, seen);
         ++taken)
    {
    }
}

} // namespace

void ConfirmedOnceAsSent(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.can == nullptr)
    {
        check.NotShown(kNoCan);
        return;
    }
    Settle(port);
    CanFrame frame = NumberedFrame(port.numbers.sent[0], 0x1234U);
    frame.length_bytes = kMaxPayloadBytes;
    frame.data[7] = 0x9AU;
    check.EqualCode(kStatus, kAccepted, Transmit(port, frame));
    PassCycles(port, CyclesForFrames(port, 3U));
    ExpectConfirmed(port, check, frame);
    PassCycles(port, CyclesForFrames(port, 3U));
    const Drained rest = Drain(port);
    check.Equal("further confirmations", 0U, rest.confirmed);
    check.Equal("receptions of the own frame", 0U, rest.received);
}

void ConfirmationHasBothStamps(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.parts.clocks == nullptr))
    {
        check.NotShown("the port has no CAN ports or no clocks");
        return;
    }
    Settle(port);
    const InstantPair before = port.parts.clocks->Now();
    const std::uint32_t latest = port.numbers.frame_us + port.numbers.tolerance_us;
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[0], 1U)));
    PassCycles(port, CyclesForFrames(port, 3U) + 3U);
    const PortEvent event = port.bench.next(port.bench.bench);
    check.EqualCode("kind of event (0x5A confirmed)", static_cast<std::uint32_t>(EventKind::kConfirmed),
                    static_cast<std::uint32_t>(event.kind));
    check.Within("us of counter A from the call to the stamp", Span{0U, latest}, event.frame.stamp.a.us - before.a.us);
    check.Within("us of counter B from the call to the stamp", Span{0U, latest}, event.frame.stamp.b.us - before.b.us);
}

void NotConfirmedBeforeTheBus(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.bench.hold_bus == nullptr))
    {
        check.NotShown(kNoHold);
        return;
    }
    Settle(port);
    HoldBus(port, Hold::kHeld);
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[0], 1U)));
    PassCycles(port, CyclesForFrames(port, 3U));
    check.Equal("confirmations while nothing leaves", 0U, Drain(port).confirmed);
    const bool has_clocks = port.parts.clocks != nullptr;
    const InstantPair released = has_clocks ? port.parts.clocks->Now() : InstantPair{{0U}, {0U}};
    HoldBus(port, Hold::kReleased);
    const std::uint32_t cycles = CyclesForFrames(port, 3U);
    PassCycles(port, cycles);
    const Drained drained = Drain(port);
    check.Equal("confirmations once it has left", 1U, drained.confirmed);
    if (has_clocks && check.IsHeld())
    {
        // The end of the frame on the bus, not the moment at which it was handed over.
        const InstantPair stamp = drained.first.frame.stamp;
        const Span expected{0U, (cycles * port.numbers.cycle_us) + port.numbers.tolerance_us};
        check.Within("us of counter A from the release of the bus to the stamp", expected, stamp.a.us - released.a.us);
        check.Within("us of counter B from the release of the bus to the stamp", expected, stamp.b.us - released.b.us);
    }
}

void NormalLeavesBeforeInverse(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.bench.hold_bus == nullptr))
    {
        check.NotShown(kNoHold);
        return;
    }
    Settle(port);
    HoldBus(port, Hold::kHeld);
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[0], 1U)));
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[1], 2U)));
    HoldBus(port, Hold::kReleased);
    PassCycles(port, CyclesForFrames(port, 4U));
    ExpectConfirmed(port, check, NumberedFrame(port.numbers.sent[0], 1U));
    ExpectConfirmed(port, check, NumberedFrame(port.numbers.sent[1], 2U));
}

void FullIsRefused(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.bench.hold_bus == nullptr))
    {
        check.NotShown(kNoHold);
        return;
    }
    Settle(port);
    HoldBus(port, Hold::kHeld);
    NumberSet accepted{};
    std::uint32_t count = 0U;
    std::uint32_t status = kAccepted;
    const std::uint32_t most = port.numbers.transmit_room + 4U;
    for (std::uint32_t number = 0U; (number < most) && (status == kAccepted); ++number)
    {
        status = Transmit(port, NumberedFrame(port.numbers.sent[0], number));
        count += (status == kAccepted) ? 1U : 0U;
        static_cast<void>((status == kAccepted) ? Add(accepted, number) : 0U);
    }
    check.EqualCode("status of Transmit beyond the room (1 queue full)",
                    static_cast<std::uint32_t>(TransmitStatus::kQueueFull), status);
    HoldBus(port, Hold::kReleased);
    PassCycles(port, CyclesForFrames(port, count + 3U));
    check.Equal("confirmations of accepted frames", count, CountConfirmed(port, check, accepted));
}

void OnTheBusAsHandedOver(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.bench.peer_take == nullptr))
    {
        check.NotShown("the other node does not tell what it received");
        return;
    }
    Settle(port);
    ForgetSeen(port);
    CanFrame seen{};
    for (std::uint8_t length = 0U; length <= kMaxPayloadBytes; ++length)
    {
        const FrameName& name = port.numbers.sent[length % 2U];
        const CanFrame frame{name.identifier,
                             FrameKind::kData,
                             name.port,
                             length,
                             {0x80U, 0x7FU, 0x01U, 0xFEU, 0x40U, 0xBFU, 0x02U, 0xFDU}};
        check.EqualCode(kStatus, kAccepted, Transmit(port, frame));
        PassCycles(port, CyclesForFrames(port, 3U));
        check.Equal("frames that the other node received", 1U, port.bench.peer_take(port.bench.bench, seen) ? 1U : 0U);
        seen.port = name.port; // The other node has one controller.
        check.EqualCode("identifier", frame.identifier, seen.identifier);
        check.Equal("length", frame.length_bytes, seen.length_bytes);
        check.EqualCode("frame as it was handed over (1: it is)", 1U, AreEqual(frame, seen) ? 1U : 0U);
        static_cast<void>(Drain(port));
    }
}

void WaitingFramesKeepOrder(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.bench.hold_bus == nullptr))
    {
        check.NotShown(kNoHold);
        return;
    }
    Settle(port);
    HoldBus(port, Hold::kHeld);
    for (std::uint32_t number = 0U; number < port.numbers.transmit_room; ++number)
    {
        static_cast<void>(Transmit(port, NumberedFrame(port.numbers.sent[number % 2U], number)));
    }
    HoldBus(port, Hold::kReleased);
    PassCycles(port, CyclesForFrames(port, port.numbers.transmit_room + 3U));
    const bool on_one_bus = port.numbers.sent[0].port == port.numbers.sent[1].port;
    // Even numbers are normal data; the number behind one is that of its inverse data.
    std::uint32_t next[2]{0U, 1U}; // MISRA D-001
    PortEvent event = port.bench.next(port.bench.bench);
    for (std::uint32_t taken = 0U; (taken < kMostSeen) && (event.kind != EventKind::kNothing); ++taken)
    {
        if (event.kind == EventKind::kConfirmed)
        {
            const std::uint32_t number = NumberOf(event.frame.frame);
            check.Equal("oldest frame of this identifier that waits", next[number % 2U], number);
            next[number % 2U] = number + 2U;
            // Two controllers may each send at the same moment.
            check.Equal("inverse data before their normal data", 0U,
                        (on_one_bus && (next[1] > (next[0] + 1U))) ? 1U : 0U);
        }
        event = port.bench.next(port.bench.bench);
    }
}

void OwnAndForeignInOrder(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.can == nullptr)
    {
        check.NotShown(kNoCan);
        return;
    }
    Settle(port);
    const std::uint32_t cycles = CyclesForFrames(port, 2U);
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[0], 1U)));
    PassCycles(port, cycles);
    const bool is_sent = Receive(port, NumberedFrame(port.numbers.received[0], 2U));
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[1], 3U)));
    PassCycles(port, cycles);
    if (!is_sent)
    {
        check.NotShown("the other node cannot send this");
        return;
    }
    for (std::uint32_t number = 1U; number <= 3U; ++number)
    {
        const PortEvent event = port.bench.next(port.bench.bench);
        check.Equal("number of the frame", number, NumberOf(event.frame.frame));
        check.EqualCode("kind of event (0x3C received, 0x5A confirmed)",
                        static_cast<std::uint32_t>((number == 2U) ? EventKind::kReceived : EventKind::kConfirmed),
                        static_cast<std::uint32_t>(event.kind));
    }
}

void LateInterruptKeepsOwnFrames(const PortUnderTest& port, Check& check) noexcept
{
    if ((port.parts.can == nullptr) || (port.bench.hold_interrupt == nullptr))
    {
        check.NotShown("the port has no CAN ports, or the bench cannot make interrupts late");
        return;
    }
    Settle(port);
    const std::uint32_t cycles = CyclesForFrames(port, 2U);
    port.bench.hold_interrupt(port.bench.bench, Hold::kHeld);
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[0], 1U)));
    PassCycles(port, cycles);
    const bool is_sent = Receive(port, NumberedFrame(port.numbers.received[0], 2U));
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[1], 3U)));
    PassCycles(port, cycles);
    port.bench.hold_interrupt(port.bench.bench, Hold::kReleased);
    PassCycles(port, 1U);
    if (!is_sent)
    {
        check.NotShown("the other node cannot send this");
        return;
    }
    bool is_told = false;
    bool in_order = true;
    for (std::uint32_t number = 1U; number <= 3U; ++number)
    {
        const PortEvent event = port.bench.next(port.bench.bench);
        const EventKind kind = (number == 2U) ? EventKind::kReceived : EventKind::kConfirmed;
        is_told = is_told || (event.kind == EventKind::kLoss);
        in_order = in_order && (event.kind == kind) && (NumberOf(event.frame.frame) == number);
    }
    check.Equal("own, foreign, own frame in order, or a loss among them", 1U, (is_told || in_order) ? 1U : 0U);
    static_cast<void>(Drain(port));
}

void NothingOldAfterBusOff(const PortUnderTest& port, Check& check) noexcept
{
    const bool can_hold = (port.bench.hold_bus != nullptr) && (port.bench.bus_off != nullptr);
    if ((port.parts.can == nullptr) || !can_hold)
    {
        check.NotShown("the bench cannot bring about a bus-off");
        return;
    }
    Settle(port);
    ForgetSeen(port);
    HoldBus(port, Hold::kHeld);
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[0], 1U)));
    check.EqualCode(kStatus, kAccepted, Transmit(port, NumberedFrame(port.numbers.sent[1], 2U)));
    port.bench.bus_off(port.bench.bench, Hold::kHeld);
    PassCycles(port, 1U);
    check.EqualCode("status of Transmit in bus-off (2 bus-off)", static_cast<std::uint32_t>(TransmitStatus::kBusOff),
                    Transmit(port, NumberedFrame(port.numbers.sent[0], 3U)));
    port.bench.bus_off(port.bench.bench, Hold::kReleased);
    HoldBus(port, Hold::kReleased);
    std::uint32_t status = static_cast<std::uint32_t>(TransmitStatus::kBusOff);
    for (std::uint32_t cycle = 0U; (cycle < kMostCyclesOff) && (status != kAccepted); ++cycle)
    {
        PassCycles(port, 1U);
        status = Transmit(port, NumberedFrame(port.numbers.sent[0], 4U));
    }
    PassCycles(port, CyclesForFrames(port, 6U));
    const std::uint32_t confirmed = CountOf(port, 4U, check);
    if (status != kAccepted)
    {
        check.NotShown("the port does not come back on the bus by itself");
        return;
    }
    check.Equal("confirmations of the frame behind it", 1U, confirmed);
}

void AbsentControllerIsRefused(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.can == nullptr)
    {
        check.NotShown(kNoCan);
        return;
    }
    if (port.numbers.controllers > 1U)
    {
        check.NotShown("the port has both controllers");
        return;
    }
    Settle(port);
    const FrameName absent{port.numbers.sent[0].identifier, CanPortId::kSecond};
    check.EqualCode("status of Transmit (3 refused)", static_cast<std::uint32_t>(TransmitStatus::kRefused),
                    Transmit(port, NumberedFrame(absent, 1U)));
    PassCycles(port, CyclesForFrames(port, 2U));
    check.Equal("confirmations", 0U, Drain(port).confirmed);
}

void CallsComeBack(const PortUnderTest& port, Check& check) noexcept
{
    const bool can_hold = (port.bench.hold_bus != nullptr) && (port.bench.work != nullptr);
    if ((port.parts.can == nullptr) || !can_hold)
    {
        check.NotShown("the bench cannot hold the bus, or does not count work");
        return;
    }
    Settle(port);
    HoldBus(port, Hold::kHeld);
    const Span expected{0U, port.numbers.most_work};
    for (std::uint32_t number = 0U; number < (port.numbers.transmit_room + 4U); ++number)
    {
        const std::uint32_t before = port.bench.work(port.bench.bench);
        static_cast<void>(Transmit(port, NumberedFrame(port.numbers.sent[number % 2U], number)));
        check.Within("work of Transmit while nothing leaves", expected, port.bench.work(port.bench.bench) - before);
    }
    const std::uint32_t before = port.bench.work(port.bench.bench);
    static_cast<void>(port.bench.next(port.bench.bench));
    check.Within("work of next while nothing comes", expected, port.bench.work(port.bench.bench) - before);
    HoldBus(port, Hold::kReleased);
    PassCycles(port, CyclesForFrames(port, port.numbers.transmit_room + 4U));
}

} // namespace counterpoint::hal::contract
