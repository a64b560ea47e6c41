// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/consumer.hpp"

#include "channel_b/slots.hpp"
#include "channel_b/words.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// What remains of a budget that was over when OnCycle saw it: it has been over for as long as a difference of instants
/// can tell.
constexpr std::uint32_t kLongOverUs = std::uint32_t{1U} << 31U;

/// Whether more than the limit of a budget has gone by at an instant so long after the last OnCycle.
[[nodiscard]] bool IsOver(std::uint32_t left, std::uint32_t limit, std::uint32_t since_call_us) noexcept
{
    return (left - since_call_us) > limit;
}

/// Whether all bits that frames have are inverse, and none but mapped ones are set in the normal one. [SRS_CONS_009]
[[nodiscard]] bool IsInverse(std::uint64_t normal, std::uint64_t inverse, std::uint64_t frame_bits,
                             std::uint64_t mapped_bits) noexcept
{
    const std::uint64_t equal = ~(normal ^ inverse);
    const std::uint64_t unmapped = normal & ~mapped_bits;
    return ((equal | unmapped) & frame_bits) == 0U;
}

/// What the inverse objects of a slot are to hold.
[[nodiscard]] std::uint64_t DueData(const Mappings& mappings, SrdoMask committed, SlotIndex slot,
                                    std::uint64_t held) noexcept
{
    return HasAny(committed, BitOf(slot)) ? held : mappings.InverseOfSafe(slot);
}

} // namespace

void Consumers::Restart() noexcept
{
    Enter();
    x_committed = 0U;
    x_missed = 0U;
    x_permitted = 0U;
}

void Consumers::Enter() noexcept
{
    x_active = 0U;
    x_pending = 0U;
    x_fresh = 0U;
    x_unheard = 0U;
    x_troubled = 0U;
    x_released = 0U;
    x_unwritten = 0U;
    x_active_us = 0U;
}

/// [SRS_REL_001, SRS_REL_008]
void Consumers::Admit(SlotIndex slot) noexcept
{
    x_active |= BitOf(slot);
    x_unheard |= BitOf(slot);
    x_pairs.held[slot] = Mark::kUnset;
    x_pairs.granted[slot] = Mark::kUnset;
    x_pairs.edge[slot] = Mark::kUnset;
    x_pairs.ordinal[slot] = 0U;
}

/// [SRS_CONS_019]
SrdoMask Consumers::Leave() noexcept
{
    const SrdoMask left = x_active;
    SlotWalk walk{left};
    while (walk.Next())
    {
        Fault(walk.Slot(), SrdoCause::kNotOperational);
    }
    Enter();
    return left;
}

/// Whether the marks are defined, fit each other, and still say what the last OnCycle decided. [SRS_CONS_024]
bool Consumers::IsSound(SlotIndex slot) const noexcept
{
    if (HasAny(x_released, BitOf(slot)))
    {
        return IsReleased(slot);
    }
    const bool is_held_defined = IsHeld(slot) || (x_pairs.held[slot] == Mark::kUnset);
    return is_held_defined && (x_pairs.granted[slot] == Mark::kUnset);
}

/// [SRS_CONS_024]
SrdoState Consumers::StateOf(SlotIndex slot) const noexcept
{
    if (!IsActive(slot))
    {
        return SrdoState::kOff;
    }
    if (IsReleased(slot))
    {
        return SrdoState::kReleased;
    }
    return HasAny(x_troubled, BitOf(slot)) ? SrdoState::kFaulted : SrdoState::kWaiting;
}

/// Nothing is granted any longer. A pending normal frame stays. [SRS_CONS_012]
void Consumers::Discard(SlotIndex slot) noexcept
{
    const SrdoMask others = ~BitOf(slot);
    x_pairs.held[slot] = Mark::kUnset;
    x_pairs.granted[slot] = Mark::kUnset;
    x_pairs.edge[slot] = Mark::kUnset;
    x_pairs.ordinal[slot] = 0U;
    x_troubled |= BitOf(slot);
    x_fresh &= others;
    x_unheard &= others;
    x_released &= others;
}

/// [SRS_CONS_012]
void Consumers::Fault(SlotIndex slot, SrdoCause cause) noexcept
{
    Discard(slot);
    x_pending &= ~BitOf(slot);
    x_faults.Record(slot, cause);
}

/// [SRS_REL_006]
void Consumers::Demote(SlotIndex slot) noexcept
{
    if (IsActive(slot))
    {
        Discard(slot);
        x_faults.Count(slot, SrdoCause::kDemoted);
    }
}

/// The limit that is over at an instant so long after the last OnCycle. With early detection a pending normal frame has
/// answered SCT. A pair behind a fault that is not told yet has none: nobody waits for it. [SRS_CONS_013, SRS_TIME_003,
/// SRS_TIME_004, SRS_TIME_005, SRS_TIME_006, SRS_TIME_007]
SrdoCause Consumers::ExpiredAt(SlotIndex slot, std::uint32_t since_call_us) const noexcept
{
    const bool is_pending = HasAny(x_pending, BitOf(slot));
    if (is_pending && (x_settings.Detection(slot) != SrvtDetection::kLate))
    {
        const bool is_over = IsOver(x_pairs.srvt_left[slot], x_pairs.srvt_limit[slot], since_call_us);
        return is_over ? SrdoCause::kSrvt : SrdoCause::kNone;
    }
    const bool is_awaited = IsHeld(slot) && (!HasAny(x_faults.Unreported(), BitOf(slot)));
    if (is_awaited && IsOver(x_pairs.left[slot], x_pairs.limit[slot], since_call_us))
    {
        return SrdoCause::kSct;
    }
    return SrdoCause::kNone;
}

/// With late detection an inverse frame asks for SRVT as well. Where both limits are over it is the one with the
/// earlier deadline, at a tie SRVT. [SRS_TIME_008, SRS_TIME_009]
SrdoCause Consumers::ExpiredAtInverse(SlotIndex slot, std::uint32_t since_call_us) const noexcept
{
    const SrdoCause expired = ExpiredAt(slot, since_call_us);
    if (HasAny(x_pending, BitOf(slot)) && IsOver(x_pairs.srvt_left[slot], x_pairs.srvt_limit[slot], since_call_us))
    {
        const std::uint32_t sct_overdue = since_call_us - x_pairs.left[slot];
        const std::uint32_t srvt_overdue = since_call_us - x_pairs.srvt_left[slot];
        const bool is_sct_earlier = (expired == SrdoCause::kSct) && (sct_overdue > srvt_overdue);
        return is_sct_earlier ? SrdoCause::kSct : SrdoCause::kSrvt;
    }
    return expired;
}

// ---- frames

/// The first thing that is wrong with a normal frame. [SRS_CONS_004, SRS_CONS_005, SRS_CONS_007, SRS_CONS_011]
SrdoCause Consumers::FlawOfNormal(SlotIndex slot, const CanFrame& frame) const noexcept
{
    if ((frame.identifier != x_settings.NormalIdentifier(slot)) || (frame.port != x_settings.Config().normal_port))
    {
        return SrdoCause::kIdentifier;
    }
    if (frame.length_bytes != x_mappings.LengthBytes(slot))
    {
        return SrdoCause::kLength;
    }
    return HasAny(x_pending, BitOf(slot)) ? SrdoCause::kNormalTwice : SrdoCause::kNone;
}

/// The first thing that is wrong with an inverse frame, but for its data. [SRS_CONS_004, SRS_CONS_005, SRS_CONS_008,
/// SRS_CONS_011]
SrdoCause Consumers::FlawOfInverse(SlotIndex slot, const CanFrame& frame) const noexcept
{
    if ((frame.identifier != x_settings.InverseIdentifier(slot)) || (frame.port != x_settings.Config().inverse_port))
    {
        return SrdoCause::kIdentifier;
    }
    if (frame.length_bytes != x_mappings.LengthBytes(slot))
    {
        return SrdoCause::kLength;
    }
    return HasAny(x_pending, BitOf(slot)) ? SrdoCause::kNone : SrdoCause::kInverseFirst;
}

/// A limit that is over discards what was there before the frame, which is then taken as the first one.
/// [SRS_CONS_003, SRS_CONS_006, SRS_CONS_007, SRS_CONS_011]
void Consumers::TakeNormal(SlotIndex slot, const CanFrame& frame, std::uint64_t data,
                           std::uint32_t since_call_us) noexcept
{
    const SrdoCause expired = ExpiredAt(slot, since_call_us);
    if (expired != SrdoCause::kNone)
    {
        Fault(slot, expired);
    }
    const SrdoCause flaw = FlawOfNormal(slot, frame);
    if (flaw != SrdoCause::kNone)
    {
        Fault(slot, flaw);
        return;
    }
    x_pending |= BitOf(slot);
    x_pairs.pending[slot] = data;
    // The next OnCycle takes away what lay between the last one and the frame.
    x_pairs.srvt_left[slot] = x_pairs.srvt_limit[slot] + since_call_us;
}

/// [SRS_CONS_003, SRS_CONS_008, SRS_CONS_009, SRS_CONS_010, SRS_CONS_011]
void Consumers::TakeInverse(SlotIndex slot, const CanFrame& frame, std::uint64_t data,
                            std::uint32_t since_call_us) noexcept
{
    const SrdoMask bit = BitOf(slot);
    const SrdoCause expired = ExpiredAtInverse(slot, since_call_us);
    if (expired != SrdoCause::kNone)
    {
        Fault(slot, expired);
    }
    SrdoCause flaw = FlawOfInverse(slot, frame);
    if ((flaw == SrdoCause::kNone) &&
        (!IsInverse(x_pairs.pending[slot], data, LowBytes(frame.length_bytes), x_mappings.MappedBits(slot))))
    {
        flaw = SrdoCause::kNotInverse;
    }
    if (flaw != SrdoCause::kNone)
    {
        Fault(slot, flaw);
        return;
    }
    // Both limits count from the normal frame, so that the greater one has the difference more left.
    x_pairs.left[slot] = x_pairs.srvt_left[slot] + (x_pairs.limit[slot] - x_pairs.srvt_limit[slot]);
    x_pairs.held[slot] = Mark::kHeld;
    x_pairs.data[slot] = data;
    x_pairs.ordinal[slot] += 1U;
    x_pending &= ~bit;
    x_unheard &= ~bit;
    x_fresh |= bit;
    x_unwritten |= bit;
}

// ---- the cycle

/// The budgets beside that of SCT, as far as they run. SRVT that is over stays over, however long nobody asks for it.
void Consumers::SpendOthers(SlotIndex slot, std::uint32_t elapsed_us) noexcept
{
    x_pairs.srvt_left[slot] -= elapsed_us;
    x_pairs.phase_left[slot] -= elapsed_us;
    if (x_pairs.srvt_left[slot] > x_pairs.srvt_limit[slot])
    {
        x_pairs.srvt_left[slot] = kLongOverUs;
    }
    if (x_pairs.phase_left[slot] > x_settings.Config().acknowledge_window_us)
    {
        x_pairs.edge[slot] = Mark::kUnset;
    }
}

/// Faults of this call, in their order. [SRS_CONS_014, SRS_CONS_015, SRS_CONS_016, SRS_CONS_017, SRS_CONS_018,
/// SRS_CONS_024]
void Consumers::Examine(SlotIndex slot, const Tick& tick) noexcept
{
    if (!IsSound(slot))
    {
        Fault(slot, SrdoCause::kInvalid);
    }
    const SrdoCause expired = ExpiredAt(slot, 0U);
    if (expired != SrdoCause::kNone)
    {
        Fault(slot, expired);
    }
    else if (tick.is_late)
    {
        Fault(slot, SrdoCause::kLateCall);
    }
    else
    {
        // In time.
    }
    if (tick.is_overflowed)
    {
        Fault(slot, SrdoCause::kQueueOverflow);
    }
    if (tick.is_gfc)
    {
        Fault(slot, SrdoCause::kGfc);
    }
}

/// Whether the slot is released now. [SRS_REL_003, SRS_REL_004, SRS_REL_007]
bool Consumers::Grant(SlotIndex slot) noexcept
{
    const bool is_acknowledged = x_pairs.edge[slot] == Mark::kWaits;
    const bool is_permitted = is_acknowledged || (x_settings.Policy(slot) == ReleasePolicy::kAutomatic);
    if (IsHeld(slot) && is_permitted)
    {
        x_pairs.granted[slot] = Mark::kGranted;
    }
    const bool is_released = IsReleased(slot);
    if (is_acknowledged && is_released)
    {
        x_faults.Forget(slot);
        x_pairs.edge[slot] = Mark::kUnset;
    }
    return is_released;
}

/// Where there is more to do than to take the time of SCT; whether the slot is released. [SRS_CONS_013, SRS_CONS_022,
/// SRS_REL_005]
bool Consumers::ServeBusy(SlotIndex slot, const Tick& tick, CycleOutcome& outcome) noexcept
{
    const SrdoMask bit = BitOf(slot);
    SpendOthers(slot, tick.elapsed_us);
    Examine(slot, tick);
    if (HasAny(x_faults.Unreported(), bit))
    {
        Discard(slot); // A pair completed after the fault, before it was reported.
        outcome.new_fault |= bit;
    }
    else if (HasAny(tick.edges, bit))
    {
        x_pairs.edge[slot] = Mark::kWaits;
        x_pairs.phase_left[slot] = x_settings.Config().acknowledge_window_us;
    }
    else
    {
        // Nothing new.
    }
    if (HasAny(x_unheard, bit) && (x_active_us > x_pairs.limit[slot]))
    {
        x_unheard &= ~bit;
        x_faults.Complain(slot, SrdoCause::kWaitingPastSct);
    }
    return Grant(slot);
}

/// Takes the time from the budgets of SCT of `quiet` consumers. Settled is what its marks release, within its SCT and
/// without a cause to be told of: it stays released. [SRS_CONS_014]
SrdoMask Consumers::Settle(SrdoMask quiet, std::uint32_t elapsed_us, CycleOutcome& outcome) noexcept
{
    SrdoMask settled = 0U;
    std::uint32_t ordinal_sum = 0U;
    std::uint32_t count = 0U;
    SlotWalk walk{quiet};
    while (walk.Next())
    {
        const SlotIndex slot = walk.Slot();
        const std::uint32_t left = x_pairs.left[slot] - elapsed_us;
        x_pairs.left[slot] = left;
        const bool is_granted = IsHeld(slot) && (x_pairs.granted[slot] == Mark::kGranted);
        if (is_granted && (left <= x_pairs.limit[slot]) && (x_faults.FirstCause(slot) == SrdoCause::kNone))
        {
            settled |= BitOf(slot);
            ordinal_sum += x_pairs.ordinal[slot];
            ++count;
        }
    }
    outcome.ordinal_sum = ordinal_sum;
    outcome.sct_checked = static_cast<std::uint8_t>(count);
    return settled;
}

/// [SRS_CONS_023, SRS_REL_010]
void Consumers::Serve(const Tick& tick, CycleOutcome& outcome) noexcept
{
    const bool is_alarm = tick.is_late || tick.is_overflowed || tick.is_gfc;
    const SrdoMask news = is_alarm ? x_active : (x_pending | x_faults.Unreported() | tick.edges);
    const SrdoMask quiet = x_active & ~news;
    SrdoMask released = Settle(quiet, tick.elapsed_us, outcome);
    x_active_us += tick.elapsed_us;
    SlotWalk walk{x_active & ~released};
    while (walk.Next())
    {
        const SlotIndex slot = walk.Slot();
        if (!HasAny(quiet, BitOf(slot)))
        {
            x_pairs.left[slot] -= tick.elapsed_us;
        }
        if (ServeBusy(slot, tick, outcome))
        {
            released |= BitOf(slot);
        }
        outcome.ordinal_sum += x_pairs.ordinal[slot];
        outcome.sct_checked = static_cast<std::uint8_t>(outcome.sct_checked + 1U);
    }
    x_released = released;
    x_permitted = 0U; // Until the next Commit.
    outcome.released = released;
    outcome.faulted = x_active & x_troubled & ~released;
    outcome.waiting = x_active & ~(x_troubled | released);
    outcome.fresh = x_fresh;
    x_fresh = 0U;
}

// ---- objects

/// [SRS_REL_002, SRS_REL_012]
void Consumers::SetUp(SlotIndex slot) noexcept
{
    const SrdoMask bit = BitOf(slot);
    x_committed &= ~bit;
    if (x_settings.Direction(slot) == kDirectionConsumer)
    {
        const std::uint64_t safe = x_mappings.InverseOfSafe(slot);
        x_mappings.WriteInverse(slot, safe);
        if (!x_mappings.HoldsInverse(slot, safe))
        {
            x_missed |= bit;
        }
    }
}

/// Nothing is read before everything is written. [SRS_REL_002, SRS_REL_010, SRS_REL_011, SRS_REL_012]
SrdoMask Consumers::Commit(const Agreement& agreement, SrdoMask examine) noexcept
{
    const SrdoMask released = agreement.agreed & x_released;
    const SrdoMask written = released & agreement.matched & x_unwritten;
    const SrdoMask changed = written | (x_committed & ~released);
    SrdoMask wrong = x_missed;
    x_missed = 0U;
    x_unwritten &= ~written;
    x_committed = (x_committed & released) | written;
    SlotWalk writing{changed};
    while (writing.Next())
    {
        const SlotIndex slot = writing.Slot();
        x_mappings.WriteInverse(slot, DueData(x_mappings, x_committed, slot, x_pairs.data[slot]));
    }
    SlotWalk reading{changed | (examine & x_committed & ~x_unwritten)};
    while (reading.Next())
    {
        const SlotIndex slot = reading.Slot();
        if (!x_mappings.HoldsInverse(slot, DueData(x_mappings, x_committed, slot, x_pairs.data[slot])))
        {
            wrong |= BitOf(slot);
        }
    }
    x_permitted = x_committed & ~wrong;
    return wrong;
}

} // namespace counterpoint::channel_b
