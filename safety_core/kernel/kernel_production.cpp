// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

// Sending: SRDOs by both channels, GFC, and what the application is told. [SRS-KRN-006, SRS-KRN-012..014]
namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLastCause = static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);

} // namespace

void Kernel::Produce() noexcept
{
    transmitted_told_ = transmitted_;
    transmitted_ = 0U;
    SlotSet to_start{verdict_.start & latch_.Gate()};
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
        HandOver(slot, pair_a.normal);
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
    parts_.channel_a.OnTransmitFault(slot, cause);
    parts_.channel_b.OnTransmitFault(slot, cause);
}

// A channel that has no frame to send gives one of kind kInvalid; one that should have been there is missed as
// kNoConfirmation.
void Kernel::HandOver(const SlotIndex slot, const CanFrame& frame) noexcept
{
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    gfc_open_ = false;
    const hal::TransmitStatus status = parts_.can.Transmit(frame);
    if (status != hal::TransmitStatus::kAccepted)
    {
        GiveUp(slot, (status == hal::TransmitStatus::kBusOff) ? SrdoCause::kBusOff : SrdoCause::kTransmitQueue);
    }
}

// t      prepare            normal on the bus         inverse on the bus
// A      normal frame       confirm                   confirm: sent
// B      compared           confirm, inverse frame    confirm: sent
void Kernel::OnConfirm(const StampedFrame& frame) noexcept
{
    if (!started_)
    {
        return;
    }
    clocks_.OnFrame(frame.stamp);
    const Confirmation a = parts_.channel_a.OnConfirm(frame.frame, frame.stamp.a);
    const Confirmation b = parts_.channel_b.OnConfirm(frame.frame, frame.stamp.b);
    // At the very limit one channel may have given the pair up already: then the other one will, for want of its frame.
    if ((a.step != b.step) || (a.slot != b.slot) || (a.slot >= config_->srdo_count))
    {
        return;
    }
    if (a.step == ConfirmStep::kPair)
    {
        ++transmitted_;
        parts_.application.OnSrdoEvent(IndexOf(a.slot));
    }
    else if ((a.step == ConfirmStep::kNormal) && latch_.IsRunning())
    {
        HandOver(a.slot, parts_.channel_b.InverseFrame(a.slot));
    }
    else
    {
        // The device is safe, or two channels agree on something that is no step: nothing follows.
    }
}

Result Kernel::SendGfc() noexcept
{
    const Result readiness = SendReadiness();
    if (readiness != Result::kSuccessful)
    {
        return readiness;
    }
    if (guard_.Value(0U, ConfigField::kGfcParameter, 0U) != 1U)
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
    gfc_open_ = true;
    gfc_sent_ = now_.a;
    SetGfcLimit();
    return Result::kSuccessful;
}

// The shortest refresh time of the producers; 0 without one: then the GFC cannot be followed at all.
void Kernel::SetGfcLimit() noexcept
{
    std::uint32_t shortest_ms = 0U;
    for (SlotIndex slot = 0U; slot < config_->srdo_count; ++slot)
    {
        const std::uint32_t refresh_ms = guard_.Value(slot, ConfigField::kSct, 0U);
        const bool is_producer = guard_.Value(slot, ConfigField::kDirection, 0U) == kDirectionProducer;
        // 0 - 1 is the greatest value: the first producer is always shorter.
        if (is_producer && ((refresh_ms - 1U) < (shortest_ms - 1U)))
        {
            shortest_ms = refresh_ms;
        }
    }
    gfc_limit_us_ = shortest_ms * kMicrosecondsPerMillisecond;
}

void Kernel::FollowGfc() noexcept
{
    if (gfc_open_ && ((now_.a.us - gfc_sent_.us) > gfc_limit_us_))
    {
        gfc_open_ = false;
        parts_.application.OnGfcNotFollowed();
    }
}

void Kernel::ReportErrors(const SrdoMask signalled) noexcept
{
    errors_ = 0U;
    SlotSet to_report{signalled};
    while (to_report.mask != 0U)
    {
        ReportSlot(TakeLowest(to_report));
    }
    const bool is_active = (nmt_ == NmtState::kOperational) && guard_.IsValid();
    if (gfc_seen_ && is_active && (guard_.Value(0U, ConfigField::kGfcParameter, 0U) == 1U))
    {
        parts_.application.OnGfc();
    }
    gfc_seen_ = false;
}

void Kernel::ReportSlot(const SlotIndex slot) noexcept
{
    const std::uint32_t signals = parts_.channel_a.View(slot).signals | parts_.channel_b.View(slot).signals;
    for (std::uint32_t cause = 1U; cause <= kLastCause; ++cause)
    {
        if (((signals >> cause) & 1U) != 0U)
        {
            ++errors_;
            parts_.application.OnSrdoError(IndexOf(slot), static_cast<SrdoCause>(cause));
        }
    }
}

void Kernel::ReportReceived(const SrdoMask received) noexcept
{
    received_ = 0U;
    SlotSet to_report{received};
    while (to_report.mask != 0U)
    {
        ++received_;
        parts_.application.OnSrdoEvent(IndexOf(TakeLowest(to_report)));
    }
}

void Kernel::ReportFlow(const CycleOutcome& outcome) noexcept
{
    if (flow_callback_ != FlowCallback::kOn)
    {
        return;
    }
    Deliver(FlowEvent::kSctChecked, outcome.sct_checked);
    Deliver(FlowEvent::kItIsTx, outcome.is_tx);
    Deliver(FlowEvent::kItIsInvalid, outcome.is_invalid);
    Deliver(FlowEvent::kNotOperational, outcome.not_operational);
    Deliver(FlowEvent::kSrdoError, errors_);
    Deliver(FlowEvent::kSrdoReceived, received_);
    Deliver(FlowEvent::kSrdoTransmitted, transmitted_told_);
}

void Kernel::Deliver(const FlowEvent event, const std::uint8_t count) noexcept
{
    if (count != 0U)
    {
        parts_.application.OnFlow(FlowCount{event, count});
    }
}

void Kernel::ReportDevice() noexcept
{
    if ((!fault_told_) && (!latch_.IsRunning()))
    {
        fault_told_ = true;
        parts_.application.OnDeviceFault(latch_.Report());
    }
}

} // namespace counterpoint
