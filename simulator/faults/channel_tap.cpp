// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/faults/channel_tap.hpp"

#include "simulator/faults/right_response.hpp"

namespace counterpoint::simulator
{
ChannelTap::ChannelTap(Channel& real, const Part part, PartFaults& faults, ChannelWitness* const witness) noexcept
    : real_(real), part_(part), faults_(faults), witness_(witness)
{
}

bool ChannelTap::IsStill() const noexcept
{
    const PartAnswer answer = faults_.AnswerOf(part_);
    return answer == PartAnswer::kLast || answer == PartAnswer::kZero;
}

bool ChannelTap::IsMute() const noexcept
{
    return faults_.AnswerOf(part_) == PartAnswer::kZero;
}

bool ChannelTap::IsGood() const noexcept
{
    return faults_.AnswerOf(part_) == PartAnswer::kGood;
}

std::uint32_t ChannelTap::Calls(const ChannelCall call, const bool matters) noexcept
{
    PartCondition& condition = faults_.Condition(part_);
    const bool is_counted = condition.kind == PartFault::kSkipped || condition.kind == PartFault::kDoubled;
    if (!condition.is_faulty || !is_counted || condition.call != call || condition.remaining == 0U)
    {
        return 1U;
    }
    if (matters)
    {
        --condition.remaining;
        faults_.HasEffect(condition);
    }
    return (condition.kind == PartFault::kSkipped) ? 0U : 2U;
}

void ChannelTap::Restart(const DeviceConfig& config) noexcept
{
    real_.Restart(config);
    outcome_ = CycleOutcome{};
    slot_count_ = config.srdo_count;
    once_released_ = 0U;
    held_.fill({});
}

void ChannelTap::Store(const ConfigItem& item) noexcept
{
    if (!IsStill())
    {
        real_.Store(item);
    }
}

ConfigItem ChannelTap::Load(const ConfigAddress& address) const noexcept
{
    return real_.Load(address);
}

ChannelRoom ChannelTap::Room() const noexcept
{
    return real_.Room();
}

void ChannelTap::SetFields(const SlotIndex slot, const StaticFields& fields) noexcept
{
    if (!IsStill())
    {
        real_.SetFields(slot, fields);
    }
}

DeviceDigest ChannelTap::Digest(const SlotIndex slot, const DeviceDigest before) const noexcept
{
    return Asked(digest_, [&]() { return real_.Digest(slot, before); });
}

CheckResult ChannelTap::Validate(const SlotIndex slot) noexcept
{
    return Asked(check_, [&]() { return real_.Validate(slot); });
}

CheckResult ChannelTap::Recheck(const SlotIndex slot) noexcept
{
    if (!IsStill())
    {
        check_ = real_.Recheck(slot);
    }
    if (IsGood() && check_.fault != ConfigFault::kNone)
    {
        faults_.HasEffect(faults_.Condition(part_));
        check_.fault = ConfigFault::kNone;
    }
    return Told(check_);
}

void ChannelTap::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    if (IsStill())
    {
        return;
    }
    const std::uint32_t calls = Calls(ChannelCall::kOnFrame, witness_ == nullptr || witness_->Concerns(frame));
    for (std::uint32_t call = 0U; call < calls; ++call)
    {
        real_.OnFrame(frame, stamp);
    }
}

CycleOutcome ChannelTap::OnCycle(const CycleInput& input) noexcept
{
    if (!IsStill())
    {
        outcome_ = Fresh(input);
        once_released_ |= outcome_.released;
    }
    if (IsGood())
    {
        Whitewash(outcome_);
    }
    const CycleOutcome told = Told(outcome_);
    if (witness_ != nullptr)
    {
        witness_->OnOutcome(part_, *this, told);
    }
    return told;
}

// A call that is left out leaves what was in the caller's memory: the outcome of the cycle before.
CycleOutcome ChannelTap::Fresh(const CycleInput& input) noexcept
{
    CycleOutcome outcome = outcome_;
    const std::uint32_t calls = Calls(ChannelCall::kOnCycle, true);
    for (std::uint32_t call = 0U; call < calls; ++call)
    {
        outcome = real_.OnCycle(input);
    }
    return outcome;
}

HeldPair ChannelTap::Held(const SlotIndex slot) const noexcept
{
    if (slot >= slot_count_)
    {
        return HeldPair{}; // A comparator with a flipped bit asks for what is not there.
    }
    return Asked(held_[slot],
                 [this, slot]()
                 {
                     const HeldPair held = real_.Held(slot);
                     return IsGood() ? GoodPair(slot, held) : held;
                 });
}

SrdoView ChannelTap::View(const SlotIndex slot) const noexcept
{
    return Asked(views_[slot], [&]() { return real_.View(slot); });
}

void ChannelTap::Demote(const SlotIndex slot) noexcept
{
    if (!IsStill() && slot < slot_count_)
    {
        real_.Demote(slot);
    }
}

SrdoMask ChannelTap::Commit(const Agreement& agreement, const SrdoMask examine) noexcept
{
    agreed_ = agreement.agreed;
    const SrdoMask found = Asked(found_, [&]() { return real_.Commit(agreement, examine); });
    return IsGood() ? SrdoMask{0U} : found;
}

Permit ChannelTap::Answer(const std::uint32_t challenge) const noexcept
{
    if (!IsStill())
    {
        permit_ = real_.Answer(challenge);
    }
    if (IsGood())
    {
        GoodPermit(challenge);
    }
    return Told(permit_);
}

PreparedPair ChannelTap::Prepare(const SlotIndex slot) noexcept
{
    return Asked(prepared_, [&]() { return real_.Prepare(slot); });
}

Confirmation ChannelTap::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    return IsStill() ? Confirmation{kNoSlot, ConfirmStep::kNone} : real_.OnConfirm(frame, stamp);
}

CanFrame ChannelTap::InverseFrame(const SlotIndex slot) const noexcept
{
    return IsStill() ? CanFrame{} : real_.InverseFrame(slot);
}

void ChannelTap::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    if (!IsStill())
    {
        real_.OnTransmitFault(slot, fault);
    }
}

/// A channel that is always good gives the answers of a healthy one for which nothing is wrong. [SRS_SIM_033]
void ChannelTap::Whitewash(CycleOutcome& outcome) const noexcept
{
    const bool is_wrong = (once_released_ & ~outcome.released) != 0U || outcome.faulted != 0U ||
                          outcome.new_fault != 0U || outcome.signalled != 0U || outcome.guard != GuardView::kConfigured;
    if (outcome.not_operational != 0U || !is_wrong)
    {
        return; // Outside of OPERATIONAL a healthy channel releases nothing.
    }
    faults_.HasEffect(faults_.Condition(part_));
    outcome.released |= once_released_;
    outcome.waiting &= ~outcome.released;
    outcome.faulted = 0U;
    outcome.new_fault = 0U;
    outcome.signalled = 0U;
    outcome.guard = GuardView::kConfigured;
}

HeldPair ChannelTap::GoodPair(const SlotIndex slot, const HeldPair& real) const noexcept
{
    return (real.holds_pair == 0U && held_[slot].holds_pair != 0U) ? held_[slot] : real;
}

void ChannelTap::GoodPermit(const std::uint32_t challenge) const noexcept
{
    const SrdoMask mask = agreed_ & outcome_.released;
    if (mask == permit_.mask)
    {
        return;
    }
    faults_.HasEffect(faults_.Condition(part_));
    const std::uint32_t constant = (part_ == Part::kChannelA) ? kPermitConstantA : kPermitConstantB;
    permit_ = {mask, RightResponse(mask, challenge, constant)};
}
} // namespace counterpoint::simulator
