// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Frames through the FIFOs of a controller (UG1085, "RX Messages", "TX Messages", "Message Format"). Byte 0 of the data
// is the highest of its word.
//
// Why one transmission at a time: ISR[TXOK] says that a message of either buffer was sent, and a message that is being
// sent is not overtaken. With two under way nobody knows of which one a confirmation is.
#include "hal/zynqmp/can/canps.hpp"

namespace counterpoint::zynqmp
{
namespace
{

using namespace canps;

constexpr std::uint32_t kWordBytes = 4U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kByteMask = 0xFFU;
/// Frames that a receive FIFO has room for: one look reads no more.
constexpr std::uint32_t kFifoFrames = 64U;
/// A state of the controller follows within some cycles of its clock, a look takes longer than one.
constexpr Looks kStateLooks{1000U};
/// By how much the counters, of whole microseconds and read one after the other, and the time stamp may differ.
constexpr std::uint32_t kSlackUs = 8U;
constexpr std::uint32_t kStampRange = kTimeStampMask + 1U;
constexpr std::uint32_t kMostMhz = 200U;

constexpr std::uint32_t kExactFormat = kOtherFormats;

[[nodiscard]] std::uint32_t WordOf(const CanFrame& frame, const std::uint32_t first) noexcept
{
    std::uint32_t word = 0U;
    for (std::uint32_t i = 0U; i < kWordBytes; ++i)
    {
        const std::uint32_t byte = ((first + i) < frame.length_bytes) ? frame.data[first + i] : 0U;
        word = (word << kByteBits) | byte;
    }
    return word;
}

void SetBytes(CanFrame& frame, const std::uint32_t first, const std::uint32_t word) noexcept
{
    for (std::uint32_t i = 0U; i < kWordBytes; ++i)
    {
        const bool is_used = (first + i) < frame.length_bytes;
        const std::uint32_t shift = kByteBits * ((kWordBytes - 1U) - i);
        frame.data[first + i] = static_cast<std::uint8_t>(is_used ? ((word >> shift) & kByteMask) : 0U);
    }
}

[[nodiscard]] std::uint32_t FilterPlace(const std::uint32_t first, const std::uint32_t number) noexcept
{
    return first + (number * kFilterBytes);
}

/// Bits of a filter's mask that are compared; the format always is.
[[nodiscard]] std::uint32_t MaskWord(const AcceptanceFilter& filter) noexcept
{
    return (std::uint32_t{filter.mask} << kIdentifierShift) | kExactFormat;
}

[[nodiscard]] std::uint32_t IdentifierWord(const AcceptanceFilter& filter) noexcept
{
    return std::uint32_t{filter.identifier} << kIdentifierShift;
}

[[nodiscard]] std::uint32_t Greater(const std::uint32_t one, const std::uint32_t other) noexcept
{
    return (one > other) ? one : other;
}

[[nodiscard]] Instant Later(const Instant one, const Instant other) noexcept
{
    constexpr std::uint32_t kHalfRange = 0x80000000U;
    return ((one.us - other.us) < kHalfRange) ? one : other;
}

/// Time that has passed by the counter that says more.
[[nodiscard]] std::uint32_t Since(const InstantPair& now, const InstantPair& before) noexcept
{
    return Greater(now.a.us - before.a.us, now.b.us - before.b.us);
}

} // namespace

bool Canps::IsUsable(const CanpsSetup& setup) const noexcept
{
    const bool is_clock = (setup.reference_mhz != 0U) && (setup.reference_mhz <= kMostMhz);
    const std::uint32_t roll_over_us = is_clock ? (kStampRange / setup.reference_mhz) : 0U;
    const bool is_dense = (setup.latest_look_us != 0U) && ((setup.latest_look_us + (4U * kSlackUs)) < roll_over_us);
    return is_dense && (plan_.count != 0U);
}

CanFault Canps::Start(const CanpsSetup& setup, hal::Clocks& clocks) noexcept
{
    fault_ = CanFault::kInvalid;
    is_bus_off_ = false;
    paused_ = 0U;
    returns_ = 0U;
    foreign_ = 0U;
    setup_ = setup;
    plan_ = PlanFilters(setup.received);
    sending_.Clear();
    if (!IsUsable(setup))
    {
        fault_ = CanFault::kSetup;
        return fault_;
    }
    if (Configure(clocks) != Outcome::kDone)
    {
        Stop(CanFault::kRegisters);
        return fault_;
    }
    fault_ = CanFault::kNone;
    return fault_;
}

Outcome Canps::Configure(hal::Clocks& clocks) noexcept
{
    Write(Place(kReset), kResetNow);
    constexpr std::uint32_t kAreFull = kUrgentFull | kTransmitFull;
    Outcome outcome = WaitFor(Place(kStatus), Bits{kIsConfiguring | kAreFull, kIsConfiguring}, kStateLooks);
    // A frame of before the reset must not be sent: bus-off and configuration alone retain it.
    outcome = Both(outcome, WaitFor(Place(kEvents), Bits{kTransmitEmpty, kTransmitEmpty}, kStateLooks));
    outcome = Both(outcome, WriteChecked(Place(kMode), 0U, kWholeWord));
    outcome = Both(outcome, WriteChecked(Place(kPrescaler), setup_.prescaler, kWholeWord));
    outcome = Both(outcome, WriteChecked(Place(kBitTiming), setup_.bit_timing, kWholeWord));
    outcome = Both(outcome, WriteChecked(Place(kInterrupts), 0U, kWholeWord));
    outcome = Both(outcome, WriteFilters());
    if (outcome != Outcome::kDone)
    {
        return Outcome::kFailed;
    }
    Discard();
    Write(Place(kReset), kEnabled);
    outcome = WaitFor(Place(kStatus), Bits{kIsConfiguring | kIsNormal, kIsNormal}, kStateLooks);
    Write(Place(kClearEvents), kAllEvents);
    emptied_ = clocks.Now();
    latest_ = emptied_;
    Anchor(clocks);
    return outcome;
}

/// A filter may be changed only while it is off and the controller is not busy with one.
Outcome Canps::WriteFilters() const noexcept
{
    Outcome outcome = WriteChecked(Place(kFilters), 0U, kWholeWord);
    outcome = Both(outcome, WaitFor(Place(kStatus), Bits{kFilterBusy, 0U}, kStateLooks));
    for (std::uint32_t number = 0U; number < plan_.count; ++number)
    {
        const AcceptanceFilter& filter = plan_.filters[number];
        outcome = Both(outcome, WriteChecked(Place(FilterPlace(kFilterMask, number)), MaskWord(filter), kWholeWord));
        outcome = Both(outcome,
                       WriteChecked(Place(FilterPlace(kFilterIdentifier, number)), IdentifierWord(filter), kWholeWord));
    }
    const std::uint32_t enabled = (1U << plan_.count) - 1U;
    return Both(outcome, WriteChecked(Place(kFilters), enabled, kWholeWord));
}

bool Canps::AreFiltersSetUp() const noexcept
{
    bool is_same = Read(Place(kFilters)) == ((1U << plan_.count) - 1U);
    for (std::uint32_t number = 0U; number < plan_.count; ++number)
    {
        const AcceptanceFilter& filter = plan_.filters[number];
        const bool same_mask = Read(Place(FilterPlace(kFilterMask, number))) == MaskWord(filter);
        const bool same_identifier = Read(Place(FilterPlace(kFilterIdentifier, number))) == IdentifierWord(filter);
        is_same = is_same && same_mask && same_identifier;
    }
    return is_same;
}

bool Canps::IsSetUp() const noexcept
{
    const bool is_on = (Read(Place(kReset)) == kEnabled) && (Read(Place(kMode)) == 0U);
    const bool is_normal = (Read(Place(kStatus)) & (kIsConfiguring | kIsNormal)) == kIsNormal;
    const bool same_prescaler = Read(Place(kPrescaler)) == setup_.prescaler;
    const bool same_timing = Read(Place(kBitTiming)) == setup_.bit_timing;
    const bool is_same = same_prescaler && same_timing && AreFiltersSetUp();
    return is_on && is_normal && is_same;
}

void Canps::Stop(const CanFault why) noexcept
{
    if (setup_.base.address != 0U) // else it was never started, and is off the bus since the reset
    {
        Write(Place(kReset), kResetNow);
    }
    sending_.Clear();
    if ((fault_ == CanFault::kNone) || (fault_ == CanFault::kInvalid))
    {
        fault_ = why;
    }
}

hal::TransmitStatus Canps::Send(const CanFrame& frame) noexcept
{
    if (fault_ != CanFault::kNone)
    {
        return hal::TransmitStatus::kRefused;
    }
    if (is_bus_off_)
    {
        return hal::TransmitStatus::kBusOff;
    }
    const SendLane lane = (frame.identifier < setup_.urgent_below) ? SendLane::kUrgent : SendLane::kFifo;
    if (!sending_.Put(frame, lane))
    {
        return hal::TransmitStatus::kQueueFull;
    }
    StartNext();
    return (fault_ == CanFault::kNone) ? hal::TransmitStatus::kAccepted : hal::TransmitStatus::kRefused;
}

void Canps::StartNext() noexcept
{
    const SendLane lane = sending_.Begin();
    if (lane == SendLane::kInvalid)
    {
        return;
    }
    const bool is_urgent = lane == SendLane::kUrgent;
    const std::uint32_t full = is_urgent ? kUrgentFull : kTransmitFull;
    if ((Read(Place(kStatus)) & full) != 0U)
    {
        Stop(CanFault::kBusy);
        return;
    }
    const std::uint32_t first = is_urgent ? kUrgent : kTransmit;
    const CanFrame& frame = sending_.UnderWay();
    Write(Place(first), frame.identifier << kIdentifierShift);
    Write(Place(first + kLengthWord), std::uint32_t{frame.length_bytes} << kLengthShift);
    Write(Place(first + kDataWord), WordOf(frame, 0U));
    Write(Place(first + kLastDataWord), WordOf(frame, kWordBytes));
}

Canps::Words Canps::ReadFrame() const noexcept
{
    const std::uint32_t identifier = Read(Place(kReceive));
    const std::uint32_t length = Read(Place(kReceive + kLengthWord));
    const std::uint32_t first = Read(Place(kReceive + kDataWord));
    const std::uint32_t last = Read(Place(kReceive + kLastDataWord));
    Write(Place(kClearEvents), kNotEmpty);
    return Words{identifier, length, {first, last}};
}

/// What was received before the reset is nobody's.
void Canps::Discard() const noexcept
{
    Write(Place(kClearEvents), kNotEmpty);
    for (std::uint32_t frame = 0U; frame < kFifoFrames; ++frame)
    {
        if ((Read(Place(kEvents)) & kNotEmpty) == 0U)
        {
            return;
        }
        static_cast<void>(ReadFrame());
    }
}

bool Canps::IsOurs(const std::uint32_t identifier_word) const noexcept
{
    const std::uint32_t identifier = identifier_word >> kIdentifierShift;
    bool is_known = false;
    for (std::uint32_t number = 0U; number < setup_.received.count; ++number)
    {
        is_known = is_known || (setup_.received.first[number] == identifier); // MISRA D-002
    }
    return is_known && ((identifier_word & kOtherFormats) == 0U);
}

InstantPair Canps::StampOf(const InstantPair& now, const std::uint32_t time_stamp, const StampSource source,
                           FrameQueue& queue) const noexcept
{
    if (source != StampSource::kController)
    {
        return now;
    }
    const std::uint32_t counted = ((now.a.us - anchor_.a.us) + kSlackUs) * setup_.reference_mhz;
    const std::uint32_t age_us = ((counted - time_stamp) & kTimeStampMask) / setup_.reference_mhz;
    if (age_us > (Since(now, emptied_) + (2U * kSlackUs)))
    {
        queue.PutLoss();
        return now;
    }
    const std::uint32_t older_us = (age_us > kSlackUs) ? (age_us - kSlackUs) : 0U;
    return InstantPair{Instant{now.a.us - older_us}, Instant{now.b.us - older_us}};
}

// Two stamps of one moment may differ by a microsecond either way.
InstantPair Canps::InOrder(const InstantPair& stamp) noexcept
{
    latest_ = InstantPair{Later(stamp.a, latest_.a), Later(stamp.b, latest_.b)};
    return latest_;
}

void Canps::Deliver(const Words& words, const InstantPair& stamp, FrameQueue& queue, const CanPortId port) noexcept
{
    if (!IsOurs(words.identifier))
    {
        foreign_ += (foreign_ != kWholeWord) ? 1U : 0U;
        return;
    }
    const std::uint32_t length = words.length >> kLengthShift;
    CanFrame frame{words.identifier >> kIdentifierShift, FrameKind::kData, port, kMaxPayloadBytes, {}};
    frame.length_bytes = (length > kMaxPayloadBytes) ? kMaxPayloadBytes : static_cast<std::uint8_t>(length);
    SetBytes(frame, 0U, words.data[0U]);
    SetBytes(frame, kWordBytes, words.data[1U]);
    queue.Put(QueuedFrame{QueuedKind::kReceived, StampedFrame{frame, InOrder(stamp)}});
}

// Returns how many frames there were. Each look at the FIFO comes before a reading of the counters.
std::uint32_t Canps::Drain(hal::Clocks& clocks, FrameQueue& queue, const CanPortId port,
                           const StampSource source) noexcept
{
    std::uint32_t frames = 0U;
    InstantPair before = clocks.Now();
    while ((frames < kFifoFrames) && ((Read(Place(kEvents)) & kNotEmpty) != 0U))
    {
        const Words words = ReadFrame();
        const InstantPair now = clocks.Now();
        const InstantPair stamp = StampOf(now, words.length & kTimeStampMask, source, queue);
        Deliver(words, stamp, queue, port);
        before = now;
        ++frames;
    }
    if (frames < kFifoFrames)
    {
        emptied_ = before;
    }
    return frames;
}

void Canps::Look(hal::Clocks& clocks, FrameQueue& queue, const CanPortId port) noexcept
{
    if ((fault_ != CanFault::kNone) || is_bus_off_)
    {
        return;
    }
    const std::uint32_t events = Read(Place(kEvents));
    const bool is_late = Since(clocks.Now(), emptied_) > setup_.latest_look_us;
    if ((events & kUnderflow) != 0U)
    {
        Stop(CanFault::kUnderflow);
        return;
    }
    if ((events & kOverflow) != 0U)
    {
        Write(Place(kClearEvents), kOverflow);
        queue.PutLoss();
    }
    const bool is_sent = (events & kSent) != 0U;
    const StampSource source = is_late ? StampSource::kMoment : StampSource::kController;
    const std::uint32_t frames = Drain(clocks, queue, port, source);
    if (is_late && (is_sent || (frames != 0U)))
    {
        queue.PutLoss();
    }
    if (is_sent)
    {
        TakeConfirmation(clocks, queue, port);
    }
    const bool is_off = (Read(Place(kStatus)) & kErrorState) == kErrorIsBusOff;
    if (((events & kBusOff) != 0U) || is_off)
    {
        EnterBusOff();
    }
}

void Canps::TakeConfirmation(hal::Clocks& clocks, FrameQueue& queue, const CanPortId port) noexcept
{
    Write(Place(kClearEvents), kSent);
    if (sending_.Lane() == SendLane::kInvalid)
    {
        Stop(CanFault::kConfirmation);
        return;
    }
    CanFrame frame = sending_.UnderWay();
    frame.port = port;
    queue.Put(QueuedFrame{QueuedKind::kConfirmed, StampedFrame{frame, InOrder(clocks.Now())}});
    sending_.End();
    StartNext();
}

void Canps::OnCycle(hal::Clocks& clocks, FrameQueue& queue, const CanPortId port) noexcept
{
    if (fault_ != CanFault::kNone)
    {
        return;
    }
    if (is_bus_off_)
    {
        FollowBusOff(clocks);
        return;
    }
    if (!IsSetUp())
    {
        // A controller that has just left the bus by itself is not set up either, and says so.
        Look(clocks, queue, port);
        if (!is_bus_off_)
        {
            Stop(CanFault::kRegisters);
        }
        return;
    }
    if ((Read(Place(kEvents)) & kNotEmpty) == 0U)
    {
        Anchor(clocks);
        // Whether its time stamp is from before or after, nobody knows; it came in between.
        static_cast<void>(Drain(clocks, queue, port, StampSource::kMoment));
    }
}

/// What waits since before bus-off is old: it must not be sent when the bus is there again. The reset empties both
/// transmit buffers.
void Canps::EnterBusOff() noexcept
{
    Write(Place(kReset), kResetNow);
    sending_.Clear();
    is_bus_off_ = true;
    paused_ = 0U;
}

void Canps::FollowBusOff(hal::Clocks& clocks) noexcept
{
    if (paused_ < setup_.pause_cycles)
    {
        ++paused_;
        return;
    }
    if (returns_ >= setup_.most_returns)
    {
        return;
    }
    ++returns_;
    if (Configure(clocks) != Outcome::kDone)
    {
        Stop(CanFault::kRegisters);
        return;
    }
    is_bus_off_ = false;
}

void Canps::Anchor(hal::Clocks& clocks) noexcept
{
    anchor_ = clocks.Now();
    Write(Place(kTimeStamp), kClearTimeStamp);
}

} // namespace counterpoint::zynqmp
