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
/// No phase and no refresh lasts longer: 2^27 us are 134 s. What is above is below zero.
constexpr std::uint32_t kLongestPhase = 0x07FFFFFFU;

constexpr CanFrame kNoFrame{0U, FrameKind::kInvalid, CanPortId::kInvalid, 0U, {}};

} // namespace

/// [SRS-PROD-005]
PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if ((row.standing != Standing::kProducer) || IsInFlight(row))
    {
        return PreparedPair{kNoFrame, PrepareStatus::kNotProducer};
    }
    UnpackBytes(~ReadInverse(slot) & row.mask & ~row.spare, &row.awaited.data[0]);
    row.awaited.identifier = WordAt(row, kCobId1At);
    row.awaited.kind = FrameKind::kData;
    row.awaited.port = x_port[1U];
    row.awaited.length_bytes = row.length_bytes;
    row.left = SrvtUs(row);
    row.limit = row.left;
    ClearNews(row, kRequested | kRefreshDue);
    if (HasNews(row, kStarted) && (row.form != ProducerForm::kProviderCalled))
    {
        row.phase_left = SctUs(row) + x_late_us;
    }
    return PreparedPair{row.awaited, PrepareStatus::kReady};
}

CanFrame Channel::InverseFrame(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if (row.to_send != kToSend)
    {
        return kNoFrame;
    }
    row.to_send = kUnset;
    return row.awaited;
}

/// One way for both frames of a pair; behind the length anything may be. [SRS-PROD-007, SRS-PROD-008]
Confirmation Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const SlotIndex slot = LookUp(x_storage, frame);
    if ((slot >= x_count) || (frame.kind != FrameKind::kData))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    Row& row = x_storage.rows[slot];
    const std::uint32_t parity = frame.identifier & 1U;
    if ((frame.identifier != row.awaited.identifier) || (frame.identifier != OwnIdentifier(row, parity)))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    const std::uint64_t data = PackBytes(&row.awaited.data[0]);
    const std::uint64_t different = (PackBytes(&frame.data[0]) ^ data) & row.mask;
    if ((different != 0U) || (frame.length_bytes != row.awaited.length_bytes))
    {
        return Fail(row, SrdoCause::kWrongEcho);
    }
    const std::uint32_t since_call = stamp.us - x_last_us;
    if (parity != 0U)
    {
        UnpackBytes(~data & row.mask, &row.awaited.data[0]);
        row.left = row.limit + since_call; // SRVT anew.
        row.awaited.identifier = OwnIdentifier(row, 0U);
        row.awaited.port = x_port[0U];
        row.to_send = kToSend;
        return Confirmation{slot, ConfirmStep::kNormal};
    }
    if ((row.left - since_call) > row.limit)
    {
        return Fail(row, SrdoCause::kNoConfirmation);
    }
    row.ordinal += 1U;
    Ground(row);
    return Confirmation{slot, ConfirmStep::kPair};
}

void Channel::OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept
{
    const bool is_of_bus = (fault.cause == SrdoCause::kTransmitQueue) || (fault.cause == SrdoCause::kBusOff);
    const bool is_transmit_fault = is_of_bus || (fault.cause == SrdoCause::kNotInverse);
    Row& row = x_storage.rows[slot];
    if (is_transmit_fault && IsInFlight(row))
    {
        static_cast<void>(Fail(row, fault.cause));
    }
}

/// The refresh falls due at exact distances, whenever the calls come. [SRS-PROD-001, SRS-PROD-002]
void Channel::AdvanceProvider(Row& row) const noexcept
{
    row.phase_left += SctUs(row);
    SetNews(row, kStarted);
    if (IsInFlight(row) || HasNews(row, kRefreshDue))
    {
        Record(row, SrdoCause::kRefreshMissed);
    }
    else
    {
        SetNews(row, kRefreshDue);
    }
}

/// Silence is allowed for the refresh time and a cycle that is just in time. [SRS-PROD-001, SRS-PROD-010]
void Channel::AdvanceApplication(Row& row) const noexcept
{
    const std::uint32_t absence_us = SctUs(row) + x_late_us;
    if (!HasNews(row, kStarted))
    {
        SetNews(row, kStarted);
        row.phase_left += absence_us; // Silence counts from the instant, not from this call.
    }
    if (row.phase_left <= absence_us)
    {
        return;
    }
    if (HasNews(row, kRequested))
    {
        row.phase_left = kJustSpent; // However long the request waits, the budget must not wrap.
    }
    else
    {
        Record(row, SrdoCause::kRefreshMissed);
        row.phase_left = absence_us;
    }
}

/// [SRS-PROD-003, SRS-PROD-004, SRS-PROD-008, SRS-PROD-010, SRS-PROD-012]
void Channel::ServeProducer(Row& row, Half& half) const noexcept
{
    const bool is_provider = row.form == ProducerForm::kProviderCalled;
    half.producers += 1U;
    if (row.left > row.limit)
    {
        static_cast<void>(Fail(row, SrdoCause::kNoConfirmation));
    }
    if ((half.requests & half.bit) != 0U)
    {
        SetNews(row, kRequested);
    }
    if (((half.stand & half.bit) != 0U) && is_provider && HasNews(row, kStarted))
    {
        row.phase_left += x_elapsed_us;
    }
    if ((row.phase_left - 1U) > kLongestPhase) // Not one microsecond is left.
    {
        if (is_provider)
        {
            AdvanceProvider(row);
        }
        else
        {
            AdvanceApplication(row);
        }
    }
    if (((half.edges & half.bit) != 0U) && (row.causes == 0U))
    {
        row.first_cause = Code(SrdoCause::kNone);
    }
    const bool is_requested = HasNews(row, kRequested) && HasNews(row, kStarted);
    if ((is_requested || HasNews(row, kRefreshDue)) && (!IsInFlight(row)))
    {
        half.due |= half.bit;
    }
}

} // namespace counterpoint::channel_b
