// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Frames through message objects (reference manual, chapter DCAN, "Message handling"; facts/tms570 3). Data are moved
// in words of 32 bits whose lowest byte is the first on the bus, which is the same for every byte order of the
// processor.
//
// Start of a controller (chapter DCAN, "Initialization"): into initialisation mode, bit timing, all objects invalid,
// those of the device written and read back, parity on, onto the bus.
#include "hal/tms570/can/dcan.hpp"

namespace counterpoint::tms570
{
namespace
{

using namespace dcan;

constexpr std::uint32_t kBytesEachWord = 4U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kNoObject = 0U;
/// 1 for objects that wait for a confirmation.
constexpr std::uint8_t kFlying = 1U;

[[nodiscard]] std::uint32_t WordOf(const CanFrame& frame, const std::uint32_t first) noexcept
{
    std::uint32_t word = 0U;
    for (std::uint32_t i = 0U; i < kBytesEachWord; ++i)
    {
        const std::uint32_t byte = ((first + i) < frame.length_bytes) ? frame.data[first + i] : 0U;
        word |= byte << (kByteBits * i);
    }
    return word;
}

void SetBytes(CanFrame& frame, const std::uint32_t first, const std::uint32_t word) noexcept
{
    for (std::uint32_t i = 0U; i < kBytesEachWord; ++i)
    {
        const bool is_used = (first + i) < frame.length_bytes;
        const std::uint32_t byte = is_used ? ((word >> (kByteBits * i)) & kByteMask) : 0U;
        frame.data[first + i] = static_cast<std::uint8_t>(byte);
    }
}

[[nodiscard]] std::uint8_t LengthOf(const std::uint32_t control) noexcept
{
    // On the bus 9 to 15 mean 8 bytes, too.
    const std::uint32_t length = control & kMessageLength;
    return static_cast<std::uint8_t>((length > kMaxPayloadBytes) ? kMaxPayloadBytes : length);
}

constexpr DcanEvent kNoEvent{DcanEventKind::kNothing, CanFrame{}};
constexpr DcanEvent kStatusEvent{DcanEventKind::kStatus, CanFrame{}};

/// An interface needs at most 14 cycles of the CAN clock for a transfer; every look takes longer than one cycle.
constexpr Looks kInterfaceLooks{64U};
constexpr Looks kInitLooks{256U};

constexpr std::uint32_t kRunControl = kControlParityOn | kControlErrorInterrupt | kControlLine0;
constexpr std::uint32_t kCheckedControl =
    kControlParityMask | kControlErrorInterrupt | kControlLine0 | kControlAutoBusOn | kControlChange | kControlInit;
constexpr std::uint32_t kExactMatch = kMaskExtended | kMaskDirection | (kIdentifierMask << kIdentifierShift);
constexpr std::uint32_t kMostIdentifier = 0x7FFU;

[[nodiscard]] constexpr std::uint32_t ArbitrationOf(const CanObject& object) noexcept
{
    const std::uint32_t direction = (object.use == ObjectUse::kTransmit) ? kArbitrationTransmit : 0U;
    return kArbitrationValid | direction | (std::uint32_t{object.identifier} << kIdentifierShift);
}

[[nodiscard]] constexpr std::uint32_t ControlOf(const CanObject& object) noexcept
{
    const std::uint32_t interrupt =
        (object.use == ObjectUse::kTransmit) ? kMessageTransmitInterrupt : kMessageReceiveInterrupt;
    return kMessageUseMask | kMessageEndOfBlock | interrupt;
}

} // namespace

void Dcan::Stop(const CanFault why) noexcept
{
    if (setup_.base.address != 0U) // else it was never started, and is off the bus since the reset
    {
        Write(Place(kControl), kControlInit | kControlParityOn);
    }
    if ((Fault() == CanFault::kNone) || (Fault() == CanFault::kInvalid))
    {
        fault_.Store(why);
    }
}

std::uint32_t Dcan::FindTransmit(const std::uint32_t identifier) const noexcept
{
    for (std::uint32_t number = 1U; number <= setup_.object_count; ++number)
    {
        const CanObject& object = setup_.objects[number - 1U]; // MISRA D-002
        if ((object.identifier == identifier) && (object.use == ObjectUse::kTransmit))
        {
            return number;
        }
    }
    return kNoObject;
}

hal::TransmitStatus Dcan::Send(const CanFrame& frame) noexcept
{
    if (Fault() != CanFault::kNone)
    {
        return hal::TransmitStatus::kRefused;
    }
    if (IsBusOff())
    {
        return hal::TransmitStatus::kBusOff;
    }
    const std::uint32_t number = FindTransmit(frame.identifier);
    if (number == kNoObject)
    {
        return hal::TransmitStatus::kRefused;
    }
    const std::uint32_t index = number - 1U;
    if (in_flight_[index].Load() == kFlying)
    {
        return hal::TransmitStatus::kQueueFull;
    }
    const Sent sent{WordOf(frame, 0U), WordOf(frame, kBytesEachWord), frame.length_bytes};
    sent_[index] = sent;
    in_flight_[index].Store(kFlying);
    Write(Place(kInterface1 + kDataA), sent.data_a);
    Write(Place(kInterface1 + kDataB), sent.data_b);
    constexpr std::uint32_t kFixed = kMessageUseMask | kMessageEndOfBlock | kMessageTransmitInterrupt;
    Write(Place(kInterface1 + kMessageControl), kFixed | sent.length);
    constexpr std::uint32_t kPut = kCommandWrite | kCommandControl | kCommandRequest | kCommandDataA | kCommandDataB;
    if (Command(kInterface1, kPut | number) != Outcome::kDone)
    {
        Stop(CanFault::kBusy);
        return hal::TransmitStatus::kRefused;
    }
    return hal::TransmitStatus::kAccepted;
}

PendingCount Dcan::Pending() const noexcept
{
    const std::uint32_t low = Read(Place(kInterruptPending));
    const std::uint32_t high = Read(Place(kInterruptPending + 4U));
    if ((low == 0U) && (high == 0U))
    {
        return PendingCount::kNone;
    }
    const bool is_one_low = (high == 0U) && ((low & (low - 1U)) == 0U);
    const bool is_one_high = (low == 0U) && ((high & (high - 1U)) == 0U);
    return (is_one_low || is_one_high) ? PendingCount::kOne : PendingCount::kMany;
}

bool Dcan::IsAsking() const noexcept
{
    return (Fault() == CanFault::kNone) && ((Read(Place(kInterrupt)) & kInterruptIdMask) != 0U);
}

DcanEvent Dcan::Take() noexcept
{
    if (Fault() != CanFault::kNone)
    {
        return kNoEvent;
    }
    const std::uint32_t source = Read(Place(kInterrupt)) & kInterruptIdMask;
    if (source == 0U)
    {
        return kNoEvent;
    }
    if (source == kInterruptIsStatus)
    {
        static_cast<void>(ExamineStatus());
        return kStatusEvent;
    }
    if (source > setup_.object_count)
    {
        Stop(CanFault::kInterrupts);
        return kStatusEvent;
    }
    return TakeObject(source);
}

std::uint32_t Dcan::ExamineStatus() noexcept
{
    const std::uint32_t status = Read(Place(kErrorStatus));
    if ((status & kStatusParity) != 0U)
    {
        Stop(CanFault::kParity);
    }
    if (((status & kStatusBusOff) != 0U) && (bus_off_.Load() == kOnBus))
    {
        paused_ = 0U;
        bus_off_.Store(kBusOff);
    }
    return status;
}

DcanEvent Dcan::TakeObject(const std::uint32_t number) noexcept
{
    constexpr std::uint32_t kGet =
        kCommandArbitration | kCommandControl | kCommandClearPending | kCommandRequest | kCommandDataA | kCommandDataB;
    if (Command(kInterface2, kGet | number) != Outcome::kDone)
    {
        Stop(CanFault::kBusy);
        return kStatusEvent;
    }
    // A parity error of this object is known once it was read; its content is then worth nothing.
    static_cast<void>(ExamineStatus());
    const Content content{Read(Place(kInterface2 + kArbitration)), Read(Place(kInterface2 + kMessageControl)),
                          Read(Place(kInterface2 + kDataA)), Read(Place(kInterface2 + kDataB))};
    const CanObject& object = setup_.objects[number - 1U]; // MISRA D-002
    const std::uint32_t direction = (object.use == ObjectUse::kTransmit) ? kArbitrationTransmit : 0U;
    const std::uint32_t expected =
        kArbitrationValid | direction | (std::uint32_t{object.identifier} << kIdentifierShift);
    if ((Fault() == CanFault::kNone) && (content.arbitration != expected))
    {
        Stop(CanFault::kReadBack);
    }
    if (Fault() != CanFault::kNone)
    {
        return kStatusEvent;
    }
    return (object.use == ObjectUse::kTransmit) ? Confirmed(number, content) : Received(number, content);
}

DcanEvent Dcan::Received(const std::uint32_t number, const Content& content) noexcept
{
    if ((content.control & kMessageNew) == 0U)
    {
        return kStatusEvent;
    }
    DcanEvent event{DcanEventKind::kReceived, CanFrame{}};
    event.frame.identifier = setup_.objects[number - 1U].identifier; // MISRA D-002
    event.frame.kind = FrameKind::kData;
    event.frame.length_bytes = LengthOf(content.control);
    SetBytes(event.frame, 0U, content.data_a);
    SetBytes(event.frame, kBytesEachWord, content.data_b);
    if ((content.control & kMessageLost) != 0U)
    {
        event.kind = DcanEventKind::kReceivedAfterLoss;
        // Cleared, or every later frame would seem to follow a loss.
        constexpr std::uint32_t kFixed = kMessageUseMask | kMessageEndOfBlock | kMessageReceiveInterrupt;
        Write(Place(kInterface2 + kMessageControl), kFixed);
        if (Command(kInterface2, kCommandWrite | kCommandControl | number) != Outcome::kDone)
        {
            Stop(CanFault::kBusy);
        }
    }
    return event;
}

DcanEvent Dcan::Confirmed(const std::uint32_t number, const Content& content) noexcept
{
    const std::uint32_t index = number - 1U;
    const bool is_sent = (content.control & kMessageTransmit) == 0U;
    if ((in_flight_[index].Load() != kFlying) || !is_sent)
    {
        return kStatusEvent;
    }
    const Sent& sent = sent_[index];
    const bool same_data = (content.data_a == sent.data_a) && (content.data_b == sent.data_b);
    const bool same_length = (content.control & kMessageLength) == sent.length;
    if (!same_data || !same_length)
    {
        Stop(CanFault::kReadBack);
        return kStatusEvent;
    }
    DcanEvent event{DcanEventKind::kConfirmed, CanFrame{}};
    event.frame.identifier = setup_.objects[index].identifier; // MISRA D-002
    event.frame.kind = FrameKind::kData;
    event.frame.length_bytes = LengthOf(content.control);
    SetBytes(event.frame, 0U, content.data_a);
    SetBytes(event.frame, kBytesEachWord, content.data_b);
    in_flight_[index].Store(0U);
    return event;
}

bool Dcan::IsUsable(const DcanSetup& setup) const noexcept
{
    if ((setup.objects == nullptr) || (setup.object_count == 0U) || (setup.object_count > setup.object_room) ||
        (setup.object_room > kMostObjects))
    {
        return false;
    }
    bool is_usable = true;
    for (std::uint32_t i = 0U; i < setup.object_count; ++i)
    {
        const CanObject& object = setup.objects[i]; // MISRA D-002
        const bool has_use = (object.use == ObjectUse::kReceive) || (object.use == ObjectUse::kTransmit);
        is_usable = is_usable && has_use && (object.identifier <= kMostIdentifier);
        for (std::uint32_t j = 0U; j < i; ++j)
        {
            is_usable = is_usable && (setup.objects[j].identifier != object.identifier); // MISRA D-002
        }
    }
    return is_usable;
}

CanFault Dcan::Start(const DcanSetup& setup) noexcept
{
    fault_.Store(CanFault::kInvalid);
    bus_off_.Store(kBusOff);
    setup_ = setup;
    paused_ = 0U;
    returns_ = 0U;
    if (!IsUsable(setup))
    {
        fault_.Store(CanFault::kSetup);
        return CanFault::kSetup;
    }
    Write(Place(kControl), kControlInit);
    Write(Place(kControl), kControlInit | kControlReset);
    if (WaitFor(Place(kControl), Bits{kControlInit, kControlInit}, kInitLooks) != Outcome::kDone)
    {
        Stop(CanFault::kRegisters);
        return Fault();
    }
    Outcome registers = WriteChecked(Place(kControl), kRunControl | kControlInit | kControlChange, kCheckedControl);
    registers = Both(registers, WriteChecked(Place(kBitTiming), setup.bit_timing, kWholeWord));
    registers = Both(registers, WriteChecked(Place(kInterruptLine), 0U, kWholeWord));
    registers = Both(registers, WriteChecked(Place(kInterruptLine + 4U), 0U, kWholeWord));
    if (registers != Outcome::kDone)
    {
        Stop(CanFault::kRegisters);
        return Fault();
    }
    Outcome objects = ClearObjects();
    for (std::uint32_t number = 1U; number <= setup.object_count; ++number)
    {
        in_flight_[number - 1U].Store(0U);
        const CanObject& object = setup.objects[number - 1U]; // MISRA D-002
        objects = Both(objects, WriteObject(number, object));
        objects = Both(objects, CheckObject(number, object));
    }
    if (objects != Outcome::kDone)
    {
        Stop(CanFault::kReadBack);
        return Fault();
    }
    Touch(Place(kErrorStatus));
    if (WriteChecked(Place(kControl), kRunControl, kCheckedControl) != Outcome::kDone)
    {
        Stop(CanFault::kRegisters);
        return Fault();
    }
    fault_.Store(CanFault::kNone);
    bus_off_.Store(kOnBus);
    return CanFault::kNone;
}

Outcome Dcan::Command(const std::uint32_t interface, const std::uint32_t command) const noexcept
{
    Write(Place(interface + kCommand), command);
    return WaitFor(Place(interface + kCommand), Bits{kCommandBusy, 0U}, kInterfaceLooks);
}

Outcome Dcan::ClearObjects() const noexcept
{
    Outcome outcome = Outcome::kDone;
    for (std::uint32_t number = 1U; number <= setup_.object_room; ++number)
    {
        Write(Place(kInterface1 + kArbitration), 0U);
        Write(Place(kInterface1 + kMessageControl), 0U);
        const std::uint32_t command = kCommandWrite | kCommandArbitration | kCommandControl | number;
        outcome = Both(outcome, Command(kInterface1, command));
    }
    return outcome;
}

Outcome Dcan::WriteObject(const std::uint32_t number, const CanObject& object) const noexcept
{
    Write(Place(kInterface1 + kMask), kExactMatch);
    Write(Place(kInterface1 + kArbitration), ArbitrationOf(object));
    Write(Place(kInterface1 + kMessageControl), ControlOf(object));
    Write(Place(kInterface1 + kDataA), 0U);
    Write(Place(kInterface1 + kDataB), 0U);
    constexpr std::uint32_t kEverything =
        kCommandWrite | kCommandMask | kCommandArbitration | kCommandControl | kCommandDataA | kCommandDataB;
    return Command(kInterface1, kEverything | number);
}

Outcome Dcan::CheckObject(const std::uint32_t number, const CanObject& object) const noexcept
{
    const Outcome read = Command(kInterface2, kCommandMask | kCommandArbitration | kCommandControl | number);
    const bool same_mask = Read(Place(kInterface2 + kMask)) == kExactMatch;
    const bool same_identifier = Read(Place(kInterface2 + kArbitration)) == ArbitrationOf(object);
    const bool same_control = Read(Place(kInterface2 + kMessageControl)) == ControlOf(object);
    return (same_mask && same_identifier && same_control) ? read : Outcome::kFailed;
}

void Dcan::OnCycle() noexcept
{
    if (Fault() != CanFault::kNone)
    {
        return;
    }
    // In this order: the hardware sets Init when it goes to bus-off, and its status then says so at once.
    const std::uint32_t control = Read(Place(kControl));
    const bool same_timing = Read(Place(kBitTiming)) == setup_.bit_timing;
    const std::uint32_t status = ExamineStatus();
    const std::uint32_t compared = IsBusOff() ? (kCheckedControl & ~kControlInit) : kCheckedControl;
    const bool same_control = ((control ^ kRunControl) & compared) == 0U;
    if (!same_control || !same_timing)
    {
        Stop(CanFault::kRegisters);
    }
    FollowBusOff((status & kStatusBusOff) != 0U);
}

void Dcan::FollowBusOff(const bool is_off) noexcept
{
    const std::uint8_t state = bus_off_.Load();
    const bool is_followed = (state != kOnBus) && (Fault() == CanFault::kNone);
    if (!is_followed)
    {
        return;
    }
    if (state == kReturning)
    {
        // The hardware counts 128 times 11 recessive bits before it takes part again.
        const bool is_stopped = (Read(Place(kControl)) & kControlInit) != 0U;
        if (!is_off)
        {
            bus_off_.Store(kOnBus);
        }
        // Bus-off again before anybody saw it on the bus: it would wait for ever.
        if (is_off && is_stopped)
        {
            bus_off_.Store(kBusOff);
        }
        return;
    }
    if (paused_ == 0U)
    {
        Withdraw();
    }
    if (paused_ < setup_.pause_cycles)
    {
        ++paused_;
        return;
    }
    if (returns_ < setup_.most_returns)
    {
        ++returns_;
        paused_ = 0U;
        bus_off_.Store(kReturning);
        Write(Place(kControl), kRunControl);
    }
}

/// What waits since before bus-off is old: it must not be sent when the bus is there again.
void Dcan::Withdraw() noexcept
{
    Outcome outcome = Outcome::kDone;
    for (std::uint32_t number = 1U; number <= setup_.object_count; ++number)
    {
        const CanObject& object = setup_.objects[number - 1U]; // MISRA D-002
        if (object.use == ObjectUse::kTransmit)
        {
            Write(Place(kInterface1 + kMessageControl), ControlOf(object));
            outcome = Both(outcome, Command(kInterface1, kCommandWrite | kCommandControl | number));
            in_flight_[number - 1U].Store(0U);
        }
    }
    if (outcome != Outcome::kDone)
    {
        Stop(CanFault::kBusy);
    }
}

} // namespace counterpoint::tms570
