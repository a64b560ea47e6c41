// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/reporting.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLastCause = static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);

// SCT, or the refresh time of a producer.
ToldWindow WindowOf(const KernelContext& context, const SlotIndex slot, const Instant now) noexcept
{
    return ToldWindow{now, context.guard.Value(slot, ConfigField::kSct) * kMicrosecondsPerMillisecond};
}

} // namespace

void Reporting::SweepOne(const KernelContext& context, const Instant now) noexcept
{
    const SlotIndex slot = told_.NextSlot();
    if ((told_.Slots() & OnlySlot(slot).mask) != 0U)
    {
        told_.Sweep(slot, WindowOf(context, slot, now));
    }
}

void Reporting::TellSlot(const KernelContext& context, const SlotIndex slot, const Instant now) noexcept
{
    const std::uint32_t signals =
        context.parts.channel_a.View(slot).signals | context.parts.channel_b.View(slot).signals;
    const ToldWindow window = WindowOf(context, slot, now);
    for (std::uint32_t number = 1U; number <= kLastCause; ++number)
    {
        const SrdoCause cause = static_cast<SrdoCause>(number);
        const bool is_signalled = ((signals >> number) & 1U) != 0U;
        const bool is_told = is_signalled ? told_.Take(slot, cause, window) : false;
        if (is_told)
        {
            ++errors_;
            status_.OnError(slot);
            context.parts.application.OnSrdoError(IndexOf(*context.config, slot), cause);
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
