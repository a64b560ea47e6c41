// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node.hpp"

// What a tapped node tells about its inside. [SRS_SIM_040]
namespace counterpoint::simulator
{
SlotIndex Node::ConsumerOf(const CanFrame& frame) const
{
    const bool is_srdo = frame.kind == FrameKind::kData && frame.identifier >= kFirstSrdoIdentifier &&
                         frame.identifier <= kLastSrdoIdentifier;
    return is_srdo ? slot_of_.at(frame.identifier - kFirstSrdoIdentifier) : kNoSlot;
}

bool Node::Concerns(const CanFrame& frame) const
{
    return ConsumerOf(frame) != kNoSlot || frame.identifier == kGfcIdentifier;
}

void Node::OnOutcome(const Part part, const Channel& channel, const CycleOutcome& outcome)
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
        TellCauses(part, channel, outcome.new_fault, outcome.signalled);
    }
    if (journal_.KeepsAll() && has_changed)
    {
        TellStates(part, channel, voice);
    }
}

void Node::TellStates(const Part part, const Channel& channel, Voice& voice)
{
    const EventKind kind = (part == Part::kChannelA) ? EventKind::kViewA : EventKind::kViewB;
    for (SlotIndex slot = 0U; slot < model_.Config().srdo_count; ++slot)
    {
        const SrdoState state = channel.View(slot).state;
        if (state != voice.states.at(slot))
        {
            voice.states.at(slot) = state;
            journal_.Tell({Now(), kind, place_.index, NumberOf(slot), static_cast<std::uint64_t>(state), 0U});
        }
    }
}

// Consumers report in new_fault; producers only by their signals. That a first pair has not come is no fault.
void Node::TellCauses(const Part part, const Channel& channel, const SrdoMask new_fault, const SrdoMask signalled)
{
    constexpr std::uint32_t kHarmless = std::uint32_t{1U} << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct);
    const EventKind kind = (part == Part::kChannelA) ? EventKind::kCauseA : EventKind::kCauseB;
    for (SlotIndex slot = 0U; slot < model_.Config().srdo_count; ++slot)
    {
        const SrdoMask bit = SrdoMask{1U} << slot;
        if (((new_fault | signalled) & bit) == 0U)
        {
            continue;
        }
        const SrdoView view = channel.View(slot);
        const std::uint32_t signals = ((signalled & bit) != 0U) ? (view.signals & ~kHarmless) : 0U;
        if ((new_fault & bit) != 0U || signals != 0U)
        {
            journal_.Note(
                {Now(), kind, place_.index, NumberOf(slot), static_cast<std::uint64_t>(view.first_cause), signals});
        }
    }
}

void Node::LookInside()
{
    if (!journal_.KeepsAll())
    {
        return;
    }
    TellLink();
    const Verdict& verdict = assembly_.Core().LastVerdict();
    const SrdoMask slots = ~SrdoMask{0U} >> (kMaxSrdoCount - model_.Config().srdo_count);
    const SrdoMask agreed = verdict.agreement.agreed & slots;
    const SrdoMask matched = verdict.agreement.matched & slots;
    if (agreed != shown_agreed_ || matched != shown_matched_)
    {
        shown_agreed_ = agreed;
        shown_matched_ = matched;
        journal_.Tell({Now(), EventKind::kVerdict, place_.index, 0U, agreed, matched});
    }
    if (verdict.demote != 0U)
    {
        journal_.Tell({Now(), EventKind::kDemotion, place_.index, 0U, verdict.demote, 0U});
    }
    const hal::PermitSet& permits = output_tap_.Permits();
    const SrdoMask permitted = permits.a.mask & permits.b.mask & permits.kernel.mask;
    if (permitted != shown_permits_)
    {
        shown_permits_ = permitted;
        journal_.Tell({Now(), EventKind::kPermits, place_.index, 0U, permitted, 0U});
    }
}

void Node::NoteEffects()
{
    for (const std::size_t fault : memory_.TakeEffects())
    {
        journal_.Note({Now(), EventKind::kFault, place_.index, 0U, fault, 0U});
    }
    for (const auto& [fault, at] : faults_.TakeEffects())
    {
        journal_.Note({at, EventKind::kFault, place_.index, 0U, fault, 0U});
    }
}

void Node::NoteHung()
{
    is_hung_ = true;
    SettleNextEvent();
    NoteEffects();
    journal_.Note({Now(), EventKind::kHung, place_.index, 0U, faults_.TakeTrap() ? 1U : 0U, 0U});
}
} // namespace counterpoint::simulator
