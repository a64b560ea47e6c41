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
    return SctUs(x_storage, slot) + x_config->cycle_us + x_config->cycle_tolerance_us;
}

PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    PreparedPair pair{{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}}, PrepareStatus::kNotProducer};
    if ((x_storage.state[slot] != Code(SrdoState::kProducer)) || IsInFlight(x_storage, slot))
    {
        return pair;
    }
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    marks.requested &= ~bit;
    marks.refresh_due &= ~bit;
    const ObjectData data = ReadObjects(slot);
    const std::uint64_t mask = PayloadMask(x_storage.length_bytes[slot]);
    if ((data.normal ^ data.inverse) != mask)
    {
        static_cast<void>(Fail(slot, SrdoCause::kNotInverse));
        pair.status = PrepareStatus::kNotInverse;
        return pair;
    }
    x_storage.inverse_data[slot] = data.inverse;
    x_storage.stage[slot] = Stage::kAwaitNormal;
    StartBudget(x_storage, slot, 0U);
    if ((marks.started & ~marks.provider & bit) != 0U)
    {
        x_storage.phase_left[slot] = AbsenceUs(slot);
    }
    pair.normal.identifier = NormalIdentifier(x_storage, slot);
    pair.normal.kind = FrameKind::kData;
    pair.normal.port = x_config->normal_port;
    pair.normal.length_bytes = x_storage.length_bytes[slot];
    UnpackBytes(data.inverse ^ mask, &pair.normal.data[0]);
    pair.status = PrepareStatus::kReady;
    return pair;
}

CanFrame Channel::InverseFrame(SlotIndex slot) noexcept
{
    CanFrame frame{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}};
    if (x_storage.stage[slot] == Stage::kSendInverse)
    {
        const std::uint64_t data = x_storage.inverse_data[slot];
        x_storage.stage[slot] = Stage::kAwaitInverse;
        frame.identifier = InverseIdentifier(x_storage, slot);
        frame.kind = FrameKind::kData;
        frame.port = x_config->inverse_port;
        frame.length_bytes = x_storage.length_bytes[slot];
        UnpackBytes(data, &frame.data[0]);
    }
    return frame;
}

[[gnu::always_inline]] inline bool Channel::IsEchoWrong(SlotIndex slot, const CanFrame& frame,
                                                        std::uint64_t expected) const noexcept
{
    const std::uint8_t length_bytes = x_storage.length_bytes[slot];
    const std::uint64_t different = (expected ^ PackBytes(&frame.data[0])) & PayloadMask(length_bytes);
    return (frame.length_bytes != length_bytes) || (different != 0U);
}

Confirmation Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const SlotIndex slot = LookUp(x_storage, frame);
    if ((frame.kind != FrameKind::kData) || (slot >= x_count))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    // The identifiers of normal frames are odd, those of inverse frames are even.
    const bool is_normal = (frame.identifier & 1U) != 0U;
    const Awaited confirmed = is_normal ? Awaited::kNormal : Awaited::kInverse;
    const bool is_own = frame.identifier == OwnIdentifier(x_storage, slot, is_normal);
    if ((AwaitedIn(x_storage.stage[slot]) != confirmed) || (!is_own))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    const std::uint64_t inverse = x_storage.inverse_data[slot];
    const std::uint32_t since_call = stamp.us - x_last_us;
    if (IsEchoWrong(slot, frame, is_normal ? ~inverse : inverse))
    {
        return Fail(slot, SrdoCause::kWrongEcho);
    }
    if (!is_normal)
    {
        return ConfirmInverse(slot, since_call);
    }
    x_storage.stage[slot] = Stage::kSendInverse;
    StartBudget(x_storage, slot, since_call);
    return Confirmation{slot, ConfirmStep::kNormal};
}

/// `since_call` is the time from the last OnCycle to the confirmation.
[[gnu::always_inline]] inline Confirmation Channel::ConfirmInverse(SlotIndex slot, std::uint32_t since_call) noexcept
{
    if ((x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot])
    {
        return Fail(slot, SrdoCause::kNoConfirmation);
    }
    x_storage.sent[slot] += 1U;
    x_storage.stage[slot] = Stage::kIdle;
    x_storage.pair_limit[slot] = kNothingRuns;
    return Confirmation{slot, ConfirmStep::kPair};
}

void Channel::OnTransmitFault(SlotIndex slot, SrdoCause cause) noexcept
{
    const bool is_transmit_fault = (cause == SrdoCause::kTransmitQueue) || (cause == SrdoCause::kBusOff);
    if (is_transmit_fault && IsInFlight(x_storage, slot))
    {
        static_cast<void>(Fail(slot, cause));
    }
}

/// The refresh falls due at exact distances, whenever the calls come. [SRS-PROD-001, SRS-PROD-002]
void Channel::AdvanceProvider(SlotIndex slot) noexcept
{
    Marks& marks = MarksOf(x_storage, slot);
    const HalfMask bit = BitOf(slot);
    x_storage.phase_left[slot] += SctUs(x_storage, slot);
    marks.started |= bit;
    if (IsInFlight(x_storage, slot) || ((marks.refresh_due & bit) != 0U))
    {
        static_cast<void>(Fail(slot, SrdoCause::kRefreshMissed));
    }
    else
    {
        marks.refresh_due |= bit;
    }
}

/// [SRS-PROD-001, SRS-PROD-010]
void Channel::AdvanceApplication(SlotIndex slot) noexcept
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
        static_cast<void>(Fail(slot, SrdoCause::kRefreshMissed));
        x_storage.phase_left[slot] = absence_us;
    }
}

/// Returns the slots that are due. [SRS-PROD-004, SRS-PROD-008, SRS-PROD-010]
HalfMask Channel::AdvanceProducers(const CycleInput& input, const Census& census) noexcept
{
    Marks& marks = MarksOf(x_storage, census.first);
    const std::uint32_t first_us = kFirstTransmissionStepUs * x_config->node_id;
    const HalfMask standing = PartOf(input.stand, census.first) & marks.provider & marks.started;
    marks.requested |= PartOf(input.request, census.first) & census.producers;
    for (HalfMask rest = census.producers & census.spent; rest != 0U;)
    {
        static_cast<void>(Fail(TakeLowest(rest, census.first), SrdoCause::kNoConfirmation));
    }
    for (HalfMask rest = census.producers; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest, census.first);
        const HalfMask bit = BitOf(slot);
        const std::uint32_t elapsed_us = ((standing & bit) != 0U) ? 0U : x_elapsed_us;
        const std::uint32_t left_us = x_storage.phase_left[slot] - elapsed_us;
        const std::uint32_t limit_us = ((marks.started & bit) != 0U) ? SctUs(x_storage, slot) : first_us;
        x_storage.phase_left[slot] = left_us;
        if ((left_us - 1U) < limit_us) // At least one microsecond is left.
        {
            continue;
        }
        if ((marks.provider & bit) != 0U)
        {
            AdvanceProvider(slot);
        }
        else
        {
            AdvanceApplication(slot);
        }
    }
    HalfMask due = census.producers & (marks.refresh_due | (marks.requested & marks.started));
    for (HalfMask rest = due; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest, census.first);
        if (IsInFlight(x_storage, slot))
        {
            due &= ~BitOf(slot);
        }
    }
    return due;
}

} // namespace counterpoint::channel_b
