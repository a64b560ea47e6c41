// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

// Sending: SRDOs by both channels, GFC; and what the application is told of pairs. [SRS_KRN_006, SRS_KRN_012,
// SRS_KRN_013, SRS_KRN_014]
namespace counterpoint
{
namespace
{

constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kSignBit = 31U;

// Both members in one word.
std::uint32_t CodeOf(const Confirmation& confirmation) noexcept
{
    return static_cast<std::uint32_t>(confirmation.slot) | (static_cast<std::uint32_t>(confirmation.step) << kByteBits);
}

} // namespace

void Kernel::Produce() noexcept
{
    run_.transmitted_told = run_.transmitted;
    run_.transmitted = 0U;
    SlotSet to_start{record_.verdict.start & latch_.Gate()};
    while (to_start.mask != 0U)
    {
        ProduceSlot(TakeLowest(to_start));
    }
    FollowGfc();
}

void Kernel::ProduceSlot(const SlotIndex slot) noexcept
{
    const bool asks_provider = config_->srdos[slot].form == ProducerForm::kProviderCalled; // MISRA D-002
    if (asks_provider && (parts_.application.OnRefresh(IndexOf(slot)) != RefreshAnswer::kReady))
    {
        return;
    }
    const PreparedPair pair_a = parts_.channel_a.Prepare(slot);
    const PreparedPair pair_b = parts_.channel_b.Prepare(slot);
    const PreparedVerdict verdict = Comparator::ComparePrepared(pair_a, pair_b);
    if (verdict == PreparedVerdict::kEqual)
    {
        // Only a pair that begins now follows a GFC, not the second half of one that was there before.
        if (HandOver(slot, pair_a.normal) == hal::TransmitStatus::kAccepted)
        {
            run_.gfc_open = false;
        }
    }
    else if (verdict == PreparedVerdict::kNotInverse)
    {
        GiveUp(slot, SrdoCause::kNotInverse);
    }
    else
    {
        latch_.Enter(DeviceFault::kDisagreement, slot);
    }
}

void Kernel::GiveUp(const SlotIndex slot, const SrdoCause cause) noexcept
{
    const TransmitFault fault{cause};
    parts_.channel_a.OnTransmitFault(slot, fault);
    parts_.channel_b.OnTransmitFault(slot, fault);
}

// A channel that has no frame to send gives one of kind kInvalid, which the HAL does not take; one that should have
// been there is missed as kNoConfirmation.
hal::TransmitStatus Kernel::HandOver(const SlotIndex slot, const CanFrame& frame) noexcept
{
    const hal::TransmitStatus status = parts_.can.Transmit(frame);
    if ((status != hal::TransmitStatus::kAccepted) && (frame.kind == FrameKind::kData))
    {
        GiveUp(slot, (status == hal::TransmitStatus::kBusOff) ? SrdoCause::kBusOff : SrdoCause::kTransmitQueue);
    }
    return status;
}

// t      prepare            normal on the bus         inverse on the bus
// A      normal frame       confirm                   confirm: sent
// B      compared           confirm, inverse frame    confirm: sent
void Kernel::OnConfirm(const StampedFrame& frame) noexcept
{
    if (!run_.started)
    {
        return;
    }
    clocks_.OnFrame(frame.stamp);
    const Confirmation a = parts_.channel_a.OnConfirm(frame.frame, frame.stamp.a);
    const Confirmation b = parts_.channel_b.OnConfirm(frame.frame, frame.stamp.b);
    // At the very limit one channel may have given the pair up already: then the other one will, for want of its frame.
    const std::uint32_t said = CodeOf(a);
    const SlotIndex slot = static_cast<SlotIndex>(said);
    if ((said != CodeOf(b)) || (slot >= config_->srdo_count))
    {
        return;
    }
    if (a.step == ConfirmStep::kPair)
    {
        ++run_.transmitted;
        ReportEvent(slot);
    }
    else if ((a.step == ConfirmStep::kNormal) && latch_.IsRunning())
    {
        (void)HandOver(slot, parts_.channel_b.InverseFrame(slot));
    }
    else
    {
        // The device is safe, or two channels agree on something that is no step: nothing follows.
    }
}

void Kernel::ReportEvent(const SlotIndex slot) noexcept
{
    record_.status.OnEvent(slot);
    parts_.application.OnSrdoEvent(IndexOf(slot));
}

void Kernel::ReportReceived(const SrdoMask received) noexcept
{
    run_.received = 0U;
    SlotSet to_report{received};
    while (to_report.mask != 0U)
    {
        ++run_.received;
        ReportEvent(TakeLowest(to_report));
    }
}

Result Kernel::SendGfc() noexcept
{
    if (config_->gfc != GfcUse::kPresent)
    {
        return Missing();
    }
    const Result readiness = SendReadiness();
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    if (guard_.Value(0U, ConfigField::kGfcParameter) != 1U)
    {
        return Result::kGfcUnsupported;
    }
    CanFrame frame{};
    frame.identifier = kGfcIdentifier;
    frame.kind = FrameKind::kData;
    frame.port = config_->normal_port;
    if (parts_.can.Transmit(frame) != hal::TransmitStatus::kAccepted)
    {
        return Result::kTransmitFailed;
    }
    if (!run_.gfc_open)
    {
        run_.gfc_open = true;
        run_.gfc_until.us = run_.now.us + run_.shortest_refresh_us;
    }
    return Result::kSuccessful;
}

void Kernel::FollowGfc() noexcept
{
    // Instants are modular: bit 31 of what is left stands for an instant that has passed.
    if (run_.gfc_open && (((run_.gfc_until.us - run_.now.us) >> kSignBit) != 0U))
    {
        run_.gfc_open = false;
        parts_.application.OnGfcNotFollowed();
    }
}

} // namespace counterpoint
