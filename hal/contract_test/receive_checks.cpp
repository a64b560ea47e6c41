// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kFrames = 6U;
constexpr std::uint32_t kMoreThanRoom = 8U;
constexpr const char* kPeerCannot = "the other node cannot send this";
constexpr const char* kEvents = "events of reception";
constexpr const char* kNoLateInterrupt = "the bench cannot make interrupts late";

[[nodiscard]] PortEvent Next(const PortUnderTest& port) noexcept
{
    return port.bench.next(port.bench.bench);
}

/// The event must be this frame, received.
void ExpectReceived(Check& check, const PortEvent& event, const CanFrame& frame) noexcept
{
    check.EqualCode("kind of event (0x3C received)", static_cast<std::uint32_t>(EventKind::kReceived),
                    static_cast<std::uint32_t>(event.kind));
    check.EqualCode("identifier", frame.identifier, event.frame.frame.identifier);
    check.EqualCode("kind of frame", static_cast<std::uint32_t>(frame.kind),
                    static_cast<std::uint32_t>(event.frame.frame.kind));
    check.Equal("controller", static_cast<std::uint32_t>(frame.port),
                static_cast<std::uint32_t>(event.frame.frame.port));
    check.Equal("length", frame.length_bytes, event.frame.frame.length_bytes);
    for (std::uint32_t byte = 0U; byte < frame.length_bytes; ++byte)
    {
        check.EqualCode("data byte", frame.data[byte], event.frame.frame.data[byte]);
    }
}

/// More frames than the port has room for; how many, 0 if the other node cannot send them.
[[nodiscard]] std::uint32_t SendMoreThanRoom(const PortUnderTest& port) noexcept
{
    const std::uint32_t sent = port.numbers.receive_room + kMoreThanRoom;
    bool is_sent = true;
    for (std::uint32_t number = 0U; (number < sent) && is_sent; ++number)
    {
        is_sent = Receive(port, NumberedFrame(port.numbers.received[number % 2U], number));
    }
    return is_sent ? sent : 0U;
}

/// Of these frames some were lost: that must have been told, and be over with the next frame.
void ExpectLossTold(const PortUnderTest& port, Check& check, const std::uint32_t sent) noexcept
{
    const Drained drained = Drain(port);
    if (sent == 0U)
    {
        check.NotShown(kPeerCannot);
        return;
    }
    if (drained.received == sent)
    {
        check.NotShown("nothing was lost: the port has more room than receive_room says");
        return;
    }
    check.Within("losses told", Span{1U, sent}, drained.losses);
    check.Equal("events of no kind", 0U, drained.others);
    if (Receive(port, NumberedFrame(port.numbers.received[0], 1U)))
    {
        ExpectReceived(check, Next(port), NumberedFrame(port.numbers.received[0], 1U));
    }
}

} // namespace

void AllGuaranteesAreGiven(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.can == nullptr)
    {
        check.NotShown("the port has no CAN ports");
        return;
    }
    check.EqualCode("first missing one (1 order, 2 stamps, 3 confirmations)",
                    static_cast<std::uint32_t>(MissingGuarantee::kNone),
                    static_cast<std::uint32_t>(CheckGuarantees(port.parts.can->Guarantees())));
}

void ContentIsAsSent(const PortUnderTest& port, Check& check) noexcept
{
    Settle(port);
    for (std::uint8_t length = 0U; length <= kMaxPayloadBytes; ++length)
    {
        CanFrame frame{port.numbers.received[length % 2U].identifier,
                       FrameKind::kData,
                       port.numbers.received[length % 2U].port,
                       length,
                       {0x80U, 0x7FU, 0x01U, 0xFEU, 0x40U, 0xBFU, 0x02U, 0xFDU}};
        if (!Receive(port, frame))
        {
            check.NotShown(kPeerCannot);
            return;
        }
        ExpectReceived(check, Next(port), frame);
        check.Equal(kEvents, 0U, Drain(port).received);
    }
}

void OrderIsThatOfTheBus(const PortUnderTest& port, Check& check) noexcept
{
    Settle(port);
    // The higher identifier first: neither the number of a mailbox nor the priority of a frame is its place.
    for (std::uint32_t number = 0U; number < kFrames; ++number)
    {
        if (!Receive(port, NumberedFrame(port.numbers.received[(number + 1U) % 2U], number)))
        {
            check.NotShown(kPeerCannot);
            return;
        }
    }
    for (std::uint32_t number = 0U; number < kFrames; ++number)
    {
        const PortEvent event = Next(port);
        check.EqualCode("kind of event (0x3C received)", static_cast<std::uint32_t>(EventKind::kReceived),
                        static_cast<std::uint32_t>(event.kind));
        check.Equal("number of the frame", number, NumberOf(event.frame.frame));
        check.EqualCode("identifier", port.numbers.received[(number + 1U) % 2U].identifier,
                        event.frame.frame.identifier);
    }
    check.Equal(kEvents, 0U, Drain(port).received);
}

void LateInterruptKeepsOrder(const PortUnderTest& port, Check& check) noexcept
{
    if (port.bench.hold_interrupt == nullptr)
    {
        check.NotShown(kNoLateInterrupt);
        return;
    }
    Settle(port);
    port.bench.hold_interrupt(port.bench.bench, Hold::kHeld);
    const bool is_sent = Receive(port, NumberedFrame(port.numbers.received[1], 1U)) &&
                         Receive(port, NumberedFrame(port.numbers.received[0], 2U));
    port.bench.hold_interrupt(port.bench.bench, Hold::kReleased);
    PassCycles(port, 1U);
    if (!is_sent)
    {
        check.NotShown(kPeerCannot);
        return;
    }
    const PortEvent first = Next(port);
    const PortEvent second = Next(port);
    const bool is_told = (first.kind == EventKind::kLoss) || (second.kind == EventKind::kLoss);
    const bool in_order = (NumberOf(first.frame.frame) == 1U) && (NumberOf(second.frame.frame) == 2U);
    check.Equal("frames in order, or a loss before them", 1U, (is_told || in_order) ? 1U : 0U);
    static_cast<void>(Drain(port));
}

void StampsAreOfBothCounters(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.clocks == nullptr)
    {
        check.NotShown("the port has no clocks");
        return;
    }
    Settle(port);
    const InstantPair before = port.parts.clocks->Now();
    const std::uint32_t latest = port.numbers.frame_us + port.numbers.tolerance_us;
    const std::uint32_t apart = before.a.us - before.b.us;
    if ((apart <= latest) || ((0U - apart) <= latest))
    {
        check.NotShown("the counters are too close to each other to be told apart");
        return;
    }
    if (!Receive(port, NumberedFrame(port.numbers.received[0], 1U)))
    {
        check.NotShown(kPeerCannot);
        return;
    }
    // Long after the frame: a stamp that is taken with the frame out of the queue is too late.
    PassCycles(port, CyclesForFrames(port, 3U) + 3U);
    const PortEvent event = Next(port);
    check.EqualCode("kind of event (0x3C received)", static_cast<std::uint32_t>(EventKind::kReceived),
                    static_cast<std::uint32_t>(event.kind));
    check.Within("us of counter A from the request to the stamp", Span{0U, latest},
                 event.frame.stamp.a.us - before.a.us);
    check.Within("us of counter B from the request to the stamp", Span{0U, latest},
                 event.frame.stamp.b.us - before.b.us);
}

void StampsAreAsFarApartAsFrames(const PortUnderTest& port, Check& check) noexcept
{
    Settle(port);
    for (std::uint32_t number = 0U; number < kFrames; ++number)
    {
        if (!Receive(port, NumberedFrame(port.numbers.received[number % 2U], number)))
        {
            check.NotShown(kPeerCannot);
            return;
        }
    }
    const std::uint32_t apart_us = CyclesForFrames(port, 1U) * port.numbers.cycle_us;
    const Span expected{apart_us - port.numbers.tolerance_us, apart_us + port.numbers.tolerance_us};
    PortEvent before = Next(port);
    check.EqualCode("kind of event (0x3C received)", static_cast<std::uint32_t>(EventKind::kReceived),
                    static_cast<std::uint32_t>(before.kind));
    for (std::uint32_t number = 1U; number < kFrames; ++number)
    {
        const PortEvent event = Next(port);
        check.Within("us of counter A between two frames", expected, event.frame.stamp.a.us - before.frame.stamp.a.us);
        check.Within("us of counter B between two frames", expected, event.frame.stamp.b.us - before.frame.stamp.b.us);
        before = event;
    }
}

void ForeignFramesStayAway(const PortUnderTest& port, Check& check) noexcept
{
    Settle(port);
    const FrameName foreign{port.numbers.foreign, port.numbers.received[0].port};
    if (!Receive(port, NumberedFrame(foreign, 1U)) || !Receive(port, NumberedFrame(port.numbers.received[0], 2U)))
    {
        check.NotShown(kPeerCannot);
        return;
    }
    ExpectReceived(check, Next(port), NumberedFrame(port.numbers.received[0], 2U));
    check.Equal("events behind it", 0U, Drain(port).received);
}

void OtherKindsAreNoData(const PortUnderTest& port, Check& check) noexcept
{
    Settle(port);
    bool is_sent = false;
    // Of 29 bits the port's identifier is once the last 11, and once the first 11, where a filter for 11 bits looks.
    constexpr std::uint32_t kFirstBits = 18U;
    const std::uint32_t identifier = port.numbers.received[0].identifier;
    const FrameName last{identifier, port.numbers.received[0].port};
    const FrameName first{identifier << kFirstBits, last.port};
    CanFrame frames[]{NumberedFrame(last, 1U), NumberedFrame(last, 1U), NumberedFrame(first, 1U)}; // MISRA D-001
    frames[0].kind = FrameKind::kRemote;
    frames[1].kind = FrameKind::kExtended;
    frames[2].kind = FrameKind::kExtended;
    for (const CanFrame& frame : frames)
    {
        is_sent = Receive(port, frame) || is_sent;
    }
    if (!is_sent)
    {
        check.NotShown(kPeerCannot);
        return;
    }
    PortEvent event = Next(port);
    for (std::uint32_t taken = 0U; (taken < kFrames) && (event.kind != EventKind::kNothing); ++taken)
    {
        const bool is_data = event.frame.frame.kind == FrameKind::kData;
        check.Equal("data frames made of remote or 29-bit ones", 0U, is_data ? 1U : 0U);
        event = Next(port);
    }
}

void LossIsTold(const PortUnderTest& port, Check& check) noexcept
{
    Settle(port);
    ExpectLossTold(port, check, SendMoreThanRoom(port));
}

void LossInControllerIsTold(const PortUnderTest& port, Check& check) noexcept
{
    if (port.bench.hold_interrupt == nullptr)
    {
        check.NotShown(kNoLateInterrupt);
        return;
    }
    Settle(port);
    // Nobody empties the controller: what its FIFO or mailboxes do not hold is lost before the port sees it.
    port.bench.hold_interrupt(port.bench.bench, Hold::kHeld);
    const std::uint32_t sent = SendMoreThanRoom(port);
    port.bench.hold_interrupt(port.bench.bench, Hold::kReleased);
    PassCycles(port, 1U);
    ExpectLossTold(port, check, sent);
}

} // namespace counterpoint::hal::contract
