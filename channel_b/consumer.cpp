// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/channel.hpp"
#include "channel_b/image.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

constexpr std::uint32_t kWaitingBit = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);

/// Any other first cause is corrupted, or was put there because something else was. [SRS_CONS_024]
[[nodiscard]] bool IsRecordable(std::uint32_t cause) noexcept
{
    return ((cause - 1U) < Code(SrdoCause::kWrongEcho)) || (cause == Code(SrdoCause::kNone));
}

/// Whether the marks of a consumer fit each other. [SRS_CONS_024]
[[nodiscard]] bool IsSound(const Row& row) noexcept
{
    if (row.standing == Standing::kReleased)
    {
        return IsHeld(row) && IsRecordable(row.first_cause);
    }
    const bool is_defined = (row.standing == Standing::kWaiting) || (row.standing == Standing::kFaulted);
    return is_defined && (IsHeld(row) || (row.held == kUnset));
}

/// The limit that is over at an instant so long after the last OnCycle: where both are the one with the earlier
/// deadline, which is further below zero, and at a tie SRVT. [SRS_TIME_008, SRS_TIME_009]
[[nodiscard]] SrdoCause ExpiredAt(const Row& row, std::uint32_t since_call, bool is_srvt_examined) noexcept
{
    const std::uint32_t sct_left = row.left - since_call;
    const std::uint32_t srvt_left = row.srvt_left - since_call;
    const bool is_sct_over = sct_left > row.limit;
    if (is_srvt_examined && (srvt_left > row.srvt_limit))
    {
        return (is_sct_over && (sct_left < srvt_left)) ? SrdoCause::kSct : SrdoCause::kSrvt;
    }
    return is_sct_over ? SrdoCause::kSct : SrdoCause::kNone;
}

} // namespace

/// A fault between two calls of OnCycle.
void Channel::Reject(SlotIndex slot, SrdoCause cause) noexcept
{
    x_released[slot / kSlotsInHalf] &= ~BitOf(slot);
    Fault(x_storage.rows[slot], cause);
}

/// First half of a pair. With early detection it has answered SCT. [SRS_CONS_006, SRS_TIME_007]
[[gnu::always_inline]] inline void Channel::TakeNormal(SlotIndex slot, const CanFrame& frame,
                                                       std::uint32_t since_call) noexcept
{
    Row& row = x_storage.rows[slot];
    if (HasNews(row, kPending))
    {
        Reject(slot, SrdoCause::kNormalTwice);
        return;
    }
    SetNews(row, kPending);
    row.pending_data = PackBytes(&frame.data[0]);
    row.srvt_limit = SrvtUs(row);
    row.srvt_left = row.srvt_limit + since_call; // The next OnCycle takes away what lay before the frame.
    if (row.detection != SrvtDetection::kLate)
    {
        row.limit = kNothingRuns;
    }
}

/// [SRS_CONS_008, SRS_CONS_009, SRS_CONS_010]
[[gnu::always_inline]] inline void Channel::TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept
{
    Row& row = x_storage.rows[slot];
    if (!HasNews(row, kPending))
    {
        Reject(slot, SrdoCause::kInverseFirst);
        return;
    }
    const std::uint64_t normal = row.pending_data;
    const std::uint64_t inverse = PackBytes(&frame.data[0]);
    const std::uint64_t alike = ~(normal ^ inverse) & row.mask; // Behind the length anything may be.
    if ((alike | (normal & row.spare)) != 0U)
    {
        Reject(slot, SrdoCause::kNotInverse);
        return;
    }
    // Both limits count from the normal frame, so that the greater one has the difference more left.
    row.limit = SctUs(row);
    row.left = row.srvt_left + (row.limit - row.srvt_limit);
    row.srvt_limit = kNothingRuns;
    SetNews(row, kFresh);
    ClearNews(row, kPending | kUnheard);
    row.held = kHeld;
    row.inverse_data = inverse;
    row.ordinal += 1U;
    x_unwritten[slot / kSlotsInHalf] |= BitOf(slot);
}

/// The checks are made in the order of SRS_CONS_011.
void Channel::TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const Row& row = x_storage.rows[slot];
    const std::uint32_t parity = frame.identifier & 1U;
    if ((frame.identifier != OwnIdentifier(row, parity)) || (frame.port != x_port[parity])) // MISRA D-002
    {
        Reject(slot, SrdoCause::kIdentifier);
        return;
    }
    if (frame.length_bytes != row.awaited.length_bytes)
    {
        Reject(slot, SrdoCause::kLength);
        return;
    }
    if (parity != 0U)
    {
        TakeNormal(slot, frame, since_call);
        return;
    }
    TakeInverse(slot, frame);
}

/// A limit that is over discards what was there before the frame, which is then taken as the first one.
/// [SRS_CONS_003, SRS_CONS_012]
void Channel::TakeLate(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept
{
    const Row& row = x_storage.rows[slot];
    const bool is_inverse = (frame.identifier & 1U) == 0U;
    const SrdoCause expired = ExpiredAt(row, since_call, is_inverse || (row.detection != SrvtDetection::kLate));
    if (expired != SrdoCause::kNone)
    {
        Reject(slot, expired);
    }
    TakeFrame(slot, frame, since_call);
}

void Channel::OnFrame(const CanFrame& frame, Instant stamp) noexcept
{
    const std::uint32_t offset = frame.identifier - kFirstSrdoIdentifier;
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    if (offset >= kSrdoIdentifierCount)
    {
        // Global fail-safe command. [SRS_CONS_017]
        const bool is_accepted = x_storage.device[kGfcParameterAt] == 1U;
        if ((frame.identifier == kGfcIdentifier) && (frame.length_bytes == 0U) && is_accepted)
        {
            x_alarms |= x_running & kGfc;
        }
        return;
    }
    const SlotIndex slot = x_storage.slot_of[offset];
    if ((slot >= x_count) || (!IsConsumer(x_storage.rows[slot])))
    {
        return; // Nobody's, or a producer's own.
    }
    const Row& row = x_storage.rows[slot];
    // From the last OnCycle to the frame, modular, so that it may be before that call as well.
    const std::uint32_t since_call = stamp.us - x_last_us;
    if (((row.left - since_call) > row.limit) || ((row.srvt_left - since_call) > row.srvt_limit))
    {
        TakeLate(slot, frame, since_call);
        return;
    }
    TakeFrame(slot, frame, since_call);
}

void Channel::Demote(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if (!IsConsumer(row))
    {
        return;
    }
    x_released[slot / kSlotsInHalf] &= ~BitOf(slot);
    Discard(row);
    Count(row, SrdoCause::kDemoted);
}

/// [SRS_CONS_013, SRS_CONS_014, SRS_CONS_015, SRS_CONS_016, SRS_CONS_017, SRS_CONS_018, SRS_CONS_022, SRS_REL_003,
/// SRS_REL_004, SRS_REL_005, SRS_REL_007]
void Channel::ServeConsumer(Row& row, Half& half) const noexcept
{
    if (!IsSound(row))
    {
        Fault(row, SrdoCause::kInvalid);
    }
    const SrdoCause expired = ExpiredAt(row, 0U, row.detection != SrvtDetection::kLate);
    if (expired != SrdoCause::kNone)
    {
        Fault(row, expired);
    }
    else if ((x_alarms & kLate) != 0U)
    {
        Fault(row, SrdoCause::kLateCall);
    }
    else
    {
        // In time.
    }
    if ((x_alarms & kOverflowed) != 0U)
    {
        Fault(row, SrdoCause::kQueueOverflow);
    }
    if ((x_alarms & kGfc) != 0U)
    {
        Fault(row, SrdoCause::kGfc);
    }
    if (row.phase_left > x_config->acknowledge_window_us)
    {
        ForgetEdge(row);
    }
    if (row.causes != 0U)
    {
        Discard(row); // A pair completed after the fault, before it was reported.
        half.new_fault |= half.bit;
    }
    else if ((half.edges & half.bit) != 0U)
    {
        row.edge = kWaits;
        row.phase_left = x_config->acknowledge_window_us;
        SetNews(row, kEdge);
    }
    else
    {
        // Nothing new.
    }
    if (HasNews(row, kUnheard) && (x_active_us > SctUs(row)))
    {
        ClearNews(row, kUnheard);
        row.causes |= kWaitingBit;
    }
    Release(row, half);
}

/// What has a fault to report holds no pair any longer. [SRS_REL_003, SRS_REL_004, SRS_REL_007]
void Channel::Release(Row& row, Half& half) const noexcept
{
    const bool is_acknowledged = row.edge == kWaits;
    const bool is_permitted = is_acknowledged || (row.policy == ReleasePolicy::kAutomatic);
    if (IsHeld(row) && is_permitted && IsRecordable(row.first_cause))
    {
        row.standing = Standing::kReleased;
    }
    if (row.standing == Standing::kReleased)
    {
        half.released |= half.bit;
        if (is_acknowledged)
        {
            row.first_cause = Code(SrdoCause::kNone);
            ForgetEdge(row);
        }
    }
    else if (row.standing == Standing::kFaulted)
    {
        half.faulted |= half.bit;
    }
    else
    {
        half.waiting |= half.bit;
    }
    if (HasNews(row, kFresh) && IsHeld(row))
    {
        half.fresh |= half.bit;
    }
    ClearNews(row, kFresh);
    half.consumers += 1U;
    half.ordinal_sum += row.ordinal;
}

/// [SRS_REL_002]
void Channel::Commit(const Agreement& agreement) noexcept
{
    for (std::uint8_t half = 0U; half < kHalves; ++half)
    {
        const HalfMask committed = x_committed[half]; // MISRA D-002
        const HalfMask released = PartOf(agreement.agreed, half) & x_released[half];
        const HalfMask written = PartOf(agreement.matched, half) & released & x_unwritten[half];
        x_unwritten[half] &= ~written;
        x_committed[half] = (committed & released) | written;
        for (HalfMask rest = written | (committed & ~released); rest != 0U; rest = WithoutLowest(rest))
        {
            const SlotIndex slot = static_cast<SlotIndex>(LowestOf(rest) + (half * kSlotsInHalf));
            if ((written & BitOf(slot)) != 0U)
            {
                WriteInverse(slot, x_storage.rows[slot].inverse_data);
            }
            else
            {
                WriteSafe(slot);
            }
        }
    }
}

} // namespace counterpoint::channel_b
