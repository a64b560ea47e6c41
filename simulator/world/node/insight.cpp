// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/insight.hpp"

#include <utility>

namespace counterpoint::simulator
{
NodeInsight::NodeInsight(const NodePlace& place, const runtime::DeviceModel& model, const NodePairs& pairs) noexcept
    : place_(place), model_(model), pairs_(pairs)
{
}

bool NodeInsight::Concerns(const CanFrame& frame) const
{
    return pairs_.ConsumerOf(frame) != kNoSlot || frame.identifier == kGfcIdentifier;
}

void NodeInsight::OnOutcome(const Part part, const Channel& channel, const CycleOutcome& outcome)
{
    Voice& voice = (part == Part::kChannelA) ? voice_a_ : voice_b_;
    const CycleOutcome& before = voice.outcome;
    const SrdoMask masks =
        (before.released ^ outcome.released) | (before.faulted ^ outcome.faulted) | (before.waiting ^ outcome.waiting);
    const bool has_changed = masks != 0U || before.not_operational != outcome.not_operational ||
                             before.is_tx != outcome.is_tx || before.cycle == 0U;
    voice.outcome = outcome;
    if ((outcome.new_fault | outcome.signalled) != 0U)
    {
        TellCauses(part, channel, outcome);
    }
    if (place_.journal.KeepsAll() && has_changed)
    {
        TellStates(part, channel, voice);
    }
}

void NodeInsight::TellStates(const Part part, const Channel& channel, Voice& voice)
{
    const EventKind kind = (part == Part::kChannelA) ? EventKind::kViewA : EventKind::kViewB;
    for (SlotIndex slot = 0U; slot < model_.Config().srdo_count; ++slot)
    {
        const SrdoState state = channel.View(slot).state;
        if (model_.NumberOf(slot) == 0U)
        {
            continue; // The place of a device without SRDOs. [SRS_SIM_661]
        }
        if (state != voice.states.at(slot))
        {
            voice.states.at(slot) = state;
            place_.Tell(kind, model_.NumberOf(slot), static_cast<std::uint64_t>(state), 0U);
        }
    }
}

// Consumers report in new_fault; producers only by their signals. That a first pair has not come is no fault.
void NodeInsight::TellCauses(const Part part, const Channel& channel, const CycleOutcome& outcome)
{
    constexpr std::uint32_t kHarmless = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);
    const EventKind kind = (part == Part::kChannelA) ? EventKind::kCauseA : EventKind::kCauseB;
    for (SlotIndex slot = 0U; slot < model_.Config().srdo_count; ++slot)
    {
        const SrdoMask bit = SrdoMask{1U} << slot;
        if (((outcome.new_fault | outcome.signalled) & bit) == 0U)
        {
            continue;
        }
        const SrdoView view = channel.View(slot);
        const std::uint32_t signals = ((outcome.signalled & bit) != 0U) ? (view.signals & ~kHarmless) : 0U;
        if ((outcome.new_fault & bit) != 0U || signals != 0U)
        {
            place_.Note(kind, model_.NumberOf(slot), static_cast<std::uint64_t>(view.first_cause), signals);
        }
    }
}

void NodeInsight::TellVerdict(const Verdict& verdict)
{
    if (model_.NumberOf(0U) == 0U)
    {
        return; // A device without SRDOs.
    }
    const SrdoMask slots = ~SrdoMask{0U} >> (kMaxSrdoCount - model_.Config().srdo_count);
    const SrdoMask agreed = verdict.agreement.agreed & slots;
    const SrdoMask matched = verdict.agreement.matched & slots;
    if (agreed != agreed_ || matched != matched_)
    {
        agreed_ = agreed;
        matched_ = matched;
        place_.Tell(EventKind::kVerdict, 0U, agreed, matched);
    }
    if (verdict.demote != 0U)
    {
        place_.Tell(EventKind::kDemotion, 0U, verdict.demote, 0U);
    }
}

void NodeInsight::TellPermits(const hal::PermitSet& permits)
{
    const SrdoMask permitted = permits.a.mask & permits.b.mask & permits.kernel.mask;
    if (std::exchange(permitted_, permitted) != permitted)
    {
        place_.Tell(EventKind::kPermits, 0U, permitted, 0U);
    }
}

void NodeInsight::TellLink(const LinkSupervisor& link)
{
    if (std::exchange(link_, link.State()) != link.State())
    {
        place_.Tell(EventKind::kLink, 0U, static_cast<std::uint64_t>(link_),
                    static_cast<std::uint64_t>(link.Finding()));
    }
}

void NodeInsight::TellSelfTest(const selftest::TestId first_failed)
{
    const bool has_failed = first_failed != selftest::TestId::kNone;
    if (!std::exchange(has_told_test_, has_failed) && has_failed)
    {
        place_.Tell(EventKind::kSelfTest, 0U, static_cast<std::uint64_t>(first_failed), 0U);
    }
}

void NodeInsight::Forget()
{
    voice_a_ = Voice{};
    voice_b_ = Voice{};
    agreed_ = 0U;
    matched_ = 0U;
}
} // namespace counterpoint::simulator
