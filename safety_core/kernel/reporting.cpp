// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/reporting.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kLastCause = static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);
constexpr std::uint32_t kEveryCause = ((1U << kLastCause) - 1U) << 1U;

// SCT, or the refresh time of a producer.
ToldWindow WindowOf(const KernelContext& context, const SlotIndex slot, const Instant now) noexcept
{
    return ToldWindow{now, context.guard.Value(slot, ConfigField::kSct) * kMicrosecondsPerMillisecond};
}

// The number of a cause that can be signalled; 0 for kNone and what is no cause.
std::uint32_t NumberOf(const SrdoCause cause) noexcept
{
    const std::uint32_t number = static_cast<std::uint32_t>(cause);
    return (number <= kLastCause) ? number : 0U;
}

} // namespace

SrdoCause FirstCauseOf(const SrdoView& a, const SrdoView& b) noexcept
{
    const bool asks_b = (a.first_cause == SrdoCause::kDemoted) || (a.first_cause == SrdoCause::kNone);
    return asks_b ? b.first_cause : a.first_cause;
}

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
    const SrdoView a = context.parts.channel_a.View(slot);
    const SrdoView b = context.parts.channel_b.View(slot);
    const ToldWindow window = WindowOf(context, slot, now);
    const std::uint32_t signals = (a.signals | b.signals) & kEveryCause;
    const std::uint32_t first = NumberOf(FirstCauseOf(a, b));
    const std::uint32_t others = signals & ~(1U << first);
    if (others != signals)
    {
        TellCause(context, slot, static_cast<SrdoCause>(first), window);
    }
    std::uint32_t number = 0U;
    for (std::uint32_t rest = others; rest != 0U; rest >>= 1U)
    {
        if ((rest & 1U) != 0U)
        {
            TellCause(context, slot, static_cast<SrdoCause>(number), window);
        }
        ++number;
    }
}

void Reporting::TellCause(const KernelContext& context, const SlotIndex slot, const SrdoCause cause,
                          const ToldWindow& window) noexcept
{
    if (told_.Take(slot, cause, window))
    {
        ++errors_;
        status_.OnError(slot);
        context.parts.application.OnSrdoError(IndexOf(*context.config, slot), cause);
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
