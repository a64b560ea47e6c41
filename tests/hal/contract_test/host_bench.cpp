// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/hal/contract_test/host_bench.hpp"

#include <utility>

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kForeign = 0x123U; // One bit from both that are received.
constexpr WatchdogWindow kWindow{500U, 1600U};

[[nodiscard]] HostBench& Of(void* const bench)
{
    return *static_cast<HostBench*>(bench);
}

[[nodiscard]] CanPortId PortOfInverse(const std::uint8_t controllers)
{
    return (controllers > 1U) ? CanPortId::kSecond : CanPortId::kFirst;
}

} // namespace

HostBench::HostBench(const Defect defect, const std::uint8_t controllers)
    : defect_(defect), controllers_(controllers), parameters_(defect)
{
    const host::NodeIndex first = can_.ConnectPort(CanPortId::kFirst, bus_, 8U);
    bus_.AcceptNone(first);
    bus_.AcceptRange(first, 0x121U, (controllers > 1U) ? 0x121U : 0x122U);
    if (Has(Defect::kForeignDelivered))
    {
        bus_.AcceptRange(first, kForeign, kForeign);
    }
    if (controllers > 1U)
    {
        const host::NodeIndex second = can_.ConnectPort(CanPortId::kSecond, bus_, 8U);
        bus_.AcceptNone(second);
        bus_.AcceptRange(second, 0x122U, 0x122U);
    }
    Restart();
}

PortUnderTest HostBench::Table()
{
    PortUnderTest port{};
    port.parts = PortParts{this, this, this, this, this, this, &parameters_};
    PortBench& bench = port.bench;
    bench.bench = this;
    bench.write = [](void* self, const char* text) { Of(self).text_ += text; };
    bench.next = [](void* self) { return Of(self).Next(); };
    bench.pass = [](void* self, const std::uint32_t us)
    {
        HostBench& host = Of(self);
        host.bus_.Advance(host.bus_.Now() + (us * host::kMicrosecond));
    };
    bench.restart = [](void* self) { Of(self).Restart(); };
    bench.peer_send = [](void* self, const CanFrame& frame) { return Of(self).PeerSend(frame); };
    bench.pins = [](void* self) { return Of(self).Pins(); };
    bench.hold_bus = [](void* self, const Hold hold) { Of(self).HoldBus(hold); };
    // Frames wait for `next` in any case; what a defect spoils while interrupts wait is noted.
    bench.hold_interrupt = [](void* self, const Hold hold) { Of(self).was_late_ = hold == Hold::kReleased; };
    bench.hold_counter = [](void* self, const Counter counter, const Hold hold)
    { Of(self).HoldCounter(counter, hold); };
    bench.hold_pin = [](void* self, const Hold hold) { Of(self).pin_held_ = hold == Hold::kHeld; };
    bench.read_back = [](void* self) { return Of(self).Has(Defect::kNotReadBack) ? SrdoMask{0U} : Of(self).Pins(); };
    bench.is_alive = [](void* self)
    { return Of(self).Has(Defect::kMissingAnswerTaken) || Of(self).watchdog_.IsAlive(); };
    bench.peer_take = [](void* self, CanFrame& frame) { return Of(self).PeerTake(frame); };
    bench.bus_off = [](void* self, const Hold hold) { Of(self).BusOff(hold); };
    bench.work = [](void* self) { return static_cast<std::uint32_t>(Of(self).bus_.Now() / host::kMicrosecond); };
    const CanPortId inverse = PortOfInverse(controllers_);
    port.numbers = PortNumbers{{{0x121U, CanPortId::kFirst}, {0x122U, inverse}},
                               {{0x101U, CanPortId::kFirst}, {0x102U, inverse}},
                               kForeign,
                               controllers_,
                               32U,
                               8U,
                               280U,
                               10U,
                               1000U,
                               1500U,
                               kWindow,
                               0U,
                               90'000'000U};
    return port;
}

CanGuarantees HostBench::Guarantees() const noexcept
{
    CanGuarantees given = can_.Guarantees();
    given.stamps = Has(Defect::kOneGuaranteeAbsent) ? Guarantee::kAbsent : given.stamps;
    return given;
}

InstantPair HostBench::Now() noexcept
{
    InstantPair now = clocks_.Now();
    ++readings_;
    now.b = Has(Defect::kOneSourceForBoth) ? Instant{now.a.us + 5000U} : now.b;
    now.a.us -= (Has(Defect::kCounterGoesBack) && ((readings_ % 64U) == 0U)) ? 3U : 0U;
    // 2^32 cycles of 80 MHz.
    now.a.us = Has(Defect::kCounterWrapsEarly) ? (now.a.us % 53'687'091U) : now.a.us;
    now.b.us = Has(Defect::kCounterBSlow) ? (now.b.us / 2U) : now.b.us;
    return now;
}

std::uint32_t HostBench::Challenge() noexcept
{
    // Armed before each cycle, not by who starts the device.
    if (Has(Defect::kForgetsInterruption) && (output_->Open() == 0U))
    {
        output_->Drive(PermitSet{});
        output_->Drive(PermitSet{});
    }
    const std::uint32_t challenge = output_->Challenge();
    return Has(Defect::kChallengeStays) ? 0x12345679U : challenge;
}

void HostBench::Drive(const PermitSet& permits) noexcept
{
    PermitSet judged = permits;
    if (Has(Defect::kOnePermitNotLookedAt))
    {
        // What A answered, without its constant, is what B had to answer: by the inverse of the constant modulo 2^32.
        std::uint32_t inverse = 1U;
        for (int step = 0; step < 5; ++step)
        {
            inverse *= 2U - (kPermitConstantA * inverse);
        }
        judged.b.response = (permits.a.response * inverse) * kPermitConstantB;
    }
    was_driven_ = true;
    judged.a.response += (Has(Defect::kNeverOpens) && (permits.a.mask != 0U)) ? 1U : 0U;
    output_->Drive(judged);
}

void HostBench::CutOff() noexcept
{
    was_cut_off_ = true;
    if (!Has(Defect::kCutOffForgotten))
    {
        output_->CutOff();
    }
    else
    {
        output_->Drive(PermitSet{}); // Closes, and the next right Drive opens again.
    }
}

WatchdogQuestion HostBench::Question() noexcept
{
    return Has(Defect::kQuestionStays) ? WatchdogQuestion{7U} : watchdog_.Question();
}

void HostBench::Answer(const WatchdogAnswer& answer) noexcept
{
    const hal::WatchdogAnswer right{(kFlowReference + watchdog_.Question().value) * kWatchdogConstant};
    const bool stays = Has(Defect::kQuestionStays) && (answer.value == ((kFlowReference + 7U) * kWatchdogConstant));
    const bool is_taken = stays || Has(Defect::kWrongAnswerTaken);
    const bool was_dead = !watchdog_.IsAlive();
    const bool is_right = answer.value == right.value;
    if (Has(Defect::kEarlyAnswerTaken) && is_right && !was_dead)
    {
        watchdog_.Start(kWindow);
        return;
    }
    watchdog_.Answer(is_taken ? right : answer);
    if (Has(Defect::kRevivedAfterTrip) && was_dead)
    {
        watchdog_.Start(kWindow);
    }
}

ProtectStatus HostBench::Protect(const MemoryRegion& region) noexcept
{
    return Has(Defect::kImpossibleRegionTaken) ? ProtectStatus::kProtected : protection_.Protect(region);
}

void HostBench::Enter(const MemoryOwner owner) noexcept
{
    protection_.Enter(owner);
}

TransmitStatus HostBench::DoTransmit(const CanFrame& frame) noexcept
{
    if (Has(Defect::kTransmitWaits))
    {
        bus_.Advance(bus_.Now() + (300 * host::kMicrosecond));
    }
    const bool is_absent = (frame.port == CanPortId::kSecond) && (controllers_ == 1U);
    CanFrame on_bus = frame;
    if (Has(Defect::kOtherOnTheBus))
    {
        std::swap(on_bus.data[0], on_bus.data[4]); // Words swapped, and turned back in what is confirmed.
    }
    if (Has(Defect::kOtherLengthOnTheBus) && (on_bus.length_bytes == 8U))
    {
        on_bus.length_bytes = 7U; // And confirmed as if it had been 8.
    }
    const TransmitStatus status = can_.Transmit(on_bus);
    handed_over_ = clocks_.Now();
    last_taken_ = (status == TransmitStatus::kAccepted) ? on_bus : last_taken_;
    if (Has(Defect::kConfirmedAtOnce) && (status == TransmitStatus::kAccepted))
    {
        events_.push_back(PortEvent{EventKind::kConfirmed, StampedFrame{frame, clocks_.Now()}});
    }
    if ((Has(Defect::kRefusalSwallowed) && !is_absent) || (Has(Defect::kAbsentControllerTaken) && is_absent))
    {
        return TransmitStatus::kAccepted;
    }
    return status;
}

void HostBench::Take(PortEvent event)
{
    const bool is_confirmation = event.kind == EventKind::kConfirmed;
    if ((Has(Defect::kConfirmedAtOnce) && is_confirmation) ||
        ((Has(Defect::kLossNotTold) || (Has(Defect::kLossInControllerNotTold) && was_late_)) &&
         (event.kind == EventKind::kLoss)))
    {
        return;
    }
    CanFrame& frame = event.frame.frame;
    if (Has(Defect::kStampsSwapped))
    {
        std::swap(event.frame.stamp.a, event.frame.stamp.b);
    }
    if (Has(Defect::kBytesSwapped) && !is_confirmation)
    {
        std::swap(frame.data[4], frame.data[7]);
        std::swap(frame.data[5], frame.data[6]);
    }
    if (Has(Defect::kOtherOnTheBus) && is_confirmation)
    {
        std::swap(frame.data[0], frame.data[4]);
    }
    if (Has(Defect::kOtherLengthOnTheBus) && is_confirmation && (frame.length_bytes == 7U))
    {
        frame.length_bytes = 8U;
    }
    if (Has(Defect::kOwnMissingWhenLate) && is_confirmation && was_late_)
    {
        return;
    }
    if (Has(Defect::kStampedAtRequest) && is_confirmation)
    {
        event.frame.stamp = handed_over_;
    }
    if (Has(Defect::kConfirmedOther) && is_confirmation)
    {
        frame.data[7] ^= 1U;
    }
    events_.push_back(event);
    if (is_confirmation && (Has(Defect::kConfirmedTwice) || Has(Defect::kOwnFrameReceived)))
    {
        event.kind = Has(Defect::kConfirmedTwice) ? EventKind::kConfirmed : EventKind::kReceived;
        events_.push_back(event);
    }
    Reorder();
}

void HostBench::Reorder()
{
    const std::size_t count = events_.size();
    if (count < 2U)
    {
        return;
    }
    PortEvent& before = events_[count - 2U];
    PortEvent& last = events_[count - 1U];
    const CanFrame& frame = last.frame.frame;
    const bool is_confirmation = last.kind == EventKind::kConfirmed;
    const bool both_confirmed = is_confirmation && (before.kind == EventKind::kConfirmed);
    if (Has(Defect::kInverseOvertakes) && both_confirmed && (frame.identifier == 0x102U))
    {
        std::swap(last, before);
    }
    const bool both_received = (before.kind == EventKind::kReceived) && (last.kind == EventKind::kReceived);
    const bool same_identifier = frame.identifier == before.frame.frame.identifier;
    if (Has(Defect::kLaterOvertakes) && both_confirmed && same_identifier)
    {
        std::swap(last, before);
    }
    if (Has(Defect::kOwnAfterForeign) && was_late_ && (before.kind == EventKind::kConfirmed) &&
        (last.kind == EventKind::kReceived))
    {
        std::swap(last, before);
    }
    // As mailboxes are read that are served by their numbers.
    if (Has(Defect::kFramesReordered) && both_received && (frame.identifier < before.frame.frame.identifier))
    {
        std::swap(last, before);
    }
}

bool HostBench::PeerSend(const CanFrame& frame)
{
    CanFrame sent = frame;
    // As a controller takes it whose filter and driver do not look at the length of the identifier.
    if (Has(Defect::kFirstBitsAsData) && (frame.kind == FrameKind::kExtended))
    {
        sent.identifier = frame.identifier >> 18U;
        sent.kind = FrameKind::kData;
    }
    if (Has(Defect::kLastBitsAsData) && (frame.kind == FrameKind::kExtended))
    {
        sent.identifier = frame.identifier & 0x7FFU;
        sent.kind = FrameKind::kData;
    }
    return bus_.Submit(peer_node_, sent) == TransmitStatus::kAccepted;
}

void HostBench::BusOff(const Hold hold)
{
    for (std::uint8_t number = 1U; number <= controllers_; ++number)
    {
        const host::NodeIndex node = can_.NodeOf((number == 2U) ? CanPortId::kSecond : CanPortId::kFirst);
        if (hold == Hold::kHeld)
        {
            bus_.ForceBusOff(node);
        }
        else
        {
            bus_.Recover(node);
        }
    }
    if (Has(Defect::kOldAfterBusOff) && (hold == Hold::kReleased))
    {
        static_cast<void>(can_.Transmit(last_taken_));
    }
}

bool HostBench::PeerTake(CanFrame& frame)
{
    if (peer_.seen.empty())
    {
        return false;
    }
    frame = peer_.seen.front();
    peer_.seen.pop_front();
    return true;
}

PortEvent HostBench::Next()
{
    queue_.Drain(sink_);
    if (events_.empty())
    {
        return PortEvent{EventKind::kNothing, StampedFrame{}};
    }
    PortEvent event = events_.front();
    events_.pop_front();
    if (Has(Defect::kStampedWhenTaken))
    {
        event.frame.stamp = clocks_.Now();
    }
    if (Has(Defect::kRemoteAsData) && (event.frame.frame.kind == FrameKind::kRemote))
    {
        event.frame.frame.kind = FrameKind::kData;
    }
    return event;
}

void HostBench::Restart()
{
    watchdog_.Start(kWindow);
    never_trips_.Start(WatchdogWindow{0U, 0x7FFFFFFFU});
    output_.emplace(bus_, Has(Defect::kOpenAfterTrip) ? never_trips_ : watchdog_,
                    GateLimit{Has(Defect::kNeverCloses) ? 1'000'000'000U : (Has(Defect::kClosesLate) ? 2900U : 1500U)});
    was_late_ = false;
    pin_held_ = false;
    was_cut_off_ = false;
    was_driven_ = false;
}

void HostBench::HoldBus(const Hold hold)
{
    for (std::uint8_t number = 1U; number <= controllers_; ++number)
    {
        const host::NodeIndex node = can_.NodeOf((number == 2U) ? CanPortId::kSecond : CanPortId::kFirst);
        if (hold == Hold::kHeld)
        {
            bus_.Disconnect(node);
        }
        else
        {
            bus_.Connect(node);
        }
    }
}

void HostBench::HoldCounter(const Counter counter, const Hold hold)
{
    host::HostClock& clock = (counter == Counter::kB) ? clocks_.B() : clocks_.A();
    clock.SetRate(bus_.Now(), (hold == Hold::kHeld) ? host::kStopped : host::kTrueRate);
}

SrdoMask HostBench::Pins()
{
    const bool is_high = pin_held_ || (Has(Defect::kOpenAfterStart) && !was_driven_ && !was_cut_off_);
    return output_->Open() | SrdoMask{is_high ? 1U : 0U};
}

} // namespace counterpoint::hal::contract
