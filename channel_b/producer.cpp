// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/producer.hpp"

#include "channel_b/slots.hpp"
#include "channel_b/words.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// No phase lasts 2^27 us, 134 s: one microsecond less than 0 is far above.
constexpr std::uint32_t kLongestPhaseUs = std::uint32_t{1U} << 27U;

/// [SRS_PROD_005, SRS_PROD_006, SRS_CFG_036]
[[nodiscard]] CanFrame FrameOf(std::uint32_t identifier, CanPortId port, std::uint8_t length_bytes,
                               std::uint64_t data) noexcept
{
    CanFrame frame{identifier, FrameKind::kData, port, length_bytes, {}};
    Unpack(data, {&frame.data[0U]}, kMaxPayloadBits);
    return frame;
}

/// Not one microsecond is left.
[[nodiscard]] bool IsPhaseOver(std::uint32_t phase_left_us) noexcept
{
    return (phase_left_us - 1U) >= kLongestPhaseUs;
}

constexpr CanFrame kNoFrame{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}};
constexpr Confirmation kNothingConfirmed{kNoSlot, ConfirmStep::kNone};

} // namespace

/// [SRS_PROD_011]
void Producers::Clear() noexcept
{
    x_active = 0U;
    x_started = 0U;
    x_requested = 0U;
    x_refresh_due = 0U;
    x_silent = 0U;
}

/// [SRS_PROD_001]
void Producers::Admit(SlotIndex slot) noexcept
{
    x_active |= BitOf(slot);
    x_pairs.ordinal[slot] = 0U;
    x_pairs.phase_left[slot] = kFirstTransmissionStepUs * x_settings.Config().node_id;
    x_pairs.stage[slot] = Stage::kIdle;
}

/// [SRS_PROD_005, SRS_PROD_006]
PreparedPair Producers::Prepare(SlotIndex slot) noexcept
{
    if ((!IsActive(slot)) || (x_pairs.stage[slot] != Stage::kIdle))
    {
        return PreparedPair{kNoFrame, PrepareStatus::kNotProducer};
    }
    const SrdoMask bit = BitOf(slot);
    const std::uint64_t data = ~x_mappings.ReadInverse(slot) & x_mappings.MappedBits(slot);
    x_pairs.data[slot] = data;
    x_pairs.stage[slot] = Stage::kNormal;
    x_pairs.left[slot] = x_pairs.limit[slot];
    if (HasAny(x_silent, bit))
    {
        x_pairs.phase_left[slot] = SilenceUs(slot);
    }
    x_requested &= ~bit;
    x_refresh_due &= ~bit;
    return PreparedPair{
        FrameOf(x_settings.NormalIdentifier(slot), x_settings.Config().normal_port, x_mappings.LengthBytes(slot), data),
        PrepareStatus::kReady};
}

/// [SRS_PROD_006]
CanFrame Producers::InverseFrame(SlotIndex slot) const noexcept
{
    if ((!IsActive(slot)) || (x_pairs.stage[slot] != Stage::kInverse))
    {
        return kNoFrame;
    }
    return FrameOf(x_settings.InverseIdentifier(slot), x_settings.Config().inverse_port, x_mappings.LengthBytes(slot),
                   InverseData(slot));
}

/// What is wrong with a frame that should have had this data: a wrong echo, or a confirmation that is too late.
/// [SRS_PROD_007, SRS_PROD_008]
SrdoCause Producers::FlawOf(SlotIndex slot, const CanFrame& frame, std::uint64_t data,
                            std::uint32_t since_call_us) const noexcept
{
    const bool is_length_right = frame.length_bytes == x_mappings.LengthBytes(slot);
    if ((!is_length_right) || ((FrameWord(frame) & LowBytes(frame.length_bytes)) != data))
    {
        return SrdoCause::kWrongEcho;
    }
    const bool is_over = (x_pairs.left[slot] - since_call_us) > x_pairs.limit[slot];
    return is_over ? SrdoCause::kNoConfirmation : SrdoCause::kNone;
}

/// The inverse frame is awaited now, with SRVT anew. [SRS_PROD_007]
Confirmation Producers::ConfirmNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call_us) noexcept
{
    if (frame.identifier != x_settings.NormalIdentifier(slot))
    {
        return kNothingConfirmed;
    }
    const SrdoCause flaw = FlawOf(slot, frame, x_pairs.data[slot], since_call_us);
    if (flaw != SrdoCause::kNone)
    {
        Fail(slot, flaw);
        return kNothingConfirmed;
    }
    x_pairs.stage[slot] = Stage::kInverse;
    x_pairs.left[slot] = x_pairs.limit[slot] + since_call_us;
    return Confirmation{slot, ConfirmStep::kNormal};
}

/// The pair was sent. [SRS_PROD_007]
Confirmation Producers::ConfirmInverse(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call_us) noexcept
{
    if (frame.identifier != x_settings.InverseIdentifier(slot))
    {
        return kNothingConfirmed;
    }
    const SrdoCause flaw = FlawOf(slot, frame, InverseData(slot), since_call_us);
    if (flaw != SrdoCause::kNone)
    {
        Fail(slot, flaw);
        return kNothingConfirmed;
    }
    x_pairs.ordinal[slot] += 1U;
    x_pairs.stage[slot] = Stage::kIdle;
    return Confirmation{slot, ConfirmStep::kPair};
}

/// A stage that is none awaits nothing.
Confirmation Producers::OnConfirm(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call_us) noexcept
{
    if (IsActive(slot))
    {
        switch (x_pairs.stage[slot])
        {
        case Stage::kNormal:
            return ConfirmNormal(slot, frame, since_call_us);
        case Stage::kInverse:
            return ConfirmInverse(slot, frame, since_call_us);
        case Stage::kIdle:
            break;
        }
    }
    return kNothingConfirmed;
}

/// What the controllers tell of a transmission, and what the other channel found where this one found nothing.
/// [SRS_PROD_009]
void Producers::OnTransmitFault(SlotIndex slot, SrdoCause cause) noexcept
{
    const bool is_of_bus = (cause == SrdoCause::kTransmitQueue) || (cause == SrdoCause::kBusOff);
    const bool is_of_both = (cause == SrdoCause::kNotInverse) || (cause == SrdoCause::kNoConfirmation);
    if ((is_of_bus || is_of_both) && IsInFlight(slot))
    {
        Fail(slot, cause);
    }
}

// ---- the cycle

/// The refresh falls due at exact distances, whenever the calls come and whatever is in flight. One that falls due
/// behind one that waits is skipped. [SRS_PROD_001, SRS_PROD_002, SRS_PROD_010, SRS_PROD_013]
void Producers::AdvanceProvider(SlotIndex slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    x_pairs.phase_left[slot] += x_settings.SctUs(slot);
    x_started |= bit;
    if (HasAny(x_refresh_due, bit))
    {
        x_faults.Record(slot, SrdoCause::kRefreshMissed);
    }
    else
    {
        x_refresh_due |= bit;
    }
}

/// Silence counts from the instant of the first possible transmission, not from the call that sees it. A request that
/// waits is no silence; that of this call is not among them yet. [SRS_PROD_001, SRS_PROD_010]
void Producers::AdvanceApplication(SlotIndex slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    const std::uint32_t silence_us = SilenceUs(slot);
    if (!HasAny(x_started, bit))
    {
        x_started |= bit;
        x_silent |= bit;
        x_pairs.phase_left[slot] += silence_us;
    }
    if (x_pairs.phase_left[slot] <= silence_us)
    {
        return;
    }
    if (HasAny(x_requested, bit))
    {
        x_pairs.phase_left[slot] = ~std::uint32_t{0U}; // However long the request waits: just over.
    }
    else
    {
        x_faults.Record(slot, SrdoCause::kRefreshMissed);
        x_pairs.phase_left[slot] = silence_us;
    }
}

/// [SRS_PROD_008, SRS_PROD_009]
void Producers::SpendConfirmation(SlotIndex slot, std::uint32_t elapsed_us) noexcept
{
    x_pairs.left[slot] -= elapsed_us;
    if (x_pairs.left[slot] > x_pairs.limit[slot])
    {
        Fail(slot, SrdoCause::kNoConfirmation);
    }
}

/// [SRS_PROD_010]
void Producers::SpendPhase(SlotIndex slot, std::uint32_t elapsed_us) noexcept
{
    x_pairs.phase_left[slot] -= elapsed_us;
    if (IsPhaseOver(x_pairs.phase_left[slot]))
    {
        if (IsProvider(slot))
        {
            AdvanceProvider(slot);
        }
        else
        {
            AdvanceApplication(slot);
        }
    }
}

/// A refresh is told while it waits, what is due not while a pair is in flight. A phase that stands is left as it is,
/// so that it moves on by this call's time. The requests of this call count behind the silence. [SRS_PROD_003,
/// SRS_PROD_004, SRS_PROD_009, SRS_PROD_012, SRS_PROD_013]
void Producers::Serve(const Tick& tick, CycleOutcome& outcome) noexcept
{
    if (x_active == 0U)
    {
        return;
    }
    const SrdoMask standing = tick.stand & x_started;
    SrdoMask in_flight = 0U;
    std::uint32_t count = 0U;
    SlotWalk walk{x_active};
    while (walk.Next())
    {
        const SlotIndex slot = walk.Slot();
        if (x_pairs.stage[slot] != Stage::kIdle)
        {
            SpendConfirmation(slot, tick.elapsed_us);
        }
        if (!HasAny(standing, BitOf(slot)))
        {
            SpendPhase(slot, tick.elapsed_us);
        }
        if (x_pairs.stage[slot] != Stage::kIdle)
        {
            in_flight |= BitOf(slot);
        }
        ++count;
    }
    SlotWalk acknowledged{tick.edges & x_active & ~x_faults.Unreported()};
    while (acknowledged.Next())
    {
        x_faults.Forget(acknowledged.Slot());
    }
    x_requested |= tick.requests & x_active;
    outcome.refresh = x_refresh_due;
    outcome.due = (x_refresh_due | (x_requested & x_started)) & ~in_flight;
    outcome.is_tx = static_cast<std::uint8_t>(count);
}

} // namespace counterpoint::channel_b
