// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// A budget of which one microsecond too much was taken.
constexpr std::uint32_t kJustSpent = 0xFFFFFFFFU;

constexpr CanFrame kNoFrame{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}};
constexpr Confirmation kNoConfirmation{kNoSlot, ConfirmStep::kNone};

[[nodiscard]] CanFrame FrameOf(const Row& row, std::size_t identifier_at, CanPortId port, std::uint64_t data) noexcept
{
    CanFrame frame{WordAt(row, identifier_at), FrameKind::kData, port, row.length_bytes, {}};
    UnpackBytes(data, &frame.data[0]);
    return frame;
}

} // namespace

/// [SRS-PROD-005]
PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if (row.stage != Stage::kIdle)
    {
        return PreparedPair{kNoFrame, PrepareStatus::kNotProducer};
    }
    const std::uint64_t data = ~ReadInverse(slot) & row.mask & ~row.spare;
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    marks.requested &= ~bit;
    marks.refresh_due &= ~bit;
    row.inverse_data = ~data;
    row.stage = Stage::kAwaitNormal;
    StartBudget(x_storage, slot, 0U);
    if ((marks.started & ~marks.provider & bit) != 0U)
    {
        x_storage.phase_left[slot] = SctUs(row) + x_late_us;
    }
    return PreparedPair{FrameOf(row, kCobId1At, x_port[1U], data), PrepareStatus::kReady};
}

CanFrame Channel::InverseFrame(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if ((row.stage != Stage::kAwaitInverse) || (row.to_send != kToSend))
    {
        return kNoFrame;
    }
    row.to_send = kHandedOut;
    return FrameOf(row, kCobId2At, x_port[0U], row.inverse_data & row.mask);
}

/// One way for both frames of a pair; behind the length anything may be. [SRS-PROD-007, SRS-PROD-008]
Confirmation Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const SlotIndex slot = LookUp(x_storage, frame);
    if ((frame.kind != FrameKind::kData) || (slot >= x_count))
    {
        return kNoConfirmation;
    }
    Row& row = x_storage.rows[slot];
    const bool is_normal = row.stage == Stage::kAwaitNormal;
    const std::uint32_t parity = is_normal ? 1U : 0U;
    const bool is_awaited = is_normal || (row.stage == Stage::kAwaitInverse);
    if ((!is_awaited) || (frame.identifier != OwnIdentifier(row, parity)))
    {
        return kNoConfirmation;
    }
    const std::uint64_t flipped =
        std::uint64_t{0U} - parity; // Every bit for the normal frame, none for the inverse one.
    const std::uint64_t different = (PackBytes(&frame.data[0]) ^ row.inverse_data ^ flipped) & row.mask;
    if ((different != 0U) || (frame.length_bytes != row.length_bytes))
    {
        return Fail(slot, SrdoCause::kWrongEcho);
    }
    const std::uint32_t since_call = stamp.us - x_last_us;
    if (is_normal)
    {
        row.stage = Stage::kAwaitInverse;
        row.to_send = kToSend;
        x_storage.pair_left[slot] = x_storage.pair_limit[slot] + since_call; // SRVT anew.
        return Confirmation{slot, ConfirmStep::kNormal};
    }
    if ((x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot])
    {
        return Fail(slot, SrdoCause::kNoConfirmation);
    }
    row.sent += 1U;
    row.stage = Stage::kIdle;
    x_storage.pair_limit[slot] = kNothingRuns;
    return Confirmation{slot, ConfirmStep::kPair};
}

void Channel::OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept
{
    const bool is_of_bus = (fault.cause == SrdoCause::kTransmitQueue) || (fault.cause == SrdoCause::kBusOff);
    const bool is_transmit_fault = is_of_bus || (fault.cause == SrdoCause::kNotInverse);
    if (is_transmit_fault && IsInFlight(x_storage.rows[slot].stage))
    {
        static_cast<void>(Fail(slot, fault.cause));
    }
}

/// The refresh falls due at exact distances, whenever the calls come. [SRS-PROD-001, SRS-PROD-002]
[[gnu::always_inline]] inline void Channel::AdvanceProvider(SlotIndex slot, HalfMask bit, Marks& marks) noexcept
{
    x_storage.phase_left[slot] += SctUs(x_storage.rows[slot]);
    marks.started |= bit;
    if (IsInFlight(x_storage.rows[slot].stage) || ((marks.refresh_due & bit) != 0U))
    {
        Record(slot, SrdoCause::kRefreshMissed);
    }
    else
    {
        marks.refresh_due |= bit;
    }
}

/// Silence is allowed for the refresh time and a cycle that is just in time. [SRS-PROD-001, SRS-PROD-010]
[[gnu::always_inline]] inline void Channel::AdvanceApplication(SlotIndex slot, HalfMask bit, Marks& marks) noexcept
{
    const std::uint32_t absence_us = SctUs(x_storage.rows[slot]) + x_late_us;
    if ((marks.started & bit) == 0U)
    {
        marks.started |= bit;
        x_storage.phase_left[slot] += absence_us; // Silence counts from the instant, not from this call.
    }
    if (x_storage.phase_left[slot] <= absence_us)
    {
        return;
    }
    if ((marks.requested & bit) != 0U)
    {
        x_storage.phase_left[slot] = kJustSpent; // However long the request waits, the budget must not wrap.
    }
    else
    {
        Record(slot, SrdoCause::kRefreshMissed);
        x_storage.phase_left[slot] = absence_us;
    }
}

/// Whose phase is over, or where no phase runs any longer.
inline void Channel::EndPhases(const Half& half) noexcept
{
    Marks& marks = *half.marks;
    for (HalfMask rest = half.present & ~(marks.acknowledged.on & marks.consumers); rest != 0U;
         rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        const HalfMask bit = BitOf(slot);
        if ((x_storage.phase_left[slot] - 1U) <= kLongestPhase)
        {
            continue; // At least one microsecond is left.
        }
        if ((marks.producers & bit) == 0U)
        {
            x_storage.phase_left[slot] = kLongestPhase;
        }
        else if ((marks.provider & bit) != 0U)
        {
            AdvanceProvider(slot, bit, marks);
        }
        else
        {
            AdvanceApplication(slot, bit, marks);
        }
    }
}

/// Returns the slots that are due. [SRS-PROD-003, SRS-PROD-004, SRS-PROD-008, SRS-PROD-010, SRS-PROD-012]
HalfMask Channel::AdvanceProducers(const CycleInput& input, const Call& call, const Half& half) noexcept
{
    Marks& marks = *half.marks;
    const HalfMask standing = PartOf(input.stand, half.first) & marks.provider & marks.started & marks.producers;
    marks.requested |= PartOf(input.request, half.first) & marks.producers;
    for (HalfMask rest = marks.producers & half.spent; rest != 0U; rest = WithoutLowest(rest))
    {
        static_cast<void>(Fail(LowestOf(rest, half.first), SrdoCause::kNoConfirmation));
    }
    for (HalfMask rest = standing; rest != 0U; rest = WithoutLowest(rest))
    {
        x_storage.phase_left[LowestOf(rest, half.first)] += x_elapsed_us;
    }
    if (call.ended != 0U)
    {
        EndPhases(half);
    }
    HalfMask due = marks.producers & (marks.refresh_due | (marks.requested & marks.started));
    for (HalfMask rest = due; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, half.first);
        if (IsInFlight(x_storage.rows[slot].stage))
        {
            due &= ~BitOf(slot);
        }
    }
    return due;
}

} // namespace counterpoint::channel_b
