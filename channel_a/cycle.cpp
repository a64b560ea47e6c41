// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/channel.hpp"
#include "channel_a/seal.hpp"
#include "channel_a/slots.hpp"

#include <cstddef>
#include <cstdint>

// One cycle: OPERATIONAL first, then a scan that finds the few slots that have something to do, then those.
namespace counterpoint::channel_a
{
namespace
{

constexpr std::uint8_t kGfcEnabled = 1U;
constexpr std::uint32_t kTokenRotation = 8U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kEachByte = 0x01010101U;

// [SRS-CFG-031]
GuardView GuardOf(const CycleInput& input, const std::uint8_t configuration_valid) noexcept
{
    const std::uint32_t rotated =
        (input.challenge << kTokenRotation) | (input.challenge >> (kWordBits - kTokenRotation));
    GuardView view = GuardView::kStale;
    if (input.guard_token == (rotated ^ (configuration_valid * kEachByte)))
    {
        view = (configuration_valid == kConfigurationValidValue) ? GuardView::kConfigured : GuardView::kUnconfigured;
    }
    return view;
}

} // namespace

CycleOutcome Channel::OnCycle(const CycleInput& input) noexcept
{
    const GuardView guard = GuardOf(input, configuration_valid_);
    Cycle cycle{};
    cycle.now = input.now;
    cycle.is_late = has_run_ && ((input.now.us - now_.us) > late_after_us_);
    cycle.has_overflow = input.queue != QueueState::kIntact;
    cycle.has_gfc = gfc_pending_;
    cycle.edges = input.acknowledge & ~levels_;
    levels_ = input.acknowledge;
    has_run_ = true;
    gfc_pending_ = false;
    step_us_ = input.now.us - now_.us;
    now_ = input.now;
    ++cycle_;

    const bool is_active = (input.nmt == NmtState::kOperational) && (guard == GuardView::kConfigured);
    FollowOperational(cycle, is_active);
    if ((cycle.now.us - entered_.us) >= first_delay_us_)
    {
        may_send_ = true; // Kept: the difference wraps after 71 minutes.
    }
    ScanLimits(cycle);
    SrdoMask to_serve = attention_;
    attention_ = 0U;
    while (to_serve != 0U)
    {
        ServeSlot(cycle, TakeLowest(to_serve));
    }

    CycleOutcome outcome{};
    outcome.released = groups_[kGroupReleased];
    outcome.faulted = groups_[kGroupFaulted];
    outcome.waiting = groups_[kGroupWaiting];
    outcome.new_fault = cycle.new_fault;
    outcome.fresh = fresh_;
    outcome.due = cycle.due;
    outcome.signalled = cycle.signalled;
    outcome.cycle = cycle_;
    outcome.ordinal_sum = ordinal_sum_;
    outcome.guard = guard;
    outcome.sct_checked = consumer_count_;
    outcome.is_tx = producer_count_;
    outcome.is_invalid = off_count_;
    outcome.not_operational = is_active_ ? 0U : 1U;
    fresh_ = 0U;
    return outcome;
}

void Channel::ReceiveOther(const CanFrame& frame) noexcept
{
    if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && (gfc_parameter_ == kGfcEnabled))
    {
        gfc_pending_ = true;
    }
}

// The limit first; the frame is then taken as if nothing had been there before it.
void Channel::ReceiveLate(const CanFrame& frame, const Instant stamp, const SlotIndex slot) noexcept
{
    RaiseAt(slot, Event::kExpired);
    ReceiveInTime(frame, stamp, slot, At(slot));
}

void Channel::RaiseAt(const SlotIndex slot, const Event event) noexcept
{
    Raise(At(slot), BitOf(slot), event, SrdoCause::kNone);
}

SlotIndex Channel::GiveUp(const SlotIndex slot, const Event event, const SrdoCause cause) noexcept
{
    Raise(At(slot), BitOf(slot), event, cause);
    return slot;
}

// [SRS-CONS-002]
void Channel::FollowOperational(Cycle& cycle, const bool is_active) noexcept
{
    if (is_active && !is_active_)
    {
        Enter(cycle.now);
    }
    if (!is_active && is_active_)
    {
        Leave(cycle);
    }
    is_active_ = is_active;
}

void Channel::Enter(const Instant now) noexcept
{
    entered_ = now;
    may_send_ = false;
    standing_ = 0U;
    ordinal_sum_ = 0U;
    consumer_count_ = 0U;
    producer_count_ = 0U;
    off_count_ = count_;
    for (std::size_t place = 0U; place < kLookUpSize; ++place)
    {
        storage_.look_up[place] = 0U; // MISRA D-002
    }
    for (SlotIndex slot = 0U; slot < count_; ++slot)
    {
        const Record& record = At(slot);
        if ((record.mapping == kMarked) && (record.check == kMarked) && IsSealed(record))
        {
            EnterSlot(slot);
        }
    }
}

// Only directions 1 and 2 come as far as a resolved mapping.
void Channel::EnterSlot(const SlotIndex slot) noexcept
{
    Record& record = At(slot);
    const SrdoMask bit = BitOf(slot);
    const std::uint32_t place = record.values[kCobIdPlace] - kFirstSrdoIdentifier;
    storage_.look_up[(place >> 1U) % kLookUpSize] = static_cast<std::uint8_t>(slot + 1U); // MISRA D-002
    record.ordinal = 0U;
    attention_ |= bit;
    --off_count_;
    if (record.direction == kDirectionConsumer)
    {
        Raise(record, bit, Event::kEnterConsumer, SrdoCause::kNone);
        record.awaiting = kMarked;
        ++consumer_count_;
    }
    else
    {
        Raise(record, bit, Event::kEnterProducer, SrdoCause::kNone);
        StartProducing(record);
        ++producer_count_;
    }
}

void Channel::Leave(Cycle& cycle) noexcept
{
    cycle.left = Consumers();
    SrdoMask to_leave = cycle.left | groups_[kGroupProducer];
    while (to_leave != 0U)
    {
        const SlotIndex slot = TakeLowest(to_leave);
        Record& record = At(slot);
        Raise(record, BitOf(slot), Event::kLeave, SrdoCause::kNone);
        StopProducing(record);
    }
    MoveTo(~SrdoMask{0U}, kGroupOff);
    consumer_count_ = 0U;
    producer_count_ = 0U;
    off_count_ = 0U;
}

// The one loop over all slots. What it passes over has no limit that expired, fits its seal, and has nothing to tell,
// to wait for or to release.
inline void Channel::ScanLimits(const Cycle& cycle) noexcept
{
    // A new pair is of interest to a slot that is not released yet.
    SrdoMask found = cycle.edges | standing_ | (fresh_ & ~groups_[kGroupReleased]);
    if (cycle.is_late || cycle.has_overflow || cycle.has_gfc)
    {
        found |= Consumers();
    }
    for (SlotIndex slot = 0U; slot < count_; ++slot)
    {
        const Record& record = At(slot);
        if (((cycle.now.us - record.since.us) > record.limit_us) || !IsSealed(record))
        {
            found |= BitOf(slot);
        }
    }
    attention_ |= found & existing_;
}

// Each cause once in a window of SCT. [SRS-CONS-021]
inline void Channel::Signal(Cycle& cycle, Record& record, const SrdoMask bit, const std::uint32_t extra) noexcept
{
    if ((cycle.now.us - record.told_since.us) > (record.values[kSctPlace] * kMicrosecondsPerMillisecond))
    {
        record.told = 0U;
    }
    record.signals = (record.unreported | extra) & ~record.told;
    record.unreported = 0U;
    if (record.signals != 0U)
    {
        record.told_since = (record.told == 0U) ? cycle.now : record.told_since;
        record.told |= record.signals;
        cycle.signalled |= bit;
    }
}

inline void Channel::ServeSlot(Cycle& cycle, const SlotIndex slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    Record& record = At(slot);
    std::uint32_t extra = 0U;
    if ((groups_[kGroupProducer] & bit) != 0U)
    {
        ServeProducer(cycle, record, bit);
    }
    else if ((groups_[kGroupOff] & bit) == 0U)
    {
        extra = ServeConsumer(cycle, record, bit);
    }
    else
    {
        cycle.new_fault |= cycle.left & bit;
    }
    Signal(cycle, record, bit, extra);
    const std::uint32_t unfinished = record.told | record.edge | record.awaiting;
    attention_ |= (unfinished != 0U) ? bit : 0U;
}

} // namespace counterpoint::channel_a
