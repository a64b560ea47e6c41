// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/reporting.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLastCause = static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);

} // namespace

void Reporting::TellSlot(const KernelContext& context, const SlotIndex slot) noexcept
{
    const std::uint32_t signals =
        context.parts.channel_a.View(slot).signals | context.parts.channel_b.View(slot).signals;
    for (std::uint32_t cause = 1U; cause <= kLastCause; ++cause)
    {
        if (((signals >> cause) & 1U) != 0U)
        {
            ++errors_;
            status_.OnError(slot);
            context.parts.application.OnSrdoError(IndexOf(*context.config, slot), static_cast<SrdoCause>(cause));
        }
    }
}

void Reporting::TellCounts(const KernelContext& context, const CycleOutcome& outcome,
                           const std::uint8_t transmitted) noexcept
{
    Deliver(context, FlowEvent::kSctChecked, outcome.sct_checked);
    Deliver(context, FlowEvent::kItIsTx, outcome.is_tx);
    Deliver(context, FlowEvent::kItIsInvalid, outcome.is_invalid);
    Deliver(context, FlowEvent::kNotOperational, outcome.not_operational);
    Deliver(context, FlowEvent::kSrdoError, errors_);
    Deliver(context, FlowEvent::kSrdoReceived, received_);
    Deliver(context, FlowEvent::kSrdoTransmitted, transmitted);
}

void Reporting::Deliver(const KernelContext& context, const FlowEvent event, const std::uint16_t count) noexcept
{
    if (count != 0U)
    {
        context.parts.application.OnFlow(FlowCount{event, count});
    }
}

} // namespace counterpoint
