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

/// A function of its own, so that the compiler keeps the answer in one register.
[[nodiscard]] inline Confirmation Told(std::size_t slot, ConfirmStep step) noexcept
{
    return Confirmation{static_cast<SlotIndex>(slot), step};
}

} // namespace

/// The pair is in flight from the last OnCycle on. [SRS_PROD_006]
[[gnu::always_inline]] inline PreparedPair Channel::Launch(Row& row, std::uint64_t data) const noexcept
{
    UnpackBytes(data, &row.awaited.data[0]);
    row.awaited.identifier = OwnIdentifier(row, 1U);
    row.awaited.port = x_port[1U];
    row.stage = Stage::kPrepared;
    row.left = SrvtUs(row);
    row.limit = row.left;
    if (HasNews(row, kSilence))
    {
        row.phase_left = SctUs(row) + x_late_us;
    }
    ClearNews(row, kRequested | kRefreshDue);
    return PreparedPair{row.awaited, PrepareStatus::kReady};
}

/// The way for all objects.
PreparedPair Channel::PrepareSlowly(SlotIndex slot) const noexcept
{
    Row& row = x_storage.rows[slot];
    return Launch(row, ~(ExchangeFrom(slot, 1U, 0U, Way::kRead) | row.spare) & row.mask);
}

/// For two objects of four bytes, which fill a frame, there is nothing to call. [SRS_PROD_005]
PreparedPair Channel::Prepare(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if (row.stage != Stage::kIdle)
    {
        return PreparedPair{kNoFrame, PrepareStatus::kNotProducer};
    }
    const std::size_t low = row.words & 0xFFFFU;
    const std::size_t high = row.words >> 16U;
    if (((low < high) ? high : low) < x_object_count)
    {
        const MappableObject& first = x_objects[low];
        const MappableObject& second = x_objects[high];
        if ((first.length_bits == kFourBytes) && (second.length_bits == kFourBytes))
        {
            return Launch(row, ~Join(PackFourBytes(first.place), PackFourBytes(second.place)));
        }
    }
    return PrepareSlowly(slot);
}

CanFrame Channel::InverseFrame(SlotIndex slot) noexcept
{
    Row& row = x_storage.rows[slot];
    if (row.stage != Stage::kToSend)
    {
        return kNoFrame;
    }
    row.stage = Stage::kHandedOut;
    return row.awaited;
}

/// Another frame, or a wrong echo.
Confirmation Channel::Doubt(const CanFrame& frame) const noexcept
{
    const SlotIndex slot = LookUp(x_storage, frame);
    if ((slot >= x_count) || IsOther(x_storage.rows[slot], frame))
    {
        return Confirmation{kNoSlot, ConfirmStep::kNone};
    }
    return Fail(x_storage.rows[slot], SrdoCause::kWrongEcho);
}

/// One way for both frames of a pair; behind the length anything may be. What is not as awaited takes the way of
/// faults. [SRS_PROD_007, SRS_PROD_008]
Confirmation Channel::OnConfirm(const CanFrame& frame, Instant stamp) noexcept
{
    const std::size_t offset = std::size_t{frame.identifier} - kFirstSrdoIdentifier;
    if (offset >= kSrdoIdentifierCount)
    {
        return Doubt(frame);
    }
    const std::size_t slot = x_storage.slot_of[offset];
    if (slot >= x_count)
    {
        return Doubt(frame);
    }
    Row& row = x_storage.rows[slot];
    const std::uint64_t data = PackBytes(&row.awaited.data[0]);
    const std::uint64_t different = (PackBytes(&frame.data[0]) ^ data) & row.mask;
    if (IsOther(row, frame) || (different != 0U) || (frame.length_bytes != row.awaited.length_bytes))
    {
        return Doubt(frame);
    }
    const std::uint32_t since_call = stamp.us - x_last_us;
    if (row.stage == Stage::kPrepared)
    {
        UnpackBytes(data ^ row.mask, &row.awaited.data[0]); // Behind the length both frames are 0.
        row.awaited.identifier = OwnIdentifier(row, 0U);
        row.awaited.port = x_port[0U];
        row.stage = Stage::kToSend;
        row.left = row.limit + since_call; // SRVT anew.
        return Told(slot, ConfirmStep::kNormal);
    }
    if ((row.left - since_call) > row.limit)
    {
        return Fail(row, SrdoCause::kNoConfirmation);
    }
    row.ordinal += 1U;
    Ground(row, Stage::kIdle);
    return Told(slot, ConfirmStep::kPair);
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

/// The refresh falls due at exact distances, whenever the calls come. [SRS_PROD_001, SRS_PROD_002]
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

/// Silence is allowed for the refresh time and a cycle that is just in time. [SRS_PROD_001, SRS_PROD_010]
void Channel::AdvanceApplication(Row& row) const noexcept
{
    const std::uint32_t absence_us = SctUs(row) + x_late_us;
    if (!HasNews(row, kStarted))
    {
        SetNews(row, kStarted | kSilence);
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

/// [SRS_PROD_003, SRS_PROD_004, SRS_PROD_008, SRS_PROD_010, SRS_PROD_012]
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
