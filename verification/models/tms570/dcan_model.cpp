// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/models/tms570/dcan_model.hpp"

#include "hal/tms570/can/dcan_registers.hpp"

namespace counterpoint::tms570::model
{

namespace
{

using namespace dcan;

[[nodiscard]] std::uint32_t Word(const CanFrame& frame, const std::uint32_t first)
{
    std::uint32_t word = 0U;
    for (std::uint32_t i = 0U; i < 4U; ++i)
    {
        word |= static_cast<std::uint32_t>(frame.data[first + i]) << (8U * i);
    }
    return word;
}

[[nodiscard]] CanFrame FrameOf(const std::uint32_t arbitration, const std::uint32_t control, const std::uint32_t data_a,
                               const std::uint32_t data_b)
{
    CanFrame frame{};
    frame.identifier = (arbitration >> kIdentifierShift) & kIdentifierMask;
    frame.kind = FrameKind::kData;
    frame.length_bytes = static_cast<std::uint8_t>(control & kMessageLength);
    for (std::uint32_t i = 0U; i < 4U; ++i)
    {
        frame.data[i] = static_cast<std::uint8_t>(data_a >> (8U * i));
        frame.data[i + 4U] = static_cast<std::uint8_t>(data_b >> (8U * i));
    }
    return frame;
}

} // namespace

DcanModel::DcanModel(const FaultSet& faults, EsmModel& esm, const std::uint32_t parity_channel)
    : Peripheral(faults), esm_(esm), parity_channel_(parity_channel)
{
    Kept(kControl) = kControlInit;
}

bool DcanModel::IsOnBus()
{
    return ((Kept(kControl) & kControlInit) == 0U) && !is_bus_off_ && !Has(Fault::kDcanInitStuck);
}

bool DcanModel::Receive(const CanFrame& frame)
{
    if (!IsOnBus())
    {
        return false;
    }
    for (std::uint32_t number = 1U; number <= kObjects; ++number)
    {
        Object& object = objects_[number];
        const bool is_receiver =
            ((object.arbitration & kArbitrationValid) != 0U) && ((object.arbitration & kArbitrationTransmit) == 0U);
        const std::uint32_t identifier = (object.arbitration >> kIdentifierShift) & kIdentifierMask;
        if (!is_receiver || (identifier != frame.identifier) || (frame.kind != FrameKind::kData))
        {
            continue;
        }
        object.control |= ((object.control & kMessageNew) != 0U) ? kMessageLost : 0U;
        object.control = (object.control & ~kMessageLength) | frame.length_bytes | kMessageNew;
        object.control |= ((object.control & kMessageReceiveInterrupt) != 0U) ? kMessagePending : 0U;
        object.data_a = Word(frame, 0U);
        object.data_b = Word(frame, 4U);
        return true;
    }
    return false;
}

std::optional<CanFrame> DcanModel::Transmit()
{
    Object* first = nullptr;
    for (std::uint32_t number = 1U; number <= kObjects; ++number)
    {
        Object& object = objects_[number];
        const bool waits =
            ((object.arbitration & kArbitrationValid) != 0U) && ((object.control & kMessageTransmit) != 0U);
        if (waits && ((first == nullptr) || (object.arbitration < first->arbitration)))
        {
            first = &object;
        }
    }
    if ((first == nullptr) || !IsOnBus())
    {
        return std::nullopt;
    }
    first->control &= ~(kMessageTransmit | kMessageNew);
    first->control |= ((first->control & kMessageTransmitInterrupt) != 0U) ? kMessagePending : 0U;
    return FrameOf(first->arbitration, first->control, first->data_a, first->data_b);
}

void DcanModel::GoBusOff()
{
    is_bus_off_ = true;
    status_asks_ = true;
    Kept(kControl) |= kControlInit;
}

void DcanModel::Recover()
{
    // Only once the driver has cleared Init does the hardware count recessive bits.
    is_bus_off_ = is_bus_off_ && ((Kept(kControl) & kControlInit) != 0U);
}

bool DcanModel::Line()
{
    return ((Kept(kControl) & kControlLine0) != 0U) && (InterruptId() != 0U);
}

std::uint32_t DcanModel::InterruptId() const
{
    if (status_asks_)
    {
        return kInterruptIsStatus;
    }
    if (Has(Fault::kDcanForeignObject))
    {
        return kObjects;
    }
    for (std::uint32_t number = 1U; number <= kObjects; ++number)
    {
        if ((objects_[number].control & kMessagePending) != 0U)
        {
            return number;
        }
    }
    return 0U;
}

std::uint32_t DcanModel::Flags(const std::uint32_t first, const std::uint32_t bit) const
{
    std::uint32_t flags = 0U;
    for (std::uint32_t i = 0U; i < 32U; ++i)
    {
        flags |= ((objects_[first + i].control & bit) != 0U) ? (1U << i) : 0U;
    }
    return flags;
}

std::uint32_t DcanModel::Read(const std::uint32_t offset)
{
    switch (offset)
    {
    case kControl:
        return Kept(kControl) ^ (Has(Fault::kDcanControlChanged) ? kControlAutoBusOn : 0U);
    case kErrorStatus:
    {
        const std::uint32_t status = status_ | (is_bus_off_ ? kStatusBusOff : 0U);
        status_ = 0U;
        status_asks_ = false;
        return status;
    }
    case kInterrupt:
        return InterruptId();
    case kInterruptPending:
        return Flags(1U, kMessagePending);
    case kInterruptPending + 4U:
        return Flags(33U, kMessagePending);
    case kTransmitRequest:
        return Flags(1U, kMessageTransmit);
    case kTransmitRequest + 4U:
        return Flags(33U, kMessageTransmit);
    default:
        return Kept(offset);
    }
}

void DcanModel::Write(const std::uint32_t offset, const std::uint32_t value)
{
    if ((offset == kInterface1 + kCommand) || (offset == kInterface2 + kCommand))
    {
        const bool stays_busy = Has(Fault::kDcanBusyForEver);
        Kept(offset) = (value & ~kCommandBusy) | (stays_busy ? kCommandBusy : 0U);
        if (!stays_busy)
        {
            Transfer(offset - kCommand, value);
        }
        return;
    }
    if (offset == kControl)
    {
        const std::uint32_t lost = Has(Fault::kDcanInitStuck) ? kControlInit : 0U;
        Kept(offset) = value & ~(lost | kControlReset);
        return;
    }
    const bool is_lost = (offset == kBitTiming) && Has(Fault::kDcanTimingLost);
    Kept(offset) = is_lost ? 0U : value;
}

void DcanModel::Transfer(const std::uint32_t interface, const std::uint32_t command)
{
    const std::uint32_t number = command & 0xFFU;
    if ((number == 0U) || (number > kObjects))
    {
        return;
    }
    Object& object = objects_[number];
    if ((command & kCommandWrite) != 0U)
    {
        Put(interface, command, object);
    }
    else
    {
        Get(interface, command, object);
    }
}

void DcanModel::Put(const std::uint32_t interface, const std::uint32_t command, Object& object)
{
    if ((command & kCommandMask) != 0U)
    {
        object.mask = Kept(interface + kMask);
    }
    if ((command & kCommandArbitration) != 0U)
    {
        object.arbitration =
            Kept(interface + kArbitration) ^ (Has(Fault::kDcanObjectLost) ? (1U << kIdentifierShift) : 0U);
    }
    if ((command & kCommandControl) != 0U)
    {
        object.control = Kept(interface + kMessageControl);
    }
    object.control |= ((command & kCommandRequest) != 0U) ? (kMessageTransmit | kMessageNew) : 0U;
    if ((command & kCommandDataA) != 0U)
    {
        object.data_a = Kept(interface + kDataA);
    }
    if ((command & kCommandDataB) != 0U)
    {
        object.data_b = Kept(interface + kDataB);
    }
}

void DcanModel::Get(const std::uint32_t interface, const std::uint32_t command, Object& object)
{
    if (Has(Fault::kDcanParityError))
    {
        status_ |= kStatusParity;
        object.arbitration &= ~kArbitrationValid;
        object.control &= ~kMessagePending;
        esm_.Raise(1U, parity_channel_);
    }
    Kept(interface + kMask) = object.mask;
    Kept(interface + kArbitration) = object.arbitration;
    Kept(interface + kMessageControl) = object.control;
    Kept(interface + kDataA) = object.data_a ^ (Has(Fault::kDcanWrongReadBack) ? 0x10U : 0U);
    Kept(interface + kDataB) = object.data_b;
    object.control &= ((command & kCommandClearPending) != 0U) ? ~kMessagePending : 0xFFFFFFFFU;
    object.control &= ((command & kCommandRequest) != 0U) ? ~kMessageNew : 0xFFFFFFFFU;
}

} // namespace counterpoint::tms570::model
