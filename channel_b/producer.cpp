// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// A budget of which one microsecond too much was taken.
constexpr std::uint32_t kJustSpent = 0xFFFFFFFFU;

} // namespace

/// For how long a producer of form kApplicationSends may be silent. [SRS-PROD-010]
std::uint32_t Channel::AbsenceUs(SlotIndex slot) const noexcept
{
    return SctUs(x_storage.rows[slot]) + x_config->cycle_us + x_config->cycle_tolerance_us;
}

PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    PreparedPair pair{{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}}, PrepareStatus::kNotProducer};
    Row& row = x_storage.rows[slot];
    if ((x_storage.state[slot] != Code(SrdoState::kProducer)) || IsInFlight(row.stage))
    {
        return pair;
    }
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    marks.requested &= ~bit;
    marks.refresh_due &= ~bit;
    const ObjectData data = ReadObjects(row);
    if (data.wrong != 0U)
    {
        static_cast<void>(Fail(slot, SrdoCause::kNotInverse));
        pair.status = PrepareStatus::kNotInverse;
        return pair;
    }
    row.inverse_data = data.inverse;
    row.stage = Stage::kAwaitNormal;
    StartBudget(x_storage, slot, 0U);
    if ((marks.started & ~marks.provider & bit) != 0U)
    {
        x_storage.phase_left[slot] = AbsenceUs(slot);
    }
    pair.normal.identifier = NormalIdentifier(row);
    pair.normal.kind = FrameKind::kData;
    pair.normal.port = x_config->normal_port;
    pair.normal.length_bytes = row.length_bytes;
    UnpackBytes(data.inverse ^ PayloadMask(row.length_bytes), &pair.normal.data[0]);
    pair.status = PrepareStatus::kReady;
    return pair;
}

CanFrame Channel::InverseFrame(SlotIndex slot) noexcept
{
    CanFrame frame{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}};
    Row& row = x_storage.rows[slot];
    if (row.stage == Stage::kSendInverse)
    {
        row.stage = Stage::kAwaitInverse;
        frame.identifier = InverseIdentifier(row);
        frame.kind = FrameKind::kData;
        frame.port = x_config->inverse_port;
        frame.length_bytes = row.length_bytes;
        UnpackBytes(row.inverse_data, &frame.data[0]);
    }
    return frame;
}

Confirmation Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const SlotIndex slot = LookUp(x_storage, frame);
    if ((frame.kind != FrameKind::kData) || (slot >= x_count))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    Row& row = x_storage.rows[slot];
    // The identifiers of normal frames are odd, those of inverse frames are even.
    const bool is_normal = (frame.identifier & 1U) != 0U;
    const bool is_inverse_awaited = IsInFlight(row.stage) && (row.stage != Stage::kAwaitNormal);
    const bool is_awaited = is_normal ? (row.stage == Stage::kAwaitNormal) : is_inverse_awaited;
    const std::uint32_t own = is_normal ? NormalIdentifier(row) : InverseIdentifier(row);
    if ((!is_awaited) || (frame.identifier != own))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    const std::uint64_t echo = PackBytes(&frame.data[0]) ^ row.inverse_data;
    const std::uint64_t different = (is_normal ? ~echo : echo) & PayloadMask(row.length_bytes);
    if ((frame.length_bytes != row.length_bytes) || (different != 0U))
    {
        return Fail(slot, SrdoCause::kWrongEcho);
    }
    const std::uint32_t since_call = stamp.us - x_last_us;
    if (is_normal)
    {
        row.stage = Stage::kSendInverse;
        StartBudget(x_storage, slot, since_call);
        return Confirmation{slot, ConfirmStep::kNormal};
    }
    if ((x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot])
    {
        return Fail(slot, SrdoCause::kNoConfirmation);
    }
    row.sent += 1U;
    Ground(slot);
    return Confirmation{slot, ConfirmStep::kPair};
}

void Channel::OnTransmitFault(SlotIndex slot, SrdoCause cause) noexcept
{
    const bool is_transmit_fault = (cause == SrdoCause::kTransmitQueue) || (cause == SrdoCause::kBusOff);
    if (is_transmit_fault && IsInFlight(x_storage.rows[slot].stage))
    {
        static_cast<void>(Fail(slot, cause));
    }
}

/// The refresh falls due at exact distances, whenever the calls come. [SRS-PROD-001, SRS-PROD-002]
inline void Channel::AdvanceProvider(SlotIndex slot) noexcept
{
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
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

/// [SRS-PROD-001, SRS-PROD-010]
inline void Channel::AdvanceApplication(SlotIndex slot) noexcept
{
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    const std::uint32_t absence_us = AbsenceUs(slot);
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
void Channel::EndPhases(const Census& census) noexcept
{
    const Marks& marks = MarksOf(x_storage, census.first);
    for (HalfMask rest = census.present & ~(marks.acknowledged.on & marks.consumers); rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, census.first);
        const HalfMask bit = BitOf(slot);
        if ((x_storage.phase_left[slot] - 1U) <= kLongestPhase)
        {
            continue; // At least one microsecond is left.
        }
        if ((census.producers & bit) == 0U)
        {
            x_storage.phase_left[slot] = kLongestPhase;
        }
        else if ((marks.provider & bit) != 0U)
        {
            AdvanceProvider(slot);
        }
        else
        {
            AdvanceApplication(slot);
        }
    }
}

/// Returns the slots that are due. [SRS-PROD-003, SRS-PROD-004, SRS-PROD-008, SRS-PROD-010, SRS-PROD-012]
HalfMask Channel::AdvanceProducers(const CycleInput& input, const Call& call, const Census& census) noexcept
{
    Marks& marks = MarksOf(x_storage, census.first);
    const HalfMask standing = PartOf(input.stand, census.first) & marks.provider & marks.started & census.producers;
    marks.requested |= PartOf(input.request, census.first) & census.producers;
    for (HalfMask rest = census.producers & census.spent; rest != 0U; rest = WithoutLowest(rest))
    {
        static_cast<void>(Fail(LowestOf(rest, census.first), SrdoCause::kNoConfirmation));
    }
    for (HalfMask rest = standing; rest != 0U; rest = WithoutLowest(rest))
    {
        x_storage.phase_left[LowestOf(rest, census.first)] += x_elapsed_us;
    }
    if (call.phases != 0U)
    {
        EndPhases(census);
    }
    HalfMask due = census.producers & (marks.refresh_due | (marks.requested & marks.started));
    for (HalfMask rest = due; rest != 0U; rest = WithoutLowest(rest))
    {
        const SlotIndex slot = LowestOf(rest, census.first);
        if (IsInFlight(x_storage.rows[slot].stage))
        {
            due &= ~BitOf(slot);
        }
    }
    return due;
}

} // namespace counterpoint::channel_b
