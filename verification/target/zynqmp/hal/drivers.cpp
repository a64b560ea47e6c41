// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The drivers of hal/zynqmp on the emulator's own controllers, both on one emulated bus: what crosses it, and what
// becomes of a fault. A fault is made by a write behind the driver's back or by a look that does not come; no register
// is a model of ours.
#include "hal/zynqmp/board.hpp"
#include "hal/zynqmp/chip/cycle_counter.hpp"
#include "hal/zynqmp/output/safety_pins.hpp"
#include "hal/zynqmp/start/memory_map.hpp"
#include "hal/zynqmp/time/system_watchdog.hpp"
#include "verification/target/target.hpp"
#include "verification/target/zynqmp/hal/board_faults.hpp"
#include "verification/target/zynqmp/hal/checks.hpp"
#include "verification/target/zynqmp/hal/emulated_setup.hpp"

extern "C" std::uint32_t TargetMain() noexcept;

namespace counterpoint::target
{
namespace
{

using namespace zynqmp;
using hal::TransmitStatus;

constexpr std::uint32_t kMostMicroseconds = 100000U;

constexpr std::uint16_t kFirstReceives[]{0x000U, 0x001U, 0x103U, 0x104U, 0x111U, 0x112U};
constexpr std::uint16_t kSecondReceives[]{0x121U, 0x122U, 0x002U};

Counters counters{};
CanPorts ports{counters};

[[nodiscard]] CanPortsSetup Setup() noexcept
{
    return CanPortsSetup{EmulatedCan(canps::kCan0, IdentifierList{&kFirstReceives[0], 6U}),
                         EmulatedCan(canps::kCan1, IdentifierList{&kSecondReceives[0], 3U}), BusLayout::kOneBus};
}

/// Frames of another node: words for the transmit FIFO of controller 1, past every driver.
void SendRaw(const RegisterBase base, const std::uint32_t identifier_word, const std::uint32_t length,
             const std::uint32_t first) noexcept
{
    Write(At(base, canps::kTransmit), identifier_word);
    Write(At(base, canps::kTransmit + canps::kLengthWord), length << canps::kLengthShift);
    Write(At(base, canps::kTransmit + canps::kDataWord), first);
    Write(At(base, canps::kTransmit + canps::kLastDataWord), 0U);
    Write(At(base, canps::kClearEvents), canps::kSent);
}

void SendFromSecond(const std::uint32_t identifier, const std::uint32_t first) noexcept
{
    SendRaw(canps::kCan1, identifier << canps::kIdentifierShift, 4U, first);
}

[[nodiscard]] CanFrame FrameOf(const std::uint32_t identifier, const CanPortId port, const std::uint8_t length,
                               const std::uint8_t first) noexcept
{
    CanFrame frame{identifier, FrameKind::kData, port, length, {}};
    for (std::uint8_t byte = 0U; byte < length; ++byte)
    {
        frame.data[byte] = static_cast<std::uint8_t>(first + byte);
    }
    return frame;
}

void Wait(const std::uint32_t microseconds) noexcept
{
    const std::uint32_t begun = counters.Now().a.us;
    for (std::uint32_t look = 0U; (look < kMostMicroseconds) && ((counters.Now().a.us - begun) < microseconds); ++look)
    {
    }
}

/// Looks until what came before this call is told; the first entry.
[[nodiscard]] QueuedFrame Next() noexcept
{
    static_cast<void>(ports.Look());
    Wait(20U);
    static_cast<void>(ports.Look());
    return ports.Next();
}

[[nodiscard]] bool IsNothing(const QueuedFrame& queued) noexcept
{
    return queued.kind == QueuedKind::kNothing;
}

[[nodiscard]] bool IsFrame(const QueuedFrame& queued, const QueuedKind kind, const CanPortId port,
                           const std::uint32_t identifier) noexcept
{
    const CanFrame& frame = queued.frame.frame;
    return (queued.kind == kind) && (frame.port == port) && (frame.identifier == identifier);
}

[[nodiscard]] bool IsReceived(const QueuedFrame& queued, const std::uint32_t identifier) noexcept
{
    return IsFrame(queued, QueuedKind::kReceived, CanPortId::kFirst, identifier);
}

void Restart() noexcept
{
    const bool is_up = ports.Start(Setup()) == CanFault::kNone;
    if (!is_up)
    {
        Check(false, "the controllers start again");
    }
}

void TestCounters() noexcept
{
    CheckEqual(static_cast<std::uint32_t>(counters.Start(kEmulatedCounters)),
               static_cast<std::uint32_t>(Outcome::kDone), "counters: both start");
    const InstantPair begun = counters.Now();
    bool are_together = true;
    for (std::uint32_t step = 0U; step < 100U; ++step)
    {
        Wait(1000U);
        are_together = are_together && (counters.Examine() == Outcome::kDone);
    }
    const InstantPair now = counters.Now();
    Check(are_together, "counters: together over 100 ms, in which the timer is set back");
    const std::uint32_t a = now.a.us - begun.a.us;
    const std::uint32_t b = now.b.us - begun.b.us;
    Check((a >= 100000U) && (a < 101000U), "counters: the timer has passed 100 ms");
    Check(((a - b) + 20U) <= 40U, "counters: the cycles have passed the same time");
    CountersSetup wrong = kEmulatedCounters;
    wrong.timer_rate.hertz = 1101405U;
    wrong.compare_us = 1000U;
    Check(counters.Start(wrong) == Outcome::kDone, "counters: 6 percent are not seen in the first 20 us");
    Wait(900U);
    Check(counters.Examine() == Outcome::kFailed, "counters: 6 percent are seen within 1 ms");
    Check(counters.Examine() == Outcome::kFailed, "counters: the failure stays");
    wrong.timer_rate.hertz = 2078125U;
    Check(counters.Start(wrong) == Outcome::kFailed, "counters: twice the rate is refused at the start");
    wrong.timer_rate = CounterRate{1000000U, 16U};
    Check(counters.Start(wrong) == Outcome::kFailed, "counters: a rate of 1 MHz is refused");
}

void TestScale() noexcept
{
    ScaledCounter counter{};
    counter.Start(CounterRate{2078125U, 16U}, 0xFFF0U);
    CheckEqual(counter.Take(0xFFFFU).us, 7U, "scale: 15 counts of 2.078125 MHz are 7.2 us");
    CheckEqual(counter.Take(0x2029U).us, 3969U, "scale: over the end of 16 bits: 8249 counts are 3969.4 us");
    counter.Start(CounterRate{25000000U, 32U}, 0xFFFFFF00U);
    CheckEqual(counter.Take(0x00000100U).us, 20U, "scale: over the end of 32 bits: 512 counts of 25 MHz are 20.5 us");
    CheckEqual(counter.Take(0xFFFFFF00U).us, 171798691U, "scale: almost all of 32 bits at once");
    counter.Start(CounterRate{500000000U, 32U}, 7U);
    CheckEqual(counter.Take(507U).us, 0U, "scale: 500 counts of 500 MHz are not quite 1 us");
    CheckEqual(counter.Take(508U).us, 1U, "scale: 501 are");
}

void TestCounterFaults() noexcept
{
    Check(counters.Start(kEmulatedCounters) == Outcome::kDone, "counters: start again");
    Write(At(ttc::kTtc0, ttc::kCounterControl), ttc::kWaveformOff | ttc::kStopped);
    Check(counters.Examine() == Outcome::kFailed, "counters: a stopped timer is told");
    Check(counters.Start(kEmulatedCounters) == Outcome::kDone, "counters: start after a stop");
    Write(At(ttc::kTtc0, ttc::kClockControl), 0U);
    Check(counters.Examine() == Outcome::kFailed, "counters: another prescaler is told");
    Check(counters.Start(kEmulatedCounters) == Outcome::kDone, "counters: start after another prescaler");
    SetUpCycles(CycleSetup{0U, kCycleCounterOn, 0U});
    Check(counters.Examine() == Outcome::kFailed, "counters: a stopped cycle counter is told");
    Check(counters.Start(kEmulatedCounters) == Outcome::kDone, "counters: start after a stopped cycle counter");
}

void TestFilters() noexcept
{
    const std::uint16_t four[]{0x000U, 0x001U, 0x103U, 0x104U};
    const FilterPlan exact = PlanFilters(IdentifierList{&four[0], 4U});
    Check((exact.count == 4U) && (exact.filters[3U].identifier == 0x104U) && (exact.filters[3U].mask == 0x7FFU),
          "filters: four identifiers have a filter each");
    const FilterPlan joined = PlanFilters(IdentifierList{&kFirstReceives[0], 6U});
    bool all_pass = joined.count == 4U;
    std::uint32_t passing = 0U;
    for (std::uint32_t identifier = 0U; identifier <= 0x7FFU; ++identifier)
    {
        bool passes = false;
        for (const AcceptanceFilter& filter : joined.filters)
        {
            passes = passes || ((identifier & filter.mask) == filter.identifier);
        }
        passing += passes ? 1U : 0U;
        for (const std::uint16_t wanted : kFirstReceives)
        {
            all_pass = all_pass && ((wanted != identifier) || passes);
        }
    }
    Check(all_pass, "filters: six identifiers pass four filters");
    CheckEqual(passing, 8U, "filters: two identifiers besides pass");
    const std::uint16_t wrong[]{0x800U};
    CheckEqual(PlanFilters(IdentifierList{&wrong[0], 1U}).count, 0U, "filters: 800h is refused");
}

void TestStart() noexcept
{
    Check(ports.Guarantees().stamps == hal::Guarantee::kAbsent, "CAN: nothing is guaranteed before the start");
    Check(ports.Transmit(FrameOf(0x121U, CanPortId::kFirst, 1U, 0U)) == TransmitStatus::kRefused,
          "CAN: nothing is taken before the start");
    CanPortsSetup setup = Setup();
    setup.first.received.count = 0U;
    Check(ports.Start(setup) == CanFault::kSetup, "CAN: a device that receives nothing is refused");
    setup = Setup();
    setup.first.latest_look_us = 2700U;
    Check(ports.Start(setup) == CanFault::kSetup, "CAN: looks that are too rare for the time stamps are refused");
    setup.first.latest_look_us = 2697U;
    Check(ports.Start(setup) == CanFault::kNone, "CAN: looks just often enough are not");
    setup.layout = BusLayout::kInvalid;
    Check(ports.Start(setup) == CanFault::kSetup, "CAN: a layout that is none is refused");
    Check(ports.Start(Setup()) == CanFault::kNone, "CAN: both controllers start");
    Check(ports.Guarantees().stamps == hal::Guarantee::kGiven, "CAN: order, stamps and confirmations are guaranteed");
    Check(IsNothing(Next()), "CAN: nothing has happened yet");
    Check(ports.OnCycle() == CanFault::kNone, "CAN: the set-up reads as it was written");
}

void TestCrossing() noexcept
{
    Check(ports.Transmit(FrameOf(0x103U, CanPortId::kSecond, 8U, 0x11U)) == TransmitStatus::kAccepted,
          "CAN: a frame is taken");
    const QueuedFrame received = Next();
    const QueuedFrame confirmed = ports.Next();
    Check(IsReceived(received, 0x103U), "CAN: it crosses the bus and comes first");
    Check(IsFrame(confirmed, QueuedKind::kConfirmed, CanPortId::kSecond, 0x103U), "CAN: then it is confirmed");
    bool are_bytes = (received.frame.frame.length_bytes == 8U) && (confirmed.frame.frame.length_bytes == 8U);
    for (std::uint8_t byte = 0U; byte < 8U; ++byte)
    {
        are_bytes = are_bytes && (received.frame.frame.data[byte] == (0x11U + byte));
        are_bytes = are_bytes && (confirmed.frame.frame.data[byte] == (0x11U + byte));
    }
    Check(are_bytes, "CAN: with its eight bytes in their order");
    Check(IsNothing(ports.Next()), "CAN: and once");
    Check(ports.Transmit(FrameOf(0x122U, CanPortId::kFirst, 3U, 0x21U)) == TransmitStatus::kAccepted,
          "CAN: three bytes the other way");
    const QueuedFrame three = Next();
    const CanFrame& frame = three.frame.frame;
    Check(IsFrame(three, QueuedKind::kReceived, CanPortId::kSecond, 0x122U) && (frame.length_bytes == 3U) &&
              (frame.data[2U] == 0x23U) && (frame.data[3U] == 0U),
          "CAN: three bytes and none behind them");
    Check(IsFrame(ports.Next(), QueuedKind::kConfirmed, CanPortId::kFirst, 0x122U), "CAN: confirmed by the first");
    Check(ports.Transmit(FrameOf(0x001U, CanPortId::kSecond, 0U, 0U)) == TransmitStatus::kAccepted,
          "CAN: no byte at all, by the buffer of high priority");
    const QueuedFrame none = Next();
    Check(IsReceived(none, 0x001U) && (none.frame.frame.length_bytes == 0U), "CAN: it crosses without a byte");
    Check(IsFrame(ports.Next(), QueuedKind::kConfirmed, CanPortId::kSecond, 0x001U), "CAN: and is confirmed");
}

void TestForeign() noexcept
{
    SendFromSecond(0x105U, 1U);
    SendFromSecond(0x7FFU, 2U);
    Check(IsNothing(Next()), "CAN: a frame that no filter lets pass is not told");
    CheckEqual(ports.Controller(CanPortId::kFirst).Foreign(), 0U, "CAN: nor seen");
    SendFromSecond(0x113U, 3U);
    Check(IsNothing(Next()), "CAN: a foreign frame that a joined filter lets pass is not told");
    CheckEqual(ports.Controller(CanPortId::kFirst).Foreign(), 1U, "CAN: but counted");
    constexpr std::uint32_t kRemote = 1U << 20U;
    constexpr std::uint32_t kExtended = 1U << 19U;
    SendRaw(canps::kCan1, (0x103U << canps::kIdentifierShift) | kRemote, 4U, 4U);
    Check(IsNothing(Next()), "CAN: a remote frame with our identifier is not told");
    SendRaw(canps::kCan1, (0x103U << canps::kIdentifierShift) | kRemote | kExtended | 2U, 4U, 5U);
    SendRaw(canps::kCan1, (0x103U << canps::kIdentifierShift) | kExtended, 4U, 5U);
    Check(IsNothing(Next()), "CAN: an extended frame that begins with our identifier is not told");
    SendFromSecond(0x103U, 6U);
    Check(IsReceived(Next(), 0x103U), "CAN: the near miss is");
    // The filters off behind the driver's back: what the software alone lets pass.
    Write(At(canps::kCan0, canps::kFilters), 0U);
    SendFromSecond(0x105U, 7U);
    SendRaw(canps::kCan1, (0x103U << canps::kIdentifierShift) | kRemote, 4U, 8U);
    SendRaw(canps::kCan1, (0x103U << canps::kIdentifierShift) | kExtended, 4U, 9U);
    Check(IsNothing(Next()), "CAN: with the filters off no foreign frame is told either");
    CheckEqual(ports.Controller(CanPortId::kFirst).Foreign(), 4U, "CAN: all of them are counted");
    Check(ports.OnCycle() == CanFault::kRegisters, "CAN: filters that are off are a fault");
    Restart();
}

void TestOrder() noexcept
{
    std::uint32_t sent_at[60]{};
    for (std::uint32_t number = 0U; number < 60U; ++number)
    {
        sent_at[number] = counters.Now().a.us;
        SendFromSecond(0x111U, number);
        Wait(15U);
    }
    bool is_order = true;
    bool are_stamps = true;
    std::uint32_t apart = 0U;
    QueuedFrame queued = Next();
    for (std::uint32_t number = 0U; number < 60U; ++number)
    {
        is_order = is_order && IsReceived(queued, 0x111U) && (queued.frame.frame.data[3U] == number);
        const std::uint32_t late = (queued.frame.stamp.a.us - sent_at[number]) + 4U;
        are_stamps = are_stamps && (late <= 12U);
        const std::uint32_t differ = (queued.frame.stamp.b.us - queued.frame.stamp.a.us) + 100U;
        apart = (differ > apart) ? differ : apart;
        queued = ports.Next();
    }
    Check(is_order, "CAN: 60 frames that wait for a look come in the order of the bus");
    Check(are_stamps, "CAN: each with the moment at which it came, up to 1 ms before the look");
    Check(apart <= 120U, "CAN: the stamp of the second counter is the same moment");
    Check(IsNothing(queued), "CAN: and no more");
}

void TestOrderOfTwo() noexcept
{
    Restart();
    for (std::uint32_t number = 0U; number < 8U; ++number)
    {
        SendRaw(canps::kCan1, 0x112U << canps::kIdentifierShift, 4U, number);
        Wait(100U);
        SendRaw(canps::kCan0, 0x121U << canps::kIdentifierShift, 4U, number);
        Wait(50U);
    }
    bool is_order = true;
    QueuedFrame queued = Next();
    for (std::uint32_t number = 0U; number < 8U; ++number)
    {
        is_order = is_order && IsReceived(queued, 0x112U) && (queued.frame.frame.data[3U] == number);
        queued = ports.Next();
        is_order = is_order && IsFrame(queued, QueuedKind::kReceived, CanPortId::kSecond, 0x121U) &&
                   (queued.frame.frame.data[3U] == number);
        queued = ports.Next();
    }
    Check(is_order, "CAN: frames of both controllers come in the order of the one bus");
    Check(IsNothing(queued), "CAN: without a loss");
}

void TestOverflow() noexcept
{
    Restart();
    for (std::uint32_t number = 0U; number < 64U; ++number)
    {
        SendFromSecond(0x111U, number);
    }
    bool are_there = true;
    QueuedFrame queued = Next();
    for (std::uint32_t number = 0U; number < 64U; ++number)
    {
        are_there = are_there && IsReceived(queued, 0x111U) && (queued.frame.frame.data[3U] == number);
        queued = ports.Next();
    }
    Check(are_there && IsNothing(queued), "CAN: 64 frames fit, without a loss");
    for (std::uint32_t number = 0U; number < 66U; ++number)
    {
        SendFromSecond(0x111U, number);
    }
    Check(Next().kind == QueuedKind::kLoss, "CAN: of 66 frames a loss is told first");
    are_there = true;
    for (std::uint32_t number = 0U; number < 64U; ++number)
    {
        queued = ports.Next();
        are_there = are_there && IsReceived(queued, 0x111U) && (queued.frame.frame.data[3U] == number);
    }
    Check(are_there && IsNothing(ports.Next()), "CAN: then the first 64, and once");
    SendFromSecond(0x104U, 5U);
    Check(IsReceived(Next(), 0x104U), "CAN: the next frame comes without a loss");
}

void TestLateLook() noexcept
{
    Restart();
    static_cast<void>(ports.Look());
    Wait(2000U);
    Check(IsNothing(Next()), "CAN: a late look at nothing is no loss");
    Wait(2000U);
    SendFromSecond(0x103U, 1U);
    Check(Next().kind == QueuedKind::kLoss, "CAN: a late look at a frame: its moment is not known, a loss is told");
    Check(IsReceived(ports.Next(), 0x103U), "CAN: the frame follows");
    Check(ports.Transmit(FrameOf(0x121U, CanPortId::kFirst, 1U, 0U)) == TransmitStatus::kAccepted,
          "CAN: a frame is sent");
    Wait(2000U);
    Check(Next().kind == QueuedKind::kLoss, "CAN: a late look at a confirmation is a loss, too");
    Restart();
    SendFromSecond(0x103U, 2U);
    Wait(1300U);
    const QueuedFrame queued = Next();
    Check(IsReceived(queued, 0x103U), "CAN: a look just in time is none");
    Restart();
    // The controller's time stamp is set back behind the driver's back: the frame seems to be older than the last look.
    Wait(200U);
    static_cast<void>(ports.Look());
    Write(At(canps::kCan0, canps::kTimeStamp), canps::kClearTimeStamp);
    SendFromSecond(0x103U, 3U);
    Check(Next().kind == QueuedKind::kLoss, "CAN: a time stamp that both counters contradict is a loss");
    Check(IsReceived(ports.Next(), 0x103U), "CAN: the frame follows with the moment of the look");
}

void TestConfirmations() noexcept
{
    Restart();
    const std::uint32_t identifiers[]{0x121U, 0x122U, 0x121U};
    bool are_taken = true;
    for (std::uint32_t number = 0U; number < 3U; ++number)
    {
        are_taken =
            are_taken && (ports.Transmit(FrameOf(identifiers[number], CanPortId::kFirst, 1U,
                                                 static_cast<std::uint8_t>(number))) == TransmitStatus::kAccepted);
    }
    are_taken = are_taken && (ports.Transmit(FrameOf(0x002U, CanPortId::kFirst, 1U, 9U)) == TransmitStatus::kAccepted);
    Check(are_taken, "CAN: three frames and an urgent one are taken at once");
    const std::uint8_t order[]{0U, 9U, 1U, 2U};
    bool is_bus_order = true;
    bool is_confirmed = true;
    for (const std::uint8_t expected : order)
    {
        const QueuedFrame received = Next();
        is_bus_order =
            is_bus_order && (received.kind == QueuedKind::kReceived) && (received.frame.frame.data[0U] == expected);
        const QueuedFrame confirmed = ports.Next();
        is_confirmed =
            is_confirmed && (confirmed.kind == QueuedKind::kConfirmed) && (confirmed.frame.frame.data[0U] == expected);
        Wait(50U);
    }
    Check(is_bus_order, "CAN: the urgent frame goes before those that wait, behind the one under way");
    Check(is_confirmed, "CAN: each is confirmed in the order of the bus");
    Check(IsNothing(Next()), "CAN: and each once");
    Check(ports.Transmit(FrameOf(0x800U, CanPortId::kFirst, 1U, 0U)) == TransmitStatus::kRefused,
          "CAN: identifier 800h is refused");
    Check(ports.Transmit(FrameOf(0x121U, CanPortId::kInvalid, 1U, 0U)) == TransmitStatus::kRefused,
          "CAN: a third controller is refused");
}

void TestLostConfirmation() noexcept
{
    Restart();
    Check(ports.Transmit(FrameOf(0x121U, CanPortId::kFirst, 1U, 1U)) == TransmitStatus::kAccepted,
          "CAN: one more frame");
    Write(At(canps::kCan0, canps::kClearEvents), canps::kSent);
    Check(IsFrame(Next(), QueuedKind::kReceived, CanPortId::kSecond, 0x121U), "CAN: it was on the bus");
    Check(IsNothing(ports.Next()), "CAN: its confirmation is lost, and none is invented");
    std::uint32_t taken = 0U;
    TransmitStatus status = TransmitStatus::kAccepted;
    for (std::uint32_t number = 0U; (number < 40U) && (status == TransmitStatus::kAccepted); ++number)
    {
        status = ports.Transmit(FrameOf(0x122U, CanPortId::kFirst, 1U, 2U));
        taken += (status == TransmitStatus::kAccepted) ? 1U : 0U;
    }
    CheckEqual(taken, 32U, "CAN: 32 frames wait behind it");
    Check(status == TransmitStatus::kQueueFull, "CAN: then there is no room");
    Check(IsNothing(Next()), "CAN: none of them is sent");
    Check(ports.OnCycle() == CanFault::kNone, "CAN: which is no fault of the controller: the kernel's time runs out");
    Restart();
    SendRaw(canps::kCan0, 0x121U << canps::kIdentifierShift, 4U, 3U);
    static_cast<void>(Next());
    Check(ports.OnCycle() == CanFault::kNone, "CAN: a frame of which nothing is told is none");
    Write(At(canps::kCan0, canps::kTransmit), 0x121U << canps::kIdentifierShift);
    Write(At(canps::kCan0, canps::kTransmit + canps::kLengthWord), 0U);
    Write(At(canps::kCan0, canps::kTransmit + canps::kDataWord), 0U);
    Write(At(canps::kCan0, canps::kTransmit + canps::kLastDataWord), 0U);
    const QueuedFrame queued = Next();
    Check(queued.kind != QueuedKind::kConfirmed, "CAN: a frame that nobody handed over is not confirmed");
    Check(ports.OnCycle() == CanFault::kConfirmation, "CAN: it is a fault");
    Check(ports.Guarantees().confirmations == hal::Guarantee::kAbsent, "CAN: nothing is guaranteed any more");
    Check(ports.Transmit(FrameOf(0x121U, CanPortId::kFirst, 1U, 1U)) == TransmitStatus::kRefused,
          "CAN: nothing is taken any more");
    SendFromSecond(0x103U, 1U);
    Check(!IsReceived(Next(), 0x103U), "CAN: nothing is received any more");
}

void TestRegisterFaults() noexcept
{
    Restart();
    Write(At(canps::kCan0, canps::kReset), 0U);
    static_cast<void>(ports.Look());
    Check(ports.OnCycle() == CanFault::kRegisters, "CAN: a controller that is off the bus is a fault");
    Restart();
    Write(At(canps::kCan1, canps::kReset), canps::kResetNow);
    static_cast<void>(ports.Look());
    Check(ports.OnCycle() == CanFault::kRegisters, "CAN: a reset of the second one is, too");
    Restart();
    Write(At(canps::kCan0, canps::kReset), 0U);
    Write(At(canps::kCan0, canps::kBitTiming), 0U);
    Write(At(canps::kCan0, canps::kReset), canps::kEnabled);
    Write(At(canps::kCan0, canps::kClearEvents), canps::kSent);
    Check(ports.OnCycle() == CanFault::kRegisters, "CAN: another bit timing is a fault");
    Restart();
    Write(At(canps::kCan0, canps::kFilters), 0xEU);
    Write(At(canps::kCan0, canps::kFilterMask), 0U);
    Write(At(canps::kCan0, canps::kFilters), 0xFU);
    Check(ports.OnCycle() == CanFault::kRegisters, "CAN: another mask of a filter is a fault");
    Restart();
    static_cast<void>(Read(At(canps::kCan0, canps::kReceive)));
    static_cast<void>(ports.Look());
    Check(ports.OnCycle() == CanFault::kUnderflow, "CAN: a reading of the empty FIFO is a fault");
    Restart();
    ports.Stop();
    Check(ports.OnCycle() == CanFault::kSetup, "CAN: after a stop there is none");
    SendFromSecond(0x103U, 1U);
    Check(IsNothing(Next()), "CAN: and nothing is received");
}

/// What the emulator does not have: the drivers must not take nothing for a device.
void TestAbsent() noexcept
{
    static Counters own{};
    static const SafetyPinsSetup pins_setup{0U, {1U}, 1U, 1U, hal::GateLimit{1500U}};
    static SafetyPins pins{own, pins_setup};
    static SystemWatchdog watchdog{own};
    Check(own.Start(kEmulatedCounters) == Outcome::kDone, "absent: the counters start");
    Check(pins.Start() == Outcome::kFailed, "absent: pins that do not follow are refused");
    Check(pins.Open() == 0U, "absent: and open nothing");
    Check(watchdog.Plan(SystemWatchdogSetup{hal::WatchdogWindow{500U, 1600U}, 100000U}) == Outcome::kDone,
          "watchdog: a period within the window is found");
    CheckEqual(watchdog.PeriodUs(), 1310U, "watchdog: of four steps");
    Check(watchdog.Plan(SystemWatchdogSetup{hal::WatchdogWindow{500U, 300U}, 100000U}) == Outcome::kFailed,
          "watchdog: a window that ends before it begins is refused");
    Check(watchdog.Plan(SystemWatchdogSetup{hal::WatchdogWindow{100U, 327U}, 100000U}) == Outcome::kFailed,
          "watchdog: a window shorter than a step is refused");
    Check(watchdog.Plan(SystemWatchdogSetup{hal::WatchdogWindow{100U, 328U}, 100000U}) == Outcome::kDone,
          "watchdog: one as long as a step is not");
    Check(watchdog.Start() == Outcome::kFailed, "absent: a watchdog that does not read as set up is refused");
    static Board board{BoardParts{own, pins, watchdog}};
    const StartReport report = board.Start(BoardSetup{Setup(), kEmulatedCounters, FixedRegions()});
    Check((report.outcome == Outcome::kFailed) && (report.last == StartStep::kPins),
          "board: the start ends at the pins");
    Check(board.Fault() == BoardFault::kStart, "board: which is told");
    Check(board.StartWatchdog() == Outcome::kFailed, "board: the watchdog is not started");
    Check(board.BeginCycle() == BoardFault::kStart, "board: no cycle begins");
    Check(board.Can().Transmit(FrameOf(0x121U, CanPortId::kFirst, 1U, 0U)) == TransmitStatus::kRefused,
          "board: its controllers are off the bus");
}

} // namespace
} // namespace counterpoint::target

std::uint32_t TargetMain() noexcept
{
    using namespace counterpoint::target;
    TestFilters();
    TestScale();
    TestCounters();
    TestCounterFaults();
    TestStart();
    TestCrossing();
    TestForeign();
    TestOrder();
    TestOrderOfTwo();
    TestOverflow();
    TestLateLook();
    TestConfirmations();
    TestLostConfirmation();
    TestRegisterFaults();
    TestAbsent();
    TestBoardFaults(counters, Setup());
    return EndChecks();
}
