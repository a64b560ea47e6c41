// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "can.hpp"

#include "registers.hpp"

namespace port_fifo
{

using counterpoint::CanFrame;
using counterpoint::CanPortId;
using counterpoint::FrameKind;
using counterpoint::Instant;
using counterpoint::InstantPair;
using counterpoint::hal::Guarantee;
using counterpoint::hal::TransmitStatus;

namespace
{

constexpr std::uint32_t kBitUs = 2U; ///< 500 kbit/s.
constexpr std::uint32_t kIdentifierMask = 0x7FFU;
constexpr std::uint32_t kMostPerInterrupt = 32U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kWordBytes = 4U;

/// How long ago the frame ended: bit times, 16 bits, modular.
[[nodiscard]] std::uint32_t Age(const std::uint32_t timer, const std::uint32_t entry) noexcept
{
    return (timer - (entry >> kStampShift)) & kStampMask;
}

/// The moment of the end of a frame by both counters: that of the interrupt less the age, which is the same for both.
[[nodiscard]] InstantPair StampOf(const InstantPair& now, const std::uint32_t age) noexcept
{
    return InstantPair{{now.a.us - (age * kBitUs)}, {now.b.us - (age * kBitUs)}};
}

[[nodiscard]] std::uint32_t PlaceOf(const std::uint32_t buffer) noexcept
{
    return kTransmitBuffer + (buffer * kBufferBytes);
}

/// The words of a frame are at `place`: two of data.
void ReadData(const std::uint32_t place, CanFrame& frame) noexcept
{
    for (std::uint32_t byte = 0U; byte < counterpoint::kMaxPayloadBytes; ++byte)
    {
        const std::uint32_t word = ReadRegister(place + (kWordBytes * (byte / kWordBytes)));
        frame.data[byte] = static_cast<std::uint8_t>(word >> (kByteBits * (byte % kWordBytes)));
    }
}

[[nodiscard]] std::uint32_t WordOf(const CanFrame& frame, const std::uint32_t first) noexcept
{
    std::uint32_t word = 0U;
    for (std::uint32_t byte = 0U; byte < kWordBytes; ++byte)
    {
        const std::uint32_t value = (first + byte < frame.length_bytes) ? frame.data[first + byte] : 0U;
        word |= value << (kByteBits * byte);
    }
    return word;
}

[[nodiscard]] bool HoldsFrame(const std::uint32_t place, const CanFrame& frame) noexcept
{
    const bool same_name =
        (ReadRegister(place) == frame.identifier) && ((ReadRegister(place + 4U) & kLengthMask) == frame.length_bytes);
    return same_name && (ReadRegister(place + 8U) == WordOf(frame, 0U)) &&
           (ReadRegister(place + 12U) == WordOf(frame, kWordBytes));
}

} // namespace

Can::Can(Clocks& clocks) noexcept : clocks_{clocks}
{
}

bool Can::Start(const FilterList& filters) noexcept
{
    WriteRegister(kCanControl, kOffTheBus);
    bool is_set = filters.count <= kFilters;
    for (std::uint32_t filter = 0U; filter < kFilters; ++filter)
    {
        const bool is_used = is_set && (filter < filters.count);
        const std::uint32_t wanted = is_used ? filters.identifiers[filter] : kFilterUnused;
        WriteRegister(kFilter + (kWordBytes * filter), wanted);
        is_set = is_set && (ReadRegister(kFilter + (kWordBytes * filter)) == wanted);
    }
    is_started_ = is_set;
    WriteRegister(kCanControl, is_set ? 0U : kOffTheBus);
    return is_set;
}

counterpoint::hal::CanGuarantees Can::Guarantees() const noexcept
{
    const Guarantee all = is_started_ ? Guarantee::kGiven : Guarantee::kAbsent;
    return counterpoint::hal::CanGuarantees{all, all, all};
}

void Can::OnInterrupt() noexcept
{
    for (std::uint32_t taken = 0U; taken < kMostPerInterrupt; ++taken)
    {
        const bool has_received = ReadRegister(kReceiveLevel) != 0U;
        const bool has_sent = ReadRegister(kEventLevel) != 0U;
        if (!has_received && !has_sent)
        {
            break;
        }
        const std::uint32_t timer = ReadRegister(kCanTimer);
        const InstantPair now = clocks_.Now();
        // Between the two FIFOs the stamps tell the order: the older one first.
        const bool sent_first =
            has_sent &&
            (!has_received || (Age(timer, ReadRegister(kEventBuffer)) > Age(timer, ReadRegister(kReceiveLength))));
        if (sent_first)
        {
            TakeSent(timer, now);
        }
        else
        {
            TakeReceived(timer, now);
        }
    }
    const std::uint32_t lost = ReadRegister(kCanStatus) & (kReceiveLost | kEventLost);
    if (lost != 0U)
    {
        WriteRegister(kCanStatus, lost);
        has_lost_.store(true);
    }
}

CanEvent Can::Next() noexcept
{
    if (has_lost_.exchange(false))
    {
        return CanEvent{EventKind::kLoss, counterpoint::StampedFrame{}};
    }
    const std::uint32_t taken = taken_.load();
    if (taken == put_.load())
    {
        return CanEvent{EventKind::kNothing, counterpoint::StampedFrame{}};
    }
    const CanEvent event = ring_[taken % kRoom];
    taken_.store(taken + 1U);
    return event;
}

TransmitStatus Can::DoTransmit(const CanFrame& frame) noexcept
{
    if ((frame.port != CanPortId::kFirst) || !is_started_)
    {
        return TransmitStatus::kRefused;
    }
    if ((ReadRegister(kCanStatus) & kBusOff) != 0U)
    {
        // What waits must not leave once the controller is back.
        WriteRegister(kTransmitCancel, (1U << kBuffers) - 1U);
        for (std::atomic<bool>& in_flight : in_flight_)
        {
            in_flight.store(false);
        }
        return TransmitStatus::kBusOff;
    }
    const std::uint32_t pending = ReadRegister(kTransmitPending);
    for (std::uint32_t buffer = 0U; buffer < kBuffers; ++buffer)
    {
        const bool is_pending = (pending & (1U << buffer)) != 0U;
        if (!is_pending && !in_flight_[buffer].exchange(true))
        {
            sent_[buffer] = frame;
            WriteRegister(PlaceOf(buffer), frame.identifier);
            WriteRegister(PlaceOf(buffer) + 4U, frame.length_bytes);
            WriteRegister(PlaceOf(buffer) + 8U, WordOf(frame, 0U));
            WriteRegister(PlaceOf(buffer) + 12U, WordOf(frame, kWordBytes));
            WriteRegister(kTransmitRequest, buffer);
            return TransmitStatus::kAccepted;
        }
    }
    return TransmitStatus::kQueueFull;
}

void Can::TakeReceived(const std::uint32_t timer, const InstantPair& now) noexcept
{
    const std::uint32_t identifier = ReadRegister(kReceiveIdentifier);
    const std::uint32_t entry = ReadRegister(kReceiveLength);
    CanEvent event{EventKind::kReceived, counterpoint::StampedFrame{}};
    CanFrame& frame = event.frame.frame;
    const bool is_remote = (identifier & kRemote) != 0U;
    const bool is_extended = (identifier & kExtended) != 0U;
    frame.identifier = identifier & kIdentifierMask;
    frame.kind = is_extended ? FrameKind::kExtended : (is_remote ? FrameKind::kRemote : FrameKind::kData);
    frame.port = CanPortId::kFirst;
    frame.length_bytes = static_cast<std::uint8_t>(entry & kLengthMask);
    ReadData(kReceiveData, frame);
    event.frame.stamp = StampOf(now, Age(timer, entry));
    WriteRegister(kReceivePop, 1U);
    Put(event);
}

void Can::TakeSent(const std::uint32_t timer, const InstantPair& now) noexcept
{
    const std::uint32_t entry = ReadRegister(kEventBuffer);
    const std::uint32_t buffer = entry & kStampMask;
    WriteRegister(kEventPop, 1U);
    if ((buffer >= kBuffers) || !HoldsFrame(PlaceOf(buffer), sent_[buffer]))
    {
        has_lost_.store(true); // What was on the bus is not known, and the buffer stays out of use.
        return;
    }
    Put(CanEvent{EventKind::kConfirmed, counterpoint::StampedFrame{sent_[buffer], StampOf(now, Age(timer, entry))}});
    in_flight_[buffer].store(false);
}

void Can::Put(const CanEvent& event) noexcept
{
    const std::uint32_t put = put_.load();
    if ((put - taken_.load()) >= kRoom)
    {
        has_lost_.store(true);
        return;
    }
    ring_[put % kRoom] = event;
    put_.store(put + 1U);
}

} // namespace port_fifo
