// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/kernel.hpp"

#include "safety_core/comparator/slot_mask.hpp"

// What the application is told. [SRS_KRN_006, SRS_KRN_021, SRS_KRN_022, SRS_FLOW_004]
namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLastCause = static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);

} // namespace

void Kernel::ReportErrors(const SrdoMask signalled) noexcept
{
    run_.errors = 0U;
    SlotSet to_report{signalled};
    while (to_report.mask != 0U)
    {
        ReportSlot(TakeLowest(to_report));
    }
    if (run_.gfc_seen)
    {
        parts_.application.OnGfc();
    }
    run_.gfc_seen = false;
}

void Kernel::ReportSlot(const SlotIndex slot) noexcept
{
    const std::uint32_t signals = parts_.channel_a.View(slot).signals | parts_.channel_b.View(slot).signals;
    for (std::uint32_t cause = 1U; cause <= kLastCause; ++cause)
    {
        if (((signals >> cause) & 1U) != 0U)
        {
            ++run_.errors;
            record_.status.OnError(slot);
            parts_.application.OnSrdoError(IndexOf(slot), static_cast<SrdoCause>(cause));
        }
    }
}

void Kernel::ReportFlow(const CycleOutcome& outcome) noexcept
{
    if (run_.flow_callback != FlowCallback::kOn)
    {
        return;
    }
    Deliver(FlowEvent::kSctChecked, outcome.sct_checked);
    Deliver(FlowEvent::kItIsTx, outcome.is_tx);
    Deliver(FlowEvent::kItIsInvalid, outcome.is_invalid);
    Deliver(FlowEvent::kNotOperational, outcome.not_operational);
    Deliver(FlowEvent::kSrdoError, run_.errors);
    Deliver(FlowEvent::kSrdoReceived, run_.received);
    Deliver(FlowEvent::kSrdoTransmitted, run_.transmitted_told);
}

void Kernel::Deliver(const FlowEvent event, const std::uint16_t count) noexcept
{
    if (count != 0U)
    {
        parts_.application.OnFlow(FlowCount{event, count});
    }
}

void Kernel::ExamineHandshake() noexcept
{
    if (run_.handshake != StatusHandshake::kRequired)
    {
        return;
    }
    const SlotIndex overdue = record_.status.TakeOverdue();
    if (overdue != kNoSlot)
    {
        latch_.Enter(DeviceFault::kHandshake, overdue);
    }
}

void Kernel::ReportDevice() noexcept
{
    if ((!run_.fault_told) && (!latch_.IsRunning()))
    {
        run_.fault_told = true;
        parts_.application.OnDeviceFault(latch_.Report());
    }
}

} // namespace counterpoint
