// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Start of a DCAN controller (reference manual, chapter DCAN, "Initialization"; facts/tms570 3): into initialisation
// mode, bit timing, all objects invalid, those of the device written and read back, parity on, onto the bus.
#include "hal/tms570/can/dcan.hpp"

namespace counterpoint::tms570
{

namespace
{

using namespace dcan;

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
