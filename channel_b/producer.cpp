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

void Channel::Request(SlotIndex slot) noexcept
{
    if (x_storage.state[slot] == Code(SrdoState::kProducer))
    {
        x_storage.marks->requested |= BitOf(slot);
    }
}

void Channel::Hold(SlotIndex slot) noexcept
{
    const SrdoMask by_provider = x_storage.marks->provider & x_storage.marks->started & BitOf(slot);
    if ((by_provider != 0U) && (x_storage.state[slot] == Code(SrdoState::kProducer)))
    {
        x_storage.marks->standing |= BitOf(slot);
    }
}

PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    PreparedPair pair{{0U, 0U}, PrepareStatus::kNotProducer, 0U};
    if ((x_storage.state[slot] != Code(SrdoState::kProducer)) || IsInFlight(x_storage, slot))
    {
        return pair;
    }
    x_storage.marks->requested &= ~BitOf(slot);
    x_storage.marks->refresh_due &= ~BitOf(slot);
    const ObjectData data = ReadObjects(slot);
    const std::uint64_t mask = PayloadMask(x_storage.length_bytes[slot]);
    if ((data.normal ^ data.inverse) != mask)
    {
        static_cast<void>(Fail(slot, SrdoCause::kNotInverse));
        pair.status = PrepareStatus::kNotInverse;
        return pair;
    }
    x_storage.inverse_data[slot] = data.inverse;
    x_storage.stage[slot] = Stage::kPrepared;
    pair.normal = PayloadOf(data.inverse ^ mask);
    pair.status = PrepareStatus::kReady;
    pair.length_bytes = x_storage.length_bytes[slot];
    return pair;
}

void Channel::Launch(SlotIndex slot) noexcept
{
    if (x_storage.stage[slot] != Stage::kPrepared)
    {
        return;
    }
    const std::uint32_t srvt_us = SrvtUs(x_storage, slot);
    x_storage.stage[slot] = Stage::kAwaitNormal;
    x_storage.pair_limit[slot] = srvt_us;
    x_storage.pair_left[slot] = srvt_us;
    const SrdoMask by_application = x_storage.marks->started & ~x_storage.marks->provider;
    if ((by_application & BitOf(slot)) != 0U)
    {
        x_storage.phase_left[slot] = AbsenceUs(slot);
    }
}

CanFrame Channel::NextFrame(SlotIndex slot) noexcept
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

SlotIndex Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const SlotIndex slot = LookUp(x_storage, frame);
    if ((frame.kind != FrameKind::kData) || (slot >= x_count))
    {
        return kNoSlot;
    }
    // The identifiers of normal frames are odd, those of inverse frames are even.
    const Awaited awaited = AwaitedIn(x_storage.stage[slot]);
    const bool is_odd = (frame.identifier & 1U) != 0U;
    if ((awaited == Awaited::kNormal) && is_odd)
    {
        return ConfirmNormal(slot, frame, stamp.us - x_last_us);
    }
    if ((awaited == Awaited::kInverse) && (!is_odd))
    {
        return ConfirmInverse(slot, frame, stamp.us - x_last_us);
    }
    return kNoSlot;
}

/// `since_call` is the time from the last OnCycle to the confirmation.
inline SlotIndex Channel::ConfirmNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const std::uint8_t length_bytes = x_storage.length_bytes[slot];
    const std::uint64_t alike = ~(x_storage.inverse_data[slot] ^ PackBytes(&frame.data[0]));
    if (frame.identifier != NormalIdentifier(x_storage, slot))
    {
        return kNoSlot;
    }
    if ((frame.length_bytes != length_bytes) || ((alike & PayloadMask(length_bytes)) != 0U))
    {
        return Fail(slot, SrdoCause::kWrongEcho);
    }
    const std::uint32_t srvt_us = SrvtUs(x_storage, slot);
    x_storage.stage[slot] = Stage::kSendInverse;
    x_storage.pair_limit[slot] = srvt_us;
    x_storage.pair_left[slot] = srvt_us + since_call;
    return slot;
}

inline SlotIndex Channel::ConfirmInverse(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const std::uint8_t length_bytes = x_storage.length_bytes[slot];
    const std::uint64_t different = x_storage.inverse_data[slot] ^ PackBytes(&frame.data[0]);
    if (frame.identifier != InverseIdentifier(x_storage, slot))
    {
        return kNoSlot;
    }
    if ((frame.length_bytes != length_bytes) || ((different & PayloadMask(length_bytes)) != 0U))
    {
        return Fail(slot, SrdoCause::kWrongEcho);
    }
    if ((x_storage.pair_left[slot] - since_call) > x_storage.pair_limit[slot])
    {
        return Fail(slot, SrdoCause::kNoConfirmation);
    }
    x_storage.stage[slot] = Stage::kIdle;
    x_storage.pair_limit[slot] = kNothingRuns;
    x_storage.sent[slot] += 1U;
    return slot;
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
    Marks& marks = *x_storage.marks;
    const SrdoMask bit = BitOf(slot);
    const std::uint32_t refresh_us = SctUs(x_storage, slot);
    const std::uint32_t first_us = kFirstTransmissionStepUs * x_config->node_id;
    const std::uint32_t limit_us = ((marks.started & bit) != 0U) ? refresh_us : first_us;
    if ((x_storage.phase_left[slot] - 1U) < limit_us) // At least one microsecond is left.
    {
        return;
    }
    x_storage.phase_left[slot] += refresh_us;
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
    Marks& marks = *x_storage.marks;
    const SrdoMask bit = BitOf(slot);
    const std::uint32_t absence_us = AbsenceUs(slot);
    if ((marks.started & bit) == 0U)
    {
        const std::uint32_t first_us = kFirstTransmissionStepUs * x_config->node_id;
        if ((x_storage.phase_left[slot] - 1U) < first_us)
        {
            return;
        }
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
SrdoMask Channel::AdvanceProducers(SrdoMask producers, SrdoMask spent) noexcept
{
    Marks& marks = *x_storage.marks;
    SrdoMask in_flight = 0U;
    for (SrdoMask rest = producers; rest != 0U;)
    {
        const SlotIndex slot = TakeLowest(rest);
        x_storage.phase_left[slot] -= ((marks.standing & BitOf(slot)) != 0U) ? 0U : x_elapsed_us;
        if ((spent & BitOf(slot)) != 0U)
        {
            static_cast<void>(Fail(slot, SrdoCause::kNoConfirmation));
        }
        if ((marks.provider & BitOf(slot)) != 0U)
        {
            AdvanceProvider(slot);
        }
        else
        {
            AdvanceApplication(slot);
        }
        in_flight |= static_cast<SrdoMask>(IsInFlight(x_storage, slot)) << slot;
    }
    marks.standing = 0U;
    return producers & ~in_flight & (marks.refresh_due | (marks.requested & marks.started));
}

} // namespace counterpoint::channel_b
